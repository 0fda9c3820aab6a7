// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/import/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/median.h"
#include "base/text.h"
#include "trace/hdf5.h"
#include "trace/import/compression.h"
#include "trace/import/import_error.h"
#include "trace/import/mtconnect.h"
#include "trace/import/sinumerik_xml.h"
#include "trace/import/text_table.h"

namespace rivulet::trace {

namespace {

/// Assumed for a table that has neither a column of time nor a rate.
constexpr double kRateHzAssumed = 1000.0;
constexpr const char* kFiletimeUnit = "100ns";
/// Sections of a trace whose time starts again follow each other at this distance.
constexpr double kSectionGapS = 1.0;
/// So few rows whose time is too early are a fault of the recorder, which was not started again.
constexpr std::size_t kGlitchRows = 3;
/// More sections than this are a clock that runs unevenly: what runs backwards is left out.
constexpr std::size_t kSectionsMax = 20;

/// A column of a table with what is known of it.
struct Column {
  std::string name;
  std::string unit;
  PackedValues values;
  std::optional<SignalRole> role{};
  double factor = 1.0;  ///< to s, mm, mm/s
  bool isChosen = false;
  bool isClock = false;  ///< its cells are times, with or without a date
};

using Row = std::vector<std::string>;

std::string joined(const Row& row) {
  return fmt::format("{}", fmt::join(row, "|"));
}

/// TwinCAT Scope writes pairs of columns, and in its head pairs of a key and a value.
bool isTwinCat(const TextTable& table) {
  return std::any_of(table.head.begin(), table.head.end(), [](const HeadRow& row) {
    return !row.cells.empty() && row.cells[0] == "SampleTime[ms]";
  });
}

/// The value of a key for each channel.
std::vector<std::string> scopeValues(const TextTable& table, std::string_view key) {
  std::vector<std::string> values;
  // The key "Name" also stands in the first line, for the project: the last row counts.
  for (const auto& [row, line, holdsValue] : table.head) {
    if (row.empty() || row[0] != key) {
      continue;
    }
    values.clear();
    for (std::size_t i = 1; i < row.size(); i += 2) {
      values.push_back(row[i]);
    }
  }
  return values;
}

/// The first value that is one; nothing: there is none.
std::optional<double> firstValue(const PackedValues& values) {
  PackedReader<PackedValues> reader(values);
  for (std::size_t row = 0; row < reader.size(); ++row) {
    if (std::isfinite(reader[row])) {
      return reader[row];
    }
  }
  return std::nullopt;
}

/// Windows counts 100 ns since 1601. Whatever else counts to such numbers has another magnitude:
/// the same moments since 1970 are less than 5e12 in ms, more than 5e14 in µs and 5e17 in ns.
void takeFiletime(Column& column) {
  constexpr double kYear1980 = 1.19e17;
  constexpr double kYear2100 = 1.58e17;
  constexpr double kYear1970 = 116'444'736'000'000'000.0;
  const std::optional<double> first = firstValue(column.values);
  if (!first || *first < kYear1980 || *first > kYear2100) {
    return;
  }
  const PackedValues counts = std::exchange(column.values, {});
  PackedReader<PackedValues> reader(counts);
  for (std::size_t row = 0; row < counts.size(); ++row) {
    column.values.push_back(reader[row] - kYear1970);
  }
  column.unit = kFiletimeUnit;
  column.factor = unitFactor(column.unit, SignalRole::Time).value_or(1.0);
}

std::vector<Column> scopeColumns(TextTable& table) {
  const std::vector<std::string> names = scopeValues(table, "Name");
  const std::vector<std::string> units = scopeValues(table, "Unit");
  const std::vector<std::string> steps = scopeValues(table, "SampleTime[ms]");
  std::vector<Column> columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::size_t channel = i / 2;
    Column column;
    column.values = std::move(table.columns[i]);
    if (i % 2 == 1) {
      column.name = channel < names.size() ? names[channel] : fmt::format("#{}", i + 1);
      column.unit = channel < units.size() ? units[channel] : std::string();
    } else {
      column.name = fmt::format("time of {}", channel < names.size() ? names[channel] : "?");
      column.role = SignalRole::Time;
      const double stepMs =
          channel < steps.size() ? base::parseNumber(steps[channel]).value_or(1.0) : 1.0;
      // Some versions count samples, others write milliseconds: the first step tells.
      const bool isCounted = column.values.size() > 1 && stepMs != 1.0 &&
                             std::abs(column.values[1] - column.values[0] - 1.0) < 1e-9;
      column.unit = "ms";
      column.factor = 1e-3 * (isCounted ? stepMs : 1.0);
      column.isChosen = true;
      takeFiletime(column);
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

bool holdsUnits(const Row& row) {
  const auto units =
      std::count_if(row.begin(), row.end(), [](const std::string& c) { return isUnit(c); });
  return units > 0 && 2 * static_cast<std::size_t>(units) >= row.size();
}

/// A row of data that has no numbers yet: "UNAVAILABLE" again and again, or values among texts.
bool isTextRow(const HeadRow& row) {
  std::map<std::string_view, std::size_t> counts;
  std::size_t filled = 0;
  std::size_t most = 0;
  for (const std::string& cell : row.cells) {
    if (!cell.empty()) {
      ++filled;
      most = std::max(most, ++counts[cell]);
    }
  }
  return row.holdsValue || (most > 1 && 2 * most >= filled);
}

/// The columns with their headings: the last row before the numbers, or the last but one if the
/// last holds units. Rows of data without numbers are passed over if a heading stands before them.
std::vector<Column> headedColumns(TextTable& table) {
  const std::size_t width = table.columns.size();
  Row names;
  Row units;
  std::size_t textRows = 0;
  std::size_t firstTextRow = 0;
  const auto isHeading = [width](const HeadRow& row) {
    return row.cells.size() >= width && !isTextRow(row);
  };
  for (std::size_t i = table.head.size(); i-- > 0 && names.empty();) {
    Row& row = table.head[i].cells;
    if (row.size() < width) {
      continue;
    }
    const auto here = table.head.begin() + static_cast<std::ptrdiff_t>(i);
    if (isTextRow(table.head[i]) && !holdsUnits(row) &&
        std::any_of(table.head.begin(), here, isHeading)) {
      ++textRows;
      firstTextRow = table.head[i].line;
      continue;
    }
    row.resize(width);
    if (units.empty() && holdsUnits(row)) {
      units = row;
    } else {
      names = row;
    }
  }
  if (textRows > 0) {
    table.remarks.push_back(
        {RemarkCode::TextRows, {std::to_string(textRows), std::to_string(firstTextRow)}});
  }
  std::vector<Column> columns;
  for (std::size_t i = 0; i < width; ++i) {
    Column column;
    column.values = std::move(table.columns[i]);
    if (i < names.size()) {
      NameAndUnit parts = splitUnit(names[i]);
      column.name = names[i];
      column.unit = std::move(parts.unit);
    }
    if (i < units.size() && column.unit.empty()) {
      column.unit = base::trim(units[i]);
      if (column.unit.size() > 2 && (column.unit.front() == '[' || column.unit.front() == '(')) {
        column.unit = column.unit.substr(1, column.unit.size() - 2);
      }
    }
    if (column.name.empty()) {
      column.name = fmt::format("#{}", i + 1);
    }
    column.isClock = table.kinds[i] == ClockKind::Timestamp;
    if (column.isClock || table.kinds[i] == ClockKind::Date) {
      column.unit = "s";
    }
    takeFiletime(column);
    columns.push_back(std::move(column));
  }
  return columns;
}

void makeUnique(std::vector<Column>& columns, std::vector<Remark>& remarks) {
  std::set<std::string> taken;
  std::map<std::string, int> counts;
  for (Column& column : columns) {
    std::string name = column.name;
    // Counted on for each name: thousands may have the same.
    for (int& count = counts.try_emplace(name, 1).first->second; !taken.insert(name).second;) {
      name = fmt::format("{} ({})", column.name, ++count);
    }
    if (name != column.name) {
      remarks.push_back({RemarkCode::DuplicateColumn, {column.name, name}});
      column.name = name;
    }
  }
}

bool isAscending(const PackedValues& values) {
  std::size_t steps = 0;
  std::size_t ascending = 0;
  double before = kNoValue;
  PackedReader<PackedValues> reader(values);
  for (std::size_t row = 0; row < reader.size(); ++row) {
    const double value = reader[row];
    // Of several columns of time, the shorter ones end with empty cells.
    if (!std::isfinite(value)) {
      continue;
    }
    steps += static_cast<std::size_t>(std::isfinite(before));
    ascending += static_cast<std::size_t>(value > before);
    before = value;
  }
  return steps > 1 && 20 * ascending >= 19 * steps;
}

/// Every row one more than the row before: the number of the sample, not a time.
bool isCounter(const PackedValues& values) {
  return values.size() > 2 && values[0] == std::floor(values[0]) && values[1] - values[0] == 1.0 &&
         values[2] - values[1] == 1.0;
}

template <class List>
double medianStep(const List& values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size() && steps.size() < 1001; ++i) {
    if (values[i] > values[i - 1]) {
      steps.push_back(values[i] - values[i - 1]);
    }
  }
  if (steps.empty()) {
    return 0.0;
  }
  return base::median(std::move(steps));
}

/// The unit of a time that says none, from its steps: a control samples at 1 Hz to 10 kHz.
void guessTimeUnit(Column& column, std::vector<Remark>& remarks) {
  // Since 1970, the magnitude tells: a date of this century.
  constexpr double kYear2000S = 9.5e8;
  constexpr double kYear2100S = 4.1e9;
  const std::optional<double> known = firstValue(column.values);
  for (const char* const unit : {"ms", "us", "ns"}) {
    const double factor = unitFactor(unit, SignalRole::Time).value_or(1.0);
    if (known && factor * *known > kYear2000S && factor * *known < kYear2100S) {
      column.unit = unit;
      column.factor = factor;
      return;
    }
  }
  const double step = medianStep(column.values);
  if (step <= 0.5) {
    column.unit = "s";
    return;
  }
  column.unit = step < 1000.0 ? "ms" : (step < 1e5 ? "us" : "ns");
  column.factor = unitFactor(column.unit, SignalRole::Time).value_or(1.0);
  remarks.push_back({RemarkCode::TimeUnitAssumed, {column.name, column.unit}});
}

bool isTimeRow(const Hdf5Row& row) {
  const bool isCalled = guessRole(splitUnit(row.name).name) == SignalRole::Time;
  return (isCalled || unitFactor(row.unit, SignalRole::Time)) && isAscending(row.values);
}

/// The row of time that a row belongs to: of the same length, in the same folder, or in the nearest
/// one around it, or anywhere.
const Hdf5Row* timeOf(const Hdf5Row& row, const std::vector<const Hdf5Row*>& times) {
  const auto inFolder = [&](std::string_view folder) -> const Hdf5Row* {
    const auto found = std::find_if(times.begin(), times.end(), [&](const Hdf5Row* time) {
      return time->count == row.count && time->folder == folder;
    });
    return found == times.end() ? nullptr : *found;
  };
  std::string_view folder = row.folder;
  while (true) {
    if (const Hdf5Row* time = inFolder(folder)) {
      return time;
    }
    if (folder.empty()) {
      break;
    }
    const std::size_t slash = folder.rfind('/');
    folder = folder.substr(0, slash == std::string_view::npos ? 0 : slash);
  }
  const auto anywhere = std::find_if(times.begin(), times.end(),
                                     [&](const Hdf5Row* time) { return time->count == row.count; });
  return anywhere == times.end() ? nullptr : *anywhere;
}

/// Each row of time, followed by the rows that belong to it. Names are short where they are unique.
/// @return error BudgetError::Exceeded: rows of other lengths would have to be filled up
base::Result<std::vector<Column>> datasetColumns(Hdf5Content& content, const base::Budget& budget) {
  std::map<std::string, int> count;
  std::vector<const Hdf5Row*> times;
  for (const Hdf5Row& row : content.rows) {
    ++count[row.name];
    // Of one folder and length, the first one named so is the time: others are signals.
    if (isTimeRow(row) && std::none_of(times.begin(), times.end(), [&row](const Hdf5Row* time) {
          return time->folder == row.folder && time->count == row.count;
        })) {
      times.push_back(&row);
    }
  }
  std::vector<Column> columns;
  const auto add = [&](Hdf5Row& row, std::size_t length) {
    Column column;
    column.name = count[row.name] > 1 ? row.path() : row.name;
    column.unit = row.unit.empty() ? splitUnit(row.name).unit : row.unit;
    column.values = std::move(row.values);
    while (column.values.size() < length) {
      column.values.push_back(kNoValue);
    }
    columns.push_back(std::move(column));
  };
  std::vector<const Hdf5Row*> owners;
  for (const Hdf5Row& row : content.rows) {
    owners.push_back(timeOf(row, times));
  }
  std::size_t without = 0;
  std::string first;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < content.rows.size(); ++i) {
    longest = std::max(longest, content.rows[i].values.size());
    if (owners[i] == nullptr && !times.empty()) {
      ++without;
      first = without == 1 ? content.rows[i].path() : first;
    }
  }
  if (times.empty()) {
    const double values = static_cast<double>(content.rows.size()) * static_cast<double>(longest);
    if (auto fits = budget.require(2 * sizeof(double) * values, "A table of all datasets"); !fits) {
      return base::fail(fits.error());
    }
    for (Hdf5Row& row : content.rows) {
      add(row, longest);
    }
    return columns;
  }
  for (const Hdf5Row* time : times) {
    const std::size_t length = time->values.size();
    for (const bool isTime : {true, false}) {
      for (std::size_t i = 0; i < content.rows.size(); ++i) {
        Hdf5Row& row = content.rows[i];
        if (owners[i] == time && (&row == time) == isTime) {
          add(row, length);
          if (isTime) {
            columns.back().role = SignalRole::Time;
            columns.back().factor = unitFactor(columns.back().unit, SignalRole::Time).value_or(1.0);
          }
        }
      }
    }
  }
  if (without > 0) {
    content.remarks.push_back({RemarkCode::DatasetsWithoutTime, {std::to_string(without), first}});
  }
  return columns;
}

base::Result<void> applyChoice(std::vector<Column>& columns, const ColumnRole& choice) {
  auto found = std::find_if(columns.begin(), columns.end(), [&choice](const Column& column) {
    return column.name == choice.column;
  });
  if (found == columns.end() && choice.column.substr(0, 1) == "#") {
    const auto number = base::parseInteger(std::string_view(choice.column).substr(1));
    if (number && *number >= 1 && static_cast<std::size_t>(*number) <= columns.size()) {
      found = columns.begin() + *number - 1;
    }
  }
  if (found == columns.end()) {
    std::vector<std::string> names;
    for (const Column& column : columns) {
      names.push_back(column.name);
    }
    return base::fail(ImportError::BadMapping,
                      fmt::format("The trace has no column \"{}\". Its columns are {}.",
                                  choice.column, fmt::join(names, ", ")));
  }
  found->role = choice.role;
  found->isChosen = true;
  found->unit = choice.unit.empty() ? found->unit : choice.unit;
  found->factor = unitFactor(found->unit, choice.role).value_or(1.0);
  return {};
}

/// Whether a column of this unit can have the role: a position in mm/s is none.
bool isOfRole(std::string_view unit, SignalRole role) {
  const bool isMeasured = role >= SignalRole::XSet && role <= SignalRole::ProgrammedFeed;
  const bool isOther = isUnit(unit) && unit != "1" && unit != "-";
  return !isMeasured || !isOther || unitFactor(unit, role);
}

/// Roles by name for what the user left open; of each role but Time the first column, but before
/// all others that which is called as the role: beside "line", "program_line" is another signal.
void guessRoles(std::vector<Column>& columns, bool isComplete, std::vector<Remark>& remarks) {
  std::set<SignalRole> taken;
  bool hasTime = false;
  for (const Column& column : columns) {
    if (column.role) {
      taken.insert(*column.role);
      hasTime = hasTime || *column.role == SignalRole::Time;
    }
  }
  const bool timeIsChosen = hasTime;
  for (const bool isNamed : {true, false}) {
    for (Column& column : columns) {
      if (column.role || isComplete) {
        continue;
      }
      const std::string name = column.unit.empty() ? column.name : splitUnit(column.name).name;
      const auto role = column.isClock ? SignalRole::Time : guessRole(name);
      if (!role || (isNamed && name != signalRoleName(*role)) ||
          (*role == SignalRole::Time ? timeIsChosen : taken.contains(*role)) ||
          !isOfRole(column.unit, *role)) {
        continue;
      }
      if (*role == SignalRole::Time && !isAscending(column.values)) {
        continue;
      }
      column.role = role;
      column.factor = unitFactor(column.unit, *role).value_or(1.0);
      taken.insert(*role);
      hasTime = hasTime || *role == SignalRole::Time;
    }
  }
  // A first column that ascends is the time, unless it counts the samples.
  if (!isComplete && !hasTime && !columns.empty() && !columns[0].role &&
      isAscending(columns[0].values) && !isCounter(columns[0].values)) {
    columns[0].role = SignalRole::Time;
  }
  for (Column& column : columns) {
    if (column.role == SignalRole::Time && !unitFactor(column.unit, SignalRole::Time)) {
      guessTimeUnit(column, remarks);
    }
  }
}

/// The rows of a time base, in the order of their time.
struct RowsInTime {
  std::vector<std::size_t> rows;
  std::vector<double> seconds;      ///< one per row, ascending
  std::vector<std::size_t> begins;  ///< of the sections but the first: indices of `rows`
};

/// Those whose time is not that of the row before, as far as it is a time. @return with the
/// sections that begin where it runs backwards, `seconds` as they are
RowsInTime rowsOf(const Column& time, std::vector<Remark>& remarks) {
  RowsInTime found;
  std::size_t same = 0;
  PackedReader<PackedValues> reader(time.values);
  for (std::size_t row = 0; row < reader.size(); ++row) {
    const double seconds = time.factor * reader[row];
    if (!std::isfinite(seconds) || std::abs(seconds) > kSecondsMax) {
      continue;
    }
    if (!found.rows.empty() && seconds == found.seconds.back()) {
      ++same;
      continue;
    }
    if (!found.rows.empty() && seconds < found.seconds.back()) {
      found.begins.push_back(found.rows.size());
    }
    found.rows.push_back(row);
    found.seconds.push_back(seconds);
  }
  if (same > 0) {
    remarks.push_back({RemarkCode::TimeRepeated, {std::to_string(same)}});
  }
  return found;
}

/// Rows that are in disorder: sorted, none of them comes too soon after another one. Rows of a
/// clock that has started again would fall among the others.
bool sortRows(const Column& time, RowsInTime& found, std::vector<Remark>& remarks) {
  std::vector<std::size_t> order(found.rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&found](std::size_t a, std::size_t b) { return found.seconds[a] < found.seconds[b]; });
  const double leastStep = 0.75 * medianStep(found.seconds);
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (found.seconds[order[i]] - found.seconds[order[i - 1]] < leastStep) {
      return false;
    }
  }
  remarks.push_back(
      {RemarkCode::RowsSorted, {time.name, std::to_string(found.rows[found.begins[0]] + 1)}});
  RowsInTime sorted;
  for (const std::size_t i : order) {
    sorted.rows.push_back(found.rows[i]);
    sorted.seconds.push_back(found.seconds[i]);
  }
  found = std::move(sorted);
  return true;
}

