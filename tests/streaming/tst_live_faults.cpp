// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Drawn live sources (rates, silence, holds, bad lines, broken ends) over drawn faults of the
/// network: no wrong motion. The judge shares no code with stream, method, driver or oracle: it has
/// the points that the source said and what the machine says it has executed. RIVULET_SCENARIOS
/// runs from the seed RIVULET_FIRST on; scripts/soak --live runs many.

#include <fmt/format.h>

#include <QtTest>
#include <cmath>

#include "base/random.h"
#include "live/error.h"
#include "live/point_stream.h"
#include "platform/thread_executor.h"
#include "streaming/run/job.h"
#include "streaming/simulation/faulty_link.h"
#include "support/setting.h"
#include "support/test_program.h"
#include "support/timed_source.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::Duration;
using base::Instant;
using base::Random;
using base::Vec3;

namespace {

/// Says a drawn script; keeps the points that may be executed.
class DrawnSource final : public tests::TimedSource {
 public:
  DrawnSource(const opcua::Link& link, Random& random) : TimedSource(link) {
    Vec3 at{0.0, 0.0, 50.0};
    Duration when{};
    double angle = 0.0;
    const auto count = static_cast<int>(10 + random.below(120));
    const Duration interval = random.below(3) == 0
                                  ? Duration{}
                                  : base::fromSeconds(0.002 * std::pow(100.0, random.uniform()));
    const int badAt = random.below(3) == 0 ? static_cast<int>(random.below(120)) : -1;
    for (int i = 0; i < count && i != badAt; ++i, when += interval) {
      angle += 0.3 * random.normal();
      at = at + (0.05 + random.uniform()) * Vec3{std::cos(angle), std::sin(angle), 0.0};
      std::string line = fmt::format("X{:.4f} Y{:.4f}", at.x, at.y);
      line += random.below(20) == 0 ? fmt::format(" F{}", 100 + random.below(2000)) : "";
      // What is said has four decimals.
      points.push_back({std::round(at.x * 1e4) / 1e4, std::round(at.y * 1e4) / 1e4, at.z});
      if (random.below(40) == 0) {
        line += "\nhold\ncomment it waits";
      }
      if (random.below(60) == 0) {
        when += base::fromSeconds(8.0 * random.uniform());
      }
      // Now and then in two pieces.
      const std::size_t cut = random.below(10) == 0 ? random.below(line.size()) : 0;
      say(when, line.substr(0, cut));
      say(when + (cut > 0 ? interval / 2 : Duration{}), line.substr(cut) + "\n");
    }
    if (badAt >= 0 && badAt < count) {
      static constexpr std::array kBad{"Xnan\n", "X250\n", "Z-7\n", "\xff\xfe\n", "X1.", ""};
      say(when, kBad[random.below(kBad.size())]);
      closeAt(when + 1ms);
    } else if (random.below(8) != 0) {
      say(when + 1ms, "end\n");
      endsWell = true;
    }
  }

