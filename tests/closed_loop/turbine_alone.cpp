// SPDX-License-Identifier: Apache-2.0
// One turbine in a process of its own: turbine_alone <turbine> <calls> <folder>
// leaves its demands in <folder>/T<turbine>.demands.
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>

#include "closed_loop/chain_turbine.hpp"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::string folder = argv[3];
  try {
    const lac::DisconLibrary master = lac::test::open_master();
    lac::test::ChainTurbine turbine(master, std::atoi(argv[1]), folder);
    turbine.run(std::atoi(argv[2]));
    std::ofstream out(folder + "/T" + argv[1] + ".demands", std::ios::binary);
    out.write(reinterpret_cast<const char*>(turbine.demands.data()),
              static_cast<std::streamsize>(turbine.demands.size() * sizeof(float)));
    return out ? 0 : 1;
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
