// SPDX-License-Identifier: Apache-2.0
#include "wrapper/guo_wrapper_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "support/error_text.hpp"
#include "support/guo_host.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::HasSubstr;

#if defined(_WIN32)
constexpr const char* kSuffix = ".dll";
#else
constexpr const char* kSuffix = ".so";
#endif

/// A folder as a user of theirs has it: input files there, libraries of another system.
class GuoWrapperFile : public ::testing::Test {
 protected:
  GuoWrapperFile() {
    folder_.write("LDP_v1.IN", test::kGuoLdpV1);
    folder_.write("FFP_a.IN", test::guo_ffp_v1(0, 1.0, 2.0));
    folder_.write("other.IN", "anything\n");
  }
  std::string write(const std::string& rows, int count = 3) {
    return folder_.write("WRAPPER.IN", "! Master\n\n! Do not change\n" + std::to_string(count) +
                                           " ! NumberofSubDLLs - number\n" + rows);
  }
  WrapperParams read(const std::string& rows, int count = 3) {
    notice_.clear();
    return read_guo_wrapper_file(write(rows, count), notice_).value();
  }
  std::string error(const std::string& rows, int count) {
    return test::error_text([&] { read(rows, count); });
  }

  const std::string rows_ =
      "\"LDP_v1.dll\" ! SubDLLName - lidar\n\"LDP_v1.IN\" ! SubDLLInputName - its input\n"
      "'.\\FFP.dll' ! SubDLLName\n'FFP_a.IN' ! SubDLLInputName\n"
      "Feedback_v2.6.dll ! SubDLLName\nother.IN ! SubDLLInputName";
  test::TempFolder folder_;
  Notice notice_;
};

// Rows in the order of calls; LDP and FFP that are not there are ours; the lidar layout is theirs.
TEST_F(GuoWrapperFile, MissingLibrariesAreReplacedByOurs) {
  const WrapperParams p = read(rows_);
  ASSERT_EQ(p.secondaries.size(), 3U);
  EXPECT_EQ(p.secondaries[0].name, "LDP_v1");
  EXPECT_EQ(p.secondaries[0].library, "liblac_ldp");
  EXPECT_EQ(p.secondaries[0].input_file, folder_.path("LDP_v1.IN"));
  EXPECT_THAT(p.secondaries[0].where, EndsWith("WRAPPER.IN:5: SubDLLName"));
  EXPECT_EQ(p.secondaries[1].name, "FFP");
  EXPECT_EQ(p.secondaries[1].library, "liblac_ffp");
  EXPECT_EQ(p.secondaries[2].name, "Feedback_v2_6");
  EXPECT_EQ(p.secondaries[2].library, "Feedback_v2.6");  // for the system's search
  EXPECT_EQ(p.secondaries[2].entry, "DISCON");
  EXPECT_EQ(p.lidar, HostLidar::Guo);
  EXPECT_EQ(notice_.level(), 1);
  EXPECT_EQ(notice_.text(),
            "input file read as WRAPPER.IN of Guo's chain, not found and replaced by our own "
            "libraries: LDP_v1.dll, ./FFP.dll; differences: docs/hosts/guo.md");
}

// A library that is there is taken, with the ending of this system and perhaps `lib` in front.
TEST_F(GuoWrapperFile, LibrariesThatAreThereAreTaken) {
  folder_.write(std::string("LDP_v1") + kSuffix, "x");
  folder_.write(std::string("libFFP") + kSuffix, "x");
  const WrapperParams p = read(rows_);
  EXPECT_EQ(p.secondaries[0].library, std::string("LDP_v1") + kSuffix);
  EXPECT_EQ(p.secondaries[1].library, std::string("libFFP") + kSuffix);
  EXPECT_EQ(notice_.text(),
            "input file read as WRAPPER.IN of Guo's chain; differences: docs/hosts/guo.md");
}

// The same library twice gets two names.
TEST_F(GuoWrapperFile, NamesDiffer) {
  const WrapperParams p = read(
      "LDP.dll ! SubDLLName\nLDP_v1.IN ! SubDLLInputName\n"
      "ldp.dll ! SubDLLName\nLDP_v1.IN ! SubDLLInputName\n",
      2);
  EXPECT_EQ(p.secondaries[0].name, "LDP");
  EXPECT_EQ(p.secondaries[1].name, "ldp_2");
}

// Keys of our master may stand behind theirs.
TEST_F(GuoWrapperFile, KeysOfOursBehindTheirs) {
  const WrapperParams p = read(rows_ +
                               "\nnative ! LidarLayout\ncsv ! OutputFormat\nLidarRews rec175 ! "
                               "OutputChannels\n4 ! Some_Other_Line\n");
  EXPECT_EQ(p.lidar, HostLidar::Native);
  EXPECT_EQ(p.output.channels.size(), 2U);
  EXPECT_THAT(test::error_text([&] { read(rows_ + "\nnativ ! LidarLayout\n"); }),
              HasSubstr("WRAPPER.IN:11: LidarLayout: found 'nativ'"));
}

// A file of our own form is left to its reader.
TEST_F(GuoWrapperFile, OurOwnForm) {
  Notice notice;
  const std::string ours = folder_.write("w.IN", "\"a\" \"liblac_ldp\" \"x.IN\" ! Secondary_1\n");
  EXPECT_FALSE(read_guo_wrapper_file(ours, notice).has_value());
  EXPECT_EQ(notice.level(), 0);
}

// What is wrong comes with its line.
TEST_F(GuoWrapperFile, Errors) {
  EXPECT_THAT(error(rows_, 4),
              HasSubstr("WRAPPER.IN:11: the file ends after line 10, expected 'value(s) ! "
                        "SubDLLName'; read as WRAPPER.IN"));
  EXPECT_THAT(error("\n" + rows_, 3),
              HasSubstr("WRAPPER.IN:5: found '', expected 'value(s) ! SubDLLName', which stands in "
                        "line 6"));
  EXPECT_THAT(
      error("x.dll ! SubDLLName\nnone.IN ! SubDLLInputName\n", 1),
      HasSubstr("WRAPPER.IN:6: SubDLLInputName: input file 'none.IN' is not there; tried:"));
  EXPECT_THAT(error("my lib.dll ! SubDLLName\nother.IN ! SubDLLInputName\n", 1),
              HasSubstr("WRAPPER.IN:5: SubDLLName: found 2 words, expected one (a blank ends"));
  EXPECT_THAT(error("", 0), HasSubstr("WRAPPER.IN:4: NumberofSubDLLs: found 0, expected a number"));
  EXPECT_THAT(
      error(rows_ + "\n\"a\" \"b\" \"c\" ! Secondary_1\n", 3),
      HasSubstr("stands in Guo's WRAPPER files, Secondary_1 (line 11) in those of our own"));
}

}  // namespace
}  // namespace lac
