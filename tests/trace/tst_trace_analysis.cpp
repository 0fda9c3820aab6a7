// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <QtTest>
#include <algorithm>
#include <cmath>

#include "base/file.h"
#include "base/random.h"
#include "gcode/program.h"
#include "support/test_program.h"
#include "trace/analysis/trace_analysis.h"
#include "trace/import/import.h"

using namespace rivulet;
using namespace rivulet::trace;

namespace {

const QString kGroundTruth = QStringLiteral(RIVULET_SOURCE_DIR "/../shared/groundtruth");

/// A motion at constant speed along straight lines.
/// @param change  of each sample
template <class Change>
void changeSamples(Motion& motion, const Change& change) {
  std::vector<MotionSample> samples(motion.samples.begin(), motion.samples.end());
  for (MotionSample& sample : samples) {
    change(sample);
  }
  motion.samples = MotionSamples(samples);
}

Motion motionAlong(const std::vector<base::Vec3>& corners, double mmPerS, double stepS) {
  Motion motion;
  motion.hasSet = true;
  motion.step = base::fromSeconds(stepS);
  double timeS = 0.0;
  double rest = 0.0;  // of the step before, mm
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const double length = base::distance(corners[i], corners[i + 1]);
    double at = rest;
    for (; at < length; at += mmPerS * stepS) {
      MotionSample sample;
      sample.at = base::Instant{base::fromSeconds(timeS)};
      sample.setMm = corners[i] + (at / length) * (corners[i + 1] - corners[i]);
      sample.pathMmPerS = mmPerS;
      motion.samples.push_back(sample);
      timeS += stepS;
    }
    rest = at - length;
  }
  MotionSample last;
  last.at = base::Instant{base::fromSeconds(timeS)};
  last.setMm = corners.back();
  last.pathMmPerS = mmPerS;
  motion.samples.push_back(last);
  return motion;
}

ProgramPath pathThrough(const std::vector<base::Vec3>& corners) {
  std::vector<gcode::StreamPoint> points;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    gcode::StreamPoint point;
    point.positionMm = corners[i];
    point.line.value = static_cast<std::uint32_t>(i);
    points.push_back(point);
  }
  return {points, corners.front()};
}

/// "executed 3 undecided 0 repeated 1 skipped 2 foreign 0, departs".
QString printed(const PathMatch& match) {
  return QStringLiteral("executed %1 undecided %2 repeated %3 skipped %4 foreign %5%6")
      .arg(match.executed)
      .arg(match.undecided)
      .arg(match.repeated)
      .arg(match.skipped)
      .arg(match.foreign)
      .arg(match.departure ? QStringLiteral(", departs") : QString());
}

const std::vector<base::Vec3> kZigzag{{0, 0, 0}, {10, 0, 0}, {10, 5, 0},
                                      {0, 5, 0}, {0, 10, 0}, {10, 10, 0}};

}  // namespace

