// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A run that is found on a control by somebody else, and resumed with the same or another program.

#include <QtTest>
#include <vector>

#include "base/units.h"
#include "streaming/recovery/resume.h"
#include "streaming/recovery/run_on_control.h"
#include "streaming/run/job.h"
#include "streaming/simulation/faulty_link.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"
#include "templates/window_protocol.h"

using namespace rivulet;
using streaming::Outcome;
using streaming::RunSettings;
using streaming::StreamError;

namespace {

constexpr int kPoints = 60;

/// A zigzag whose points from `changedFrom` on are elsewhere.
gcode::Program zigzag(int points = kPoints, int changedFrom = kPoints) {
  std::string text = "G90\n";
  for (int i = 0; i < points; ++i) {
    text += "G1 X" + std::to_string(5 * (i + 1)) + " Y" +
            std::to_string(i % 2 * 3 + (i >= changedFrom ? 10 : 0)) + " F1000\n";
  }
  return *gcode::interpretProgram("zigzag.nc", text + "M30\n");
}

RunSettings windowSettings() {
  RunSettings settings;
  settings.parameters.pointsPerLoop = 5;
  settings.feedMmPerS = base::mmPerSFromMmPerMin(1000.0);
  settings.origin = {"anna", "cell-pc-3", "2026-11-22T05:00:00Z"};
  return settings;
}

/// Breaks off once `breakAt` points are executed: as a client that is killed, it writes nothing
/// more.
class KilledClient final : public streaming::RunSink, public streaming::RunOrders {
 public:
  void update(const streaming::LiveUpdate& update) override {
    m_executed = update.counters.executed;
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(base::Instant) override { return m_executed >= stopAt; }
  std::size_t stopAt = SIZE_MAX;

 private:
  std::size_t m_executed = 0;
};

/// Keeps what a job gives it.
class Memory final : public streaming::CheckpointKeeper {
 public:
  base::Result<void> keep(const streaming::Checkpoint& checkpoint, const RunSettings& settings,
                          std::span<const gcode::StreamPoint> all) override {
    kept.push_back(checkpoint);
    kindOfRun = settings;
    if (!all.empty()) {
      points.assign(all.begin(), all.end());
    }
    return {};
  }
  std::vector<streaming::Checkpoint> kept;
  std::vector<gcode::StreamPoint> points;
  RunSettings kindOfRun;
};

struct World {
  machine::Machine machine{*machine::loadPreset("ideal"), 1};
  streaming::SimulatedLink link{machine};
  Memory memory;

  streaming::RunReport run(const gcode::Program& program, const RunSettings& settings,
                           std::size_t stopAt = SIZE_MAX) {
    KilledClient client;
    client.stopAt = stopAt;
    streaming::JobRecorder recorder;
    recorder.keeper = &memory;
    return streaming::runJob(link, link, program, settings, client, client, std::move(recorder));
  }
};

}  // namespace

class TestRunOnControl : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void labelsAreReadBack() {
    const streaming::RunOrigin origin{"anna", "cell-pc-3", "2026-11-22T05:00:00Z"};
    QVERIFY(streaming::runLabelOf(streaming::runLabelText(77, origin), 77) == origin);
    QVERIFY(!streaming::runLabelOf(streaming::runLabelText(77, origin), 7));
    QVERIFY(!streaming::runLabelOf("G1 X1\n", 77));
    // Nothing in a name becomes a block.
    const std::string odd =
        streaming::runLabelText(1, {"a\nG0 X99", "b\r\nM30", std::string(500, 'c')});
    QCOMPARE(std::count(odd.begin(), odd.end(), '\n'), std::ptrdiff_t{6});
    QVERIFY(streaming::runLabelOf(odd, 1).has_value());
  }

  /// The checkpoint is kept before anything moves and says afterwards that the run may have begun.
  void theCheckpointIsKeptBeforeTheFirstWindow() {
    World world;
    const streaming::RunReport report = world.run(zigzag(), windowSettings());
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    QCOMPARE(world.memory.kept.size(), std::size_t{2});
    QVERIFY(!world.memory.kept[0].granted);
    QVERIFY(world.memory.kept[1].granted);
    QCOMPARE(world.memory.kept[1].runNumber, report.checkpoint->runNumber);
    QCOMPARE(world.memory.kept[1].pointCount, std::size_t{kPoints});
    QCOMPARE(world.memory.points.size(), std::size_t{kPoints});
    QCOMPARE(streaming::hashOfPoints(world.memory.points), world.memory.kept[1].pointsHash);
    QCOMPARE(world.memory.kindOfRun.runNumber, report.checkpoint->runNumber);
    const auto label = world.machine.programText(streaming::runLabelName(0));
    QVERIFY(label.has_value());
    QVERIFY(streaming::runLabelOf(*label, report.checkpoint->runNumber) == windowSettings().origin);
  }

