// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QSignalSpy>
#include <QTest>

#include "base/units.h"
#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "widgets/common/theme.h"
#include "widgets/feasibility/feasibility_page.h"

using namespace rivulet;
using namespace rivulet::widgets;
using feasibility::SweepAxis;

class TestFeasibilityPage : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    test::failOnWarnings();
    applyTheme(Theme::Light);
  }

  void showsTheBordersOfTheMethod() {
    FeasibilityPage page;
    page.setModel(test::feasibilityModel(base::MethodKind::Position, 300.0));
    QSet<int> equations;
    for (const auto& border : page.chart(SweepAxis::PointDistance)->borders()) {
      equations.insert(static_cast<int>(border.equation));
      QVERIFY(!border.points.empty());
    }
    QVERIFY(equations.contains(static_cast<int>(feasibility::Equation::PointDistance)));
    QVERIFY(equations.contains(static_cast<int>(feasibility::Equation::Delta)));
    page.setModel(test::feasibilityModel(base::MethodKind::Signal, 300.0));
    equations.clear();
    for (const auto& border : page.chart(SweepAxis::PointsPerLoop)->borders()) {
      equations.insert(static_cast<int>(border.equation));
    }
    QVERIFY(equations.contains(static_cast<int>(feasibility::Equation::RealWindow)));
  }

  void draggingChangesFeedAndAbscissa_data() {
    QTest::addColumn<int>("axis");
    QTest::addColumn<bool>("position");
    QTest::newRow("d_min") << static_cast<int>(SweepAxis::PointDistance) << true;
    QTest::newRow("N") << static_cast<int>(SweepAxis::PointsPerLoop) << false;
    QTest::newRow("delta") << static_cast<int>(SweepAxis::Delta) << true;
  }
  void draggingChangesFeedAndAbscissa() {
    QFETCH(int, axis);
    QFETCH(bool, position);
    FeasibilityPage page;
    const auto model = test::feasibilityModel(
        position ? base::MethodKind::Position : base::MethodKind::Signal, 200.0);
    page.setModel(model);
    page.showChart(static_cast<SweepAxis>(axis));
    static_cast<void>(test::picture(page, {900, 600}));
    RegionChart* chart = page.chart(static_cast<SweepAxis>(axis));
    QSignalSpy requests(&page, &FeasibilityPage::operatingPointRequested);
    const QPoint from = chart->operatingPixel().toPoint();
    const QPoint to = from + QPoint(60, -40);
    QTest::mousePress(chart->viewport(), Qt::LeftButton, {}, from);
    QTest::mouseMove(chart->viewport(), to);
    QTest::mouseRelease(chart->viewport(), Qt::LeftButton, {}, to);
    QVERIFY(!requests.isEmpty());
    const auto point = requests.last().first().value<feasibility::OperatingPoint>();
    QVERIFY(point.feedMmPerS > model.operatingPoint.feedMmPerS);
    QCOMPARE(point.pointsPerLoop > model.operatingPoint.pointsPerLoop,
             static_cast<SweepAxis>(axis) == SweepAxis::PointsPerLoop);
    QCOMPARE(point.deltaMm > model.operatingPoint.deltaMm,
             static_cast<SweepAxis>(axis) == SweepAxis::Delta);
  }

  void draggingElsewhereDoesNothing() {
    FeasibilityPage page;
    page.setModel(test::feasibilityModel(base::MethodKind::Position, 200.0));
    static_cast<void>(test::picture(page, {900, 600}));
    RegionChart* chart = page.chart(SweepAxis::PointDistance);
    QSignalSpy requests(&page, &FeasibilityPage::operatingPointRequested);
    const QPoint away = chart->operatingPixel().toPoint() + QPoint(120, 0);
    QTest::mousePress(chart->viewport(), Qt::LeftButton, {}, away);
    QTest::mouseMove(chart->viewport(), away + QPoint(0, -40));
    QTest::mouseRelease(chart->viewport(), Qt::LeftButton, {}, away);
    page.setEditable(false);
    const QPoint from = chart->operatingPixel().toPoint();
    QTest::mousePress(chart->viewport(), Qt::LeftButton, {}, from);
    QTest::mouseMove(chart->viewport(), from + QPoint(0, -40));
    QTest::mouseRelease(chart->viewport(), Qt::LeftButton, {}, from);
    QCOMPARE(requests.count(), 0);
  }

  void rangesStandStillWhileDragging() {
    FeasibilityPage page;
    page.setModel(test::feasibilityModel(base::MethodKind::Position, 200.0));
    connect(&page, &FeasibilityPage::operatingPointRequested, &page,
            [&page](const feasibility::OperatingPoint& point) {
              auto model = test::feasibilityModel(base::MethodKind::Position, 200.0);
              model.operatingPoint = point;
              page.setModel(model);  // as the application answers
            });
    static_cast<void>(test::picture(page, {900, 600}));
    RegionChart* chart = page.chart(SweepAxis::PointDistance);
    const QPoint from = chart->operatingPixel().toPoint();
    QTest::mousePress(chart->viewport(), Qt::LeftButton, {}, from);
    const QPoint to = from + QPoint(0, -70);
    QTest::mouseMove(chart->viewport(), to);
    // The marker is where the finger is: the axis did not run away under it.
    QVERIFY(std::abs(chart->operatingPixel().y() - to.y()) < 4.0);
    QTest::mouseRelease(chart->viewport(), Qt::LeftButton, {}, to);
  }

  void speaksBothLanguages() {
    test::Language language;
    FeasibilityPage page;
    QVERIFY(test::visibleText(page).contains("Load a program"));
    page.setModel(test::feasibilityModel(base::MethodKind::Signal, 300.0));
    page.showChart(SweepAxis::Delta);
    QVERIFY(test::visibleText(page).contains("Method signal does not use δ"));
    language.german();
    QVERIFY(test::visibleText(page).contains("benutzt δ nicht"));
  }
};

Q_DECLARE_METATYPE(rivulet::feasibility::OperatingPoint)
QTEST_MAIN(TestFeasibilityPage)
#include "tst_feasibility_page.moc"
