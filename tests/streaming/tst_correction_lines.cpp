// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "streaming/run/correction_lines.h"
#include "support/test_program.h"

using namespace rivulet;
using base::Vec3;
using streaming::CorrectionLines;

class TestCorrectionLines : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void says_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<bool>("isKnown");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    const auto known = [](const char* line, double x, double y, double z) {
      QTest::newRow(line) << QByteArray(line) << true << x << y << z;
    };
    const auto unknown = [](const char* line) {
      QTest::newRow(line) << QByteArray(line) << false << 0.0 << 0.0 << 0.0;
    };
    known("X 0.01 Y -0.02", 0.01, -0.02, 0.0);
    known("x0.01 y-0.02 Z+3e-2\r", 0.01, -0.02, 0.03);
    known("  Z=0.5; X = 1 ", 1.0, 0.0, 0.5);
    known("{\"x\": 0.01, \"Y\":-0.02}", 0.01, -0.02, 0.0);
    known("{ \"z\" : 1e-3 }", 0.0, 0.0, 0.001);
    known("{\"x\": 1, \"z\": -2}", 1.0, 0.0, -2.0);
    known("", 0.0, 0.0, 0.0);
    known("# X 1", 0.0, 0.0, 0.0);
    for (const char* line : {"X",
                             "X X",
                             "X 1 2",
                             "X 0,5",
                             "X 1 X 2",
                             "A 1",
                             "1",
                             "X 1 Q 2",
                             "X nan",
                             "X inf",
                             "X -1e400",
                             "X 0.1mm",
                             "{}",
                             "{\"x\": }",
                             "{\"x\": 1",
                             "{\"x\": 1,}",
                             "{\"x\": \"1\"}",
                             "{\"a\": 1}",
                             "{\"x\": 1, \"x\": 2}",
                             "{\"x\" 1}",
                             "{\"x\": true}",
                             "{\"x\": -1e400}",
                             "{\"x\": {\"y\": 1}}",
                             "[1, 2]",
                             "{\"x\": 1} X 2"}) {
      unknown(line);
    }
  }
  void says() {
    QFETCH(QByteArray, line);
    QFETCH(bool, isKnown);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    CorrectionLines lines;
    const bool says = lines.add(line.toStdString() + "\n");
    QCOMPARE(lines.unknownCount(), isKnown ? std::size_t{0} : std::size_t{1});
    QCOMPARE(lines.valueMm(), (Vec3{x, y, z}));
    QCOMPARE(says, lines.valueMm() != Vec3{});
  }

  void linesMayComeInAnyPieces() {
    const std::string text = "X 0.25 Y 1\nwhat?\n\nY 2\n{\"z\": 3}\nX 4\nno\n";
    for (std::size_t piece = 1; piece <= text.size(); ++piece) {
      CorrectionLines lines;
      for (std::size_t at = 0; at < text.size(); at += piece) {
        lines.add(std::string_view(text).substr(at, piece));
      }
      QCOMPARE(lines.valueMm(), (Vec3{4.0, 2.0, 3.0}));
      QCOMPARE(lines.firstUnknown(), std::size_t{2});
      QCOMPARE(lines.unknownCount(), std::size_t{2});
    }
  }

  /// What has no line end yet says nothing; a line without an end takes no room.
  void unfinishedLines() {
    CorrectionLines lines;
    QVERIFY(!lines.add("X 0.1"));
    QCOMPARE(lines.valueMm(), Vec3{});
    QVERIFY(lines.finishLine());
    QCOMPARE(lines.valueMm().x, 0.1);
    for (int i = 0; i < 1000; ++i) {
      QVERIFY(!lines.add(std::string(1000, '1')));
    }
    QVERIFY(!lines.finishLine());
    QCOMPARE(lines.unknownCount(), std::size_t{1});
    QVERIFY(lines.add("Y 0.2\n"));
    QCOMPARE(lines.valueMm(), (Vec3{0.1, 0.2, 0.0}));
  }
};

RIVULET_TEST(TestCorrectionLines)
#include "tst_correction_lines.moc"
