// SPDX-License-Identifier: Apache-2.0
// Needs a file size limit for the process (POSIX), which stands for a full disk.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "core/error.hpp"
#include "core/outb_file.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// The system takes no more bytes: append says no, finish tells file and reason, nothing stays.
TEST(RefusedWrite, IsReported) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit tight{6, before.rlim_max};
  const test::TempFolder folder;
  {
    OutbWriter writer({folder.path("run.outb"), {{"A", "-"}}, 0.0, 0.0125, 1, "test"});
    const float value = 1.0F;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    const bool first = writer.append(&value);
    const bool second = writer.append(&value);
    ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_TRUE(first);
    EXPECT_FALSE(second);
    EXPECT_FALSE(writer.append(&value));
    EXPECT_THAT(test::error_text([&] { writer.finish(); }),
                AllOf(HasSubstr("run.outb: cannot write"), HasSubstr("File too large")));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace lac
