// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The test of the feed cell: virtual machines pass it, and each wrong control is caught by the
/// check that is meant for it.

#include <QtTest>
#include <algorithm>
#include <cmath>

#include "machine/machine.h"
#include "streaming/run/run.h"
#include "streaming/setup/feed_test.h"
#include "streaming/simulation/simulated_link.h"
#include "support/misread_link.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using streaming::AirMove;
using streaming::FeedCommissioning;
using streaming::FeedTestPlan;
using streaming::StreamError;

namespace {

constexpr AirMove kMove{0, 20.0, 400.0};
constexpr AirMove kLift{0, 20.0, 400.0, 2.0};

struct World {
  explicit World(const char* preset = "dmu75") : World(*machine::loadPreset(preset)) {}
  explicit World(const machine::MachineConfig& config) : machine(config, 1), link(machine) {}

  base::Result<FeedCommissioning> test(bool moves, int firstCell = 20) {
    FeedTestPlan plan;
    plan.firstCell = firstCell;
    plan.move = moves ? std::optional(kMove) : std::nullopt;
    return streaming::testFeedCell(link, link, plan, onStep);
  }
  base::Result<FeedCommissioning> test(const QString& written, const QString& read,
                                       const std::optional<AirMove>& move) {
    tests::MisreadLink misread(link, written.toStdString(), read.toStdString());
    FeedTestPlan plan;
    plan.firstCell = 20;
    plan.move = move;
    return streaming::testFeedCell(misread, misread, plan, onStep);
  }

  machine::Machine machine;
  streaming::SimulatedLink link;
  std::function<bool(streaming::CommissioningStep)> onStep;
};

QStringList failedIn(const FeedCommissioning& result) {
  QStringList names;
  for (const streaming::CommissioningCheck& check : result.checks) {
    if (!check.passed) {
      names << QString::fromStdString(check.name);
    }
  }
  return names;
}

}  // namespace

class TestFeedTest : public QObject {
  Q_OBJECT

