// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/discon_abi.h"
#include "core/swap_view.hpp"

namespace lac::test {

/// The calls of ROSCO's Python class ControllerInterface (rosco.toolbox, 2.10), float for float:
///
/// * 500 floats, copied to new memory for each call (numpy's astype), the old memory freed;
/// * only records 1-4, 15, 20, 21, 23, 24, 27, 28, 33, 34, 37, 49-53, 61, 83 are ever filled;
/// * lengths 50 and 51 without the terminator, 49 half the true size of the message buffer;
/// * the root name is immutable memory, record 64 is 0;
/// * aviFAIL is never reset: the next call finds what the last one left;
/// * the first call is made by the constructor at 1 rad/s, and a failure in it is swallowed.
class RoscoToolboxHost {
 public:
  struct Turbine {  // what the class is given for each call
    int status = 1;
    double time_s = 0.0;
    double pitch_rad = 0.0;
    double generator_torque_Nm = 0.0;
    double generator_speed_radps = 0.0;
    double rotor_speed_radps = 0.0;
    double wind_mps = 0.0;
  };

  static constexpr std::size_t kFloats = 500;
  /// What ROSCO 2.10 reads of any host's array, the platform motion in 1001-1018 last. Its own
  /// class lends half of that; what lies behind is left to chance.
  static constexpr std::size_t kFloatsReadByRosco = 1018;

  RoscoToolboxHost(LacDisconFunction entry, std::string parameter_file, std::string sim_name,
                   std::size_t floats = kFloats)
      : entry_(entry),
        in_file_(std::move(parameter_file)),
        out_name_(std::move(sim_name)),
        array_(floats, 0.0f) {
    set(3, kTimeStep_s);
    set(61, 3.0);
    set(20, 1.0);
    set(21, 1.0);
    set(27, 10.0);
    set(28, 1.0);
    set(49, kMessageCapacity);
    set(50, static_cast<double>(in_file_.size()));
    set(51, static_cast<double>(out_name_.size()));
    set(52, kMessageCapacity);
    call_discon();
    set(1, 1.0);
  }

  void call_controller(const Turbine& t) {
    set(1, t.status);
    set(2, t.time_s);
    set(3, kTimeStep_s);
    for (const int record : {4, 33, 34}) set(record, t.pitch_rad);
    set(15, t.generator_speed_radps * t.generator_torque_Nm * 0.944);
    set(23, t.generator_torque_Nm);
    set(20, t.generator_speed_radps);
    set(21, t.rotor_speed_radps);
    for (const int record : {24, 37, 83, 53}) set(record, 0.0);
    set(27, t.wind_mps);
    call_discon();
  }

  float at(int record) const { return array_.at(static_cast<std::size_t>(record) - 1); }
  int fail() const { return fail_; }
  std::string message() const { return message_.data(); }
  /// Nothing written behind what record 49 allows, and the root name as it was.
  bool kept_to_its_buffers() const {
    for (std::size_t i = kMessageCapacity; i < message_.size(); ++i) {
      if (message_[i] != '\0') return false;
    }
    return out_name_ == out_name_seen_;
  }

 private:
  static constexpr double kTimeStep_s = 0.1;
  static constexpr int kMessageCapacity = 500;

  void set(int record, double value) {
    array_.at(static_cast<std::size_t>(record) - 1) = static_cast<float>(value);
  }

  void call_discon() {
    std::vector<float> copy = array_;
    std::vector<char> out(out_name_.c_str(), out_name_.c_str() + out_name_.size() + 1);
    entry_(copy.data(), &fail_, in_file_.c_str(), out.data(), message_.data());
    out_name_seen_ = std::string(out.begin(), out.end() - 1);
    array_ = std::move(copy);
  }

  LacDisconFunction entry_;
  std::string in_file_, out_name_, out_name_seen_;
  std::vector<float> array_;
  std::vector<char> message_ = std::vector<char>(1000, '\0');
  int fail_ = 0;
};

}  // namespace lac::test
