// SPDX-License-Identifier: Apache-2.0
#include "core/native_lidar.hpp"
#include "ldp/wind_reconstruction.hpp"

namespace lac {

WindModelParams WindModelParams::read(InputFile& in, bool sees_across) {
  WindModelParams p;
  p.model =
      static_cast<WindModel>(in.choice("WindModel", 0, {"u", "u_shear", "u_v", "u_v_w", "all"}));
  if (p.model == WindModel::U) return p;
  if (!sees_across) {
    in.fail("WindModel", "expected u with LidarLayout openfast: it gives u on points alone");
  }
  p.window_s = in.number("ReconstructionWindow", p.window_s, Range::between(1.0, 3600.0));
  p.largest_condition =
      in.number("LargestCondition", p.largest_condition, Range::between(2.0, 1e4));
  p.hub_height_m = in.number("HubHeight", Range::positive());
  p.rotor_radius_m = in.number("RotorRadius", Range::positive());
  p.average_if_refused = in.choice("WhenRefused", 0, {"invalid", "average"}) == 1;
  if (!in.has("GateWeights")) return p;
  p.gate_weights = in.numbers("GateWeights", Range::not_negative());
  double sum = 0.0;
  for (const double w : p.gate_weights) sum += w;
  if (p.gate_weights.size() > native_lidar::kMaxGates || !(sum > 0.0)) {
    in.fail("GateWeights", "expected one weight per gate, at most " +
                               std::to_string(native_lidar::kMaxGates) + ", not all of them 0");
  }
  return p;
}

}  // namespace lac
