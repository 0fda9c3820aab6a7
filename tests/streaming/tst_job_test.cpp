// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The test of whole jobs: virtual machines pass it, and each wrong control is caught by the check
/// that is meant for it.

#include <QtTest>
#include <cmath>

#include "job/main_program.h"
#include "machine/machine.h"
#include "opcua/await.h"
#include "streaming/run/run.h"
#include "streaming/setup/job_test.h"
#include "streaming/simulation/simulated_link.h"
#include "support/misread_link.h"
#include "support/test_program.h"
#include "templates/target.h"

using namespace rivulet;
using namespace std::chrono_literals;
using streaming::JobCommissioning;
using streaming::JobTestPlan;
using streaming::JobTestTalk;
using streaming::StreamError;
using streaming::Witness;

namespace {

struct World {
  explicit World(const char* preset = "dmu75-mill")
      : machine(*machine::loadPreset(preset), 1), link(machine) {}

  static JobTestPlan planOf(const QStringList& blocks) {
    JobTestPlan plan;
    plan.firstCell = 20;
    plan.move = {0, 20.0, 400.0};
    for (const QString& block : blocks) {
      plan.blocks.push_back(block.toStdString());
    }
    return plan;
  }
  base::Result<JobCommissioning> test(const QStringList& blocks = {}) {
    return streaming::testJobs(link, link, planOf(blocks), talk);
  }
  base::Result<JobCommissioning> test(const QString& written, const QString& read,
                                      const QStringList& blocks = {}) {
    tests::MisreadLink misread(link, written.toStdString(), read.toStdString());
    return streaming::testJobs(misread, misread, planOf(blocks), talk);
  }

  machine::Machine machine;
  streaming::SimulatedLink link;
  JobTestTalk talk;
};

std::string textOf(const JobCommissioning& result) {
  std::string text;
  for (const auto& check : result.checks) {
    text += (check.passed ? "holds " : "FAILS ") + check.name + ": " + check.message + '\n';
  }
  for (const auto& block : result.tried) {
    text +=
        std::string(witnessName(block.witness)) + ' ' + block.text + ": " + block.message + '\n';
  }
  return text;
}

}  // namespace

class TestJobTest : public QObject {
  Q_OBJECT

 private slots:
  void virtualMachinesPass_data() {
    QTest::addColumn<QString>("preset");
    for (const std::string& name : machine::presetNames()) {
      QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
  }
  void virtualMachinesPass() {
    QFETCH(QString, preset);
    World world(preset.toLatin1().constData());
    const base::Vec3 before = world.machine.state().commandMm;
    const auto result = world.test();
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QVERIFY2(result->passed(), textOf(*result).c_str());
    QCOMPARE(result->checks.size(), std::size_t{11});
    QVERIFY(base::distance(before, world.machine.state().commandMm) < 1e-6);
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Reset);
  }

  void wrongControlsFail_data() {
    QTest::addColumn<QString>("written");
    QTest::addColumn<QString>("read");
    QTest::addColumn<QString>("caughtBy");
    const auto row = [](const char* name, const char* written, const char* read,
                        const char* caughtBy) {
      QTest::newRow(name) << QString::fromLatin1(written) << QString::fromLatin1(read)
                          << QString::fromLatin1(caughtBy);
    };
    row("skips a dwell", "\nG4 F2\n", "\n", "executes-blocks");
    row("skips a block that moves", "COMPOF G1 X", ";", "hand-over");
    row("loses the number of a stretch", "R29=RIV_JOB*10000+RIV_STR", "R29=RIV_JOB*10000",
        "hand-over");
    row("does not wait for its client", "IF (RIV_STR==0) AND (R20==1)", "IF (RIV_STR==0)",
        "waits-for-client");
    row("executes a block early", "IF R20==RIV_STR+3 GOTOF RIV_RETURN", "GOTOF RIV_RETURN",
        "waits-after-stretch");
    row("keeps the override", "\nID=", "\nIDS=", "ends-with-job");
    row("ignores a stop between blocks", "IF R20==2 GOTOF RIV_END", "", "stopped-in-block");
    row("forgets a stop in a stretch", "RIV_STOPPED:\nR25=2", "RIV_STOPPED:\nR20=1 R25=1",
        "stopped-in-stretch");
    row("restarts the subprogram", "RIV_RETURN:\n",
        "RIV_RETURN:\nR98=R98+1\nIF R98==2 GOTOB RIV_NEXT\n", "hand-over");
    row("the timer stands", "($AC_TIMER[1]>=0) AND ($AC_TIMER[1]<=1)",
        "($AC_PARAM[9]>=0) AND ($AC_PARAM[9]<=1)", "silence-in-block");
    row("blocks do not obey the override", "ID=5 DO $AC_OVR=$R31",
        "ID=5 WHENEVER $R29>0 DO $AC_OVR=$R31", "silence-in-block");
    row("stretches do not obey the override", "ID=5 DO $AC_OVR=$R31",
        "ID=5 WHENEVER $R29<=0 DO $AC_OVR=$R31", "silence-in-stretch");
    row("silence is obeyed, and no hold", "ID=5 DO $AC_OVR=$R31",
        "ID=5 WHENEVER ($R31>0) OR ($AC_TIMER[1]>1) DO $AC_OVR=$R31", "held-in-stretch");
  }
  void wrongControlsFail() {
    QFETCH(QString, written);
    QFETCH(QString, read);
    QFETCH(QString, caughtBy);
    World world;
    const auto result = world.test(written, read);
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QVERIFY2(!result->passed(), textOf(*result).c_str());
    QVERIFY2(result->checks.back().name == caughtBy.toStdString(), textOf(*result).c_str());
    QVERIFY(!result->releases({}));
  }

