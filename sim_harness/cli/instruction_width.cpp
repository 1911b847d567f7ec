// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/instruction_width.hpp"

namespace lac::sim {
namespace {

enum Prefix { None = 1, H66 = 2, F3 = 4, F2 = 8, Any = 15 };
constexpr Prefix kPrefixes[] = {None, H66, F3, F2};  // in the order of VEX and EVEX
enum Map { OneByte, Map0F, Map0F38, Map0F3A };
constexpr std::size_t kVector = 100, kHalf = 101, kByPrefix = 102, kReal = 103;

/// Operand widths of opcodes `first` to `last`, in bytes or as one of the words above.
struct Rule {
  int map;
  int prefixes;
  int first, last;
  std::size_t width;
};

/// The first one that fits holds. What none fits takes the whole vector, in map 0 an integer.
constexpr Rule kRules[] = {
    {OneByte, Any, 0x63, 0x63, 4},            // movsxd
    {OneByte, Any, 0xd8, 0xdb, 4},            // x87, float
    {OneByte, Any, 0xdc, 0xdf, 8},            // x87, double
    {OneByte, Any, 0x00, 0xff, kReal},        // integers: 4, or 8 if wide
    {Map0F, F3, 0x12, 0x16, kVector},         // movsldup, movshdup
    {Map0F, Any, 0x12, 0x13, 8},              // half a register
    {Map0F, Any, 0x16, 0x17, 8},              // the other half
    {Map0F, F3 | F2, 0x2c, 0x2d, kByPrefix},  // to integers
    {Map0F, None, 0x2e, 0x2f, 4},             // compare
    {Map0F, H66, 0x2e, 0x2f, 8},
    {Map0F, Any, 0x40, 0x4f, kReal},   // conditional move
    {Map0F, None, 0x5a, 0x5a, kHalf},  // floats to doubles
    {Map0F, Any, 0x5b, 0x5b, kVector},
    {Map0F, Any, 0x10, 0x11, kByPrefix},  // moves
    {Map0F, Any, 0x51, 0x5f, kByPrefix},  // arithmetic
    {Map0F, Any, 0xc2, 0xc2, kByPrefix},  // compare to a mask
    {Map0F, F3, 0x7e, 0x7e, 8},
    {Map0F, Any, 0x6e, 0x6e, kReal},
    {Map0F, Any, 0x7e, 0x7e, kReal},
    {Map0F, Any, 0xa0, 0xc1, kReal},  // integers
    {Map0F, Any, 0xc3, 0xc3, kReal},
    {Map0F, Any, 0xd6, 0xd6, 8},
    {Map0F38, Any, 0x18, 0x18, 4},  // one element to all
    {Map0F38, Any, 0x58, 0x58, 4},
    {Map0F38, Any, 0x19, 0x19, 8},
    {Map0F38, Any, 0x59, 0x59, 8},
    {Map0F38, Any, 0xf0, 0xff, kReal},  // integers
    {Map0F3A, Any, 0x0a, 0x0a, 4},      // round
    {Map0F3A, Any, 0x17, 0x17, 4},      // extract, insert
    {Map0F3A, Any, 0x21, 0x21, 4},
    {Map0F3A, Any, 0x18, 0x19, 16},
    {Map0F3A, Any, 0x38, 0x39, 16},
};

struct Instruction {
  Prefix prefix = None;
  bool wide = false;  // REX.W or its like
  int map = OneByte;
  std::size_t vector = 16;
  int opcode = 0;

  std::size_t bytes(std::size_t width) const {
    switch (width) {
      case kVector:
        return vector;
      case kHalf:
        return vector / 2;
      case kByPrefix:  // ps and pd take a vector, ss and sd one number
        return prefix == F3 ? 4 : prefix == F2 ? 8 : vector;
      case kReal:
        return wide ? 8 : 4;
      default:
        return width;
    }
  }
};

Instruction read_legacy(const std::uint8_t* code) {
  Instruction i;
  for (;; ++code) {
    if (*code == 0xf3 || *code == 0xf2) {
      i.prefix = *code == 0xf3 ? F3 : F2;
    } else if (*code == 0x66) {
      if (i.prefix == None) i.prefix = H66;
    } else if ((*code & 0xf0) == 0x40) {
      i.wide = (*code & 0x08) != 0;
    } else if (*code != 0xf0) {  // lock
      break;
    }
  }
  if (*code == 0x0f) {
    i.map = code[1] == 0x38 ? Map0F38 : code[1] == 0x3a ? Map0F3A : Map0F;
    code += i.map == Map0F ? 1 : 2;
  }
  i.opcode = *code;
  return i;
}

Instruction read_instruction(const std::uint8_t* code) {
  switch (*code) {
    case 0xc5:
      return {kPrefixes[code[1] & 3], false, Map0F, code[1] & 4 ? 32U : 16U, code[2]};
    case 0xc4:
      return {kPrefixes[code[2] & 3], (code[2] & 0x80) != 0, code[1] & 0x1f,
              code[2] & 4 ? 32U : 16U, code[3]};
    case 0x62:
      return {kPrefixes[code[2] & 3], (code[2] & 0x80) != 0, code[1] & 7,
              std::size_t{16} << ((code[3] >> 5) & 3), code[4]};
    default:
      return read_legacy(code);
  }
}

/// Fused multiply-add of one number.
bool is_scalar_fma(const Instruction& i) {
  return i.map == Map0F38 && i.opcode >= 0x99 && i.opcode <= 0xbf && (i.opcode & 9) == 9;
}

}  // namespace

std::size_t memory_operand_bytes(const std::uint8_t* code) {
  const Instruction i = read_instruction(code);
  if (is_scalar_fma(i)) return i.bytes(kReal);
  for (const Rule& r : kRules) {
    const bool fits = r.map == i.map && (r.prefixes & i.prefix) != 0;
    if (fits && i.opcode >= r.first && i.opcode <= r.last) return i.bytes(r.width);
  }
  return i.vector;
}

}  // namespace lac::sim
