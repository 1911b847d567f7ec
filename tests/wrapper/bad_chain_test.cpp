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
  EXPECT_THAT(message_for(row("libnone")),
              AllOf(HasSubstr(in_file() + ":2: Secondary_1: library 'libnone' not found; tried:"),
                    HasSubstr("\n  " + folder.file("libnone.so")),
                    HasSubstr("\n  " + std::string(LAC_LIBRARY_DIR) + "/libnone.so"),
                    HasSubstr("the system's own search: libnone.so")));
  EXPECT_THAT(message_for(row("sub/libnone.so")),
              AllOf(HasSubstr("\n  " + folder.file("sub/libnone.so")),
                    testing::Not(HasSubstr("system's own"))));
  EXPECT_THAT(message_for(row("/no/where/libnone")),
              HasSubstr("tried:\n  /no/where/libnone\n  /no/where/libnone.so"));
}

TEST_F(BadChain, NotALibrary) {
  folder.write("libtext.so", "I am a text file\n");
  EXPECT_THAT(message_for(row("libtext")),
              HasSubstr(folder.file("libtext.so") +
                        ": cannot be loaded: it is not a library for this system"));
  folder.write("libwin.so", std::string("MZ\x90\0\3\0", 6));
  EXPECT_THAT(message_for(row("libwin")), HasSubstr("it is a Windows library"));
}

// ELF headers of other machines: 32-bit x86 (machine 3), 64-bit ARM (183), 64-bit RISC-V (243).
TEST_F(BadChain, OtherMachine) {
  const auto header = [](char elf_class, unsigned char machine) {
    std::string h(64, '\0');
    h.replace(0, 4,
              "\x7f"
              "ELF");
    h[4] = elf_class;
    h[5] = 1;
    h[6] = 1;
    h[16] = 3;
    h[18] = static_cast<char>(machine);
    h[20] = 1;
    return h;
  };
  folder.write("x86.so", header(1, 3));
  folder.write("arm.so", header(2, 183));
  folder.write("riscv.so", header(2, 243));
  EXPECT_THAT(message_for(row("x86")), HasSubstr("it is a 32-bit library for x86; this process"));
  EXPECT_THAT(message_for(row("arm")), HasSubstr("it is a 64-bit library for ARM64; this process"));
  EXPECT_THAT(message_for(row("riscv")), HasSubstr("for machine type 243; this process"));
}

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
  EXPECT_THAT(message_for(r + "nativ ! LidarLayout -\n"),
              HasSubstr(":3: LidarLayout: found 'nativ', expected one of none, native, guo "
                        "(did you mean 'native'?)"));
  EXPECT_THAT(message_for(r + "csv ! OutputFormat -\n"),
              HasSubstr("OutputChannels: missing, OutputFormat asks for an output file"));
  EXPECT_THAT(message_for(r + "csv ! OutputFormat -\nGenSpeed ! OutputChannels -\n"),
              HasSubstr(":4: OutputChannels: found 'GenSpeed', expected names of records or rec1"));
  EXPECT_THAT(message_for(r + "csv ! OutputFormat -\nrec3713 ! OutputChannels -\n"),
              HasSubstr("found 'rec3713'"));
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
