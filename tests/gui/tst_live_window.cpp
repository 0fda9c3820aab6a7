// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Live points in the window: a real socket, the real window, a virtual machine in virtual time. A
/// source that is silent, that sends rubbish or goes away, and a connection that is cut.

#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>

#include "base/file.h"
#include "gui/end_by_hand.h"
#include "hmi/main_window.h"
#include "live/error.h"
#include "opcua/error.h"
#include "report/run_history.h"
#include "support/patience.h"
#include "support/patient_sender.h"
#include "support/simulated_control.h"
#include "support/test_program.h"
#include "trace/recording.h"
#include "widgets/alarms/alarm_line.h"
#include "widgets/common/hold_button.h"
#include "widgets/common/status_label.h"
#include "widgets/live/live_dialog.h"
#include "widgets/live/live_panel.h"
#include "widgets/program/path_view.h"
#include "widgets/program/program_page.h"
#include "widgets/program/program_panel.h"
#include "widgets/streaming/preflight_sheet.h"

using namespace rivulet;
using namespace std::chrono_literals;
using hmi::MainWindow;
using streaming::Outcome;
using streaming::RunReport;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;
/// Seconds of the machine in one second, where a test acts in the middle of a run.
constexpr double kPace = 4.0;

hmi::Settings settings() {
  hmi::Settings settings;
  settings.language = QStringLiteral("en");
  settings.theme = widgets::Theme::Light;
  return settings;
}

/// Any free port; the tool of the virtual machine stands at X0 Y0 Z50.
live::Setup agreed() {
  live::Setup setup;
  setup.address = "tcp:0";
  setup.agreement.lowestMm = {-20.0, -20.0, 40.0};
  setup.agreement.highestMm = {20.0, 20.0, 60.0};
  setup.agreement.feedMmPerMinMax = 3000.0;
  return setup;
}

/// Points of a circle that begins at the tool. @param from  number of the first
QByteArray circle(int from, int count) {
  QByteArray lines;
  for (int i = from; i < from + count; ++i) {
    const double angle = 0.05 * i;
    lines += QByteArrayLiteral("X") + QByteArray::number(8.0 * std::sin(angle), 'f', 4) +
             QByteArrayLiteral(" Y") + QByteArray::number(8.0 - 8.0 * std::cos(angle), 'f', 4) +
             QByteArrayLiteral(" F2400\n");
  }
  return lines;
}

}  // namespace

