// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Hold and override by the feed cell, in virtual time: from the order to standing, what is executed
// afterwards, and machines that do not obey. The judge has the machine's own trace and the instant
// at which the cell was written there.

#include <fmt/format.h>

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "base/random.h"
#include "base/units.h"
#include "job/main_program.h"
#include "job/plan.h"
#include "machine/braking.h"
#include "machine/machine.h"
#include "streaming/run/whole_job.h"
#include "streaming/simulation/scenario.h"
#include "streaming/simulation/simulated_link.h"
#include "support/misread_link.h"
#include "support/sleepy_link.h"
#include "support/stop_bench.h"
#include "support/test_program.h"
#include "support/whole_trace_link.h"
#include "templates/flexible_program.h"
#include "trace/analysis/pauses.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::Duration;
using base::Instant;
using base::MethodKind;
using base::Vec3;
using machine::brakingTime;
using streaming::FeedOrder;
using streaming::Outcome;
using streaming::RunSettings;
using tests::circles;
using tests::Hold;
using tests::lines;
using tests::median;
using tests::MisreadLink;
using tests::Operator;
using tests::stopsWanted;
using tests::worst;

namespace {

struct World {
  explicit World(std::uint64_t seed = 1, const char* preset = "dmu75")
      : config(configOf(preset)), machine(config, seed), link(machine), person(seed) {
    person.machine = &machine;
  }
  static machine::MachineConfig configOf(const char* preset) {
    machine::MachineConfig config = *machine::loadPreset(preset);
    config.traceLimit = 12h;
    return config;
  }
  void watch(int cell) {
    link.onWrite = [this, cell](base::RequestId, int written, double value) {
      if (written == cell && value == 0.0 && !person.holds.empty() &&
          !person.holds.back().written) {
        person.holds.back().written = machine.now();
      }
    };
  }
  streaming::RunReport run(const gcode::Program& program, const RunSettings& settings) {
    const auto flexible = templates::makeProgram(settings.parameters);
    watch(flexible->cells.overrideWanted);
    tests::WholeTraceLink whole(link);
    return streaming::runJob(whole, link, program, *flexible, settings, person, person);
  }

  machine::MachineConfig config;
  machine::Machine machine;
  streaming::SimulatedLink link;
  Operator person;
};

RunSettings settingsOf(MethodKind method, double feedMmPerMin, int points = 7) {
  RunSettings settings;
  settings.parameters.method = method;
  settings.parameters.pointsPerLoop = points;
  settings.isCommissioned = true;
  settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  return settings;
}

std::shared_ptr<const gcode::Program> contour(std::size_t points) {
  base::Random random(3);
  return streaming::programOf(streaming::drawContour({points, 0.15, 0.15}, random));
}

struct Stopped {
  std::vector<double> toCellS;  ///< from the order until the cell was written
  std::vector<double> standsS;  ///< from the order until the set point stands
  std::vector<double> brakesS;  ///< from the next cycle until it stands
  std::string wrong;            ///< empty: nothing
};

/// What the machine did with each hold. The client's clock is the machine's.
Stopped judge(const World& world, const trace::ControlTrace& trace) {
  Stopped stopped;
  const Duration cycle = trace.cycle;
  const auto fail = [&stopped](std::string why) {
    if (stopped.wrong.empty()) {
      stopped.wrong = std::move(why);
    }
  };
  for (const Hold& hold : world.person.holds) {
    if (!hold.written) {
      fail("a hold was never written");
      continue;
    }
    // In force at the boundary after it; axes that stand may leave until then.
    const auto from = std::lower_bound(
        trace.samples.begin(), trace.samples.end(), *hold.written + cycle,
        [](const trace::ControlSample& sample, Instant at) { return sample.at < at; });
    const Instant until = hold.released == Instant{} ? Instant::max() : hold.released;
    const double speed = from == trace.samples.begin() ? 0.0 : std::prev(from)->feedMmPerS;
    auto stands = from;
    while (stands != trace.samples.end() && stands->feedMmPerS > 0.0 && stands->at < until) {
      ++stands;
    }
    if (stands == trace.samples.end()) {
      continue;  // the program has ended meanwhile
    }
    const Duration access = *hold.written - hold.ordered;
    const Duration brakes = stands->at - from->at;
    stopped.toCellS.push_back(base::toSeconds(access));
    stopped.brakesS.push_back(base::toSeconds(brakes));
    stopped.standsS.push_back(base::toSeconds(stands->at - hold.ordered));
    if (access > 2 * world.person.longest + 2 * cycle) {
      fail(fmt::format("written only after {:.1f} ms", base::toMilliseconds(access)));
    }
    if (brakes > brakingTime(world.config, speed) + 2 * cycle) {
      fail(fmt::format("from {:.1f} mm/s it took {:.1f} ms to stand, at most {:.1f} were due",
                       speed, base::toMilliseconds(brakes),
                       base::toMilliseconds(brakingTime(world.config, speed) + 2 * cycle)));
    }
    for (auto held = stands; held != trace.samples.end() && held->at <= until; ++held) {
      const double movedMm = base::distance(held->commandMm, stands->commandMm);
      if (held->feedMmPerS > 0.0 || movedMm > 1e-3) {
        fail(fmt::format("moved by {:.4f} mm while held", movedMm));
        break;
      }
    }
  }
  return stopped;
}

/// A client that is silent again and again at drawn times.
class Naps {
 public:
  Naps(std::uint64_t seed, std::size_t most) : m_random(seed), m_most(most) {}
  Duration operator()(Instant now) {
    if (m_count == m_most) {
      return {};
    }
    if (m_next == Instant{}) {
      m_next = now + drawn(1.5);
    }
    if (now < m_next) {
      return {};
    }
    ++m_count;
    const Duration asleep = drawn(6.0);
    m_next = now + asleep + drawn(3.0);
    return asleep;
  }

