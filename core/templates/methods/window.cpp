// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/methods/window.h"

#include <algorithm>
#include <cmath>

#include "templates/feed_cell.h"
#include "templates/methods/subprogram.h"
#include "templates/overlay.h"

namespace rivulet::templates {

namespace {

/// Beyond any control; keeps the arithmetic of cells small.
constexpr int kRParametersMax = 1'000'000;
constexpr int kStrideMax = 100;
/// Characters of a block that unpacks: a control of this family takes 512.
constexpr std::size_t kUnpackingMax = 240;

/// Passes of 20 ms within which the overlay must be gone at the end.
constexpr int kOverlayPassesMax = 500;

/// No overlay may be active when the client reads the positions of the axes, and a control that
/// adds up values would drive the axes away.
void writeOverlayCheck(Listing& out, const WindowCells& cells) {
  out.line(
      "; Not if an overlay is active on the axes, or if the control adds overlays up (MD36750).");
  out.line("RIV_IDLE={}", static_cast<int>(WindowState::OverlayLeft));
  out.line("IF {} GOTOF RIV_UNFIT", overlayThere(cells));
  out.line("RIV_IDLE={}", static_cast<int>(WindowState::OverlayIntegrates));
  out.line("IF {} GOTOF RIV_UNFIT", overlayIntegrates(cells));
  out.line("RIV_IDLE=0");
}

/// Actions of the same numbers replace those that obeyed the client. The axes have reached the end
/// of the path before the program ends.
void writeOverlayBack(Listing& out, const CellMap& cells, int layoutNumber) {
  out.line("RIV_OFF:");
  for (const Corrected& axis : correctedAxes(cells)) {
    out.line("ID={} DO $AA_OFF[{}]=0", axis.action, axis.letter);
  }
  out.line("RIV_IDLE=0");
  out.line("RIV_BACK:");
  out.line("G4 F0.02");
  out.line("RIV_IDLE=RIV_IDLE+1");
  out.line("IF RIV_IDLE>{} GOTOF RIV_END", kOverlayPassesMax);
  out.line("IF {} GOTOB RIV_BACK", overlayThere(cells));
  out.line("G4 F0.2");
  out.line("RIV_END:");
  out.line("M30");
  out.line("RIV_UNFIT:");
  out.line("R{}=RIV_IDLE R{}={}", cells.state, cells.layout, layoutNumber);
  out.line("M30");
}

/// "G1 X=RIV_C[3] Y=RIV_C[4] F=RIV_F": from the program's own copy, never from the cells.
void writeCopiedPoint(Listing& out, const CellMap& cells, int place) {
  std::string words;
  int next = place * copiedPerPoint(cells);
  for (const char letter : lettersOf(cells)) {
    words += fmt::format("{}=RIV_C[{}] ", letter, next++);
  }
  out.line("G1 {}F={}", words, cells.feedPerPoint ? fmt::format("RIV_C[{}]", next) : "RIV_F");
}

double limitMmOf(const WindowSettings& settings) {
  return correctionSteps(settings) / 1000.0;
}

base::Result<void> checkCorrection(const TemplateParameters& parameters) {
  const double limitMm = parameters.correctionLimitMm;
  const double liftMm = parameters.liftMm;
  if (liftMm != 0.0 && limitMm != 0.0) {
    return base::fail(TemplateError::BadCorrection,
                      "The lift and the online correction need the same overlay: choose one.");
  }
  if (liftMm != 0.0 &&
      (!(liftMm > 0.0) || liftMm > kLiftMmMax || correctionSteps(parameters) == 0)) {
    return base::fail(
        TemplateError::BadCorrection,
        fmt::format("A lift of {} mm: choose 0.001 to {} mm, or 0 for none.", liftMm, kLiftMmMax));
  }
  if (limitMm == 0.0) {
    return {};
  }
  if (!(limitMm > 0.0) || limitMm > kCorrectionLimitMmMax || correctionSteps(parameters) == 0) {
    return base::fail(TemplateError::BadCorrection,
                      fmt::format("A limit of {} mm for the online correction: choose 0.001 to {} "
                                  "mm, or 0 for none.",
                                  limitMm, kCorrectionLimitMmMax));
  }
  if (parameters.axes == std::array{false, false, false}) {
    return base::fail(TemplateError::BadCorrection,
                      "Only X, Y and Z can be corrected online, but none of them is selected.");
  }
  return {};
}

}  // namespace

base::Result<void> WindowedTemplate::check(const TemplateParameters& parameters) const {
  if (parameters.windows < 1 || parameters.windows > WindowProtocol::kWindowsMax) {
    return base::fail(TemplateError::BadCells,
                      fmt::format("{} windows: choose 1 to {}.", parameters.windows,
                                  WindowProtocol::kWindowsMax));
  }
  if (parameters.windowsAhead < 1 || parameters.windowsAhead > WindowProtocol::kWindowsAheadMax) {
    return base::fail(TemplateError::BadCells,
                      fmt::format("{} windows ahead of the motion: choose 1 to {}.",
                                  parameters.windowsAhead, WindowProtocol::kWindowsAheadMax));
  }
  if (parameters.baseCell < 0 || parameters.baseCell > kRParametersMax) {
    return base::fail(TemplateError::BadCells,
                      fmt::format("The cells cannot begin at R{}.", parameters.baseCell));
  }
  if (!isSilenceLimit(parameters.silenceLimitS)) {
    return base::fail(
        TemplateError::BadCells,
        fmt::format("The axes cannot stand after {} s without a sign of the client: choose {} to "
                    "{} s, or 0 for not at all.",
                    parameters.silenceLimitS, kSilenceLimitSMin, kSilenceLimitSMax));
  }
  if (parameters.hasFactor() && !areFactorBounds(parameters.factorLeast, parameters.factorMost)) {
    return base::fail(
        TemplateError::BadFactor,
        fmt::format("A factor of the override from {} to {}: choose bounds from {} to {} with 1 "
                    "between them, as in 0.2 and 1.2.",
                    parameters.factorLeast, parameters.factorMost, kFactorMin, kFactorMax));
  }
  if (parameters.packed && parameters.slotStride != 0) {
    return base::fail(TemplateError::BadCells,
                      "Points that are packed have no stride: choose 0 for it, or do not pack.");
  }
  const int perPoint = cellsPerPoint(parameters);
  if (parameters.slotStride != 0 &&
      (parameters.slotStride < perPoint || parameters.slotStride > kStrideMax)) {
    return base::fail(
        TemplateError::BadCells,
        fmt::format("{} cells per point: choose {} to {}, or 0 for as many as needed.",
                    parameters.slotStride, perPoint, kStrideMax));
  }
  return {};
}

std::string WindowedTemplate::nameSuffix(const TemplateParameters& parameters) const {
  std::string name = fmt::format("X{}", parameters.windows);
  name += parameters.baseCell != 0 ? fmt::format("B{}", parameters.baseCell) : "";
  name += parameters.slotStride != 0 ? fmt::format("S{}", parameters.slotStride) : "";
  if (parameters.silenceLimitS != kSilenceLimitS) {
    name += fmt::format("T{}", std::lround(1000.0 * parameters.silenceLimitS));
  }
  if (parameters.hasFactor()) {
    name += fmt::format("Q{}Q{}", std::lround(1000.0 * parameters.factorLeast),
                        std::lround(1000.0 * parameters.factorMost));
  }
  return name;
}

CellMap WindowedTemplate::header(const TemplateParameters& parameters) const {
  const int first = parameters.baseCell;
  CellMap cells;
  cells.axes = parameters.axes;
  cells.rotaryAxes = parameters.rotaryAxes;
  cells.pointsPerLoop = parameters.pointsPerLoop;
  cells.run = first + WindowProtocol::Run;
  cells.delivered = first + WindowProtocol::Delivered;
  cells.latched = first + WindowProtocol::Latched;
  cells.executed = first + WindowProtocol::Executed;
  cells.layout = first + WindowProtocol::Layout;
  cells.state = first + WindowProtocol::State;
  cells.client = first + WindowProtocol::Client;
  cells.owner = first + WindowProtocol::Owner;
  cells.heartbeat = first + WindowProtocol::Heartbeat;
  cells.overrideWanted = first + WindowProtocol::Override;
  cells.overrideActs = first + WindowProtocol::OverrideActs;
  cells.silenceLimitS = parameters.silenceLimitS;
  // Not used here; `last` and the lists of cells must not find those of [P1].
  cells.signal = cells.stop = cells.feed = cells.run;
  cells.slotStride = parameters.slotStride > 0 ? parameters.slotStride : cellsPerPoint(parameters);
  cells.windows = parameters.windows;
  cells.windowStride = WindowProtocol::WindowCells + cellsOfFirstPoint(parameters) +
                       cells.slotStride * parameters.pointsPerLoop;
  cells.firstSlot = first + WindowProtocol::HeaderCells + WindowProtocol::WindowCells;
  cells.cleared = {cells.layout, cells.run};
  cells.endCell = cells.run;
  cells.endValue = WindowProtocol::kEnd;
  return cells;
}

void WindowedTemplate::takeFactor(CellMap& cells, const TemplateParameters& parameters) {
  if (parameters.hasFactor()) {
    cells.factor = cells.last() + 1;
    cells.factorLeast = parameters.factorLeast;
    cells.factorMost = parameters.factorMost;
  }
}

void WindowedTemplate::writeTitle(Listing& out, const TemplateParameters& parameters,
                                  const CellMap& cells, const Wording& wording) const {
  const int count = cells.pointsPerLoop;
  out.line("; RIVULET FLEXIBLE PROGRAM: MOVES TO THE POINTS IN {}, WINDOW BY WINDOW",
           wording.source);
  out.line("; Do not edit: the client relies on every line. Axes move only while it runs.");
  out.line("; Method {}, {} point{} per window, {} window{}, axes {}",
           base::methodName(parameters.method), count, plural(count), cells.windows,
           plural(cells.windows), fmt::join(lettersOf(cells), " "));
  if (base::any(cells.rotaryAxes)) {
    out.line("; Rotary axes in degrees; if only they turn, the feed is in deg/min.");
  }
}

void WindowedTemplate::writeHeaderCells(Listing& out, const CellMap& cells,
                                        const Wording& wording) const {
  out.line(";");
  out.line("; R{}  run, by the client: {} hold, {} run, {} end before the next window", cells.run,
           WindowProtocol::kHold, WindowProtocol::kRun, WindowProtocol::kEnd);
  out.line("; R{}  windows delivered, written by the client last of each window", cells.delivered);
  out.line("; R{}  windows {}", cells.latched, wording.latched);
  out.line("; R{}  windows executed to the end", cells.executed);
  out.line("; R{}  number of this program's layout, checked by the client", cells.layout);
  out.line("; R{}  state: 0 runs, 1 done, 2 stopped, 3 window damaged, 4 client silent{}",
           cells.state, cells.corrects() ? "," : "");
  if (cells.corrects()) {
    out.line("; 5 not begun: overlay still active, 6 not begun: overlay adds up");
  }
  out.line("; R{}  number of the client's run, R{} number of the run this program obeys",
           cells.client, cells.owner);
  out.line("; R{}  heartbeat of the client{}", cells.heartbeat,
           watchesClient(cells)
               ? fmt::format(": unchanged for {:g} s, the override is 0", cells.silenceLimitS)
               : std::string());
  if (cells.hasFeedCell()) {
    out.line("; R{}  path override in %, by the client: 0 holds at once; R{} the override in force",
             cells.overrideWanted, cells.overrideActs);
  }
  if (cells.hasFactor()) {
    out.line(
        "; R{}  factor of it, by the client: {} to {}, anything else holds; at most {:g} % in all",
        cells.factor, cells.factorLeast, cells.factorMost, FeedCell::kProductMax);
  }
}

void WindowedTemplate::writeResets(Listing& out, const CellMap& cells) const {
  // The layout number comes later: a client that sees it knows that these are done.
  out.line("R{}=0 R{}=0 R{}=0 R{}=0", cells.run, cells.delivered, cells.latched, cells.executed);
  out.line("R{}=0 R{}=0 R{}=0", cells.state, cells.client, cells.owner);
  // Late requests of an earlier run may ask, deliver and run as well: what it has left in a window
  // must not match.
  std::string checks;
  const int inCells = cells.slotCount() > 0 ? cells.windows : 0;  // not those of method file
  for (int window = 0; window < inCells; ++window) {
    checks += fmt::format("{}R{}=0", checks.empty() ? "" : " ", cells.windowCheck(window));
  }
  if (!checks.empty()) {
    out.line("{}", checks);
  }
}

void WindowedTemplate::writeFeedCell(Listing& out, const CellMap& cells) const {
  for (const std::string& block : feedCellBlocks(cells)) {
    out.line("{}", block);
  }
}

void WindowedTemplate::writeWaiting(Listing& out, const CellMap& cells) const {
  // After this STOPRE the axes have stopped, and the client's values are read again.
  out.line("RIV_NEXT:");
  out.line("STOPRE");
  out.line("R{}=RIV_L R{}=RIV_L", cells.latched, cells.executed);
  writeLeaving(out, cells);
  out.line("IF R{}>{} GOTOF RIV_STOPPED", cells.run, WindowProtocol::kRun);
  out.line("IF (R{}>{}) AND (RIV_OWN>0) AND (R{}>RIV_L) AND (R{}<=RIV_L+{}) GOTOF RIV_TAKE",
           cells.run, WindowProtocol::kHold, cells.delivered, cells.delivered, cells.windows);
  out.line("IF R{}==RIV_BEAT GOTOF RIV_SILENT", cells.heartbeat);
  out.line("RIV_BEAT=R{} RIV_IDLE=0", cells.heartbeat);
  out.line("RIV_SILENT:");
  out.line("RIV_IDLE=RIV_IDLE+1");
  out.line("IF RIV_IDLE>{} GOTOF RIV_LOST", kSilentPassesMax);
  out.line("IF RIV_OWN>0 GOTOF RIV_PAUSE");
  out.line("RIV_OWN=R{}", cells.client);
  out.line("R{}=RIV_OWN", cells.owner);
  out.line("RIV_PAUSE:");
  out.line("G4 F0.02");
  out.line("GOTOB RIV_NEXT");
}

void WindowedTemplate::writeEnd(Listing& out, const CellMap& cells, std::string_view label,
                                WindowState state, bool stands) const {
  out.line("{}:", label);
  if (!stands) {
    out.line("STOPRE");
    out.line("R{}=RIV_L R{}={}", cells.executed, cells.state, static_cast<int>(state));
  } else {
    out.line("R{}={}", cells.state, static_cast<int>(state));
  }
  out.line("{}", cells.corrects() ? "GOTOF RIV_OFF" : endWord());
}

base::Result<void> WindowTemplate::check(const TemplateParameters& parameters) const {
  base::Result<void> windows = WindowedTemplate::check(parameters);
  return windows ? checkCorrection(parameters) : windows;
}

CellMap WindowTemplate::cells(const TemplateParameters& parameters) const {
  CellMap cells = header(parameters);
  cells.feedPerPoint = parameters.feedPerPoint;
  cells.packed = packingOf(parameters).has_value();
  cells.pointSlots = cells.windows * cells.pointsPerLoop;
  if (cells.pointSlots <= 0) {
    return cells;
  }
  const int slotEnd = cells.slotCells(cells.pointSlots - 1).back();
  if (parameters.liftMm > 0.0) {
    cells.lifts = true;
    cells.correction.back() = slotEnd + 1;
  } else if (correctionSteps(parameters) > 0) {
    int next = slotEnd + 1;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (parameters.axes[axis]) {
        cells.correction[axis] = next++;
      }
    }
  }
  takeFactor(cells, parameters);
  // The first window, between the free cell before it and the cell after it, if that is the run's
  // own; where slots have gaps, no further than to the first slot.
  const int first = cells.windowCount(0) - 1;
  const int firstSlotEnd = cells.slotCells(0).back();
  const int after = cells.windowCount(0) + cells.windowStride;
  const bool hasGaps = cells.slotStride > firstSlotEnd - cells.firstSlot + 1;
  cells.scratch = CellRange{first, hasGaps ? firstSlotEnd : cells.windows > 1 ? after : after - 1};
  return cells;
}

