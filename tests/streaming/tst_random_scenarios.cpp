// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Runs drawn from seeds, and what an independent witness makes of the control's trace. The
/// oracle works from the list of executed blocks in one pass; the witness looks up every target by
/// brute force, and follows the set point, which knows nothing of blocks.
/// RIVULET_SEED=n replays one run, RIVULET_SCENARIOS=n runs so many.

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "machine/machine.h"
#include "platform/thread_executor.h"
#include "random_scenario.h"
#include "support/test_program.h"

using namespace rivulet;
using base::Vec3;
using streaming::Outcome;
using streaming::RunReport;

namespace {

constexpr double kToleranceMm = 1e-6;
constexpr double kMovedMm = 1e-9;

/// The definition of the oracle's counts where no two points of the program coincide, the plain
/// way: which point does each moving block end at?
struct Witness {
  bool distinct = true;  ///< no two points of the program at one place
  std::size_t executed = 0;
  std::size_t repeated = 0;
  std::size_t skipped = 0;
  std::size_t foreign = 0;
  bool inOrder = true;
};

Witness witness(const std::vector<gcode::StreamPoint>& points,
                const std::vector<trace::ExecutedBlock>& blocks) {
  Witness seen;
  for (std::size_t i = 0; i < points.size() && seen.distinct; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      seen.distinct =
          seen.distinct && base::distance(points[i].positionMm, points[j].positionMm) > 1e-3;
    }
  }
  std::vector<std::size_t> times(points.size(), 0);
  std::size_t last = 0;
  for (const trace::ExecutedBlock& block : blocks) {
    std::size_t found = points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (base::distance(points[i].positionMm, block.targetMm) <= kToleranceMm) {
        found = i;
        break;
      }
    }
    // A block that moves nothing counts only where the point due lies where the axes stand.
    const bool moves = block.lengthMm > kMovedMm;
    if (found == points.size()) {
      seen.foreign += moves ? 1 : 0;
      continue;
    }
    if (!moves && times[found] > 0) {
      continue;
    }
    if (times[found]++ == 0) {
      seen.inOrder = seen.inOrder && found >= last;
      last = std::max(last, found);
    }
  }
  const auto highest = std::find_if(times.rbegin(), times.rend(), [](auto n) { return n > 0; });
  const auto reached = static_cast<std::size_t>(times.rend() - highest);
  for (std::size_t i = 0; i < points.size(); ++i) {
    seen.executed += times[i] > 0 ? 1 : 0;
    seen.repeated += times[i] > 1 ? times[i] - 1 : 0;
    seen.skipped += times[i] == 0 && i < reached ? 1 : 0;
  }
  return seen;
}

double segmentDistance(Vec3 point, Vec3 from, Vec3 to) {
  const Vec3 way = to - from;
  const double square = base::dot(way, way);
  const double share =
      square > 0.0 ? std::clamp(base::dot(point - from, way) / square, 0.0, 1.0) : 0.0;
  return base::distance(point, from + share * way);
}

/// Follows the set point along the programmed polyline, never back: each sample must lie on the
/// piece it was on, or on one after it.
/// @return the first distance beyond the tolerance, or 0
double deviationFromProgram(const std::vector<trace::ControlSample>& samples, Vec3 startMm,
                            const std::vector<gcode::StreamPoint>& points, std::size_t executed,
                            double toleranceMm) {
  std::vector<Vec3> corners{startMm};
  for (std::size_t i = 0; i < executed; ++i) {
    corners.push_back(points[i].positionMm);
  }
  corners.push_back(corners.back());
  std::size_t segment = 0;
  for (const trace::ControlSample& sample : samples) {
    const auto distanceTo = [&](std::size_t i) {
      return segmentDistance(sample.commandMm, corners[i], corners[i + 1]);
    };
    std::size_t on = segment;
    while (on + 1 < corners.size() && distanceTo(on) > toleranceMm) {
      ++on;
    }
    if (on + 1 == corners.size()) {
      return distanceTo(segment);
    }
    segment = on;
  }
  return 0.0;
}

struct Tally {
  std::size_t faultless = 0;
  std::size_t repeated = 0;
  std::size_t skipped = 0;
  std::size_t stopped = 0;
  std::size_t failed = 0;
  std::size_t judgedByWitness = 0;
};

