// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The control's trace is taken while the run lasts: the report is the same as from the whole
/// trace, and memory does not grow with the run.

#include <malloc.h>

#include <QtTest>
#include <cmath>
#include <string>

#include "base/units.h"
#include "streaming/run/job.h"
#include "streaming/run/run_trace.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"
#include "support/whole_trace_link.h"

using namespace rivulet;
using streaming::RunReport;
using streaming::RunTrace;

namespace {

class Silent final : public streaming::RunSink, public streaming::RunOrders {
 public:
  void update(const streaming::LiveUpdate&) override {}
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(base::Instant) override { return false; }
};

gcode::Program scorpion() {
  return *gcode::loadProgram(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");
}

streaming::RunSettings settings(base::MethodKind method, int points, double feedMmPerMin) {
  streaming::RunSettings settings;
  settings.parameters.method = method;
  settings.parameters.pointsPerLoop = points;
  settings.deltaMm = 0.1;
  settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  return settings;
}

/// What the report says of the motion.
std::string text(const RunReport& report) {
  std::string all =
      std::to_string(report.integrity.judged) + " " + std::to_string(report.integrity.executed) +
      " " + std::to_string(report.integrity.repeated) + " " +
      std::to_string(report.integrity.skipped) + " " + std::to_string(report.integrity.foreign) +
      " " + std::to_string(report.integrity.outOfOrder) + " " +
      std::to_string(report.duration.count());
  for (const trace::IntegrityFault& fault : report.integrity.faults) {
    all += " f" + std::to_string(fault.point.value) + "@" +
           std::to_string(fault.at.time_since_epoch().count());
  }
  for (const trace::Pause& pause : report.pauses) {
    all += " p" + std::to_string(pause.start.time_since_epoch().count()) + "+" +
           std::to_string(pause.duration.count());
  }
  return all;
}

/// Samples of a tool that stands every tenth second, one block per second.
trace::TracePiece piece(std::size_t from, std::size_t count, std::size_t& blocks) {
  trace::TracePiece piece;
  piece.records.cycle = std::chrono::milliseconds{4};
  for (std::size_t i = from; i < from + count; ++i) {
    trace::ControlSample sample;
    sample.at = base::Instant{piece.records.cycle * static_cast<int>(i)};
    sample.feedMmPerS = i % 2500 < 10 ? 0.0 : 10.0;
    piece.records.samples.push_back(sample);
    if (i % 250 == 249) {
      trace::ExecutedBlock block;
      block.from = sample.at;
      block.targetMm = {static_cast<double>(blocks++), 0, 0};
      block.lengthMm = 1.0;
      piece.records.blocks.push_back(block);
    }
  }
  return piece;
}

}  // namespace

class TestRunTrace : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theReportIsTheSameAsFromTheWholeTrace() {
    Silent silent;
    bool sawFaults = false;
    for (const streaming::RunSettings& run : {settings(base::MethodKind::Window, 9, 1000.0),
                                              settings(base::MethodKind::Signal, 7, 3000.0),
                                              settings(base::MethodKind::Position, 7, 2000.0)}) {
      machine::Machine first(*machine::loadPreset("dmu75"), 3);
      machine::Machine second(*machine::loadPreset("dmu75"), 3);
      streaming::SimulatedLink inPieces(first);
      streaming::SimulatedLink atOnce(second);
      tests::WholeTraceLink whole(atOnce);
      const RunReport taken =
          streaming::runJob(inPieces, inPieces, scorpion(), run, silent, silent);
      const RunReport fetched = streaming::runJob(whole, atOnce, scorpion(), run, silent, silent);
      QCOMPARE(text(taken), text(fetched));
      QVERIFY(taken.integrity.judged && taken.duration > std::chrono::seconds{10});
      sawFaults = sawFaults || !taken.integrity.faults.empty();
      QVERIFY(trace::printControlTrace(*taken.controlTrace) ==
              trace::printControlTrace(*fetched.controlTrace));
    }
    QVERIFY2(sawFaults, "one of the runs has to be faulty");
  }

  /// The control's memory holds a small part of the run.
  void aRunLongerThanTheTraceOfTheControlIsJudged() {
    machine::MachineConfig config = *machine::loadPreset("dmu75");
    config.traceLimit = std::chrono::seconds{20};
    machine::Machine machine(config, 1);
    streaming::SimulatedLink link(machine);
    Silent silent;
    const RunReport report = streaming::runJob(
        link, link, scorpion(), settings(base::MethodKind::Window, 9, 1000.0), silent, silent);
    QVERIFY2(report.isFaultless(), report.error.text().c_str());
    QVERIFY(report.duration > std::chrono::seconds{60});
    QVERIFY(machine.trace().truncated && machine.trace().samples.size() <= 5'000);
  }

  void memoryDoesNotGrowWithTheRun() {
    if (mallinfo2().uordblks == 0) {
      QSKIP("the heap is not counted under a sanitizer");
    }
    const auto heapAfter = [](std::size_t samples) {
      std::vector<gcode::StreamPoint> points;
      for (std::size_t i = 0; i < samples / 250; ++i) {
        points.push_back({{static_cast<double>(i), 0, 0}, {}});
      }
      const auto bytes = [] {
        const struct mallinfo2 now = mallinfo2();
        return now.uordblks + now.hblkhd;
      };
      const std::size_t before = bytes();
      RunTrace trace(points, {}, trace::PointsOfRun::Known, nullptr);
      std::size_t blocks = 0;
      for (std::size_t i = 0; i < samples; i += 500) {
        trace.take(piece(i, 500, blocks));
      }
      const std::size_t used = bytes() - before;
      const streaming::TraceFindings found = trace.finish();
      const bool isRight = found.isWhole && found.integrity.isFaultless() &&
                           found.integrity.executed == samples / 250 &&
                           found.kept->samples.size() == RunTrace::kKeptMax &&
                           found.kept->truncated;
      return isRight ? used : std::size_t{0};
    };
    const std::size_t once = heapAfter(250'000);
    const std::size_t fourTimes = heapAfter(1'000'000);
    QVERIFY2(once > 0 && fourTimes > 0, "the judgement is wrong");
    // 300 pauses more, in a list that doubles.
    QVERIFY2(fourTimes < once + 32'768,
             qPrintable(QStringLiteral("%1 and %2 bytes").arg(once).arg(fourTimes)));
  }
};

RIVULET_TEST(TestRunTrace)
#include "tst_run_trace.moc"
