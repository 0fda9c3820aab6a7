// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Method window: the program on the control alone, then whole runs with holds, stops and
/// resumptions. What a run may do at worst is in tst_window_faults.

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/units.h"
#include "gcode/program.h"
#include "streaming/methods/pause_placement.h"
#include "streaming/recovery/resume.h"
#include "streaming/run/job.h"
#include "streaming/simulation/scenario.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"
#include "templates/flexible_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::MethodKind;
using base::Vec3;
using streaming::Outcome;
using streaming::RunReport;
using streaming::RunSettings;
using streaming::StreamError;
using templates::WindowState;

namespace {

constexpr double kToken = 4711.0;

templates::TemplateParameters windowParameters(int points, int windows = 2) {
  templates::TemplateParameters parameters;
  parameters.method = MethodKind::Window;
  parameters.pointsPerLoop = points;
  parameters.windows = windows;
  return parameters;
}

templates::TemplateParameters unwatched(templates::TemplateParameters parameters) {
  parameters.silenceLimitS = 0.0;
  return parameters;
}

/// The flexible program on a machine, fed by hand, without signs of life.
struct Bench {
  explicit Bench(int points, machine::MachineConfig config = *machine::loadPreset("ideal"))
      : parameters(unwatched(windowParameters(points))),
        cells(templates::makeProgram(parameters)->cells),
        machine(std::move(config), 1) {
    const std::string name = templates::makeProgram(parameters)->name;
    const bool runs = machine.storeProgram(name, templates::makeProgram(parameters)->text, true) &&
                      machine.selectProgram(name) && machine.cycleStart();
    run(500ms);
    if (!runs || cell(cells.layout) != templates::makeProgram(parameters)->layoutNumber) {
      qFatal("the flexible program does not run: %s", machine.state().alarmText.c_str());
    }
  }
  void run(base::Duration duration) { machine.advance(machine.now() + duration); }
  void set(int cell, double value) {
    machine.writeRParameter(cell, value);
    run(8ms);
  }
  double cell(int number) const { return machine.ncRParameter(number); }
  void claim() {
    set(cells.client, kToken);
    run(500ms);
  }
  /// Content of window `number` (from 1) without its number. @return its cells
  void fill(int number, const std::vector<Vec3>& pointsMm, bool last = false,
            double feedMmPerMin = 3000.0) {
    const int slot = (number - 1) % parameters.windows;
    const double count = (last ? -1.0 : 1.0) * static_cast<double>(pointsMm.size());
    double check = kToken + 7.31 * number + 13.7 * count + 0.917 * feedMmPerMin;
    int place = 0;
    for (int i = 0; i < parameters.pointsPerLoop; ++i) {
      const Vec3 point = pointsMm[std::min(static_cast<std::size_t>(i), pointsMm.size() - 1)];
      const std::vector<int> numbers = cells.slotCells(slot * parameters.pointsPerLoop + i);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        machine.writeRParameter(numbers[axis], point[axis]);
        check += templates::WindowProtocol::checkFactor(place++) * point[axis];
      }
    }
    machine.writeRParameter(cells.windowCount(slot), count);
    machine.writeRParameter(cells.windowFeed(slot), feedMmPerMin);
    set(cells.windowCheck(slot), check);
  }
  bool hasEnded() const { return machine.state().channel == machine::ChannelStatus::Reset; }
  std::vector<Vec3> executed() const {
    std::vector<Vec3> targets;
    for (const trace::ExecutedBlock& block : machine.trace().blocks) {
      if (block.lengthMm > 0.0) {
        targets.push_back(block.targetMm);
      }
    }
    return targets;
  }

  templates::TemplateParameters parameters;
  templates::CellMap cells;
  machine::Machine machine;
};

