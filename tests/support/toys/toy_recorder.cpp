// SPDX-License-Identifier: Apache-2.0
// A controller that does what its input file says and writes down how it was called: one line
// per call into "<output name>.seen" at the last call. Input: "key value" lines,
//   pitch_rad, torque_Nm    demands
//   warn_at, fail_at        number of the call (from 0) that returns a warning or a failure
//   fail_at_last 1          the last call fails
//   put <record> <value>    written in every call
//   quiet 1                 writes nothing down
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/discon_abi.h"

namespace {

struct Probe {
  double pitch_rad = 0.0;
  double torque_Nm = 0.0;
  int warn_at = -1;
  int fail_at = -1;
  bool fail_at_last = false;
  bool quiet = false;
  std::vector<std::pair<int, double>> puts;
  int calls = 0;
  std::ostringstream seen;
};
Probe* probe = nullptr;

void read(const char* file) {
  std::ifstream in(file);
  std::string key;
  while (in >> key) {
    if (key == "pitch_rad") in >> probe->pitch_rad;
    if (key == "torque_Nm") in >> probe->torque_Nm;
    if (key == "warn_at") in >> probe->warn_at;
    if (key == "fail_at") in >> probe->fail_at;
    if (key == "fail_at_last") in >> probe->fail_at_last;
    if (key == "quiet") in >> probe->quiet;
    if (key == "put") {
      int record = 0;
      double value = 0.0;
      in >> record >> value;
      probe->puts.emplace_back(record, value);
    }
  }
}

void note_call(const float* swap, int fail_on_entry, const char* in_file, const char* out_name,
               const char* message) {
  const bool not_all_zero_behind =
      std::any_of(out_name + std::strlen(out_name), out_name + std::strlen(out_name) + 16,
                  [](char c) { return c != '\0'; });
  probe->seen << swap[0] << ' ' << swap[1] << ' ' << fail_on_entry << ' ' << std::strlen(in_file)
              << ' ' << std::strlen(out_name) << ' ' << std::strlen(message) << ' '
              << not_all_zero_behind;
  for (const int record : {3,  4,  11, 15, 20, 21, 23, 27,  35,  42,   45,   47,   49,  50,
                           51, 53, 61, 62, 63, 64, 66, 129, 150, 1000, 1101, 1102, 3300}) {
    probe->seen << ' ' << record << '=' << swap[record - 1];
  }
  probe->seen << '\n';
}

}  // namespace

extern "C" LAC_DISCON_EXPORT void DISCON(float* swap, int* fail, const char* in_file,
                                         char* out_name, char* message) {
  const int status = static_cast<int>(std::lround(swap[0]));
  if (status == LAC_STATUS_FIRST) {
    probe = new Probe;
    read(in_file);
  }
  if (!probe->quiet) note_call(swap, *fail, in_file, out_name, message);
  swap[149] += 1.0F;  // a private record: does it survive?
  *fail = 0;
  for (const int record : {42, 43, 44, 45}) swap[record - 1] = static_cast<float>(probe->pitch_rad);
  swap[46] = static_cast<float>(probe->torque_Nm);
  for (const auto& [record, value] : probe->puts) swap[record - 1] = static_cast<float>(value);
  if (probe->calls == probe->warn_at) {
    *fail = 1;
    std::snprintf(message, 100, "probe: a warning");
  }
  if (probe->calls == probe->fail_at || (status == LAC_STATUS_LAST && probe->fail_at_last)) {
    *fail = -1;
    std::snprintf(message, 100, "probe: told to fail");
  }
  ++probe->calls;
  if (status == LAC_STATUS_LAST) {
    if (!probe->quiet) std::ofstream(std::string(out_name) + ".seen") << probe->seen.str();
    delete probe;
    probe = nullptr;
  }
}
