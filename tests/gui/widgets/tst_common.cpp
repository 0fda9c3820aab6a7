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
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "gcode/error.h"
#include "gui/widgets/page_test.h"
#include "opcua/error.h"
#include "streaming/run/run.h"
#include "support/test_program.h"
#include "templates/cells.h"
#include "widgets/alarms/alarm_line.h"
#include "widgets/common/diagnostic_text.h"
#include "widgets/common/error_text.h"
#include "widgets/common/icons.h"
#include "widgets/common/log_view.h"
#include "widgets/common/note_text.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"

using namespace rivulet;
using namespace rivulet::widgets;

namespace {

const QChar kSpace(0x00A0);

/// How an eye sees a colour: linear RGB, multiplied by this. Machado, Oliveira, Fernandes, "A
/// physiologically-based model for simulation of color vision deficiency", 2009, severity 1.
struct Vision {
  const char* name;
  std::array<std::array<double, 3>, 3> matrix;
};
constexpr std::array<Vision, 4> kVisions{{
    {"all colours", {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}}},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868},
       {0.114503, 0.786281, 0.099216},
       {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968},
       {0.280085, 0.672501, 0.047413},
       {-0.011820, 0.042940, 0.968881}}}},
    {"tritanopia",
     {{{1.255528, -0.076749, -0.178779},
       {-0.078411, 0.930809, 0.147602},
       {0.004733, 0.691367, 0.303900}}}},
}};

using Triple = std::array<double, 3>;

Triple multiplied(const std::array<Triple, 3>& matrix, const Triple& value) {
  Triple result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      result[row] += matrix[row][column] * value[column];
    }
  }
  return result;
}

/// Linear RGB as the eye gets it.
Triple seenBy(const Vision& eye, const QColor& color) {
  const auto linear = [](double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
  };
  Triple seen =
      multiplied(eye.matrix, {linear(color.redF()), linear(color.greenF()), linear(color.blueF())});
  for (double& channel : seen) {
    channel = std::clamp(channel, 0.0, 1.0);
  }
  return seen;
}

