// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/interruption.hpp"

namespace lac::sim {
namespace {

volatile std::sig_atomic_t requested_signal = 0;

void remember(int signal) {
  requested_signal = signal;
}

void listen(int signal, struct sigaction& before) {
  struct sigaction ours {};
  ours.sa_handler = remember;
  ours.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(signal, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(signal, &ours, nullptr);
}

}  // namespace

Interruption::Interruption() {
  requested_signal = 0;
  listen(SIGINT, interrupt_before_);
  listen(SIGTERM, terminate_before_);
}

Interruption::~Interruption() {
  sigaction(SIGINT, &interrupt_before_, nullptr);
  sigaction(SIGTERM, &terminate_before_, nullptr);
}

bool Interruption::requested() const {
  return requested_signal != 0;
}

void Interruption::check() const {
  if (requested()) throw Interrupted("interrupted: this run is given up and leaves no file");
}

}  // namespace lac::sim
