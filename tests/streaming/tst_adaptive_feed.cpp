// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Factors of the override by a source beside the operator, in virtual time: what the axes do, who
// wins, and a closed loop on a simulated force. The judge has the machine's own trace and the
// instants at which the cells were written there.

#include <fmt/format.h>

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "base/random.h"
#include "base/units.h"
#include "live/feed_factor.h"
#include "machine/braking.h"
#include "machine/machine.h"
#include "streaming/run/job.h"
#include "streaming/simulation/scenario.h"
#include "streaming/simulation/simulated_link.h"
#include "support/stop_bench.h"
#include "support/test_program.h"
#include "support/timed_source.h"
#include "support/whole_trace_link.h"
#include "templates/flexible_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::Duration;
using base::Instant;
using base::MethodKind;
using live::FactorAgreement;
using live::FactorState;
using streaming::FeedOrder;
using streaming::Outcome;
using streaming::RunSettings;
using tests::lines;

namespace {

constexpr FactorAgreement kAgreed{0.2, 1.2, 1s, true};

struct World {
  explicit World(const FactorAgreement& agreement = kAgreed)
      : config(configOf()),
        machine(config, 1),
        link(machine),
        script(link),
        factor("script", agreement),
        person(1) {
    settings.parameters.pointsPerLoop = 3;
    settings.parameters.factorLeast = agreement.least;
    settings.parameters.factorMost = agreement.most;
    settings.isCommissioned = true;
    settings.feedMmPerS = base::mmPerSFromMmPerMin(1000.0);
    person.machine = &machine;
  }
  static machine::MachineConfig configOf() {
    machine::MachineConfig config = *machine::loadPreset("dmu75");
    config.traceLimit = 12h;
    return config;
  }

  /// @param order  of the operator, by the time since the run began to read the source
  streaming::RunReport run(const gcode::Program& program,
                           const std::function<FeedOrder(Duration)>& order = {}) {
    const auto flexible = templates::makeProgram(settings.parameters);
    cells = flexible->cells;
    link.onWrite = [this](base::RequestId, int cell, double value) {
      if (cell == cells.factor) {
        written.emplace_back(machine.now(), value);
      } else if (cell == cells.overrideWanted) {
        overrides.push_back(value);
      }
    };
    person.orderWhen = [this, order](Instant now) {
      began = began.value_or(now);
      FeedOrder wanted = order ? order(now - *began) : FeedOrder{};
      reader.turn(now);
      wanted.source = factor.seen(now);
      return wanted;
    };
    tests::WholeTraceLink whole(link);
    return streaming::runJob(whole, link, program, *flexible, settings, person, person);
  }
  /// The same factor every 0.2 s.
  void sayFor(Duration from, Duration to, double value) {
    for (Duration at = from; at < to; at += 200ms) {
      script.say(at, fmt::format("feed {}\n", value));
    }
  }
  /// Fastest and slowest set point between these times, in mm/min.
  [[nodiscard]] std::pair<double, double> feeds(Duration from, Duration to) const {
    double least = 1e9;
    double most = 0.0;
    for (const trace::ControlSample& sample : person.trace.samples) {
      if (sample.at >= *began + from && sample.at <= *began + to) {
        least = std::min(least, base::mmPerMinFromMmPerS(sample.feedMmPerS));
        most = std::max(most, base::mmPerMinFromMmPerS(sample.feedMmPerS));
      }
    }
    return {least, most};
  }

  machine::MachineConfig config;
  machine::Machine machine;
  streaming::SimulatedLink link;
  tests::TimedSource script;
  live::FeedFactor factor;
  live::FactorReader reader{script, factor};
  tests::Operator person;
  RunSettings settings;
  templates::CellMap cells;
  std::optional<Instant> began;
  std::vector<std::pair<Instant, double>> written;  ///< factors, at the machine
  std::vector<double> overrides;
};

bool isRight(const streaming::RunReport& report) {
  return report.isFaultless() && report.outcome == Outcome::Completed;
}

/// A tool enters material that is twice as deep from a place on. What is engaged grows over the
/// radius of the tool, and the force is in proportion to depth and feed. The source knows force and
/// feed, as a sensor at the spindle does, and sends the factor at which the force would be right.
class ForceLoop final : public live::Source {
 public:
  static constexpr double kWantedN = 200.0;
  static constexpr double kNewtonPerMmAndMmPerS = 30.0;
  static constexpr double kRadiusMm = 10.0;
  static constexpr Duration kEvery = 20ms;

