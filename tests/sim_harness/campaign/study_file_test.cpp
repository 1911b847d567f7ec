// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/study_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim_harness/campaign/study_folder.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;

class StudyFileTest : public ::testing::Test {
 protected:
  Study load(const std::string& lines) { return load_study(files_.study(lines)); }
  std::string error(const std::string& lines) {
    return test::error_text([&] { load(lines); });
  }
  std::vector<std::string> names(const StudyRange& range) {
    std::vector<std::string> all;
    for (const StudyChoice& c : range.choices) all.push_back(c.name);
    return all;
  }

  test::StudyFolder files_;
};

// The three forms of a range, with names, settings and lines.
TEST_F(StudyFileTest, Ranges) {
  const Study s = load(
      "ranges:\n"
      "  seed: [3, 1]\n"
      "  wind.speed_mps: {from: 12, to: 13, step: 0.25}\n"
      "  wind:\n"
      "    calm: {}\n"
      "    gust: {wind.kind: eog, wind.start_s: 5.0}\n");
  ASSERT_EQ(s.ranges.size(), 3U);
  EXPECT_THAT(names(s.ranges[0]), ElementsAre("3", "1"));
  EXPECT_EQ(s.ranges[0].choices[1].settings[0].text(), "seed=1");
  EXPECT_EQ(s.ranges[0].choices[1].settings[0].line, 3);
  EXPECT_THAT(names(s.ranges[1]), ElementsAre("12", "12.25", "12.5", "12.75", "13"));
  EXPECT_FALSE(s.ranges[1].named);
  EXPECT_TRUE(s.ranges[2].named);
  EXPECT_TRUE(s.ranges[2].choices[0].settings.empty());
  const StudyChoice& gust = s.ranges[2].choices[1];
  EXPECT_EQ(gust.name, "gust");
  EXPECT_EQ(gust.settings[0].text(), "wind.kind=eog");
  EXPECT_EQ(gust.settings[1].text(), "wind.start_s=5.0");
  EXPECT_EQ(gust.settings[1].line, 7);
}

// Lists and maps as values, on one line; words that need quotes keep them.
TEST_F(StudyFileTest, ValuesOnOneLine) {
  const Study s = load(
      "set:\n"
      "  controllers:\n"
      "    - name: one\n"
      "      input: 'a: b.in'\n"
      "  lidar.gates_m: [50.0, 60]\n"
      "ranges: {seed: [1]}\n");
  EXPECT_EQ(s.settings[0].value, "[{name: one, input: \"a: b.in\"}]");
  EXPECT_EQ(s.settings[1].value, "[50.0, 60]");
}

// Where things lie: the case counts from the study's folder, results from where the program runs.
TEST_F(StudyFileTest, Places) {
  const Study s = load("ranges: {seed: [1]}\n");
  EXPECT_EQ(s.name, "study");
  EXPECT_EQ(s.base_case, files_.folder.path("case.yaml"));
  EXPECT_EQ(s.folder, fs::path("results/study"));
  EXPECT_EQ(load("folder: there\nranges: {seed: [1]}\n").folder, files_.folder.path("there"));
  EXPECT_EQ(load("time_limit_s: 30\nranges: {seed: [1]}\n").time_limit_s, 30.0);
}

TEST_F(StudyFileTest, Exclusions) {
  const Study s = load(
      "ranges: {seed: [1, 2, 3], class: {a: {}, b: {}}}\n"
      "exclude:\n"
      "  - {seed: [1, 3.0], class: b}\n");
  ASSERT_EQ(s.exclusions.size(), 1U);
  EXPECT_EQ(s.exclusions[0].parts[0].range, 0U);
  EXPECT_THAT(s.exclusions[0].parts[0].choices, ElementsAre(0U, 2U));
  EXPECT_THAT(s.exclusions[0].parts[1].choices, ElementsAre(1U));
}

// Every fault with file, line and key, what was found and what is expected.
TEST_F(StudyFileTest, Faults) {
  const std::pair<const char*, const char*> faults[] = {
      {"rnages: {seed: [1]}\n", "ranges: the key is missing; is 'rnages' meant to be it?"},
      {"set: {seed: 1}\n", "ranges: the key is missing"},
      {"ranges: {seed: [1]}\nexcept: 1\n", "study.yaml:3: except: unknown key"},
      {"ranges: []\n", "study.yaml:2: ranges: found a list, expected lines 'key: value'"},
      {"ranges:\n  seed: []\n", ":3: ranges.seed: found an empty list, expected a list of values"},
      {"ranges:\n  seed: {}\n",
       ":3: ranges.seed: found an empty map, expected a list of values, {"},
      {"ranges:\n  seed: 5\n",
       ":3: ranges.seed: found '5', expected a list of values, {from: , to"},
      {"ranges:\n  seed: [1, 1.0]\n", ":3: ranges.seed: found '1.0' twice, expected different"},
      {"ranges:\n  seed: [1]\n  seed: [2]\n", ":4: ranges.seed: the key is there twice"},
      {"ranges:\n  a:\n    b: {seed: 1}\n    b: {seed: 2}\n",
       ":5: ranges.a.b: the key is there tw"},
      {"ranges:\n  lidar.file: [a/b.yaml]\n",
       ":3: ranges.lidar.file: found 'a/b.yaml', expected letters"},
      {"ranges:\n  lidar.gates_m: [[1, 2]]\n", ":3: ranges.lidar.gates_m: found a list or a map, "},
      {"ranges:\n  seed: {from: 1, to: 4, step: 2}\n", ":3: ranges.seed: found from 1 to 4 by 2, "},
      {"ranges:\n  seed: {from: 1, to: 3, step: -1}\n", "expected a whole number of steps"},
      {"ranges:\n  seed: {from: 1, to: 3, step: 0}\n", "expected a whole number of steps"},
      {"ranges:\n  seed: {from: 1, to: 3}\n", ":3: ranges.seed: expected all of from, to and step"},
      {"ranges:\n  seed: {from: 1, too: 3, step: 1}\n",
       ":3: ranges.seed.too: unknown key, expecte"},
      {"ranges:\n  seed: {from: one, to: 3, step: 1}\n",
       "ranges.seed.from: found 'one', expected a"},
      {"ranges:\n  a:\n    b: [1]\n", ":4: ranges.a.b: found a list, expected the keys it sets"},
      {"ranges: {seed: [1]}\nexclude: [{sed: 1}]\n",
       ":3: exclude.sed: this is no range of the stud"},
      {"ranges: {seed: [1]}\nexclude: [{seed: 2}]\n",
       ":3: exclude.seed: found '2', which is not in"},
      {"ranges: {seed: [1]}\nexclude: {seed: 1}\n", ":3: exclude: found a map, expected a list"},
      {"ranges: {seed: [1]}\ntime_limit_s: -1\n", ":3: time_limit_s: found -1, expected"},
  };
  for (const auto& [lines, text] : faults) {
    EXPECT_THAT(error(lines), HasSubstr(text)) << lines;
    EXPECT_THAT(error(lines), HasSubstr("study.yaml:")) << lines;
  }
  files_.folder.write("study.yaml", "case: none.yaml\nranges: {seed: [1]}\n");
  EXPECT_THAT(test::error_text([&] { load_study(files_.folder.path("study.yaml")); }),
              EndsWith("none.yaml cannot be read: no such file"));
}

}  // namespace
}  // namespace lac::sim
