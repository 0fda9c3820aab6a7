// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A run that was left is driven back along its path, and goes on.

#include <QtTest>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/random.h"
#include "base/units.h"
#include "streaming/recovery/back_along.h"
#include "streaming/run/job.h"
#include "streaming/simulation/scenario.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"

using namespace rivulet;
using base::AxisPosition;
using base::Vec3;
using streaming::Outcome;
using streaming::RunSettings;
using streaming::StreamError;

namespace {

/// Tells the run to end once so many points have been executed.
class Stopper final : public streaming::RunSink, public streaming::RunOrders {
 public:
  explicit Stopper(std::size_t after) : m_after(after) {}
  void update(const streaming::LiveUpdate& update) override {
    m_executed = update.counters.executed;
    if (machine != nullptr && m_executed >= m_after) {
      std::exchange(machine, nullptr)->reset();
    }
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(base::Instant) override { return machine == nullptr && m_executed >= m_after; }
  machine::Machine* machine = nullptr;  ///< to be reset then, once; null: the run is stopped

 private:
  std::size_t m_after;
  std::size_t m_executed = 0;
};

gcode::Program programOf(const std::string& text) {
  return *gcode::interpretProgram("part.nc", text + "M30\n");
}

/// A rapid above, a plunge, and a zigzag of 40 moves.
gcode::Program part() {
  std::string text = "G90 G0 X0 Y0 Z10\nG1 Z-1 F500\n";
  for (int i = 1; i <= 40; ++i) {
    text += "X" + std::to_string(5 * i) + " Y" + std::to_string(i % 2 * 3) + "\n";
  }
  return programOf(text);
}

RunSettings settings() {
  RunSettings settings;
  settings.parameters.pointsPerLoop = 5;
  settings.feedMmPerS = base::mmPerSFromMmPerMin(1000.0);
  return settings;
}

/// Of all that the control has executed, in its order.
std::vector<Vec3> endsOf(const streaming::RunReport& report) {
  std::vector<Vec3> ends;
  for (const trace::ExecutedBlock& block : report.controlTrace->blocks) {
    if (block.moves()) {
      ends.push_back(block.targetMm);
    }
  }
  return ends;
}

struct World {
  explicit World(const char* preset = "ideal", std::uint64_t seed = 1)
      : machine(*machine::loadPreset(preset), seed), link(machine) {}

  streaming::RunReport run(const gcode::Program& program, const RunSettings& settings,
                           std::size_t stopAfter = SIZE_MAX) {
    Stopper stopper(stopAfter);
    stopper.machine = resets ? &machine : nullptr;
    return streaming::runJob(link, link, program, settings, stopper, stopper);
  }
  [[nodiscard]] AxisPosition tool(const gcode::Program& program = part()) {
    const auto flight = streaming::preflight(link, program, settings());
    return flight ? AxisPosition{flight->toolMm, flight->toolDeg} : AxisPosition{};
  }

