// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/import/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/median.h"
#include "base/text.h"
#include "trace/hdf5.h"
#include "trace/import/compression.h"
#include "trace/import/import_error.h"
#include "trace/import/sinumerik_xml.h"
#include "trace/import/text_table.h"

namespace rivulet::trace {

namespace {

/// Assumed for a table that has neither a column of time nor a rate.
constexpr double kRateHzAssumed = 1000.0;
/// Beyond that many seconds an `Instant` overflows: clocks count from 1970 or 1601 at most.
constexpr double kSecondsMax = 9e9;

/// A column of a table with what is known of it.
struct Column {
  std::string name;
  std::string unit;
  std::vector<double> values;
  std::optional<SignalRole> role{};
  double factor = 1.0;  ///< to s, mm, mm/s
  bool isChosen = false;
};

using Row = std::vector<std::string>;

std::string joined(const Row& row) {
  return fmt::format("{}", fmt::join(row, "|"));
}

/// TwinCAT Scope writes pairs of columns, and in its head pairs of a key and a value.
bool isTwinCat(const TextTable& table) {
  return std::any_of(table.head.begin(), table.head.end(),
                     [](const Row& row) { return !row.empty() && row[0] == "SampleTime[ms]"; });
}

/// The value of a key for each channel.
std::vector<std::string> scopeValues(const TextTable& table, std::string_view key) {
  std::vector<std::string> values;
  // The key "Name" also stands in the first line, for the project: the last row counts.
  for (const Row& row : table.head) {
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

/// The columns with their headings: the last row before the numbers, or the last but one if the
/// last holds units.
std::vector<Column> headedColumns(TextTable& table) {
  const std::size_t width = table.columns.size();
  Row names;
  Row units;
  for (std::size_t i = table.head.size(); i-- > 0 && names.empty();) {
    Row& row = table.head[i];
    if (row.size() < width) {
      continue;
    }
    row.resize(width);
    if (units.empty() && holdsUnits(row)) {
      units = row;
    } else {
      names = row;
    }
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

bool isAscending(const std::vector<double>& values) {
  std::size_t steps = 0;
  std::size_t ascending = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    // Of several columns of time, the shorter ones end with empty cells.
    const bool isStep = std::isfinite(values[i]) && std::isfinite(values[i - 1]);
    steps += static_cast<std::size_t>(isStep);
    ascending += static_cast<std::size_t>(isStep && values[i] > values[i - 1]);
  }
  return steps > 1 && 20 * ascending >= 19 * steps;
}

/// Every row one more than the row before: the number of the sample, not a time.
bool isCounter(const std::vector<double>& values) {
  return values.size() > 2 && values[0] == std::floor(values[0]) && values[1] - values[0] == 1.0 &&
         values[2] - values[1] == 1.0;
}

double medianStep(const std::vector<double>& values) {
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
    column.values.resize(length, kNoValue);
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
      const auto role = guessRole(name);
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

/// Rows that a column of time allows: those whose time is after that of all rows before.
std::vector<std::size_t> rowsInTime(const Column& time, std::vector<Remark>& remarks) {
  std::vector<std::size_t> rows;
  std::size_t backwards = 0;
  std::size_t first = 0;
  std::size_t same = 0;
  double latest = -std::numeric_limits<double>::infinity();
  for (std::size_t row = 0; row < time.values.size(); ++row) {
    const double seconds = time.factor * time.values[row];
    if (!std::isfinite(seconds) || std::abs(seconds) > kSecondsMax) {
      continue;
    }
    if (seconds <= latest) {
      first = backwards == 0 ? row : first;
      ++(seconds == latest ? same : backwards);
      continue;
    }
    latest = seconds;
    rows.push_back(row);
  }
  if (backwards > 0) {
    remarks.push_back({RemarkCode::TimeBackwards,
                       {time.name, std::to_string(first + 1), std::to_string(backwards)}});
  }
  if (same > 0) {
    remarks.push_back({RemarkCode::TimeRepeated, {std::to_string(same)}});
  }
  return rows;
}

/// A column that counts the samples shows gaps: its values are the time, at the rate.
TimeBase countedTime(std::vector<Column>& columns, double rateHz) {
  TimeBase base;
  const std::size_t rows = columns.empty() ? 0 : columns[0].values.size();
  const bool isTagged = !columns.empty() && !columns[0].role && isCounter(columns[0].values);
  for (std::size_t row = 0; row < rows; ++row) {
    const double sample = isTagged ? columns[0].values[row] : static_cast<double>(row);
    base.at.push_back(base::Instant{base::fromSeconds(sample / rateHz)});
  }
  return base;
}

/// The columns as signals, each with the column of time before it.
SignalTrace signalsOf(std::vector<Column>& columns, const TableMapping& mapping,
                      std::vector<Remark> remarks) {
  SignalTrace trace;
  const auto isTime = [](const Column& column) { return column.role == SignalRole::Time; };
  const auto firstTime = std::find_if(columns.begin(), columns.end(), isTime);
  std::vector<std::size_t> rows;
  if (firstTime == columns.end()) {
    const double rateHz = mapping.rateHz.value_or(kRateHzAssumed);
    if (!mapping.rateHz) {
      remarks.push_back({RemarkCode::RateAssumed, {fmt::format("{}", rateHz)}});
    }
    trace.timeBases.push_back(countedTime(columns, rateHz));
    // A counter that jumps back is no time.
    std::vector<base::Instant>& at = trace.timeBases[0].at;
    for (std::size_t row = 0; row < at.size(); ++row) {
      if (rows.empty() || at[row] > at[rows.back()]) {
        rows.push_back(row);
      }
    }
    std::vector<base::Instant> kept;
    for (const std::size_t row : rows) {
      kept.push_back(at[row]);
    }
    at = std::move(kept);
  }
  const auto addBase = [&](const Column& time) {
    rows = rowsInTime(time, remarks);
    TimeBase base{time.name, {}};
    base.at.reserve(rows.size());
    for (const std::size_t row : rows) {
      base.at.push_back(base::Instant{base::fromSeconds(time.factor * time.values[row])});
    }
    trace.timeBases.push_back(std::move(base));
  };
  if (firstTime != columns.end()) {
    addBase(*firstTime);
  }
  for (auto column = columns.begin(); column != columns.end(); ++column) {
    if (isTime(*column)) {
      if (column != firstTime) {
        addBase(*column);
      }
      continue;
    }
    Signal signal{column->name, column->unit, trace.timeBases.size() - 1, {}};
    signal.values.reserve(rows.size());
    for (const std::size_t row : rows) {
      signal.values.push_back(column->values[row]);
    }
    column->values = {};
    trace.signalList.push_back(std::move(signal));
  }
  if (trace.timeBases.size() > 1) {
    trace.remarks.push_back({RemarkCode::SeveralTimes, {std::to_string(trace.timeBases.size())}});
  }
  trace.remarks.insert(trace.remarks.begin(), remarks.begin(), remarks.end());
  return trace;
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
    hasPosition = hasPosition || (column.role && *column.role >= SignalRole::XSet &&
                                  *column.role <= SignalRole::ZActual);
    hasTime = hasTime || column.role == SignalRole::Time;
  }
  const bool isAssumed = std::any_of(remarks.begin(), remarks.end(), [](const Remark& remark) {
    return remark.code == RemarkCode::TimeUnitAssumed;
  });
  preview.isCertain = hasPosition && hasTime && !isAssumed;
  return preview;
}

base::Result<ImportedTrace> importXml(std::string_view text, const TableMapping& mapping,
                                      const base::Budget& budget) {
  auto trace = readSinumerikTrace(text, budget);
  if (!trace) {
    return base::fail(trace.error());
  }
  std::vector<Column> columns;
  ImportedTrace imported;
  for (const Signal& signal : trace->signalList) {
    columns.push_back({signal.name, signal.unit, {}});
    imported.layout += (imported.layout.empty() ? "" : "|") + signal.name;
  }
  for (const ColumnRole& choice : mapping.columns) {
    if (auto done = applyChoice(columns, choice); !done) {
      return base::fail(done.error());
    }
  }
  guessRoles(columns, mapping.isComplete, trace->remarks);
  makeUnique(columns, trace->remarks);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    trace->signalList[i].name = columns[i].name;
  }
  imported.columns = rolesOf(columns);
  imported.table.mapping = mapping;
  imported.trace = std::move(*trace);
  return imported;
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
  return imported;
}

base::Result<ImportedTrace> importTable(std::string_view text, const TableMapping& mapping,
                                        const base::Budget& budget) {
  auto table = readTable(text, budget);
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

base::Result<ImportedTrace> importTrace(std::string_view bytes, const TableMapping& mapping,
                                        const base::Budget& budget) {
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
  auto imported =
      isSinumerikTrace(*text) ? importXml(*text, mapping, rest) : importTable(*text, mapping, rest);
  if (imported && !unpacked.whole) {
    imported->trace.remarks.insert(imported->trace.remarks.begin(), {RemarkCode::CutCompressed});
  }
  return imported;
}

}  // namespace rivulet::trace
