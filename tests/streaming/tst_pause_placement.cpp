// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <algorithm>
#include <functional>
#include <limits>

#include "base/random.h"
#include "gcode/program.h"
#include "gcode/thinning.h"
#include "streaming/methods/pause_placement.h"
#include "streaming/recovery/resume.h"
#include "streaming/start/stop_bound.h"
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

/// Whether a window may have the points from its first to before its second argument.
using Fits = std::function<bool(std::size_t, std::size_t)>;

/// Every way to cut is tried.
std::pair<std::size_t, std::size_t> fewestByTrying(const std::vector<bool>& harmless,
                                                   std::size_t perWindow, const Fits& fits = {}) {
  std::pair<std::size_t, std::size_t> best{std::numeric_limits<std::size_t>::max(), 0};
  const std::function<void(std::size_t, std::size_t, std::size_t)> go = [&](std::size_t begin,
                                                                            std::size_t inCut,
                                                                            std::size_t windows) {
    if (begin == harmless.size()) {
      best = std::min(best, {inCut, windows});
      return;
    }
    for (std::size_t end = begin + 1; end <= std::min(begin + perWindow, harmless.size()); ++end) {
      if (!fits || fits(begin, end)) {
        go(end, inCut + (harmless[end - 1] ? 0U : 1U), windows + 1);
      }
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

  /// Of all ways in which no window of several moves takes too long, none is better.
  void noWindowTakesTooLong() {
    base::Random random(11);
    std::size_t alone = 0;
    for (int round = 0; round < 400; ++round) {
      auto points = drawPoints(random, 1 + random.below(12));
      for (gcode::StreamPoint& point : points) {
        point.feedMmPerS = random.below(3) == 0 ? 0.25 : 0.0;  // 4 s, and 1 s at the run's feed
      }
      streaming::WindowCut cut;
      cut.feedPerPoint = true;
      cut.secondsMax = 3.1;
      cut.feedMmPerS = 1.0;
      const auto takes = [&](std::size_t begin, std::size_t end) {
        double seconds = 0.0;
        for (std::size_t i = std::max<std::size_t>(begin, 1); i < end; ++i) {
          seconds += base::distance(points[i - 1].positionMm, points[i].positionMm) /
                     (points[i].feedMmPerS > 0.0 ? points[i].feedMmPerS : 1.0);
        }
        return seconds;
      };
      const auto fits = [&](std::size_t begin, std::size_t end) {
        return end - begin == 1 || takes(begin, end) <= cut.secondsMax;
      };
      const std::size_t perWindow = 1 + random.below(5);
      const std::vector<bool> harmless = streaming::harmlessPauses(points);
      for (const bool place : {true, false}) {
        cut.place = place;
        const PausePlacement placed = streaming::cutWindows(points, perWindow, cut);
        checkCuts(placed, harmless, perWindow);
        for (std::size_t window = 0; window < placed.windows(); ++window) {
          const std::size_t begin = placed.begins[window];
          const std::size_t end =
              window + 1 < placed.windows() ? placed.begins[window + 1] : points.size();
          QVERIFY(fits(begin, end));
          alone += begin > 0 && end - begin == 1 && takes(begin, end) > cut.secondsMax ? 1U : 0U;
        }
        if (place) {
          const auto best = fewestByTrying(harmless, perWindow, fits);
          QCOMPARE(placed.inCut, best.first);
          QCOMPARE(placed.windows(), best.second);
        }
      }
    }
    QVERIFY(alone > 100);
  }

  /// The worst case of a stop, by hand: 4 moves of 10 mm at 1 mm/s, then one of 40 mm.
  void theBoundOfAStop() {
    std::vector<gcode::StreamPoint> points;
    for (const double x : {10.0, 20.0, 30.0, 40.0, 80.0}) {
      gcode::StreamPoint point;
      point.positionMm = {x, 0.0, 0.0};
      point.line = {static_cast<std::uint32_t>(x)};
      points.push_back(point);
    }
    streaming::RunSettings settings;
    settings.parameters.pointsPerLoop = 7;
    settings.feedMmPerS = 1.0;
    settings.placePauses = false;
    const base::Vec3 tool{0.0, 5.0, 0.0};
    auto bound = streaming::stopBound(points, std::nullopt, settings);
    QCOMPARE(bound.seconds, 70.0);
    QCOMPARE(bound.mm, 70.0);
    QVERIFY(!bound.longMove);
    settings.windowSMax = 20.0;
    bound = streaming::stopBound(points, tool, settings);
    QCOMPARE(bound.seconds, 40.0);
    QVERIFY(bound.longMove && bound.longMove->line.value == 80);
    QCOMPARE(bound.longMove->seconds, 40.0);
    settings.windowSMax = 60.0;
    bound = streaming::stopBound(points, tool, settings);
    QVERIFY(bound.seconds > 41.1 && bound.seconds < 41.3);  // the way to the first point counts
    QVERIFY(!bound.longMove);
    // With credit three windows are executed after a stop.
    settings.parameters.method = base::MethodKind::Credit;
    settings.parameters.windowsAhead = 3;
    bound = streaming::stopBound(points, tool, settings);
    QVERIFY(bound.seconds > 81.1 && bound.seconds < 81.3);
    QVERIFY(bound.longMove && bound.longMove->line.value == 80);  // 20 s is its share
    // The methods of [P1] end at the end of their loop.
    settings.parameters.method = base::MethodKind::Position;
    settings.parameters.pointsPerLoop = 2;
    QCOMPARE(streaming::stopBound(points, std::nullopt, settings).seconds, 40.0);
  }

  /// Where a stop acts before the next window, no move takes longer than the limit, whatever its
  /// feed: without the division a move of 60 s would.
  void longMovesAreDivided() {
    gcode::Program program = *gcode::interpretProgram(
        "long.nc", "G0 X0 Y0 Z5\nG1 Z0 F60\nX60\nX300 F2400\nG0 Y900\nG1 X0 Y0 F600\nM30\n");
    const gcode::Trajectory whole = program.trajectory;
    streaming::RunSettings settings;
    settings.programFeeds = gcode::ProgramFeeds{1.0, 100.0, 40.0};
    for (const auto method : {base::MethodKind::Window, base::MethodKind::Credit}) {
      settings.parameters.method = method;
      for (const double limitS : {20.0, 5.0, 0.7}) {
        settings.windowSMax = limitS;
        program.trajectory = whole;
        const auto pointsNow = [&] {
          return gcode::streamPoints(program.trajectory, {0, 0, 5}, {}, &*settings.programFeeds)
              .points;
        };
        QVERIFY(streaming::stopBound(pointsNow(), {}, settings).longMove);
        QVERIFY(gcode::divideLongMoves(program.trajectory, streaming::moveRules(settings)));
        const auto bound = streaming::stopBound(pointsNow(), {}, settings);
        QVERIFY(!bound.longMove);
        QVERIFY(bound.seconds <= limitS * (1 + 1e-6));
      }
    }
    // With one feed for all moves, F 60: the way of 60 mm takes a minute.
    settings.parameters.method = base::MethodKind::Window;
    settings.programFeeds.reset();
    settings.feedMmPerS = 1.0;
    settings.windowSMax = 5.0;
    program.trajectory = whole;
    QVERIFY(gcode::divideLongMoves(program.trajectory, streaming::moveRules(settings)));
    QCOMPARE(program.trajectory.points.size(),
             std::size_t{1 + 1 + 12 + 48 + 180 + 190});  // the last is 948.7 mm long
    // The methods of [P1] stay as they are published.
    settings.parameters.method = base::MethodKind::Position;
    QCOMPARE(streaming::moveRules(settings).secondsMax, 0.0);
  }

  /// A run is resumed by the windows that it had, whatever feed and limit are set by then.
  void theCutIsKeptWithTheRun() {
    base::Random random(3);
    const auto points = drawPoints(random, 60);
    streaming::RunSettings settings;
    settings.feedMmPerS = 1.0;
    settings.windowSMax = 3.5;
    settings.placePauses = false;
    const auto had =
        streaming::cutWindows(points, static_cast<std::size_t>(settings.parameters.pointsPerLoop),
                              streaming::windowCut(settings));
    streaming::Checkpoint last;
    last.pausesPlaced = false;
    last.windowSMax = 3.5;
    last.windowFeedMmPerS = 1.0;
    for (const double feed : {1.0, 50.0}) {
      for (const double limit : {0.0, 3.5, 10.0}) {
        settings.feedMmPerS = feed;
        settings.windowSMax = limit;
        auto ends = streaming::windowEnds(points, settings, last);
        QCOMPARE(ends.back(), points.size());
        ends.pop_back();
        QCOMPARE(ends, had.begins);
      }
    }
    QVERIFY(had.windows() > 15);  // 9 without the limit
  }

  /// Only what has proved its feed cell, or needs none, has windows of any length.
  void whoseWindowsAreShortened() {
    using streaming::FeedProof;
    using templates::TargetControl;
    for (const FeedProof proof : {FeedProof::NotTested, FeedProof::OtherServer, FeedProof::Failed,
                                  FeedProof::WithoutMotion}) {
      QCOMPARE(streaming::windowSMaxOf(proof, TargetControl::Sinumerik, 5.0), 5.0);
      QVERIFY(!streaming::describe(proof).empty());
    }
    QCOMPARE(streaming::windowSMaxOf(FeedProof::Proved, TargetControl::Sinumerik, 5.0), 0.0);
    QCOMPARE(streaming::windowSMaxOf(FeedProof::NotTested, TargetControl::LinuxCnc, 5.0), 0.0);
    const opcua::ServerIdentity server{"urn:control", "Control", "4.95", "7"};
    const opcua::ServerIdentity other{"urn:control", "Control", "4.96", "7"};
    streaming::FeedTest test;
    test.server = server;
    test.result.checks = {{"actions-follow", true, ""}};
    QVERIFY(streaming::feedProof(std::nullopt, server, false) == FeedProof::NotTested);
    QVERIFY(streaming::feedProof(std::nullopt, server, true) == FeedProof::Proved);
    QVERIFY(streaming::feedProof(test, server, false) == FeedProof::WithoutMotion);
    test.result.move = streaming::AirMove{0, 20.0, 400.0};
    QVERIFY(streaming::feedProof(test, server, false) == FeedProof::Proved);
    QVERIFY(streaming::feedProof(test, other, false) == FeedProof::OtherServer);
    test.result.checks.front().passed = false;
    for (const bool isVirtual : {false, true}) {
      QVERIFY(streaming::feedProof(test, server, isVirtual) == FeedProof::Failed);
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