int WindowTemplate::pointsMax(const TemplateParameters& parameters) const {
  TemplateParameters one = parameters;
  one.pointsPerLoop = 1;
  one.windows = std::clamp(parameters.windows, 1, WindowProtocol::kWindowsMax);
  const CellMap smallest = cells(one);
  const auto corrections = static_cast<int>(std::count_if(
      smallest.correction.begin(), smallest.correction.end(), [](int cell) { return cell >= 0; }));
  const int beside = corrections + (smallest.hasFactor() ? 1 : 0);
  const int perWindow =
      (parameters.rParameterCount - beside - smallest.windowCount(0)) / one.windows -
      WindowProtocol::WindowCells - cellsOfFirstPoint(parameters);
  // The last cells of the last slot may stay unused where the stride leaves room.
  int fits = std::max(0, perWindow / smallest.slotStride);
  for (one.pointsPerLoop = fits + 1; cells(one).last() < parameters.rParameterCount;
       ++one.pointsPerLoop) {
    fits = one.pointsPerLoop;
  }
  return fits;
}

std::string WindowTemplate::nameSuffix(const TemplateParameters& parameters) const {
  const int steps = correctionSteps(parameters);
  return WindowedTemplate::nameSuffix(parameters) + (parameters.feedPerPoint ? "P" : "") +
         (packingOf(parameters) ? "D" : "") +
         (steps > 0 ? fmt::format("{}{}", parameters.liftMm > 0.0 ? 'L' : 'K', steps) : "");
}