  /// Text that gives the same points is the same program; other points are not.
  void hashesPointsAndNotTheText() {
    const auto hashOf = [](const char* text) {
      return streaming::hashOfPoints(
          gcode::streamPoints(gcode::interpretProgram("a.nc", text)->trajectory, {}).points);
    };
    const std::uint64_t hash = hashOf("G1 X1 F100\nX2\n");
    QCOMPARE(hashOf("; a comment\nN10 G01 X1.0 F200\nN20 G1 X2.000\n"), hash);
    QVERIFY(hashOf("G1 X1 F100\nX2.0001\n") != hash);
    QVERIFY(hashOf("G1 X1 F100\nX1.5\nX2\n") != hash);
    QVERIFY(hashOf("G1 X1 F100\n") != hash);
    QVERIFY(hashOf("G1 X1 F100\nG0 X2\n") != hash);  // windows are cut there
  }

  void otherProgramsAreNotResumed() {
    const gcode::Program program = zigzag();
    const auto stopped = [&program](World& world) {
      return world.run(program, windowSettings(), 20);
    };
    const auto resume = [](World& world, const streaming::RunReport& report,
                           const gcode::Program& other, bool withPoints) {
      return streaming::resumeFrom(
          world.link, other, report.settings, *report.checkpoint,
          withPoints ? world.memory.points : std::vector<gcode::StreamPoint>());
    };
    World world;
    const streaming::RunReport report = stopped(world);
    QCOMPARE(report.outcome, Outcome::Stopped);
    const auto same = resume(world, report, program, false);
    QVERIFY2(same.has_value(), same ? "" : same.error().text().c_str());
    QVERIFY(!same->changedFrom);
    const std::size_t place = same->point;
    QVERIFY(place >= 20 && place < kPoints - 5);

    // An early point changed, a point inserted, the file cut off: whether or not the points are
    // known.
    std::string inserted = "G90\nG1 X2 Y0 F1000\n";
    for (int i = 0; i < kPoints; ++i) {
      inserted += "G1 X" + std::to_string(5 * (i + 1)) + " Y" + std::to_string(i % 2 * 3) + "\n";
    }
    const std::vector<gcode::Program> others{zigzag(kPoints, 3),
                                             *gcode::interpretProgram("in.nc", inserted),
                                             zigzag(static_cast<int>(place))};
    for (const gcode::Program& other : others) {
      for (const bool withPoints : {false, true}) {
        const auto refused = resume(world, report, other, withPoints);
        QVERIFY(!refused.has_value());
        QVERIFY(refused.error().code == StreamError::ProgramChanged);
      }
    }
    // Points that have not been executed may differ if somebody confirms it.
    const auto later = zigzag(kPoints, static_cast<int>(place) + 3);
    QVERIFY(resume(world, report, later, false).error().code == StreamError::ProgramChanged);
    const auto shown = resume(world, report, later, true);
    QVERIFY2(shown.has_value(), shown ? "" : shown.error().text().c_str());
    QCOMPARE(shown->point, place);
    QVERIFY(shown->changedFrom == place + 3);
    const auto shorter = resume(world, report, zigzag(static_cast<int>(place) + 2), true);
    QVERIFY(shorter.has_value() && shorter->changedFrom == place + 2);
    // And is then executed as it is now.
    RunSettings settings = windowSettings();
    settings.resume = *shown;
    const streaming::RunReport rest = world.run(later, settings);
    QVERIFY2(rest.outcome == Outcome::Completed, rest.error.text().c_str());
    QVERIFY(rest.isFaultless());
    QCOMPARE(rest.integrity.executed, kPoints - place);
  }

