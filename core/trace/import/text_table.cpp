// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/import/text_table.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "base/text.h"
#include "trace/control_trace.h"
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
constexpr std::size_t kColumnBytes = 1000;  // beside its values: names, roles, remarks

struct TableLayout {
  char separator = ',';  ///< ' ' means any number of blanks and tabs
  char decimal = '.';
  std::size_t width = 0;  ///< columns of a row of numbers
  DateOrder dates = DateOrder::DayFirst;
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

struct CellValue {
  double value = 0.0;
  ClockKind kind = ClockKind::None;
};

std::optional<CellValue> clockValue(std::string_view cell, const TableLayout& layout) {
  const auto clock = parseClock(cell, layout.dates);
  return clock ? std::optional(CellValue{clock->seconds, clock->kind}) : std::nullopt;
}

std::optional<CellValue> cellValue(std::string_view cell, const TableLayout& layout) {
  if (layout.decimal == ',') {
    std::array<char, 64> text{};
    if (cell.size() >= text.size() || cell.find('.') != std::string_view::npos) {
      return clockValue(cell, layout);
    }
    std::replace_copy(cell.begin(), cell.end(), text.begin(), ',', '.');
    if (const auto value = base::parseNumber({text.data(), cell.size()})) {
      return CellValue{*value};
    }
  } else if (const auto value = base::parseNumber(cell)) {
    return CellValue{*value};
  }
  if (cell.size() == 4 || cell.size() == 5) {
    const std::string word = base::toUpper(cell);
    if (word == "TRUE" || word == "FALSE") {
      return CellValue{word == "TRUE" ? 1.0 : 0.0};
    }
  }
  return clockValue(cell, layout);
}

/// Empty cells at the end come from a separator at the end of the line.
std::size_t widthOf(const std::vector<std::string_view>& cells) {
  return cells.size() - static_cast<std::size_t>(!cells.empty() && cells.back().empty());
}

/// True if more than half of what the cells hold are numbers.
bool isNumbers(const std::vector<std::string_view>& cells, const TableLayout& layout) {
  std::size_t numbers = 0;
  std::size_t filled = 0;
  for (const std::string_view cell : cells) {
    filled += static_cast<std::size_t>(!cell.empty());
    numbers += static_cast<std::size_t>(cellValue(cell, layout).has_value());
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
  static const std::array<TableLayout, 7> kCandidates{
      {{'\t', '.'}, {';', '.'}, {',', '.'}, {' ', '.'}, {'\t', ','}, {';', ','}, {' ', ','}}};
  std::optional<TableLayout> best;
  double bestScore = 0.0;
  std::vector<std::string_view> cells;
  for (const TableLayout& candidate : kCandidates) {
    std::map<std::size_t, std::size_t> widths;
    std::size_t numbers = 0;
    std::size_t all = 0;
    // The second half: a head may be long.
    for (std::size_t i = sample.size() / 2; i < sample.size(); ++i) {
      splitCells(sample[i], candidate.separator, cells);
      for (std::size_t cell = 0; cell < widthOf(cells); ++cell) {
        numbers += static_cast<std::size_t>(cellValue(cells[cell], candidate).has_value());
        ++all;
      }
      if (isNumbers(cells, candidate)) {
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
      best = candidate;
      best->width = usual->first;
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

/// Rows that do not fit.
struct OddRows {
  std::size_t count = 0;
  std::size_t firstLine = 0;

  void add(std::size_t line) {
    firstLine = count == 0 ? line : firstLine;
    ++count;
  }
  /// @param linesBefore  of the text before the one that `later` is about
  void add(const OddRows& later, std::size_t linesBefore) {
    firstLine = count == 0 && later.count > 0 ? linesBefore + later.firstLine : firstLine;
    count += later.count;
  }
};

}  // namespace

namespace {

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

namespace {

/// The rows of a table. In its head, quotes may hold line ends.
class RowReader {
 public:
  explicit RowReader(std::string_view text) : m_reader(text) {}

  /// @param isHead  the numbers have not begun
  [[nodiscard]] std::optional<lines::LineReader::Line> next(bool isHead) {
    auto line = m_reader.next();
    if (!line || !isHead || !isOpen(line->text)) {
      return line;
    }
    // What does not end soon is no quote, but an inch sign.
    lines::LineReader ahead = m_reader;
    m_joined = line->text;
    for (int i = 0; i < kLinesOfCell; ++i) {
      const auto more = ahead.next();
      if (!more) {
        break;
      }
      (m_joined += ' ') += more->text;
      if (!isOpen(m_joined)) {
        m_reader = ahead;
        return lines::LineReader::Line{m_joined, line->number, more->whole};
      }
    }
    return line;
  }
  [[nodiscard]] std::size_t linesRead() const { return m_reader.linesRead(); }
  [[nodiscard]] std::string_view rest() const { return m_reader.rest(); }

 private:
  static constexpr int kLinesOfCell = 4;

  static bool isOpen(std::string_view text) {
    return std::count(text.begin(), text.end(), '"') % 2 != 0;
  }

  lines::LineReader m_reader;
  std::string m_joined;
};

/// What the first date says that can be read in one way only. @param sample  the first lines
/// @return nothing: there are dates with slashes, and none says it; errors of `TextBlocks::next`
base::Result<std::optional<DateOrder>> datesOf(TextBlocks& blocks,
                                               const std::vector<std::string_view>& sample,
                                               const TableLayout& layout) {
  std::vector<std::string_view> cells;
  const bool hasSlashes = std::any_of(sample.begin(), sample.end(), [&](std::string_view line) {
    splitCells(line, layout.separator, cells);
    return std::any_of(cells.begin(), cells.end(), hasSlashDate);
  });
  if (!hasSlashes) {
    return layout.dates;
  }
  blocks.rewind();
  for (;;) {
    const auto block = blocks.next();
    if (!block) {
      return base::fail(block.error());
    }
    if (!*block) {
      return std::nullopt;
    }
    lines::LineReader reader(**block);
    while (const auto line = reader.next()) {
      splitCells(line->text, layout.separator, cells);
      for (const std::string_view cell : cells) {
        if (const auto order = dateOrderOf(cell)) {
          return order;
        }
      }
    }
  }
}

/// A time of day belongs to the date beside it, or to the only one. Without a date, it goes on
/// after midnight.
void completeTimes(TextTable& table) {
  const auto isDate = [&table](std::size_t column) {
    return column < table.kinds.size() && table.kinds[column] == ClockKind::Date;
  };
  const auto dates = std::count(table.kinds.begin(), table.kinds.end(), ClockKind::Date);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.kinds[i] != ClockKind::TimeOfDay) {
      continue;
    }
    std::optional<std::size_t> date;
    if (i > 0 && isDate(i - 1)) {
      date = i - 1;
    } else if (isDate(i + 1)) {
      date = i + 1;
    } else if (dates == 1) {
      date = static_cast<std::size_t>(
          std::find(table.kinds.begin(), table.kinds.end(), ClockKind::Date) - table.kinds.begin());
    }
    double midnight = 0.0;
    double before = 0.0;
    const PackedValues times = std::exchange(table.columns[i], {});
    PackedReader<PackedValues> timeAt(times);
    PackedReader<PackedValues> dayAt(table.columns[date.value_or(i)]);
    for (std::size_t row = 0; row < times.size(); ++row) {
      double value = timeAt[row];
      if (date) {
        const double day = dayAt[row];
        midnight = std::isfinite(day) ? day : midnight;
      } else if (std::isfinite(value)) {
        midnight += value < before - kDayS / 2 ? kDayS : 0.0;
        before = value;
      }
      value += midnight;
      table.columns[i].push_back(value);
    }
    table.kinds[i] = ClockKind::Timestamp;
  }
}

/// The rows of a part of the text, after the head.
class RowParser {
 public:
  explicit RowParser(const TableLayout& layout) : m_layout(layout), m_kinds(layout.width) {}

  void parse(std::string_view text) {
    lines::LineReader reader(text);
    while (const auto line = reader.next()) {
      m_lines = line->number;
      add(*line);
    }
  }
  [[nodiscard]] std::size_t rows() const { return m_values.size() / m_layout.width; }
  [[nodiscard]] double value(std::size_t row, std::size_t column) const {
    return m_values[row * m_layout.width + column];
  }

 private:
  friend class TableBuilder;

  void add(const lines::LineReader::Line& line) {
    const std::size_t before = m_values.size();
    if (readNumbers(line.text)) {
      return;
    }
    m_values.resize(before);
    splitCells(line.text, m_layout.separator, m_cells);
    const std::size_t width = widthOf(m_cells);
    if (width == 0) {
      return;
    }
    if (width == m_layout.width || m_cells.size() == m_layout.width) {
      addRow(line.number);
    } else if (line.whole) {
      m_odd.add(line.number);
    } else {
      m_isCut = true;
    }
  }

  /// Nearly every row holds plain numbers and nothing else. @return false: this one does not
  bool readNumbers(std::string_view line) {
    constexpr std::ptrdiff_t kCellMax = 63;  // as `cellValue`, of numbers with a comma
    const char* at = line.data();
    const char* const end = at + line.size();
    const fast_float::parse_options options(fast_float::chars_format::general, m_layout.decimal);
    const bool isTabbed = m_layout.separator == '\t';
    const auto skipBlanks = [&] {
      while (at != end && (*at == ' ' || (*at == '\t' && !isTabbed))) {
        ++at;
      }
    };
    for (std::size_t column = 0; column < m_layout.width; ++column) {
      skipBlanks();
      double value = 0.0;
      const auto [next, status] = fast_float::from_chars_advanced(at, end, value, options);
      if (status != std::errc{} || next - at > kCellMax) {
        return false;
      }
      m_values.push_back(value);
      const bool isLast = column + 1 == m_layout.width;
      at = next;
      skipBlanks();
      if (isLast || m_layout.separator == ' ') {
        if (isLast ? at != end : at == next) {
          return false;
        }
      } else if (at == end || *at++ != m_layout.separator) {
        return false;
      }
    }
    return true;
  }

  void addRow(std::size_t line) {
    std::size_t texts = 0;
    std::size_t values = 0;
    for (std::size_t column = 0; column < m_layout.width; ++column) {
      const auto value = cellValue(m_cells[column], m_layout);
      texts += static_cast<std::size_t>(!value && !m_cells[column].empty());
      values += static_cast<std::size_t>(value.has_value());
      m_values.push_back(value ? value->value : kNoValue);
      if (value && m_kinds[column] == ClockKind::None) {
        m_kinds[column] = value->kind;
      }
    }
    if (values == 0 && texts > 0) {
      m_text.add(line);  // such as a heading that comes again
      return;
    }
    for (; texts > 0; --texts) {
      m_noNumbers.add(line);
    }
  }

  TableLayout m_layout;
  std::vector<double> m_values;  ///< row by row
  std::vector<ClockKind> m_kinds;
  std::vector<std::string_view> m_cells;
  std::size_t m_lines = 0;
  OddRows m_odd;
  OddRows m_noNumbers;
  OddRows m_text;
  bool m_isCut = false;
};

/// Joins the rows in their order.
class TableBuilder {
 public:
  TableBuilder(const TableLayout& layout, const base::Budget& budget, base::Executor& executor)
      : m_layout(layout),
        m_budget(budget),
        m_executor(executor),
        m_headBytes(layout.width * kColumnBytes) {
    m_table.columns.resize(layout.width);
    m_table.kinds.resize(layout.width);
  }
  /// @param block  whole lines, those after the block before  @return error BudgetError::Exceeded
  base::Result<void> add(std::string_view block);
  [[nodiscard]] TextTable finish();

 private:
  /// Lines of the head. @param block  what is left behind them
  base::Result<void> addHead(std::string_view& block);
  void join(const std::vector<RowParser>& parts);

  TableLayout m_layout;
  const base::Budget& m_budget;
  base::Executor& m_executor;
  TextTable m_table;
  std::size_t m_headBytes;
  std::size_t m_lines = 0;  ///< before the block
  bool m_hasBegun = false;
  OddRows m_odd;
  OddRows m_noNumbers;
  OddRows m_text;
  bool m_isCut = false;
};

base::Result<void> TableBuilder::addHead(std::string_view& block) {
  RowReader reader(block);
  std::vector<std::string_view> cells;
  std::size_t lines = 0;
  while (!m_hasBegun) {
    block = reader.rest();
    lines = reader.linesRead();
    const auto line = reader.next(true);
    if (!line) {
      break;
    }
    splitCells(line->text, m_layout.separator, cells);
    const std::size_t width = widthOf(cells);
    const bool fits = width == m_layout.width || cells.size() == m_layout.width;
    m_hasBegun = width > 0 && fits && isNumbers(cells, m_layout);
    if (m_hasBegun) {
      break;
    }
    if (width > 0 && m_table.head.size() < kHeadLinesMax) {
      m_table.head.push_back({{cells.begin(), cells.end()}, m_lines + line->number, false});
      m_table.head.back().holdsValue =
          std::any_of(cells.begin(), cells.end(),
                      [this](std::string_view cell) { return cellValue(cell, m_layout); });
      m_headBytes += cells.size() * sizeof(std::string) + line->text.size();
    }
    if (m_headBytes > m_budget.left()) {
      return base::fail(m_budget.exceeded("The head of the table"));
    }
  }
  m_lines += lines;
  return {};
}

base::Result<void> TableBuilder::add(std::string_view block) {
  if (!m_hasBegun) {
    if (auto done = addHead(block); !done) {
      return done;
    }
  }
  const std::vector<std::string_view> texts = partsOf(block);
  std::vector<RowParser> parts(texts.size(), RowParser(m_layout));
  m_executor.forEach(texts.size(), [&](std::size_t part) { parts[part].parse(texts[part]); });
  join(parts);
  std::size_t held = m_headBytes + m_table.columns.front().size() * kAnalysedRowBytes;
  for (const PackedValues& column : m_table.columns) {
    held += column.memoryBytes();
  }
  return held > m_budget.left() ? base::fail(m_budget.exceeded("The table with its analysis"))
                                : base::Result<void>();
}

void TableBuilder::join(const std::vector<RowParser>& parts) {
  m_executor.forEach(m_layout.width, [&](std::size_t column) {
    for (const RowParser& part : parts) {
      for (std::size_t row = 0; row < part.rows(); ++row) {
        m_table.columns[column].push_back(part.value(row, column));
      }
      if (m_table.kinds[column] == ClockKind::None) {
        m_table.kinds[column] = part.m_kinds[column];
      }
    }
  });
  for (const RowParser& part : parts) {
    m_odd.add(part.m_odd, m_lines);
    m_text.add(part.m_text, m_lines);
    m_noNumbers.add(part.m_noNumbers, m_lines);
    m_isCut = m_isCut || part.m_isCut;
    m_lines += part.m_lines;
  }
}

TextTable TableBuilder::finish() {
  const auto add = [this](RemarkCode code, std::vector<std::string> values) {
    m_table.remarks.push_back({code, std::move(values)});
  };
  if (m_odd.count > 0) {
    add(RemarkCode::OddRows, {std::to_string(m_layout.width), std::to_string(m_odd.count),
                              std::to_string(m_odd.firstLine)});
  }
  if (m_text.count > 0) {
    add(RemarkCode::TextRows, {std::to_string(m_text.count), std::to_string(m_text.firstLine)});
  }
  if (m_noNumbers.count > 0) {
    add(RemarkCode::NoNumbers,
        {std::to_string(m_noNumbers.count), std::to_string(m_noNumbers.firstLine)});
  }
  if (m_isCut) {
    add(RemarkCode::CutInRow, {});
  }
  completeTimes(m_table);
  return std::move(m_table);
}

}  // namespace

base::Result<TextTable> readTable(TextBlocks& blocks, const TextFacts& facts,
                                  const base::Budget& budget, base::Executor& executor) {
  // Cells are split line by line, and the longest line may be all of the text.
  constexpr double kBytesPerCharacter = 2 * sizeof(std::string_view);  // a list that grows
  if (auto fits = budget.require(kBytesPerCharacter * static_cast<double>(facts.longestLine),
                                 "A row of the table");
      !fits) {
    return base::fail(fits.error());
  }
  const std::vector<std::string_view> sample = firstLines(blocks.beginning());
  auto layout = facts.hasNull ? std::optional<TableLayout>() : recognise(sample);
  if (!layout) {
    return base::fail(ImportError::NotATable,
                      "The file holds no rows of numbers. Export the trace as a table (CSV).");
  }
  const auto dates = datesOf(blocks, sample, *layout);
  if (!dates) {
    return base::fail(dates.error());
  }
  layout->dates = dates->value_or(layout->dates);
  TableBuilder table(*layout, budget, executor);
  blocks.rewind();
  for (;;) {
    const auto block = blocks.next();
    if (!block) {
      return base::fail(block.error());
    }
    if (!*block) {
      break;
    }
    if (auto done = table.add(**block); !done) {
      return base::fail(done.error());
    }
  }
  TextTable read = table.finish();
  if (!*dates) {
    read.remarks.push_back({RemarkCode::DayFirstAssumed});
  }
  return read;
}

}  // namespace rivulet::trace
