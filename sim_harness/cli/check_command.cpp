// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <ostream>

#include "core/error.hpp"
#include "sim_harness/cli/chain_observation.hpp"
#include "sim_harness/cli/commands.hpp"
#include "sim_harness/cli/record_map.hpp"
#include "sim_harness/config/temporary_folder.hpp"
#include "sim_harness/host/controller_host.hpp"
#include "sim_harness/output/text_table.hpp"
#include "wrapper/chain.hpp"
#include "wrapper/guo_wrapper_file.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

/// The chain that the master would make of the file, of our form or of Guo's.
WrapperParams read_chain(const fs::path& file, Notice& notice) {
  if (std::optional<WrapperParams> theirs = read_guo_wrapper_file(file, notice)) return *theirs;
  InputFile in = InputFile::load(file);
  return WrapperParams::read(in);
}

/// What the first call meets.
struct Trial {
  std::vector<float> array;  // what the host sent
  fs::path master;
  std::string out_name;
  std::vector<std::string> warnings;
};

/// The array of our host, and in it a turbine at work above rated, as any controller could meet it.
Trial prepare_trial(const fs::path& input, HostLidar lidar, const fs::path& folder) {
  HostSetup setup;
  setup.library_folders = folders_beside_program();
  setup.input_file = input.string();
  setup.output_root = (folder / "check").string();
  setup.initial_pitch_rad = 0.2;
  ControllerHost host(setup, [](double, const std::string&) {});
  SwapView swap = host.swap();
  place_lidar(lidar, swap, 0.0, false);
  for (const Rec blade : {Rec::PitchBlade1, Rec::PitchBlade2, Rec::PitchBlade3}) {
    swap.set(blade, setup.initial_pitch_rad);
  }
  swap.set(Rec::RotorSpeed, 1.26);
  swap.set(Rec::GeneratorSpeed, 122.0);
  swap.set(Rec::ShaftPower, 5.0e6);
  swap.set(Rec::HubWindSpeed, 16.0);
  return {std::vector<float>(swap.data(), swap.data() + swap.size()),
          fs::weakly_canonical(host.library_path()),
          setup.output_root + ".SrvD",
          {}};
}

/// The first and the last call of the master, whose own output is left out: the file it would
/// replace may be a result of the user's.
void try_master(WrapperParams chain, Trial& trial) {
  chain.output.enabled = false;
  std::vector<float> array = trial.array;
  const SwapView host(array.data(), static_cast<int>(array.size()));
  StartInfo start;
  start.input_file = chain.file;
  start.out_name = trial.out_name;
  start.time_step_s = HostSetup{}.time_step_s;
  Chain master(std::move(chain), start, host, trial.master.parent_path());
  for (const bool first : {true, false}) {
    Notice notice;
    if (first) {
      master.step(host, 0.0, notice);
    } else {
      master.finish(host, notice);
    }
    const std::string text = (first ? "first call: " : "last call: ") + std::string(notice.text());
    if (notice.level() < 0) throw Error(text);
    if (notice.level() > 0) trial.warnings.push_back(text);
  }
}

/// An output file that the master could not create is found here: the trial does not try.
void require_output_folder(const WrapperParams& chain) {
  const fs::path& file = chain.output.file;
  if (!chain.output.enabled || !file.is_absolute() || fs::is_directory(file.parent_path())) return;
  throw Error(chain.file.string() + ": OutputFile: " + file.string() +
              " cannot be created: there is no such folder");
}

void print_order(const WrapperParams& chain, const Trial& trial, std::ostream& out) {
  out << "Master: " << trial.master.string() << '\n';
  TextTable table({"call", "name", "library", "entry", "input file"});
  for (std::size_t i = 0; i < chain.secondaries.size(); ++i) {
    const SecondaryParams& s = chain.secondaries[i];
    const DisconLibrary library = chain.open_library(s, trial.master.parent_path());
    table.add_row({std::to_string(i + 1), s.name, fs::weakly_canonical(library.path()).string(),
                   s.entry, s.input_file.string()});
  }
  out << table.text();
}

void print_records_in_use(const std::vector<RecordUse>& map, std::ostream& out) {
  TextTable table({"record", "name", "written by", "read by"});
  for (const RecordUse& use : map) {
    std::string records = std::to_string(use.first);
    if (use.last > use.first) records.append("-").append(std::to_string(use.last));
    table.add_row({records, use.name, use.writers.empty() ? "nobody" : joined(use.writers),
                   joined(use.readers)});
  }
  out << table.text();
}

std::string problems_of(const std::vector<SecondaryAccess>& all) {
  std::string text;
  for (const SecondaryAccess& s : all) {
    if (s.problem.empty()) continue;
    text += (text.empty() ? "" : "\n") + s.name + " was not observed to the end: " + s.problem;
  }
  return text;
}

}  // namespace

void check_command(const fs::path& wrapper_input, std::ostream& out) {
  Notice found;
  const WrapperParams chain = read_chain(wrapper_input, found);
  require_output_folder(chain);
  const TemporaryFolder folder;
  Trial trial = prepare_trial(wrapper_input, chain.lidar, folder.path());
  try_master(chain, trial);
  print_order(chain, trial, out);
  if (found.level() != 0) out << "note: " << found.text() << '\n';
  for (const std::string& text : trial.warnings) out << "warning: " << text << '\n';
  const std::vector<SecondaryAccess> all =
      observe_chain(chain, trial.master.parent_path(), trial.array, trial.out_name);
  out << "\nRecords in use, as observed over " << kObservedSteps << " steps"
      << (ObservedArray::available() ? "" : " (reads cannot be observed on this system)")
      << "; those of the call itself are left out:\n";
  print_records_in_use(record_map(chain, all), out);
  for (const std::string& text : doubts(chain, all)) out << "note: " << text << '\n';
  const std::string problems = problems_of(all);
  if (!problems.empty()) throw Error(problems);
  const std::string conflict = writers_in_conflict(chain, all);
  if (!conflict.empty()) throw Error(conflict);
  out << "\nThe chain is ready to fly.\n";
}

}  // namespace lac::sim
