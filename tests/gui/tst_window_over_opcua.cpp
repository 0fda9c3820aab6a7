// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The window as it is released: the virtual machine runs in a process of its own, the window talks
/// to it over OPC UA, in real time. What the window does is tested in virtual time, in
/// tst_main_window; this shows that it also does it on a real connection.

#include <QComboBox>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <optional>
#include <thread>

#include "base/units.h"
#include "gui/end_by_hand.h"
#include "hmi/main_window.h"
#include "report/run_history.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/test_program.h"
#include "widgets/alarms/alarm_line.h"
#include "widgets/common/number_field.h"
#include "widgets/plots/time_window.h"
#include "widgets/scope/scope_curves.h"
#include "widgets/scope/scope_pane.h"
#include "widgets/streaming/resume_bar.h"
#include "widgets/trace/trace_page.h"

using namespace rivulet;
using hmi::MainWindow;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;
constexpr int kRising = 0;  // of the list of conditions

hmi::Settings settings() {
  hmi::Settings settings;
  settings.language = QStringLiteral("en");
  return settings;
}

}  // namespace

class TestWindowOverOpcua : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  /// The first lines of the sample program, which is long for a machine in real time.
  [[nodiscard]] QString beginning(int lines) {
    QFile whole(QStringLiteral(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap"));
    QFile part(m_folder.filePath(QStringLiteral("beginning.tap")));
    if (!whole.open(QIODevice::ReadOnly) || !part.open(QIODevice::WriteOnly)) {
      qFatal("the sample program cannot be copied");
    }
    for (int line = 0; line < lines; ++line) {
      part.write(whole.readLine());
    }
    return part.fileName();
  }

 private Q_SLOTS:
  void initTestCase() { QCoreApplication::setOrganizationName(QStringLiteral("RivuletTest")); }

  void streams() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE),
                                        {QStringLiteral("--seed"), QStringLiteral("1"),
                                         QStringLiteral("--preset"), QStringLiteral("dmu75")});
    QVERIFY(machine.endpoint().startsWith(QStringLiteral("opc.tcp://127.0.0.1:")));
    MainWindow window(settings(), false);
    window.show();
    streaming::StreamSettings stream;
    stream.parameters.method = base::MethodKind::Signal;
    stream.parameters.pointsPerLoop = 7;
    stream.feedMmPerS = base::mmPerSFromMmPerMin(3000.0);
    window.setStreamSettings(stream);
    window.openProgram(beginning(40));
    window.connectTo(machine.endpoint());
    QTRY_COMPARE_WITH_TIMEOUT(window.startBlockedReason(), QString(), kSoonMs);
    QSignalSpy finished(&window, &MainWindow::runFinished);
    QVERIFY(window.start());
    QVERIFY(finished.wait(kRunMs));
    const auto report = window.lastReport();
    QVERIFY2(report->outcome == streaming::Outcome::Completed, report->error.text().c_str());
    QVERIFY(report->integrity.isFaultless());
    QVERIFY(report->counters.total > 20);
    QCOMPARE(report->integrity.executed, report->counters.total);
  }

  /// A trigger that was armed before the run catches what it waits for, with the time before it,
  /// while the machine goes on.
  void aTriggerCatchesTheRun() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE),
                                        {QStringLiteral("--seed"), QStringLiteral("1"),
                                         QStringLiteral("--preset"), QStringLiteral("dmu75")});
    MainWindow window(settings(), false);
    window.show();
    streaming::StreamSettings stream;
    stream.feedMmPerS = base::mmPerSFromMmPerMin(3000.0);
    window.setStreamSettings(stream);
    window.openProgram(beginning(40));
    window.connectTo(machine.endpoint());
    QTRY_COMPARE_WITH_TIMEOUT(window.startBlockedReason(), QString(), kSoonMs);
    widgets::TracePage& page = *window.tracePage();
    const auto field = [&page](const char* name) {
      return page.findChild<widgets::NumberField*>(QLatin1String(name));
    };
    constexpr double kLevelMm = 60.0;
    constexpr double kBeforeS = 0.4;
    constexpr double kAfterS = 0.2;
    auto* signal = page.findChild<QComboBox*>("triggerSignal");
    signal->setCurrentIndex(signal->findData(QStringLiteral("x_act")));
    page.findChild<QComboBox*>("triggerCondition")->setCurrentIndex(kRising);
    field("triggerLevel")->setValue(kLevelMm);
    field("triggerBefore")->setValue(kBeforeS);
    field("triggerAfter")->setValue(kAfterS);
    auto* arm = page.findChild<QPushButton*>("triggerArm");
    arm->click();
    QVERIFY(arm->isChecked());
    QSignalSpy finished(&window, &MainWindow::runFinished);
    QVERIFY(window.start());
    QTRY_VERIFY_WITH_TIMEOUT(!arm->isChecked(), kRunMs);
    // It fired during the run, and what it caught stays while the run goes on.
    QCOMPARE(finished.count(), 0);
    const auto atS = page.findChild<widgets::ScopeCursors*>()->atS(widgets::ScopeCursors::A);
    QVERIFY(atS);
    const auto isCaught = [&] {
      return !page.timeWindow()->isLive() &&
             std::abs(page.timeWindow()->fromS() - (*atS - kBeforeS)) < 1e-6 &&
             std::abs(page.timeWindow()->toS() - (*atS + kAfterS)) < 1e-6;
    };
    QVERIFY(isCaught());
    const auto samples =
        page.findChild<widgets::ScopeCurves*>()->samples(0, QStringLiteral("x_act"));
    const std::size_t fired = samples->firstAt(base::Instant{base::fromSeconds(*atS)});
    QVERIFY(fired > 0 && fired < samples->size());
    QVERIFY(samples->valueAt(fired) >= kLevelMm);
    QVERIFY(samples->valueAt(fired - 1) < kLevelMm);
    // The time before is there, from the same run.
    QVERIFY(samples->timeAt(0) <= base::Instant{base::fromSeconds(*atS - kBeforeS)});
    const std::size_t size = samples->size();
    QTRY_VERIFY_WITH_TIMEOUT(samples->size() > size + 5 || finished.count() > 0, kRunMs);
    QVERIFY(finished.count() > 0 || isCaught());
    QVERIFY(finished.count() > 0 || finished.wait(kRunMs));
    QVERIFY(window.lastReport()->integrity.isFaultless());
  }

  /// A program of its own sends points over TCP and reacts to what has been executed: it is never
  /// more than three windows ahead.
  void streamsLivePoints() {
    const tests::MachineProcess machine(
        QStringLiteral(RIVULET_MACHINE),
        {QStringLiteral("--seed"), QStringLiteral("1"), QStringLiteral("--preset"),
         QStringLiteral("dmu75-arrays")});
    MainWindow window(settings(), false);
    window.show();
    live::Setup setup;
    setup.address = "tcp:0";
    setup.agreement.lowestMm = {-20.0, -20.0, 0.0};
    setup.agreement.highestMm = {20.0, 20.0, 100.0};
    setup.agreement.feedMmPerMinMax = 3000.0;
    window.openLive(setup);
    window.connectTo(machine.endpoint());
    QTRY_COMPARE_WITH_TIMEOUT(window.startBlockedReason(), QString(), kSoonMs);
    const auto port =
        QString::fromStdString(window.program()->name).section(QLatin1Char(':'), 1).toUShort();
    constexpr int kPoints = 300;
    constexpr int kLead = 42;
    int mostAhead = 0;
    QByteArray last;
    std::thread sender([&] {
      QTcpSocket socket;
      socket.connectToHost(QStringLiteral("127.0.0.1"), port);
      if (!socket.waitForConnected(kSoonMs)) {
        return;
      }
      const auto nextReply = [&] {
        while (!socket.canReadLine() && socket.waitForReadyRead(kRunMs)) {
        }
        last = socket.readLine();
        return QJsonDocument::fromJson(last).object();
      };
      const QJsonObject start = nextReply();
      int executed = 0;
      for (int i = 1; i <= kPoints; ++i) {
        const double angle = 0.02 * i;
        const double xMm = start[QStringLiteral("x")].toDouble() + 8.0 * std::sin(angle);
        const double yMm = start[QStringLiteral("y")].toDouble() + 8.0 - 8.0 * std::cos(angle);
        socket.write("X" + QByteArray::number(xMm, 'f', 4) + " Y" +
                     QByteArray::number(yMm, 'f', 4) + "\n");
        socket.waitForBytesWritten(kSoonMs);
        while (i - executed >= kLead && !last.isEmpty() && !last.contains("\"end\"")) {
          executed = nextReply()[QStringLiteral("executed")].toInt();
        }
        mostAhead = std::max(mostAhead, i - executed);
      }
      socket.write("end\n");
      socket.waitForBytesWritten(kSoonMs);
      while (!last.isEmpty() && !last.contains("\"end\"")) {
        nextReply();
      }
    });
    QSignalSpy finished(&window, &MainWindow::runFinished);
    const bool hasStarted = window.start();
    const bool hasEnded = hasStarted && (!finished.isEmpty() || finished.wait(kRunMs));
    sender.join();
    QVERIFY(hasStarted && hasEnded);
    const auto report = window.lastReport();
    QVERIFY2(report->outcome == streaming::Outcome::Completed, report->error.text().c_str());
    QVERIFY(report->isFaultless());
    QCOMPARE(report->integrity.executed, std::size_t{kPoints});
    QCOMPARE(report->live->accepted, std::size_t{kPoints});
    QCOMPARE(report->live->delay.count, std::size_t{kPoints});
    QCOMPARE(mostAhead, kLead - 1);
    QVERIFY2(last.contains("\"end\":\"completed\""), last.constData());
  }

  /// A whole job, stopped while the control waits between two stretches. Another window, as after a
  /// restart, turns the spindle again and goes on.
  void stopsAWholeJobAndGoesOn() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE),
                                        {QStringLiteral("--seed"), QStringLiteral("1"),
                                         QStringLiteral("--preset"), QStringLiteral("dmu75-mill")});
    QFile file(m_folder.filePath(QStringLiteral("JOB.MPF")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        "G17 G90 G71\nG0 X0 Y0 Z45\nG1 Z40 F3000\nX20\nY10\nG0 Z45\nS500 M3\n"
        "G4 F3\nG0 X30 Y0 Z44\nG1 Z40 F3000\nX40\nM5\nM30\n");
    file.close();
    std::optional<MainWindow> first;
    MainWindow& window = first.emplace(settings(), false);
    window.show();
    streaming::StreamSettings stream;
    stream.programFeeds = true;
    stream.wholeJob = true;
    window.setStreamSettings(stream);
    window.openProgram(file.fileName());
    window.connectTo(machine.endpoint());
    QTRY_COMPARE_WITH_TIMEOUT(window.startBlockedReason(), QString(), kSoonMs);
    auto* state = window.findChild<QWidget*>(QStringLiteral("state"));
    QSignalSpy finished(&window, &MainWindow::runFinished);
    QVERIFY(window.start());
    QTRY_COMPARE_WITH_TIMEOUT(state->accessibleName(),
                              QStringLiteral("Running: the control, line 8"), kRunMs);
    QTest::keyClick(&window, Qt::Key_Escape);
    tests::endByHand(window);
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    const auto report = window.lastReport();
    QVERIFY2(report->outcome == streaming::Outcome::Stopped, report->error.text().c_str());
    QVERIFY(report->counters.executed > 0);
    QVERIFY(report->counters.executed < report->counters.total);
    QVERIFY(report->integrity.isFaultless());
    const auto kept = report::RunHistory().list().runs;
    QVERIFY(!kept.empty() && kept.front().jobTimes && !kept.front().recording.empty());
    QVERIFY(kept.front().judged);
    const std::size_t executed = report->counters.executed;
    const std::size_t total = report->counters.total;
    first.reset();
    MainWindow again(settings(), false);
    again.show();
    again.setStreamSettings(stream);
    again.connectTo(machine.endpoint());
    auto* button = again.findChild<QPushButton*>(QStringLiteral("found-resume"));
    QTRY_VERIFY_WITH_TIMEOUT(button->isVisible() && button->isEnabled(), kSoonMs);
    button->click();
    const auto* bar = again.findChild<widgets::ResumeBar*>();
    QTRY_VERIFY_WITH_TIMEOUT(bar->place(), kSoonMs);
    QCOMPARE(bar->place()->stretch, 2);
    QCOMPARE(bar->place()->point, executed);
    const auto& steps = bar->place()->steps;
    QVERIFY(std::find(steps.begin(), steps.end(), "S500 M3") != steps.end());
    QSignalSpy ended(&again, &MainWindow::runFinished);
    QTRY_COMPARE_WITH_TIMEOUT(again.resumeBlockedReason(), QString(), kSoonMs);
    QVERIFY(again.resume());
    QVERIFY(ended.wait(kRunMs));
    const auto rest = again.lastReport();
    QVERIFY2(rest->outcome == streaming::Outcome::Completed, rest->error.text().c_str());
    QVERIFY(rest->integrity.isFaultless());
    QCOMPARE(rest->integrity.executed, total - executed);
  }

  /// Tool, spindle, coolant and work offset, as the control has them at each moment of a job; when
  /// the connection is gone, they are not shown as present any more.
  void showsToolAndSpindle() {
    std::optional<tests::MachineProcess> machine;
    machine.emplace(QStringLiteral(RIVULET_MACHINE),
                    QStringList{QStringLiteral("--preset"), QStringLiteral("dmu75-mill")});
    QFile file(m_folder.filePath(QStringLiteral("TOOLS.MPF")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        "G17 G90 G71 G500\nT1 M6\nD1 G0 X0 Y0 Z45\nS1500 M3 M8\nG1 Z44 F300\nX10\nX0\nX10\n"
        "M5 M9\nT2 M6\nD1 S800 M4 M7\nG4 F2\nG0 X5\nG1 X6 F300\nM5 M9\nM30\n");
    file.close();
    MainWindow window(settings(), false);
    window.show();
    streaming::StreamSettings stream;
    stream.programFeeds = true;
    stream.wholeJob = true;
    window.setStreamSettings(stream);
    auto* tool = window.findChild<QWidget*>(QStringLiteral("tool"));
    auto* number = window.findChild<QLabel*>(QStringLiteral("tool-number"));
    auto* edge = window.findChild<QLabel*>(QStringLiteral("tool-detail"));
    auto* speed = window.findChild<QLabel*>(QStringLiteral("spindle-speed"));
    auto* set = window.findChild<QLabel*>(QStringLiteral("spindle-detail"));
    QVERIFY(!tool->isVisible());  // nothing is known yet
    window.openProgram(file.fileName());
    window.connectTo(machine->endpoint());
    QTRY_VERIFY_WITH_TIMEOUT(tool->isVisible(), kSoonMs);
    QTRY_COMPARE_WITH_TIMEOUT(window.startBlockedReason(), QString(), kSoonMs);
    QSignalSpy finished(&window, &MainWindow::runFinished);
    QVERIFY(window.start());
    // While the first stretch is streamed.
    const auto isShown = [](const QLabel* label, const char* text) {
      return label->text() == QString::fromUtf8(text) && !label->font().strikeOut();
    };
    QTRY_VERIFY_WITH_TIMEOUT(isShown(number, "1") && edge->text().startsWith(u"D1 · G500") &&
                                 isShown(speed, "↻ 1,500") && isShown(set, "set 1,500 · M8"),
                             kRunMs);
    QTRY_VERIFY_WITH_TIMEOUT(
        isShown(number, "2") && isShown(speed, "↺ 800") && isShown(set, "set 800 · M7"), kRunMs);
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    const auto report = window.lastReport();
    QVERIFY2(report->outcome == streaming::Outcome::Completed, report->error.text().c_str());
    QVERIFY(report->integrity.isFaultless());
    QTRY_VERIFY_WITH_TIMEOUT(
        isShown(speed, "0") && isShown(set, "set 0 · M9") && edge->text().startsWith(u"D0"),
        kSoonMs);
    machine.reset();
    QTRY_VERIFY_WITH_TIMEOUT(
        number->font().strikeOut() && speed->font().strikeOut() && set->font().strikeOut(),
        kSoonMs);
    QVERIFY(tool->toolTip().contains(QStringLiteral("may have changed")));
  }

  /// The machine says over the connection what it is: a job that it cannot do is not started.
  void aJobBeyondTheMachineIsNotStarted() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE),
                                        {QStringLiteral("--preset"), QStringLiteral("dmu75-mill")});
    QFile file(m_folder.filePath(QStringLiteral("BEYOND.MPF")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("G17 G90 G71\nT2 M6 D1\nG0 X0 Y0 Z45\nG1 Z40 F3000\nX500\nM30\n");
    file.close();
    MainWindow window(settings(), false);
    streaming::StreamSettings stream;
    stream.programFeeds = true;
    stream.wholeJob = true;
    window.setStreamSettings(stream);
    window.openProgram(file.fileName());
    window.connectTo(machine.endpoint());
    QTRY_VERIFY2_WITH_TIMEOUT(
        window.startBlockedReason().startsWith(QStringLiteral("Line 5 (part ")),
        qPrintable(window.startBlockedReason()), kSoonMs);
    QVERIFY(!window.start());
    QTRY_VERIFY_WITH_TIMEOUT(window.startBlockedReason().contains(QStringLiteral("X would go to")),
                             kSoonMs);
  }

  void wrongAddressIsSaid() {
    MainWindow window(settings(), false);
    auto* messages = window.findChild<widgets::AlarmLine*>();
    window.connectTo(QStringLiteral("opc.tcp://127.0.0.1:1"));
    QTRY_VERIFY_WITH_TIMEOUT(!messages->text().isEmpty(), kSoonMs);
    QVERIFY(!window.startBlockedReason().isEmpty());
  }
};

RIVULET_TEST(TestWindowOverOpcua)
#include "tst_window_over_opcua.moc"
