// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include "templates/feed_cell.h"
#include "templates/methods/subprogram.h"

namespace rivulet::templates {

namespace {

/// Passes of the loop that waits while the axes move, before the program stops to look: minutes.
/// Only a control that does not show new values without a stop reaches it.
constexpr int kAskingPassesMax = 100'000;
/// Passes in which no block was left to execute, before the program stops to look. The stop also
/// makes the control execute a block that it holds back until it knows the next one.
constexpr int kDryPassesMax = 25;

/// By what is left of a window, in blocks, of as many as it has at most. A control that does not
/// count the block in motion slows down further, and no control below the least.
std::string slowPercent(int points) {
  constexpr int kLeast = WindowProtocol::kSlowestPercent;
  return fmt::format("{}+{}*ABS($AC_IPO_BUF-$AC_PATHN)/{}", kLeast, 100 - kLeast, points);
}

}  // namespace

std::unique_ptr<MethodTemplate> CreditTemplate::asSubprogram(std::string name) const {
  return std::make_unique<SubprogramTemplate<CreditTemplate>>(std::move(name));
}

std::string CreditTemplate::nameSuffix(const TemplateParameters& parameters) const {
  return WindowTemplate::nameSuffix(parameters) +
         fmt::format("A{}{}", parameters.windowsAhead, parameters.slowDown ? "" : "F");
}

void CreditTemplate::writeNotes(Listing& out, const CreditSettings& settings) const {
  out.line("; EXPERIMENTAL: no stop between windows. The program checks repeatedly while the axes");
  out.line("; move, and relies on a control that reads R-parameters each time it passes a block.");
  out.line("; At most {} windows are copied but not executed: as many are executed after a stop.",
           settings.windowsAhead);
}

void CreditTemplate::writeSlowDown(Listing& out, const CreditSettings& settings,
                                   const CellMap& cells) const {
  if (settings.slowDown) {
    out.line("; Slower while nothing is left after the window in motion, the less is left of it.");
    out.line("{}", feedLimitBlock(cells, ActionNumber::kSlow,
                                  fmt::format("($R{}-$R{})<2", cells.latched, cells.executed),
                                  slowPercent(cells.pointsPerLoop)));
  }
}

/// Waits for the next window while earlier ones are in motion. Nothing here goes to the main run,
/// so nothing stops the axes.
void CreditTemplate::writeAsking(Listing& out, const CreditSettings& settings,
                                 const CellMap& cells) const {
  out.line("RIV_MORE:");
  out.line("RIV_TURN=0 RIV_DRY=0");
  out.line("RIV_ASK:");
  out.line("IF R{}>{} GOTOF RIV_STOPPED", cells.run, WindowProtocol::kRun);
  out.line("IF (R{}>{}) AND (R{}>RIV_L) AND (R{}<=RIV_L+{}) AND (RIV_L-R{}<{}) GOTOF RIV_TAKE",
           cells.run, WindowProtocol::kHold, cells.delivered, cells.delivered, cells.windows,
           cells.executed, settings.windowsAhead);
  out.line("RIV_TURN=RIV_TURN+1");
  out.line("IF $AC_IPO_BUF>0 GOTOF RIV_FED");
  out.line("RIV_DRY=RIV_DRY+1");
  out.line("RIV_FED:");
  out.line("IF (RIV_TURN<{}) AND (RIV_DRY<{}) GOTOB RIV_ASK", kAskingPassesMax, kDryPassesMax);
  out.line("GOTOB RIV_NEXT");
}

/// The main run writes it with the first block of this window: the windows before it have been
/// executed.
void CreditTemplate::writeTaken(Listing& out, const CellMap& cells) const {
  out.line("DO $R{}=R{}-1", cells.executed, cells.latched);
}

void CreditTemplate::writeLastTaken(Listing& out, const CreditSettings& settings) const {
  if (settings.slowDown) {
    out.line("IF RIV_K>0 GOTOF RIV_PART");
    out.line("CANCEL({})", ActionNumber::kSlow);
    out.line("RIV_PART:");
  }
}

}  // namespace rivulet::templates
