// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/import/text_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

#include "base/text.h"
#include "trace/import/import_error.h"
#include "trace/lines.h"
#include "trace/signals.h"

namespace rivulet::trace {

namespace {

/// Lines from which the layout is recognised.
constexpr std::size_t kLayoutLines = 400;
/// A head may hold that many lines.
constexpr std::size_t kHeadLinesMax = 200;

// What is held of a table, with the signals that are made of it and their analysis, bytes.
constexpr std::size_t kCellBytes = 2 * sizeof(double);
constexpr std::size_t kColumnBytes = 1000;  // beside its values: names, roles, remarks

struct TableLayout {
  char separator = ',';  ///< ' ' means any number of blanks and tabs
  char decimal = '.';
  std::size_t width = 0;  ///< columns of a row of numbers
};

/// The cells of a line, without blanks and quotes around them.
void splitCells(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  if (separator == ' ') {
    std::size_t at = 0;
    while (at < line.size()) {
      const std::size_t begin = line.find_first_not_of(" \t", at);
      if (begin == std::string_view::npos) {
        return;
      }
      at = std::min(line.find_first_of(" \t", begin), line.size());
      cells.push_back(line.substr(begin, at - begin));
    }
    return;
  }
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t at = 0; at <= line.size(); ++at) {
    if (at < line.size() && line[at] == '"') {
      quoted = !quoted;
    }
    if (at < line.size() && (line[at] != separator || quoted)) {
      continue;
    }
    std::string_view cell = base::trim(line.substr(begin, at - begin));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
      cell = base::trim(cell.substr(1, cell.size() - 2));
    }
    cells.push_back(cell);
    begin = at + 1;
  }
}

/// Days from 1970-01-01, Gregorian. @source H. Hinnant: chrono-compatible low-level date algorithms
std::int64_t daysOf(int year, int month, int day) {
  const int y = month <= 2 ? year - 1 : year;
  const int era = (y >= 0 ? y : y - 399) / 400;
  const int ofEra = y - era * 400;
  const int ofYear = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
  return std::int64_t{era} * 146097 + ofEra * 365 + ofEra / 4 - ofEra / 100 + ofYear - 719468;
}

/// "2026-01-02T03:04:05.678Z" and "03:04:05,678" as seconds.
std::optional<double> clockSeconds(std::string_view cell) {
  double seconds = 0.0;
  if (cell.size() > 11 && cell[4] == '-' && cell[7] == '-' &&
      (cell[10] == 'T' || cell[10] == ' ')) {
    const auto year = base::parseInteger(cell.substr(0, 4));
    const auto month = base::parseInteger(cell.substr(5, 2));
    const auto day = base::parseInteger(cell.substr(8, 2));
    if (!year || !month || !day || *month < 1 || *month > 12) {
      return std::nullopt;
    }
    seconds = 86400.0 * static_cast<double>(daysOf(*year, *month, *day));
    cell.remove_prefix(11);
  }
  if (!cell.empty() && cell.back() == 'Z') {
    cell.remove_suffix(1);
  }
  if (cell.size() < 8 || cell[2] != ':' || cell[5] != ':') {
    return std::nullopt;
  }
  std::string last(cell.substr(6));
  std::replace(last.begin(), last.end(), ',', '.');
  const auto hours = base::parseInteger(cell.substr(0, 2));
  const auto minutes = base::parseInteger(cell.substr(3, 2));
  const auto rest = base::parseNumber(last);
  if (!hours || !minutes || !rest) {
    return std::nullopt;
  }
  return seconds + 3600.0 * *hours + 60.0 * *minutes + *rest;
}

std::optional<double> cellValue(std::string_view cell, char decimal) {
  if (decimal == ',') {
    std::array<char, 64> text{};
    if (cell.size() >= text.size() || cell.find('.') != std::string_view::npos) {
      return clockSeconds(cell);
    }
    std::replace_copy(cell.begin(), cell.end(), text.begin(), ',', '.');
    if (const auto value = base::parseNumber({text.data(), cell.size()})) {
      return value;
    }
  } else if (const auto value = base::parseNumber(cell)) {
    return value;
  }
  if (cell.size() == 4 || cell.size() == 5) {
    const std::string word = base::toUpper(cell);
    if (word == "TRUE" || word == "FALSE") {
      return word == "TRUE" ? 1.0 : 0.0;
    }
  }
  return clockSeconds(cell);
}

/// Empty cells at the end come from a separator at the end of the line.
std::size_t widthOf(const std::vector<std::string_view>& cells) {
  return cells.size() - static_cast<std::size_t>(!cells.empty() && cells.back().empty());
}

