// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/filters.hpp"
#include "core/induction.hpp"
#include "core/input_file.hpp"
#include "core/lookup_table.hpp"
#include "core/vec3.hpp"

namespace lac {

struct InductionCorrectionParams {
  InductionModel model = InductionModel::kNone;
  LookupTable thrust;      // C_T over free wind speed
  double window_s = 60.0;  // mean wind speed that enters it
  bool slows_travel = false;
  double hub_height_m = 0.0;
  double rotor_radius_m = 0.0;

  /// Keys InductionModel and, only with one, InductionWindSpeed, InductionThrust, InductionWindow,
  /// InductionDelay, HubHeight, RotorRadius. Throws lac::Error.
  static InductionCorrectionParams read(InputFile& in);
};

/// Takes the induction zone out of lidar speeds (methods section 8, HM eq. 23). Wind that is free
/// of the rotor, (u, 0, 0), is at a gate
///
///   u (1 - a axial, a radial e_r),      a: of C_T at the slow mean of the free wind
///
/// so that a beam n sees  -n_x u c  with  c = 1 - a q,  q = axial - radial (n . e_r)/n_x. Both
/// come from the same functions that the simulated lidar uses. Lateral wind passes as it is.
///
/// q depends on the geometry alone. It is kept for each beam and gate until the gate has moved by
/// kMove of the radius; error of c below 0.005 a.
class InductionCorrection {
 public:
  struct Place {
    Vec3 from_hub_I_m;
    double unit = 0.0;  // q
    void visit(StateArchive& a) {
      a(from_hub_I_m.x), a(from_hub_I_m.y), a(from_hub_I_m.z), a(unit);
    }
  };
  struct State {
    std::vector<Place> places;  // beams x gates
    SlowMean free_speed;
    double factor = 0.0;  // a
    void visit(StateArchive& a) { a(places), a(free_speed), a(factor); }
  };

  static constexpr double kMove = 0.005;

  InductionCorrection() = default;
  explicit InductionCorrection(InductionCorrectionParams params) : params_(std::move(params)) {}
  bool active() const { return params_.model != InductionModel::kNone; }
  State initial_state(std::size_t places) const;

  /// Before the first mean: a from the wind as the lidar sees it.
  void start(double seen_mps, State& state) const noexcept;
  /// Mean free wind of one measurement, which stands for share_s.
  void add(double free_mps, double share_s, State& state) const noexcept;
  /// c, of the gate that has this number. Precondition: place < places of initial_state().
  double remaining(std::size_t place, const Vec3& beam_dir_I, const Vec3& from_hub_I_m,
                   State& state) const noexcept;
  /// The way through undisturbed wind that takes as long as the last `ahead_m` before the rotor on
  /// its axis: integral of ds/(1 - a (1 - s/sqrt(s^2 + R^2))). As it stands without InductionDelay.
  double travel_m(double ahead_m, const State& state) const noexcept;

  const InductionCorrectionParams& params() const { return params_; }

 private:
  double unit(const Vec3& beam_dir_I, const Vec3& from_hub_I_m) const noexcept;

  InductionCorrectionParams params_;
};

}  // namespace lac
