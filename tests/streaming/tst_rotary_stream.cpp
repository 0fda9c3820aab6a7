// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Method window with one to five axes, from the CAM text to the machine's own trace: every point
/// with its angles, the limits of the rotary axes, what is refused, and going on after a stop.

#include <QtTest>
#include <cmath>

#include "streaming/control/control_axes.h"
#include "streaming/recovery/resume.h"
#include "streaming/run/job.h"
#include "streaming/simulation/scenario.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"
#include "templates/flexible_program.h"
#include "templates/lint/lint.h"

using namespace rivulet;
using streaming::Outcome;
using streaming::RunReport;
using streaming::RunSettings;
using streaming::StreamError;

namespace {

/// A flank around a cone: the table turns while X Y Z follow, with ways that only turn, ways that
/// do not turn, and an arc.
const char* const kFiveAxisText =
    "G90 G94 G17\n"
    "G0 X40 Y0 Z60 A0 C0\n"
    "G1 Z50 F1500\n"
    "G1 A-20\n"
    "X39.5 Y2 Z49.8 A-20.5 C5\n"
    "X38.6 Y4.1 Z49.5 A-21.25 C10.125\n"
    "X37.2 Y6.3 Z49.1 A-22 C15.5\n"
    "X35 Y8 Z48.5 A-23.75 C21\n"
    "G1 C30\n"
    "X30 Y10 Z48\n"
    "G3 X20 Y20 I-10 J0 A-25 C60\n"
    "G1 X10 Y22 Z47 A-30.001 C90.5\n"
    "X0 Y22.5 Z46 A-35 C135\n"
    "C-45\n"
    "X-10 Y20 Z50 A0 C0\n"
    "M30\n";

gcode::Program programFrom(const std::string& text) {
  auto program = gcode::interpretProgram("five.mpf", text);
  if (!program) {
    qFatal("the program of the test cannot be read");
  }
  return *program;
}

class Watcher final : public streaming::RunSink, public streaming::RunOrders {
 public:
  std::optional<base::Instant> stopAt;
  std::size_t angles = 0;  ///< live samples with angles
  double angleMax = 0.0;
  void update(const streaming::LiveUpdate& update) override {
    if (update.sample && update.sample->rotaryDeg) {
      ++angles;
      angleMax = std::max(angleMax, std::abs((*update.sample->rotaryDeg)[2]));
    }
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(base::Instant now) override { return stopAt && now >= *stopAt; }
};

/// A control and what a client knows of it.
struct World {
  explicit World(const char* preset = "dmu75-5axis")
      : machine(*machine::loadPreset(preset), 1), link(machine) {
    settings.feedMmPerS = 25.0;
    settings.parameters.rParameterCount = 200;
  }

  RunReport run(const gcode::Program& program) {
    return streaming::runJob(link, link, program, settings, watcher, watcher);
  }

  machine::Machine machine;
  streaming::SimulatedLink link;
  RunSettings settings;
  Watcher watcher;
};

std::string wordsOf(std::string_view axes, int i) {
  std::string words;
  for (const char axis : axes) {
    const double value =
        axis == 'X' || axis == 'Y' || axis == 'Z' ? 50.0 - 0.75 * i : 1.25 * i - 0.125 * i * i;
    words += std::string(1, axis) + std::to_string(value) + " ";
  }
  return words;
}

/// Each block that moves ends exactly at the next point, angles included; all points are there.
QString examine(const trace::ControlTrace& trace, const std::vector<gcode::StreamPoint>& points,
                const base::RotarySet& axes) {
  std::size_t due = 0;
  for (const trace::ExecutedBlock& block : trace.blocks) {
    const bool isDue = due < points.size() && block.targetMm == points[due].positionMm &&
                       base::differenceDeg(block.targetDeg, points[due].rotaryDeg, axes) == 0.0;
    if (isDue) {
      ++due;
    } else if (block.moves()) {
      return QStringLiteral("point %1 was due").arg(due);
    }
  }
  return due == points.size() ? QString() : QStringLiteral("%1 points executed").arg(due);
}

}  // namespace

class TestRotaryStream : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void oneToFiveAxes_data() {
    QTest::addColumn<QString>("axes");
    for (const char* axes :
         {"X", "A", "C", "XZ", "YA", "AC", "XYZ", "XAC", "YZC", "XYZA", "XYAC", "XYZAC"}) {
      QTest::newRow(axes) << axes;
    }
  }
  /// Templates of any of the axes run in the machine, are sound, and every point is exact.
  void oneToFiveAxes() {
    QFETCH(QString, axes);
    const std::string letters = axes.toStdString();
    std::string text = "G90 G94\nF900\n";
    for (int i = 1; i <= 23; ++i) {
      text += "G1 " + wordsOf(letters, i) + "\n";
    }
    const gcode::Program program = programFrom(text + "M30\n");
    World world;
    QVERIFY(templates::chooseAxes(world.settings.parameters, letters));
    QCOMPARE(templates::axisLetters(world.settings.parameters), letters);
    world.settings.parameters.pointsPerLoop = 5;
    const auto nc = templates::makeProgram(world.settings.parameters);
    QVERIFY(nc.has_value());
    QVERIFY(templates::requireSound(*nc).has_value());
    const base::AxisPosition start = world.machine.config().start();
    const RunReport report = world.run(program);
    QVERIFY2(report.outcome == Outcome::Completed,
             qPrintable(QString::fromStdString(report.error.text())));
    QVERIFY(report.isFaultless());
    QCOMPARE(report.integrity.executed, std::size_t{23});
    const QString wrong =
        examine(*report.controlTrace, gcode::streamPoints(program.trajectory, start.mm).points,
                world.settings.parameters.rotaryAxes);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
  }

