// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Wrong motion is noticed while the run is in progress, and right motion is not taken for it. What
/// is shown as measured was there: the control's own trace is the judge.

#include <fmt/format.h>

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/units.h"
#include "streaming/run/job.h"
#include "streaming/run/path_watch.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"
#include "trace/analysis/pauses.h"

using namespace rivulet;
using base::MethodKind;
using base::Vec3;
using streaming::PathWatch;
using streaming::WrongMotion;

namespace {

/// A circle of short moves: neighbouring points are closer than δ when it is slow.
gcode::Program circle(int points, double stepRad, double radiusMm) {
  std::string text;
  for (int i = 0; i < points; ++i) {
    text += fmt::format("G1 X{:.4f} Y{:.4f} Z0 F150\n", radiusMm * std::cos(stepRad * i),
                        radiusMm * std::sin(stepRad * i));
  }
  return *gcode::interpretProgram("circle.nc", text + "M30\n");
}

std::vector<gcode::StreamPoint> pointsAt(const std::vector<Vec3>& places) {
  std::vector<gcode::StreamPoint> points;
  for (const Vec3 place : places) {
    points.emplace_back().positionMm = place;
  }
  return points;
}

/// Keeps what the display of a run gets.
class Display final : public streaming::RunSink, public streaming::RunOrders {
 public:
  void update(const streaming::LiveUpdate& update) override {
    isRunning = isRunning || update.state == streaming::RunState::Running;
    if (update.wrong && !wrong) {
      wrong = update.wrong;
      wrongSeenAt = update.at;
      wrongAt = update.counters.executed;
    }
    if (update.pause) {
      pauses.push_back(*update.pause);
    }
    if (update.sample) {
      samples.push_back(*update.sample);
    }
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(base::Instant) override { return false; }
  bool holdRequested(base::Instant now) override {
    return holdFrom && now >= *holdFrom && now < *holdFrom + std::chrono::seconds{2};
  }

  bool isRunning = false;
  std::optional<base::Instant> holdFrom;
  std::optional<WrongMotion> wrong;
  std::size_t wrongAt = 0;
  base::Instant wrongSeenAt{};
  std::vector<trace::Pause> pauses;
  std::vector<trace::LiveSample> samples;
};

struct Streamed {
  Display display;
  streaming::RunReport report;
};

Streamed stream(const gcode::Program& program, MethodKind method, int perLoop, double feedMmPerMin,
                std::optional<base::Instant> holdFrom = {}, int timesAsSlow = 1) {
  machine::MachineConfig config = *machine::loadPreset("dmu75");
  config.access.nodeTimeMean *= timesAsSlow;
  config.access.nodeTimeMin *= timesAsSlow;
  machine::Machine machine(std::move(config), 1);
  streaming::SimulatedLink link(machine);
  streaming::RunSettings settings;
  settings.parameters.method = method;
  settings.parameters.pointsPerLoop = perLoop;
  settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  settings.stallDeadline = std::chrono::seconds{2};
  settings.isCommissioned = true;
  Streamed streamed;
  streamed.display.holdFrom = holdFrom;
  streamed.report =
      streaming::runJob(link, link, program, settings, streamed.display, streamed.display);
  return streamed;
}

}  // namespace

class TestPathWatch : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void knowsThePieceThatMayBeExecuted() {
    const auto points = pointsAt({{10, 0, 0}, {20, 0, 0}, {30, 0, 0}, {30, 10, 0}, {30, 20, 0}});
    const auto isOff = [&points](Vec3 at, std::size_t passed, std::size_t sent) {
      PathWatch watch(points, {}, {});
      // Two in a row: one alone may be a reading that was falsified.
      const bool alone = watch.add(at, passed, sent).has_value();
      return watch.add(at, passed, sent).has_value() && !alone;
    };
    QVERIFY(!isOff({5, 0.6, 0}, 0, 2));  // on the way to the first
    QVERIFY(!isOff({25, 0, 0}, 2, 4));
    QVERIFY(!isOff({19, 0, 0}, 2, 4));     // the axes lag behind
    QVERIFY(!isOff({30, 9, 0}, 2, 4));     // it may be that far already
    QVERIFY(isOff({30, 17, 0}, 2, 4));     // nothing that was sent leads there
    QVERIFY(isOff({25, 2, 0}, 2, 4));      // beside the path
    QVERIFY(isOff({10, 0, 0}, 4, 5));      // old points again
    QVERIFY(!isOff({30, 20.5, 0}, 5, 5));  // at the end
  }

