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
#include "base/hash.h"
#include "base/units.h"
#include "streaming/run/run.h"
#include "streaming/setup/program_test.h"
#include "templates/feed_cell.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using base::Result;
using opcua::Variable;
using templates::FeedCell;

/// R-parameters of the test, counted from its first.
enum class TestCell {
  Wanted,     ///< client: the feed cell
  Acts,       ///< main run: what it makes of it
  Beat,       ///< client: its sign of life
  Command,    ///< client: number of the move that it wants
  Done,       ///< program: number of the last move
  Round,      ///< client: 2 at the start without a feed cell
  Layout,     ///< program: its number
  Stands,     ///< client: 1 while the axis must not move
  Moved,      ///< main run: cycles in which it moved nevertheless
  Late,       ///< main run: cycles at full speed since 0 is wanted
  Moving,     ///< main run: cycles with motion since the move began
  Step,       ///< main run: way of the set point in a cycle
  Place,      ///< main run: the set point in the cycle before
  Reference,  ///< main run: square of the step at the override that was wanted last
};
static_assert(static_cast<int>(TestCell::Reference) + 1 == kFeedTestCells);

/// Synchronized actions of the test: after those of the feed cell.
enum TestAction { TakeStep = 20, TakePlace, TakeReference, CountLate, CountMoved, CountMoving };
static_assert(TakeStep > templates::ActionNumber::kCorrection);

constexpr double kEnd = 99.0;  ///< as a command
constexpr double kHalf = 50.0;
/// Passes of the waiting loop, 20 ms or more each, before the program ends without a client.
constexpr int kIdlePassesMax = 1500;

/// A set point that moves less in a cycle stands, mm; a step counts as undiminished by its square.
constexpr double kStandsMm = 1e-5;
constexpr double kUndiminished = 0.9999;
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
/// A move may take so much longer: other overrides of the machine lower its feed.
constexpr int kPatience = 10;

int layoutOf(const FeedTestPlan& plan) {
  constexpr std::uint64_t kSpread = 1'000'000;
  const AirMove move = plan.move.value_or(AirMove{-1, 0.0, 0.0});
  const std::uint64_t hash = base::hashOf(
      fmt::format("{} {} {} {}", plan.firstCell, move.axis, move.mm, move.feedMmPerMin));
  return kTestLayout + 1 + static_cast<int>(hash % kSpread);
}

class FeedCellTest : ProgramTest {
  using enum TestCell;

 public:
  FeedCellTest(opcua::Link& link, opcua::Control& control, const FeedTestPlan& plan,
               const std::function<bool(CommissioningStep)>& progress)
      : ProgramTest(link, control, plan, progress), m_feedPlan(plan) {}

  Result<FeedCommissioning> run() {
    for (const auto step : {&FeedCellTest::begin, &FeedCellTest::follow, &FeedCellTest::keepSilent,
                            &FeedCellTest::move, &FeedCellTest::end, &FeedCellTest::moveAgain}) {
      if (Result<void> done = (this->*step)(); !done) {
        if (done.error().code == StreamError::Cancelled) {
          (void)set(Wanted, FeedCell::kHold);  // whatever moves stands
        }
        return base::fail(done.error());
      }
    }
    if (m_foreign) {
      add("only-this-client", false,
          fmt::format("Another client has written {:g} into R{}, the feed cell. Reset the control "
                      "and find out who it is.",
                      *m_foreign, m_plan.firstCell + static_cast<int>(Wanted)));
    } else {
      add("only-this-client", true, "Nobody else has written the feed cell.");
    }
    return std::move(m_result);
  }

 private:
  [[nodiscard]] Variable cell(TestCell which) const {
    return ProgramTest::cell(static_cast<int>(which));
  }
  Result<void> set(TestCell which, double value) {
    return ProgramTest::set(static_cast<int>(which), value);
  }

  /// One look at the cells.
  struct Look {
    double acts = 0.0;
    double done = 0.0;
    double moved = 0.0;
    double late = 0.0;
    double moving = 0.0;
    double step = 0.0;
  };

