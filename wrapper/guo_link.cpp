// SPDX-License-Identifier: Apache-2.0
#include "wrapper/guo_link.hpp"

#include <cmath>
#include <cstring>
#include <limits>

namespace lac {
namespace {

constexpr int kFirst = kPrivateGuoBlock.first;
constexpr double kErrorValue = -99.0;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kNoWind = 1;  // FfpReason::NoWind
constexpr int kResults = 4;

LidarReaderParams reader_params(const WrapperParams& params) {
  LidarReaderParams p;
  p.layout = params.lidar == HostLidar::OpenFast ? LidarLayout::OpenFast : LidarLayout::Native;
  p.number_of_beams = p.layout == LidarLayout::OpenFast ? 1 : 256;
  p.stuck_scans = 0;
  p.openfast = params.openfast_lidar;
  return p;
}

int gates_of(const GuoLink::State& s) {
  return s.gates > 0 ? s.gates : 1;
}
int result_record(const GuoLink::State& s, int offset) {
  return kFirst + gates_of(s) + offset;
}
bool is_wind_speed(double v_mps) {
  return v_mps > 0.0 && v_mps <= 100.0;
}

/// A host's block may come late; the results move behind its gates.
void set_gates(PrivateArray& array, GuoLink::State& s, int gates) {
  std::array<float, kResults> results{};
  std::memcpy(results.data(), array.record(result_record(s, guo_lidar::kRews)), sizeof results);
  s.gates = gates;
  std::memcpy(array.record(result_record(s, guo_lidar::kRews)), results.data(), sizeof results);
}

void put_measurement(const LidarMeasurement& m, const GuoLink::State& s, SwapView view) {
  view.put(kFirst + guo_lidar::kBeamId, m.beam_id);
  for (int g = 0; g < s.gates; ++g) {
    const LidarGate& gate = m.gates[static_cast<std::size_t>(g)];
    const bool valid = g < m.gate_count && gate.valid;
    view.put(kFirst + guo_lidar::kFirstSpeed + g, valid ? gate.speed_mps : kErrorValue);
  }
  int record = kFirst + guo_lidar::kAfterGates + s.gates;
  for (const double value : {m.roll_rad, m.pitch_rad, m.yaw_rad, m.velocity_I_mps.x,
                             m.velocity_I_mps.y, m.velocity_I_mps.z}) {
    view.put(record++, value);
  }
}

template <std::size_t n>
std::array<float, n> values(const SwapReader& view, const std::array<Rec, n>& records) {
  std::array<float, n> all{};
  for (std::size_t i = 0; i < n; ++i) all[i] = static_cast<float>(view.get(records[i]));
  return all;
}
/// To the bit: "not a number" is a value here.
template <std::size_t n>
bool same(const std::array<float, n>& a, const std::array<float, n>& b) {
  return std::memcmp(a.data(), b.data(), sizeof a) == 0;  // NOLINT
}

constexpr std::array kRewsRecords{Rec::LidarRews, Rec::LidarRewsValid};
constexpr std::array kFeedforwardRecords{Rec::FeedforwardPitchRate, Rec::FeedforwardActive,
                                         Rec::FeedforwardReason};

bool ours_writes_rews(const SwapReader& view, const GuoLink::State& s) {
  return !same(values(view, kRewsRecords), s.rews);
}

}  // namespace

GuoLink::GuoLink(const WrapperParams& params)
    : copies_(params.lidar == HostLidar::Guo),
      announced_gates_(params.lidar == HostLidar::OpenFast ? openfast_lidar::kMaxPoints
                                                           : guo_lidar::kMaxGates),
      reader_(reader_params(params)) {}

void GuoLink::require(const SwapReader& array, double time_step_s, Notice& notice) const {
  if (!copies_) reader_.require(array, time_step_s, notice);
}

GuoLink::State GuoLink::initial_state() const {
  State s;
  s.lidar = reader_.initial_state();
  if (!copies_) s.gates = announced_gates_;
  return s;
}

void GuoLink::fill(PrivateArray& array, int host_block, double time_s, State& s,
                   Notice& notice) noexcept {
  const bool is_new =
      copies_ ? copy_block(array, host_block, s, notice) : read_lidar(array, time_s, s, notice);
  s.calls_since = is_new ? 0 : s.calls_since + 1;
  s.announced = s.announced || is_new;
  s.buffered_was_good = s.buffered_is_good;
  SwapView view = array.view();
  view.put(kFirst + guo_lidar::kNewData, is_new ? 1.0 : 0.0);
  view.put(kFirst + guo_lidar::kNumberOfGates, gates_of(s));
}

bool GuoLink::read_lidar(PrivateArray& array, double time_s, State& s, Notice& notice) noexcept {
  LidarMeasurement& m = measurement_;
  if (!reader_.read(array.view(), time_s, s.lidar, m, notice)) return false;
  if (m.gate_count == 0 || !m.gates[0].valid) return false;
  put_measurement(m, s, array.view());
  return true;
}

bool GuoLink::copy_block(PrivateArray& array, int host_block, State& s,
                         Notice& notice) const noexcept {
  const SwapView view = array.view();
  const int gates = host_block > 0 ? view.integer(host_block + guo_lidar::kNumberOfGates, 0) : 0;
  if (s.gates == 0 && gates > 0) set_gates(array, s, gates);
  if (gates == 0 || gates != s.gates) {
    if (!s.no_block_reported) {
      notice.warn(
          "lidar: record 63 (%g) of the host is not the start of a lidar block of Guo's layout, or "
          "no longer with %d gates: no measurements for GuoSecondaries until it is",
          array.view().get(Rec::LogStart), gates_of(s));
    }
    s.no_block_reported = true;
    return false;
  }
  std::memcpy(array.record(kFirst), array.record(host_block),
              static_cast<std::size_t>(guo_lidar::kRews + gates) * sizeof(float));
  return view.integer(host_block + guo_lidar::kNewData, 0) == 1;
}

void GuoLink::take(PrivateArray& array, const State& s) const noexcept {
  SwapView view = array.view();
  if (!ours_writes_rews(view, s) || view.integer(Rec::LidarRewsValid, 0) != 1) return;
  view.put(result_record(s, guo_lidar::kRews), view.get(Rec::LidarRews));
}

void GuoLink::give(PrivateArray& array, State& s) const noexcept {
  SwapView view = array.view();
  const auto result = [&](int offset) { return view.at(result_record(s, offset)); };
  const double age_s = static_cast<double>(s.calls_since) * view.get(Rec::TimeStep);
  const bool fresh = s.announced && age_s <= kOldest_s;
  if (!ours_writes_rews(view, s)) {
    const bool valid = fresh && is_wind_speed(result(guo_lidar::kRews));
    view.set(Rec::LidarRews, valid ? result(guo_lidar::kRews) : kNan);
    view.set(Rec::LidarRewsLead, 0.0);
    view.set(Rec::LidarRewsValid, valid ? 1.0 : 0.0);
    view.set(Rec::LidarDataAge, s.announced ? age_s : kNan);
    s.rews = values(view, kRewsRecords);
  }
  if (!same(values(view, kFeedforwardRecords), s.feedforward)) return;
  const double rate = result(guo_lidar::kPitchRate);
  s.buffered_is_good = is_wind_speed(result(guo_lidar::kRewsBuffered));
  const bool on =
      fresh && s.buffered_was_good && s.buffered_is_good && std::abs(rate) <= kFastestRate_radps;
  view.set(Rec::FeedforwardPitchRate, on ? rate : 0.0);
  view.set(Rec::FeedforwardActive, on ? 1.0 : 0.0);
  view.set(Rec::FeedforwardReason, on ? 0 : kNoWind);
  view.set(Rec::RewsFiltered, on ? result(guo_lidar::kRewsFiltered) : kNan);
  view.set(Rec::RewsBuffered, on ? result(guo_lidar::kRewsBuffered) : kNan);
  s.feedforward = values(view, kFeedforwardRecords);
}

}  // namespace lac
