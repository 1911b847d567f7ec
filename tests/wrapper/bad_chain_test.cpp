// SPDX-License-Identifier: Apache-2.0
// Input files and libraries that cannot work: aviFAIL -1, a message that says where and what.
#include "wrapper/chain_fixture.hpp"

namespace lac::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class BadChain : public ChainTest {
 protected:
  /// The message of a first call with this input file content.
  std::string message_for(const std::string& text) {
    folder.write("s.txt", "");
    TestHost host = host_for(folder.write("chain.IN", text));
    host.message_capacity = 4096;
    EXPECT_EQ(host.call(0), -1) << text;
    return host.message();
  }
  std::string row(const std::string& library) const {
    return "\n\"a\" \"" + library + "\" \"s.txt\" ! Secondary_1 - row\n";
  }
  std::string in_file() const { return folder.file("chain.IN"); }
};

// Without a root name from the host there is nothing to name an output file after.
TEST_F(BadChain, OutputWithoutARootName) {
  folder.write("s.txt", "");
  const std::string file = folder.write(
      "chain.IN", row(toy("toy_empty")) + "csv ! OutputFormat -\nrec20 ! OutputChannels -\n");
  TestHost host(master.entry(), file, "");
  EXPECT_EQ(host.call(0), -1);
  EXPECT_THAT(host.message(), HasSubstr("chain.IN: OutputFile: missing, and the host passed no"));
}

TEST_F(BadChain, MissingInputFile) {
  TestHost host = host_for(folder.file("no.IN"));
  EXPECT_EQ(host.call(0), -1);
  EXPECT_THAT(host.message(), HasSubstr(folder.file("no.IN") + ": cannot open the input file"));
  TestHost none = host_for("");
  EXPECT_EQ(none.call(0), -1);
  EXPECT_THAT(none.message(), HasSubstr("no input file"));
  TestHost is_folder = host_for(folder.path().string());
  EXPECT_EQ(is_folder.call(0), -1);
  EXPECT_THAT(is_folder.message(), HasSubstr("is a folder"));
}

// Not found: every path that was tried is told.
TEST_F(BadChain, LibraryNotFound) {
  std::filesystem::path beside_the_master = built_library("wrapper");
  beside_the_master.replace_filename("libnone" LAC_LIBRARY_SUFFIX);
  EXPECT_THAT(message_for(row("libnone")),
              AllOf(HasSubstr(in_file() + ":2: Secondary_1: library 'libnone' not found; tried:"),
                    HasSubstr("\n  " + folder.file("libnone" LAC_LIBRARY_SUFFIX)),
                    HasSubstr("\n  " + beside_the_master.make_preferred().string()),
                    HasSubstr("the system's own search: ")));
  EXPECT_THAT(message_for(row("sub/libnone" LAC_LIBRARY_SUFFIX)),
              AllOf(HasSubstr("\n  " + folder.file("sub/libnone" LAC_LIBRARY_SUFFIX)),
                    testing::Not(HasSubstr("system's own"))));
  const std::string elsewhere = folder.file("no/where/libnone");
  EXPECT_THAT(message_for(row(elsewhere)), testing::EndsWith("tried:\n  " + elsewhere + "\n  " +
                                                             elsewhere + LAC_LIBRARY_SUFFIX));
}

TEST_F(BadChain, NotALibrary) {
  const std::string text = "libtext" LAC_LIBRARY_SUFFIX;
  folder.write(text, "I am a text file\n");
  EXPECT_THAT(
      message_for(row("libtext")),
      HasSubstr(folder.file(text) + ": cannot be loaded: it is not a library for this system"));
}

/// As much of a file of Linux as tells the machine.
std::string elf_header(char bits, unsigned char machine) {
  std::string h(64, '\0');
  h.replace(1, 3, "ELF");
  h[0] = '\x7f';
  h[4] = bits;
  h[5] = h[6] = h[20] = 1;
  h[16] = 3;
  h[18] = static_cast<char>(machine);
  return h;
}
/// The same of Windows.
std::string windows_header(char bits, const std::string& machine) {
  std::string h(128, '\0');
  h.replace(0, 2, "MZ");
  h[0x3c] = 0x40;
  h.replace(0x40, 2, "PE");
  h.replace(0x44, 2, machine);
  h[0x58] = 0x0b;
  h[0x59] = bits;
  return h;
}

