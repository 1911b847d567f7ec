// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lac {

/// One DISCON call: finds the caller's instance, runs the status through the life-cycle of
/// discon_abi.h, catches everything, writes aviFAIL and the message. The only place where
/// exceptions end. Message form: "<module>: <text>".
void discon_entry(float* swap, int* fail, const char* in_file, const char* out_name,
                  char* message) noexcept;

}  // namespace lac
