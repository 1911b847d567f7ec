// SPDX-License-Identifier: Apache-2.0
#include <sundials/sundials_version.h>

#include <array>
#include <ostream>

#include "core/swap_layout.hpp"
#include "sim_harness/cli/commands.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {
namespace {

std::string sundials_version() {
  std::array<char, 64> text{};
  SUNDIALSGetVersion(text.data(), static_cast<int>(text.size()));
  return text.data();
}

const char* direction_text(Direction direction) {
  return direction == Direction::In ? "in" : direction == Direction::Out ? "out" : "both";
}

/// Our own lidar layout, record by record.
void print_lidar_block(std::ostream& out) {
  namespace nat = native_lidar;
  struct Row {
    int offset;
    const char* meaning;
  };
  constexpr Row kHeader[] = {
      {nat::kVersion, "layout version, 1; 0: no lidar"},
      {nat::kNewData, "1 in the one call that carries a new measurement"},
      {nat::kMeasurementTime, "time of the measurement [s]"},
      {nat::kBeamId, "beam, counted from 0"},
      {nat::kBeamDirection, "direction of the beam in frame L, unit vector: x, y, z [-]"},
      {nat::kNumberOfGates, "number of gates, at most 50"},
      {nat::kPosition, "position of the lidar in frame I: x, y, z [m]"},
      {nat::kAttitude, "roll, pitch, yaw of frame L in frame I [rad]"},
      {nat::kVelocity, "velocity of the lidar in frame I: x, y, z [m/s]"},
  };
  constexpr Row kGate[] = {
      {nat::kGateRange, "range along the beam [m]"},
      {nat::kGateSpeed, "line-of-sight speed, positive towards the lidar [m/s]"},
      {nat::kGateValid, "1 usable, 0 not"},
      {nat::kGateCnr, "carrier-to-noise ratio [dB]"},
  };
  out << "\n## Native lidar block\n\nOne beam with all its gates. Frames: "
         "docs/frames_and_units.md.\n\n"
         "| record | meaning |\n|---:|---|\n";
  for (const Row& row : kHeader) {
    out << "| " << kNativeLidarBlock.first + row.offset << " | " << row.meaning << " |\n";
  }
  for (const Row& row : kGate) {
    out << "| " << kNativeLidarBlock.first + nat::gate_offset(0) + row.offset << " + "
        << nat::kGateSize << " g | gate g = 0, 1, ...: " << row.meaning << " |\n";
  }
}

/// OpenFAST's lidar layout, which depends on the number n of points.
void print_openfast_lidar_block(std::ostream& out) {
  namespace of = openfast_lidar;
  const int first = kOpenFastLidarBlock.first;
  out << "\n## OpenFAST lidar block\n\nn = beams x gates, at most " << of::kMaxPoints
      << "; positions in OpenFAST's global frame.\n\n| record | meaning |\n|---:|---|\n| "
      << first + of::kSensorType
      << " | sensor type: 0 none, 1 single points, 2 continuous wave, 3 pulsed |\n| "
      << first + of::kNumberOfBeams << " | beams |\n| " << first + of::kNumberOfGates
      << " | gates |\n";
  constexpr const char* kStarts[] = {"", " + n", " + 2 n", " + 3 n"};
  constexpr const char* kMeanings[] = {"speed [m/s]", "x [m]", "y [m]", "z [m]"};
  for (int i = 0; i < 4; ++i) {
    out << "| " << first + of::kFirstSpeed << kStarts[i]
        << " + i | point i = 0, 1, ...: " << kMeanings[i] << " |\n";
  }
}

}  // namespace

void print_version(std::ostream& out) {
  out << "lac " << LAC_VERSION << " (" << LAC_BUILD_TYPE << ", GCC-compatible " << __VERSION__
      << ")\nSUNDIALS " << sundials_version() << "\n\nArray of the host: " << kExtendedArraySize
      << " records, of the master: " << kPrivateArraySize << "; native lidar layout "
      << native_lidar::kLayoutVersion << ", chain layout " << kChainLayoutVersion << "\n";
  TextTable table({"block", "first", "last"});
  for (const RecordBlock& b : kBlocks) {
    table.add_row({std::string(b.name), std::to_string(b.first), std::to_string(b.last())});
  }
  out << table.text();
}

void print_records(std::ostream& out) {
  out << "# Record map\n\n"
         "Printed by `lac records` from the one table of records, `core/swap_records.def`, and "
         "the\n"
         "blocks of `core/swap_layout.hpp`. Records are counted from 1. *in*: host to library, "
         "*out*:\n"
         "library to host. The chain block exists in the master's private array only.\n\n"
         "## Records\n\n| record | name | unit | direction | writer | meaning |\n"
         "|---:|---|---|---|---|---|\n";
  for (const RecordInfo& r : kRecords) {
    out << "| " << r.index << " | " << r.name << " | " << r.unit << " | "
        << direction_text(r.direction) << " | " << r.writer << " | " << r.meaning << " |\n";
  }
  out << "\n## Blocks\n\n| block | first | last |\n|---|---:|---:|\n";
  for (const RecordBlock& b : kBlocks) {
    out << "| " << b.name << " | " << b.first << " | " << b.last() << " |\n";
  }
  print_lidar_block(out);
  print_openfast_lidar_block(out);
}

}  // namespace lac::sim
