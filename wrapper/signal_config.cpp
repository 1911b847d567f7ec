// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/suggest.hpp"
#include "core/swap_layout.hpp"
#include "wrapper/chain_config.hpp"
#include "wrapper/numbered_rows.hpp"

namespace lac {
namespace {

constexpr const char* kPrefix = "Signal_";

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

void check_name(const InputFile& in, const std::string& key, const std::string& name) {
  const bool plain = !name.empty() && is_letter(name[0]) && std::ranges::all_of(name, [](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
  });
  if (!plain) {
    in.fail(key, "found the name '" + name + "', expected letters, digits and _, a letter first");
  }
  for (const RecordInfo& r : kRecords) {
    if (equal_ignoring_case(r.name, name)) {
      in.fail(key,
              "the name '" + name + "' is taken: it is that of record " + std::to_string(r.index));
    }
  }
  if (raw_record(name) != 0) in.fail(key, "found the name '" + name + "', which means a record");
}

NamedSignal read_row(InputFile& in, const std::string& key) {
  const std::vector<std::string> words = in.texts(key);
  if (words.size() < 2 || words.size() > 3) {
    in.fail(key, "found " + std::to_string(words.size()) +
                     " words, expected \"name\" record [\"unit\"]");
  }
  NamedSignal s{words[0], whole_number(words[1], 0), words.size() == 3 ? words[2] : "-"};
  check_name(in, key, s.name);
  if (s.record < kSignalBlock.first || s.record > kSignalBlock.last()) {
    in.fail(key, "found record '" + words[1] + "', expected a number from " +
                     std::to_string(kSignalBlock.first) + " to " +
                     std::to_string(kSignalBlock.last()));
  }
  return s;
}

}  // namespace

std::vector<NamedSignal> NamedSignal::read_all(InputFile& in) {
  std::vector<NamedSignal> all;
  const int count = count_numbered_rows(in, kPrefix, kSignalBlock.size, "signals");
  for (int n = 1; n <= count; ++n) {
    const std::string key = kPrefix + std::to_string(n);
    NamedSignal s = read_row(in, key);
    for (const NamedSignal& o : all) {
      if (equal_ignoring_case(o.name, s.name)) {
        in.fail(key, "the name '" + s.name + "' is taken; each signal needs its own");
      }
      if (o.record == s.record) {
        in.fail(key, "record " + std::to_string(s.record) + " is taken by '" + o.name + "'");
      }
    }
    all.push_back(std::move(s));
  }
  return all;
}

}  // namespace lac