int WindowTemplate::longestWrite(const TemplateParameters& parameters) const {
  return cellsPerPoint(parameters) * parameters.pointsPerLoop + cellsOfFirstPoint(parameters) +
         WindowProtocol::WindowCells;
}

std::unique_ptr<MethodTemplate> WindowTemplate::asSubprogram(std::string name) const {
  return std::make_unique<SubprogramTemplate<WindowTemplate>>(std::move(name));
}

std::string WindowTemplate::program(const TemplateParameters& parameters, const CellMap& cells,
                                    int layoutNumber) const {
  Listing out;
  writeHead(out);
  writeComments(out, parameters, cells);
  writeStart(out, parameters, cells, layoutNumber);
  writeWaiting(out, cells);
  writeAsking(out, parameters, cells);
  writeCopyAndCheck(out, cells);
  writeMotion(out, parameters, cells);
  out.line("STOPRE");
  out.line("R{}=RIV_L R{}={}", cells.executed, cells.state, static_cast<int>(WindowState::Done));
  writeDone(out, cells);
  out.line("{}", cells.corrects() ? "GOTOF RIV_OFF" : endWord());
  writeEnd(out, cells, "RIV_STOPPED", WindowState::Stopped, standsBetweenWindows());
  writeEnd(out, cells, "RIV_DAMAGED", WindowState::Damaged, standsBetweenWindows());
  writeEnd(out, cells, "RIV_LOST", WindowState::Abandoned, true);
  if (cells.corrects()) {
    writeOverlayBack(out, cells, layoutNumber);
  }
  return out.take();
}

