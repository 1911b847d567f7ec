// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "core/chain_block.hpp"
#include "core/discon_library.hpp"
#include "core/discon_module.hpp"
#include "core/error.hpp"
#include "wrapper/chain.hpp"

namespace lac {

const char* module_name() {
  return "wrapper";
}

std::unique_ptr<DisconModule> make_module(const StartInfo& start, SwapView swap, Notice&) {
  if (has_chain_block(swap)) {
    throw Error("the wrapper is called by a wrapper: put all secondaries into one input file");
  }
  InputFile in = InputFile::load(start.input_file);
  return std::make_unique<Chain>(WrapperParams::read(in), start, swap, own_folder());
}

}  // namespace lac
