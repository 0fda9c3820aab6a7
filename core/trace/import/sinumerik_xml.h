// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The XML that SINUMERIK Operate saves a trace session as. @threadsafety pure.
#pragma once

#include <string_view>

#include "base/budget.h"
#include "base/result.h"
#include "trace/signals.h"

namespace rivulet::trace {

[[nodiscard]] bool isSinumerikTrace(std::string_view text);

/// One time base for each signal, because signals have their own sampling interval. Speeds are in
/// mm/min, as the control shows them. A file that was cut is read up to there.
/// @param budget  without the text; of the signals and their analysis
/// @return error ImportError::NotATable: no signals, or their values in an unknown encoding;
/// BudgetError::Exceeded
[[nodiscard]] base::Result<SignalTrace> readSinumerikTrace(std::string_view text,
                                                           const base::Budget& budget);

}  // namespace rivulet::trace
