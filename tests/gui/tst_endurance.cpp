// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// How much memory the window needs after hours of runs, in virtual time. Skipped unless
/// RIVULET_ENDURANCE_HOURS says for how long: eight hours take some minutes.

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "base/instant.h"
#include "hmi/main_window.h"
#include "support/patience.h"
#include "support/simulated_control.h"
#include "support/test_program.h"

using namespace rivulet;
using hmi::MainWindow;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;
const QString kScorpion = QStringLiteral(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");

/// Memory of this process that is in the main memory, MiB.
double residentMiB() {
  QFile file(QStringLiteral("/proc/self/status"));
  if (!file.open(QIODevice::ReadOnly)) {
    return 0.0;
  }
  for (const QByteArray& line : file.readAll().split('\n')) {
    if (line.startsWith("VmRSS:")) {
      constexpr double kKiBPerMiB = 1024.0;
      return line.mid(6).trimmed().split(' ').front().toDouble() / kKiBPerMiB;
    }
  }
  return 0.0;
}

}  // namespace

class TestEndurance : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

 private Q_SLOTS:
  void initTestCase() {
    qputenv("XDG_DATA_HOME", m_folder.path().toUtf8());
    qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toUtf8());
    qputenv("XDG_CONFIG_HOME", m_folder.path().toUtf8());
  }

  void memoryStaysFlat() {
    const double hours = qEnvironmentVariable("RIVULET_ENDURANCE_HOURS").toDouble();
    if (!(hours > 0.0)) {
      QSKIP("RIVULET_ENDURANCE_HOURS is not set.");
    }
    tests::SimulatedControl machine("dmu75");
    hmi::Settings settings;
    settings.language = QStringLiteral("en");
    settings.stream.parameters.method = base::MethodKind::Window;
    settings.stream.feedMmPerS = 2.0;
    MainWindow window(settings, false,
                      [&machine](const auto& asked) { return machine.connect(asked.endpoint); });
    window.show();
    window.openProgram(kScorpion);
    window.connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    QSignalSpy finished(&window, &MainWindow::runFinished);
    double passedS = 0.0;
    double nextS = 0.0;
    for (int run = 0; passedS < 3600.0 * hours; ++run) {
      QTRY_COMPARE_WITH_TIMEOUT(window.startBlockedReason(), QString(), kSoonMs);
      if (passedS >= nextS) {
        qInfo("%5.2f h, %d runs: %.1f MiB", passedS / 3600.0, run, residentMiB());
        nextS += 1800.0;
      }
      finished.clear();
      QVERIFY(window.start());
      QVERIFY(!finished.isEmpty() || finished.wait(2 * kRunMs));
      QVERIFY(window.lastReport()->outcome == streaming::Outcome::Completed);
      passedS += base::toSeconds(window.lastReport()->duration);
    }
    qInfo("%5.2f h: %.1f MiB", passedS / 3600.0, residentMiB());
  }
};

RIVULET_TEST(TestEndurance)
#include "tst_endurance.moc"
