// SPDX-License-Identifier: Apache-2.0
#include <ostream>

#include "core/input_file.hpp"
#include "core/swap_layout.hpp"
#include "sim_harness/cli/commands.hpp"
#include "sim_harness/cli/trace_summary.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {
namespace {

float sent_first(const TraceSummary& s, int record) {
  const auto i = static_cast<std::size_t>(record) - 1;
  return i < s.first.sent.size() ? s.first.sent[i] : 0.0F;
}
std::string number_first(const TraceSummary& s, Rec record) {
  return shortest(static_cast<double>(sent_first(s, static_cast<int>(record))));
}

void print_calls(const TraceSummary& s, std::ostream& out) {
  out << "Calls: " << s.calls << " (status: calls";
  for (const auto& [status, count] : s.statuses) out << ", " << status << ": " << count;
  out << "); step " << shortest(s.step_s) << " s, to " << shortest(s.last_time_s) << " s\n";
  if (!s.last_answered) out << "The last call was not answered: the process ended in it.\n";
  if (!s.array_kept) out << "Demands do not come back with the next call: a fresh array each.\n";
}

void print_strings(const TraceSummary& s, std::ostream& out) {
  const auto length = [&](Rec record, const std::string& text) {
    const double counted = static_cast<double>(sent_first(s, static_cast<int>(record)));
    return shortest(counted) +
           (counted == static_cast<double>(text.size() + 1) ? ", terminator counted" : "");
  };
  out << "Input file: '" << s.first.in_file
      << "' (record 50: " << length(Rec::InFileLength, s.first.in_file) << ")\nRoot name:  '"
      << s.first.out_name << "' (record 51: " << length(Rec::OutNameLength, s.first.out_name)
      << ")\nMessage: " << number_first(s, Rec::MessageCapacity)
      << " characters; logging: " << number_first(s, Rec::LogCapacity) << " values from record "
      << number_first(s, Rec::LogStart) << ", names " << number_first(s, Rec::OutNameCapacity)
      << " characters\n";
}

void print_lidar(const TraceSummary& s, std::ostream& out) {
  out << "Lidar: ";
  if (const float version = sent_first(s, kNativeLidarBlock.first); version != 0.0F) {
    out << "native block at " << kNativeLidarBlock.first << ", layout "
        << shortest(static_cast<double>(version)) << '\n';
    return;
  }
  const int first = kOpenFastLidarBlock.first;
  const float type = sent_first(s, first + openfast_lidar::kSensorType);
  if (type == 0.0F) {
    out << "none in the blocks of OpenFAST and of LAC Chain\n";
    return;
  }
  const char* names[] = {"none", "single point", "continuous wave", "pulsed"};
  out << "OpenFAST's block at " << first << ", sensor type " << shortest(static_cast<double>(type))
      << " (" << (type >= 1.0F && type <= 3.0F ? names[static_cast<int>(type)] : "unknown") << "), "
      << shortest(static_cast<double>(sent_first(s, first + openfast_lidar::kNumberOfBeams)))
      << " beams, "
      << shortest(static_cast<double>(sent_first(s, first + openfast_lidar::kNumberOfGates)))
      << " gates\n";
}

void print_messages(const TraceSummary& s, std::ostream& out) {
  for (const auto& [text, m] : s.messages) {
    out << (m.fail < 0 ? "Failure" : "Warning") << ", " << m.count << " calls, first at "
        << shortest(m.first_time_s) << " s: " << text << '\n';
  }
}

void print_histories(const char* title, const std::vector<RecordHistory>& all, std::ostream& out) {
  TextTable table({"record", "name", "unit", "first", "smallest", "largest", "changes"});
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].seen) continue;
    const RecordInfo* info = find_record(static_cast<int>(i) + 1);
    table.add_row({std::to_string(i + 1), info != nullptr ? std::string(info->name) : "-",
                   info != nullptr ? std::string(info->unit) : "-",
                   shortest(static_cast<double>(all[i].first)),
                   shortest(static_cast<double>(all[i].smallest)),
                   shortest(static_cast<double>(all[i].largest)), std::to_string(all[i].changes)});
  }
  out << '\n' << title << '\n' << table.text();
}

}  // namespace

void trace_command(const std::filesystem::path& file, std::ostream& out) {
  TraceReader trace(file);
  const TraceSummary s(trace);
  out << "Trace: " << file.string() << ", " << trace.records() << " records, compiler of the probe "
      << trace.compiler() << '\n';
  if (s.calls == 0) {
    out << "no calls\n";
    return;
  }
  print_calls(s, out);
  print_strings(s, out);
  print_lidar(s, out);
  print_messages(s, out);
  print_histories("Sent by the host (records that it filled or changed):", s.host, out);
  print_histories("Written by the controller (records that it changed):", s.controller, out);
}

}  // namespace lac::sim
