// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a comparison of a whole job with its machine has found. @threadsafety plain values.
#pragma once

#include <vector>

#include "forecast/job_forecast.h"

namespace rivulet::session {

using Hazards = std::vector<forecast::Hazard>;

}  // namespace rivulet::session
