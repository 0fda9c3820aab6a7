// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A stop of the axes as the window shows it: seen during a run, or found in a whole trace.
/// @threadsafety GUI thread.
#pragma once

#include <QBrush>
#include <QPalette>
#include <QRectF>
#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "trace/analysis/standstills.h"
#include "trace/pause.h"

class QPainter;

namespace rivulet::widgets {

struct StopRow {
  base::Instant start{};  ///< from the first sample
  base::Duration duration{};
  trace::PauseOrigin origin = trace::PauseOrigin::Measured;
  std::optional<trace::StopCause> cause{};  ///< nothing: not looked for
  std::uint32_t line = 0;                   ///< of the program on the control; 0: not known
  std::string evidence{};                   ///< of the cause, in English
  double fromAxis = 0.0;                    ///< on the axis of the panes: s, mm or points
  double toAxis = 0.0;
};

[[nodiscard]] StopRow stopRow(const trace::Pause& pause);
[[nodiscard]] StopRow stopRow(const trace::Standstill& stop);

/// "M", "I" or "P" in the language of the operator, and the word for it.
[[nodiscard]] QString pauseOriginLetter(trace::PauseOrigin origin);
[[nodiscard]] QString pauseOriginText(trace::PauseOrigin origin);
/// How the bands of an origin are filled.
[[nodiscard]] QBrush pauseBrush(trace::PauseOrigin origin, const QPalette& palette);

/// Where a picture of the time is, and which part of the time it shows.
struct TimeArea {
  QRectF rect;
  double fromS = 0.0;
  double toS = 1.0;

  [[nodiscard]] double xOf(double seconds) const {
    return rect.left() + (seconds - fromS) / (toS - fromS) * rect.width();
  }
  [[nodiscard]] double secondsAt(double x) const {
    return fromS + (x - rect.left()) / rect.width() * (toS - fromS);
  }
};

/// Stops as bands: plain for measured, hatched for inferred, dotted for predicted ones, with
/// duration and origin if there is room for them. @param stops  in time order
void paintStopBands(QPainter& painter, const TimeArea& area, const std::vector<StopRow>& stops,
                    bool labels, const QPalette& palette);

}  // namespace rivulet::widgets
