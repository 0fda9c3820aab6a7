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

/// Nothing if there is no such file; what is damaged is left out.
[[nodiscard]] widgets::ScopeLayouts loadTraceLayouts(const std::filesystem::path& file);

/// @return error NotWritable
[[nodiscard]] base::Result<void> saveTraceLayouts(const std::filesystem::path& file,
                                                  const widgets::ScopeLayouts& layouts);

}  // namespace rivulet::hmi