  void whatWasTriedIsReleased() {
    World world;
    QStringList asked;
    world.talk.hasSeen = [&asked](const std::string& block) -> std::optional<bool> {
      asked << QString::fromStdString(block);
      return block == "M27" ? std::optional(true) : std::nullopt;
    };
    const auto result =
        world.test({QStringLiteral("S500 M3"), QStringLiteral("M5"), QStringLiteral("M8"),
                    QStringLiteral("M27"), QStringLiteral("M28"), QStringLiteral("M0"),
                    QStringLiteral("T1 M6\nD1\nG41 G1 X5 Y5\nG40 X0 Y0")});
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QVERIFY2(result->passed(), textOf(*result).c_str());
    QCOMPARE(result->tried.size(), std::size_t{7});
    QCOMPARE(asked, (QStringList{QStringLiteral("M27"), QStringLiteral("M28")}));
    for (const streaming::TriedBlock& block : result->tried) {
      const Witness expected = block.text == "M28"   ? Witness::Nobody
                               : block.text == "M27" ? Witness::Operator
                                                     : Witness::Control;
      QVERIFY2(block.witness == expected, textOf(*result).c_str());
    }
    const auto releases = [&result](job::NativeReason reason, const char* text) {
      job::NativeBlock block;
      block.reason = reason;
      block.text = text;
      return result->releases(block);
    };
    using job::NativeReason;
    QVERIFY(releases(NativeReason::Spindle, "S900 M4"));
    QVERIFY(releases(NativeReason::Coolant, "M9"));
    QVERIFY(releases(NativeReason::Stop, "M1"));
    QVERIFY(releases(NativeReason::RadiusCompensation, "G42 X1"));
    QVERIFY(releases(NativeReason::Dwell, "G4 F1"));
    QVERIFY(releases(NativeReason::Other, "M27"));
    QVERIFY(!releases(NativeReason::Other, "M28"));
    QVERIFY(!releases(NativeReason::Other, "M29"));
    QVERIFY(releases(NativeReason::Tool, "T2 M6"));
    QVERIFY(!releases(NativeReason::WorkOffset, "G54"));
    QVERIFY(!releases(NativeReason::Cycle, "CYCLE81(1,0,1,-5)"));
  }

  /// A line of it that shows nothing is not released by one that does.
  void everyKindOfABlockHasToBeSeen() {
    World world;
    const auto result = world.test({QStringLiteral("S500 M3\nM27"), QStringLiteral("M5\nG4 F1")});
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QVERIFY2(result->passed() && result->tried.size() == 2, textOf(*result).c_str());
    QVERIFY2(result->tried[0].witness == Witness::Nobody, textOf(*result).c_str());
    QVERIFY2(result->tried[1].witness == Witness::Control, textOf(*result).c_str());
  }