  void fiveAxisProgramEndToEnd() {
    const gcode::Program program = programFrom(kFiveAxisText);
    QVERIFY(program.isStreamable());
    World world;
    world.settings.parameters =
        streaming::withTurnedAxes(world.settings.parameters, program.trajectory);
    QCOMPARE(templates::axisLetters(world.settings.parameters), std::string("XYZAC"));
    std::string recorded;
    trace::RecordingWriter writer([&](std::string_view lines) {
      recorded += lines;
      return true;
    });
    streaming::JobRecorder recorder;
    recorder.writer = &writer;
    const RunReport report = streaming::runJob(world.link, world.link, program, world.settings,
                                               world.watcher, world.watcher, recorder);
    QVERIFY2(report.outcome == Outcome::Completed,
             qPrintable(QString::fromStdString(report.error.text())));
    QVERIFY(report.isFaultless());
    const auto points =
        gcode::streamPoints(program.trajectory, world.machine.config().start().mm).points;
    QCOMPARE(report.integrity.executed, points.size());
    const base::RotarySet axes = world.settings.parameters.rotaryAxes;
    const QString wrong = examine(*report.controlTrace, points, axes);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    QVERIFY2(world.watcher.angles > 10 && world.watcher.angleMax > 80.0, "angles are shown live");

    // The machine's own trace: no rotary axis beyond its speed and acceleration.
    const machine::MachineConfig& config = world.machine.config();
    const double h = base::toSeconds(config.interpolationCycle);
    const auto& samples = report.controlTrace->samples;
    for (const std::size_t axis : {0U, 2U}) {
      for (std::size_t i = 2; i < samples.size(); ++i) {
        const auto at = [&](std::size_t k) { return samples[k].commandDeg[axis]; };
        QVERIFY(std::abs(at(i) - at(i - 1)) / h <=
                config.rotaryAxes[axis]->speedDegPerSMax * (1.0 + 1e-6));
        QVERIFY(std::abs(at(i) - 2.0 * at(i - 1) + at(i - 2)) / (h * h) <=
                config.rotaryAxes[axis]->accelerationDegPerS2Max * (1.0 + 1e-4));
      }
    }

    // The recording has all of it.
    const auto recording = trace::parseRecording(recorded);
    QVERIFY(recording.has_value());
    QCOMPARE(recording->start.axes, std::string("XYZAC"));
    QVERIFY(recording->pointsComplete && recording->unreadableLines == 0);
    QCOMPARE(recording->points.points.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      QVERIFY(recording->points.points[i].rotaryDeg == points[i].rotaryDeg);
    }
    QVERIFY(!recording->controlTrace->truncated);
    QVERIFY(trace::judgeIntegrity(recording->points.points, recording->controlTrace->blocks, 1e-6,
                                  recording->controlTrace->rotaryAxes)
                .isFaultless());
    QVERIFY(
        std::any_of(recording->samples.begin(), recording->samples.end(),
                    [](const trace::LiveSample& sample) { return sample.rotaryDeg.has_value(); }));

    // A wrong angle in one block is a fault, and only for a judge that looks at angles.
    std::vector<trace::ExecutedBlock> tampered = report.controlTrace->blocks;
    for (trace::ExecutedBlock& block : tampered) {
      if (block.targetDeg[2] == 135.0) {
        block.targetDeg[2] += 1e-3;
        break;
      }
    }
    QVERIFY(!trace::judgeIntegrity(points, tampered, 1e-6, axes).isFaultless());
    QVERIFY(trace::judgeIntegrity(points, tampered, 1e-6, {}).foreign == 0);
  }

