// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/option_effect.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr const char* kOfFolders[] = {"--from", "--to", "--woehler", "--reference", "--rainflow"};
constexpr const char* kOfTables[] = {"--where", "--pair-by", "--column"};

[[noreturn]] void refuse(const std::string& option, const std::string& reason) {
  throw Error(option + " has no effect: " + reason);
}

}  // namespace

void require_effect(const CLI::App& command, const std::vector<std::filesystem::path>& inputs) {
  const auto is_folder = [](const std::filesystem::path& p) {
    return std::filesystem::is_directory(p);
  };
  for (const char* option : kOfFolders) {
    if (command.count(option) > 0 && std::ranges::none_of(inputs, is_folder))
      refuse(option,
             "the figures of a table are computed already, it is for folders of results; "
             "of a table give it to lac stats");
  }
  for (const char* option : kOfTables) {
    if (command.count(option) > 0 && std::ranges::all_of(inputs, is_folder))
      refuse(option, "it is for tables; the runs of folders are paired by their file names");
  }
}

void require_table(const CLI::App& command, const std::string& option,
                   const std::filesystem::path& input) {
  if (command.count(option) == 0 || !std::filesystem::is_directory(input)) return;
  refuse(option, input.string() +
                     " is a folder, which holds the results of one controller; the "
                     "controllers of a table have names");
}

}  // namespace lac::sim
