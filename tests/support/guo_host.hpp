// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "support/discon_caller.hpp"

namespace lac::test {

// Input files in the grammar of Guo's chain; numbers of our own.
inline const std::string kGuoHeader = "! Some lidar\n\nthird line of the header\n";
inline const std::string kGuoLegacy = "True ! LegacyTiming - as theirs\n";
inline const std::string kGuoLdpV1 = kGuoHeader +
                                     "4\t! NumberOfBeams - [-]\n"
                                     "16 17 -15 -18 ! Lidar_Azimuth - [deg]\n"
                                     "11 -13 -12 10.5 ! Lidar_Elevation - [deg]\n";
inline const std::string kGuoLdpV3 = kGuoHeader +
                                     "2 ! NumberOfModularLidars - [-]\n"
                                     "20 35 ! AngleToCenterline - [deg]\n"
                                     "6 ! NumberOfMeasurements - [-]\n";
inline const std::string kGuoLdpTask52 = kGuoHeader +
                                         "4 ! NumberOfBeams - [-]\n"
                                         "19 ! AngleToCenterline - [deg]\n"
                                         "3 ! IndexGate";

/// A curve of 0.01 rad per m/s above 10 m/s.
inline const std::string kGuoCurve =
    "\n"
    "!------- STATIC PITCH CURVE\n"
    "3 ! n_StaticPitchCurve - [-]\n"
    "0 10 30 ! StaticWind - [m/s]\n"
    "0 0 0.2 ! StaticPitch - [rad]\n";
inline std::string guo_ffp_v1(int low_pass, double cutoff_radps, double buffer_s) {
  return kGuoHeader + std::to_string(low_pass) + " ! FlagLPF - [0/1]\n" +
         std::to_string(cutoff_radps) + " ! f_cutoff - [rad/s]\n" + std::to_string(buffer_s) +
         " ! T_buffer - [s]\n" + kGuoCurve;
}
inline std::string guo_ffp_v2(int low_pass, int notch, double buffer_s) {
  return kGuoHeader + std::to_string(low_pass) +
         " ! FlagLPF - [0/1]\n0.3 ! f_cutoff_LP - [rad/s]\n" + std::to_string(notch) +
         " ! FlagNotch - [0/1]\n0.9 ! f_cutoff_Notch - [rad/s]\n0.02 ! betaNum_Notch\n"
         "0.4 ! betaDen_Notch\n" +
         std::to_string(buffer_s) + " ! T_buffer - [s]\n" + kGuoCurve;
}

/// A host of Guo's layout, with its array as long as it needs to be and no word of that in records
/// 66 and 129: a foreign master or its OpenFAST. `size` kPrivateArraySize: our master.
class GuoHost {
 public:
  static constexpr int kFirst = 165;  // record 63
  static constexpr int kForeignSize = 464;

  GuoHost(const std::string& library, std::string in_file, int gates = 1, int size = kForeignSize)
      : caller(library, std::move(in_file), size), gates_(gates) {
    SwapView swap = caller.swap();
    if (size == kForeignSize) {
      swap.set(Rec::ExtendedStart, 0.0);
      swap.set(Rec::ArraySize, 0.0);
    }
    swap.set(Rec::LogStart, kFirst);
    swap.put(kFirst + guo_lidar::kNumberOfGates, gates);
  }

  void measure(int beam, const std::vector<double>& speeds_mps) {
    SwapView swap = caller.swap();
    swap.put(kFirst + guo_lidar::kNewData, 1.0);
    swap.put(kFirst + guo_lidar::kBeamId, beam);
    for (int g = 0; g < gates_; ++g) {
      swap.put(kFirst + guo_lidar::kFirstSpeed + g, speeds_mps[static_cast<std::size_t>(g)]);
    }
  }
  /// aviFAIL; the new-data flag goes down.
  int call() {
    const int fail = caller.call(started_ ? 1 : 0);
    started_ = true;
    caller.swap().put(kFirst + guo_lidar::kNewData, 0.0);
    return fail;
  }
  double result(int offset) { return caller.swap().at(kFirst + gates_ + offset); }
  void put_rews(double rews_mps) {
    caller.swap().put(kFirst + gates_ + guo_lidar::kRews, rews_mps);
  }

  DisconCaller caller;

 private:
  int gates_;
  bool started_ = false;
};

}  // namespace lac::test
