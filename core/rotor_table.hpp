// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace lac {

/// Power and thrust coefficient of a rotor over tip-speed ratio and blade pitch, from a file in
/// ROSCO's layout (pitch vector in deg, TSR vector, blocks of power, thrust and torque
/// coefficient, each under its comment line; the torque block is optional and not used).
///
/// Between the points bilinear interpolation. Outside the table both arguments are clamped to its
/// edges; inside() tells. Not a number in gives not a number out. Immutable after loading; every
/// const method is free of allocation and may be called from several threads.
class RotorTable {
 public:
  struct Coefficients {
    double cp = 0.0;
    double ct = 0.0;
  };
  struct Optimum {
    double tsr = 0.0;
    double pitch_rad = 0.0;
    double cp = 0.0;
  };

  /// Throws Error naming file, line, what was found and what was expected: text for a number,
  /// sizes that do not match, a vector that does not rise, a block that is missing or twice.
  static RotorTable parse(std::string_view text, const std::string& file_name);
  static RotorTable load(const std::filesystem::path& path);

  /// Node values row by row, cp[i_tsr * pitch_rad.size() + i_pitch]. Throws Error when sizes do
  /// not match, a vector has fewer than two entries or does not rise.
  RotorTable(std::vector<double> tsr, std::vector<double> pitch_rad, const std::vector<double>& cp,
             const std::vector<double>& ct);

  Coefficients at(double tsr, double pitch_rad) const noexcept;
  double cp(double tsr, double pitch_rad) const noexcept { return at(tsr, pitch_rad).cp; }
  double ct(double tsr, double pitch_rad) const noexcept { return at(tsr, pitch_rad).ct; }

  /// Central differences over one table step to either side, one-sided at the edges (a smaller
  /// step would see the kinks of the bilinear surface).
  double dcp_dtsr(double tsr, double pitch_rad) const noexcept;
  double dcp_dpitch_per_rad(double tsr, double pitch_rad) const noexcept;

  bool inside(double tsr, double pitch_rad) const noexcept;

  /// Largest power coefficient with the pitch at `min_pitch_rad` or above. The tip-speed ratio is
  /// the vertex of the parabola through the best node and its two neighbours, cp its value there.
  Optimum optimum(double min_pitch_rad = -std::numeric_limits<double>::infinity()) const noexcept;

  const std::vector<double>& tsr() const noexcept { return tsr_.points; }
  const std::vector<double>& pitch_rad() const noexcept { return pitch_.points; }

 private:
  struct Place {
    std::size_t interval;
    double weight;  // 0 at the lower point, 1 at the upper
  };
  struct Axis {
    explicit Axis(std::vector<double> rising_points);
    Place locate(double value) const noexcept;
    double clamp(double value) const noexcept;
    double step(double value) const noexcept;

    std::vector<double> points;
    bool uniform;
    double points_per_unit;
  };

  Axis tsr_;
  Axis pitch_;
  std::vector<Coefficients> nodes_;
};

}  // namespace lac