/// Leaves out runs of at most `rowsMax` rows that are not after all rows before; at longer ones
/// sections begin.
void dropBackwards(const Column& time, std::size_t rowsMax, RowsInTime& found,
                   std::vector<Remark>& remarks) {
  RowsInTime kept;
  std::size_t dropped = 0;
  std::size_t first = 0;
  const std::size_t count = found.rows.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!kept.rows.empty() && found.seconds[i] <= kept.seconds.back()) {
      std::size_t next = i + 1;
      while (next < count && found.seconds[next] <= kept.seconds.back()) {
        ++next;
      }
      if (next - i <= rowsMax) {
        first = dropped == 0 ? found.rows[i] : first;
        dropped += next - i;
        i = next - 1;
        continue;
      }
      kept.begins.push_back(kept.rows.size());
    }
    kept.rows.push_back(found.rows[i]);
    kept.seconds.push_back(found.seconds[i]);
  }
  if (dropped > 0) {
    remarks.push_back({RemarkCode::TimeBackwards,
                       {time.name, std::to_string(first + 1), std::to_string(dropped)}});
  }
  found = std::move(kept);
}

/// Puts the sections one after another.
void placeSections(const Column& time, RowsInTime& found, std::vector<Remark>& remarks) {
  std::vector<std::size_t> ends = found.begins;
  ends.push_back(found.rows.size());
  double shift = 0.0;
  for (std::size_t section = 1; section < ends.size(); ++section) {
    const std::size_t begin = ends[section - 1];
    shift = found.seconds[begin - 1] + kSectionGapS - found.seconds[begin];
    for (std::size_t i = begin; i < ends[section]; ++i) {
      found.seconds[i] += shift;
    }
  }
  remarks.push_back({RemarkCode::Sections,
                     {time.name, std::to_string(found.rows[found.begins[0]] + 1),
                      std::to_string(ends.size()), fmt::format("{:g}", kSectionGapS)}});
}