/// True if more than half of what the cells hold are numbers.
bool isNumbers(const std::vector<std::string_view>& cells, char decimal) {
  std::size_t numbers = 0;
  std::size_t filled = 0;
  for (const std::string_view cell : cells) {
    filled += static_cast<std::size_t>(!cell.empty());
    numbers += static_cast<std::size_t>(cellValue(cell, decimal).has_value());
  }
  return 2 * numbers > filled;
}

/// A row ends with a separator because it has one more column that is empty there: some line has
/// something in it, such as the heading.
bool hasLastColumn(const std::vector<std::string_view>& sample, char separator, std::size_t width) {
  std::vector<std::string_view> cells;
  std::size_t ended = 0;
  std::size_t filled = 0;
  for (const std::string_view line : sample) {
    splitCells(line, separator, cells);
    if (cells.size() == width + 1) {
      ++(cells.back().empty() ? ended : filled);
    }
  }
  return filled > 0 && 2 * (ended + filled) > sample.size();
}

/// The layout in which most of the text are numbers.
std::optional<TableLayout> recognise(const std::vector<std::string_view>& sample) {
  struct Candidate {
    char separator;
    char decimal;
  };
  static constexpr std::array<Candidate, 7> kCandidates{
      {{'\t', '.'}, {';', '.'}, {',', '.'}, {' ', '.'}, {'\t', ','}, {';', ','}, {' ', ','}}};
  std::optional<TableLayout> best;
  double bestScore = 0.0;
  std::vector<std::string_view> cells;
  for (const Candidate& candidate : kCandidates) {
    std::map<std::size_t, std::size_t> widths;
    std::size_t numbers = 0;
    std::size_t all = 0;
    // The second half: a head may be long.
    for (std::size_t i = sample.size() / 2; i < sample.size(); ++i) {
      splitCells(sample[i], candidate.separator, cells);
      for (std::size_t cell = 0; cell < widthOf(cells); ++cell) {
        numbers += static_cast<std::size_t>(cellValue(cells[cell], candidate.decimal).has_value());
        ++all;
      }
      if (isNumbers(cells, candidate.decimal)) {
        ++widths[widthOf(cells)];
      }
    }
    const auto usual =
        std::max_element(widths.begin(), widths.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (usual == widths.end()) {
      continue;
    }
    const double share = static_cast<double>(numbers) / static_cast<double>(all);
    // A single column is the last choice, except that everything is a number in it.
    const double score = share + (usual->first > 1 ? 1.0 : 0.0);
    if (score > bestScore + 1e-9) {
      bestScore = score;
      best = TableLayout{candidate.separator, candidate.decimal, usual->first};
    }
  }
  if (best && hasLastColumn(sample, best->separator, best->width)) {
    ++best->width;
  }
  return best;
}

std::vector<std::string_view> firstLines(std::string_view text) {
  std::vector<std::string_view> sample;
  lines::LineReader reader(text);
  while (const auto line = reader.next()) {
    if (!base::trim(line->text).empty()) {
      sample.push_back(line->text);
    }
    if (sample.size() == kLayoutLines) {
      break;
    }
  }
  return sample;
}

void appendUtf8(std::string& out, char32_t c) {
  if (c < 0x80) {
    out += static_cast<char>(c);
  } else if (c < 0x800) {
    out += static_cast<char>(0xC0 | (c >> 6U));
    out += static_cast<char>(0x80 | (c & 0x3FU));
  } else {
    out += static_cast<char>(0xE0 | (c >> 12U));
    out += static_cast<char>(0x80 | ((c >> 6U) & 0x3FU));
    out += static_cast<char>(0x80 | (c & 0x3FU));
  }
}

/// Cells are split line by line, and the longest line may be all of the text.
base::Result<void> requireCells(std::string_view text, const base::Budget& budget) {
  constexpr double kBytesPerCharacter = 2 * sizeof(std::string_view);  // a list that grows
  std::size_t longest = 0;
  lines::LineReader reader(text);
  while (const auto line = reader.next()) {
    longest = std::max(longest, line->text.size());
  }
  return budget.require(kBytesPerCharacter * static_cast<double>(longest), "A row of the table");
}

/// One row that does not fit.
struct OddRows {
  std::size_t count = 0;
  std::size_t firstLine = 0;

  void add(std::size_t line) {
    firstLine = count == 0 ? line : firstLine;
    ++count;
  }
};

}  // namespace

