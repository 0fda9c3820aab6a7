// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Online correction: the cells as the driver keeps them, the program on the control alone, then
/// whole runs whose correction changes while the axes move.

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/units.h"
#include "streaming/recovery/resume.h"
#include "streaming/run/correction.h"
#include "streaming/run/job.h"
#include "streaming/simulation/scenario.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"
#include "templates/flexible_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::Instant;
using base::MethodKind;
using base::Vec3;
using streaming::Outcome;
using streaming::RunReport;
using streaming::RunSettings;
using streaming::StreamError;
using templates::WindowState;

namespace {

constexpr double kToken = 4711.0;
constexpr double kLimitMm = 0.1;
constexpr double kSameMm = 1e-9;

templates::TemplateParameters correctedParameters(int points = 7) {
  templates::TemplateParameters parameters;
  parameters.pointsPerLoop = points;
  parameters.correctionLimitMm = kLimitMm;
  parameters.silenceLimitS = 0.0;  // nobody gives signs of life
  return parameters;
}

/// The flexible program on a machine, fed by hand: one window of two points.
struct Bench {
  explicit Bench(machine::MachineConfig config = *machine::loadPreset("dmu75"))
      : parameters(correctedParameters(2)),
        cells(templates::makeProgram(parameters)->cells),
        machine(std::move(config), 1) {
    const std::string name = templates::makeProgram(parameters)->name;
    if (!machine.storeProgram(name, templates::makeProgram(parameters)->text, true) ||
        !machine.selectProgram(name) || !machine.cycleStart()) {
      qFatal("the flexible program does not run: %s", machine.state().alarmText.c_str());
    }
    run(500ms);
  }
  void run(base::Duration duration) { machine.advance(machine.now() + duration); }
  void set(int cell, double value) {
    machine.writeRParameter(cell, value);
    run(8ms);
  }
  void correct(Vec3 valueMm) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      machine.writeRParameter(cells.correction[axis], valueMm[axis]);
    }
    run(100ms);
  }
  void deliver(Vec3 pointMm, bool last) {
    const double count = last ? -2.0 : 2.0;
    const double feed = 600.0;
    double check = kToken + 7.31 + 13.7 * count + 0.917 * feed;
    int place = 0;
    for (int i = 0; i < 2; ++i) {
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        const double at = pointMm[axis] * (i + 1);
        machine.writeRParameter(cells.slotCells(i)[axis], at);
        check += templates::WindowProtocol::checkFactor(place++) * at;
      }
    }
    set(cells.client, kToken);
    run(500ms);
    machine.writeRParameter(cells.windowCount(0), count);
    machine.writeRParameter(cells.windowFeed(0), feed);
    set(cells.windowCheck(0), check);
    set(cells.run, 1.0);
    set(cells.delivered, 1.0);
  }
  /// Until the channel is in reset, at most ten minutes. @return the cell that says how it ended
  WindowState finish() {
    const Instant until = machine.now() + 10min;
    while (!hasEnded() && machine.now() < until) {
      run(4ms);
    }
    return static_cast<WindowState>(machine.ncRParameter(cells.state));
  }
  [[nodiscard]] bool hasEnded() const {
    return machine.state().channel == machine::ChannelStatus::Reset;
  }
  [[nodiscard]] bool isAt(Vec3 overlayMm) const {
    return base::distance(machine.state().overlayMm, overlayMm) < kSameMm;
  }

  templates::TemplateParameters parameters;
  templates::CellMap cells;
  machine::Machine machine;
};

/// Orders a correction by time and notes what comes of it.
class Orders final : public streaming::RunSink, public streaming::RunOrders {
 public:
  struct Change {
    Instant askedAt{};
    std::optional<Instant> confirmedAt;
    Vec3 valueMm;
  };