/// @param isAlone  no other column of time: a jump back starts a new section
RowsInTime rowsInTime(const Column& time, bool isAlone, std::vector<Remark>& remarks) {
  RowsInTime found = rowsOf(time, remarks);
  if (found.begins.empty() || sortRows(time, found, remarks)) {
    return found;
  }
  if (isAlone) {
    dropBackwards(time, kGlitchRows, found, remarks);
  }
  if (isAlone && found.begins.size() < kSectionsMax) {
    if (!found.begins.empty()) {
      placeSections(time, found, remarks);
    }
  } else {
    dropBackwards(time, found.rows.size(), found, remarks);
  }
  return found;
}

/// Which rows of the columns a time base has; nothing: all of them.
using ChosenRows = std::optional<std::vector<std::size_t>>;

/// A time base and its rows.
struct TimesOfRows {
  PackedTimes at;
  ChosenRows rows;
};

/// A column that counts the samples shows gaps: its values are the time, at the rate. Where it
/// jumps back, it is no time.
TimesOfRows countedTime(const std::vector<Column>& columns, double rateHz) {
  TimesOfRows times;
  const std::size_t count = columns.empty() ? 0 : columns[0].values.size();
  const bool isTagged = !columns.empty() && !columns[0].role && isCounter(columns[0].values);
  const PackedValues none;
  PackedReader<PackedValues> counter(isTagged ? columns[0].values : none);
  base::Instant before = base::Instant::min();
  for (std::size_t row = 0; row < count; ++row) {
    const double sample = isTagged ? counter[row] : static_cast<double>(row);
    const base::Instant at{base::fromSeconds(sample / rateHz)};
    const bool isLater = row == 0 || at > before;
    if (!isLater && !times.rows) {
      times.rows.emplace(row);
      std::iota(times.rows->begin(), times.rows->end(), std::size_t{0});
    } else if (isLater && times.rows) {
      times.rows->push_back(row);
    }
    if (isLater) {
      times.at.push_back(at);
      before = at;
    }
  }
  return times;
}

