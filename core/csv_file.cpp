// SPDX-License-Identifier: Apache-2.0
#include "core/csv_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace lac {
namespace {

constexpr std::size_t kValueWidth = 17;  // ",-1.17549435e-38" has 16
constexpr std::size_t kTimeWidth = 26;
constexpr int kTimeDigits = 10;

std::string header_line(const std::vector<TableChannel>& channels) {
  std::string line = "Time [s]";
  for (const TableChannel& channel : channels) {
    line += "," + channel.name + " [" + channel.unit + "]";
  }
  return line + "\n";
}

char* put_value(char* out, float value) {
  if (std::isnan(value)) return std::copy_n("nan", 3, out);  // the sign of a NaN says nothing
  return std::to_chars(out, out + kValueWidth, value).ptr;
}

}  // namespace

CsvWriter::CsvWriter(TableSpec spec)
    : spec_((validate(spec), std::move(spec))),
      file_(spec_.path),
      block_(spec_.block_rows * (kValueWidth * spec_.channels.size() + kTimeWidth)) {
  const std::string header = header_line(spec_.channels);
  healthy_ = file_.write(header.data(), header.size());
}

bool CsvWriter::append(const float* row) noexcept {
  if (!healthy_ || finished_) return false;
  const double time_s = spec_.start_time_s + static_cast<double>(rows_) * spec_.time_step_s;
  char* const begin = block_.data() + bytes_in_block_;
  char* out =
      std::to_chars(begin, begin + kTimeWidth, time_s, std::chars_format::general, kTimeDigits).ptr;
  for (std::size_t i = 0; i < spec_.channels.size(); ++i) {
    *out++ = ',';
    out = put_value(out, row[i]);
  }
  *out++ = '\n';
  bytes_in_block_ += static_cast<std::size_t>(out - begin);
  ++rows_;
  ++rows_in_block_;
  return rows_in_block_ < spec_.block_rows || flush_block();
}

bool CsvWriter::flush_block() noexcept {
  healthy_ = file_.write(block_.data(), bytes_in_block_);
  bytes_in_block_ = 0;
  rows_in_block_ = 0;
  return healthy_;
}

void CsvWriter::finish() {
  if (finished_) return;
  finished_ = true;
  flush_block();
  file_.commit();
}

}  // namespace lac
