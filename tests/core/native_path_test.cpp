// SPDX-License-Identifier: Apache-2.0
#include "core/native_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "core/checkpoint.hpp"
#include "core/input_file.hpp"
#include "core/table_writer.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

namespace fs = std::filesystem;

const std::string kUtf8 =
    "Gr\xc3\xb6\xc3\x9f"
    "e mit Leerzeichen";
const std::string kAnsi =
    "Gr\xf6\xdf"  // code page 1252
    "e mit Leerzeichen";

// ASCII is the same in and out.
TEST(NativePath, PlainNames) {
  EXPECT_EQ(path_from_bytes("a b/c.IN"), fs::path("a b/c.IN"));
  EXPECT_EQ(bytes_from_path(path_from_bytes("a b/c.IN")), "a b/c.IN");
  EXPECT_TRUE(path_from_bytes("").empty());
  EXPECT_EQ(bytes_from_path({}), "");
}

#if defined(_WIN32)

// Both ways of writing mean the same file there. Out goes what a library for the code page
// understands, and UTF-8 where the code page has no such letter.
TEST(NativePath, Utf8AndCodePage) {
  EXPECT_EQ(path_from_bytes(kUtf8).native(), L"Gr\u00f6\u00dfe mit Leerzeichen");
  EXPECT_EQ(path_from_bytes(kAnsi), path_from_bytes(kUtf8));
  EXPECT_EQ(bytes_from_path(path_from_bytes(kUtf8)), kAnsi);
  const std::string wind = "\xe9\xa2\xa8.IN";
  EXPECT_EQ(path_from_bytes(wind).native(), L"\u98a8.IN");
  EXPECT_EQ(bytes_from_path(path_from_bytes(wind)), wind);
}

// Code-page bytes that happen to be valid UTF-8 would come back as another name.
TEST(NativePath, AmbiguousNamesGoOutAsUtf8) {
  const fs::path ambiguous(L"\u00c3\u00a4");  // its code-page bytes are the letter \u00e4 in UTF-8
  EXPECT_EQ(path_from_bytes("\xc3\xa4").native(), L"\u00e4");
  EXPECT_EQ(bytes_from_path(ambiguous), ambiguous.string());
  EXPECT_EQ(path_from_bytes(bytes_from_path(ambiguous)), ambiguous);
}

#else

// Bytes are names there, in whatever encoding.
TEST(NativePath, BytesStayAsTheyAre) {
  for (const std::string& name : {kUtf8, kAnsi}) {
    EXPECT_EQ(path_from_bytes(name).native(), name);
    EXPECT_EQ(bytes_from_path(path_from_bytes(name)), name);
  }
}

#endif

// Every kind of file that the chain reads and writes, in such a folder and of such a name.
TEST(NativePath, FilesOfSuchNames) {
  const test::TempFolder folder(" " + kUtf8);
  const std::string name =
      "Stra\xc3\x9f"
      "e 1";
  InputFile in = InputFile::load(path_from_bytes(folder.write(name + ".IN", "7 ! Key - \n")));
  EXPECT_EQ(in.integer("Key"), 7);
  EXPECT_EQ(in.resolve("sub/" + name), folder.path() / "sub" / path_from_bytes(name));

  write_checkpoint(folder.path(name + ".chkp"), {"m", "in", "out", 0.1, 3, {}});
  EXPECT_EQ(read_checkpoint(folder.path(name + ".chkp"), "m").steps, 3);

  for (const std::string ending : {".csv", ".outb"}) {
    const auto table =
        make_table_writer({folder.path(name + ending), {{"A", "-"}}, 0.0, 0.1, 2, ""});
    const float value = 1.5F;
    ASSERT_TRUE(table->append(&value));
    table->finish();
  }
  EXPECT_EQ(folder.read(name + ".csv"), "Time [s],A [-]\n0,1.5\n");
  EXPECT_GT(fs::file_size(folder.path(name + ".outb")), 0U);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 4);
}

}  // namespace
}  // namespace lac
