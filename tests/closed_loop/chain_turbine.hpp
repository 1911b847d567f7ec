// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "closed_loop/chain_inputs.hpp"
#include "core/discon_library.hpp"
#include "support/test_host.hpp"

namespace lac::test {

inline constexpr char kShippedChain[] = LAC_SOURCE_DIR "/config/nrel5mw/wrapper_lac.IN";

inline DisconLibrary open_master() {
  return DisconLibrary::open("liblac_wrapper", "DISCON", {LAC_LIBRARY_DIR});
}

/// The shipped lidar-assisted chain at the boundary of the host, with the inputs of one turbine.
/// Its output file goes to <folder>/T<turbine>.lac.outb.
class ChainTurbine {
 public:
  ChainTurbine(const DisconLibrary& master, int turbine, const std::string& folder)
      : inputs(turbine),
        host(master.entry(), kShippedChain, folder + "/T" + std::to_string(turbine) + ".SrvD") {}

  /// Goes on by so many calls; the demands of each are added to `demands`.
  void run(int calls) {
    for (int i = 0; i < calls; ++i) {
      if (moving_array) host.array = std::vector<float>(host.array);
      inputs.fill({host.array.data(), static_cast<int>(host.array.size())});
      if (host.call(std::exchange(status_, 1)) < 0) throw std::runtime_error(host.message());
      demands.push_back(host.get(Rec::PitchDemandCollective));
      demands.push_back(host.get(Rec::TorqueDemand));
    }
  }

  /// Replaces the first call: -9 with the name of the checkpoint.
  int restart(const std::string& file) {
    status_ = 1;
    return host.call_with(-9, file);
  }

  ChainInputs inputs;
  TestHost host;
  bool moving_array = false;  // a new array at another address in each call
  std::vector<float> demands;

 private:
  int status_ = 0;
};

}  // namespace lac::test
