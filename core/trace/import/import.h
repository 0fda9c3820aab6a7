// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Reads the traces of other tools: tables of any layout (CSV, TSV, LinuxCNC halsampler, TwinCAT
/// Scope) and the XML of the SINUMERIK trace, plain or compressed with zstd. What can be read is
/// kept; the rest is said in `SignalTrace::remarks`. @threadsafety pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "trace/import/columns.h"
#include "trace/signals.h"

namespace rivulet::trace {

struct ImportOptions {
  std::vector<ColumnRole> columns;  ///< as the user says; other roles are guessed
  std::optional<double> rateHz;     ///< of a table without a column of time, > 0
};

struct ImportedTrace {
  SignalTrace trace;
  /// The roles in use, with the units that were applied; those of Time first.
  std::vector<ColumnRole> columns;
  /// The headings of the table in one line, by which files of the same layout are recognised.
  std::string layout;
};

/// @return error NotATable: nothing can be read; BadMapping: a column is not there
[[nodiscard]] base::Result<ImportedTrace> importTrace(std::string_view bytes,
                                                      const ImportOptions& options = {});

}  // namespace rivulet::trace
