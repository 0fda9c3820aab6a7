// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Writes the page of a trace for programs without a window. Needs Qt's fonts, but no display.
/// @threadsafety main thread; the first call makes the application object.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "trace_report/trace_page.h"

namespace rivulet::trace_report {

/// @param file  its ending says how: .html or .pdf
/// @param language  "en", "de", "fr", "it", "es"
/// @return NotWritable: another ending, or the file cannot be written
[[nodiscard]] base::Result<void> writeTracePage(const std::filesystem::path& file,
                                                const std::string& language,
                                                const TraceFacts& facts);

}  // namespace rivulet::trace_report
