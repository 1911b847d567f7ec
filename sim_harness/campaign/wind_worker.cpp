// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/wind_worker.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <iostream>
#include <new>
#include <optional>

#include "core/error.hpp"
#include "core/system_reason.hpp"
#include "sim_harness/campaign/process_copy.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

fs::path log_of(const MarkedCase& c) {
  return c.folder / "log.txt";
}

/// Unless another process is at this case.
void mark_failed(const MarkedCase& c, const std::string& fingerprint, const std::string& reason) {
  try {
    MarkerWriter(c.folder, fingerprint).failed(reason);
  } catch (const Error& e) {
    std::cerr << e.what() << '\n';
  }
}

/// The side of the worker that makes the wind.
class Flights {
 public:
  Flights(const WindOrder& order, int reports) : order_(order), reports_(reports) {}

  int run() {
    for (const MarkedCase& c : order_.cases) {
      fs::create_directories(c.folder);
      fs::remove(log_of(c));
    }
    redirect_to(log_of(order_.cases.front()));
    const std::string problem = make_wind();
    for (std::size_t i = 0; i < order_.cases.size(); ++i) {
      if (problem.empty()) {
        fly(order_.cases[i], order_.fingerprints[i]);
      } else {
        mark_failed(order_.cases[i], order_.fingerprints[i], problem);
      }
      const char ended = 1;
      if (::write(reports_, &ended, 1) != 1) return 1;
    }
    return 0;
  }

 private:
  std::string make_wind() {
    try {
      const MarkedCase& first = order_.cases.front();
      wind_ = make_case_wind(load_case(first.case_file, first.overrides));
      return {};
    } catch (const std::bad_alloc&) {
      return "not enough memory for the wind";
    } catch (const std::exception& e) {
      return e.what();
    }
  }

  void fly(const MarkedCase& c, const std::string& fingerprint) {
    const int status = wait_for(start_copy([&] {
      redirect_to(log_of(c));
      if (order_.time_limit_s > 0.0) {
        std::signal(SIGALRM, SIG_DFL);
        ::alarm(static_cast<unsigned>(std::ceil(order_.time_limit_s)));
      }
      fly_marked(c, fingerprint, &*wind_, std::cout);
      return 0;
    }));
    const CaseMarker marker = read_marker(c.folder);
    if (marker.state == CaseState::kOpen || marker.fingerprint != fingerprint)
      mark_failed(c, fingerprint, why(status));
  }

  std::string why(int status) const {
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
      return "took longer than time_limit_s allows";
    return "the process " + describe_end(status);
  }

  const WindOrder& order_;
  int reports_;
  std::optional<CaseWind> wind_;
};

}  // namespace

WindWorker::WindWorker(WindOrder order) : order_(std::move(order)) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw Error("no pipe to a process: " + system_reason(errno));
  reports_ = ends[0];
  try {
    process_ = start_copy([&] { return Flights(order_, ends[1]).run(); });
  } catch (...) {
    ::close(ends[0]);
    ::close(ends[1]);
    throw;
  }
  ::close(ends[1]);
}

WindWorker::~WindWorker() {
  if (!ended()) {
    ::kill(process_, SIGKILL);
    wait_for(process_);
  }
  ::close(reports_);
}

std::vector<MarkedCase> WindWorker::take_reports() {
  std::array<char, 64> bytes{};
  const ssize_t count = ::read(reports_, bytes.data(), bytes.size());
  const std::size_t before = reported_;
  if (count > 0) {
    reported_ += static_cast<std::size_t>(count);
  } else if (count == 0 || errno != EINTR) {
    const int status = wait_for(process_);
    process_ = 0;
    mark_rest("the process that makes the wind " + describe_end(status));
    reported_ = order_.cases.size();
  }
  const auto at = [&](std::size_t i) {
    return order_.cases.begin() + static_cast<std::ptrdiff_t>(i);
  };
  return {at(before), at(reported_)};
}

void WindWorker::mark_rest(const std::string& reason) {
  for (std::size_t i = reported_; i < order_.cases.size(); ++i)
    mark_failed(order_.cases[i], order_.fingerprints[i], reason);
}

}  // namespace lac::sim
