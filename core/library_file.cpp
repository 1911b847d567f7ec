// SPDX-License-Identifier: Apache-2.0
#include "core/library_file.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>

#if defined(__linux__)
#include <link.h>
#endif

namespace lac {
namespace fs = std::filesystem;
namespace {

struct Machine {
  unsigned elf;
  unsigned pe;
  const char* name;
};
constexpr std::array kMachines{Machine{3, 0x14c, "x86"}, Machine{62, 0x8664, "x86-64"},
                               Machine{183, 0xaa64, "ARM64"}};

#if defined(_WIN32)
constexpr bool kHereIsWindows = true;
#else
constexpr bool kHereIsWindows = false;
#endif

#if defined(__x86_64__)
constexpr const char* kThisMachine = " x86-64";
#elif defined(__aarch64__)
constexpr const char* kThisMachine = " ARM64";
#elif defined(__i386__)
constexpr const char* kThisMachine = " x86";
#else
constexpr const char* kThisMachine = "";
#endif

using Bytes = std::array<unsigned char, 26>;

/// Zero behind the end of the file.
Bytes bytes_at(std::ifstream& in, std::uint64_t position) {
  Bytes bytes{};
  in.clear();
  in.seekg(static_cast<std::streamoff>(position));
  in.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
  return bytes;
}
unsigned word(const Bytes& bytes, std::size_t at) {
  return bytes[at] + 256u * bytes[at + 1];
}
std::uint64_t double_word(const Bytes& bytes, std::size_t at) {
  return word(bytes, at) + std::uint64_t{65536} * word(bytes, at + 2);
}

bool begins_with(const Bytes& bytes, std::string_view text) {
  return std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

/// Where the headers of a Windows library begin, or 0 if it is none.
std::uint64_t windows_headers(std::ifstream& in) {
  if (!begins_with(bytes_at(in, 0), "MZ")) return 0;
  const std::uint64_t start = double_word(bytes_at(in, 0x3c), 0);
  return begins_with(bytes_at(in, start), {"PE\0\0", 4}) ? start : 0;
}

std::string kind(bool windows, bool is_32_bit, unsigned machine) {
  std::string name = "machine type " + std::to_string(machine);
  for (const Machine& m : kMachines) {
    if (machine == (windows ? m.pe : m.elf)) name = m.name;
  }
  if (windows == kHereIsWindows && " " + name == kThisMachine) return {};
  const char* system = windows == kHereIsWindows ? "" : windows ? " Windows" : " Linux";
  return std::string(is_32_bit ? "a 32-bit" : "a 64-bit") + system + " library for " + name +
         "; this process is " + std::to_string(8 * sizeof(void*)) + "-bit" + kThisMachine;
}

}  // namespace

#if defined(__linux__)
bool is_cut_off(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  ElfW(Ehdr) head{};
  in.read(reinterpret_cast<char*>(&head), sizeof head);
  const bool is_ours =
      std::memcmp(head.e_ident, ELFMAG, SELFMAG) == 0 && head.e_phentsize == sizeof(ElfW(Phdr));
  if (!in || !is_ours) return false;  // the loader sees that, and says what it is
  std::error_code ec;
  const std::uintmax_t size = fs::file_size(path, ec);
  in.seekg(static_cast<std::streamoff>(head.e_phoff));
  for (unsigned i = 0; i < head.e_phnum; ++i) {
    ElfW(Phdr) part{};
    if (!in.read(reinterpret_cast<char*>(&part), sizeof part)) return true;
    if (part.p_filesz > size || part.p_offset > size - part.p_filesz) return true;
  }
  return false;
}
#else
bool is_cut_off(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::uint64_t start = windows_headers(in);
  if (start == 0) return false;  // the loader sees that, and says what it is
  const Bytes head = bytes_at(in, start);
  const std::uint64_t sections = start + 24 + word(head, 20);
  std::error_code ec;
  const std::uintmax_t size = fs::file_size(path, ec);
  for (unsigned i = 0; i < word(head, 6); ++i) {
    const std::uint64_t section = sections + std::uint64_t{40} * i;
    const Bytes part = bytes_at(in, section + 16);  // size and position in the file
    if (section + 40 > size || double_word(part, 0) + double_word(part, 4) > size) return true;
  }
  return false;
}
#endif

std::string describe_library(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  const Bytes head = bytes_at(in, 0);
  if (begins_with(head,
                  "\x7f"
                  "ELF"))
    return kind(false, head[4] == 1, word(head, 18));
  if (const std::uint64_t start = windows_headers(in); start != 0) {
    const Bytes headers = bytes_at(in, start);
    return kind(true, word(headers, 24) == 0x10b, word(headers, 4));
  }
  return "not a library for this system";
}

}  // namespace lac
