// SPDX-License-Identifier: Apache-2.0
#include "tools/host_probe/host_trace.hpp"

#include <bit>
#include <cstring>
#include <iterator>
#include <utility>

#include "core/error.hpp"

namespace lac {
namespace {

constexpr std::string_view kMagic = "LACTRACE";
constexpr std::uint64_t kVersion = 1;
constexpr std::uint64_t kMostRecords = 1000000;
constexpr std::uint64_t kLargestDifference = std::uint64_t{1} << 36;  // of any two floats, folded
enum Text { kInFile, kOutName, kMessage };

/// Seven bits a byte, lowest first; the eighth says that more follow.
void put_number(std::string& out, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) out.push_back(static_cast<char>(value | 0x80));
  out.push_back(static_cast<char>(value));
}

bool get_number(std::string_view bytes, std::size_t& at, std::uint64_t& value) {
  value = 0;
  for (int shift = 0; shift < 64 && at < bytes.size(); shift += 7) {
    const auto byte = static_cast<unsigned char>(bytes[at++]);
    value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
    if (byte < 0x80) return true;
  }
  return false;
}

/// 0, -1, 1, -2 ... as 0, 1, 2, 3 ...
std::uint64_t folded(std::int64_t value) {
  return (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
}
std::int64_t unfolded(std::uint64_t value) {
  return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
}

/// An integer that rises with the number; -0 lies below 0.
std::int64_t ordered(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const auto magnitude = static_cast<std::int64_t>(bits & 0x7fffffffU);
  return bits >> 31 == 0 ? magnitude : -1 - magnitude;
}
float from_ordered(std::int64_t value) {
  const auto magnitude = static_cast<std::uint32_t>(value >= 0 ? value : -1 - value);
  return std::bit_cast<float>(magnitude | (value >= 0 ? 0U : 0x80000000U));
}
bool is_float(std::int64_t value) {
  return value >= -0x80000000LL && value <= 0x7fffffffLL;
}

}  // namespace

void RecordCoder::take(std::size_t i, std::int64_t value) {
  before_[i] = last_[i];
  last_[i] = value;
  now_[i] = from_ordered(value);
}

void RecordCoder::code(const float* array, Set& set, std::string& out) {
  Set changed;
  for (std::size_t i = 0; i < now_.size(); ++i) {
    if (ordered(array[i]) != last_[i]) changed.push_back(i);
  }
  put_number(out, changed == set ? 0 : changed.size() + 1);
  if (changed != set) {
    std::size_t next = 0;
    for (const std::size_t i : changed) {
      put_number(out, i - next);
      next = i + 1;
    }
    set = std::move(changed);
  }
  for (const std::size_t i : set) {
    put_number(out, folded(ordered(array[i]) - line(i)));
    take(i, ordered(array[i]));
  }
}

bool RecordCoder::decode_set(std::string_view bytes, std::size_t& at, Set& set) const {
  std::uint64_t count = 0, gap = 0, next = 0;
  if (!get_number(bytes, at, count) || count > now_.size() + 1) return false;
  if (count == 0) return true;
  set.clear();
  for (std::uint64_t n = 1; n < count; ++n) {
    if (!get_number(bytes, at, gap) || gap >= now_.size() || next + gap >= now_.size()) {
      return false;
    }
    set.push_back(next + gap);
    next = set.back() + 1;
  }
  return true;
}

bool RecordCoder::decode(std::string_view bytes, std::size_t& at, Set& set) {
  if (!decode_set(bytes, at, set)) return false;
  for (const std::size_t i : set) {
    std::uint64_t difference = 0;
    if (!get_number(bytes, at, difference) || difference > kLargestDifference) return false;
    const std::int64_t value = line(i) + unfolded(difference);
    if (!is_float(value)) return false;
    take(i, value);
  }
  return true;
}

TraceWriter::TraceWriter(const std::filesystem::path& file, int records)
    : file_(file, std::ios::binary | std::ios::trunc), coder_(static_cast<std::size_t>(records)) {
  bytes_ = kMagic;
  put_number(bytes_, kVersion);
  put_number(bytes_, static_cast<std::uint64_t>(records));
  const std::string_view compiler = __VERSION__;
  put_number(bytes_, compiler.size());
  bytes_ += compiler;
  flush();
  if (!file_) throw Error(file.string() + ": the trace cannot be written: is there such a folder?");
}

void TraceWriter::put_text(int place, std::string_view text) {
  std::string& last = texts_[static_cast<std::size_t>(place)];
  if (text == last) return put_number(bytes_, 0);
  put_number(bytes_, text.size() + 1);
  bytes_ += text;
  last = text;
}

void TraceWriter::flush() {
  file_.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
  file_.flush();
  bytes_.clear();
}

void TraceWriter::sent(const float* array, int fail, std::string_view in_file,
                       std::string_view out_name) {
  put_number(bytes_, folded(fail));
  put_text(kInFile, in_file);
  put_text(kOutName, out_name);
  coder_.code(array, sent_set_, bytes_);
  flush();
}

void TraceWriter::answered(const float* array, int fail, std::string_view message) {
  put_number(bytes_, folded(fail));
  put_text(kMessage, message);
  coder_.code(array, answered_set_, bytes_);
  flush();
}

TraceReader::TraceReader(const std::filesystem::path& file) : file_(file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) fail("cannot be read: is there such a file?");
  bytes_.assign(std::istreambuf_iterator<char>(in), {});
  if (!bytes_.starts_with(kMagic)) fail("is not a host trace (it does not begin with LACTRACE)");
  at_ = kMagic.size();
  std::uint64_t version = 0, records = 0, length = 0;
  if (!get_number(bytes_, at_, version)) fail("is cut off in its header");
  if (version != kVersion) {
    fail("has version " + std::to_string(version) + ", expected " + std::to_string(kVersion));
  }
  if (!get_number(bytes_, at_, records) || !get_number(bytes_, at_, length) ||
      records > kMostRecords || length > bytes_.size() - at_) {
    fail("is cut off in its header");
  }
  compiler_ = bytes_.substr(at_, length);
  at_ += length;
  records_ = static_cast<int>(records);
  coder_ = RecordCoder(records);
}

bool TraceReader::get_text(int place, std::string& text) {
  std::string& last = texts_[static_cast<std::size_t>(place)];
  std::uint64_t length = 0;
  if (!get_number(bytes_, at_, length) || length > bytes_.size() - at_ + 1) return false;
  if (length > 0) {
    last = bytes_.substr(at_, length - 1);
    at_ += length - 1;
  }
  text = last;
  return true;
}

bool TraceReader::next(TraceCall& call) {
  if (at_ == bytes_.size()) return false;
  std::uint64_t number = 0;
  const bool sent = get_number(bytes_, at_, number) && get_text(kInFile, call.in_file) &&
                    get_text(kOutName, call.out_name) && coder_.decode(bytes_, at_, sent_set_);
  if (!sent) fail("is damaged or cut off near byte " + std::to_string(at_));
  call.fail_before = static_cast<int>(unfolded(number));
  call.sent = coder_.now();
  call.answered = at_ < bytes_.size();
  if (!call.answered) return true;
  if (!get_number(bytes_, at_, number) || !get_text(kMessage, call.message) ||
      !coder_.decode(bytes_, at_, answered_set_)) {
    fail("is damaged or cut off near byte " + std::to_string(at_));
  }
  call.fail = static_cast<int>(unfolded(number));
  call.answer = coder_.now();
  return true;
}

void TraceReader::fail(const std::string& problem) const {
  throw Error(file_.string() + ": " + problem);
}

}  // namespace lac
