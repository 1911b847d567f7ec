// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lac::sim {

/// Without blanks, tabs and carriage returns at both ends.
std::string_view trimmed(std::string_view text);

/// A number as programs write it, blanks around it allowed: also "+1", "nan", "inf", and Fortran's
/// "1.5D+02" and "1.5-101". An empty text, "NA" and "n/a" are NaN: no value. None for anything
/// else.
std::optional<double> number_in(std::string_view text);

/// "kNm" of "(kNm)" or "[kNm]"; "-" of an empty text.
std::string without_brackets(std::string_view unit);

/// 0.123 as "12.3 %", with these decimals.
std::string percent_text(double share, int decimals);

}  // namespace lac::sim
