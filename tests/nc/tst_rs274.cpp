// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QTemporaryDir>
#include <QtTest>

#include "nc/rs274/judge.h"
#include "nc/rs274/rs274.h"
#include "support/test_program.h"

using namespace rivulet;

/// LinuxCNC's interpreter as a judge of Rivulet's reader. `scripts/meaning` draws more programs.
class TestRs274 : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void drawnProgramsAreReadAlike();
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
  for (const tests::Difference& each : judgement.examples) {
    QFAIL(("program " + std::to_string(each.number) + ", " + each.kind + "\n" + describe(each))
              .c_str());
  }
  QVERIFY(judgement.equal > options.count / 2);
}

RIVULET_TEST(TestRs274)
#include "tst_rs274.moc"
