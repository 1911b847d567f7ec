// SPDX-License-Identifier: Apache-2.0
#include "core/discon_abi.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>
#include <type_traits>

extern "C" int lac_statuses_in_c(const int** values);

// Five pointers and no return value.
static_assert(std::is_same_v<LacDisconFunction, void (*)(float*, int*, const char*, char*, char*)>);

// The header compiles as C11, the function pointer takes a C function, and the numbers are those
// of the hosts.
TEST(AbiHeader, SpeaksC) {
  const int* values = nullptr;
  const int n = lac_statuses_in_c(&values);
  ASSERT_EQ(n, 7);
  EXPECT_THAT(std::span(values, 7), testing::ElementsAre(-11, -10, -9, -8, -1, 0, 1));
}
