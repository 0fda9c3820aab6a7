// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "widgets/common/theme.h"
#include "widgets/feasibility/advice_panel.h"
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

  /// At 1024x768 both axes of the chart and what stands below it are in sight without scrolling,
  /// also if the window was larger before.
  void fitsASmallWindow() {
    test::Language language;
    FeasibilityPage page;
    page.setModel(test::feasibilityModel(base::MethodKind::Signal, 300.0));
    static_cast<void>(test::picture(page, {1400, 900}));
    QVERIFY2(page.heightForWidth(880) <= 540,
             qPrintable(QString::number(page.heightForWidth(880))));
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

  /// With the feeds of the program, chart, sliders and advice have the override in %.
  void feedsOfTheProgramGoByTheOverride() {
    test::Language language;
    FeasibilityPage page;
    auto model = test::feasibilityModel(base::MethodKind::Window, 20000.0);
    model.scale.fullFeedMmPerS = base::mmPerSFromMmPerMin(40000.0);
    model.limitedBy = QStringLiteral("83 % (line 214)");
    model.verdict->feasible = model.verdict->waits = true;
    model.verdict->feedMmPerSMax = base::mmPerSFromMmPerMin(33200.0);
    page.setModel(model);
    page.showChart(SweepAxis::PointsPerLoop);
    static_cast<void>(test::picture(page, {1000, 640}));
    const QString text = test::visibleText(page);
    QVERIFY2(!text.contains("mm/min"), qPrintable(text));
    QVERIFY2(text.contains("50\u00A0%") && text.contains("83\u00A0%") && text.contains("line 214"),
             qPrintable(text));
    RegionChart* chart = page.chart(SweepAxis::PointsPerLoop);
    QSignalSpy requests(&page, &FeasibilityPage::operatingPointRequested);
    const QPoint from = chart->operatingPixel().toPoint();
    const QPoint to = from + QPoint(0, -40);
    QTest::mousePress(chart->viewport(), Qt::LeftButton, {}, from);
    QTest::mouseMove(chart->viewport(), to);
    QTest::mouseRelease(chart->viewport(), Qt::LeftButton, {}, to);
    QVERIFY(!requests.isEmpty());
    const auto point = requests.last().first().value<feasibility::OperatingPoint>();
    const double percent = 100.0 * point.feedMmPerS / model.scale.fullFeedMmPerS;
    QVERIFY2(percent > 55.0 && percent <= 200.0 && std::abs(percent - std::round(percent)) < 1e-9,
             qPrintable(QString::number(percent)));
    feasibility::Advice advice;
    advice.kind = feasibility::AdviceKind::PointsPerLoop;
    advice.before = advice.after = model.operatingPoint;
    advice.after.pointsPerLoop = 9;
    advice.feedMmPerSMaxBefore = base::mmPerSFromMmPerMin(33200.0);
    advice.feedMmPerSMaxAfter = base::mmPerSFromMmPerMin(43600.0);
    page.advice()->setAdvice({advice});
    static_cast<void>(test::picture(page, {1000, 640}));
    QVERIFY2(test::visibleText(page).contains("N 9 instead of 7: largest override 83 → 109\u00A0%"),
             qPrintable(test::visibleText(page)));
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

  void asksForAGridAroundTheOperatingPoint() {
    FeasibilityPage page;
    auto* button = page.findChild<QPushButton*>();
    QVERIFY(!button->isEnabled());  // no program
    const auto model = test::feasibilityModel(base::MethodKind::Position, 200.0);
    page.setModel(model);
    static_cast<void>(test::picture(page, {900, 600}));
    QVERIFY(button->isEnabled());
    for (const SweepAxis axis :
         {SweepAxis::PointDistance, SweepAxis::PointsPerLoop, SweepAxis::Delta}) {
      page.showChart(axis);
      QSignalSpy requests(&page, &FeasibilityPage::simulationRequested);
      QTest::mouseClick(button, Qt::LeftButton);
      QCOMPARE(requests.count(), 1);
      const auto wanted = requests.first().first().value<SimulationWanted>();
      QVERIFY(wanted.axis == axis);
      QVERIFY(wanted.abscissas.size() >= 5 && wanted.feedsMmPerS.size() >= 5);
      QVERIFY(std::is_sorted(wanted.abscissas.begin(), wanted.abscissas.end()));
      const double own = axis == SweepAxis::PointDistance ? model.distances.pointDistanceMmMin
                         : axis == SweepAxis::Delta
                             ? model.operatingPoint.deltaMm
                             : static_cast<double>(model.operatingPoint.pointsPerLoop);
      QVERIFY(std::count(wanted.abscissas.begin(), wanted.abscissas.end(), own) == 1);
      QVERIFY(wanted.feedsMmPerS.front() > 0.0);
      QVERIFY(wanted.feedsMmPerS.front() < model.operatingPoint.feedMmPerS);
      QVERIFY(wanted.feedsMmPerS.back() > model.operatingPoint.feedMmPerS);
    }
    page.setEditable(false);
    QVERIFY(!button->isEnabled());
  }

  void progressAndCancel() {
    FeasibilityPage page;
    page.setModel(test::feasibilityModel(base::MethodKind::Position, 200.0));
    page.setSimulationProgress(40);
    static_cast<void>(test::picture(page, {900, 600}));
    const auto buttons = page.findChildren<QPushButton*>();
    QCOMPARE(buttons.size(), 2);
    QVERIFY(!buttons[0]->isVisible() && buttons[1]->isVisible());
    QCOMPARE(page.findChild<QProgressBar*>()->value(), 40);
    QSignalSpy cancels(&page, &FeasibilityPage::simulationCancelRequested);
    QTest::mouseClick(buttons[1], Qt::LeftButton);
    QCOMPARE(cancels.count(), 1);
    page.setSimulationProgress(std::nullopt);
    QVERIFY(buttons[0]->isVisible() && !buttons[1]->isVisible());
  }

  /// What was simulated holds for its method, N and δ; each point has its own feed.
  void staleRegionsAreDropped() {
    FeasibilityPage page;
    auto model = test::feasibilityModel(base::MethodKind::Position, 200.0);
    page.setModel(model);
    const auto show = [&](SweepAxis axis) {
      page.setRegion(test::simulatedRegion(model, page.chart(axis)->simulationWanted(), 250.0));
      QVERIFY(page.chart(axis)->region());
    };
    const auto has = [&](SweepAxis axis) { return page.chart(axis)->region().has_value(); };
    show(SweepAxis::PointDistance);
    show(SweepAxis::PointsPerLoop);
    show(SweepAxis::Delta);
    model.operatingPoint.feedMmPerS *= 1.5;
    page.setModel(model);
    QVERIFY(has(SweepAxis::PointDistance) && has(SweepAxis::PointsPerLoop) &&
            has(SweepAxis::Delta));
    model.operatingPoint.deltaMm *= 2.0;
    page.setModel(model);
    QVERIFY(!has(SweepAxis::PointDistance) && !has(SweepAxis::PointsPerLoop));
    QVERIFY(has(SweepAxis::Delta));
    model.operatingPoint.pointsPerLoop += 2;
    page.setModel(model);
    QVERIFY(!has(SweepAxis::Delta));
    show(SweepAxis::Delta);
    page.clearRegions();
    QVERIFY(!has(SweepAxis::Delta));
    // A result that comes after the operating point has changed is not shown at all.
    auto late =
        test::simulatedRegion(model, page.chart(SweepAxis::Delta)->simulationWanted(), 250.0);
    late.operatingPoint.method = base::MethodKind::Signal;
    page.setRegion(late);
    QVERIFY(!has(SweepAxis::Delta));
  }

  void simulatedPointsAreDrawnAndNamed() {
    FeasibilityPage page;
    const auto model = test::feasibilityModel(base::MethodKind::Position, 200.0);
    page.setModel(model);
    page.showChart(SweepAxis::Delta);
    const QImage before = test::picture(page, {900, 600});
    page.setRegion(
        test::simulatedRegion(model, page.chart(SweepAxis::Delta)->simulationWanted(), 250.0));
    const QImage after = test::picture(page, {900, 600});
    for (const QColor& color : RegionChart::pointColors(page.palette())) {
      const auto count = [&color](const QImage& image) {
        int pixels = 0;
        for (int y = 0; y < image.height(); ++y) {
          for (int x = 0; x < image.width(); ++x) {
            pixels += image.pixelColor(x, y) == color ? 1 : 0;
          }
        }
        return pixels;
      };
      QVERIFY(count(after) > count(before) + 100);
    }
    QVERIFY(test::visibleText(page).contains("200 points"));
  }

  void adviceIsOneClick() {
    test::Language language;
    FeasibilityPage page;
    const auto model = test::feasibilityModel(base::MethodKind::Signal, 200.0);
    page.setModel(model);
    AdvicePanel* panel = page.advice();
    panel->setBusy();
    QVERIFY(test::visibleText(*panel).contains("Looking for better settings"));
    const auto list = test::advice(model);
    QVERIFY(list.size() >= 2);
    panel->setAdvice(list);
    static_cast<void>(test::picture(page, {1000, 640}));
    QVERIFY(test::visibleText(*panel).contains(AdvicePanel::adviceText(list.front())));
    const auto byN = std::find_if(list.begin(), list.end(), [](const feasibility::Advice& one) {
      return one.kind == feasibility::AdviceKind::PointsPerLoop;
    });
    QVERIFY(byN != list.end());
    const QString sentence = AdvicePanel::adviceText(*byN);
    QVERIFY2(sentence.contains(QStringLiteral("instead of 7: largest feed")), qPrintable(sentence));
    QSignalSpy wanted(&page, &FeasibilityPage::operatingPointRequested);
    const auto buttons = panel->findChildren<QPushButton*>();
    QCOMPARE(static_cast<std::size_t>(buttons.size()), std::min<std::size_t>(list.size(), 6));
    QTest::mouseClick(buttons[byN - list.begin()], Qt::LeftButton);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted[0][0].value<feasibility::OperatingPoint>().pointsPerLoop,
             byN->after.pointsPerLoop);
    panel->setAdvice({});
    QVERIFY(test::visibleText(*panel).contains("No single change"));
    page.setEditable(false);
    for (const QSlider* slider : panel->findChildren<QSlider*>()) {
      QVERIFY(!slider->isEnabled());
    }
  }

  /// While a slider is held, nothing is set; the verdict on what is under the finger is asked for,
  /// and an answer that comes too late is not shown.
  void slidersAskForTheVerdictUnderTheFinger() {
    FeasibilityPage page;
    const auto model = test::feasibilityModel(base::MethodKind::Signal, 200.0);
    page.setModel(model);
    static_cast<void>(test::picture(page, {1000, 640}));
    AdvicePanel* panel = page.advice();
    QSignalSpy turned(panel, &AdvicePanel::turnRequested);
    QSignalSpy wanted(&page, &FeasibilityPage::operatingPointRequested);
    auto* points = panel->findChildren<QSlider*>().first();
    points->setSliderDown(true);
    points->setSliderPosition(9);
    QCOMPARE(turned.count(), 1);
    const auto under = turned[0][0].value<feasibility::OperatingPoint>();
    QCOMPARE(under.pointsPerLoop, 9);
    QCOMPARE(under.feedMmPerS, model.operatingPoint.feedMmPerS);
    QCOMPARE(wanted.count(), 0);
    QVERIFY(test::visibleText(*panel).contains("Judging"));
    feasibility::Verdict verdict = *model.verdict;
    verdict.feasible = false;
    verdict.feedMmPerSMax = base::mmPerSFromMmPerMin(123.0);
    panel->setTurned(model.operatingPoint, verdict);
    QVERIFY(test::visibleText(*panel).contains("Judging"));
    panel->setTurned(under, verdict);
    QVERIFY(test::visibleText(*panel).contains("Not feasible: largest feed 123"));
    points->setSliderDown(false);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted[0][0].value<feasibility::OperatingPoint>().pointsPerLoop, 9);
  }

  void speaksBothLanguages() {
    test::Language language;
    FeasibilityPage page;
    QVERIFY(test::visibleText(page).contains("Load a program"));
    page.setModel(test::feasibilityModel(base::MethodKind::Signal, 300.0));
    page.showChart(SweepAxis::Delta);
    QVERIFY(test::visibleText(page).contains("This method does not use δ"));
    language.german();
    QVERIFY(test::visibleText(page).contains("benutzt δ nicht"));
  }
};

Q_DECLARE_METATYPE(rivulet::feasibility::OperatingPoint)
Q_DECLARE_METATYPE(rivulet::widgets::SimulationWanted)
RIVULET_TEST(TestFeasibilityPage)
#include "tst_feasibility_page.moc"
