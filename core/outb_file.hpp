// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/part_file.hpp"
#include "core/table_writer.hpp"

namespace lac {

/// OpenFAST binary output, format id 4 (equidistant time, packed int16, channel names of any
/// length), little-endian:
///
///   int16 4, int16 name length, int32 channels, int32 rows, float64 t0, float64 dt,
///   float32 scale[channels], float32 offset[channels], int32 length, description,
///   (channels + 1) names, (channels + 1) units "(rpm)", blank-padded, Time first,
///   int16 values, row by row; value = (stored - offset) / scale.
///
/// scale = 65535 / max(max - min, sqrt(eps of float32)), offset = -32768 - scale min. Error of
/// a value: at most half of (max - min) / 65535, plus the float32 rounding of its magnitude
/// where a channel is nearly constant beside its mean.
///
/// Sixteen bits have no place for "not a number": non-finite values are stored as 0, do not
/// count for max and min (but the range is widened to hold 0), and the description ends in
/// "; not finite, stored as 0: <channel> <count>, ...".
///
/// Rows go as float32 to "<path>.part" while the range is not yet known; finish() packs them
/// through "<path>.packed.part". Memory: block_rows * channels * 4 bytes.
class OutbWriter final : public TableWriter {
 public:
  explicit OutbWriter(TableSpec spec);
  ~OutbWriter() override = default;

  bool append(const float* row) noexcept override;
  void finish() override;

 private:
  struct Range {
    float min = 0.0F;
    float max = 0.0F;
    std::uint64_t finite = 0;
    void include(float value) noexcept;
  };
  struct Packing {
    float scale = 0.0F;
    float offset = 0.0F;
  };

  bool flush_block() noexcept;
  std::vector<Packing> packing() const;
  std::string description() const;
  std::vector<char> header(const std::vector<Packing>& packing) const;
  void pack_rows(const std::vector<Packing>& packing, PartFile& packed);

  TableSpec spec_;
  std::optional<PartFile> rows_file_;  // gone after finish()
  std::vector<float> block_;
  std::vector<Range> ranges_;
  std::size_t rows_in_block_ = 0;
  std::uint64_t rows_ = 0;
  bool healthy_ = true;
  bool finished_ = false;
};

}  // namespace lac
