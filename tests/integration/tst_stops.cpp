// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Stops by the feed cell over OPC UA, of a `rivulet-machine` in real time. RIVULET_STOPS=1000
/// draws as many in all, in each kind of motion. The judge has the machine's own trace; the
/// client's times are printed.

#include <fmt/format.h>

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/units.h"
#include "job/main_program.h"
#include "job/plan.h"
#include "machine/braking.h"
#include "opcua/open62541/ua_link.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/stop_bench.h"
#include "support/test_program.h"
#include "templates/flexible_program.h"
#include "trace/analysis/pauses.h"

using namespace rivulet;
using base::Duration;
using tests::Operator;

namespace {

/// What a run is stopped in.
enum class In { ShortMoves, LongMoves, Arcs, CreditArcs, Job };

struct Seen {
  std::vector<double> stoodS;   ///< from an order until the client had seen the axes stand
  std::vector<double> brakesS;  ///< from the feed of the path until the set point stands
  double offMm = 0.0;           ///< off the path while held; only of moves along X
};

/// Standstills of 100 ms and more in the middle of a block, also of the control's own: no pause of
/// a stream or a cycle is there.
std::vector<trace::Pause> standstillsInBlocks(const trace::ControlTrace& trace) {
  constexpr Duration kLong = std::chrono::milliseconds{100};
  std::vector<trace::Pause> found;
  std::size_t block = 0;
  for (std::size_t i = 0; i < trace.samples.size(); ++i) {
    if (trace.samples[i].feedMmPerS > 0.0) {
      continue;
    }
    const std::size_t begin = i;
    while (i + 1 < trace.samples.size() && trace.samples[i + 1].feedMmPerS == 0.0) {
      ++i;
    }
    const base::Instant from = trace.samples[begin].at;
    const base::Instant to = trace.samples[i].at;
    while (block < trace.blocks.size() && trace.blocks[block].to < to) {
      ++block;
    }
    const bool isWithin = block < trace.blocks.size() && trace.blocks[block].moves() &&
                          trace.blocks[block].from < from && trace.blocks[block].to > to;
    if (isWithin && to - from >= kLong) {
      trace::Pause pause;
      pause.start = from - trace.cycle;
      pause.duration = to - from;
      found.push_back(pause);
    }
  }
  return found;
}

/// By the machine's trace: where the feed is left, the axes brake and stand. @return empty: all is
/// well
QString judge(const trace::ControlTrace& trace, const std::vector<trace::Pause>& holds,
              const machine::MachineConfig& config, Seen& seen) {
  constexpr double kSteadyMmPerS = 1e-6;
  // A hold right before the end of a window, and the standstill there, are one in the trace: after
  // Continue the path creeps to the end in between.
  constexpr double kHeldMmMax = 1e-3;
  const auto& samples = trace.samples;
  for (const trace::Pause& hold : holds) {
    const auto stands = std::find_if(samples.begin(), samples.end(), [&hold](const auto& sample) {
      return sample.at > hold.start && sample.feedMmPerS == 0.0;
    });
    if (stands == samples.end()) {
      continue;
    }
    auto from = stands;
    while (from != samples.begin() &&
           std::prev(from)->feedMmPerS > from->feedMmPerS + kSteadyMmPerS) {
      --from;
    }
    if (from == stands) {
      continue;  // it stood already, between two windows or in a dwell
    }
    const Duration brakes = stands->at - from->at;
    seen.brakesS.push_back(base::toSeconds(brakes));
    const Duration most =
        machine::brakingTime(config, from->feedMmPerS) + 2 * config.interpolationCycle;
    // A hold may meet a path that is about to stop: then both are seen as one.
    if (brakes > 3 * most) {
      return QStringLiteral("braked for %1 ms").arg(base::toMilliseconds(brakes));
    }
    // The axes may still settle from the first move.
    const double beforeMm = std::hypot(from->actualMm.y, from->actualMm.z);
    for (auto held = stands; held != samples.end() && held->at <= hold.start + hold.duration;
         ++held) {
      if (base::distance(held->commandMm, stands->commandMm) > kHeldMmMax) {
        return QStringLiteral("moved by %1 mm while held, %2 ms after it stood, in a hold of %3 ms")
            .arg(base::distance(held->commandMm, stands->commandMm))
            .arg(base::toMilliseconds(held->at - stands->at))
            .arg(base::toMilliseconds(hold.duration));
      }
      const bool isOnX = std::hypot(held->commandMm.y, held->commandMm.z) < 1e-6;
      const double heldMm = std::hypot(held->actualMm.y, held->actualMm.z);
      seen.offMm = isOnX ? std::max(seen.offMm, heldMm - beforeMm) : seen.offMm;
    }
  }
  return {};
}

}  // namespace