void WindowTemplate::writeComments(Listing& out, const TemplateParameters& parameters,
                                   const CellMap& cells) const {
  constexpr Wording kWording{"R-PARAMETERS",
                             "copied by this program: their cells may be written again"};
  writeTitle(out, parameters, cells, kWording);
  if (cells.corrects()) {
    out.line("; Online correction: the values of the last cells are applied to the axes, also at");
    out.line("; standstill. Its motion is added to the feed. It is removed when the program ends.");
  }
  out.line(
      "; A window is executed only after its number has been delivered, and if its check number");
  out.line("; matches: if the client is late, the axes wait.");
  writeNotes(out, parameters);
  writeHeaderCells(out, cells, kWording);
  for (int window = 0; window < cells.windows; ++window) {
    out.line("; R{} R{} R{}  window {}: points (negative: the last window), {}, check",
             cells.windowCount(window), cells.windowFeed(window), cells.windowCheck(window),
             window + 1, cells.feedPerPoint ? "0" : "feed in mm/min");
    for (int place = 0; place < cells.pointsPerLoop; ++place) {
      const SlotText slot = slotText(cells, window * cells.pointsPerLoop + place);
      if (cells.packed && place > 0) {
        out.line("; {}  window {} point {}: {} from point 1, packed{}", slot.cells, window + 1,
                 place + 1, slot.axes, cells.feedPerPoint ? "; feed in mm/min" : "");
        continue;
      }
      out.line("; {}  window {} point {}: {}{}", slot.cells, window + 1, place + 1, slot.axes,
               cells.feedPerPoint ? " feed in mm/min" : "");
    }
  }
  for (const Corrected& axis : correctedAxes(cells)) {
    out.line("; R{}  online correction of {} in mm, by the client; obeyed up to {:.3f}", axis.cell,
             axis.letter, limitMmOf(parameters));
  }
  out.line(";");
}