class TestTraceAnalysis : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void followsThePath_data() {
    QTest::addColumn<double>("stepS");
    for (const double hz : {10.0, 50.0, 250.0, 1000.0, 4000.0}) {
      QTest::addRow("%g Hz", hz) << 1.0 / hz;
    }
  }
  void followsThePath() {
    QFETCH(double, stepS);
    const PathMatch match = matchPath(motionAlong(kZigzag, 10.0, stepS), pathThrough(kZigzag));
    QVERIFY(match.isFaultless());
    QCOMPARE(match.executed + match.undecided, std::size_t{5});
    QVERIFY(stepS > 0.01 || match.undecided == 0);
  }

  /// Between two samples, the motion may have gone to the tip and back, or not.
  void leavesOpenWhatSamplesDoNotShow() {
    const std::vector<base::Vec3> spike{{0, 0, 0}, {10, 0, 0}, {10, 3, 0}, {10, 0, 0}, {20, 0, 0}};
    const PathMatch match = matchPath(motionAlong(spike, 10.0, 1.0), pathThrough(spike));
    QVERIFY(match.isFaultless());
    QCOMPARE(printed(match),
             QStringLiteral("executed 3 undecided 1 repeated 0 skipped 0 foreign 0"));
  }

  /// The same places in the opposite direction, and twice.
  void followsAPathThatComesBack() {
    const std::vector<base::Vec3> there{{0, 0, 0}, {10, 0, 0}, {0, 0, 0}, {10, 0, 0}, {20, 0, 0}};
    const PathMatch match = matchPath(motionAlong(there, 10.0, 0.004), pathThrough(there));
    QCOMPARE(printed(match),
             QStringLiteral("executed 4 undecided 0 repeated 0 skipped 0 foreign 0"));
  }

  /// More often than courses are followed at a time.
  void followsAPathThatOverlapsItself_data() {
    QTest::addColumn<double>("lengthMm");
    QTest::newRow("lines over each other") << 10.0;
    QTest::newRow("corners in one place") << 0.2;
  }
  void followsAPathThatOverlapsItself() {
    QFETCH(double, lengthMm);
    std::vector<base::Vec3> there;
    for (int i = 0; i <= 400; ++i) {
      there.push_back({i % 2 == 0 ? 0.0 : lengthMm, 0.0, 0.0});
    }
    const PathMatch match =
        matchPath(motionAlong(there, 10.0, 0.002 * lengthMm), pathThrough(there));
    QCOMPARE(printed(match),
             QStringLiteral("executed 400 undecided 0 repeated 0 skipped 0 foreign 0"));
  }

  void findsFaults_data() {
    QTest::addColumn<QList<int>>("course");
    QTest::addColumn<QString>("expected");
    QTest::newRow("skipped") << QList<int>{0, 1, 3, 4, 5}
                             << "executed 4 undecided 0 repeated 0 skipped 1 foreign 0";
    QTest::newRow("two skipped") << QList<int>{0, 1, 4, 5}
                                 << "executed 3 undecided 0 repeated 0 skipped 2 foreign 0";
    QTest::newRow("repeated") << QList<int>{0, 1, 2, 3, 1, 2, 3, 4, 5}
                              << "executed 5 undecided 0 repeated 3 skipped 0 foreign 0";
    QTest::newRow("stopped in the middle")
        << QList<int>{0, 1, 2, 3} << "executed 3 undecided 0 repeated 0 skipped 0 foreign 0";
    QTest::newRow("elsewhere") << QList<int>{0, 1, 2, 6, 7, 2, 3, 4, 5}
                               << "executed 5 undecided 0 repeated 0 skipped 0 foreign 1";
    QTest::newRow("another program from there")
        << QList<int>{0, 1, 2, 6, 7, 8}
        << "executed 2 undecided 0 repeated 0 skipped 0 foreign 0, departs";
  }
  void findsFaults() {
    QFETCH(QList<int>, course);
    QFETCH(QString, expected);
    std::vector<base::Vec3> places = kZigzag;
    places.insert(places.end(), {{15, 8, 0}, {15, 2, 0}, {30, 2, 0}});
    std::vector<base::Vec3> corners;
    for (const int place : course) {
      corners.push_back(places[static_cast<std::size_t>(place)]);
    }
    const PathMatch match = matchPath(motionAlong(corners, 10.0, 0.004), pathThrough(kZigzag));
    QCOMPARE(printed(match), expected);
  }

  /// A rounded corner is not a skipped point, however wide.
  void roundingSkipsNothing() {
    const std::vector<base::Vec3> round{{0, 0, 0},  {9, 0, 0},  {9.7, 0.3, 0},
                                        {10, 1, 0}, {10, 5, 0}, {0, 5, 0}};
    const PathMatch match = matchPath(motionAlong(round, 10.0, 0.001),
                                      pathThrough({{0, 0, 0}, {10, 0, 0}, {10, 5, 0}, {0, 5, 0}}));
    QCOMPARE(printed(match),
             QStringLiteral("executed 3 undecided 0 repeated 0 skipped 0 foreign 0"));
  }

  void saysWhereAForeignProgramDeparts() {
    const PathMatch match = matchPath(
        motionAlong({{0, 0, 0}, {10, 0, 0}, {10, 5, 0}, {4, 5, 0}, {4, 30, 0}}, 10.0, 0.004),
        pathThrough(kZigzag));
    QVERIFY(match.departure.has_value());
    QCOMPARE(match.departure->line.value, 3U);
    QVERIFY(base::distance(match.departure->placeMm, {4.0, 5.0, 0.0}) < 0.2);
  }

  /// Whatever is nearest of all the path is among what is near, also where it is a corner of two
  /// segments, and all of that is near. The other way to find it looks at each segment.
  void nothingNearIsMissed() {
    constexpr double kRadiusMm = 0.5;
    base::Random random(1);
    const auto drawn = [&random](double mm) { return mm * (2.0 * random.uniform() - 1.0); };
    int found = 0;
    for (std::size_t corners = 2; corners < 300; corners += corners < 40 ? 1 : 37) {
      std::vector<base::Vec3> spiral;
      std::vector<base::Vec3> tangle;
      for (std::size_t i = 0; i < corners; ++i) {
        const double turn = 0.3 * static_cast<double>(i);
        const double radius = 5.0 + 0.03 * turn;
        spiral.push_back({radius * std::cos(turn), radius * std::sin(turn), 0.0});
        tangle.push_back({drawn(3.0), drawn(3.0), drawn(1.0)});
      }
      for (const auto& line : {spiral, tangle}) {
        const ProgramPath path = pathThrough(line);
        for (int place = 0; place < 60; ++place) {
          const base::Vec3 at{drawn(6.0), drawn(6.0), drawn(0.1)};
          const PathPlace nearest = path.nearest(at, 0.0, path.lengthMm());
          const std::vector<PathPlace> near = path.near(at, kRadiusMm);
          QVERIFY(std::ranges::is_sorted(near, {}, &PathPlace::segment));
          double leastMm = kRadiusMm;
          for (const PathPlace& one : near) {
            QVERIFY(one.distanceMm <= kRadiusMm);
            leastMm = std::min(leastMm, one.distanceMm);
          }
          QVERIFY(near.empty() == (nearest.distanceMm > kRadiusMm));
          QVERIFY(near.empty() || std::abs(leastMm - nearest.distanceMm) < 1e-9);
          found += near.empty() ? 0 : 1;
        }
      }
    }
    QVERIFY2(found > 500, qPrintable(QString::number(found)));
  }

  void measuresTheContourError() {
    Motion motion = motionAlong(kZigzag, 10.0, 0.004);
    motion.hasActual = true;
    changeSamples(motion, [](MotionSample& sample) {
      sample.actualMm = sample.setMm + base::Vec3{0.0, 0.02, 0.0};
    });
    const ProgramPath path = pathThrough(kZigzag);
    const PathMatch match = matchPath(motion, path);
    const MotionQuality quality = judgeMotion(motion, {}, &path, &match);
    QVERIFY(quality.setContour.maxMm < 1e-6);
    QVERIFY(std::abs(quality.actualContour.maxMm - 0.02) < 1e-6);
    QVERIFY(std::abs(quality.actualContour.leftMm - 0.02) < 1e-6);
    QVERIFY(std::abs(quality.actualContour.rightMm + 0.02) < 1e-6);
    QVERIFY(std::abs(quality.following[1].maxMm - 0.02) < 1e-6);
    QCOMPARE(quality.corners.size(), std::size_t{4});
  }

  /// Backlash of 10 µm beside a lag that grows with the speed.
  void tellsBacklashFromLag() {
    constexpr double kLagS = 0.002;
    constexpr double kBacklashMm = 0.01;
    Motion motion;
    motion.hasSet = motion.hasActual = true;
    motion.step = std::chrono::milliseconds{4};
    for (int i = 0; i < 1000; ++i) {
      const double atS = 0.004 * i;
      const double mmPerS = 40.0 * std::cos(2.0 * atS);
      MotionSample sample;
      sample.at = base::Instant{base::fromSeconds(atS)};
      sample.setMm.x = 20.0 * std::sin(2.0 * atS);
      sample.actualMm.x =
          sample.setMm.x - kLagS * mmPerS - std::copysign(0.5 * kBacklashMm, mmPerS);
      motion.samples.push_back(sample);
    }
    const MotionQuality quality = judgeMotion(motion, {}, nullptr, nullptr);
    QVERIFY(quality.following[0].reversalMm.has_value());
    QVERIFY(std::abs(*quality.following[0].reversalMm - kBacklashMm) < 1e-4);
    QVERIFY(!quality.following[1].reversalMm);
  }

  /// Programmed with 10 mm/s: a third of the path at 5 mm/s takes as long again.
  void measuresTheFeedKept() {
    constexpr double kStepS = 0.004;
    Motion motion = motionAlong({{0, 0, 0}, {20, 0, 0}}, 10.0, kStepS);
    const Motion slow = motionAlong({{20, 0, 0}, {30, 0, 0}}, 5.0, kStepS);
    for (MotionSample sample : slow.samples) {
      sample.at += base::fromSeconds(2.0);
      if (sample.at > motion.samples.back().at) {
        motion.samples.push_back(sample);
      }
    }
    motion.hasFeed = true;
    changeSamples(motion, [](MotionSample& sample) { sample.feedMmPerS = 10.0; });
    const FeedKept feed = judgeMotion(motion, {}, nullptr, nullptr).feed;
    QVERIFY(feed.known);
    QVERIFY2(std::abs(feed.share - 2.0 / 3.0) < 1e-3, qPrintable(QString::number(feed.share)));
    QVERIFY(std::abs(feed.programmedS - 3.0) < 1e-6);
    QVERIFY(std::abs(feed.motionS - 4.0) < 0.01);
    QVERIFY(std::abs(feed.slowS - 1.0) < 0.01);
  }

  /// A corner that is cut by a line from 1 mm before it to 1 mm after it.
  void measuresCorners() {
    Motion motion =
        motionAlong({{0, 0, 0}, {9, 0, 0}, {10, 1, 0}, {10, 5, 0}, {20, 5, 0}}, 10.0, 0.001);
    motion.hasSpeed = true;
    changeSamples(motion, [](MotionSample& sample) {
      sample.pathMmPerS = sample.setMm.y > 0.4 && sample.setMm.y < 0.6 ? 3.0 : 10.0;
    });
    const ProgramPath path = pathThrough({{0, 0, 0}, {10, 0, 0}, {10, 5, 0}, {20, 5, 0}});
    const PathMatch match = matchPath(motion, path);
    const MotionQuality quality = judgeMotion(motion, {}, &path, &match);
    QCOMPARE(quality.corners.size(), std::size_t{2});
    QVERIFY(std::abs(quality.corners[0].turnDeg - 90.0) < 1e-9);
    QVERIFY(std::abs(quality.corners[0].setMm - std::sqrt(0.5)) < 1e-6);
    QCOMPARE(quality.corners[0].mmPerSMin, 3.0);
    QVERIFY(quality.corners[1].setMm < 0.01);  // the samples are so far apart
  }

  /// Braking to zero between two samples is a stop, a missing sample in a shallow dip is none.
  void aGapIsNoStop_data() {
    QTest::addColumn<QList<double>>("mmPerS");
    QTest::addColumn<int>("gapSteps");
    QTest::addColumn<int>("stops");
    QTest::newRow("for a moment") << QList<double>{10, 10, 3, 3, 10, 10} << 1 << 1;
    QTest::newRow("dip") << QList<double>{10, 10, 7, 7, 10, 10} << 1 << 0;
    QTest::newRow("dip with a gap") << QList<double>{10, 10, 7, 7, 10, 10} << 8 << 0;
  }
  void aGapIsNoStop() {
    QFETCH(QList<double>, mmPerS);
    QFETCH(int, gapSteps);
    QFETCH(int, stops);
    constexpr double kStepS = 0.004;
    Motion motion;
    motion.hasSet = motion.hasSpeed = true;
    motion.step = base::fromSeconds(kStepS);
    double atS = 0.0;
    double xMm = 0.0;
    for (qsizetype i = 0; i < mmPerS.size(); ++i) {
      const double stepS = i == mmPerS.size() / 2 ? gapSteps * kStepS : kStepS;
      atS += stepS;
      xMm += stepS * mmPerS[i];
      MotionSample sample;
      sample.at = base::Instant{base::fromSeconds(atS)};
      sample.setMm.x = xMm;
      sample.pathMmPerS = mmPerS[i];
      motion.samples.push_back(sample);
    }
    QCOMPARE(static_cast<int>(findStandstills(motion).size()), stops);
  }

  /// Whatever lies between, a turn is that between the nearest samples that are far enough away.
  void findsTurnsWhereAToolTrembles() {
    base::Random random(21);
    Motion motion;
    motion.hasSet = motion.hasSpeed = true;
    motion.step = base::fromSeconds(0.004);
    MotionSample sample;
    std::vector<Standstill> stops;
    for (int i = 0; i < 6000; ++i) {
      sample.at = base::Instant{base::fromSeconds(0.004 * i)};
      const double stride = random.below(400) == 0 ? 1.0 : 0.004;  // seldom far away
      sample.setMm =
          sample.setMm + stride * base::Vec3{random.normal(), random.normal(), random.normal()};
      sample.setMm = i % 1500 == 0 ? base::Vec3{} : sample.setMm;
      sample.pathMmPerS = 1.0;
      motion.samples.push_back(sample);
      if (random.below(8) == 0) {
        Standstill stop;
        stop.start = sample.at;
        stop.placeMm = sample.setMm;
        stops.push_back(stop);
      }
    }
    findCauses(stops, motion, nullptr);
    MotionReader samples(motion.samples);
    const auto isFar = [&](std::size_t i, base::Vec3 place) {
      return base::distance(samples[i].setMm, place) > 0.05;
    };
    int turns = 0;
    for (const Standstill& stop : stops) {
      const std::size_t at = motion.samples.indexAt(stop.start);
      std::size_t before = at;
      while (before > 0 && !isFar(before - 1, stop.placeMm)) {
        --before;
      }
      std::size_t after = at;
      while (after < samples.size() && !isFar(after, stop.placeMm)) {
        ++after;
      }
      if (before == 0 || after == samples.size()) {
        QVERIFY(stop.cause == StopCause::Unknown);
        continue;
      }
      ++turns;
      const base::Vec3 in = stop.placeMm - samples[before - 1].setMm;
      const base::Vec3 out = samples[after].setMm - stop.placeMm;
      const double cosine = base::dot(in, out) / (base::norm(in) * base::norm(out));
      const double turn = std::acos(cosine) * 180.0 / std::acos(-1.0);
      QCOMPARE(stop.evidence,
               turn > 0.1 ? fmt::format("the path turns by {:.1f} degrees there", turn) : "");
    }
    QVERIFY(turns > 300);
  }

  /// The one that begins first of those that touch the stop, whatever else is between.
  void takesTheFirstEventThatTouches() {
    Motion motion = motionAlong(kZigzag, 10.0, 0.004);
    const auto at = [](double seconds) { return base::Instant{base::fromSeconds(seconds)}; };
    motion.notes = {{at(0.0), at(9.0), "note", ""},
                    {at(0.1), at(0.2), "hold", "early"},
                    {at(0.1), at(0.6), "dwell", "long"},
                    {at(0.3), at(0.31), "tool change", "short"},
                    {at(0.5), at(0.6), "hold", "late"}};
    std::vector<Standstill> stops(3);
    stops[0].start = at(0.15);
    stops[1].start = at(0.3);
    stops[2].start = at(0.9);
    findCauses(stops, motion, nullptr);
    QCOMPARE(stops[0].evidence, std::string("early"));
    QCOMPARE(stops[1].evidence, std::string("long"));
    QVERIFY(stops[1].cause == StopCause::Dwell);
    QVERIFY(stops[2].evidence.find("degrees") != std::string::npos || stops[2].evidence.empty());
  }

  /// A recording knows between which blocks of the program on the control there is a STOPRE.
  void tellsAStopreByTheProgram_data() {
    QTest::addColumn<QList<QPair<int, int>>>("continuations");
    QTest::addColumn<int>("before");
    QTest::addColumn<int>("after");
    QTest::addColumn<bool>("endsBlock");
    QTest::addColumn<QString>("evidence");
    const QList<QPair<int, int>> windows{{10, 11}, {20, 21}};
    QTest::newRow("next window, short")
        << windows << 11 << 20 << true << "has a STOPRE between line 11 and line 20";
    QTest::newRow("next window, full")
        << windows << 11 << 10 << true << "has a STOPRE between line 11 and line 10";
    QTest::newRow("next window of one point")
        << windows << 20 << 20 << true << "has a STOPRE between line 20 and line 20";
    QTest::newRow("within a block") << windows << 20 << 20 << false << "";
    QTest::newRow("within a window") << windows << 10 << 11 << true << "";
    QTest::newRow("over a block without a sample")
        << QList<QPair<int, int>>{{11, 12}, {12, 20}} << 11 << 20 << true << "";
    QTest::newRow("not recorded, back")
        << QList<QPair<int, int>>{} << 11 << 10 << true << "jumps from line 11 back to line 10";
    QTest::newRow("not recorded, on") << QList<QPair<int, int>>{} << 11 << 20 << true << "";
  }
  void tellsAStopreByTheProgram() {
    using Lines = QList<QPair<int, int>>;
    QFETCH(Lines, continuations);
    QFETCH(int, before);
    QFETCH(int, after);
    QFETCH(bool, endsBlock);
    QFETCH(QString, evidence);
    const auto line = [](int number) {
      return base::LineNumber{static_cast<std::uint32_t>(number)};
    };
    Recording recording;
    for (const auto& [from, to] : continuations) {
      recording.start.continuations.push_back({line(from), line(to)});
    }
    ControlTrace& trace = recording.controlTrace.emplace();
    const auto at = [](int step) { return base::Instant{std::chrono::milliseconds{4 * step}}; };
    double xMm = 0.0;
    for (int step = 0; step < 60; ++step) {
      const bool stands = step >= 20 && step < 40;
      xMm += stands ? 0.0 : 0.04;
      trace.samples.push_back({at(step),
                               {xMm, 0.0, 0.0},
                               {xMm, 0.0, 0.0},
                               stands ? 0.0 : 10.0,
                               line(step < 40 ? before : after)});
    }
    trace.blocks.push_back({at(0), at(endsBlock ? 20 : 59), line(before), {0.8, 0.0, 0.0}, 0.8});
    const std::vector<Standstill> stops = analyseTrace(Trace(recording)).stops;
    QCOMPARE(stops.size(), std::size_t{1});
    QCOMPARE(stopCauseName(stops[0].cause),
             std::string_view(evidence.isEmpty() ? "unknown" : "preprocessor stop"));
    QVERIFY2(QString::fromStdString(stops[0].evidence).endsWith(evidence),
             stops[0].evidence.c_str());
  }

  /// The recordings of another control: which stops there are is known from their programs.
  void agreesWithTheGroundTruth_data() {
    QTest::addColumn<QString>("trace");
    QTest::addColumn<QString>("program");
    QTest::addColumn<int>("stops");
    QTest::addColumn<double>("contourMmMax");
    const auto row = [](const char* trace, const char* program, int stops, double contourMmMax) {
      QTest::newRow(trace) << QString(trace) << QString(program) << stops << contourMmMax;
    };
    row("G1_g61_250hz", "G1_g61", 11, 0.001);
    row("G1_g64_250hz", "G1_g64", 0, 0.1);
    row("G3_g61_250hz", "G3_g61", 11, 0.001);
    row("corners_F3000_g61", "corners_F3000_g61", 12, 0.001);
    row("corners_F3000_g64p001", "corners_F3000_g64p001", 0, 0.0101);
    row("star5_F3000_g64p001", "star5_F3000_g64p001", 0, 0.0101);
  }
  void agreesWithTheGroundTruth() {
    QFETCH(QString, trace);
    QFETCH(QString, program);
    QFETCH(int, stops);
    QFETCH(double, contourMmMax);
    if (!QFileInfo::exists(kGroundTruth)) {
      QSKIP("the folder ../shared/groundtruth is not there");
    }
    const auto bytes = base::readFile((kGroundTruth + "/data/" + trace + ".csv.zst").toStdString());
    QVERIFY(bytes.has_value());
    const auto imported = importTrace(*bytes);
    QVERIFY(imported.has_value());
    gcode::LoadOptions loading;
    loading.chordToleranceMm = 0.0002;
    const auto loaded =
        gcode::loadProgram((kGroundTruth + "/programs/" + program + ".ngc").toStdString(), loading);
    QVERIFY(loaded.has_value());
    const TraceAnalysis analysis = analyseTrace(Trace(*imported), {&*loaded});
    QCOMPARE(static_cast<int>(analysis.stops.size()), stops);
    QVERIFY2(analysis.path.isFaultless(), qPrintable(printed(analysis.path)));
    QCOMPARE(analysis.path.executed, analysis.path.points);
    QVERIFY2(analysis.quality.setContour.maxMm <= contourMmMax,
             qPrintable(QString::number(analysis.quality.setContour.maxMm)));
    for (const Standstill& stop : analysis.stops) {
      QCOMPARE(stopCauseName(stop.cause), std::string_view("exact stop"));
    }
  }
};

RIVULET_TEST(TestTraceAnalysis)
#include "tst_trace_analysis.moc"
