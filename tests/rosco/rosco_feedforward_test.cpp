// SPDX-License-Identifier: Apache-2.0
// Lidar feedforward and power level for an unmodified ROSCO, through the bridge: the shipped chains
// of config/rosco, flown in the harness.
#include <gmock/gmock.h>

#include <array>
#include <iomanip>
#include <iostream>
#include <numeric>
#include <regex>

#include "closed_loop/case_flight.hpp"
#include "rosco/rosco_files.hpp"
#include "sim_harness/run/results.hpp"
#include "support/error_text.hpp"

namespace lac::test {
namespace {

using testing::HasSubstr;

/// The shipped chains with ROSCO's own inputs, prepared as docs/hosts/rosco.md says, in a folder
/// of their own.
struct RoscoChains {
  RoscoChains() {
    const std::string discon_in = std::filesystem::path(rosco.copy_input_to(folder)).filename();
    for (const char* way : {"tower_damper", "derating"}) {
      folder.write("DISCON_" + std::string(way) + ".IN",
                   folder.read(discon_in) + shipped(std::string(way) + ".lines"));
      adopt("bridge_" + std::string(way) + ".IN");
      adopt("wrapper_" + std::string(way) + ".IN");
    }
    adopt("bridge_added.IN");
    adopt("wrapper_added.IN");
    adopt("wrapper_rosco.IN");
    adopt("rating_over_wind.txt");
  }

  static std::string shipped(const std::string& name) {
    std::ifstream in(LAC_SOURCE_DIR "/config/rosco/" + name);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  /// Copies a shipped file; its paths stay good, those of ROSCO's inputs lead here.
  void adopt(const std::string& name) const {
    std::string text = shipped(name);
    const auto replace = [&](const std::string& what, const std::string& by) {
      text = std::regex_replace(text, std::regex(what), by);
    };
    replace("\\.\\./\\.\\./build/rosco/Examples/Test_Cases/NREL-5MW", folder.path().string());
    replace("\\.\\./\\.\\./build/rosco", rosco.root.string());
    replace("\\.\\./nrel5mw", LAC_SOURCE_DIR "/config/nrel5mw");
    folder.write(name, text);
  }
  /// A copy of one of these files with other text in it; its name.
  std::string variant(const std::string& file, const std::string& what,
                      const std::string& by) const {
    const std::string name = "variant_" + file;
    folder.write(name, std::regex_replace(folder.read(file), std::regex(what), by));
    return name;
  }
  sim::CaseController controller(const std::string& wrapper) const {
    sim::CaseController c;
    c.name = "flight";
    c.input_file = folder.file(wrapper);
    return c;
  }
  sim::CaseController rosco_alone() const {
    sim::CaseController c;
    c.name = "alone";
    c.input_file = folder.file("DISCON.IN");
    c.library = rosco.library.string();
    return c;
  }

  TempFolder folder;
  RoscoFiles rosco;
};

class RoscoFeedforward : public testing::Test {
 protected:
  void SetUp() override {
    const RoscoFiles rosco;
    if (!rosco.there()) {
      GTEST_SKIP() << rosco.library << " is not there: the rosco wheel was not downloaded";
    }
    chains = std::make_unique<RoscoChains>();
  }

  sim::CaseController way(const std::string& name) const {
    return chains->controller("wrapper_" + name + ".IN");
  }
  static CaseFlight wind(double duration_s) {
    const std::string time = std::to_string(duration_s);
    return CaseFlight("demo.yaml",
                      {"wind.period_s=" + time, "time.duration_s=" + time, "time.run_in_s=0"});
  }
  static void expect_same_bits(const sim::Recording& a, const sim::Recording& b) {
    ASSERT_EQ(a.rows(), b.rows());
    for (const TableChannel& channel : a.channels()) {
      EXPECT_EQ(a.column(channel.name), b.column(channel.name)) << channel.name;
    }
  }

