// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include "base/axes.h"
#include "base/contract.h"
#include "base/hash.h"
#include "streaming/run/feed_order.h"
#include "streaming/setup/feed_test_cells.h"
#include "streaming/setup/program_test.h"
#include "templates/feed_cell.h"
#include "templates/overlay.h"

namespace rivulet::streaming {

namespace {

/// Synchronized actions of the test: after those of the feed cell.
enum TestAction {
  TakeStep = 20,
  TakePlace,
  TakeReference,
  CountLate,
  CountMoved,
  CountMoving,
  TakeLifted,
  CountInAir
};
static_assert(TakeStep > templates::ActionNumber::kLowered);

/// Passes of the waiting loop, 20 ms or more each, before the program ends without a client.
constexpr int kIdlePassesMax = 1500;

/// A step counts as undiminished by its square.
constexpr double kUndiminished = 0.9999;

/// The blocks that watch the set point of the axis in the main run.
std::vector<std::string> watchingBlocks(char axis, bool lifts,
                                        const std::function<std::string(TestCell)>& r) {
  using enum TestCell;
  const auto text = [&](TestAction action, const std::string& condition, const std::string& done) {
    return fmt::format("ID={} {}{}", static_cast<int>(action),
                       condition.empty() ? "" : "WHENEVER " + condition + " ", "DO " + done);
  };
  const std::string moves =
      fmt::format("(${0}>{1:.5f}) OR (${0}<-{1:.5f})", r(Step), kStepStandsMm);
  std::vector<std::string> blocks{
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
  if (lifts) {
    blocks.push_back(text(TakeLifted, "", fmt::format("${}=$AA_OFF_VAL[Z]", r(Lifted))));
    blocks.push_back(text(CountInAir,
                          fmt::format("(${}>{}) AND ({})", r(Lifted), kLoweredMm, moves),
                          fmt::format("${0}=${0}+1", r(InAir))));
  }
  return blocks;
}

/// The overlay of Z, where it can lift so far, and what the control allows.
std::vector<std::string> liftBlocks(const templates::CellMap& cells, double liftMm,
                                    const std::string& limit) {
  std::vector<std::string> blocks{
      fmt::format("{}={:g}", limit, kOverlayAddsUp),
      fmt::format("IF {} GOTOF RIV_FIT", templates::overlayIntegrates(cells)),
      fmt::format("{}={:g}", limit, kOverlayThere),
      fmt::format("IF {} GOTOF RIV_FIT", templates::overlayThere(cells)),
      fmt::format("{}=$SA_AA_OFF_LIMIT[Z]", limit),
      fmt::format("IF {}<{:.3f} GOTOF RIV_FIT", limit, liftMm),
  };
  for (std::string& block : templates::overlayBlocks(cells, liftMm)) {
    blocks.push_back(std::move(block));
  }
  blocks.emplace_back("RIV_FIT:");
  return blocks;
}

}  // namespace

int layoutOf(const FeedTestPlan& plan) {
  constexpr std::uint64_t kSpread = 1'000'000;
  const AirMove move = plan.move.value_or(AirMove{-1, 0.0, 0.0});
  const std::uint64_t hash = base::hashOf(fmt::format("{} {} {} {} {}", plan.firstCell, move.axis,
                                                      move.mm, move.feedMmPerMin, move.liftMm));
  return kTestLayout + 1 + static_cast<int>(hash % kSpread);
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
  const double liftMm = liftMmOf(plan);
  if (liftMm > 0.0) {
    cells.lifts = true;
    cells.correction.back() = number(Lift);
  }
  const char axis = plan.move ? base::kAxisNames[static_cast<std::size_t>(plan.move->axis)] : 'X';
  std::string text;
  const auto line = [&text](const std::string& block) { text += block + '\n'; };
  line("; RIVULET TEST OF THE FEED CELL");
  line(plan.move
           ? fmt::format("; MOVES {0} BY {1:g} MM AND BACK AT F{2:g}, THREE TIMES IN TWO STARTS",
                         axis, plan.move->mm, plan.move->feedMmPerMin)
           : "; MOVES NO AXIS");
  if (liftMm > 0.0) {
    line(fmt::format("; LIFTS Z BY {:g} MM WHILE THE AXIS IS HELD", liftMm));
  }
  line("; Do not edit: the client relies on every line.");
  line("; Does the path obey the override that synchronized actions make of an R-parameter?");
  line("DEF INT RIV_TURN");
  line("DEF REAL RIV_SIGN");
  for (const TestCell which : {Wanted, Acts, Beat, Command, Done, Stands, Moved, Late, Moving, Step,
                               Place, Reference, Lift, Lifted, LiftLimit, InAir}) {
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
  if (liftMm > 0.0) {
    for (const std::string& block : liftBlocks(cells, liftMm, r(LiftLimit))) {
      line(block);
    }
  }
  line("RIV_WATCH:");
  for (const std::string& block : watchingBlocks(axis, liftMm > 0.0, r)) {
    line(block);
  }
  line(fmt::format("{}={}", r(Layout), layoutOf(plan)));
  line("RIV_NEXT:");
  line("STOPRE");
  line("RIV_TURN=RIV_TURN+1");
  line(fmt::format("IF RIV_TURN>{} GOTOF RIV_END", kIdlePassesMax));
  line("G4 F0.02");
  line(fmt::format("IF {}=={} GOTOB RIV_NEXT", r(Command), r(Done)));
  line(fmt::format("IF {}>={:g} GOTOF RIV_END", r(Command), kEndOfTest));
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

}  // namespace rivulet::streaming
