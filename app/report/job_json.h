// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a whole job would do, and what it did, as JSON (docs/cli.md names every field).
/// @threadsafety pure.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "forecast/job_forecast.h"
#include "job/plan.h"
#include "streaming/run/job_times.h"
#include "streaming/run/whole_job.h"
#include "trace/analysis/tool_use.h"

namespace rivulet::report {

[[nodiscard]] nlohmann::ordered_json hazardsJson(const std::vector<forecast::Hazard>& hazards);
/// In seconds.
[[nodiscard]] nlohmann::ordered_json jobTimesJson(const streaming::JobTimes& times);
[[nodiscard]] nlohmann::ordered_json toolsJson(const std::vector<trace::ToolUse>& uses);
[[nodiscard]] nlohmann::ordered_json functionsJson(const std::vector<job::FunctionUse>& uses);
[[nodiscard]] nlohmann::ordered_json jobPlaceJson(const streaming::JobPlace& place);
[[nodiscard]] nlohmann::ordered_json wholeJobJson(const job::Plan& plan,
                                                  const streaming::WholeJobReport& report);

/// "12.3 s streamed, 4.0 s pauses, 8.1 s blocks of the control, 10.0 s tool changes, 2.0 s
/// handovers; 36.4 s in all"
[[nodiscard]] std::string describe(const streaming::JobTimes& times);

/// "tool 5 MILL: 4.0 s change, 61.2 s in the spindle, turning 58.0 s at 3000 1/min, G54"
[[nodiscard]] std::string describe(const trace::ToolUse& use);

}  // namespace rivulet::report
