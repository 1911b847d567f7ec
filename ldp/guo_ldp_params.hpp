// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/guo_input_file.hpp"
#include "core/vec3.hpp"

namespace lac {

/// What an LDP input file of Guo's chain says. It has no distances, so its estimate has no lead.
struct GuoLdpParams {
  enum class Form { V1, V2, V3, Task52 };  // LDP_v1, v2, v3; LDP_v1 v1.4 of IEA Wind Task 52
  Form form = Form::V1;

  std::vector<Vec3> beam_dir_L;  // unit vectors by beam id; V3: by lidar, in the plane of its angle
  bool one_direction = false;    // the first for every beam id: Task52, and a V3 file of one lidar
  int samples = 1;               // in the mean: NumberOfBeams, V3 NumberOfMeasurements
  int gate = 1;                  // which one of a beam, counted from 1: IndexGate, else the first
  bool motion_compensation = false;  // V2: MC_Mode
  // All values as their library would give them, its defects included; for comparison.
  bool legacy_timing = false;

  static GuoForm form_of(const GuoInputFile& file);
  /// Precondition: file.is_theirs(guo_ldp_marks()). Throws lac::Error with file and line.
  static GuoLdpParams read(const GuoInputFile& file);
};

}  // namespace lac
