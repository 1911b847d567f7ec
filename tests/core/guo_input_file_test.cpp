// SPDX-License-Identifier: Apache-2.0
#include "core/guo_input_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/error_text.hpp"

namespace lac {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const GuoForm kForm{"FORM_v1", {"Count", "Angles", "", "Last"}, {"LegacyTiming"}};

GuoInputFile file(const std::string& text) {
  return GuoInputFile::parse(text, "a/x.IN");
}

// The grammar: three header lines, fixed order, a skipped line, keys without regard to case.
TEST(GuoInputFile, ReadsTheFixedOrder) {
  InputFile in = file(
                     "! one\n\nthree\n2 ! Count - of angles\n1.5D1\t-3 ! ANGLES [deg]\n"
                     "anything\n7 ! Last")
                     .read(kForm);
  EXPECT_EQ(in.integer("Count"), 2);
  EXPECT_THAT(in.numbers("Angles", 2, "Count"), ElementsAre(15.0, -3.0));
  EXPECT_EQ(in.number("Last"), 7.0);
  EXPECT_EQ(in.where("Last"), "a/x.IN:7: Last");
}

// `!` only separates words there, and so do quotes, commas and semicolons.
TEST(GuoInputFile, SeparatorsAreThoseOfTheirParser) {
  const auto lines =
      file("\n\n\n'2';Count\n1,-3 Angles\n\n\"seven\" ! Last' - x\n").sequence(kForm);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_THAT(lines[0].values, ElementsAre("2"));
  EXPECT_THAT(lines[1].values, ElementsAre("1", "-3"));
  EXPECT_THAT(lines[2].values, ElementsAre("seven"));
}

// Windows line ends and a byte-order mark pass; keys agree if their first 20 characters do.
TEST(GuoInputFile, LineEndsAndLongKeys) {
  const GuoForm form{"F", {"NumberOfModularLidars"}, {}};
  InputFile in = file("\xEF\xBB\xBF!\r\n!\r\n!\r\n3 ! numberofmodularlidarZ\r\n").read(form);
  EXPECT_EQ(in.integer("NumberOfModularLidars"), 3);
}

// Lines behind the last key do not matter, but for the keys that are asked for.
TEST(GuoInputFile, LinesBehindTheLast) {
  const std::string text = "\n\n\n2 ! Count\n1 2 ! Angles\n\n7 ! Last\n5 ! Other_Key\n";
  EXPECT_FALSE(file(text + "nothing").read(kForm).has("LegacyTiming"));
  InputFile in = file(text + "True ! LegacyTiming - x\n").read(kForm);
  EXPECT_TRUE(in.flag("LegacyTiming"));
  EXPECT_EQ(in.where("LegacyTiming"), "a/x.IN:9: LegacyTiming");
  EXPECT_THAT(
      test::error_text([&] { file("\n\n\nTrue ! LegacyTiming\n" + text.substr(3)).extras(kForm); }),
      StartsWith("a/x.IN:4: LegacyTiming: expected behind line 7"));
}

// A line out of place is named with its number, what it should be and where that stands.
TEST(GuoInputFile, LineOutOfPlace) {
  const auto error = [](const std::string& text) {
    return test::error_text([&] { file(text).sequence(kForm); });
  };
  EXPECT_EQ(error("\n\n2 ! Count\n1 2 ! Angles\n\n7 ! Last\n"),
            "a/x.IN:4: found '1 2 ! Angles', expected 'value(s) ! Count', which stands in line 3; "
            "read as FORM_v1 of Guo's chain: 3 header lines, then its keys in fixed order, one a "
            "line, nothing between");
  EXPECT_THAT(
      error("\n\n\n2 ! Count\n\n1 2 ! Angles\n"),
      StartsWith("a/x.IN:5: found '', expected 'value(s) ! Angles', which stands in line 6"));
  EXPECT_THAT(error("\n\n\n2 ! Count\n"),
              StartsWith("a/x.IN:5: the file ends after line 4, expected 'value(s) ! Angles'"));
  EXPECT_THAT(error("\n\n\nCount - none\n"), StartsWith("a/x.IN:4: Count: no value in front"));
}

// Values are checked as in our own files, with the line of theirs.
TEST(GuoInputFile, ValuesAreChecked) {
  const std::string start = "\n\n\n2 ! Count\n1 2 3 ! Angles\n\n";
  EXPECT_EQ(test::error_text([&] {
              InputFile in = file(start + "x ! Last").read(kForm);
              in.number("Last");
            }),
            "a/x.IN:7: Last: found 'x', expected a number");
  EXPECT_EQ(test::error_text([&] {
              InputFile in = file(start + "1 ! Last").read(kForm);
              in.numbers("Angles", 2, "Count");
            }),
            "a/x.IN:5: Angles: found 3 values, expected 2 as Count says");
}

// Which form a file is of follows from its keys, wherever they stand, but not from comments.
TEST(GuoInputFile, FormIsCertain) {
  const auto is_ldp = [](const std::string& text) { return file(text).is_theirs(guo_ldp_marks()); };
  EXPECT_TRUE(is_ldp("!\n!\n!\n4 ! NumberOfBeams\n1 2 3 4 ! Lidar_Azimuth\n"));
  EXPECT_TRUE(is_ldp("2 NumberOfModularLidars\n"));  // incomplete, but theirs
  EXPECT_FALSE(is_ldp("4 ! NumberOfBeams\n1.0 ! ScanTime\n! 1 2 ! Lidar_Azimuth\n"));
  EXPECT_FALSE(is_ldp("# 5 ! MC_Mode\nguo ! LidarLayout\n"));
  EXPECT_FALSE(is_ldp(""));
  EXPECT_TRUE(file("0 ! FlagLPF\n").is_theirs(guo_ffp_marks()));
  EXPECT_TRUE(file("\"a.dll\" ! SubDLLName\n").is_theirs(guo_wrapper_marks()));
  EXPECT_FALSE(file("\"a\" \"b\" \"c\" ! Secondary_1\n").is_theirs(guo_wrapper_marks()));
}

// A file that could be both, or neither quite, is refused with both names.
TEST(GuoInputFile, HalfAFormIsRefused) {
  const auto error = [](const std::string& text, const GuoMarks& marks) {
    return test::error_text([&] { file(text).is_theirs(marks); });
  };
  EXPECT_EQ(error("4 ! NumberOfBeams\n1 ! Lidar_Azimuth\n\n1.0 ! ScanTime\n", guo_ldp_marks()),
            "a/x.IN:2: Lidar_Azimuth: stands in Guo's LDP files, ScanTime (line 4) in those of our "
            "own form; expected keys of one form ('lac migrate' turns theirs into ours)");
  EXPECT_EQ(error("\n0 0 ! StaticWind\n", guo_ffp_marks()),
            "a/x.IN:2: StaticWind: stands in files of our own form, where CutOffFrequency is "
            "missing, and in Guo's FFP files, where FlagLPF is missing; expected one of them");
}

// A file that cannot be opened is nobody's: the reader of our own form says why.
TEST(GuoInputFile, FileThatIsNotThere) {
  const GuoInputFile none = GuoInputFile::load("no/such/file.IN");
  EXPECT_TRUE(none.empty());
  EXPECT_FALSE(none.is_theirs(guo_ldp_marks()));
  EXPECT_TRUE(GuoInputFile::load(".").empty());
}

}  // namespace
}  // namespace lac