/// Of a column of time that ascends in every row, as nearly all do; nothing: it does not.
std::optional<PackedTimes> ascendingTimes(const Column& time) {
  PackedTimes at;
  PackedReader<PackedValues> reader(time.values);
  double before = -std::numeric_limits<double>::infinity();
  for (std::size_t row = 0; row < reader.size(); ++row) {
    const double seconds = time.factor * reader[row];
    // Negated, so that what is no number fails.
    if (!(seconds > before && std::abs(seconds) <= kSecondsMax)) {
      return std::nullopt;
    }
    at.push_back(base::Instant{base::fromSeconds(seconds)});
    before = seconds;
  }
  return at;
}

/// @param isAlone  no other column of time  @param sections  those that begin are added
TimesOfRows timesOf(const Column& time, bool isAlone, std::vector<base::Instant>& sections,
                    std::vector<Remark>& remarks) {
  if (auto at = ascendingTimes(time)) {
    return {std::move(*at), std::nullopt};
  }
  RowsInTime found = rowsInTime(time, isAlone, remarks);
  TimesOfRows times;
  for (const double seconds : found.seconds) {
    times.at.push_back(base::Instant{base::fromSeconds(seconds)});
  }
  for (const std::size_t begin : found.begins) {
    sections.push_back(times.at[begin]);
  }
  times.rows = std::move(found.rows);
  return times;
}

