// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A run that begins at a line the operator has chosen: shown first, then held like a resumed one.

#include <QInputDialog>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>
#include <utility>

#include "hmi/main_window.h"
#include "journal/audit.h"
#include "support/patience.h"
#include "support/simulated_control.h"
#include "support/test_program.h"
#include "widgets/alarms/alarm_line.h"
#include "widgets/common/hold_button.h"
#include "widgets/program/path_canvas.h"
#include "widgets/program/program_page.h"
#include "widgets/program/text_pane.h"
#include "widgets/streaming/preflight_sheet.h"
#include "widgets/streaming/resume_bar.h"
#include "widgets/streaming/run_panel.h"

using namespace rivulet;
using hmi::MainWindow;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;
const QString kScorpion = QStringLiteral(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");
constexpr std::size_t kPoints = 270;
/// A cut in the middle, and the point at which its path begins.
constexpr std::uint32_t kLine = 200;
constexpr std::size_t kFirst = 195;

}  // namespace

class TestRunFromHere : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;
  std::unique_ptr<QTemporaryDir> m_state;
  std::unique_ptr<tests::SimulatedControl> m_machine;
  std::unique_ptr<MainWindow> m_window;

  [[nodiscard]] std::filesystem::path stateFolder() const { return m_state->path().toStdString(); }
  void openWindow(base::MethodKind method, bool wholeJob = false, bool isReal = false) {
    m_machine = std::make_unique<tests::SimulatedControl>("dmu75");
    if (isReal) {
      m_machine->passForReal();
    }
    m_state = std::make_unique<QTemporaryDir>();
    hmi::Settings settings;
    settings.language = QStringLiteral("en");
    settings.stream.parameters.method = method;
    settings.stream.wholeJob = wholeJob;
    settings.stream.deltaMm = 0.1;
    settings.stream.feedMmPerS = 2.0;
    settings.stateFolder = stateFolder();
    m_window = std::make_unique<MainWindow>(
        settings, false, [this](const auto& asked) { return m_machine->connect(asked.endpoint); });
    m_window->resize(1440, 900);
    m_window->show();
    m_window->openProgram(kScorpion);
    m_window->connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
  }
  void choose(std::size_t line) {
    m_window->programPage()->showLine(line);
    m_window->programPage()->textPane()->startHere()->click();
    QCoreApplication::processEvents();
  }
  /// Layouts take several turns.
  static void settle() {
    for (int turn = 0; turn < 5; ++turn) {
      QCoreApplication::processEvents();
    }
  }
  [[nodiscard]] QString text(const QWidget* widget) const {
    QString text;
    for (const auto* label : widget->findChildren<QLabel*>()) {
      text += label->text() + QLatin1Char('\n');
    }
    return text;
  }

  void openText(const char* name, const char* program) {
    QFile file(m_folder.filePath(QString::fromUtf8(name)));
    if (!file.open(QIODevice::WriteOnly) || file.write(program) <= 0) {
      qFatal("the program cannot be written");
    }
    file.close();
    m_window->openProgram(file.fileName());
    QTRY_COMPARE_WITH_TIMEOUT(QString::fromStdString(m_window->program()->name),
                              QString::fromUtf8(name), kSoonMs);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
  }
  /// The preflight of a pocket, where a program before it has left the tool in the cut.
  void openInTheCut(bool isReal) {
    openWindow(base::MethodKind::Window, false, isReal);
    openText("place.nc", "G21 G90 G1 X10 Y10 Z-5 F3000\n");
    if (QTest::currentTestFailed()) {
      return;
    }
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    openText("pocket.nc", "G21 G90 G1 X0 Y0 Z20 F3000\nZ-5\nX30\nY30\nX0\nY0\nZ20\n");
    QTest::mouseClick(m_window->findChild<widgets::HoldButton*>(QStringLiteral("start")),
                      Qt::LeftButton);
  }
  /// False: there is no such button.
  static bool press(const QWidget* sheet, const QString& name) {
    settle();
    for (auto* button : sheet->findChildren<QPushButton*>()) {
      if (button->isVisible() && button->text() == name) {
        QTest::mouseClick(button, Qt::LeftButton);
        settle();
        return true;
      }
    }
    return false;
  }
  void hold(QWidget* button) const {
    // A motion that is over at once would never be seen to begin.
    constexpr double kSeenPace = 20.0;
    m_machine->setPace(kSeenPace);
    QTest::mousePress(button, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isRunning(), kSoonMs);
    m_machine->setPace(tests::SimulatedControl::kUnlimited);
    QTest::mouseRelease(button, Qt::LeftButton);
  }

 private Q_SLOTS:
  void initTestCase() {
    qputenv("XDG_DATA_HOME", m_folder.path().toUtf8());
    qputenv("XDG_CONFIG_HOME", m_folder.path().toUtf8());
  }
  void cleanup() {
    m_window.reset();
    m_machine.reset();
  }

  void beginsAtTheChosenLine() {
    openWindow(base::MethodKind::Window);
    choose(kLine);
    const auto* bar = m_window->findChild<widgets::ResumeBar*>();
    QVERIFY(bar->isVisible() && bar->place().has_value());
    QVERIFY(bar->place()->isChosen);
    QCOMPARE(bar->place()->line.value, kLine);
    const std::size_t first = bar->place()->point;
    // From where the line begins: the end of the one before it.
    QCOMPARE(first, kFirst);
    const auto* sheet = m_window->findChild<widgets::PreflightSheet*>();
    QVERIFY(sheet->isVisible());
    const QString shown = text(sheet);
    QVERIFY(shown.contains(QStringLiteral("Before the start")));
    QVERIFY2(shown.contains(QStringLiteral("The %1 points before it are not executed.").arg(first)),
             qPrintable(shown));
    // What holds at the line and is not set by a run of the motion alone, the last first.
    QVERIFY2(shown.contains(QStringLiteral("G0X0.000Y0.000S10000M3 (line 4), T1M6 (line 2)")),
             qPrintable(shown));
    QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS));
    settle();
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/run-from-here-light.png")));
    m_window->setTheme(widgets::Theme::Dark);
    settle();
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/run-from-here-dark.png")));
    m_window->setTheme(widgets::Theme::Light);
    QVERIFY(!m_window->isRunning());
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->resume());
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    const auto report = m_window->lastReport();
    QVERIFY2(report->outcome == streaming::Outcome::Completed,
             qPrintable(QString::fromStdString(report->error.text())));
    QVERIFY(report->integrity.judged && report->integrity.isFaultless());
    QVERIFY(report->settings.resume.has_value());
    QCOMPARE(report->settings.resume->point, first);
    // Neither executed nor skipped are the points before the line.
    QCOMPARE(report->counters.total, kPoints - first);
    QCOMPARE(report->counters.executed, kPoints - first);
    QCOMPARE(report->integrity.skipped, std::size_t{0});
    QCOMPARE(m_window->lastUpdate().counters.executed, kPoints);
    const auto* panel = m_window->findChild<widgets::RunPanel*>();
    const QString all = QString::number(kPoints - first);
    QVERIFY2(text(panel).contains(QStringLiteral("%1 of %1").arg(all)), qPrintable(text(panel)));
    // The next run has all points again.
    QVERIFY(m_window->start());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed >= 1, kRunMs);
    QCOMPARE(m_window->lastUpdate().counters.total, kPoints);
    QVERIFY(text(panel).contains(QStringLiteral(" of %1").arg(kPoints)));
    m_window->stop();
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->isRunning(), kRunMs);
  }

  void notNowForgetsTheLine() {
    openWindow(base::MethodKind::Window);
    choose(kLine);
    m_window->findChild<QPushButton*>(QStringLiteral("not-now"))->click();
    QVERIFY(!m_window->findChild<widgets::ResumeBar*>()->isVisible());
    QVERIFY(!m_window->resume());
    QVERIFY(!m_window->isRunning());
  }

  /// What the control executes before the line would be left out without a word.
  void aWholeJobBeginsAtItsBeginning() {
    openWindow(base::MethodKind::Window, true);
    choose(kLine);
    QVERIFY(!m_window->findChild<widgets::ResumeBar*>()->isVisible());
    const QString said = text(m_window->findChild<widgets::AlarmLine*>());
    QVERIFY2(said.contains(QStringLiteral("choose Motion only")), qPrintable(said));
    QVERIFY(!m_window->resume());
  }

  /// Methods without numbered windows begin at the first point only; a run from the beginning
  /// forgets the chosen line.
  void onlyWithWindows() {
    openWindow(base::MethodKind::Signal);
    choose(200);
    QVERIFY(!m_window->resume());
    QVERIFY(!m_window->isRunning());
  }

  /// A start from the beginning while the tool stands in the cut: it can be raised first, as a run
  /// of its own. Until then nothing starts on a real control; on a virtual machine it is only said.
  void theToolIsRaisedBeforeAStartInTheCut_data() {
    QTest::addColumn<bool>("isReal");
    QTest::newRow("real") << true;
    QTest::newRow("virtual") << false;
  }
  void theToolIsRaisedBeforeAStartInTheCut() {
    QFETCH(const bool, isReal);
    openInTheCut(isReal);
    if (QTest::currentTestFailed()) {
      return;
    }
    auto* start = m_window->findChild<widgets::HoldButton*>(QStringLiteral("start"));
    const auto* sheet = m_window->findChild<widgets::PreflightSheet*>();
    QTRY_VERIFY(text(sheet).contains(QStringLiteral("passes within what the program cuts")));
    QCOMPARE(text(sheet).contains(QStringLiteral("Start is not possible yet.")), isReal);
    settle();
    const auto showsWayTo = [sheet](base::Vec3 placeMm) {
      const std::vector<base::Vec3>& wayMm = sheet->firstMove().wayMm;
      return wayMm.size() == 2 && base::distance(wayMm[0], {10.0, 10.0, -5.0}) < 1e-3 &&
             base::distance(wayMm[1], placeMm) < 1e-3;
    };
    QTRY_VERIFY(showsWayTo({0.0, 0.0, 20.0}));
    QVERIFY(!sheet->picture()->isHidden());
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/first-move-light.png")));
    QVERIFY(press(sheet, QStringLiteral("Raise the tool …")));
    QTRY_VERIFY2(text(sheet).contains(QStringLiteral("Before the tool is raised")),
                 qPrintable(text(sheet)));
    QVERIFY(showsWayTo({10.0, 10.0, 20.0}));
    const QString said = text(sheet).replace(QChar(0x00A0), QLatin1Char(' '));
    QVERIFY2(said.contains(QStringLiteral("by 25.000 mm to Z 20.000 mm, at 120 mm/min")),
             qPrintable(said));
    settle();
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/raise-light.png")));
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    hold(start);
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->isRunning() && sheet->isVisible(), kRunMs);
    QVERIFY(finished.isEmpty());  // no run of the program
    QTRY_VERIFY(
        text(sheet).contains(QStringLiteral("Hold Start for one second: then the machine "
                                            "moves.")));
    QVERIFY(!text(sheet).contains(QStringLiteral("passes within")));
    hold(start);
    QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, kRunMs);
    QVERIFY(m_window->lastReport()->isFaultless());
    // On a control that has not proved its feed cell no move takes longer than 5 s: at F 120 those
    // of 30 mm are divided into three, and those along Z of 25 mm into three.
    QCOMPARE(m_window->lastReport()->counters.executed,
             isReal ? std::size_t{1 + 6 * 3} : std::size_t{7});
  }

  /// The methods of [P1] on a real control: what they may do is typed before they start.
  void aTypedSentenceStartsAMethodThatMayRepeat_data() {
    QTest::addColumn<base::MethodKind>("method");
    QTest::addColumn<bool>("isReal");
    QTest::addColumn<bool>("isAsked");
    QTest::newRow("signal") << base::MethodKind::Signal << true << true;
    QTest::newRow("signal, virtual") << base::MethodKind::Signal << false << false;
    QTest::newRow("window") << base::MethodKind::Window << true << false;
  }
  void aTypedSentenceStartsAMethodThatMayRepeat() {
    QFETCH(const base::MethodKind, method);
    QFETCH(const bool, isReal);
    QFETCH(const bool, isAsked);
    openWindow(method, false, isReal);
    if (QTest::currentTestFailed()) {
      return;
    }
    m_window->showPreflight();
    settle();
    const auto* sheet = m_window->findChild<widgets::PreflightSheet*>();
    const QString what = QStringLiteral("may execute old points again");
    QCOMPARE(text(sheet).contains(what), isAsked);
    if (!isAsked) {
      return;
    }
    settle();
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/may-repeat-light.png")));
    for (const auto& [words, isRight] :
         {std::pair("old points", false), std::pair("This may execute old points again", true)}) {
      QVERIFY(text(sheet).contains(QStringLiteral("Start is not possible yet.")));
      QVERIFY(press(sheet, QStringLiteral("Accept it …")));
      auto* question = m_window->findChild<QInputDialog*>();
      QVERIFY(question != nullptr);
      question->setTextValue(QString::fromUtf8(words));
      question->accept();
      delete question;
      settle();
      QCOMPARE(text(sheet).contains(QStringLiteral("Confirmed.")), isRight);
    }
    QVERIFY(text(sheet).contains(what));
  }

  /// The straight way is taken when the right word has been typed.
  void aTypedWordTakesTheStraightWay() {
    openInTheCut(true);
    if (QTest::currentTestFailed()) {
      return;
    }
    auto* start = m_window->findChild<widgets::HoldButton*>(QStringLiteral("start"));
    const auto* sheet = m_window->findChild<widgets::PreflightSheet*>();
    for (const auto& [word, isRight] : {std::pair("yes", false), std::pair("clear", true)}) {
      QTRY_VERIFY(text(sheet).contains(QStringLiteral("passes within what the program cuts")));
      QVERIFY(press(sheet, QStringLiteral("It is clear …")));
      auto* question = m_window->findChild<QInputDialog*>();
      QVERIFY(question != nullptr);
      question->setTextValue(QString::fromUtf8(word));
      question->accept();
      delete question;
      settle();
      QCOMPARE(text(sheet).contains(QStringLiteral("Start is not possible yet.")), !isRight);
    }
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    hold(start);
    QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, kRunMs);
    QVERIFY(m_window->lastReport()->isFaultless());
    m_window.reset();
    const auto trail = journal::readAudit(journal::auditFileIn(stateFolder()));
    QVERIFY(trail.has_value());
    std::vector<std::string> confirmed;
    for (const auto& line : trail->lines) {
      for (const auto& [name, value] : line.entry.details) {
        if (name == "confirmed") {
          confirmed.push_back(line.entry.act + ": " + value);
        }
      }
    }
    QCOMPARE(confirmed, std::vector<std::string>{"start: first move"});
  }
};

RIVULET_TEST(TestRunFromHere)
#include "tst_run_from_here.moc"
