// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QUrl>

#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "widgets/common/diagnostic_text.h"
#include "widgets/program/diagnostic_model.h"
#include "widgets/program/program_panel.h"

using namespace rivulet;
using namespace rivulet::widgets;

namespace {

QPushButton* button(const QWidget& parent, const QString& text) {
  for (QPushButton* candidate : parent.findChildren<QPushButton*>()) {
    if (candidate->text() == text) {
      return candidate;
    }
  }
  return nullptr;
}

}  // namespace

class TestProgramPanel : public QObject {
  Q_OBJECT

 private slots:
  void init() { test::failOnWarnings(); }

  void showsTheFiguresOfAProgram() {
    test::Language language;
    ProgramPanel panel;
    QVERIFY(test::visibleText(panel).contains("No program"));
    const auto program = test::pocket();
    const auto view = test::viewOf(program);
    panel.setProgram(view);
    panel.setDistances(view->distances);
    const QString text = test::visibleText(panel);
    QVERIFY(text.contains("POCKET_60x40.MPF"));
    QVERIFY(text.contains(QString::fromStdString(program->hash)));
    QVERIFY(text.contains("G3 2"));
    QVERIFY(text.contains(QString("-30.000 … 30.000") + QChar(0x00A0) + "mm"));
    QVERIFY(text.contains("(3 values)"));
    QVERIFY(text.contains(">lines "));
    QVERIFY(!text.contains("Cannot be streamed"));
    panel.setProgram(nullptr);
    QVERIFY(test::visibleText(panel).contains("No program"));
    QVERIFY(!test::visibleText(panel).contains(">lines "));
  }

  void listsFindings() {
    test::Language language;
    DiagnosticModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(model.rowCount(), 0);
    const auto program = test::brokenProgram();
    QVERIFY(!program->isStreamable());
    model.setRows(program->diagnostics);
    QCOMPARE(model.rowCount(), static_cast<int>(program->diagnostics.size()));
    QCOMPARE(model.index(0, DiagnosticModel::SeverityColumn).data().toString(), QString("Error"));
    QCOMPARE(model.index(0, DiagnosticModel::Line).data().toString(), QString("3"));
    QVERIFY(model.index(0, DiagnosticModel::Text).data().toString().contains("G87"));
    ProgramPanel panel;
    panel.setProgram(test::viewOf(program));
    QVERIFY(test::visibleText(panel).contains("Cannot be streamed"));
    // The sentence of the first finding stands there in full, and in the present language.
    QVERIFY(test::visibleText(panel).contains(diagnosticText(program->diagnostics.front())));
    language.german();
    QCOMPARE(model.index(0, DiagnosticModel::SeverityColumn).data().toString(), QString("Fehler"));
    QVERIFY(test::visibleText(panel).contains("Nicht streambar"));
    QVERIFY(test::visibleText(panel).contains(diagnosticText(program->diagnostics.front())));
    model.clear();
    QCOMPARE(model.rowCount(), 0);
  }

