// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <string_view>

#include "core/hash.hpp"

namespace lac {

/// What is known about a caller: DISCON has no handle.
struct CallerKey {
  const void* array = nullptr;
  std::uint64_t strings = 0;   // hash of both names
  std::uint64_t out_name = 0;  // hash of the root name alone
};

/// Which turbine is calling?
///
///   address and strings fit      the instance, found without a lock (every normal step)
///   strings fit exactly one      that one: a host that moves its array (address is updated)
///   strings fit none             a call with another file name (checkpoint): the one whose
///                                address and root name fit, else the only one whose address does
///   anything else                none
///
/// Different turbines may search, enter and leave at the same time from different threads.
/// Slots are static and never freed, so a search never touches memory that another thread frees.
template <class Instance>
class InstanceTable {
 public:
  static constexpr int kCapacity = 1024;

  /// The calling turbine's instance or nullptr. Lock-free in the normal case.
  Instance* find(const CallerKey& key) {
    const int used = used_.load(std::memory_order_acquire);
    for (int i = 0; i < used; ++i) {
      if (slots_[i].array.load(std::memory_order_acquire) == key.array &&
          slots_[i].strings.load(std::memory_order_relaxed) == key.strings) {
        return slots_[i].instance.load(std::memory_order_acquire);
      }
    }
    return find_other(key);
  }

  /// Enters an instance; false if the table is full.
  bool enter(const CallerKey& key, Instance* instance) {
    const std::lock_guard lock(mutex_);
    int target = 0;
    while (target < used_.load() && slots_[target].instance.load() != nullptr) ++target;
    if (target == kCapacity) return false;
    slots_[target].strings.store(key.strings, std::memory_order_relaxed);
    slots_[target].out_name.store(key.out_name, std::memory_order_relaxed);
    slots_[target].instance.store(instance, std::memory_order_relaxed);
    slots_[target].array.store(key.array, std::memory_order_release);
    if (target == used_.load()) used_.store(target + 1, std::memory_order_release);
    return true;
  }

  void leave(const Instance* instance) {
    const std::lock_guard lock(mutex_);
    for (Slot& slot : slots_) {
      if (slot.instance.load() == instance) empty(slot);
    }
  }

  /// Takes out and gives the instance with this very address and these very strings (a run that
  /// was never ended), or nullptr.
  Instance* take(const CallerKey& key) {
    const std::lock_guard lock(mutex_);
    Slot* slot = only([&](const Slot& s) {
      return s.array.load() == key.array && s.strings.load() == key.strings;
    });
    if (slot == nullptr) return nullptr;
    Instance* instance = slot->instance.load();
    empty(*slot);
    return instance;
  }

  /// How many instances were entered with these strings?
  int with_strings(const CallerKey& key) {
    const std::lock_guard lock(mutex_);
    int count = 0;
    for (int i = 0; i < used_.load(); ++i) {
      const bool same = slots_[i].instance.load() != nullptr && slots_[i].strings == key.strings;
      count += same ? 1 : 0;
    }
    return count;
  }

 private:
  struct Slot {
    std::atomic<const void*> array{nullptr};
    std::atomic<std::uint64_t> strings{0};
    std::atomic<std::uint64_t> out_name{0};
    std::atomic<Instance*> instance{nullptr};
  };

  static void empty(Slot& slot) {
    slot.array.store(nullptr, std::memory_order_release);
    slot.instance.store(nullptr, std::memory_order_release);
  }

  Instance* find_other(const CallerKey& key) {
    const std::lock_guard lock(mutex_);
    if (Slot* moved = only([&](const Slot& s) { return s.strings.load() == key.strings; })) {
      moved->array.store(key.array, std::memory_order_release);
      return moved->instance.load();
    }
    const auto same_address = [&](const Slot& s) {
      return s.array.load() == key.array && s.strings.load() != key.strings;
    };
    Slot* other_file =
        only([&](const Slot& s) { return same_address(s) && s.out_name.load() == key.out_name; });
    if (other_file == nullptr) other_file = only(same_address);
    return other_file != nullptr ? other_file->instance.load() : nullptr;
  }

  /// The slot in use that fits, or nullptr if there is none or more than one.
  template <class Fits>
  Slot* only(Fits fits) {
    Slot* found = nullptr;
    for (int i = 0; i < used_.load(); ++i) {
      if (slots_[i].instance.load() == nullptr || !fits(slots_[i])) continue;
      if (found != nullptr) return nullptr;
      found = &slots_[i];
    }
    return found;
  }

  std::array<Slot, kCapacity> slots_;
  std::atomic<int> used_{0};
  std::mutex mutex_;
};

inline CallerKey caller_key(const void* array, std::string_view in_file,
                            std::string_view out_name) noexcept {
  const std::uint64_t out = hash_of_text(out_name);
  return {array, hash_of_text(in_file) + 3 * out, out};  // not the same with the names exchanged
}

}  // namespace lac
