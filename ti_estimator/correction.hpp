// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/kaimal.hpp"
#include "core/vec3.hpp"
#include "ti_estimator/faddeeva.hpp"
#include "ti_estimator/mann_los.hpp"

namespace lac {

/// What connects v, and w, of different points inside a measurement volume (methods section 1).
enum class LateralCoherence {
  SameAsU,      // the coherence of u: what the frequency-domain correlation codes assume
  Independent,  // none: TurbSim's default; the volume then averages v and w away altogether
};

/// How the wind is averaged over a volume (methods section 6). W: full width at half maximum.
enum class VolumeModel {
  Full,        // Gaussian; points decorrelate along and across the wind
  Phase,       // Gaussian; only the offset along the wind counts: v and w are coherent as well
  ThreePoint,  // weights 1/4, 1/2, 1/4 at -W/2, 0, W/2, as coarse lidar simulators have them
};

/// Spectra of the turbulence.
enum class Spectra {
  Kaimal,  // components independent, exponential coherence within a volume
  Mann,    // the uniform-shear tensor: no model of coherence needed, covariances included
};

/// IEC 61400-1: length 0.8 Lambda_1 and anisotropy 3.9; sigma_u cancels out of c_TI.
MannParams iec_mann(double hub_height_m);

/// How slow fluctuations drop out of a standard deviation over T.
enum class LowFrequencies {
  Cutoff,    // nothing below 1/T (S20 eq. 6)
  Response,  // what the statistics over T really leave: window_response()
};

/// Statistics over the last T: all samples alike, or weighted with exp(-2 age / T), which has as
/// many independent samples.
enum class Window { Sliding, Exponential };
/// What is taken out of a series before its variance. Linear: sliding windows only.
enum class Detrending { Mean, Linear };

/// Share of the variance at f that is left by the statistics over T, p = f T and x = pi p:
///   sliding, mean    1 - (sin x / x)^2
///   sliding, linear  1 - (sin x / x)^2 - 3 ((sin x / x - cos x) / x)^2
///   exponential      1 - 1 / (1 + x^2)
double window_response(double periods, Window window, Detrending detrending);

struct CorrectionParams {
  Spectra spectra = Spectra::Kaimal;
  KaimalModel model = iec_kaimal(1.0, 90.0);  // sigma_u cancels out of c_TI
  MannParams mann = iec_mann(90.0);           // with Spectra::Mann; Gaussian volumes only
  double averaging_time_s = 600.0;            // T
  double scan_rate_hz = 1.0;                  // f_scan, measurements per volume and second
  /// False: nothing above f_scan is in the samples (S20 eq. 7). True: they hold the variance of all
  /// frequencies up to f_max, what is above half of f_scan folded.
  bool aliasing = false;
  double max_frequency_hz = 10.0;  // f_max of the point wind speed
  double pulse_width_m = 30.0;     // W, full width at half maximum
  LateralCoherence lateral_coherence = LateralCoherence::SameAsU;
  VolumeModel volume_model = VolumeModel::Full;
  LowFrequencies low_frequencies = LowFrequencies::Cutoff;
  Window window = Window::Sliding;
  Detrending detrending = Detrending::Mean;
};

/// c_TI = sigma_u / sigma_L of S20 eqs. 6-8 with the volume models of methods section 6.
///
/// S_los = sum over c = u, v, w of n_c^2 S_c(f) H^2(f), n the beam in the wind frame. Two points of
/// a volume decorrelate with their offset along the wind (phase, Taylor) and across it (exponential
/// coherence). Full: a Gaussian of standard deviation s = W / sqrt(8 ln 2) along the beam; the
/// difference of two points of it is Gaussian with s sqrt(2), and the integral over it is
///   H^2 = Re w( s (k n_x + i c n_t) ),  c = a sqrt((f/U)^2 + (0.12/L_c)^2),  k = 2 pi f / U,
/// w the Faddeeva function, n_t = sqrt(n_y^2 + n_z^2). Phase: c = 0, H^2 = exp(-(s k n_x)^2).
/// ThreePoint: the double sum over its points of cos(k n_x d) exp(-c n_t d), d their distance.
///
/// Mann: MannLos, in k1 = 2 pi f / U.
///
/// c_TI does not depend on the gate (Taylor: all gates of a beam see the same statistics) nor on
/// the turbulence level. Integrals over f: Gauss-Legendre, relative error below 1e-9.
class Correction {
 public:
  explicit Correction(const CorrectionParams& params);

