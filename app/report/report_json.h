// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Results as JSON for programs (docs/cli.md names every field). @threadsafety pure.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "base/error.h"
#include "feasibility/path_statistics.h"
#include "feasibility/verdict.h"
#include "gcode/program.h"
#include "streaming/methods/feed_plan.h"
#include "streaming/run/run.h"
#include "trace/analysis/integrity.h"
#include "trace/pause.h"

namespace rivulet::report {

/// Orders of the feed cell, the first at 0 s.
[[nodiscard]] nlohmann::ordered_json feedJson(const std::vector<streaming::FeedEvent>& events);
/// What came of a source of factors.
[[nodiscard]] nlohmann::ordered_json factorJson(const streaming::FactorReport& factor);

/// {"code": "category:number", "message": …}
[[nodiscard]] nlohmann::ordered_json errorJson(const base::Error& error);
[[nodiscard]] nlohmann::ordered_json pausesJson(const std::vector<trace::Pause>& pauses,
                                                base::Instant origin);
/// The first faults the oracle found, with times from the start of the trace.
[[nodiscard]] nlohmann::ordered_json faultsJson(const std::vector<trace::IntegrityFault>& faults,
                                                base::Instant origin);
/// Every form that was tried, the best first.
[[nodiscard]] nlohmann::ordered_json accessFormsJson(const streaming::AccessForms& forms);
[[nodiscard]] nlohmann::ordered_json runJson(const streaming::RunReport& report);
[[nodiscard]] nlohmann::ordered_json verdictJson(const feasibility::Verdict& verdict);
/// The largest override and the block that limits it.
[[nodiscard]] nlohmann::ordered_json overrideLimitJson(const streaming::OverrideLimit& limit);
[[nodiscard]] nlohmann::ordered_json mergedJson(const gcode::MergedMoves& merged);
[[nodiscard]] nlohmann::ordered_json distancesJson(const feasibility::ProgramDistances& distances);
/// The facts of a program's text, in its own units; null if not known.
[[nodiscard]] nlohmann::ordered_json factsJson(const gcode::ProgramFacts& facts);

/// Distances and corners of the points as they are streamed. @param list at least 2 points
[[nodiscard]] nlohmann::ordered_json statisticsJson(const feasibility::PathStatistics& statistics);
[[nodiscard]] nlohmann::ordered_json programJson(const gcode::Program& program);

}  // namespace rivulet::report
