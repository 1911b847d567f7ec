// SPDX-License-Identifier: Apache-2.0
// Keys, and what is refused before the first step.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/openfast_lidar_bench.hpp"

namespace lac {
namespace {

using Bench = test::OpenFastBench;
using test::kOpenFastStep_s;
using test::with_order;
using testing::HasSubstr;

// What the user must say and what not, with hints; the interval is optional.
TEST(OpenFastLidarStart, Keys) {
  const auto read = [](const std::string& text, OpenFastLidarParams* p = nullptr) {
    InputFile in = InputFile::parse("openfast ! LidarLayout\n" + text, "ldp.IN");
    return test::error_text([&] {
      const OpenFastLidarParams read_params = OpenFastLidarParams::read(in);
      if (p != nullptr) *p = read_params;
    });
  };
  const std::string order = "1 ! InterpolationOrder\n", rotor = "-7.5 ! RotorPositionX\n";
  OpenFastLidarParams p;
  EXPECT_EQ(read(order + rotor + "0.5 ! MeasurementInterval\n", &p), "no error");
  EXPECT_EQ(p.interpolation_order, 1);
  EXPECT_EQ(p.rotor_position_x_m, -7.5);
  EXPECT_EQ(p.measurement_interval_s, 0.5);
  EXPECT_EQ(p.interval_at, "ldp.IN:4: MeasurementInterval");
  EXPECT_EQ(read(order + rotor, &p), "no error");
  EXPECT_EQ(p.measurement_interval_s, 0.0);
  EXPECT_THAT(read(rotor), HasSubstr("InterpolationOrder: missing, expected InterpOrder of the"));
  EXPECT_THAT(read(order), HasSubstr("RotorPositionX: missing, expected x of the rotor centre"));
  EXPECT_THAT(read("3 ! InterpolationOrder\n" + rotor),
              HasSubstr("ldp.IN:2: InterpolationOrder: found 3, expected"));
  EXPECT_THAT(read(order + rotor + "0 ! MeasurementInterval\n"), HasSubstr("found 0"));
  EXPECT_THAT(read(order + rotor + "4 ! NumberOfBeams\n"),
              HasSubstr("ldp.IN:4: NumberOfBeams: not with LidarLayout openfast"));
}

// A focus without its minus sign is refused at start: nothing lies ahead of the rotor.
TEST(OpenFastLidarStart, NothingAheadIsRefused) {
  Bench bench(with_order(2));
  bench.host.x_m = {45.0, 75.0};
  EXPECT_THAT(bench.start_error(), HasSubstr("ldp.IN:3: RotorPositionX: no measured point is ahead "
                                             "of the rotor: found x = 45, 75 m"));
  bench.host.x_m = {std::nan("")};
  EXPECT_THAT(bench.start_error(), HasSubstr("found x = nan m"));
}

// Types 1 and 3 start; none, 2 and what is no type are refused with record, reason and what to do.
TEST(OpenFastLidarStart, SensorTypes) {
  for (const int type : {1, 3}) {
    Bench bench(with_order(2));
    bench.host.sensor_type = type;
    EXPECT_EQ(bench.start_error(), "no error");
    EXPECT_EQ(bench.notice.level(), 0);
    EXPECT_TRUE(bench.call());
    EXPECT_EQ(bench.m.gate_count, 5);
    EXPECT_TRUE(bench.m.gates[4].valid);
  }
  const auto refused = [](double type, const std::string& text) {
    Bench bench(with_order(2));
    bench.host.fill(bench.swap(), 0);
    bench.put(0, type);
    const std::string error =
        test::error_text([&] { bench.lidar.require(bench.swap(), kOpenFastStep_s, bench.notice); });
    EXPECT_THAT(error, HasSubstr("ldp.IN:1: LidarLayout: found record 2001 is ")) << type;
    EXPECT_THAT(error, HasSubstr(text)) << type;
  };
  refused(0.0, "set SensorType in the InflowWind file of OpenFAST 3.5 or later");
  refused(2.0, "at the ground below its focus and returns about half the wind speed");
  refused(4.0, "is 4, expected a sensor type");
  refused(std::nan(""), "is nan, expected a sensor type");
  refused(-1e20, "expected a sensor type");
}

// Counts that cannot be: more than five points, beams and gates at once, no number.
TEST(OpenFastLidarStart, PointCounts) {
  const double nan = std::nan("");
  const std::vector<std::pair<double, double>> counts = {{1, 6},   {2, 2},  {0, 5},   {nan, 5},
                                                         {1, nan}, {1, -3}, {1, 1e30}};
  for (const auto& [beams, gates] : counts) {
    Bench bench(with_order(2));
    bench.host.fill(bench.swap(), 0);
    bench.put(1, beams);
    bench.put(2, gates);
    EXPECT_THAT(
        test::error_text([&] { bench.lidar.require(bench.swap(), kOpenFastStep_s, bench.notice); }),
        HasSubstr("(gates), expected 1 and 1 to 5 or the reverse"))
        << beams << " " << gates;
  }
}

// Shares of the measurements that OpenFAST takes, as published for its condition on t/interval.
TEST(OpenFastLidarStart, SharesOfMeasurementsTaken) {
  for (const double step_s : {0.00625, 0.0125, 0.025, 0.05, 0.005, 0.01}) {
    EXPECT_EQ(share_of_measurements_taken(0.25, step_s), 1.0);
    EXPECT_EQ(share_of_measurements_taken(1.0, step_s), 1.0);
  }
  for (const double step_s : {0.00625, 0.0125, 0.025, 0.05}) {
    EXPECT_NEAR(share_of_measurements_taken(0.2, step_s), 0.938, 5e-4) << step_s;
    EXPECT_NEAR(share_of_measurements_taken(0.1, step_s), 0.937, 5e-4) << step_s;
    EXPECT_NEAR(share_of_measurements_taken(0.3, step_s), 0.427, 5e-4) << step_s;
  }
  for (const double step_s : {0.005, 0.01}) {
    EXPECT_NEAR(share_of_measurements_taken(0.2, step_s), 0.777, 5e-4) << step_s;
    EXPECT_NEAR(share_of_measurements_taken(0.05, step_s), 0.777, 5e-4) << step_s;
  }
}

// Such an interval is a warning at the start, one that is no multiple of the step an error.
TEST(OpenFastLidarStart, IntervalIsChecked) {
  Bench good(with_order(2)), skipping(with_order(2, 0.3)), off_grid(with_order(2, 0.252)),
      short_one(with_order(0, 0.005));
  EXPECT_EQ(good.start_error(), "no error");
  EXPECT_EQ(good.notice.level(), 0);
  EXPECT_EQ(skipping.start_error(), "no error");
  EXPECT_THAT(std::string(skipping.notice.text()),
              HasSubstr("ldp.IN:2: MeasurementInterval: with 0.3 s OpenFAST takes 43 %"));
  EXPECT_THAT(off_grid.start_error(), HasSubstr("ldp.IN:2: MeasurementInterval: found 0.252 s, "
                                                "expected a multiple of the time step, 0.00625 s"));
  EXPECT_THAT(short_one.start_error(), HasSubstr("expected a multiple"));
}

}  // namespace
}  // namespace lac