  void update(const streaming::LiveUpdate& update) override {
    executed = update.counters.executed;
    if (!update.correction) {
      return;
    }
    seen = update.correction;
    if (!changes.empty() && !changes.back().confirmedAt &&
        update.correction->confirmedMm == changes.back().valueMm) {
      changes.back().confirmedAt = update.at;
    }
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note& note) override { notes.push_back(note.text); }
  bool stopRequested(Instant) override {
    if (onPass) {
      onPass();
    }
    return executed >= stopAt;
  }
  Vec3 correctionMm(Instant now) override {
    const Vec3 wantedMm = wanted ? wanted(now) : Vec3{};
    if (wantedMm != (changes.empty() ? Vec3{} : changes.back().valueMm)) {
      changes.push_back({now, std::nullopt, wantedMm});
    }
    return wantedMm;
  }

  std::function<Vec3(Instant)> wanted;
  std::function<void()> onPass;
  std::size_t executed = 0;
  std::size_t stopAt = SIZE_MAX;
  std::optional<streaming::Correction> seen;
  std::vector<Change> changes;
  std::vector<std::string> notes;
};

struct World {
  explicit World(machine::MachineConfig config = *machine::loadPreset("dmu75"),
                 std::uint64_t seed = 1)
      : machine(std::move(config), seed), link(machine) {}
  RunReport run(const gcode::Program& program, const RunSettings& settings) {
    return streaming::runJob(link, link, program, settings, orders, orders);
  }
  machine::Machine machine;
  streaming::SimulatedLink link;
  Orders orders;
};

RunSettings settingsFor(double feedMmPerMin, int points = 7) {
  RunSettings settings;
  settings.parameters = correctedParameters(points);
  settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  return settings;
}

/// Points along X, from where the tool of the presets does not stand.
std::shared_ptr<const gcode::Program> straight(std::size_t points, double stepMm) {
  std::vector<Vec3> way;
  for (std::size_t i = 0; i < points; ++i) {
    way.push_back({stepMm * static_cast<double>(i + 1), 0.0, 0.0});
  }
  return streaming::programOf(way);
}

double fromPath(const std::vector<Vec3>& path, Vec3 at) {
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec3 way = path[i] - path[i - 1];
    const double length2 = base::dot(way, way);
    const double share =
        length2 > 0.0 ? std::clamp(base::dot(at - path[i - 1], way) / length2, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, base::distance(at, path[i - 1] + share * way));
  }
  return nearest;
}

std::string about(const RunReport& report) {
  return std::string(streaming::outcomeName(report.outcome)) + ": " + report.error.text();
}

}  // namespace

