// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The analysis of a recording, of the control's trace alone with the program, and of its positions
/// alone say the same as the report of the run, for runs drawn from seeds.
/// RIVULET_SCENARIOS=n draws so many.

#include <QtTest>
#include <algorithm>
#include <array>
#include <map>

#include "machine/machine.h"
#include "random_scenario.h"
#include "streaming/run/job.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"
#include "trace/analysis/trace_analysis.h"

using namespace rivulet;
using streaming::RunReport;

namespace {

/// Narrower than most steps of the contour: points that are nearer cannot be told apart.
double toleranceFor(const std::vector<base::Vec3>& pointsMm) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < pointsMm.size(); ++i) {
    steps.push_back(base::distance(pointsMm[i - 1], pointsMm[i]));
  }
  if (steps.empty()) {
    return 0.02;
  }
  std::sort(steps.begin(), steps.end());
  return std::clamp(0.25 * steps[steps.size() / 2], 0.0005, 0.02);
}

class Watcher final : public streaming::RunSink, public streaming::RunOrders {
 public:
  explicit Watcher(base::Duration limit) : m_limit(limit) {}
  void update(const streaming::LiveUpdate&) override {}
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(base::Instant now) override {
    m_first = m_first ? m_first : std::optional(now);
    return now - *m_first >= m_limit;
  }

 private:
  base::Duration m_limit;
  std::optional<base::Instant> m_first;
};

struct RecordedRun {
  RunReport report;
  std::string recording;
};

RecordedRun record(const streaming::Scenario& scenario) {
  machine::Machine machine(scenario.machine, scenario.seed);
  streaming::SimulatedLink link(machine);
  Watcher watcher(scenario.limit);
  RecordedRun run;
  trace::RecordingWriter writer([&run](std::string_view lines) {
    run.recording += lines;
    return true;
  });
  streaming::JobRecorder recorder;
  recorder.writer = &writer;
  run.report = streaming::runJob(link, link, *scenario.program, scenario.settings, watcher, watcher,
                                 recorder);
  return run;
}

/// Two runs of five have one of the methods with windows instead of one of [P1].
void chooseMethod(streaming::RunSettings& settings, std::uint64_t seed) {
  using base::MethodKind;
  static constexpr std::array<MethodKind, 3> kWithWindows{MethodKind::Window, MethodKind::Credit,
                                                          MethodKind::File};
  if (seed % 5 < 2) {
    settings.parameters.method = kWithWindows[seed / 5 % kWithWindows.size()];
    settings.isCommissioned = true;
  }
}

QString printed(const trace::Integrity& integrity) {
  return QStringLiteral("judged %1 executed %2 repeated %3 skipped %4 foreign %5 order %6")
      .arg(integrity.judged)
      .arg(integrity.executed)
      .arg(integrity.repeated)
      .arg(integrity.skipped)
      .arg(integrity.foreign)
      .arg(integrity.outOfOrder);
}

QString printed(const trace::PathMatch& path) {
  return QStringLiteral("executed %1 undecided %2 repeated %3 skipped %4 foreign %5%6")
      .arg(path.executed)
      .arg(path.undecided)
      .arg(path.repeated)
      .arg(path.skipped)
      .arg(path.foreign)
      .arg(path.departure ? QStringLiteral(" departs") : QString());
}

struct Tally {
  std::size_t runs = 0;
  std::size_t faultless = 0;
  std::size_t faulty = 0;
  std::size_t cleanByPositions = 0;
  std::size_t faultyByPositions = 0;
  std::map<std::string, std::size_t> methods;
  /// Stops by their cause; those of recordings that do not know the program on the control, too.
  std::map<std::string, std::size_t> causes;
  std::map<std::string, std::size_t> causesWithoutProgram;
};

std::string printed(const std::map<std::string, std::size_t>& counts) {
  std::string text;
  for (const auto& [name, count] : counts) {
    text += (text.empty() ? "" : ", ") + name + " " + std::to_string(count);
  }
  return text;
}