PackedValues valuesIn(const ChosenRows& rows, const PackedValues& all) {
  if (!rows) {
    return all;
  }
  PackedValues values;
  PackedReader<PackedValues> reader(all);
  for (const std::size_t row : *rows) {
    values.push_back(reader[row]);
  }
  return values;
}

/// The columns as signals, each with the column of time before it.
SignalTrace signalsOf(std::vector<Column>& columns, const TableMapping& mapping,
                      std::vector<Remark> remarks) {
  SignalTrace trace;
  const auto isTime = [](const Column& column) { return column.role == SignalRole::Time; };
  const auto firstTime = std::find_if(columns.begin(), columns.end(), isTime);
  ChosenRows rows;
  if (firstTime == columns.end()) {
    const double rateHz = mapping.rateHz.value_or(kRateHzAssumed);
    if (!mapping.rateHz) {
      remarks.push_back({RemarkCode::RateAssumed, {fmt::format("{}", rateHz)}});
    }
    TimesOfRows times = countedTime(columns, rateHz);
    rows = std::move(times.rows);
    trace.timeBases.push_back({{}, std::move(times.at)});
  }
  const bool isAlone = std::count_if(columns.begin(), columns.end(), isTime) == 1;
  const auto addBase = [&](const Column& time) {
    TimesOfRows times = timesOf(time, isAlone, trace.sections, remarks);
    rows = std::move(times.rows);
    trace.timeBases.push_back({time.name, std::move(times.at)});
  };
  if (firstTime != columns.end()) {
    addBase(*firstTime);
  }
  for (auto column = columns.begin(); column != columns.end(); ++column) {
    if (isTime(*column)) {
      if (column != firstTime) {
        addBase(*column);
      }
      column->values.clear();
      continue;
    }
    trace.signalList.push_back({column->name, column->unit, trace.timeBases.size() - 1,
                                valuesIn(rows, std::exchange(column->values, {}))});
  }
  if (trace.timeBases.size() > 1) {
    trace.remarks.push_back({RemarkCode::SeveralTimes, {std::to_string(trace.timeBases.size())}});
  }
  trace.remarks.insert(trace.remarks.begin(), remarks.begin(), remarks.end());
  return trace;
}

