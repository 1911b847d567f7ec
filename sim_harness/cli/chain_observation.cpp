// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/chain_observation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/lidar_block.hpp"
#include "wrapper/guo_link.hpp"
#include "wrapper/host_link.hpp"
#include "wrapper/private_array.hpp"
#include "wrapper/secondary.hpp"

namespace lac::sim {
namespace {

constexpr int kStepsPerBeam = 20;
constexpr double kMeasurement_s = 0.25;
constexpr int kGates = 10;
constexpr int kGuoBlockStart = 165;
constexpr int kObservedFloats = sizeof(PrivateArray) / sizeof(float);
static_assert(std::is_trivially_destructible_v<PrivateArray>);  // its memory is not its own here

using Accesses = ObservedArray::Accesses;

void place_native_lidar(SwapView host, double time_s, bool is_new) {
  LidarMeasurement m;
  m.time_s = time_s;
  m.gate_count = kGates;
  m.position_I_m = {0.0, 0.0, 90.0};
  for (int g = 0; g < kGates; ++g) {
    m.gates[static_cast<std::size_t>(g)] = {50.0 + 10.0 * g, 15.0 + 0.01 * g + time_s, true, 0.0};
  }
  write_native_lidar(host, m, is_new);
}

/// Five gates of a pulsed lidar up-wind; values change with each measurement.
void place_openfast_lidar(SwapView host, double time_s) {
  namespace of = openfast_lidar;
  const int first = kOpenFastLidarBlock.first;
  const double measured_s = std::floor(time_s / kMeasurement_s) * kMeasurement_s;
  host.put(first + of::kSensorType, 3.0);
  host.put(first + of::kNumberOfBeams, 1.0);
  host.put(first + of::kNumberOfGates, of::kMaxPoints);
  for (int g = 0; g < of::kMaxPoints; ++g) {
    const int speed = first + of::kFirstSpeed + g;
    host.put(speed, 15.0 + 0.01 * g + measured_s);
    host.put(speed + of::kMaxPoints, -205.0 + 30.0 * g);  // x, y, z
    host.put(speed + 2 * of::kMaxPoints, 0.0);
    host.put(speed + 3 * of::kMaxPoints, 90.0);
  }
}

void place_guo_lidar(SwapView host, double time_s, bool is_new) {
  host.set(Rec::LogStart, kGuoBlockStart);
  host.put(kGuoBlockStart + guo_lidar::kNewData, is_new ? 1.0 : 0.0);
  host.put(kGuoBlockStart + guo_lidar::kNumberOfGates, kGates);
  for (int g = 0; g < kGates; ++g) {
    host.put(kGuoBlockStart + guo_lidar::kFirstSpeed + g, 15.0 + 0.01 * g + time_s);
  }
}

/// The records of the private array without the guard in front of it and those of the call.
Accesses records_in(const Accesses& floats) {
  Accesses records{std::vector<bool>(kPrivateArraySize + 1),
                   std::vector<bool>(kPrivateArraySize + 1)};
  for (std::size_t record = 1; record <= kPrivateArraySize; ++record) {
    if (is_of_the_call(static_cast<int>(record))) continue;
    records.read[record] = floats.read[record + PrivateArray::kGuard];
    records.written[record] = floats.written[record + PrivateArray::kGuard];
  }
  return records;
}

/// The chain on an array that sees who touches it.
class ObservedChain {
 public:
  ObservedChain(const WrapperParams& chain, const std::filesystem::path& master_folder,
                std::vector<float> host_array, const std::string& out_name)
      : lidar_(chain.lidar),
        link_(chain.lidar, chain.extended_demands),
        host_array_(std::move(host_array)) {
    link_.require(host());
    link_.start(host(), array_, state_);
    if (std::ranges::any_of(chain.secondaries, &SecondaryParams::guo)) {
      guo_.emplace(chain);
      guo_state_ = guo_->initial_state();
      Notice nobody_listens;
      guo_->require(host(), host().get(Rec::TimeStep), nobody_listens);
    }
    for (const SecondaryParams& s : chain.secondaries) {
      members_.push_back(
          {std::make_unique<Secondary>(chain, s, master_folder, out_name),
           {std::vector<bool>(kObservedFloats + 1), std::vector<bool>(kObservedFloats + 1)},
           {}});
    }
  }

