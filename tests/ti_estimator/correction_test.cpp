// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/correction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/lidar_block.hpp"
#include "core/units.hpp"

namespace lac {
namespace {

/// The lidar of S20, Table 1.
Vec3 beam(double azimuth_sign = 1.0, double elevation_sign = 1.0) {
  return beam_direction(rad_from_deg(15.0 * azimuth_sign), rad_from_deg(12.5 * elevation_sign));
}

CorrectionParams params(double averaging_time_s = 600.0) {
  CorrectionParams p;
  p.averaging_time_s = averaging_time_s;
  return p;
}

/// Trapezoid over log f: brute force, good to about 1e-8 here.
double integral_over_log_f(double from_hz, double to_hz, const std::function<double(double)>& s) {
  const int n = 40000;
  const double step = std::log(to_hz / from_hz) / n;
  double sum = 0.0;
  for (int i = 0; i <= n; ++i) {
    const double f = from_hz * std::exp(step * i);
    sum += (i == 0 || i == n ? 0.5 : 1.0) * f * s(f);
  }
  return sum * step;
}

// A beam along the wind has no offset across it: the Gaussian filter of u alone.
TEST(Correction, AlignedBeamIsAGaussianFilter) {
  const CorrectionParams p = params();
  const double s = 30.0 / std::sqrt(8.0 * std::log(2.0));
  for (const double speed : {5.0, 16.0, 25.0}) {
    const double expected = integral_over_log_f(1.0 / 600.0, 1.0, [&](double f) {
      const double phase = 2.0 * kPi * f / speed * s;
      return p.model.u.spectrum(f, speed) * std::exp(-phase * phase);
    });
    EXPECT_NEAR(Correction(p).los_variance({1.0, 0.0, 0.0}, speed) / expected, 1.0, 1e-7);
  }
}

// A volume without extent is a point: all three components, closed form.
TEST(Correction, PointVolumeIsTheClosedForm) {
  CorrectionParams p = params();
  p.pulse_width_m = 0.0;
  const Vec3 n = beam();
  const double expected = n.x * n.x * p.model.u.variance(1.0 / 600.0, 1.0, 16.0) +
                          n.y * n.y * p.model.v.variance(1.0 / 600.0, 1.0, 16.0) +
                          n.z * n.z * p.model.w.variance(1.0 / 600.0, 1.0, 16.0);
  EXPECT_NEAR(Correction(p).los_variance(n, 16.0) / expected, 1.0, 1e-9);
}

// The full model against the double integral over the volume and SciPy's quadrature, computed by
// python/check_c_ti.py.
TEST(Correction, IndependentFigures) {
  const Correction t600(params(600.0)), t180(params(180.0));
  EXPECT_NEAR(t600.volume_response(beam(), 0.1, 16.0), 0.61813690, 1e-8);
  EXPECT_NEAR(t600.c_ti(beam(), 16.0, 0.0), 1.16458009, 2e-8);
  EXPECT_NEAR(t180.c_ti(beam(), 16.0, rad_from_deg(10.0)), 1.17142558, 2e-8);
  EXPECT_NEAR(t180.c_ti(beam(), 6.0, rad_from_deg(-20.0)), 1.36316709, 2e-8);
}

// The wider the volume, the more is averaged away.
TEST(Correction, RisesWithTheVolume) {
  double before = 0.0;
  for (const double width_m : {0.0, 10.0, 20.0, 30.0, 45.0, 60.0}) {
    CorrectionParams p = params();
    p.pulse_width_m = width_m;
    const double c = Correction(p).c_ti(beam(), 16.0, 0.0);
    EXPECT_GT(c, before) << width_m;
    before = c;
  }
}

// The slower the wind, the longer the volume lasts; the shorter T, the more of what is left is
// averaged away.
TEST(Correction, FallsWithWindSpeedAndAveragingTime) {
  EXPECT_GT(Correction(params(600.0)).c_ti(beam(), 8.0, 0.0),
            Correction(params(600.0)).c_ti(beam(), 20.0, 0.0));
  EXPECT_GT(Correction(params(180.0)).c_ti(beam(), 16.0, 0.0),
            Correction(params(600.0)).c_ti(beam(), 16.0, 0.0));
}

// Four symmetric beams are equal without misalignment. With it left and right move apart, up and
// down stay equal, and turning the wind the other way exchanges left and right.
TEST(Correction, YawErrorPartsLeftFromRight) {
  const Correction c(params());
  const double straight = c.c_ti(beam(), 16.0, 0.0), yaw = rad_from_deg(12.0);
  EXPECT_DOUBLE_EQ(c.c_ti(beam(-1, 1), 16.0, 0.0), straight);
  EXPECT_DOUBLE_EQ(c.c_ti(beam(-1, -1), 16.0, 0.0), straight);
  const double left = c.c_ti(beam(1, 1), 16.0, yaw), right = c.c_ti(beam(-1, 1), 16.0, yaw);
  EXPECT_GT(right, left * 1.05);  // 27 deg off the wind against 3 deg
  EXPECT_DOUBLE_EQ(c.c_ti(beam(1, -1), 16.0, yaw), left);
  EXPECT_DOUBLE_EQ(c.c_ti(beam(-1, 1), 16.0, -yaw), left);
}

// The factor does not depend on the level of turbulence.
TEST(Correction, SameForEveryTurbulenceLevel) {
  CorrectionParams strong = params();
  strong.model = iec_kaimal(3.7, 90.0);
  EXPECT_NEAR(Correction(strong).c_ti(beam(), 16.0, 0.1),
              Correction(params()).c_ti(beam(), 16.0, 0.1), 1e-12);
}

// Independent lateral components leave u alone: c_TI = sqrt(var u / (n_x^2 int S_u H^2)).
TEST(Correction, IndependentLateralComponentsLeaveU) {
  CorrectionParams p = params();
  p.lateral_coherence = LateralCoherence::Independent;
  const Correction independent(p);
  const Vec3 n = beam();
  const double u_part = integral_over_log_f(1.0 / 600.0, 1.0, [&](double f) {
    return n.x * n.x * p.model.u.spectrum(f, 16.0) * independent.volume_response(n, f, 16.0);
  });
  EXPECT_NEAR(independent.los_variance(n, 16.0) / u_part, 1.0, 1e-7);
  EXPECT_GT(independent.c_ti(n, 16.0, 0.0), Correction(params()).c_ti(n, 16.0, 0.0));
}

// The phase model: a Gaussian filter along the beam's projection, v and w included.
TEST(Correction, PhaseModel) {
  CorrectionParams p = params();
  p.volume_model = VolumeModel::Phase;
  const Vec3 n = beam();
  const double phase = 2.0 * kPi * 0.1 / 16.0 * n.x * 30.0 / std::sqrt(8.0 * std::log(2.0));
  EXPECT_NEAR(Correction(p).volume_response(n, 0.1, 16.0), std::exp(-phase * phase), 1e-14);
}

// Three points: the double sum written out. The models are in rising order of what they average
// away, for S20's beams and T = 600 s (methods section 6).
TEST(Correction, ThreePointModel) {
  CorrectionParams p = params();
  p.volume_model = VolumeModel::ThreePoint;
  const Vec3 n = beam();
  const double k = 2.0 * kPi * 0.1 / 16.0 * n.x;
  const double c = p.model.coherence_rate(0.1, 16.0) * std::hypot(n.y, n.z);
  const double weights[3] = {0.25, 0.5, 0.25}, places_m[3] = {-15.0, 0.0, 15.0};
  double expected = 0.0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double d = std::abs(places_m[i] - places_m[j]);
      expected += weights[i] * weights[j] * std::cos(k * d) * std::exp(-c * d);
    }
  }
  EXPECT_NEAR(Correction(p).volume_response(n, 0.1, 16.0), expected, 1e-14);
  CorrectionParams phase = params();
  phase.volume_model = VolumeModel::Phase;
  EXPECT_LT(Correction(phase).c_ti(n, 16.0, 0.0), Correction(params()).c_ti(n, 16.0, 0.0));
}

