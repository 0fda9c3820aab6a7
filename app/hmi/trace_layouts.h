// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The pane layouts of the page Traces on the disk, one file per user.
/// @threadsafety reads and writes a file.
#pragma once

#include <filesystem>

#include "base/result.h"
#include "widgets/scope/scope_layout.h"

namespace rivulet::hmi {

/// $XDG_CONFIG_HOME/rivulet/trace_panes.json.
[[nodiscard]] std::filesystem::path traceLayoutsFile();

struct LoadedTraceLayouts {
  widgets::ScopeLayouts layouts;  ///< what can be read of them
  /// Where a damaged file is kept; the file itself then has what can be read. Empty: it is sound,
  /// or there is none.
  std::filesystem::path keptAs;
};

/// @return error Unreadable; NotWritable: the file is damaged, and cannot be kept under another
/// name
[[nodiscard]] base::Result<LoadedTraceLayouts> loadTraceLayouts(const std::filesystem::path& file);

/// @return error NotWritable
[[nodiscard]] base::Result<void> saveTraceLayouts(const std::filesystem::path& file,
                                                  const widgets::ScopeLayouts& layouts);

}  // namespace rivulet::hmi
