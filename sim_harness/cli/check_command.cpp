// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <ostream>

#include "core/error.hpp"
#include "sim_harness/cli/chain_observation.hpp"
#include "sim_harness/cli/commands.hpp"
#include "sim_harness/cli/temporary_folder.hpp"
#include "sim_harness/host/controller_host.hpp"
#include "sim_harness/output/text_table.hpp"
#include "wrapper/chain.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

/// What the first call meets.
struct Trial {
  std::vector<float> array;  // what the host sent
  fs::path master;
  std::string out_name;
  std::vector<std::string> warnings;
};

/// The array of our host, and in it a turbine at work above rated, as any controller could meet it.
Trial prepare_trial(const fs::path& input, const fs::path& folder) {
  HostSetup setup;
  setup.library_folders = folders_beside_program();
  setup.input_file = input.string();
  setup.output_root = (folder / "check").string();
  setup.initial_pitch_rad = 0.2;
  ControllerHost host(setup, [](double, const std::string&) {});
  host.set_lidar({}, false);
  SwapView swap = host.swap();
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

/// The names of those who touch one of the records.
std::string users(const std::vector<SecondaryAccess>& all, int first, int last,
                  std::vector<bool> ObservedArray::Accesses::*how) {
  std::string names;
  for (const SecondaryAccess& s : all) {
    const std::vector<bool>& touched = s.accesses.*how;
    const bool any =
        std::any_of(touched.begin() + first, touched.begin() + last + 1, [](bool t) { return t; });
    if (any) names += (names.empty() ? "" : ", ") + s.name;
  }
  return names;
}

void add_row(const std::vector<SecondaryAccess>& all, const std::string& record,
             const std::string& name, int first, int last, bool from_host, TextTable& table,
             std::vector<std::string>& unwritten) {
  std::string writers = users(all, first, last, &ObservedArray::Accesses::written);
  const std::string readers = users(all, first, last, &ObservedArray::Accesses::read);
  if (writers.empty() && readers.empty()) return;
  if (from_host) writers = writers.empty() ? "host" : "host, " + writers;
  if (writers.empty()) unwritten.push_back(name + " (" + record + ") by " + readers);
  table.add_row({record, name, writers.empty() ? "nobody" : writers, readers});
}

void print_records_in_use(const WrapperParams& chain, const std::vector<SecondaryAccess>& all,
                          std::ostream& out) {
  TextTable table({"record", "name", "written by", "read by"});
  std::vector<std::string> unwritten;
  for (int record = 1; record <= kPrivateArraySize; ++record) {
    if (record == kNativeLidarBlock.first || record == kOpenFastLidarBlock.first) {
      const bool native = record == kNativeLidarBlock.first;
      const RecordBlock& block = native ? kNativeLidarBlock : kOpenFastLidarBlock;
      add_row(all, std::to_string(block.first) + "-" + std::to_string(block.last()),
              std::string(block.name), block.first, block.last(),
              native && chain.lidar == HostLidar::Native, table, unwritten);
      record = block.last();
      continue;
    }
    const RecordInfo* info = find_record(record);
    const bool from_host = info == nullptr ? record <= kPlatformBlock.last()
                                           : info->writer == "host" || info->writer == "wrapper";
    add_row(all, std::to_string(record), info != nullptr ? std::string(info->name) : "-", record,
            record, from_host, table, unwritten);
  }
  out << table.text();
  for (const std::string& text : unwritten) out << "read, but written by nobody: " << text << '\n';
}

/// A lidar block that somebody reads and the master does not pass on.
void warn_of_lidar_layout(const WrapperParams& chain, const std::vector<SecondaryAccess>& all,
                          std::ostream& out) {
  if (chain.lidar == HostLidar::Native) return;
  const std::string readers =
      users(all, kNativeLidarBlock.first, kNativeLidarBlock.last(), &ObservedArray::Accesses::read);
  if (readers.empty()) return;
  out << "warning: " << chain.file.string() << ": LidarLayout is "
      << (chain.lidar == HostLidar::None ? "none" : "guo") << ", but " << readers
      << " reads the native lidar block (" << kNativeLidarBlock.first << '-'
      << kNativeLidarBlock.last() << "), which stays empty; expected LidarLayout native\n";
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
  InputFile in = InputFile::load(wrapper_input);
  const WrapperParams chain = WrapperParams::read(in);
  require_output_folder(chain);
  const TemporaryFolder folder;
  Trial trial = prepare_trial(wrapper_input, folder.path());
  try_master(chain, trial);
  print_order(chain, trial, out);
  for (const std::string& text : trial.warnings) out << "warning: " << text << '\n';
  const std::vector<SecondaryAccess> all =
      observe_chain(chain, trial.master.parent_path(), trial.array, trial.out_name);
  out << "\nRecords in use, as observed over " << kObservedSteps << " steps"
      << (ObservedArray::available() ? "" : " (reads cannot be observed on this system)")
      << "; those of the call itself are left out:\n";
  print_records_in_use(chain, all, out);
  warn_of_lidar_layout(chain, all, out);
  const std::string problems = problems_of(all);
  if (!problems.empty()) throw Error(problems);
  out << "\nThe chain is ready to fly.\n";
}

}  // namespace lac::sim
