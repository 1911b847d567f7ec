// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace lac::sim {

/// Bytes that the memory operand of an x86-64 instruction spans, from its code. Legacy, VEX and
/// EVEX forms that move or use floats and integers; of forms that are not told apart (gathers,
/// shuffles, conversions to wider types) the full width of the vector, never less than is used.
/// Source: Intel 64 and IA-32 Architectures Software Developer's Manual, volume 2, appendix A.
std::size_t memory_operand_bytes(const std::uint8_t* code);

}  // namespace lac::sim
