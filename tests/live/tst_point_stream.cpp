// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A live source becomes windows: when they are given out, when the run holds, what ends it.

#include <QtTest>
#include <cmath>

#include "live/error.h"
#include "live/point_stream.h"
#include "live/setup.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::Instant;
using live::LiveError;

namespace {

class TextSource final : public live::Source {
 public:
  std::string name() const override { return "test"; }
  std::size_t read(std::span<char> into) override {
    const std::size_t count = std::min(into.size(), text.size());
    std::copy_n(text.begin(), count, into.begin());
    text.erase(0, count);
    return count;
  }
  bool isClosed() const override { return isOver && text.empty(); }
  bool endsByClosing() const override { return isPipe; }
  bool canWait() const override { return waits; }
  bool takesReplies() const override { return true; }
  void tell(const live::Progress& progress) override {
    replies.push_back(live::progressLine(progress));
  }

  std::string text;
  std::vector<std::string> replies;
  bool isOver = false;
  bool isPipe = true;
  bool waits = true;
};

struct Bench {
  explicit Bench(std::size_t pointsPerWindow = 4, double secondsMax = 0.0, int packedAxes = 0)
      : stream(source, agreement(), limits()) {
    stream.begin({{},
                  600.0,
                  {true, true, true},
                  {true, false, false},
                  {pointsPerWindow, 3, false, secondsMax, packedAxes}},
                 at);
  }
  static live::Agreement agreement() {
    live::Agreement agreed;
    agreed.highestMm = {1e6, 10.0, 10.0};
    agreed.stepMmMax = 6.0;
    agreed.turnDegMax = 30.0;
    return agreed;
  }
  static live::Limits limits() {
    live::Limits limits;
    limits.queuedMax = 8;
    return limits;
  }
  void send(const std::string& text) {
    source.text += text;
    stream.turn(at);
  }
  void sendPoints(int count) {
    for (int i = 0; i < count; ++i) {
      source.text += "X" + std::to_string(++x) + "\n";
    }
    stream.turn(at);
  }
  void wait(base::Duration time) {
    at += time;
    stream.turn(at);
  }
  std::size_t window() { return stream.takeWindow(at).value_or(0); }
  std::error_code refusal() const { return stream.summary().refusal.code; }

  Instant at{1000s};
  TextSource source;
  live::PointStream stream;
  int x = 0;
};

}  // namespace

class TestPointStream : public QObject {
  Q_OBJECT

 private slots:
  void fullWindowsGoAtOnce() {
    Bench bench;
    bench.sendPoints(5);
    QCOMPARE(bench.window(), 4U);
    QCOMPARE(bench.window(), 0U);
    QCOMPARE(bench.stream.points().size(), 4U);
  }

  void theLastPointsDoNotWaitForOthers() {
    Bench bench;
    bench.sendPoints(2);
    bench.wait(90ms);
    QCOMPARE(bench.window(), 0U);
    bench.wait(10ms);
    QCOMPARE(bench.window(), 2U);
    QCOMPARE(bench.stream.summary().shortWindows, 1U);
    bench.send("X3\nend\nX999\n");
    QCOMPARE(bench.window(), 1U);
    QVERIFY(bench.stream.isDry());
    QCOMPARE(bench.stream.summary().shortWindows, 1U);
    QVERIFY(!bench.refusal());
  }

  void aWindowEndsWhereTheFeedChanges() {
    Bench bench;
    bench.send("X1\nX2\nX3 F500\nX4\n");
    QCOMPARE(bench.window(), 2U);
    bench.wait(100ms);
    QCOMPARE(bench.window(), 2U);
  }

  /// At 10 mm/s, beginning where the tool is.
  void aWindowTakesNoLongerThanItMay() {
    Bench bench(4, 0.45);
    bench.send("X1\nX3\nX5\nX9\nX10\nX11\nend\n");
    QCOMPARE(bench.window(), 2U);  // 0.3 s; a third would make 0.5
    QCOMPARE(bench.window(), 1U);
    QCOMPARE(bench.window(), 1U);  // 0.4 s
    QCOMPARE(bench.window(), 2U);
    QVERIFY(bench.stream.isDry());
  }

