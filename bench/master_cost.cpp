// SPDX-License-Identifier: Apache-2.0
// What the master adds: its time with one secondary that does nothing, and ROSCO behind it against
// ROSCO called directly, step by step with the same inputs in the same run.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "bench/recorded_inputs.hpp"
#include "core/call_strings.hpp"
#include "rosco/rosco_files.hpp"
#include "support/discon_caller.hpp"
#include "support/library_names.hpp"

namespace lac {
namespace {

std::string empty_chain(const test::TempFolder& folder) {
  folder.write("empty.IN", "");
  return folder.write("chain.IN", std::string("empty \"") + LAC_TOY_DIR + "/libtoy_empty" +
                                      LAC_LIBRARY_SUFFIX + "\" empty.IN ! Secondary_1 -\n");
}

/// One secondary that returns at once; the argument is the length of the host's array.
void empty_secondary(benchmark::State& state) {
  const test::TempFolder folder;
  test::DisconCaller caller("liblac_wrapper", empty_chain(folder), static_cast<int>(state.range(0)),
                            folder.file("run.SrvD"));
  caller.swap().set(Rec::NumberOfBlades, 3);
  if (caller.call(0) < 0) return state.SkipWithError(caller.message().c_str());
  while (state.KeepRunning()) benchmark::DoNotOptimize(caller.call(1));
  caller.call(-1);
}
BENCHMARK(empty_secondary)->Arg(164)->Arg(500)->Arg(kExtendedArraySize);

/// The call of that secondary without a master.
void empty_alone(benchmark::State& state) {
  const test::TempFolder folder;
  test::DisconCaller caller(std::string(LAC_TOY_DIR) + "/libtoy_empty" + LAC_LIBRARY_SUFFIX,
                            empty_chain(folder), kExtendedArraySize, folder.file("run.SrvD"));
  while (state.KeepRunning()) benchmark::DoNotOptimize(caller.call(1));
}
BENCHMARK(empty_alone);

/// As a host calls: the buffer of the message is what record 49 says.
class Host {
 public:
  Host(const std::string& library, std::string in_file, std::string out_name, int message_capacity)
      : library_(DisconLibrary::open(library, "DISCON", {LAC_LIBRARY_DIR})),
        in_file_(std::move(in_file)),
        out_name_(std::move(out_name)),
        message_(static_cast<std::size_t>(message_capacity)) {
    SwapView swap = records();
    swap.set(Rec::TimeStep, 0.0125);
    swap.set(Rec::ExtendedStart, kExtendedSignature);
    swap.set(Rec::ArraySize, kExtendedArraySize);
    swap.set(Rec::NumberOfBlades, 3);
    swap.set(Rec::MessageCapacity, message_capacity);
    swap.set(Rec::InFileLength, static_cast<double>(in_file_.size() + 1));
    swap.set(Rec::OutNameLength, static_cast<double>(out_name_.size() + 1));
  }
  void call(int status, double time_s) {
    int fail = 0;
    records().set(Rec::Status, status);
    records().set(Rec::Time, time_s);
    library_.entry()(array_.data(), &fail, in_file_.c_str(), out_name_.data(), message_.data());
    if (fail < 0) throw std::runtime_error(message_.data());
  }
  SwapView records() { return {array_.data(), kExtendedArraySize}; }

 private:
  DisconLibrary library_;
  std::vector<float> array_ = std::vector<float>(kExtendedArraySize);
  std::string in_file_, out_name_;
  std::vector<char> message_;
};

class RoscoPair {
 public:
  RoscoPair(const test::RoscoFiles& rosco, const test::TempFolder& folder, int message_capacity)
      : direct_(rosco.library.string(), rosco.copy_input_to(folder), folder.file("direct.SrvD"),
                message_capacity),
        behind_("liblac_wrapper",
                folder.write("chain.IN", "rosco \"" + rosco.library.string() +
                                             "\" DISCON.IN ! Secondary_1 -\n"),
                folder.file("behind.SrvD"), message_capacity) {}

  /// So many steps of one of them; nanoseconds per step.
  double time_ns(bool behind, int from, int steps) {
    Host& host = behind ? behind_ : direct_;
    const auto start = std::chrono::steady_clock::now();
    for (int i = from; i < from + steps; ++i) {
      bench::set_inputs(host.records(), inputs_[static_cast<std::size_t>(i % bench::kRecorded)]);
      host.call(i == 0 ? 0 : 1, 0.0125 * i);
    }
    const std::chrono::duration<double, std::nano> passed =
        std::chrono::steady_clock::now() - start;
    return passed.count() / steps;
  }

 private:
  std::vector<bench::HostInput> inputs_ = bench::recorded_inputs();
  Host direct_, behind_;
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Short turns one after the other, so that what else the machine does meets both alike; the
/// figures are medians over the turns. The argument is what the host has room for in a message,
/// which ROSCO fills with blanks at each call: 8197 characters in OpenFAST, 2049 behind our master.
void rosco_behind_master_against_direct(benchmark::State& state) {
  constexpr int kTurn = 50;
  const test::RoscoFiles rosco;
  if (!rosco.there()) {
    return state.SkipWithError("no ROSCO in build/rosco: it could not be downloaded");
  }
  const test::TempFolder folder;
  RoscoPair pair(rosco, folder, static_cast<int>(state.range(0)));
  std::vector<double> direct, behind, extra;
  int step = 0;
  while (state.KeepRunning()) {
    const bool behind_first = step / kTurn % 2 == 1;
    const double first = pair.time_ns(behind_first, step, kTurn);
    const double second = pair.time_ns(!behind_first, step, kTurn);
    direct.push_back(behind_first ? second : first);
    behind.push_back(behind_first ? first : second);
    extra.push_back(behind.back() - direct.back());
    step += kTurn;
  }
  state.counters["direct_ns"] = median(direct);
  state.counters["behind_ns"] = median(behind);
  state.counters["extra_ns"] = median(extra);
  state.counters["extra_percent"] = 100.0 * median(extra) / median(direct);
}
BENCHMARK(rosco_behind_master_against_direct)->Arg(kOpenFastMessageCapacity)->Arg(2049);

}  // namespace
}  // namespace lac
