// SPDX-License-Identifier: Apache-2.0
// The built libraries as a host loads, calls and drops them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/discon_library.hpp"
#include "support/library_names.hpp"
#include "support/process_state.hpp"
#include "support/temp_folder.hpp"
#include "support/test_host.hpp"

namespace lac::test {
namespace {

using testing::HasSubstr;

class Library : public testing::TestWithParam<const char*> {};

// Closed, it is gone: no thread-local destructor and no unique symbol holds it. A first call
// that failed (no input file) does not hold it either.
TEST_P(Library, UnloadsCleanly) {
  const std::string path = built_library(GetParam());
  for (int i = 0; i < 2; ++i) {
    {
      const DisconLibrary library = DisconLibrary::open(path, "DISCON", {});
      EXPECT_TRUE(is_loaded(path));
      TestHost host(library.entry(), "no/such.IN");
      EXPECT_EQ(host.call(0), -1);
      EXPECT_THAT(host.message(), HasSubstr("no/such.IN"));
      EXPECT_THAT(host.message(), testing::StartsWith(std::string(GetParam()) + ": "));
    }
    EXPECT_FALSE(is_loaded(path));
  }
}

// The library itself and its input file may lie in a folder with blanks and letters beyond ASCII;
// the message says so in UTF-8.
TEST_P(Library, LivesInAnyFolder) {
  const TempFolder folder(" Größe mit Leerzeichen, 5 €");
  const std::string name = "lib" LAC_LIBRARY_SUFFIX;
  std::filesystem::copy(built_library(GetParam()), folder.path(name));
  const DisconLibrary library = DisconLibrary::open(folder.file(name), "DISCON", {});
  TestHost host(library.entry(), folder.write("Prüf.IN", "1 ! NoSuchKey - of any library\n"));
  EXPECT_EQ(host.call(0), -1);
  EXPECT_THAT(host.message(), HasSubstr(folder.path("Prüf.IN").string() + ":"));
}

INSTANTIATE_TEST_SUITE_P(Built, Library,
                         testing::Values("wrapper", "ldp", "ti_estimator", "ffp", "feedback",
                                         "bridge", "monitor"),
                         [](const auto& test) { return std::string(test.param); });

// More often than a process has thread-local slots (Windows: 1088), with an exception each time;
// no handle stays behind.
TEST(Unloading, VeryOften) {
  const auto load_call_and_drop = [] {
    const DisconLibrary library = DisconLibrary::open(built_library("wrapper"), "DISCON", {});
    TestHost host(library.entry(), "no/such.IN");
    ASSERT_EQ(host.call(0), -1);
  };
  load_call_and_drop();
  const int before = open_files();
  for (int i = 0; i < 1200; ++i) load_call_and_drop();
  EXPECT_EQ(open_files(), before);
}

}  // namespace
}  // namespace lac::test
