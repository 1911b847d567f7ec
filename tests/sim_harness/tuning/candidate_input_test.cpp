// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tuning/candidate_input.hpp"

#include <gtest/gtest.h>

#include "core/input_file.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

namespace fs = std::filesystem;
using test::error_text;

// Values change, everything else stays byte by byte; a key that is not there comes at the end.
TEST(WithValues, KeepsTheTemplate) {
  EXPECT_EQ(with_values("! TIRated is a comment\n"
                        "\n"
                        "0.16      ! TIRated - [-]\n"
                        "# TI0\n"
                        "1 2 3 ! TI0\n"
                        "\"a\" ! Name - of TIRated\n",
                        {{"tirated", "0.1525"}, {"TI0", "0.30000001"}, {"Rate", "0.005"}}),
            "! TIRated is a comment\n"
            "\n"
            "0.1525    ! TIRated - [-]\n"
            "# TI0\n"
            "0.30000001 ! TI0\n"
            "\"a\" ! Name - of TIRated\n"
            "0.005 ! Rate - tuned\n");
}

// The result reads as an input file with the new numbers.
TEST(WithValues, CanBeRead) {
  InputFile in = InputFile::parse(with_values("5 ! A\n7! B\n", {{"A", "6.5"}, {"B", "8"}}), "f");
  EXPECT_EQ(in.number("A"), 6.5);
  EXPECT_EQ(in.number("B"), 8.0);
}

class LinkedChain : public ::testing::Test {
 protected:
  LinkedChain() {
    fs::create_directories(folder_.path("config/chain"));
    fs::create_directories(folder_.path("config/tables"));
    folder_.write("config/tables/t.txt", "table");
    folder_.write("config/chain/a.IN", "a");
    folder_.write("config/chain/b.IN", "b");
    folder_.write("config/outside.IN", "o");
    folder_.write("config/chain/master.IN",
                  "\"first\" \"liba\" \"a.IN\" ! Secondary_1\n"
                  "\"second\" \"libb\" \"b.IN\" ! Secondary_2\n"
                  "\"third\" \"libc\" \"../outside.IN\" ! Secondary_3\n");
    fs::create_directories(folder_.path("work"));
  }
  test::TempFolder folder_;
  fs::path master_ = folder_.path("config/chain/master.IN");
};

// Beside the new file the old ones are found, a folder above too; the originals are as they were.
TEST_F(LinkedChain, PathsHold) {
  const fs::path input = input_of_secondary(master_, "SECOND");
  EXPECT_EQ(input.filename(), "b.IN");
  const fs::path copy = linked_chain(master_, input, "new", folder_.path("work/1"));
  EXPECT_EQ(copy, folder_.path("work/1/chain/master.IN"));
  EXPECT_EQ(folder_.read("work/1/chain/b.IN"), "new");
  EXPECT_EQ(folder_.read("work/1/chain/a.IN"), "a");
  EXPECT_EQ(folder_.read("work/1/chain/../tables/t.txt"), "table");
  EXPECT_EQ(folder_.read("config/chain/b.IN"), "b");
  fs::remove_all(folder_.path("work/1"));
  EXPECT_EQ(folder_.read("config/tables/t.txt"), "table");
}

// What cannot be done is said.
TEST_F(LinkedChain, Refuses) {
  EXPECT_NE(error_text([&] {
              input_of_secondary(master_, "secnd");
            }).find("has no secondary 'secnd', only first, second, third (did you mean 'second'?)"),
            std::string::npos);
  const fs::path outside = input_of_secondary(master_, "third");
  EXPECT_NE(error_text([&] {
              linked_chain(master_, outside, "x", folder_.path("work/2"));
            }).find("expected beside"),
            std::string::npos);
  const fs::path b = input_of_secondary(master_, "second");
  linked_chain(master_, b, "x", folder_.path("work/3"));
  EXPECT_NE(error_text([&] {
              linked_chain(master_, b, "x", folder_.path("work/3"));
            }).find("cannot link"),
            std::string::npos);
}

}  // namespace
}  // namespace lac::sim