  /// Old points on a straight line: the tool never leaves the path, but goes back on it.
  void goingBackIsSeen() {
    std::vector<Vec3> places;
    for (int i = 1; i <= 40; ++i) {
      places.push_back({0.3 * i, 0, 0});
    }
    const auto points = pointsAt(places);
    PathWatch watch(points, {}, {});
    for (int i = 0; i <= 20; ++i) {
      QVERIFY(!watch.add({0.3 * i, 0, 0}, 0, 27));
    }
    QVERIFY(!watch.add({5.6, 0, 0}, 0, 27));  // it stopped, and overshot
    static_cast<void>(watch.add({4.6, 0, 0}, 0, 27));
    QVERIFY(watch.add({4.4, 0, 0}, 0, 27));
  }

  /// Where the path itself goes back, that is right.
  void aPathMayGoBack() {
    std::vector<Vec3> places;
    for (int i = 1; i <= 60; ++i) {
      places.push_back({i <= 30 ? 0.3 * i : 0.3 * (60 - i), 0, 0});
    }
    const auto points = pointsAt(places);
    PathWatch watch(points, {}, {});
    for (int i = 0; i <= 60; ++i) {
      QVERIFY(!watch.add({i <= 30 ? 0.3 * i : 0.3 * (60 - i), 0.01, 0}, 0, 60));
    }
  }

  /// The tool rises and goes down where it came from: while it rises it is not on the way down.
  void aLongMoveMayGoBack() {
    const auto points = pointsAt({{0, 0, 6}, {0, 0, -1}, {5, 0, -1}});
    PathWatch watch(points, {}, {50.0, 0.0, 0.0});
    for (const double z : {0.4, 2.3, 4.9, 5.9, 4.9, 2.3, 0.1, -1.0}) {
      QVERIFY(!watch.add({0, 0, z}, 0, 3));
    }
  }

  /// Points closer than δ: method position counts them as passed before they are, and the control
  /// executes old ones again. It is said while it happens.
  void repeatedPointsAreSeen() {
    const Streamed streamed = stream(circle(400, 0.015, 10.0), MethodKind::Position, 7, 150.0);
    QVERIFY(streamed.report.integrity.judged && !streamed.report.integrity.isFaultless());
    QVERIFY(streamed.display.wrong.has_value());
    QVERIFY(streamed.display.wrongAt < streamed.report.counters.total);
    QVERIFY(streamed.report.wrong == streamed.display.wrong);
    // Without a trace of the control this is what is known.
    streaming::RunReport unjudged = streamed.report;
    unjudged.integrity = {};
    unjudged.outcome = streaming::Outcome::Completed;
    QVERIFY(unjudged.finding() == streaming::RunFinding::Faulty);
    unjudged.wrong.reset();
    QVERIFY(unjudged.finding() == streaming::RunFinding::NotJudged);
  }

  /// A run that has only lost the network has done nothing wrong that anybody knows of.
  void aLostConnectionIsNoWrongMotion() {
    using streaming::RunFinding;
    streaming::RunReport report;
    report.outcome = streaming::Outcome::Failed;
    report.error = base::makeError(opcua::LinkError::ConnectionLost, "lost");
    QVERIFY(report.finding() == RunFinding::NotJudged);
    report.wrong.emplace();
    QVERIFY(report.finding() == RunFinding::Faulty);
    report.wrong.reset();
    // The trace of what was executed until the control ended its program.
    report.error = base::makeError(streaming::StreamError::ClientSilent, "silent");
    report.integrity.judged = true;
    report.counters.total = 10;
    report.integrity.executed = 4;
    QVERIFY(report.finding() == RunFinding::NotJudged);
    report.integrity.repeated = 1;
    QVERIFY(report.finding() == RunFinding::Faulty);
    report.integrity.repeated = 0;
    // An alarm is another matter.
    report.error = base::makeError(streaming::StreamError::ControlAlarm, "alarm");
    QVERIFY(report.finding() == RunFinding::Faulty);
  }

  /// The control has passed two windows before the client looks: one signal is lost.
  void missedSignalsAreSeen() {
    const Streamed streamed =
        stream(circle(300, 0.1, 20.0), MethodKind::Signal, 7, 1200.0, std::nullopt, 12);
    QVERIFY(streamed.report.integrity.judged && !streamed.report.integrity.isFaultless());
    QVERIFY(streamed.display.wrong.has_value());
  }

