// SPDX-License-Identifier: Apache-2.0
#include "wrapper/host_lidar.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/lidar_block.hpp"
#include "wrapper/host_records.hpp"

namespace lac {
namespace {

constexpr RecordBlock kOpenFastPoints{"OpenFAST lidar", kOpenFastLidarBlock.first,
                                      openfast_lidar::kSize};

constexpr const char* kHowAHostSaysSo =
    "a longer one says so with record 66 = 1001 and its length in record 129";
constexpr const char* kOpenFastHosts =
    "OpenFAST from 3.5 on passes them (extended array: record 66 = 1001, length in record 129); "
    "hosts with a short array, such as ROSCO's Python class with its 500 floats, cannot carry a "
    "lidar: use LidarLayout none there";

/// Flag, beam, gate count, speeds, attitude and velocity; what follows belongs to the chain.
int host_part_of(GuoBlock block) {
  return guo_lidar::kAfterGates + block.gates + 6;
}

/// The block, if it lies within what is known of the array. An array without a known size is
/// trusted: the user has said that it carries this layout.
GuoBlock fitting_guo_block(const SwapReader& host) {
  const int end = host.size() > kHostBlock.last() ? host.size() : kExtendedArraySize;
  const int header_end = host.integer(Rec::LogStart, 0) + guo_lidar::kNumberOfGates;
  if (header_end > end) return {};
  const GuoBlock block = find_guo_block(host.data());
  return block.first + host_part_of(block) - 1 <= end ? block : GuoBlock{};
}

void take_native(SwapView host, PrivateArray& array) {
  const int first = kNativeLidarBlock.first;
  copy_records(host.data(), array, first, native_lidar::kNewData + 1);
  if (!native_lidar_is_new(host)) return;
  const int gates =
      std::clamp(host.integer(first + native_lidar::kNumberOfGates, 0), 0, native_lidar::kMaxGates);
  copy_records(host.data(), array, first, native_lidar::gate_offset(gates));
}

}  // namespace

void require_records(const SwapReader& host, const RecordBlock& block, const std::string& key,
                     const std::string& hint) {
  if (host.holds(block)) return;
  throw Error(key + " needs records " + std::to_string(block.first) + "-" +
              std::to_string(block.last()) + " (" + std::string(block.name) + "), but only " +
              std::to_string(host.size()) + " records of the host's array are known to exist; " +
              hint);
}

void require_host_lidar(HostLidar layout, const SwapReader& host) {
  if (layout == HostLidar::Native) {
    require_records(host, kNativeLidarBlock, "LidarLayout native", kHowAHostSaysSo);
  } else if (layout == HostLidar::OpenFast) {
    require_records(host, kOpenFastPoints, "LidarLayout openfast", kOpenFastHosts);
  }
}

int take_host_lidar(HostLidar layout, SwapView host, PrivateArray& array) noexcept {
  switch (layout) {
    case HostLidar::None:
      break;
    case HostLidar::Native:
      take_native(host, array);
      break;
    case HostLidar::OpenFast:
      copy_records(host.data(), array, kOpenFastPoints.first, kOpenFastPoints.size);
      break;
    case HostLidar::Guo: {
      const GuoBlock block = fitting_guo_block(host);
      if (block.first != 0) {
        copy_records(host.data(), array, block.first, host_part_of(block));
      }
      return block.first;
    }
  }
  return kPrivateLogBlock.first;
}

}  // namespace lac
