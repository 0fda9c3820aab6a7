// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/remark.h"

#include <cstddef>

#include "base/contract.h"
#include "base/sentence.h"

namespace rivulet::trace {

const char* remarkPattern(RemarkCode code) {
  switch (code) {
    case RemarkCode::DuplicateColumn:
      return RIVULET_SENTENCE(
          "TraceRemarks", "The column \"%1\" occurs more than once: this one is called \"%2\".");
    case RemarkCode::TimeUnitAssumed:
      return RIVULET_SENTENCE("TraceRemarks", "The time \"%1\" has no unit: %2 is assumed.");
    case RemarkCode::RateAssumed:
      return RIVULET_SENTENCE("TraceRemarks", "The file has no column of time: %1 Hz is assumed.");
    case RemarkCode::TimeBackwards:
      return RIVULET_SENTENCE("TraceRemarks",
                              "The time \"%1\" runs backwards at row %2. Rows that were left out "
                              "until it goes on: %3.");
    case RemarkCode::TimeRepeated:
      return RIVULET_SENTENCE("TraceRemarks",
                              "Rows that repeat the time of the row before and were left out: %1.");
    case RemarkCode::ValuesBackwards:
      return RIVULET_SENTENCE("TraceRemarks",
                              "Values whose time runs backwards and that were left out: %1.");
    case RemarkCode::SeveralTimes:
      return RIVULET_SENTENCE(
          "TraceRemarks", "The file has %1 columns of time; each belongs to the columns after it.");
    case RemarkCode::OddRows:
      return RIVULET_SENTENCE("TraceRemarks",
                              "Rows that do not have %1 columns and were left out: %2, the first "
                              "in line %3.");
    case RemarkCode::NoNumbers:
      return RIVULET_SENTENCE(
          "TraceRemarks",
          "Cells that are no numbers and were left empty: %1, the first in line %2.");
    case RemarkCode::CutInRow:
      return RIVULET_SENTENCE("TraceRemarks", "The file ends within a row: it was cut off there.");
    case RemarkCode::CutFile:
      return RIVULET_SENTENCE("TraceRemarks", "The file was cut off: its end is missing.");
    case RemarkCode::CutCompressed:
      return RIVULET_SENTENCE("TraceRemarks",
                              "The compressed file is cut or damaged: what came before was read.");
    case RemarkCode::SpeedUnitsAssumed:
      return RIVULET_SENTENCE("TraceRemarks",
                              "The file does not say the units of its speeds: mm/min is assumed, "
                              "as the control shows them.");
    case RemarkCode::Remembered:
      return RIVULET_SENTENCE("TraceRemarks",
                              "The columns mean what was said for this layout before: %1.");
    case RemarkCode::OtherDatasets:
      return RIVULET_SENTENCE(
          "TraceRemarks",
          "Datasets that are no row of numbers and were left out: %1, the first \"%2\".");
    case RemarkCode::DamagedDatasets:
      return RIVULET_SENTENCE(
          "TraceRemarks",
          "Datasets that are damaged and were read in part or not at all: %1, the first \"%2\".");
    case RemarkCode::DatasetsWithoutTime:
      return RIVULET_SENTENCE("TraceRemarks",
                              "Datasets to whose length no time belongs and that were left out: "
                              "%1, the first \"%2\".");
    case RemarkCode::RecordingCut:
      return RIVULET_SENTENCE("TraceRemarks",
                              "The recording ends before its run: what came before is shown.");
    case RemarkCode::UnreadableLines:
      return RIVULET_SENTENCE("TraceRemarks",
                              "Lines of the recording that cannot be read and were left out: %1.");
    case RemarkCode::TraceTruncated:
      return RIVULET_SENTENCE("TraceRemarks",
                              "The trace of the control is incomplete: its memory was full.");
    case RemarkCode::OtherProgram:
      return RIVULET_SENTENCE("TraceRemarks",
                              "The program does not belong to this trace from %1 s on.");
  }
  RIVULET_ASSERT(false);
  return "";
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