  /// Variance of v_los between 1/T and f_scan (or f_max: aliasing), for unit sigma_u. `beam_W`:
  /// unit vector in the frame of the mean wind (x down-wind or up-wind alike).
  double los_variance(const Vec3& beam_W, double mean_speed_mps) const;
  /// Variance of u between 1/T and f_max, for unit sigma_u.
  double u_variance(double mean_speed_mps) const;
  /// Variance of the mean of u over the rotor disk between 1/T and f_max, for unit sigma_u, behind
  /// a low-pass of first order (-3 dB at the cut-off; infinity: none).
  double rews_variance(double mean_speed_mps, double rotor_radius_m, double cutoff_hz) const;
  /// `beam_L`: unit vector in frame L; `yaw_error_rad`: wind minus nacelle direction, about z.
  double c_ti(const Vec3& beam_L, double mean_speed_mps, double yaw_error_rad) const;
  /// The same at several speeds, of 0.5 m/s or more.
  std::vector<double> c_ti(const Vec3& beam_L, const std::vector<double>& mean_speeds_mps,
                           double yaw_error_rad) const;
  /// H^2, in 0 ... 1. Kaimal.
  double volume_response(const Vec3& beam_W, double frequency_hz, double mean_speed_mps) const;

 private:
  struct Node {
    double frequency_hz;
    double weight_hz;  // contains the window's response
  };
  std::vector<Node> nodes(double upper_hz) const;
  double kaimal_variance(const Vec3& beam_W, double mean_speed_mps) const;
  static double variance(const TabulatedSpectrum& spectrum, const std::vector<Node>& nodes,
                         double mean_speed_mps);
  double share_left(double frequency_hz, bool followed) const;

  CorrectionParams params_;
  double volume_std_m_;
  Faddeeva faddeeva_;
  std::vector<Node> lidar_nodes_;
  std::vector<Node> point_nodes_;
  std::optional<MannLos> mann_;
  TabulatedSpectrum mann_u_;
};

/// The beam as the mean wind sees it: its direction in the frame whose x-axis lies along the wind,
/// up to a turn by pi about z (methods section 6).
Vec3 beam_in_wind(const Vec3& beam_L, double yaw_error_rad);

/// c_TI |n_x| per beam over mean wind speed and yaw error: the factor for the standard deviation
/// of v_los/|n_x|. With the default axes of the TI estimator linear interpolation is good to 0.2 %.
class CorrectionTable {
 public:
  /// A place in the table, found once for all beams.
  struct Place {
    std::size_t speed = 0, yaw = 0;  // lower corner
    double speed_part = 0.0, yaw_part = 0.0;
  };

  /// Axes rise strictly, at least one value each.
  CorrectionTable(const Correction& correction, const std::vector<Vec3>& beams_L,
                  std::vector<double> speeds_mps, std::vector<double> yaw_errors_rad);

  bool covers(double mean_speed_mps, double yaw_error_rad) const noexcept;
  /// Precondition: covers().
  Place find(double mean_speed_mps, double yaw_error_rad) const noexcept;
  /// Bilinear.
  double at(std::size_t beam, const Place& place) const noexcept;

 private:
  std::size_t index(std::size_t beam, std::size_t speed, std::size_t yaw) const noexcept {
    return (beam * speeds_mps_.size() + speed) * yaw_errors_rad_.size() + yaw;
  }
  double corner(std::size_t beam, std::size_t speed, std::size_t yaw) const noexcept;

  std::vector<double> speeds_mps_;
  std::vector<double> yaw_errors_rad_;
  std::vector<double> values_;  // beams x speeds x yaw errors
};

}  // namespace lac
