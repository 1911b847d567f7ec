// SPDX-License-Identifier: Apache-2.0
#include "core/input_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "core/error.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

InputFile of(const std::string& text) {
  return InputFile::parse(text, "dir/x.IN");
}
std::string refusal(const std::function<void()>& read) {
  try {
    read();
  } catch (const Error& e) {
    return e.what();
  }
  return "accepted";
}

// The field's own form: any order, comments, blanks, commas, quotes, signs, Fortran exponents.
TEST(InputFile, ReadsEveryKind) {
  InputFile in =
      of("! comment\n# comment\n\n"
         "1.5D-3, +2 ,-3e1\t! Row - numbers [m]\n"
         "20.000 ! Count - whole\n"
         "TRUE ! Flag\n"
         "\"two words ! here\" 'x y' z ! Names - texts\n"
         "Second ! Choice -\n"
         "7 !NoBlank - key right behind the mark\n"
         "0.25 ! Last");
  EXPECT_THAT(in.numbers("row"), ElementsAre(1.5e-3, 2.0, -30.0));
  EXPECT_EQ(in.integer("COUNT"), 20);
  EXPECT_TRUE(in.flag("Flag"));
  EXPECT_THAT(in.texts("Names"), ElementsAre("two words ! here", "x y", "z"));
  EXPECT_EQ(in.choice("Choice", {"first", "second"}), 1);
  EXPECT_EQ(in.integer("NoBlank"), 7);
  EXPECT_EQ(in.number("Last"), 0.25);
  EXPECT_EQ(in.number("Absent", 9.0, Range::any()), 9.0);
  EXPECT_FALSE(in.has("Absent"));
  EXPECT_EQ(refusal([&] { in.finish(); }), "accepted");
}

TEST(InputFile, WindowsLineEndsAndByteOrderMark) {
  InputFile in = of("\xEF\xBB\xBF! c\r\n1 ! A\r\n\r\ntext ! B - b\r\n");
  EXPECT_EQ(in.number("A"), 1.0);
  EXPECT_EQ(in.text("B"), "text");
}

// Lines may end as on old Macintoshes: nothing hides behind a comment in the first one.
TEST(InputFile, CarriageReturnAlone) {
  InputFile in = of("! c\r1 ! A\rx ! B\r\n");
  EXPECT_EQ(in.number("A"), 1.0);
  EXPECT_EQ(in.text("B"), "x");
  EXPECT_EQ(refusal([] { of("! c\r1 ! A\r\rx\r"); }).substr(0, 11), "dir/x.IN:4:");
}

// What is no text is named as such; long and unprintable words do not hide what was expected.
TEST(InputFile, RubbishIsQuotedWithCare) {
  EXPECT_THAT(refusal([] { of(std::string("1 ! A\n\0\0", 8)); }),
              HasSubstr("dir/x.IN: byte 7 is zero: found a binary or UTF-16 file"));
  const std::string word(9000, 'z');
  EXPECT_EQ(refusal([&] { of(word + " ! A").number("A"); }),
            "dir/x.IN:1: A: found '" + word.substr(0, 60) + "...', expected a number");
  EXPECT_THAT(refusal([&] { of("1 ! " + word).finish(); }), HasSubstr("zzz...: unknown key"));
  EXPECT_EQ(refusal([&] { of("a\033[1m\x7f ! A").integer("A"); }),
            "dir/x.IN:1: A: found 'a?[1m?', expected a number");
}