  ForceLoop(const machine::Machine& machine, double stepAtMm)
      : m_machine(machine), m_stepAtMm(stepAtMm) {}
  [[nodiscard]] double depthMm(double xMm) const {
    return 1.0 + std::clamp((xMm - m_stepAtMm) / kRadiusMm, 0.0, 1.0);
  }
  [[nodiscard]] double forceN(double xMm, double feedMmPerS) const {
    return kNewtonPerMmAndMmPerS * depthMm(xMm) * feedMmPerS;
  }

  std::string name() const override { return "force"; }
  std::size_t read(std::span<char> into) override {
    if (m_machine.now() < m_next) {
      return 0;
    }
    m_next = m_machine.now() + kEvery;
    const machine::MachineState state = m_machine.state();
    const double forceNow = forceN(state.commandMm.x, state.feedMmPerS);
    const double perFeed = state.feedMmPerS > 0.0 ? forceNow / state.feedMmPerS : 0.0;
    const double factor = perFeed > 0.0 ? kWantedN / (perFeed * programmedMmPerS) : 1.0;
    const std::string line = fmt::format("feed {}\n", std::clamp(factor, 0.2, 1.2));
    std::copy(line.begin(), line.end(), into.begin());
    return line.size();
  }
  bool isClosed() const override { return false; }

  double programmedMmPerS = kWantedN / kNewtonPerMmAndMmPerS;

 private:
  const machine::Machine& m_machine;
  double m_stepAtMm;
  Instant m_next{};
};

}  // namespace

