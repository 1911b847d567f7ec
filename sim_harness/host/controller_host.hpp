// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/discon_library.hpp"
#include "core/lidar_block.hpp"

namespace lac::sim {

/// Which library, its input, and what a host tells it once and for all.
struct HostSetup {
  std::string library = "liblac_wrapper";  // path or name, with or without suffix
  std::vector<std::filesystem::path> library_folders;
  std::string entry = "DISCON";
  std::string input_file;   // handed on as accINFILE
  std::string output_root;  // handed on as avcOUTNAME, with ".SrvD" behind it

  double time_step_s = 0.0125;
  int number_of_blades = 3;
  double initial_pitch_rad = 0.0;
  double fine_pitch_rad = 0.0;
  double min_pitch_rad = 0.0;
  double max_pitch_rad = 0.0;
  double pitch_rate_limit_radps = 0.0;
  double rated_generator_speed_radps = 0.0;
  double rated_torque_Nm = 0.0;
  double rated_power_W = 0.0;
  double generator_efficiency = 1.0;
  double air_density_kgpm3 = 1.225;
  double mean_wind_mps = 0.0;
};

/// Where our own libraries lie, built or installed: ../lib seen from the program, or beside it.
std::vector<std::filesystem::path> folders_beside_program();

/// What the turbine measures at the time of a call.
struct HostInputs {
  double pitch_rad = 0.0;  // all blades alike
  double rotor_speed_radps = 0.0;
  double generator_speed_radps = 0.0;
  double shaft_torque_Nm = 0.0;  // low-speed shaft
  double thrust_N = 0.0;
  double hub_wind_mps = 0.0;
  double tower_acceleration_mps2 = 0.0;
  double azimuth_rad = 0.0;
};

struct HostDemands {
  double pitch_rad = 0.0;  // collective
  double torque_Nm = 0.0;  // generator side
};

/// Loads a controller library and calls it as OpenFAST v5 does; knows nothing of what is inside.
///
///     ControllerHost host(setup, print);
///     each step n = 0, 1, ...: host.set_lidar(...); demands = host.call(inputs)
///     host.finish()
///
/// Status 0 at the first call, 1 at all others, -1 once at the end: by finish(), after a failure,
/// or when the object goes away in the middle of a run. The array has 3300 records, zeroed at the
/// start and not cleared between calls; the strings are rebuilt for each call, with rubbish behind
/// their terminators. Measured torque and power (23, 15) and the pitch demand (11) are those of
/// the call before. One object per turbine; not to be moved while the library is in use.
class ControllerHost {
 public:
  /// Takes the text of a warning (aviFAIL > 0), at every call that returns one.
  using MessageSink = std::function<void(double time_s, const std::string& text)>;

  /// Throws lac::Error if the library cannot be loaded.
  ControllerHost(HostSetup setup, MessageSink on_warning);
  ~ControllerHost();
  ControllerHost(const ControllerHost&) = delete;
  ControllerHost& operator=(const ControllerHost&) = delete;

  /// The lidar block of the next call (core/lidar_block.hpp). Not called: no lidar on board.
  void set_lidar(const LidarMeasurement& measurement, bool is_new);

  /// One controller step at time n time_step. Throws lac::Error after the last call was made if
  /// the library returns aviFAIL < 0, or demands that no turbine could follow.
  HostDemands call(const HostInputs& inputs);

  /// The last call, with the records of the one before. Throws lac::Error if it fails. A second
  /// call does nothing; nor does it without a call() before.
  void finish();

  const std::filesystem::path& library_path() const { return library_.path(); }
  /// For tests and tools that look at the array between calls; counted from 1.
  SwapView swap() { return {array_.data(), static_cast<int>(array_.size())}; }

 private:
  struct Reply {
    int fail = 0;
    std::string message;  // empty without allocation unless fail is not 0
  };

  void fill_constants();
  void fill_measurements(const HostInputs& inputs);
  Reply enter_library();
  void require_usable_demands() const;
  HostDemands demands() const;
  [[noreturn]] void end_run(const std::string& problem);

  HostSetup setup_;
  MessageSink on_warning_;
  DisconLibrary library_;
  std::vector<float> array_;
  std::string output_name_;
  std::int64_t calls_ = 0;
  double generator_speed_before_radps_ = 0.0;
  bool finished_ = false;
};

}  // namespace lac::sim