class Orders final : public streaming::RunSink, public streaming::RunOrders {
 public:
  void update(const streaming::LiveUpdate& update) override {
    executed = update.counters.executed;
    held = held || update.state == streaming::RunState::Holding;
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(base::Instant) override { return executed >= stopAt; }
  bool holdRequested(base::Instant now) override {
    if (executed >= holdAt && !heldSince) {
      heldSince = now;
    }
    return heldSince && now < *heldSince + holdFor;
  }

  std::size_t executed = 0;
  std::size_t stopAt = SIZE_MAX;
  std::size_t holdAt = SIZE_MAX;
  base::Duration holdFor = 30s;
  std::optional<base::Instant> heldSince;
  bool held = false;
};

RunSettings settings(int points, double feedMmPerMin, int windows = 2) {
  RunSettings settings;
  settings.parameters = windowParameters(points, windows);
  settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  return settings;
}

struct World {
  explicit World(const std::string& preset, std::uint64_t seed = 1)
      : machine(*machine::loadPreset(preset), seed), link(machine) {}
  RunReport run(const gcode::Program& program, const RunSettings& run) {
    return streaming::runJob(link, link, program, run, orders, orders);
  }
  machine::Machine machine;
  streaming::SimulatedLink link;
  Orders orders;
};

std::shared_ptr<const gcode::Program> contour(std::size_t points, std::uint64_t seed = 1,
                                              double distanceMm = 0.15) {
  base::Random random(seed);
  return streaming::programOf(streaming::drawContour({points, distanceMm, distanceMm}, random));
}

gcode::Program scorpion() {
  return *gcode::loadProgram(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");
}

}  // namespace

class TestWindow : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void nothingMovesBeforeClaimRunAndDelivery() {
    for (int missing = 0; missing < 4; ++missing) {
      Bench bench(3);
      if (missing != 0) {
        bench.claim();
      }
      if (missing != 1) {
        bench.set(bench.cells.run, 1.0);
      }
      if (missing != 2) {
        bench.fill(1, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
      }
      if (missing != 3) {
        bench.set(bench.cells.delivered, 1.0);
      }
      bench.run(5s);
      QVERIFY2(bench.executed().empty(), std::to_string(missing).c_str());
    }
  }

