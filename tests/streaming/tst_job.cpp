// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Whole runs in virtual time: the production job, driver and methods against the virtual
/// machine. The oracle, which is none of them, judges.

#include <QtTest>
#include <cmath>
#include <set>

#include "base/units.h"
#include "feasibility/verdict.h"
#include "streaming/run/job.h"
#include "streaming/simulation/scenario.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"
#include "templates/flexible_program.h"

using namespace rivulet;
using base::MethodKind;
using streaming::Outcome;
using streaming::RunReport;
using streaming::RunSettings;
using streaming::RunState;
using streaming::StreamError;

namespace {

/// Stops once `executed` points are known to be passed.
class Recorder final : public streaming::RunSink, public streaming::RunOrders {
 public:
  void update(const streaming::LiveUpdate& update) override {
    m_executed = update.counters.executed;
    states.insert(update.state);
    samples += update.sample ? 1 : 0;
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(base::Instant) override { return m_executed >= stopAt; }

  std::size_t stopAt = SIZE_MAX;
  std::size_t samples = 0;
  std::set<RunState> states;

 private:
  std::size_t m_executed = 0;
};

struct World {
  explicit World(const std::string& preset, std::uint64_t seed = 1)
      : machine(*machine::loadPreset(preset), seed), link(machine) {}
  machine::Machine machine;
  streaming::SimulatedLink link;
  Recorder recorder;

  RunReport run(const gcode::Program& program, const RunSettings& settings,
                streaming::JobRecorder recording = {}) {
    return streaming::runJob(link, link, program, settings, recorder, recorder,
                             std::move(recording));
  }
};

gcode::Program contour(int points) {
  std::string text = "G90\n";
  for (int i = 0; i < points; ++i) {
    text += "G1 X" + std::to_string(5 * (i + 1)) + " Y" + std::to_string(i % 2 * 3) + " F1000\n";
  }
  return *gcode::interpretProgram("contour.nc", text + "M30\n");
}

gcode::Program scorpion() {
  return *gcode::loadProgram(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");
}

RunSettings settings(MethodKind method, int points, double deltaMm, double feedMmPerMin) {
  RunSettings settings;
  settings.parameters.method = method;
  settings.parameters.pointsPerLoop = points;
  settings.deltaMm = deltaMm;
  settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  return settings;
}

bool isFeasible(const gcode::Program& program, const RunSettings& run) {
  const gcode::PointList list = gcode::streamPoints(program.trajectory, {});
  feasibility::OperatingPoint point;
  point.method = run.parameters.method;
  point.pointsPerLoop = run.parameters.pointsPerLoop;
  point.deltaMm = run.deltaMm;
  point.feedMmPerS = run.feedMmPerS;
  return feasibility::judge(point, feasibility::programDistances(list.points, point.pointsPerLoop))
      ->feasible;
}

}  // namespace

class TestJob : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Any number of points, whether or not it fills its last loop or window.
  void everyLengthRunsOnce() {
    for (const MethodKind method : base::kPaperMethods) {
      for (const int perLoop : {2, 3, 7, 9}) {
        for (int points = 1; points <= 3 * perLoop + 2; ++points) {
          World world("ideal");
          const RunReport report =
              world.run(contour(points), settings(method, perLoop, 1.0, 1000.0));
          const std::string where = std::string(base::methodName(method)) + " N " +
                                    std::to_string(perLoop) + " points " + std::to_string(points) +
                                    ": " + report.error.text();
          QVERIFY2(report.outcome == Outcome::Completed, where.c_str());
          QVERIFY2(report.integrity.isFaultless(), where.c_str());
          QVERIFY2(report.integrity.executed == static_cast<std::size_t>(points), where.c_str());
          QVERIFY2(report.counters.sent == static_cast<std::size_t>(points), where.c_str());
          QVERIFY2(report.counters.accepted == report.counters.sent, where.c_str());
        }
      }
    }
  }

  /// A real CAM program with the access cost of the real control, at feeds the verdict allows.
  void realProgramRunsFaultlessly() {
    const gcode::Program program = scorpion();
    const RunSettings signal = settings(MethodKind::Signal, 7, 0.3, 3000.0);
    const RunSettings position = settings(MethodKind::Position, 9, 0.75, 1400.0);
    QVERIFY(isFeasible(program, signal));
    QVERIFY(isFeasible(program, position));
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      for (const RunSettings& run : {signal, position}) {
        World world("dmu75", seed);
        const RunReport report = world.run(program, run);
        QVERIFY2(report.isFaultless(), qPrintable(QStringLiteral("seed %1").arg(seed)));
        QCOMPARE(report.integrity.executed, std::size_t{270});
        const std::size_t stops = run.parameters.method == MethodKind::Signal ? 2 * 39 : 30;
        QCOMPARE(report.pauses.size(), stops - 1);
        QVERIFY(world.recorder.samples > 100);
      }
    }
  }