  void add(const char* name, bool passed, std::string message) {
    m_result.checks.push_back({name, passed, std::move(message)});
  }
  [[nodiscard]] bool goesOn() const {
    return !m_foreign && (m_result.checks.empty() || m_result.passed());
  }

  Result<void> want(double percent) {
    m_wanted = percent;
    return set(Wanted, percent);
  }

  /// Gives a sign of life, waits a little, and looks.
  Result<Look> look() {
    m_beats += 1.0;
    Result<void> on = proceed(m_step);
    on = on ? set(Beat, m_beats) : on;
    if (!on) {
      return base::fail(on.error());
    }
    pause();
    const std::array<Variable, 7> watched{cell(Wanted), cell(Acts),   cell(Done), cell(Moved),
                                          cell(Late),   cell(Moving), cell(Step)};
    const auto seen = numbers(watched);
    if (!seen) {
      return base::fail(seen.error());
    }
    if ((*seen)[0] != m_wanted) {
      m_foreign = (*seen)[0];
    }
    return Look{(*seen)[1], (*seen)[2], (*seen)[3], (*seen)[4], (*seen)[5], (*seen)[6]};
  }

  /// Looks until `holds` is true of what is seen. @return nothing: it was not, in that time
  template <class Condition>
  Result<std::optional<Look>> await(Duration longest, Condition holds) {
    const Instant until = m_link.now() + longest;
    for (;;) {
      const Result<Look> seen = look();
      if (!seen) {
        return base::fail(seen.error());
      }
      if (holds(*seen)) {
        return *seen;
      }
      if (m_foreign || m_link.now() >= until) {
        return std::nullopt;
      }
    }
  }

  Result<void> start(CommissioningStep step) {
    return awaitStart(step, static_cast<int>(Layout), layoutOf(m_feedPlan), feedTestFileName());
  }

  Result<void> begin() {
    Result<void> done = requireReset();
    done = done
               ? transfer(feedTestFileName(), feedTestProgram(m_feedPlan), static_cast<int>(Layout))
               : done;
    done = done ? set(Round, 1.0) : done;
    done = done ? start(CommissioningStep::CycleStart) : done;
    m_step = CommissioningStep::Running;
    return done;
  }

