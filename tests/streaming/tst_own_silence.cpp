// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A client that stands still in the middle of a run, as on a computer that was suspended. In
/// virtual time: the link holds back what happens meanwhile.

#include <fmt/format.h>

#include <QtTest>
#include <utility>

#include "base/units.h"
#include "streaming/run/job.h"
#include "streaming/simulation/faulty_link.h"
#include "support/silent_run.h"
#include "support/sleepy_link.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::Duration;
using base::Instant;
using base::MethodKind;
using streaming::Outcome;

namespace {

streaming::RunReport run(MethodKind method, Duration asleep) {
  std::string text = "G90 G1 F1000\n";
  for (int i = 1; i <= 200; ++i) {
    text += fmt::format("X{:.1f} Y{:.1f} Z0\n", 0.5 * i, 0.1 * (i % 7));
  }
  const auto program = gcode::interpretProgram("line.mpf", text + "M30\n");
  streaming::RunSettings settings;
  settings.parameters.method = method;
  settings.feedMmPerS = base::mmPerSFromMmPerMin(1000.0);
  settings.isCommissioned = true;
  machine::Machine machine(*machine::loadPreset("ideal"), 1);
  streaming::FaultyLink link(machine, {}, 1);
  tests::SleepyLink sleepy(link, [once = asleep](Instant now) mutable {
    return now >= Instant{} + 3s ? std::exchange(once, Duration{}) : Duration{};
  });
  tests::SilentRun silent;
  return streaming::runJob(sleepy, link, *program, settings, silent, silent);
}

}  // namespace

class TestOwnSilence : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aMomentDelaysTheRun_data() { methods(); }
  void aMomentDelaysTheRun() {
    QFETCH(int, method);
    const auto report = run(static_cast<MethodKind>(method), opcua::kSilenceMax - 1s);
    QVERIFY2(report.isFaultless(), report.error.text().c_str());
    QCOMPARE(report.outcome, Outcome::Completed);
  }

  /// However much has come from the control meanwhile: who closed the lid is not at the machine.
  void longerEndsIt_data() { methods(); }
  void longerEndsIt() {
    QFETCH(int, method);
    const auto report = run(static_cast<MethodKind>(method), opcua::kSilenceMax + 1s);
    QCOMPARE(report.outcome, Outcome::Failed);
    QVERIFY(report.error.code == opcua::LinkError::ConnectionLost);
    QVERIFY2(report.error.message.find("did nothing for 11 s") != std::string::npos,
             report.error.message.c_str());
    QCOMPARE(report.integrity.repeated + report.integrity.skipped + report.integrity.foreign,
             std::size_t{0});
  }

 private:
  static void methods() {
    QTest::addColumn<int>("method");
    QTest::newRow("window") << static_cast<int>(MethodKind::Window);
    QTest::newRow("credit") << static_cast<int>(MethodKind::Credit);
  }
};

RIVULET_TEST(TestOwnSilence)
#include "tst_own_silence.moc"