void WindowTemplate::writeStart(Listing& out, const TemplateParameters& parameters,
                                const CellMap& cells, int layoutNumber) const {
  // Everything that the program relies on is in its own variables, which no client can write.
  out.line("DEF REAL RIV_C[{}],RIV_F,RIV_K,RIV_S,RIV_OWN,RIV_BEAT",
           cells.pointsPerLoop * copiedPerPoint(cells));
  if (cells.packed) {
    out.line("DEF REAL RIV_P[{}]", std::max(1, cells.pointsPerLoop - 1));
  }
  out.line("DEF INT RIV_L,RIV_N,RIV_B,RIV_IDLE{}", variables());
  writeResets(out, cells);
  out.line("RIV_L=0 RIV_OWN=0 RIV_B={} RIV_IDLE=0", cells.windowCount(0));
  if (cells.corrects()) {
    std::string uncorrected;
    for (const Corrected& axis : correctedAxes(cells)) {
      uncorrected += fmt::format("{}R{}=0", uncorrected.empty() ? "" : " ", axis.cell);
    }
    out.line("{}", uncorrected);
  }
  out.line("G90 G94 G64");
  out.line("STOPRE");
  out.line("RIV_BEAT=R{}", cells.heartbeat);
  writeFeedCell(out, cells);
  if (cells.corrects()) {
    writeOverlayCheck(out, cells);
    for (const std::string& block : overlayBlocks(cells, limitMmOf(parameters))) {
      out.line("{}", block);
    }
  }
  writeSlowDown(out, parameters, cells);
  out.line("R{}={}", cells.layout, layoutNumber);
  writeReady(out, cells);
}

