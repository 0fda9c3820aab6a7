// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a program alone does not say: a value of the control, a place before the first motion.
#pragma once

#include <limits>

namespace rivulet::nc {

/// NaN, so that what is computed with it is unknown, too. Ask with std::isnan.
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace rivulet::nc
