// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <string_view>

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

  /// Enters an instance; false if the table is full. An instance that had the same address and
  /// strings (a run that was never ended) is handed back through `replaced`.
  bool enter(const CallerKey& key, Instance* instance, Instance** replaced) {
    const std::lock_guard lock(mutex_);
    *replaced = nullptr;
    int target = -1;
    for (int i = 0; i < used_.load(); ++i) {
      const bool same = slots_[i].array.load() == key.array &&
                        slots_[i].instance.load() != nullptr &&
                        slots_[i].strings.load() == key.strings;
      if (same) {
        *replaced = slots_[i].instance.exchange(instance, std::memory_order_acq_rel);
        return true;
      }
      if (slots_[i].instance.load() == nullptr && target < 0) target = i;
    }
    if (target < 0) {
      if (used_.load() == kCapacity) return false;
      target = used_.load();
    }
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
      if (slot.instance.load() != instance) continue;
      slot.array.store(nullptr, std::memory_order_release);
      slot.instance.store(nullptr, std::memory_order_release);
    }
  }

 private:
  struct Slot {
    std::atomic<const void*> array{nullptr};
    std::atomic<std::uint64_t> strings{0};
    std::atomic<std::uint64_t> out_name{0};
    std::atomic<Instance*> instance{nullptr};
  };

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

/// Fast 64-bit hash (not cryptographic); chained through `seed`.
inline std::uint64_t hash_of_text(std::string_view s,
                                  std::uint64_t seed = 0x9e3779b97f4a7c15ull) noexcept {
  std::uint64_t hash = seed;
  const auto mix = [&hash](std::uint64_t word) {
    hash = (hash ^ word) * 0xff51afd7ed558ccdull;
    hash ^= hash >> 32;
  };
  const char* p = s.data();
  std::size_t left = s.size();
  for (; left >= sizeof(std::uint64_t); left -= sizeof(std::uint64_t)) {
    std::uint64_t word;
    std::memcpy(&word, p, sizeof word);  // of known size: one load, not a call
    mix(word);
    p += sizeof word;
  }
  if (s.size() >= sizeof(std::uint64_t)) {  // the rest together with what stands before it
    std::uint64_t word;
    std::memcpy(&word, s.data() + s.size() - sizeof word, sizeof word);
    mix(word);
  } else {
    std::uint64_t rest = 0;
    for (; left > 0; --left) rest = (rest << 8) | static_cast<unsigned char>(*p++);
    mix(rest);
  }
  hash = (hash ^ s.size()) * 0xc4ceb9fe1a85ec53ull;
  return hash ^ (hash >> 29);
}

inline CallerKey caller_key(const void* array, std::string_view in_file,
                            std::string_view out_name) noexcept {
  const std::uint64_t out = hash_of_text(out_name);
  return {array, hash_of_text(in_file, out), out};
}

}  // namespace lac
