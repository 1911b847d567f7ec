// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/fingerprint.hpp"

#include <gtest/gtest.h>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

namespace fs = std::filesystem;

class FingerprintTest : public ::testing::Test {
 protected:
  FingerprintTest() { write(folder_.path()); }
  static void write(const fs::path& folder) {
    fs::create_directories(folder / "deep");
    std::ofstream(folder / "case.yaml") << "turbine: deep/turbine.yaml # named here\n";
    std::ofstream(folder / "deep/turbine.yaml") << "table: \"with blank.txt\"\n";
    std::ofstream(folder / "deep/with blank.txt") << "1 2 3\n";
    std::ofstream(folder / "lidar.yaml") << "beams: 4\n";
  }
  std::string of(const std::vector<std::string>& overrides = {}) {
    return Fingerprints().of_case(folder_.path("case.yaml"), overrides);
  }

  test::TempFolder folder_;
};

// The same from call to call, at another place and at a later time.
TEST_F(FingerprintTest, OfContentAlone) {
  const std::string before = of();
  EXPECT_EQ(before.size(), 16U);
  write(folder_.path());
  EXPECT_EQ(of(), before);
  const test::TempFolder other;
  write(other.path());
  EXPECT_EQ(Fingerprints().of_case(other.path("case.yaml"), {}), before);
}

// It changes with the overrides, the case, a file named in a file, a file named in an override.
TEST_F(FingerprintTest, Changes) {
  const std::string before = of();
  EXPECT_NE(of({"seed=2"}), before);
  EXPECT_NE(of({"seed=2"}), of({"seed=3"}));
  folder_.write("deep/with blank.txt", "1 2 4\n");
  const std::string deeper = of();
  EXPECT_NE(deeper, before);
  folder_.write("case.yaml", "turbine: deep/turbine.yaml\n");
  EXPECT_NE(of(), deeper);
  const std::string with_lidar = of({"lidar.file=lidar.yaml"});
  folder_.write("lidar.yaml", "beams: 5\n");
  EXPECT_NE(of({"lidar.file=lidar.yaml"}), with_lidar);
}

// A file that nothing names does not count; two files that name each other come to an end.
TEST_F(FingerprintTest, OnlyWhatIsNamed) {
  const std::string before = of();
  folder_.write("lidar.yaml", "beams: 5\n");
  EXPECT_EQ(of(), before);
  folder_.write("deep/turbine.yaml", "table: ../case.yaml\n");
  EXPECT_NE(of(), before);
}

TEST_F(FingerprintTest, MissingCase) {
  EXPECT_NE(test::error_text([&] {
              Fingerprints().of_case(folder_.path("none"), {});
            }).find("cannot be read"),
            std::string::npos);
}

}  // namespace
}  // namespace lac::sim
