// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The analysis of a trace as JSON and as text (docs/traces.md names every field).
/// @threadsafety pure.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "trace/analysis/trace_analysis.h"

namespace rivulet::report {

/// `standstills`, `path` and, as far as they are known, `contour_error`, `following_error`,
/// `corners`, `feed`, `vibration`. Times are from the first sample.
void addTraceAnalysis(nlohmann::ordered_json& json, const trace::TraceAnalysis& analysis);

/// The same for people: one figure a line, without the lists.
[[nodiscard]] std::string traceAnalysisText(const trace::TraceAnalysis& analysis);

}  // namespace rivulet::report
