// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "support/temp_folder.hpp"

namespace lac::test {

/// The unmodified library and 5 MW example of the rosco wheel, where `./run test` unpacks it.
struct RoscoFiles {
  std::filesystem::path root = LAC_ROSCO_DIR;
  std::filesystem::path library = root / "rosco/lib/libdiscon.so";

  bool there() const { return std::filesystem::exists(library); }

  /// Its example input with the log switched off, beside the performance table it names.
  std::string copy_input_to(const TempFolder& folder) const {
    const std::filesystem::path shipped = root / "Examples/Test_Cases/NREL-5MW";
    std::filesystem::copy_file(shipped / "Cp_Ct_Cq.NREL5MW.txt",
                               folder.path() / "Cp_Ct_Cq.NREL5MW.txt");
    std::ifstream in(shipped / "DISCON.IN");
    std::ofstream out(folder.path() / "DISCON.IN");
    for (std::string line; std::getline(in, line);) {
      const bool log_level = line.find("! LoggingLevel") != std::string::npos;
      out << (log_level ? "0 ! LoggingLevel - no log" : line) << '\n';
    }
    return folder.file("DISCON.IN");
  }
};

}  // namespace lac::test
