// SPDX-License-Identifier: Apache-2.0
#include "core/part_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class PartFileTest : public testing::Test {
 protected:
  std::string error_of_new() const {
    return test::error_text([this] { PartFile file(target); });
  }
  test::TempFolder folder;
  std::filesystem::path target = folder.path("run.out");
};

// Until commit the old file stands; then the new one is there alone, also when it is shorter.
TEST_F(PartFileTest, ReplacesAnOlderFile) {
  folder.write("run.out", "old and long");
  folder.write("run.out.part", "left by a run that was ended");
  PartFile file(target);
  ASSERT_TRUE(file.write("new", 3));
  EXPECT_EQ(folder.read("run.out"), "old and long");
  file.commit();
  EXPECT_EQ(folder.read("run.out"), "new");
  EXPECT_FALSE(std::filesystem::exists(folder.path("run.out.part")));
}

// Reading back disturbs neither the end nor what is written next.
TEST_F(PartFileTest, ReadsBackBetweenWrites) {
  PartFile file(target);
  ASSERT_TRUE(file.write("abcd", 4));
  std::array<char, 2> two{};
  file.read(two.data(), two.size(), 1);
  EXPECT_THAT(two, testing::ElementsAre('b', 'c'));
  ASSERT_TRUE(file.write("ef", 2));
  EXPECT_THAT(test::error_text([&] { file.read(two.data(), 2, 5); }),
              HasSubstr("run.out.part: cannot read back what was written"));
  file.commit();
  EXPECT_EQ(folder.read("run.out"), "abcdef");
}

// One writer at a time: the second is refused by name and does no harm; the place is free again
// after a commit and after a file that was given up.
TEST_F(PartFileTest, OneWriterAtATime) {
  {
    PartFile first(target);
    ASSERT_TRUE(first.write("first", 5));
    EXPECT_THAT(error_of_new(), AllOf(HasSubstr("run.out: another run is writing this file ("),
                                      HasSubstr("run.out.part is locked)")));
    first.commit();
  }
  { PartFile given_up(target); }
  EXPECT_FALSE(std::filesystem::exists(folder.path("run.out.part")));
  EXPECT_EQ(folder.read("run.out"), "first");
  EXPECT_EQ(error_of_new(), "no error");
}

// Committed, the file belongs to nobody, although the object still lives.
TEST_F(PartFileTest, CommittedFileIsFree) {
  PartFile first(target);
  first.commit();
  EXPECT_EQ(error_of_new(), "no error");
  EXPECT_TRUE(std::filesystem::remove(target));
}

// Why not, in the same words on every system.
TEST_F(PartFileTest, SaysWhyNot) {
  std::filesystem::create_directory(target);
  EXPECT_THAT(error_of_new(), HasSubstr("run.out: cannot create this file: Is a directory"));
  target = folder.path("missing") / "run.out";
  EXPECT_THAT(error_of_new(), HasSubstr("run.out: cannot create this file: No such file"));
}

}  // namespace
}  // namespace lac