  /// The source knows only its own points.
  void aMoveThatTakesLongerIsDivided() {
    Bench bench(4, 0.2);
    bench.send("X1\nX6 Y3 A30\nX7\n");  // 0.1 s, 0.58 s in three parts, 0.1 s
    bench.wait(40ms);
    QCOMPARE(bench.stream.accepted(), 5U);
    QCOMPARE(bench.stream.summary().accepted, 3U);
    QCOMPARE(bench.window(), 1U);
    for (int part = 1; part <= 3; ++part) {
      QCOMPARE(bench.window(), 1U);
      const gcode::StreamPoint& end = bench.stream.points().back();
      QVERIFY(std::abs(end.positionMm.x - (1.0 + 5.0 * part / 3.0)) < 1e-9);
      QVERIFY(std::abs(end.positionMm.y - part) < 1e-9);
      QVERIFY(std::abs(end.rotaryDeg[0] - 10.0 * part) < 1e-9);
      QCOMPARE(end.line.value, 2U);
    }
    QCOMPARE(bench.stream.points().back().positionMm.x, 6.0);
    QCOMPARE(bench.window(), 0U);  // the rest may be more
    bench.wait(60ms);
    QCOMPARE(bench.window(), 1U);
    for (const auto& [executed, ofSource] :
         std::vector<std::pair<std::size_t, std::size_t>>{{1, 1}, {2, 1}, {3, 1}, {4, 2}, {5, 3}}) {
      bench.stream.executed(executed);
      bench.wait(10ms);
      QCOMPARE(bench.stream.level().executed, ofSource);
      QCOMPARE(bench.stream.level().waiting, 3U - ofSource);
      QCOMPARE(bench.stream.summary().lastLine, ofSource);
      const std::string told = "\"executed\":" + std::to_string(ofSource) +
                               ",\"line\":" + std::to_string(ofSource) + ",";
      QVERIFY2(bench.source.replies.back().find(told) != std::string::npos,
               bench.source.replies.back().c_str());
    }
    // Four replies: when the points came, and when the source's own points were executed.
    QCOMPARE(bench.source.replies.size(), 4U);
    for (int window = 0; window < 5; ++window) {
      bench.stream.windowMoves(bench.at);
    }
    QCOMPARE(bench.stream.summary().delay.count, 3U);
  }

  /// No more waits here than without, and nothing comes between the parts of a move.
  void aMoveInManyPartsTakesNoRoom() {
    Bench bench(4, 0.001);
    bench.send("X1\nX2\nhold\nX3\n");
    QCOMPARE(bench.stream.accepted(), 300U);
    QCOMPARE(bench.stream.level().waiting, 3U);
    for (int i = 0; i < 200; ++i) {
      QCOMPARE(bench.window(), 1U);
    }
    QCOMPARE(bench.window(), 0U);  // the machine is not yet where it waits
    bench.stream.executed(200);
    bench.wait(100ms);
    for (int i = 0; i < 100; ++i) {
      QCOMPARE(bench.window(), 1U);
    }
    QCOMPARE(bench.window(), 0U);
  }

  void theSourceIsReadOnlyAsFastAsWindowsGo() {
    Bench bench;
    bench.sendPoints(100000);
    QCOMPARE(bench.stream.level().waiting, 8U);
    QVERIFY(bench.source.text.size() > 500000);
    QCOMPARE(bench.window(), 4U);
    bench.wait(1ms);
    QCOMPARE(bench.stream.summary().accepted, 12U);
    // A source that is not asked is not silent.
    for (int i = 0; i < 100; ++i) {
      bench.wait(1s);
    }
    QVERIFY(!bench.refusal());
    QVERIFY(!bench.stream.wantsHold(bench.at));
  }

  void holdIsWhereTheSourceSaysIt() {
    Bench bench;
    bench.send("X1\nX2\nhold\n");
    QCOMPARE(bench.window(), 2U);
    QVERIFY(!bench.stream.wantsHold(bench.at));
    bench.stream.executed(2);
    QVERIFY(bench.stream.wantsHold(bench.at));
    bench.send("X3\nX4\nX5\nX6\nhold\nX7\n");
    QVERIFY(!bench.stream.wantsHold(bench.at));
    QCOMPARE(bench.window(), 4U);
    QCOMPARE(bench.window(), 0U);  // it would not wait there
    bench.stream.executed(6);
    bench.wait(100ms);
    QCOMPARE(bench.window(), 1U);
  }

  void aSilentSourceHoldsAndEndsTheRun() {
    Bench bench;
    bench.sendPoints(4);
    QCOMPARE(bench.window(), 4U);
    bench.stream.executed(4);
    bench.wait(4s);
    QVERIFY(!bench.stream.wantsHold(bench.at));
    bench.wait(1s);
    QVERIFY(bench.stream.wantsHold(bench.at));
    bench.send("comment alive\n");
    QVERIFY(!bench.stream.wantsHold(bench.at));
    bench.wait(60s);
    QVERIFY(bench.refusal() == LiveError::SourceSilent);
    QVERIFY(bench.stream.isDry());
  }

