// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/flown_lidar_report.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <random>

#include "core/error.hpp"
#include "sim_harness/design/flown_rotor_speed.hpp"
#include "sim_harness/output/recording.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;
using testing::ThrowsMessage;

constexpr double kChainStep_s = 0.125, kStep_s = 0.0125, kLead_s = 4.0, kWindow_s = 1.0;
constexpr double kNoise = 0.5;  // of the lidar, standard deviation over that of the wind
constexpr int kRows = 4800;     // 600 s

/// The rotor meets white noise that stays for a row of the chain; the lidar says it lead less half
/// a window before, with noise of its own.
void write_run(const std::filesystem::path& folder, unsigned seed, double valid = 1.0,
               double said_lead_s = kLead_s) {
  std::filesystem::create_directories(folder);
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  const auto ahead =
      static_cast<std::size_t>(std::lround((kLead_s - 0.5 * kWindow_s) / kChainStep_s));
  std::vector<float> wind(kRows + ahead);
  for (float& v : wind) v = 10.0F + normal(random);
  Recording chain({{"LidarRews", "m/s"},
                   {"LidarRewsLead", "s"},
                   {"LidarScanWindow", "s"},
                   {"LidarRewsValid", "-"}},
                  0.0, kChainStep_s, kRows);
  Recording turbine({{"RtVAvgxh", "m/s"}, {"RotSpeed", "rpm"}}, 0.0, kStep_s, 10 * kRows);
  for (std::size_t i = 0; i < kRows; ++i) {
    const float row[] = {wind[i + ahead] + static_cast<float>(kNoise) * normal(random),
                         static_cast<float>(said_lead_s), static_cast<float>(kWindow_s),
                         static_cast<float>(valid)};
    chain.append(row);
    for (int j = 0; j < 10; ++j) {
      // Rows of the chain lie in the middle of ten steps of the turbine.
      const std::size_t n = (10 * i + static_cast<std::size_t>(j) + 5) / 10;
      const float fine[] = {wind[std::min<std::size_t>(n, kRows - 1)], 12.0F};
      turbine.append(fine);
    }
  }
  chain.write(folder / "chain.lac.outb");
  turbine.write(folder / "chain.outb");
}

/// A campaign of three runs at 10 m/s with the lidar that is asked for, and one of another.
FlownCampaign campaign(const test::TempFolder& folder, double valid = 1.0) {
  std::ofstream table(folder.path() / "results.csv");
  table << "case,status,reason,mean_speed_mps,lidar,seed,controller\n";
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const std::string name = "seed-" + std::to_string(seed);
    table << name << ",done,,10,two," << seed << ",chain\n";
    write_run(folder.path() / "cases" / name, seed, valid);
  }
  table << "other,failed,why,10,four,1,chain\n";
  return {folder.path() / "results.csv", {{"lidar", "two"}}, 60.0, 25.0, "design.yaml"};
}

// Coherence 1/(1 + n^2) of a lidar with noise, delay and lead as they were put in.
TEST(FlownLidar, GathersTheRunsOfACampaign) {
  const test::TempFolder folder;
  const std::vector<FlownLidar> flown = flown_lidar(campaign(folder));
  ASSERT_THAT(flown, SizeIs(1));
  EXPECT_EQ(flown[0].mean_speed_mps, 10.0);
  EXPECT_EQ(flown[0].runs, 3U);
  EXPECT_NEAR(flown[0].lead_s, kLead_s - 0.5 * kWindow_s, 1e-6);
  EXPECT_NEAR(flown[0].delay_s, kLead_s - 0.5 * kWindow_s, 0.02);
  double sum = 0.0;
  const std::vector<double>& coherence = flown[0].spectrum.coherence;
  for (const double c : coherence) sum += c;
  // 75 independent blocks: each value within about 0.06, their mean much closer.
  EXPECT_NEAR(sum / static_cast<double>(coherence.size()), 1.0 / (1.0 + kNoise * kNoise), 0.02);
}