  std::vector<Vec3> points;
  bool endsWell = false;
};

class Operator final : public streaming::RunSink, public streaming::RunOrders {
 public:
  void update(const streaming::LiveUpdate& update) override { saysWrong |= bool(update.wrong); }
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(Instant now) override { return now >= stopAt; }
  Instant stopAt = Instant::max();
  bool saysWrong = false;
};

struct Outcome {
  std::size_t points = 0;
  bool isCompleted = false;
  std::string wrong;  ///< empty: nothing
};

streaming::LinkFaults drawFaults(Random& random) {
  streaming::LinkFaults faults;
  if (random.below(4) == 0) {
    return faults;
  }
  faults.delayProbability = 0.2 * random.uniform();
  faults.delayMax = 400ms;
  faults.lostRequestProbability = 0.02 * random.uniform();
  faults.lostAnswerProbability = 0.02 * random.uniform();
  faults.stallProbability = 0.01 * random.uniform();
  faults.stallMax = 3s;
  faults.disconnectProbability = random.below(3) == 0 ? 0.002 * random.uniform() : 0.0;
  faults.strayMax = random.below(2) == 0 ? 2s : 0s;
  return faults;
}

/// Each block that moves must end at the point that is due.
Outcome judge(const std::vector<Vec3>& pointsMm, const trace::ControlTrace& trace,
              const streaming::RunReport& report, bool endsWell, bool isStopped) {
  Outcome outcome;
  for (const trace::ExecutedBlock& block : trace.blocks) {
    const bool isDue = outcome.points < pointsMm.size() &&
                       base::distance(pointsMm[outcome.points], block.targetMm) < 1e-6;
    if (isDue) {
      ++outcome.points;
    } else if (block.lengthMm > 1e-9) {
      outcome.wrong = fmt::format("point {} was due, the axes went to {} {} {}", outcome.points,
                                  block.targetMm.x, block.targetMm.y, block.targetMm.z);
      return outcome;
    }
  }
  outcome.isCompleted = report.outcome == streaming::Outcome::Completed;
  const bool isWhole = outcome.points == pointsMm.size();
  if (outcome.isCompleted && !(isWhole && endsWell)) {
    outcome.wrong = fmt::format("completed after {} of {}", outcome.points, pointsMm.size());
  } else if (report.integrity.judged && report.counters.executed != outcome.points) {
    outcome.wrong =
        fmt::format("{} executed, {} reported", outcome.points, report.counters.executed);
  } else if (report.error.code.category() ==
                 live::make_error_code(live::LiveError::NoPoint).category() &&
             !isWhole && !isStopped) {
    outcome.wrong = fmt::format("a good point was left out: {}", report.error.text());
  }
  return outcome;
}

Outcome runOnce(std::uint64_t seed) {
  Random random(seed);
  machine::MachineConfig config =
      *machine::loadPreset(random.below(2) == 0 ? "dmu75-arrays" : "dmu75");
  machine::Machine machine(config, seed);
  streaming::FaultyLink link(machine, drawFaults(random), random.bits());
  streaming::RunSettings settings;
  settings.parameters.method =
      random.below(2) == 0 ? base::MethodKind::Window : base::MethodKind::Credit;
  settings.parameters.pointsPerLoop = static_cast<int>(1 + random.below(10));
  settings.parameters.windows = static_cast<int>(1 + random.below(2));
  settings.parameters.feedPerPoint = random.below(3) == 0;
  settings.isCommissioned = true;
  settings.feedMmPerS = 5.0 + 30.0 * random.uniform();
  live::Agreement agreed;
  agreed.lowestMm = {-200.0, -200.0, 0.0};
  agreed.highestMm = {200.0, 200.0, 100.0};
  agreed.feedMmPerMinMax = 3000.0;
  agreed.startMmMax = 2.0;
  live::Limits limits;
  limits.queuedMax = random.below(50);
  limits.fullWithin = base::fromSeconds(0.3 * random.uniform());
  limits.holdAfter = 2s;
  limits.endAfter = 15s;
  DrawnSource source(link, random);
  live::PointStream stream(source, agreed, limits);
  Operator orders;
  const bool isStopped = random.below(6) == 0;
  orders.stopAt = link.now() + (isStopped ? base::fromSeconds(2.0 + 8.0 * random.uniform()) : 1h);
  const streaming::RunReport report =
      streaming::runLive(link, link, "drawn", stream, *templates::makeProgram(settings.parameters),
                         settings, orders, orders);
  // Nobody is there any more: what was delivered may still be executed.
  if (!link.isConnected()) {
    link.wait(link.now() + 60s);
  }
  machine.advance(machine.now() + 60s);
  Outcome outcome = judge(source.points, machine.trace(), report, source.endsWell, isStopped);
  if (outcome.wrong.empty() && orders.saysWrong) {
    outcome.wrong = "wrong motion was reported, but there was none";
  }
  return outcome;
}

}  // namespace

class TestLiveFaults : public QObject {
  Q_OBJECT

 private slots:
  void noWrongMotion() {
    const auto first = static_cast<std::uint64_t>(tests::setting("RIVULET_FIRST", 1));
    const auto count = static_cast<std::size_t>(tests::setting("RIVULET_SCENARIOS", 300));
    std::vector<Outcome> outcomes(count);
    parallel::ThreadExecutor(0).forEach(count,
                                        [&](std::size_t i) { outcomes[i] = runOnce(first + i); });
    std::size_t points = 0;
    std::size_t completed = 0;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < count; ++i) {
      points += outcomes[i].points;
      completed += outcomes[i].isCompleted ? 1 : 0;
      if (!outcomes[i].wrong.empty()) {
        ++wrong;
        qWarning("seed %llu: %s", static_cast<unsigned long long>(first + i),
                 outcomes[i].wrong.c_str());
      }
    }
    qInfo("%zu runs, %zu completed, %zu points executed, %zu wrong", count, completed, points,
          wrong);
    QCOMPARE(wrong, 0U);
    QVERIFY(completed > count / 4);
  }
};

RIVULET_TEST(TestLiveFaults)
#include "tst_live_faults.moc"
