// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace lac {

/// Saves or loads a state by visiting its fields, so that the list of fields stands once:
///
///   struct State {
///     double speed_radps = 0.0;
///     std::vector<double> buffer;
///     void visit(StateArchive& a) { a(speed_radps), a(buffer); }
///   };
///
/// Numbers go bit by bit: a loaded state continues exactly. Sizes of vectors belong to the
/// state and must be the same when loading (a state is loaded into an object that was built
/// from the same input); a mismatch makes complete() false and leaves the rest untouched.
class StateArchive {
 public:
  /// Saves into bytes (appended; memory is reused between saves).
  explicit StateArchive(std::vector<std::byte>& sink) : sink_(&sink) { sink.clear(); }
  /// Loads from bytes.
  explicit StateArchive(std::span<const std::byte> source) : source_(source) {}

  template <class T>
  void operator()(T& value) {
    if constexpr (requires { value.visit(*this); }) {
      value.visit(*this);
    } else {
      static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>, "give the type a visit()");
      bytes(reinterpret_cast<std::byte*>(&value), sizeof value);
    }
  }
  template <class T, std::size_t n>
  void operator()(std::array<T, n>& values) {
    elements(values.data(), n);
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    std::size_t size = values.size();
    (*this)(size);
    if (size != values.size()) ok_ = false;
    if (ok_) elements(values.data(), values.size());
  }

  /// After loading: every field found, none left over.
  bool complete() const { return ok_ && (sink_ != nullptr || position_ == source_.size()); }

 private:
  template <class T>
  void elements(T* values, std::size_t n) {
    if constexpr (std::is_arithmetic_v<T>) {
      bytes(reinterpret_cast<std::byte*>(values), n * sizeof(T));
    } else {
      for (std::size_t i = 0; i < n; ++i) (*this)(values[i]);
    }
  }

  void bytes(std::byte* data, std::size_t n) {
    if (sink_ != nullptr) {
      sink_->insert(sink_->end(), data, data + n);
    } else if (ok_ && n <= source_.size() - position_) {
      std::memcpy(data, source_.data() + position_, n);
      position_ += n;
    } else {
      ok_ = false;
    }
  }

  std::vector<std::byte>* sink_ = nullptr;
  std::span<const std::byte> source_;
  std::size_t position_ = 0;
  bool ok_ = true;
};

}  // namespace lac
