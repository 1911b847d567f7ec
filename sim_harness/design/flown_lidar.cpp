// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/flown_lidar.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <span>

#include "core/error.hpp"
#include "sim_harness/analysis/correlation.hpp"
#include "sim_harness/tables/csv_table.hpp"
#include "sim_harness/tables/time_series.hpp"

namespace lac::sim {
namespace {

namespace fs = std::filesystem;

constexpr double kLongestDelay_s = 30.0;

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// One run at the steps of the chain's file, run-in left out.
struct Run {
  fs::path file;
  double step_s = 0.0;
  std::vector<double> rotor_mps, lidar_mps;
  double lead_s = 0.0;
};

std::vector<double> from(std::vector<double> values, std::size_t first) {
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first));
  return values;
}

/// Means of the rotor's wind about each row of the chain.
std::vector<double> at_rows_of(const Recording& chain, const Recording& turbine) {
  const std::vector<double> fine = turbine.column("RtVAvgxh");
  const double step_s = turbine.time_step_s();
  const auto half = static_cast<std::ptrdiff_t>(0.5 * chain.time_step_s() / step_s);
  std::vector<double> result;
  for (std::size_t i = 0; i < chain.rows(); ++i) {
    const double time_s = chain.start_time_s() + static_cast<double>(i) * chain.time_step_s() -
                          turbine.start_time_s();
    const auto middle = static_cast<std::ptrdiff_t>(std::lround(time_s / step_s));
    double sum = 0.0;
    int count = 0;
    for (std::ptrdiff_t j = middle - half; j <= middle + half; ++j) {
      if (j < 0 || j >= static_cast<std::ptrdiff_t>(fine.size())) continue;
      sum += fine[static_cast<std::size_t>(j)], ++count;
    }
    if (count == 0) break;
    result.push_back(sum / count);
  }
  return result;
}

Run read_run(const fs::path& folder, const std::string& controller, double run_in_s) {
  const fs::path file = folder / (controller + ".lac.outb");
  const Recording chain = read_time_series(file);
  const Recording turbine = read_time_series(folder / (controller + ".outb"));
  const std::size_t first = chain.first_row_from(chain.start_time_s() + run_in_s);
  const std::vector<double> rotor_mps = at_rows_of(chain, turbine);
  if (first >= rotor_mps.size()) {
    throw Error(file.string() + ": nothing is left behind a run-in of " + shortest(run_in_s) +
                " s (flown_lidar.run_in_s)");
  }
  Run run;
  run.file = file;
  run.step_s = chain.time_step_s();
  run.rotor_mps = from(rotor_mps, first);
  run.lidar_mps = from(chain.column("LidarRews"), first);
  run.lidar_mps.resize(run.rotor_mps.size());
  run.lead_s = mean_of(from(chain.column("LidarRewsLead"), first)) -
               0.5 * mean_of(from(chain.column("LidarScanWindow"), first));
  const std::vector<double> valid = from(chain.column("LidarRewsValid"), first);
  for (const double v : valid)
    if (v != 1.0) throw Error(folder.string() + ": LidarRews is not always valid after the run-in");
  return run;
}

/// The series, shifted by the lead, have to hold a block; and the lags of the correlation.
void check_length(const Run& run, double block_s) {
  if (!(run.lead_s >= 0.0)) {
    throw Error(run.file.string() + ": the mean of LidarRewsLead less half of LidarScanWindow is " +
                shortest(run.lead_s) + " s, expected 0 or more");
  }
  const double length_s = static_cast<double>(run.rotor_mps.size()) * run.step_s;
  const double least_s = std::max(run.lead_s + block_s, kLongestDelay_s + 10.0 * run.step_s);
  if (length_s < least_s) {
    throw Error(run.file.string() + ": " + shortest(length_s) +
                " s are left behind the run-in, expected " + shortest(least_s) +
                " or more for a lead of " + shortest(run.lead_s) + " s and a block of " +
                shortest(block_s) + " s (flown_lidar.block_s)");
  }
}