// With what is folded down the samples hold more, and there is less to correct.
TEST(Correction, Aliasing) {
  CorrectionParams p = params();
  p.aliasing = true;
  p.pulse_width_m = 0.0;
  const Vec3 n = beam();
  const double expected = n.x * n.x * p.model.u.variance(1.0 / 600.0, 10.0, 16.0) +
                          n.y * n.y * p.model.v.variance(1.0 / 600.0, 10.0, 16.0) +
                          n.z * n.z * p.model.w.variance(1.0 / 600.0, 10.0, 16.0);
  EXPECT_NEAR(Correction(p).los_variance(n, 16.0) / expected, 1.0, 1e-9);
  p.pulse_width_m = 30.0;
  EXPECT_LT(Correction(p).c_ti(n, 16.0, 0.0), Correction(params()).c_ti(n, 16.0, 0.0));
}

// What a window leaves of all frequencies, against brute force down to 1e-4/T.
TEST(Correction, OtherWindows) {
  for (const auto& [window, detrending] : {std::pair{Window::Sliding, Detrending::Linear},
                                           std::pair{Window::Exponential, Detrending::Mean}}) {
    CorrectionParams p = params();
    p.low_frequencies = LowFrequencies::Response;
    p.window = window;
    p.detrending = detrending;
    const double expected = integral_over_log_f(1e-4 / 600.0, 10.0, [&](double f) {
      return p.model.u.spectrum(f, 16.0) * window_response(f * 600.0, window, detrending);
    });
    EXPECT_NEAR(Correction(p).u_variance(16.0) / expected, 1.0, 2e-6);
  }
}

