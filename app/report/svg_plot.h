// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A plot as an SVG picture for print: axes with round ticks, units, a legend, and series that
/// differ even without colour. @threadsafety pure.
#pragma once

#include <string>

#include "experiments/experiment.h"

namespace rivulet::report {

/// The same plot gives the same text, to the byte.
[[nodiscard]] std::string svgPlot(const experiments::Plot& plot);

}  // namespace rivulet::report