  void badInputEndsBehindTheLastGoodPoint_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("code");
    QTest::newRow("nan") << "Xnan\n" << static_cast<int>(LiveError::NotFinite);
    QTest::newRow("text") << "hello\n" << static_cast<int>(LiveError::NotALine);
    QTest::newRow("step") << "X99\n" << static_cast<int>(LiveError::StepTooLong);
    QTest::newRow("huge") << QString(5000, u'1') << static_cast<int>(LiveError::TooLong);
    QTest::newRow("huge line") << QString(3000, u'1') + "\n"
                               << static_cast<int>(LiveError::TooLong);
    QTest::newRow("number") << "N1 X3.1\nN3 X3.2\n" << static_cast<int>(LiveError::NumberWrong);
  }

  void badInputEndsBehindTheLastGoodPoint() {
    QFETCH(QString, text);
    QFETCH(int, code);
    Bench bench(20);
    bench.sendPoints(3);
    bench.send(text.toStdString() + "X4\nX5\n");
    bench.wait(1ms);
    QCOMPARE(bench.refusal().value(), code);
    const std::string said = bench.stream.summary().refusal.text();
    QVERIFY2(said.starts_with("test, line "), said.c_str());
    const bool isNumbered = code == static_cast<int>(LiveError::NumberWrong);
    QCOMPARE(bench.window(), isNumbered ? 4U : 3U);
    QVERIFY(bench.stream.isDry());
  }

  void closingASource() {
    for (const bool isPipe : {true, false}) {
      for (const char* rest : {"", "X4"}) {
        Bench bench;
        bench.source.isPipe = isPipe;
        bench.sendPoints(3);
        bench.source.isOver = true;
        bench.send(rest);
        const std::error_code said = bench.refusal();
        QVERIFY(*rest != '\0' ? said == LiveError::Incomplete
                : isPipe      ? !said
                              : said == LiveError::SourceClosed);
        QCOMPARE(bench.window(), 3U);
        QVERIFY(bench.stream.isDry());
      }
    }
  }

  void aSourceThatCannotWait() {
    Bench bench;
    bench.source.waits = false;
    bench.send("X1\n");
    QVERIFY(bench.refusal() == LiveError::NumberMissing);
    Bench fast;
    fast.source.waits = false;
    for (int i = 1; i <= 200'000; ++i) {
      fast.source.text += "N" + std::to_string(i) + " X" + std::to_string(i) + "\n";
    }
    for (int i = 0; i < 100; ++i) {
      fast.wait(1ms);
    }
    QVERIFY(fast.refusal() == LiveError::Overrun);
    QCOMPARE(fast.stream.summary().accepted, 100'000U);
  }

  void theDelayIsThatOfEachPoint() {
    Bench bench;
    bench.sendPoints(2);
    bench.wait(50ms);
    bench.sendPoints(2);
    QCOMPARE(bench.window(), 4U);
    bench.wait(50ms);
    bench.stream.windowMoves(bench.at);
    // 600 mm/min: each point begins 0.1 s after the one before it.
    const trace::DurationStatistics delay = bench.stream.summary().delay;
    QCOMPARE(delay.count, 4U);
    QVERIFY(delay.max == 350ms);
    QVERIFY(delay.mean == (100ms + 200ms + 250ms + 350ms) / 4);
  }

  void theStateOfTheSourceIsKnown() {
    Bench bench;
    using live::SourceState;
    QVERIFY(bench.stream.level().state == SourceState::Waiting);
    bench.wait(3s);
    QVERIFY(bench.stream.level().state == SourceState::Waiting);
    QVERIFY(bench.stream.level().silence == 3s);
    bench.sendPoints(4);
    QVERIFY(bench.stream.level().state == SourceState::Receiving);
    bench.wait(999ms);
    QVERIFY(bench.stream.level().state == SourceState::Receiving);
    bench.wait(1ms);
    QVERIFY(bench.stream.level().state == SourceState::Silent);
    bench.send("end\n");
    QVERIFY(bench.stream.level().state == SourceState::Ended);
    Bench bad;
    bad.send("X1\nrubbish\n");
    QVERIFY(bad.stream.level().state == SourceState::Refused);
    QVERIFY(bad.stream.level().refusal.code == LiveError::NotALine);
  }

  void theLevelHasDelayAndTheory() {
    Bench bench;
    QCOMPARE(bench.stream.level().delays, 0U);
    bench.sendPoints(8);
    QCOMPARE(bench.window(), 4U);
    QCOMPARE(bench.window(), 4U);
    bench.wait(50ms);
    bench.stream.windowMoves(bench.at);
    bench.wait(400ms);
    bench.stream.windowMoves(bench.at);
    const live::Level level = bench.stream.level();
    QCOMPARE(level.delays, 8U);
    // 50, 150, 250, 350 ms, then 450 to 750 ms: 600 mm/min, points 1 mm apart.
    QVERIFY(level.delayMedian == 350ms);
    QVERIFY(level.delayP99 == 750ms);
    QVERIFY(level.leastDelay == 100ms);     // a window goes as it is
    QVERIFY(level.mostDelay == 6 * 400ms);  // its own, three on the control, two that wait
    QCOMPARE(level.capacity, 8U + 3U * 4U);
  }

  void ratesAreThoseOfTheLastTwoSeconds() {
    live::Rate rate;
    QCOMPARE(rate.perS(), 0.0);
    Instant at{5s};
    std::size_t count = 0;
    for (int i = 0; i < 1000; ++i, at += 10ms) {
      rate.add(at, count += 2);
    }
    QVERIFY(std::abs(rate.perS() - 200.0) < 1.0);
    for (int i = 0; i < 500; ++i, at += 10ms) {
      rate.add(at, count);
    }
    QCOMPARE(rate.perS(), 0.0);
    // Asked seldom, it is the mean since then.
    rate.add(at + 10s, count + 50);
    QVERIFY(std::abs(rate.perS() - 5.0) < 0.1);
  }

  void whatNobodyCanKeepIsNotAgreed() {
    const auto refuses = [](auto change) {
      live::Setup setup;
      change(setup);
      const auto sound = live::requireSound(setup);
      return !sound && sound.error().code == LiveError::NotAgreed;
    };
    QVERIFY(live::requireSound(live::Setup{}));
    QVERIFY(refuses([](live::Setup& setup) { setup.agreement.lowestMm.set(1, 10.5); }));
    QVERIFY(refuses([](live::Setup& setup) { setup.agreement.highestMm.set(2, NAN); }));
    QVERIFY(refuses([](live::Setup& setup) { setup.agreement.lowestMm.set(0, -INFINITY); }));
    QVERIFY(refuses([](live::Setup& setup) { setup.agreement.stepMmMax = 0.0; }));
    QVERIFY(refuses([](live::Setup& setup) { setup.agreement.feedMmPerMinMax = NAN; }));
    QVERIFY(refuses([](live::Setup& setup) { setup.agreement.distanceMmMin = 5.0; }));
    QVERIFY(refuses([](live::Setup& setup) { setup.agreement.startMmMax = -1.0; }));
    QVERIFY(refuses([](live::Setup& setup) { setup.limits.fullWithin = {}; }));
    QVERIFY(refuses([](live::Setup& setup) { setup.limits.endAfter = 4s; }));
    // A release is for exactly what was agreed.
    live::Setup other;
    other.agreement.stepMmMax = 5.001;
    QVERIFY(live::textOf(other) != live::textOf(live::Setup{}));
  }

  /// Packed points lie on whole steps, and as near to the first of their window as fits: 0.511 mm
  /// with five axes.
  void packedPointsShareAWindowOnlyIfTheyFit() {
    for (const bool packs : {false, true}) {
      Bench bench(6, 0.0, packs ? 5 : 0);
      bench.send("X0.20004\nX0.4\nX0.60001\nX0.8\nX1\nX1.2\n");
      QCOMPARE(bench.window(), packs ? 3U : 6U);
      QCOMPARE(bench.stream.points().front().positionMm.x, packs ? 0.2 : 0.20004);
      QCOMPARE(bench.stream.points()[2].positionMm.x, packs ? 0.6 : 0.60001);
      bench.wait(1s);
      QCOMPARE(bench.window(), packs ? 3U : 0U);
    }
  }

  void theSourceIsToldHowFarTheRunIs() {
    Bench bench;
    bench.sendPoints(4);
    QCOMPARE(bench.source.replies.size(), 1U);
    QCOMPARE(bench.window(), 4U);
    bench.stream.executed(4);
    bench.wait(10ms);
    QCOMPARE(bench.source.replies.back(),
             std::string("{\"accepted\":4,\"executed\":4,\"line\":4,\"merged\":0,\"x\":4.000000,"
                         "\"y\":0.000000,\"z\":0.000000}\n"));
    bench.stream.finish("completed", {});
    QCOMPARE(bench.source.replies.back(),
             std::string("{\"end\":\"completed\",\"accepted\":4,\"executed\":4,\"line\":4}\n"));
  }
};

RIVULET_TEST(TestPointStream)
#include "tst_point_stream.moc"
