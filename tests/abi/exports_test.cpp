// SPDX-License-Identifier: Apache-2.0
// Reads the dynamic section of the built libraries (64-bit ELF): what they export and need.
#include <elf.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/library_names.hpp"

namespace lac::test {
namespace {

class ElfFile {
 public:
  explicit ElfFile(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(in), {});
    const auto header = at<Elf64_Ehdr>(0);
    for (int i = 0; i < header.e_shnum; ++i) {
      sections_.push_back(
          at<Elf64_Shdr>(header.e_shoff + static_cast<std::size_t>(i) * sizeof(Elf64_Shdr)));
    }
  }
  std::vector<std::string> exported() const {
    std::vector<std::string> names;
    for (const Elf64_Shdr& s : sections_) {
      if (s.sh_type != SHT_DYNSYM) continue;
      for (std::size_t at_ = 0; at_ < s.sh_size; at_ += sizeof(Elf64_Sym)) {
        const auto symbol = at<Elf64_Sym>(s.sh_offset + at_);
        if (symbol.st_shndx != SHN_UNDEF) names.push_back(text(s, symbol.st_name));
      }
    }
    return names;
  }
  std::vector<std::string> needed() const {
    std::vector<std::string> names;
    for (const Elf64_Shdr& s : sections_) {
      if (s.sh_type != SHT_DYNAMIC) continue;
      for (std::size_t at_ = 0; at_ < s.sh_size; at_ += sizeof(Elf64_Dyn)) {
        const auto entry = at<Elf64_Dyn>(s.sh_offset + at_);
        if (entry.d_tag == DT_NEEDED) names.push_back(text(s, entry.d_un.d_val));
      }
    }
    return names;
  }

 private:
  template <class T>
  T at(std::size_t offset) const {
    T value{};
    if (offset + sizeof value <= bytes_.size()) {
      std::memcpy(&value, bytes_.data() + offset, sizeof value);
    }
    return value;
  }
  std::string text(const Elf64_Shdr& owner, std::size_t offset) const {
    return bytes_.data() + sections_[owner.sh_link].sh_offset + offset;
  }

  std::vector<char> bytes_;
  std::vector<Elf64_Shdr> sections_;
};

class Library : public testing::TestWithParam<const char*> {
 protected:
  static std::string path() { return built_library(GetParam()); }
};

// The entry, and the constant that says that one image serves many turbines.
TEST_P(Library, ExportsTwoSymbols) {
  EXPECT_THAT(ElfFile(path()).exported(),
              testing::UnorderedElementsAre("DISCON", "LAC_DISCON_REENTRANT"));
}

// Nothing beyond the C runtime at run time; the C++ one is inside. (Sanitizers add their own.)
TEST_P(Library, NeedsTheRuntimeOnly) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers link their runtime";
#endif
  for (const std::string& name : ElfFile(path()).needed()) {
    EXPECT_THAT(name, testing::MatchesRegex("(libc|libm|libdl|libpthread|ld-linux.*)\\.so.*"));
  }
}

INSTANTIATE_TEST_SUITE_P(Built, Library,
                         testing::Values("wrapper", "ldp", "ti_estimator", "ffp", "feedback",
                                         "bridge", "monitor"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace lac::test