  machine::Machine machine;
  streaming::SimulatedLink link;
  bool resets = false;  ///< at the control, in place of a stop
};

/// The way back of a path whose points up to `next` have been executed.
base::Result<streaming::BackWay> wayOf(const gcode::Program& program, std::size_t next,
                                       AxisPosition tool, std::optional<double> mm) {
  streaming::Checkpoint last;
  last.startMm = {0, 0, 50};
  return streaming::backAlong(program, settings(), last, next, tool, {mm});
}

QString refusal(const base::Result<streaming::BackWay>& way) {
  return way ? QStringLiteral("no refusal") : QString::fromStdString(way.error().message);
}

}  // namespace

class TestBackAlong : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// A run that is stopped goes back 17 mm, and from there to its end: each point is executed that
  /// had not been, and those of the way back again, in their order.
  void goesBackAndOn() {
    World world;
    const gcode::Program program = part();
    const auto first = world.run(program, settings(), 20);
    QCOMPARE(first.outcome, Outcome::Stopped);
    const auto left = streaming::resumeFrom(world.link, program, first.settings, *first.checkpoint);
    QVERIFY2(left.has_value(), left ? "" : left.error().text().c_str());
    const AxisPosition tool = world.tool();
    const auto way =
        streaming::backAlong(program, first.settings, *first.checkpoint, left->point, tool, {17.0});
    QVERIFY2(way.has_value(), way ? "" : way.error().text().c_str());
    QCOMPARE(way->lengthMm, 17.0);
    // 5.83 mm a move: two whole ones, and a part of the third.
    QCOMPARE(way->places.size(), std::size_t{3});
    QCOMPARE(way->part.next, left->point);
    QCOMPARE(way->part.first, left->point - 3);

    RunSettings slow = settings();
    slow.feedMmPerS = 5.0;
    const auto back = world.run(streaming::backProgram(*way, {}), slow);
    QVERIFY2(back.outcome == Outcome::Completed, back.error.text().c_str());
    QVERIFY(back.integrity.judged && back.integrity.repeated == 0 && back.integrity.skipped == 0);
    QVERIFY(base::distance(world.tool().mm, way->places.back().mm) < 1e-3);

    // The control knows the run no more; the place of the tool is enough.
    QVERIFY(!streaming::resumeFrom(world.link, program, first.settings, *first.checkpoint));
    const auto on =
        streaming::resumeOnPart(world.link, program, first.settings, *first.checkpoint, way->part);
    QVERIFY2(on.has_value(), on ? "" : on.error().text().c_str());
    QCOMPARE(on->point, left->point - 3);
    RunSettings again = settings();
    again.resume = *on;
    const auto rest = world.run(program, again);
    QVERIFY2(rest.outcome == Outcome::Completed, rest.error.text().c_str());
    const auto points = gcode::streamPoints(program.trajectory, first.checkpoint->startMm).points;
    const std::vector<Vec3> ends = endsOf(rest);
    QCOMPARE(ends.size(), points.size() - on->point);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      QVERIFY(base::distance(ends[i], points[on->point + i].positionMm) < 1e-6);
    }
  }

  /// Whatever becomes of the way back, the place of the tool on the path says where the run goes
  /// on.
  void goesOnFromHalfOfTheWay() {
    World world;
    const gcode::Program program = part();
    const auto first = world.run(program, settings(), 20);
    const auto left = streaming::resumeFrom(world.link, program, first.settings, *first.checkpoint);
    QVERIFY(left.has_value());
    const auto way = streaming::backAlong(program, first.settings, *first.checkpoint, left->point,
                                          world.tool(), {60.0});
    QVERIFY(way.has_value());
    const auto back = world.run(streaming::backProgram(*way, {}), settings(), 5);
    QCOMPARE(back.outcome, Outcome::Stopped);
    const auto on =
        streaming::resumeOnPart(world.link, program, first.settings, *first.checkpoint, way->part);
    QVERIFY2(on.has_value(), on ? "" : on.error().text().c_str());
    QCOMPARE(on->point, left->point - back.counters.executed);
    // Somebody has moved it.
    QCOMPARE(world.run(programOf("G1 X1 Y2 Z3\n"), settings()).outcome, Outcome::Completed);
    const auto moved =
        streaming::resumeOnPart(world.link, program, first.settings, *first.checkpoint, way->part);
    QVERIFY(!moved && moved.error().code == StreamError::CannotResume);
    // Another program.
    const auto other = streaming::resumeOnPart(world.link, programOf("G1 X10 F100\nX20\n"),
                                               first.settings, *first.checkpoint, way->part);
    QVERIFY(!other && other.error().code == StreamError::ProgramChanged);
  }

  /// Drawn contours, reset somewhere or stopped, driven back, stopped on the way back or not: each
  /// goes on where the tool stands, and executes from there each point once.
  void drawnWaysBack() {
    const int count = std::max(60, qEnvironmentVariableIntValue("RIVULET_SCENARIOS"));
    const int first = std::max(1, qEnvironmentVariableIntValue("RIVULET_FIRST"));
    int driven = 0;
    int halfway = 0;
    int refused = 0;
    for (int seed = first; seed < first + count; ++seed) {
      base::Random random(static_cast<std::uint64_t>(seed));
      const auto program = streaming::programOf(
          streaming::drawContour({120, 0.5 + 4.0 * random.uniform(), 0.2}, random));
      World world("dmu75", static_cast<std::uint64_t>(seed));
      const std::size_t after = 20 + random.below(80);
      world.resets = random.below(2) == 0;
      const auto begun = world.run(*program, settings(), after);
      world.resets = false;
      QVERIFY2(begun.outcome != Outcome::Completed && begun.checkpoint,
               std::to_string(seed).c_str());
      world.machine.advance(world.machine.now() + std::chrono::seconds{2});
      const auto left =
          streaming::resumeFrom(world.link, *program, begun.settings, *begun.checkpoint);
      if (!left) {  // the path passes there twice
        QCOMPARE(left.error().code, make_error_code(StreamError::CannotResume));
        ++refused;
        continue;
      }
      const auto way =
          streaming::backAlong(*program, begun.settings, *begun.checkpoint, left->point,
                               world.tool(*program), {0.5 + 30.0 * random.uniform()});
      if (!way) {
        QCOMPARE(way.error().code, make_error_code(StreamError::CannotResume));
        ++refused;
        continue;
      }
      ++driven;
      const bool isStopped = random.below(3) == 0 && way->places.size() > 3;
      world.resets = random.below(2) == 0;
      const auto back = world.run(streaming::backProgram(*way, {}), settings(),
                                  isStopped ? 1 + random.below(way->places.size() - 1) : SIZE_MAX);
      world.resets = false;
      QVERIFY(back.integrity.repeated + back.integrity.skipped + back.integrity.foreign == 0);
      halfway += back.outcome != Outcome::Completed ? 1 : 0;
      world.machine.advance(world.machine.now() + std::chrono::seconds{2});
      const auto on = streaming::resumeOnPart(world.link, *program, begun.settings,
                                              *begun.checkpoint, way->part);
      if (!on) {  // stopped beside a sharp corner, where nobody can tell
        QVERIFY2(isStopped, qPrintable(QString::fromStdString(on.error().text())));
        ++refused;
        continue;
      }
      QVERIFY(on->point >= way->part.first && on->point <= left->point);
      RunSettings again = settings();
      again.resume = *on;
      const auto rest = world.run(*program, again);
      QVERIFY2(rest.outcome == Outcome::Completed, rest.error.text().c_str());
      const auto points =
          gcode::streamPoints(program->trajectory, begun.checkpoint->startMm).points;
      const std::vector<Vec3> ends = endsOf(rest);
      QVERIFY(ends.size() == points.size() - on->point);
      for (std::size_t i = 0; i < ends.size(); ++i) {
        QVERIFY(base::distance(ends[i], points[on->point + i].positionMm) < 1e-6);
      }
    }
    qInfo("%d ways back, %d stopped on the way; %d refused", driven, halfway, refused);
    QVERIFY(driven > count / 3 && halfway > 0);
  }

  void endsWhereTheLastRapidEnded() {
    const gcode::Program program = part();
    // In the middle of the second move of the zigzag.
    const auto way = wayOf(program, 3, {{7.5, 1.5, -1}, {}}, std::nullopt);
    QVERIFY2(way.has_value(), qPrintable(refusal(way)));
    QCOMPARE(way->places.size(), std::size_t{3});
    QCOMPARE(way->places.back().mm.z, 10.0);
    QVERIFY(std::abs(way->lengthMm - (1.5 * std::hypot(5.0, 3.0) + 11.0)) < 0.5);
    QCOMPARE(way->part.first, std::size_t{1});
    const auto further = wayOf(program, 3, {{7.5, 1.5, -1}, {}}, 30.0);
    QVERIFY2(refusal(further).contains("can be driven back: a rapid ends in line 1"),
             qPrintable(refusal(further)));
  }

  void refusesByName_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("next");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("mm");
    QTest::addColumn<QString>("says");
    const QByteArray line = "G1 X0 Y0 Z0 F100\nX10\nX20\n";
    QTest::newRow("at the beginning") << line << 0 << 0.0 << 5.0 << "has executed nothing";
    QTest::newRow("at the end") << line << 3 << 20.0 << 5.0 << "or all of it";
    QTest::newRow("to the first point") << line << 1 << 5.0 << 6.0 << "the path begins in line 1";
    QTest::newRow("beside the path") << line << 1 << 25.0 << 5.0 << "not on the path";
    QTest::newRow("no rapid") << line << 1 << 5.0 << 0.0 << "no rapid to go back to";
    QTest::newRow("within a rapid") << QByteArray("G1 X0 Y0 Z0 F100\nG0 X10\nG1 X20\n") << 1 << 5.0
                                    << 2.0 << "no way back from";
    QTest::newRow("across a tool change")
        << QByteArray("G1 X0 Y0 Z0 F100\nX10\nT2 M6\nX20\n") << 2 << 15.0 << 8.0
        << "changes its tool or another function in line 3";
    QTest::newRow("back on itself")
        << QByteArray("G1 X0 Y0 Z0 F100\nX10\nX5\nX5 Y9\n") << 2 << 7.0 << 6.0 << "a place twice";
    QTest::newRow("across itself") << QByteArray("G1 X0 Y0 Z0 F100\nX10\nY10\nX5\nY-5\n") << 4
                                   << 5.0 << 28.0 << "a place twice";
  }
  void refusesByName() {
    QFETCH(const QByteArray, text);
    QFETCH(const int, next);
    QFETCH(const double, x);
    QFETCH(const double, mm);
    QFETCH(const QString, says);
    const auto way = wayOf(programOf(text.toStdString()), static_cast<std::size_t>(next),
                           {{x, 0, 0}, {}}, mm > 0.0 ? std::optional(mm) : std::nullopt);
    QVERIFY2(refusal(way).contains(says), qPrintable(refusal(way)));
  }

  /// Rotary axes turn back with the others.
  void turnsBack() {
    gcode::LoadOptions options;
    const gcode::Program program = *gcode::interpretProgram(
        "turn.nc", "G1 X0 Y0 Z0 A0 F100\nX10 A40\nX20 A80\nM30\n", options);
    RunSettings rotary = settings();
    rotary.parameters.rotaryAxes = {true, false, false};
    streaming::Checkpoint last;
    const auto way =
        streaming::backAlong(program, rotary, last, 2, {{15, 0, 0}, {60, 5, 0}}, {7.5});
    QVERIFY2(way.has_value(), qPrintable(refusal(way)));
    QCOMPARE(way->places.back().mm.x, 7.5);
    QCOMPARE(way->places.back().deg[0], 30.0);
    const auto points =
        gcode::streamPoints(streaming::backProgram(*way, rotary.parameters.rotaryAxes).trajectory,
                            {})
            .points;
    QCOMPARE(points.size(), std::size_t{2});
    QCOMPARE(points.back().rotaryDeg[0], 30.0);
  }
};

RIVULET_TEST(TestBackAlong)
#include "tst_back_along.moc"
