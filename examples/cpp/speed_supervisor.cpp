// SPDX-License-Identifier: Apache-2.0
//
// A secondary controller in C++, made to be copied: a supervisor that gives the turbine a rest
// after overspeed. Each time the generator speed passes a limit the power level falls by a step;
// it comes back slowly. The feedback controller follows it (UsePowerLevel true).
//
// Each turbine has a state of its own here, found by the root name of its output files, so one
// image of this library serves any number of turbines, also in threads; the marker at the end
// says so to the LAC master. (The C and Fortran examples keep one static state and no marker: the
// master then loads a private copy for each turbine.)
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/discon_abi.h"

namespace {

/// The records of one call, counted from 1 as in all documents.
class Records {
 public:
  explicit Records(float* swap) : swap_(swap) {}
  float& operator[](int record) { return swap_[record - 1]; }

  /// Records that may be touched: 164 with every host, more where the host says so.
  int known() { return (*this)[66] == 1001.0F && (*this)[129] > 164.0F ? whole(129) : 164; }
  int whole(int record) { return static_cast<int>(std::lround((*this)[record])); }

 private:
  float* swap_;
};

constexpr int kStatus = 1, kTimeStep = 3, kGeneratorSpeed = 20, kMessageCapacity = 49,
              kInFileLength = 50, kOutNameLength = 51;
constexpr int kChainVersion = 3301, kPowerLevel = 3313, kPowerLevelValid = 3314;
constexpr double kRadpsFromRpm = 3.14159265358979323846 / 30.0;

/// The host counts the terminator or not, and may send none.
std::string_view text_of(const char* text, int length) {
  const std::string_view all(text, static_cast<std::size_t>(length < 0 ? 0 : length));
  return all.substr(0, all.find('\0'));
}

/// The number of the line "value ! key". Not by streams or strtod: a host may have set a locale
/// with decimal commas.
double read_number(const std::string& file, const std::string& key) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file + " cannot be opened");
  for (std::string line; std::getline(in, line);) {
    const std::size_t mark = line.find("! " + key + " ");
    double value = 0.0;
    if (mark == std::string::npos) continue;
    const std::size_t first = std::min(line.find_first_not_of(" \t"), mark);
    const auto result = std::from_chars(line.data() + first, line.data() + mark, value);
    if (result.ec == std::errc{}) return value;
    throw std::runtime_error(file + ": " + key + ": expected a number in front of '!'");
  }
  throw std::runtime_error(file + ": " + key + " is missing");
}

class Supervisor {
 public:
  Supervisor(const std::string& file, Records swap) {
    if (swap.known() < kPowerLevelValid || swap[kChainVersion] != 1.0F) {
      throw std::runtime_error("the power level exists in the array of the LAC master alone");
    }
    s_.limit_radps = read_number(file, "SpeedLimit") * kRadpsFromRpm;
    s_.release_radps = read_number(file, "ReleaseSpeed") * kRadpsFromRpm;
    s_.step = read_number(file, "PowerLevelStep");
    s_.minimum = read_number(file, "MinimumPowerLevel");
    s_.recovery_per_step = read_number(file, "RecoveryRate") / 60.0 * swap[kTimeStep];
    if (!(s_.release_radps < s_.limit_radps && s_.step > 0.0 && s_.minimum > 0.0)) {
      throw std::runtime_error(file +
                               ": expected ReleaseSpeed below SpeedLimit, PowerLevelStep and "
                               "MinimumPowerLevel above 0");
    }
  }

  /// Continues from a checkpoint, which holds the parameters as well: a restarted process is told
  /// its name, not that of the input file.
  explicit Supervisor(const std::string& checkpoint) {
    std::ifstream in(checkpoint, std::ios::binary);
    const Saved fresh;
    in.read(reinterpret_cast<char*>(&s_), sizeof s_);
    if (!in || std::memcmp(s_.magic, fresh.magic, sizeof fresh.magic) != 0) {
      throw std::runtime_error(checkpoint + " is not a checkpoint of this library");
    }
  }

