// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/fingerprint.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>

#include "core/discon_library.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "sim_harness/host/controller_host.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kLongestText = 4u << 20;  // greater files are data and name no others
constexpr std::size_t kLongestName = 4096;
constexpr char kSeparators[] = " \t\r\n\"',:;=[]{}()<>|";

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Error(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

bool is_text(const std::string& bytes) {
  return bytes.size() <= kLongestText && bytes.find('\0') == std::string::npos;
}

/// Words between blanks and punctuation, and what stands between quotes, blanks and all.
std::set<std::string> words_of(const std::string& text) {
  std::set<std::string> words;
  const auto add = [&](std::string_view word) {
    const bool has_letter = std::ranges::any_of(
        word, [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });
    if (has_letter && word.size() <= kLongestName) words.emplace(word);
  };
  const auto split = [&](const char* separators) {
    std::size_t at = 0;
    while ((at = text.find_first_not_of(separators, at)) != std::string::npos) {
      const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
      add(std::string_view(text).substr(at, end - at));
      at = end;
    }
  };
  split(kSeparators);
  split("\"'\r\n");
  return words;
}

bool is_file(const fs::path& path) {
  std::error_code no;
  return fs::is_regular_file(path, no);
}

fs::path this_program() {
  std::error_code unknown;
  return fs::read_symlink("/proc/self/exe", unknown);
}

}  // namespace

std::vector<fs::path> Fingerprints::named_in(const std::string& text, const fs::path& folder) {
  std::vector<fs::path> named;
  for (const std::string& word : words_of(text)) {
    if (is_file(folder / word)) named.push_back((folder / word).lexically_normal());
    for (const fs::path& library : library_candidates(word, folders_beside_program())) {
      if (is_file(library)) named.push_back(library.lexically_normal());
    }
  }
  return named;
}

const Fingerprints::File& Fingerprints::look_at(const fs::path& file) {
  const auto [at, is_new] = files_.try_emplace(file);
  if (!is_new) return at->second;
  const std::string bytes = content(file);
  at->second.hash = hash_of_text(bytes);
  if (is_text(bytes)) at->second.named = named_in(bytes, file.parent_path());
  return at->second;
}

std::string Fingerprints::of_case(const fs::path& case_file,
                                  const std::vector<std::string>& overrides) {
  std::string all;
  std::vector<fs::path> open{case_file};
  for (const std::string& o : overrides) {
    all += o + '\n';
    for (fs::path& file : named_in(o, case_file.parent_path())) open.push_back(std::move(file));
  }
  if (const fs::path program = this_program(); is_file(program)) open.push_back(program);
  for (fs::path& library : named_in("liblac_wrapper", case_file.parent_path()))
    open.push_back(std::move(library));  // what flies where the case names none

  std::set<fs::path> seen;
  std::set<std::uint64_t> hashes;  // the order of files must not depend on where they lie
  while (!open.empty()) {
    const fs::path file = std::move(open.back());
    open.pop_back();
    if (!seen.insert(file).second) continue;
    const File& known = look_at(file);
    hashes.insert(known.hash);
    open.insert(open.end(), known.named.begin(), known.named.end());
  }
  for (const std::uint64_t hash : hashes) all += std::to_string(hash) + '\n';
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016" PRIx64, hash_of_text(all));
  return text.data();
}

}  // namespace lac::sim
