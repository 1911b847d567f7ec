// SPDX-License-Identifier: Apache-2.0
#include "wrapper/chain_config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/swap_layout.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

// What a full file says, paths counted from its own folder.
TEST(ChainConfig, ReadsEverything) {
  const test::TempFolder folder;
  folder.write("l.IN", "");
  const auto file = folder.write(
      "w.IN",
      "lidar libx ./l.IN ! Secondary_1 -\n\"fb\" \"y.so\" \"l.IN\" \"Control\" ! Secondary_2 -\n"
      "Guo ! LidarLayout -\ntrue ! ExtendedDemands -\ncsv ! OutputFormat -\n"
      "sub/out.csv ! OutputFile -\n5 ! OutputDecimation -\nlidarrews rec20 ! OutputChannels -\n");
  InputFile in = InputFile::load(file);
  const WrapperParams p = WrapperParams::read(in);
  ASSERT_EQ(p.secondaries.size(), 2U);
  EXPECT_EQ(p.secondaries[0].where, file + ":1: Secondary_1");
  EXPECT_EQ(p.secondaries[0].name, "lidar");
  EXPECT_EQ(p.secondaries[0].library, "libx");
  EXPECT_EQ(p.secondaries[0].input_file, folder.file("l.IN"));
  EXPECT_EQ(p.secondaries[0].entry, "DISCON");
  EXPECT_EQ(p.secondaries[1].entry, "Control");
  EXPECT_EQ(p.lidar, HostLidar::Guo);
  EXPECT_TRUE(p.extended_demands);
  EXPECT_TRUE(p.output.enabled);
  EXPECT_EQ(p.output.decimation, 5);
  ASSERT_EQ(p.output.channels.size(), 2U);
  EXPECT_EQ(p.output.channels[0].record, static_cast<int>(Rec::LidarRews));
  EXPECT_EQ(p.output.channels[0].channel, (TableChannel{"LidarRews", "m/s"}));
  EXPECT_EQ(p.output.channels[1].channel, (TableChannel{"rec20", "rad/s"}));
  EXPECT_EQ(p.output.path("/runs/case.SrvD"), "/runs/sub/out.csv");
}

// Signals: name, record and unit, which default to nothing, and as output channels.
TEST(ChainConfig, Signals) {
  const test::TempFolder folder;
  folder.write("l.IN", "");
  InputFile in = InputFile::load(folder.write(
      "w.IN",
      "a libx l.IN ! Secondary_1 -\n\"CrestPitch\" 3400 \"rad\" ! Signal_1 -\n"
      "Level_2 3341 ! Signal_2 -\ncsv ! OutputFormat -\nlevel_2 crestpitch ! OutputChannels -\n"));
  const WrapperParams p = WrapperParams::read(in);
  ASSERT_EQ(p.signals.size(), 2U);
  EXPECT_EQ(p.signals[0].name, "CrestPitch");
  EXPECT_EQ(p.signals[0].record, 3400);
  EXPECT_EQ(p.signals[0].unit, "rad");
  EXPECT_EQ(p.signals[1].unit, "-");
  ASSERT_EQ(p.output.channels.size(), 2U);
  EXPECT_EQ(p.output.channels[0].record, 3341);
  EXPECT_EQ(p.output.channels[0].channel, (TableChannel{"Level_2", "-"}));
  EXPECT_EQ(p.output.channels[1].channel, (TableChannel{"CrestPitch", "rad"}));
}

// The words that mean a record; the first and the last record of the array.
TEST(ChainConfig, RawRecords) {
  EXPECT_EQ(raw_record("rec1"), 1);
  EXPECT_EQ(raw_record("REC3820"), kPrivateArraySize);
  for (const char* word : {"rec", "rec0", "rec-1", "rec3821", "rec1x", "recs", "12"}) {
    EXPECT_EQ(raw_record(word), 0) << word;
  }
}

TEST(ChainConfig, OutputNameFromTheHostsRoot) {
  OutputParams out;
  out.ending = ".outb";
  EXPECT_EQ(out.path("/runs/case.T1.SrvD"), "/runs/case.T1.lac.outb");
  EXPECT_EQ(out.path("wind_11.4"), "wind_11.4.lac.outb");
}

class ShippedChain : public testing::TestWithParam<const char*> {};

// The shipped files can be read, with every file they name, and their libraries load.
TEST_P(ShippedChain, LoadsWithItsLibraries) {
  InputFile in =
      InputFile::load(std::string(LAC_SOURCE_DIR) + "/config/nrel5mw/" + GetParam() + ".IN");
  const WrapperParams p = WrapperParams::read(in);
  for (const SecondaryParams& s : p.secondaries) {
    const DisconLibrary library = p.open_library(s, LAC_LIBRARY_DIR);
    EXPECT_EQ(library.path().parent_path(), LAC_LIBRARY_DIR);
  }
}

INSTANTIATE_TEST_SUITE_P(Nrel5mw, ShippedChain, testing::Values("wrapper_fb", "wrapper_lac"));

}  // namespace
}  // namespace lac
