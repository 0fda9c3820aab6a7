// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A short NC program for tests that stream over a connection.
#pragma once

#include <QByteArray>
#include <cmath>

namespace rivulet::tests {

/// An arc of points that are 1 mm apart, in mm. @param points  with the start
[[nodiscard]] inline QByteArray arcProgram(int points) {
  QByteArray text = "G17 G90 G71 G94\nG0 X0 Y0 Z50\n";
  for (int i = 1; i < points; ++i) {
    const double angle = 0.2 * i;
    text += "G1 X" + QByteArray::number(5.0 * std::sin(angle), 'f', 3) + " Y" +
            QByteArray::number(5.0 - 5.0 * std::cos(angle), 'f', 3) + " F300\n";
  }
  return text + "M30\n";
}

}  // namespace rivulet::tests
