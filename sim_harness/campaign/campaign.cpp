// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/campaign.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <optional>
#include <thread>

#include "core/error.hpp"
#include "core/locked_file.hpp"
#include "core/part_file.hpp"
#include "core/system_reason.hpp"
#include "sim_harness/campaign/campaign_plan.hpp"
#include "sim_harness/campaign/fleet.hpp"
#include "sim_harness/campaign/result_table.hpp"
#include "sim_harness/campaign_report/campaign_page.hpp"
#include "sim_harness/output/page_parts.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

// The flights of a campaign that was killed end within moments.
constexpr int kLockTries = 20;
constexpr std::chrono::milliseconds kLockPause{100};

double seconds_now() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

/// Processor time of the processes that have ended.
double processor_time_s() {
  rusage used{};
  ::getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// While one lives, no other campaign flies into this folder.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder) {
    std::error_code problem;
    fs::create_directories(folder, problem);
    if (problem) throw Error(folder.string() + ": cannot be created: " + problem.message());
    const fs::path path = folder / "lock";
    int code = file_.open(path);
    for (int i = 0; i < kLockTries && code == LockedFile::kInUse; ++i) {
      std::this_thread::sleep_for(kLockPause);
      code = file_.open(path);
    }
    if (code == LockedFile::kInUse)
      throw Error(folder.string() + ": another campaign is flying into this folder");
    if (code != 0) throw Error(path.string() + ": cannot be opened: " + system_reason(code));
  }

 private:
  LockedFile file_;
};

fs::path program_path() {
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  return unknown ? fs::path("lac") : program;
}

constexpr const char* kStudyFile = "study.txt";  // of the folder: whose results these are

/// The table of another study is not overwritten. Folders of earlier versions say nothing.
void require_own_folder(const Study& study) {
  std::ifstream in(study.folder / kStudyFile);
  std::string name;
  if (!std::getline(in, name) || name == study.file.filename().string()) return;
  throw Error(study.folder.string() + ": holds the results of study '" + name + "', not of '" +
              study.file.filename().string() +
              "', and one folder has one table; --output names another folder (the same study "
              "renamed: remove " +
              kStudyFile + " there)");
}

void write_study_name(const Study& study) {
  write_whole_file(study.folder / kStudyFile, study.file.filename().string() + '\n');
}

void write_commands(const CampaignPlan& plan) {
  PartFile file(plan.study.folder / "cases.txt");
  for (const StudyCase& c : plan.cases) {
    const std::string line = command_line(plan.study, c, program_path()) + '\n';
    file.write(line.data(), line.size());
  }
  file.commit();
}

std::string cases_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " case" : " cases");
}

/// What there is and what is to come, in one or two lines.
void announce(const CampaignPlan& plan, std::size_t to_fly, std::size_t winds, bool only_failed,
              std::ostream& out) {
  const auto outdated = static_cast<std::size_t>(
      std::ranges::count_if(plan.outdated, [](CaseState s) { return s != CaseState::kOpen; }));
  const std::size_t failed = plan.count(CaseState::kFailed);
  out << plan.study.name << ": " << cases_text(plan.cases.size()) << ", "
      << plan.count(CaseState::kDone) << " done, " << failed << " failed before, " << to_fly
      << " to fly in " << winds << (winds == 1 ? " wind" : " winds") << '\n';
  if (outdated > 0)
    out << "note: " << cases_text(outdated)
        << " there are of other inputs or of another program; they do not count\n";
  if (failed > 0 && !only_failed)
    out << "note: failed cases are left as they are; --only failed flies them again\n";
}

void fly_orders(const CampaignPlan& plan, std::vector<WindOrder> orders, std::size_t cases,
                int jobs, std::ostream& out) {
  const double start_s = seconds_now();
  const double used_s = processor_time_s();
  const Interruption interruption;
  {
    CampaignProgress progress(plan.study.name, cases, progress_style_of_stderr(), std::cerr,
                              seconds_now);
    Fleet(std::move(orders), jobs, progress).fly(interruption);
  }
  const double took_s = std::max(seconds_now() - start_s, 1e-3);
  const double busy = (processor_time_s() - used_s) / (took_s * jobs);
  out << (interruption.requested() ? "interrupted after " : "flown in ") << duration_text(took_s)
      << ", " << jobs << (jobs == 1 ? " core" : " cores") << " busy for "
      << std::lround(100.0 * busy) << " % of it\n";
}

/// The page, if there is something to compare. What cannot be compared fails no campaign.
void write_report(const CampaignPlan& plan, const fs::path& table, std::ostream& out) {
  CampaignReportOptions options;
  options.inputs = {table};
  options.title = plan.study.name;
  try {
    const CampaignReport report = campaign_report(options);
    if (report.views.front().comparisons.empty()) {
      out << "no report: "
          << (report.notes.empty() ? "one controller, nothing to compare" : report.notes.front())
          << '\n';
      return;
    }
    const fs::path page = page_beside(table);
    write_page(page, campaign_page(report));
    out << "wrote " << page.string() << '\n';
  } catch (const Error& e) {
    out << "no report: " << e.what() << '\n';
  }
}

/// The table, the page, and what is to be said at the end.
bool finish(CampaignPlan& plan, bool with_report, std::ostream& out) {
  look_again(plan);
  const fs::path table = plan.study.folder / "results.csv";
  write_result_table(table, plan.study, plan.cases, plan.markers);
  const std::size_t done = plan.count(CaseState::kDone);
  const std::size_t failed = plan.count(CaseState::kFailed);
  out << done << " of " << cases_text(plan.cases.size()) << " done, " << failed << " failed\n"
      << "wrote " << table.string() << '\n';
  if (with_report && done > 0) write_report(plan, table, out);
  if (done + failed < plan.cases.size()) out << "the same command goes on with the rest\n";
  return done == plan.cases.size();
}

}  // namespace

bool run_campaign(const CampaignOptions& options, std::ostream& out) {
  CampaignPlan plan = plan_campaign(options.study, options.output);
  if (options.list) return list_cases(plan, out), true;
  require_own_folder(plan.study);
  std::optional<FolderLock> lock;
  if (!options.dry_run) {
    lock.emplace(plan.study.folder);
    look_again(plan);  // another campaign may have ended in between
  }
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int jobs = options.jobs > 0 ? options.jobs : cores;
  const std::vector<std::size_t> cases = cases_to_fly(plan, options.only_failed);
  std::vector<WindOrder> orders = wind_orders(plan, cases, jobs);
  announce(plan, cases.size(), orders.size(), options.only_failed, out);
  if (options.dry_run) {
    for (const std::size_t i : cases)
      out << command_line(plan.study, plan.cases[i], program_path()) << '\n';
    return true;
  }
  write_study_name(plan.study);
  write_commands(plan);
  if (!orders.empty()) fly_orders(plan, std::move(orders), cases.size(), jobs, out);
  return finish(plan, options.report, out);
}

}  // namespace lac::sim
