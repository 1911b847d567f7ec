// SPDX-License-Identifier: Apache-2.0
#include "tools/host_probe/host_trace.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

using test::error_text;
using testing::HasSubstr;

constexpr int kRecords = 50;

std::vector<std::uint32_t> bits(const std::vector<float>& array) {
  std::vector<std::uint32_t> all;
  for (const float x : array) all.push_back(std::bit_cast<std::uint32_t>(x));
  return all;
}

class HostTraceTest : public testing::Test {
 protected:
  /// Writes what the calls say.
  void write(const std::vector<TraceCall>& calls) {
    TraceWriter writer(file_, kRecords);
    for (const TraceCall& c : calls) {
      writer.sent(c.sent.data(), c.fail_before, c.in_file, c.out_name);
      if (c.answered) writer.answered(c.answer.data(), c.fail, c.message);
    }
  }
  int read_all() {
    TraceReader reader(file_);
    TraceCall call;
    int calls = 0;
    while (reader.next(call)) ++calls;
    return calls;
  }

  test::TempFolder folder_;
  std::string file_ = folder_.file("a.lactrace");
};

/// A call in which a random part of the records has random bits, special values among them.
TraceCall random_call(std::mt19937& random, const std::vector<float>& before) {
  TraceCall c;
  const auto change = [&random](std::vector<float> array) {
    constexpr float kSpecial[] = {0.0F, -0.0F, std::numeric_limits<float>::infinity(),
                                  std::numeric_limits<float>::denorm_min(),
                                  std::numeric_limits<float>::lowest()};
    for (float& x : array) {
      const auto r = random();
      if (r % 4 == 0) x = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
      if (r % 16 == 1) x = kSpecial[random() % 5];
    }
    return array;
  };
  c.sent = change(before);
  c.answer = change(c.sent);
  c.answered = true;
  c.fail_before = static_cast<int>(random() % 3) - 1;
  c.fail = static_cast<int>(random());
  c.in_file = "input " + std::to_string(random() % 3);
  c.out_name = std::string(random() % 200, 'r');
  c.message = random() % 2 == 0 ? "" : "text";
  return c;
}

// Every bit pattern, every text and every number comes back.
TEST_F(HostTraceTest, RoundTrip) {
  std::mt19937 random(1);
  std::vector<TraceCall> calls;
  std::vector<float> last(kRecords);
  for (int n = 0; n < 300; ++n) {
    calls.push_back(random_call(random, last));
    last = calls.back().answer;
  }
  write(calls);
  TraceReader reader(file_);
  EXPECT_EQ(reader.records(), kRecords);
  EXPECT_EQ(reader.compiler(), __VERSION__);
  for (const TraceCall& expected : calls) {
    TraceCall c;
    ASSERT_TRUE(reader.next(c));
    EXPECT_EQ(bits(c.sent), bits(expected.sent));
    EXPECT_EQ(bits(c.answer), bits(expected.answer));
    EXPECT_EQ(c.fail_before, expected.fail_before);
    EXPECT_EQ(c.fail, expected.fail);
    EXPECT_EQ(c.in_file, expected.in_file);
    EXPECT_EQ(c.out_name, expected.out_name);
    EXPECT_EQ(c.message, expected.message);
  }
  TraceCall none;
  EXPECT_FALSE(reader.next(none));
}

// Smooth signals take about two bytes a value: 40 sines of 0.3 Hz at 80 calls a second.
TEST_F(HostTraceTest, SmoothSignalsAreSmall) {
  constexpr int kSignals = 40, kCalls = 1000;
  std::vector<TraceCall> calls(kCalls);
  for (int n = 0; n < kCalls; ++n) {
    TraceCall& c = calls[static_cast<std::size_t>(n)];
    c.sent.resize(kRecords);
    for (int i = 0; i < kSignals; ++i) {
      c.sent[static_cast<std::size_t>(i)] =
          static_cast<float>(1.0e5 * std::sin(2.0 * 3.14159 * 0.3 * n / 80.0 + i));
    }
    c.answer = c.sent;
    c.answered = true;
  }
  write(calls);
  const auto size = static_cast<double>(std::filesystem::file_size(file_));
  EXPECT_LT(size / (kCalls * kSignals), 2.5);
  EXPECT_EQ(read_all(), kCalls);
}

// The host died in a call: what it had sent is there.
TEST_F(HostTraceTest, UnansweredCall) {
  std::mt19937 random(2);
  TraceCall first = random_call(random, std::vector<float>(kRecords));
  TraceCall second = random_call(random, first.answer);
  second.answered = false;
  write({first, second});
  TraceReader reader(file_);
  TraceCall c;
  ASSERT_TRUE(reader.next(c));
  EXPECT_TRUE(c.answered);
  ASSERT_TRUE(reader.next(c));
  EXPECT_FALSE(c.answered);
  EXPECT_EQ(bits(c.sent), bits(second.sent));
  EXPECT_FALSE(reader.next(c));
}

// A file cut off anywhere or with any byte changed gives fewer calls or an error, nothing else.
TEST_F(HostTraceTest, DamagedFiles) {
  std::mt19937 random(3);
  const TraceCall first = random_call(random, std::vector<float>(kRecords));
  write({first, random_call(random, first.answer)});
  const std::string whole = folder_.read("a.lactrace");
  int tried = 0, refused = 0;
  for (std::size_t n = 0; n < whole.size(); n += 5) {
    ++tried;
    folder_.write("a.lactrace", whole.substr(0, n));
    const std::string text = error_text([&] { EXPECT_LE(read_all(), 2); });
    refused += text != "no error" ? 1 : 0;
    std::string changed = whole;
    changed[n] = static_cast<char>(changed[n] ^ (1 << (n % 8)));
    folder_.write("a.lactrace", changed);
    static_cast<void>(error_text([&] { read_all(); }));
  }
  EXPECT_GE(refused, tried - 3);  // a cut behind a header, a call or half of one is none
}

TEST_F(HostTraceTest, OtherFiles) {
  EXPECT_THAT(error_text([&] { TraceReader(folder_.file("none")); }), HasSubstr("cannot be read"));
  EXPECT_THAT(error_text([&] { TraceReader(folder_.write("x", "hello")); }),
              HasSubstr("x: is not a host trace"));
  EXPECT_THAT(error_text([&] { TraceReader(folder_.write("x", "LACTRACE\x02")); }),
              HasSubstr("has version 2, expected 1"));
  EXPECT_THAT(error_text([&] { TraceWriter(folder_.file("not/there"), 164); }),
              HasSubstr("there: the trace cannot be written"));
}

}  // namespace
}  // namespace lac
