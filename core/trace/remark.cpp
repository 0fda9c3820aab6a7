// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/remark.h"

#include <array>
#include <cstddef>
#include <utility>

#include "base/sentence.h"

namespace rivulet::trace {

namespace {

/// In the order of the codes.
constexpr std::array<std::pair<RemarkCode, const char*>, 39> kPatterns{{
    {RemarkCode::DuplicateColumn,
     RIVULET_SENTENCE("TraceRemarks",
                      "The column \"%1\" occurs more than once: this one is called \"%2\".")},
    {RemarkCode::TimeUnitAssumed,
     RIVULET_SENTENCE("TraceRemarks", "The time \"%1\" has no unit: %2 is assumed.")},
    {RemarkCode::RateAssumed,
     RIVULET_SENTENCE("TraceRemarks", "The file has no column of time: %1 Hz is assumed.")},
    {RemarkCode::TimeBackwards,
     RIVULET_SENTENCE("TraceRemarks",
                      "The time \"%1\" runs backwards at row %2. Rows that were left out "
                      "until it goes on: %3.")},
    {RemarkCode::TimeRepeated,
     RIVULET_SENTENCE("TraceRemarks",
                      "Rows that repeat the time of the row before and were left out: %1.")},
    {RemarkCode::RowsSorted,
     RIVULET_SENTENCE("TraceRemarks",
                      "The rows are not in the order of their time \"%1\", the first at "
                      "row %2: they were sorted.")},
    {RemarkCode::Sections,
     RIVULET_SENTENCE("TraceRemarks",
                      "The time \"%1\" starts again, the first time at row %2. %3 sections "
                      "are shown %4 s apart, and the longest one is analysed.")},
    {RemarkCode::SparseRows,
     RIVULET_SENTENCE("TraceRemarks",
                      "The signals stand in rows of their own: straight lines are assumed "
                      "between the values of each.")},
    {RemarkCode::TextRows,
     RIVULET_SENTENCE("TraceRemarks",
                      "Rows of text that hold no values and were left out: %1, the first "
                      "in line %2.")},
    {RemarkCode::DayFirstAssumed,
     RIVULET_SENTENCE("TraceRemarks",
                      "No date tells what comes first in it: day/month is assumed.")},
    {RemarkCode::ValuesBackwards,
     RIVULET_SENTENCE("TraceRemarks",
                      "Values whose time runs backwards and that were left out: %1.")},
    {RemarkCode::SeveralTimes,
     RIVULET_SENTENCE("TraceRemarks",
                      "The file has %1 columns of time; each belongs to the columns after it.")},
    {RemarkCode::OddRows,
     RIVULET_SENTENCE("TraceRemarks",
                      "Rows that do not have %1 columns and were left out: %2, the first "
                      "in line %3.")},
    {RemarkCode::NoNumbers,
     RIVULET_SENTENCE("TraceRemarks",
                      "Cells that are no numbers and were left empty: %1, the first in line %2.")},
    {RemarkCode::CutInRow,
     RIVULET_SENTENCE("TraceRemarks", "The file ends within a row: it was cut off there.")},
    {RemarkCode::CutFile,
     RIVULET_SENTENCE("TraceRemarks", "The file was cut off: its end is missing.")},
    {RemarkCode::CutCompressed,
     RIVULET_SENTENCE("TraceRemarks",
                      "The compressed file is cut or damaged: what came before was read.")},
    {RemarkCode::SpeedUnitsAssumed,
     RIVULET_SENTENCE("TraceRemarks",
                      "The file does not say the units of its speeds: mm/min is assumed, "
                      "as the control shows them.")},
    {RemarkCode::Remembered,
     RIVULET_SENTENCE("TraceRemarks",
                      "The columns mean what was said for this layout before: %1.")},
    {RemarkCode::OtherDatasets,
     RIVULET_SENTENCE(
         "TraceRemarks",
         "Datasets that are no row of numbers and were left out: %1, the first \"%2\".")},
    {RemarkCode::DamagedDatasets,
     RIVULET_SENTENCE(
         "TraceRemarks",
         "Datasets that are damaged and were read in part or not at all: %1, the first \"%2\".")},
    {RemarkCode::DatasetsWithoutTime,
     RIVULET_SENTENCE("TraceRemarks",
                      "Datasets to whose length no time belongs and that were left out: "
                      "%1, the first \"%2\".")},
    {RemarkCode::HeldValues,
     RIVULET_SENTENCE("TraceRemarks",
                      "An MTConnect agent reports a value when it changes: in gaps the last value "
                      "is held; otherwise straight lines are assumed between values.")},
    {RemarkCode::KnownFrom,
     RIVULET_SENTENCE("TraceRemarks",
                      "All positions are known from %1 s on: what comes before is not analysed.")},
    {RemarkCode::ValuesAtOnce,
     RIVULET_SENTENCE("TraceRemarks",
                      "Values with the time of a later value of the same item, which counts "
                      "instead: %1.")},
    {RemarkCode::ItemTables,
     RIVULET_SENTENCE("TraceRemarks",
                      "Observations that are tables or sets of values and were left out: %1, the "
                      "first of \"%2\".")},
    {RemarkCode::SeriesWithoutRate,
     RIVULET_SENTENCE("TraceRemarks",
                      "Series of values without a sample rate that were left out, because their "
                      "times are not known: %1, the first of \"%2\".")},
    {RemarkCode::UnreadableObservations,
     RIVULET_SENTENCE("TraceRemarks",
                      "Observations without a time or a number that can be read and that were "
                      "left out: %1, the first of \"%2\".")},
    {RemarkCode::ItemsUnavailable,
     RIVULET_SENTENCE("TraceRemarks",
                      "Items without any value that were left out: %1, the first \"%2\".")},
    {RemarkCode::ItemsWithoutRole,
     RIVULET_SENTENCE("TraceRemarks",
                      "Items that mean the same as another one, which is analysed instead: %1.")},
    {RemarkCode::ItemUnitUnknown,
     RIVULET_SENTENCE(
         "TraceRemarks",
         "The unit \"%2\" of the item \"%1\" is not known: the item is not analysed.")},
    {RemarkCode::NotesLeftOut,
     RIVULET_SENTENCE("TraceRemarks",
                      "States and messages of the machine that are too many and were left out: "
                      "%1.")},
    {RemarkCode::AgentRefused,
     RIVULET_SENTENCE("TraceRemarks", "The MTConnect agent refused a part: %1.")},
    {RemarkCode::ObservationsMissing,
     RIVULET_SENTENCE("TraceRemarks",
                      "Observations between two answers that the MTConnect agent no longer had: "
                      "%1. The motion is not known there.")},
    {RemarkCode::AgentRestarted,
     RIVULET_SENTENCE("TraceRemarks",
                      "The MTConnect agent was started again between two answers: what it had kept "
                      "until then may be incomplete.")},
    {RemarkCode::RecordingCut,
     RIVULET_SENTENCE("TraceRemarks",
                      "The recording ends before its run: what came before is shown.")},
    {RemarkCode::UnreadableLines,
     RIVULET_SENTENCE("TraceRemarks",
                      "Lines of the recording that cannot be read and were left out: %1.")},
    {RemarkCode::TraceTruncated,
     RIVULET_SENTENCE("TraceRemarks",
                      "The trace of the control is incomplete: its memory was full.")},
    {RemarkCode::OtherProgram,
     RIVULET_SENTENCE("TraceRemarks", "The program does not belong to this trace from %1 s on.")},
}};

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < kPatterns.size(); ++i) {
    if (static_cast<std::size_t>(kPatterns[i].first) != i) {
      return false;
    }
  }
  return kPatterns.size() == static_cast<std::size_t>(RemarkCode::OtherProgram) + 1;
}
static_assert(isInOrder(), "each code has its sentence");

}  // namespace

const char* remarkPattern(RemarkCode code) {
  return kPatterns[static_cast<std::size_t>(code)].second;
}

std::string remarkText(const Remark& remark) {
  std::string text;
  for (const char* at = remarkPattern(remark.code); *at != '\0'; ++at) {
    const bool isPlace = *at == '%' && at[1] >= '1' && at[1] <= '9';
    const auto index = isPlace ? static_cast<std::size_t>(at[1] - '1') : 0;
    if (isPlace && index < remark.values.size()) {
      text += remark.values[index];
      ++at;
    } else {
      text += *at;
    }
  }
  return text;
}

}  // namespace rivulet::trace