void add(const Run& run, double block_s, std::unique_ptr<CrossSpectrumEstimator>& estimator,
         FlownLidar& result) {
  check_length(run, block_s);
  const auto block = static_cast<std::size_t>(std::lround(block_s / run.step_s));
  if (!estimator) estimator = std::make_unique<CrossSpectrumEstimator>(run.step_s, block);
  const auto shift = static_cast<std::size_t>(std::lround(run.lead_s / run.step_s));
  const std::size_t length = run.rotor_mps.size() - shift;
  const std::span<const double> rotor(run.rotor_mps), lidar(run.lidar_mps);
  if (!estimator->add(rotor.subspan(shift), lidar.first(length)))
    throw Error(run.file.string() + ": shorter than a block of " + shortest(block_s) +
                " s (flown_lidar.block_s)");
  LagRange lags;
  lags.max_s = kLongestDelay_s;
  const std::size_t kept =
      run.rotor_mps.size() - static_cast<std::size_t>(kLongestDelay_s / run.step_s) - 2;
  result.delay_s += correlation_peak(lidar, rotor, run.step_s, 0, kept, lags).delay_s;
  result.lead_s += run.lead_s;
  ++result.runs;
}

std::string values_in(const CsvTable& table, std::size_t column,
                      const std::vector<std::size_t>& rows) {
  std::set<std::string> values;
  for (const std::size_t row : rows) values.insert(table.text(row, column));
  std::string list;
  for (const std::string& value : values) list += (list.empty() ? "" : ", ") + value;
  return list;
}

/// Condition after condition, so that the message is about the one that leaves nothing.
std::vector<std::size_t> wanted_rows(const CsvTable& table, const FlownCampaign& c) {
  std::vector<std::size_t> rows(table.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  if (rows.empty()) throw Error(table.file().string() + ": has no row, expected runs");
  for (const auto& [name, value] : c.where) {
    const std::size_t column = table.column(name);
    const std::vector<std::size_t> before = rows;
    std::erase_if(rows, [&](std::size_t row) { return table.text(row, column) != value; });
    if (!rows.empty()) continue;
    throw Error(c.file.string() + ": flown_lidar.where: found " + name + "=" + value +
                ", which leaves no row of " + table.file().string() + "; expected one of " +
                values_in(table, column, before));
  }
  const std::size_t status = table.column("status");
  for (const std::size_t row : rows)
    if (table.text(row, status) != "done")
      throw Error(table.place(row) + ": this case has not ended well; fly the campaign to its end");
  return rows;
}

}  // namespace

FlownCampaign read_flown_campaign(YamlReader in) {
  FlownCampaign c;
  c.file = in.file();
  c.table = in.existing_file("campaign");
  for (const std::string& text : in.texts("where")) {
    const std::size_t mark = text.find('=');
    if (mark == std::string::npos) in.fail("where", "found " + text + ", expected column=value");
    c.where.emplace_back(text.substr(0, mark), text.substr(mark + 1));
  }
  c.run_in_s = in.number("run_in_s", c.run_in_s, Range::not_negative());
  c.block_s = in.number("block_s", c.block_s, Range::positive());
  in.finish();
  return c;
}

std::vector<FlownLidar> flown_lidar(const FlownCampaign& c) {
  const CsvTable table(c.table);
  struct Speed {
    FlownLidar result;
    std::unique_ptr<CrossSpectrumEstimator> estimator;
  };
  std::map<double, Speed> speeds;
  for (const std::size_t row : wanted_rows(table, c)) {
    const double v = table.number(row, table.column("mean_speed_mps"));
    const fs::path folder = c.table.parent_path() / "cases" / table.text(row, table.column("case"));
    const Run run = read_run(folder, table.text(row, table.column("controller")), c.run_in_s);
    add(run, c.block_s, speeds[v].estimator, speeds[v].result);
  }
  std::vector<FlownLidar> all;
  for (auto& [v, s] : speeds) {
    s.result.mean_speed_mps = v;
    s.result.delay_s /= static_cast<double>(s.result.runs);
    s.result.lead_s /= static_cast<double>(s.result.runs);
    s.result.spectrum = s.estimator->result();
    all.push_back(std::move(s.result));
  }
  return all;
}

}  // namespace lac::sim
