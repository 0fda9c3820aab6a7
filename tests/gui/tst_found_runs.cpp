// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Runs that the window did not start, on the real window and a virtual machine in virtual time:
/// the window's own run after the window was gone, one of somebody else, and one that is left on
/// disk only. What is done to the programs themselves is in tst_window_kills, over OPC UA.

#include <QDir>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>

#include "base/units.h"
#include "hmi/main_window.h"
#include "journal/audit.h"
#include "report/run_store.h"
#include "streaming/recovery/run_on_control.h"
#include "support/patience.h"
#include "support/simulated_control.h"
#include "support/test_program.h"
#include "trace/analysis/integrity.h"
#include "widgets/common/hold_button.h"
#include "widgets/program/path_view.h"
#include "widgets/program/program_page.h"
#include "widgets/streaming/found_run_bar.h"
#include "widgets/streaming/preflight_sheet.h"
#include "widgets/streaming/resume_bar.h"
#include "widgets/streaming/run_panel.h"

using namespace rivulet;
using hmi::MainWindow;
using streaming::Outcome;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;
constexpr double kInteractivePace = 8.0;
constexpr int kPoints = 60;

hmi::Settings settings() {
  hmi::Settings settings;
  settings.language = QStringLiteral("en");
  settings.theme = widgets::Theme::Light;
  return settings;
}

bool shows(const QWidget* widget, const QString& text) {
  const auto labels = widget->findChildren<QLabel*>();
  return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
    return label->isVisible() && label->text().contains(text);
  });
}

}  // namespace

