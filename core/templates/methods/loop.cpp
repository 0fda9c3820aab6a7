// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/methods/loop.h"

namespace rivulet::templates {

namespace {

constexpr int kPaperFirstSlot = 11;
constexpr int kPaperStride = 10;
constexpr int kContiguousFirstSlot = 10;

/// "slot 1", "slots 1 to 3".
std::string slotRange(int first, int last) {
  return first == last ? fmt::format("slot {}", first) : fmt::format("slots {} to {}", first, last);
}

void writeSlots(Listing& out, const CellMap& cells, int from, int to) {
  for (int slot = from; slot < to; ++slot) {
    out.line("G1 {} F=R{}", slotText(cells, slot).words, cells.feed);
  }
}

}  // namespace

base::Result<void> LoopTemplate::check(const TemplateParameters& parameters) const {
  if (parameters.hasOverlay()) {
    return base::fail(TemplateError::BadCorrection,
                      fmt::format("Method {} has no online correction and no lift: choose method "
                                  "window.",
                                  base::methodName(parameters.method)));
  }
  if (parameters.hasFactor()) {
    return base::fail(
        TemplateError::BadFactor,
        fmt::format("Method {} has no factor of the override: choose method window or "
                    "credit.",
                    base::methodName(parameters.method)));
  }
  return {};
}

CellMap LoopTemplate::cells(const TemplateParameters& parameters) const {
  CellMap cells;
  const bool isPaper = parameters.layout == Layout::Paper;
  cells.firstSlot = isPaper ? kPaperFirstSlot : kContiguousFirstSlot;
  cells.slotStride = isPaper ? kPaperStride : cellsPerPoint(parameters);
  cells.pointSlots = parameters.pointsPerLoop;
  cells.pointsPerLoop = parameters.pointsPerLoop;
  cells.axes = parameters.axes;
  cells.rotaryAxes = parameters.rotaryAxes;
  cells.heartbeat = WindowProtocol::Heartbeat;  // the program does not use it
  cells.cleared = {cells.layout, cells.run, cells.stop};
  cells.endCell = cells.stop;
  cells.endValue = LoopProtocol::kStop;
  if (!isPaper) {  // between the points of the paper's layout there are other cells
    cells.scratch = CellRange{cells.firstSlot, cells.last()};
  }
  return cells;
}

int LoopTemplate::pointsMax(const TemplateParameters& parameters) const {
  TemplateParameters one = parameters;
  one.pointsPerLoop = 1;
  const CellMap cells = this->cells(one);
  const int room = parameters.rParameterCount - 1 - cells.last();
  const int fits = room < 0 ? 0 : 1 + room / cells.slotStride;
  return fits < pointsMin() ? 0 : fits;
}

std::string LoopTemplate::program(const TemplateParameters& parameters, const CellMap& cells,
                                  int layoutNumber) const {
  Listing out;
  const int count = cells.pointsPerLoop;
  const std::string axes = slotText(cells, 0).axes;
  out.line("; RIVULET FLEXIBLE PROGRAM: MOVES TO THE VALUES OF R-PARAMETERS, IN A LOOP");
  out.line("; Do not edit: the client relies on every line. Axes move only while it runs.");
  out.line("; Method {}, {} point{} per loop, layout {}, axes {}",
           base::methodName(parameters.method), count, plural(count), layoutName(parameters.layout),
           axes);
  writeNotes(out, parameters);
  out.line(";");
  writeSignalCell(out, cells);
  out.line("; R{}  run: the client writes 1 to start", cells.run);
  out.line("; R{}  stop: the client writes 1 to end the program at the end of the loop",
           cells.stop);
  out.line("; R{}  feed in mm/min, written by the client before the start", cells.feed);
  out.line("; R{}  number of this program's layout, checked by the client", cells.layout);
  for (int slot = 0; slot < count; ++slot) {
    out.line("; {}  slot {}: {}", slotText(cells, slot).cells, slot + 1, axes);
  }
  out.line(";");
  // The layout number comes last: a client that sees it knows that the resets are done.
  out.line("R{}=0", cells.run);
  out.line("R{}=0", cells.stop);
  out.line("R{}={}", cells.signal, LoopProtocol::kRefilled);
  out.line("G90 G94 G64");
  out.line("STOPRE");
  out.line("R{}={}", cells.layout, layoutNumber);
  out.line("RIV_WAIT:");
  out.line("STOPRE");
  out.line("G4 F0.02");
  out.line("IF R{}>0 GOTOF RIV_END", cells.stop);
  out.line("IF R{}<{} GOTOB RIV_WAIT", cells.run, LoopProtocol::kRun);
  out.line("RIV_LOOP:");
  writeLoop(out, parameters, cells);
  out.line("IF R{}<{} GOTOB RIV_LOOP", cells.stop, LoopProtocol::kStop);
  out.line("RIV_END:");
  out.line("M30");
  return out.take();
}

std::string LoopTemplate::nameSuffix(const TemplateParameters& parameters) const {
  return parameters.layout == Layout::Contiguous ? "C" : "";
}

int PositionTemplate::longestWrite(const TemplateParameters& parameters) const {
  return cellsPerPoint(parameters);
}

void PositionTemplate::writeLoop(Listing& out, const LoopSettings& /*settings*/,
                                 const CellMap& cells) const {
  writeSlots(out, cells, 0, cells.pointsPerLoop);
  out.line("STOPRE");
}

std::string SignalTemplate::nameSuffix(const TemplateParameters& parameters) const {
  return LoopTemplate::nameSuffix(parameters) +
         (parameters.signalStop == SignalStop::OncePerLoop ? "L" : "");
}

int SignalTemplate::longestWrite(const TemplateParameters& parameters) const {
  return cellsPerPoint(parameters) * (parameters.pointsPerLoop / 2) + 1;
}

void SignalTemplate::writeNotes(Listing& out, const LoopSettings& settings) const {
  if (settings.signalStop == SignalStop::OncePerLoop) {
    out.line("; FOR STUDY ONLY: one STOPRE per loop, so the first signal is set before the motion");
  }
}

void SignalTemplate::writeSignalCell(Listing& out, const CellMap& cells) const {
  const int half = cells.pointsPerLoop / 2;
  out.line("; R{}  signal: {} = {} passed, {} = {} passed, {} = refilled by the client",
           cells.signal, LoopProtocol::kFirstPassed, slotRange(1, half),
           LoopProtocol::kSecondPassed, slotRange(half + 1, cells.pointsPerLoop),
           LoopProtocol::kRefilled);
}

void SignalTemplate::writeLoop(Listing& out, const LoopSettings& settings,
                               const CellMap& cells) const {
  // An assignment takes effect when it is interpreted. After a STOPRE that is when the axes have
  // passed the slots before it; without one it may be a whole block buffer too early.
  const int half = cells.pointsPerLoop / 2;
  writeSlots(out, cells, 0, half);
  if (settings.signalStop == SignalStop::EachSignal) {
    out.line("STOPRE");
  }
  out.line("R{}={}", cells.signal, LoopProtocol::kFirstPassed);
  writeSlots(out, cells, half, cells.pointsPerLoop);
  out.line("STOPRE");
  out.line("R{}={}", cells.signal, LoopProtocol::kSecondPassed);
}

}  // namespace rivulet::templates