class TestCorrection : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // --- the cells, as the driver keeps them ------------------------------------------------
  void wantedIsCutOffAndNoNumberChangesNothing() {
    templates::TemplateParameters parameters = correctedParameters();
    parameters.axes = {true, false, true};
    streaming::CorrectionCells cells(templates::makeProgram(parameters)->cells, parameters);
    QVERIFY(cells.exists());
    QCOMPARE(cells.nodeCount(), 2);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    cells.want({0.05, 0.05, -7.0}, Instant{});
    QCOMPARE(cells.value().askedMm, (Vec3{0.05, 0.0, -0.1}));
    cells.want({nan, nan, infinity}, Instant{});
    QCOMPARE(cells.value().askedMm, (Vec3{0.05, 0.0, 0.1}));
    const auto writes = cells.take(Instant{1s});
    QCOMPARE(writes.size(), std::size_t{2});
    QCOMPARE(writes[0].value, 0.05);
    QCOMPARE(writes[1].value, 0.1);
    QCOMPARE(writes[1].variable.index, writes[0].variable.index + 1);
    QCOMPARE(cells.value().confirmedMm, Vec3{});
    cells.confirm();
    QCOMPARE(cells.value().confirmedMm, (Vec3{0.05, 0.0, 0.1}));
    parameters.correctionLimitMm = 0.0;
    QVERIFY(!streaming::CorrectionCells(templates::makeProgram(parameters)->cells, parameters)
                 .exists());
  }

  void writesAreRareAndNoneIsForgotten() {
    const templates::TemplateParameters parameters = correctedParameters();
    streaming::CorrectionCells cells(templates::makeProgram(parameters)->cells, parameters);
    const Instant begin{10s};
    QVERIFY(!cells.isDue(begin));
    cells.want({0.01, 0, 0}, begin);
    QVERIFY(cells.isDue(begin) && !cells.isOverdue(begin + 499ms));
    QVERIFY(cells.isOverdue(begin + 500ms));
    cells.want({0.02, 0, 0}, begin + 400ms);  // a newer one is no younger
    QVERIFY(cells.isOverdue(begin + 500ms));
    static_cast<void>(cells.take(begin + 500ms));
    QVERIFY(!cells.isDue(begin + 2s));
    cells.want({0.03, 0, 0}, begin + 510ms);
    QVERIFY(!cells.isDue(begin + 549ms));
    QVERIFY(cells.isDue(begin + 550ms));
    cells.want({0.02, 0, 0}, begin + 560ms);  // as it was sent: nothing to do
    QVERIFY(!cells.isDue(begin + 2s));
    cells.lost();  // whether it came through is not known
    QVERIFY(cells.isDue(begin + 2s));
    QCOMPARE(cells.take(begin + 2s)[0].value, 0.02);
    QVERIFY(!cells.isDue(begin + 3s));
  }

  // --- the program on the control alone ---------------------------------------------------
  void overlayFollowsTheCellsWithinTheLimit() {
    Bench bench;
    QCOMPARE(bench.machine.ncRParameter(bench.cells.layout),
             static_cast<double>(templates::makeProgram(bench.parameters)->layoutNumber));
    QVERIFY(bench.isAt({}));
    bench.correct({0.1, -0.1, 0.03});
    QVERIFY(bench.isAt({0.1, -0.1, 0.03}));
    for (const double wrong : {0.1001, -0.1001, 1e9, -1e9, 1e300}) {
      bench.correct({wrong, wrong, wrong});
      QVERIFY2(bench.isAt({0.1, -0.1, 0.03}), std::to_string(wrong).c_str());
    }
    QCOMPARE(bench.machine.state().alarm, 0);
    bench.correct({0.0, 0.02, 0.0});
    QVERIFY(bench.isAt({0.0, 0.02, 0.0}));
    QVERIFY(!bench.hasEnded());
  }

  /// No link sends what is no number. Should it come from elsewhere, the axes stay where they are.
  void whatIsNoNumberIsNotObeyed() {
    for (const double wrong :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      Bench bench;
      bench.correct({0.1, -0.1, 0.03});
      bench.correct({wrong, wrong, wrong});
      QVERIFY(bench.isAt({0.1, -0.1, 0.03}));
      QVERIFY(bench.machine.state().alarm != 0);
      bench.set(bench.cells.run, 2.0);
      QVERIFY(bench.finish() == WindowState::Stopped);
      QVERIFY(bench.isAt({}));
    }
  }

  /// What lay in the cells before the program began is not obeyed.
  void itBeginsWithNothing() {
    machine::MachineConfig config = *machine::loadPreset("dmu75");
    machine::Machine machine(config, 1);
    const templates::TemplateParameters parameters = correctedParameters(2);
    const templates::CellMap cells = templates::makeProgram(parameters)->cells;
    for (const int cell : cells.correction) {
      machine.writeRParameter(cell, 0.08);
    }
    machine.advance(machine.now() + 100ms);
    QVERIFY(machine.storeProgram("A.MPF", templates::makeProgram(parameters)->text, true));
    QVERIFY(machine.selectProgram("A.MPF"));
    QVERIFY(machine.cycleStart());
    for (int i = 0; i < 250; ++i) {
      machine.advance(machine.now() + 4ms);
      QCOMPARE(machine.state().overlayMm, Vec3{});
    }
    QCOMPARE(machine.ncRParameter(cells.correction[0]), 0.0);
  }

  /// Done, stopped, damaged, lost: the overlay is gone and the axes have arrived when the program
  /// has ended, whatever the client still asks for.
  void everyEndTakesTheOverlayBack() {
    for (const WindowState end :
         {WindowState::Done, WindowState::Stopped, WindowState::Damaged, WindowState::Abandoned}) {
      Bench bench;
      bench.correct({0.1, -0.1, 0.1});
      Vec3 expected = bench.machine.state().commandMm - Vec3{0.1, -0.1, 0.1};
      if (end == WindowState::Done || end == WindowState::Damaged) {
        bench.deliver({5.0, 4.0, 3.0}, true);
        if (end == WindowState::Damaged) {
          // The window on its way is executed; a number that does not fit is the next one's.
          Bench other;
          other.correct({0.1, -0.1, 0.1});
          expected = other.machine.state().commandMm - Vec3{0.1, -0.1, 0.1};
          other.set(other.cells.client, kToken);
          other.run(500ms);
          other.set(other.cells.windowCount(0), -2.0);
          other.set(other.cells.run, 1.0);
          other.set(other.cells.delivered, 1.0);
          QVERIFY(other.finish() == WindowState::Damaged);
          QVERIFY(other.isAt({}));
          QVERIFY(base::distance(other.machine.state().actualMm, expected) < 1e-3);
          continue;
        }
        expected = {10.0, 8.0, 6.0};
      } else if (end == WindowState::Stopped) {
        bench.set(bench.cells.run, 2.0);
      }
      QVERIFY(bench.finish() == end);
      QVERIFY(bench.isAt({}));
      QVERIFY2(base::distance(bench.machine.state().actualMm, expected) < 1e-3,
               std::to_string(base::distance(bench.machine.state().actualMm, expected)).c_str());
      bench.correct({0.1, 0.1, 0.1});  // nobody obeys any more
      QVERIFY(bench.isAt({}));
    }
  }

  void resetTakesItBackWhereTheControlDoes() {
    for (const int mode : {0, 2}) {
      machine::MachineConfig config = *machine::loadPreset("dmu75");
      config.overlay.mode = mode;
      Bench bench(config);
      bench.correct({0.1, 0.0, 0.0});
      bench.machine.reset();
      bench.run(1s);
      QVERIFY(bench.hasEnded());
      QVERIFY(bench.isAt({mode == 2 ? 0.1 : 0.0, 0.0, 0.0}));
    }
  }

  // --- whole runs -------------------------------------------------------------------------
  void pathIsDisplacedByTheCorrection_data() {
    QTest::addColumn<int>("method");
    QTest::newRow("window") << static_cast<int>(MethodKind::Window);
    QTest::newRow("credit") << static_cast<int>(MethodKind::Credit);
  }
  /// The path lies in a plane across Z: what is in Z is the correction. In X and Y the axes are as
  /// far from the path as the correction puts them.
  void pathIsDisplacedByTheCorrection() {
    QFETCH(int, method);
    base::Random random(3);
    const std::vector<Vec3> path = streaming::drawContour({300, 0.5, 0.5}, random);
    const auto program = streaming::programOf(path);
    RunSettings settings = settingsFor(600.0);
    settings.parameters.method = static_cast<MethodKind>(method);
    settings.isCommissioned = true;
    World still;
    const RunReport plain = still.run(*program, settings);
    QVERIFY2(plain.isFaultless(), about(plain).c_str());
    QVERIFY(still.orders.seen == streaming::Correction{});

    World world;
    const auto valueAt = [](Instant at) {
      constexpr std::array<Vec3, 5> kSteps{
          {{0, 0, 0.05}, {0, 0, -0.1}, {0.04, -0.03, 0.1}, {-0.1, 0.1, 0.0}, {0, 0, 0.025}}};
      return kSteps[static_cast<std::size_t>(base::toSeconds(at.time_since_epoch()) / 3.0) %
                    kSteps.size()];
    };
    world.orders.wanted = valueAt;
    const RunReport report = world.run(*program, settings);
    QVERIFY2(report.outcome == Outcome::Completed && report.isFaultless(), about(report).c_str());
    QCOMPARE(report.integrity.executed, path.size());
    QVERIFY(world.orders.changes.size() > 5);

    // Where the correction has stood for a second, the axes are where it puts them.
    std::size_t compared = 0;
    const double tolerance = world.machine.config().roundingMm + 1e-6;
    const std::vector<Orders::Change>& changes = world.orders.changes;
    for (const trace::ControlSample& sample : report.controlTrace->samples) {
      const auto next = std::find_if(changes.begin(), changes.end(), [&](const auto& change) {
        return change.askedAt > sample.at;
      });
      if (next == changes.begin() || sample.at - std::prev(next)->askedAt < 1s ||
          sample.at > report.controlTrace->blocks.back().to ||
          sample.at < report.controlTrace->blocks[1].to) {
        continue;
      }
      const Vec3 correctionMm = std::prev(next)->valueMm;
      QVERIFY2(std::abs(sample.commandMm.z - correctionMm.z) < kSameMm,
               std::to_string(sample.commandMm.z).c_str());
      QVERIFY(fromPath(path, sample.commandMm - correctionMm) <= tolerance);
      ++compared;
    }
    QVERIFY2(compared > 1000, std::to_string(compared).c_str());
    for (std::size_t i = 0; i + 1 < changes.size(); ++i) {
      QVERIFY(changes[i].confirmedAt);
    }
    QVERIFY(base::distance(world.machine.state().commandMm, path.back()) < kSameMm);

    // The axes stand where they stood, as long as they stood.
    QCOMPARE(report.pauses.size(), plain.pauses.size());
    const auto paused = [](const RunReport& run) {
      base::Duration sum{};
      for (const trace::Pause& pause : run.pauses) {
        sum += pause.duration;
      }
      return base::toSeconds(sum);
    };
    QVERIFY2(std::abs(paused(report) - paused(plain)) <= 0.05 * paused(plain) + 0.004,
             qPrintable(QStringLiteral("%1 s, %2 s").arg(paused(report)).arg(paused(plain))));
    QVERIFY(std::any_of(world.orders.notes.begin(), world.orders.notes.end(), [](const auto& note) {
      return note.find("online correction in mm: X 0.0000 Y 0.0000 Z 0.0500") == 0;
    }));
  }

  /// Far beyond the feed the client can keep up there is no slack; a correction still comes, and
  /// none comes too often.
  void correctionComesWithoutSlackAndNotTooOften() {
    for (const double feed : {500.0, 20000.0}) {
      base::Random random(5);
      const auto program = streaming::programOf(streaming::drawContour({1500, 0.15, 0.15}, random));
      World world;
      int step = 0;
      world.orders.wanted = [&step](Instant at) {
        step = static_cast<int>(base::toSeconds(at.time_since_epoch()) / 1.5);
        return Vec3{0.01 * (step % 7), 0.0, -0.01 * (step % 5)};
      };
      const int cell = templates::makeProgram(correctedParameters())->cells.correction[0];
      std::vector<Instant> writes;
      world.link.onWrite = [&](base::RequestId, int written, double) {
        if (written == cell) {
          writes.push_back(world.machine.now());
        }
      };
      const RunReport report = world.run(*program, settingsFor(feed));
      QVERIFY2(report.isFaultless(), about(report).c_str());
      const auto& changes = world.orders.changes;
      QVERIFY(changes.size() > 5);
      for (std::size_t i = 1; i + 1 < changes.size(); ++i) {
        QVERIFY2(changes[i].confirmedAt, std::to_string(i).c_str());
        // Half a second, the access in progress and its own.
        const double age = base::toSeconds(*changes[i].confirmedAt - changes[i].askedAt);
        QVERIFY2(age < 0.5 + 0.3, std::to_string(age).c_str());
      }
      QVERIFY(writes.size() + 1 >= changes.size() && writes.size() <= changes.size() + 1);

      // A source that never stands still.
      World busy;
      busy.orders.wanted = [](Instant at) {
        return Vec3{0.05 * std::sin(100.0 * base::toSeconds(at.time_since_epoch())), 0.0, 0.0};
      };
      writes.clear();
      busy.link.onWrite = [&](base::RequestId, int written, double) {
        if (written == cell) {
          writes.push_back(busy.machine.now());
        }
      };
      const RunReport other = busy.run(*program, settingsFor(feed));
      QVERIFY2(other.isFaultless(), about(other).c_str());
      QVERIFY(writes.size() > 10);
      const double perS =
          static_cast<double>(writes.size()) / base::toSeconds(writes.back() - writes.front());
      QVERIFY2(perS <= 20.5, std::to_string(perS).c_str());
    }
  }

  void stopTakesTheCorrectionBack() {
    World world;
    world.orders.wanted = [](Instant) { return Vec3{0.1, 0.1, 0.1}; };
    world.orders.stopAt = 60;
    const auto program = straight(200, 1.0);
    const RunReport report = world.run(*program, settingsFor(600.0));
    QVERIFY2(report.outcome == Outcome::Stopped && report.stopConfirmedAfter,
             about(report).c_str());
    QCOMPARE(world.machine.state().overlayMm, Vec3{});
    const Vec3 expected = report.controlTrace->blocks.back().targetMm;
    QVERIFY(base::distance(world.machine.state().actualMm, expected) < 1e-3);
    // It is taken up where it stopped, with another correction.
    RunSettings settings = settingsFor(600.0);
    const auto resume = streaming::resumeFrom(world.link, *program, settings, *report.checkpoint);
    QVERIFY(resume);
    QCOMPARE(resume->point, report.integrity.executed);
    settings.resume = *resume;
    world.orders.stopAt = SIZE_MAX;
    world.orders.wanted = [](Instant) { return Vec3{0.0, -0.1, 0.0}; };
    const RunReport rest = world.run(*program, settings);
    QVERIFY2(rest.isFaultless(), about(rest).c_str());
    QCOMPARE(rest.integrity.executed + report.integrity.executed, std::size_t{200});
  }

  /// Nothing is streamed where an overlay lies over the axes, or where it would be a sum.
  void unfitControlIsRefused() {
    for (const int mode : {1, 2}) {
      machine::MachineConfig config = *machine::loadPreset("dmu75");
      config.overlay.mode = mode;
      World world(config);
      if (mode == 2) {
        QVERIFY(
            world.machine.storeProgram("LEFT.MPF", "ID=1 DO $AA_OFF[Y]=0.02\nG4 F1\nM30\n", true));
        QVERIFY(world.machine.selectProgram("LEFT.MPF"));
        QVERIFY(world.machine.cycleStart());
        world.machine.advance(world.machine.now() + 3s);
        QCOMPARE(world.machine.state().overlayMm.y, 0.02);
      }
      const Vec3 before = world.machine.state().commandMm;
      const RunReport report = world.run(*straight(20, 1.0), settingsFor(600.0));
      QVERIFY2(report.outcome == Outcome::Failed, about(report).c_str());
      QVERIFY2(report.error.code ==
                   (mode == 2 ? StreamError::OverlayLeft : StreamError::OverlayIntegrates),
               about(report).c_str());
      world.machine.advance(world.machine.now() + 5s);
      QCOMPARE(world.machine.state().commandMm, before);
      QVERIFY(world.machine.state().channel == machine::ChannelStatus::Reset);
    }
  }

  void resumeBehindAReset_data() {
    QTest::addColumn<int>("mode");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<int>("error");  // 0: it goes on
    const int left = static_cast<int>(StreamError::OverlayLeft);
    const int unknown = static_cast<int>(StreamError::CannotResume);
    QTest::newRow("taken back, across the path") << 0 << 0.0 << 0.1 << 0;
    QTest::newRow("taken back, along a coarse path") << 0 << 0.1 << 0.0 << 0;
    QTest::newRow("kept, across the path") << 2 << 0.0 << 0.1 << left;
    QTest::newRow("foreign value in the cell") << 0 << 0.0 << 7.0 << unknown;
  }
  /// The tool stands on the path of the window it was reset in: with a correction over the axes it
  /// would be somewhere else than it seems.
  void resumeBehindAReset() {
    QFETCH(int, mode);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(int, error);
    machine::MachineConfig config = *machine::loadPreset("dmu75");
    config.overlay.mode = mode;
    World world(config);
    const auto program = straight(60, 5.0);
    const Vec3 correctionMm{x, std::min(y, 0.1), 0.0};
    world.orders.wanted = [correctionMm](Instant) { return correctionMm; };
    bool isReset = false;
    world.orders.onPass = [&] {
      // In the middle of a block, far from its points.
      const double at = std::fmod(world.machine.state().commandMm.x, 5.0);
      if (!isReset && world.orders.executed >= 30 && at > 2.0 && at < 3.0) {
        isReset = true;
        world.machine.reset();
      }
    };
    const RunSettings settings = settingsFor(600.0);
    const RunReport report = world.run(*program, settings);
    QVERIFY2(isReset && report.outcome == Outcome::Failed, about(report).c_str());
    world.machine.advance(world.machine.now() + 1s);
    if (y > 0.1) {
      world.machine.writeRParameter(
          templates::makeProgram(settings.parameters)->cells.correction[1], y);
      world.machine.advance(world.machine.now() + 1s);
    }
    const auto resume = streaming::resumeFrom(world.link, *program, settings, *report.checkpoint);
    if (error != 0) {
      QVERIFY(!resume);
      QVERIFY2(resume.error().code == make_error_code(static_cast<StreamError>(error)),
               resume.error().text().c_str());
      return;
    }
    QVERIFY2(resume, resume ? "" : resume.error().text().c_str());
    world.orders.onPass = nullptr;
    RunSettings rest = settings;
    rest.resume = *resume;
    const RunReport second = world.run(*program, rest);
    QVERIFY2(second.isFaultless(), about(second).c_str());
    QCOMPARE(second.integrity.executed + resume->point, std::size_t{60});
  }

  /// A correction along a path of close points: the tool may have passed points it has not, or not
  /// have passed those it has.
  void resumeAlongAFinePathIsRefused() {
    World world;
    const auto program = straight(600, 0.04);
    world.orders.wanted = [](Instant) { return Vec3{0.1, 0.0, 0.0}; };
    bool isReset = false;
    world.orders.onPass = [&] {
      // In the middle of a window, so that it passes where the tool is and where it would be.
      const double at = std::fmod(world.machine.state().commandMm.x - 0.1, 7 * 0.04);
      if (!isReset && world.orders.executed >= 200 && at > 0.14 && at < 0.22) {
        isReset = true;
        world.machine.reset();
      }
    };
    RunSettings settings = settingsFor(300.0);
    settings.placePauses = false;
    const RunReport report = world.run(*program, settings);
    QVERIFY(isReset && report.outcome == Outcome::Failed);
    world.machine.advance(world.machine.now() + 1s);
    const auto resume = streaming::resumeFrom(world.link, *program, settings, *report.checkpoint);
    QVERIFY(!resume);
    QVERIFY2(resume.error().code == StreamError::CannotResume, resume.error().text().c_str());
  }
};

RIVULET_TEST(TestCorrection)
#include "tst_correction.moc"
