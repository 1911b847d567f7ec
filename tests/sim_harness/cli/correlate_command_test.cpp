// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/correlate_command.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "sim_harness/output/recording.hpp"
#include "sim_harness/tables/csv_table.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

/// Red wind at 4 Hz in one file; a load 9 s behind it, power and pitch at 20 Hz in another that
/// starts 10 s later. Above rated all the time.
class CorrelateCommandTest : public ::testing::Test {
 protected:
  CorrelateCommandTest() {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    std::vector<double> wind_mps;
    double x = 0.0;
    for (int i = 0; i < 4000; ++i) {
      x = 0.97 * x + std::sqrt(1.0 - 0.97 * 0.97) * normal(random);
      wind_mps.push_back(16.0 + 2.0 * x);
    }
    Recording lidar({{"Lidar50", "m/s"}, {"CNR", "dB"}}, 0.0, 0.25, 4000);
    for (int i = 0; i < 4000; ++i) {
      const float row[] = {static_cast<float>(i == 1000 ? 99.0 : wind_mps[i]),
                           i == 2000 ? -20.0F : -10.0F};
      lidar.append(row);
    }
    lidar.write(folder_.file("lidar.outb"));
    Recording turbine({{"TwrBsMyt", "kNm"}, {"GenPwr", "kW"}, {"BldPitch1", "deg"}}, 10.0, 0.05,
                      19000);
    for (int i = 0; i < 19000; ++i) {
      const auto seen = static_cast<std::size_t>((10.0 + 0.05 * i - 9.0) / 0.25 + 1e-6);
      const float row[] = {static_cast<float>(3000.0 * wind_mps[seen]), 5000.0F, 10.0F};
      turbine.append(row);
    }
    turbine.write(folder_.file("turbine.outb"));
    options_.input.files = {folder_.path("lidar.outb"), folder_.path("turbine.outb")};
    options_.input.winds = {"Lidar50"};
    options_.input.load = "TwrBsMyt";
    options_.input.wind_rule.max = 35.0;
    options_.input.wind_rule.fill_s = 1.0;
    options_.lags.max_s = 20.0;
    options_.ranges_m = {50.0};
  }
  std::string run() {
    std::ostringstream out;
    correlate_command(options_, out);
    return out.str();
  }
  test::TempFolder folder_;
  CorrelateOptions options_;
};

// Two files, two rates, two starts: one mode, the delay, every window with a correlation of one,
// what was filled, coherence.
TEST_F(CorrelateCommandTest, DelayAcrossFiles) {
  options_.csv = folder_.path("w.csv");
  options_.input.companion = "CNR";
  const std::string text = run();
  EXPECT_THAT(text, HasSubstr("Lidar50  above rated  all"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("below rated")));
  EXPECT_THAT(text, HasSubstr("1 outside the limits, 0 stuck; 2 gaps (2 samples) filled"));
  EXPECT_THAT(text, HasSubstr("1 missing for CNR"));
  EXPECT_THAT(text, HasSubstr("Lidar50, above rated: "));
  EXPECT_THAT(text, HasSubstr("does not fall through 0.4; decay 0"));
  const CsvTable t(options_.csv);
  ASSERT_GT(t.rows(), 20U);
  for (std::size_t i = 0; i < t.rows(); ++i) {
    EXPECT_NEAR(t.number(i, t.column("delay")), 9.0, 0.2) << i;
    EXPECT_GT(t.number(i, t.column("correlation")), 0.99) << i;
  }
}

// The spectra of wind and load differ by the square of their ratio, bands as well; the coherence is
// 1 where the wind has energy.
TEST_F(CorrelateCommandTest, Spectra) {
  options_.spectra = folder_.path("s.csv");
  run();
  const CsvTable t(options_.spectra);
  const auto at = [&](const char* name) { return t.number(0, t.column(name)); };
  EXPECT_EQ(at("frequency"), 3.0 / 75.0);
  for (const char* part : {"density", "low", "high"}) {
    const std::string name(part);
    EXPECT_NEAR(at(("load_" + name).c_str()) / at(("wind_" + name).c_str()), 9e6, 2e5) << part;
  }
  EXPECT_LT(at("wind_low"), at("wind_density"));
  EXPECT_GT(at("coherence_low"), 0.98);
}

