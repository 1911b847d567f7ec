// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/config/yaml_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "core/error.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;

class YamlReaderTest : public ::testing::Test {
 protected:
  YamlReader read(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return YamlReader::load(folder_.write("case.yaml", text), overrides);
  }

  std::string error_of(const std::function<void()>& action) {
    return test::error_text([&] { action(); });
  }

  test::TempFolder folder_;
};

// Every kind of value; 20.000 is a whole number, yes and off are flags, words stay words.
TEST_F(YamlReaderTest, Values) {
  YamlReader in = read(
      "a: 1.5e-3\nb: 20.000\nc: yes\nd: off\ne: no\nf: [1, 2.5]\ng: {h: 7}\ni:\n  - {j: 1}\n"
      "  - {j: 2}\nk: sub/file.txt\n");
  EXPECT_EQ(in.number("a"), 1.5e-3);
  EXPECT_EQ(in.integer("b"), 20);
  EXPECT_TRUE(in.flag("c"));
  EXPECT_FALSE(in.flag("d"));
  EXPECT_EQ(in.text("e"), "no");
  EXPECT_THAT(in.numbers("f"), ElementsAre(1.0, 2.5));
  EXPECT_EQ(in.map("g").integer("h"), 7);
  EXPECT_EQ(in.maps("i")[1].integer("j"), 2);
  EXPECT_EQ(in.path("k"), folder_.path() / "sub/file.txt");
  in.finish();
}

// A key that is not there means the default, where one is given.
TEST_F(YamlReaderTest, Defaults) {
  YamlReader in = read("a: 1\n");
  EXPECT_EQ(in.number("a", 5.0, Range::any()), 1.0);
  EXPECT_EQ(in.number("b", 5.0, Range::any()), 5.0);
  EXPECT_EQ(in.integer("c", 6, Range::any()), 6);
  EXPECT_TRUE(in.flag("d", true));
  EXPECT_EQ(in.text("e", "x"), "x");
  EXPECT_EQ(in.choice("f", 1, {"p", "q"}), 1);
  in.finish();
}

// File, line, key, what was found, what was expected.
TEST_F(YamlReaderTest, WrongValues) {
  YamlReader in =
      read("x: 1\nspeed: fast\ncount: 2.5\nflag: maybe\nlist: 3\nkind: stedy\nmap: 4\n");
  const auto expect = [&](const std::function<void()>& action, const std::string& text) {
    EXPECT_THAT(error_of(action), EndsWith("case.yaml:" + text));
  };
  expect([&] { in.number("speed"); }, "2: speed: found 'fast', expected a number");
  expect([&] { in.number("count", Range::between(3, 5)); },
         "3: count: found 2.5, expected " + Range::between(3, 5).text());
  expect([&] { in.integer("count"); }, "3: count: found 2.5, expected a whole number");
  expect([&] { in.flag("flag"); }, "4: flag: found 'maybe', expected true or false");
  expect([&] { in.numbers("list"); }, "5: list: found '3', expected a list of numbers");
  expect(
      [&] {
        in.choice("kind", {"steady", "step", "eog"});
      },
      "6: kind: found 'stedy', expected steady, step or eog (did you mean 'steady'?)");
  expect([&] { in.map("map"); }, "7: map: found '4', expected lines 'key: value'");
}

// Mistyped keys: named from both sides, the missing one and the unknown one.
TEST_F(YamlReaderTest, MissingUnknownAndDoubleKeys) {
  YamlReader in = read("durations_s: 5\n");
  EXPECT_THAT(error_of([&] { in.number("duration_s"); }),
              HasSubstr("duration_s: the key is missing; is 'durations_s' meant to be it?"));
  YamlReader other = read("a: 1\nruninn_s: 5\n");
  other.number("a");
  other.number("run_in_s", 0.0, Range::any());
  EXPECT_THAT(error_of([&] { other.finish(); }),
              EndsWith("case.yaml:2: runinn_s: unknown key (did you mean 'run_in_s'?)"));
  EXPECT_THAT(error_of([&] { read("a: 1\nb: 2\na: 3\n"); }),
              EndsWith("case.yaml:3: a: the key is there twice"));
}

