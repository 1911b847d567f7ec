// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/beam_extent.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/error.hpp"
#include "sim_harness/lidar/spinner_positions.hpp"

namespace lac::sim {
namespace {

constexpr double kTimeRounding_s = 1e-9;
constexpr double kEdgeRounding_m = 1e-6;
constexpr double kPlannedTravel_m = 3.0;  // of the tower top

/// How far a value is outside [low, high]; 0 inside.
double outside(double value, double low, double high) {
  return std::max({low - value, value - high, 0.0});
}

std::string named(std::size_t beam, std::size_t gate) {
  return "lidar: beam " + std::to_string(beam + 1) + ", gate " + std::to_string(gate + 1);
}

/// The points of a gate that lie nearest to the lidar and farthest from it.
struct GateEnds {
  double nearest_m;
  double farthest_m;
};

GateEnds ends_of(const BeamSamples& beam, const GateSamples& gate) {
  const auto first = beam.points_m.begin() + static_cast<std::ptrdiff_t>(gate.first_point);
  const auto last = first + static_cast<std::ptrdiff_t>(gate.weights.size());
  return {*std::min_element(first, last), *std::max_element(first, last)};
}

}  // namespace

BeamExtent::BeamExtent(const std::vector<BeamSamples>& beams, const Mounting& mounting,
                       const WindField& field)
    : beams_(beams), mounting_(mounting), field_(field), extent_(field.extent()) {
  for (const BeamSamples& beam : beams) {
    nearest_m_.push_back(beam.nearest_m());
    farthest_m_.push_back(beam.farthest_m());
  }
}

void BeamExtent::check_at_rest() const {
  for (const double azimuth_rad : looked_at_azimuths(mounting_)) {
    const LidarPose pose = mounting_.rest_pose(azimuth_rad);
    for (std::size_t b = 0; b < beams_.size(); ++b) {
      for (std::size_t g = 0; g < beams_[b].gates.size(); ++g) check_gate_at_rest(b, g, pose);
    }
  }
}

void BeamExtent::check_gate_at_rest(std::size_t b, std::size_t g, const LidarPose& pose) const {
  const BeamSamples& beam = beams_[b];
  const GateSamples& gate = beam.gates[g];
  const Vec3 dir_I = pose.R_IL * beam.dir_L;
  const auto place = [&](double range_m) { return pose.position_I_m + range_m * dir_I; };
  std::ostringstream text;
  const Vec3 centre = place(gate.range_m);
  const GateEnds ends = ends_of(beam, gate);
  const double lowest_m =
      std::min(place(ends.nearest_m).z, place(ends.farthest_m).z) - between_positions_m(b);
  if (centre.x >= 0.0) {
    text << " lies " << centre.x << " m behind the rotor plane, expected up-wind of it";
  } else if (ends.nearest_m < -kEdgeRounding_m) {
    text << ": its range weighting reaches " << -ends.nearest_m
         << " m behind the lidar, expected a gate farther away or a shorter one";
  } else if (lowest_m < 0.0) {
    text << " (with its range weighting) reaches " << -lowest_m << " m into the ground";
  } else {
    for (std::size_t i = 0; i < gate.weights.size(); ++i) {
      if (field_.holds(place(beam.points_m[gate.first_point + i]))) continue;
      text << ": the wind was not kept there, the field was thinned for another lidar";
      break;
    }
  }
  if (!text.str().empty()) throw Error(named(b, g) + text.str());
}

void BeamExtent::check_planned(std::size_t first_beam, std::size_t count, double time_s) const {
  for (const double azimuth_rad : looked_at_azimuths(mounting_)) {
    TurbineState at_rest;
    at_rest.azimuth_rad = azimuth_rad;
    const LidarPose pose = mounting_.pose(at_rest, time_s);
    for (std::size_t b = first_beam; b < first_beam + count; ++b) {
      check_beam(b, pose, time_s, {kPlannedTravel_m, between_positions_m(b)});
    }
  }
}

void BeamExtent::check_now(std::size_t b, const LidarPose& pose, double time_s,
                           double tower_x_m) const {
  check_beam(b, pose, time_s, {});
  const Vec3 dir_I = pose.R_IL * beams_[b].dir_L;
  for (const double range_m : beams_[b].points_m) {
    const Vec3 point_I_m = pose.position_I_m + range_m * dir_I;
    if (!field_.holds(point_I_m)) report_not_kept(b, point_I_m, range_m, time_s, tower_x_m);
  }
}

double BeamExtent::between_positions_m(std::size_t b) const {
  if (!mounting_.turns_with_rotor()) return 0.0;
  const LidarPose pose = mounting_.rest_pose();
  const Vec3 dir_I = pose.R_IL * beams_[b].dir_L;
  double radius_m = 0.0;
  for (const double range_m : {nearest_m_[b], farthest_m_[b]}) {
    const Vec3 p = pose.position_I_m + range_m * dir_I;
    radius_m = std::max(radius_m, std::hypot(p.y, p.z - mounting_.hub_height_m()));
  }
  return radius_m * (1.0 - std::cos(kPi / kSpinnerPositions));
}

void BeamExtent::check_beam(std::size_t b, const LidarPose& pose, double time_s,
                            Distance keep) const {
  const Vec3 dir_I = pose.R_IL * beams_[b].dir_L;
  for (const double range_m : {nearest_m_[b], farthest_m_[b]}) {
    if (is_inside(pose.position_I_m + range_m * dir_I, time_s, keep)) continue;
    report(b, pose, time_s, keep);
  }
}

bool BeamExtent::is_inside(const Vec3& p, double time_s, Distance keep) const {
  const double arrival_s = time_s - p.x / field_.mean_speed_mps();
  const double travel_s = keep.along_m / field_.mean_speed_mps();
  const double across_m = keep.across_m;
  return std::max({outside(p.y, extent_.y_min_m + across_m, extent_.y_max_m - across_m),
                   outside(p.z, extent_.z_min_m + across_m, extent_.z_max_m - across_m),
                   across_m - p.z}) <= kEdgeRounding_m &&
         std::max(arrival_s + travel_s - extent_.t_max_s, extent_.t_min_s - arrival_s + travel_s) <=
             kTimeRounding_s;
}

/// What is wrong with a place, or nothing.
std::string BeamExtent::fault_at(const Vec3& p, double time_s, Distance keep) const {
  const WindExtent& e = extent_;
  const double across_m = keep.across_m;
  const double y_m = outside(p.y, e.y_min_m + across_m, e.y_max_m - across_m);
  const double z_m = outside(p.z, e.z_min_m + across_m, e.z_max_m - across_m);
  const double travel_s = keep.along_m / field_.mean_speed_mps();
  const double arrival_s = time_s - p.x / field_.mean_speed_mps();
  std::ostringstream text;
  if (across_m - p.z > kEdgeRounding_m) {
    text << "reaches " << across_m - p.z << " m into the ground at t = " << time_s << " s";
    return text.str();
  }
  text << "leaves the wind field by ";
  if (y_m > kEdgeRounding_m) {
    text << y_m << " m sideways at t = " << time_s << " s; the field must be wider";
  } else if (z_m > kEdgeRounding_m) {
    text << z_m << " m in height at t = " << time_s << " s; the field must be higher";
  } else if (arrival_s + travel_s > e.t_max_s + kTimeRounding_s) {
    text << arrival_s + travel_s - e.t_max_s << " s at the end; the field must be longer";
  } else if (arrival_s - travel_s < e.t_min_s - kTimeRounding_s) {
    text << e.t_min_s - arrival_s + travel_s << " s at the start (t = " << time_s
         << " s): what is down-wind of the rotor then is not in it";
  } else {
    return {};
  }
  return text.str();
}

/// The box of the field is convex: if the ends of a beam are inside, so is all between them.
void BeamExtent::report(std::size_t b, const LidarPose& pose, double time_s, Distance keep) const {
  const Vec3 dir_I = pose.R_IL * beams_[b].dir_L;
  for (std::size_t g = 0; g < beams_[b].gates.size(); ++g) {
    const GateEnds ends = ends_of(beams_[b], beams_[b].gates[g]);
    for (const double range_m : {ends.nearest_m, ends.farthest_m}) {
      const std::string fault = fault_at(pose.position_I_m + range_m * dir_I, time_s, keep);
      if (!fault.empty()) throw Error(named(b, g) + " (with its range weighting) " + fault);
    }
  }
}

void BeamExtent::report_not_kept(std::size_t b, const Vec3& p, double range_m, double time_s,
                                 double tower_x_m) const {
  const auto& gates = beams_[b].gates;
  std::size_t g = 0;
  const auto sees = [&](std::size_t i) {
    return ends_of(beams_[b], gates[i]).farthest_m >= range_m;
  };
  while (g + 1 < gates.size() && !sees(g)) ++g;
  std::ostringstream text;
  text
      << " (with its range weighting) at t = " << time_s
      << " s: the wind was not kept at x = " << p.x << ", y = " << p.y << ", z = " << p.z
      << " m, the field was thinned to the surroundings of the lidar's beams; the tower top stands "
      << tower_x_m << " m off its place, lidar.tower_travel_m must allow for that";
  throw Error(named(b, g) + text.str());
}

}  // namespace lac::sim
