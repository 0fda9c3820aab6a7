// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <algorithm>
#include <functional>
#include <limits>

#include "base/random.h"
#include "gcode/program.h"
#include "streaming/pause_placement.h"

using namespace rivulet;
using streaming::PausePlacement;

namespace {

std::vector<gcode::StreamPoint> drawPoints(base::Random& random, std::size_t count) {
  std::vector<gcode::StreamPoint> points;
  base::Vec3 at;
  base::Vec3 along{1, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    if (random.below(3) == 0) {
      along = random.below(2) == 0 ? base::Vec3{0, 1, 0} : base::Vec3{1, 0.1, 0};
    }
    at = at + along;
    points.push_back({at,
                      {static_cast<std::uint32_t>(i + 1)},
                      random.below(6) == 0 ? gcode::MoveKind::Rapid : gcode::MoveKind::Feed});
  }
  return points;
}

/// Every way to cut is tried.
std::pair<std::size_t, std::size_t> fewestByTrying(const std::vector<bool>& harmless,
                                                   std::size_t perWindow) {
  std::pair<std::size_t, std::size_t> best{std::numeric_limits<std::size_t>::max(), 0};
  const std::function<void(std::size_t, std::size_t, std::size_t)> go = [&](std::size_t begin,
                                                                            std::size_t inCut,
                                                                            std::size_t windows) {
    if (begin == harmless.size()) {
      best = std::min(best, {inCut, windows});
      return;
    }
    for (std::size_t end = begin + 1; end <= std::min(begin + perWindow, harmless.size()); ++end) {
      go(end, inCut + (harmless[end - 1] ? 0U : 1U), windows + 1);
    }
  };
  go(0, 0, 0);
  return best;
}

void checkCuts(const PausePlacement& placement, const std::vector<bool>& harmless,
               std::size_t perWindow) {
  QCOMPARE(placement.begins.front(), std::size_t{0});
  std::size_t inCut = 0;
  for (std::size_t window = 0; window < placement.windows(); ++window) {
    const std::size_t end =
        window + 1 < placement.windows() ? placement.begins[window + 1] : harmless.size();
    QVERIFY(end > placement.begins[window]);
    QVERIFY(end - placement.begins[window] <= perWindow);
    inCut += harmless[end - 1] ? 0U : 1U;
  }
  QCOMPARE(placement.inCut, inCut);
}

}  // namespace

class TestPausePlacement : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// No way to cut has fewer pauses in the cut, or as few and fewer windows.
  void noWayIsBetter() {
    base::Random random(7);
    for (int round = 0; round < 400; ++round) {
      const auto points = drawPoints(random, 1 + random.below(14));
      const std::size_t perWindow = 1 + random.below(5);
      const std::vector<bool> harmless = streaming::harmlessPauses(points);
      const PausePlacement placed = streaming::placePauses(points, perWindow);
      checkCuts(placed, harmless, perWindow);
      const PausePlacement even = streaming::evenPauses(points, perWindow);
      checkCuts(even, harmless, perWindow);
      const auto best = fewestByTrying(harmless, perWindow);
      QCOMPARE(placed.inCut, best.first);
      QCOMPARE(placed.windows(), best.second);
      QVERIFY(placed.inCut <= even.inCut);
      QCOMPARE(even.windows(), (points.size() + perWindow - 1) / perWindow);
    }
  }

  void whereAPauseDoesNoHarm() {
    using gcode::MoveKind;
    const std::vector<gcode::StreamPoint> points{
        {{0, 0, 5}, {1}, MoveKind::Rapid},  {{0, 0, 0}, {2}, MoveKind::Feed},
        {{1, 0, 0}, {3}, MoveKind::Feed},   {{2, 0.2, 0}, {4}, MoveKind::Feed},
        {{2.1, 1, 0}, {5}, MoveKind::Feed}, {{2.2, 2, 0}, {6}, MoveKind::Feed},
        {{2.2, 2, 5}, {7}, MoveKind::Rapid}};
    // Behind the rapid, at the plunge's end, at the corner, in front of the retract, at the end.
    QCOMPARE(streaming::harmlessPauses(points),
             (std::vector<bool>{true, true, false, true, false, true, true}));
  }

  /// CAM programs: at least 90 % of the pauses lie off the cut, or M allows no better (above).
  void camPrograms() {
    const auto program = gcode::loadProgram(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");
    QVERIFY(program.has_value());
    const auto points = gcode::streamPoints(program->trajectory, {}).points;
    for (const std::size_t perWindow : {7U, 12U, 30U}) {
      const PausePlacement placed = streaming::placePauses(points, perWindow);
      const PausePlacement even = streaming::evenPauses(points, perWindow);
      checkCuts(placed, streaming::harmlessPauses(points), perWindow);
      QVERIFY(placed.inCut < even.inCut);
      qInfo("M %zu: %zu pauses, %zu in the cut; evenly %zu, %zu in the cut", perWindow,
            placed.pauses(), placed.inCut, even.pauses(), even.inCut);
    }
  }
};

QTEST_APPLESS_MAIN(TestPausePlacement)
#include "tst_pause_placement.moc"
