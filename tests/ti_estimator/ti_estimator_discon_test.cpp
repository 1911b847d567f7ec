// SPDX-License-Identifier: Apache-2.0
// The built library through its C entry, as the master calls it.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/discon_caller.hpp"
#include "support/temp_folder.hpp"
#include "ti_estimator/ti_estimator.hpp"

namespace lac {
namespace {

using test::DisconCaller;

const char* const kShipped = LAC_SOURCE_DIR "/config/nrel5mw/ti_estimator.IN";
constexpr int kStepsPerBeam = 20;

/// The lidar of the shipped input file in a wind of 16 m/s with a sine of 12 s on it.
class Host {
 public:
  explicit Host(const std::string& out_name = "test.SrvD", const std::string& input = kShipped)
      : caller("liblac_ti_estimator", input, kPrivateArraySize, out_name) {
    InputFile in = InputFile::load(input);
    params = TiEstimatorParams::read(in);
  }
  ~Host() { caller.call(-1); }

  int step() {
    const bool is_new = steps % kStepsPerBeam == 0;
    if (is_new) measure(static_cast<int>(steps / kStepsPerBeam % 4));
    write_native_lidar(caller.swap(), m, is_new && alive);
    return caller.call(steps++ == 0 ? 0 : 1);
  }
  /// Number of steps with a message.
  int run(int count) {
    int messages = 0;
    for (int i = 0; i < count; ++i) {
      const int fail = step();
      EXPECT_GE(fail, 0) << caller.message();
      if (fail != 0) last_message = caller.message();
      messages += fail != 0 ? 1 : 0;
    }
    return messages;
  }
  double get(Rec record) { return caller.swap().get(record); }

  DisconCaller caller;
  TiEstimatorParams params;
  LidarMeasurement m;
  long steps = 0;
  bool alive = true;
  double lie = 0.0;  // speed of gate 4 if not 0
  std::string last_message;

