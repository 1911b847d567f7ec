// SPDX-License-Identifier: Apache-2.0
#include "core/discon_library.hpp"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kToy = std::string(LAC_TOY_DIR) + "/libtoy_empty.so";

std::string refusal(const std::string& name, const std::string& entry = "DISCON") {
  try {
    DisconLibrary::open(name, entry, {LAC_TOY_DIR});
  } catch (const Error& e) {
    return e.what();
  }
  return "opened";
}

// Folder by folder, as written first; an absolute name stands alone; no folder means here.
TEST(DisconLibrary, Candidates) {
  EXPECT_THAT(library_candidates("libx", {"a", "b/c"}),
              ElementsAre("a/libx", "a/libx.so", "b/c/libx", "b/c/libx.so"));
  EXPECT_THAT(library_candidates("sub/libx.so", {"a", ""}),
              ElementsAre("a/sub/libx.so", "./sub/libx.so"));
  EXPECT_THAT(library_candidates("/x/libx", {"a"}), ElementsAre("/x/libx", "/x/libx.so"));
}

TEST(DisconLibrary, OwnFolderIsThatOfTheTests) {
  EXPECT_TRUE(std::filesystem::equivalent(own_folder() / "toys", LAC_TOY_DIR));
}

TEST(DisconLibrary, OpensWithAndWithoutSuffix) {
  for (const char* name : {"libtoy_empty", "libtoy_empty.so"}) {
    const DisconLibrary library = DisconLibrary::open(name, "my_controller", {"/no", LAC_TOY_DIR});
    EXPECT_EQ(library.path(), kToy);
    EXPECT_NE(library.entry(), nullptr);
  }
}

// The handle goes with the object, once, also after moves.
TEST(DisconLibrary, ClosesWithTheObject) {
  const auto loaded = [] {
    void* handle = dlopen(kToy.c_str(), RTLD_NOW | RTLD_NOLOAD);
    if (handle != nullptr) dlclose(handle);
    return handle != nullptr;
  };
  {
    DisconLibrary a = DisconLibrary::open(kToy, "DISCON", {});
    DisconLibrary b = std::move(a);
    a = std::move(b);
    EXPECT_TRUE(loaded());
    a = DisconLibrary();
    EXPECT_FALSE(loaded());
    a = DisconLibrary::open(kToy, "DISCON", {});
    EXPECT_TRUE(loaded());
  }
  EXPECT_FALSE(loaded());
}

TEST(DisconLibrary, SaysWhyNot) {
  EXPECT_THAT(refusal("libnone"), HasSubstr("library 'libnone' not found; tried:\n  "));
  EXPECT_THAT(refusal("libtoy_empty", "discon"), HasSubstr(kToy + ": has no entry 'discon'"));
  const test::TempFolder folder;
  EXPECT_THAT(refusal(folder.write("libtext.so", "text")),
              HasSubstr("cannot be loaded: it is not a library for this system"));
  EXPECT_THAT(refusal(folder.write("libempty.so", "")), HasSubstr("not a library for this system"));
}

// A library cut off anywhere is refused: the loader of the system would end the process.
TEST(DisconLibrary, CutOffFile) {
  std::ifstream file(kToy, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  const test::TempFolder folder;
  for (const std::size_t kept : {std::size_t{3000}, whole.size() / 2}) {
    EXPECT_THAT(refusal(folder.write("libcut.so", whole.substr(0, kept))),
                HasSubstr("libcut.so: cannot be loaded: the file is shorter than its own headers"));
  }
  EXPECT_THAT(refusal(folder.write("libcut.so", whole.substr(0, 40))),
              HasSubstr("cannot be loaded"));
  EXPECT_EQ(refusal(folder.write("libcut.so", whole)), "opened");
}

// A library for another machine is named as such.
TEST(DisconLibrary, WrongMachine) {
  std::ifstream file(kToy, std::ios::binary);
  std::string other{std::istreambuf_iterator<char>(file), {}};
  const bool here_x86_64 = other[18] == 62;
  other[18] = here_x86_64 ? '\xb7' : '\x3e';
  const test::TempFolder folder;
  EXPECT_THAT(refusal(folder.write("libother.so", other)),
              HasSubstr(here_x86_64 ? "it is a 64-bit library for ARM64; this process is 64-bit"
                                    : "it is a 64-bit library for x86-64; this process is 64-bit"));
}

// A bare name at last goes to the system's own search; the C library is there, and no controller.
TEST(DisconLibrary, BareNameAsksTheSystem) {
  EXPECT_THAT(refusal("libc.so.6"), HasSubstr("libc.so.6: has no entry 'DISCON'"));
}

}  // namespace
}  // namespace lac
