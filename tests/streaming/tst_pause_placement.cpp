// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <algorithm>
#include <functional>
#include <limits>

#include "base/random.h"
#include "gcode/program.h"
#include "streaming/methods/pause_placement.h"
#include "support/test_program.h"

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
        {{0, 0, 5}, {1}, MoveKind::Rapid},    {{0, 0, 2}, {2}, MoveKind::Rapid},
        {{0, 0, 0}, {3}, MoveKind::Feed},     {{1, 0, 0}, {4}, MoveKind::Feed},
        {{2, 0.2, 0}, {5}, MoveKind::Feed},   {{2.1, 1, 0}, {6}, MoveKind::Feed},
        {{2.2, 2, 0}, {7}, MoveKind::Feed},   {{2.3, 3, 0}, {8}, MoveKind::Rapid},
        {{2.3, 3.5, 0}, {9}, MoveKind::Feed}, {{2.3, 3.5, 1}, {10}, MoveKind::Feed},
        {{2.3, 3.5, 5}, {11}, MoveKind::Feed}};
    // Behind both rapids though the second goes straight on into the plunge, at the plunge's end,
    // at the corner, not where a rapid goes straight on from the cut, after that rapid, before
    // the retract, after it although it goes on, at the end.
    QCOMPARE(
        streaming::harmlessPauses(points),
        (std::vector<bool>{true, true, true, false, true, false, false, true, true, true, true}));
  }

  /// 45 degrees are a corner, whatever the last digit of the coordinates; less is none.
  void theAngleThatCounts() {
    for (const double stepMm : {1.0, 0.1, 1.0 / 3.0, 1e-3}) {
      for (const double aside : {1.0, 0.99, -1.0, -0.99}) {
        std::vector<gcode::StreamPoint> points{
            {{}, {1}}, {{stepMm, 0, 0}, {2}}, {{2 * stepMm, aside * stepMm, 0}, {3}}};
        QCOMPARE(streaming::harmlessPauses(points)[1], std::abs(aside) == 1.0);
      }
    }
  }

  /// As many as a run has (tst_main_window, tst_job), each where its method stops.
  void pausesOfTheMethods() {
    base::Random random(11);
    const auto points = drawPoints(random, 270);
    const std::vector<bool> harmless = streaming::harmlessPauses(points);
    const auto planned = [&](base::MethodKind method, std::size_t perLoop) {
      const auto pauses = streaming::plannedPauses(points, method, perLoop);
      for (const streaming::PlannedPause& pause : pauses) {
        if (pause.inCut == harmless[pause.point]) {
          qFatal("the kind of a pause is wrong");
        }
      }
      return pauses;
    };
    const auto position = planned(base::MethodKind::Position, 9);
    QCOMPARE(position.size(), std::size_t{29});
    QCOMPARE(position.front().point, 8U);
    const auto signal = planned(base::MethodKind::Signal, 7);
    QCOMPARE(signal.size(), std::size_t{77});
    QCOMPARE(signal[0].point, 2U);
    QCOMPARE(signal[1].point, 6U);
    const PausePlacement placed = streaming::placePauses(points, 7);
    const auto window = planned(base::MethodKind::Window, 7);
    QCOMPARE(window.size(), placed.pauses());
    QCOMPARE(streaming::pausesInCut(window), placed.inCut);
    for (std::size_t i = 0; i < window.size(); ++i) {
      QCOMPARE(std::size_t{window[i].point} + 1, placed.begins[i + 1]);
    }
    QVERIFY(streaming::plannedPauses({points.data(), 1}, base::MethodKind::Window, 7).empty());
  }
};

RIVULET_TEST(TestPausePlacement)
#include "tst_pause_placement.moc"
