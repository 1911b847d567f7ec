// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/ode_solver.hpp"

#include <arkode/arkode_erkstep.h>
#include <nvector/nvector_serial.h>

#include <algorithm>
#include <string>

#include "core/error.hpp"

namespace lac::sim {

namespace {

void require(bool success, const char* call) {
  if (!success) throw Error(std::string("SUNDIALS: ") + call + " failed");
}

}  // namespace

struct OdeSolver::Memory {
  ~Memory() {
    if (arkode) ERKStepFree(&arkode);
    if (start) N_VDestroy(start);
    if (result) N_VDestroy(result);
    if (tolerance) N_VDestroy(tolerance);
    if (sundials) SUNContext_Free(&sundials);
  }

  static int evaluate(realtype time_s, N_Vector state, N_Vector rates, void* self) {
    const auto* memory = static_cast<const Memory*>(self);
    memory->function(time_s, NV_DATA_S(state), NV_DATA_S(rates), memory->context);
    return 0;
  }

  static void keep_message(int, const char*, const char*, char* text, void* self) {
    static_cast<Memory*>(self)->message = text;
  }

  OdeFunction function = nullptr;
  const void* context = nullptr;
  SUNContext sundials = nullptr;
  N_Vector start = nullptr;
  N_Vector result = nullptr;
  N_Vector tolerance = nullptr;
  void* arkode = nullptr;
  Statistics statistics;
  std::string message;
};

OdeSolver::OdeSolver(OdeFunction function, double relative_tolerance,
                     const std::vector<double>& absolute_tolerance)
    : memory_(std::make_unique<Memory>()) {
  Memory& m = *memory_;
  m.function = function;
  const auto size = static_cast<sunindextype>(absolute_tolerance.size());
  require(SUNContext_Create(nullptr, &m.sundials) == 0, "SUNContext_Create");
  m.start = N_VNew_Serial(size, m.sundials);
  m.result = N_VNew_Serial(size, m.sundials);
  m.tolerance = N_VNew_Serial(size, m.sundials);
  require(m.start && m.result && m.tolerance, "N_VNew_Serial");
  N_VConst(0.0, m.start);
  std::copy(absolute_tolerance.begin(), absolute_tolerance.end(), NV_DATA_S(m.tolerance));

  m.arkode = ERKStepCreate(Memory::evaluate, 0.0, m.start, m.sundials);
  require(m.arkode != nullptr, "ERKStepCreate");
  require(ERKStepSetUserData(m.arkode, &m) == 0, "ERKStepSetUserData");
  require(ERKStepSetErrHandlerFn(m.arkode, Memory::keep_message, &m) == 0,
          "ERKStepSetErrHandlerFn");
  require(ERKStepSVtolerances(m.arkode, relative_tolerance, m.tolerance) == 0,
          "ERKStepSVtolerances");
  require(ERKStepSetTableNum(m.arkode, ARKODE_BOGACKI_SHAMPINE_4_2_3) == 0, "ERKStepSetTableNum");
  require(ERKStepSetMaxNumSteps(m.arkode, 100000) == 0, "ERKStepSetMaxNumSteps");
}

OdeSolver::~OdeSolver() = default;
OdeSolver::OdeSolver(OdeSolver&&) noexcept = default;
OdeSolver& OdeSolver::operator=(OdeSolver&&) noexcept = default;

void OdeSolver::advance(double duration_s, double* state, const void* context) {
  Memory& m = *memory_;
  m.context = context;
  const auto size = static_cast<std::size_t>(NV_LENGTH_S(m.start));
  std::copy_n(state, size, NV_DATA_S(m.start));
  require(ERKStepReInit(m.arkode, Memory::evaluate, 0.0, m.start) == 0, "ERKStepReInit");
  require(ERKStepSetInitStep(m.arkode, duration_s) == 0, "ERKStepSetInitStep");
  require(ERKStepSetStopTime(m.arkode, duration_s) == 0, "ERKStepSetStopTime");

  double reached_s = 0.0;
  const int flag = ERKStepEvolve(m.arkode, duration_s, m.result, &reached_s, ARK_NORMAL);
  if (flag < 0) {
    throw Error("SUNDIALS: no solution after " + std::to_string(reached_s) +
                " s of an interval of " + std::to_string(duration_s) + " s: " + m.message);
  }
  std::copy_n(NV_DATA_S(m.result), size, state);

  long steps = 0;
  long attempts = 0;
  long calls = 0;
  ERKStepGetNumSteps(m.arkode, &steps);
  ERKStepGetNumStepAttempts(m.arkode, &attempts);
  ERKStepGetNumRhsEvals(m.arkode, &calls);
  ++m.statistics.intervals;
  m.statistics.steps += steps;
  m.statistics.rejected_steps += attempts - steps;
  m.statistics.function_calls += calls;
}

const OdeSolver::Statistics& OdeSolver::statistics() const {
  return memory_->statistics;
}

}  // namespace lac::sim
