// SPDX-License-Identifier: Apache-2.0
#include "core/checkpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

using testing::HasSubstr;

class CheckpointFile : public testing::Test {
 protected:
  Checkpoint sample() const {
    return {"ldp", "some/folder/ldp.IN", "case.SrvD", 0.0125, 4711, {std::byte{1}, std::byte{255}}};
  }
  std::string refusal(const std::string& module = "ldp") {
    try {
      read_checkpoint(file, module);
    } catch (const Error& e) {
      return e.what();
    }
    return "read";
  }
  test::TempFolder folder;
  std::string file = folder.file("a.chkp");
};

TEST_F(CheckpointFile, RoundTrip) {
  write_checkpoint(file, sample());
  const Checkpoint c = read_checkpoint(file, "ldp");
  EXPECT_EQ(c.input_file, "some/folder/ldp.IN");
  EXPECT_EQ(c.out_name, "case.SrvD");
  EXPECT_EQ(c.time_step_s, 0.0125);
  EXPECT_EQ(c.steps, 4711);
  EXPECT_EQ(c.state, sample().state);
  EXPECT_FALSE(std::filesystem::exists(file + ".part"));
}

// Every single byte counts: one that is changed or missing is noticed.
TEST_F(CheckpointFile, DamageIsNoticed) {
  write_checkpoint(file, sample());
  const std::string whole = folder.read("a.chkp");
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    folder.write("a.chkp", damaged);
    EXPECT_THAT(refusal(), testing::StartsWith(file + ": ")) << i;
    folder.write("a.chkp", whole.substr(0, i));
    EXPECT_THAT(refusal(), testing::StartsWith(file + ": ")) << i;
  }
}

TEST_F(CheckpointFile, SaysWhatIsWrong) {
  EXPECT_THAT(refusal(), HasSubstr("cannot open the checkpoint"));
  folder.write("a.chkp", "this is a text file, and not a short one");
  EXPECT_THAT(refusal(), HasSubstr("is not a checkpoint of LAC Chain"));
  write_checkpoint(file, sample());
  EXPECT_THAT(refusal("ffp"), HasSubstr("checkpoint of 'ldp', expected 'ffp'"));
  std::string other = folder.read("a.chkp");
  other[7] = '2';
  folder.write("a.chkp", other);
  EXPECT_THAT(refusal(), HasSubstr("checkpoint format 2, expected 1"));
}

TEST_F(CheckpointFile, CannotBeWritten) {
  try {
    write_checkpoint(folder.file("no/where.chkp"), sample());
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("no/where.chkp: cannot create this file"));
  }
}

}  // namespace
}  // namespace lac