  void step(int number) {
    const double time_s = number * host().get(Rec::TimeStep);
    host().set(Rec::Time, time_s);
    const bool is_new = number > 0 && number % kStepsPerBeam == 0;
    place_lidar(lidar_, host(), time_s, is_new);
    Notice nobody_listens;
    link_.take_inputs(host(), array_, state_, nobody_listens);
    if (guo_) guo_->fill(array_, state_.log_start, time_s, guo_state_, nobody_listens);
    array_.view().set(Rec::ChainVersion, kChainLayoutVersion);
    array_.view().set(Rec::ChainInputsGood, 1.0);
    for (Member& m : members_) {
      if (!m.problem.empty()) continue;
      if (number == 0) array_.view().set(Rec::ChainMember, 0.0);
      call(m, number == 0 ? LAC_STATUS_FIRST : LAC_STATUS_STEP);
      m.secondary->started = m.secondary->started || m.problem.empty();
    }
    link_.keep_demands(array_, state_);
  }

  void finish() {
    for (Member& m : members_) {
      if (m.secondary->started) call(m, LAC_STATUS_LAST);
    }
  }

  std::vector<SecondaryAccess> result() const {
    std::vector<SecondaryAccess> all;
    for (const Member& m : members_) {
      all.push_back({m.secondary->name(), records_in(m.touched), m.problem});
    }
    if (guo_) all.push_back({"wrapper", records_in(translated_), {}});
    return all;
  }

 private:
  struct Member {
    std::unique_ptr<Secondary> secondary;
    Accesses touched;  // floats of the observed memory, counted from 1
    std::string problem;
  };

  SwapView host() { return {host_array_.data(), static_cast<int>(host_array_.size())}; }

  void call(Member& m, int status) {
    if (m.secondary->guo()) {
      call_guo(m, status);
    } else {
      const ObservedArray::Watch watch(memory_, m.touched);
      m.secondary->call(array_, status, state_.log_start, link_.logging());
    }
    if (!m.problem.empty()) return;
    if (m.secondary->fail() < 0) {
      m.problem = m.secondary->message();
    } else if (const int record = HostLink::bad_demand(array_); record != 0) {
      m.problem = "demand in record " + std::to_string(record) + " is not finite";
    }
    if (!m.problem.empty()) link_.hold_demands(array_, state_);
  }

  /// What the master puts into its block beforehand (a REWS of ours) is a copy, not a writer more.
  void call_guo(Member& m, int status) {
    Secondary& secondary = *m.secondary;
    guo_->take(array_, guo_state_);
    {
      const ObservedArray::Watch watch(memory_, m.touched);
      secondary.call(array_, status, kPrivateGuoBlock.first, false);
    }
    if (status == LAC_STATUS_FIRST) {
      secondary.member = array_.view().integer(Rec::ChainMember, 0) == 1;
    }
    if (secondary.member || status == LAC_STATUS_LAST) return;
    const ObservedArray::Watch watch(memory_, translated_);
    guo_->give(array_, guo_state_);
  }

  HostLidar lidar_;
  HostLink link_;
  HostLink::State state_;
  std::optional<GuoLink> guo_;  // if there are Guo-type secondaries
  GuoLink::State guo_state_;
  /// What the master translates of their results.
  Accesses translated_{std::vector<bool>(kObservedFloats + 1),
                       std::vector<bool>(kObservedFloats + 1)};
  std::vector<float> host_array_;
  ObservedArray memory_{kObservedFloats};
  PrivateArray& array_ = *new (memory_.data()) PrivateArray;
  std::vector<Member> members_;
};

}  // namespace

void place_lidar(HostLidar layout, SwapView host, double time_s, bool is_new) {
  if (layout == HostLidar::Native) place_native_lidar(host, time_s, is_new);
  if (layout == HostLidar::OpenFast) place_openfast_lidar(host, time_s);
  if (layout == HostLidar::Guo) place_guo_lidar(host, time_s, is_new);
}

bool is_of_the_call(int record) {
  constexpr std::array kRecordsOfTheCall{
      Rec::Status,          Rec::Time,          Rec::TimeStep,      Rec::MessageCapacity,
      Rec::InFileLength,    Rec::OutNameLength, Rec::LogCapacity,   Rec::LogStart,
      Rec::OutNameCapacity, Rec::LogCount,      Rec::ExtendedStart, Rec::ArraySize,
      Rec::ChainVersion,    Rec::ChainMember};
  return std::find(kRecordsOfTheCall.begin(), kRecordsOfTheCall.end(), static_cast<Rec>(record)) !=
         kRecordsOfTheCall.end();
}

std::vector<SecondaryAccess> observe_chain(const WrapperParams& chain,
                                           const std::filesystem::path& master_folder,
                                           std::vector<float> host_array,
                                           const std::string& out_name) {
  ObservedChain observed(chain, master_folder, std::move(host_array), out_name);
  for (int number = 0; number <= kObservedSteps; ++number) observed.step(number);
  observed.finish();
  return observed.result();
}

}  // namespace lac::sim