  void windowsAreTakenInOrderAndTheMachineWaits() {
    Bench bench(3);
    bench.claim();
    QCOMPARE(bench.cell(bench.cells.owner), kToken);
    bench.fill(1, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
    bench.set(bench.cells.delivered, 1.0);
    bench.set(bench.cells.run, 1.0);
    bench.run(3s);
    QCOMPARE(bench.executed().size(), std::size_t{3});
    QCOMPARE(bench.cell(bench.cells.latched), 1.0);
    QCOMPARE(bench.cell(bench.cells.executed), 1.0);
    bench.run(10s);  // nothing comes: nothing is repeated
    QCOMPARE(bench.executed().size(), std::size_t{3});
    bench.fill(2, {{4, 0, 0}, {5, 0, 0}});  // a short one in the middle
    bench.set(bench.cells.delivered, 2.0);
    bench.run(3s);
    bench.fill(3, {{6, 0, 0}}, true);
    QVERIFY(!bench.hasEnded());
    bench.set(bench.cells.delivered, 3.0);
    bench.run(3s);
    QVERIFY(bench.hasEnded());
    QCOMPARE(bench.executed().size(), std::size_t{6});
    for (std::size_t i = 0; i < 6; ++i) {
      QVERIFY(base::distance(bench.executed()[i], {static_cast<double>(i + 1), 0, 0}) < 1e-9);
    }
    QCOMPARE(bench.cell(bench.cells.state), static_cast<double>(WindowState::Done));
    QCOMPARE(bench.cell(bench.cells.executed), 3.0);
  }

  /// The cells belong to the client again as soon as `latched` says so: what it writes then does
  /// not reach the window in progress.
  void latchedWindowMayBeOverwritten() {
    Bench bench(3);
    bench.claim();
    bench.fill(1, {{50, 0, 0}, {50, 50, 0}, {0, 50, 0}});
    bench.set(bench.cells.delivered, 1.0);
    bench.machine.writeRParameter(bench.cells.run, 1.0);
    while (bench.cell(bench.cells.latched) < 1.0) {
      bench.run(1ms);
    }
    for (int cell = bench.cells.windowCount(0); cell <= bench.cells.last(); ++cell) {
      bench.machine.writeRParameter(cell, 77.0);
    }
    bench.run(20s);
    const std::vector<Vec3> executed = bench.executed();
    QCOMPARE(executed.size(), std::size_t{3});
    QVERIFY(base::distance(executed[2], {0, 50, 0}) < 1e-9);
  }

  /// Whatever is wrong with a delivered window: it is refused, and the program ends standing.
  void damagedWindowIsRefused() {
    Bench reference(3);
    const int first = reference.cells.windowCount(0);
    const int cellCount = reference.cells.windowStride;
    for (int broken = 0; broken < cellCount + 2; ++broken) {
      Bench bench(3);
      bench.claim();
      bench.fill(broken == cellCount ? 3 : 1, {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
      if (broken < cellCount) {
        bench.set(first + broken, bench.cell(first + broken) + 0.001);
      }
      if (broken == cellCount + 1) {
        // The content of another run.
        bench.set(first + 2, bench.cell(first + 2) + 1.0);
      }
      bench.set(bench.cells.delivered, 1.0);
      bench.set(bench.cells.run, 1.0);
      bench.run(3s);
      QVERIFY2(bench.hasEnded(), std::to_string(broken).c_str());
      QVERIFY(bench.executed().empty());
      QCOMPARE(bench.cell(bench.cells.state), static_cast<double>(WindowState::Damaged));
    }
  }

  void numbersOutOfRangeAreWaitedOut() {
    Bench bench(3);
    bench.claim();
    bench.fill(1, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
    bench.set(bench.cells.run, 1.0);
    for (const double number : {-1.0, 0.0, 3.0, 1e9}) {
      bench.set(bench.cells.delivered, number);
      bench.run(2s);
      QVERIFY(bench.executed().empty());
      QVERIFY(!bench.hasEnded());
    }
    bench.set(bench.cells.delivered, 1.0);
    bench.run(3s);
    QCOMPARE(bench.executed().size(), std::size_t{3});
  }

  void onlyTheFirstClientIsGranted() {
    Bench bench(3);
    bench.claim();
    bench.set(bench.cells.client, 99.0);
    bench.run(2s);
    QCOMPARE(bench.cell(bench.cells.owner), kToken);
  }

  void silentClientEndsTheProgram() {
    Bench bench(3);
    bench.claim();
    bench.set(bench.cells.run, 1.0);
    for (int beat = 1; beat <= 120; ++beat) {
      bench.set(bench.cells.heartbeat, beat);
      bench.run(1s);
    }
    QVERIFY(!bench.hasEnded());
    bench.run(19s);
    QVERIFY(!bench.hasEnded());
    bench.run(60s);
    QVERIFY(bench.hasEnded());
    QCOMPARE(bench.cell(bench.cells.state), static_cast<double>(WindowState::Abandoned));
    bench.fill(1, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
    bench.set(bench.cells.delivered, 1.0);
    bench.run(10s);
    QVERIFY(bench.executed().empty());
  }

  void everyLengthRunsOnce() {
    for (const int windows : {1, 2, 3}) {
      for (const int perWindow : {1, 2, 7}) {
        for (std::size_t points = 1; points <= 3 * static_cast<std::size_t>(perWindow) + 2;
             ++points) {
          World world("ideal");
          const RunReport report =
              world.run(*contour(points, points, 2.0), settings(perWindow, 1000.0, windows));
          const std::string where = std::to_string(windows) + " windows of " +
                                    std::to_string(perWindow) + ", points " +
                                    std::to_string(points) + ": " + report.error.text();
          QVERIFY2(report.outcome == Outcome::Completed, where.c_str());
          QVERIFY2(report.isFaultless(), where.c_str());
          QVERIFY2(report.integrity.executed == points, where.c_str());
          QVERIFY2(report.counters.sent == points, where.c_str());
          QVERIFY2(report.counters.accepted == points, where.c_str());
        }
      }
    }
  }

  /// A real CAM program with the access cost of the real control; far beyond the feed that can be
  /// kept up the machine waits more often, and nothing else happens.
  void realProgramRunsFaultlesslyAtAnyFeed() {
    const gcode::Program program = scorpion();
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      for (const double feed : {500.0, 3000.0, 20000.0}) {
        World world("dmu75", seed);
        const RunReport report = world.run(program, settings(7, feed));
        QVERIFY2(report.isFaultless(),
                 qPrintable(QStringLiteral("seed %1 F %2: %3")
                                .arg(seed)
                                .arg(feed)
                                .arg(QString::fromStdString(report.error.text()))));
        QCOMPARE(report.integrity.executed, std::size_t{270});
      }
    }
  }

  /// The best form is found by itself. A window is one node then, and its number still comes in a
  /// request of its own, after the content.
  void windowsTravelAsArrays() {
    World world("dmu75-arrays");
    RunSettings run = settings(7, 2000.0);
    run.access = streaming::AccessChoice::Best;
    const templates::CellMap cells = templates::makeProgram(run.parameters)->cells;
    struct Delivery {
      base::RequestId request;
      double number;
      base::Instant at;
    };
    std::vector<Delivery> deliveries;
    std::map<base::RequestId, std::vector<int>> requests;
    std::map<base::RequestId, std::set<base::Instant>> moments;
    bool isStarted = false;
    world.link.onWrite = [&](base::RequestId request, int cell, double value) {
      isStarted = isStarted || world.machine.state().channel == machine::ChannelStatus::Active;
      if (!isStarted) {
        return;
      }
      requests[request].push_back(cell);
      moments[request].insert(world.machine.now());
      if (cell == cells.delivered) {
        deliveries.push_back({request, value, world.machine.now()});
      }
    };
    const RunReport report = world.run(*contour(70), run);
    QVERIFY2(report.isFaultless(), report.error.text().c_str());
    QVERIFY(report.accessForms.has_value());
    QVERIFY(report.settings.grouping == opcua::Grouping::ArrayCount);
    QCOMPARE(deliveries.size(), std::size_t{10});
    std::vector<base::RequestId> contents;
    for (const auto& [request, written] : requests) {
      if (written.size() > 1) {
        QCOMPARE(written.size(), static_cast<std::size_t>(cells.windowStride));
        QVERIFY(std::is_sorted(written.begin(), written.end()));
        QCOMPARE(moments[request].size(), std::size_t{1});  // one node
        contents.push_back(request);
      }
    }
    QCOMPARE(contents.size(), deliveries.size());
    for (std::size_t i = 0; i < deliveries.size(); ++i) {
      QCOMPARE(deliveries[i].number, static_cast<double>(i + 1));
      QCOMPARE(requests[deliveries[i].request].size(), std::size_t{1});
      QVERIFY(contents[i] < deliveries[i].request);
      QVERIFY(*moments[contents[i]].begin() < deliveries[i].at);
    }
  }

  /// Ordered arrays are used or nothing moves; a control without them gets lists.
  void controlsWithoutArrays() {
    World world("plc");
    RunSettings run = settings(7, 2000.0);
    run.access = streaming::AccessChoice::Best;
    const RunReport list = world.run(*contour(40), run);
    QVERIFY2(list.isFaultless(), list.error.text().c_str());
    QVERIFY(list.settings.grouping == opcua::Grouping::List);
    run.access = streaming::AccessChoice::Array;
    const RunReport none = world.run(*contour(40), run);
    QVERIFY(none.outcome == Outcome::Failed);
    QVERIFY(none.error.code == opcua::LinkError::Rejected);
    QCOMPARE(none.counters.sent, std::size_t{0});
  }

  /// The methods of the paper may use them where their cells follow one another.
  void otherMethodsNeedTheContiguousLayout() {
    World world("dmu75");
    RunSettings run = settings(7, 300.0);
    run.parameters.method = MethodKind::Signal;
    run.access = streaming::AccessChoice::Array;
    const RunReport refused = world.run(*contour(40, 1, 2.0), run);
    QVERIFY(refused.error.code == opcua::LinkError::Rejected);
    QCOMPARE(refused.counters.sent, std::size_t{0});
    run.parameters.layout = templates::Layout::Contiguous;
    const RunReport report = world.run(*contour(40, 1, 2.0), run);
    QVERIFY2(report.isFaultless(), report.error.text().c_str());
    QVERIFY(report.settings.grouping == opcua::Grouping::ArrayCount);
  }

  /// Whatever N, number of windows, and cells per point: the probe finds its cells.
  void everyShapeRunsWithArrays() {
    for (const int windows : {1, 2, 3}) {
      for (const int perWindow : {1, 2, 6}) {
        for (const int stride : {0, 4}) {
          World world("ideal");
          RunSettings run = settings(perWindow, 2000.0, windows);
          run.parameters.slotStride = stride;
          run.access = streaming::AccessChoice::Array;
          const templates::CellMap cells = templates::makeProgram(run.parameters)->cells;
          std::set<int> owned{cells.windowCount(0) - 1};
          for (int cell : {cells.run, cells.delivered, cells.layout, cells.client, cells.heartbeat,
                           cells.overrideWanted}) {
            owned.insert(cell);
          }
          for (int window = 0; window < windows; ++window) {
            owned.insert(cells.windowCount(window));
            owned.insert(cells.windowFeed(window));
            owned.insert(cells.windowCheck(window));
          }
          for (int slot = 0; slot < cells.slotCount(); ++slot) {
            for (const int cell : cells.slotCells(slot)) {
              owned.insert(cell);
            }
          }
          int stranger = -1;
          world.link.onWrite = [&](base::RequestId, int cell, double) {
            stranger = owned.contains(cell) ? stranger : cell;
          };
          const RunReport report = world.run(*contour(15), run);
          QCOMPARE(stranger, -1);
          const std::string where = std::to_string(windows) + " windows of " +
                                    std::to_string(perWindow) + ", stride " +
                                    std::to_string(stride) + ": " + report.error.text();
          QVERIFY2(report.isFaultless(), where.c_str());
          QCOMPARE(report.integrity.executed, std::size_t{15});
        }
      }
    }
  }

  /// While the client keeps up there is one pause per window, as long as those of the paper.
  void onePausePerWindow() {
    World world("dmu75");
    const RunReport report = world.run(*contour(200), settings(7, 300.0));
    QVERIFY(report.isFaultless());
    QCOMPARE(report.pauses.size(), std::size_t{28});
    for (const trace::Pause& pause : report.pauses) {
      QVERIFY2(pause.duration < 70ms, std::to_string(base::toMilliseconds(pause.duration)).c_str());
    }
  }

  void stopEndsInFrontOfTheNextWindow() {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      World world("dmu75", seed);
      world.orders.stopAt = 30;
      const RunReport report = world.run(scorpion(), settings(7, 2000.0));
      QVERIFY2(report.outcome == Outcome::Stopped, report.error.text().c_str());
      QVERIFY(report.stopConfirmedAfter.has_value());
      QVERIFY(report.integrity.isFaultless());
      QVERIFY(report.integrity.executed >= 30 && report.integrity.executed <= 30 + 3 * 7);
      const auto points = gcode::streamPoints(scorpion().trajectory, {}).points;
      const auto begins = streaming::placePauses(points, 7).begins;
      QVERIFY(std::find(begins.begin(), begins.end(), report.integrity.executed) != begins.end());
      QCOMPARE(report.counters.executed, report.integrity.executed);
      const std::size_t samples = world.machine.trace().samples.size();
      world.machine.advance(world.machine.now() + 60s);
      QCOMPARE(world.machine.trace().samples.size(), samples);
    }
  }

  void holdWaitsAndContinues() {
    World world("dmu75");
    world.orders.holdAt = 40;
    const RunReport report = world.run(scorpion(), settings(7, 2000.0));
    QVERIFY2(report.isFaultless(), report.error.text().c_str());
    QVERIFY(report.outcome == Outcome::Completed);
    QVERIFY(world.orders.held);
    // It is no pause of the stream.
    QCOMPARE(report.holds.size(), std::size_t{1});
    QVERIFY(report.holds.front().duration > 25s && report.holds.front().duration < 31s);
    for (const trace::Pause& pause : report.pauses) {
      QVERIFY(pause.duration < 1s);
    }
  }

  void resumesWhereItWasStopped() {
    const auto program = contour(150);
    World world("dmu75");
    world.orders.stopAt = 60;
    RunSettings run = settings(7, 600.0);
    const RunReport first = world.run(*program, run);
    QVERIFY(first.outcome == Outcome::Stopped);
    QVERIFY(first.checkpoint.has_value());
    const auto resume =
        streaming::resumeFrom(world.link, *program, first.settings, *first.checkpoint);
    QVERIFY2(resume.has_value(), resume ? "" : resume.error().text().c_str());
    QCOMPARE(resume->point, first.integrity.executed);
    world.orders.stopAt = SIZE_MAX;
    run.resume = *resume;
    const RunReport second = world.run(*program, run);
    QVERIFY2(second.isFaultless(), second.error.text().c_str());
    QCOMPARE(first.integrity.executed + second.integrity.executed, std::size_t{150});
    const auto nothingLeft =
        streaming::resumeFrom(world.link, *program, second.settings, *second.checkpoint);
    QVERIFY(!nothingLeft && nothingLeft.error().code == StreamError::CannotResume);
    const auto other =
        streaming::resumeFrom(world.link, *program, first.settings, *first.checkpoint);
    QVERIFY(!other && other.error().code == StreamError::CannotResume);
  }

  void pointAheadOfTheTool() {
    const std::vector<Vec3> path{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {20, 10, 0}};
    QCOMPARE(streaming::pointAhead(path, {0, 0, 0}), std::optional<std::size_t>(1));
    QCOMPARE(streaming::pointAhead(path, {5, 0.01, 0}), std::optional<std::size_t>(1));
    QCOMPARE(streaming::pointAhead(path, {10, 0, 0}), std::optional<std::size_t>(2));
    QCOMPARE(streaming::pointAhead(path, {10, 9, 0}), std::optional<std::size_t>(2));
    QCOMPARE(streaming::pointAhead(path, {20, 10, 0}), std::optional<std::size_t>(4));
    QVERIFY(!streaming::pointAhead(path, {5, 1, 0}));
    const std::vector<Vec3> crossing{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {5, -5, 0}};
    QVERIFY(!streaming::pointAhead(crossing, {5.0 + 5.0 / 3.0, 0, 0}));
    QCOMPARE(streaming::pointAhead(crossing, {2, 0, 0}), std::optional<std::size_t>(1));
    // Out and back again by less than half a millimetre: either point may have been the last.
    const std::vector<base::Vec3> spur{{-1, 0, 0}, {0, 0, 0}, {0.07, 0, 0}, {0, 0, 0}, {0, 1, 0}};
    QVERIFY(!streaming::pointAhead(spur, {0, 0, 0}));
    QCOMPARE(streaming::pointAhead(spur, {0, 0.5, 0}), std::optional<std::size_t>(4));
    // Cutting a corner by a rounding is no second pass.
    const std::vector<base::Vec3> corner{{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}};
    QCOMPARE(streaming::pointAhead(corner, {-0.02, 0.03, 0}), std::optional<std::size_t>(2));
  }
};

RIVULET_TEST(TestWindow)
#include "tst_window.moc"
