// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Writes the page of a trace, and says the words of a trend, for programs without a window. Needs
/// Qt's fonts, but no display.
/// @threadsafety main thread; the first call makes the application object.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "report/run_trend.h"
#include "trace_report/trace_sheet.h"

namespace rivulet::trace_report {

/// @param file  its ending says how: .html or .pdf
/// @param language  "en", "de", "fr", "it", "es"
/// @return NotWritable: another ending, or the file cannot be written
[[nodiscard]] base::Result<void> writeTracePage(const std::filesystem::path& file,
                                                const std::string& language,
                                                const TraceFacts& facts);

/// The words of a trend. @param language  as above
[[nodiscard]] report::TrendTexts trendTexts(const std::string& language);

}  // namespace rivulet::trace_report
