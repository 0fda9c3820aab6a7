// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>

#include "papers/experiment.h"
#include "papers/figures.h"
#include "support/test_program.h"

using namespace rivulet::papers;

class TestFigures : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void statistics() {
    const std::vector<double> values{4.0, 1.0, 3.0, 2.0};
    QCOMPARE(meanOf(values), 2.5);
    QVERIFY(std::abs(deviationOf(values) - std::sqrt(5.0 / 3.0)) < 1e-12);
    QCOMPARE(medianOf(values), 2.0);
    QCOMPARE(quantileOf(values, 0), 1.0);
    QCOMPARE(quantileOf(values, 1000), 4.0);
    QCOMPARE(deviationOf({7.0}), 0.0);
  }

  void wilsonInterval() {
    const Share none = shareOf(0, 100);
    QCOMPARE(none.seen, 0.0);
    QCOMPARE(none.low, 0.0);
    QVERIFY(std::abs(none.high - 0.0370) < 1e-4);
    const Share half = shareOf(50, 100);
    QVERIFY(std::abs(half.low - 0.4038) < 1e-4 && std::abs(half.high - 0.5962) < 1e-4);
    QCOMPARE(shareOf(0, 0).high, 1.0);
  }

  void checksKnowTheirRange() {
    Check check{"x", "ms", "", 10.0, 11.0, 9.0, 12.0};
    QVERIFY(check.passed());
    QVERIFY(std::abs(check.deviation() - 0.1) < 1e-12);
    check.ours = 12.1;
    QVERIFY(!check.passed());
    check.ours = std::nan("");
    QVERIFY(!check.passed());
    Experiment experiment;
    experiment.checks = {check};
    QVERIFY(!experiment.passed());
  }
};

RIVULET_TEST(TestFigures)
#include "tst_figures.moc"
