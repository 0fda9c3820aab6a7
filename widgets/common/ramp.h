// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Colours for values along a scale. @threadsafety pure.
#pragma once

#include <QColor>

#include "widgets/common/theme.h"

namespace rivulet::widgets {

/// From cool to warm; each end and the middle stand out from the surface of the theme. No blue: the
/// executed path is blue. @param share  0 to 1
[[nodiscard]] QColor rampColor(double share, const ThemeColors& colors);

}  // namespace rivulet::widgets
