// SPDX-License-Identifier: Apache-2.0
// What the pages share: text in HTML and in JSON, blocks of a page, the way into a template.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lac::sim {

/// User text as HTML, also between quotes.
std::string html_text(std::string_view text);

/// A number's text as the scripts write it: a true minus, thousands apart from five digits on.
std::string displayed_number(std::string number);

/// A list of names and values; empty without one.
std::string metadata_html(const std::vector<std::pair<std::string, std::string>>& metadata);

/// A bulleted list; empty without a line.
std::string list_html(const std::vector<std::string>& lines);

/// A bar that grows from the middle to the left (change below 0) or to the right, `widest` (above
/// 0) being the whole half; empty for a change that is not finite.
std::string bar_html(double change, double widest);

/// A quoted JSON text without "<", ">" and "&", so that it can stand inside a script element.
std::string json_text(std::string_view text);

/// With so many significant digits; null for a value that is not finite.
std::string json_number(double value, int digits);

template <typename Items, typename ToText>
std::string json_array(const Items& items, ToText to_text) {
  std::string json = "[";
  for (const auto& item : items) {
    if (json.size() > 1) json += ',';
    json += to_text(item);
  }
  return json + "]";
}

/// The template with <!--lac:NAME--> replaced by the part of that name, in one pass: what was put
/// in is not looked at again. Throws std::out_of_range for a name that has no part.
std::string filled_page(std::string_view page,
                        const std::map<std::string, std::string, std::less<>>& parts);

/// Writes a page in one step: nothing half-written. Throws lac::Error with file and reason.
void write_page(const std::filesystem::path& path, std::string_view html);

}  // namespace lac::sim