// Keys of inner maps and list items are named in full.
TEST_F(YamlReaderTest, InnerKeysAreNamedInFull) {
  YamlReader in = read("wind:\n  speed: x\nlist:\n  - {a: 1}\n  - {b: 1}\n");
  EXPECT_THAT(error_of([&] { in.map("wind").number("speed"); }),
              EndsWith(":2: wind.speed: found 'x', expected a number"));
  EXPECT_THAT(error_of([&] { in.maps("list")[1].number("a"); }),
              EndsWith(":5: list.1.a: the key is missing; is 'b' meant to be it?"));
}

TEST_F(YamlReaderTest, UnreadableFiles) {
  EXPECT_THAT(error_of([&] { YamlReader::load(folder_.file("none.yaml")); }),
              EndsWith("none.yaml: cannot be read: no such file; expected a YAML file"));
  EXPECT_THAT(error_of([&] { YamlReader::load(folder_.path()); }),
              EndsWith(": is a folder, expected a YAML file"));
  EXPECT_THAT(error_of([&] { read("a: 1\n---\na: 2\n"); }),
              EndsWith("case.yaml: found 2 YAML documents (lines '---'), expected one"));
  EXPECT_THAT(error_of([&] { read("a: [1, 2\nb: 3\n"); }), HasSubstr("not valid YAML"));
  EXPECT_THAT(error_of([&] { read(""); }),
              EndsWith("case.yaml:1: found nothing, expected lines 'key: value'"));
}

// A file that is named must be there, and the place that names it is told.
TEST_F(YamlReaderTest, ExistingFile) {
  folder_.write("there.txt", "");
  YamlReader in = read("a: there.txt\nb: gone.txt\nc: .\n");
  EXPECT_EQ(in.existing_file("a"), folder_.path() / "there.txt");
  EXPECT_THAT(
      error_of([&] { in.existing_file("b"); }),
      EndsWith("case.yaml:2: b: " + folder_.file("gone.txt") + " cannot be read: no such file"));
  EXPECT_THAT(error_of([&] { in.existing_file("c"); }), HasSubstr(":3: c: found the folder"));
}

// --set replaces values, adds keys, reaches into lists and makes inner maps.
TEST_F(YamlReaderTest, Overrides) {
  YamlReader in = read("a: 1\nlist:\n  - {b: 1}\n", {"a=2", "list.0.b=3", "m.n=4", "a=5"});
  EXPECT_EQ(in.number("a"), 5.0);
  EXPECT_EQ(in.maps("list")[0].number("b"), 3.0);
  EXPECT_EQ(in.map("m").number("n"), 4.0);
  in.finish();
}

// Errors in them say so instead of a line.
TEST_F(YamlReaderTest, WrongOverrides) {
  EXPECT_THAT(error_of([&] { read("a: 1\n", {"a"}); }), HasSubstr("--set a: expected key=value"));
  EXPECT_THAT(error_of([&] { read("a: 1\n", {"a.b=1"}); }),
              HasSubstr("--set a.b=1: there are no keys below a single value"));
  EXPECT_THAT(error_of([&] { read("a:\n  - 1\n", {"a.1=1"}); }),
              HasSubstr("'1' is no position in a list of 1"));
  EXPECT_THAT(error_of([&] { read("a: 1\n", {"a=[1"}); }), HasSubstr("not valid YAML"));
  YamlReader in = read("b: 0\na: 1\n", {"a=fast", "bb=2"});
  EXPECT_EQ(error_of([&] { in.number("a"); }), "--set a=fast: a: found 'fast', expected a number");
  in.number("b");
  EXPECT_EQ(error_of([&] { in.finish(); }), "--set bb=2: bb: unknown key (did you mean 'b'?)");
}

}  // namespace
}  // namespace lac::sim
