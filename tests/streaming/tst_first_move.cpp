// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The straight way to a first point through what the program cuts is told from one that is clear.

#include <QtTest>
#include <vector>

#include "gcode/program.h"
#include "streaming/start/first_move.h"
#include "support/test_program.h"

using namespace rivulet;

class TestFirstMove : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void waysOfATool_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QVector<double>>("toolMm");
    QTest::addColumn<bool>("passesCut");
    // A pocket from X0 to X50, 5 mm deep, with rapids at Z20.
    const QString pocket =
        QStringLiteral("G0 X0 Y0 Z20\nG1 Z-5 F500\nX50\nY30\nX0\nY0\nG0 Z20\nM30\n");
    QTest::newRow("above the part") << pocket << QVector<double>{25, 10, 25} << false;
    QTest::newRow("in the cut") << pocket << QVector<double>{25, 10, -5} << true;
    QTest::newRow("in the cut below the first point")
        << pocket << QVector<double>{0, 0, -5} << false;
    QTest::newRow("beside the part, away from it")
        << pocket << QVector<double>{-20, -10, -5} << false;
    QTest::newRow("beside the part, on its other side")
        << pocket << QVector<double>{60, 40, -30} << true;
    // What follows a first move in X and Y comes too late.
    const QString level =
        QStringLiteral("G0 X0 Y0\nZ20\nG1 Z-5 F500\nX50\nY30\nX0\nY0\nG0 Z20\nM30\n");
    QTest::newRow("aside in the cut, then up") << level << QVector<double>{25, 10, -5} << true;
    QTest::newRow("up first") << QStringLiteral("G0 Z20\nX0 Y0\nG1 Z-5 F500\nX50\nY30\nM30\n")
                              << QVector<double>{25, 10, -5} << false;
    // A path that is level has nothing below its cut.
    QTest::newRow("on the level of the path")
        << QStringLiteral("G1 X0 Y0 Z0 F500\nX50\nY30\nX0\nM30\n") << QVector<double>{25, 10, 0}
        << false;
    QTest::newRow("below the level of the path")
        << QStringLiteral("G1 X0 Y0 Z0 F500\nX50\nY30\nX0\nM30\n") << QVector<double>{25, 10, -2}
        << true;
    QTest::newRow("only rapids") << QStringLiteral("G0 X0 Y0 Z0\nX50\nY30\nM30\n")
                                 << QVector<double>{25, 10, -2} << false;
  }
  void waysOfATool() {
    QFETCH(QString, program);
    QFETCH(QVector<double>, toolMm);
    QFETCH(bool, passesCut);
    const base::Vec3 tool{toolMm[0], toolMm[1], toolMm[2]};
    const auto read = gcode::interpretProgram("part.nc", program.toStdString());
    QVERIFY(read.has_value());
    const auto points = gcode::streamPoints(read->trajectory, tool).points;
    const base::Vec3 first = streaming::firstPlace(read->trajectory, tool);
    const auto cut = streaming::cutOnTheWay(tool, first, streaming::cutOf(points));
    QCOMPARE(cut.has_value(), passesCut);
    if (cut) {  // what the program leaves open is left there when the tool is higher, too
      QVERIFY(cut->isClearFromAbove);
    }
  }

  /// Above the height that is told, the way is clear.
  void theHeightIsEnough() {
    const auto read = gcode::interpretProgram(
        "part.nc", "G0 X0 Y0 Z20\nZ2\nG1 Z-5 F500\nX50 Z-2\nY30\nX0 Z-5\nG0 Z20\nM30\n");
    const auto points = gcode::streamPoints(read->trajectory, {}).points;
    const streaming::CutBox box = streaming::cutOf(points);
    const auto cut = streaming::cutOnTheWay({25, 10, -5}, points.front().positionMm, box);
    QVERIFY(cut.has_value());
    QCOMPARE(cut->heightMm, 2.0);
    QVERIFY(cut->isClearFromAbove);
    QVERIFY(!streaming::cutOnTheWay({25, 10, cut->heightMm}, points.front().positionMm, box));
    QVERIFY(!streaming::cutOnTheWay({25, 10, -5}, {25, 10, cut->heightMm}, box));
  }

  /// A program whose first point is in the cut is not reached from above.
  void raisingDoesNotAlwaysHelp() {
    const auto read =
        gcode::interpretProgram("part.nc", "G1 X0 Y0 Z-5 F500\nX50\nY30\nZ20\nX0 Y0 Z-5\nM30\n");
    const auto points = gcode::streamPoints(read->trajectory, {}).points;
    const auto cut =
        streaming::cutOnTheWay({25, 10, -5}, points.front().positionMm, streaming::cutOf(points));
    QVERIFY(cut && !cut->isClearFromAbove);
  }

  /// One move, in Z alone.
  void theToolIsRaised() {
    const gcode::Program raise = streaming::raiseProgram(22.5);
    QVERIFY(raise.isStreamable());
    const auto points = gcode::streamPoints(raise.trajectory, {7, 8, -5}).points;
    QCOMPARE(points.size(), std::size_t{1});
    QCOMPARE(points.front().positionMm, (base::Vec3{7, 8, 22.5}));
  }
};

RIVULET_TEST(TestFirstMove)
#include "tst_first_move.moc"
