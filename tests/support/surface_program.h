// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

/// Finishing programs of any length.

#include <QByteArray>
#include <QFile>
#include <QString>
#include <cmath>

namespace rivulet::tests {

/// As CAM systems make them: there and back over a wavy surface of 200 mm by 100 mm, a block a
/// line, moves of half a millimetre. Five more lines than moves.
inline QByteArray surfaceProgram(int moves) {
  constexpr int kMovesOfRow = 400;
  const double rowMm = 100.0 / (moves / kMovesOfRow + 1);
  QByteArray text = "G17 G90 G71\nG0 X0 Y0 Z20\nG1 Z0 F400\n";
  text.reserve(moves * 32);
  for (int i = 0; i < moves; ++i) {
    const int row = i / kMovesOfRow;
    const int column = row % 2 == 0 ? i % kMovesOfRow : kMovesOfRow - 1 - i % kMovesOfRow;
    const double xMm = 0.5 * column;
    text += "X" + QByteArray::number(xMm, 'f', 3) + " Y" + QByteArray::number(rowMm * row, 'f', 3) +
            " Z" + QByteArray::number(2.0 * std::sin(0.2 * xMm), 'f', 3) + "\n";
  }
  return text + "G0 Z20\nM30\n";
}

/// @return whether it is on the disk
inline bool writeSurfaceProgram(const QString& path, int moves) {
  const QByteArray text = surfaceProgram(moves);
  QFile file(path);
  return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
}

}  // namespace rivulet::tests