  /// Ctrl-C at any moment, also while the program waits for its first client.
  void aStopIsNeverAnotherRun() {
    /// Wants to stop from the n-th question on.
    struct Impatient final : streaming::RunSink, streaming::RunOrders {
      void update(const streaming::LiveUpdate&) override {}
      void access(const trace::Access&) override {}
      void note(const trace::Note&) override {}
      bool stopRequested(base::Instant) override { return ++asked >= stopAt; }
      int asked = 0;
      int stopAt = 0;
    };
    for (int stopAt = 1; stopAt <= 60; ++stopAt) {
      World world;
      Impatient client;
      client.stopAt = stopAt;
      const streaming::RunReport report =
          streaming::runJob(world.link, world.link, zigzag(), windowSettings(), client, client);
      QVERIFY2(report.outcome == Outcome::Stopped,
               (std::to_string(stopAt) + ": " + report.error.text()).c_str());
    }
  }

  /// A run was interrupted within a move, resumed, and its client died before the control obeyed
  /// it: the tool stands where the first run was left, which is at no point.
  void aResumedRunThatWasNeverObeyed() {
    const auto resumeFrom = [](const char* place, std::size_t firstPoint) {
      World world;
      streaming::Checkpoint begun;
      begun.runNumber = 999;
      begun.firstPoint = firstPoint;
      begun.startMm = world.machine.state().actualMm;
      const std::string text = std::string("G90 G1 ") + place + " F20000\nM30\n";
      if (!world.link.uploadProgram("JOG.MPF", text, true) ||
          !world.link.selectProgram("JOG.MPF") || !world.link.cycleStart()) {
        qFatal("the tool cannot be moved");
      }
      while (world.machine.state().channel != machine::ChannelStatus::Reset) {
        static_cast<void>(world.link.wait(world.link.now() + std::chrono::milliseconds{20}));
      }
      return streaming::resumeFrom(world.link, zigzag(), windowSettings(), begun);
    };
    // The 20th point is at X100 Y3, the next one at X105 Y0.
    for (const char* const place : {"X100 Y3", "X102.5 Y1.5", "X104.9 Y0.06"}) {
      const auto resume = resumeFrom(place, 20);
      QVERIFY2(resume, resume ? "" : (place + (": " + resume.error().text())).c_str());
      QCOMPARE(resume->point, std::size_t{20});
    }
    for (const char* const place : {"X95 Y0", "X102.5 Y2", "X107.5 Y1.5"}) {
      QVERIFY2(!resumeFrom(place, 20), place);
    }
  }

