// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How every chart looks, and how its axes are divided: steps of 1, 2 or 5, numbers in the
/// language of the application.
/// @threadsafety GUI thread.
#pragma once

#include <QPalette>

class QChart;
class QValueAxis;

namespace rivulet::widgets {

/// 1, 2 or 5 times a power of ten, not below `value`. @param value > 0
[[nodiscard]] double niceStep(double value);

/// Smallest multiple of a nice step that is not below `value`. @param value > 0
[[nodiscard]] double niceCeil(double value);

/// Background, fonts and colours of chart and axes.
void styleChart(QChart* chart, const QPalette& palette);

/// Divides [min, max] into about `ticks` nice steps; labels get the decimals the step needs.
/// @param min < max
void divideAxis(QValueAxis* axis, double min, double max, int ticks);

}  // namespace rivulet::widgets
