// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>

#include "core/chain_block.hpp"
#include "core/discon_library.hpp"
#include "core/discon_module.hpp"
#include "core/error.hpp"
#include "wrapper/chain.hpp"
#include "wrapper/guo_wrapper_file.hpp"

namespace lac {

const char* module_name() {
  return "wrapper";
}

std::unique_ptr<DisconModule> make_module(const StartInfo& start, SwapView swap, Notice& notice) {
  if (has_chain_block(swap)) {
    throw Error("the wrapper is called by a wrapper: put all secondaries into one input file");
  }
  std::optional<WrapperParams> params = read_guo_wrapper_file(start.input_file, notice);
  if (!params) {
    InputFile in = InputFile::load(start.input_file);
    params = WrapperParams::read(in);
  }
  return std::make_unique<Chain>(*std::move(params), start, swap, own_folder());
}

}  // namespace lac
