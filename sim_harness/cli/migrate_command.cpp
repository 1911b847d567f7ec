// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/migrate_command.hpp"

#include <fstream>
#include <ostream>

#include "core/error.hpp"
#include "core/input_file.hpp"
#include "sim_harness/cli/migrate_forms.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

std::string migrated(const fs::path& path) {
  const GuoInputFile file = GuoInputFile::load(path);
  if (file.empty()) InputFile::load(path);  // says why it cannot be opened
  if (file.is_theirs(guo_wrapper_marks())) return migrated_wrapper(file);
  if (file.is_theirs(guo_ldp_marks())) return migrated_ldp(file);
  if (file.is_theirs(guo_ffp_marks())) return migrated_ffp(file);
  throw Error(path.string() +
              ": is no WRAPPER, LDP or FFP input file of Guo's chain; files of our own form need "
              "no migration");
}

}  // namespace

void migrate_command(const MigrateOptions& options, std::ostream& out) {
  const std::string text = migrated(options.file);
  if (options.output.empty()) {
    out << text;
    return;
  }
  if (fs::exists(options.output) && !options.force) {
    throw Error(options.output.string() + ": is there already, --force replaces it");
  }
  std::ofstream file(options.output, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw Error(options.output.string() + ": cannot be written");
  out << options.output.string() << ": written; lines with '! ...' are yours to fill in\n";
}

}  // namespace lac::sim
