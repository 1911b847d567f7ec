// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/chain_observation.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

#include "core/lidar_block.hpp"
#include "wrapper/host_link.hpp"
#include "wrapper/private_array.hpp"
#include "wrapper/secondary.hpp"

namespace lac::sim {
namespace {

constexpr int kStepsPerBeam = 20;
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
    if (lidar_ == HostLidar::Native) place_native_lidar(host(), time_s, is_new);
    if (lidar_ == HostLidar::Guo) place_guo_lidar(host(), time_s, is_new);
    Notice nobody_listens;
    link_.take_inputs(host(), array_, state_, nobody_listens);
    array_.view().set(Rec::ChainVersion, kChainLayoutVersion);
    array_.view().set(Rec::ChainInputsGood, 1.0);
    for (Member& m : members_) {
      if (!m.problem.empty()) continue;
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
    {
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

  HostLidar lidar_;
  HostLink link_;
  HostLink::State state_;
  std::vector<float> host_array_;
  ObservedArray memory_{kObservedFloats};
  PrivateArray& array_ = *new (memory_.data()) PrivateArray;
  std::vector<Member> members_;
};

}  // namespace

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