  Result<void> follow() {
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
      if (!*followed || *other || m_foreign) {
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
    const Variable acts = cell(Acts);
    const auto silent = numbers({&acts, 1});
    if (!silent) {
      return base::fail(silent.error());
    }
    const auto back =
        await(kFollows, [](const Look& seen) { return seen.acts == FeedCell::kProgrammed; });
    if (!back) {
      return base::fail(back.error());
    }
    add("silence-holds", silent->front() == FeedCell::kHold && back->has_value(),
        fmt::format("Without a sign of the client the override became {:g}; it came back with the "
                    "next one.",
                    silent->front()));
    return {};
  }

  [[nodiscard]] Duration patience() const {
    return kPatience * m_feedPlan.move->duration() + kFollows;
  }

  /// Commands the next move. @return cycles that it took; nothing: it did not come to its end
  Result<std::optional<double>> drive(double percent) {
    if (Result<void> done = want(percent); !done) {
      return base::fail(done.error());
    }
    m_command += 1.0;
    if (Result<void> done = set(Command, m_command); !done) {
      return base::fail(done.error());
    }
    return arrive();
  }

  Result<std::optional<double>> arrive() {
    const auto there =
        await(patience(), [this](const Look& seen) { return seen.done == m_command; });
    if (!there) {
      return base::fail(there.error());
    }
    return *there ? std::optional((*there)->moving) : std::nullopt;
  }

  static base::Error stuck() {
    return base::makeError(StreamError::StreamStalled,
                           "The axis did not come to the end of its move. Check the feed switch of "
                           "the machine, reset the control and start again.");
  }

  Result<void> move() {
    if (!m_feedPlan.move || !goesOn()) {
      return {};
    }
    m_result.move = m_feedPlan.move;
    const auto whole = drive(FeedCell::kProgrammed);
    const auto half = whole && *whole ? drive(kHalf) : whole;
    if (!half) {
      return base::fail(half.error());
    }
    if (!*whole || !*half) {
      return m_foreign ? Result<void>() : base::fail(stuck());
    }
    m_wholeCycles = **whole;
    const double ratio = **half / std::max(1.0, m_wholeCycles);
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
      return seen.moving >= third && std::abs(seen.step) > kStandsMm;
    });
    if (!onTheWay) {
      return base::fail(onTheWay.error());
    }
    if (Result<void> held = want(FeedCell::kHold); !held) {
      return held;
    }
    const Instant from = m_link.now();
    const auto stood =
        await(kBrakes, [](const Look& seen) { return std::abs(seen.step) < kStandsMm; });
    if (!stood) {
      return base::fail(stood.error());
    }
    m_result.braking = m_link.now() - from;
    const bool isOnTheWay = *onTheWay && *stood && (*stood)->done != m_command;
    add("path-held", isOnTheWay,
        isOnTheWay ? fmt::format("With 0 the axis stood on its way, {:.0f} ms after the answer of "
                                 "the control at the latest.",
                                 base::toMilliseconds(m_result.braking))
                   : std::string("With 0 the axis did not stand on its way within 3 s."));
    if (isOnTheWay) {
      add("held-at-once", (*stood)->late <= kLateCyclesMax,
          fmt::format("The main run saw the axis at full speed for {:g} cycles after 0 was wanted.",
                      (*stood)->late));
      if (Result<void> watched = watchStanding(); !watched) {
        return watched;
      }
    }
    return m_foreign ? Result<void>() : goBack();
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
    const auto back = forth && *forth ? drive(kHalf) : forth;
    if (!back) {
      return base::fail(back.error());
    }
    return *back || m_foreign ? Result<void>() : base::fail(stuck());
  }

  /// The program ends at 50 %: whether that ends with it shows afterwards.
  Result<void> end() {
    if (m_foreign) {
      return set(Command, kEnd);  // whatever moves stands as soon as the client is silent
    }
    Result<void> done = want(kHalf);
    done = done ? set(Command, kEnd) : done;
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
    if (!m_feedPlan.move || !goesOn()) {
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
    const double ratio = *forth ? **forth / std::max(1.0, m_wholeCycles) : 0.0;
    add("taken-back", *back && ratio <= kSameFactor && ratio * kSameFactor >= 1.0,
        *back ? fmt::format("In the next program, without a feed cell, the move took {:.2f} times "
                            "as long.",
                            ratio)
              : std::string("In the next program, without a feed cell, the axis did not come to "
                            "the end of its move: reset the control."));
    if (!*back) {
      return {};
    }
    done = set(Command, kEnd);
    return done ? awaitEnd(m_step, kEnds) : done;
  }

  const FeedTestPlan& m_feedPlan;
  CommissioningStep m_step = CommissioningStep::Running;
  double m_wanted = FeedCell::kProgrammed;
  double m_beats = 0.0;
  double m_command = 0.0;
  double m_wholeCycles = 0.0;
  std::optional<double> m_foreign;
  FeedCommissioning m_result;
};

/// The blocks that watch the set point of the axis in the main run.
std::vector<std::string> watchingBlocks(char axis, const std::function<std::string(TestCell)>& r) {
  using enum TestCell;
  const auto text = [&](TestAction action, const std::string& condition, const std::string& done) {
    return fmt::format("ID={} {}{}", static_cast<int>(action),
                       condition.empty() ? "" : "WHENEVER " + condition + " ", "DO " + done);
  };
  const std::string moves = fmt::format("(${0}>{1:.5f}) OR (${0}<-{1:.5f})", r(Step), kStandsMm);
  return {
      text(TakeStep, "", fmt::format("${}=$AA_IM[{}]-${}", r(Step), axis, r(Place))),
      text(TakePlace, "", fmt::format("${}=$AA_IM[{}]", r(Place), axis)),
      text(TakeReference, fmt::format("(${}>0)", r(Wanted)),
           fmt::format("${0}=${1}*${1} ${2}=0", r(Reference), r(Step), r(Late))),
      text(CountLate,
           fmt::format("(${0}<=0) AND (${1}>0) AND (${2}*${2}>={3:g}*${1})", r(Wanted),
                       r(Reference), r(Step), kUndiminished),
           fmt::format("${0}=${0}+1", r(Late))),
      text(CountMoved, fmt::format("(${}>0) AND ({})", r(Stands), moves),
           fmt::format("${0}=${0}+1", r(Moved))),
      text(CountMoving, moves, fmt::format("${0}=${0}+1", r(Moving))),
  };
}

}  // namespace

