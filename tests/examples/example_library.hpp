// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

#include "core/discon_library.hpp"
#include "support/test_host.hpp"

namespace lac::test {

/// One of the secondaries under examples/, as this build made it.
struct ExampleLibrary {
  const char* folder;
  const char* name;
  bool built = true;

  std::string input_file() const {
    return std::string(LAC_SOURCE_DIR "/examples/") + folder + "/" + name + ".IN";
  }
  DisconLibrary open() const {
    return DisconLibrary::open(std::string("lib") + name, "DISCON", {LAC_LIBRARY_DIR});
  }
};

inline constexpr ExampleLibrary kTowerFilter{"c", "tower_filter"};
inline constexpr ExampleLibrary kSpeedSupervisor{"cpp", "speed_supervisor"};
inline constexpr ExampleLibrary kMinimumPitch{"fortran", "minimum_pitch", LAC_HAS_FORTRAN != 0};
inline constexpr const char* kNoFortran = "no Fortran compiler was found when this was configured";

inline std::ostream& operator<<(std::ostream& out, const ExampleLibrary& e) {
  return out << e.name;
}

/// A host whose array is that of the LAC master.
class ExampleHost : public TestHost {
 public:
  explicit ExampleHost(const DisconLibrary& library, std::string in_file,
                       int records = kPrivateArraySize)
      : TestHost(library.entry(), std::move(in_file), "run.example.SrvD", records) {
    if (records >= kPrivateArraySize) set(Rec::ChainVersion, kChainLayoutVersion);
  }
};

}  // namespace lac::test
