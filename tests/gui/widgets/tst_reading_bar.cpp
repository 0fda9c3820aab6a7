// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The bar asks what a program leaves open, one question at a time, and tells the answer on.

#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "gui/widgets/page_test.h"
#include "support/test_program.h"
#include "widgets/program/reading_bar.h"

using namespace rivulet;
using namespace rivulet::widgets;

namespace {

std::shared_ptr<const gcode::Program> programOf(const char* text,
                                                const gcode::LoadOptions& options = {}) {
  return std::make_shared<gcode::Program>(
      gcode::interpretProgram("part.txt", text, options).value());
}

QPushButton* button(const ReadingBar& bar, const QString& text) {
  for (QPushButton* each : bar.findChildren<QPushButton*>()) {
    if (!each->isHidden() && each->text() == text) {
      return each;
    }
  }
  return nullptr;
}

}  // namespace

class TestReadingBar : public QObject {
  Q_OBJECT

 private slots:
  void init() { test::failOnWarnings(); }

  void asksNothingOfWhatIsSaid() {
    test::Language language;
    ReadingBar bar;
    QVERIFY(bar.isHidden());
    bar.setProgram(programOf("O1\nG21 G90\nG0 X10. Y20.\nX5.\nM30\n"));
    QVERIFY(bar.isHidden());
    bar.setProgram(nullptr);
    QVERIFY(bar.isHidden());
  }

  void asksForTheUnitFirst() {
    test::Language language;
    ReadingBar bar;
    bar.setProgram(programOf("O1\nG90\nG0 X10000 Y20000\nX5000\nM30\n"));
    QVERIFY(!bar.isHidden());
    QVERIFY(test::visibleText(bar).contains("mm or inch"));
    QSignalSpy chosen(&bar, &ReadingBar::unitsChosen);
    button(bar, "inch")->click();
    QCOMPARE(chosen.size(), 1);
    QCOMPARE(chosen.last().first().value<gcode::FileUnits>(), gcode::FileUnits::Inches);
    button(bar, "mm")->click();
    QCOMPARE(chosen.last().first().value<gcode::FileUnits>(), gcode::FileUnits::Millimetres);
    language.german();
    QVERIFY(test::visibleText(bar).contains("in mm oder in Zoll"));
  }

  void asksForNumbersWithoutPoint() {
    test::Language language;
    ReadingBar bar;
    bar.setProgram(programOf("O1\nG21 G90\nG0 X10000 Y20000\nX5000\nM30\n"));
    QSignalSpy chosen(&bar, &ReadingBar::noPointChosen);
    button(bar, "Thousandths")->click();
    QCOMPARE(chosen.last().first().value<gcode::NoPoint>(), gcode::NoPoint::Increments);
    button(bar, "Whole units")->click();
    QCOMPARE(chosen.last().first().value<gcode::NoPoint>(), gcode::NoPoint::Units);
  }

  /// What is left to settings is shown, and taken as a whole.
  void asksForSettings() {
    test::Language language;
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Fanuc;
    const char* const text = "G21 G90 G0 X1. Y1.\nG2 X2. F100.\n";
    ReadingBar bar;
    bar.setProgram(programOf(text, options));
    QVERIFY(test::visibleText(bar).contains("an arc without centre and radius"));
    QSignalSpy chosen(&bar, &ReadingBar::settingsChosen);
    button(bar, "Take them")->click();
    options.settings = chosen.last().first().value<gcode::ControlSettings>();
    QCOMPARE(QString::fromStdString(gcode::textOf(options.settings)), "arc=line");
    bar.setProgram(programOf(text, options));
    QVERIFY(bar.isHidden());
  }

  /// A setting has the name that a machinist knows, and may have another value on the machine.
  void takesAnotherValue() {
    test::Language language;
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Fanuc;
    options.accepted = {"G83"};
    auto program = std::make_shared<gcode::Program>(
        gcode::interpretProgram("part.txt", "G21 G90 G0 X1. Y1.\n", options).value());
    program->diagnostics.push_back({gcode::Severity::Warning, base::LineNumber{2}, 1,
                                    gcode::DiagnosticCode::ControlSettingOpen, "G83: stroke=0"});
    ReadingBar bar;
    bar.setProgram(program);
    QVERIFY(test::visibleText(bar).contains("peck depth of G73 and G83 without Q"));
    auto* const field = bar.findChild<QLineEdit*>();
    QCOMPARE(field->text(), "0");
    QSignalSpy chosen(&bar, &ReadingBar::settingsChosen);
    field->setText("deep");
    button(bar, "Take them")->click();
    QVERIFY(chosen.isEmpty());
    field->setText("2.5");
    button(bar, "Take them")->click();
    QCOMPARE(QString::fromStdString(
                 gcode::textOf(chosen.last().first().value<gcode::ControlSettings>())),
             "stroke=2.5");
  }

  /// Where two controls would move differently, each button is one of them.
  void asksForTheControl() {
    test::Language language;
    const auto program = programOf("G21 G90\nG0 X1. ; Y2.\nX3.\n");
    ReadingBar bar;
    bar.setProgram(program);
    if (!program->ambiguity) {
      QFAIL("the test's program is not ambiguous");
    }
    QSignalSpy chosen(&bar, &ReadingBar::dialectChosen);
    for (const gcode::Ambiguity::Reading& reading : program->ambiguity->readings) {
      button(bar, controlName(reading.dialect))->click();
      QCOMPARE(chosen.last().first().value<gcode::Dialect>(), reading.dialect);
    }
    QVERIFY(chosen.size() > 1);
  }

  /// While a run is in progress its program stays as it was read.
  void answersNothingDuringARun() {
    test::Language language;
    ReadingBar bar;
    bar.setAnswerable(false);
    bar.setProgram(programOf("O1\nG90\nG0 X10. Y20.\nX5.\nM30\n"));
    QVERIFY(!button(bar, "mm")->isEnabled());
    bar.setAnswerable(true);
    QVERIFY(button(bar, "mm")->isEnabled());
  }
};

RIVULET_TEST(TestReadingBar)
#include "tst_reading_bar.moc"
