// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <cmath>

#include "base/contract.h"
#include "base/text.h"
#include "templates/flexible_program.h"
#include "templates/methods/window.h"

namespace rivulet::templates {

namespace {

/// About 40 kB a window.
constexpr int kLoopPointsMax = 1000;

std::string subprogram(int file) {
  return fmt::format("RIVULET_W{}", file + 1);
}

/// To the digits of an F word, and never faster than commanded.
double roundedDown(double feedMmPerMin) {
  constexpr double kPerStep = 1e6;
  constexpr double kOfAStep = 1e-3;  // 299.9999999999 is 300
  return std::floor(feedMmPerMin * kPerStep + kOfAStep) / kPerStep;
}

}  // namespace

base::Result<void> FileTemplate::check(const TemplateParameters& parameters) const {
  if (parameters.hasOverlay()) {
    return base::fail(TemplateError::BadCorrection,
                      "Method file has no online correction and no lift: choose method window.");
  }
  if (parameters.hasFactor()) {
    return base::fail(TemplateError::BadFactor,
                      "Method file has no factor of the override: choose method window or credit.");
  }
  if (base::Result<void> windows = WindowedTemplate::check(parameters); !windows) {
    return windows;
  }
  if (parameters.pointsPerLoop > kLoopPointsMax) {
    return base::fail(TemplateError::DoesNotFit,
                      fmt::format("{} points per file: choose at most {}.",
                                  parameters.pointsPerLoop, kLoopPointsMax));
  }
  return {};
}

CellMap FileTemplate::cells(const TemplateParameters& parameters) const {
  CellMap cells = header(parameters);
  cells.pointSlots = 0;
  cells.files = parameters.windows;
  cells.asked = parameters.baseCell + WindowProtocol::Asked;
  return cells;
}

int FileTemplate::pointsMax(const TemplateParameters& parameters) const {
  const int needed = parameters.baseCell + WindowProtocol::HeaderCells;
  return needed <= parameters.rParameterCount ? kLoopPointsMax : 0;
}

int FileTemplate::longestWrite(const TemplateParameters& /*parameters*/) const {
  return 1;  // the number of a window; its content is a file
}

std::string FileTemplate::program(const TemplateParameters& parameters, const CellMap& cells,
                                  int layoutNumber) const {
  constexpr Wording kWording{"SUBPROGRAMS", "begun by this program"};
  Listing out;
  writeTitle(out, parameters, cells, kWording);
  out.line(
      "; FOR COMPARISON: each window is a subprogram that the client transfers. It is executed");
  out.line("; only after it has been delivered, and if it has its number and that of the run.");
  writeHeaderCells(out, cells, kWording);
  out.line("; R{}  the requested window, then the answer of its subprogram", cells.asked);
  out.line(";");
  out.line("DEF REAL RIV_OWN,RIV_BEAT,RIV_K");
  out.line("DEF INT RIV_L,RIV_IDLE");
  writeResets(out, cells);
  out.line("RIV_L=0 RIV_OWN=0 RIV_IDLE=0");
  out.line("G90 G94 G64");
  out.line("STOPRE");
  out.line("RIV_BEAT=R{}", cells.heartbeat);
  writeFeedCell(out, cells);
  out.line("R{}={}", cells.layout, layoutNumber);
  writeWaiting(out, cells);
  out.line("RIV_TAKE:");
  out.line("RIV_IDLE=0 RIV_L=RIV_L+1");
  out.line("R{}=RIV_L R{}=RIV_L", cells.latched, cells.asked);
  for (int file = 1; file < cells.files; ++file) {
    out.line("IF (RIV_L-1) MOD {}=={} GOTOF RIV_FILE{}", cells.files, file, file + 1);
  }
  for (int file = 0; file < cells.files; ++file) {
    if (file > 0) {
      out.line("RIV_FILE{}:", file + 1);
    }
    out.line("CALL \"{}\"", subprogram(file));
    if (file + 1 < cells.files) {
      out.line("GOTOF RIV_ANSWER");
    }
  }
  // 0: more windows follow, 1: it was the last; see `WindowProtocol::fileAnswer`.
  out.line("RIV_ANSWER:");
  out.line("RIV_K=-R{}-2*RIV_L", cells.asked);
  out.line("IF RIV_K==0 GOTOB RIV_NEXT");
  out.line("STOPRE");
  out.line("IF RIV_K<>1 GOTOF RIV_DAMAGED");
  out.line("R{}=RIV_L R{}={}", cells.executed, cells.state, static_cast<int>(WindowState::Done));
  out.line("M30");
  writeEnd(out, cells, "RIV_STOPPED", WindowState::Stopped, true);
  writeEnd(out, cells, "RIV_DAMAGED", WindowState::Damaged, true);
  writeEnd(out, cells, "RIV_LOST", WindowState::Abandoned, true);
  return out.take();
}

std::string windowFileText(const CellMap& cells, const WindowFile& window) {
  const std::string letters = lettersOf(cells);
  RIVULET_ASSERT(cells.files > 0 && !window.coordinates.empty());
  const std::size_t count = window.motions.size();
  RIVULET_ASSERT(window.coordinates.size() == count * letters.size());
  Listing out;
  out.line("; RIVULET: WINDOW {} OF RUN {}, {} POINTS. REPLACED DURING THE RUN", window.number,
           window.run, count);
  out.line("IF (R{}<>{}) OR (R{}<>{}) GOTOF RIV_END", cells.asked, window.number, cells.owner,
           window.run);
  // A file that has been cut off has no such label: the control stops before anything moves.
  out.line("GOTOF RIV_WHOLE");
  out.line("RIV_GO:");
  out.line("R{}={}", cells.asked,
           WindowProtocol::fileAnswer(static_cast<long long>(window.number), window.isLast));
  std::size_t next = 0;
  double feedMmPerMin = 0.0;
  for (std::size_t point = 0; point < count; ++point) {
    std::string words;
    for (const char letter : letters) {
      words += fmt::format(" {}{:.6f}", letter, window.coordinates[next++]);
    }
    const WindowFile::Motion& motion = window.motions[point];
    if (motion.isRapid) {
      out.line("G0{}", words);
      continue;
    }
    const bool isSame = feedMmPerMin == motion.feedMmPerMin;
    feedMmPerMin = motion.feedMmPerMin;
    out.line("G1{}{}", words,
             isSame ? "" : fmt::format(" F{}", base::formatFixed(roundedDown(feedMmPerMin), 6)));
  }
  out.line("RIV_END:");
  out.line("M17");
  out.line("RIV_WHOLE:");
  out.line("GOTOB RIV_GO");
  return out.take();
}

std::string windowFileName(int file) {
  return subprogram(file) + ".SPF";
}

}  // namespace rivulet::templates