  std::unique_ptr<RoscoChains> chains;
};

/// One figure of all seeds.
struct Sample {
  std::vector<double> values = {};
  double mean() const {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  }
  friend std::ostream& operator<<(std::ostream& out, const Sample& s) {
    const auto [low, high] = std::ranges::minmax(s.values);
    out << s.mean();
    return s.values.size() > 1 ? out << " (" << low << " to " << high << ")" : out;
  }
};

struct Seeds {
  Sample speed_std_rpm, del_MNm, power_kW, speed_max_rpm, pitch_rate_std_degps;

  void add(const sim::FlightFigures& f) {
    speed_std_rpm.values.push_back(f.rotor_speed_std_rpm);
    del_MNm.values.push_back(f.tower_base_del_MNm);
    power_kW.values.push_back(f.power_mean_kW);
    speed_max_rpm.values.push_back(f.rotor_speed_max_rpm);
    pitch_rate_std_degps.values.push_back(f.pitch_rate_std_degps);
  }
  void print(const std::string& name) const {
    std::cout << std::fixed << std::setprecision(4) << name << ": rotor speed std " << speed_std_rpm
              << " rpm, max " << std::setprecision(2) << speed_max_rpm << " rpm, tower DEL "
              << del_MNm << " MNm, pitch rate std " << std::setprecision(3) << pitch_rate_std_degps
              << " deg/s, power " << std::setprecision(1) << power_kW << " kW\n";
  }
};

/// ROSCO alone, through its tower damper, added: in the same winds. Warnings are failures.
std::array<Seeds, 3> fly_seeds(const RoscoChains& chains, int seeds,
                               std::vector<std::string> overrides = {}) {
  std::array<Seeds, 3> results;
  const std::array controllers = {chains.rosco_alone(),
                                  chains.controller("wrapper_tower_damper.IN"),
                                  chains.controller("wrapper_added.IN")};
  overrides.emplace_back();
  for (int seed = 1; seed <= seeds; ++seed) {
    overrides.back() = "seed=" + std::to_string(seed);
    const CaseFlight flight("demo.yaml", overrides);
    for (std::size_t i = 0; i < controllers.size(); ++i) {
      const Flight flown = flight.fly(controllers[i]);
      results[i].add(sim::flight_figures(flown.recording, flight.c.time.run_in_s));
      for (const Warning& w : flown.warnings) ADD_FAILURE() << w.time_s << " s: " << w.text;
    }
  }
  for (std::size_t i = 0; i < results.size(); ++i) {
    results[i].print(std::array{"ROSCO alone ", "tower_damper", "added       "}[i]);
  }
  return results;
}

// 18 m/s, class A, mean of six seeds: rotor speed standard deviation at least 20 % smaller, tower
// DEL not larger, mean power within 0.5 %, both ways.
TEST_F(RoscoFeedforward, SixSeeds) {
  const auto [alone, tower, added] = fly_seeds(*chains, kSanitized ? 1 : 6);
  for (const Seeds& way : {tower, added}) {
    EXPECT_LT(way.speed_std_rpm.mean(), 0.8 * alone.speed_std_rpm.mean());
    EXPECT_LE(way.del_MNm.mean(), alone.del_MNm.mean());
    EXPECT_NEAR(way.power_kW.mean(), alone.power_kW.mean(), 0.005 * alone.power_kW.mean());
  }
}

// Where the feedforward comes and goes (14 m/s) and where it has to do most (24 m/s) it is not
// worse than ROSCO alone; of the DEL of one seed more cannot be said than 3 %. Nothing winds up.
TEST_F(RoscoFeedforward, OtherWindSpeeds) {
  for (const std::string speed_mps : {"14", "24"}) {
    std::cout << speed_mps << " m/s\n";
    const auto [alone, tower, added] = fly_seeds(*chains, 1, {"wind.mean_speed_mps=" + speed_mps});
    for (const Seeds& way : {tower, added}) {
      EXPECT_LE(way.speed_std_rpm.mean(), alone.speed_std_rpm.mean());
      EXPECT_LE(way.speed_max_rpm.mean(), 1.001 * alone.speed_max_rpm.mean());
      EXPECT_LE(way.del_MNm.mean(), 1.03 * alone.del_MNm.mean());
    }
  }
}

// Steady wind: the lidar has nothing to tell, ROSCO settles where it does alone.
TEST_F(RoscoFeedforward, SteadyWind) {
  for (const char* speed : {"14", "18", "24"}) {
    const CaseFlight flight(
        "demo.yaml",
        {"wind={kind: steady, speed_mps: " + std::string(speed) + "}", "time.duration_s=150"});
    const sim::Recording alone = flight.fly(chains->rosco_alone()).recording;
    for (const char* name : {"tower_damper", "added"}) {
      const sim::Recording r = flight.fly(way(name)).recording;
      EXPECT_LT(largest_difference(r, alone, "BldPitchDem", 0, r.rows()), 1e-4) << name << speed;
    }
  }
}

// With the route none, or without a lidar, it is ROSCO called directly to the last bit, though its
// tower damper is on and the tower shakes.
TEST_F(RoscoFeedforward, WithoutLidarItIsRosco) {
  CaseFlight flight = wind(100.0);
  chains->folder.write("none.IN", "none ! FeedforwardRoute\n");
  const std::string none = chains->variant("wrapper_added.IN", "bridge_added.IN", "none.IN");
  const sim::Recording alone = flight.fly(chains->rosco_alone()).recording;
  expect_same_bits(flight.fly(chains->controller(none)).recording, alone);
  flight.c.lidar->fault = {.kind = sim::LidarFaultKind::kDead};
  for (const char* name : {"rosco", "tower_damper", "added"}) {
    expect_same_bits(flight.fly(way(name)).recording, alone);
  }
}

// A lidar that dies in mid-run: no step of the demand, and 60 s later the run is that of ROSCO
// alone. (What is left, 1e-5 deg, ROSCO's estimator and region switches blow up in a lull at 235 s,
// for a while.)
TEST_F(RoscoFeedforward, LidarDies) {
  CaseFlight flight = wind(300.0);
  flight.c.lidar->fault = {.kind = sim::LidarFaultKind::kDead, .start_s = 120.0};
  const sim::Recording alone = flight.fly(chains->rosco_alone()).recording;
  const auto largest_step_deg = [](const sim::Recording& r, double from_s, double to_s) {
    const auto demand_deg = r.column("BldPitchDem");
    double largest = 0.0;
    for (std::size_t i = r.first_row_from(from_s); i < r.first_row_from(to_s); ++i) {
      largest = std::max(largest, std::abs(demand_deg[i] - demand_deg[i - 1]));
    }
    return largest;
  };
  for (const char* name : {"tower_damper", "added"}) {
    const sim::Recording r = flight.fly(way(name)).recording;
    const std::size_t fault = r.first_row_from(120.0), later = r.first_row_from(180.0);
    const std::size_t last = r.first_row_from(270.0);
    EXPECT_GT(largest_difference(r, alone, "BldPitchDem", 0, fault), 0.1) << name;
    EXPECT_LT(largest_difference(r, alone, "BldPitchDem", later, r.rows()), 1e-2) << name;
    EXPECT_LT(largest_difference(r, alone, "BldPitchDem", last, r.rows()), 1e-4) << name;
    EXPECT_LT(largest_step_deg(r, 120.0, 150.0), 0.03) << name;
  }
}

// `added` in front of ROSCO has no effect, and it is told once.
TEST_F(RoscoFeedforward, WrongOrderIsTold) {
  const CaseFlight flight = wind(200.0);
  const std::string swapped = chains->variant(
      "wrapper_added.IN", "(\"rosco\".*! Secondary_)3\n(\"bridge\".*! Secondary_)4", "$023\n$014");
  const Flight flown = flight.fly(chains->controller(swapped));
  EXPECT_EQ(largest_difference(flown.recording, flight.fly(chains->rosco_alone()).recording,
                               "BldPitchDem", 0, flown.recording.rows()),
            0.0);
  ASSERT_EQ(flown.warnings.size(), 1U);
  EXPECT_THAT(flown.warnings[0].text, HasSubstr("this library stands last"));
}

// The shipped case names the shipped chains.
TEST_F(RoscoFeedforward, ShippedCase) {
  const sim::Case c = sim::load_case(LAC_SOURCE_DIR "/config/rosco/demo.yaml");
  std::vector<std::string> inputs;
  for (const sim::CaseController& one : c.controllers) {
    inputs.push_back(one.input_file.filename().string());
  }
  EXPECT_THAT(inputs, testing::ElementsAre("wrapper_rosco.IN", "wrapper_tower_damper.IN",
                                           "wrapper_added.IN"));
}

// An input file of ROSCO that was not prepared is refused with the line that has to change.
TEST_F(RoscoFeedforward, UnpreparedInputIsRefused) {
  chains->folder.write("DISCON_tower_damper.IN", chains->folder.read("DISCON.IN"));
  const CaseFlight flight = wind(10.0);
  EXPECT_THAT(
      error_text([&] { flight.fly(way("tower_damper")); }),
      testing::ContainsRegex("bridge_tower_damper.IN:[0-9]+: RoscoInput: .*"
                             "DISCON_tower_damper.IN:[0-9]+: TD_Mode: found 0, expected 1"));
}

// ROSCO's error text goes on behind the name of its input file. (A host that calls ROSCO directly
// and counts the terminator gets it cut there.)
TEST_F(RoscoFeedforward, ErrorTextIsWhole) {
  chains->folder.write("DISCON.IN", chains->folder.read("DISCON.IN") + "abc ! WE_RhoAir\n");
  const CaseFlight flight = wind(10.0);
  const std::string rest = "was not assigned valid REAL value on line #";
  EXPECT_THAT(error_text([&] { flight.fly(way("rosco")); }),
              testing::AllOf(HasSubstr("rosco (libdiscon.so): ROSCO:"), HasSubstr("DISCON.IN\"."),
                             HasSubstr(rest)));
}

// Power level 0.8 (the estimator's own limit, at a turbulence that would allow more): the power
// settles there, at rated speed.
TEST_F(RoscoFeedforward, PowerLevel) {
  std::ifstream in(LAC_SOURCE_DIR "/config/nrel5mw/ti_estimator.IN");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  chains->folder.write("ti_estimator.IN", text);
  chains->variant("ti_estimator.IN", "1\\.1( *! MaximumPowerLevel)", "0.8$1");
  const std::string wrapper = chains->variant("wrapper_derating.IN", "\"[^\"]*/ti_estimator.IN\"",
                                              "\"variant_ti_estimator.IN\"");
  const double duration_s = 450.0;
  const CaseFlight flight = wind(duration_s);
  const Flight flown = flight.fly(chains->controller(wrapper));
  for (const Warning& w : flown.warnings) ADD_FAILURE() << w.time_s << " s: " << w.text;
  const sim::FlightFigures early = sim::flight_figures(flown.recording, 0.0);
  const sim::FlightFigures late = sim::flight_figures(flown.recording, duration_s - 80.0);
  std::cout << "mean power of the last 80 s " << late.power_mean_kW << " kW, largest rotor speed "
            << early.rotor_speed_max_rpm << " rpm\n";
  EXPECT_NEAR(late.power_mean_kW, 4000.0, 20.0);
  EXPECT_LT(early.rotor_speed_max_rpm, 13.0);
}

}  // namespace
}  // namespace lac::test
