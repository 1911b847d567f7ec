// SPDX-License-Identifier: Apache-2.0
// The shipped folder for OpenFAST as a whole, through the master and the 3300 records of the host.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>

#include "core/units.hpp"
#include "support/discon_caller.hpp"
#include "support/openfast_lidar_host.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

namespace fs = std::filesystem;

void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
}

/// A copy of the folder that can be used alone, its output as text with four channels.
void copy_folder(const test::TempFolder& folder, const std::string& ffp) {
  for (const auto& entry : fs::directory_iterator(LAC_SOURCE_DIR "/config/openfast")) {
    fs::copy_file(entry.path(), folder.path() / entry.path().filename());
  }
  std::string master = folder.read("wrapper.IN");
  replace(master, "\"ffp.IN\"", "\"" + ffp + "\"");
  replace(master, "\noutb ", "\ncsv ");
  replace(master, "\nGeneratorSpeed ",
          "\nLidarRewsValid FeedforwardActive FeedforwardReason FeedforwardBufferTime "
          "! OutputChannels\n! ");
  folder.write("wrapper.IN", master);
}

double wind_mps(double t, double x_m) {
  return 18.0 + 1.5 * std::sin(2.0 * kPi * (t + (-5.0 - x_m) / 18.0) / 40.0);
}

/// 60 s at 18 m/s; gives the last row of the chain's own output.
std::string last_row(const test::OpenFastLidarHost& host, const std::string& ffp) {
  test::TempFolder folder;
  copy_folder(folder, ffp);
  {
    test::DisconCaller caller("liblac_wrapper", folder.file("wrapper.IN"), kExtendedArraySize,
                              folder.file("case.SrvD"));
    caller.set_time_step(host.time_step_s);
    caller.swap().set(Rec::RotorSpeed, 1.267);
    caller.swap().set(Rec::GeneratorSpeed, 122.9);
    for (const Rec blade : {Rec::PitchBlade1, Rec::PitchBlade2, Rec::PitchBlade3}) {
      caller.swap().set(blade, 0.26);
    }
    for (long k = 0; k < 60 * 160; ++k) {
      host.fill(caller.swap(), k);
      caller.swap().set(Rec::HubWindSpeed, wind_mps(static_cast<double>(k) * 0.00625, -5.0));
      EXPECT_EQ(caller.call(k == 0 ? 0 : 1), 0) << caller.message();
    }
    EXPECT_GT(caller.swap().get(Rec::PitchDemandCollective), 0.0);
  }
  std::istringstream rows(folder.read("case.lac.csv"));
  std::string row, last;
  while (std::getline(rows, row)) last = row;
  return last.substr(last.find(',') + 1);
}

// The pulsed lidar: valid, feedforward fully on, and time left in the buffer.
TEST(OpenFastFolder, PulsedLidar) {
  test::OpenFastLidarHost host;
  host.wind_mps = wind_mps;
  const std::string row = last_row(host, "ffp.IN");
  EXPECT_EQ(row.rfind("1,1,0,", 0), 0U) << row;
  // 140 m is the nearest gate ahead of the filter's 6.3 s at this frequency and half a scan.
  EXPECT_NEAR(std::stod(row.substr(6)), 140.0 / 18.0 - 6.25 - 0.125, 0.15) << row;
}

// The five points over the rotor with their own feedforward file.
TEST(OpenFastFolder, SinglePoints) {
  test::OpenFastLidarHost host;
  host.sensor_type = 1;
  host.x_m = {-165.0, -165.0, -165.0, -165.0, -165.0};
  host.wind_mps = wind_mps;
  const std::string row = last_row(host, "ffp_points.IN");
  EXPECT_EQ(row.rfind("1,1,0,", 0), 0U) << row;
  EXPECT_NEAR(std::stod(row.substr(6)), 160.0 / 18.0 - 2.4 - 0.125, 0.15) << row;
}

}  // namespace
}  // namespace lac
