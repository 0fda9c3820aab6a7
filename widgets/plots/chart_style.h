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

/// Background, fonts and colours of chart and axes.
void styleChart(QChart* chart, const QPalette& palette);

/// Divides [min, max] into about `ticks` steps (see `base/nice_step.h`); labels get the decimals
/// the step needs.
/// @param min < max
void divideAxis(QValueAxis* axis, double min, double max, int ticks);

}  // namespace rivulet::widgets