  void refusals_data() {
    QTest::addColumn<QString>("axes");
    QTest::addColumn<QString>("method");
    QTest::addColumn<QString>("preset");
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("says");
    const int chosen = static_cast<int>(StreamError::AxesNotChosen);
    const int missing = static_cast<int>(StreamError::AxisMissing);
    const int never = static_cast<int>(StreamError::ProgramNotStreamable);
    const QString turn = "G1 X1 C1 F600\nX2 C2\n";
    QTest::newRow("rotary axis not chosen") << "XYZ"
                                            << "window"
                                            << "dmu75-5axis" << turn << chosen << "Select XYZC.";
    QTest::newRow("one of two not chosen") << "XYZA"
                                           << "window"
                                           << "dmu75-5axis" << turn << chosen << "Select XYZAC.";
    QTest::newRow("linear axis not chosen") << "XC"
                                            << "window"
                                            << "dmu75-5axis"
                                            << "G1 X1 C1 F600\nX2 Y5 C2\n"
                                            << chosen << "XYC";
    QTest::newRow("control without rotary axes")
        << "XYZC"
        << "window"
        << "dmu75" << turn << missing << "no axis C; it has X, Y and Z";
    QTest::newRow("control with others") << "XYZB"
                                         << "window"
                                         << "dmu75-5axis"
                                         << "G1 X1 B1 F600\nX2 B2\n"
                                         << missing << "A and C";
    QTest::newRow("method of the paper") << "XYZ"
                                         << "signal"
                                         << "dmu75-5axis" << turn << never << "only method window";
    QTest::newRow("set once, stands elsewhere") << "XYZ"
                                                << "window"
                                                << "dmu75-5axis"
                                                << "G1 X1 A30 F600\nX2\n"
                                                << chosen << "A at 30 deg";
    QTest::newRow("directions of the tool") << "XYZAC"
                                            << "window"
                                            << "dmu75-5axis"
                                            << "G1 X1 A3=0 B3=1 C3=1 F600\nX2\n"
                                            << never << "";
  }
  void refusals() {
    QFETCH(QString, axes);
    QFETCH(QString, method);
    QFETCH(QString, preset);
    QFETCH(QString, text);
    QFETCH(int, code);
    QFETCH(QString, says);
    World world(preset.toUtf8().constData());
    world.settings.parameters.method = *base::methodFromName(method.toStdString());
    QVERIFY(templates::chooseAxes(world.settings.parameters, axes.toStdString()));
    const RunReport report = world.run(programFrom(text.toStdString()));
    QCOMPARE(report.outcome, Outcome::Failed);
    QVERIFY2(report.error.code == static_cast<StreamError>(code),
             qPrintable(QString::fromStdString(report.error.text())));
    QVERIFY2(QString::fromStdString(report.error.message).contains(says),
             qPrintable(QString::fromStdString(report.error.message)));
    QVERIFY(world.machine.trace().blocks.empty());
  }

  /// Set once where the axis stands already, or on a control without the axis: as ever.
  void setOnceIsStreamed() {
    World here;
    QVERIFY(here.run(programFrom("G1 X1 A0 F600\nX2\n")).isFaultless());
    World without("dmu75");
    QVERIFY(without.run(programFrom("G1 X1 A30 F600\nX2\n")).isFaultless());
    World chosen;
    QVERIFY(templates::chooseAxes(chosen.settings.parameters, "XYZA"));
    QVERIFY(chosen.run(programFrom("G1 X1 A30 F600\nX2\n")).isFaultless());
    QCOMPARE(chosen.machine.state().commandDeg[0], 30.0);
  }

