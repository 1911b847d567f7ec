// SPDX-License-Identifier: Apache-2.0
// A controller made like those of LAC Chain: a first-order low-pass of the generator speed goes to
// the torque demand, the exact time to the pitch demand. Keys: Weight (of the new value),
// FailAtStep, WarnAtStep.
#include <cmath>
#include <memory>

#include "core/discon_module.hpp"
#include "core/input_file.hpp"

namespace lac {
namespace {

class ToyState final : public DisconModule {
 public:
  explicit ToyState(InputFile& in)
      : weight_(in.number("Weight", 0.25, Range::between(0.0, 1.0))),
        fail_at_(in.integer("FailAtStep", -1, Range::any())),
        warn_at_(in.integer("WarnAtStep", -1, Range::any())) {
    in.finish();
  }
  void step(SwapView swap, double time_s, Notice& notice) noexcept override {
    filtered_ += weight_ * (swap.get(Rec::GeneratorSpeed) - filtered_);
    swap.set(Rec::TorqueDemand, filtered_);
    swap.set(Rec::PitchDemandCollective, time_s);
    if (steps_ == warn_at_) notice.warn("step %d has come", steps_);
    if (steps_ == fail_at_) notice.fail("step %d is the end", steps_);
    ++steps_;
  }
  void visit_state(StateArchive& a) override { a(filtered_), a(steps_); }

 private:
  double weight_;
  int fail_at_;
  int warn_at_;
  double filtered_ = 0.0;
  int steps_ = 0;
};

}  // namespace

const char* module_name() {
  return "toy_state";
}

std::unique_ptr<DisconModule> make_module(const StartInfo& start, SwapView, Notice&) {
  InputFile in = InputFile::load(start.input_file);
  return std::make_unique<ToyState>(in);
}

}  // namespace lac
