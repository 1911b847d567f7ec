// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/chain_observation.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/lidar_block.hpp"

namespace lac::sim {
namespace {

constexpr int kStepsPerBeam = 20;
constexpr int kMessageCapacity = 8197;
constexpr int kOutNameCapacity = 12601;

/// One secondary while it is observed.
struct Observed {
  const SecondaryParams* params;
  DisconLibrary library;
  std::string in_file;
  std::string out_name;
  SecondaryAccess access;
};

LidarMeasurement beam_ahead(double time_s) {
  LidarMeasurement m;
  m.time_s = time_s;
  m.gate_count = 10;
  m.position_I_m = {0.0, 0.0, 90.0};
  for (int g = 0; g < m.gate_count; ++g) {
    m.gates[static_cast<std::size_t>(g)] = {50.0 + 10.0 * g, 15.0 + 0.01 * g + time_s, true, 0.0};
  }
  return m;
}

void fill(SwapView swap, int status, int step) {
  const double time_s = step * swap.get(Rec::TimeStep);
  swap.set(Rec::Status, status);
  swap.set(Rec::Time, time_s);
  swap.set(Rec::ChainVersion, kChainLayoutVersion);
  swap.set(Rec::ChainInputsGood, 1.0);
  swap.set(Rec::ArraySize, kPrivateArraySize);
  const bool is_new = status == LAC_STATUS_STEP && step % kStepsPerBeam == 0;
  write_native_lidar(swap, beam_ahead(time_s), is_new);
}

void call(Observed& o, ObservedArray& array) {
  SwapView swap(array.data(), array.size());
  std::array<char, kMessageCapacity> message{};
  std::vector<char> in_file(o.in_file.c_str(), o.in_file.c_str() + o.in_file.size() + 1);
  std::vector<char> out_name(kOutNameCapacity, '\0');
  std::copy(o.out_name.begin(), o.out_name.end(), out_name.begin());
  swap.set(Rec::MessageCapacity, kMessageCapacity);
  swap.set(Rec::InFileLength, static_cast<double>(in_file.size()));
  swap.set(Rec::OutNameLength, static_cast<double>(o.out_name.size() + 1));
  int fail = 0;
  array.watch(o.access.accesses);
  o.library.entry()(array.data(), &fail, in_file.data(), out_name.data(), message.data());
  array.stop();
  if (fail < 0 && o.access.problem.empty()) o.access.problem = message.data();
}

void forget_records_of_the_call(ObservedArray::Accesses& accesses) {
  for (int record = 1; record <= kPrivateArraySize; ++record) {
    if (!is_of_the_call(record)) continue;
    accesses.read[static_cast<std::size_t>(record)] = false;
    accesses.written[static_cast<std::size_t>(record)] = false;
  }
}

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
                                           const std::vector<float>& host_array,
                                           const std::string& out_root) {
  ObservedArray array(kPrivateArraySize);
  std::copy(host_array.begin(), host_array.end(), array.data());
  const std::vector<bool> none(kPrivateArraySize + 1, false);
  std::vector<Observed> all;
  for (const SecondaryParams& s : chain.secondaries) {
    all.push_back({&s,
                   chain.open_library(s, master_folder),
                   s.input_file.string(),
                   out_root + "." + s.name + ".SrvD",
                   {s.name, {none, none}, {}}});
  }
  for (int step = 0; step <= kObservedSteps + 1; ++step) {
    const int status = step == 0                    ? LAC_STATUS_FIRST
                       : step == kObservedSteps + 1 ? LAC_STATUS_LAST
                                                    : LAC_STATUS_STEP;
    fill(SwapView(array.data(), array.size()), status, std::min(step, kObservedSteps));
    for (Observed& o : all) {
      if (o.access.problem.empty() || status == LAC_STATUS_LAST) call(o, array);
    }
  }
  std::vector<SecondaryAccess> result;
  for (Observed& o : all) {
    forget_records_of_the_call(o.access.accesses);
    result.push_back(std::move(o.access));
  }
  return result;
}

}  // namespace lac::sim
