// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The prediction of each method, called by `predict`. Each follows the client along the time line
/// of the control in its own way. @threadsafety pure.
#pragma once

#include <chrono>
#include <vector>

#include "base/instant.h"
#include "feasibility/probability.h"

namespace rivulet::feasibility {

/// Between two signs of life of the client, each an access of its own, where the axes stand after
/// the usual time without one.
inline constexpr base::Duration kUsualBeatInterval = std::chrono::milliseconds{250};

/// [P1] Algorithm II. @param operatingPoint  N >= 1, δ > 0
[[nodiscard]] Prediction predictPosition(const std::vector<gcode::StreamPoint>& points,
                                         const OperatingPoint& operatingPoint,
                                         const StreamModel& model, base::Vec3 startMm);

/// [P1] Algorithm III. @param operatingPoint  N >= 2
[[nodiscard]] Prediction predictSignal(const std::vector<gcode::StreamPoint>& points,
                                       const OperatingPoint& operatingPoint,
                                       const StreamModel& model, base::Vec3 startMm);

/// Windows cannot fail; mean times tell how long a run takes. Of method credit this is the slower
/// end: it does not stand between windows. @param operatingPoint  N >= 1
[[nodiscard]] Prediction predictWindows(const std::vector<gcode::StreamPoint>& points,
                                        const OperatingPoint& operatingPoint,
                                        const StreamModel& model, base::Vec3 startMm);

}  // namespace rivulet::feasibility
