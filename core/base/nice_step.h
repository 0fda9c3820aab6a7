// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Round numbers for the ticks of axes and the bins of histograms: 1, 2 or 5 times a power of ten.
/// @threadsafety pure.
#pragma once

namespace rivulet::base {

/// Smallest round number that is not below `value`, up to a relative error of 1e-9. @param value >
/// 0
[[nodiscard]] double niceStepAbove(double value);

/// Largest round number that is not above `value`. @param value > 0
[[nodiscard]] double niceStepBelow(double value);

/// Smallest multiple of a tenth, rounded, that is not below `value`. @param value > 0
[[nodiscard]] double niceCeil(double value);

/// Decimals that show a multiple of `step` exactly. @param step > 0, a round number
[[nodiscard]] int decimalsOfStep(double step);

}  // namespace rivulet::base
