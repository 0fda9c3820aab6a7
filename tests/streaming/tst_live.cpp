// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Runs whose points arrive while the machine moves, in virtual time.

#include <fmt/format.h>

#include <QtTest>
#include <cmath>
#include <functional>

#include "live/error.h"
#include "live/point_stream.h"
#include "streaming/run/job.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"
#include "support/timed_source.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::Duration;
using base::Instant;
using base::MethodKind;
using live::LiveError;
using streaming::Outcome;
using streaming::RunReport;
using streaming::RunState;

namespace {

/// Reads replies and answers them.
class AnsweringSource final : public tests::TimedSource {
 public:
  using TimedSource::TimedSource;

  bool takesReplies() const override { return true; }
  void tell(const live::Progress& progress) override {
    lastReply = live::progressLine(progress);
    if (answer) {
      if (const std::string text = answer(lastReply); !text.empty()) {
        say(time(), text);
      }
    }
  }

  std::function<std::string(const std::string&)> answer;
  std::string lastReply;
};

class Watcher final : public streaming::RunSink, public streaming::RunOrders {
 public:
  explicit Watcher(const machine::Machine& machine) : m_machine(machine) {}
  void update(const streaming::LiveUpdate& update) override {
    if (update.state == RunState::Holding) {
      heldAt.emplace_back(m_machine.now(), update.counters.executed);
    }
    waiting = std::max(waiting, update.source ? update.source->waiting : 0);
    wrong = wrong || update.wrong;
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(Instant now) override {
    first = first.value_or(now);
    return now - *first >= limit;
  }
  std::optional<Instant> first;
  Duration limit = 1h;
  std::vector<std::pair<Instant, std::size_t>> heldAt;
  std::size_t waiting = 0;
  bool wrong = false;

 private:
  const machine::Machine& m_machine;
};

struct Bench {
  explicit Bench(MethodKind method = MethodKind::Window,
                 machine::MachineConfig config = *machine::loadPreset("dmu75-arrays"))
      : machine(std::move(config), 1), link(machine), source(link), watcher(machine) {
    settings.parameters.method = method;
    settings.parameters.pointsPerLoop = 13;
    settings.access = streaming::AccessChoice::Best;
    settings.feedMmPerS = 20.0;
    settings.isCommissioned = true;
    agreed.lowestMm = {-300.0, -300.0, 0.0};
    agreed.highestMm = {300.0, 300.0, 100.0};
    agreed.feedMmPerMinMax = 6000.0;
    limits.queuedMax = 28;
  }
  RunReport run() {
    live::PointStream stream(source, agreed, limits);
    return streaming::runLive(link, link, "script", stream,
                              templates::makeProgram(settings.parameters).value(), settings,
                              watcher, watcher);
  }
  /// A spiral from the tool's place, one point each `interval`. @return time of the last
  Duration spiral(int count, Duration interval, double stepMm = 0.1) {
    double angle = 0.0;
    Duration at{};
    base::Vec3 pointMm{0.0, 0.0, 50.0};
    for (int i = 0; i < count; ++i, at += interval) {
      const double radiusMm = 5.0 + 0.2 * angle;
      angle += stepMm / radiusMm;
      pointMm = pointMm + stepMm * base::Vec3{std::cos(angle), std::sin(angle), 0.0};
      source.say(at, fmt::format("X{:.4f} Y{:.4f}\n", pointMm.x, pointMm.y));
    }
    return at;
  }

  /// The same along straight legs of 5 mm.
  Duration legs(int count, Duration interval) {
    Duration at{};
    base::Vec3 pointMm{0.0, 0.0, 50.0};
    for (int i = 0; i < count; ++i, at += interval) {
      const int leg = i / 100;
      const double stepMm = leg % 4 == 2 ? -0.05 : 0.05;
      pointMm =
          pointMm + (leg % 2 == 0 ? base::Vec3{stepMm, 0.0, 0.0} : base::Vec3{0.0, 0.05, 0.0});
      source.say(at, fmt::format("X{:.4f} Y{:.4f}\n", pointMm.x, pointMm.y));
    }
    return at;
  }

  machine::Machine machine;
  streaming::SimulatedLink link;
  AnsweringSource source;
  Watcher watcher;
  streaming::RunSettings settings;
  live::Agreement agreed;
  live::Limits limits;
};

double ms(Duration duration) {
  return base::toMilliseconds(duration);
}

void verifyFaultless(const RunReport& report, std::size_t points) {
  QVERIFY2(!report.error.code, report.error.text().c_str());
  QVERIFY(report.outcome == Outcome::Completed);
  QVERIFY(report.isFaultless());
  QVERIFY(!report.wrong);
  QCOMPARE(report.counters.executed, points);
  QCOMPARE(report.counters.total, points);
  QCOMPARE(report.live->accepted, points);
  QCOMPARE(report.live->delay.count, points);
}

}  // namespace

class TestLive : public QObject {
  Q_OBJECT