class TestStops : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyStopStands_data() {
    QTest::addColumn<In>("in");
    QTest::addColumn<double>("feedMmPerMin");
    QTest::newRow("60 mm moves at F 400") << In::ShortMoves << 400.0;
    QTest::newRow("300 mm moves at F 4000") << In::LongMoves << 4000.0;
    QTest::newRow("arcs in chords of 1 mm at F 2000") << In::Arcs << 2000.0;
    QTest::newRow("credit, arcs at F 2000") << In::CreditArcs << 2000.0;
    QTest::newRow("whole job: rapids, arcs, cycles, stretches") << In::Job << 1500.0;
  }

  void everyStopStands() {
    QFETCH(In, in);
    QFETCH(double, feedMmPerMin);
    const QString preset = in == In::Job ? "dmu75-mill" : machine::kDefaultPreset;
    const tests::MachineProcess process(QStringLiteral(RIVULET_MACHINE_PROGRAM),
                                        {QStringLiteral("--preset"), preset});
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = process.endpoint().toStdString();
    options.connectDeadline = std::chrono::milliseconds(tests::kRunMs);
    const auto link = opcua::UaLink::connect(options);
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    const machine::MachineConfig config = *machine::loadPreset(preset.toStdString());

    Operator person(3);
    const std::size_t kinds = 5;
    person.holdsMax = std::max<std::size_t>(5, tests::stopsWanted() / kinds);
    person.meanS = 0.3;
    // The run is stopped after the last hold.
    person.stopWhen = [&person](base::Instant) {
      return person.holds.size() == person.holdsMax &&
             person.holds.back().released != base::Instant{};
    };
    streaming::RunSettings settings;
    settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
    std::vector<streaming::FeedEvent> orders;
    std::vector<trace::Pause> holds;
    std::shared_ptr<const trace::ControlTrace> trace;
    if (in == In::Job) {
      settings.parameters.pointsPerLoop = 5;
      gcode::LoadOptions reading;
      reading.dialect = gcode::Dialect::Sinumerik;
      // A round takes about 25 s: there are more than the holds need.
      const int rounds = static_cast<int>(person.holdsMax) / 4 + 2;
      const auto plan = job::makePlan("PART.MPF", tests::jobText(rounds), reading);
      QVERIFY(plan.has_value());
      const auto programs = job::makePrograms(*plan, settings.parameters);
      QVERIFY2(programs.has_value(), programs ? "" : programs.error().text().c_str());
      const streaming::WholeJobReport report =
          streaming::runWholeJob(**link, **link, *plan, *programs, settings, person, person);
      QVERIFY2(report.outcome == streaming::Outcome::Stopped, report.error.text().c_str());
      QVERIFY(report.integrity.judged);
      QCOMPARE(report.integrity.repeated + report.integrity.foreign, std::size_t{0});
      QVERIFY(report.controlTrace != nullptr);
      orders = report.feed;
      trace = report.controlTrace;
      holds = standstillsInBlocks(*trace);
    } else {
      const bool isArc = in == In::Arcs || in == In::CreditArcs;
      settings.parameters.pointsPerLoop = isArc ? 7 : 1;
      settings.parameters.method =
          in == In::CreditArcs ? base::MethodKind::Credit : base::MethodKind::Window;
      settings.isCommissioned = true;
      const auto flexible = templates::makeProgram(settings.parameters);
      QVERIFY(flexible.has_value());
      // A hold and the way to the next take two seconds at most.
      const std::size_t enough = 60 * (person.holdsMax + 10);
      const auto program =
          isArc ? tests::circles(enough) : tests::lines(enough, in == In::LongMoves ? 300.0 : 60.0);
      const streaming::RunReport report =
          streaming::runJob(**link, **link, *program, *flexible, settings, person, person);
      QVERIFY2(report.outcome == streaming::Outcome::Stopped, report.error.text().c_str());
      QVERIFY(report.finding() == streaming::RunFinding::Faultless);
      orders = report.feed;
      holds = report.holds;
      trace = report.controlTrace;
    }
    QVERIFY(!person.wasIgnored);
    Seen seen;
    for (const streaming::FeedEvent& event : orders) {
      if (event.isHold() && event.stoodAfter) {
        seen.stoodS.push_back(base::toSeconds(*event.stoodAfter));
      }
    }
    QCOMPARE(seen.stoodS.size(), person.holds.size());
    QVERIFY(trace != nullptr);
    const QString wrong = judge(*trace, holds, config, seen);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    // In a job, many holds meet a tool change, a dwell or a window that waits.
    const std::size_t least = in == In::Job ? 4 : person.holds.size() / 2;
    QVERIFY(seen.brakesS.size() + 2 >= least);
    constexpr double kOffMmMax = 0.001;
    QVERIFY2(seen.offMm <= kOffMmMax, std::to_string(seen.offMm).c_str());
    qInfo(
        "%s: %zu stops; the client saw them stand after %.0f ms (worst %.0f); braking %.0f (%.0f) "
        "of %zu in motion; at most %.3f um off a path along X while held",
        QTest::currentDataTag(), seen.stoodS.size(), 1e3 * tests::median(seen.stoodS),
        1e3 * tests::worst(seen.stoodS), 1e3 * tests::median(seen.brakesS),
        1e3 * tests::worst(seen.brakesS), seen.brakesS.size(), 1e3 * seen.offMm);
  }
};

RIVULET_TEST(TestStops)
#include "tst_stops.moc"