/// Distance in CIE L*a*b* (1976), white point D65.
double colourDifference(const Triple& first, const Triple& second) {
  const auto lab = [](const Triple& rgb) {
    Triple xyz = multiplied(
        {{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}}, rgb);
    const Triple white{0.95047, 1.0, 1.08883};
    for (std::size_t i = 0; i < 3; ++i) {
      const double share = xyz[i] / white[i];
      xyz[i] = share > 0.008856 ? std::cbrt(share) : 7.787 * share + 16.0 / 116.0;
    }
    return Triple{116.0 * xyz[1] - 16.0, 500.0 * (xyz[0] - xyz[1]), 200.0 * (xyz[1] - xyz[2])};
  };
  const Triple a = lab(first);
  const Triple b = lab(second);
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

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

  /// Notes of a run are written in English by core, and said in the language of the window.
  void notesSpeakTheLanguage() {
    test::Language language;
    const QString transfer =
        QStringLiteral("program RIVULET_WINDOW_7.MPF: written, compared, to be selected");
    QCOMPARE(noteText(transfer),
             QStringLiteral("Program RIVULET_WINDOW_7.MPF: written, compared, to be selected."));
    QCOMPARE(noteText(QStringLiteral("something else")), QStringLiteral("something else"));
    language.german();
    QCOMPARE(noteText(transfer),
             QStringLiteral("Programm RIVULET_WINDOW_7.MPF: geschrieben, verglichen, anzuwählen."));
    QCOMPARE(noteText(QStringLiteral("network: nothing has come from the control for 3 s")),
             QStringLiteral("Seit 3 s ist nichts von der Steuerung gekommen."));
    QVERIFY(!noteText(QStringLiteral("access form: array-count")).contains("array-count"));
    QVERIFY(noteText(QStringLiteral("slowed: The control answered slowly: accesses took up to 1.20 "
                                    "s, 40 times as long as expected. Each took at least 0.90 s: "
                                    "the network is slow, or the server is busy with another OPC "
                                    "UA client."))
                .contains("Jeder dauerte mindestens 0,90 s"));
    QCOMPARE(noteText(QStringLiteral("feed: the axes stand, 0.165 s after it was requested")),
             QStringLiteral("Die Achsen stehen, 0,165 s nach der Anforderung."));
  }

  void themesAreReadable_data() {
    QTest::addColumn<int>("theme");
    QTest::newRow("light") << static_cast<int>(Theme::Light);
    QTest::newRow("dark") << static_cast<int>(Theme::Dark);
    QTest::newRow("contrast") << static_cast<int>(Theme::Contrast);
  }
  void themesAreReadable() {
    QFETCH(int, theme);
    const QPalette palette = themePalette(static_cast<Theme>(theme));
    const ThemeColors& colors = themeColors(palette);
    QCOMPARE(colors.isDark, static_cast<Theme>(theme) != Theme::Light);
    QCOMPARE(colors.isContrast, static_cast<Theme>(theme) == Theme::Contrast);
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
    for (const QColor& ground : {colors.window, colors.surface, colors.button}) {
      QVERIFY2(contrastRatio(colors.outline, ground) >= 3.0, qPrintable(ground.name()));
      QVERIFY2(contrastRatio(colors.accent, ground) >= 3.0, qPrintable(ground.name()));  // focus
    }
    for (const QColor& line : {colors.path, colors.rapid, colors.native, colors.trace}) {
      QVERIFY2(contrastRatio(line, colors.surface) >= 3.0, qPrintable(line.name()));
    }
  }

  /// States, kinds of move and borders of the region: told apart by everybody, also by those who
  /// see two of the three primary colours only. (The states have a shape and a word as well.)
  /// The colour of a state would be hard to see on that of the selection.
  void anIconInASelectedRowHasTheColourOfItsText() {
    applyTheme(Theme::Contrast);
    const QColor text = QGuiApplication::palette().color(QPalette::HighlightedText);
    const QIcon icon = themedIcon(QStringLiteral("play"), Qt::magenta);
    const QImage image = icon.pixmap(QSize(16, 16), QIcon::Selected).toImage();
    QCOMPARE(image.pixelColor(8, 8).name(), text.name());
    QCOMPARE(icon.pixmap(QSize(32, 32)).toImage().pixelColor(16, 16).name(),
             QColor(Qt::magenta).name());
    applyTheme(Theme::Light);
  }

  void coloursAreToldApart_data() {
    QTest::addColumn<int>("theme");
    QTest::addColumn<int>("vision");
    for (const Theme theme : {Theme::Light, Theme::Dark, Theme::Contrast}) {
      for (std::size_t vision = 0; vision < kVisions.size(); ++vision) {
        QTest::addRow("%s, %s", qPrintable(themeName(theme)), kVisions[vision].name)
            << static_cast<int>(theme) << static_cast<int>(vision);
      }
    }
  }
  void coloursAreToldApart() {
    QFETCH(int, theme);
    QFETCH(int, vision);
    // A difference of 1 is just seen side by side, one of 10 at a glance.
    constexpr double kDifferenceMin = 12.0;
    const ThemeColors& colors = themeColors(themePalette(static_cast<Theme>(theme)));
    const std::vector<std::vector<QColor>> groups{
        {colors.text, colors.attention, colors.fault},
        {colors.accent, colors.path, colors.rapid, colors.native},
        {colors.equations[0], colors.equations[1], colors.equations[2], colors.equations[3]}};
    for (const std::vector<QColor>& group : groups) {
      for (std::size_t i = 0; i < group.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const auto& eye = kVisions[static_cast<std::size_t>(vision)];
          const double difference = colourDifference(seenBy(eye, group[i]), seenBy(eye, group[j]));
          QVERIFY2(difference >= kDifferenceMin,
                   qPrintable(QStringLiteral("%1 and %2: %3")
                                  .arg(group[i].name(), group[j].name())
                                  .arg(difference)));
        }
      }
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

  void whatIsWrongIsSaidInTheSameLanguage() {
    test::Language language;
    language.german();
    gcode::Diagnostic diagnostic;
    diagnostic.code = gcode::DiagnosticCode::ExpressionFault;
    diagnostic.cause = nc::FaultCode::NameUnknown;
    diagnostic.argument = "DEPTH";
    QCOMPARE(diagnosticText(diagnostic),
             QStringLiteral("Die Rechnung hat kein Ergebnis: DEPTH ist weder Variable noch "
                            "Funktion."));
    QCOMPARE(gcode::describe(diagnostic),
             std::string("The calculation has no result: DEPTH is neither a variable nor a "
                         "function."));
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
    for (int code = 1; code <= static_cast<int>(streaming::StreamError::BadTestBlock); ++code) {
      QVERIFY(!errorCodeText(make_error_code(static_cast<streaming::StreamError>(code))).isEmpty());
    }
    for (int code = 1; code <= static_cast<int>(opcua::LinkError::NoHistory); ++code) {
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
    QVERIFY(line.text().startsWith("It is not known"));
    line.setAlarm(std::nullopt, 0);
    QVERIFY(line.text().isEmpty());
  }
};

RIVULET_TEST(TestCommon)
#include "tst_common.moc"
