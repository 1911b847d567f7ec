// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <fstream>

#include "core/suggest.hpp"
#include "wrapper/chain_config.hpp"
#include "wrapper/numbered_rows.hpp"

namespace lac {
namespace fs = std::filesystem;
namespace {

constexpr const char* kPrefix = "Secondary_";
constexpr int kMostSecondaries = 64;

void check_name(const InputFile& in, const std::string& key, const std::string& name) {
  const bool plain = std::ranges::all_of(name, [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
  if (name.empty() || !plain) {
    in.fail(key, "found the name '" + name +
                     "', expected letters, digits, - and _ (it becomes part of file names)");
  }
}

fs::path find_input_file(const InputFile& in, const std::string& key, const std::string& written) {
  fs::path path = in.resolve(written).lexically_normal();
  std::error_code ec;
  if (!fs::is_regular_file(path, ec) || !std::ifstream(path)) {
    in.fail(key, "input file '" + written + "' cannot be opened; tried " + path.string());
  }
  if (fs::equivalent(path, in.path(), ec)) {
    in.fail(key, "input file '" + written + "' is the master's own");
  }
  return path;
}

SecondaryParams read_row(InputFile& in, const std::string& key) {
  const std::vector<std::string> words = in.texts(key);
  if (words.size() < 3 || words.size() > 4) {
    in.fail(key, "found " + std::to_string(words.size()) +
                     " words, expected \"name\" \"library\" \"input file\" [\"entry\"]");
  }
  SecondaryParams s;
  s.where = in.where(key);
  s.name = words[0];
  check_name(in, key, s.name);
  s.library = words[1];
  if (s.library.empty()) in.fail(key, "found an empty library name");
  s.input_file = find_input_file(in, key, words[2]);
  if (words.size() == 4) s.entry = words[3];
  return s;
}

}  // namespace

std::vector<SecondaryParams> SecondaryParams::read_all(InputFile& in) {
  std::vector<SecondaryParams> all;
  const int rows = count_numbered_rows(in, kPrefix, kMostSecondaries, "secondaries");
  const int count = std::max(1, rows);  // none: the first is reported as missing
  for (int n = 1; n <= count; ++n) {
    const std::string key = kPrefix + std::to_string(n);
    SecondaryParams s = read_row(in, key);
    const auto same = [&](const SecondaryParams& o) { return equal_ignoring_case(o.name, s.name); };
    if (std::ranges::any_of(all, same)) {
      in.fail(key, "the name '" + s.name + "' is taken; each secondary needs its own");
    }
    all.push_back(std::move(s));
  }
  return all;
}

}  // namespace lac