  /// It takes the axis elsewhere, and nothing that was meant for its place before moves it.
  void aBlockThatMovesTheAxisEndsTheTest() {
    World world;
    const auto result = world.test({QStringLiteral("SUPA G0 X100 Y100"), QStringLiteral("M8")});
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QVERIFY2(result->passed(), textOf(*result).c_str());
    QCOMPARE(result->tried.size(), std::size_t{1});
    QVERIFY(result->tried[0].witness == Witness::Control);
    QVERIFY(std::abs(world.machine.state().commandMm[0] - 0.0) > 1.0);
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Reset);
  }

  void aBlockThatIsNotExecutedIsNotReleased() {
    World world;
    world.talk.hasSeen = [](const std::string&) { return std::optional(false); };
    const auto result =
        world.test(QStringLiteral("S500 M3"), QStringLiteral("; "), {QStringLiteral("S500 M3")});
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QVERIFY2(!result->passed(), textOf(*result).c_str());
    QVERIFY(result->checks.back().name == "executes-blocks");
  }

  void badBlocksAreRefused_data() {
    QTest::addColumn<QString>("block");
    QTest::newRow("streamed") << QStringLiteral("G1 X5");
    QTest::newRow("ends the program") << QStringLiteral("M30");
    QTest::newRow("nothing") << QStringLiteral("; S500 M3");
    QTest::newRow("half of it streamed") << QStringLiteral("M8\nG1 X5");
    QTest::newRow("a jump") << QStringLiteral("GOTOB AGAIN");
    QTest::newRow("another frame") << QStringLiteral("TRANS X100");
    QTest::newRow("a variable") << QStringLiteral("R1=5");
  }
  void badBlocksAreRefused() {
    QFETCH(QString, block);
    World world;
    const auto result = world.test({block});
    QVERIFY2(!result, result ? textOf(*result).c_str() : "");
    QVERIFY(world.machine.trace().blocks.empty());
  }

  /// The move stays the one that was agreed to, whatever a block sets.
  void blocksDoNotChangeTheMove_data() {
    QTest::addColumn<QString>("block");
    QTest::newRow("increments") << QStringLiteral("G91 M8");
    QTest::newRow("inches") << QStringLiteral("G70 M8");
    QTest::newRow("per revolution") << QStringLiteral("S500 M3 G95 F0.1");
    QTest::newRow("rapid") << QStringLiteral("G0 M8");
  }
  void blocksDoNotChangeTheMove() {
    QFETCH(QString, block);
    World world;
    const base::Vec3 start = world.machine.state().commandMm;
    const auto result = world.test({block, QStringLiteral("M9")});
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QVERIFY2(result->passed() && result->tried.size() == 2, textOf(*result).c_str());
    for (const trace::ExecutedBlock& executed : world.machine.trace().blocks) {
      const base::Vec3 off = executed.targetMm - start;
      QVERIFY2(off[0] > -0.001 && off[0] < 20.001, qPrintable(QString::number(off[0])));
      QVERIFY(std::abs(off[1]) < 0.001 && std::abs(off[2]) < 0.001);
    }
  }

  /// A program counts from elsewhere than the control does in reset: nothing is moved.
  void anotherOffsetInProgramsIsNoticed() {
    World world;
    const base::Vec3 start = world.machine.state().commandMm;
    const auto result = world.test(QStringLiteral("G90 G94 G64\n"),
                                   QStringLiteral("$P_UIFR[1,X,TR]=7\nG54\nG90 G94 G64\n"));
    QVERIFY2(!result && result.error().code == job::JobError::PositionDiffers,
             result ? textOf(*result).c_str() : result.error().text().c_str());
    QCOMPARE(world.machine.state().commandMm[0], start[0]);
    for (const trace::ExecutedBlock& block : world.machine.trace().blocks) {
      QVERIFY(block.lengthMm < 1e-6);
    }
  }

  /// Its programs are for a SINUMERIK alone.
  void anotherControlIsRefused() {
    World world;
    struct LinuxCnc final : tests::MisreadLink {
      using MisreadLink::MisreadLink;
      base::Result<opcua::ServerIdentity> identity() override {
        return opcua::ServerIdentity{std::string(templates::kLinuxCncApplicationUri), "", "", ""};
      }
    } control(world.link, "no such text", "");
    const auto result = streaming::testJobs(control, control, World::planOf({}));
    QVERIFY(!result && result.error().code == opcua::LinkError::NamespaceMissing);
  }

  /// It is the block's, and says nothing of the control.
  void anAlarmOfABlockIsNoVerdict() {
    World world;
    const auto result = world.test({QStringLiteral("S500 M3 (")});
    QVERIFY(!result && result.error().code == StreamError::ControlAlarm);
  }

  /// The axes stand where they are.
  void aTestCanBeAborted() {
    World world;
    world.talk.progress = [&world](streaming::CommissioningStep) {
      return world.machine.state().commandMm[0] < 5.0;
    };
    const auto result = world.test();
    QVERIFY(!result && result.error().code == StreamError::Cancelled);
    const base::Vec3 there = world.machine.state().commandMm;
    QVERIFY(there[0] > 0.5 && there[0] < 19.5);
    (void)opcua::sleepUntil(world.link, world.link.now() + 10s);
    QCOMPARE(world.machine.state().commandMm[0], there[0]);
  }
};

RIVULET_TEST(TestJobTest)
#include "tst_job_test.moc"
