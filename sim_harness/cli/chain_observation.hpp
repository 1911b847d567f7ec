// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/swap_view.hpp"
#include "sim_harness/cli/access_observer.hpp"
#include "wrapper/chain_config.hpp"

namespace lac::sim {

inline constexpr int kObservedSteps = 100;

/// Records that belong to the call itself (status, time step, sizes of strings ...): everybody
/// reads them.
bool is_of_the_call(int record);

/// Writes a lidar of this layout into a host's array: at every call, with values that change
/// slowly.
void place_lidar(HostLidar layout, SwapView host, double time_s, bool is_new);

struct SecondaryAccess {
  std::string name;
  ObservedArray::Accesses accesses;  // without records of the call
  std::string problem;               // why it was not observed to the end; empty if it was
};

/// Calls the secondaries of a chain one after the other with the master's own parts (HostLink,
/// Secondary, PrivateArray) for kObservedSteps steps of level flight, with a lidar in the layout
/// the chain asks for, and notes who touches what. One that fails is not called again but for
/// its last call. host_array: what the host sends in its first call. out_name: root of files
/// that secondaries may write. Throws lac::Error if a library cannot be loaded.
std::vector<SecondaryAccess> observe_chain(const WrapperParams& chain,
                                           const std::filesystem::path& master_folder,
                                           std::vector<float> host_array,
                                           const std::string& out_name);

}  // namespace lac::sim
