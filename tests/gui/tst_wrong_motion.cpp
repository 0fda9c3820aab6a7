// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A run that goes wrong, in the real window: on a virtual machine in virtual time whose accesses
/// take longer than the equations and the simulation before the start assume, and over OPC UA in
/// real time, when the network becomes slow. The window must say so while the run is in progress,
/// offer Stop, and not be ready before somebody has seen it.

#include <fmt/format.h>

#include <QDir>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>

#include "base/units.h"
#include "hmi/main_window.h"
#include "support/fault_proxy.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/simulated_control.h"
#include "support/test_program.h"
#include "widgets/alarms/alarm_line.h"
#include "widgets/streaming/wrong_motion_bar.h"

using namespace rivulet;
using hmi::MainWindow;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;
constexpr double kInteractivePace = 8.0;
constexpr int kPoints = 300;

hmi::Settings settingsOf(base::MethodKind method) {
  hmi::Settings settings;
  settings.language = QStringLiteral("en");
  settings.theme = widgets::Theme::Light;
  settings.stream.parameters.method = method;
  settings.stream.feedMmPerS = base::mmPerSFromMmPerMin(400.0);
  return settings;
}

machine::MachineConfig slowMachine() {
  constexpr int kTimesAsLong = 20;
  machine::MachineConfig machine = *machine::loadPreset("dmu75");
  machine.access.nodeTimeMean *= kTimesAsLong;
  machine.access.nodeTimeMin *= kTimesAsLong;
  return machine;
}

}  // namespace

class TestWrongMotion : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  /// A helix of moves of 2 mm.
  [[nodiscard]] QString program() const {
    const QString path = m_folder.filePath(QStringLiteral("helix.nc"));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
      qFatal("the program cannot be written");
    }
    std::string text("G1 X20 Y0 Z0 F1200\n");
    for (int i = 1; i < kPoints; ++i) {
      text += fmt::format("X{:.4f} Y{:.4f} Z{:.4f}\n", 20.0 * std::cos(0.1 * i),
                          20.0 * std::sin(0.1 * i), -0.02 * i);
    }
    file.write(text.c_str());
    return path;
  }

 private Q_SLOTS:
  void initTestCase() {
    qputenv("XDG_DATA_HOME", m_folder.path().toUtf8());
    qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toUtf8());
    QCoreApplication::setOrganizationName(QStringLiteral("RivuletTest"));
  }

  void itIsSaidDuringTheRun_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<bool>("isDark");
    QTest::newRow("position") << static_cast<int>(base::MethodKind::Position) << false;
    QTest::newRow("signal") << static_cast<int>(base::MethodKind::Signal) << true;
  }
  void itIsSaidDuringTheRun() {
    QFETCH(int, method);
    QFETCH(bool, isDark);
    QDir(m_folder.filePath(QStringLiteral("state"))).removeRecursively();
    tests::SimulatedControl machine(slowMachine(), kInteractivePace);
    hmi::Settings settings = settingsOf(static_cast<base::MethodKind>(method));
    settings.theme = isDark ? widgets::Theme::Dark : widgets::Theme::Light;
    MainWindow window(settings, false,
                      [&machine](const auto& asked) { return machine.connect(asked.endpoint); });
    window.resize(1280, 800);
    window.show();
    window.connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    window.openProgram(program());
    QTRY_COMPARE_WITH_TIMEOUT(window.startBlockedReason(), QString(), kSoonMs);
    QSignalSpy finished(&window, &MainWindow::runFinished);
    QVERIFY(window.start());
    QTRY_VERIFY_WITH_TIMEOUT(window.lastUpdate().wrong || finished.count() > 0, kRunMs);

    const auto* state = window.findChild<QWidget*>(QStringLiteral("state"));
    const auto* line = window.findChild<widgets::AlarmLine*>();
    auto* stop = window.findChild<QPushButton*>(QStringLiteral("wrong-stop"));
    QVERIFY(window.isRunning());
    QVERIFY(window.lastUpdate().counters.executed < window.lastUpdate().counters.total);
    QCOMPARE(state->accessibleName(), QStringLiteral("Wrong motion. Running"));
    QVERIFY2(line->text().contains(QStringLiteral("Wrong motion in helix.nc after point")),
             qPrintable(line->text()));
    QVERIFY(stop->isVisible() && stop->isEnabled());
    QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS));
    for (int pass = 0; pass < 5; ++pass) {
      QCoreApplication::processEvents();  // layouts settle in several steps
    }
    window.grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/wrong-motion-%1.png")
                           .arg(QLatin1String(QTest::currentDataTag())));
    QTest::mouseClick(stop, Qt::LeftButton);
    QVERIFY(finished.count() > 0 || finished.wait(kRunMs));
    QVERIFY(window.lastReport()->outcome == streaming::Outcome::Stopped);
    QVERIFY(window.lastReport()->wrong.has_value());
    QVERIFY(!window.lastReport()->integrity.isFaultless());
    QVERIFY(state->accessibleName().startsWith(QStringLiteral("Wrong motion. Stopped at")));
    auto* acknowledge = window.findChild<QPushButton*>(QStringLiteral("wrong-acknowledge"));
    QVERIFY(acknowledge->isVisible() && !stop->isVisible());
    QTest::mouseClick(acknowledge, Qt::LeftButton);
    QVERIFY(!acknowledge->isVisible());
    QVERIFY(state->accessibleName().startsWith(QStringLiteral("Stopped at")));
  }

  void itIsSaidOverOpcUa() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE),
                                        {QStringLiteral("--seed"), QStringLiteral("1")});
    tests::FaultProxy proxy(machine.endpoint().toStdString());
    MainWindow window(settingsOf(base::MethodKind::Position), false);
    window.show();
    window.openProgram(program());
    window.connectTo(QString::fromStdString(proxy.endpoint()));
    QTRY_COMPARE_WITH_TIMEOUT(window.startBlockedReason(), QString(), kSoonMs);
    QSignalSpy finished(&window, &MainWindow::runFinished);
    QVERIFY(window.start());
    QTRY_VERIFY_WITH_TIMEOUT(window.lastUpdate().counters.executed >= 7, kRunMs);
    QVERIFY(!window.lastUpdate().wrong);
    tests::NetworkFault slow;
    slow.kind = tests::FaultKind::Delay;
    slow.duration = std::chrono::hours(1);
    slow.delay = std::chrono::milliseconds(150);
    proxy.begin(slow);
    QTRY_VERIFY_WITH_TIMEOUT(window.lastUpdate().wrong || finished.count() > 0, kRunMs);
    QVERIFY(window.isRunning() && window.lastUpdate().wrong);
    const auto* line = window.findChild<widgets::AlarmLine*>();
    QVERIFY(line->text().contains(QStringLiteral("Wrong motion in helix.nc after point")));
    QTest::mouseClick(window.findChild<QPushButton*>(QStringLiteral("wrong-stop")), Qt::LeftButton);
    QVERIFY(finished.count() > 0 || finished.wait(kRunMs));
    QVERIFY(window.lastReport()->outcome == streaming::Outcome::Stopped);
    QVERIFY(!window.lastReport()->integrity.isFaultless());
  }
};

RIVULET_TEST(TestWrongMotion)
#include "tst_wrong_motion.moc"