 private:
  Duration drawn(double mostS) { return base::fromSeconds(mostS * m_random.uniform()); }

  base::Random m_random;
  std::size_t m_most;
  std::size_t m_count = 0;
  Instant m_next{};
};

struct Silences {
  std::size_t stood = 0;  ///< silences in which the axes had to stand, and did
  double worstS = 0.0;    ///< from the beginning of a silence until they stood
  std::string wrong;
};

/// No set point moves in a silence, once the limit and the braking are over.
Silences judgeSilences(const World& world, const std::vector<tests::SleepyLink::Sleep>& sleeps,
                       double limitS) {
  Silences found;
  const trace::ControlTrace& trace = world.person.trace;
  for (const auto& sleep : sleeps) {
    // A sign of life may have been on its way.
    const Instant due = sleep.from + 2 * world.person.longest + base::fromSeconds(limitS) +
                        brakingTime(world.config, 8000.0 / 60.0) + 3 * trace.cycle;
    found.stood += sleep.to > due ? 1 : 0;
    Instant last = sleep.from;
    for (const trace::ControlSample& sample : trace.samples) {
      if (sample.at < sleep.from || sample.at >= sleep.to || sample.feedMmPerS == 0.0) {
        continue;
      }
      last = sample.at;
      if (sample.at > due && found.wrong.empty()) {
        found.wrong = fmt::format("moved {:.3f} s after the client had become silent",
                                  base::toSeconds(sample.at - sleep.from));
      }
    }
    found.worstS = std::max(found.worstS, base::toSeconds(last - sleep.from));
  }
  return found;
}

void show(const char* name, const Stopped& stopped) {
  qInfo(
      "%s: %zu stops; order to cell %.0f ms (worst %.0f), braking %.0f (%.0f), in all %.0f (%.0f)",
      name, stopped.standsS.size(), 1e3 * median(stopped.toCellS), 1e3 * worst(stopped.toCellS),
      1e3 * median(stopped.brakesS), 1e3 * worst(stopped.brakesS), 1e3 * median(stopped.standsS),
      1e3 * worst(stopped.standsS));
}

}  // namespace

