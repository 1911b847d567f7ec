// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/written_table.hpp"

#include <ostream>

#include "core/part_file.hpp"

namespace lac::sim {

void write_table(const std::filesystem::path& file, const std::string& text, std::ostream& out) {
  if (file.empty()) return;
  PartFile table(file);
  table.write(text.data(), text.size());
  table.commit();
  out << "wrote " << file.string() << '\n';
}

}  // namespace lac::sim
