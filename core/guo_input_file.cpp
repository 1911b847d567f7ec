// SPDX-License-Identifier: Apache-2.0
#include "core/guo_input_file.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "core/suggest.hpp"

namespace lac {
namespace {

constexpr std::string_view kSeparators = " ,!;'\"\t";  // of their GetWords
constexpr std::size_t kComparedCharacters = 20;
constexpr int kHeaderLines = 3;

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(kSeparators);
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(kSeparators), line.size());
    words.emplace_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

bool same_key(std::string_view a, std::string_view b) {
  return equal_ignoring_case(a.substr(0, kComparedCharacters), b.substr(0, kComparedCharacters));
}

bool is_comment(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  return begin == std::string_view::npos || line[begin] == '!' || line[begin] == '#';
}

bool looks_like_a_number(const std::string& word) {
  return word.find_first_not_of("0123456789+-.eEdD") == std::string::npos;
}

/// The word that stands where a key does: behind `!`, or behind the value(s).
std::string key_of(std::string_view line) {
  if (is_comment(line)) return {};
  const std::size_t mark = line.find('!');
  const std::vector<std::string> words =
      words_of(mark == std::string_view::npos ? line : line.substr(mark));
  if (words.empty()) return {};
  if (mark != std::string_view::npos) return words.front();
  const auto key = std::find_if_not(words.begin() + 1, words.end(), looks_like_a_number);
  return key == words.end() ? std::string() : *key;
}

const std::string* first_present(const GuoInputFile& file, const std::vector<std::string>& keys) {
  const auto found =
      std::ranges::find_if(keys, [&](const std::string& key) { return file.line_of(key) > 0; });
  return found == keys.end() ? nullptr : &*found;
}

std::string shown(std::string_view line) {
  constexpr std::size_t kLongest = 60;
  std::string text(line.substr(0, kLongest));
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
  return "'" + text + (line.size() > kLongest ? "...'" : "'");
}

}  // namespace

const GuoMarks& guo_ldp_marks() {
  static const GuoMarks marks{
      "LDP",
      {"Lidar_Azimuth", "Lidar_Elevation", "MC_Mode", "AngleToCenterline", "IndexGate",
       "NumberOfModularLidars", "NumberOfMeasurements"},
      {"ScanTime",    "LidarLayout",        "BeamAzimuth",         "BeamElevation",
       "GateRanges",  "LidarPosition",      "RequiredLead",        "LeadMargin",
       "LongestLead", "MeanSpeedWindow",    "SettlingTime",        "MinimumSamples",
       "MaximumAge",  "MotionCompensation", "MinimumSpeed",        "MaximumSpeed",
       "StuckScans",  "InterpolationOrder", "MeasurementInterval", "RotorPositionX"},
      {"NumberOfBeams"}};
  return marks;
}

const GuoMarks& guo_ffp_marks() {
  static const GuoMarks marks{
      "FFP",
      {"FlagLPF", "f_cutoff", "f_cutoff_LP", "FlagNotch", "f_cutoff_Notch", "betaNum_Notch",
       "betaDen_Notch", "T_buffer", "n_StaticPitchCurve"},
      {"CutOffFrequency", "CutOffWindSpeed", "DelayFrequency", "ActuatorFrequency",
       "ActuatorDamping", "BufferTrim", "BufferTimeConstant", "LongestBuffer", "ThresholdSpeed",
       "Hysteresis", "FadeTime", "MaximumRate"},
      {"StaticWind", "StaticPitch"}};
  return marks;
}

const GuoMarks& guo_wrapper_marks() {
  static const GuoMarks marks{
      "WRAPPER", {"NumberofSubDLLs", "SubDLLName", "SubDLLInputName"}, {"Secondary_1"}, {}};
  return marks;
}

GuoInputFile GuoInputFile::load(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::error_code ec;
  if (!in || std::filesystem::is_directory(file, ec)) return parse({}, file);
  return parse(std::string(std::istreambuf_iterator<char>(in), {}), file);
}

GuoInputFile GuoInputFile::parse(std::string_view text, std::filesystem::path file) {
  GuoInputFile result;
  result.file_ = std::move(file);
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte-order mark
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const bool windows = text.substr(end).starts_with("\r\n");
    result.lines_.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + (windows ? 2 : 1), text.size()));
  }
  return result;
}

