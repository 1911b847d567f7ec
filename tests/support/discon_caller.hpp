// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/discon_library.hpp"
#include "core/native_path.hpp"
#include "core/swap_view.hpp"
#include "support/unique_name.hpp"

namespace lac::test {

/// Root name for output files, in the system's temporary folder and unlike any other's.
inline std::string own_output_root() {
  return bytes_from_path(std::filesystem::temp_directory_path() / (unique_name() + ".SrvD"));
}

/// Calls one built library as a host or the master does, with an array of exactly `size` floats.
/// A size of kPrivateArraySize carries the chain block, as the master's array.
class DisconCaller {
 public:
  explicit DisconCaller(const std::string& library, std::string in_file,
                        int size = kPrivateArraySize, std::string out_name = own_output_root())
      : library_(DisconLibrary::open(library, "DISCON", {LAC_LIBRARY_DIR})),
        array_(static_cast<std::size_t>(size), 0.0f),
        in_file_(std::move(in_file)),
        out_name_(std::move(out_name)) {
    set_time_step(0.0125);
    if (size > kHostBlock.last()) {
      swap().set(Rec::ExtendedStart, kExtendedSignature);
      swap().set(Rec::ArraySize, size);
    }
    if (size >= kPrivateArraySize) {
      swap().set(Rec::ChainVersion, kChainLayoutVersion);
      swap().set(Rec::ChainInputsGood, 1.0);
    }
    swap().set(Rec::MessageCapacity, static_cast<double>(message_.size()));
    swap().set(Rec::InFileLength, static_cast<double>(in_file_.size() + 1));
    swap().set(Rec::OutNameLength, static_cast<double>(out_name_.size() + 1));
  }

  /// Ends a run that the test left open, as a host would.
  ~DisconCaller() {
    if (running_) call(-1);
  }
  DisconCaller(const DisconCaller&) = delete;
  DisconCaller& operator=(const DisconCaller&) = delete;

  void set_time_step(double s) {
    time_step_s = s;
    swap().set(Rec::TimeStep, s);
  }

  /// Returns aviFAIL. Status 1 advances the time record.
  int call(int status) {
    int fail = 0;
    steps_ = status == 0 ? 0 : steps_ + (status == 1 ? 1 : 0);
    swap().set(Rec::Status, status);
    swap().set(Rec::Time, static_cast<double>(steps_) * time_step_s);
    library_.entry()(array_.data(), &fail, in_file_.c_str(), out_name_.data(), message_.data());
    running_ = status != -1 && fail >= 0;
    return fail;
  }

  SwapView swap() { return {array_.data(), static_cast<int>(array_.size())}; }
  std::string message() const { return std::string(message_.data()); }  // up to the NUL

  double time_step_s = 0.0125;

 private:
  DisconLibrary library_;
  std::vector<float> array_;
  std::string in_file_;
  std::string out_name_;
  std::string message_ = std::string(2048, '\0');
  long steps_ = 0;
  bool running_ = false;
};

}  // namespace lac::test