Duration AirMove::duration() const {
  return base::fromSeconds(
      feedMmPerMin > 0.0 ? std::abs(mm) / base::mmPerSFromMmPerMin(feedMmPerMin) : 0.0);
}

std::string describe(const AirMove& move) {
  return fmt::format("{} {:g} mm F{:g}", base::kAxisNames[static_cast<std::size_t>(move.axis)],
                     move.mm, move.feedMmPerMin);
}

Result<void> requireAirMove(const AirMove& move) {
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

std::string feedTestProgram(const FeedTestPlan& plan) {
  RIVULET_ASSERT(plan.firstCell >= 0);
  using enum TestCell;
  const auto number = [&plan](TestCell which) { return plan.firstCell + static_cast<int>(which); };
  const auto r = [&number](TestCell which) { return fmt::format("R{}", number(which)); };
  templates::CellMap cells;
  cells.overrideWanted = number(Wanted);
  cells.overrideActs = number(Acts);
  cells.heartbeat = number(Beat);
  cells.silenceLimitS = templates::kSilenceLimitS;
  const char axis = plan.move ? base::kAxisNames[static_cast<std::size_t>(plan.move->axis)] : 'X';
  std::string text;
  const auto line = [&text](const std::string& block) { text += block + '\n'; };
  line("; RIVULET TEST OF THE FEED CELL");
  line(plan.move
           ? fmt::format("; MOVES {0} BY {1:g} MM AND BACK AT F{2:g}, THREE TIMES IN TWO STARTS",
                         axis, plan.move->mm, plan.move->feedMmPerMin)
           : "; MOVES NO AXIS");
  line("; Do not edit: the client relies on every line.");
  line("; Does the path obey the override that synchronized actions make of an R-parameter?");
  line("DEF INT RIV_TURN");
  line("DEF REAL RIV_SIGN");
  for (const TestCell which :
       {Wanted, Acts, Beat, Command, Done, Stands, Moved, Late, Moving, Step, Place, Reference}) {
    line(r(which) + "=0");
  }
  line("RIV_TURN=0");
  line("RIV_SIGN=1");
  line("G90 G94 G64 G710 DIAMOF G40");
  line("STOPRE");
  line(fmt::format("IF {}>1 GOTOF RIV_WATCH", r(Round)));
  for (const std::string& block : templates::feedCellBlocks(cells)) {
    line(block);
  }
  line("RIV_WATCH:");
  for (const std::string& block : watchingBlocks(axis, r)) {
    line(block);
  }
  line(fmt::format("{}={}", r(Layout), layoutOf(plan)));
  line("RIV_NEXT:");
  line("STOPRE");
  line("RIV_TURN=RIV_TURN+1");
  line(fmt::format("IF RIV_TURN>{} GOTOF RIV_END", kIdlePassesMax));
  line("G4 F0.02");
  line(fmt::format("IF {}=={} GOTOB RIV_NEXT", r(Command), r(Done)));
  line(fmt::format("IF {}>={:g} GOTOF RIV_END", r(Command), kEnd));
  line("RIV_TURN=0");
  line(r(Moving) + "=0");
  if (plan.move) {
    line(
        fmt::format("G1 {}=IC({:g}*RIV_SIGN) F{:g}", axis, plan.move->mm, plan.move->feedMmPerMin));
    line("RIV_SIGN=-RIV_SIGN");
    line("STOPRE");
  }
  line(fmt::format("{}={}", r(Done), r(Command)));
  line("GOTOB RIV_NEXT");
  line("RIV_END:");
  line("M30");
  return text;
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
