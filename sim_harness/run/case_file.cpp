// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/case_file.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sim_harness/lidar/beam_extent.hpp"
#include "sim_harness/run/lidar_on_board.hpp"
#include "sim_harness/run/turbulence_case.hpp"
#include "sim_harness/wind/uniform_wind.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr char kFileNameCharacters[] =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";

constexpr double kLongest_s = 1.0e6;  // every step is kept in memory
constexpr double kFewestSteps = 2.0;  // that a standard deviation can be taken of

/// A word that makes a good file name.
std::string file_name_word(YamlReader& in, const std::string& key, const std::string& word) {
  if (word.empty() || word.find_first_not_of(kFileNameCharacters) != std::string::npos) {
    in.fail(key, "found '" + word +
                     "', expected letters, digits, '-' and '_' alone: result "
                     "files bear this name");
  }
  return word;
}

CaseTime read_time(YamlReader in) {
  CaseTime t;
  t.duration_s = in.number("duration_s", {0.0, kLongest_s, false});
  t.run_in_s = in.number("run_in_s", Range::not_negative());
  t.step_s = in.number("step_s", t.step_s, {1e-4, 1.0});
  if (t.duration_s - t.run_in_s < kFewestSteps * t.step_s) {
    in.fail("run_in_s", "expected a time before duration_s, by two steps at least");
  }
  const double steps = t.duration_s / t.step_s;
  if (std::abs(steps - std::round(steps)) > 1e-6 * steps) {
    in.fail("duration_s", "expected a multiple of step_s");
  }
  in.finish();
  return t;
}

/// A library given with a folder counts from the case file; a bare name is searched for.
std::string read_library(YamlReader& in) {
  const std::string word = in.text("library", "");
  return word.find('/') == std::string::npos ? word : in.path("library").string();
}

std::vector<CaseController> read_controllers(YamlReader& in) {
  std::vector<CaseController> all;
  for (YamlReader& item : in.maps("controllers")) {
    CaseController c;
    c.name = file_name_word(item, "name", item.text("name"));
    const bool taken = std::any_of(all.begin(), all.end(),
                                   [&](const CaseController& o) { return o.name == c.name; });
    if (taken) item.fail("name", "found '" + c.name + "' twice, expected different names");
    c.input_file = item.existing_file("input");
    c.library = read_library(item);
    c.entry = item.text("entry", c.entry);
    item.finish();
    all.push_back(std::move(c));
  }
  return all;
}

CaseOutputs read_outputs(YamlReader& in, const std::string& case_name, double duration_s) {
  CaseOutputs out;
  out.folder = fs::path("results") / case_name;
  out.wind_window_s = std::min(out.wind_window_s, duration_s);
  if (!in.has("outputs")) return out;
  YamlReader map = in.map("outputs");
  if (map.has("folder")) out.folder = map.path("folder");
  out.outb = map.flag("outb", out.outb);
  out.csv = map.flag("csv", out.csv);
  out.html = map.flag("html", out.html);
  out.wind = map.flag("wind", out.wind);
  out.intensity = map.flag("intensity", out.intensity);
  out.intensity_lead_s =
      map.number("intensity_lead_s", out.intensity_lead_s, Range::between(0.0, duration_s));
  out.wind_window_s = map.number("wind_window_s", out.wind_window_s, Range::positive());
  if (out.wind_window_s > duration_s) {
    map.fail("wind_window_s", "found " + shortest(out.wind_window_s) +
                                  ", expected at most time.duration_s = " + shortest(duration_s));
  }
  map.finish();
  return out;
}

NacelleAnemometerParams read_anemometer(YamlReader in) {
  NacelleAnemometerParams p;
  const Range share = Range::between(0.0, 1.0);
  p.induction_share = in.number("induction_share", p.induction_share, share);
  p.induction_lag_s = in.number("induction_lag_s", p.induction_lag_s, Range::positive());
  p.added_intensity = in.number("added_intensity", p.added_intensity, share);
  p.time_scale_s = in.number("time_scale_s", p.time_scale_s, Range::positive());
  in.finish();
  return p;
}

/// What a lidar needs of no field in particular: all of it but the field's borders.
void check_lidar(const YamlReader& in, const Case& c) {
  if (!c.lidar) return;
  const UniformWind everywhere{UniformWindParams{}};
  try {
    LidarOnBoard(c, everywhere);
  } catch (const Error& e) {
    const std::string text = e.what(), whose = "lidar: ";
    in.fail("lidar", text.starts_with(whose) ? text.substr(whose.size()) : text);
  }
}

std::uint64_t read_seed(YamlReader& in) {
  return static_cast<std::uint64_t>(in.integer("seed", 1, Range::between(0, 2147483647)));
}

}  // namespace

CaseLidar read_case_lidar(YamlReader in) {
  CaseLidar lidar;
  if (in.has("file")) {
    lidar.params = load_lidar(in.existing_file("file"));
  } else {
    lidar.params = read_lidar(in);
  }
  if (in.has("platform")) {
    YamlReader platform = in.map("platform");
    lidar.params.platform = read_platform_motion(platform);
    platform.finish();
  }
  if (in.has("weaknesses")) {
    YamlReader weaknesses = in.map("weaknesses");
    lidar.weaknesses = read_lidar_weaknesses(weaknesses);
    weaknesses.finish();
  }
  if (in.has("fault")) {
    YamlReader fault = in.map("fault");
    lidar.fault = read_lidar_fault(fault, static_cast<int>(lidar.params.scan.beams.size()));
    fault.finish();
  }
  in.finish();
  return lidar;
}

std::optional<WindDemand> lidar_demand(const Case& c) {
  if (!c.lidar) return std::nullopt;
  return wind_demand(c.lidar->params, c.turbine.hub_height_m);
}

std::int64_t CaseTime::steps() const {
  return std::llround(duration_s / step_s);
}

Case load_case(const fs::path& file, const std::vector<std::string>& overrides) {
  YamlReader in = YamlReader::load(file, overrides);
  const std::string name =
      in.has("name") ? file_name_word(in, "name", in.text("name")) : file.stem().string();
  const std::uint64_t seed = read_seed(in);
  Case c{.file = file, .name = name, .turbine = load_turbine(in.existing_file("turbine"))};
  c.seed = seed;
  c.time = read_time(in.map("time"));
  if (in.has("lidar")) c.lidar = read_case_lidar(in.map("lidar"));
  check_lidar(in, c);
  if (in.has("anemometer")) c.anemometer = read_anemometer(in.map("anemometer"));
  YamlReader wind = in.map("wind");
  c.wind =
      read_wind(wind, {c.turbine.hub_height_m, c.turbine.rotor.radius_m, seed, lidar_demand(c)});
  wind.finish();
  check_covers_rotor(wind, c.wind);
  c.controllers = read_controllers(in);
  c.outputs = read_outputs(in, name, c.time.duration_s);
  in.finish();
  return c;
}

}  // namespace lac::sim
