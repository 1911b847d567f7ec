// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <ostream>

#include "core/error.hpp"
#include "sim_harness/cli/chain_observation.hpp"
#include "sim_harness/cli/commands.hpp"
#include "sim_harness/cli/temporary_folder.hpp"
#include "sim_harness/host/controller_host.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

/// A turbine at work above rated, as any controller could meet it.
HostInputs level_flight() {
  HostInputs in;
  in.pitch_rad = 0.2;
  in.rotor_speed_radps = 1.26;
  in.generator_speed_radps = 122.0;
  in.shaft_torque_Nm = 4.0e6;
  in.thrust_N = 4.0e5;
  in.hub_wind_mps = 16.0;
  return in;
}

struct FirstCall {
  std::vector<float> array;  // what the host sent
  fs::path master;
  std::vector<std::string> warnings;
};

/// The real master, its first and its last call.
FirstCall try_master(const fs::path& input, const std::string& out_root) {
  FirstCall result;
  HostSetup setup;
  setup.library_folders = folders_beside_program();
  setup.input_file = input.string();
  setup.output_root = out_root;
  setup.initial_pitch_rad = level_flight().pitch_rad;
  ControllerHost host(setup,
                      [&](double, const std::string& text) { result.warnings.push_back(text); });
  host.set_lidar({}, false);
  host.call(level_flight());
  SwapView swap = host.swap();
  result.array.assign(swap.data(), swap.data() + swap.size());
  result.master = fs::weakly_canonical(host.library_path());
  host.finish();
  return result;
}

void print_order(const WrapperParams& chain, const FirstCall& first, std::ostream& out) {
  out << "Master: " << first.master.string() << '\n';
  TextTable table({"call", "name", "library", "entry", "input file"});
  for (std::size_t i = 0; i < chain.secondaries.size(); ++i) {
    const SecondaryParams& s = chain.secondaries[i];
    const DisconLibrary library = chain.open_library(s, first.master.parent_path());
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

void print_records_in_use(const std::vector<SecondaryAccess>& all, std::ostream& out) {
  TextTable table({"record", "name", "written by", "read by"});
  std::vector<std::string> unwritten;
  for (int record = 1; record <= kPrivateArraySize; ++record) {
    if (record == kNativeLidarBlock.first || record == kOpenFastLidarBlock.first) {
      const RecordBlock& block =
          record == kNativeLidarBlock.first ? kNativeLidarBlock : kOpenFastLidarBlock;
      add_row(all, std::to_string(block.first) + "-" + std::to_string(block.last()),
              std::string(block.name), block.first, block.last(), true, table, unwritten);
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

}  // namespace

void check_command(const fs::path& wrapper_input, std::ostream& out) {
  InputFile in = InputFile::load(wrapper_input);
  const WrapperParams chain = WrapperParams::read(in);
  const TemporaryFolder folder;
  const std::string out_root = (folder.path() / "check").string();
  const FirstCall first = try_master(wrapper_input, out_root);
  print_order(chain, first, out);
  for (const std::string& text : first.warnings) out << "first call says: " << text << '\n';
  const std::vector<SecondaryAccess> all =
      observe_chain(chain, first.master.parent_path(), first.array, out_root);
  out << "\nRecords in use, as observed over " << kObservedSteps << " steps"
      << (ObservedArray::available() ? "" : " (reads cannot be observed on this system)")
      << "; those of the call itself are left out:\n";
  print_records_in_use(all, out);
  for (const SecondaryAccess& s : all) {
    if (!s.problem.empty()) out << s.name << " was not observed to the end: " << s.problem << '\n';
  }
  out << "\nThe chain is ready to fly.\n";
}

}  // namespace lac::sim
