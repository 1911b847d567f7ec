// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/design_case.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "sim_harness/wind/stability.hpp"

namespace lac::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;
using testing::ThrowsMessage;

const std::filesystem::path kFile =
    std::filesystem::path(LAC_SOURCE_DIR) / "config/design/nrel5mw.yaml";

DesignCase load(const std::vector<std::string>& overrides) {
  return load_design(kFile, overrides);
}

// The shipped file: rotor of the turbine, timing of the FFP file and of the lidar's scan.
TEST(DesignCase, GathersWhatTheFilesSay) {
  const DesignCase d = load({});
  EXPECT_DOUBLE_EQ(d.rotor_radius_m, 63.0);
  EXPECT_DOUBLE_EQ(d.hub_height_m, 90.0);
  EXPECT_THAT(d.speeds_mps, SizeIs(12));
  const MannParams& mann = std::get<MannParams>(d.turbulence);
  EXPECT_EQ(mann.length_m, 49.0);
  EXPECT_EQ(mann.evolution_s, 400.0);
  EXPECT_EQ(mann.lifetime, EddyLifetime::kGuo);
  EXPECT_EQ(d.timing.delay_frequency_hz, 0.08);
  EXPECT_EQ(d.timing.scan_time_s, 1.0);
  EXPECT_EQ(d.curves.scan_time_s, 0.0);
  EXPECT_EQ(d.output_folder, std::filesystem::path("results/nrel5mw"));
  EXPECT_THAT(describe_turbulence(d.turbulence),
              AllOf(HasSubstr("L 49 m"), HasSubstr("lifetime of Guo"), HasSubstr("400 s")));
}

// stability: iec is the model of the standard, both lifetimes can be had for each class.
TEST(DesignCase, KnowsEveryTurbulence) {
  const auto mann = [](const std::vector<std::string>& o) {
    return std::get<MannParams>(load(o).turbulence);
  };
  EXPECT_EQ(mann({"turbulence.stability=iec"}).gamma, 3.9);
  EXPECT_EQ(mann({"turbulence.stability=iec"}).length_m, 0.8 * 42.0);
  EXPECT_EQ(mann({"turbulence.stability=iec"}).lifetime, EddyLifetime::kMann);
  EXPECT_EQ(mann({"turbulence.eddy_lifetime=mann"}).lifetime, EddyLifetime::kMann);
  EXPECT_EQ(mann({"turbulence.stability=stable"}).low_slope, -0.8);
  EXPECT_TRUE(std::isinf(mann({"turbulence.evolution=no"}).evolution_s));
  const auto kaimal = [](std::vector<std::string> o) {
    o.push_back("turbulence.kind=kaimal");
    return std::get<KaimalTurbulence>(load(o).turbulence);
  };
  EXPECT_EQ(kaimal({}).lateral, LateralCoherence::kSameAsU);
  EXPECT_EQ(kaimal({"turbulence.lateral_coherence=independent"}).lateral,
            LateralCoherence::kIndependent);
  EXPECT_EQ(kaimal({"turbulence.stability=unstable"}).model.u.length_scale_m, 744.8);
  EXPECT_EQ(kaimal({"turbulence.stability=unstable"}).evolution.decay, 4.1);
  EXPECT_EQ(kaimal({"turbulence.evolution=no"}).evolution.decay, 0.0);
}

TEST(DesignCase, ReadsTheOptionsOfTheModel) {
  const DesignCase d =
      load({"yaw_error_deg=10", "scan_averaging=yes", "probe_volume=three_point",
            "feedforward.cutoff=closest_fit", "feedforward.lead_margin_s=0.2", "name=other"});
  EXPECT_DOUBLE_EQ(d.volumes.yaw_error_rad, rad_from_deg(10.0));
  EXPECT_EQ(d.curves.scan_time_s, 1.0);
  EXPECT_EQ(d.volumes.model, VolumeModel::kThreePoint);
  EXPECT_EQ(d.rule, CutoffRule::kClosestFit);
  EXPECT_EQ(d.timing.lead_margin_s, 0.2);
  EXPECT_EQ(d.output_folder, std::filesystem::path("results/other"));
}

TEST(DesignCase, NamesWhatIsWrong) {
  const auto fails = [](const std::string& override_, const std::string& what) {
    EXPECT_THAT([&] { load({override_}); }, ThrowsMessage<Error>(HasSubstr(what))) << override_;
  };
  fails("turbulence.evolution_decay=1", "evolution_decay");  // of the other model
  fails("wind_speeds_mps=[8, 6]", "wind_speeds_mps: expected speeds that rise");
  fails("quadrature_nodes=100", "quadrature_nodes: expected an odd number");
  fails("feedforward.template=missing.IN", "missing.IN");
  fails("feedforward.cutof=closest_fit", "cutof");
  fails("turbulence.kind=isotropic", "turbulence.kind");
  fails("turbulence.category=D", "turbulence.category");
  fails("feedback.damping=20", "feedback.damping");
  fails("feedback.template=missing.IN", "missing.IN");
  fails("feedforward.pitch_curve=given", "pitch_curve");
}

}  // namespace
}  // namespace lac::sim
