// SPDX-License-Identifier: Apache-2.0
#include "wrapper/signal_log.hpp"

namespace lac {

SignalLog::SignalLog(const OutputParams& params, const std::filesystem::path& file,
                     double time_step_s, std::int64_t first_step)
    : decimation_(params.decimation) {
  TableSpec spec;
  spec.path = file;
  for (const OutputChannel& c : params.channels) {
    records_.push_back(c.record);
    spec.channels.push_back(c.channel);
  }
  row_.resize(records_.size());
  const std::int64_t first_row = (first_step + decimation_ - 1) / decimation_ * decimation_;
  spec.start_time_s = static_cast<double>(first_row) * time_step_s;
  spec.time_step_s = static_cast<double>(decimation_) * time_step_s;
  spec.description = "LAC Chain: records of the controller chain";
  writer_ = make_table_writer(std::move(spec));
}

bool SignalLog::take(PrivateArray& array, std::int64_t step) noexcept {
  if (step % decimation_ != 0 || step <= last_step_) return true;
  last_step_ = step;
  for (std::size_t i = 0; i < records_.size(); ++i) row_[i] = *array.record(records_[i]);
  return writer_->append(row_.data());
}

}  // namespace lac