  void numbersOfLinesLeadToTheirPlace() {
    ProgramPanel panel;
    const auto view = test::viewOf(test::pocket());
    panel.setProgram(view);
    panel.setDistances(view->distances);
    QSignalSpy chosen(&panel, &ProgramPanel::lineChosen);
    int links = 0;
    for (QLabel* label : panel.findChildren<QLabel*>()) {
      const auto link = QRegularExpression("href=\"(\\d+)\"").match(label->text());
      if (link.hasMatch()) {
        Q_EMIT label->linkActivated(link.captured(1));
        QCOMPARE(chosen.last().first().value<std::size_t>(), link.captured(1).toULongLong());
        ++links;
      }
    }
    QCOMPARE(links, 3);  // d_min, d_min^N and the sharpest corner
    // A click on a finding does the same.
    panel.setProgram(test::viewOf(test::brokenProgram()));
    static_cast<void>(test::picture(panel, {420, 700}));
    auto* table = panel.findChild<QTableView*>();
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                      table->visualRect(table->model()->index(1, 1)).center());
    QCOMPARE(chosen.last().first().value<std::size_t>(),
             std::size_t{test::brokenProgram()->diagnostics[1].line.value});
  }

  void acceptsOnlyAfterAQuestion() {
    test::Language language;
    ProgramPanel panel;
    const auto program = test::brokenProgram();
    QVERIFY(!gcode::acceptableName(program->diagnostics.front()).empty());
    panel.setProgram(test::viewOf(program));
    panel.setReading(std::nullopt, {});
    static_cast<void>(test::picture(panel, {420, 700}));
    QSignalSpy accepted(&panel, &ProgramPanel::acceptRequested);
    QPushButton* accept = button(panel, "Accept…");
    QVERIFY(accept != nullptr && accept->isVisible());
    for (const bool agree : {false, true}) {
      QTest::mouseClick(accept, Qt::LeftButton);
      auto* box = panel.findChild<QMessageBox*>();
      QVERIFY(box != nullptr);
      QVERIFY(box->text().contains("G87"));
      QTest::mouseClick(
          agree ? button(*box, "Accept and read again") : box->button(QMessageBox::Cancel),
          Qt::LeftButton);
      QCoreApplication::sendPostedEvents(box, QEvent::DeferredDelete);
      QCOMPARE(accepted.count(), agree ? 1 : 0);
    }
    QCOMPARE(accepted.first().first().toString(), QString("G87"));
    // What was accepted is shown and can be taken back.
    QSignalSpy back(&panel, &ProgramPanel::takeBackRequested);
    panel.setReading(std::nullopt, {"G87", "CYCLE83"});
    QCoreApplication::processEvents();  // rows that come later are shown by a posted event
    QVERIFY(test::visibleText(panel).contains("Accepted: G87"));
    QVERIFY(test::visibleText(panel).contains("Accepted: CYCLE83"));
    QTest::mouseClick(button(panel, "Take back"), Qt::LeftButton);
    QTRY_COMPARE(back.count(), 1);
    QCOMPARE(back.first().first().toString(), QString("G87"));
    panel.setReading(std::nullopt, {});
    QVERIFY(!test::visibleText(panel).contains("Accepted"));
  }

  void centresAreReadAnotherWayOnDemand() {
    test::Language language;
    auto program = std::make_shared<gcode::Program>(*test::pocket());
    gcode::Diagnostic finding;
    finding.severity = gcode::Severity::Error;
    finding.line = {9};
    finding.code = gcode::DiagnosticCode::CentreReading;
    finding.argument = "absolute";
    program->diagnostics = {finding};
    program->facts.centreReading = gcode::CentreReading::Absolute;
    ProgramPanel panel;
    panel.setProgram(test::viewOf(program));
    panel.setReading(std::nullopt, {});
    static_cast<void>(test::picture(panel, {420, 700}));
    std::vector<gcode::CentreReading> wanted;
    connect(&panel, &ProgramPanel::centresRequested, this,
            [&](gcode::CentreReading centres) { wanted.push_back(centres); });
    QTest::mouseClick(button(panel, "Read it that way"), Qt::LeftButton);
    QCOMPARE(wanted.size(), std::size_t{1});
    QVERIFY(wanted.back() == gcode::CentreReading::Absolute);
    panel.setReading(std::nullopt, {}, gcode::CentreReading::Absolute);
    QCoreApplication::processEvents();
    QVERIFY(test::visibleText(panel).contains("I, J, K are read as the centre itself"));
    QTest::mouseClick(button(panel, "Take back"), Qt::LeftButton);
    QTRY_COMPARE(wanted.size(), std::size_t{2});
    QVERIFY(wanted.back() == gcode::CentreReading::AsProgrammed);
  }

  void directionsOfTheToolAreSaid() {
    test::Language language;
    auto program = std::make_shared<gcode::Program>(*test::pocket());
    gcode::Diagnostic finding;
    finding.severity = gcode::Severity::Warning;
    finding.line = {9};
    finding.code = gcode::DiagnosticCode::ToolDirections;
    finding.argument = "A3 B3 C3";
    program->diagnostics = {finding};
    QVERIFY(program->isUnderstood() && !program->isStreamable());
    ProgramPanel panel;
    panel.setProgram(test::viewOf(program));
    QVERIFY(test::visibleText(panel).contains("needs a transformation of the control"));
    // A text that moves nothing is shown as well.
    auto still = std::make_shared<gcode::Program>(
        gcode::interpretProgram("STILL.MPF", "G71\nM30\n").value_or(gcode::Program{}));
    panel.setProgram(test::viewOf(still));
    QVERIFY(test::visibleText(panel).contains("no axis moves"));
    QVERIFY(test::colourCount(test::picture(panel, {420, 700})) > 5);
  }

  void theDialectIsShownAndOrdered() {
    test::Language language;
    auto program = std::make_shared<gcode::Program>(*test::pocket());
    program->dialect = gcode::Dialect::Sinumerik;
    program->dialectEvidence = "CR=10";
    ProgramPanel panel;
    panel.setProgram(test::viewOf(program));
    panel.setReading(std::nullopt, {});
    QVERIFY(test::visibleText(panel).contains("Read as SINUMERIK because of \"CR=10\"."));
    auto* combo = panel.findChild<QComboBox*>();
    QCOMPARE(combo->count(), static_cast<int>(gcode::kDialects.size()) + 1);
    std::optional<gcode::Dialect> wanted;
    int asked = 0;
    connect(&panel, &ProgramPanel::dialectRequested, this,
            [&](const std::optional<gcode::Dialect>& dialect) {
              wanted = dialect;
              ++asked;
            });
    for (int index = 0; index < combo->count(); ++index) {
      combo->setCurrentIndex(index);
      Q_EMIT combo->activated(index);
      if (index > 0) {
        QCOMPARE(asked, index);
        QVERIFY(wanted == gcode::kDialects.at(static_cast<std::size_t>(index - 1)));
      }
    }
    QCOMPARE(asked, combo->count() - 1);  // as it is needs no order
    panel.setReading(gcode::Dialect::Sinumerik, {});
    QVERIFY(test::visibleText(panel).contains("as selected"));
    QCOMPARE(combo->currentIndex(), 1);
  }

  void timesAreShownWhenTheyAreKnown() {
    test::Language language;
    ProgramPanel panel;
    const auto view = test::viewOf(test::pocket());
    panel.setProgram(view);
    QVERIFY(test::visibleText(panel).contains("computing"));
    auto times = std::make_shared<overview::ProgramTimes>(*test::timesOf(*view));
    times->programmedS = 125.4;
    times->run->totalS = 3725.0;
    panel.setTimes(times);
    QVERIFY(test::visibleText(panel).contains(QString("2:05") + QChar(0x00A0) + "min"));
    QVERIFY(test::visibleText(panel).contains(QString("1:02:05") + QChar(0x00A0) + "h with 39"));
    panel.setProgram(view);
    QVERIFY(test::visibleText(panel).contains("computing"));
  }

  void asksForRecentAndDroppedFiles() {
    ProgramPanel panel;
    QSignalSpy opens(&panel, &ProgramPanel::openRequested);
    QSignalSpy drops(&panel, &ProgramPanel::fileDropped);
    panel.setRecentFiles({"/data/a.mpf", "/data/b.mpf"});
    const auto actions = panel.findChild<QMenu*>()->actions();
    QCOMPARE(actions.size(), 2);
    actions[1]->trigger();
    QCOMPARE(opens.count(), 1);
    QCOMPARE(opens.first().first().toString(), QString("/data/b.mpf"));

    QMimeData data;
    data.setUrls({QUrl("https://example.org/x.mpf"), QUrl::fromLocalFile("/data/c.mpf")});
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&panel, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&panel, &drop);
    QCOMPARE(drops.count(), 1);
    QCOMPARE(drops.first().first().toString(), QString("/data/c.mpf"));
  }

  void opensNothingWhileARunLasts() {
    ProgramPanel panel;
    panel.setRecentFiles({"/data/a.mpf"});
    panel.setOpenEnabled(false);
    for (const QPushButton* button : panel.findChildren<QPushButton*>()) {
      QVERIFY(!button->isEnabled());
    }
    QVERIFY(!panel.acceptDrops());
    panel.setOpenEnabled(true);
    for (const QPushButton* button : panel.findChildren<QPushButton*>()) {
      QVERIFY(button->isEnabled());
    }
  }
};

RIVULET_TEST(TestProgramPanel)
#include "tst_program_panel.moc"
