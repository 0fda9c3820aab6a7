// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Factors of the override: what a source may send, and what acts in the place of anything else.

#include <QtTest>
#include <algorithm>
#include <limits>
#include <string>

#include "live/error.h"
#include "live/feed_factor.h"
#include "live/line.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::Instant;
using live::FactorAgreement;
using live::FactorReader;
using live::FactorState;
using live::FeedFactor;
using live::Line;
using live::parseLine;

namespace {

class Script final : public live::Source {
 public:
  std::string name() const override { return "script"; }
  std::size_t read(std::span<char> into) override {
    const std::size_t count = std::min(into.size(), text.size());
    std::copy_n(text.begin(), count, into.begin());
    text.erase(0, count);
    return count;
  }
  bool isClosed() const override { return closes && text.empty(); }

  std::string text;
  bool closes = false;
};

struct Bench {
  explicit Bench(const FactorAgreement& agreement) : factor("script", agreement) {
    reader.turn(now);  // it has begun
  }
  /// The factor that acts when these lines have come, so much later.
  double after(base::Duration time, const std::string& lines = {}) {
    now += time;
    source.text += lines;
    reader.turn(now);
    return factor.seen(now).factor;
  }
  [[nodiscard]] FactorState state() { return factor.seen(now).state; }
  [[nodiscard]] std::string why() { return factor.seen(now).why; }

  Instant now{1h};
  Script source;
  FeedFactor factor;
  FactorReader reader{source, factor};
};

constexpr FactorAgreement kHolds{0.2, 1.2, 1s, true};
constexpr FactorAgreement kGoesOn{0.2, 1.2, 1s, false};

}  // namespace

class TestFeedFactor : public QObject {
  Q_OBJECT

 private slots:
  void theLine() {
    for (const char* const text : {"feed 0.85", " FEED\t0.85 ", "{\"feed\": 0.85}"}) {
      const auto line = parseLine(text);
      QVERIFY2(line && line->kind == Line::Kind::Feed, text);
      QCOMPARE(*line->factor, 0.85);
    }
    QVERIFY(std::isnan(*parseLine("feed fast")->factor));
    for (const char* const text :
         {"{\"feed\": 0.85, \"x\": 1}", "{\"feed\": 1, \"feed\": 1}", "{\"feed\": NaN}",
          "{\"feed\": \"fast\"}", "feeds 1", "X1 feed 1"}) {
      QVERIFY2(!parseLine(text), text);
    }
  }

  /// Neither the source before its first factor nor one that is silent lets the axes move.
  void silenceHolds() {
    Bench bench(kHolds);
    QCOMPARE(bench.after(10s), 0.0);
    QVERIFY(bench.state() == FactorState::Waiting);
    QCOMPARE(bench.after(0s, "feed 0.85\n"), 0.85);
    QVERIFY(bench.state() == FactorState::Follows && bench.why().empty());
    QCOMPARE(bench.after(1s), 0.85);
    QCOMPARE(bench.after(1ms), 0.0);
    QVERIFY(bench.state() == FactorState::Silent);
    QCOMPARE(bench.why(), std::string("No factor for 1 s: the axes are held."));
    // What only shows that it lives is no factor.
    QCOMPARE(bench.after(0s, "comment alive\n\n# alive\n"), 0.0);
    QCOMPARE(bench.after(1s, "feed 1.2\n"), 1.2);
    QCOMPARE(bench.factor.count().silences, std::size_t{1});
    QCOMPARE(bench.factor.count().values, std::size_t{2});
  }

  void silenceGoesOn() {
    Bench bench(kGoesOn);
    QCOMPARE(bench.after(10s), 1.0);
    QCOMPARE(bench.after(0s, "feed 0.2\n"), 0.2);
    QCOMPARE(bench.after(2s), 1.0);
    QCOMPARE(bench.why(),
             std::string("No factor for 1 s: the override of the operator acts alone."));
  }

