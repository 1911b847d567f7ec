// SPDX-License-Identifier: Apache-2.0
#include "core/discon_entry.hpp"

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/call_strings.hpp"
#include "core/chain_block.hpp"
#include "core/checkpoint.hpp"
#include "core/discon_abi.h"
#include "core/discon_module.hpp"
#include "core/error.hpp"
#include "core/instance_table.hpp"
#include "core/native_path.hpp"

namespace lac {
namespace {

/// One turbine: its module and what the entry keeps for it.
struct Instance {
  std::unique_ptr<DisconModule> module;
  StartInfo start;
  std::string in_file;          // accINFILE of the first call, byte by byte
  std::int64_t steps = 0;       // the step in hand; status 0 is step 0
  std::vector<std::byte> kept;  // by -11
  std::int64_t kept_steps = 0;
};

InstanceTable<Instance>& instances() {
  static InstanceTable<Instance> table;
  return table;
}

struct Call {
  SwapView swap;
  std::string_view in_file;
  std::string_view out_name;
  Notice& notice;
};

// What a time step can be: outside of this the record was never filled, or not as seconds.
constexpr float kShortestStep_s = 1.0e-5f;
constexpr float kLongestStep_s = 1.0e3f;

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// Record 3 is a float: 0.0125f is 0.012500000186. The shortest decimal that gives the same
/// float is what the user wrote.
double exact_time_step(const SwapReader& swap) {
  const auto step = static_cast<float>(swap.get(Rec::TimeStep));
  if (!(step >= kShortestStep_s && step <= kLongestStep_s)) {
    throw Error("record 3 (communication interval) is " + shown(step) + " s, expected " +
                shown(kShortestStep_s) + " to " + shown(kLongestStep_s) + " s");
  }
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, step);
  double value = 0.0;
  std::from_chars(text, written.ptr, value);
  return value;
}

void enter(std::unique_ptr<Instance> instance, Call& call) {
  const CallerKey key = caller_key(call.swap.data(), instance->in_file, call.out_name);
  if (!instances().enter(key, instance.get())) {
    throw Error("more than " + std::to_string(InstanceTable<Instance>::kCapacity) +
                " turbines in one process");
  }
  static_cast<void>(instance.release());  // the table owns it now
}

/// A run of the same turbine that was never ended goes before the new one comes: they would meet
/// in output files and in libraries that keep one state per process.
void end_unfinished_run(Call& call, std::string_view in_file) {
  delete instances().take(caller_key(call.swap.data(), in_file, call.out_name));
}

/// A length that is no length would otherwise read as an empty string.
void require_lengths(const Call& call) {
  for (const Rec record : {Rec::InFileLength, Rec::OutNameLength}) {
    const double length = call.swap.get(record);
    if (length >= 0.0 && length <= kLongestString) continue;
    throw Error("record " + std::to_string(static_cast<int>(record)) + " (" +
                std::string(find_record(static_cast<int>(record))->meaning) + ") is " +
                shown(length) + ", expected 0 to " + std::to_string(kLongestString));
  }
}

/// Tells the master that this library knows the chain block and every status.
void answer_master(SwapView& swap) {
  if (has_chain_block(swap)) {
    swap.set(Rec::ChainMember, 1.0);
  }
}

void first_call(Call& call) {
  require_lengths(call);
  if (call.in_file.empty()) {
    throw Error("no input file: the host passed an empty name (record 50 is " +
                shown(call.swap.get(Rec::InFileLength)) + ")");
  }
  end_unfinished_run(call, call.in_file);
  const CallerKey key = caller_key(call.swap.data(), call.in_file, call.out_name);
  if (!has_chain_block(call.swap) && instances().with_strings(key) > 0) {
    call.notice.warn(
        "another turbine of this process, or a run that was never ended, has the same input file "
        "and root name: they are told apart by the address of their arrays alone");
  }
  auto instance = std::make_unique<Instance>();
  instance->in_file = std::string(call.in_file);
  instance->start.input_file = path_from_bytes(call.in_file);
  instance->start.out_name = std::string(call.out_name);
  instance->start.time_step_s = exact_time_step(call.swap);
  instance->module = make_module(instance->start, call.swap, call.notice);
  instance->module->step(call.swap, 0.0, call.notice);
  answer_master(call.swap);
  if (call.notice.level() >= 0) enter(std::move(instance), call);
}

void load_state(DisconModule& module, const std::vector<std::byte>& bytes,
                const std::string& source) {
  StateArchive archive{std::span<const std::byte>(bytes)};
  module.visit_state(archive);
  if (!archive.complete()) {
    throw Error(source + ": the state does not fit the input file: was it changed since?");
  }
}

void restart(Call& call) {
  require_lengths(call);
  const std::filesystem::path file = path_from_bytes(call.in_file);
  const Checkpoint saved = read_checkpoint(file, module_name());
  end_unfinished_run(call, saved.input_file);
  auto instance = std::make_unique<Instance>();
  instance->in_file = saved.input_file;
  instance->start.input_file = path_from_bytes(saved.input_file);
  instance->start.out_name = saved.out_name;
  instance->start.time_step_s = saved.time_step_s;
  instance->start.checkpoint = file;
  instance->start.steps = saved.steps;
  instance->steps = saved.steps;
  instance->module = make_module(instance->start, call.swap, call.notice);
  load_state(*instance->module, saved.state, file.string());
  instance->module->restart(file, call.swap, call.notice);
  answer_master(call.swap);
  if (call.notice.level() >= 0) enter(std::move(instance), call);
}

void checkpoint(Instance& instance, Call& call) {
  const CallerKey own = caller_key(call.swap.data(), instance.in_file, instance.start.out_name);
  if (instances().with_strings(own) > 1) {
    throw Error("several turbines of this process have the same input file and root name (" +
                instance.start.out_name + "): their checkpoints would overwrite each other");
  }
  Checkpoint c{module_name(),           instance.in_file,
               instance.start.out_name, instance.start.time_step_s,
               instance.steps,          {}};
  StateArchive archive(c.state);
  instance.module->visit_state(archive);
  const std::filesystem::path file = path_from_bytes(call.in_file);
  write_checkpoint(file, c);
  instance.module->checkpoint(file, call.swap, call.notice);
}

void store(Instance& instance, Call& call) {
  StateArchive archive(instance.kept);
  instance.module->visit_state(archive);
  instance.kept_steps = instance.steps;
  instance.module->store_or_restore(LAC_STATUS_STORE, call.swap, call.notice);
}

void restore(Instance& instance, Call& call) {
  if (instance.kept.empty()) throw Error("status -10 (restore) came before any -11 (store)");
  load_state(*instance.module, instance.kept, "restore");
  instance.steps = instance.kept_steps;
  instance.module->store_or_restore(LAC_STATUS_RESTORE, call.swap, call.notice);
}

void last_call(Instance* instance, Call& call) {
  instances().leave(instance);
  const std::unique_ptr<Instance> owner(instance);
  owner->module->finish(call.swap, call.notice);
}

void dispatch(int status, Call& call) {
  if (status == LAC_STATUS_FIRST) return first_call(call);
  if (status == LAC_STATUS_RESTART) return restart(call);

  Instance* instance = instances().find(caller_key(call.swap.data(), call.in_file, call.out_name));
  if (instance == nullptr) {
    // A host ends even a run whose first call failed; there is nothing to end then.
    if (status == LAC_STATUS_LAST) return;
    throw Error("call with status " + std::to_string(status) + " for a turbine that never made " +
                "a first call (status 0), or whose first call failed");
  }
  switch (status) {
    case LAC_STATUS_STEP:
      ++instance->steps;
      return instance->module->step(
          call.swap, static_cast<double>(instance->steps) * instance->start.time_step_s,
          call.notice);
    case LAC_STATUS_LAST:
      return last_call(instance, call);
    case LAC_STATUS_CHECKPOINT:
      return checkpoint(*instance, call);
    case LAC_STATUS_STORE:
      return store(*instance, call);
    default:
      return restore(*instance, call);
  }
}

bool is_known(int status) {
  return status == LAC_STATUS_FIRST || status == LAC_STATUS_STEP || status == LAC_STATUS_LAST ||
         (status <= LAC_STATUS_CHECKPOINT && status >= LAC_STATUS_STORE);
}

void deliver(const Notice& notice, SwapView& swap, int* fail, char* message) {
  *fail = notice.level();
  const int capacity = swap.integer(Rec::MessageCapacity, 0);
  if (message == nullptr || capacity <= 0 || capacity > kLongestString) return;
  if (notice.level() == 0) {
    message[0] = '\0';
    return;
  }
  Notice full;
  full.warn("%s: %.*s", module_name(), static_cast<int>(notice.text().size()),
            notice.text().data());
  write_string(message, capacity, full.text());
}

}  // namespace

void discon_entry(float* array, int* fail, const char* in_file, const char* out_name,
                  char* message) noexcept {
  if (array == nullptr || fail == nullptr) {
    if (fail != nullptr) *fail = -1;
    return;
  }
  SwapView swap(array, known_array_size(array));
  Notice notice;
  try {
    const int status = swap.integer(Rec::Status, INT32_MIN);
    *fail = 0;
    if (!is_known(status) || swap.get(Rec::Status) != status) return;
    Call call{swap, read_in_file(in_file, swap), read_out_name(out_name, swap), notice};
    dispatch(status, call);
  } catch (const std::exception& e) {
    notice.fail("%s", e.what());
  } catch (...) {
    notice.fail("unknown error");
  }
  deliver(notice, swap, fail, message);
}

}  // namespace lac