/// Whether the positions stand in rows of their own: hardly a row has all of them.
bool isSparse(const SignalTrace& trace, const std::vector<ColumnRole>& roles) {
  std::vector<const Signal*> positions;
  for (const Signal& signal : trace.signalList) {
    const bool is = std::any_of(roles.begin(), roles.end(), [&signal](const ColumnRole& column) {
      return isPosition(column.role) && column.column == signal.name;
    });
    if (is && signal.timeBase == 0) {
      positions.push_back(&signal);
    }
  }
  std::size_t all = 0;
  std::vector<std::size_t> counts(positions.size());
  std::vector<PackedReader<PackedValues>> values;
  for (const Signal* position : positions) {
    values.emplace_back(position->values);
  }
  for (std::size_t row = 0; row < trace.timeBases[0].at.size(); ++row) {
    std::size_t here = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const bool is = std::isfinite(values[i][row]);
      counts[i] += static_cast<std::size_t>(is);
      here += static_cast<std::size_t>(is);
    }
    all += static_cast<std::size_t>(here == positions.size());
  }
  return positions.size() > 1 && *std::min_element(counts.begin(), counts.end()) > 0 &&
         2 * all < *std::max_element(counts.begin(), counts.end());
}

/// Where the signal has values.
std::vector<std::size_t> rowsWith(const Signal& signal) {
  std::vector<std::size_t> rows;
  PackedReader<PackedValues> values(signal.values);
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (std::isfinite(values[row])) {
      rows.push_back(row);
    }
  }
  return rows;
}

/// The rows of the position on whose times the others are read: the first that has not much fewer
/// values than another one.
std::vector<std::size_t> leadingRows(const SignalTrace& trace,
                                     const std::vector<ColumnRole>& roles) {
  std::vector<std::vector<std::size_t>> all;
  std::size_t most = 0;
  for (const ColumnRole& column : roles) {
    for (const Signal& signal : trace.signalList) {
      if (isPosition(column.role) && column.column == signal.name) {
        all.push_back(rowsWith(signal));
        most = std::max(most, all.back().size());
      }
    }
  }
  return *std::find_if(all.begin(), all.end(),
                       [most](const auto& rows) { return 2 * rows.size() >= most; });
}

/// Each signal that is not in all rows gets a time base of its own rows. At the ends of the trace
/// it has its first and its last value, unless the others are read at its times.
void separateSparse(SignalTrace& trace, const std::vector<ColumnRole>& roles) {
  if (trace.timeBases.size() != 1 || !isSparse(trace, roles)) {
    return;
  }
  const PackedTimes all = trace.timeBases[0].at;
  const std::vector<std::size_t> leading = leadingRows(trace, roles);
  std::map<std::vector<std::size_t>, std::size_t> bases;  // of the same rows
  for (Signal& signal : trace.signalList) {
    std::vector<std::size_t> rows = rowsWith(signal);
    if (rows.empty() || rows.size() == all.size()) {
      continue;
    }
    const bool isLeading = rows == leading;
    std::vector<std::pair<std::size_t, std::size_t>> kept;  // row of the time, row of the value
    if (!isLeading && rows.front() > 0) {
      kept.emplace_back(0, rows.front());
    }
    for (const std::size_t row : rows) {
      kept.emplace_back(row, row);
    }
    if (!isLeading && rows.back() + 1 < all.size()) {
      kept.emplace_back(all.size() - 1, rows.back());
    }
    const auto [found, isNew] = bases.try_emplace(std::move(rows), trace.timeBases.size());
    if (isNew) {
      trace.timeBases.push_back({trace.timeBases[0].name, {}});
    }
    PackedValues values;
    PackedReader<PackedTimes> allAt(all);
    PackedReader<PackedValues> allValues(signal.values);
    for (const auto& [at, from] : kept) {
      if (isNew) {
        trace.timeBases.back().at.push_back(allAt[at]);
      }
      values.push_back(allValues[from]);
    }
    signal.timeBase = found->second;
    signal.values = std::move(values);
  }
  trace.remarks.push_back({RemarkCode::SparseRows});
}