/// @return what the oracle and the witness do not agree on; empty: nothing
QString examine(std::uint64_t seed, Tally& tally) {
  const streaming::RandomScenario drawn =
      streaming::drawScenario(seed, *machine::loadPreset("dmu75"));
  const RunReport report = streaming::simulate(drawn.scenario);
  if (!report.controlTrace) {
    // Refused or stopped before anything moved.
    const bool stoppedBefore = report.outcome == Outcome::Stopped && report.counters.executed == 0;
    return report.error.code || stoppedBefore ? QString() : QStringLiteral("no trace");
  }
  const auto& trace = *report.controlTrace;
  const trace::Integrity& oracle = report.integrity;
  const Vec3 startMm{drawn.scenario.machine.axes[0].startMm, drawn.scenario.machine.axes[1].startMm,
                     drawn.scenario.machine.axes[2].startMm};
  const auto points = gcode::streamPoints(drawn.scenario.program->trajectory, startMm).points;
  const Witness seen = witness(points, trace.blocks);

  tally.faultless += oracle.isFaultless() ? 1 : 0;
  tally.repeated += oracle.repeated > 0 ? 1 : 0;
  tally.skipped += oracle.skipped > 0 ? 1 : 0;
  tally.stopped += report.outcome == Outcome::Stopped ? 1 : 0;
  tally.failed += report.outcome == Outcome::Failed ? 1 : 0;
  tally.judgedByWitness += seen.distinct ? 1 : 0;

  if (!oracle.judged) {
    return QStringLiteral("not judged");
  }
  if (seen.distinct) {
    if (oracle.executed != seen.executed || oracle.repeated != seen.repeated ||
        oracle.skipped != seen.skipped || oracle.foreign != seen.foreign ||
        (oracle.outOfOrder == 0) != seen.inOrder) {
      return QStringLiteral(
                 "oracle %1 %2 %3 %4 %5, witness %6 %7 %8 %9 %10 "
                 "(executed, repeated, skipped, foreign, order)")
          .arg(oracle.executed)
          .arg(oracle.repeated)
          .arg(oracle.skipped)
          .arg(oracle.foreign)
          .arg(oracle.outOfOrder)
          .arg(seen.executed)
          .arg(seen.repeated)
          .arg(seen.skipped)
          .arg(seen.foreign)
          .arg(seen.inOrder);
    }
  }
  if (report.counters.executed != oracle.executed) {
    return QStringLiteral("counted %1, judged %2")
        .arg(report.counters.executed)
        .arg(oracle.executed);
  }
  if (report.outcome == Outcome::Completed && oracle.executed < points.size()) {
    return QStringLiteral("completed without all points");
  }
  // A run that was given up may have been in the middle of a block that no list tells of.
  if (oracle.isFaultless() && report.outcome != Outcome::Failed) {
    const double deviation = deviationFromProgram(trace.samples, startMm, points, oracle.executed,
                                                  drawn.scenario.machine.roundingMm + kToleranceMm);
    if (deviation > 0.0) {
      return QStringLiteral("faultless, but the set point left the program by %1 mm")
          .arg(deviation);
    }
  }
  return {};
}

std::size_t numberFrom(const char* name, std::size_t otherwise) {
  bool isNumber = false;
  const qulonglong value = qEnvironmentVariable(name).toULongLong(&isNumber);
  return isNumber ? value : otherwise;
}

}  // namespace

class TestRandomScenarios : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void oracleAndMachineAgree() {
    std::vector<std::uint64_t> seeds;
    if (qEnvironmentVariableIsSet("RIVULET_SEED")) {
      seeds.push_back(numberFrom("RIVULET_SEED", 1));
    } else {
      const std::size_t count = numberFrom("RIVULET_SCENARIOS", 400);
      for (std::uint64_t seed = 1; seed <= count; ++seed) {
        seeds.push_back(seed);
      }
      seeds.push_back(std::random_device{}());  // one that nobody has tried
      qInfo("fresh seed: RIVULET_SEED=%llu", static_cast<unsigned long long>(seeds.back()));
    }
    std::vector<QString> findings(seeds.size());
    std::vector<Tally> tallies(seeds.size());
    parallel::ThreadExecutor executor;
    executor.forEach(seeds.size(),
                     [&](std::size_t i) { findings[i] = examine(seeds[i], tallies[i]); });
    Tally sum;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      sum.faultless += tallies[i].faultless;
      sum.repeated += tallies[i].repeated;
      sum.skipped += tallies[i].skipped;
      sum.stopped += tallies[i].stopped;
      sum.failed += tallies[i].failed;
      sum.judgedByWitness += tallies[i].judgedByWitness;
    }
    qInfo(
        "%zu runs: %zu faultless, %zu with repetitions, %zu with skips, %zu stopped, %zu failed; "
        "%zu counted by the witness",
        seeds.size(), sum.faultless, sum.repeated, sum.skipped, sum.stopped, sum.failed,
        sum.judgedByWitness);
    QStringList disagreements;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      if (!findings[i].isEmpty()) {
        disagreements << QStringLiteral("RIVULET_SEED=%1: %2").arg(seeds[i]).arg(findings[i]);
      }
    }
    QVERIFY2(disagreements.isEmpty(),
             qPrintable(QStringLiteral("%1 of %2\n").arg(disagreements.size()).arg(seeds.size()) +
                        disagreements.mid(0, 20).join(u'\n')));
    if (seeds.size() > 100) {
      // The scenarios must be worth something.
      QVERIFY(sum.faultless > seeds.size() / 10);
      QVERIFY(sum.repeated > seeds.size() / 20);
      QVERIFY(sum.skipped > 0 && sum.stopped > 0 && sum.judgedByWitness > seeds.size() / 3);
    }
  }
};

RIVULET_TEST(TestRandomScenarios)
#include "tst_random_scenarios.moc"
