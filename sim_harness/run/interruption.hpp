// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>

#include "core/error.hpp"

namespace lac::sim {

/// The user or the system has asked to stop: no fault of the case.
class Interrupted : public Error {
 public:
  using Error::Error;
};

/// While one lives, the first SIGINT (Ctrl-C) or SIGTERM does not end the process but asks to
/// stop: files that were begun are then removed on the way out. The second one ends it at once.
/// One at a time in a process.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  bool requested() const;
  /// Throws Interrupted if it is requested.
  void check() const;

 private:
  struct sigaction interrupt_before_ {};
  struct sigaction terminate_before_ {};
};

}  // namespace lac::sim
