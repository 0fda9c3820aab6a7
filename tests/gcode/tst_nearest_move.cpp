// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <vector>

#include "gcode/nearest_move.h"
#include "support/test_program.h"

using namespace rivulet;
using gcode::nearestMove;

namespace {

/// Along X, then Y, then back along X.
std::vector<gcode::StreamPoint> path() {
  std::vector<gcode::StreamPoint> points;
  for (const base::Vec3 at :
       {base::Vec3{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, 10, 0}}) {
    points.push_back({at, base::LineNumber{1}, gcode::MoveKind::Feed, {}});
  }
  return points;
}

}  // namespace

class TestNearestMove : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void findsTheMoveThatThePositionIsOn() {
    const auto points = path();
    QCOMPARE(nearestMove(points, 0, 5, {4, 0, 0}).point, std::size_t{1});
    QCOMPARE(nearestMove(points, 0, 5, {10, 6, 0}).point, std::size_t{2});
    QCOMPARE(nearestMove(points, 0, 5, {3, 10, 0}).point, std::size_t{3});
    QCOMPARE(nearestMove(points, 0, 5, {3, 9.9, 0}).distanceMm, 0.1);
  }

  void looksOnlyAtTheMovesAskedFor() {
    QCOMPARE(nearestMove(path(), 2, 4, {4, 0, 0}).point, std::size_t{2});
    QCOMPARE(nearestMove(path(), 0, 1, {0, 0, 5}).distanceMm, 5.0);
  }

  /// At a point, the move that ends there counts; a move of no length is no trap.
  void ofEquallyNearMovesTheFirstCounts() {
    QCOMPARE(nearestMove(path(), 0, 5, {10, 0, 0}).point, std::size_t{1});
    QCOMPARE(nearestMove(path(), 3, 5, {0, 10, 0}).point, std::size_t{3});
    QCOMPARE(nearestMove(path(), 4, 5, {0, 10, 2}).distanceMm, 2.0);
  }
};

RIVULET_TEST(TestNearestMove)
#include "tst_nearest_move.moc"