// Each refusal names file, line, key, what was found and what was expected.
TEST(InputFile, RefusalsAreComplete) {
  const auto with = [](const std::string& line, const std::function<void(InputFile&)>& read) {
    return refusal([&] {
      InputFile in = of("! first\n" + line + "\n");
      read(in);
    });
  };
  const auto number = [](InputFile& in) { in.number("Key", Range::positive()); };
  const auto whole = [](InputFile& in) { in.integer("Key", Range::between(0, 1e12)); };
  EXPECT_EQ(with("abc ! Key", number), "dir/x.IN:2: Key: found 'abc', expected a number above 0");
  EXPECT_THAT(with("1.0.0 ! Key", number), HasSubstr("found '1.0.0'"));
  EXPECT_THAT(with("nan ! Key", number), HasSubstr("found 'nan'"));
  EXPECT_THAT(with("inf ! Key", number), HasSubstr("found 'inf'"));
  EXPECT_THAT(with("0x10 ! Key", number), HasSubstr("found '0x10'"));
  EXPECT_THAT(with("0 ! Key", number), HasSubstr("found 0, expected a number above 0"));
  EXPECT_THAT(with("1 2 ! Key", number), HasSubstr("found 2 values, expected one"));
  EXPECT_THAT(with("2.5 ! Key", whole), HasSubstr("found 2.5, expected a whole number"));
  EXPECT_THAT(with("1e11 ! Key", whole), HasSubstr("expected a whole number"));
  EXPECT_THAT(with("maybe ! Key", [](InputFile& in) { in.flag("Key"); }),
              HasSubstr("found 'maybe', expected true or false"));
  EXPECT_THAT(with("fist ! Key",
                   [](InputFile& in) {
                     in.choice("Key", {"first", "last"});
                   }),
              HasSubstr("found 'fist', expected one of first, last (did you mean 'first'?)"));
  EXPECT_THAT(with("1 2 3 ! Key", [](InputFile& in) { in.numbers("Key", 4, "NumberOfBeams"); }),
              HasSubstr("found 3 values, expected 4 as NumberOfBeams says"));
  EXPECT_THAT(with("1 ! Kay", number),
              HasSubstr("dir/x.IN: Key: missing, expected a line 'value ! Key - ...' (is 'Kay'"));
  EXPECT_THAT(with("1 ! Key", [](InputFile& in) { in.fail("Key", "wrong"); }),
              HasSubstr("dir/x.IN:2: Key: wrong"));
}

TEST(InputFile, LinesThatAreNone) {
  const auto parse = [](const std::string& text) { return refusal([&] { of(text); }); };
  EXPECT_THAT(parse("\n5\n"), HasSubstr("dir/x.IN:2: found '5', expected 'value ! Key"));
  EXPECT_THAT(parse("5 !\n"), HasSubstr("dir/x.IN:1: "));
  EXPECT_THAT(parse("\"open ! Key\n"), HasSubstr("dir/x.IN:1: a quote is not closed"));
  EXPECT_THAT(parse("1 ! A\n2 ! b\n3 ! a\n"),
              HasSubstr("dir/x.IN:3: a: stands twice, first in line 1"));
}

TEST(InputFile, UnknownKeysAreRefused) {
  InputFile in = of("1 ! Known\n2 ! Unknow\n");
  in.number("Known");
  in.has("Unknown");
  EXPECT_EQ(refusal([&] { in.finish(); }),
            "dir/x.IN:2: Unknow: unknown key (did you mean 'Unknown'?)");
}

TEST(InputFile, WhereAndResolve) {
  const InputFile in = of("\n1 ! A\n");
  EXPECT_EQ(in.where("a"), "dir/x.IN:2: A");
  EXPECT_EQ(in.where("B"), "dir/x.IN: B");
  EXPECT_EQ(in.resolve("sub/y"), "dir/sub/y");
  EXPECT_EQ(in.resolve("/y"), "/y");
}

TEST(InputFile, FilesThatCannotBeRead) {
  const test::TempFolder folder;
  const auto load = [](const std::string& f) { return refusal([&] { InputFile::load(f); }); };
  EXPECT_THAT(load(folder.file("no.IN")), HasSubstr("no such file"));
  EXPECT_THAT(load(folder.path().string()), HasSubstr("is a folder"));
  EXPECT_EQ(load(folder.write("a.IN", "")), "accepted");
}

}  // namespace
}  // namespace lac
