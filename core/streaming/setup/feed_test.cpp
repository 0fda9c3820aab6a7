// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/setup/feed_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/axes.h"
#include "base/contract.h"
#include "base/units.h"
#include "streaming/run/run.h"
#include "streaming/setup/feed_test_steps.h"
#include "streaming/setup/lift_test.h"
#include "templates/feed_cell.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using base::Result;
using opcua::Variable;
using templates::FeedCell;

constexpr double kHalf = 50.0;
/// The override acts within two cycles, and a step is known in the cycle after.
constexpr int kLateCyclesMax = 3;
/// A move at 50 % takes twice as long, but for its acceleration; one at 100 % as long as before.
constexpr double kHalfMin = 1.7;
constexpr double kHalfMax = 2.3;
constexpr double kSameFactor = 1.15;

constexpr Duration kFollows = std::chrono::seconds{2};
constexpr Duration kSteady = std::chrono::milliseconds{500};
constexpr Duration kBrakes = std::chrono::seconds{3};
constexpr Duration kWatched = std::chrono::seconds{3};
constexpr Duration kEnds = std::chrono::minutes{3};
constexpr Duration kMoveMin = std::chrono::seconds{2};
constexpr Duration kMoveMax = std::chrono::seconds{30};
/// Less could not be told from what is beside the lift.
constexpr double kLiftMmMin = 0.5;
/// A move may take so much longer: other overrides of the machine lower its feed.
constexpr int kPatience = 10;

class FeedCellTest : FeedTestSteps {
  using enum TestCell;

 public:
  using FeedTestSteps::FeedTestSteps;

  Result<FeedCommissioning> run() {
    for (const auto step : {&FeedCellTest::begin, &FeedCellTest::fitLift, &FeedCellTest::follow,
                            &FeedCellTest::keepSilent, &FeedCellTest::move, &FeedCellTest::end,
                            &FeedCellTest::moveAgain}) {
      if (Result<void> done = (this->*step)(); !done) {
        if (done.error().code == StreamError::Cancelled) {
          (void)set(Wanted, FeedCell::kHold);  // whatever moves stands
          (void)set(Lift, 0.0);
        }
        return base::fail(done.error());
      }
    }
    if (foreign()) {
      add("only-this-client", false,
          fmt::format("Another client has written {:g} into R{}, the feed cell. Reset the control "
                      "and find out who it is.",
                      *foreign(), m_plan.firstCell + static_cast<int>(Wanted)));
    } else {
      add("only-this-client", true, "Nobody else has written the feed cell.");
    }
    return std::move(result());
  }

 private:
  Result<void> start(CommissioningStep step) {
    return awaitStart(step, static_cast<int>(Layout), layoutOf(feedPlan()), feedTestFileName());
  }

  Result<void> begin() {
    Result<void> done = requireReset();
    done = done
               ? transfer(feedTestFileName(), feedTestProgram(feedPlan()), static_cast<int>(Layout))
               : done;
    done = done ? set(Round, 1.0) : done;
    done = done ? start(CommissioningStep::CycleStart) : done;
    m_step = CommissioningStep::Running;
    return done;
  }

  /// What the control says of the overlay of Z, before anything moves.
  Result<void> fitLift() { return requireOverlay(*this); }

  Result<void> follow() {
    if (!goesOn()) {
      return {};
    }
    for (const double percent : {FeedCell::kProgrammed, kHalf, FeedCell::kHold, kHalf,
                                 FeedCell::kHold, FeedCell::kProgrammed}) {
      if (Result<void> done = want(percent); !done) {
        return done;
      }
      const auto acts = [percent](const Look& seen) { return seen.acts == percent; };
      const auto followed = await(kFollows, acts);
      const auto other = followed && *followed
                             ? await(kSteady, [&](const Look& seen) { return !acts(seen); })
                             : followed;
      if (!other) {
        return base::fail(other.error());
      }
      if (!*followed || *other || foreign()) {
        add("actions-follow", false,
            fmt::format("With {:g} in the feed cell the synchronized actions did not make {:g} of "
                        "it, or did not keep it.",
                        percent, percent));
        return {};
      }
    }
    add("actions-follow", true, "Synchronized actions make the override of the feed cell.");
    return {};
  }

  /// The client is silent for longer than it may be.
  Result<void> keepSilent() {
    if (!goesOn()) {
      return {};
    }
    const Instant until =
        m_link.now() + base::fromSeconds(templates::kSilenceLimitS) + std::chrono::seconds{1};
    while (m_link.now() < until) {
      pause();
    }
    const auto silent = number(cell(Acts));
    if (!silent) {
      return base::fail(silent.error());
    }
    const auto back =
        await(kFollows, [](const Look& seen) { return seen.acts == FeedCell::kProgrammed; });
    if (!back) {
      return base::fail(back.error());
    }
    add("silence-holds", *silent == FeedCell::kHold && back->has_value(),
        fmt::format("Without a sign of the client the override became {:g}; it came back with the "
                    "next one.",
                    *silent));
    return {};
  }

