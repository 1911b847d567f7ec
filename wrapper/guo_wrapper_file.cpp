// SPDX-License-Identifier: Apache-2.0
#include "wrapper/guo_wrapper_file.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/native_path.hpp"
#include "core/suggest.hpp"

namespace lac {
namespace fs = std::filesystem;
namespace {

constexpr int kMostLibraries = 64;

/// Folder of the file, then the working folder.
std::vector<fs::path> search_folders(const GuoInputFile& file) {
  std::error_code ec;
  return {file.path().parent_path(), fs::current_path(ec)};
}

/// As written if it lies in the first folder, absolute if it lies in a later one, else empty.
std::string find_file(const std::string& written, const std::vector<fs::path>& folders) {
  std::error_code ec;
  for (const fs::path& folder : folders) {
    const fs::path file = folder / path_from_bytes(written);
    if (fs::is_regular_file(file, ec)) {
      return folder == folders.front() ? written : file.string();
    }
  }
  return {};
}

/// Without an ending that means a library on one system or another.
fs::path without_library_ending(const fs::path& name) {
  for (const char* ending : {".dll", ".so", ".dylib"}) {
    if (equal_ignoring_case(name.extension().string(), ending))
      return name.parent_path() / name.stem();
  }
  return name;
}

/// The library as this system knows it, or empty.
std::string find_library(const fs::path& stem, const std::vector<fs::path>& folders) {
  for (const fs::path& name : {stem, stem.parent_path() / (fs::path("lib") += stem.filename())}) {
    for (const fs::path& candidate : library_candidates(name.string(), {{}})) {
      const std::string found = find_file(candidate.lexically_normal().string(), folders);
      if (!found.empty()) return found;
    }
  }
  return {};
}

std::string library_of_ours_for(const std::string& input_file, const GuoInputFile& wrapper) {
  const fs::path given = path_from_bytes(input_file);
  const GuoInputFile input =
      GuoInputFile::load(given.is_absolute() ? given : wrapper.path().parent_path() / given);
  if (input.is_theirs(guo_ldp_marks())) return "liblac_ldp";
  if (input.is_theirs(guo_ffp_marks())) return "liblac_ffp";
  return {};
}

/// Letters, digits, - and _ only, and unlike all names before.
std::string name_for(const fs::path& stem, const std::vector<GuoSubDll>& before) {
  std::string name = stem.filename().string();
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!plain && c != '-') c = '_';
  }
  const auto taken = [&](const std::string& n) {
    return std::ranges::any_of(before,
                               [&](const GuoSubDll& s) { return equal_ignoring_case(s.name, n); });
  };
  std::string result = name;
  for (int n = 2; taken(result); ++n) result = name + "_" + std::to_string(n);
  return result;
}

std::string single_value(const GuoInputFile& file, const GuoInputFile::Line& line) {
  if (line.values.size() != 1) {
    throw Error(file.path().string() + ":" + std::to_string(line.number) + ": " + line.key +
                ": found " + std::to_string(line.values.size()) +
                " words, expected one (a blank ends a name in this form)");
  }
  std::string value = line.values.front();
  std::ranges::replace(value, '\\', '/');
  return value;
}

[[noreturn]] void fail_input(const GuoInputFile& file, const GuoInputFile::Line& line,
                             const std::string& written, const std::vector<fs::path>& folders) {
  std::string tried;
  for (const fs::path& folder : folders)
    tried += "\n  " + (folder / path_from_bytes(written)).string();
  throw Error(file.path().string() + ":" + std::to_string(line.number) + ": " + line.key +
              ": input file '" + written + "' is not there; tried:" + tried);
}

}  // namespace

GuoForm guo_wrapper_form(int libraries) {
  GuoForm form{"WRAPPER.IN",
               {"NumberofSubDLLs"},
               {"LidarLayout", "InterpolationOrder", "MeasurementInterval", "RotorPositionX",
                "GuoSecondaries", "ReentrantSecondaries", "ExtendedDemands", "SharedRecords",
                "OutputFormat", "OutputFile", "OutputChannels", "OutputDecimation"}};
  for (int i = 0; i < libraries; ++i) {
    form.lines.insert(form.lines.end(), {"SubDLLName", "SubDLLInputName"});
  }
  return form;
}

std::vector<GuoSubDll> read_guo_sub_dlls(const GuoInputFile& file) {
  GuoForm head = guo_wrapper_form(0);
  head.extras.clear();
  const int count = file.read(head).integer("NumberofSubDLLs", Range::between(1, kMostLibraries));
  const std::vector<fs::path> folders = search_folders(file);
  const auto lines = file.sequence(guo_wrapper_form(count));
  std::vector<GuoSubDll> all;
  for (std::size_t i = 1; i < lines.size(); i += 2) {
    GuoSubDll s;
    s.line = lines[i].number;
    s.written = single_value(file, lines[i]);
    const std::string input = single_value(file, lines[i + 1]);
    s.input_file = find_file(input, folders);
    if (s.input_file.empty()) fail_input(file, lines[i + 1], input, folders);
    const fs::path stem = without_library_ending(path_from_bytes(s.written));
    s.name = name_for(stem, all);
    s.library = find_library(stem, folders);
    if (s.library.empty()) {
      s.library = library_of_ours_for(s.input_file, file);
      s.replaced = !s.library.empty();
    }
    if (s.library.empty()) s.library = stem.string();  // the system's search, or its error
    all.push_back(std::move(s));
  }
  return all;
}

std::string secondary_row(const GuoSubDll& s, int number) {
  return '"' + s.name + "\" \"" + s.library + "\" \"" + s.input_file + "\" ! Secondary_" +
         std::to_string(number);
}

std::optional<WrapperParams> read_guo_wrapper_file(const fs::path& path, Notice& notice) {
  const GuoInputFile file = GuoInputFile::load(path);
  if (!file.is_theirs(guo_wrapper_marks())) return std::nullopt;
  const std::vector<GuoSubDll> all = read_guo_sub_dlls(file);
  const GuoForm form = guo_wrapper_form(static_cast<int>(all.size()));
  std::vector<GuoInputFile::OurLine> ours;
  if (file.line_of("LidarLayout") == 0) ours.push_back({1, "guo ! LidarLayout"});
  std::string replaced;
  for (std::size_t i = 0; i < all.size(); ++i) {
    ours.push_back({all[i].line, secondary_row(all[i], static_cast<int>(i) + 1)});
    if (all[i].replaced) replaced += (replaced.empty() ? "" : ", ") + all[i].written;
  }
  for (GuoInputFile::OurLine& extra : file.extras(form)) ours.push_back(std::move(extra));
  InputFile in = file.as_ours(ours);
  WrapperParams params = WrapperParams::read(in);
  for (std::size_t i = 0; i < all.size(); ++i) {  // as the user knows the rows
    params.secondaries[i].where =
        path.string() + ":" + std::to_string(all[i].line) + ": SubDLLName";
  }
  notice.warn(
      "input file read as WRAPPER.IN of Guo's chain%s%s; differences: docs/hosts/guo.md",
      replaced.empty() ? "" : ", not found and replaced by our own libraries: ", replaced.c_str());
  return params;
}

}  // namespace lac