  /// The published form of Algorithm II: inside the region it executes every point once as well.
  void P1_algorithm_II_withTheDistanceToGo() {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      World world("dmu75", seed);
      RunSettings run = settings(MethodKind::Position, 9, 0.3, 400.0);
      run.passedBy = streaming::PassedBy::DistanceToGo;
      const RunReport report = world.run(scorpion(), run);
      QVERIFY2(report.isFaultless(), qPrintable(QStringLiteral("seed %1: ").arg(seed) +
                                                QString::fromStdString(report.error.text())));
      QVERIFY(report.outcome == Outcome::Completed);
      QVERIFY(world.recorder.samples > 0);  // the position is read for the display alone
    }
  }

  /// The hazard is real and it is reported: far outside the region old points are run again.
  void tooFastRepeatsAndTheOracleSeesIt() {
    const RunSettings run = settings(MethodKind::Position, 7, 0.1, 2000.0);
    base::Random random(1);
    const auto program = streaming::programOf(streaming::drawContour({200, 0.1, 0.1}, random));
    QVERIFY(!isFeasible(*program, run));
    World world("dmu75");
    const RunReport report = world.run(*program, run);
    QVERIFY(report.integrity.judged);
    QVERIFY(report.integrity.repeated > 0);
    QVERIFY(!report.isFaultless());
  }

  /// What the control's trace does not cover cannot be judged, and is not called faultless.
  void aRunLongerThanTheTraceIsNotJudged() {
    World world("dmu75");
    machine::MachineConfig config = world.machine.config();
    config.traceLimit = std::chrono::seconds{1};
    machine::Machine forgetful(config, 1);
    streaming::SimulatedLink link(forgetful);
    const RunReport report =
        streaming::runJob(link, link, scorpion(), settings(MethodKind::Window, 9, 0.75, 1000.0),
                          world.recorder, world.recorder);
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    QVERIFY(report.controlTrace && report.controlTrace->truncated);
    QVERIFY(!report.integrity.judged);
    QVERIFY(!report.isFaultless());
    QVERIFY(report.finding() == streaming::RunFinding::NotJudged);
    // The time is that of the run, not of the second that was recorded.
    QVERIFY(report.duration > std::chrono::seconds{60});
    QVERIFY(report.pauses.size() > 20);
  }

  /// The display reads only where the stream has slack: with and without it nothing changes for
  /// the points, and it does see something.
  void displayCostsTheStreamNothing() {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      for (const bool monitor : {false, true}) {
        World world("dmu75", seed);
        RunSettings run = settings(MethodKind::Signal, 7, 0.3, 6000.0);
        run.monitor = monitor;
        QVERIFY(world.run(scorpion(), run).isFaultless());
        QCOMPARE(world.recorder.samples > 0, monitor);
      }
    }
  }

  void stopEndsAfterTheLoop() {
    for (const MethodKind method : base::kPaperMethods) {
      World world("dmu75");
      world.recorder.stopAt = 30;
      const RunReport report =
          world.run(scorpion(), method == MethodKind::Signal ? settings(method, 7, 0.3, 2000.0)
                                                             : settings(method, 9, 0.75, 1000.0));
      QVERIFY2(report.outcome == Outcome::Stopped, report.error.text().c_str());
      QVERIFY(report.stopConfirmedAfter.has_value());
      QVERIFY(report.integrity.isFaultless());
      QVERIFY(report.integrity.executed >= 30);
      QVERIFY(report.integrity.executed <= 30 + 2 * 9);
      QVERIFY(world.recorder.states.contains(RunState::Stopping));
      QVERIFY(world.machine.state().channel == machine::ChannelStatus::Reset);
    }
  }

  void stopBeforeTheStartMovesNothing() {
    World world("dmu75");
    world.recorder.stopAt = 0;
    const RunReport report = world.run(scorpion(), settings(MethodKind::Signal, 7, 0.3, 2000.0));
    QVERIFY(report.outcome == Outcome::Stopped);
    world.machine.advance(world.machine.now() + std::chrono::seconds(5));
    QVERIFY(world.machine.trace().blocks.empty());
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Reset);
  }

  void busyChannelIsLeftAlone() {
    World world("dmu75");
    QVERIFY(world.machine.storeProgram("X.MPF", "G4 F1000\nM30\n", true));
    QVERIFY(world.machine.selectProgram("X.MPF"));
    QVERIFY(world.machine.cycleStart());
    const RunReport report = world.run(scorpion(), settings(MethodKind::Signal, 7, 0.3, 2000.0));
    QVERIFY(report.outcome == Outcome::Failed);
    QVERIFY(report.error.code == StreamError::ChannelBusy);
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Active);
  }

  /// The operator has another flexible program in the channel: nothing is started.
  void wrongProgramIsRefused() {
    class OtherProgram final : public opcua::Control {
     public:
      explicit OtherProgram(streaming::SimulatedLink& link) : m_link(link) {}
      base::Result<void> uploadProgram(const std::string& name, const std::string& text,
                                       bool overwrite) override {
        return m_link.uploadProgram(name, text, overwrite);
      }
      base::Result<std::string> downloadProgram(const std::string& name) override {
        return m_link.downloadProgram(name);
      }
      base::Result<void> selectProgram(const std::string&) override {
        templates::TemplateParameters other;
        other.pointsPerLoop = 8;
        const std::string name = templates::makeProgram(other)->name;
        const auto done = m_link.uploadProgram(name, templates::makeProgram(other)->text, true);
        return done ? m_link.selectProgram(name) : done;
      }
      bool isVirtualMachine() const override { return true; }
      opcua::Abilities abilities() const override { return m_link.abilities(); }
      base::Result<void> cycleStart() override { return m_link.cycleStart(); }
      base::Result<void> reset() override { return m_link.reset(); }
      base::Result<trace::ControlTrace> fetchTrace() override { return m_link.fetchTrace(); }

     private:
      streaming::SimulatedLink& m_link;
    };
    World world("dmu75");
    OtherProgram control(world.link);
    const RunReport report = streaming::runJob(world.link, control, scorpion(),
                                               settings(MethodKind::Signal, 7, 0.3, 2000.0),
                                               world.recorder, world.recorder);
    QVERIFY(report.error.code == StreamError::WrongProgram);
    world.machine.advance(world.machine.now() + std::chrono::seconds(5));
    QVERIFY(world.machine.trace().blocks.empty());
  }

  /// N needs more R-parameters than the control has: refused where the cells are written.
  void missingCellsEndTheRun() {
    machine::MachineConfig config = *machine::loadPreset("dmu75");
    config.rParameterCount = 50;
    machine::Machine machine(config, 1);
    streaming::SimulatedLink link(machine);
    Recorder recorder;
    const RunReport report = streaming::runJob(
        link, link, scorpion(), settings(MethodKind::Signal, 7, 0.3, 2000.0), recorder, recorder);
    QVERIFY(report.outcome == Outcome::Failed);
    QVERIFY(report.error.code == opcua::LinkError::VariableMissing);
    QVERIFY(machine.trace().blocks.empty());
  }

  void deadlineAbandonsAndEndsTheProgram() {
    World world("dmu75");
    RunSettings run = settings(MethodKind::Signal, 7, 0.3, 2000.0);
    run.requestDeadline = std::chrono::milliseconds(70);  // enough for the checks, not always
    run.accessTime = std::chrono::microseconds(1);        // for a window of 13 nodes
    const RunReport report = world.run(scorpion(), run);
    QVERIFY(report.outcome == Outcome::Failed);
    QVERIFY(report.error.code == opcua::LinkError::DeadlineExceeded);
  }

  void recordingHoldsTheWholeRun() {
    const auto record = [] {
      World world("dmu75", 4);
      std::string text;
      trace::RecordingWriter writer([&text](std::string_view lines) {
        text += lines;
        return true;
      });
      streaming::JobRecorder recorder;
      recorder.writer = &writer;
      const RunReport report =
          world.run(scorpion(), settings(MethodKind::Signal, 7, 0.3, 3000.0), recorder);
      return std::pair(text, report);
    };
    const auto [text, report] = record();
    const auto recording = trace::parseRecording(text);
    QVERIFY(recording);
    QVERIFY(recording->complete);
    QVERIFY(recording->pointsComplete);
    QCOMPARE(recording->unreadableLines, std::size_t{0});
    QCOMPARE(recording->accesses.size(), report.access.requests);
    const trace::Integrity integrity =
        trace::judgeIntegrity(recording->points.points, recording->controlTrace->blocks, 1e-6);
    QVERIFY(integrity.isFaultless());
    QCOMPARE(integrity.executed, report.integrity.executed);
    QVERIFY2(record().first == text, "the same seed gives the same run to the bit");
  }

  /// [P1] V1 and V2: single accesses cost more than lists.
  void singleAccessCostsMore() {
    const auto perNodeMs = [](opcua::Grouping grouping) {
      World world("dmu75");
      RunSettings run = settings(MethodKind::Signal, 7, 0.3, 2000.0);
      run.grouping = grouping;
      const RunReport report = world.run(contour(40), run);
      return base::toMilliseconds(report.duration) > 0.0 && report.isFaultless()
                 ? base::toMilliseconds(report.access.perRequest.max)
                 : 0.0;
    };
    QVERIFY(perNodeMs(opcua::Grouping::Single) > 1.1 * perNodeMs(opcua::Grouping::List));
  }
};

RIVULET_TEST(TestJob)
#include "tst_job.moc"
