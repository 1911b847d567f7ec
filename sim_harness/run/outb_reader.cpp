// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/outb_reader.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr std::int16_t kFormatId = 4;
constexpr std::int32_t kMostChannels = 100000;

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file), in_(file, std::ios::binary) {
    if (!in_) fail("cannot be opened");
  }

  template <typename T>
  T take() {
    T value{};
    read(&value, sizeof value);
    return value;
  }
  template <typename T>
  std::vector<T> take(std::size_t count) {
    std::vector<T> values(count);
    read(values.data(), count * sizeof(T));
    return values;
  }
  std::string text(std::size_t length) {
    const std::vector<char> bytes = take<char>(length);
    const std::string s(bytes.begin(), bytes.end());
    return s.substr(0, s.find_last_not_of(' ') + 1);
  }
  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(file_.string() + ": " + problem);
  }

 private:
  void read(void* target, std::size_t bytes) {
    if (!in_.read(static_cast<char*>(target), static_cast<std::streamsize>(bytes))) {
      fail("ends too early for an OpenFAST output file");
    }
  }

  std::filesystem::path file_;
  std::ifstream in_;
};

std::string without_brackets(const std::string& unit) {
  return unit.size() >= 2 && unit.front() == '(' ? unit.substr(1, unit.size() - 2) : unit;
}

std::vector<TableChannel> read_channels(Reader& in, std::size_t count, std::size_t name_length) {
  in.text(name_length);  // Time
  std::vector<TableChannel> channels(count);
  for (TableChannel& c : channels) c.name = in.text(name_length);
  in.text(name_length);
  for (TableChannel& c : channels) c.unit = without_brackets(in.text(name_length));
  return channels;
}

}  // namespace

Recording read_outb(const std::filesystem::path& file) {
  Reader in(file);
  const auto id = in.take<std::int16_t>();
  if (id != kFormatId) {
    in.fail("found format id " + std::to_string(id) + ", expected an .outb file of id 4");
  }
  const auto name_length = in.take<std::int16_t>();
  const auto channel_count = in.take<std::int32_t>();
  const auto rows = in.take<std::int32_t>();
  if (name_length < 1 || channel_count < 1 || channel_count > kMostChannels || rows < 0) {
    in.fail("has sizes that cannot be");
  }
  const auto start_s = in.take<double>();
  const auto step_s = in.take<double>();
  const auto n = static_cast<std::size_t>(channel_count);
  const std::vector<float> scale = in.take<float>(n);
  const std::vector<float> offset = in.take<float>(n);
  in.text(static_cast<std::size_t>(in.take<std::int32_t>()));
  Recording recording(read_channels(in, n, static_cast<std::size_t>(name_length)), start_s, step_s,
                      static_cast<std::size_t>(rows));
  std::vector<float> row(n);
  for (std::int32_t i = 0; i < rows; ++i) {
    const std::vector<std::int16_t> packed = in.take<std::int16_t>(n);
    for (std::size_t k = 0; k < n; ++k) {
      row[k] = (static_cast<float>(packed[k]) - offset[k]) / scale[k];
    }
    recording.append(row.data());
  }
  return recording;
}

}  // namespace lac::sim
