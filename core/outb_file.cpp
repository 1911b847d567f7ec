// SPDX-License-Identifier: Apache-2.0
#include "core/outb_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

#include "core/error.hpp"

namespace lac {
namespace {

static_assert(std::endian::native == std::endian::little, "the format is little-endian");

constexpr std::int16_t kFormatId = 4;
constexpr std::size_t kMinNameLength = 10;  // what the older ids have
constexpr double kLevels = 65535.0;
constexpr double kLowest = -32768.0;
constexpr double kHighest = 32767.0;

class ByteWriter {
 public:
  template <typename T>
  void put(T value) {
    bytes_.resize(bytes_.size() + sizeof value);
    std::memcpy(bytes_.data() + bytes_.size() - sizeof value, &value, sizeof value);
  }
  void text(std::string_view text, std::size_t width) {
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.insert(bytes_.end(), width - text.size(), ' ');
  }
  std::vector<char> take() { return std::move(bytes_); }

 private:
  std::vector<char> bytes_;
};

std::string in_brackets(const std::string& unit) {
  return "(" + unit + ")";
}

std::size_t name_length(const std::vector<TableChannel>& channels) {
  std::size_t length = kMinNameLength;
  for (const TableChannel& channel : channels) {
    length = std::max({length, channel.name.size(), channel.unit.size() + 2});
  }
  return length;
}

std::int16_t packed_value(float value, float scale, float offset) {
  const double finite = std::isfinite(value) ? value : 0.0;
  const double level = std::nearbyint(finite * scale + offset);
  return static_cast<std::int16_t>(std::clamp(level, kLowest, kHighest));
}

}  // namespace

void OutbWriter::Range::include(float value) noexcept {
  if (!std::isfinite(value)) return;
  min = finite == 0 ? value : std::min(min, value);
  max = finite == 0 ? value : std::max(max, value);
  ++finite;
}

OutbWriter::OutbWriter(TableSpec spec)
    : spec_((validate(spec), std::move(spec))),
      rows_file_(std::in_place, spec_.path),
      block_(spec_.block_rows * spec_.channels.size()),
      ranges_(spec_.channels.size()) {
  if (name_length(spec_.channels) > std::numeric_limits<std::int16_t>::max()) {
    throw Error(spec_.path.string() + ": a channel name or unit has more than 32767 characters");
  }
}

bool OutbWriter::append(const float* row) noexcept {
  if (!healthy_ || finished_) return false;
  const std::size_t width = ranges_.size();
  std::copy_n(row, width, block_.data() + rows_in_block_ * width);
  for (std::size_t i = 0; i < width; ++i) ranges_[i].include(row[i]);
  ++rows_;
  ++rows_in_block_;
  return rows_in_block_ < spec_.block_rows || flush_block();
}

bool OutbWriter::flush_block() noexcept {
  const std::size_t count = rows_in_block_ * ranges_.size();
  healthy_ = rows_file_->write(block_.data(), count * sizeof(float));
  rows_in_block_ = 0;
  return healthy_;
}

void OutbWriter::finish() {
  if (finished_) return;
  flush_block();
  finished_ = true;
  if (!healthy_) rows_file_->commit();  // throws: it knows the reason
  if (rows_ > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max())) {
    throw Error(spec_.path.string() + ": more than 2147483647 rows do not fit this format");
  }
  PartFile packed(spec_.path, ".packed.part");
  const std::vector<Packing> scales = packing();
  const std::vector<char> head = header(scales);
  packed.write(head.data(), head.size());
  pack_rows(scales, packed);
  packed.commit();
  rows_file_.reset();
}

std::vector<OutbWriter::Packing> OutbWriter::packing() const {
  const double smallest_range = std::sqrt(std::numeric_limits<float>::epsilon());
  std::vector<Packing> result;
  for (const Range& range : ranges_) {
    double min = range.min;
    double max = range.max;
    if (range.finite < rows_) {
      min = std::min(min, 0.0);
      max = std::max(max, 0.0);
    }
    const auto scale = static_cast<float>(kLevels / std::max(max - min, smallest_range));
    result.push_back({scale, static_cast<float>(kLowest - static_cast<double>(scale) * min)});
  }
  return result;
}

std::string OutbWriter::description() const {
  std::string text = spec_.description;
  const char* separator = "; not finite, stored as 0: ";
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    const std::uint64_t replaced = rows_ - ranges_[i].finite;
    if (replaced == 0) continue;
    text += separator + spec_.channels[i].name + " " + std::to_string(replaced);
    separator = ", ";
  }
  return text;
}

std::vector<char> OutbWriter::header(const std::vector<Packing>& packing) const {
  const std::size_t width = name_length(spec_.channels);
  const std::string text = description();
  ByteWriter out;
  out.put(kFormatId);
  out.put(static_cast<std::int16_t>(width));
  out.put(static_cast<std::int32_t>(packing.size()));
  out.put(static_cast<std::int32_t>(rows_));
  out.put(spec_.start_time_s);
  out.put(spec_.time_step_s);
  for (const Packing& channel : packing) out.put(channel.scale);
  for (const Packing& channel : packing) out.put(channel.offset);
  out.put(static_cast<std::int32_t>(text.size()));
  out.text(text, text.size());
  out.text("Time", width);
  for (const TableChannel& channel : spec_.channels) out.text(channel.name, width);
  out.text("(s)", width);
  for (const TableChannel& channel : spec_.channels) out.text(in_brackets(channel.unit), width);
  return out.take();
}

void OutbWriter::pack_rows(const std::vector<Packing>& packing, PartFile& packed) {
  const std::size_t width = packing.size();
  std::vector<std::int16_t> values(block_.size());
  for (std::uint64_t row = 0; row < rows_; row += spec_.block_rows) {
    const std::uint64_t rows = std::min<std::uint64_t>(spec_.block_rows, rows_ - row);
    const std::size_t count = rows * width;
    rows_file_->read(block_.data(), count * sizeof(float), row * width * sizeof(float));
    for (std::size_t i = 0; i < count; ++i) {
      const Packing& channel = packing[i % width];
      values[i] = packed_value(block_[i], channel.scale, channel.offset);
    }
    packed.write(values.data(), count * sizeof(std::int16_t));
  }
}

}  // namespace lac