  /// Stopped or reset anywhere, the run goes on with the point that is due, by the angles too.
  void goesOnWhereItWasLeft() {
    const gcode::Program program = programFrom(kFiveAxisText);
    std::size_t resumed = 0;
    for (const bool isReset : {false, true}) {
      for (double afterS = 1.0; afterS < 12.0; afterS += 1.0) {
        World world;
        world.settings.parameters =
            streaming::withTurnedAxes(world.settings.parameters, program.trajectory);
        world.settings.parameters.pointsPerLoop = 4;
        world.watcher.stopAt = base::Instant{} + base::fromSeconds(afterS);
        world.settings.stopDeadline = isReset ? base::fromSeconds(0.05) : base::fromSeconds(60.0);
        const RunReport first = world.run(program);
        if (first.outcome == Outcome::Completed) {
          break;
        }
        if (isReset) {
          world.machine.reset();
          world.link.wait(world.link.now() + std::chrono::seconds{2});
        }
        std::vector<trace::ExecutedBlock> blocks = world.machine.trace().blocks;
        const machine::MachineState stood = world.machine.state();
        QVERIFY(first.checkpoint.has_value());
        const auto resume =
            streaming::resumeFrom(world.link, program, first.settings, *first.checkpoint);
        const auto points =
            gcode::streamPoints(program.trajectory, world.machine.config().start().mm).points;
        const base::RotarySet axes = world.settings.parameters.rotaryAxes;
        if (!resume && (isReset || examine(world.machine.trace(), points, axes).isEmpty())) {
          continue;  // the path passes there twice, or the stop came after the last point
        }
        ++resumed;
        QVERIFY2(
            resume.has_value(),
            qPrintable(QString::fromStdString(resume ? std::string() : resume.error().text())));
        world.watcher.stopAt.reset();
        world.settings.stopDeadline = base::fromSeconds(60.0);
        world.settings.resume = *resume;
        world.settings.runNumber = 0;
        const RunReport second = world.run(program);
        QVERIFY2(second.isFaultless(), qPrintable(QString::fromStdString(second.error.text())));
        for (const trace::ExecutedBlock& block : second.controlTrace->blocks) {
          blocks.push_back(block);
        }
        const trace::Integrity whole =
            trace::judgeIntegrity(points, blocks, 1e-6, world.settings.parameters.rotaryAxes);
        // A rounded path does not touch the point of its corner: where a reset leaves the axes in
        // the rounding, the point counts as reached.
        constexpr double kRoundingMm = 0.03;
        constexpr double kRoundingDeg = 0.15;
        const gcode::StreamPoint& before = points[std::max<std::size_t>(resume->point, 1) - 1];
        const bool isNearlyThere =
            isReset && base::distance(before.positionMm, stood.commandMm) <= kRoundingMm &&
            base::differenceDeg(before.rotaryDeg, stood.commandDeg, axes) <= kRoundingDeg;
        QVERIFY(whole.skipped <= (isNearlyThere ? 1U : 0U));
        QCOMPARE(whole.outOfOrder + whole.foreign, std::size_t{0});
        QCOMPARE(world.machine.state().commandDeg[2], points.back().rotaryDeg[2]);
      }
    }
    QVERIFY(resumed > 8);
  }

  /// A program of a CAM system for a machine with A and C.
  void programOfTheCorpus() {
    const QString path =
        QStringLiteral(RIVULET_SOURCE_DIR "/../shared/corpus/linuxcnc/boat-xyzac.ngc");
    if (!QFile::exists(path)) {
      QSKIP("the corpus is not here");
    }
    gcode::LoadOptions options;
    options.accepted = {"G54", "M428", "M429"};
    const auto program = gcode::loadProgram(path.toStdString(), options);
    QVERIFY(program.has_value());
    QVERIFY(program->isStreamable());
    World world;
    world.settings.feedMmPerS = 50.0;
    world.settings.monitor = false;
    world.settings.parameters =
        streaming::withTurnedAxes(world.settings.parameters, program->trajectory);
    QCOMPARE(templates::axisLetters(world.settings.parameters), std::string("XYZAC"));
    world.settings.parameters.pointsPerLoop = 14;
    const RunReport report = world.run(*program);
    QVERIFY2(report.outcome == Outcome::Completed,
             qPrintable(QString::fromStdString(report.error.text())));
    QVERIFY(report.isFaultless());
    const QString wrong =
        examine(*report.controlTrace,
                gcode::streamPoints(program->trajectory, world.machine.config().start().mm).points,
                world.settings.parameters.rotaryAxes);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    qInfo("%zu points in %.0f s", report.integrity.executed, base::toSeconds(report.duration));
  }

  void pointAheadKnowsAngles() {
    const std::vector<base::AxisPosition> path{
        {{0, 0, 0}, {}}, {{10, 0, 0}, {}}, {{10, 0, 0}, {0, 0, 90}}, {{10, 0, 0}, {0, 0, 180}}};
    using streaming::pointAhead;
    QCOMPARE(pointAhead(path, {{10, 0, 0}, {0, 0, 45}}), std::optional<std::size_t>(2));
    QCOMPARE(pointAhead(path, {{10, 0, 0}, {0, 0, 90}}), std::optional<std::size_t>(3));
    QCOMPARE(pointAhead(path, {{5, 0, 0}, {}}), std::optional<std::size_t>(1));
    QVERIFY(!pointAhead(path, {{5, 0, 0}, {0, 0, 3}}));
  }
};

RIVULET_TEST(TestRotaryStream)
#include "tst_rotary_stream.moc"
