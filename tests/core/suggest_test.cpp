// SPDX-License-Identifier: Apache-2.0
#include "core/suggest.hpp"

#include <gtest/gtest.h>

namespace lac {
namespace {

const std::vector<std::string> kKeys{"LidarLayout", "OutputFile", "OutputFormat", "Weight"};

TEST(Suggest, FindsTheMistypedWord) {
  EXPECT_EQ(closest("LidarLayuot", kKeys), "LidarLayout");
  EXPECT_EQ(closest("outputformat", kKeys), "OutputFormat");
  EXPECT_EQ(closest("Output_File", kKeys), "OutputFile");
  EXPECT_EQ(did_you_mean("Wieght", kKeys), " (did you mean 'Weight'?)");
}

// At most a third of the letters may differ, but one always may.
TEST(Suggest, KeepsQuietWhenNothingIsClose) {
  EXPECT_EQ(closest("PitchRate", kKeys), "");
  EXPECT_EQ(did_you_mean("", kKeys), "");
  EXPECT_EQ(closest("ab", {"ac"}), "ac");
  EXPECT_EQ(closest("ab", {"cd"}), "");
  EXPECT_EQ(closest("x", {}), "");
}

// Two letters in the wrong order are one mistake, so that short words are found as well.
TEST(Suggest, SwappedLetters) {
  EXPECT_EQ(closest("rnu", {"check", "run"}), "run");
  EXPECT_EQ(closest("unr", {"check", "run"}), "");
}

TEST(Suggest, EqualIgnoringCase) {
  EXPECT_TRUE(equal_ignoring_case("NatiVe", "native"));
  EXPECT_FALSE(equal_ignoring_case("native", "natives"));
  EXPECT_TRUE(equal_ignoring_case("", ""));
}

}  // namespace
}  // namespace lac
