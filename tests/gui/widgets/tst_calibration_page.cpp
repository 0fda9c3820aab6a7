// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <optional>

#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "widgets/calibration/calibration_charts.h"
#include "widgets/calibration/calibration_models.h"
#include "widgets/calibration/calibration_page.h"
#include "widgets/common/theme.h"

using namespace rivulet;
using namespace rivulet::widgets;

namespace {

QPushButton* buttonOf(const CalibrationPage& page, const char* text) {
  for (QPushButton* button : page.findChildren<QPushButton*>()) {
    if (button->text() == QLatin1String(text)) {
      return button;
    }
  }
  return nullptr;
}

/// The box that confirms the R-parameters.
QCheckBox* confirmOf(const CalibrationPage& page) {
  for (QCheckBox* box : page.findChildren<QCheckBox*>()) {
    if (box->text().contains(QLatin1String("may be written"))) {
      return box;
    }
  }
  return nullptr;
}

}  // namespace

class TestCalibrationPage : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    test::failOnWarnings();
    applyTheme(Theme::Light);
  }

  /// Nothing is written before the R-parameters are confirmed; others are not; nor is the next time.
  void asksForTheCells() {
    test::Language language;
    CalibrationPage page;
    static_cast<void>(test::picture(page, {780, 640}));
    QPushButton* start = buttonOf(page, "Calibrate");
    QCheckBox* confirm = confirmOf(page);
    QVERIFY(start != nullptr && confirm != nullptr);
    QVERIFY(!start->isEnabled());
    QVERIFY(test::visibleText(page).contains("Confirm the R-parameters"));
    QVERIFY(confirm->text().contains("R50 to R99"));
    confirm->click();
    QVERIFY(start->isEnabled());
    auto plan = page.plan();
    plan.firstCell = 90;
    page.setPlan(plan);
    QVERIFY(!confirm->isChecked() && !start->isEnabled());
    QVERIFY(confirm->text().contains("R90 to R99"));
    confirm->click();
    page.setBlocked("busy");
    QVERIFY(!start->isEnabled());
    QVERIFY(test::visibleText(page).contains("busy"));
    page.setBlocked({});
    QVERIFY(start->isEnabled());

    std::optional<streaming::CalibrationPlan> ordered;
    connect(&page, &CalibrationPage::calibrationRequested, &page,
            [&ordered](const streaming::CalibrationPlan& wanted) { ordered = wanted; });
    start->click();
    QVERIFY(ordered.has_value());
    QCOMPARE(ordered->firstCell, 90);
    QCOMPARE(ordered->lastCell, 99);
    QCOMPARE(ordered->shots, 500);
    QVERIFY(ordered->budget == std::chrono::minutes{10});
    QVERIFY(ordered->arrays);
    QVERIFY(!confirm->isChecked() && !start->isEnabled());
    plan.lastCell = 80;
    page.setPlan(plan);
    confirmOf(page)->click();
    QVERIFY(!start->isEnabled());
  }

  /// The time before the start, and what is left of it.
  void tellsTheTime() {
    test::Language language;
    CalibrationPage page;
    static_cast<void>(test::picture(page, {780, 640}));
    streaming::CalibrationPlan plan;
    plan.firstCell = 0;
    plan.lastCell = 9;
    plan.shots = 500;
    plan.budget = std::chrono::minutes{2};
    page.setPlan(plan);
    QVERIFY2(test::visibleText(page).contains("Takes about 2:0"),
             qPrintable(test::visibleText(page)));
    streaming::CalibrationProgress progress;
    progress.phase = streaming::CalibrationProgress::Phase::Shots;
    progress.share = 0.25;
    progress.left = std::chrono::seconds{90};
    progress.shotsMade = 700;
    progress.shotsPlanned = 2800;
    page.setProgress(progress);
    QVERIFY(!buttonOf(page, "Calibrate")->isVisible());
    QPushButton* cancel = buttonOf(page, "Cancel");
    QVERIFY(cancel->isVisible());
    QVERIFY(test::visibleText(page).contains("700 of 2,800 shots"));
    QVERIFY(test::visibleText(page).contains("left"));
    QVERIFY(!page.findChild<QSpinBox*>()->isEnabled());
    QSignalSpy cancelled(&page, &CalibrationPage::cancelRequested);
    cancel->click();
    QCOMPARE(cancelled.count(), 1);
    page.setProgress(std::nullopt);
    QVERIFY(buttonOf(page, "Calibrate")->isVisible());
    QVERIFY(!cancel->isVisible());
  }

  void showsWhatWasMeasured() {
    test::Language language;
    CalibrationPage page;
    static_cast<void>(test::picture(page, {780, 640}));
    QVERIFY(test::visibleText(page).contains("not calibrated"));
    const auto record = test::calibrationRecord();
    page.setRecord(record, false);
    QVERIFY(test::visibleText(page).contains("Calibrated:"));
    QVERIFY(test::visibleText(page).contains("SINUMERIK OPC UA 3.2 SP1 117"));
    QVERIFY(test::visibleText(page).contains("reduced numbers are bold"));
    auto* series = page.findChild<SeriesModel*>();
    auto* fits = page.findChild<FitModel*>();
    QCOMPARE(series->rowCount(), static_cast<int>(record->calibration.series.size()));
    QCOMPARE(fits->rowCount(), 8);
    auto* histogram = page.findChild<HistogramChart*>();
    for (const int row : {0, 7, series->rowCount() - 1}) {
      page.showSpread(row);
      QCOMPARE(histogram->series()->nodes,
               record->calibration.series[static_cast<std::size_t>(row)].nodes);
      QVERIFY(!histogram->legend().empty());
    }
    page.setRecord(record, true);
    QVERIFY(test::visibleText(page).contains("Outdated, not used"));
    page.setRecord(nullptr, false);
    QCOMPARE(series->rowCount(), 0);
    QVERIFY(!histogram->series());
    QVERIFY(histogram->legend().empty());
  }

  /// Figures in the operator's language; where there were too few shots stands no percentile.
  void tablesSayWhatIsKnown() {
    test::Language language;
    SeriesModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    FitModel fits;
    QAbstractItemModelTester fitTester(&fits,
                                       QAbstractItemModelTester::FailureReportingMode::QtTest);
    const auto record = test::calibrationRecord();
    model.setSeries(record->calibration.series, record->calibration.plan.shots);
    fits.setRows(record->calibration.fits);
    const auto text = [&model](int row, int column) {
      return model.index(row, column).data().toString();
    };
    bool cut = false;
    for (int row = 0; row < model.rowCount(); ++row) {
      const streaming::AccessSeries& series = model.row(row);
      QCOMPARE(text(row, SeriesModel::Cells), QString::number(series.nodes));
      QCOMPARE(text(row, SeriesModel::P99) == QStringLiteral("\u2013"), series.shotsMade < 100);
      QCOMPARE(text(row, SeriesModel::P999), QStringLiteral("\u2013"));
      const bool fewer = series.shotsMade < record->calibration.plan.shots;
      QCOMPARE(model.index(row, SeriesModel::Shots).data(Qt::FontRole).isValid(), fewer);
      cut = cut || fewer;
    }
    QVERIFY(cut);
    language.german();
    QVERIFY(text(0, SeriesModel::Mean).contains(QLatin1Char(',')));
    QCOMPARE(text(0, SeriesModel::Form), QStringLiteral("Liste"));
    QCOMPARE(model.headerData(SeriesModel::P999, Qt::Horizontal, Qt::DisplayRole).toString(),
             QStringLiteral("99,9 %"));
  }

  void theSourceIsSaid() {
    test::Language language;
    AccessSource source;
    const auto textOf = [&source](double ms) {
      return accessSourceText(source, base::fromMilliseconds(ms));
    };
    QVERIFY(textOf(4.3).text.contains("is assumed"));
    QVERIFY(textOf(4.3).text.contains("4.30"));
    source.record = test::calibrationRecord();
    source.form = opcua::Grouping::ArrayCount;
    source.cellsMax = 24;
    QVERIFY(textOf(0.35).text.contains("calibrated on"));
    QVERIFY(textOf(0.35).text.contains("array, by count"));
    QVERIFY(textOf(0.35).text.contains("writes of 24 R-parameters"));
    QVERIFY(!textOf(0.35).text.contains("R-parameters were measured"));
    source.cellsMax = 63;
    QVERIFY(textOf(0.35).text.contains("Up to 50 R-parameters were measured"));
    source.isOutdated = true;
    QVERIFY(textOf(4.3).status == Status::Attention);
    QVERIFY(textOf(4.3).text.contains("not used"));
  }
};

RIVULET_TEST(TestCalibrationPage)
#include "tst_calibration_page.moc"
