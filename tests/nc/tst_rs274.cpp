// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <QTemporaryDir>
#include <QtTest>

#include "nc/rs274/judge.h"
#include "nc/rs274/rs274.h"
#include "support/test_program.h"

using namespace rivulet;

#define COMPARE_TEXT(actual, expected) \
  QCOMPARE(QByteArray::fromStdString(actual), QByteArray(expected))

/// LinuxCNC's interpreter as a judge of Rivulet's reader. `scripts/meaning` draws more programs.
class TestRs274 : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void drawnProgramsAreReadAlike();
  void wrongReadingsAreFound();
};

void TestRs274::initTestCase() {
  if (tests::Rs274::program().empty()) {
    QSKIP("rs274 of LinuxCNC is not installed.");
  }
}

void TestRs274::drawnProgramsAreReadAlike() {
  const QTemporaryDir folder;
  tests::JudgeOptions options;
  options.folder = folder.path().toStdString();
  const tests::Judgement judgement = tests::judge(options);
  std::string differences;
  for (const tests::Difference& each : judgement.examples) {
    differences += fmt::format("\nprogram {}, {}\n{}", each.number, each.kind, describe(each));
  }
  QVERIFY2(differences.empty(), differences.c_str());
  QVERIFY(judgement.equal > options.count / 2);
}

/// A judge that calls everything equal would be of no use.
void TestRs274::wrongReadingsAreFound() {
  const QTemporaryDir folder;
  tests::Rs274 rs274(folder.path().toStdString());
  const tests::PathReading right =
      rs274.read("G21 G90 G17\nG0 X10 Y0 Z0\nG3 X0 Y10 I-10 J0 F100\nG1 X0 A5\nM2\n");
  QVERIFY(right.accepted);
  QCOMPARE(right.moves.size(), std::size_t{3});
  QCOMPARE(compared(right, right).agreement, tests::Agreement::Equal);
  const auto judged = [&right](void (*change)(tests::PathReading&)) {
    tests::PathReading wrong = right;
    change(wrong);
    return compared(right, wrong).kind;
  };
  COMPARE_TEXT(judged([](tests::PathReading& read) { read.moves[0].endMm.x += 0.001; }),
               "another end");
  COMPARE_TEXT(judged([](tests::PathReading& read) { read.moves[0].form = tests::MoveForm::Feed; }),
               "another kind of move");
  COMPARE_TEXT(judged([](tests::PathReading& read) { read.moves[1].centreMm.y += 0.001; }),
               "another centre");
  COMPARE_TEXT(judged([](tests::PathReading& read) { read.moves[1].sweepRad += 0.001; }),
               "another turn");
  COMPARE_TEXT(judged([](tests::PathReading& read) {
                 read.moves[1].axis = {0, 0, -1};
               }),
               "another turn");
  COMPARE_TEXT(judged([](tests::PathReading& read) { read.moves[1].feedPerMin = 101.0; }),
               "another feed");
  COMPARE_TEXT(judged([](tests::PathReading& read) { read.moves[2].rotaryDeg[0] = 4.0; }),
               "another angle of a rotary axis");
  COMPARE_TEXT(judged([](tests::PathReading& read) { read.moves.pop_back(); }),
               "another number of moves");
  tests::PathReading refused = rs274.read("G0 X1 X2\nM2\n");
  QVERIFY(!refused.accepted);
  COMPARE_TEXT(refused.refusal, "Multiple x words on one line");
  QCOMPARE(compared(refused, right).agreement, tests::Agreement::Different);
}

RIVULET_TEST(TestRs274)
#include "tst_rs274.moc"
