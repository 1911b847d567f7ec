// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/host/controller_host.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <utility>

#include "core/call_strings.hpp"
#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr int kMessageCapacity = kOpenFastMessageCapacity;
constexpr int kOutNameCapacity = kOpenFastOutNameCapacity;
constexpr int kMostLogged = 300;
constexpr int kFirstFreeRecord = 165;

/// A string as a Fortran host hands it over: what lies behind the NUL is left from before.
void place(const std::string& text, char* buffer) {
  constexpr char kRubbish[] = "\x80rubbish behind the terminator";
  std::memcpy(buffer, text.c_str(), text.size() + 1);
  std::memcpy(buffer + text.size() + 1, kRubbish, sizeof kRubbish - 1);
}

}  // namespace

std::vector<std::filesystem::path> folders_beside_program() {
  std::error_code unknown;  // found in PATH, a program does not know its own folder otherwise
  const std::filesystem::path link = std::filesystem::read_symlink("/proc/self/exe", unknown);
  const std::filesystem::path program = unknown ? own_folder() : link.parent_path();
  const std::filesystem::path above = program.parent_path();
  return {above / LAC_INSTALL_LIBDIR, above / "lib", program};
}

ControllerHost::ControllerHost(HostSetup setup, MessageSink on_warning)
    : setup_(std::move(setup)),
      on_warning_(std::move(on_warning)),
      library_(DisconLibrary::open(setup_.library, setup_.entry, setup_.library_folders)),
      array_(kExtendedArraySize, 0.0F),
      output_name_(setup_.output_root + ".SrvD") {
  if (output_name_.size() + 100 > kOutNameCapacity) {
    throw Error("path of the results is too long for a controller: " + output_name_);
  }
  fill_constants();
}

ControllerHost::~ControllerHost() {
  try {
    finish();
  } catch (const std::exception&) {  // the run ends for another reason, which is being told
  }
}

void ControllerHost::fill_constants() {
  SwapView s = swap();
  s.set(Rec::TimeStep, setup_.time_step_s);
  s.put(5, setup_.fine_pitch_rad);
  s.put(6, setup_.min_pitch_rad);
  s.put(7, setup_.max_pitch_rad);
  s.put(8, -setup_.pitch_rate_limit_radps);
  s.put(9, setup_.pitch_rate_limit_radps);
  s.set(Rec::PitchDemandPresent, setup_.initial_pitch_rad);
  s.put(13, setup_.rated_power_W);
  s.put(19, setup_.rated_generator_speed_radps);
  s.put(22, setup_.rated_torque_Nm);
  s.set(Rec::GeneratorContactor, 1.0);
  s.set(Rec::MessageCapacity, kMessageCapacity);
  s.set(Rec::InFileLength, static_cast<double>(setup_.input_file.size() + 1));
  s.set(Rec::OutNameLength, static_cast<double>(output_name_.size() + 1));
  s.set(Rec::NumberOfBlades, setup_.number_of_blades);
  s.set(Rec::LogCapacity, kMostLogged);
  s.set(Rec::LogStart, kFirstFreeRecord);
  s.set(Rec::OutNameCapacity, kOutNameCapacity);
  s.set(Rec::ExtendedStart, kExtendedSignature);
  s.put(95, setup_.air_density_kgpm3);
  s.put(96, setup_.mean_wind_mps);
  s.set(Rec::ArraySize, kExtendedArraySize);
  s.put(kPlatformBlock.first, 1.0);  // version of OpenFAST's extended layout
}

void ControllerHost::set_lidar(const LidarMeasurement& measurement, bool is_new) {
  write_native_lidar(swap(), measurement, is_new);
}

void ControllerHost::fill_measurements(const HostInputs& in) {
  SwapView s = swap();
  s.set(Rec::Status, calls_ == 0 ? LAC_STATUS_FIRST : LAC_STATUS_STEP);
  s.set(Rec::Time, static_cast<double>(calls_) * setup_.time_step_s);
  s.set(Rec::PitchBlade1, in.pitch_rad);
  s.set(Rec::PitchBlade2, in.pitch_rad);
  s.set(Rec::PitchBlade3, in.pitch_rad);
  s.set(Rec::ShaftPower, in.shaft_torque_Nm * in.rotor_speed_radps);
  if (calls_ > 0) {
    const HostDemands before = demands();
    s.set(Rec::PitchDemandPresent, before.pitch_rad);
    s.set(Rec::GeneratorTorque, before.torque_Nm);
    s.set(Rec::ElectricalPower,
          setup_.generator_efficiency * before.torque_Nm * generator_speed_before_radps_);
  }
  s.set(Rec::GeneratorSpeed, in.generator_speed_radps);
  s.set(Rec::RotorSpeed, in.rotor_speed_radps);
  s.set(Rec::HubWindSpeed, in.hub_wind_mps);
  s.set(Rec::TowerForeAftAcceleration, in.tower_acceleration_mps2);
  s.set(Rec::RotorAzimuth, in.azimuth_rad);
  s.set(Rec::SafetySystem, 0.0);
  s.put(109, in.shaft_torque_Nm);
  s.put(110, in.thrust_N);
  generator_speed_before_radps_ = in.generator_speed_radps;
}