  void badInput_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char* line, const char* says) {
      QTest::addRow("%.40s", line) << QByteArray(line) << QByteArray(says);
    };
    row("feed nan", "The factor nan was not agreed: 0.2 to 1.2, where 1 is 100 %");
    row("feed -1", "The factor -1 was not agreed");
    row("feed 250", "The factor 250 was not agreed");
    row("feed 1e308", "The factor 1e+308 was not agreed");
    row("feed 0", "The factor 0 was not agreed");
    row("feed 0.1999", "The factor 0.1999 was not agreed");
    row("feed", "The factor nan was not agreed");
    row("{\"feed\": 1e999}", "The line is no factor of the feed, as feed 0.85 would be: ");
    row("GET / HTTP/1.1", "The line is no factor of the feed, as feed 0.85 would be: ");
    row("X1 Y2", "The line is no factor of the feed, as feed 0.85 would be: ");
    row("hold", "The line is no factor of the feed, as feed 0.85 would be: ");
    QTest::addRow("too long") << QByteArray(5000, '7')
                              << QByteArray("The line is no factor of the feed");
  }

  /// It acts as silence, at once, until the next factor.
  void badInput() {
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, says);
    for (const FactorAgreement& agreement : {kHolds, kGoesOn}) {
      Bench bench(agreement);
      QCOMPARE(bench.after(0s, "feed 0.85\n"), 0.85);
      QCOMPARE(bench.after(1ms, line.toStdString() + "\n"), agreement.holdsInSilence ? 0.0 : 1.0);
      QVERIFY(bench.state() == FactorState::Refused);
      QVERIFY2(bench.why().starts_with(says.toStdString()), bench.why().c_str());
      const live::FactorSeen seen = bench.factor.seen(bench.now);
      QCOMPARE(seen.refused.value_or(-7.0), line == "feed 250"      ? 250.0
                                            : line == "feed -1"     ? -1.0
                                            : line == "feed 0"      ? 0.0
                                            : line == "feed 0.1999" ? 0.1999
                                                                    : -7.0);
      QCOMPARE(seen.source, std::string("script"));
      QVERIFY(seen == bench.factor.seen(bench.now));
      QVERIFY(bench.factor.count().refused >= 1);
      QCOMPARE(bench.after(1ms, "feed 0.9\n"), 0.9);
      QVERIFY(bench.state() == FactorState::Follows);
    }
  }

  void aSourceThatDies() {
    Bench bench(kHolds);
    QCOMPARE(bench.after(0s, "feed 0.85\n"), 0.85);
    bench.source.closes = true;
    QCOMPARE(bench.after(1ms), 0.0);
    QVERIFY(bench.state() == FactorState::Closed);
    QCOMPARE(bench.why(), std::string("The source has closed: the axes are held."));
    bench.factor.release(bench.now);
    QCOMPARE(bench.after(10s), 1.0);
  }

  /// The operator goes on without it; its next factor acts again. What does not hold is not
  /// released.
  void theOperatorGoesOn() {
    Bench bench(kHolds);
    bench.factor.release(bench.now);
    QCOMPARE(bench.after(10s), 1.0);
    QVERIFY(bench.state() == FactorState::Released);
    QCOMPARE(bench.after(0s, "feed 0.5\n"), 0.5);
    bench.factor.release(bench.now);
    QCOMPARE(bench.after(1ms), 0.5);
    QCOMPARE(bench.after(2s), 0.0);
  }

  /// The newest of many acts; what was there before the run is old.
  void manyLines() {
    Bench bench(kHolds);
    std::string lines;
    for (int i = 0; i < 2000; ++i) {
      lines += "feed 0.3\n";
    }
    QCOMPARE(bench.after(0s, lines + "feed 0.7\n"), 0.7);
    Script old;
    old.text = "feed 0.6\n";
    FeedFactor factor("script", kHolds);
    FactorReader reader(old, factor);
    reader.turn(bench.now);
    QCOMPARE(factor.seen(bench.now).factor, 0.0);
  }

  void whatNobodyCanKeep() {
    QVERIFY(live::requireSound(kHolds).has_value());
    const auto refused = live::requireSound({0.2, 1.2, 0s, true});
    QVERIFY(!refused && refused.error().code == live::LiveError::NotAgreed);
    QCOMPARE(live::textOf(kHolds),
             std::string("factor 0.2 to 1.2; without one for 1 s the axes are held"));
  }
};

RIVULET_TEST(TestFeedFactor)
#include "tst_feed_factor.moc"
