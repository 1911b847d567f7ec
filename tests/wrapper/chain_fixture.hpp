// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/discon_library.hpp"
#include "support/library_names.hpp"
#include "support/temp_folder.hpp"
#include "support/test_host.hpp"

namespace lac::test {

/// The built master with small controllers as secondaries, in a folder of its own.
class ChainTest : public testing::Test {
 protected:
  struct Row {
    std::string name;
    std::string library;  // in LAC_TOY_DIR
    std::string input;    // content of its input file
    std::string entry;    // empty: not in the row
  };

  static std::string master_path() { return built_library("wrapper"); }
  static std::string toy(const std::string& name) {
    return std::string(LAC_TOY_DIR) + "/lib" + name + LAC_LIBRARY_SUFFIX;
  }

  /// Writes <file> and the input files of the secondaries; gives the path of <file>.
  std::string write_chain(const std::vector<Row>& rows, const std::string& more_lines = "",
                          const std::string& file = "chain.IN") {
    std::string text = "! a chain for a test\n";
    int n = 0;
    for (const Row& row : rows) {
      const std::string input = file + "_" + row.name + ".txt";
      folder.write(input, row.input);
      const std::string library =
          std::filesystem::path(row.library).has_parent_path() ? row.library : toy(row.library);
      text += "\"" + row.name + "\" \"" + library + "\" \"" + input + "\"";
      if (!row.entry.empty()) text += " \"" + row.entry + "\"";
      text += " ! Secondary_" + std::to_string(++n) + " - row\n";
    }
    return folder.write(file, text + more_lines);
  }

  TestHost host_for(const std::string& in_file, int array_size = kExtendedArraySize) {
    return TestHost(master.entry(), in_file, folder.file("case.SrvD"), array_size);
  }

  TempFolder folder;
  DisconLibrary master = DisconLibrary::open(master_path(), "DISCON", {});
};

}  // namespace lac::test