  [[nodiscard]] Duration patience() const {
    return kPatience * feedPlan().move->duration() + kFollows;
  }

  /// Commands the next move. @return what was seen at its end; nothing: it did not come there
  Result<std::optional<Look>> drive(double percent) {
    if (Result<void> done = want(percent); !done) {
      return base::fail(done.error());
    }
    m_command += 1.0;
    if (Result<void> done = set(Command, m_command); !done) {
      return base::fail(done.error());
    }
    return arrive();
  }

  Result<std::optional<Look>> arrive() {
    return await(patience(), [this](const Look& seen) { return seen.done == m_command; });
  }

  static base::Error stuck() {
    return base::makeError(StreamError::StreamStalled,
                           "The axis did not come to the end of its move. Check the feed switch of "
                           "the machine, reset the control and start again.");
  }

  Result<void> move() {
    if (!feedPlan().move || !goesOn()) {
      return {};
    }
    result().move = feedPlan().move;
    const auto whole = drive(FeedCell::kProgrammed);
    const auto half = whole && *whole ? drive(kHalf) : whole;
    if (!half) {
      return base::fail(half.error());
    }
    if (!*whole || !*half) {
      return foreign() ? Result<void>() : base::fail(stuck());
    }
    m_wholeCycles = (*whole)->moving;
    const double ratio = (*half)->moving / std::max(1.0, m_wholeCycles);
    add("path-at-half-feed", ratio >= kHalfMin && ratio <= kHalfMax,
        fmt::format("At 50 % the move took {:.2f} times as long.", ratio));
    return goesOn() ? holdOnTheWay() : Result<void>();
  }

  Result<void> holdOnTheWay() {
    m_command += 1.0;
    Result<void> done = want(FeedCell::kProgrammed);
    done = done ? set(Command, m_command) : done;
    if (!done) {
      return done;
    }
    const double third = m_wholeCycles / 3.0;
    const auto onTheWay = await(patience(), [third](const Look& seen) {
      return seen.moving >= third && std::abs(seen.step) > kStepStandsMm;
    });
    if (!onTheWay) {
      return base::fail(onTheWay.error());
    }
    if (Result<void> held = want(FeedCell::kHold); !held) {
      return held;
    }
    const Instant from = m_link.now();
    const auto stood =
        await(kBrakes, [](const Look& seen) { return std::abs(seen.step) < kStepStandsMm; });
    if (!stood) {
      return base::fail(stood.error());
    }
    result().braking = m_link.now() - from;
    const bool isOnTheWay = *onTheWay && *stood && (*stood)->done != m_command;
    add("path-held", isOnTheWay,
        isOnTheWay ? fmt::format("With 0 the axis stood on its way, {:.0f} ms after the answer of "
                                 "the control at the latest.",
                                 base::toMilliseconds(result().braking))
                   : std::string("With 0 the axis did not stand on its way within 3 s."));
    if (isOnTheWay) {
      add("held-at-once", (*stood)->late <= kLateCyclesMax,
          fmt::format("The main run saw the axis at full speed for {:g} cycles after 0 was wanted.",
                      (*stood)->late));
      if (Result<void> watched = watchStanding(); !watched) {
        return watched;
      }
      if (Result<void> lifted = goesOn() ? liftWhileHeld(*this) : Result<void>(); !lifted) {
        return lifted;
      }
    }
    return foreign() ? Result<void>() : goBack();
  }

  Result<void> watchStanding() {
    if (Result<void> done = set(Stands, 1.0); !done) {
      return done;
    }
    const auto moved = await(kWatched, [](const Look& seen) { return seen.moved > 0.0; });
    if (!moved) {
      return base::fail(moved.error());
    }
    add("stays-held", !*moved,
        fmt::format("While the axis was held, its set point moved in {} interpolation cycles.",
                    *moved ? fmt::format("{:g}", (*moved)->moved) : std::string("0")));
    return set(Stands, 0.0);
  }

  /// The rest of the move, and back to where the axis stood before the test.
  Result<void> goBack() {
    Result<void> done = want(FeedCell::kProgrammed);
    const auto forth = done ? arrive() : base::fail(done.error());
    if (forth && *forth) {
      judgeLowered(*this, **forth);
    }
    const auto back = forth && *forth ? drive(kHalf) : forth;
    if (!back) {
      return base::fail(back.error());
    }
    return *back || foreign() ? Result<void>() : base::fail(stuck());
  }

