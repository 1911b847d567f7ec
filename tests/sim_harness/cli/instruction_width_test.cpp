// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/instruction_width.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace lac::sim {
namespace {

// Codes as GNU as writes them, widths as objdump -M intel names them.
TEST(InstructionWidth, AsTheDisassemblerSays) {
  const struct {
    const char* text;
    std::vector<std::uint8_t> code;
    std::size_t bytes;
  } cases[] = {
      {"mov eax,DWORD PTR [rdi]", {0x8b, 0x07}, 4},
      {"mov rax,QWORD PTR [rdi]", {0x48, 0x8b, 0x07}, 8},
      {"movss xmm0,DWORD PTR [rdi]", {0xf3, 0x0f, 0x10, 0x07}, 4},
      {"movsd xmm8,QWORD PTR [r9]", {0xf2, 0x45, 0x0f, 0x10, 0x01}, 8},
      {"movups xmm0,XMMWORD PTR [rdi]", {0x0f, 0x10, 0x07}, 16},
      {"cvtss2sd xmm0,DWORD PTR [rdi]", {0xf3, 0x0f, 0x5a, 0x07}, 4},
      {"cvtps2pd xmm0,QWORD PTR [rdi]", {0x0f, 0x5a, 0x07}, 8},
      {"ucomiss xmm0,DWORD PTR [rdi]", {0x0f, 0x2e, 0x07}, 4},
      {"fld DWORD PTR [rdi]", {0xd9, 0x07}, 4},
      {"movbe eax,DWORD PTR [rdi]", {0x0f, 0x38, 0xf0, 0x07}, 4},
      {"vmovss xmm0,DWORD PTR [rdi]", {0xc5, 0xfa, 0x10, 0x07}, 4},
      {"vmovsd xmm0,QWORD PTR [r9]", {0xc4, 0xc1, 0x7b, 0x10, 0x01}, 8},
      {"vmovups xmm0,XMMWORD PTR [rdi]", {0xc5, 0xf8, 0x10, 0x07}, 16},
      {"vmovups ymm0,YMMWORD PTR [rdi]", {0xc5, 0xfc, 0x10, 0x07}, 32},
      {"vmovups YMMWORD PTR [r9],ymm8", {0xc4, 0x41, 0x7c, 0x11, 0x01}, 32},
      {"vmovdqu ymm8,YMMWORD PTR [r9+0x40]", {0xc4, 0x41, 0x7e, 0x6f, 0x41, 0x40}, 32},
      {"vfmadd231ss xmm0,xmm1,DWORD PTR [rdi]", {0xc4, 0xe2, 0x71, 0xb9, 0x07}, 4},
      {"vfmadd231ps ymm0,ymm1,YMMWORD PTR [rdi]", {0xc4, 0xe2, 0x75, 0xb8, 0x07}, 32},
      {"vbroadcastss ymm0,DWORD PTR [rdi]", {0xc4, 0xe2, 0x7d, 0x18, 0x07}, 4},
      {"vinsertf128 ymm0,ymm1,XMMWORD PTR [rdi],0x1", {0xc4, 0xe3, 0x75, 0x18, 0x07, 0x01}, 16},
      {"vmovdqu64 ymm16,YMMWORD PTR [rdi]", {0x62, 0xe1, 0xfe, 0x28, 0x6f, 0x07}, 32},
      {"vmovdqu64 zmm16,ZMMWORD PTR [rdi]", {0x62, 0xe1, 0xfe, 0x48, 0x6f, 0x07}, 64},
      {"vmovss xmm16,DWORD PTR [rdi]", {0x62, 0xe1, 0x7e, 0x08, 0x10, 0x07}, 4},
  };
  for (const auto& c : cases) EXPECT_EQ(memory_operand_bytes(c.code.data()), c.bytes) << c.text;
}

}  // namespace
}  // namespace lac::sim