/// RIV_C has the coordinates of each point, and its feed, whatever the cells are.
void WindowTemplate::writeCopies(Listing& out, const CellMap& cells) const {
  const int perPoint = copiedPerPoint(cells);
  std::vector<std::string> copies;
  for (int place = 0; place < cells.pointsPerLoop; ++place) {
    const std::vector<int> slot = cells.slotCells(place);
    const bool isPacked = cells.packed && place > 0;
    for (std::size_t i = 0; i < slot.size(); ++i) {
      const int offset = slot[i] - cells.windowCount(0);
      const int value = isPacked && i > 0 ? perPoint - 1 : static_cast<int>(i);
      copies.push_back(isPacked && i == 0 ? fmt::format("RIV_P[{}]=R[RIV_B+{}]", place - 1, offset)
                                          : fmt::format("RIV_C[{}]=R[RIV_B+{}]",
                                                        place * perPoint + value, offset));
    }
  }
  out.pieces("", copies, " ");
  if (cells.packed) {
    writeUnpacking(out, cells);
  }
}

/// One axis after the other, each of all points: the assignments of a block do not need each other.
void WindowTemplate::writeUnpacking(Listing& out, const CellMap& cells) const {
  const int axes = cells.axisCount();
  const int perPoint = copiedPerPoint(cells);
  const base::Packing packing(axes);
  for (int axis = 0; axis < axes; ++axis) {
    const bool isLast = axis + 1 == axes;
    std::vector<std::string> coordinates;
    std::vector<std::string> rests;
    for (int place = 1; place < cells.pointsPerLoop; ++place) {
      const std::string rest = fmt::format("RIV_P[{}]", place - 1);
      coordinates.push_back(fmt::format("RIV_C[{}]=RIV_C[{}]+({}-{})/{}", place * perPoint + axis,
                                        axis, isLast ? rest : "TRUNC(" + rest + ")",
                                        packing.middle(), base::Packing::kStepsPerUnit));
      rests.push_back(fmt::format("{0}=({0}-TRUNC({0}))*{1}", rest, packing.base()));
    }
    out.pieces("", coordinates, " ", kUnpackingMax);
    if (!isLast) {
      out.pieces("", rests, " ", kUnpackingMax);
    }
  }
}