// The exact response of a window, 1 - sinc^2(f T), against brute force down to 1e-4/T.
TEST(Correction, WindowResponse) {
  CorrectionParams p = params();
  p.low_frequencies = LowFrequencies::Response;
  const auto weight = [](double f) {
    const double x = kPi * f * 600.0;
    return 1.0 - std::pow(std::sin(x) / x, 2);
  };
  const double expected = integral_over_log_f(
      1e-4 / 600.0, 10.0, [&](double f) { return p.model.u.spectrum(f, 16.0) * weight(f); });
  EXPECT_NEAR(Correction(p).u_variance(16.0) / expected, 1.0, 2e-6);
}

// Figures at the points of the table are those of the model; between them within 0.2 %.
TEST(CorrectionTable, FollowsTheModel) {
  const Correction model(params(180.0));
  const std::vector<double> speeds{10.0, 12.5, 15.0, 18.0};
  const double step = rad_from_deg(5.0);
  const CorrectionTable table(model, {beam(1, 1), beam(-1, 1)}, speeds, {-step, 0.0, step});
  const auto exact = [&](const Vec3& n, double speed, double yaw) {
    return model.c_ti(n, speed, yaw) * beam_in_wind(n, yaw).x;
  };
  for (const double yaw : {-step, 0.0, step}) {
    for (const double speed : speeds) {
      EXPECT_NEAR(table.at(1, table.find(speed, yaw)), exact(beam(-1, 1), speed, yaw), 1e-12);
    }
  }
  EXPECT_NEAR(table.at(0, table.find(16.4, 0.4 * step)) / exact(beam(1, 1), 16.4, 0.4 * step), 1.0,
              2e-3);
  EXPECT_NEAR(table.at(1, table.find(11.0, -0.5 * step)) / exact(beam(-1, 1), 11.0, -0.5 * step),
              1.0, 2e-3);
}

// Outside of its axes, and for what is no number, the table has nothing to say.
TEST(CorrectionTable, Covers) {
  const CorrectionTable table(Correction(params()), {beam()}, {4.0, 8.0}, {0.0});
  EXPECT_TRUE(table.covers(4.0, 0.0));
  EXPECT_TRUE(table.covers(8.0, 0.0));
  EXPECT_FALSE(table.covers(3.99, 0.0));
  EXPECT_FALSE(table.covers(8.01, 0.0));
  EXPECT_FALSE(table.covers(6.0, 0.01));
  EXPECT_FALSE(table.covers(std::nan(""), 0.0));
}

MannParams iec_of_length(double length_m) {
  MannParams p = iec_mann(90.0);
  p.length_m = length_m;
  return p;
}

/// S20's beam to the left, in the frame whose x is down-wind: 1 up, -1 down.
Vec3 s20_beam_I(double up) {
  const Vec3 n = beam_direction(rad_from_deg(15.0), rad_from_deg(12.5));
  return {-n.x, -n.y, up * n.z};
}

