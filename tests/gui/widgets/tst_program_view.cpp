// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <algorithm>
#include <cmath>

#include "gui/widgets/samples.h"
#include "overview/program_view.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::widgets;

namespace {

double distanceToLine(base::Vec3 point, base::Vec3 from, base::Vec3 to) {
  const base::Vec3 along = to - from;
  const double square = base::dot(along, along);
  const double share =
      square > 0.0 ? std::clamp(base::dot(point - from, along) / square, 0.0, 1.0) : 0.0;
  return base::distance(point, from + share * along);
}

/// A finishing spiral on a wavy surface with a rapid in the middle.
std::vector<gcode::StreamPoint> surface(std::size_t count) {
  std::vector<gcode::StreamPoint> points = test::manyPoints(count);
  for (gcode::StreamPoint& point : points) {
    point.positionMm.z = 2.0 * std::sin(0.3 * point.positionMm.x);
  }
  return points;
}

}  // namespace

class TestProgramView : public QObject {
  Q_OBJECT

 private slots:
  void linesEndAsOnTheControl_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QList<QByteArray>>("lines");
    QTest::newRow("empty") << QByteArray() << QList<QByteArray>{};
    QTest::newRow("lf") << QByteArray("G0\nG1\n") << QList<QByteArray>{"G0", "G1"};
    QTest::newRow("no end") << QByteArray("G0\nG1") << QList<QByteArray>{"G0", "G1"};
    QTest::newRow("crlf") << QByteArray("G0\r\n\r\nG1\r\n") << QList<QByteArray>{"G0", "", "G1"};
    QTest::newRow("cr") << QByteArray("G0\rG1\r") << QList<QByteArray>{"G0", "G1"};
    QTest::newRow("mixed") << QByteArray("a\n\rb\r\nc") << QList<QByteArray>{"a", "", "b", "c"};
    QTest::newRow("blank") << QByteArray("\n\n") << QList<QByteArray>{"", ""};
  }
  void linesEndAsOnTheControl() {
    QFETCH(QByteArray, text);
    QFETCH(QList<QByteArray>, lines);
    const std::string bytes = text.toStdString();
    const overview::TextIndex index(bytes);
    QCOMPARE(static_cast<qsizetype>(index.lines()), lines.size());
    std::size_t longest = 0;
    for (std::size_t i = 0; i < index.lines(); ++i) {
      const std::string_view line = index.line(bytes, i);
      QCOMPARE(QByteArray(line.data(), static_cast<qsizetype>(line.size())),
               lines[static_cast<qsizetype>(i)]);
      longest = std::max(longest, line.size());
    }
    QCOMPARE(index.longestBytes(), longest);
  }

  /// The index of a real program has the line numbers the interpreter counts.
  void linesAreThoseOfTheInterpreter() {
    for (const auto& program : {test::pocket(), test::brokenProgram()}) {
      QCOMPARE(overview::TextIndex(program->text).lines(), program->statistics.lines);
    }
  }

  void knowsUtf8FromLatin1() {
    QVERIFY(overview::isUtf8("plain"));
    QVERIFY(
        overview::isUtf8("gr\xC3\xB6\xC3\x9F"
                         "er \xE2\x82\xAC \xF0\x9F\x94\xA7"));
    for (const char* bad : {"gr\xF6\xDF"
                            "er",
                            "\xC3", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80",
                            "\xF5\x80\x80\x80", "\x80", "\xE2\x82"}) {
      QVERIFY2(!overview::isUtf8(bad), bad);
    }
    QVERIFY(!overview::TextIndex("(gr\xF6)\n").isUtf8());
    QVERIFY(overview::TextIndex("(gr\xC3\xB6)\n").isUtf8());
  }

  /// No point left out lies farther from the line drawn in its place than the level says.
  void levelsKeepTheirTolerance() {
    const auto points = surface(20'000);
    std::vector<bool> isRapid(points.size(), false);
    for (std::size_t i = 9000; i < 9100; ++i) {
      isRapid[i] = true;
    }
    const overview::PathLevels levels(points, isRapid);
    QVERIFY(levels.levels().size() >= 4);
    QCOMPARE(levels.levels().front().kept.size(), points.size());
    QVERIFY(levels.levels().back().kept.size() <= 2000);
    for (std::size_t l = 0; l < levels.levels().size(); ++l) {
      const overview::PathLevel& level = levels.levels()[l];
      QCOMPARE(level.kept.front(), 0U);
      QCOMPARE(level.kept.back(), static_cast<std::uint32_t>(points.size() - 1));
      QVERIFY(l == 0 || level.toleranceMm >= 2.0 * levels.levels()[l - 1].toleranceMm);
      double farthest = 0.0;
      for (std::size_t k = 1; k < level.kept.size(); ++k) {
        QVERIFY(level.kept[k] > level.kept[k - 1]);
        for (std::size_t i = level.kept[k - 1] + 1; i < level.kept[k]; ++i) {
          farthest = std::max(
              farthest, distanceToLine(points[i].positionMm, points[level.kept[k - 1]].positionMm,
                                       points[level.kept[k]].positionMm));
        }
      }
      QVERIFY2(farthest <= level.toleranceMm * (1.0 + 1e-12),
               qPrintable(QString("%1 > %2").arg(farthest).arg(level.toleranceMm)));
      // Where rapids begin and end there is a point.
      for (const std::uint32_t change : {8999U, 9099U}) {
        QVERIFY(std::binary_search(level.kept.begin(), level.kept.end(), change));
      }
    }
  }

  void boxesHoldTheirChunks() {
    const auto points = surface(3000);
    const overview::PathLevels levels(points, std::vector<bool>(points.size(), false));
    for (const overview::PathLevel& level : levels.levels()) {
      QCOMPARE(level.boxes.size(),
               (level.kept.size() - 1 + overview::kChunkMoves - 1) / overview::kChunkMoves);
      for (std::size_t k = 0; k < level.kept.size(); ++k) {
        const base::Vec3& place = points[level.kept[k]].positionMm;
        const overview::SpaceBox& box =
            level.boxes[std::min(k / overview::kChunkMoves, level.boxes.size() - 1)];
        for (const overview::SpaceBox& around : {box, levels.box()}) {
          for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
            const auto value = static_cast<float>(place[axis]);
            QVERIFY(value >= around.low[axis] && value <= around.high[axis]);
          }
        }
      }
    }
  }

  /// The picture of a box holds the pictures of its corners, and touches one on each side.
  void boxesInPicturesAreTight() {
    const overview::SpaceBox box{{-1.0F, 2.0F, -7.0F}, {4.0F, 3.0F, 0.5F}};
    for (const overview::Projection::Angles angles : {overview::Projection::Angles{},
                                                      overview::Projection::isometric(),
                                                      {0.0, 0.0},
                                                      {90.0, 0.0},
                                                      {-130.0, -35.0},
                                                      {200.0, 71.0}}) {
      const overview::Projection projection(angles);
      overview::PlaneBox corners{1e9, -1e9, 1e9, -1e9};
      for (unsigned corner = 0; corner < 8; ++corner) {
        base::Vec3 place;
        for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
          place.set(axis, ((corner >> axis) & 1U) != 0 ? box.high[axis] : box.low[axis]);
        }
        const overview::PlanePoint seen = projection(place);
        corners.widen({seen.right, seen.right, seen.up, seen.up});
      }
      const overview::PlaneBox whole = projection(box);
      for (const auto& [value, wanted] :
           {std::pair(whole.left, corners.left), std::pair(whole.right, corners.right),
            std::pair(whole.low, corners.low), std::pair(whole.high, corners.high)}) {
        QVERIFY2(std::abs(value - wanted) < 1e-9, qPrintable(QString::number(value - wanted)));
      }
    }
  }

  /// Nothing but changes between rapid and cut: the levels still become small.
  void pathsOfRapidsAndCutsBecomeSmall() {
    const auto points = test::manyPoints(50'000);
    std::vector<bool> isRapid(points.size());
    for (std::size_t i = 0; i < points.size(); i += 2) {
      isRapid[i] = true;
    }
    QVERIFY(overview::PathLevels(points, isRapid).levels().back().kept.size() <= 2000);
    QVERIFY(overview::PathLevels({}, {}).levels().empty());
    QCOMPARE(overview::PathLevels({points.front()}, {false}).levels().size(), std::size_t{1});
  }

  void theViewOfAProgramAgreesWithItsTrajectory() {
    const auto program = test::pocket();
    const auto view = overview::makeProgramView(program, {1.0, 2.0, 3.0}, 7);
    QVERIFY(view->program == program);
    QCOMPARE(view->points.points.size(), test::streamed(*program).size());
    for (std::size_t i = 0; i < view->points.points.size(); ++i) {
      const gcode::TrajectoryPoint& source = program->trajectory.points[view->trajectoryIndices[i]];
      QCOMPARE(view->points.points[i].kind, source.kind);
      QCOMPARE(view->programmedMmPerS(i), static_cast<float>(source.feedMmPerS));
      QCOMPARE(view->points.points[i].line.value, source.line.value);
    }
    QVERIFY(view->statistics.has_value());
    QCOMPARE(view->distances->windowSteps, 3);
    QCOMPARE(view->smallestDistancesMm.front(), view->distances->pointDistanceMmMin);
    QVERIFY(!view->dependsOnStart);
    double length = 0.0;
    for (std::size_t i = 1; i < view->points.points.size(); ++i) {
      length +=
          base::distance(view->points.points[i - 1].positionMm, view->points.points[i].positionMm);
    }
    const overview::KindLengths& lengths = view->lengths;
    QVERIFY(std::abs(lengths.rapidMm + lengths.lineMm + lengths.arcMm + lengths.splineMm - length) <
            1e-9);
    QVERIFY(lengths.arcMm > 0.0 && lengths.rapidMm > 0.0);
    QVERIFY(overview::makeProgramView(test::brokenProgram(), {}, 7)->points.points.size() >= 2);
  }

  /// What text and path show of a job: who executes which line, where the path is interrupted.
  void aJobKnowsItsParts() {
    const auto view = test::jobView();
    QVERIFY(view->isJob());
    const overview::JobOutline& outline = view->outline;
    QCOMPARE(outline.stretches(), std::size_t{3});
    QCOMPARE(outline.partLines(), (std::vector<std::size_t>{3, 5, 10, 11, 14, 18, 20}));
    QCOMPARE(outline.nativeAt(10)->reason, job::NativeReason::Coolant);
    QCOMPARE(outline.nativeAt(11), nullptr);
    QCOMPARE(outline.stretchAt(11)->number, 2);
    QCOMPARE(outline.stretchAt(12), nullptr);
    QCOMPARE(outline.partBeyond(10, true), std::size_t{11});
    QCOMPARE(outline.partBeyond(11, false), std::size_t{10});
    QCOMPARE(outline.partBeyond(20, true), std::size_t{0});
    QCOMPARE(outline.partBeyond(3, false), std::size_t{0});
    // All but the end of the program.
    QCOMPARE(outline.needed().size(), std::size_t{12});
    QCOMPARE(view->stretchStarts.size(), std::size_t{3});
    // Before the second stretch the control moves to a known place, before the third it does not.
    QCOMPARE(view->gaps.size(), std::size_t{2});
    QCOMPARE(view->gaps[0].point, view->stretchStarts[1]);
    QVERIFY(view->gaps[0].fromMm == (base::Vec3{60.0, 30.0, 5.0}));
    QCOMPARE(view->gaps[1].point, view->stretchStarts[2]);
    QVERIFY(!view->gaps[1].isKnown());
    QCOMPARE(view->toolChanges.size(), std::size_t{2});
    QCOMPARE(view->toolChanges[0].point, std::uint32_t{0});
    QCOMPARE(view->toolChanges[1].tool, std::string("2"));
    QCOMPARE(view->toolChanges[1].point, view->stretchStarts[2]);
    // Without the gaps: 5 + 7, 40 + 10, 7, 7, arc, 7.
    QCOMPARE(std::round(view->lengths.lineMm), 64.0);
  }

  /// A block for the control names where the path goes on: that is drawn, not where the tool is
  /// now.
  void placesNamedByNativeBlocksAreDrawn() {
    const std::string text =
        "G17 G90 G71\nT1 M6\nG54 G0 X60 Y30\nZ5\nG1 X70 F100\nG0 G53 Z0 D0\n"
        "T2 M6\nG54 G0 X-20 Y=IC(5)\nG1 Z-2 F100\nM30\n";
    auto made = job::makePlan("NAMED.MPF", text);
    QVERIFY(made && made->isWhole());
    const auto plan = std::make_shared<const job::Plan>(*std::move(made));
    const std::shared_ptr<const gcode::Program> program(plan, &plan->program);
    const auto view = overview::makeProgramView(program, {1.0, 2.0, 3.0}, 7, {}, {}, plan);
    QCOMPARE(view->stretchStarts.size(), std::size_t{2});
    const auto& points = view->points.points;
    QVERIFY(points[0].positionMm == (base::Vec3{60.0, 30.0, 5.0}));
    QVERIFY(points[1].positionMm == (base::Vec3{70.0, 30.0, 5.0}));
    // Of the increment only the control knows where it leads: it is drawn as no move.
    QCOMPARE(points[2].positionMm.x, -20.0);
    QCOMPARE(points[2].positionMm.y, 30.0);
    QCOMPARE(points[2].positionMm.z, -2.0);
    QVERIFY(view->dependsOnStart);
    QVERIFY(!view->gaps[0].isKnown());
  }

  /// Behind G43 the control alone knows Z until it is named: the stream leaves the axis where it
  /// is, and the view has the same moves.
  void anAxisThatIsForgottenStays() {
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Fanuc;
    options.units = gcode::FileUnits::Millimetres;
    auto read = gcode::interpretProgram(
        "O1.nc", "O1\nG90 G0 X0. Y0. Z10.\nG43 H1\nX0.\nX20.\nG1 Z5. F100\nM30\n", options);
    QVERIFY(read);
    const auto view = overview::makeProgramView(
        std::make_shared<const gcode::Program>(*std::move(read)), {1.0, 2.0, 3.0}, 7);
    const auto& points = view->points.points;
    QCOMPARE(points.size(), std::size_t{3});
    QVERIFY(points[1].positionMm == (base::Vec3{20.0, 0.0, 10.0}));
    QVERIFY(points[2].positionMm == (base::Vec3{20.0, 0.0, 5.0}));
    QVERIFY(view->dependsOnStart);
  }

  void toolsAreNamedAsTheProgramDoes() {
    const auto tool = [](const char* text) {
      job::NativeBlock block;
      block.text = text;
      return overview::toolOf(block);
    };
    QCOMPARE(tool("N10 T5 M6"), std::string("5"));
    QCOMPARE(tool("T=\"MILL_10\""), std::string("MILL_10"));
    QCOMPARE(tool("M6 T12 D1 ; T3"), std::string("12"));
    QCOMPARE(tool("TRANS X5"), std::string());
    QCOMPARE(tool("START M3 S100"), std::string());
    QCOMPARE(tool("T="), std::string());
  }

  void linesKnowTheirPoints() {
    auto program = std::make_shared<gcode::Program>();
    const std::vector<std::uint32_t> lines{1, 2, 3, 4, 2, 3, 4, 9};
    for (std::size_t i = 0; i < lines.size(); ++i) {
      gcode::TrajectoryPoint point;
      point.positionMm = {static_cast<double>(i), 0.0, 0.0};
      point.line = {lines[i]};
      program->trajectory.points.push_back(point);
    }
    // A loop runs lines 2 to 4 twice.
    const auto looped = overview::makeProgramView(program, {}, 2);
    QVERIFY(!looped->byLine.empty());
    QCOMPARE(looped->pointsOfLine({3}), (std::vector<std::uint32_t>{2, 5}));
    QCOMPARE(looped->pointsOfLine({9}), (std::vector<std::uint32_t>{7}));
    QVERIFY(looped->pointsOfLine({5}).empty());
    QVERIFY(looped->pointsOfLine({0}).empty());
    const auto pocket = overview::makeProgramView(test::pocket(), {}, 7);
    QVERIFY(pocket->byLine.empty());
    for (std::size_t i = 0; i < pocket->points.points.size(); i += 97) {
      const auto found = pocket->pointsOfLine(pocket->points.points[i].line);
      QVERIFY(std::find(found.begin(), found.end(), i) != found.end());
    }
  }

  void workCanBeGivenUp() {
    int asked = 0;
    QVERIFY(!overview::makeProgramView(test::pocket(), {}, 7, [&](double) { return ++asked < 2; }));
    QCOMPARE(asked, 2);
    double last = 0.0;
    QVERIFY(overview::makeProgramView(test::pocket(), {}, 7, [&](double share) {
      const bool grows = share >= last;
      last = share;
      return grows;
    }));
    QCOMPARE(last, 1.0);
  }
};

RIVULET_TEST(TestProgramView)
#include "tst_program_view.moc"