std::vector<ColumnRole> rolesOf(const std::vector<Column>& columns) {
  std::vector<ColumnRole> roles;
  for (const Column& column : columns) {
    if (column.role) {
      roles.push_back({*column.role, column.name, column.unit});
    }
  }
  std::stable_sort(roles.begin(), roles.end(),
                   [](const ColumnRole& a, const ColumnRole& b) { return a.role < b.role; });
  return roles;
}

TablePreview previewOf(const std::vector<Column>& columns, const TableMapping& mapping,
                       const std::vector<Remark>& remarks) {
  TablePreview preview;
  preview.mapping = mapping;
  bool hasPosition = false;
  bool hasTime = mapping.rateHz.has_value();
  for (const Column& column : columns) {
    const auto count = static_cast<std::ptrdiff_t>(std::min(kValuesShown, column.values.size()));
    preview.columns.push_back({column.name,
                               column.unit,
                               column.role,
                               {column.values.begin(), column.values.begin() + count}});
    hasPosition = hasPosition || (column.role && isPosition(*column.role));
    hasTime = hasTime || column.role == SignalRole::Time;
  }
  const bool isAssumed = std::any_of(remarks.begin(), remarks.end(), [](const Remark& remark) {
    return remark.code == RemarkCode::TimeUnitAssumed;
  });
  preview.isCertain = hasPosition && hasTime && !isAssumed;
  return preview;
}

/// The signals of a format that has its own time bases, as columns without their values.
std::vector<Column> columnsOf(const SignalTrace& trace) {
  std::vector<Column> columns;
  for (const Signal& signal : trace.signalList) {
    columns.push_back({signal.name, signal.unit, {}});
  }
  return columns;
}

/// @param columns  one per signal, with their roles
ImportedTrace importedOf(SignalTrace trace, std::vector<Column>& columns,
                         const TableMapping& mapping) {
  ImportedTrace imported;
  for (const Signal& signal : trace.signalList) {
    imported.layout += (imported.layout.empty() ? "" : "|") + signal.name;
  }
  makeUnique(columns, trace.remarks);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    trace.signalList[i].name = columns[i].name;
  }
  imported.columns = rolesOf(columns);
  imported.table.mapping = mapping;
  imported.trace = std::move(trace);
  return imported;
}

base::Result<ImportedTrace> importSinumerik(std::string_view text, const TableMapping& mapping,
                                            const base::Budget& budget) {
  auto trace = readSinumerikTrace(text, budget);
  if (!trace) {
    return base::fail(trace.error());
  }
  return importSignals(std::move(*trace), mapping);
}

/// When the last of the positions has its first value, if that is later than the first.
void addKnownFrom(SignalTrace& trace, const std::vector<Column>& columns) {
  base::Instant first = base::Instant::max();
  base::Instant known = base::Instant::min();
  base::Instant origin = base::Instant::max();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const base::Instant begin = trace.timeBases[trace.signalList[i].timeBase].at.front();
    origin = std::min(origin, begin);
    if (columns[i].role && isPosition(*columns[i].role)) {
      first = std::min(first, begin);
      known = std::max(known, begin);
    }
  }
  if (first < known) {
    trace.remarks.push_back(
        {RemarkCode::KnownFrom, {fmt::format("{:.3f}", base::toSeconds(known - origin))}});
  }
}

/// What items mean is not guessed from their names: the standard says it.
base::Result<ImportedTrace> importMtconnect(std::string_view text, const TableMapping& mapping,
                                            const base::Budget& budget) {
  auto read = readMtconnect(text, budget);
  if (!read) {
    return base::fail(read.error());
  }
  std::vector<Column> columns = columnsOf(read->trace);
  for (const ColumnRole& choice : mapping.columns) {
    if (auto done = applyChoice(columns, choice); !done) {
      return base::fail(done.error());
    }
  }
  std::vector<bool> isPositionOf;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto& role = read->kinds[i].role;
    const bool isTaken = std::any_of(columns.begin(), columns.end(), [&role](const Column& one) {
      return one.isChosen && one.role == role;
    });
    if (!columns[i].isChosen && !mapping.isComplete && !isTaken) {
      columns[i].role = role;
    }
    isPositionOf.push_back(columns[i].role && isPosition(*columns[i].role));
  }
  if (auto done = addHeldValues(*read, isPositionOf, budget); !done) {
    return base::fail(done.error());
  }
  addKnownFrom(read->trace, columns);
  return importedOf(std::move(read->trace), columns, mapping);
}

/// @param columns  with the roles that the format itself tells
base::Result<ImportedTrace> importColumns(std::vector<Column> columns, std::vector<Remark> remarks,
                                          const TableMapping& mapping) {
  ImportedTrace imported;
  makeUnique(columns, remarks);
  Row names;
  for (const Column& column : columns) {
    names.push_back(column.name);
  }
  imported.layout = joined(names);
  for (const ColumnRole& choice : mapping.columns) {
    if (auto done = applyChoice(columns, choice); !done) {
      return base::fail(done.error());
    }
  }
  guessRoles(columns, mapping.isComplete, remarks);
  imported.columns = rolesOf(columns);
  imported.table = previewOf(columns, mapping, remarks);
  imported.trace = signalsOf(columns, mapping, std::move(remarks));
  separateSparse(imported.trace, imported.columns);
  return imported;
}