  void save(const std::string& checkpoint) const {
    std::ofstream out(checkpoint, std::ios::binary);
    out.write(reinterpret_cast<const char*>(&s_), sizeof s_);
    if (!out.flush()) throw std::runtime_error(checkpoint + " cannot be written");
  }

  /// True if the limit was passed in this step. No memory, no files.
  bool step(Records swap) noexcept {
    const double speed_radps = swap[kGeneratorSpeed];
    const bool passed = !s_.above && speed_radps > s_.limit_radps;
    if (passed) s_.above = true;
    if (speed_radps < s_.release_radps) s_.above = false;
    if (passed) {
      s_.level = std::fmax(s_.minimum, s_.level - s_.step);
    } else {
      s_.level = std::fmin(1.0, s_.level + s_.recovery_per_step);
    }
    swap[kPowerLevel] = static_cast<float>(s_.level);
    swap[kPowerLevelValid] = 1.0F;
    return passed;
  }

 private:
  struct Saved {
    char magic[8] = "SPEEDS1";
    double limit_radps = 0.0, release_radps = 0.0, step = 0.0, minimum = 0.0;
    double recovery_per_step = 0.0;
    double level = 1.0;
    bool above = false;
  };
  Saved s_;
};

/// One per turbine. The lock is held to find it, not while it works.
std::map<std::string, std::unique_ptr<Supervisor>, std::less<>> supervisors;
std::mutex door;

Supervisor& find(std::string_view root_name) {
  const std::lock_guard lock(door);
  const auto found = supervisors.find(root_name);
  if (found == supervisors.end()) throw std::runtime_error("call before the first one");
  return *found->second;
}

void keep(std::string_view root_name, std::unique_ptr<Supervisor> supervisor) {
  const std::lock_guard lock(door);
  supervisors[std::string(root_name)] = std::move(supervisor);
}

void drop(std::string_view root_name) {
  const std::lock_guard lock(door);
  if (const auto found = supervisors.find(root_name); found != supervisors.end()) {
    supervisors.erase(found);
  }
}

/// aviFAIL: 0 fine, 1 a warning in avcMSG. Failures are thrown.
int call(Records swap, std::string_view in_file, std::string_view root_name, std::string& message) {
  switch (swap.whole(kStatus)) {
    case LAC_STATUS_FIRST:
      keep(root_name, std::make_unique<Supervisor>(std::string(in_file), swap));
      find(root_name).step(swap);
      return 0;
    case LAC_STATUS_STEP:
      if (!find(root_name).step(swap)) return 0;
      message = "overspeed: power level lowered to " + std::to_string(swap[kPowerLevel]);
      return 1;
    case LAC_STATUS_CHECKPOINT:
      find(root_name).save(std::string(in_file));
      return 0;
    case LAC_STATUS_RESTART:
      keep(root_name, std::make_unique<Supervisor>(std::string(in_file)));
      return 0;
    case LAC_STATUS_LAST:
      drop(root_name);
      return 0;
    default:  // not known: nothing is done
      return 0;
  }
}

}  // namespace

/// All data is per turbine: the master need not load a copy of this library for each.
const int LAC_DISCON_REENTRANT = 1;

/// No exception may leave: the host is not written in C++.
extern "C" LAC_DISCON_EXPORT void LAC_DISCON_CALL DISCON(float* avrSWAP, int* aviFAIL,
                                                         const char* accINFILE, char* avcOUTNAME,
                                                         char* avcMSG) {
  Records swap(avrSWAP);
  std::string message;
  try {
    *aviFAIL = call(swap, text_of(accINFILE, swap.whole(kInFileLength)),
                    text_of(avcOUTNAME, swap.whole(kOutNameLength)), message);
  } catch (const std::exception& e) {
    *aviFAIL = -1;
    message = std::string("speed_supervisor: ") + e.what();
  }
  const int capacity = swap.whole(kMessageCapacity);  // the terminator included
  if (capacity > 0) {
    std::snprintf(avcMSG, static_cast<std::size_t>(capacity), "%s", message.c_str());
  }
}