 private slots:
  void virtualMachinesPass_data() {
    QTest::addColumn<QString>("preset");
    QTest::addColumn<bool>("moves");
    for (const std::string& name : machine::presetNames()) {
      QTest::newRow((name + ", without motion").c_str()) << QString::fromStdString(name) << false;
      QTest::newRow((name + ", with a move").c_str()) << QString::fromStdString(name) << true;
    }
  }
  void virtualMachinesPass() {
    QFETCH(QString, preset);
    QFETCH(bool, moves);
    World world(preset.toLatin1().constData());
    const base::Vec3 before = world.machine.state().commandMm;
    const auto result = world.test(moves);
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    for (const auto& check : result->checks) {
      QVERIFY2(check.passed, (check.name + ": " + check.message).c_str());
    }
    QCOMPARE(result->checks.size(), moves ? std::size_t{9} : std::size_t{4});
    QCOMPARE(result->proves(), moves);
    QCOMPARE(result->move.has_value(), moves);
    QVERIFY(base::distance(before, world.machine.state().commandMm) < 1e-9);
    QVERIFY(moves || world.machine.trace().blocks.empty());
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Reset);
  }

  void wrongControlsFail_data() {
    QTest::addColumn<QString>("written");
    QTest::addColumn<QString>("read");
    QTest::addColumn<bool>("moves");
    QTest::addColumn<QString>("caughtBy");
    const QString acts = QStringLiteral("ID=5 DO $AC_OVR=$R21");
    const auto row = [](const char* name, const QString& written, const QString& read, bool moves,
                        const char* caughtBy) {
      QTest::newRow(name) << written << read << moves << QString::fromLatin1(caughtBy);
    };
    row("no synchronized actions", QStringLiteral("\nID="), QStringLiteral("\n; ID="), true,
        "actions-follow");
    row("the cell is read once", QStringLiteral("ID=2 WHENEVER"), QStringLiteral("ID=2 WHEN"), true,
        "actions-follow");
    row("the timer stands", QStringLiteral("$AC_TIMER[1]>=0) AND ($AC_TIMER[1]<=1)"),
        QStringLiteral("$AC_PARAM[9]>=0) AND ($AC_PARAM[9]<=1)"), false, "silence-holds");
    row("actions outlive the program", QStringLiteral("\nID="), QStringLiteral("\nIDS="), false,
        "ends-with-program");
    row("the path does not obey", acts, QStringLiteral("ID=5 DO $AC_PARAM[9]=$R21"), true,
        "path-at-half-feed");
    row("only 0 is not obeyed", acts, QStringLiteral("ID=5 WHENEVER $R21>0 DO $AC_OVR=$R21"), true,
        "path-held");
    row("0 is only slow", acts,
        QStringLiteral("ID=5 DO $AC_OVR=$R21\nID=6 WHENEVER $R21<=0 DO $AC_OVR=1"), true,
        "path-held");
    row("200 ms late", acts,
        QStringLiteral("ID=5 WHENEVER ($R21>0) OR ($AC_TIMER[3]>0.2) DO $AC_OVR=$R21\n"
                       "ID=6 WHENEVER $R21>0 DO $AC_TIMER[3]=0 $AC_PARAM[8]=$R21"),
        true, "held-at-once");
    row("20 ms late", acts,
        QStringLiteral("ID=5 WHENEVER ($R21>0) OR ($AC_TIMER[3]>0.02) DO $AC_OVR=$R21\n"
                       "ID=6 WHENEVER $R21>0 DO $AC_TIMER[3]=0"),
        true, "held-at-once");
    row("one cycle a second is let through", acts,
        QStringLiteral("ID=5 DO $AC_OVR=$R21\n"
                       "ID=6 DO $AC_MARKER[1]=$AC_MARKER[1]+1\n"
                       "ID=7 WHENEVER ($AC_MARKER[1]>=250) AND ($R21<=0) DO $AC_OVR=100\n"
                       "ID=8 WHENEVER $AC_MARKER[1]>=250 DO $AC_MARKER[1]=0"),
        true, "stays-held");
    row("the override is kept", QStringLiteral("RIV_WATCH:\n"),
        QStringLiteral("RIV_WATCH:\nIF R25<2 GOTOF RIV_KEPT\nID=6 DO $AC_OVR=50\nRIV_KEPT:\n"),
        true, "taken-back");
    row("the override is kept at 0", QStringLiteral("RIV_WATCH:\n"),
        QStringLiteral("RIV_WATCH:\nIF R25<2 GOTOF RIV_KEPT\nID=6 DO $AC_OVR=0\nRIV_KEPT:\n"), true,
        "taken-back");
  }
  void wrongControlsFail() {
    QFETCH(QString, written);
    QFETCH(QString, read);
    QFETCH(bool, moves);
    QFETCH(QString, caughtBy);
    World world;
    const auto result = world.test(written, read, moves ? std::optional(kMove) : std::nullopt);
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QCOMPARE(failedIn(*result), QStringList{caughtBy});
    QVERIFY(!result->proves());
    const bool isBeforeMotion = caughtBy == QLatin1String("actions-follow") || !moves;
    QVERIFY(!isBeforeMotion || world.machine.trace().blocks.empty());
  }

  /// Lifted while it is held, lowered, lifted again and let go: the tool comes back first.
  void aLiftIsProved() {
    for (const std::string& name : machine::presetNames()) {
      World world(name.c_str());
      const base::Vec3 before = world.machine.state().commandMm;
      FeedTestPlan plan;
      plan.firstCell = 20;
      plan.move = kLift;
      double highest = 0.0;
      double lowest = 0.0;
      world.onStep = [&](streaming::CommissioningStep) {
        highest = std::max(highest, world.machine.state().overlayMm.z);
        lowest = std::min(lowest, world.machine.state().overlayMm.z);
        return true;
      };
      const auto result = streaming::testFeedCell(world.link, world.link, plan, world.onStep);
      QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
      for (const auto& check : result->checks) {
        QVERIFY2(check.passed, (check.name + ": " + check.message).c_str());
      }
      QCOMPARE(result->checks.size(), std::size_t{15});
      QCOMPARE(result->limitMm, 10.0);
      QCOMPARE(result->provedLiftMm(), 10.0);
      QVERIFY(std::abs(highest - kLift.liftMm) < 1e-6);
      QCOMPARE(lowest, 0.0);
      QVERIFY(base::distance(before, world.machine.state().commandMm) < 1e-9);
    }
  }

  void controlsThatLiftWronglyFail_data() {
    QTest::addColumn<QString>("written");
    QTest::addColumn<QString>("read");
    QTest::addColumn<QString>("caughtBy");
    const auto row = [](const char* name, const char* written, const char* read,
                        const char* caughtBy) {
      QTest::newRow(name) << QString::fromLatin1(written) << QString::fromLatin1(read)
                          << QString::fromLatin1(caughtBy);
    };
    row("negative values act", "($R34>=0)", "($R34>=-1)", "lift-bounds");
    row("values beyond it act", "($R34<=2.000)", "($R34<=3)", "lift-bounds");
    row("nothing lifts", "DO $AA_OFF[Z]=$R34", "DO $AC_PARAM[9]=$R34", "lifts");
    row("half of it", "DO $AA_OFF[Z]=$R34", "DO $AA_OFF[Z]=$R34/2", "lifts");
    row("once only", "ID=13 WHENEVER", "ID=13 WHEN", "lifts");
    row("the axis goes on lifted", "ID=2 WHENEVER",
        "ID=9 WHENEVER $AA_OFF_VAL[Z]>1 DO $AC_OVR=5\nID=2 WHENEVER", "stands-lifted");
    row("it stays up", "DO $AA_OFF[Z]=$R34\n", "AND ($R34>0) DO $AA_OFF[Z]=$R34\n", "lowers");
    row("it does not wait for the tool", " AND ($AA_OFF_VAL[Z]<=0.0005)", "", "waits-for-tool");
  }
  void controlsThatLiftWronglyFail() {
    QFETCH(QString, written);
    QFETCH(QString, read);
    QFETCH(QString, caughtBy);
    World world;
    const auto result = world.test(written, read, kLift);
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QCOMPARE(failedIn(*result), QStringList{caughtBy});
    QCOMPARE(result->provedLiftMm(), 0.0);
  }

  /// A control that adds overlays up, or allows too little, moves nothing.
  void overlaysThatDoNotFitMoveNothing() {
    machine::MachineConfig adding = *machine::loadPreset("dmu75");
    adding.overlay.mode = 1;
    machine::MachineConfig narrow = *machine::loadPreset("dmu75");
    narrow.overlay.mostMm = 1.5;
    for (const machine::MachineConfig& config : {adding, narrow}) {
      World world(config);
      FeedTestPlan plan;
      plan.firstCell = 20;
      plan.move = kLift;
      const auto result = streaming::testFeedCell(world.link, world.link, plan);
      QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
      QCOMPARE(failedIn(*result), QStringList{QStringLiteral("overlay-fits")});
      QCOMPARE(result->provedLiftMm(), 0.0);
      QVERIFY(world.machine.trace().blocks.empty());
      QVERIFY(world.machine.state().channel == machine::ChannelStatus::Reset);
    }
  }

  /// Who writes the cell beside us is named, whenever he does it, and nothing begins after that.
  void anotherClientIsSeen_data() {
    QTest::addColumn<int>("look");
    QTest::addColumn<double>("value");
    for (const int look : {20, 60, 90, 150}) {
      for (const double value : {7.0, 30.0, 150.0}) {
        QTest::addRow("look %d, %g", look, value) << look << value;
      }
    }
  }
  void anotherClientIsSeen() {
    QFETCH(int, look);
    QFETCH(double, value);
    World world;
    int looks = 0;
    world.onStep = [&](streaming::CommissioningStep) {
      if (++looks == look) {
        world.machine.writeRParameter(20, value);
      }
      return true;
    };
    const auto result = world.test(true);
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QVERIFY(looks >= look);
    QVERIFY2(failedIn(*result).contains(QStringLiteral("only-this-client")),
             qPrintable(failedIn(*result).join(u',')));
    QVERIFY(!result->proves());
  }

  void itCanBeBrokenOff() {
    World world;
    base::Instant cancelledAt{};
    world.onStep = [&](streaming::CommissioningStep) {
      const bool isMoving = world.machine.state().feedMmPerS > 0.0;
      cancelledAt = world.machine.now();
      return !isMoving;
    };
    const auto result = world.test(true);
    QVERIFY(!result && result.error().code == StreamError::Cancelled);
    world.machine.advance(world.machine.now() + 500ms);
    QCOMPARE(world.machine.state().feedMmPerS, 0.0);
    QVERIFY(world.machine.state().channel != machine::ChannelStatus::Reset);  // held
  }

  void othersCellsAreLeftAlone() {
    World world;
    for (int cell = 0; cell < 100; ++cell) {
      world.machine.writeRParameter(cell, 500.0 + cell);
    }
    world.machine.advance(world.machine.now() + 20ms);
    const auto result = world.test(true, 60);
    QVERIFY2(result && result->proves(), result ? "" : result.error().text().c_str());
    for (int cell = 0; cell < 100; ++cell) {
      if (cell < 60 || cell >= 60 + streaming::kFeedTestCells) {
        QCOMPARE(world.machine.rParameter(cell), 500.0 + cell);
      }
    }
  }

  void movesThatCannotBeHeldAreRefused() {
    World world;
    const double nan = std::nan("");
    for (const AirMove& move :
         {AirMove{0, 1.0, 400.0}, AirMove{0, 500.0, 100.0}, AirMove{3, 20.0, 400.0},
          AirMove{0, nan, 400.0}, AirMove{0, 20.0, 0.0}, AirMove{-1, 20.0, 400.0},
          AirMove{2, 20.0, 400.0, 2.0}, AirMove{0, 20.0, 400.0, 0.1}, AirMove{0, 20.0, 400.0, 11.0},
          AirMove{0, 20.0, 400.0, -1.0}, AirMove{0, 20.0, 400.0, nan}}) {
      FeedTestPlan plan;
      plan.move = move;
      const auto result = streaming::testFeedCell(world.link, world.link, plan);
      QVERIFY(!result && result.error().code == StreamError::BadAirMove);
    }
    QVERIFY(world.machine.programNames().empty());
    QVERIFY(streaming::requireAirMove({2, -20.0, 400.0}).has_value());
  }
};

RIVULET_TEST(TestFeedTest)
#include "tst_feed_test.moc"