/// @param facts  of the text
base::Result<ImportedTrace> importTable(TextBlocks& blocks, const TextFacts& facts,
                                        const TableMapping& mapping, const base::Budget& budget,
                                        base::Executor& executor) {
  auto table = readTable(blocks, facts, budget, executor);
  if (!table) {
    return base::fail(table.error());
  }
  const bool isScope = isTwinCat(*table);
  std::vector<Column> columns = isScope ? scopeColumns(*table) : headedColumns(*table);
  auto imported = importColumns(std::move(columns), std::move(table->remarks), mapping);
  if (imported) {
    imported->trace.format =
        isScope ? "TwinCAT Scope" : (table->head.empty() ? "halsampler" : "CSV");
  }
  return imported;
}

base::Result<ImportedTrace> importTable(std::string_view text, const TableMapping& mapping,
                                        const base::Budget& budget, base::Executor& executor) {
  BlocksInMemory blocks(text);
  const auto facts = factsOf(blocks, executor);
  return facts ? importTable(blocks, *facts, mapping, budget, executor) : base::fail(facts.error());
}

base::Result<ImportedTrace> importDatasets(std::string_view bytes, const TableMapping& mapping,
                                           const base::Budget& budget) {
  auto content = readHdf5(bytes, budget);
  if (!content) {
    return base::fail(content.error());
  }
  auto columns = datasetColumns(*content, budget);
  if (!columns) {
    return base::fail(columns.error());
  }
  auto imported = importColumns(std::move(*columns), std::move(content->remarks), mapping);
  if (imported) {
    imported->trace.format = "HDF5";
    imported->trace.events = std::move(content->events);
  }
  return imported;
}

}  // namespace

std::error_code make_error_code(ImportError code) {
  static const base::NamedCategory category("trace import");
  return {static_cast<int>(code), category};
}

base::Result<ImportedTrace> importSignals(SignalTrace trace, const TableMapping& mapping) {
  std::vector<Column> columns = columnsOf(trace);
  for (const ColumnRole& choice : mapping.columns) {
    if (auto done = applyChoice(columns, choice); !done) {
      return base::fail(done.error());
    }
  }
  guessRoles(columns, mapping.isComplete, trace.remarks);
  return importedOf(std::move(trace), columns, mapping);
}

base::Result<ImportedTrace> importTrace(std::string_view bytes, const TableMapping& mapping,
                                        const base::Budget& budget, base::Executor* executor) {
  base::SerialExecutor serial;
  Unpacked unpacked;
  if (isCompressed(bytes)) {
    auto done = unpack(bytes, budget);
    if (!done) {
      return base::fail(done.error());
    }
    unpacked = std::move(*done);
    bytes = unpacked.text;
  }
  base::Budget rest = budget.without(unpacked.text.capacity());
  if (isHdf5(bytes)) {
    return importDatasets(bytes, mapping, rest);
  }
  std::string converted;
  const auto text = utf8Of(bytes, converted, rest);
  if (!text) {
    return base::fail(text.error());
  }
  rest = rest.without(converted.capacity());
  auto imported = isMtconnect(*text) ? importMtconnect(*text, mapping, rest)
                  : isSinumerikTrace(*text)
                      ? importSinumerik(*text, mapping, rest)
                      : importTable(*text, mapping, rest, executor != nullptr ? *executor : serial);
  if (imported && !unpacked.whole) {
    imported->trace.remarks.insert(imported->trace.remarks.begin(), {RemarkCode::CutCompressed});
  }
  return imported;
}

base::Result<std::optional<ImportedTrace>> importLargeTable(base::ByteSource& bytes,
                                                            const TableMapping& mapping,
                                                            const base::Budget& budget,
                                                            base::Executor* executor) {
  constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
  constexpr std::uint64_t kLargeBytes = 2 * TextBlocks::kBlockBytes;
  base::SerialExecutor serial;
  base::Executor& jobs = executor != nullptr ? *executor : serial;
  if (bytes.size() < kLargeBytes) {
    return std::nullopt;
  }
  const auto head = bytes.read(0, kUtf8Mark.size());
  if (!head) {
    return base::fail(head.error());
  }
  auto blocks = BlocksInFile::open(bytes, *head == kUtf8Mark ? kUtf8Mark.size() : 0, budget);
  if (!blocks) {
    return base::fail(blocks.error());
  }
  const std::string_view text = blocks->beginning();
  // Lines as long as these are those of a format that is known as a whole only.
  constexpr std::ptrdiff_t kLinesMin = 1000;
  if (isCompressed(text) || isHdf5(text) || isMtconnect(text) || isSinumerikTrace(text) ||
      std::count(text.begin(), text.end(), '\n') < kLinesMin) {
    return std::nullopt;
  }
  const auto facts = factsOf(*blocks, jobs);
  if (!facts) {
    return base::fail(facts.error());
  }
  if (!facts->isUtf8) {
    return std::nullopt;
  }
  auto imported = importTable(*blocks, *facts, mapping, budget, jobs);
  return imported ? base::Result<std::optional<ImportedTrace>>(std::move(*imported))
                  : base::fail(imported.error());
}

}  // namespace rivulet::trace
