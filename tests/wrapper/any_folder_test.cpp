// SPDX-License-Identifier: Apache-2.0
// Every file of a run in a folder with blanks and letters beyond ASCII. On Windows the host may
// write the names in UTF-8 or in the code page.
#include "wrapper/chain_fixture.hpp"

namespace lac::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class AnyFolder : public testing::TestWithParam<bool> {
 protected:
  std::string name(const std::string& file) const {
    return GetParam() ? folder.path(file).string() : folder.file(file);
  }
  /// A chain whose libraries lie in the folder, too; the input file itself is in UTF-8.
  void write_chain() const {
    for (const std::string toy : {"toy_state", "toy_script"}) {
      fs::copy(LAC_TOY_DIR "/lib" + toy + LAC_LIBRARY_SUFFIX,
               folder.path("Bücherei " + toy + LAC_LIBRARY_SUFFIX));
    }
    folder.write("Zustand ä.IN", "");
    folder.write("Skript €.txt", "set 48 7\n");
    folder.write("Kette ß.IN",
                 "a \"Bücherei toy_state\" \"Zustand ä.IN\" ! Secondary_1 -\n"
                 "b \"Bücherei toy_script\" \"Skript €.txt\" ! Secondary_2 -\n"
                 "csv ! OutputFormat -\nTorqueDemand ! OutputChannels -\n");
  }
  TestHost host() const {
    return TestHost(master.entry(), name("Kette ß.IN"), name("Lauf ö.SrvD"));
  }

  TempFolder folder{" Größe mit Leerzeichen, 5 €"};
  DisconLibrary master = DisconLibrary::open(built_library("wrapper"), "DISCON", {});
};

// Input files, libraries, checkpoint and output file; a library that opens its file by the bytes
// it was given, as others' do, finds it.
TEST_P(AnyFolder, Run) {
  write_chain();
  {
    TestHost first = host();
    ASSERT_EQ(first.call(0), 0) << first.message();
    ASSERT_EQ(first.call(1), 0) << first.message();
    ASSERT_EQ(first.call_with(-8, name("Lauf ö.2.chkp")), 0) << first.message();
    ASSERT_EQ(first.call(-1), 0) << first.message();
  }
  TestHost second = host();
  ASSERT_EQ(second.call_with(-9, name("Lauf ö.2.chkp")), 0) << second.message();
  ASSERT_EQ(second.call(1), 0) << second.message();
  EXPECT_EQ(second.at(48), 7.0f);  // as the script says
  ASSERT_EQ(second.call(-1), 0) << second.message();
  EXPECT_EQ(folder.read("Lauf ö.2.chkp.2.b.toy"), "b -8\nb -9\n");
  for (const char* file :
       {"Lauf ö.lac.csv", "Lauf ö.lac.2.csv", "Lauf ö.2.chkp", "Lauf ö.2.chkp.1.a"}) {
    EXPECT_TRUE(fs::exists(folder.path(file))) << file;
  }
}

// Messages name the files in UTF-8.
TEST_P(AnyFolder, Message) {
  folder.write("Kette ß.IN", "a keine \"fehlt ü.IN\" ! Secondary_1 -\n");
  TestHost none = host();
  EXPECT_EQ(none.call(0), -1);
  EXPECT_THAT(none.message(), HasSubstr(folder.path("Kette ß.IN").string() + ":1: Secondary_1: "));
  EXPECT_THAT(none.message(), HasSubstr("tried " + folder.path("fehlt ü.IN").string()));
}

INSTANTIATE_TEST_SUITE_P(Names, AnyFolder, testing::Values(true, false), [](const auto& test) {
  return std::string(test.param ? "Utf8" : "AsTheSystem");
});

}  // namespace
}  // namespace lac::test
