// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/ramp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace rivulet::widgets {

QColor rampColor(double share, const ThemeColors& colors) {
  static const std::array<QColor, 3> light{QColor(0x1e, 0x6b, 0x3a), QColor(0x85, 0x7f, 0x12),
                                           QColor(0xb8, 0x4a, 0x0c)};
  static const std::array<QColor, 3> dark{QColor(0x5f, 0xc9, 0x7b), QColor(0xd6, 0xcf, 0x5a),
                                          QColor(0xf0, 0x8a, 0x4f)};
  const std::array<QColor, 3>& stops = colors.isDark ? dark : light;
  const double place = std::clamp(share, 0.0, 1.0) * 2.0;
  const std::size_t from = place < 1.0 ? 0 : 1;
  const double part = place - static_cast<double>(from);
  const auto mix = [&](int a, int b) { return static_cast<int>(std::lround(a + part * (b - a))); };
  return {mix(stops[from].red(), stops[from + 1].red()),
          mix(stops[from].green(), stops[from + 1].green()),
          mix(stops[from].blue(), stops[from + 1].blue())};
}

}  // namespace rivulet::widgets