  void whatIsNoRunIsReset() {
    World world;
    const auto never = [] { return false; };
    QVERIFY(world.link.uploadProgram("JOG.MPF", "G90 G1 X100 F1000\nM30\n", true) &&
            world.link.selectProgram("JOG.MPF") && world.link.cycleStart());
    static_cast<void>(world.link.wait(world.link.now() + std::chrono::seconds{2}));
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Active);
    const auto stopped = streaming::stopByReset(world.link, world.link, never);
    QVERIFY2(stopped.has_value(), stopped ? "" : stopped.error().text().c_str());
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Reset);
    const double place = world.machine.state().commandMm[0];
    QVERIFY2(place > 10.0 && place < 90.0, std::to_string(place).c_str());
  }

  void findsTheRunAndItsClient() {
    World world;
    QVERIFY(!streaming::findRun(world.link, world.link, 0, std::chrono::seconds{3})->has_value());
    // The client is killed in the middle: its axes stand, until somebody else ends its program.
    streaming::RunReport report;
    {
      KilledClient client;
      RunSettings settings = windowSettings();
      settings.stopDeadline = base::Duration{1};  // it gives up at once
      client.stopAt = 20;
      report = streaming::runJob(world.link, world.link, zigzag(), settings, client, client);
    }
    const auto standsAt = [&world] {
      static_cast<void>(world.link.wait(world.link.now() + std::chrono::seconds{30}));
      return world.machine.state().commandMm;
    };
    const base::Vec3 stood = standsAt();
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Active);
    QCOMPARE(base::distance(standsAt(), stood), 0.0);
    const auto left = streaming::findRun(world.link, world.link, 0, std::chrono::seconds{3});
    QVERIFY(left.has_value() && left->has_value() && !(*left)->hasClient);
    // Asked, they stay where they are: what would be executed first is computed.
    const auto foreseen =
        streaming::resumeFrom(world.link, zigzag(), windowSettings(), *report.checkpoint, {},
                              streaming::ActiveProgram::Stays);
    QVERIFY2(foreseen.has_value(), foreseen ? "" : foreseen.error().text().c_str());
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Active);
    QCOMPARE(base::distance(standsAt(), stood), 0.0);
    QVERIFY(foreseen->restMm.has_value());
    // Stopped, they stay where they are; ended, they go on to the end of the window.
    const auto never = [] { return false; };
    const auto held = streaming::stopRun(world.link, **left, windowSettings(), never);
    QVERIFY2(held.has_value(), held ? "" : held.error().text().c_str());
    QVERIFY(!held->hasEnded && held->stoodAfter.has_value());
    QCOMPARE(base::distance(standsAt(), stood), 0.0);
    {
      // While somebody gives signs of life, it is his hand that holds them.
      streaming::FaultyLink observed(world.machine, {}, 1);
      double beats = 1000.0;
      observed.onTime = [&] {
        world.machine.writeRParameter(templates::WindowProtocol::Heartbeat, beats += 1.0);
      };
      const auto refused = streaming::endRun(observed, **left, windowSettings());
      QVERIFY(!refused && refused.error().code == streaming::StreamError::StopNotConfirmed);
      QCOMPARE(base::distance(standsAt(), stood), 0.0);
    }
    const std::size_t samples = world.machine.trace().samples.size();
    const auto ended = streaming::endRun(world.link, **left, windowSettings());
    QVERIFY2(ended.has_value(), ended ? "" : ended.error().text().c_str());
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Reset);
    QVERIFY(base::distance(world.machine.state().commandMm, stood) > 0.0);
    double movedMm = 0.0;
    const auto& all = world.machine.trace().samples;
    for (std::size_t i = samples; i < all.size(); ++i) {
      movedMm += base::distance(all[i - 1].commandMm, all[i].commandMm);
    }
    constexpr double kRoundedMm = 1.0;  // of the corners
    QVERIFY2(movedMm <= *foreseen->restMm + 1e-6 && movedMm > *foreseen->restMm - kRoundedMm,
             (std::to_string(movedMm) + " of " + std::to_string(*foreseen->restMm)).c_str());
    const auto found1 =
        streaming::resumeFrom(world.link, zigzag(), windowSettings(), *report.checkpoint);
    QVERIFY(found1 && found1->point == foreseen->point && !found1->restMm);
    QVERIFY(world.link.selectProgram("RIVULET_WINDOW_5X2.MPF").has_value());
    world.machine.writeRParameter(4, 0.0);
    QVERIFY(world.link.cycleStart().has_value());
    while (world.machine.rParameter(4) == 0.0) {
      static_cast<void>(world.link.wait(world.link.now() + std::chrono::milliseconds{20}));
    }
    auto found = streaming::findRun(world.link, world.link, 30, std::chrono::seconds{3});
    QVERIFY(found.has_value() && found->has_value());
    QCOMPARE((*found)->baseCell, 0);  // by the name of the program
    QCOMPARE((*found)->number, 0);
    QVERIFY(!(*found)->hasClient);
    QVERIFY(!(*found)->origin);
    // A client that was killed before it was granted the run can go on where it would have begun.
    streaming::Checkpoint begun = *report.checkpoint;
    begun.granted = false;
    begun.runNumber = 999;
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Active);
    const auto resume = streaming::resumeFrom(world.link, zigzag(), windowSettings(), begun);
    QVERIFY2(resume.has_value(), resume ? "" : resume.error().text().c_str());
    QCOMPARE(resume->point, std::size_t{0});
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Reset);
    world.machine.writeRParameter(4, 0.0);
    QVERIFY(world.link.cycleStart().has_value());
    while (world.machine.rParameter(4) == 0.0) {
      static_cast<void>(world.link.wait(world.link.now() + std::chrono::milliseconds{20}));
    }
    world.machine.writeRParameter(6, report.checkpoint->runNumber);
    found = streaming::findRun(world.link, world.link, 30, std::chrono::seconds{1});
    found = streaming::findRun(world.link, world.link, 30, std::chrono::seconds{1});
    QCOMPARE((*found)->number, report.checkpoint->runNumber);
    QVERIFY((*found)->origin == windowSettings().origin);
    QVERIFY(!(*found)->hasClient);
    // One that waits for a window has nothing left to execute.
    const auto stopped = streaming::stopRun(world.link, **found, windowSettings(), never);
    QVERIFY(stopped.has_value() && stopped->hasEnded);
    QVERIFY(!streaming::findRun(world.link, world.link, 0, {})->has_value());
  }
};

RIVULET_TEST(TestRunOnControl)
#include "tst_run_on_control.moc"
