// SPDX-License-Identifier: Apache-2.0
#include "core/table_writer.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "core/csv_file.hpp"
#include "core/error.hpp"
#include "core/outb_file.hpp"

namespace lac {
namespace {

bool is_plain_text(std::string_view text, std::string_view forbidden) {
  return std::all_of(text.begin(), text.end(), [&](char c) {
    return c >= ' ' && c <= '~' && forbidden.find(c) == std::string_view::npos;
  });
}

[[noreturn]] void refuse(const TableSpec& spec, const std::string& reason) {
  throw Error(spec.path.string() + ": cannot write this table: " + reason);
}

void validate_channel(const TableSpec& spec, const TableChannel& channel) {
  if (channel.name.empty()) refuse(spec, "a channel has no name");
  if (!is_plain_text(channel.name, " ,\"[]()")) {
    refuse(spec, "channel name '" + channel.name +
                     "' has a character other than printable ASCII without blank, comma, "
                     "quote and brackets");
  }
  if (!is_plain_text(channel.unit, ",\"[]()")) {
    refuse(spec, "unit '" + channel.unit + "' of channel " + channel.name +
                     " has a character other than printable ASCII without comma, quote and "
                     "brackets");
  }
}

}  // namespace

void validate(const TableSpec& spec) {
  if (spec.channels.empty()) refuse(spec, "no channels");
  if (!(spec.time_step_s > 0.0) || !std::isfinite(spec.time_step_s)) {
    refuse(spec,
           "time step is " + std::to_string(spec.time_step_s) + " s, expected a number above zero");
  }
  if (!std::isfinite(spec.start_time_s)) refuse(spec, "start time is not a number");
  if (spec.block_rows == 0) refuse(spec, "block size is 0 rows, expected at least 1");
  std::set<std::string_view> seen{"Time"};
  for (const TableChannel& channel : spec.channels) {
    validate_channel(spec, channel);
    if (!seen.insert(channel.name).second) {
      refuse(spec, "channel name '" + channel.name + "' occurs twice ('Time' is always there)");
    }
  }
}

std::unique_ptr<TableWriter> make_table_writer(TableSpec spec) {
  std::string ending = spec.path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  if (ending == ".outb") return std::make_unique<OutbWriter>(std::move(spec));
  if (ending == ".csv") return std::make_unique<CsvWriter>(std::move(spec));
  refuse(spec, "unknown file ending '" + ending + "', expected .outb or .csv");
}

}  // namespace lac
