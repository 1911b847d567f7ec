// SPDX-License-Identifier: Apache-2.0
#include "core/discon_library.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "support/library_names.hpp"
#include "support/process_state.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kToy = std::string(LAC_TOY_DIR) + "/libtoy_empty" LAC_LIBRARY_SUFFIX;

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
  const std::string libx = "libx" LAC_LIBRARY_SUFFIX;
  EXPECT_THAT(library_candidates("libx", {"a", "b/c"}),
              ElementsAre("a/libx", "a/" + libx, "b/c/libx", "b/c/" + libx));
  EXPECT_THAT(library_candidates("sub/" + libx, {"a", ""}),
              ElementsAre("a/sub/" + libx, "./sub/" + libx));
  const std::string elsewhere = (test::TempFolder().path() / "libx").string();
  EXPECT_THAT(library_candidates(elsewhere, {"a"}),
              ElementsAre(elsewhere, elsewhere + LAC_LIBRARY_SUFFIX));
}

TEST(DisconLibrary, OwnFolderIsThatOfTheTests) {
  EXPECT_TRUE(std::filesystem::equivalent(own_folder() / "toys", LAC_TOY_DIR));
}

TEST(DisconLibrary, OpensWithAndWithoutSuffix) {
  for (const char* name : {"libtoy_empty", "libtoy_empty" LAC_LIBRARY_SUFFIX}) {
    const DisconLibrary library = DisconLibrary::open(name, "my_controller", {"/no", LAC_TOY_DIR});
    EXPECT_EQ(library.path(), kToy);
    EXPECT_NE(library.entry(), nullptr);
  }
}

// The handle goes with the object, once, also after moves.
TEST(DisconLibrary, ClosesWithTheObject) {
  const auto loaded = [] { return test::is_loaded(kToy); };
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
  EXPECT_THAT(refusal("libtoy_empty", "discon"),
              HasSubstr("libtoy_empty" LAC_LIBRARY_SUFFIX ": has no entry 'discon'"));
  const test::TempFolder folder;
  EXPECT_THAT(refusal(folder.write("libtext" LAC_LIBRARY_SUFFIX, "text")),
              HasSubstr("cannot be loaded: it is not a library for this system"));
  EXPECT_THAT(refusal(folder.write("libempty" LAC_LIBRARY_SUFFIX, "")),
              HasSubstr("not a library for this system"));
}

// A library cut off anywhere is refused: the loader of the system would end the process.
TEST(DisconLibrary, CutOffFile) {
  std::ifstream file(kToy, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  const test::TempFolder folder;
  for (const std::size_t kept : {std::size_t{3000}, whole.size() / 2}) {
    EXPECT_THAT(refusal(folder.write("libcut" LAC_LIBRARY_SUFFIX, whole.substr(0, kept))),
                HasSubstr("libcut" LAC_LIBRARY_SUFFIX
                          ": cannot be loaded: the file is shorter than its own headers"));
  }
  EXPECT_THAT(refusal(folder.write("libcut" LAC_LIBRARY_SUFFIX, whole.substr(0, 40))),
              HasSubstr("cannot be loaded"));
  EXPECT_EQ(refusal(folder.write("libcut" LAC_LIBRARY_SUFFIX, whole)), "opened");
}

// A library for another machine is named as such.
TEST(DisconLibrary, WrongMachine) {
  std::ifstream file(kToy, std::ios::binary);
  std::string other{std::istreambuf_iterator<char>(file), {}};
#if defined(_WIN32)
  const std::size_t at = static_cast<unsigned char>(other[0x3c]) + 4;
  const std::string x86_64 = "\x64\x86", arm = "\x64\xaa";
#else
  const std::size_t at = 18;
  const std::string x86_64("\x3e\0", 2), arm("\xb7\0", 2);
#endif
  const bool here_x86_64 = other.substr(at, 2) == x86_64;
  other.replace(at, 2, here_x86_64 ? arm : x86_64);
  const test::TempFolder folder;
  EXPECT_THAT(refusal(folder.write("libother" LAC_LIBRARY_SUFFIX, other)),
              HasSubstr(here_x86_64 ? "it is a 64-bit library for ARM64; this process is 64-bit"
                                    : "it is a 64-bit library for x86-64; this process is 64-bit"));
}

// A bare name at last goes to the system's own search; the C library is there, and no controller.
TEST(DisconLibrary, BareNameAsksTheSystem) {
#if defined(_WIN32)
  const std::string c_library = "msvcrt.dll";
#else
  const std::string c_library = "libc.so.6";
#endif
  EXPECT_THAT(refusal(c_library), HasSubstr(c_library + ": has no entry 'DISCON'"));
}

}  // namespace
}  // namespace lac
