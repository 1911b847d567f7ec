// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/instruction_width.hpp"

namespace lac::sim {
namespace {

enum class Prefix { None, H66, F3, F2 };  // in the order of the pp field of VEX and EVEX

struct Instruction {
  Prefix prefix = Prefix::None;
  bool wide = false;  // REX.W or its like
  int map = 0;        // 0: one byte, 1: 0F, 2: 0F 38, 3: 0F 3A
  std::size_t vector = 16;
  bool broadcast = false;
  const std::uint8_t* opcode = nullptr;

  std::size_t integer() const { return wide ? 8 : prefix == Prefix::H66 ? 2 : 4; }
  std::size_t real() const { return wide ? 8 : 4; }
  /// ps and pd take a vector, ss and sd one number.
  std::size_t by_prefix() const {
    return prefix == Prefix::F3 ? 4 : prefix == Prefix::F2 ? 8 : vector;
  }
};

void read_legacy(const std::uint8_t* code, Instruction& i) {
  for (;; ++code) {
    if (*code == 0xF3) {
      i.prefix = Prefix::F3;
    } else if (*code == 0xF2) {
      i.prefix = Prefix::F2;
    } else if (*code == 0x66) {
      if (i.prefix == Prefix::None) i.prefix = Prefix::H66;
    } else if ((*code & 0xF0) == 0x40) {
      i.wide = (*code & 0x08) != 0;
    } else if (*code != 0xF0 && *code != 0x67 && (*code & 0xE7) != 0x26 && *code != 0x64 &&
               *code != 0x65) {
      break;
    }
  }
  if (*code == 0x0F) {
    i.map = code[1] == 0x38 ? 2 : code[1] == 0x3A ? 3 : 1;
    code += i.map == 1 ? 1 : 2;
  }
  i.opcode = code;
}

Instruction read_instruction(const std::uint8_t* code) {
  Instruction i;
  if (*code == 0xC5) {
    i.prefix = static_cast<Prefix>(code[1] & 3);
    i.vector = (code[1] & 4) != 0 ? 32 : 16;
    i.map = 1;
    i.opcode = code + 2;
  } else if (*code == 0xC4) {
    i.prefix = static_cast<Prefix>(code[2] & 3);
    i.vector = (code[2] & 4) != 0 ? 32 : 16;
    i.wide = (code[2] & 0x80) != 0;
    i.map = code[1] & 0x1F;
    i.opcode = code + 3;
  } else if (*code == 0x62) {
    i.prefix = static_cast<Prefix>(code[2] & 3);
    i.vector = std::size_t{16} << ((code[3] >> 5) & 3);
    i.wide = (code[2] & 0x80) != 0;
    i.broadcast = (code[3] & 0x10) != 0;
    i.map = code[1] & 7;
    i.opcode = code + 4;
  } else {
    read_legacy(code, i);
  }
  return i;
}

std::size_t one_byte(const Instruction& i) {
  const std::uint8_t op = *i.opcode;
  const int field = (i.opcode[1] >> 3) & 7;
  if (op >= 0xD8 && op <= 0xDF) {  // x87
    if ((op == 0xDB && field >= 4) || (op == 0xDF && (field == 4 || field == 6))) return 10;
    return op == 0xDC || op == 0xDD || (op == 0xDF && field >= 4) ? 8 : 4;
  }
  if (op == 0x63) return 4;                                // movsxd
  if (op == 0x8F || (op == 0xFF && field >= 2)) return 8;  // push, pop, jump
  return i.integer();
}

std::size_t two_byte(const Instruction& i) {
  const std::uint8_t op = *i.opcode;
  const bool h66 = i.prefix == Prefix::H66;
  const bool scalar = i.prefix == Prefix::F3 || i.prefix == Prefix::F2;
  if (op == 0x12 || op == 0x13 || op == 0x16 || op == 0x17) {  // half a register
    return i.prefix == Prefix::F3 || (i.prefix == Prefix::F2 && i.vector > 16) ? i.vector : 8;
  }
  if (op == 0x2A) return scalar ? i.real() : 8;  // from integers
  if (op == 0x2C || op == 0x2D) return scalar || h66 ? i.by_prefix() : 8;
  if (op == 0x2E || op == 0x2F) return h66 ? 8 : 4;  // compare
  if (op == 0x5A && i.prefix == Prefix::None) return i.vector / 2;
  if (op == 0x6E || (op == 0x7E && i.prefix != Prefix::F3)) return i.real();
  if (op == 0x7E || op == 0xD6) return 8;
  if (op == 0xE6 && i.prefix == Prefix::F3) return i.vector / 2;
  if (op == 0x10 || op == 0x11 || (op >= 0x51 && op <= 0x5F && op != 0x5B) || op == 0xC2) {
    return i.by_prefix();
  }
  if (op == 0xB6 || op == 0xBE) return 1;
  if (op == 0xB7 || op == 0xBF || op == 0xC4) return 2;
  if (op == 0xC7) return 16;  // compare and exchange
  const bool vector = op == 0x14 || op == 0x15 || (op >= 0x28 && op <= 0x2B) ||
                      (op >= 0x54 && op <= 0x7F) || op == 0xC6 || op >= 0xD0;
  return vector ? i.vector : i.integer();
}

std::size_t op_0F38(const Instruction& i) {
  const std::uint8_t op = *i.opcode;
  if (op == 0x18 || op == 0x58) return 4;  // one element to all
  if (op == 0x19 || op == 0x59) return 8;
  if (op == 0x78) return 1;
  if (op == 0x79) return 2;
  if (op == 0x1A || op == 0x5A) return 16;
  if (op == 0x1B || op == 0x5B) return 32;
  if (op >= 0x99 && op <= 0xBF && (op & 0x0F) >= 0x09 && op % 2 == 1) return i.real();  // fma
  return op >= 0xF0 ? i.integer() : i.vector;
}

std::size_t op_0F3A(const Instruction& i) {
  const std::uint8_t op = *i.opcode;
  if (op == 0x14 || op == 0x20) return 1;
  if (op == 0x15) return 2;
  if (op == 0x0A || op == 0x17 || op == 0x21) return 4;
  if (op == 0x0B) return 8;
  if (op == 0x16 || op == 0x22 || op == 0xF0) return i.real();
  if (op == 0x18 || op == 0x19 || op == 0x38 || op == 0x39) return 16;
  if (op == 0x1A || op == 0x1B || op == 0x3A || op == 0x3B) return 32;
  return op == 0x1D ? i.vector / 2 : i.vector;
}

}  // namespace

std::size_t memory_operand_bytes(const std::uint8_t* code) {
  const Instruction i = read_instruction(code);
  if (i.broadcast) return i.real();
  switch (i.map) {
    case 0:
      return one_byte(i);
    case 1:
      return two_byte(i);
    case 2:
      return op_0F38(i);
    case 3:
      return op_0F3A(i);
    default:
      return i.vector;
  }
}

}  // namespace lac::sim