class TestLiveWindow : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<tests::SimulatedControl> m_machine;
  std::unique_ptr<MainWindow> m_window;
  std::unique_ptr<QTcpSocket> m_sender;

  [[nodiscard]] widgets::LivePanel* panel() const { return m_window->programPage()->livePanel(); }
  [[nodiscard]] QString state() const {
    return panel()->findChild<widgets::StatusLabel*>(QStringLiteral("live-state"))->text();
  }
  [[nodiscard]] QString alarm() const { return m_window->findChild<widgets::AlarmLine*>()->text(); }
  [[nodiscard]] std::size_t drawn() const {
    const QSlider* slider = m_window->programPage()->path()->slider();
    return static_cast<std::size_t>(slider->maximum()) + 1;
  }

  /// A source that listens, a machine that waits, and a sender that is connected.
  void open(const live::Setup& setup = agreed()) {
    m_window->openLive(setup);
    m_window->connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
    connectSender();
  }
  void connectSender() {
    const QString port =
        QString::fromStdString(m_window->program()->name).section(QLatin1Char(':'), 1);
    m_sender = std::make_unique<QTcpSocket>();
    m_sender->connectToHost(QStringLiteral("127.0.0.1"), port.toUShort());
    QVERIFY(m_sender->waitForConnected(kSoonMs));
  }
  void send(const QByteArray& text) {
    m_sender->write(text);
    while (m_sender->bytesToWrite() > 0 && m_sender->waitForBytesWritten(kSoonMs)) {
    }
  }
  std::shared_ptr<const RunReport> runToEnd() {
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    if (!m_window->start()) {
      return nullptr;
    }
    return waitForEnd(finished);
  }
  std::shared_ptr<const RunReport> waitForEnd(QSignalSpy& finished) {
    return finished.isEmpty() && !finished.wait(kRunMs) ? nullptr : m_window->lastReport();
  }

 private Q_SLOTS:
  void initTestCase() { QCoreApplication::setOrganizationName(QStringLiteral("RivuletTest")); }
  void init() {
    QDir(qEnvironmentVariable("XDG_STATE_HOME")).removeRecursively();
    m_machine = std::make_unique<tests::SimulatedControl>("dmu75-arrays");
    m_window = std::make_unique<MainWindow>(
        settings(), false,
        [this](const opcua::ConnectRequest& asked) { return m_machine->connect(asked.endpoint); });
    m_window->resize(1280, 800);
    m_window->show();
  }
  void cleanup() {
    m_sender.reset();
    m_window.reset();
    m_machine.reset();
  }

  /// All of it by hand: the dialog, the preflight, press and hold.
  void everyPointIsExecutedOnce() {
    Q_EMIT m_window->programPage()->panel()->liveRequested();
    auto* dialog = m_window->findChild<widgets::LiveDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    QCOMPARE(dialog->locale(), QLocale());  // its numbers are those of the language
    dialog->findChild<QSpinBox*>(QStringLiteral("live-port"))->setValue(0);
    dialog->findChild<QDoubleSpinBox*>(QStringLiteral("live-z-from"))->setValue(40.0);
    dialog->findChild<QDoubleSpinBox*>(QStringLiteral("live-z-to"))->setValue(60.0);
    dialog->findChild<QDoubleSpinBox*>(QStringLiteral("live-y-to"))->setValue(20.0);
    dialog->findChild<QDoubleSpinBox*>(QStringLiteral("live-feed"))->setValue(3000.0);
    QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("live-open")), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(panel()->isVisible(), kSoonMs);
    QVERIFY(m_window->program()->name.starts_with("tcp:"));
    m_window->connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
    connectSender();
    m_machine->setPace(kPace);
    constexpr int kPoints = 400;
    send(circle(1, kPoints / 2));

    auto* start = m_window->findChild<widgets::HoldButton*>(QStringLiteral("start"));
    QTest::mouseClick(start, Qt::LeftButton);
    const auto* sheet = m_window->findChild<widgets::PreflightSheet*>();
    QVERIFY(sheet->isVisible());
    QStringList said;
    for (const auto* label : sheet->findChildren<QLabel*>()) {
      said.append(label->text());
    }
    QVERIFY2(said.join(QLatin1Char('\n')).contains(QStringLiteral("40.000 to 60.000")),
             qPrintable(said.join(QLatin1Char('\n'))));
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QTest::mousePress(start, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isRunning(), kSoonMs);
    QTest::mouseRelease(start, Qt::LeftButton);

    // More points wait than there is room for: the buffer is full, the sender has to wait.
    const auto* buffer = panel()->findChild<QProgressBar*>(QStringLiteral("live-buffer"));
    QTRY_VERIFY_WITH_TIMEOUT(buffer->value() > 0, kSoonMs);
    QTRY_COMPARE_WITH_TIMEOUT(state(), QStringLiteral("Receiving"), kSoonMs);
    const auto* median = panel()->findChild<QLabel*>(QStringLiteral("live-median"));
    QTRY_VERIFY_WITH_TIMEOUT(median->text().endsWith(QStringLiteral("ms")), kSoonMs);
    const auto* out = panel()->findChild<QLabel*>(QStringLiteral("live-out"));
    QTRY_VERIFY_WITH_TIMEOUT(out->text().endsWith(QStringLiteral("/s")), kSoonMs);
    // The path has grown, but the second half is not even sent.
    QTRY_VERIFY_WITH_TIMEOUT(drawn() > 20 && drawn() <= kPoints / 2, kSoonMs);
    send(circle(1 + kPoints / 2, kPoints / 2) + "end\n");
    m_machine->setPace(tests::SimulatedControl::kUnlimited);
    const auto report = waitForEnd(finished);
    QVERIFY(report);
    QVERIFY2(report->outcome == Outcome::Completed, report->error.text().c_str());
    QVERIFY(report->isFaultless());
    QCOMPARE(report->integrity.executed, std::size_t{kPoints});
    QCOMPARE(report->counters.executed, std::size_t{kPoints});
    QCOMPARE(report->live->accepted, std::size_t{kPoints});
    QCOMPARE(report->live->delay.count, std::size_t{kPoints});
    QTRY_COMPARE_WITH_TIMEOUT(drawn(), std::size_t{kPoints}, kSoonMs);
    // It is kept like any other run.
    const auto runs = report::RunHistory().list().runs;
    QCOMPARE(runs.size(), std::size_t{1});
    QCOMPARE(runs.front().executed, std::size_t{kPoints});
    const auto kept = report::readFinishedRun(report::RunHistory().reportFile(runs.front().id));
    QVERIFY(kept && kept->report.live);
    QCOMPARE(kept->report.live->accepted, std::size_t{kPoints});
    QCOMPARE(kept->report.live->lastLine, report->live->lastLine);
    QFile file(QString::fromStdString(runs.front().recording));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const auto recording = trace::parseRecording(file.readAll().toStdString());
    QVERIFY(recording && recording->end.has_value());
    // The sender has been told, and the same port is open for the next run.
    QByteArray told;
    const auto hasBeenTold = [&] {
      told += m_sender->readAll();
      return told.contains("\"end\":\"completed\"");
    };
    QTRY_VERIFY_WITH_TIMEOUT(hasBeenTold(), kSoonMs);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
  }

  void theNextRunBeginsAnew() {
    open();
    for (int run = 0; run < 2; ++run) {
      send((run == 0 ? circle(1, 30) : QByteArray("X1.6 Y9\n")) + "end\n");
      const auto report = run == 0 ? runToEnd() : nullptr;
      if (run == 0) {
        QVERIFY(report && report->isFaultless());
        QCOMPARE(report->integrity.executed, std::size_t{30});
        QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
        connectSender();
      }
    }
    // Its first point is far from the tool: nothing moves, and nothing of the first run is left.
    const auto refused = runToEnd();
    QVERIFY(refused && refused->outcome == Outcome::Failed);
    QVERIFY(refused->error.code == live::LiveError::TooFarAway);
    QCOMPARE(refused->counters.executed, std::size_t{0});
    QTRY_COMPARE_WITH_TIMEOUT(m_window->programPage()->path()->slider()->maximum(), 0, kSoonMs);
  }

  void rubbishEndsBehindTheLastGoodPoint_data() {
    QTest::addColumn<QByteArray>("rubbish");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char* name, const char* text, live::LiveError code,
                        const char* sentence) {
      QTest::newRow(name) << QByteArray(text) << static_cast<int>(code)
                          << QString::fromLatin1(sentence);
    };
    row("nan", "Xnan\n", live::LiveError::NotFinite, "line 31");
    row("box", "Z39\n", live::LiveError::OutsideBox, "line 31");
    row("text", "hello\n", live::LiveError::NotALine, "line 31");
    row("feed", "X8 F30000\n", live::LiveError::FeedTooLarge, "line 31");
    row("half a line", "X8.", live::LiveError::Incomplete, "line 31");
    row("gone", "", live::LiveError::SourceClosed, "line 30");
  }
  void rubbishEndsBehindTheLastGoodPoint() {
    QFETCH(QByteArray, rubbish);
    QFETCH(int, code);
    QFETCH(QString, sentence);
    open();
    send(circle(1, 30) + rubbish);
    m_sender->disconnectFromHost();
    const auto report = runToEnd();
    QVERIFY(report && report->outcome == Outcome::Failed);
    QVERIFY2(report->error.code == static_cast<live::LiveError>(code),
             report->error.text().c_str());
    QCOMPARE(report->counters.executed, std::size_t{30});
    QCOMPARE(report->integrity.executed, std::size_t{30});
    QVERIFY(report->integrity.isFaultless());
    QTRY_VERIFY2_WITH_TIMEOUT(alarm().contains(sentence), qPrintable(alarm()), kSoonMs);
    QVERIFY2(state().contains(sentence), qPrintable(state()));
    // Another sender can try again.
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
  }

  void aSilentSourceHoldsTheRunUntilItsNextPoint() {
    live::Setup setup = agreed();
    setup.limits.endAfter = 3600s;
    open(setup);
    m_machine->setPace(kPace);
    send(circle(1, 20));
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().state == streaming::RunState::Holding, kRunMs);
    QCOMPARE(m_window->lastUpdate().counters.executed, std::size_t{20});
    QTRY_VERIFY2_WITH_TIMEOUT(state().startsWith(QStringLiteral("Silent for ")),
                              qPrintable(state()), kSoonMs);
    // Continue would be a lie: it goes on by itself.
    QCOMPARE(m_window->findChild<QPushButton*>(QStringLiteral("hold"))->text(),
             QStringLiteral("Pause"));
    send(circle(21, 20) + "end\n");
    const auto report = waitForEnd(finished);
    QVERIFY(report && report->isFaultless());
    QCOMPARE(report->integrity.executed, std::size_t{40});
  }

  void aSourceThatStaysSilentEndsTheRun() {
    open();
    send(circle(1, 20));
    const auto report = runToEnd();
    QVERIFY(report && report->outcome == Outcome::Failed);
    QVERIFY(report->error.code == live::LiveError::SourceSilent);
    QCOMPARE(report->counters.executed, std::size_t{20});
    QVERIFY(report->integrity.isFaultless());
  }

  void stopAndHoldWorkAsEver() {
    open();
    m_machine->setPace(kPace);
    send(circle(1, 2000));
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed > 20, kRunMs);
    auto* hold = m_window->findChild<QPushButton*>(QStringLiteral("hold"));
    QTest::mouseClick(hold, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(hold->text(), QStringLiteral("Continue"), kRunMs);
    QTest::mouseClick(hold, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(hold->text(), QStringLiteral("Pause"), kRunMs);
    QTest::keyClick(m_window.get(), Qt::Key_Escape);
    tests::endByHand(*m_window);
    const auto report = waitForEnd(finished);
    QVERIFY(report && report->outcome == Outcome::Stopped);
    QVERIFY(report->integrity.isFaultless());
    QVERIFY(report->integrity.executed < 2000);
    // A live run cannot be resumed: its points are not known any longer.
    QVERIFY(!m_window->findChild<QPushButton*>(QStringLiteral("resume"))->isVisible());
  }

  void aPulledLinkEndsTheRun() {
    open();
    m_machine->setPace(kPace);
    send(circle(1, 2000));
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed > 20, kRunMs);
    m_machine->cut();
    const auto report = waitForEnd(finished);
    QVERIFY(report && report->outcome == Outcome::Failed);
    QVERIFY(report->error.code == opcua::LinkError::ConnectionLost);
    QTRY_VERIFY_WITH_TIMEOUT(!alarm().isEmpty(), kSoonMs);
    // The source waits for the connection.
    m_window->connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    QTRY_VERIFY_WITH_TIMEOUT(state().startsWith(QStringLiteral("The run has ended")), kSoonMs);
  }

  void whatCannotBeOpenedIsSaid() {
    QTcpServer other;
    QVERIFY(other.listen(QHostAddress::LocalHost));
    live::Setup setup = agreed();
    setup.address = "tcp:" + std::to_string(other.serverPort());
    m_window->openLive(setup);
    QTRY_VERIFY2_WITH_TIMEOUT(alarm().contains(QStringLiteral("cannot be opened")),
                              qPrintable(alarm()), kSoonMs);
    QVERIFY(!m_window->program());
    // A program takes the place of a source, whose port is free again then.
    open();
    const std::string name = m_window->program()->name;
    m_window->openProgram(QStringLiteral(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap"));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->program()->name == "scorpion.tap", kSoonMs);
    QVERIFY(!panel()->isVisible());
    const auto port = QString::fromStdString(name).section(QLatin1Char(':'), 1).toUShort();
    QTRY_VERIFY_WITH_TIMEOUT(QTcpServer().listen(QHostAddress::LocalHost, port), kSoonMs);
  }

  /// The server is there between two runs, and what is left in its variables is old.
  void variablesOfAServerBringTwoRuns() {
    tests::PatientSender sender;
    const tests::PlainServer server(tests::kNumbers, {}, std::ref(sender));
    const QTemporaryDir folder;
    const std::string file = folder.filePath(QStringLiteral("source.toml")).toStdString();
    QVERIFY(base::writeFile(
        file, "endpoint = \"" + server.endpoint() + "\"\n" + tests::kWords + tests::kReplies));
    live::Setup setup = agreed();
    setup.address = "opcua:" + file;
    setup.agreement.startMmMax = 20.0;  // the second run goes back to the beginning
    m_window->openLive(setup);
    m_window->connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    for (int run = 0; run < 2; ++run) {
      QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
      const auto report = runToEnd();
      QVERIFY(report);
      QVERIFY2(report->outcome == Outcome::Completed, report->error.text().c_str());
      QVERIFY(report->isFaultless());
      QCOMPARE(report->integrity.executed, std::size_t{tests::kPoints});
    }
    setup.address = "opcua:" + file + ".none";
    m_window->openLive(setup);
    QTRY_VERIFY2_WITH_TIMEOUT(alarm().contains(QStringLiteral(".none")), qPrintable(alarm()),
                              kSoonMs);
  }

  void onlyMethodsThatWaitTakeLivePoints() {
    open();
    streaming::StreamSettings stream;
    stream.parameters.method = base::MethodKind::Signal;
    stream.parameters.pointsPerLoop = 7;
    m_window->setStreamSettings(stream);
    QVERIFY2(m_window->startBlockedReason().contains(QStringLiteral("choose method window")),
             qPrintable(m_window->startBlockedReason()));
    QVERIFY(!m_window->start());
  }
};

RIVULET_TEST(TestLiveWindow)
#include "tst_live_window.moc"
