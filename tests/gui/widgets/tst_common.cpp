// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <limits>

#include "gcode/error.h"
#include "gui/widgets/page_test.h"
#include "opcua/error.h"
#include "streaming/run.h"
#include "support/test_program.h"
#include "templates/cells.h"
#include "widgets/alarms/alarm_line.h"
#include "widgets/common/diagnostic_text.h"
#include "widgets/common/error_text.h"
#include "widgets/common/log_view.h"
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
                    alarm::Source::Run, [line] { return QString("line %1").arg(line); }});
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
    QCOMPARE(model.index(0, LogModel::Time).data().toString(), QString("2026-01-02 03:04:05.678"));
  }

  void messagesSpeakTheLanguage() {
    test::Language language;
    LogView view;
    // A text is made again, with what it speaks of.
    view.append({QDateTime(QDate(2026, 1, 2), QTime(3, 4, 5, 678)), gcode::Severity::Warning,
                 alarm::Source::Connection, [] { return QLocale().toString(1234.5, 'f', 1); }});
    QVERIFY(view.toText().contains("\tWarning\tConnection\t1,234.5\n"));
    QVERIFY(view.toText().startsWith("2026-01-02T03:04:05.678"));
    language.german();
    QVERIFY(view.toText().contains("\tWarnung\tVerbindung\t1.234,5\n"));
    QVERIFY(test::visibleText(view).contains("Kopieren"));
  }

  void messagesAreFilteredAndSearched() {
    LogView view;
    const auto append = [&view](gcode::Severity severity, alarm::Source source, const char* text) {
      view.append({QDateTime::currentDateTime(), severity, source,
                   [text] { return QString::fromUtf8(text); }});
    };
    append(gcode::Severity::Note, alarm::Source::Run, "Access: list.");
    append(gcode::Severity::Warning, alarm::Source::Program, "The file has changed.");
    append(gcode::Severity::Error, alarm::Source::Run, "The run was ended by a fault.");
    const auto boxes = view.findChildren<QComboBox*>();
    QCOMPARE(boxes.size(), 2);
    const auto lines = [&view] { return view.toText().count('\n'); };
    QCOMPARE(lines(), 3);
    boxes[0]->setCurrentIndex(1);
    QCOMPARE(lines(), 2);
    boxes[1]->setCurrentText("Run");
    QCOMPARE(lines(), 1);
    QVERIFY(view.toText().contains("fault") && test::visibleText(view).contains("1 of 3"));
    boxes[0]->setCurrentIndex(0);
    auto* search = view.findChild<QLineEdit*>();
    search->setText("LIST access");
    QCOMPARE(lines(), 1);
    boxes[1]->setCurrentIndex(0);
    search->clear();
    QCOMPARE(lines(), 3);
    // There is no button that removes lines.
    QCOMPARE(view.findChildren<QPushButton*>().size(), 2);
  }

  void longMessagesAreWrapped() {
    LogView view;
    view.resize(700, 400);
    view.append({QDateTime::currentDateTime(), gcode::Severity::Note, alarm::Source::Run,
                 [] { return QString("word ").repeated(60); }});
    view.show();
    auto* table = view.findChild<QTableView*>();
    const int plainPx = table->rowHeight(0);
    auto* wrap = view.findChild<QCheckBox*>();
    wrap->click();
    QVERIFY(table->rowHeight(0) > 2 * plainPx);
    wrap->click();
    QCOMPARE(table->rowHeight(0), plainPx);
  }

  void theAlarmLineShowsTheMostImportant() {
    test::Language language;
    AlarmLine line;
    line.resize(800, 48);
    line.show();
    QVERIFY(line.text().isEmpty());
    alarm::Alarm lost;
    lost.number = 7;
    lost.code = alarm::Code::ConnectionLost;
    lost.arguments = {"cell"};
    line.setAlarm(lost, 3);
    QVERIFY(line.text().startsWith("The connection to cell is lost.\nLook at the machine"));
    QVERIFY(test::visibleText(line).contains("(3)"));
    QSignalSpy acknowledged(&line, &AlarmLine::acknowledgeRequested);
    QSignalSpy listed(&line, &AlarmLine::listRequested);
    for (auto* button : line.findChildren<QToolButton*>()) {
      if (button->text() == "Ack") {
        button->click();
      }
    }
    QCOMPARE(acknowledged.count(), 1);
    QCOMPARE(acknowledged.first().first().toInt(), 7);
    QTest::mouseClick(&line, Qt::LeftButton, {}, QPoint(100, 24));
    QCOMPARE(listed.count(), 1);
    language.german();
    QVERIFY(line.text().startsWith("Die Verbindung zu cell ist unterbrochen."));
  }

  /// An answer stands in front of the alarm, and gives way to it again.
  void aNoteIsDismissed() {
    AlarmLine line;
    line.resize(600, 48);
    line.show();
    line.showNote(gcode::Severity::Error, [] { return QString("No such file."); });
    QCOMPARE(line.text(), QString("No such file."));
    alarm::Alarm alarm;
    alarm.code = alarm::Code::NotJudged;
    alarm.arguments = {"a.nc"};
    line.setAlarm(alarm, 1);
    QCOMPARE(line.text(), QString("No such file."));
    QVERIFY(test::visibleText(line).contains("(1)"));
    for (auto* button : line.findChildren<QToolButton*>()) {
      if (button->toolTip() == "Dismiss the message") {
        button->click();
      }
    }
    QVERIFY(line.text().startsWith("Nobody knows"));
    line.setAlarm(std::nullopt, 0);
    QVERIFY(line.text().isEmpty());
  }
};

RIVULET_TEST(TestCommon)
#include "tst_common.moc"