// 32-bit x86 (ELF machine 3, Windows 14c), 64-bit ARM (183, aa64), 64-bit RISC-V (243, 5064).
TEST_F(BadChain, OtherMachine) {
#if defined(_WIN32)
  const std::string elf = " Linux library for ", windows = " library for ";
#else
  const std::string elf = " library for ", windows = " Windows library for ";
#endif
  const std::vector<std::pair<std::string, std::string>> cases{
      {elf_header(1, 3), "a 32-bit" + elf + "x86"},
      {elf_header(2, 183), "a 64-bit" + elf + "ARM64"},
      {elf_header(2, 243), "a 64-bit" + elf + "machine type 243"},
      {windows_header(1, "\x4c\x01"), "a 32-bit" + windows + "x86"},
      {windows_header(2, "\x64\xaa"), "a 64-bit" + windows + "ARM64"},
      {windows_header(2, "\x64\x50"), "a 64-bit" + windows + "machine type 20580"}};
  for (const auto& [content, kind] : cases) {
    folder.write("other" LAC_LIBRARY_SUFFIX, content);
    EXPECT_THAT(message_for(row("other")), HasSubstr("it is " + kind + "; this process is "));
  }
}

// A library that needs another one, which is not there.
TEST_F(BadChain, LibraryOfALibrary) {
  EXPECT_THAT(
      message_for(row(toy("toy_orphan"))),
      AllOf(HasSubstr(in_file() + ":2: Secondary_1: " + toy("toy_orphan") + ": cannot be loaded: "),
            HasSubstr("toy_orphan_part")));
}

#if !defined(_WIN32)
// Start-up code that aborts or throws ends the process, and with it the host: no message can reach
// it, the name of the library is written to the standard error.
using BadChainDeathTest = BadChain;
TEST_F(BadChainDeathTest, CrashOnLoad) {
  for (const std::string name : {"toy_aborts_on_load", "toy_throws_on_load"}) {
    EXPECT_DEATH(message_for(row(toy(name))),
                 "the process ended while it loaded .*lib" + name + "\\.so: the start-up code");
  }
}
#endif

TEST_F(BadChain, MissingInputFileOfASecondary) {
  EXPECT_THAT(
      message_for("a " + toy("toy_empty") + " no.txt ! Secondary_1 -\n"),
      HasSubstr(in_file() + ":1: Secondary_1: input file 'no.txt' cannot be opened; tried " +
                folder.file("no.txt")));
  EXPECT_THAT(message_for("a " + toy("toy_empty") + " chain.IN ! Secondary_1 -\n"),
              HasSubstr("input file 'chain.IN' is the master's own"));
}

TEST_F(BadChain, Rows) {
  const std::string lib = toy("toy_empty");
  EXPECT_THAT(message_for("none ! LidarLayout -\n"), HasSubstr("Secondary_1: missing"));
  EXPECT_THAT(message_for("a x ! Secondary_1 -\n"),
              HasSubstr(":1: Secondary_1: found 2 words, expected \"name\" \"library\""));
  EXPECT_THAT(
      message_for("a " + lib + " s.txt ! Secondary_1 -\nb " + lib + " s.txt ! Secondary_3 -\n"),
      HasSubstr(":2: Secondary_3: Secondary_2 is missing"));
  EXPECT_THAT(
      message_for("a " + lib + " s.txt ! Secondary_1 -\nA " + lib + " s.txt ! Secondary_2 -\n"),
      HasSubstr(":2: Secondary_2: the name 'A' is taken"));
  EXPECT_THAT(message_for("a/b " + lib + " s.txt ! Secondary_1 -\n"),
              HasSubstr("found the name 'a/b', expected letters"));
  EXPECT_THAT(
      message_for("a " + lib + " s.txt ! Secondary_1 -\nb " + lib + " s.txt ! Secundary_2 -\n"),
      HasSubstr(":2: Secundary_2: unknown key (did you mean 'Secondary_2'?)"));
}

