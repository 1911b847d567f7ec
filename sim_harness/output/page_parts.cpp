// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/output/page_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/part_file.hpp"

namespace lac::sim {

std::string html_text(std::string_view text) {
  constexpr std::string_view kSpecial = "&<>\"'";
  constexpr std::array kNames{"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  std::string html;
  for (const char c : text) {
    const std::size_t which = kSpecial.find(c);
    which == std::string_view::npos ? html += c : html += kNames[which];
  }
  return html;
}

std::string displayed_number(std::string number) {
  const bool negative = number.starts_with('-');
  if (negative) number.erase(0, 1);
  const std::size_t digits = std::min(number.find_first_not_of("0123456789"), number.size());
  for (std::size_t at = digits; digits > 4 && at > 3;) number.insert(at -= 3, "\u202f");
  return (negative ? "\u2212" : "") + number;
}

std::string metadata_html(const std::vector<std::pair<std::string, std::string>>& metadata) {
  if (metadata.empty()) return {};
  std::string html = "<dl class=\"metadata\">\n";
  for (const auto& [name, value] : metadata) {
    html += "<div><dt>" + html_text(name) + "</dt><dd>" + html_text(value) + "</dd></div>\n";
  }
  return html + "</dl>";
}

std::string list_html(const std::vector<std::string>& lines) {
  if (lines.empty()) return {};
  std::string html = "<ul class=\"notes\">\n";
  for (const std::string& line : lines) html += "<li>" + html_text(line) + "</li>\n";
  return html + "</ul>";
}

std::string bar_html(double change, double widest) {
  if (!std::isfinite(change) || widest <= 0.0) return {};
  char width[16];
  std::snprintf(width, sizeof width, "%.1f", 50.0 * std::min(1.0, std::abs(change) / widest));
  return std::string("<span class=\"bar\" aria-hidden=\"true\"><i class=\"") +
         (change < 0.0 ? "down" : "up") + "\" style=\"width:" + width + "%\"></i></span>";
}

std::string json_text(std::string_view text) {
  std::string json = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || c == '"' || c == '\\' || c == '<' || c == '>' || c == '&') {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", code);
      json += escape;
    } else {
      json += c;
    }
  }
  return json + "\"";
}

std::string json_number(double value, int digits) {
  if (!std::isfinite(value)) return "null";
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string filled_page(std::string_view page,
                        const std::map<std::string, std::string, std::less<>>& parts) {
  constexpr std::string_view kOpen = "<!--lac:", kClose = "-->";
  std::string html;
  for (std::size_t at = page.find(kOpen); at != std::string_view::npos; at = page.find(kOpen)) {
    const std::size_t end = page.find(kClose, at);
    html += page.substr(0, at);
    html += parts.at(std::string(page.substr(at + kOpen.size(), end - at - kOpen.size())));
    page.remove_prefix(end + kClose.size());
  }
  return html.append(page);
}

void write_page(const std::filesystem::path& path, std::string_view html) {
  write_whole_file(path, html);
}

}  // namespace lac::sim