class TestAdaptiveFeed : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theFactorScalesTheFeed_data() {
    QTest::addColumn<int>("method");
    QTest::newRow("window") << static_cast<int>(MethodKind::Window);
    QTest::newRow("credit") << static_cast<int>(MethodKind::Credit);
  }

  /// Each point once, whatever the factor; it multiplies the operator's override.
  void theFactorScalesTheFeed() {
    QFETCH(int, method);
    World world;
    world.settings.parameters.method = static_cast<MethodKind>(method);
    world.sayFor(100ms, 5s, 1.0);
    world.sayFor(5s, 10s, 0.3);
    world.sayFor(10s, 60s, 1.2);
    const auto report = world.run(*lines(4, 200.0), [](Duration at) {
      return FeedOrder{false, at > 8s && at < 10s ? 50.0 : 100.0};
    });
    QVERIFY2(isRight(report), report.error.text().c_str());
    QCOMPARE(std::lround(world.feeds(3s, 4900ms).first), 1000L);
    QCOMPARE(std::lround(world.feeds(6s, 7900ms).second), 300L);
    QCOMPARE(std::lround(world.feeds(9s, 9900ms).second), 150L);
    QCOMPARE(std::lround(world.feeds(11s, 12s).second), 1200L);
    QVERIFY(report.factor && report.factor->written == 4);  // the hold before the first one, too
    QCOMPARE(report.factor->least, 0.3);
    QCOMPARE(report.factor->most, 1.2);
    QVERIFY(world.person.seen && world.person.seen->source->state == FactorState::Follows);
    QVERIFY(world.person.hasNote("feed source: factor 0.3"));
  }

  /// The product is no higher than anybody may set by hand.
  void theProductIsLimited() {
    World world;
    world.sayFor(100ms, 60s, 1.2);
    const auto report = world.run(*lines(3, 200.0), [](Duration) {
      return FeedOrder{false, 120.0};
    });
    QVERIFY2(isRight(report), report.error.text().c_str());
    QCOMPARE(std::lround(world.feeds(0s, 60s).second), 1200L);
    QVERIFY(!world.person.wasIgnored && !world.person.hasNote("does not obey"));
  }

  /// Nothing moves before the first factor; a source that is silent holds, and lets go.
  void silenceHolds() {
    World world;
    world.sayFor(3s, 6s, 1.0);
    world.sayFor(12s, 60s, 0.8);
    const auto report = world.run(*lines(3, 200.0));
    QVERIFY2(isRight(report), report.error.text().c_str());
    QCOMPARE(world.feeds(0s, 3s).second, 0.0);
    QCOMPARE(std::lround(world.feeds(5s, 6s).first), 1000L);
    const Duration brakes = machine::brakingTime(world.config, world.settings.feedMmPerS);
    const Duration stands = 6s + kAgreed.silence + 2 * world.person.longest + brakes + 12ms;
    QCOMPARE(world.feeds(stands, 12s).second, 0.0);
    QCOMPARE(std::lround(world.feeds(13s, 14s).second), 800L);
    QVERIFY(world.person.hasNote("No factor for 1 s: the axes are held."));
    // In the record: held twice by the source, and no pause of the stream.
    const auto holds = std::count_if(
        report.feed.begin(), report.feed.end(),
        [](const streaming::FeedEvent& event) { return event.isHold() && event.isSource; });
    QCOMPARE(holds, std::ptrdiff_t{2});
    QVERIFY(std::all_of(report.feed.begin(), report.feed.end(), [](const auto& event) {
      return !event.isHold() || event.stoodAfter.has_value();
    }));
    QVERIFY(std::none_of(report.pauses.begin(), report.pauses.end(),
                         [](const trace::Pause& pause) { return pause.duration > 1s; }));
  }

  void silenceGoesOn() {
    World world({0.2, 1.2, 1s, false});
    world.sayFor(2s, 6s, 0.3);
    const auto report = world.run(*lines(3, 200.0));
    QVERIFY2(isRight(report), report.error.text().c_str());
    QCOMPARE(std::lround(world.feeds(4s, 6s).second), 300L);
    QCOMPARE(std::lround(world.feeds(8s, 9s).second), 1000L);
    QVERIFY(std::none_of(report.feed.begin(), report.feed.end(),
                         [](const auto& event) { return event.isHold(); }));
  }

  /// What was not agreed never comes to the cell.
  void badInputHolds() {
    for (const char* const bad : {"feed nan", "feed -1", "feed 250", "feed 1e308", "rubbish"}) {
      World world;
      world.sayFor(100ms, 4s, 0.9);
      world.script.say(4s, std::string(bad) + "\n");
      world.sayFor(6s, 60s, 0.9);
      const auto report = world.run(*lines(3, 200.0));
      QVERIFY2(isRight(report), report.error.text().c_str());
      QCOMPARE(world.feeds(4500ms, 6s).second, 0.0);
      QCOMPARE(std::lround(world.feeds(7s, 8s).second), 900L);
      for (const auto& [at, value] : world.written) {
        QVERIFY(value == 0.0 || value == 0.2 || value == 0.9 || value == 1.0);
      }
      QVERIFY(world.person.hasNote("was not agreed") || world.person.hasNote("is no factor"));
    }
  }

  /// Written past every client: the program itself holds the axes, and the client writes its own.
  void whatIsNoFactorInTheCellHolds() {
    for (const double value : {250.0, 1.2001, 0.1999, -1.0, 1e308}) {
      World world;
      world.sayFor(100ms, 60s, 0.9);
      bool isDone = false;
      double feedThen = -1.0;
      const auto report = world.run(*lines(3, 200.0), [&](Duration at) {
        if (at > 5s && !std::exchange(isDone, true)) {
          world.machine.writeRParameter(world.cells.factor, value);
        }
        if (at > 5300ms && feedThen < 0.0) {
          feedThen = world.machine.state().feedMmPerS;
        }
        return FeedOrder{};
      });
      QVERIFY2(isRight(report), report.error.text().c_str());
      QCOMPARE(feedThen, 0.0);
      QVERIFY(world.person.hasNote("another client has written the factor"));
      QCOMPARE(std::lround(world.feeds(10s, 11s).second), 900L);
    }
  }

  /// While the operator holds, no factor moves the axes; and none undoes the hold of another
  /// client, who does not know of the source.
  void holdWins() {
    World world;
    base::Random random(4);
    for (Duration at = 100ms; at < 80s; at += 15ms) {
      world.script.say(at, fmt::format("feed {:.4f}\n", 0.2 + random.uniform()));
    }
    bool isDone = false;
    const auto report = world.run(*lines(3, 200.0), [&](Duration at) {
      if (at > 12s && !std::exchange(isDone, true)) {
        world.machine.writeRParameter(world.cells.overrideWanted, 0.0);
      }
      // Another order than before takes it back.
      return FeedOrder{at > 5s && at < 9s, at < 25s ? 100.0 : 99.0};
    });
    QVERIFY2(isRight(report), report.error.text().c_str());
    QVERIFY(world.feeds(3s, 5s).second > 0.0);
    QCOMPARE(world.feeds(5500ms, 9s).second, 0.0);
    QVERIFY(world.feeds(9500ms, 12s).second > 0.0);
    QCOMPARE(world.feeds(12500ms, 25s).second, 0.0);
    QVERIFY(world.person.hasNote("another client has set the override to 0 %"));
    QVERIFY(world.feeds(26s, 27s).second > 0.0);
    // Whoever lets the axes go while the operator holds finds no factor that holds.
    const auto held = std::find_if(world.written.begin(), world.written.end(), [&](const auto& w) {
      return w.first > *world.began + 5s && w.first < *world.began + 6s && w.second == 1.0;
    });
    QVERIFY(held != world.written.end());
  }

  /// From reading a value to the cycle in which it acts, at 4.3 ms a variable with lists.
  void valuesActSoon_data() { theFactorScalesTheFeed_data(); }
  void valuesActSoon() {
    QFETCH(int, method);
    World world({0.2, 1.2, 1s, false});
    world.settings.parameters.method = static_cast<MethodKind>(method);
    world.settings.parameters.pointsPerLoop = 7;
    base::Random random(9);
    std::vector<std::pair<Duration, double>> said;
    for (Duration at = 100ms; said.size() < 400;
         at += base::fromSeconds(0.05 + 0.1 * random.uniform())) {
      said.emplace_back(at, 0.5 + 0.001 * static_cast<double>(said.size()));
      world.script.say(at, fmt::format("feed {:.4f}\n", said.back().second));
    }
    const auto report = world.run(*lines(200, 4.0));
    QVERIFY2(report.outcome == Outcome::Completed || report.outcome == Outcome::Stopped,
             report.error.text().c_str());
    std::vector<double> delays;
    auto next = world.written.begin();
    for (const auto& [at, value] : said) {
      const auto there = std::find_if(next, world.written.end(), [v = value](const auto& w) {
        return std::abs(w.second - v) < 1e-9;
      });
      if (there != world.written.end()) {
        next = there;
        const Duration cycle = world.config.interpolationCycle;
        const Instant inForce{(there->first.time_since_epoch() / cycle + 1) * cycle};
        const Duration acts = inForce - *world.began - at;
        delays.push_back(1e3 * base::toSeconds(acts));
      }
    }
    qInfo("%zu values: median %.1f ms, worst %.1f; by the client's report %.1f and %.1f",
          delays.size(), tests::median(delays), tests::worst(delays),
          base::toMilliseconds(report.factor->delay.p50),
          base::toMilliseconds(report.factor->delay.max));
    QVERIFY(delays.size() > 200);
    // Half of what is in progress on the link, the access and half a cycle; a client that waited
    // for its turn among the reads for the display would need more.
    constexpr double kMedianMs = 16.0;
    QVERIFY2(tests::median(delays) <= kMedianMs, fmt::format("{}", tests::median(delays)).c_str());
  }

  /// By override alone, within 10 %, while the depth doubles. Without the source it would be 100 %.
  void aClosedLoopHoldsTheForce() {
    for (const bool isClosed : {true, false}) {
      World world({0.2, 1.2, 1s, false});
      world.settings.parameters.method = MethodKind::Credit;
      ForceLoop loop(world.machine, 60.0);
      live::FactorReader reader(loop, world.factor);
      world.settings.feedMmPerS = loop.programmedMmPerS;
      const auto report = world.run(*lines(1, 120.0), [&](Duration at) {
        if (isClosed) {
          reader.turn(*world.began + at);
        }
        return FeedOrder{};
      });
      QVERIFY2(isRight(report), report.error.text().c_str());
      double worst = 0.0;
      for (const trace::ControlSample& sample : world.person.trace.samples) {
        if (sample.commandMm.x > 10.0 && sample.commandMm.x < 110.0) {
          const double force = loop.forceN(sample.commandMm.x, sample.feedMmPerS);
          worst = std::max(worst, std::abs(force / ForceLoop::kWantedN - 1.0));
        }
      }
      qInfo("%s: the force deviates by %.1f %%", isClosed ? "closed loop" : "without it",
            100.0 * worst);
      QCOMPARE(worst <= 0.1, isClosed);
    }
  }
};

RIVULET_TEST(TestAdaptiveFeed)
#include "tst_adaptive_feed.moc"
