// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/run_case.hpp"

#include <chrono>
#include <iostream>
#include <optional>
#include <ostream>
#include <sstream>
#include <utility>

#include "core/error.hpp"
#include "sim_harness/output/progress.hpp"
#include "sim_harness/run/flight.hpp"
#include "sim_harness/run/intensity.hpp"
#include "sim_harness/run/interruption.hpp"
#include "sim_harness/run/report.hpp"
#include "sim_harness/tables/outb_reader.hpp"
#include "sim_harness/wind_check/wind_statistics.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostWarningsShown = 20;
constexpr double kRotorWindStep_s = 0.1;
constexpr double kRounding = 1e-9;

double seconds_now() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

/// Keeps what a controller says until the progress line is out of the way.
class Warnings {
 public:
  void take(double time_s, const std::string& text) {
    ++count_;
    if (count_ <= kMostWarningsShown) lines_ << "  t = " << time_s << " s: " << text << '\n';
  }
  void show(const std::string& controller, std::ostream& out) const {
    if (count_ == 0) return;
    out << controller << " says:\n" << lines_.str();
    if (count_ > kMostWarningsShown) {
      out << "  ... and " << count_ - kMostWarningsShown << " more\n";
    }
  }

 private:
  std::ostringstream lines_;
  std::size_t count_ = 0;
};

/// The file a chain writes by itself, beside the root name it is given; a stale one is removed.
fs::path chain_output_file(const fs::path& root) {
  fs::path file = root;
  file += ".lac.outb";
  return file;
}

FlownController fly_with_progress(const Case& c, const CaseController& controller,
                                  const WindField& wind, const RotorWind& rotor_wind,
                                  const Interruption& interruption) {
  const fs::path root = c.outputs.folder / controller.name;
  fs::remove(chain_output_file(root));
  Progress progress(controller.name);
  Warnings warnings;
  FlightReport report;
  report.on_progress = [&](double done) {
    interruption.check();
    progress.update(done);
  };
  report.on_warning = [&](double time_s, const std::string& text) { warnings.take(time_s, text); };
  try {
    FlownController flown{controller.name, fly(c, controller, wind, rotor_wind, root, report), {}};
    progress.finish();
    warnings.show(controller.name, std::cerr);
    if (fs::exists(chain_output_file(root)))
      flown.chain_output = read_outb(chain_output_file(root));
    return flown;
  } catch (const Error& e) {
    warnings.show(controller.name, std::cerr);
    if (interruption.requested()) {
      fs::remove(chain_output_file(root));
      throw Interrupted(controller.name + ": " + e.what());
    }
    throw Error(controller.name + ": " + e.what());
  }
}

void write_recording(const Case& c, const FlownController& flown, std::vector<fs::path>& files) {
  const std::string description =
      "lac " + c.name + ", " + flown.name + ": " + c.turbine.name + ", " + describe(c.wind);
  const auto write = [&](const char* ending) {
    files.push_back(c.outputs.folder / (flown.name + ending));
    flown.recording.write(files.back(), description);
  };
  if (c.outputs.outb) write(".outb");
  if (c.outputs.csv) write(".csv");
  if (flown.chain_output) files.push_back(chain_output_file(c.outputs.folder / flown.name));
}

/// A period shorter than the run is allowed, but not in silence.
std::string repetition(const Case& c, const WindField& wind) {
  if (wind.period_s() >= c.time.duration_s * (1.0 - kRounding)) return {};
  std::ostringstream text;
  text << "note: the wind repeats itself after its period of " << wind.period_s()
       << " s; the run lasts " << c.time.duration_s << " s\n";
  return text.str();
}

RotorWindParams rotor_of(const Case& c) {
  RotorWindParams p;
  p.radius_m = c.turbine.rotor.radius_m;
  p.hub_height_m = c.turbine.hub_height_m;
  p.t_end_s = c.time.duration_s;
  p.dt_s = kRotorWindStep_s;
  return p;
}

void create_folder(const fs::path& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) throw Error(folder.string() + ": cannot be created: " + problem.message());
}

std::filesystem::path write_wind_channels(const Case& c, const WindField& wind,
                                          const RotorSignals& signals) {
  const fs::path file = c.outputs.folder / (c.name + ".wind.outb");
  wind_channels(wind, signals, c.turbine.hub_height_m).write(file, describe(c.wind));
  return file;
}

}  // namespace

CaseWind make_case_wind(const Case& c) try {
  const WindDemand demand = lidar_demand(c).value_or(WindDemand{});
  std::unique_ptr<WindField> field = make_wind(c.wind, &demand);
  RotorWind rotor(*field, rotor_of(c));
  return {std::move(field), std::move(rotor), held_turbulence(c.wind)};
} catch (const Error& e) {
  throw Error(c.file.string() + ": wind: " + e.what());
}

CaseResult run_case(const Case& c, std::ostream& out) {
  create_folder(c.outputs.folder);
  const double start_s = seconds_now();
  const CaseWind wind = make_case_wind(c);
  out << c.name << ": wind ready in " << duration_text(seconds_now() - start_s) << '\n';
  return fly_case(c, wind, out);
}

CaseResult fly_case(const Case& c, const CaseWind& wind, std::ostream& out) {
  create_folder(c.outputs.folder);
  out << c.name << ": " << c.turbine.name << ", " << describe(c.wind) << '\n'
      << wind.note << repetition(c, *wind.field) << std::flush;

  const Interruption interruption;
  std::optional<RotorSignals> rotor;
  if (c.outputs.wind || c.outputs.intensity) {
    RotorWindParams until = rotor_of(c);
    if (c.outputs.intensity) until.t_end_s += c.outputs.intensity_lead_s;
    rotor = rotor_signals(*wind.field, until, c.outputs.wind_window_s);
  }
  CaseResult result;
  std::vector<std::string> names;
  for (const CaseController& controller : c.controllers) {
    result.flights.push_back(
        fly_with_progress(c, controller, *wind.field, wind.rotor, interruption));
    interruption.check();
    FlownController& flown = result.flights.back();
    if (c.outputs.intensity)
      flown.recording = with_rotor_intensity(flown, *rotor, c.outputs.intensity_lead_s);
    write_recording(c, flown, result.files);
    result.figures.push_back(flight_figures(flown.recording, c.time.run_in_s));
    names.push_back(controller.name);
  }
  if (c.outputs.wind) result.files.push_back(write_wind_channels(c, *wind.field, *rotor));
  const std::vector<ReportResult> rows = result_rows(result.figures);
  out << '\n' << result_table(names, rows) << '\n';
  if (c.outputs.intensity)
    out << intensity_table(result.flights, *rotor, c.time.run_in_s, c.outputs.wind_window_s,
                           c.outputs.intensity_lead_s)
        << '\n';
  if (c.outputs.html) {
    result.files.push_back(c.outputs.folder / (c.name + ".html"));
    write_html_report(result.files.back(), make_report(c, result.flights, rows));
  }
  for (const fs::path& file : result.files) out << "wrote " << file.string() << '\n';
  return result;
}

}  // namespace lac::sim