// Without shear the spectra of isotropic turbulence, closed forms; a point sees
// n_x^2 F11 + (n_y^2 + n_z^2) F22.
TEST(MannLos, Isotropic) {
  MannParams p = iec_of_length(40.0);
  p.gamma = 0.0;
  const MannLos point(p, 0.0, 100.0);
  const Vec3 n = s20_beam_I(1.0);
  for (const double k1 : {1e-5, 0.01, 0.1, 2.0}) {
    const double q = 1.0 / 1600.0 + k1 * k1;
    const double f11 = 9.0 / 55.0 * std::pow(q, -5.0 / 6.0);
    const double f22 = 3.0 / 110.0 * (3.0 / 1600.0 + 8.0 * k1 * k1) * std::pow(q, -11.0 / 6.0);
    EXPECT_NEAR(point.u().at(k1) / f11, 1.0, 1e-3) << k1;
    const double across = 1.0 - n.x * n.x;
    EXPECT_NEAR(point.los(n).at(k1) / (n.x * n.x * f11 + across * f22), 1.0, 1e-3) << k1;
  }
}

// python/check_c_ti.py: another quadrature of another tensor. IEC, W = 30 m.
TEST(MannLos, AgainstPython) {
  const MannLos los(iec_mann(90.0), 30.0 / std::sqrt(8.0 * std::log(2.0)), 100.0);
  EXPECT_NEAR(los.u().at(0.02) / 92.59486354, 1.0, 1e-3);
  EXPECT_NEAR(los.u().at(0.5) / 0.51866529, 1.0, 1e-3);
  EXPECT_NEAR(los.los(s20_beam_I(1.0)).at(0.02) / 89.69967337, 1.0, 1e-3);
  EXPECT_NEAR(los.los(s20_beam_I(-1.0)).at(0.02) / 66.0153054, 1.0, 1e-3);
  EXPECT_NEAR(los.los(s20_beam_I(1.0)).at(0.5) / 0.01956252, 1.0, 0.02);
  EXPECT_NEAR(los.los(s20_beam_I(-1.0)).at(0.5) / 0.02152967, 1.0, 0.02);
}

// python/check_c_ti.py: 16 m/s, T = 180 s, up to 1 Hz and 10 Hz. The covariance of u and w gives
// the beam that looks up more variance, so that it needs less of a correction.
TEST(Correction, Mann) {
  CorrectionParams p;
  p.spectra = Spectra::Mann;
  p.averaging_time_s = 180.0;
  const Vec3 up = beam_direction(rad_from_deg(15.0), rad_from_deg(12.5));
  const Vec3 down = beam_direction(rad_from_deg(15.0), rad_from_deg(-12.5));
  const Correction iec(p);
  EXPECT_NEAR(iec.c_ti(up, 16.0, 0.0), 1.10083, 1e-3);
  EXPECT_NEAR(iec.c_ti(down, 16.0, 0.0), 1.23172, 1e-3);
  p.mann = iec_of_length(61.0);
  const Correction longer(p);
  EXPECT_NEAR(longer.c_ti(up, 16.0, 0.0), 1.06161, 1e-3);
  EXPECT_NEAR(longer.c_ti(down, 16.0, 0.0), 1.20417, 1e-3);
}

// Unit sigma_u: all of the variance is there when nothing is cut off. Turning left and right beams
// by opposite yaw errors is the same.
TEST(Correction, MannLimits) {
  CorrectionParams p;
  p.spectra = Spectra::Mann;
  p.averaging_time_s = 1e6;
  p.max_frequency_hz = 1000.0;
  EXPECT_NEAR(Correction(p).u_variance(16.0), 1.0, 2e-3);
  const Correction c(CorrectionParams{.spectra = Spectra::Mann});
  const Vec3 left = beam_direction(0.2, 0.1), right = beam_direction(-0.2, 0.1);
  EXPECT_NEAR(c.c_ti(left, 12.0, 0.15), c.c_ti(right, 12.0, -0.15), 1e-9);
  const std::vector<double> several = c.c_ti(left, {8.0, 12.0}, 0.15);
  EXPECT_EQ(several[1], c.c_ti(left, 12.0, 0.15));
}

}  // namespace
}  // namespace lac
