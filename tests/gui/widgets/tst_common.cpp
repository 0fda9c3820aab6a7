// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QAbstractItemModelTester>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <limits>

#include "gcode/error.h"
#include "gui/widgets/page_test.h"
#include "opcua/error.h"
#include "streaming/run.h"
#include "support/test_program.h"
#include "templates/cells.h"
#include "widgets/common/diagnostic_text.h"
#include "widgets/common/error_text.h"
#include "widgets/common/log_view.h"
#include "widgets/common/message_area.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"

using namespace rivulet;
using namespace rivulet::widgets;

namespace {

const QChar kSpace(0x00A0);

}  // namespace

class TestCommon : public QObject {
  Q_OBJECT

 private slots:
  void init() { test::failOnWarnings(); }

  void numbersFollowTheLanguage() {
    test::Language language;
    QCOMPARE(numberText(1234.5, 2), QString("1,234.50"));
    QCOMPARE(lengthText(-0.00001), QString("0.000") + kSpace + "mm");
    QCOMPARE(feedText(500.0 / 60.0), QString("500") + kSpace + "mm/min");
    QCOMPARE(feedText(0.1), QString("6.00") + kSpace + "mm/min");
    QCOMPARE(millisecondsText(std::chrono::microseconds{41'250}, 2),
             QString("41.25") + kSpace + "ms");
    QCOMPARE(numberText(std::numeric_limits<double>::quiet_NaN(), 3), noValue());
    QCOMPARE(factorText(std::numeric_limits<double>::infinity()), QString("> 1,000"));
    language.german();
    QCOMPARE(numberText(1234.5, 2), QString("1.234,50"));
    QCOMPARE(countText(1'000'000), QString("1.000.000"));
  }

  void themesAreReadable_data() {
    QTest::addColumn<int>("theme");
    QTest::newRow("light") << static_cast<int>(Theme::Light);
    QTest::newRow("dark") << static_cast<int>(Theme::Dark);
  }
  void themesAreReadable() {
    QFETCH(int, theme);
    const QPalette palette = themePalette(static_cast<Theme>(theme));
    const ThemeColors& colors = themeColors(palette);
    QCOMPARE(colors.isDark, static_cast<Theme>(theme) == Theme::Dark);
    for (const QColor& text :
         {colors.text, colors.mutedText, colors.attention, colors.fault, colors.accent,
          colors.equations[0], colors.equations[1], colors.equations[2], colors.equations[3]}) {
      QVERIFY2(contrastRatio(text, colors.window) >= 4.5, qPrintable(text.name()));
      QVERIFY2(contrastRatio(text, colors.surface) >= 4.5, qPrintable(text.name()));
    }
    QVERIFY(contrastRatio(colors.text, colors.button) >= 4.5);
    QVERIFY(contrastRatio(palette.color(QPalette::HighlightedText),
                          palette.color(QPalette::Highlight)) >= 4.5);
    // Lines and shapes need 3:1.
    for (const QColor& line : {colors.path, colors.rapid, colors.trace}) {
      QVERIFY2(contrastRatio(line, colors.surface) >= 3.0, qPrintable(line.name()));
    }
  }

  void contrastIsThatOfWcag() {
    QCOMPARE(contrastRatio(Qt::black, Qt::white), 21.0);
    QCOMPARE(contrastRatio(Qt::white, Qt::white), 1.0);
    // 0x77 grey on white is known to miss 4.5:1 by a hair.
    QVERIFY(contrastRatio(QColor(0x77, 0x77, 0x77), Qt::white) < 4.5);
    QVERIFY(contrastRatio(QColor(0x76, 0x76, 0x76), Qt::white) > 4.5);
  }

  void everyFindingHasASentenceInBothLanguages() {
    test::Language language;
    const auto last = static_cast<int>(gcode::DiagnosticCode::MoreFindings);
    for (int code = 0; code <= last; ++code) {
      language.english();
      gcode::Diagnostic diagnostic;
      diagnostic.code = static_cast<gcode::DiagnosticCode>(code);
      diagnostic.argument = "G87";
      const QString english = diagnosticText(diagnostic);
      // The sentence of the HMI is the sentence of the command line.
      QCOMPARE(english, QString::fromStdString(gcode::describe(diagnostic)));
      language.german();
      QVERIFY2(diagnosticText(diagnostic) != english, qPrintable(english));
      QVERIFY(!diagnosticText(diagnostic).contains("%1"));
    }
  }

  void ordersToTheMachineAreNamed() {
    test::Language language;
    for (const auto& [severity, word] :
         {std::pair(gcode::Severity::Warning, "M6"), std::pair(gcode::Severity::Note, "M8"),
          std::pair(gcode::Severity::Note, "/"), std::pair(gcode::Severity::Note, "G54")}) {
      gcode::Diagnostic diagnostic;
      diagnostic.severity = severity;
      diagnostic.code = gcode::DiagnosticCode::IgnoredCode;
      diagnostic.argument = word;
      QCOMPARE(diagnosticText(diagnostic), QString::fromStdString(gcode::describe(diagnostic)));
    }
  }

  void errorsAreTranslated() {
    test::Language language;
    const base::Error error = base::makeError(make_error_code(opcua::LinkError::NotReachable),
                                              "no server", "opc.tcp://127.0.0.1:4840");
    language.german();
    QVERIFY(errorText(error).startsWith("opc.tcp://127.0.0.1:4840: An diesem Endpunkt"));
    for (int code = 1; code <= static_cast<int>(streaming::StreamError::EndedEarly); ++code) {
      QVERIFY(!errorCodeText(make_error_code(static_cast<streaming::StreamError>(code))).isEmpty());
    }
    for (int code = 1; code <= static_cast<int>(opcua::LinkError::TooManyItems); ++code) {
      QVERIFY(!errorCodeText(make_error_code(static_cast<opcua::LinkError>(code))).isEmpty());
    }
  }

  void englishErrorsKeepTheirDetails() {
    test::Language language;
    const base::Error error = base::makeError(make_error_code(templates::TemplateError::DoesNotFit),
                                              "N = 20 needs 204 R-parameters: set MD28050 to 204.");
    QCOMPARE(errorText(error), QString("N = 20 needs 204 R-parameters: set MD28050 to 204."));
  }

  void unknownErrorsShowTheirMessage() {
    test::Language language;
    language.german();
    const base::Error error =
        base::makeError(std::make_error_code(std::errc::no_space_on_device), "The disk is full.");
    QCOMPARE(errorText(error), QString("The disk is full."));
    QVERIFY(errorCodeText({}).isEmpty());
  }

  void statusSaysItInShapeAndWords() {
    QSet<QString> shapes;
    for (const Status status : {Status::Unknown, Status::Busy, Status::Good, Status::Attention,
                                Status::Fault, Status::Simulated}) {
      shapes.insert(statusIconName(status));
    }
    QCOMPARE(shapes.size(), 6);
    const QPalette palette = themePalette(Theme::Light);
    // What is normal stays neutral.
    QCOMPARE(statusColor(Status::Good, palette), themeColors(palette).text);
    QVERIFY(statusColor(Status::Fault, palette) != themeColors(palette).text);
  }

  void logKeepsTheNewestLines() {
    LogModel model;
    const auto append = [&model](std::size_t line) {
      model.append({QDateTime(QDate(2026, 1, 2), QTime(3, 4, 5, 678)), gcode::Severity::Note,
                    QString("line %1").arg(line)});
    };
    std::size_t line = 0;
    for (; line < LogModel::kCapacity; ++line) {
      append(line);
    }
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    for (; line < LogModel::kCapacity + 10; ++line) {
      append(line);
    }
    QCOMPARE(model.rowCount(), static_cast<int>(LogModel::kCapacity));
    QCOMPARE(model.index(0, LogModel::Text).data().toString(), QString("line 10"));
    QCOMPARE(model.index(0, LogModel::Time).data().toString(), QString("03:04:05.678"));
    QVERIFY(model.toText().startsWith("2026-01-02T03:04:05.678\tNote\tline 10\n"));
  }

  void logSpeaksTheLanguage() {
    test::Language language;
    LogView view;
    view.append({QDateTime::currentDateTime(), gcode::Severity::Warning, "text"});
    QVERIFY(view.toText().contains("Warning"));
    language.german();
    QVERIFY(view.toText().contains("Warnung"));
    QVERIFY(test::visibleText(view).contains("Kopieren"));
  }

  void messageCanBeDismissed() {
    test::Language language;
    MessageArea area;
    QVERIFY(area.isHidden());
    QSignalSpy dismissed(&area, &MessageArea::dismissed);
    area.resize(600, 48);
    area.showMessage(gcode::Severity::Error, "The connection is lost.");
    QVERIFY(!area.isHidden());
    QVERIFY(test::visibleText(area).contains("Error"));
    language.german();
    QVERIFY(test::visibleText(area).contains("Fehler"));
    const auto buttons = area.findChildren<QToolButton*>();
    QCOMPARE(buttons.size(), 2);
    buttons.last()->click();
    QCOMPARE(dismissed.count(), 1);
    QVERIFY(area.isHidden());
    QVERIFY(area.text().isEmpty());
  }
};

RIVULET_TEST(TestCommon)
#include "tst_common.moc"