  void rightMotionIsNotTakenForWrong_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<int>("perLoop");
    QTest::addColumn<double>("feed");
    for (const double feed : {300.0, 1500.0, 6000.0}) {
      QTest::addRow("window %.0f", feed) << static_cast<int>(MethodKind::Window) << 7 << feed;
      QTest::addRow("credit %.0f", feed) << static_cast<int>(MethodKind::Credit) << 5 << feed;
      QTest::addRow("file %.0f", feed) << static_cast<int>(MethodKind::File) << 40 << feed;
      QTest::addRow("signal %.0f", feed) << static_cast<int>(MethodKind::Signal) << 9 << feed;
      QTest::addRow("position %.0f", feed) << static_cast<int>(MethodKind::Position) << 9 << feed;
    }
  }
  void rightMotionIsNotTakenForWrong() {
    QFETCH(int, method);
    QFETCH(int, perLoop);
    QFETCH(double, feed);
    const auto scorpion = gcode::loadProgram(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");
    QVERIFY(scorpion.has_value());
    const Streamed streamed = stream(*scorpion, static_cast<MethodKind>(method), perLoop, feed);
    QVERIFY(streamed.report.integrity.judged);
    if (streamed.report.integrity.isFaultless()) {
      QVERIFY(!streamed.display.wrong.has_value());
    } else {
      QVERIFY(streamed.display.wrong.has_value());
    }
  }

  /// Every pause that is shown as measured is a standstill in the trace of the control.
  void measuredPausesHaveBeenThere() {
    for (const MethodKind method : {MethodKind::Window, MethodKind::Credit, MethodKind::Signal,
                                    MethodKind::Position, MethodKind::File}) {
      const Streamed streamed =
          stream(circle(250, 0.2, 20.0), method, method == MethodKind::File ? 40 : 7, 1200.0,
                 base::Instant{std::chrono::seconds{4}});
      QVERIFY(streamed.report.controlTrace != nullptr);
      const std::vector<trace::Pause> stands = trace::findPauses(*streamed.report.controlTrace);
      std::size_t measured = 0;
      int held = 0;
      for (const trace::Pause& shown : streamed.display.pauses) {
        if (shown.origin != trace::PauseOrigin::Measured) {
          continue;
        }
        ++measured;
        const base::Instant middle = shown.start + shown.duration / 2;
        const bool isThere =
            std::any_of(stands.begin(), stands.end(), [&](const trace::Pause& stand) {
              return middle >= stand.start && middle <= stand.start + stand.duration &&
                     // A motion between two samples of a long standstill is not seen.
                     std::chrono::abs(shown.duration - stand.duration) <=
                         std::max<base::Duration>(std::chrono::milliseconds{100},
                                                  stand.duration / 8);
            });
        QVERIFY2(
            isThere,
            fmt::format("method {}, at {:.3f} s for {:.3f} s", base::methodName(method),
                        base::toSeconds(middle.time_since_epoch()), base::toSeconds(shown.duration))
                .c_str());
      }
      // A hold is long enough to be seen from its begin to its end.
      for (const trace::Pause& stand : stands) {
        const bool isSeen =
            std::any_of(streamed.display.pauses.begin(), streamed.display.pauses.end(),
                        [&stand](const trace::Pause& shown) {
                          return shown.origin == trace::PauseOrigin::Measured &&
                                 std::chrono::abs(shown.start - stand.start) <=
                                     std::max<base::Duration>(std::chrono::milliseconds{100},
                                                              stand.duration / 8);
                        });
        std::string shownAt;
        for (const trace::Pause& shown : streamed.display.pauses) {
          if (shown.duration > std::chrono::seconds{1}) {
            shownAt += fmt::format(" {:.3f} s for {:.3f} s",
                                   base::toSeconds(shown.start.time_since_epoch()),
                                   base::toSeconds(shown.duration));
          }
        }
        // While a file is transferred, nothing is read for the display.
        QVERIFY2(
            stand.duration < std::chrono::seconds{1} || isSeen || method == MethodKind::File,
            fmt::format("method {}, at {:.3f} s for {:.3f} s; shown:{}", base::methodName(method),
                        base::toSeconds(stand.start.time_since_epoch()),
                        base::toSeconds(stand.duration), shownAt)
                .c_str());
        held += stand.duration >= std::chrono::seconds{1} ? 1 : 0;
      }
      qInfo("%s: %zu shown, %zu of them measured, %zu in the trace, %d of them held",
            std::string(base::methodName(method)).c_str(), streamed.display.pauses.size(), measured,
            stands.size(), held);
    }
  }

  /// Where the method reads the position, each stop between two loops shows in the feed.
  void theLiveFeedShowsStops() {
    const Streamed streamed = stream(circle(120, 0.2, 20.0), MethodKind::Position, 9, 900.0);
    QVERIFY(streamed.report.integrity.isFaultless());
    const std::vector<trace::Pause> stands = trace::findPauses(*streamed.report.controlTrace);
    QVERIFY(stands.size() > 10);
    for (const trace::Pause& stand : stands) {
      const bool isShown = std::any_of(
          streamed.display.samples.begin(), streamed.display.samples.end(),
          [&](const trace::LiveSample& sample) {
            return sample.feedMmPerS == 0.0 && sample.at >= stand.start &&
                   sample.at <= stand.start + stand.duration + std::chrono::milliseconds{60};
          });
      QVERIFY2(isShown, fmt::format("at {:.3f} s for {:.3f} s",
                                    base::toSeconds(stand.start.time_since_epoch()),
                                    base::toSeconds(stand.duration))
                            .c_str());
    }
  }
};

RIVULET_TEST(TestPathWatch)
#include "tst_path_watch.moc"
