// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What could not be read of a trace, or had to be assumed: a code with its values. The command
/// line prints the English sentence, the window its translation. @threadsafety plain values; pure.
#pragma once

#include <string>
#include <vector>

namespace rivulet::trace {

enum class RemarkCode {
  // Files of other tools.
  DuplicateColumn,      ///< name, name that it has now
  TimeUnitAssumed,      ///< name of the column, unit
  RateAssumed,          ///< Hz
  TimeBackwards,        ///< name of the column, first row, rows
  TimeRepeated,         ///< rows
  RowsSorted,           ///< name of the column, first row
  Sections,             ///< name of the column, first row of the second one, sections, s between
  SparseRows,           ///< no value
  TextRows,             ///< rows, line of the first
  DayFirstAssumed,      ///< no value
  ValuesBackwards,      ///< values
  SeveralTimes,         ///< columns of time
  OddRows,              ///< columns, rows, first line
  NoNumbers,            ///< cells, line of the first
  CutInRow,             ///< no value
  CutFile,              ///< no value
  CutCompressed,        ///< no value
  SpeedUnitsAssumed,    ///< no value
  Remembered,           ///< columns as `printColumnRoles`
  OtherDatasets,        ///< datasets, path of the first
  DamagedDatasets,      ///< datasets, path of the first
  DatasetsWithoutTime,  ///< datasets, path of the first
  // MTConnect.
  HeldValues,              ///< no value
  KnownFrom,               ///< s from the first value
  ValuesAtOnce,            ///< values
  ItemTables,              ///< observations, item of the first
  SeriesWithoutRate,       ///< observations, item of the first
  UnreadableObservations,  ///< observations, item of the first
  ItemsUnavailable,        ///< items, the first
  ItemsWithoutRole,        ///< names of the items
  ItemUnitUnknown,         ///< name of the item, unit
  NotesLeftOut,            ///< words of events
  AgentRefused,            ///< text of the agent
  ObservationsMissing,     ///< observations
  AgentRestarted,          ///< no value
  // Recordings and traces of controls.
  RecordingCut,     ///< no value
  UnreadableLines,  ///< lines
  TraceTruncated,   ///< no value
  OtherProgram,     ///< s from the first sample
};

struct Remark {
  RemarkCode code = RemarkCode::CutFile;
  std::vector<std::string> values{};  ///< as the code says

  friend bool operator==(const Remark&, const Remark&) = default;
};

/// The English sentence with "%1", "%2", "%3" in place of the values: the source of its
/// translation, context "TraceRemarks".
[[nodiscard]] const char* remarkPattern(RemarkCode code);
/// One English sentence.
[[nodiscard]] std::string remarkText(const Remark& remark);

}  // namespace rivulet::trace
