// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim_harness/lidar/lidar_fault.hpp"
#include "sim_harness/lidar/lidar_params.hpp"
#include "sim_harness/lidar/lidar_weaknesses.hpp"
#include "sim_harness/run/wind_case.hpp"
#include "sim_harness/turbine/nacelle_anemometer.hpp"
#include "sim_harness/turbine/turbine_params.hpp"

namespace lac::sim {

struct CaseTime {
  double duration_s = 660.0;
  double run_in_s = 60.0;  // not part of the results
  double step_s = 0.0125;  // of the controller

  std::int64_t steps() const;
};

struct CaseLidar {
  LidarParams params;
  LidarWeaknessParams weaknesses = {};
  LidarFault fault;
};

/// One chain that is flown in the wind of the case.
struct CaseController {
  std::string name;                  // names its result files
  std::filesystem::path input_file;  // of the library that the host loads
  std::string library;               // empty: the master that lies beside this program
  std::string entry = "DISCON";
};

struct CaseOutputs {
  std::filesystem::path folder;
  bool outb = true;
  bool csv = true;
  bool html = true;
  bool wind = false;              // what the rotor meets, once for all controllers
  bool intensity = false;         // with_rotor_intensity() of every flight, and its table
  double intensity_lead_s = 0.0;  // an estimate is for so much later
  double wind_window_s = 600.0;   // of the turbulence intensity; no longer than the case
};

/// What `lac run` does: one wind, one turbine, several controllers one after the other. The
/// first controller is the reference of relative changes.
struct Case {
  std::filesystem::path file;
  std::string name;
  TurbineParams turbine;
  std::optional<CaseLidar> lidar = {};
  NacelleAnemometerParams anemometer = {};
  WindCase wind = {};
  std::vector<CaseController> controllers = {};
  CaseTime time = {};
  std::uint64_t seed = 1;
  CaseOutputs outputs = {};
};

/// The map `lidar` of a case. Throws lac::Error.
CaseLidar read_case_lidar(YamlReader in);

/// Where its lidar will ask for the wind, if it has one.
std::optional<WindDemand> lidar_demand(const Case& c);

/// Reads a case file; overrides as in YamlReader::load. Paths in it count from its own folder,
/// but results/<name> (the default) from where the program runs. Throws lac::Error: file, line,
/// key, found, expected, hint.
Case load_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

}  // namespace lac::sim
