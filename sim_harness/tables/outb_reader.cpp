// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tables/outb_reader.hpp"

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "sim_harness/tables/text_number.hpp"
#include "sim_harness/tables/time_axis.hpp"

namespace lac::sim {
namespace {

constexpr std::int16_t kWithTime = 1;
constexpr std::int16_t kUnpacked = 3;
constexpr std::int16_t kWithNameLength = 4;
constexpr std::int16_t kShortName = 10;
constexpr std::int32_t kMostChannels = 100000;

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file), in_(file, std::ios::binary) {
    std::error_code problem;
    left_ = std::filesystem::file_size(file, problem);
    if (!in_ || problem) fail("cannot be opened");
  }

  template <typename T>
  T take() {
    T value{};
    read(&value, sizeof value);
    return value;
  }
  template <typename T>
  std::vector<T> take(std::size_t count) {
    require(count * sizeof(T));
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
  /// Before memory is taken for what a header promises.
  void require(std::uintmax_t bytes) const {
    if (bytes <= left_) return;
    fail("ends too early for an OpenFAST output file: found " + std::to_string(left_) +
         " bytes where its header tells of " + std::to_string(bytes));
  }

 private:
  void read(void* target, std::size_t bytes) {
    require(bytes);
    if (!in_.read(static_cast<char*>(target), static_cast<std::streamsize>(bytes)))
      fail("cannot be read");
    left_ -= bytes;
  }

  std::filesystem::path file_;
  std::ifstream in_;
  std::uintmax_t left_ = 0;  // bytes not read yet
};

struct Head {
  std::int16_t id = 0;
  std::int16_t name_length = kShortName;
  std::size_t channels = 0;
  std::size_t rows = 0;
  double time_a = 0.0;  // start and step, or scale and offset of the times (id 1)
  double time_b = 0.0;
  std::vector<float> scale;
  std::vector<float> offset;
};

Head read_head(Reader& in) {
  Head h;
  h.id = in.take<std::int16_t>();
  if (h.id < kWithTime || h.id > kWithNameLength) {
    in.fail("found format id " + std::to_string(h.id) + ", expected an .outb file of id 1 to 4");
  }
  if (h.id == kWithNameLength) h.name_length = in.take<std::int16_t>();
  const auto channels = in.take<std::int32_t>();
  const auto rows = in.take<std::int32_t>();
  if (h.name_length < 1 || channels < 1 || channels > kMostChannels || rows < 0) {
    in.fail("has sizes that cannot be");
  }
  h.channels = static_cast<std::size_t>(channels);
  h.rows = static_cast<std::size_t>(rows);
  h.time_a = in.take<double>();
  h.time_b = in.take<double>();
  if (h.id == kUnpacked) return h;
  h.scale = in.take<float>(h.channels);
  h.offset = in.take<float>(h.channels);
  return h;
}

std::vector<TableChannel> read_channels(Reader& in, const Head& h) {
  const auto length = in.take<std::int32_t>();
  if (length < 0) in.fail("has sizes that cannot be");
  in.text(static_cast<std::size_t>(length));  // description
  const auto name_length = static_cast<std::size_t>(h.name_length);
  in.text(name_length);  // Time
  std::vector<TableChannel> channels(h.channels);
  for (TableChannel& c : channels) c.name = in.text(name_length);
  in.text(name_length);
  for (TableChannel& c : channels) c.unit = without_brackets(in.text(name_length));
  return channels;
}

TimeAxis read_times(Reader& in, const Head& h) {
  if (h.id != kWithTime) return {h.time_a, h.time_b, {}};
  std::vector<double> times_s;
  for (const std::int32_t packed : in.take<std::int32_t>(h.rows))
    times_s.push_back((packed - h.time_b) / h.time_a);
  return time_axis_of(times_s, [&](std::size_t row, const std::string& problem) {
    in.fail("row " + std::to_string(row + 1) + ": " + problem);
  });
}

}  // namespace

Recording read_outb(const std::filesystem::path& file) {
  Reader in(file);
  const Head h = read_head(in);
  std::vector<TableChannel> channels = read_channels(in, h);
  const TimeAxis axis = read_times(in, h);
  if (axis.has_gaps()) in.fail("rows are missing: its times are not equidistant");
  in.require(std::uintmax_t{h.rows} * h.channels *
             (h.id == kUnpacked ? sizeof(double) : sizeof(std::int16_t)));
  Recording recording(std::move(channels), axis.start_s, axis.step_s, h.rows);
  std::vector<float> row(h.channels);
  for (std::size_t i = 0; i < h.rows; ++i) {
    if (h.id == kUnpacked) {
      const std::vector<double> values = in.take<double>(h.channels);
      for (std::size_t k = 0; k < h.channels; ++k) row[k] = static_cast<float>(values[k]);
    } else {
      const std::vector<std::int16_t> packed = in.take<std::int16_t>(h.channels);
      for (std::size_t k = 0; k < h.channels; ++k)
        row[k] = (static_cast<float>(packed[k]) - h.offset[k]) / h.scale[k];
    }
    recording.append(row.data());
  }
  return recording;
}

}  // namespace lac::sim
