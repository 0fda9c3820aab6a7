// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <set>
#include <utility>

#include "streaming/methods/method.h"
#include "support/test_program.h"
#include "templates/flexible_program.h"

using namespace rivulet;
using base::MethodKind;
using streaming::Expectation;
using namespace std::chrono_literals;

namespace {

streaming::MethodSetup setup(MethodKind method) {
  streaming::MethodSetup setup;
  for (int i = 0; i < 40; ++i) {
    setup.points.push_back({{50.0 * (i + 1), 0.0, 0.0}, base::LineNumber{}});
  }
  setup.settings.parameters.method = method;
  setup.settings.feedMmPerS = 10.0;
  setup.cells = templates::makeProgram(setup.settings.parameters)->cells;
  return setup;
}

}  // namespace

class TestMethods : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// What is due has no slack: a read for the display before a refill makes it late.
  void refillIsNeededAtOnce() {
    for (const MethodKind kind : base::kPaperMethods) {
      const auto method = streaming::methodType(kind).make(setup(kind));
      base::Instant now{};
      for (int begin = 0; begin < 2; ++begin) {  // fill, run
        QVERIFY(method->poll(now)->kind == streaming::Action::Kind::Write);
        method->handle({now, now, {}}, now);
      }
      QVERIFY(method->poll(now)->kind == streaming::Action::Kind::Read);
      std::vector<opcua::Reading> readings(kind == MethodKind::Position ? 3 : 1);
      // At the first point, or: the first window has been passed.
      readings[0].number = kind == MethodKind::Position ? 50.0 : 0.0;
      now += 5ms;
      method->handle({now - 5ms, now, readings}, now);
      QVERIFY(method->progress().executed > 0);
      QVERIFY(!method->progress().expected.isAhead(Expectation::Access, now));
      QVERIFY(method->poll(now)->kind == streaming::Action::Kind::Write);
      now += 20ms;
      method->handle({now - 20ms, now, {}}, now);
      // The next point is 50 mm away at 10 mm/s.
      QVERIFY(method->progress().expected.isAhead(Expectation::Access, now + 1s));
    }
  }

  /// A hold whose answer is lost may have been carried out: to continue must be written then.
  void continueAfterALostHoldIsWritten() {
    for (const MethodKind kind : {MethodKind::Window, MethodKind::Credit}) {
      streaming::MethodSetup made = setup(kind);
      made.settings.runNumber = 1;
      const templates::CellMap cells = made.cells;
      const auto method = streaming::methodType(kind).make(std::move(made));
      base::Instant now{};
      // The value that the next write of the run cell brings; every access is answered, unless it
      // is this write and its answer is to be lost.
      const auto nextRun = [&](bool isLost) -> std::optional<double> {
        for (int polls = 0; polls < 200; ++polls, now += 4ms) {
          const auto action = method->poll(now);
          if (!action) {
            continue;
          }
          std::vector<opcua::Reading> readings(action->variables.size());
          for (std::size_t i = 0; i < readings.size(); ++i) {
            readings[i].number = action->variables[i] == opcua::rParameter(cells.owner) ? 1.0 : 0.0;
          }
          for (const opcua::Assignment& item : action->assignments) {
            if (item.variable == opcua::rParameter(cells.run)) {
              const double value = item.value;
              isLost ? static_cast<void>(method->answerLost(now))
                     : method->handle({now, now, {}}, now);
              return value;
            }
          }
          method->handle({now, now, readings}, now);
        }
        return std::nullopt;
      };
      QVERIFY(nextRun(false) == std::optional(1.0));
      method->requestHold(true);
      QVERIFY(nextRun(true) == std::optional(0.0));
      method->requestHold(false);
      QVERIFY(nextRun(false) == std::optional(1.0));
    }
  }

  /// The distance to go is 0 before the first motion: that is no point passed.
  /// @source [P1] Algorithm II
  void distanceToGoWaitsForMotionAndCountsABlockOnce() {
    streaming::MethodSetup one = setup(MethodKind::Position);
    one.settings.passedBy = streaming::PassedBy::DistanceToGo;
    const auto method = streaming::methodType(MethodKind::Position).make(std::move(one));
    base::Instant now{};
    for (int begin = 0; begin < 2; ++begin) {  // fill, run
      QVERIFY(method->poll(now)->kind == streaming::Action::Kind::Write);
      method->handle({now, now, {}}, now);
    }
    // The distance read, and the points passed after it.
    const std::vector<std::pair<double, std::size_t>> seen{
        {0.0, 0},  {0.0, 0},             // stands and waits
        {49.0, 0}, {10.0, 0},            // on the way to the first point
        {0.2, 1},  {0.1, 1},  {0.0, 1},  // there, counted once
        {0.25, 2},                       // the next block, nearly at its end when it is seen
        {0.1, 2},  {48.0, 2}, {0.29, 3}, {0.0, 3}, {0.0, 3}};  // a STOPRE
    for (const auto& [toGoMm, passed] : seen) {
      const auto action = method->poll(now);
      QVERIFY(action->kind == streaming::Action::Kind::Read);
      QCOMPARE(action->variables[0].kind, opcua::VariableKind::DistanceToGo);
      const std::size_t before = method->progress().executed;
      std::vector<opcua::Reading> readings(3);
      readings[0].number = toGoMm;
      now += 5ms;
      method->handle({now - 5ms, now, readings}, now);
      QCOMPARE(method->progress().executed, passed);
      if (passed > before) {  // the slot that has been passed is refilled
        const auto refill = method->poll(now);
        QVERIFY(refill->kind == streaming::Action::Kind::Write);
        QCOMPARE(refill->assignments[0].value, 50.0 * static_cast<double>(passed + 7));
        method->handle({now, now, {}}, now);
      }
    }
    QVERIFY(!method->readsPosition());
  }

  /// Every method is registered under its own kind.
  void everyMethodHasItsType() {
    std::set<const streaming::MethodType*> types;
    for (const MethodKind kind : base::kMethodKinds) {
      const streaming::MethodType& type = streaming::methodType(kind);
      QVERIFY(types.insert(&type).second);
      streaming::MethodSetup one = setup(kind);
      type.complete(one.settings, 17);
      QCOMPARE(one.settings.runNumber > 0, base::hasWindows(kind));
      QCOMPARE(type.windowsTakenMax(one.settings.parameters) > 0, base::hasWindows(kind));
      QCOMPARE(type.checkpoint(one.settings, {}).has_value(), base::hasWindows(kind));
      const auto method = type.make(std::move(one));
      QCOMPARE(method->waitsForClient(), base::hasWindows(kind));
      QCOMPARE(method->readsPosition(), kind == MethodKind::Position);
    }
  }

  void aTimerThatIsStoppedNeverExpires() {
    base::TimerTable<Expectation> timers;
    const base::Instant now{};
    QVERIFY(timers.isAhead(Expectation::Points, now));
    QVERIFY(!timers.isExpired(Expectation::Points, now + 1h));
    timers.set(Expectation::Points, now + 1s);
    QVERIFY(timers.isAhead(Expectation::Points, now));
    QVERIFY(timers.isExpired(Expectation::Points, now + 1s));
    QVERIFY(!timers.isAhead(Expectation::Points, now + 1s));
    QVERIFY(!timers.deadline(Expectation::Access));
    timers.stop(Expectation::Points);
    QVERIFY(!timers.isExpired(Expectation::Points, now + 1h));
  }
};

RIVULET_TEST(TestMethods)
#include "tst_methods.moc"