 private slots:
  void everyPointOnce_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<int>("interval");
    QTest::newRow("window, faster than the machine") << static_cast<int>(MethodKind::Window) << 0;
    QTest::newRow("window, slower") << static_cast<int>(MethodKind::Window) << 20;
    QTest::newRow("window, one by one") << static_cast<int>(MethodKind::Window) << 300;
    QTest::newRow("credit, faster") << static_cast<int>(MethodKind::Credit) << 0;
    QTest::newRow("credit, slower") << static_cast<int>(MethodKind::Credit) << 20;
    QTest::newRow("credit, one by one") << static_cast<int>(MethodKind::Credit) << 300;
  }

  void everyPointOnce() {
    QFETCH(int, method);
    QFETCH(int, interval);
    Bench bench(static_cast<MethodKind>(method));
    const int count = interval == 300 ? 30 : 300;
    const Duration end = bench.spiral(count, std::chrono::milliseconds{interval});
    bench.source.say(end, "end\n");
    const RunReport report = bench.run();
    verifyFaultless(report, static_cast<std::size_t>(count));
    QVERIFY(!bench.watcher.wrong);
    // The queue, two windows in the cells, and those that the control has copied.
    QVERIFY(bench.watcher.waiting <= 28 + (2 + 4) * 13);
    qInfo("%zu windows, %zu short, delay %.0f %.0f %.0f %.0f ms, bound %.0f to %.0f ms",
          report.live->windows, report.live->shortWindows, ms(report.live->delay.p50),
          ms(report.live->delay.p90), ms(report.live->delay.p99), ms(report.live->delay.max),
          ms(report.live->leastDelay), ms(report.live->mostDelay));
  }

  /// Where only the run cell stops a run. The control executes parts, the source hears of its
  /// points.
  void longMovesAreDivided() {
    for (const MethodKind method : {MethodKind::Window, MethodKind::Credit}) {
      Bench bench(method);
      bench.settings.windowSMax = 1.0;
      bench.agreed.stepMmMax = bench.agreed.startMmMax = 60.0;
      for (const char* point : {"X60\n", "Y50 F600\n", "X0 F1200\n", "Y0.1 F6000\nend\n"}) {
        bench.source.say(0s, point);
      }
      const RunReport report = bench.run();
      QVERIFY2(report.isFaultless(), report.error.text().c_str());
      // 3 s at F 1200, 5 s at F 600, 3 s, 0.5 s: by parts of 1 s, or of what one of the windows
      // that are executed after a stop may take.
      const auto together =
          static_cast<std::size_t>(streaming::windowsAfterStop(bench.settings.parameters));
      QVERIFY(report.counters.executed >= 11 * together + 1);
      QCOMPARE(report.counters.total, report.counters.executed);
      QVERIFY(report.live->windows >= 12);
      QCOMPARE(report.live->accepted, 4U);
      QCOMPARE(report.live->executed, 4U);
      QCOMPARE(report.live->delay.count, 4U);
      QVERIFY(bench.source.lastReply.find("\"executed\":4,\"line\":4") != std::string::npos);
    }
  }

  void theEndMayComeLater() {
    Bench bench;
    const Duration end = bench.spiral(20, 10ms);
    bench.source.say(end + 2s, "end\n");
    verifyFaultless(bench.run(), 20);
  }

  void twoHundredPointsASecond_data() {
    QTest::addColumn<int>("cycleMs");
    // At a rounded corner the main run of the virtual machine needs two cycles for a point.
    QTest::newRow("straight legs, 4 ms cycle") << 4;
    QTest::newRow("spiral, 2 ms cycle") << 2;
  }

