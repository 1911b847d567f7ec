// SPDX-License-Identifier: Apache-2.0
// Lidar and rotor as a campaign has flown them, beside the model of a design.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "sim_harness/analysis/coherence.hpp"
#include "sim_harness/config/yaml_reader.hpp"

namespace lac::sim {

/// Some runs of a campaign: results.csv, and the rows whose columns have these values.
struct FlownCampaign {
  std::filesystem::path table;
  std::vector<std::pair<std::string, std::string>> where;
  double run_in_s = 60.0;
  double block_s = 100.0;        // of the coherence
  std::filesystem::path file{};  // the design that asks for them, for messages
};

/// Keys: campaign (results.csv, from the design file's folder), where (list of "column=value"),
/// run_in_s, block_s. Throws lac::Error.
FlownCampaign read_flown_campaign(YamlReader in);

/// All runs at one mean wind speed together: RtVAvgxh of the rotor and LidarRews of the chain, the
/// latter moved by its lead less half its window, as it is meant to arrive.
struct FlownLidar {
  double mean_speed_mps = 0.0;
  std::size_t runs = 0;
  CrossSpectrum spectrum;  // x: rotor, y: lidar
  double delay_s = 0.0;    // mean lag of the best correlation of lidar with rotor
  double lead_s = 0.0;     // mean, as LDP says it, less half its window
};

/// By mean wind speed, rising. Throws lac::Error: no such column or file, no row that is asked for,
/// runs that have not ended, a run too short or with a lead below zero.
std::vector<FlownLidar> flown_lidar(const FlownCampaign& campaign);

}  // namespace lac::sim
