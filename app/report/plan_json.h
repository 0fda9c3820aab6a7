// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A whole job as JSON (docs/cli.md names every field). @threadsafety pure.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "job/plan.h"

namespace rivulet::report {

/// The parts of a program in its order, each streamed or native, and what refuses the job.
[[nodiscard]] nlohmann::ordered_json planJson(const job::Plan& plan);
/// One part of it; null for a stretch that moves nothing.
[[nodiscard]] nlohmann::ordered_json partJson(const job::Part& part);
[[nodiscard]] nlohmann::ordered_json refusalsJson(const std::vector<job::Refusal>& refusals);

}  // namespace rivulet::report
