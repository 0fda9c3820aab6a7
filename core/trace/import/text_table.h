// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A text of rows and columns as numbers, whatever separates the columns (tab, semicolon, comma,
/// blanks) and whatever the decimal sign is. @threadsafety pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/budget.h"
#include "base/result.h"
#include "trace/import/clock_text.h"
#include "trace/import/text_blocks.h"
#include "trace/packed_points.h"
#include "trace/remark.h"

namespace rivulet::trace {

/// A row before the first row of numbers.
struct HeadRow {
  std::vector<std::string> cells;  ///< as they are
  std::size_t line = 0;
  bool holdsValue = false;  ///< a number or a time is among them
};

struct TextTable {
  std::vector<HeadRow> head;
  std::vector<PackedValues> columns;  ///< of equal length; NaN: empty, or not a number
  std::vector<ClockKind> kinds;       ///< one per column; TimeOfDay has become Timestamp
  std::vector<Remark> remarks;        ///< what could not be read
};

/// UTF-8 of a text that may be UTF-16 or Latin-1, or begin with a byte order mark.
/// @param converted  holds the text where the bytes are something else
/// @return error BudgetError::Exceeded
[[nodiscard]] base::Result<std::string_view> utf8Of(std::string_view bytes, std::string& converted,
                                                    const base::Budget& budget);

/// Columns are recognised by the rows that hold numbers. A time of day counts as a number of
/// seconds, with its own date or that of another column; "true" and "false" as 1 and 0. Rows that
/// do not fit are left out and counted.
/// @param facts   of all blocks; they are UTF-8
/// @param budget  without the text; of the numbers and their analysis
/// @return error ImportError::NotATable: no rows of numbers; BudgetError::Exceeded; those of
/// `TextBlocks::next`
[[nodiscard]] base::Result<TextTable> readTable(TextBlocks& blocks, const TextFacts& facts,
                                                const base::Budget& budget,
                                                base::Executor& executor);

}  // namespace rivulet::trace
