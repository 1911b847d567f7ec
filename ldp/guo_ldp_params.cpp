// SPDX-License-Identifier: Apache-2.0
#include "ldp/guo_ldp_params.hpp"

#include "core/lidar_block.hpp"

namespace lac {
namespace {

// Theirs hold 50, V3 100 without looking; a lidar that needs more than this is a mistake.
const Range kCount = Range::between(1, 1000);
// A beam further from the axis gives its wind speed with more than twenty times its error.
const Range kAngle_deg = Range::between(-87.0, 87.0);

GuoLdpParams::Form find_form(const GuoInputFile& file) {
  using Form = GuoLdpParams::Form;
  if (file.line_of("NumberOfModularLidars") > 0) return Form::V3;
  if (file.line_of("AngleToCenterline") > 0 || file.line_of("IndexGate") > 0) return Form::Task52;
  return file.line_of("MC_Mode") > 0 ? Form::V2 : Form::V1;
}

std::vector<Vec3> read_directions(InputFile& in, std::size_t beams) {
  const auto azimuth_deg = in.numbers("Lidar_Azimuth", beams, "NumberOfBeams", kAngle_deg);
  const auto elevation_deg = in.numbers("Lidar_Elevation", beams, "NumberOfBeams", kAngle_deg);
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < beams; ++i) {
    result.push_back(beam_direction(rad_from_deg(azimuth_deg[i]), rad_from_deg(elevation_deg[i])));
  }
  return result;
}

Vec3 at_angle(double angle_deg) {
  return beam_direction(0.0, rad_from_deg(angle_deg));
}

}  // namespace

GuoForm GuoLdpParams::form_of(const GuoInputFile& file) {
  const std::vector<std::string> extras{"LegacyTiming"};
  switch (find_form(file)) {
    case Form::V3:
      return {
          "LDP_v3", {"NumberOfModularLidars", "AngleToCenterline", "NumberOfMeasurements"}, extras};
    case Form::Task52:
      return {
          "LDP_v1 (v1.4, Task 52)", {"NumberOfBeams", "AngleToCenterline", "IndexGate"}, extras};
    case Form::V2:
      return {"LDP_v2", {"NumberOfBeams", "Lidar_Azimuth", "Lidar_Elevation", "MC_Mode"}, extras};
    case Form::V1:
      break;
  }
  return {"LDP_v1", {"NumberOfBeams", "Lidar_Azimuth", "Lidar_Elevation"}, extras};
}

GuoLdpParams GuoLdpParams::read(const GuoInputFile& file) {
  InputFile in = file.read(form_of(file));
  GuoLdpParams p;
  p.form = find_form(file);
  p.legacy_timing = in.flag("LegacyTiming", false);
  if (p.form == Form::V3) {
    const auto lidars = static_cast<std::size_t>(in.integer("NumberOfModularLidars", kCount));
    const auto angles_deg =
        in.numbers("AngleToCenterline", lidars, "NumberOfModularLidars", kAngle_deg);
    for (const double angle_deg : angles_deg) p.beam_dir_L.push_back(at_angle(angle_deg));
    p.one_direction = lidars == 1 || p.legacy_timing;  // theirs takes the first for all
    p.samples = in.integer("NumberOfMeasurements", kCount);
    return p;
  }
  p.samples = in.integer("NumberOfBeams", kCount);
  if (p.form == Form::Task52) {
    p.beam_dir_L = {at_angle(in.number("AngleToCenterline", kAngle_deg))};
    p.one_direction = true;
    p.gate = in.integer("IndexGate", Range::between(1, guo_lidar::kMaxGates));
    return p;
  }
  p.beam_dir_L = read_directions(in, static_cast<std::size_t>(p.samples));
  if (p.form == Form::V2) p.motion_compensation = in.flag("MC_Mode");
  return p;
}

}  // namespace lac
