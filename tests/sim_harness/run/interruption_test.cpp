// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/interruption.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace lac::sim {
namespace {

// The first signal only asks; what was set before is back afterwards, and nothing is remembered.
TEST(Interruption, AsksOnce) {
  {
    const Interruption interruption;
    EXPECT_NO_THROW(interruption.check());
    std::raise(SIGINT);
    EXPECT_TRUE(interruption.requested());
    EXPECT_THROW(interruption.check(), Error);
    struct sigaction now {};
    sigaction(SIGINT, nullptr, &now);
    EXPECT_EQ(now.sa_handler, SIG_DFL);  // the second one ends the process
  }
  const Interruption next;
  EXPECT_FALSE(next.requested());
  std::raise(SIGTERM);
  EXPECT_TRUE(next.requested());
}

// A process told to ignore Ctrl-C (nohup, background jobs of a shell) goes on ignoring it.
TEST(Interruption, IgnoredStaysIgnored) {
  std::signal(SIGINT, SIG_IGN);
  {
    const Interruption interruption;
    std::raise(SIGINT);
    EXPECT_FALSE(interruption.requested());
  }
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace
}  // namespace lac::sim