  /// The program ends at 50 %: whether that ends with it shows afterwards.
  Result<void> end() {
    if (foreign()) {
      return set(Command, kEndOfTest);  // whatever moves stands as soon as the client is silent
    }
    Result<void> done = want(kHalf);
    done = done ? set(Command, kEndOfTest) : done;
    done = done ? awaitEnd(m_step, kEnds) : done;
    if (!done || !goesOn()) {
      return done;
    }
    // Another value in the cell: what still follows it has not ended.
    done = want(FeedCell::kProgrammed);
    if (!done) {
      return done;
    }
    const auto follows =
        await(kSteady, [](const Look& seen) { return seen.acts == FeedCell::kProgrammed; });
    if (!follows) {
      return base::fail(follows.error());
    }
    add("ends-with-program", !*follows,
        *follows ? "After the end of the program its synchronized actions go on."
                 : "The synchronized actions have ended with their program.");
    return {};
  }

  /// The same move in a program without a feed cell.
  Result<void> moveAgain() {
    if (!feedPlan().move || !goesOn()) {
      return {};
    }
    m_command = 0.0;
    Result<void> done = set(Round, 2.0);
    done = done ? set(Layout, 0.0) : done;
    m_step = CommissioningStep::CycleStartAgain;
    done = done ? start(m_step) : done;
    m_step = CommissioningStep::Running;
    const auto forth = done ? drive(FeedCell::kProgrammed) : base::fail(done.error());
    const auto back = forth && *forth ? drive(FeedCell::kProgrammed) : forth;
    if (!back) {
      return base::fail(back.error());
    }
    const double ratio = *forth ? (*forth)->moving / std::max(1.0, m_wholeCycles) : 0.0;
    add("taken-back", *back && ratio <= kSameFactor && ratio * kSameFactor >= 1.0,
        *back ? fmt::format("In the next program, without a feed cell, the move took {:.2f} times "
                            "as long.",
                            ratio)
              : std::string("In the next program, without a feed cell, the axis did not come to "
                            "the end of its move: reset the control."));
    if (!*back) {
      return {};
    }
    done = set(Command, kEndOfTest);
    return done ? awaitEnd(m_step, kEnds) : done;
  }

  double m_command = 0.0;
  double m_wholeCycles = 0.0;
};

}  // namespace

Duration AirMove::duration() const {
  return base::fromSeconds(
      feedMmPerMin > 0.0 ? std::abs(mm) / base::mmPerSFromMmPerMin(feedMmPerMin) : 0.0);
}

std::string describe(const AirMove& move) {
  return fmt::format(
      "{} {:g} mm F{:g}{}", base::kAxisNames[static_cast<std::size_t>(move.axis)], move.mm,
      move.feedMmPerMin,
      move.liftMm > 0.0 ? fmt::format(", Z lifted by {:g} mm", move.liftMm) : std::string());
}

Result<void> requireAirMove(const AirMove& move) {
  constexpr int kZ = 2;
  const bool isLift = move.liftMm == 0.0 || (move.liftMm >= kLiftMmMin && move.axis != kZ &&
                                             move.liftMm <= templates::kLiftMmMax);
  if (!isLift) {
    return base::fail(StreamError::BadAirMove,
                      fmt::format("The tool is lifted along Z by {:g} to {:g} mm while X or Y is "
                                  "held: choose another length, or another axis for the move.",
                                  kLiftMmMin, templates::kLiftMmMax));
  }
  const bool isMove = move.axis >= 0 && move.axis < static_cast<int>(base::kAxisCount) &&
                      std::isfinite(move.mm) && std::isfinite(move.feedMmPerMin) &&
                      move.feedMmPerMin > 0.0;
  if (isMove && move.duration() >= kMoveMin && move.duration() <= kMoveMax) {
    return {};
  }
  return base::fail(StreamError::BadAirMove,
                    fmt::format("The move of the test is one of X, Y or Z that takes {:g} to {:g} "
                                "s at its feed, so that it can be held on its way. Choose another "
                                "length or feed.",
                                base::toSeconds(kMoveMin), base::toSeconds(kMoveMax)));
}

std::string feedTestFileName() {
  return "RIVULET_FEED_TEST.MPF";
}

Result<FeedCommissioning> testFeedCell(opcua::Link& link, opcua::Control& control,
                                       const FeedTestPlan& plan,
                                       const std::function<bool(CommissioningStep)>& progress) {
  if (plan.move) {
    if (Result<void> fit = requireAirMove(*plan.move); !fit) {
      return base::fail(fit.error());
    }
  }
  return FeedCellTest(link, control, plan, progress).run();
}

}  // namespace rivulet::streaming
