// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tuning/candidate_input.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "sim_harness/config/input_text.hpp"
#include "wrapper/chain_config.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

/// The value, blanks up to where the comment stood if there is room, the comment.
std::string with_value(const std::string& line, const std::string& value) {
  const std::size_t mark = line.find('!');
  const std::size_t width = std::max(mark, value.size() + 1);
  return value + std::string(width - value.size(), ' ') + line.substr(mark);
}

void link_entries(const fs::path& from, const fs::path& to, const fs::path& left_out) {
  fs::create_directories(to);
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    const fs::path name = entry.path().filename();
    if (name != left_out.filename()) fs::create_symlink(entry.path(), to / name);
  }
}

}  // namespace

std::string with_values(std::string_view input_text, const std::vector<KeyValue>& values) {
  std::vector<bool> placed(values.size(), false);
  std::istringstream in{std::string(input_text)};
  std::string text;
  for (std::string line; std::getline(in, line);) {
    const std::string key = key_of_input_line(line);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!equal_ignoring_case(values[i].key, key)) continue;
      line = with_value(line, values[i].value);
      placed[i] = true;
    }
    text += line + "\n";
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!placed[i]) text += values[i].value + " ! " + values[i].key + " - tuned\n";
  return text;
}

fs::path input_of_secondary(const fs::path& master_input, const std::string& secondary) {
  InputFile in = InputFile::load(master_input);
  std::vector<std::string> names;
  for (const SecondaryParams& s : SecondaryParams::read_all(in)) {
    if (equal_ignoring_case(s.name, secondary)) return s.input_file;
    names.push_back(s.name);
  }
  std::string known;
  for (const std::string& n : names) known += (known.empty() ? "" : ", ") + n;
  throw Error(master_input.string() + ": has no secondary '" + secondary + "', only " + known +
              did_you_mean(secondary, names));
}

fs::path linked_chain(const fs::path& master_input, const fs::path& changed,
                      const std::string& text, const fs::path& folder) {
  const fs::path chain = fs::absolute(master_input).lexically_normal().parent_path();
  if (fs::absolute(changed).lexically_normal().parent_path() != chain) {
    throw Error(changed.string() + ": expected beside " + master_input.string() +
                ", which names it: only then can it be replaced for a flight");
  }
  const fs::path copy = folder / chain.filename();
  try {
    link_entries(chain.parent_path(), folder, chain);
    link_entries(chain, copy, changed);
  } catch (const fs::filesystem_error& e) {
    throw Error(folder.string() + ": cannot link the input files: " + e.code().message());
  }
  std::ofstream file(copy / changed.filename(), std::ios::binary);
  file << text;
  file.close();
  if (!file) throw Error((copy / changed.filename()).string() + ": cannot be written");
  return copy / master_input.filename();
}

}  // namespace lac::sim
