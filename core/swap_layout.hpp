// SPDX-License-Identifier: Apache-2.0
// Which record means what: generated from the one table swap_records.def, plus the blocks
// whose size depends on the lidar. docs/record_map.md is the same for readers.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace lac {

enum class Direction { In, Out, Both };

struct RecordInfo {
  std::string_view name;
  int index = 0;  // counted from 1
  std::string_view unit;
  Direction direction = Direction::In;
  std::string_view writer;
  std::string_view meaning;
};

/// Record numbers by name, counted from 1.
enum class Rec : int {
#define LAC_RECORD(name, index, unit, direction, writer, meaning) name = index,
#include "core/swap_records.def"
#undef LAC_RECORD
};

inline constexpr auto kRecords = std::to_array<RecordInfo>({
#define LAC_RECORD(name, index, unit, direction, writer, meaning) \
  {#name, index, unit, Direction::direction, writer, meaning},
#include "core/swap_records.def"
#undef LAC_RECORD
});

/// A run of records with one owner.
struct RecordBlock {
  std::string_view name;
  int first = 0;
  int size = 0;
  constexpr int last() const { return first + size - 1; }
  constexpr bool overlaps(const RecordBlock& o) const {
    return first <= o.last() && o.first <= last();
  }
};

/// Lidar as Guo's chain sends it: the block begins at record 63 and depends on the gate count G.
namespace guo_lidar {
inline constexpr int kNewData = 0;        // 1 in the one call that carries a new measurement
inline constexpr int kBeamId = 1;         // from 0
inline constexpr int kNumberOfGates = 2;  // G
inline constexpr int kFirstSpeed = 3;     // G line-of-sight speeds [m/s], positive to the lidar
inline constexpr int kAfterGates = 3;     // + G: roll, pitch, yaw [rad], velocity x y z [m/s] in I
inline constexpr int kFixedSize = 3 + 6 + 4;  // without the G speeds; 4 results of that chain
inline constexpr int kMaxGates = 50;
// Results of that chain, + G; its LDP writes the first, its FFP the others.
inline constexpr int kRews = kAfterGates + 6;    // [m/s], 999: none yet
inline constexpr int kRewsBuffered = kRews + 1;  // [m/s], filtered and delayed
inline constexpr int kPitchRate = kRews + 2;     // [rad/s]
inline constexpr int kRewsFiltered = kRews + 3;  // [m/s]
}  // namespace guo_lidar

/// Lidar as OpenFAST sends it (3.5 on), offsets from kOpenFastLidarBlock.first. Behind the header
/// n = beams x gates speeds [m/s], then n X, n Y, n Z [m] of the measured points in its global
/// frame. No new-data flag, no validity; values are extrapolated in time (openfast_lidar.hpp).
namespace openfast_lidar {
inline constexpr int kSensorType = 0;  // 0 none, 1 point, 2 continuous wave, 3 pulsed
inline constexpr int kNumberOfBeams = 1;
inline constexpr int kNumberOfGates = 2;
inline constexpr int kFirstSpeed = 4;
inline constexpr int kMaxPoints = 5;
inline constexpr int kSize = kFirstSpeed + 4 * kMaxPoints;
}  // namespace openfast_lidar

/// Our own lidar block: everything a lidar knows about one beam, in the part of the extended
/// array that OpenFAST leaves free (1019-2000). Offsets from kNativeLidarBlock.first.
namespace native_lidar {
inline constexpr int kVersion = 0;          // 1; 0: the host fills no lidar block
inline constexpr int kNewData = 1;          // 1 in the one call that carries a new measurement
inline constexpr int kMeasurementTime = 2;  // [s], end of the accumulation of this beam
inline constexpr int kBeamId = 3;           // from 0
inline constexpr int kBeamDirection = 4;    // x y z, unit vector from the lidar, frame L
inline constexpr int kNumberOfGates = 7;
inline constexpr int kPosition = 8;     // x y z [m], frame I, origin below the rotor centre
inline constexpr int kAttitude = 11;    // roll pitch yaw [rad] of R_IL; yaw is pi looking up-wind
inline constexpr int kVelocity = 14;    // x y z [m/s], frame I
inline constexpr int kHeaderSize = 20;  // 17-19 reserved
// Per gate:
inline constexpr int kGateRange = 0;  // [m] from the lidar along the beam
inline constexpr int kGateSpeed = 1;  // line-of-sight speed [m/s], positive towards the lidar
inline constexpr int kGateValid = 2;  // 1 usable
inline constexpr int kGateCnr = 3;    // carrier-to-noise ratio [dB]
inline constexpr int kGateSize = 4;
inline constexpr int kMaxGates = 50;
inline constexpr int kLayoutVersion = 1;
constexpr int gate_offset(int gate) {
  return kHeaderSize + kGateSize * gate;
}
}  // namespace native_lidar

inline constexpr RecordBlock kHostBlock{"host", 1, 164};
inline constexpr RecordBlock kPlatformBlock{"platform motion", 1000, 19};
inline constexpr RecordBlock kNativeLidarBlock{
    "native lidar", 1101,
    native_lidar::kHeaderSize + native_lidar::kGateSize* native_lidar::kMaxGates};
inline constexpr RecordBlock kOpenFastLidarBlock{"OpenFAST lidar", 2001, 500};
inline constexpr RecordBlock kOpenFastDemandBlock{"OpenFAST lidar, cable, structure, aero control",
                                                  2501, 800};
inline constexpr RecordBlock kChainBlock{"chain", 3301, 40};
inline constexpr RecordBlock kSignalBlock{"named signals of secondaries", 3341, 60};
inline constexpr RecordBlock kPrivateLogBlock{"logging of secondaries", 3401, 300};
inline constexpr RecordBlock kPrivateGuoBlock{"lidar of Guo-type secondaries", 3701,
                                              guo_lidar::kFixedSize + guo_lidar::kMaxGates};
inline constexpr RecordBlock kChainSecondBlock{"chain, second part", 3771, 40};

inline constexpr int kExtendedArraySize = 3300;  // what OpenFAST and our harness pass
inline constexpr int kPrivateArraySize = 3820;   // what the master passes to its secondaries
inline constexpr int kExtendedSignature = 1001;  // record 66 of an extended array
inline constexpr int kChainLayoutVersion = 1;

inline constexpr auto kBlocks = std::to_array<RecordBlock>(
    {kHostBlock, kPlatformBlock, kNativeLidarBlock, kOpenFastLidarBlock, kOpenFastDemandBlock,
     kChainBlock, kSignalBlock, kPrivateLogBlock, kPrivateGuoBlock, kChainSecondBlock});

namespace detail {
constexpr bool blocks_are_disjoint() {
  for (std::size_t i = 0; i < kBlocks.size(); ++i) {
    for (std::size_t j = i + 1; j < kBlocks.size(); ++j) {
      if (kBlocks[i].overlaps(kBlocks[j])) return false;
    }
  }
  return true;
}
constexpr bool records_rise() {
  for (std::size_t i = 1; i < kRecords.size(); ++i) {
    if (kRecords[i].index <= kRecords[i - 1].index) return false;
  }
  return true;
}
constexpr bool records_are_in_a_named_block() {
  for (const RecordInfo& r : kRecords) {
    const bool host = r.index >= kHostBlock.first && r.index <= kHostBlock.last();
    const bool chain = r.index >= kChainBlock.first && r.index <= kChainBlock.last();
    const bool second = r.index >= kChainSecondBlock.first && r.index <= kChainSecondBlock.last();
    if (!host && !chain && !second) return false;
  }
  return true;
}
}  // namespace detail

static_assert(detail::blocks_are_disjoint(), "two record blocks overlap");
static_assert(detail::records_rise(), "a record stands twice or out of order");
static_assert(detail::records_are_in_a_named_block());
static_assert(kChainSecondBlock.last() <= kPrivateArraySize);
static_assert(kOpenFastDemandBlock.last() <= kExtendedArraySize);

/// The table entry of a record number, or nullptr.
constexpr const RecordInfo* find_record(int index) {
  for (const RecordInfo& r : kRecords) {
    if (r.index == index) return &r;
  }
  return nullptr;
}

}  // namespace lac