int GuoInputFile::line_of(std::string_view key) const {
  const auto has_key = [&](const std::string& line) { return same_key(key_of(line), key); };
  const auto found = std::ranges::find_if(lines_, has_key);
  return found == lines_.end() ? 0 : static_cast<int>(found - lines_.begin()) + 1;
}

bool GuoInputFile::is_theirs(const GuoMarks& marks) const {
  const std::string* theirs = first_present(*this, marks.theirs);
  const std::string* ours = first_present(*this, marks.ours);
  const std::string line = file_.string() + ":";
  if (theirs != nullptr && ours != nullptr) {
    throw Error(line + std::to_string(line_of(*theirs)) + ": " + *theirs + ": stands in Guo's " +
                marks.kind + " files, " + *ours + " (line " + std::to_string(line_of(*ours)) +
                ") in those of our own form; expected keys of one form ('lac migrate' turns "
                "theirs into ours)");
  }
  const std::string* shared = first_present(*this, marks.shared);
  if (theirs == nullptr && ours == nullptr && shared != nullptr) {
    throw Error(line + std::to_string(line_of(*shared)) + ": " + *shared +
                ": stands in files of our own form, where " + marks.ours.front() +
                " is missing, and in Guo's " + marks.kind + " files, where " +
                marks.theirs.front() + " is missing; expected one of them");
  }
  return theirs != nullptr;
}

void GuoInputFile::fail(int line, const std::string& problem, const GuoForm& form) const {
  throw Error(file_.string() + ":" + std::to_string(line) + ": " + problem + "; read as " +
              form.name + " of Guo's chain: " + std::to_string(kHeaderLines) +
              " header lines, then its keys in fixed order, one a line, nothing between");
}

std::vector<GuoInputFile::Line> GuoInputFile::sequence(const GuoForm& form) const {
  std::vector<Line> result;
  int number = kHeaderLines;
  for (const std::string& key : form.lines) {
    ++number;
    const bool there = number <= static_cast<int>(lines_.size());
    if (key.empty()) continue;
    const std::string expected = "expected 'value(s) ! " + key + "'";
    if (!there) {
      fail(number, "the file ends after line " + std::to_string(lines_.size()) + ", " + expected,
           form);
    }
    const std::string& text = lines_[static_cast<std::size_t>(number - 1)];
    std::vector<std::string> words = words_of(text);
    const auto found =
        std::ranges::find_if(words, [&](const std::string& w) { return same_key(w, key); });
    if (found == words.end() || is_comment(text)) {
      const int elsewhere = line_of(key);
      fail(number,
           "found " + shown(text) + ", " + expected +
               (elsewhere > 0 ? ", which stands in line " + std::to_string(elsewhere) : ""),
           form);
    }
    if (found == words.begin()) fail(number, key + ": no value in front of the key", form);
    words.erase(found, words.end());
    result.push_back({number, key, std::move(words)});
  }
  return result;
}

std::vector<GuoInputFile::OurLine> GuoInputFile::extras(const GuoForm& form) const {
  const int last = kHeaderLines + static_cast<int>(form.lines.size());
  std::vector<OurLine> result;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const std::string key = key_of(lines_[i]);
    const auto is_key = [&](const std::string& extra) { return equal_ignoring_case(extra, key); };
    if (!std::ranges::any_of(form.extras, is_key)) continue;
    const int number = static_cast<int>(i) + 1;
    if (number <= last) {
      fail(number, key + ": expected behind line " + std::to_string(last) + ", the last of theirs",
           form);
    }
    result.push_back({number, lines_[i]});
  }
  return result;
}

InputFile GuoInputFile::as_ours(const std::vector<OurLine>& lines) const {
  std::string text;
  int number = 1;
  for (const OurLine& line : lines) {
    text.append(static_cast<std::size_t>(line.number - number), '\n');
    text += line.text + '\n';
    number = line.number + 1;
  }
  return InputFile::parse(text, file_);
}

InputFile GuoInputFile::read(const GuoForm& form) const {
  std::vector<OurLine> lines;
  for (const Line& line : sequence(form)) {
    OurLine ours{line.number, ""};
    for (const std::string& value : line.values) ours.text += '"' + value + "\" ";
    ours.text += "! " + line.key;
    lines.push_back(std::move(ours));
  }
  for (OurLine& extra : extras(form)) lines.push_back(std::move(extra));
  return as_ours(lines);
}

}  // namespace lac