// The model of exactly that is inside of 95 % of the bands; one that is 0.15 off is not.
TEST(FlownLidar, IsComparedWithAModel) {
  class Flat : public CorrelationModel {
   public:
    explicit Flat(double coherence) : coherence_(coherence) {}
    std::vector<RotorLidarSpectra> at(double, const std::vector<double>& v) const override {
      return std::vector<RotorLidarSpectra>(v.size(), {1.0, {1.0}, {std::sqrt(coherence_)}});
    }

   private:
    double coherence_;
  };
  const test::TempFolder folder;
  const std::vector<FlownLidar> flown = flown_lidar(campaign(folder));
  DesignCase design;
  design.timing.delay_frequency_hz = 0.0425;
  LidarVolumes lidar;
  lidar.planes.push_back({40.0, {}});
  const auto compared = [&](double coherence) {
    const CorrelationCurves curves(Flat(coherence), {10.0}, {.last_k1_radpm = 2.0});
    return compare_flown_lidar(design, lidar, curves, flown).front();
  };
  const LidarComparison right = compared(1.0 / (1.0 + kNoise * kNoise)), wrong = compared(0.65);
  EXPECT_GT(right.compared, 5);
  EXPECT_GE(right.inside, 0.85 * right.compared);
  EXPECT_LT(wrong.inside, 0.4 * wrong.compared);
  EXPECT_NEAR(right.expected_s, 40.0 / 10.0 - 0.5, 1e-12);
  EXPECT_NEAR(right.model_delay_s, right.expected_s, 0.011);  // S_RL is real: not late
  const CorrelationCurves elsewhere(Flat(0.5), {12.0}, {});
  EXPECT_THAT([&] { compare_flown_lidar(design, lidar, elsewhere, flown); },
              ThrowsMessage<Error>(HasSubstr("expected only speeds of wind_speeds_mps")));
}

// What would spoil the comparison without a word is refused.
TEST(FlownLidar, RefusesRunsThatDidNotEndWell) {
  const test::TempFolder folder;
  FlownCampaign c = campaign(folder);
  c.where = {{"lidar", "four"}};
  EXPECT_THAT([&] { flown_lidar(c); }, ThrowsMessage<Error>(HasSubstr("has not ended well")));
  c = campaign(folder, 0.0);
  EXPECT_THAT([&] { flown_lidar(c); }, ThrowsMessage<Error>(HasSubstr("not always valid")));
}

// A condition that no row meets is told with what there is, among the rows that the others leave.
TEST(FlownLidar, SaysWhichConditionLeavesNothing) {
  const test::TempFolder folder;
  FlownCampaign c = campaign(folder);
  c.where = {{"lidar", "three"}};
  EXPECT_THAT([&] { flown_lidar(c); },
              ThrowsMessage<Error>(AllOf(HasSubstr("design.yaml: flown_lidar.where: found "
                                                   "lidar=three, which leaves no row of "),
                                         HasSubstr("results.csv; expected one of four, two"))));
  c.where = {{"lidar", "two"}, {"case", "other"}};
  EXPECT_THAT([&] { flown_lidar(c); },
              ThrowsMessage<Error>(HasSubstr("expected one of seed-1, seed-2, seed-3")));
  folder.write("results.csv", "case,status,mean_speed_mps,controller\n");
  c.where.clear();
  EXPECT_THAT([&] { flown_lidar(c); }, ThrowsMessage<Error>(HasSubstr("has no row")));
}

// Leads that no lidar has, and runs too short for lead, block or run-in: told with their file.
TEST(FlownLidar, NamesTheRunThatIsTooShort) {
  const test::TempFolder folder;
  FlownCampaign c = campaign(folder);
  const auto problem = [&](double lead_s) {
    write_run(folder.path() / "cases/seed-2", 2, 1.0, lead_s);
    return test::error_text([&] { flown_lidar(c); });
  };
  const auto of_run = HasSubstr("seed-2");
  EXPECT_THAT(problem(-2.0), AllOf(of_run, HasSubstr("is -2.5 s, expected 0 or more")));
  EXPECT_THAT(problem(NAN), AllOf(of_run, HasSubstr("expected 0 or more")));
  EXPECT_THAT(problem(5000.0), AllOf(of_run, HasSubstr("540 s are left behind the run-in")));
  c.block_s = 541.0;
  EXPECT_THAT(problem(kLead_s), HasSubstr("a block of 541 s (flown_lidar.block_s)"));
  c.block_s = 25.0, c.run_in_s = 590.0;
  EXPECT_THAT(problem(kLead_s), HasSubstr("10 s are left behind the run-in"));
  c.run_in_s = 1000.0;
  EXPECT_THAT(problem(kLead_s), HasSubstr("flown_lidar.run_in_s"));
}

// A constant rotor speed has no spectrum; files of different lengths are refused.
TEST(FlownRotorSpeed, AveragesItsRuns) {
  const test::TempFolder folder;
  write_run(folder.path(), 1);
  const Spectrum s = flown_rotor_speed({folder.path() / "chain.outb"}, 60.0);
  EXPECT_THAT(s.density, testing::Each(testing::Lt(1e-9)));
  EXPECT_THAT([&] { flown_rotor_speed({folder.path() / "chain.lac.outb"}, 60.0); },
              ThrowsMessage<Error>(HasSubstr("RotSpeed")));
}

}  // namespace
}  // namespace lac::sim
