// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/flown_rotor_speed.hpp"

#include <algorithm>
#include <span>

#include "core/error.hpp"
#include "core/units.hpp"
#include "sim_harness/tables/time_series.hpp"

namespace lac::sim {
namespace {

constexpr std::size_t kBlocks = 4;  // of a record, before overlap

std::vector<std::filesystem::path> files_of(YamlReader& in, const std::string& key) {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : in.texts(key)) files.push_back(in.file().parent_path() / name);
  return files;
}

Spectrum spectrum_of(const std::filesystem::path& file, double run_in_s) {
  const Recording run = read_time_series(file);
  std::vector<double> speed_radps = run.column("RotSpeed");
  for (double& v : speed_radps) v = radps_from_rpm(v);
  const auto kept =
      std::span(speed_radps).subspan(run.first_row_from(run.start_time_s() + run_in_s));
  return welch(kept, run.time_step_s(), kept.size() / kBlocks);
}

}  // namespace

FlownRuns read_flown_runs(YamlReader& in, const std::vector<double>& speeds_mps) {
  FlownRuns runs;
  runs.mean_speed_mps = in.number("mean_speed_mps", Range::positive());
  if (std::ranges::find(speeds_mps, runs.mean_speed_mps) == speeds_mps.end())
    in.fail("mean_speed_mps", "expected one of wind_speeds_mps");
  runs.run_in_s = in.number("run_in_s", runs.run_in_s, Range::not_negative());
  runs.designed = in.choice("schedule", 0, {"designed", "template"}) == 0;
  runs.feedback_only = files_of(in, "feedback_only");
  runs.assisted = files_of(in, "lidar_assisted");
  in.finish();
  return runs;
}

Spectrum flown_rotor_speed(const std::vector<std::filesystem::path>& files, double run_in_s) {
  Spectrum mean = spectrum_of(files.front(), run_in_s);
  for (std::size_t i = 1; i < files.size(); ++i) {
    const Spectrum s = spectrum_of(files[i], run_in_s);
    if (s.frequency_hz != mean.frequency_hz)
      throw Error(files[i].string() + ": another step or length than " + files.front().string());
    for (std::size_t j = 0; j < s.density.size(); ++j) mean.density[j] += s.density[j];
  }
  for (double& d : mean.density) d /= static_cast<double>(files.size());
  return mean;
}

}  // namespace lac::sim
