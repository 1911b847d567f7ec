// SPDX-License-Identifier: Apache-2.0
#include "wrapper/chain_config.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "core/swap_layout.hpp"

namespace lac {
namespace fs = std::filesystem;
namespace {

constexpr int kMostSecondaries = 64;
const Range kCount = Range::between(1, 1.0e6);

std::string row_key(int number) {
  return "Secondary_" + std::to_string(number);
}

int count_rows(InputFile& in) {
  int count = 0;
  for (int n = 1; n <= kMostSecondaries; ++n) {
    if (!in.has(row_key(n))) continue;
    if (n != count + 1) {
      in.fail(row_key(n), row_key(count + 1) + " is missing: number the rows 1, 2, 3 ... " +
                              "without a gap, in the order of calls");
    }
    count = n;
  }
  if (in.has(row_key(kMostSecondaries + 1))) {
    in.fail(row_key(kMostSecondaries + 1),
            "expected at most " + std::to_string(kMostSecondaries) + " secondaries");
  }
  return count;
}

void check_name(const InputFile& in, const std::string& key, const std::string& name) {
  const bool plain = std::ranges::all_of(name, [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
  if (name.empty() || !plain) {
    in.fail(key, "found the name '" + name +
                     "', expected letters, digits, - and _ (it becomes part of file names)");
  }
}

fs::path find_input_file(const InputFile& in, const std::string& key, const std::string& written) {
  fs::path path = in.resolve(written).lexically_normal();
  std::error_code ec;
  if (!fs::is_regular_file(path, ec) || !std::ifstream(path)) {
    in.fail(key, "input file '" + written + "' cannot be opened; tried " + path.string());
  }
  if (fs::equivalent(path, in.path(), ec)) {
    in.fail(key, "input file '" + written + "' is the master's own");
  }
  return path;
}

SecondaryParams read_row(InputFile& in, const std::string& key) {
  const std::vector<std::string> words = in.texts(key);
  if (words.size() < 3 || words.size() > 4) {
    in.fail(key, "found " + std::to_string(words.size()) +
                     " words, expected \"name\" \"library\" \"input file\" [\"entry\"]");
  }
  SecondaryParams s;
  s.where = in.where(key);
  s.name = words[0];
  check_name(in, key, s.name);
  s.library = words[1];
  if (s.library.empty()) in.fail(key, "found an empty library name");
  s.input_file = find_input_file(in, key, words[2]);
  if (words.size() == 4) s.entry = words[3];
  return s;
}

std::vector<SecondaryParams> read_secondaries(InputFile& in) {
  std::vector<SecondaryParams> all;
  const int count = std::max(1, count_rows(in));  // none: the first is reported as missing
  for (int n = 1; n <= count; ++n) {
    SecondaryParams s = read_row(in, row_key(n));
    const auto same = [&](const SecondaryParams& o) { return equal_ignoring_case(o.name, s.name); };
    if (std::ranges::any_of(all, same)) {
      in.fail(row_key(n), "the name '" + s.name + "' is taken; each secondary needs its own");
    }
    all.push_back(std::move(s));
  }
  return all;
}

/// "rec120" -> 120, anything else 0.
int raw_record(const std::string& word) {
  if (word.size() < 4 || !equal_ignoring_case(word.substr(0, 3), "rec")) return 0;
  int record = 0;
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data() + 3, end, record);
  return result.ec == std::errc{} && result.ptr == end ? record : 0;
}

OutputChannel find_channel(const InputFile& in, const std::string& word) {
  if (const int record = raw_record(word); record >= 1 && record <= kPrivateArraySize) {
    const RecordInfo* info = find_record(record);
    return {record, {word, std::string(info != nullptr ? info->unit : "-")}};
  }
  std::vector<std::string> names;
  for (const RecordInfo& r : kRecords) {
    if (equal_ignoring_case(r.name, word)) {
      return {r.index, {std::string(r.name), std::string(r.unit)}};
    }
    names.emplace_back(r.name);
  }
  in.fail("OutputChannels", "found '" + word + "', expected names of records or rec1 ... rec" +
                                std::to_string(kPrivateArraySize) + did_you_mean(word, names));
}

OutputParams read_output(InputFile& in) {
  static const std::vector<std::string> kEndings{"", ".outb", ".csv"};
  OutputParams out;
  const int format = in.choice("OutputFormat", 0, {"none", "outb", "csv"});
  out.enabled = format != 0;
  out.ending = kEndings[static_cast<std::size_t>(format)];
  out.file = in.text("OutputFile", "");
  out.decimation = in.integer("OutputDecimation", 1, kCount);
  if (in.has("OutputChannels")) {
    for (const std::string& word : in.texts("OutputChannels")) {
      OutputChannel c = find_channel(in, word);
      const auto same = [&](const OutputChannel& o) { return o.channel.name == c.channel.name; };
      if (std::ranges::any_of(out.channels, same)) {
        in.fail("OutputChannels", "found '" + word + "' twice, expected each channel once");
      }
      out.channels.push_back(std::move(c));
    }
  } else if (out.enabled) {
    in.fail("OutputChannels", "missing, OutputFormat asks for an output file");
  }
  if (out.enabled && !out.file.empty() && out.file.extension() != out.ending) {
    in.fail("OutputFile", "found '" + out.file.string() + "', expected the ending " + out.ending +
                              " as OutputFormat says");
  }
  return out;
}

}  // namespace

fs::path OutputParams::path(const std::string& host_out_name) const {
  if (file.empty()) return without_host_suffix(host_out_name) + ".lac" + ending;
  return file.is_absolute() ? file : fs::path(host_out_name).parent_path() / file;
}

WrapperParams WrapperParams::read(InputFile& in) {
  WrapperParams p;
  p.file = in.path();
  p.secondaries = read_secondaries(in);
  p.lidar = static_cast<HostLidar>(in.choice("LidarLayout", 0, {"none", "native", "guo"}));
  p.extended_demands = in.flag("ExtendedDemands", false);
  p.output = read_output(in);
  in.finish();
  return p;
}

DisconLibrary WrapperParams::open_library(const SecondaryParams& secondary,
                                          const fs::path& wrapper_folder) const {
  try {
    return DisconLibrary::open(secondary.library, secondary.entry,
                               {file.parent_path(), wrapper_folder});
  } catch (const Error& e) {
    throw Error(secondary.where + ": " + e.what());
  }
}

std::string without_host_suffix(const std::string& host_out_name) {
  constexpr std::string_view kSuffix = ".SrvD";
  std::string root = host_out_name;
  if (root.ends_with(kSuffix)) root.erase(root.size() - kSuffix.size());
  return root;
}

}  // namespace lac
