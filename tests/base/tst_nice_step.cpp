// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "base/nice_step.h"
#include "support/test_program.h"

using namespace rivulet::base;

class TestNiceStep : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void above() {
    QCOMPARE(niceStepAbove(1.0), 1.0);
    QCOMPARE(niceStepAbove(1.1), 2.0);
    QCOMPARE(niceStepAbove(0.03), 0.05);
    QCOMPARE(niceStepAbove(6000.0), 10000.0);
    // 0.1 + 0.2 is a little above 0.3: what is meant to be round stays.
    QCOMPARE(niceStepAbove((0.1 + 0.2) / 0.3 * 20.0), 20.0);
  }

  void below() {
    QCOMPARE(niceStepBelow(1.9), 1.0);
    QCOMPARE(niceStepBelow(4.9), 2.0);
    QCOMPARE(niceStepBelow(0.06), 0.05);
    QCOMPARE(niceStepBelow(1000.0), 1000.0);
  }

  void ceil() {
    QCOMPARE(niceCeil(93.0), 100.0);
    QCOMPARE(niceCeil(100.0), 100.0);
    QCOMPARE(niceCeil(101.0), 120.0);
  }

  void decimals() {
    QCOMPARE(decimalsOfStep(100.0), 0);
    QCOMPARE(decimalsOfStep(1.0), 0);
    QCOMPARE(decimalsOfStep(0.5), 1);
    QCOMPARE(decimalsOfStep(0.001), 3);
  }
};

RIVULET_TEST(TestNiceStep)
#include "tst_nice_step.moc"
