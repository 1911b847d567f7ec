// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/access_observer.hpp"

#include <bit>
#include <cstdint>

#include "core/error.hpp"
#include "sim_harness/cli/instruction_width.hpp"

#if defined(__linux__) && defined(__x86_64__)
#define LAC_CAN_TRAP 1
#include <signal.h>
#include <sys/mman.h>
#include <ucontext.h>
#include <unistd.h>
#endif

namespace lac::sim {

#if LAC_CAN_TRAP
namespace {

constexpr std::size_t kPage = 4096;
constexpr greg_t kSingleStep = 0x100;  // trap flag of the processor
constexpr greg_t kWriteAccess = 0x2;   // of the page fault

/// What the signal handlers know.
struct Watch {
  float* first = nullptr;
  std::size_t bytes = 0;
  ObservedArray::Accesses* accesses = nullptr;
  struct sigaction old_segv {};
  struct sigaction old_trap {};
};
Watch watched;

void protect(int access) {
  mprotect(watched.first, watched.bytes, access);
}

void on_fault(int, siginfo_t* info, void* context) {
  const auto offset = reinterpret_cast<std::uintptr_t>(info->si_addr) -
                      reinterpret_cast<std::uintptr_t>(watched.first);
  if (offset >= watched.bytes) {
    sigaction(SIGSEGV, &watched.old_segv, nullptr);  // not ours: comes again and is told
    return;
  }
  auto* registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
  const bool write = (registers[REG_ERR] & kWriteAccess) != 0;
  auto& touched = write ? watched.accesses->written : watched.accesses->read;
  const auto* code = reinterpret_cast<const std::uint8_t*>(registers[REG_RIP]);  // NOLINT
  const std::size_t last = (offset + memory_operand_bytes(code) - 1) / sizeof(float);
  for (std::size_t i = offset / sizeof(float); i <= last && i + 1 < touched.size(); ++i) {
    touched[i + 1] = true;
  }
  protect(PROT_READ | PROT_WRITE);
  registers[REG_EFL] |= kSingleStep;
}

void on_step(int, siginfo_t*, void* context) {
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_EFL] &= ~kSingleStep;
  protect(PROT_NONE);
}

void install(int signal, void (*handler)(int, siginfo_t*, void*), struct sigaction& old) {
  struct sigaction action {};
  action.sa_sigaction = handler;
  action.sa_flags = SA_SIGINFO;
  sigaction(signal, &action, &old);
}

}  // namespace

bool ObservedArray::available() {
  return true;
}

ObservedArray::ObservedArray(int size) : size_(size) {
  bytes_ = (static_cast<std::size_t>(size) * sizeof(float) + kPage - 1) / kPage * kPage;
  void* memory = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw Error("no memory for the array to be observed");
  data_ = static_cast<float*>(memory);
}

ObservedArray::~ObservedArray() {
  munmap(data_, bytes_);
}

void ObservedArray::begin(Accesses& into) {
  watched.first = data_;
  watched.bytes = bytes_;
  watched.accesses = &into;
  install(SIGSEGV, on_fault, watched.old_segv);
  install(SIGTRAP, on_step, watched.old_trap);
  protect(PROT_NONE);
}

void ObservedArray::end() noexcept {
  protect(PROT_READ | PROT_WRITE);
  sigaction(SIGSEGV, &watched.old_segv, nullptr);
  sigaction(SIGTRAP, &watched.old_trap, nullptr);
}

#else

bool ObservedArray::available() {
  return false;
}

ObservedArray::ObservedArray(int size) : size_(size), data_(new float[size]{}) {}

ObservedArray::~ObservedArray() {
  delete[] data_;
}

void ObservedArray::begin(Accesses& into) {
  accesses_ = &into;
  before_.assign(data_, data_ + size_);
}

void ObservedArray::end() noexcept {
  for (int i = 0; i < size_; ++i) {
    const bool same = std::bit_cast<std::uint32_t>(data_[i]) ==
                      std::bit_cast<std::uint32_t>(before_[static_cast<std::size_t>(i)]);
    if (!same) accesses_->written[static_cast<std::size_t>(i) + 1] = true;
  }
}

#endif

}  // namespace lac::sim
