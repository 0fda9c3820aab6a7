// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Reads the traces of other tools: tables of any layout (CSV, TSV, LinuxCNC halsampler, TwinCAT
/// Scope), the XML of the SINUMERIK trace and that of MTConnect agents, plain or compressed with
/// zstd. What can be read is kept; the rest is said in `SignalTrace::remarks`. @threadsafety pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/budget.h"
#include "base/byte_source.h"
#include "base/executor.h"
#include "base/result.h"
#include "trace/import/columns.h"
#include "trace/signals.h"

namespace rivulet::trace {

/// A column of a table as it is shown to somebody who says what it means.
struct ColumnPreview {
  std::string name;
  std::string unit;                  ///< as the file says, as chosen, or as assumed
  std::optional<SignalRole> role{};  ///< as chosen or guessed
  std::vector<double> first{};       ///< its first values, at most `kValuesShown`; NaN: none there
};
inline constexpr std::size_t kValuesShown = 5;

struct TablePreview {
  std::vector<ColumnPreview> columns;  ///< empty: the file is no table
  TableMapping mapping;                ///< that was obeyed
  /// A position is known, and no unit or rate of the time had to be assumed.
  bool isCertain = false;
};

struct ImportedTrace {
  SignalTrace trace;
  /// The roles in use, with the units that were applied; those of Time first.
  std::vector<ColumnRole> columns;
  /// The headings of the table in one line, by which files of the same layout are recognised.
  std::string layout;
  TablePreview table;
};

/// @param budget  without the bytes themselves  @param executor  null: one thread
/// @return error NotATable: nothing can be read; AgentRefused: it is a refusal; BadMapping: a
/// column is not there; BudgetError::Exceeded, also if only the analysis would take more
[[nodiscard]] base::Result<ImportedTrace> importTrace(std::string_view bytes,
                                                      const TableMapping& mapping = {},
                                                      const base::Budget& budget = {},
                                                      base::Executor* executor = nullptr);

/// The same of a table that is read block by block, so that its text is not held.
/// @return nothing: it is not so large, or something else, or not UTF-8; `importTrace` reads it
[[nodiscard]] base::Result<std::optional<ImportedTrace>> importLargeTable(
    base::ByteSource& bytes, const TableMapping& mapping = {}, const base::Budget& budget = {},
    base::Executor* executor = nullptr);

/// Signals that have their own times, from elsewhere than a file; what they mean is guessed from
/// their names. @param trace  each signal has a value or more
/// @return error BadMapping
[[nodiscard]] base::Result<ImportedTrace> importSignals(SignalTrace trace,
                                                        const TableMapping& mapping = {});

}  // namespace rivulet::trace
