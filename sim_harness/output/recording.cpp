// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/output/recording.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr double kRounding = 1e-6;  // of a step: times are sums of binary fractions

}  // namespace

Recording::Recording(std::vector<TableChannel> channels, double start_time_s, double time_step_s,
                     std::size_t expected_rows)
    : channels_(std::move(channels)), start_time_s_(start_time_s), time_step_s_(time_step_s) {
  if (channels_.empty()) throw Error("recording: no channels");
  values_.reserve(expected_rows * channels_.size());
}

std::span<const float> Recording::row(std::size_t index) const {
  return std::span(values_).subspan(index * channels_.size(), channels_.size());
}

std::size_t Recording::first_row_from(double time_s) const {
  const double steps = std::ceil((time_s - start_time_s_) / time_step_s_ - kRounding);
  return static_cast<std::size_t>(std::clamp(steps, 0.0, static_cast<double>(rows())));
}

std::vector<double> Recording::column(std::string_view name) const {
  const auto found = std::find_if(channels_.begin(), channels_.end(),
                                  [&](const TableChannel& c) { return c.name == name; });
  if (found == channels_.end()) {
    std::string known;
    for (const TableChannel& c : channels_) known += " " + c.name;
    throw Error("recording: no channel '" + std::string(name) + "'; there are:" + known);
  }
  std::vector<double> column;
  column.reserve(rows());
  for (auto i = static_cast<std::size_t>(found - channels_.begin()); i < values_.size();
       i += channels_.size()) {
    column.push_back(values_[i]);
  }
  return column;
}

void Recording::write(const std::filesystem::path& path, const std::string& description) const {
  TableSpec spec;
  spec.path = path;
  spec.channels = channels_;
  spec.start_time_s = start_time_s_;
  spec.time_step_s = time_step_s_;
  spec.description = description;
  const auto writer = make_table_writer(std::move(spec));
  for (std::size_t i = 0; i < rows(); ++i) writer->append(row(i).data());
  writer->finish();  // tells why, should a row have been refused
}

}  // namespace lac::sim
