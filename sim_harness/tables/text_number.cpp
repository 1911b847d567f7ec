// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tables/text_number.hpp"

#include <limits>

#include "core/plain_number.hpp"
#include "core/suggest.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {
namespace {

constexpr std::string_view kBlanks = " \t\r";

/// "1.5D+02" and "1.5-101" with an E in its place; the word itself if it has neither.
std::string with_exponent_letter(std::string_view word) {
  std::string text(word);
  const std::size_t letter = text.find_first_of("dD");
  if (letter != std::string::npos) {
    text[letter] = 'e';
    return text;
  }
  const std::size_t sign = text.find_last_of("+-");
  if (sign != std::string::npos && sign > 0) text.insert(sign, 1, 'e');
  return text;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::optional<double> number_in(std::string_view text) {
  std::string_view word = trimmed(text);
  if (word.empty() || equal_ignoring_case(word, "na") || equal_ignoring_case(word, "n/a"))
    return std::numeric_limits<double>::quiet_NaN();
  word = without_plus(word);
  if (const auto value = plain_number(word)) return value;
  return plain_number(with_exponent_letter(word));
}

std::string without_brackets(std::string_view unit) {
  if (unit.size() >= 2 && (unit.front() == '(' || unit.front() == '['))
    unit = unit.substr(1, unit.size() - 2);
  return unit.empty() ? "-" : std::string(unit);
}

std::string percent_text(double share, int decimals) {
  return format_value(100.0 * share, decimals) + " %";
}

}  // namespace lac::sim
