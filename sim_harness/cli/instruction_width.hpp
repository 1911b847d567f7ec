// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace lac::sim {

/// Bytes that the memory operand of an x86-64 instruction spans, from its code, for the ones by
/// which compilers and C libraries move and use floats (legacy, VEX and EVEX forms). Of all
/// others the full width of their register: never less than is used.
/// Source: Intel 64 and IA-32 Architectures Software Developer's Manual, volume 2, appendix A.
std::size_t memory_operand_bytes(const std::uint8_t* code);

}  // namespace lac::sim