 private:
  void measure(int beam) {
    m.time_s = static_cast<double>(steps) * caller.time_step_s;
    m.beam_id = beam;
    m.beam_dir_L = params.beam_dir_L[static_cast<std::size_t>(beam)];
    m.gate_count = 10;
    const double u = 16.0 + 3.0 * std::sin(2.0 * kPi * m.time_s / 12.0);
    for (int g = 0; g < 10; ++g) {
      m.gates[static_cast<std::size_t>(g)] = {50.0 + 13.3 * g, u * m.beam_dir_L.x, true, -10.0};
    }
    if (lie != 0.0) m.gates[4].speed_mps = lie;
  }
};

std::string shipped_with_yaw() {
  std::ifstream in(kShipped);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::string off = "false                    ! UseYawError";
  return text.replace(text.find(off), off.size(), "true ! UseYawError");
}

constexpr int kWindowSteps = 180 * 80;

// The shipped input file runs; NaN and "not valid" until T, then the TI of the wind.
TEST(TiEstimatorLibrary, RecordsBeforeAndAfterT) {
  Host host;
  EXPECT_EQ(host.run(kWindowSteps), 0);
  EXPECT_TRUE(std::isnan(host.get(Rec::TurbulenceIntensity)));
  EXPECT_EQ(host.get(Rec::TurbulenceValid), 0.0);
  EXPECT_EQ(host.get(Rec::PowerLevel), 1.0);
  EXPECT_EQ(host.get(Rec::PowerLevelValid), 0.0);

  EXPECT_EQ(host.run(80 * 80), 0);
  const Vec3 n = host.params.beam_dir_L[0];
  const double expected = Correction(host.params.correction).c_ti(n, 16.0, 0.0) * n.x * 3.0 *
                          std::sqrt(0.5 * 180.0 / 179.0) / 16.0;
  EXPECT_NEAR(host.get(Rec::TurbulenceIntensity) / expected, 1.0, 2e-3);
  EXPECT_EQ(host.get(Rec::TurbulenceValid), 1.0);
  EXPECT_NEAR(host.get(Rec::PowerLevel), power_level_for(expected, 16.0, host.params.power_level),
              5e-3);
  EXPECT_EQ(host.get(Rec::PowerLevelValid), 1.0);
}

// Error values of the field with the valid flag up: not used, the other gates carry on.
TEST(TiEstimatorLibrary, ErrorValuesAreNotSamples) {
  Host honest;
  honest.run(kWindowSteps + 80);
  const double expected = honest.get(Rec::TurbulenceIntensity);
  for (const double lie : {std::nan(""), -99.0, 999.0}) {
    Host host("lie.SrvD");
    host.lie = lie;
    host.run(kWindowSteps + 80);
    EXPECT_EQ(host.get(Rec::TurbulenceValid), 1.0) << lie;
    EXPECT_NEAR(host.get(Rec::TurbulenceIntensity), expected, 1e-6) << lie;
  }
}

// A dead lidar: one message, no estimate, and a power level that walks back to 1.
TEST(TiEstimatorLibrary, DeadLidarIsToldOnce) {
  Host host;
  host.run(kWindowSteps + 80 * 80);
  EXPECT_NE(host.get(Rec::PowerLevel), 1.0);
  host.alive = false;
  EXPECT_EQ(host.run(kWindowSteps), 1);
  EXPECT_NE(host.last_message.find("turbulence intensity lost"), std::string::npos)
      << host.last_message;
  EXPECT_TRUE(std::isnan(host.get(Rec::TurbulenceIntensity)));
  EXPECT_EQ(host.get(Rec::TurbulenceValid), 0.0);
  EXPECT_EQ(host.get(Rec::PowerLevel), 1.0);
  EXPECT_EQ(host.get(Rec::PowerLevelValid), 0.0);
}

// Back at a stored state (-11, -10) the library repeats itself to the last bit.
TEST(TiEstimatorLibrary, StoreAndRestore) {
  Host host;
  host.run(kWindowSteps + 800);
  EXPECT_EQ(host.caller.call(-11), 0);
  const long stored = host.steps;
  std::vector<double> first, second;
  for (std::vector<double>* record : {&first, &second}) {
    host.steps = stored;
    for (int i = 0; i < 400; ++i) {
      host.step();
      record->push_back(host.get(Rec::TurbulenceIntensity));
      record->push_back(host.get(Rec::PowerLevel));
    }
    EXPECT_EQ(host.caller.call(-10), 0);
  }
  EXPECT_EQ(first, second);
  EXPECT_NE(first[1], first.back());  // the power level was on its way
}

// Records 27, 3771 with 3772, 3307 and 3315 with 3319 are read by those who ask for them; estimates
// nobody asks for are not written.
TEST(TiEstimatorLibrary, CompetitorsAndLdp) {
  const test::TempFolder folder;
  const std::string file =
      folder.write("ti.IN", shipped_with_yaw() +
                                "\ntrue ! EstimateUncorrected - x\ntrue ! EstimateAnemometer - x\n"
                                "true ! EstimateTurbine - x\n65 ! RotorRadius - x\n"
                                "anemometer ! PowerLevelSource - x\nldp ! MeanSpeedSource - x\n"
                                "ldp ! YawErrorSource - x\n");
  Host host("others.SrvD", file);
  const auto run = [&](int count) {
    int messages = 0;
    for (int i = 0; i < count; ++i) {
      const double u = 16.0 + 3.0 * std::sin(2.0 * kPi * 0.0125 * host.steps / 12.0);
      host.caller.swap().set(Rec::HubWindSpeed, u);
      host.caller.swap().set(Rec::TurbineRews, u);
      messages += host.run(1);
    }
    return messages;
  };
  host.caller.swap().set(Rec::LidarMeanSpeed, 16.0);
  EXPECT_EQ(run(kWindowSteps + 8000), 1);  // what never came is told
  EXPECT_NE(host.last_message.find("so far: ldp gives no mean"), std::string::npos)
      << host.last_message;
  EXPECT_EQ(host.get(Rec::TurbulenceValid), 0.0);  // LidarReconstruction is 0: no yaw error
  EXPECT_NEAR(host.get(Rec::TurbulenceAnemometer), 3.0 / 16.0 * std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(host.get(Rec::PowerLevel), 1.1, 1e-6);          // the anemometer drives it
  EXPECT_TRUE(std::isnan(host.get(Rec::TurbulenceTurbine)));  // TurbineRewsValid is 0

  host.caller.swap().set(Rec::LidarReconstruction, 1.0);
  host.caller.swap().set(Rec::LidarYawError, 0.1);
  host.caller.swap().set(Rec::TurbineRewsValid, 1.0);
  EXPECT_EQ(run(kWindowSteps + 8000), 0);
  EXPECT_EQ(host.get(Rec::TurbulenceValid), 1.0);
  EXPECT_GT(host.get(Rec::TurbulenceTurbine), host.get(Rec::TurbulenceAnemometer));
  EXPECT_LT(host.get(Rec::TurbulenceUncorrected), host.get(Rec::TurbulenceIntensity));

  host.caller.swap().set(Rec::LidarMeanSpeed, std::nan(""));
  EXPECT_EQ(run(800), 1);
  EXPECT_NE(host.last_message.find("ldp gives no mean wind speed"), std::string::npos)
      << host.last_message;

  Host plain;
  plain.run(kWindowSteps + 80);
  EXPECT_EQ(plain.get(Rec::TurbulenceAnemometer), 0.0);
}

// Called by a host directly there is no chain to write to: refused with what to do.
TEST(TiEstimatorLibrary, WithoutTheChainBlockItSaysWhatToDo) {
  DisconCaller caller("liblac_ti_estimator", kShipped, kExtendedArraySize);
  EXPECT_EQ(caller.call(0), -1);
  EXPECT_NE(caller.message().find("works behind the LAC wrapper"), std::string::npos);
}

}  // namespace
}  // namespace lac
