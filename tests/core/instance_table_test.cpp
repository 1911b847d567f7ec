// SPDX-License-Identifier: Apache-2.0
#include "core/instance_table.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace lac {
namespace {

struct Turbine {
  int calls = 0;
};
using Table = InstanceTable<Turbine>;

class Instances : public testing::Test {
 protected:
  bool enter(float* array, const char* in, const char* out, Turbine& t) {
    return table->enter(caller_key(array, in, out), &t);
  }
  Turbine* find(float* array, const char* in, const char* out) {
    return table->find(caller_key(array, in, out));
  }
  std::unique_ptr<Table> table = std::make_unique<Table>();
  float x[4] = {};
  Turbine a, b;
};

TEST_F(Instances, AddressAndStrings) {
  EXPECT_EQ(find(&x[0], "in", "out"), nullptr);
  enter(&x[0], "in", "T1", a);
  enter(&x[1], "in", "T2", b);
  EXPECT_EQ(find(&x[0], "in", "T1"), &a);
  EXPECT_EQ(find(&x[1], "in", "T2"), &b);
  table->leave(&a);
  EXPECT_EQ(find(&x[0], "in", "T1"), nullptr);
  EXPECT_EQ(find(&x[1], "in", "T2"), &b);
}

// Several rotors with the same names differ by their arrays.
TEST_F(Instances, SameStringsDifferentArrays) {
  enter(&x[0], "in", "out", a);
  enter(&x[1], "in", "out", b);
  EXPECT_EQ(find(&x[0], "in", "out"), &a);
  EXPECT_EQ(find(&x[1], "in", "out"), &b);
  EXPECT_EQ(find(&x[2], "in", "out"), nullptr);  // moved, but which?
}

// An array that moves is followed as long as the strings are unique.
TEST_F(Instances, MovingArray) {
  enter(&x[0], "in", "T1", a);
  enter(&x[1], "in", "T2", b);
  EXPECT_EQ(find(&x[2], "in", "T1"), &a);
  EXPECT_EQ(find(&x[3], "in", "T1"), &a);
  EXPECT_EQ(find(&x[1], "in", "T2"), &b);
  EXPECT_EQ(find(&x[0], "other", "T3"), nullptr);  // the old address is forgotten
}

// Checkpoint calls carry another file name: found by the array; two libraries of one chain share
// the array and differ in the root name.
TEST_F(Instances, OtherFileName) {
  enter(&x[0], "in_a", "case.a", a);
  EXPECT_EQ(find(&x[0], "case.chkp", "case.a"), &a);
  EXPECT_EQ(find(&x[0], "case.chkp", "renamed"), &a);
  enter(&x[0], "in_b", "case.b", b);
  EXPECT_EQ(find(&x[0], "case.chkp", "case.a"), &a);
  EXPECT_EQ(find(&x[0], "case.chkp", "case.b"), &b);
  EXPECT_EQ(find(&x[0], "case.chkp", "renamed"), nullptr);
  EXPECT_EQ(find(&x[1], "case.chkp", "case.a"), nullptr);
}

// A run that was never ended is taken out by its own key alone, not by half of it.
TEST_F(Instances, TakeOut) {
  enter(&x[0], "in", "out", a);
  enter(&x[1], "in", "out", b);
  EXPECT_EQ(table->take(caller_key(&x[2], "in", "out")), nullptr);
  EXPECT_EQ(table->take(caller_key(&x[0], "in", "other")), nullptr);
  EXPECT_EQ(table->take(caller_key(&x[0], "in", "out")), &a);
  EXPECT_EQ(table->take(caller_key(&x[0], "in", "out")), nullptr);
  EXPECT_EQ(find(&x[1], "in", "out"), &b);
}

TEST_F(Instances, FullTableSaysSo) {
  std::vector<float> arrays(Table::kCapacity + 1);
  std::vector<Turbine> turbines(Table::kCapacity + 1);
  for (std::size_t i = 0; i < Table::kCapacity; ++i) {
    EXPECT_TRUE(enter(&arrays[i], "in", "out", turbines[i]));
  }
  EXPECT_FALSE(enter(&arrays.back(), "in", "out", turbines.back()));
  table->leave(&turbines[5]);
  EXPECT_TRUE(enter(&arrays.back(), "in", "out", turbines.back()));
  EXPECT_EQ(find(&arrays.back(), "in", "out"), &turbines.back());
}

// Turbines come, call and go at the same time; nobody ever meets another's instance.
TEST_F(Instances, ManyThreads) {
  std::atomic<int> strangers{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([&, t] {
      const std::string out = std::string("T").append(std::to_string(t));
      for (int run = 0; run < 200; ++run) {
        float array = 0.0f;
        Turbine mine;
        const CallerKey key = caller_key(&array, "in", out);
        table->enter(key, &mine);
        for (int i = 0; i < 50; ++i) {
          Turbine* found = table->find(key);
          if (found != &mine) ++strangers;
          if (found != nullptr) ++found->calls;
        }
        if (mine.calls != 50) ++strangers;
        table->leave(&mine);
      }
    });
  }
  for (std::thread& t : threads) t.join();
  EXPECT_EQ(strangers, 0);
}

// The hash tells apart what differs by one letter, by a shift between the names, or by length.
TEST(CallerKeyHash, TellsApart) {
  const auto hash = [](const char* in, const char* out) {
    return caller_key(nullptr, in, out).strings;
  };
  EXPECT_EQ(hash("a.IN", "b"), hash("a.IN", "b"));
  EXPECT_NE(hash("a.IN", "b"), hash("b.IN", "a"));
  EXPECT_NE(hash("ab", "c"), hash("a", "bc"));
  EXPECT_NE(hash("", "a"), hash("a", ""));
  EXPECT_NE(hash_of_text(std::string_view("a\0", 2)), hash_of_text("a"));
}

}  // namespace
}  // namespace lac