class TestFeedCell : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyStopStands_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<std::string>("kind");
    QTest::addColumn<double>("feedMmPerMin");
    const auto row = [](MethodKind method, const char* kind, double feed) {
      const std::string_view name = base::methodName(method);
      QTest::addRow("%s, %s at F %.0f", std::string(name).c_str(), kind, feed)
          << static_cast<int>(method) << std::string(kind) << feed;
    };
    for (const MethodKind method : {MethodKind::Window, MethodKind::Credit, MethodKind::File}) {
      row(method, "contour", 400.0);
      row(method, "arcs", 2000.0);
      row(method, "300 mm moves", 400.0);
      row(method, "300 mm moves", 8000.0);
    }
  }

  /// After Continue the points are those of the run: the machine's trace is judged as a whole.
  void everyStopStands() {
    QFETCH(int, method);
    QFETCH(std::string, kind);
    QFETCH(double, feedMmPerMin);
    World world(7);
    world.person.holdsMax = stopsWanted();
    const std::size_t stops = stopsWanted();
    const auto program = kind == "contour" ? contour(stops * 40)
                         : kind == "arcs"  ? circles(stops * 40)
                                           : lines(stops / 4 + 10, 300.0);
    const streaming::RunReport report =
        world.run(*program, settingsOf(static_cast<MethodKind>(method), feedMmPerMin));
    QVERIFY2(report.isFaultless() && report.outcome == Outcome::Completed,
             report.error.text().c_str());
    const Stopped stopped = judge(world, world.person.trace);
    show(QTest::currentDataTag(), stopped);
    QVERIFY2(stopped.wrong.empty(), stopped.wrong.c_str());
    QVERIFY(stopped.standsS.size() >= 10);
    QVERIFY(!world.person.wasIgnored);
    // Held, the tool is on the path.
    if (kind == "300 mm moves") {
      const Instant there = world.person.trace.blocks.front().to + 100ms;  // and has settled
      for (const trace::ControlSample& sample : world.person.trace.samples) {
        QVERIFY(sample.at <= there ||
                (std::abs(sample.commandMm.y) < 1e-9 && std::abs(sample.commandMm.z) < 1e-9));
      }
    }
    // Each is in the report, and none is a pause of the stream.
    std::size_t holds = 0;
    for (const streaming::FeedEvent& event : report.feed) {
      holds += event.isHold() ? 1 : 0;
    }
    QCOMPARE(holds, world.person.holds.size());
    // One that begins or ends in a pause of the stream may count to either.
    const auto longer =
        std::count_if(report.pauses.begin(), report.pauses.end(),
                      [](const trace::Pause& pause) { return pause.duration > 150ms; });
    QVERIFY2(longer <= 1 + static_cast<long>(holds) / 4, fmt::format("{}", longer).c_str());
  }

  /// A whole job: native moves, rapids, arcs, cycles and stretches; the same blocks are executed as
  /// without holds.
  void everyStopStandsInAJob() {
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Sinumerik;
    const auto plan = job::makePlan("PART.MPF", tests::jobText(6), options);
    QVERIFY2(plan.has_value(), plan ? "" : plan.error().text().c_str());
    const auto isWhole = job::requireWhole(*plan);
    QVERIFY2(isWhole.has_value(), isWhole ? "" : isWhole.error().text().c_str());
    std::vector<std::size_t> executed;
    for (const std::size_t holds : {std::size_t{0}, stopsWanted()}) {
      World world(5, "dmu75-mill");
      world.person.holdsMax = holds;
      world.person.meanS = 0.7;
      RunSettings settings = settingsOf(MethodKind::Window, 1500.0, 5);
      const auto programs = job::makePrograms(*plan, settings.parameters);
      QVERIFY2(programs.has_value(), programs ? "" : programs.error().text().c_str());
      world.watch(programs->loop.cells.overrideWanted);
      tests::WholeTraceLink whole(world.link);
      const streaming::WholeJobReport report = streaming::runWholeJob(
          whole, world.link, *plan, *programs, settings, world.person, world.person);
      QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
      QVERIFY(report.integrity.judged);
      QCOMPARE(report.integrity.repeated + report.integrity.skipped + report.integrity.foreign,
               std::size_t{0});
      std::size_t blocks = 0;
      for (const trace::ExecutedBlock& block : world.person.trace.blocks) {
        blocks += block.lengthMm > 0.01 ? 1 : 0;
      }
      executed.push_back(blocks);
      const Stopped stopped = judge(world, world.person.trace);
      if (holds > 0) {
        show("job", stopped);
        QVERIFY(stopped.standsS.size() >= 10);
      }
      QVERIFY2(stopped.wrong.empty(), stopped.wrong.c_str());
    }
    QCOMPARE(executed[0], executed[1]);
  }

  void overrideScalesTheFeed() {
    World world;
    const auto program = lines(4, 100.0);
    std::optional<Instant> first;
    world.person.orderWhen = [&](Instant now) -> FeedOrder {
      if (world.person.seen && !first) {
        first = now;
      }
      const double s = first ? base::toSeconds(now - *first) : 0.0;
      return {false, s < 3.0 ? 100.0 : s < 6.0 ? 50.0 : s < 9.0 ? 120.0 : 100.0};
    };
    const streaming::RunReport report = world.run(*program, settingsOf(MethodKind::Window, 1000.0));
    QVERIFY(report.isFaultless() && report.outcome == Outcome::Completed);
    std::set<long> speeds;
    for (const trace::ControlSample& sample : world.person.trace.samples) {
      speeds.insert(std::lround(600.0 * sample.feedMmPerS / 10.0));
    }
    QVERIFY(speeds.contains(1000) && speeds.contains(500) && speeds.contains(1200));
    QCOMPARE(*speeds.rbegin(), 1200L);
    QCOMPARE(report.feed.size(), std::size_t{3});
    QVERIFY(world.person.hasNote("override 50 % requested"));
  }

  void whatIsNoOverrideIsRefused() {
    for (const double percent : {250.0, -1.0, std::nan(""), HUGE_VAL}) {
      World world;
      world.person.orderWhen = [percent](Instant) -> FeedOrder { return {false, percent}; };
      bool isOther = false;
      const auto settings = settingsOf(MethodKind::Window, 1000.0);
      const auto flexible = templates::makeProgram(settings.parameters);
      world.link.onWrite = [&](base::RequestId, int cell, double value) {
        isOther = isOther || (cell == flexible->cells.overrideWanted && value != 100.0);
      };
      const auto report = streaming::runJob(world.link, world.link, *lines(2, 10.0), *flexible,
                                            settings, world.person, world.person);
      QVERIFY(report.outcome == Outcome::Completed && !isOther);
      QCOMPARE(std::count_if(world.person.notes.begin(), world.person.notes.end(),
                             [](const std::string& note) {
                               return note.find("refused") != std::string::npos;
                             }),
               1);
    }
  }

  /// Written past every client: the program itself holds the axes.
  void whatIsNoOverrideInTheCellHolds() {
    for (const double percent : {250.0, 200.001, -1.0, -1e9, 1e300}) {
      World world;
      const auto settings = settingsOf(MethodKind::Window, 1000.0, 2);
      const auto flexible = templates::makeProgram(settings.parameters);
      std::optional<Instant> since;
      world.person.orderWhen = [&](Instant now) -> FeedOrder {
        if (world.person.executed >= 1 && !since) {
          since = now;
          world.machine.writeRParameter(flexible->cells.overrideWanted, percent);
        }
        // The operator takes it back; another order than before is needed for that.
        return {false, since && now > *since + 20s ? 99.0 : 100.0};
      };
      const auto report = world.run(*lines(10, 60.0), settings);
      QVERIFY2(report.isFaultless() && report.outcome == Outcome::Completed,
               report.error.text().c_str());
      const auto pauses = trace::findPauses(world.person.trace);
      QVERIFY(std::any_of(pauses.begin(), pauses.end(),
                          [](const trace::Pause& pause) { return pause.duration > 19s; }));
    }
  }

  /// A second client holds the machine: it is told, and nothing is written over it.
  void anotherClientsHoldStays() {
    World world;
    const auto settings = settingsOf(MethodKind::Window, 400.0, 2);
    const auto flexible = templates::makeProgram(settings.parameters);
    std::optional<Instant> since;
    world.person.orderWhen = [&](Instant now) -> FeedOrder {
      if (world.person.executed >= 1 && !since) {
        since = now;
        world.machine.writeRParameter(flexible->cells.overrideWanted, 0.0);
      }
      return {false, since && now > *since + 60s ? 90.0 : 100.0};
    };
    const auto report = world.run(*lines(6, 60.0), settings);
    QVERIFY2(report.isFaultless() && report.outcome == Outcome::Completed,
             report.error.text().c_str());
    QVERIFY(world.person.hasNote("another client has set the override to 0 %"));
    QVERIFY(report.feed.front().isForeign && report.feed.front().isHold());
    QVERIFY(report.feed.front().lasted > 55s);
  }

  /// Held at a stop, the program does not end before somebody lets it go on.
  void aStopThatIsHeldWaits() {
    World world;
    std::optional<Instant> since;
    const auto isAfter = [&](Instant now, Duration time) { return since && now > *since + time; };
    world.person.orderWhen = [&](Instant now) -> FeedOrder {
      if (world.person.executed >= 1 && !since) {
        since = now;
      }
      return {since && !isAfter(now, 120s)};
    };
    world.person.stopWhen = [&](Instant now) { return isAfter(now, 1s); };
    const auto report = world.run(*lines(40, 60.0), settingsOf(MethodKind::Window, 400.0, 2));
    QVERIFY2(
        report.outcome == Outcome::Stopped && report.finding() == streaming::RunFinding::Faultless,
        report.error.text().c_str());
    QVERIFY(report.counters.executed < 10);
    QVERIFY(*report.stopConfirmedAfter > 118s);
    QCOMPARE(report.holds.size(), std::size_t{1});
  }

  void aSilentClientStands_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<double>("limitS");
    QTest::addColumn<double>("feedMmPerMin");
    for (const MethodKind method : {MethodKind::Window, MethodKind::Credit, MethodKind::File}) {
      for (const double limitS : {0.5, 1.0}) {
        for (const double feed : {400.0, 8000.0}) {
          QTest::addRow("%s, %.1f s, F %.0f", std::string(base::methodName(method)).c_str(), limitS,
                        feed)
              << static_cast<int>(method) << limitS << feed;
        }
      }
    }
  }

  /// It stands within the set time, and goes on with the client: every point once.
  void aSilentClientStands() {
    QFETCH(int, method);
    QFETCH(double, limitS);
    QFETCH(double, feedMmPerMin);
    World world(11);
    const auto program = lines(feedMmPerMin > 1000.0 ? 60 : 12, 300.0);
    RunSettings settings = settingsOf(static_cast<MethodKind>(method), feedMmPerMin, 3);
    settings.parameters.silenceLimitS = limitS;
    const auto flexible = templates::makeProgram(settings.parameters);
    QVERIFY2(flexible.has_value(), flexible ? "" : flexible.error().text().c_str());
    Naps drawn(2, 20);
    tests::SleepyLink sleepy(world.link, [&](Instant now) {
      return world.person.executed > 0 ? drawn(now) : Duration{};
    });
    tests::WholeTraceLink whole(sleepy);
    const auto report = streaming::runJob(whole, world.link, *program, *flexible, settings,
                                          world.person, world.person);
    QVERIFY2(report.isFaultless() && report.outcome == Outcome::Completed,
             report.error.text().c_str());
    const Silences found = judgeSilences(world, sleepy.sleeps(), limitS);
    qInfo("%zu silences, the axes stood in %zu; worst %.2f s", sleepy.sleeps().size(), found.stood,
          found.worstS);
    QVERIFY2(found.wrong.empty(), found.wrong.c_str());
    QVERIFY(found.stood >= 8);
    QVERIFY(world.person.hasNote("the axes have stood meanwhile"));
  }

  /// In native moves and cycles of a whole job, too; the same blocks are executed.
  void aSilentClientStandsInAJob() {
    std::string text = "G17 G90 G71 G94 F300\nT1 M6\nS1000 M3\nG0 X0 Y0 Z20\n";
    for (int i = 0; i < 4; ++i) {
      text += "SUPA G0 Z60\nG0 X0 Y0 Z20\nG1 Z0\nG1 X200 Y10\nG0 Z20\n";
      text += "F100\nMCALL CYCLE81(20,0,2,-10)\nX5 Y5\nX30 Y5\nMCALL\nF300\n";
    }
    text += "M30\n";
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Sinumerik;
    const auto plan = job::makePlan("PART.MPF", tests::jobText(6), options);
    QVERIFY2(plan.has_value(), plan ? "" : plan.error().text().c_str());
    std::vector<std::size_t> executed;
    for (const std::size_t naps : {std::size_t{0}, std::size_t{40}}) {
      World world(5, "dmu75-mill");
      const RunSettings settings = settingsOf(MethodKind::Window, 1500.0, 5);
      const auto programs = job::makePrograms(*plan, settings.parameters);
      QVERIFY2(programs.has_value(), programs ? "" : programs.error().text().c_str());
      Naps drawn(4, naps);
      tests::SleepyLink sleepy(
          world.link, [&](Instant now) { return world.person.seen ? drawn(now) : Duration{}; });
      tests::WholeTraceLink whole(sleepy);
      const auto report = streaming::runWholeJob(whole, world.link, *plan, *programs, settings,
                                                 world.person, world.person);
      QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
      QVERIFY(report.integrity.judged);
      QCOMPARE(report.integrity.repeated + report.integrity.skipped + report.integrity.foreign,
               std::size_t{0});
      executed.push_back(static_cast<std::size_t>(
          std::count_if(world.person.trace.blocks.begin(), world.person.trace.blocks.end(),
                        [](const trace::ExecutedBlock& block) { return block.lengthMm > 0.01; })));
      const Silences found = judgeSilences(world, sleepy.sleeps(), templates::kSilenceLimitS);
      qInfo("%zu silences, the axes stood in %zu; worst %.2f s", sleepy.sleeps().size(),
            found.stood, found.worstS);
      QVERIFY2(found.wrong.empty(), found.wrong.c_str());
      QVERIFY(naps == 0 || found.stood >= 15);
    }
    QCOMPARE(executed[0], executed[1]);
  }

  /// Written past every client: what is not a number is no sign of life, and an alarm where the
  /// program asks for it.
  void noNumberIsNoSignOfLife() {
    World world;
    const auto settings = settingsOf(MethodKind::Window, 400.0, 2);
    const auto flexible = templates::makeProgram(settings.parameters);
    tests::SleepyLink sleepy(world.link, [&, once = Duration(8s)](Instant now) mutable {
      if (world.person.executed < 1 || once == Duration{}) {
        return Duration{};
      }
      for (int beat = 0; beat < 40; ++beat) {
        world.machine.writeRParameter(flexible->cells.heartbeat, std::nan(""));
      }
      static_cast<void>(now);
      return std::exchange(once, Duration{});
    });
    tests::WholeTraceLink whole(sleepy);
    const auto report = streaming::runJob(whole, world.link, *lines(8, 60.0), *flexible, settings,
                                          world.person, world.person);
    QVERIFY2(report.error.code == streaming::StreamError::ControlAlarm,
             report.error.text().c_str());
    const Silences found = judgeSilences(world, sleepy.sleeps(), templates::kSilenceLimitS);
    QVERIFY2(found.wrong.empty(), found.wrong.c_str());
    QCOMPARE(found.stood, std::size_t{1});
  }

  /// A machine that does not carry out what the feed cell needs: nothing moves.
  void aControlThatMisreadsIsNotStarted_data() {
    QTest::addColumn<QString>("written");
    QTest::addColumn<QString>("read");
    QTest::newRow("the timer stands, or there are none") << "$AC_TIMER[1]=0"
                                                         << "$AC_TIMER[2]=0";
    QTest::newRow("no synchronized actions") << "ID="
                                             << "; ID=";
    QTest::newRow("the factor is not multiplied") << "DO $R11=$R10*$R"
                                                  << "DO $R11=$R10+0*$R";
  }
  void aControlThatMisreadsIsNotStarted() {
    QFETCH(QString, written);
    QFETCH(QString, read);
    World world;
    MisreadLink link(world.link, written.toStdString(), read.toStdString());
    auto settings = settingsOf(MethodKind::Window, 400.0);
    settings.parameters.factorLeast = 0.2;
    settings.parameters.factorMost = 1.2;
    const auto flexible = templates::makeProgram(settings.parameters);
    const auto report = streaming::runJob(link, link, *lines(4, 10.0), *flexible, settings,
                                          world.person, world.person);
    QVERIFY(report.error.code == streaming::StreamError::FeedCellIgnored);
    QVERIFY(world.machine.trace().samples.empty());
  }

  /// The cell is read, but the axes do not obey: the client sees that they move, and says so.
  void aControlThatDoesNotObeyIsNoticed() {
    World world;
    MisreadLink link(world.link, "$AC_OVR=$R11", "$AC_PARAM[1]=$R11");
    std::optional<Instant> since;
    world.person.orderWhen = [&](Instant now) -> FeedOrder {
      if (world.person.executed >= 1 && !since) {
        since = now;
      }
      return {since.has_value() && now < *since + 10s};
    };
    const auto settings = settingsOf(MethodKind::Window, 400.0, 2);
    const auto flexible = templates::makeProgram(settings.parameters);
    const auto report = streaming::runJob(link, link, *lines(8, 60.0), *flexible, settings,
                                          world.person, world.person);
    QVERIFY(world.person.wasIgnored);
    QVERIFY(world.person.hasNote("does not obey"));
    QVERIFY(!report.feed.empty() && !report.feed.front().stoodAfter);
  }

  /// An override of 0 that is let through for single cycles: the judge of this test finds it, and
  /// so does the client, once the axes have crept by a micrometre.
  void singleCyclesAreNoticed() {
    World world;
    MisreadLink link(world.link, "ID=5 DO $AC_OVR=$R11",
                     "ID=5 DO $AC_OVR=$R11\nID=7 DO $R99=$R99+1\n"
                     "ID=8 WHENEVER $R99>25 DO $AC_OVR=100 $R99=0");
    std::optional<Instant> since;
    const auto settings = settingsOf(MethodKind::Window, 3000.0, 2);
    const auto flexible = templates::makeProgram(settings.parameters);
    world.watch(flexible->cells.overrideWanted);
    world.person.orderWhen = [&](Instant now) -> FeedOrder {
      if (world.person.executed >= 1 && !since) {
        since = now;
        world.person.holds.push_back({now, now + 10s, {}});
      }
      return {since.has_value() && now < *since + 10s};
    };
    tests::WholeTraceLink whole(link);
    const auto report = streaming::runJob(whole, link, *lines(8, 60.0), *flexible, settings,
                                          world.person, world.person);
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    const Stopped stopped = judge(world, world.person.trace);
    QVERIFY2(
        stopped.wrong.find("while held") != std::string::npos,
        fmt::format("{} {} holds, {} samples, R99 {}", stopped.wrong, world.person.holds.size(),
                    world.person.trace.samples.size(), world.machine.ncRParameter(99))
            .c_str());
    QVERIFY(world.person.wasIgnored);
  }

  /// A program without the cell says so, and is held before its next window as before.
  void aProgramWithoutTheCellSaysSo() {
    World world;
    world.person.orderWhen = [](Instant) -> FeedOrder { return {true}; };
    const auto report = world.run(*lines(4, 10.0), settingsOf(MethodKind::Signal, 400.0, 2));
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    QVERIFY(world.person.hasNote("no feed cell"));
    QVERIFY(report.feed.empty() && !world.person.seen);
  }
};

RIVULET_TEST(TestFeedCell)
#include "tst_feed_cell.moc"