// A generator torque taken to the rotor: ratio times it and inertia times what the rotor gains,
// 0.06 rpm/s from 500 s on. Other units are refused.
TEST_F(CorrelateCommandTest, TorqueAtTheRotor) {
  const auto write = [&](const char* unit) {
    Recording rotor({{"GenTq", unit}, {"RotSpeed", "rpm"}}, 10.0, 0.05, 19000);
    for (int i = 0; i < 19000; ++i) {
      const double t_s = 10.0 + 0.05 * i;
      const float row[] = {40.0F, static_cast<float>(10.0 + 0.06 * std::max(0.0, t_s - 500.0))};
      rotor.append(row);
    }
    rotor.write(folder_.file("rotor.outb"));
  };
  write("kNm");
  options_.input.files.push_back(folder_.path("rotor.outb"));
  options_.input.load = "GenTq";
  options_.input.torque = {4e7, 97.0, "RotSpeed"};
  const std::vector<double> load = read_correlated(options_.input).of_wind[0].load;
  ASSERT_EQ(load.size(), 3800U);
  EXPECT_DOUBLE_EQ(load[100], 97.0 * 40.0);
  EXPECT_NEAR(load[3000], 97.0 * 40.0 + 4e4 * 0.06 * 2.0 * std::acos(-1.0) / 60.0, 2.0);
  EXPECT_NEAR(load[3799], load[3000], 2.0);
  write("Nm");
  EXPECT_THAT(test::error_text([&] { read_correlated(options_.input); }),
              HasSubstr("'GenTq' is in [Nm], expected [kNm] with --inertia"));
}

// What does not fit together is said.
TEST_F(CorrelateCommandTest, Faults) {
  options_.ranges_m = {50.0, 110.0};
  EXPECT_THAT(test::error_text([&] { run(); }), HasSubstr("2 ranges for 1 winds"));
  options_.ranges_m.clear();
  options_.input.rate_hz = 3.0;
  EXPECT_THAT(test::error_text([&] { run(); }), HasSubstr("expected a whole number"));
  options_.input.rate_hz = 4.0;
  options_.input.wind_rule.max = 15.0;
  EXPECT_THAT(test::error_text([&] { run(); }), HasSubstr("'Lidar50' is available "));
  options_.input.winds = {"Lidar55"};
  EXPECT_THAT(test::error_text([&] { run(); }),
              HasSubstr("no file has a channel 'Lidar55' (did you mean 'Lidar50'?)"));
  options_.input.from_s = 5000.0;
  EXPECT_THAT(
      test::error_text([&] { run(); }),
      HasSubstr("--from 5000.00 s is beyond the common time of the files, 10.00 to 960.00 s"));
}

// Blocks without a frequency, delays the wrong way round, no window: said, not left empty.
TEST_F(CorrelateCommandTest, NothingToTell) {
  options_.block_s = 1.5;
  EXPECT_THAT(test::error_text([&] { run(); }),
              HasSubstr("--block 1.50 s is 6.0 samples at --rate 4.00 Hz, expected at least 7"));
  options_.block_s = 75.0;
  options_.lags.min_s = 40.0;
  EXPECT_THAT(test::error_text([&] { run(); }),
              HasSubstr("--min-delay 40.00 s is above --max-delay 20.00 s"));
  options_.lags.min_s = 0.0;
  options_.window.length_s = 1000.0;
  EXPECT_THAT(test::error_text([&] { run(); }), HasSubstr("no complete window: the series have "));
}

}  // namespace
}  // namespace lac::sim
