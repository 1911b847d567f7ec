// SPDX-License-Identifier: Apache-2.0
// A controller that does what its input file says, one command per line, read anew at each call:
// it has no state of its own, so one image serves any number of instances.
//
//   log FILE                  appends "<name> <status>" (name: from the root name) to FILE
//   set RECORD VALUE          at every call of status 0 or 1
//   add RECORD FROM VALUE     RECORD = record FROM + VALUE
//   count RECORD              RECORD = RECORD + 1
//   nan RECORD STATUS         not a number at calls of that status
//   fail STATUS TEXT          aviFAIL = -1 and the text
//   warn STATUS TEXT          aviFAIL = 1 and the text
//   warn_at RECORD LO HI TEXT aviFAIL = 1 while LO <= RECORD <= HI
//   warn_time                 aviFAIL = 1, another text at each call
//   echo FILE                 what it was called with
//   name_inside               aviFAIL = 1, the counted input file name in the middle of the text
//   full_message              aviFAIL = 1, every character of the message, no terminator
//   below | above | message | root   writes one place too far
//   leave_rubbish             aviFAIL and root name as a careless library leaves them
//   throw                     a C++ exception
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "core/discon_abi.h"

const int LAC_DISCON_REENTRANT = 1;

namespace {

constexpr auto kAppend = std::ios::app | std::ios::binary;  // equal files on every system

struct Call {
  float* swap;
  int* fail;
  const char* in_file;
  char* out_name;
  char* message;

  float& record(int n) const { return swap[n - 1]; }
  int integer(int n) const { return static_cast<int>(std::lround(record(n))); }
  int status() const { return integer(1); }
  std::string file() const { return std::string(in_file, std::strlen(in_file)); }
  std::string name() const {
    const std::string root(out_name);
    const std::size_t end = root.rfind('.');
    return root.substr(root.rfind('.', end - 1) + 1, end - root.rfind('.', end - 1) - 1);
  }
  void say(int level, const std::string& text) const {
    *fail = level;
    std::strncpy(message, text.c_str(), static_cast<std::size_t>(integer(49)) - 1);
  }
};

std::string rest_of(std::istringstream& line) {
  std::string text;
  std::getline(line >> std::ws, text);
  return text;
}

void echo(const Call& c, const std::string& file) {
  std::ofstream out(file, kAppend);
  out << "in=" << std::string(c.in_file, static_cast<std::size_t>(c.integer(50)) - 1)
      << " end=" << static_cast<int>(c.in_file[c.integer(50) - 1])
      << " out=" << std::string(c.out_name, static_cast<std::size_t>(c.integer(51)) - 1)
      << " end=" << static_cast<int>(c.out_name[c.integer(51) - 1]);
  bool zeroed = true;
  for (int i = 0; i < c.integer(49); ++i) zeroed = zeroed && c.message[i] == '\0';
  out << " zeroed=" << zeroed << " fail=" << *c.fail;
  for (const int n : {1, 49, 62, 63, 64, 65, 66, 129}) out << " " << n << "=" << c.record(n);
  out << "\n";
}

void misbehave(const Call& c, const std::string& what) {
  if (what == "below") c.swap[-1] = 1.0f;
  if (what == "above") c.swap[c.integer(129)] = 1.0f;
  if (what == "message") c.message[c.integer(49)] = 'x';
  if (what == "root") c.out_name[c.integer(64)] = 'x';
  if (what == "throw") throw std::runtime_error("toy");
  if (what == "full_message") {
    *c.fail = 1;
    std::memset(c.message, 'm', static_cast<std::size_t>(c.integer(49)));
  }
  if (what == "name_inside") {
    c.say(1, "in \"" + c.file());
    std::strcpy(c.message + 4 + c.file().size() + 1, "\": line 7 is wrong  \n");
  }
  if (what == "leave_rubbish") {
    std::strcpy(c.message, "old text that nobody asked for");
    std::strcpy(c.out_name, "rubbish:A;more:A;");
    c.record(65) = 2.0f;
  }
}

void obey(const Call& c, const std::string& command) {
  std::istringstream line(command);
  std::string word, text;
  int a = 0, b = 0;
  float value = 0.0f;
  line >> word;
  const bool runs = c.status() == 0 || c.status() == 1;
  if (word == "log" && line >> text) {
    std::ofstream(text, kAppend) << c.name() << " " << c.status() << "\n";
  } else if (word == "echo" && line >> text) {
    echo(c, text);
  } else if (word == "set" && line >> a >> value) {
    if (runs) c.record(a) = value;
  } else if (word == "add" && line >> a >> b >> value) {
    if (runs) c.record(a) = c.record(b) + value;
  } else if (word == "count" && line >> a) {
    if (runs) c.record(a) += 1.0f;
  } else if (word == "nan" && line >> a >> b) {
    if (c.status() == b) c.record(a) = std::numeric_limits<float>::quiet_NaN();
  } else if (word == "fail" && line >> a) {
    if (c.status() == a) c.say(-1, rest_of(line));
  } else if (word == "warn" && line >> a) {
    if (c.status() == a) c.say(1, rest_of(line));
  } else if (word == "warn_at" && line >> a >> value >> b) {
    if (c.record(a) >= value && c.record(a) <= static_cast<float>(b)) c.say(1, rest_of(line));
  } else if (word == "warn_time") {
    if (c.status() == 1) c.say(1, "it is now " + std::to_string(c.record(2)));
  } else {
    misbehave(c, word);
  }
}

}  // namespace

extern "C" LAC_DISCON_EXPORT void LAC_DISCON_CALL DISCON(float* swap, int* fail,
                                                         const char* in_file, char* out_name,
                                                         char* message) {
  const Call call{swap, fail, in_file, out_name, message};
  const int status = call.status();  // at -8 and -9 the file is the checkpoint
  if (status == -8 || status == -9) {
    std::ofstream(call.file() + ".toy", kAppend) << call.name() << " " << status << "\n";
    return;
  }
  std::ifstream script{call.file()};
  std::string line;
  while (std::getline(script, line)) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty()) obey(call, line);
  }
}
