// SPDX-License-Identifier: Apache-2.0
// A host trace: every call of a run as the host made it and the controller answered it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace lac {

/// One call. Arrays hold the records that were known, record n at n - 1.
struct TraceCall {
  int fail_before = 0;    // aviFAIL as the host left it
  int fail = 0;           // as the controller set it
  bool answered = false;  // false: the controller did not come back (last call of a trace)
  std::string in_file;
  std::string out_name;
  std::string message;  // with fail != 0 alone
  std::vector<float> sent;
  std::vector<float> answer;
};

/// The records of one array, coded as changes since they were last looked at: which ones, unless
/// they are those of the set before, and for each the difference of its bits, taken as an integer
/// that rises with the value, to the straight line through the last two values it had. About two
/// bytes for a smooth signal, exact for every bit pattern.
class RecordCoder {
 public:
  explicit RecordCoder(std::size_t records) : now_(records), last_(records), before_(records) {}

  using Set = std::vector<std::size_t>;  // of positions that changed together

  const std::vector<float>& now() const { return now_; }

  void code(const float* array, Set& set, std::string& out);
  /// False at the end of the bytes or if they cannot be such a code. `at` moves behind it.
  bool decode(std::string_view bytes, std::size_t& at, Set& set);

 private:
  bool decode_set(std::string_view bytes, std::size_t& at, Set& set) const;
  std::int64_t line(std::size_t i) const { return 2 * last_[i] - before_[i]; }
  void take(std::size_t i, std::int64_t value);

  std::vector<float> now_;
  std::vector<std::int64_t> last_, before_;
};

/// File format, version 1 (README.md). Each half of a call is written through at once: when the
/// host dies, the trace holds the call it died in.
class TraceWriter {
 public:
  /// Throws lac::Error if the file cannot be made.
  TraceWriter(const std::filesystem::path& file, int records);

  void sent(const float* array, int fail, std::string_view in_file, std::string_view out_name);
  void answered(const float* array, int fail, std::string_view message);

 private:
  void put_text(int place, std::string_view text);
  void flush();

  std::ofstream file_;
  RecordCoder coder_;
  RecordCoder::Set sent_set_, answered_set_;
  std::array<std::string, 3> texts_;
  std::string bytes_;
};

class TraceReader {
 public:
  /// Throws lac::Error: no file, not a trace, another version.
  explicit TraceReader(const std::filesystem::path& file);

  int records() const { return records_; }
  const std::string& compiler() const { return compiler_; }  // of the library that recorded

  /// The next call; false at the end. Throws lac::Error if the file is damaged.
  bool next(TraceCall& call);

 private:
  bool get_text(int place, std::string& text);
  [[noreturn]] void fail(const std::string& problem) const;

  std::filesystem::path file_;
  std::string bytes_;
  std::size_t at_ = 0;
  int records_ = 0;
  std::string compiler_;
  RecordCoder coder_{0};
  RecordCoder::Set sent_set_, answered_set_;
  std::array<std::string, 3> texts_;
};

}  // namespace lac