class TestFoundRuns : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  std::unique_ptr<tests::SimulatedControl> m_machine;
  std::unique_ptr<MainWindow> m_window;
  QString m_program;

  /// A zigzag of which the points from `changedFrom` on are elsewhere.
  void writeProgram(int changedFrom = kPoints, int feedMmPerMin = 3000) {
    QFile file(m_program);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("G1 X0 Y0 Z0 F" + QByteArray::number(feedMmPerMin) + '\n');
    for (int i = 1; i < kPoints; ++i) {
      file.write("X" + QByteArray::number(5 * i) + " Y" +
                 QByteArray::number(i % 2 * 3 + (i >= changedFrom ? 10 : 0)) + '\n');
    }
  }

  void openWindow() {
    hmi::Settings settings = ::settings();
    settings.stateFolder = m_folder.filePath(QStringLiteral("audit")).toStdString();
    m_window = std::make_unique<MainWindow>(
        settings, false, [this](const auto& asked) { return m_machine->connect(asked.endpoint); });
    m_window->resize(1440, 900);
    m_window->show();
    m_window->connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
  }

  void startRun() {
    streaming::StreamSettings stream;
    stream.parameters.pointsPerLoop = 5;
    stream.programFeeds = true;
    stream.overrideFactor = 0.9;
    m_window->setStreamSettings(stream);
    m_window->openProgram(m_program);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
    QVERIFY(m_window->start());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed >= 10, kRunMs);
  }

  /// A window streams until it has executed some points, and is gone then as if it were killed.
  void startAndLose() {
    openWindow();
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    startRun();
    m_machine->cut();
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    m_window.reset();
  }

  [[nodiscard]] QPushButton* button(const char* name) const {
    return m_window->findChild<QPushButton*>(QLatin1String(name));
  }
  [[nodiscard]] widgets::FoundRunBar* bar() const {
    return m_window->findChild<widgets::FoundRunBar*>();
  }
  void picture(const char* name) const {
    QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS));
    for (int pass = 0; pass < 5; ++pass) {
      QCoreApplication::processEvents();  // layouts settle in several steps
    }
    m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/%1.png").arg(QLatin1String(name)));
  }
  /// What the audit trail says that was done, after the window is closed.
  [[nodiscard]] QStringList closeAndReadActs() {
    m_window.reset();
    const auto trail = journal::readAudit(
        journal::auditFileIn(m_folder.filePath(QStringLiteral("audit")).toStdString()));
    QStringList acts;
    for (const auto& line : trail->lines) {
      acts << QString::fromStdString(line.entry.act);
    }
    return acts;
  }
  /// Everything the machine has executed since its program was started last.
  [[nodiscard]] std::vector<trace::ExecutedBlock> blocks() const {
    auto connection = m_machine->connect(tests::SimulatedControl::endpoint());
    const auto trace = connection->control->fetchTrace();
    return trace ? trace->blocks : std::vector<trace::ExecutedBlock>();
  }
  void hold(QPushButton* button) const {
    QTest::mousePress(button, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isRunning(), kSoonMs);
    QTest::mouseRelease(button, Qt::LeftButton);
  }

 private Q_SLOTS:
  void initTestCase() {
    qputenv("XDG_DATA_HOME", m_folder.path().toUtf8());
    qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toUtf8());
    QCoreApplication::setOrganizationName(QStringLiteral("RivuletTest"));
    m_program = m_folder.filePath(QStringLiteral("zigzag.nc"));
  }
  void init() {
    QDir(m_folder.filePath(QStringLiteral("state"))).removeRecursively();
    QDir(m_folder.filePath(QStringLiteral("audit"))).removeRecursively();
    writeProgram();
    m_machine = std::make_unique<tests::SimulatedControl>("dmu75", kInteractivePace);
  }
  void cleanup() {
    m_window.reset();
    m_machine.reset();
  }

  /// What somebody else has started is no run: Stop and Escape reset the control.
  void stopsWhatIsNoRun_data() {
    QTest::addColumn<bool>("byKey");
    QTest::newRow("Stop") << false;
    QTest::newRow("Escape") << true;
  }
  void stopsWhatIsNoRun() {
    QFETCH(bool, byKey);
    const auto other = m_machine->connect(tests::SimulatedControl::endpoint());
    QVERIFY(other->control->uploadProgram("JOG.MPF", "G90 G1 X300 F100\nX0\nM30\n", true) &&
            other->control->selectProgram("JOG.MPF") && other->control->cycleStart());
    openWindow();
    QTRY_VERIFY_WITH_TIMEOUT(button("stop")->isEnabled(), kSoonMs);
    QVERIFY(!bar()->isVisible());
    if (byKey) {
      QTest::keyClick(m_window.get(), Qt::Key_Escape);
    } else {
      QTest::mouseClick(button("stop"), Qt::LeftButton);
    }
    QTRY_VERIFY_WITH_TIMEOUT(!button("stop")->isEnabled(), kSoonMs);
    QVERIFY(shows(m_window.get(), QStringLiteral("The control was reset")));
    picture("stopped-by-reset");
  }

  /// A window that is opened again finds its own run, says whose it is, watches and resumes it:
  /// each point once.
  void resumesItsOwnRun() {
    startAndLose();
    openWindow();
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), kSoonMs);
    const streaming::RunOrigin me = report::thisUser();
    QVERIFY(shows(bar(),
                  QStringLiteral("Started by %1 on %2")
                      .arg(QString::fromStdString(me.user), QString::fromStdString(me.computer))));
    QVERIFY(shows(bar(), QStringLiteral("of zigzag.nc")));
    QVERIFY(button("stop")->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(shows(bar(), QStringLiteral("Its client is gone")), kSoonMs);
    QVERIFY(shows(bar(), QStringLiteral("of 60 points executed")));
    picture("found-own");
    // To watch it loads the program and shows the progress; nothing is changed.
    QVERIFY(!m_window->program());
    QTest::mouseClick(button("found-watch"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->program() != nullptr, kSoonMs);
    QVERIFY(shows(m_window->findChild<widgets::RunPanel*>(), QStringLiteral("Watching run")));
    picture("found-watching");
    QTRY_VERIFY_WITH_TIMEOUT(button("found-resume")->isEnabled(), kSoonMs);
    QTest::mouseClick(button("found-resume"), Qt::LeftButton);
    auto* place = m_window->findChild<widgets::ResumeBar*>();
    QTRY_VERIFY_WITH_TIMEOUT(place->place().has_value(), kSoonMs);
    auto* sheet = m_window->findChild<widgets::PreflightSheet*>();
    QVERIFY(sheet->isVisible());
    QVERIFY(shows(sheet, QStringLiteral("Before the run is resumed")));
    QVERIFY(shows(sheet, QStringLiteral("The axes stand on the path within 0.")));
    QVERIFY(shows(sheet, QStringLiteral("zigzag.nc, version")));
    QVERIFY(!m_window->isRunning());
    QVERIFY(shows(sheet, QStringLiteral("The program still stands on the control")));
    QVERIFY(place->place()->restMm.has_value());
    picture("found-resume");
    const std::size_t point = place->place()->point;
    QVERIFY(point >= 10 && point < kPoints);
    // Nothing moves before it is confirmed; then the rest of the window, and the run.
    std::vector<trace::ExecutedBlock> all = blocks();
    constexpr int kWatchedMs = 300;
    QTest::qWait(kWatchedMs);
    QCOMPARE(blocks().size(), all.size());
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    hold(button("go-on"));
    QVERIFY(!sheet->isVisible() && !bar()->isVisible());
    const auto isSameProgram = [&all](const std::vector<trace::ExecutedBlock>& now) {
      return !now.empty() && now.front().from == all.front().from;
    };
    for (auto now = blocks(); isSameProgram(now); now = blocks()) {
      all = now;
      QTest::qWait(1);
    }
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    const auto report = m_window->lastReport();
    QVERIFY2(report->outcome == Outcome::Completed, report->error.text().c_str());
    QCOMPARE(m_window->lastUpdate().counters.executed, std::size_t{kPoints});
    all.insert(all.end(), report->controlTrace->blocks.begin(), report->controlTrace->blocks.end());
    const auto points =
        gcode::streamPoints(m_window->program()->trajectory, report->checkpoint->startMm).points;
    const trace::Integrity integrity = trace::judgeIntegrity(points, all, trace::kPointToleranceMm);
    QVERIFY(integrity.isFaultless());
    QCOMPARE(integrity.executed, std::size_t{kPoints});
    QVERIFY(report->settings.programFeeds && report->settings.programFeeds->overrideFactor == 0.9);
    // Completed: nothing is left of it.
    QVERIFY(report::RunStore().runs().empty());
    QTRY_VERIFY(!bar()->isVisible());
    const QStringList acts = closeAndReadActs();
    QVERIFY2(acts.contains(QStringLiteral("watch")) && acts.contains(QStringLiteral("resume")),
             qPrintable(acts.join(QLatin1Char(' '))));
  }

  /// A program that was changed where points have been executed is refused; one that was changed
  /// after that is shown.
  void comparesTheProgram() {
    startAndLose();
    writeProgram(3);
    openWindow();
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible() && button("found-resume")->isEnabled(), kSoonMs);
    QTest::mouseClick(button("found-resume"), Qt::LeftButton);
    auto* place = m_window->findChild<widgets::ResumeBar*>();
    QTRY_VERIFY_WITH_TIMEOUT(shows(place, QStringLiteral("cannot be resumed")), kSoonMs);
    QVERIFY(shows(place, QStringLiteral("changed since the run")));
    picture("found-refused");
    writeProgram(kPoints - 10);
    // Nothing has moved for the refusal: the program stands as it did.
    m_window.reset();
    openWindow();
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible() && button("found-resume")->isEnabled(), kSoonMs);
    QVERIFY(shows(bar(), QStringLiteral("Its client is gone")));
    QTest::mouseClick(button("found-resume"), Qt::LeftButton);
    place = m_window->findChild<widgets::ResumeBar*>();
    QTRY_VERIFY_WITH_TIMEOUT(place->place().has_value(), kSoonMs);
    QVERIFY(place->place()->changedFrom == std::size_t{kPoints - 10});
    QVERIFY(shows(place, QStringLiteral("From point 51 on, the program differs")));
    picture("found-changed");
  }

  /// Stop, by the bar, the big button or Escape: the axes stand where they are until the run is
  /// ended, and it can still be resumed.
  void stopsItsOwnRun_data() {
    QTest::addColumn<QString>("how");
    QTest::newRow("bar") << QStringLiteral("found-stop");
    QTest::newRow("Stop") << QStringLiteral("stop");
    QTest::newRow("Escape") << QString();
  }
  void stopsItsOwnRun() {
    QFETCH(QString, how);
    startAndLose();
    openWindow();
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), kSoonMs);
    if (how.isEmpty()) {
      QTest::keyClick(m_window.get(), Qt::Key_Escape);
    } else {
      QTest::mouseClick(button(how.toLatin1().constData()), Qt::LeftButton);
    }
    QVERIFY(shows(m_window.get(), QStringLiteral("Stop requested")));
    QTRY_VERIFY_WITH_TIMEOUT(shows(bar(), QStringLiteral("The axes stand")), kSoonMs);
    picture("found-held");
    QVERIFY(button("stop")->isEnabled() && !button("found-stop")->isVisible());
    QTest::keyClick(m_window.get(), Qt::Key_Escape);  // a stop lets nothing go
    QTRY_VERIFY_WITH_TIMEOUT(shows(bar(), QStringLiteral("The axes stand")), kSoonMs);
    QTest::mouseClick(button("found-end"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(shows(bar(), QStringLiteral("no longer active")), kSoonMs);
    QTRY_VERIFY_WITH_TIMEOUT(button("found-resume")->isEnabled(), kSoonMs);
    picture("found-stopped");
    QTest::mouseClick(button("found-dismiss"), Qt::LeftButton);
    QVERIFY(!bar()->isVisible());
    QVERIFY(closeAndReadActs().contains(QStringLiteral("stop")));
  }

  /// Until its axes stand, the strip says how far they still move, at most, and counts down.
  void saysHowFarAFoundRunStillMoves() {
    constexpr int kSlowMmPerMin = 300;
    constexpr double kWindowMm = 30.0;  // five moves of less than 6 mm
    writeProgram(kPoints, kSlowMmPerMin);
    startAndLose();
    openWindow();
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), kSoonMs);
    QTest::mouseClick(button("found-stop"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(shows(bar(), QStringLiteral("The axes stand")), kSoonMs);
    QVERIFY(!shows(bar(), QStringLiteral("still moving")));
    QTest::mouseClick(button("found-end"), Qt::LeftButton);
    std::vector<double> aheadMm;
    const QRegularExpression told(QStringLiteral("still moving, at most ([0-9]+)"));
    QTRY_VERIFY_WITH_TIMEOUT(
        [&] {
          for (const QLabel* label : bar()->findChildren<QLabel*>()) {
            if (const auto match = told.match(label->text()); match.hasMatch()) {
              aheadMm.push_back(match.captured(1).toDouble());
            }
          }
          return shows(bar(), QStringLiteral("no longer active"));
        }(),
        kRunMs);
    QVERIFY(aheadMm.size() > 1);
    QVERIFY(aheadMm.front() <= kWindowMm && aheadMm.back() < aheadMm.front());
    QVERIFY(std::is_sorted(aheadMm.rbegin(), aheadMm.rend()));
  }

  /// Closing asks, does not cover Stop, and stops only when told to; the run is kept.
  void closingStopsOnlyIfConfirmed() {
    openWindow();
    startRun();
    QVERIFY(!m_window->close());
    QVERIFY(m_window->isVisible() && m_window->isRunning());
    QVERIFY(button("keep-open")->isVisible() && button("stop")->isEnabled());
    QCOMPARE(m_window->focusWidget(), button("keep-open"));
    picture("closing");
    QTest::mouseClick(button("keep-open"), Qt::LeftButton);
    QVERIFY(!button("keep-open")->isVisible() && m_window->isRunning());
    QVERIFY(!m_window->close());
    QTest::mouseClick(button("stop-and-close"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), kRunMs);
    QVERIFY(m_window->lastReport()->outcome == Outcome::Stopped);
    QCOMPARE(report::RunStore().runs().size(), std::size_t{1});
    // Held in the middle of the window, or ended between windows: nothing moves any more.
    constexpr int kWatchedMs = 300;
    const std::size_t executed = blocks().size();
    QTest::qWait(kWatchedMs);
    QCOMPARE(blocks().size(), executed);
    QVERIFY(m_window->lastReport()->leftHeld || m_window->lastReport()->stopConfirmedAfter);
  }

  /// A run of somebody else: watched and stopped, also by Escape, not resumed.
  void leavesTheRunsOfOthers() {
    startAndLose();
    QDir(m_folder.filePath(QStringLiteral("state"))).removeRecursively();
    openWindow();
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), kSoonMs);
    QTRY_VERIFY_WITH_TIMEOUT(shows(bar(), QStringLiteral("Its client is gone")), kSoonMs);
    QVERIFY(shows(bar(), QStringLiteral("windows executed")));
    QVERIFY(shows(bar(), QStringLiteral("on the computer where it was started")));
    QVERIFY(!button("found-resume")->isVisible());
    QTest::mouseClick(button("found-watch"), Qt::LeftButton);
    QVERIFY(shows(m_window->findChild<widgets::RunPanel*>(), QStringLiteral("Watching run")));
    picture("found-foreign");
    QTest::mouseClick(button("found-watch"), Qt::LeftButton);
    QTest::keyClick(m_window.get(), Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(shows(bar(), QStringLiteral("The axes stand")), kSoonMs);
    QTest::mouseClick(button("found-end"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!bar()->isVisible(), kSoonMs);
  }
};

RIVULET_TEST(TestFoundRuns)
#include "tst_found_runs.moc"
