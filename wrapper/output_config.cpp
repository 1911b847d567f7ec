// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/native_path.hpp"
#include "core/suggest.hpp"
#include "core/swap_layout.hpp"
#include "wrapper/chain_config.hpp"
#include "wrapper/numbered_rows.hpp"

namespace lac {
namespace fs = std::filesystem;
namespace {

const Range kCount = Range::between(1, 1.0e6);

}  // namespace

int raw_record(const std::string& word) {
  if (word.size() < 4 || !equal_ignoring_case(word.substr(0, 3), "rec")) return 0;
  const int record = whole_number(std::string_view(word).substr(3), 0);
  return record >= 1 && record <= kPrivateArraySize ? record : 0;
}

OutputChannel OutputParams::find_channel(const InputFile& in, const std::string& key,
                                         const std::string& word,
                                         const std::vector<NamedSignal>& signals) {
  if (const int record = raw_record(word); record != 0) {
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
  for (const NamedSignal& n : signals) {
    if (equal_ignoring_case(n.name, word)) return {n.record, {n.name, n.unit}};
    names.push_back(n.name);
  }
  in.fail(key, "found '" + word + "', expected names of records or signals, or rec1 ... rec" +
                   std::to_string(kPrivateArraySize) + did_you_mean(word, names));
}

OutputParams OutputParams::read(InputFile& in, const std::vector<NamedSignal>& signals) {
  static const std::vector<std::string> kEndings{"", ".outb", ".csv"};
  OutputParams out;
  const int format = in.choice("OutputFormat", 0, {"none", "outb", "csv"});
  out.enabled = format != 0;
  out.ending = kEndings[static_cast<std::size_t>(format)];
  out.file = path_from_bytes(in.text("OutputFile", ""));
  out.decimation = in.integer("OutputDecimation", 1, kCount);
  if (in.has("OutputChannels")) {
    for (const std::string& word : in.texts("OutputChannels")) {
      OutputChannel c = find_channel(in, "OutputChannels", word, signals);
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

fs::path OutputParams::path(const std::string& host_out_name) const {
  if (file.empty()) return path_from_bytes(without_host_suffix(host_out_name) + ".lac" + ending);
  return file.is_absolute() ? file : path_from_bytes(host_out_name).parent_path() / file;
}

std::string without_host_suffix(const std::string& host_out_name) {
  constexpr std::string_view kSuffix = ".SrvD";
  std::string root = host_out_name;
  if (root.ends_with(kSuffix)) root.erase(root.size() - kSuffix.size());
  return root;
}

}  // namespace lac
