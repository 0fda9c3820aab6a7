// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>
#include <limits>
#include <vector>

#include "support/test_program.h"
#include "trace/trigger.h"

using namespace rivulet;
using namespace rivulet::trace;

namespace {

using base::Instant;
using std::chrono::milliseconds;

Instant ms(double value) {
  return Instant{base::fromSeconds(value * 1e-3)};
}

TriggerSettings settings(TriggerKind kind, double level = 0.0, bool isRepeated = true) {
  TriggerSettings settings;
  settings.condition.kind = kind;
  settings.condition.level = level;
  settings.isRepeated = isRepeated;
  return settings;
}

/// When a trigger fires on values that come every 10 ms.
std::vector<double> firings(const TriggerSettings& settings, const std::vector<double>& values) {
  Trigger trigger(settings);
  std::vector<double> at;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (const auto shot = trigger.sample(ms(10.0 * static_cast<double>(i)), values[i])) {
      at.push_back(base::toMilliseconds(shot->at.time_since_epoch()));
    }
  }
  return at;
}

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

}  // namespace

class TestTrigger : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void firesOnLevels() {
    const std::vector<double> values{5, 1, 2, 3, 4, 3, 2, 3, 5};
    // At once if it is so when the trigger is armed; then it must have been otherwise.
    QCOMPARE(firings(settings(TriggerKind::Above, 3.0), values),
             (std::vector<double>{0.0, 30.0, 70.0}));
    QCOMPARE(firings(settings(TriggerKind::Below, 2.0), values), (std::vector<double>{10.0, 60.0}));
  }

  /// Between two samples, where the straight line crosses the level.
  void firesOnEdges() {
    const std::vector<double> values{4, 1, 3, 4, 0, kGap, 4, 3, 1, 2};
    QCOMPARE(firings(settings(TriggerKind::Rising, 2.0), values),
             (std::vector<double>{15.0, 90.0}));
    QCOMPARE(firings(settings(TriggerKind::Falling, 2.0), values).size(), std::size_t{3});
    QVERIFY(std::abs(firings(settings(TriggerKind::Falling, 2.0), values)[0] - 20.0 / 3.0) < 1e-5);
    QVERIFY(std::abs(firings(settings(TriggerKind::Falling, 2.0), values)[1] - 35.0) < 1e-5);
    QVERIFY(std::abs(firings(settings(TriggerKind::Falling, 2.0), values)[2] - 75.0) < 1e-5);
  }

  void noiseFiresOnceWithHysteresis() {
    const std::vector<double> values{0, 2.1, 1.9, 2.1, 1.8, 2.2, 0.9, 2.1};
    QCOMPARE(firings(settings(TriggerKind::Rising, 2.0), values).size(), std::size_t{4});
    TriggerSettings calm = settings(TriggerKind::Rising, 2.0);
    calm.condition.hysteresis = 1.0;
    QCOMPARE(firings(calm, values).size(), std::size_t{2});
    calm.condition.kind = TriggerKind::Above;
    QCOMPARE(firings(calm, values), (std::vector<double>{10.0, 70.0}));
    std::vector<double> mirrored;
    for (const double value : values) {
      mirrored.push_back(-value);
    }
    calm.condition.level = -2.0;
    calm.condition.kind = TriggerKind::Below;
    QCOMPARE(firings(calm, mirrored), (std::vector<double>{10.0, 70.0}));
  }

  void firesOnWindows() {
    TriggerSettings window = settings(TriggerKind::Inside);
    window.condition.low = 1.0;
    window.condition.high = 2.0;
    const std::vector<double> values{0, 1, 2, 3, 1.5, 0, 5};
    QCOMPARE(firings(window, values), (std::vector<double>{10.0, 40.0}));
    window.condition.kind = TriggerKind::Outside;
    QCOMPARE(firings(window, values), (std::vector<double>{0.0, 30.0, 50.0}));
  }

  /// The stretch is complete when the time after the trigger has passed.
  void showsWhatWasBeforeAndAfter() {
    TriggerSettings wanted = settings(TriggerKind::Rising, 0.5, false);
    wanted.before = milliseconds{200};
    wanted.after = milliseconds{30};
    Trigger trigger(wanted);
    QVERIFY(!trigger.sample(ms(0), 0.0));
    QVERIFY(!trigger.sample(ms(10), 1.0));
    QCOMPARE(trigger.state(), Trigger::State::Filling);
    QVERIFY(!trigger.sample(ms(20), 0.0));
    QVERIFY(!trigger.sample(ms(30), 1.0));
    const auto shot = trigger.sample(ms(40), 0.0);
    QVERIFY(shot.has_value());
    QCOMPARE(*shot, (TriggerShot{ms(5), ms(-195), ms(35)}));
    // Once is enough.
    QCOMPARE(trigger.state(), Trigger::State::Done);
    QVERIFY(!trigger.sample(ms(50), 1.0) && !trigger.sample(ms(500), 0.0));
    QVERIFY(!trigger.finish());
  }

  void repeatsAfterWhatIsShown() {
    TriggerSettings wanted = settings(TriggerKind::Rising, 0.5, true);
    wanted.after = milliseconds{35};
    const std::vector<double> values{0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0};
    // At 5, complete at 40; the next edge after that is at 45, then at 85.
    QCOMPARE(firings(wanted, values), (std::vector<double>{5.0, 45.0, 85.0}));
  }

  void firesOnEvents() {
    TriggerSettings wanted = settings(TriggerKind::Event, 0.0, false);
    wanted.condition.event = TriggerEvent::Alarm;
    wanted.before = milliseconds{100};
    wanted.after = milliseconds{50};
    Trigger trigger(wanted);
    QVERIFY(!trigger.sample(ms(1000), 1e9));
    QVERIFY(!trigger.happened(TriggerEvent::PauseBegins, ms(900), ms(1000)));
    QCOMPARE(trigger.state(), Trigger::State::Waiting);
    // Noticed late: all of it is there.
    const auto late = trigger.happened(TriggerEvent::Alarm, ms(940), ms(1000));
    QVERIFY(late.has_value());
    QCOMPARE(*late, (TriggerShot{ms(940), ms(840), ms(990)}));
    Trigger another(wanted);
    QVERIFY(!another.happened(TriggerEvent::Alarm, ms(1000), ms(1000)));
    QVERIFY(!another.advance(ms(1049)));
    QVERIFY(another.advance(ms(1050)).has_value());
  }

  /// The run ends before the time after the trigger has passed: what there is counts.
  void endsWithTheRun() {
    TriggerSettings wanted = settings(TriggerKind::Above, 1.0, false);
    wanted.after = milliseconds{1000};
    Trigger trigger(wanted);
    QVERIFY(!trigger.finish());
    QVERIFY(!trigger.sample(ms(10), 2.0));
    const auto shot = trigger.finish();
    QVERIFY(shot && shot->at == ms(10));
    QCOMPARE(trigger.state(), Trigger::State::Done);
  }
};

RIVULET_TEST(TestTrigger)
#include "tst_trigger.moc"
