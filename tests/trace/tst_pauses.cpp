// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <limits>

#include "base/random.h"
#include "support/test_program.h"
#include "trace/analysis/pauses.h"

using namespace rivulet::trace;
using rivulet::base::Duration;
using rivulet::base::Instant;
using rivulet::base::Random;
using namespace std::chrono_literals;

namespace {

/// One character per cycle of 4 ms: '.' stands, anything else moves.
ControlTrace traceOf(std::string_view feeds) {
  ControlTrace trace;
  trace.cycle = 4ms;
  Instant at{100ms};
  for (const char c : feeds) {
    ControlSample sample;
    sample.at = at;
    sample.feedMmPerS = c == '.' ? 0.0 : 10.0;
    trace.samples.push_back(sample);
    at += trace.cycle;
  }
  return trace;
}

/// "start+duration" in ms, separated by blanks.
std::string print(const std::vector<Pause>& pauses) {
  std::string text;
  for (const Pause& pause : pauses) {
    text += (text.empty() ? "" : " ") + std::to_string(pause.start.time_since_epoch() / 1ms) + "+" +
            std::to_string(pause.duration / 1ms);
  }
  return text;
}

}  // namespace

class TestPauses : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void namesOrigins() {
    QCOMPARE(pauseOriginName(PauseOrigin::Measured), std::string_view("measured"));
    QCOMPARE(pauseOriginName(PauseOrigin::Inferred), std::string_view("inferred"));
    QCOMPARE(pauseOriginName(PauseOrigin::Predicted), std::string_view("predicted"));
  }

  void findsStandStillsBetweenMotions() {
    QCOMPARE(print(findPauses(traceOf(""))), std::string());
    QCOMPARE(print(findPauses(traceOf("....."))), std::string());
    QCOMPARE(print(findPauses(traceOf("...mmm..."))), std::string());
    // The last 'm' in front is at 104 ms, the last '.' ten cycles later.
    QCOMPARE(print(findPauses(traceOf("mm..........mm"))), std::string("104+40"));
    QCOMPARE(print(findPauses(traceOf("..m...m..m..."))), std::string("108+12 124+8"));
    QVERIFY(findPauses(traceOf("m...m"))[0].origin == PauseOrigin::Measured);
  }

  void leavesOutWhatIsTooShort() {
    QCOMPARE(print(findPauses(traceOf("m.m..m"))), std::string("108+8"));
    PauseOptions options;
    options.durationMin = 0ms;
    QCOMPARE(print(findPauses(traceOf("m.m..m"), options)), std::string("100+4 108+8"));
    options.durationMin = 9ms;
    QCOMPARE(print(findPauses(traceOf("m.m..m"), options)), std::string());
  }

  void takesTheThresholdAsStanding() {
    ControlTrace trace = traceOf("m....m");
    for (std::size_t i = 1; i < 5; ++i) {
      trace.samples[i].feedMmPerS = 0.25;
    }
    QCOMPARE(print(findPauses(trace)), std::string());
    PauseOptions options;
    options.standstillMmPerSMax = 0.25;
    QCOMPARE(print(findPauses(trace, options)), std::string("100+16"));
    trace.samples[2].feedMmPerS = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(print(findPauses(trace, options)), std::string("108+8"));
  }

  void liveEstimatesBetweenSamples() {
    LivePauseDetector detector;
    QVERIFY(!detector.add(Instant{0ms}, 0.0));
    QVERIFY(!detector.standingSince());  // nothing has moved yet
    QVERIFY(!detector.add(Instant{10ms}, 5.0));
    QVERIFY(!detector.add(Instant{30ms}, 0.0));
    QVERIFY(detector.standingSince() == Instant{20ms});
    QVERIFY(!detector.add(Instant{50ms}, 0.0));
    QVERIFY(detector.standingSince() == Instant{20ms});
    const auto found = detector.add(Instant{80ms}, 5.0);
    QVERIFY(found);
    QVERIFY(!detector.standingSince());
    QVERIFY(found->pause.start == Instant{20ms});
    QVERIFY(found->pause.duration == 45ms);  // the end between 50 and 80
    QVERIFY(found->uncertainty >= 25ms);     // half of 20 and half of 30
    QVERIFY(found->uncertainty < 26ms);
    QVERIFY(found->pause.origin == PauseOrigin::Measured);
    QVERIFY(!detector.add(Instant{90ms}, 5.0));
  }

  void liveIgnoresWhatTellsNothing() {
    LivePauseDetector detector;
    QVERIFY(!detector.add(Instant{10ms}, 5.0));
    QVERIFY(!detector.add(Instant{20ms}, 0.0));
    QVERIFY(!detector.add(Instant{15ms}, 5.0));  // older
    QVERIFY(!detector.add(Instant{20ms}, 5.0));  // the same instant
    QVERIFY(!detector.add(Instant{30ms}, std::numeric_limits<double>::quiet_NaN()));
    QVERIFY(!detector.add(Instant{28ms}, 0.0));
    const auto found = detector.add(Instant{40ms}, 5.0);
    QVERIFY(found);
    QVERIFY(found->pause.start == Instant{15ms});
    QVERIFY(found->pause.duration == 19ms);
  }

  /// One standing sample may be the cycle of a reversal, and what happened between samples that are
  /// far apart is not known.
  void liveNeedsToSeeThePause() {
    LivePauseDetector reversal;
    QVERIFY(!reversal.add(Instant{0ms}, 5.0));
    QVERIFY(!reversal.add(Instant{50ms}, 0.0));
    QVERIFY(!reversal.add(Instant{90ms}, 5.0));
    LivePauseDetector rare;
    QVERIFY(!rare.add(Instant{0ms}, 5.0));
    QVERIFY(!rare.add(Instant{900ms}, 0.0));
    QVERIFY(!rare.add(Instant{1800ms}, 0.0));
    QVERIFY(!rare.add(Instant{2700ms}, 5.0));
    // And is forgotten with the next motion.
    QVERIFY(!rare.add(Instant{2750ms}, 0.0));
    QVERIFY(!rare.add(Instant{2800ms}, 0.0));
    const auto found = rare.add(Instant{2850ms}, 5.0);
    QVERIFY(found && found->pause.duration == 100ms);
    // A long one may end in a gap that is a small part of it; that is its uncertainty.
    for (int ms = 2900; ms <= 3500; ms += 50) {
      QVERIFY(!rare.add(Instant{std::chrono::milliseconds(ms)}, 0.0));
    }
    const auto held = rare.add(Instant{3640ms}, 5.0);
    QVERIFY(held && held->pause.duration == 695ms && held->uncertainty >= 95ms);
  }

  /// Positions every 10 ms at 20 mm/s with a stop of 40 ms: the feed is 0 in it, and rises after
  /// it.
  void positionsShowAStop() {
    StandstillByPosition standstill;
    double x = 0.0;
    std::string seen;
    for (int i = 0; i < 12; ++i) {
      x += i >= 4 && i < 8 ? 0.0 : 0.2;
      const auto feed = standstill.add(Instant{10ms * i}, {x, 0.0, 0.0}, 20.0);
      seen += !feed ? '-' : *feed == 0.0 ? '0' : '+';
    }
    QCOMPARE(seen, std::string("----0000+---"));
  }

  void liveStaysWithinItsUncertainty() {
    Random random(7);
    int found = 0;
    for (int run = 0; run < 500; ++run) {
      const Instant start{
          Duration{100'000'000 + static_cast<std::int64_t>(random.below(50'000'000))}};
      const Duration duration{20'000'000 + static_cast<std::int64_t>(random.below(60'000'000))};
      LivePauseDetector detector;
      for (Instant at{0ms}; at < Instant{400ms};) {
        const bool stands = at >= start && at < start + duration;
        if (const auto pause = detector.add(at, stands ? 0.0 : 8.0)) {
          ++found;
          QVERIFY(std::chrono::abs(pause->pause.duration - duration) <= pause->uncertainty);
        }
        at += Duration{4'000'000 + static_cast<std::int64_t>(random.below(15'000'000))};
      }
    }
    QVERIFY(found > 400);  // some are so short that fewer than two samples see them
  }
};

RIVULET_TEST(TestPauses)
#include "tst_pauses.moc"
