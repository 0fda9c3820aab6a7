// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QAbstractItemModelTester>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <cmath>

#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "widgets/common/theme.h"
#include "widgets/plots/chart_style.h"
#include "widgets/plots/envelope_series.h"
#include "widgets/plots/time_plot.h"
#include "widgets/plots/time_window.h"
#include "widgets/trace/pause_model.h"
#include "widgets/trace/trace_page.h"

using namespace rivulet;
using namespace rivulet::widgets;

class TestTracePage : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    test::failOnWarnings();
    applyTheme(Theme::Light);
  }

  void seriesKeepTheExtremesAndTheGaps() {
    EnvelopeSeries series;
    QVERIFY(series.lines(0.0, 1.0, 10).empty());
    for (int index = 0; index < 100'000; ++index) {
      series.append(index * 0.001, index == 50'000 ? 99.0 : std::sin(index * 0.01));
    }
    const auto lines = series.lines(0.0, 100.0, 200);
    QCOMPARE(lines.size(), std::size_t{1});
    QVERIFY(lines[0].size() <= 2 * 200 + 2);
    QVERIFY(std::any_of(lines[0].begin(), lines[0].end(),
                        [](QPointF point) { return point.y() == 99.0; }));
    series.append(100.0, std::nan(""));
    series.append(101.0, 1.0);
    QCOMPARE(series.lines(0.0, 102.0, 200).size(), std::size_t{2});
    // A sample that comes late is put where the line stands, never before it.
    series.append(50.0, 2.0);
    QCOMPARE(series.lines(100.5, 102.0, 50).back().back().x(), 101.0);
  }

  void windowFollowsUntilTheOperatorLooksBack() {
    TimeWindow window;
    QSignalSpy changes(&window, &TimeWindow::changed);
    window.setEnd(100.0);
    QVERIFY(window.isLive());
    QCOMPARE(window.toS(), 100.0);
    window.pan(-20.0);
    QVERIFY(!window.isLive());
    const double to = window.toS();
    window.setEnd(110.0);
    QCOMPARE(window.toS(), to);
    window.goLive();
    QCOMPARE(window.toS(), 110.0);
    const double from = window.fromS();
    const double middle = (window.fromS() + window.toS()) / 2.0;
    window.zoom(0.5, middle);
    QVERIFY(window.fromS() > from);
    QCOMPARE((window.fromS() + window.toS()) / 2.0, middle);
    for (int step = 0; step < 100; ++step) {
      window.zoom(0.5, middle);
    }
    QVERIFY(window.toS() - window.fromS() >= 0.0199);
    window.showAll();
    QCOMPARE(window.fromS(), 0.0);
    QCOMPARE(window.toS(), 110.0);
    QVERIFY(changes.count() > 4);
  }

  void manySamplesMakeFewRedraws() {
    TimeWindow window;
    TimePlot plot(&window);
    static_cast<void>(test::picture(plot, {600, 200}));
    QSignalSpy redraws(&plot, &TimePlot::redrawn);
    for (int index = 0; index < 10'000; ++index) {
      plot.append(index * 0.004, index);
      window.setEnd(index * 0.004);
    }
    QCOMPARE(redraws.count(), 0);  // a redraw never happens inside an append
    QTRY_COMPARE(redraws.count(), 1);
    QVERIFY(test::settle(plot));
    QCOMPARE(redraws.count(), 1);
  }

  void pausesAreListed() {
    test::Language language;
    PauseModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.append({base::Instant{std::chrono::milliseconds{1500}}, std::chrono::milliseconds{41},
                  trace::PauseOrigin::Inferred});
    QCOMPARE(model.index(0, PauseModel::Start).data().toString(),
             QString("1.500") + QChar(0x00A0) + "s");
    QCOMPARE(model.index(0, PauseModel::Duration).data().toString(),
             QString("41") + QChar(0x00A0) + "ms");
    QCOMPARE(model.index(0, PauseModel::Origin).data().toString(), QString("I (inferred)"));
    language.german();
    QCOMPARE(model.index(0, PauseModel::Origin).data().toString(), QString("A (abgeleitet)"));
    model.clear();
    QCOMPARE(model.rowCount(), 0);
  }

  void showsLiveSamplesThenTheControlsTrace() {
    test::Language language;
    TracePage page;
    QVERIFY(test::visibleText(page).contains("No samples yet"));
    page.append({0.0, base::Vec3{1.0, 2.0, 3.0}, 8.0});
    page.append({0.1, std::nullopt, 8.0});
    QVERIFY(test::visibleText(page).contains("Live samples"));
    page.addPause({base::Instant{std::chrono::milliseconds{50}}, std::chrono::milliseconds{40},
                   trace::PauseOrigin::Inferred});
    auto* table = page.findChild<QTableView*>();
    QCOMPARE(table->model()->rowCount(), 1);
    const auto trace = test::controlTrace(0.9);
    const auto pauses = test::pausesOf(*trace);
    page.showControlTrace(trace, pauses);
    QVERIFY(test::visibleText(page).contains("The control's own trace"));
    QVERIFY(test::visibleText(page).contains(QString("every 4") + QChar(0x00A0) + "ms"));
    QCOMPARE(table->model()->rowCount(), static_cast<int>(pauses.size()));
    // The trace's own clock began at 1 s: what is shown begins at 0.
    const double first = base::toSeconds(pauses.front().start) - 1.0;
    QCOMPARE(table->model()->index(0, PauseModel::Start).data().toString(),
             QString::number(first, 'f', 3) + QChar(0x00A0) + "s");
    page.clear();
    QCOMPARE(table->model()->rowCount(), 0);
    QVERIFY(test::visibleText(page).contains("No samples yet"));
  }

  void aMissingTraceKeepsTheLiveSamples() {
    test::Language language;
    TracePage page;
    page.append({0.0, base::Vec3{}, 8.0});
    page.showControlTrace(nullptr, {});
    QVERIFY(test::visibleText(page).contains("Live samples"));
  }

  void liveButtonTellsWhetherItIsLive() {
    TracePage page;
    for (int index = 0; index < 1000; ++index) {
      page.append({index * 0.1, base::Vec3{}, 8.0});
    }
    auto* live = page.findChildren<QPushButton*>().first();
    QVERIFY(live->isChecked());
    auto* all = page.findChildren<QPushButton*>().at(1);
    all->click();
    QVERIFY(!live->isChecked());
    live->click();
    QVERIFY(live->isChecked());
    live->click();
    QVERIFY(live->isChecked());
  }
};

RIVULET_TEST(TestTracePage)
#include "tst_trace_page.moc"
