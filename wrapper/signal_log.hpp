// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/table_writer.hpp"
#include "wrapper/chain_config.hpp"
#include "wrapper/private_array.hpp"

namespace lac {

/// Selected records of the private array over time: memory is reserved at the start, the disk is
/// touched once per block of rows, and the file appears at finish().
class SignalLog {
 public:
  /// `first_step` is the next call's number: 0, or later after a restart.
  SignalLog(const OutputParams& params, const std::filesystem::path& file, double time_step_s,
            std::int64_t first_step);

  /// Takes every OutputDecimation-th call; false if the disk has refused a block. Steps that are
  /// done again after a restore (-10) are not taken again: the rows stay equidistant in time.
  /// [real time but for one write per block]
  bool take(PrivateArray& array, std::int64_t step) noexcept;

  /// Throws lac::Error.
  void finish() { writer_->finish(); }

 private:
  std::vector<int> records_;
  std::vector<float> row_;
  std::int64_t decimation_;
  std::int64_t last_step_ = -1;
  std::unique_ptr<TableWriter> writer_;
};

}  // namespace lac