void countCauses(const std::vector<trace::Standstill>& stops,
                 std::map<std::string, std::size_t>& causes) {
  for (const trace::Standstill& stop : stops) {
    ++causes[std::string(trace::stopCauseName(stop.cause))];
  }
}

}  // namespace

class TestTraceAgreement : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void analysesAgreeWithTheReport() {
    bool isNumber = false;
    const auto asked = qEnvironmentVariable("RIVULET_SCENARIOS").toULongLong(&isNumber);
    const std::uint64_t count = isNumber ? asked : 200;
    Tally tally;
    QStringList disagreements;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
      streaming::RandomScenario drawn =
          streaming::drawScenario(seed, *machine::loadPreset("dmu75"));
      chooseMethod(drawn.scenario.settings, seed);
      const RecordedRun run = record(drawn.scenario);
      if (!run.report.controlTrace) {
        continue;  // refused, or stopped before anything moved
      }
      ++tally.runs;
      ++tally.methods[std::string(base::methodName(drawn.scenario.settings.parameters.method))];
      const QString expected = printed(run.report.integrity);
      const auto compare = [&](const char* what, const QString& actual) {
        if (actual != expected) {
          disagreements << QStringLiteral("seed %1, %2: %3, the report %4")
                               .arg(seed)
                               .arg(QLatin1String(what), actual, expected);
        }
      };

      auto recording = trace::parseRecording(run.recording);
      QVERIFY(recording.has_value());
      trace::AnalysisOptions options;
      options.toleranceMm = toleranceFor(drawn.pointsMm);
      const trace::TraceAnalysis recorded = trace::analyseTrace(trace::Trace(*recording), options);
      compare("recording", printed(recorded.blocks));
      countCauses(recorded.stops, tally.causes);
      recording->start.continuations.clear();
      countCauses(trace::analyseTrace(trace::Trace(*recording), options).stops,
                  tally.causesWithoutProgram);

      const auto bare =
          trace::parseControlTrace(trace::printControlTrace(*run.report.controlTrace));
      QVERIFY(bare.has_value());
      options.program = drawn.scenario.program.get();
      const trace::TraceAnalysis analysis = trace::analyseTrace(trace::Trace(*bare), options);
      compare("trace and program", printed(analysis.blocks));

      const bool isFaultless = run.report.integrity.isFaultless();
      if (!analysis.path.judged) {
        continue;  // nothing moved
      }
      ++(isFaultless ? tally.faultless : tally.faulty);
      ++(analysis.path.isFaultless() ? tally.cleanByPositions : tally.faultyByPositions);
      // Positions alone may not show a fault, but never one that is not there.
      if (isFaultless && !analysis.path.isFaultless()) {
        disagreements << QStringLiteral("seed %1, positions: %2, the report %3")
                             .arg(seed)
                             .arg(printed(analysis.path), expected);
      }
      if (analysis.path.isFaultless() != isFaultless) {
        qInfo("seed %llu: positions: %s; report: %s", static_cast<unsigned long long>(seed),
              qPrintable(printed(analysis.path)), qPrintable(expected));
      }
    }
    qInfo("%zu runs (%s): %zu faultless, %zu faulty; by positions alone %zu and %zu", tally.runs,
          printed(tally.methods).c_str(), tally.faultless, tally.faulty, tally.cleanByPositions,
          tally.faultyByPositions);
    qInfo("stops: %s; without the program on the control: %s", printed(tally.causes).c_str(),
          printed(tally.causesWithoutProgram).c_str());
    QVERIFY2(disagreements.isEmpty(), qPrintable(disagreements.join(u'\n')));
    QVERIFY(tally.faulty > 0 && tally.faultless > 0);
  }
};

RIVULET_TEST(TestTraceAgreement)
#include "tst_trace_agreement.moc"
