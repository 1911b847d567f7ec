// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/discon_module.hpp"
#include "wrapper/guo_link.hpp"
#include "wrapper/host_link.hpp"
#include "wrapper/private_array.hpp"
#include "wrapper/secondary.hpp"
#include "wrapper/signal_log.hpp"

namespace lac {

/// The master: calls its secondaries in order on one private array and gives their demands to the
/// host. Behaviour in every case: README.md.
class Chain final : public DisconModule {
 public:
  /// Opens every library; calls none. Throws lac::Error.
  Chain(WrapperParams params, const StartInfo& start, SwapView host,
        const std::filesystem::path& wrapper_folder);
  ~Chain() override;

  void step(SwapView host, double time_s, Notice& notice) noexcept override;
  void finish(SwapView host, Notice& notice) override;
  void visit_state(StateArchive& archive) override;
  void checkpoint(const std::filesystem::path& file, SwapView host, Notice& notice) override;
  void restart(const std::filesystem::path& file, SwapView host, Notice& notice) override;
  void store_or_restore(int status, SwapView host, Notice& notice) override;

 private:
  bool take_inputs(SwapView host, double time_s, Notice& notice) noexcept;
  bool call_all(int status, double time_s, Notice& notice) noexcept;
  void call(Secondary& secondary, int status) noexcept;
  void call_with_file(std::size_t index, int status, const std::filesystem::path& file);
  bool judge(Secondary& secondary, double time_s, Notice& notice) noexcept;
  void record_signals(Notice& notice) noexcept;
  void end_all(Notice& notice) noexcept;
  std::filesystem::path checkpoint_of(std::size_t index, const std::filesystem::path& file) const;

  // What a step needs stands together.
  HostLink link_;
  std::vector<std::unique_ptr<Secondary>> secondaries_;
  std::unique_ptr<GuoLink> guo_;  // if there are Guo-type secondaries
  std::unique_ptr<SignalLog> log_;
  std::int64_t step_ = 0;  // number of the next call
  bool log_refused_ = false;
  bool first_call_ = true;
  bool store_reported_ = false;
  WarningFilter input_filter_;
  HostLink::State link_state_;
  PrivateArray array_;
  GuoLink::State guo_state_;
  Notice start_warning_;  // for the first call
  WrapperParams params_;
};

}  // namespace lac