ControllerHost::Reply ControllerHost::enter_library() {
  char message[kMessageCapacity];
  char output_name[kOutNameCapacity];
  std::vector<char> input_file(setup_.input_file.c_str(),
                               setup_.input_file.c_str() + setup_.input_file.size() + 1);
  place("", message);
  place(output_name_, output_name);
  Reply reply;
  library_.entry()(array_.data(), &reply.fail, input_file.data(), output_name, message);
  if (reply.fail != 0) {
    message[kMessageCapacity - 1] = '\0';
    reply.message = message;
  }
  return reply;
}

HostDemands ControllerHost::demands() const {
  const SwapReader s(array_.data(), static_cast<int>(array_.size()));
  return {s.get(Rec::PitchDemandCollective), s.get(Rec::TorqueDemand)};
}

void ControllerHost::require_usable_demands() const {
  const SwapReader s(array_.data(), static_cast<int>(array_.size()));
  const auto refuse = [&](Rec record, const char* expected) {
    std::ostringstream text;
    const RecordInfo* info = find_record(static_cast<int>(record));
    text << "record " << info->index << " (" << info->meaning << ") returned as " << s.get(record)
         << ", expected " << expected;
    throw Error(text.str());
  };
  const auto is_one_of = [&](Rec record, std::initializer_list<double> values) {
    return std::find(values.begin(), values.end(), s.get(record)) != values.end();
  };
  if (!std::isfinite(s.get(Rec::PitchDemandCollective))) {
    refuse(Rec::PitchDemandCollective, "a finite angle");
  }
  if (!std::isfinite(s.get(Rec::TorqueDemand))) refuse(Rec::TorqueDemand, "a finite torque");
  if (!is_one_of(Rec::GeneratorContactor, {0, 1})) refuse(Rec::GeneratorContactor, "0 or 1");
  if (!is_one_of(Rec::ShaftBrake, {0, 1, 16})) refuse(Rec::ShaftBrake, "0, 1 or 16");
  if (!is_one_of(Rec::PitchOverride, {0})) refuse(Rec::PitchOverride, "0");
  if (!is_one_of(Rec::TorqueOverride, {0})) refuse(Rec::TorqueOverride, "0");
  if (!(s.get(Rec::LogCount) <= kMostLogged)) refuse(Rec::LogCount, "at most 300");
}

HostDemands ControllerHost::call(const HostInputs& inputs) {
  fill_measurements(inputs);
  const double time_s = static_cast<double>(calls_) * setup_.time_step_s;
  const Reply reply = enter_library();
  ++calls_;
  if (reply.fail < 0) end_run(reply.message);
  if (reply.fail > 0) on_warning_(time_s, reply.message);
  try {
    require_usable_demands();
  } catch (const Error& e) {
    end_run(e.what());
  }
  return demands();
}

void ControllerHost::end_run(const std::string& problem) {
  const double time_s = static_cast<double>(calls_ - 1) * setup_.time_step_s;
  try {
    finish();
  } catch (const Error&) {  // a library that failed may fail again; the first reason is told
  }
  std::ostringstream text;
  text << "controller " << library_.path().filename().string() << " ended the run at t = " << time_s
       << " s: " << (problem.empty() ? "(no message)" : problem);
  throw Error(text.str());
}

void ControllerHost::finish() {
  if (finished_ || calls_ == 0) return;
  finished_ = true;
  swap().set(Rec::Status, LAC_STATUS_LAST);
  const Reply reply = enter_library();
  const double time_s = static_cast<double>(calls_ - 1) * setup_.time_step_s;
  if (reply.fail > 0) on_warning_(time_s, reply.message);
  if (reply.fail < 0) {
    throw Error("controller " + library_.path().filename().string() +
                " failed in the last call: " + reply.message);
  }
}

}  // namespace lac::sim