void WindowTemplate::writeCopyAndCheck(Listing& out, const CellMap& cells) const {
  // First a copy, then the check of the copy, then the motion from the copy: whatever is written
  // meanwhile, and by whom, the axes move to the positions sent by the client of this run.
  const int perPoint = copiedPerPoint(cells);
  out.line("RIV_TAKE:");
  out.line("RIV_IDLE=0 RIV_K=R[RIV_B] RIV_F=R[RIV_B+{}] RIV_S=R[RIV_B+{}]",
           static_cast<int>(WindowProtocol::Feed), static_cast<int>(WindowProtocol::Check));
  std::vector<std::string> terms;
  for (int number = 0; number < cells.pointsPerLoop * perPoint; ++number) {
    terms.push_back(fmt::format("{:.6f}*RIV_C[{}]", WindowProtocol::checkFactor(number), number));
  }
  writeCopies(out, cells);
  out.line("RIV_S=RIV_OWN+{}*(RIV_L+1)+{}*RIV_K+{}*RIV_F-RIV_S", WindowProtocol::kCheckNumber,
           WindowProtocol::kCheckCount, WindowProtocol::kCheckFeed);
  out.pieces("RIV_S=RIV_S+", terms, "+");
  out.line("IF ABS(RIV_S)>0.000001 GOTOF RIV_DAMAGED");
  out.line("RIV_L=RIV_L+1 RIV_N=ABS(RIV_K)");
  out.line("R{}=RIV_L", cells.latched);
  if (cells.windows > 1) {
    out.line("RIV_B=RIV_B+{}", cells.windowStride);
    out.line("IF RIV_B<={} GOTOF RIV_MOVE", cells.windowCount(cells.windows - 1));
    out.line("RIV_B={}", cells.windowCount(0));
    out.line("RIV_MOVE:");
  }
}

void WindowTemplate::writeMotion(Listing& out, const TemplateParameters& parameters,
                                 const CellMap& cells) const {
  const int count = cells.pointsPerLoop;
  out.line("IF RIV_K<{} GOTOF RIV_SHORT", count);
  writeTaken(out, cells);
  for (int place = 0; place < count; ++place) {
    writeCopiedPoint(out, cells, place);
  }
  out.line("GOTOB {}", next());
  out.line("RIV_SHORT:");
  writeLastTaken(out, parameters);
  writeTaken(out, cells);
  for (int place = 0; place < count; ++place) {
    writeCopiedPoint(out, cells, place);
    if (place + 1 < count) {
      out.line("IF RIV_N<{} GOTOF RIV_TAIL", place + 2);
    }
  }
  out.line("RIV_TAIL:");
  out.line("IF RIV_K>0 GOTOB {}", next());
}

}  // namespace rivulet::templates