  void twoHundredPointsASecond() {
    QFETCH(int, cycleMs);
    machine::MachineConfig config = *machine::loadPreset("dmu75-arrays");
    config.interpolationCycle = std::chrono::milliseconds{cycleMs};
    config.rParameterCount = 102;
    Bench bench(MethodKind::Credit, config);
    bench.settings.parameters.rParameterCount = config.rParameterCount;
    bench.settings.parameters.pointsPerLoop = 14;
    bench.settings.feedMmPerS = cycleMs == 4 ? 11.0 : 8.0;
    const Duration end = cycleMs == 4 ? bench.legs(10'000, 5ms) : bench.spiral(10'000, 5ms, 0.03);
    bench.source.say(end, "end\n");
    const RunReport report = bench.run();
    verifyFaultless(report, 10'000);
    QVERIFY2(report.duration < end + 3s, qPrintable(QString::number(ms(report.duration))));
    // Nothing piles up: a point waits for its window and for those that are in the control.
    QVERIFY(report.live->delay.max < report.live->mostDelay);
    qInfo("%.1f s, %zu windows, %zu short, delay %.0f %.0f %.0f %.0f ms, %.0f ms per window",
          base::toSeconds(report.duration), report.live->windows, report.live->shortWindows,
          ms(report.live->delay.p50), ms(report.live->delay.p90), ms(report.live->delay.p99),
          ms(report.live->delay.max), ms(report.live->windowTime));
  }

  void aSilentSourceHoldsThenContinues() {
    Bench bench;
    bench.spiral(20, 0ms);
    bench.source.say(12s, "X0.1 Y0.1\nend\n");
    bench.agreed.stepMmMax = 20.0;
    verifyFaultless(bench.run(), 21);
    QVERIFY(!bench.watcher.heldAt.empty());
    QCOMPARE(bench.watcher.heldAt.front().second, 20U);
  }

  void aSourceThatStaysSilentEndsTheRun() {
    Bench bench;
    bench.spiral(20, 0ms);
    const RunReport report = bench.run();
    QVERIFY(report.error.code == LiveError::SourceSilent);
    QVERIFY(report.outcome == Outcome::Failed);
    QCOMPARE(report.counters.executed, 20U);
    QVERIFY(report.integrity.isFaultless());
    QCOMPARE(report.live->lastLine, 20U);
  }

  void aSourceThatSaysNothing() {
    Bench bench;
    const RunReport report = bench.run();
    QVERIFY(report.error.code == LiveError::SourceSilent);
    QCOMPARE(report.counters.executed, 0U);
    QCOMPARE(report.integrity.foreign, 0U);
  }

  void aSourceThatOnlySaysEnd() {
    Bench bench;
    bench.source.say(0s, "end\n");
    const RunReport report = bench.run();
    QVERIFY(report.error.code == LiveError::NoPoint);
    QCOMPARE(report.counters.executed, 0U);
  }

  void badInputLeavesThePointsBeforeIt_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("code");
    QTest::newRow("nan") << "X nan\n" << static_cast<int>(LiveError::NotFinite);
    QTest::newRow("step") << "X200\n" << static_cast<int>(LiveError::StepTooLong);
    QTest::newRow("box") << "Z-1\n" << static_cast<int>(LiveError::OutsideBox);
    QTest::newRow("half a line, then closed") << "X1." << static_cast<int>(LiveError::Incomplete);
    QTest::newRow("closed") << "" << static_cast<int>(LiveError::SourceClosed);
  }

  void badInputLeavesThePointsBeforeIt() {
    QFETCH(QString, text);
    QFETCH(int, code);
    for (const MethodKind method : {MethodKind::Window, MethodKind::Credit}) {
      Bench bench(method);
      const Duration end = bench.spiral(40, 5ms);
      bench.source.say(end, text.toStdString());
      bench.source.say(end + 1ms, "");
      bench.source.closeAt(end + 2ms);
      const RunReport report = bench.run();
      QCOMPARE(report.error.code.value(), code);
      QVERIFY(report.outcome == Outcome::Failed);
      QCOMPARE(report.counters.executed, 40U);
      QVERIFY(report.integrity.isFaultless());
      QCOMPARE(report.live->lastLine, 40U);
      QVERIFY(bench.source.lastReply.find("\"end\":\"failed\"") != std::string::npos);
    }
  }

  void aStopEndsBeforeTheNextWindow() {
    Bench bench;
    bench.spiral(1000, 0ms);
    bench.watcher.limit = 5s;
    const RunReport report = bench.run();
    QVERIFY(report.outcome == Outcome::Stopped);
    QVERIFY(report.integrity.isFaultless());
    QVERIFY(report.counters.executed > 0 && report.counters.executed < 1000);
    QCOMPARE(report.live->lastLine, report.counters.executed);
  }

  void aHoldOfTheSourceIsAStandstill() {
    Bench bench;
    bench.spiral(20, 0ms);
    bench.source.say(0s, "hold\n");
    bench.source.say(3s, "X0.1 Y0.1\nend\n");
    bench.agreed.stepMmMax = 20.0;
    verifyFaultless(bench.run(), 21);
    QVERIFY(!bench.watcher.heldAt.empty());
    QCOMPARE(bench.watcher.heldAt.front().second, 20U);
  }

  /// One point at a time, and only after the one before has been executed.
  void theLoopIsClosed() {
    Bench bench;
    bench.limits.fullWithin = 0s;
    int sent = 1;
    bench.source.say(0s, "X0.1\n");
    bench.source.answer = [&](const std::string& reply) -> std::string {
      if (reply.find(fmt::format("\"executed\":{},", sent)) == std::string::npos) {
        return {};
      }
      ++sent;
      return sent > 20 ? "end\n" : fmt::format("X{:.1f}\n", 0.1 * sent);
    };
    const RunReport report = bench.run();
    verifyFaultless(report, 20);
    QCOMPARE(report.live->windows, 20U);
    qInfo("delay %.0f %.0f ms", ms(report.live->delay.p50), ms(report.live->delay.max));
  }

  void onlyMethodsThatWait() {
    Bench bench(MethodKind::Signal);
    bench.settings.parameters.pointsPerLoop = 4;
    bench.source.say(0s, "X0.1\nend\n");
    QVERIFY(bench.run().error.code == streaming::StreamError::ProgramNotStreamable);
  }
};

RIVULET_TEST(TestLive)
#include "tst_live.moc"