namespace {

/// Bytes beyond ASCII come in sequences as UTF-8 has them.
bool isUtf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto first = static_cast<unsigned char>(bytes[i]);
    const int more = first < 0x80                    ? 0
                     : first >= 0xC2 && first < 0xE0 ? 1
                     : first >= 0xE0 && first < 0xF0 ? 2
                     : first >= 0xF0 && first < 0xF5 ? 3
                                                     : -1;
    if (more < 0) {
      return false;
    }
    // A file may be cut within its last character.
    for (int left = more; left > 0 && i + 1 < bytes.size(); --left) {
      if ((static_cast<unsigned char>(bytes[++i]) & 0xC0U) != 0x80U) {
        return false;
      }
    }
  }
  return true;
}

/// Each byte is a character, as tools on old computers write it.
void appendLatin1(std::string& text, std::string_view bytes) {
  for (const char c : bytes) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x80) {
      text += c;
    } else {
      text += static_cast<char>(0xC0U | code >> 6U);
      text += static_cast<char>(0x80U | (code & 0x3FU));
    }
  }
}

}  // namespace

base::Result<std::string_view> utf8Of(std::string_view bytes, std::string& converted,
                                      const base::Budget& budget) {
  constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
  if (bytes.starts_with(kUtf8Mark)) {
    return bytes.substr(kUtf8Mark.size());
  }
  const bool isLittle = bytes.starts_with("\xFF\xFE");
  const bool isWide = isLittle || bytes.starts_with("\xFE\xFF");
  if (!isWide && isUtf8(bytes)) {
    return bytes;
  }
  const std::size_t size = isWide ? bytes.size() / 2 * 3 : 2 * bytes.size();  // at most
  if (auto fits = budget.require(static_cast<double>(size), "The text as UTF-8"); !fits) {
    return base::fail(fits.error());
  }
  converted.reserve(size);
  if (!isWide) {
    appendLatin1(converted, bytes);
    return converted;
  }
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const auto low = static_cast<unsigned char>(bytes[i + (isLittle ? 0 : 1)]);
    const auto high = static_cast<unsigned char>(bytes[i + (isLittle ? 1 : 0)]);
    appendUtf8(converted, static_cast<char32_t>(high << 8U | low));
  }
  return converted;
}

base::Result<TextTable> readTable(std::string_view text, const base::Budget& budget) {
  if (auto fits = requireCells(text, budget); !fits) {
    return base::fail(fits.error());
  }
  const auto layout = text.find('\0') == std::string_view::npos ? recognise(firstLines(text))
                                                                : std::optional<TableLayout>();
  if (!layout) {
    return base::fail(ImportError::NotATable,
                      "The file holds no rows of numbers. Export the trace as a table (CSV).");
  }
  TextTable table;
  table.columns.resize(layout->width);
  const std::size_t rowBytes = layout->width * kCellBytes + kAnalysedSampleBytes;
  std::size_t held = layout->width * kColumnBytes;
  OddRows odd;
  OddRows noNumbers;
  std::size_t cutCells = 0;
  std::vector<std::string_view> cells;
  lines::LineReader reader(text);
  bool hasBegun = false;
  while (const auto line = reader.next()) {
    splitCells(line->text, layout->separator, cells);
    const std::size_t width = widthOf(cells);
    if (width == 0) {
      continue;
    }
    const bool fits = width == layout->width || cells.size() == layout->width;
    if (!hasBegun) {
      hasBegun = fits && isNumbers(cells, layout->decimal);
      if (!hasBegun) {
        if (table.head.size() < kHeadLinesMax) {
          table.head.emplace_back(cells.begin(), cells.end());
          held += cells.size() * sizeof(std::string) + line->text.size();
        }
        if (held > budget.left()) {
          return base::fail(budget.exceeded("The head of the table"));
        }
        continue;
      }
    }
    if (!fits) {
      if (line->whole) {
        odd.add(line->number);
      } else {
        cutCells = width;
      }
      continue;
    }
    held += rowBytes;
    if (held > budget.left()) {
      return base::fail(budget.exceeded("The table with its analysis"));
    }
    for (std::size_t column = 0; column < layout->width; ++column) {
      const auto value = cellValue(cells[column], layout->decimal);
      if (!value && !cells[column].empty()) {
        noNumbers.add(line->number);
      }
      table.columns[column].push_back(value.value_or(kNoValue));
    }
  }
  if (odd.count > 0) {
    table.remarks.push_back({RemarkCode::OddRows,
                             {std::to_string(layout->width), std::to_string(odd.count),
                              std::to_string(odd.firstLine)}});
  }
  if (noNumbers.count > 0) {
    table.remarks.push_back(
        {RemarkCode::NoNumbers,
         {std::to_string(noNumbers.count), std::to_string(noNumbers.firstLine)}});
  }
  if (cutCells > 0) {
    table.remarks.push_back({RemarkCode::CutInRow});
  }
  return table;
}

}  // namespace rivulet::trace