TEST_F(BadChain, Keys) {
  const std::string lib = toy("toy_empty");
  std::string many;
  for (int n = 1; n <= 65; ++n) {
    const std::string number = std::to_string(n);
    many += "a" + number + " " + lib + " s.txt ! Secondary_" + number + " -\n";
  }
  EXPECT_THAT(message_for(many), HasSubstr(":65: Secondary_65: expected at most 64 secondaries"));
  const std::string r = row(toy("toy_empty"));
  EXPECT_THAT(
      message_for(r + "nativ ! LidarLayout -\n"),
      HasSubstr(":3: LidarLayout: found 'nativ', expected one of none, native, guo, openfast "
                "(did you mean 'native'?)"));
  EXPECT_THAT(message_for(r + "csv ! OutputFormat -\n"),
              HasSubstr("OutputChannels: missing, OutputFormat asks for an output file"));
  EXPECT_THAT(message_for(r + "csv ! OutputFormat -\nGenSpeed ! OutputChannels -\n"),
              HasSubstr(":4: OutputChannels: found 'GenSpeed', expected names of records or "
                        "signals, or rec1 ... rec3820"));
  EXPECT_THAT(message_for(r + "csv ! OutputFormat -\nrec3821 ! OutputChannels -\n"),
              HasSubstr("found 'rec3821'"));
  EXPECT_THAT(message_for(r + "csv ! OutputFormat -\nrec20 rec20 ! OutputChannels -\n"),
              HasSubstr(":4: OutputChannels: found 'rec20' twice"));
  EXPECT_THAT(
      message_for(r + "csv ! OutputFormat -\nx.outb ! OutputFile -\nrec20 ! OutputChannels"),
      HasSubstr(":4: OutputFile: found 'x.outb', expected the ending .csv"));
  EXPECT_THAT(message_for(r + "0 ! OutputDecimation -\n"),
              HasSubstr("OutputDecimation: found 0, expected a number from 1 to"));
  EXPECT_THAT(message_for(r + "csv ! OutputFormat -\nno/where.csv ! OutputFile -\nrec20 ! "
                              "OutputChannels -\n"),
              HasSubstr("no/where.csv: cannot create this file"));
}

TEST_F(BadChain, Signals) {
  const std::string r = row(toy("toy_empty"));
  const auto with = [&](const std::string& signals) { return message_for(r + signals); };
  EXPECT_THAT(with("a ! Signal_1 -\n"),
              HasSubstr(":3: Signal_1: found 1 words, expected \"name\" record [\"unit\"]"));
  EXPECT_THAT(with("a 3340 ! Signal_1 -\n"),
              HasSubstr("Signal_1: found record '3340', expected a number from 3341 to 3400"));
  EXPECT_THAT(with("a 3341.5 ! Signal_1 -\n"), HasSubstr("found record '3341.5', expected"));
  EXPECT_THAT(with("a 3341 ! Signal_2 -\n"), HasSubstr("Signal_2: Signal_1 is missing"));
  EXPECT_THAT(with("a 3341 ! Signal_1 -\nA 3342 ! Signal_2 -\n"),
              HasSubstr(":4: Signal_2: the name 'A' is taken"));
  EXPECT_THAT(with("a 3341 ! Signal_1 -\nb 3341 ! Signal_2 -\n"),
              HasSubstr(":4: Signal_2: record 3341 is taken by 'a'"));
  EXPECT_THAT(with("lidarrews 3341 ! Signal_1 -\n"),
              HasSubstr("the name 'lidarrews' is taken: it is that of record 3303"));
  EXPECT_THAT(with("rec20 3341 ! Signal_1 -\n"), HasSubstr("'rec20', which means a record"));
  EXPECT_THAT(with("2a 3341 ! Signal_1 -\n"), HasSubstr("found the name '2a', expected letters"));
}

// Windows line ends, a byte-order mark, odd case and blanks are fine.
TEST_F(BadChain, WindowsFilesAreFine) {
  folder.write("s.txt", "set 47 3\r\n");
  const auto in =
      folder.write("chain.IN", "\xEF\xBB\xBF! comment\r\n\r\n a\t" + toy("toy_script") +
                                   " s.txt !secondary_1 - row\r\nNATIVE ! lidarlayout\r\n");
  TestHost host = host_for(in);
  EXPECT_EQ(host.call(0), 0) << host.message();
  EXPECT_EQ(host.get(Rec::TorqueDemand), 3.0f);
}

}  // namespace
}  // namespace lac::test
