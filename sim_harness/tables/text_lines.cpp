// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tables/text_lines.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "sim_harness/tables/text_number.hpp"

namespace lac::sim {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

void split_at_blanks(std::string_view line, Cells& cells) {
  for (std::size_t at = line.find_first_not_of(" \t"); at != std::string_view::npos;
       at = line.find_first_not_of(" \t", at)) {
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    cells.push_back(line.substr(at, end - at));
    at = end;
  }
}

}  // namespace

TextLines::TextLines(const std::filesystem::path& file) : file_(file), in_(file, std::ios::binary) {
  if (!in_) fail_as_a_whole("cannot be opened for reading");
}

bool TextLines::next() {
  if (!std::getline(in_, text_)) return false;
  if (++number_ == 1 && text_.starts_with(kByteOrderMark)) text_.erase(0, kByteOrderMark.size());
  if (text_.ends_with('\r')) text_.pop_back();
  if (text_.find('\0') != std::string::npos) fail("found bytes that are no text");
  return true;
}

bool TextLines::is_empty() const {
  return trimmed(text_).empty();
}

void TextLines::fail_at(std::size_t line, const std::string& problem) const {
  throw Error(file_.string() + ":" + std::to_string(line) + ": " + problem);
}

void TextLines::fail_as_a_whole(const std::string& problem) const {
  throw Error(file_.string() + ": " + problem);
}

void split_cells(std::string_view line, char separator, Cells& cells) {
  cells.clear();
  if (separator == kBlanks) return split_at_blanks(line, cells);
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(separator, at), line.size());
    std::string_view cell = trimmed(line.substr(at, end - at));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
      cell = cell.substr(1, cell.size() - 2);
    cells.push_back(cell);
    at = end + 1;
  }
}

}  // namespace lac::sim
