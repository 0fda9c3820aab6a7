// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/generator.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "base/text.h"

namespace rivulet::templates {

namespace {

/// Collects the lines of the program: one block or comment per line.
class Listing {
 public:
  template <class... Arguments>
  void line(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(m_text), text, std::forward<Arguments>(arguments)...);
    m_text += '\n';
  }
  [[nodiscard]] std::string take() { return std::move(m_text); }

 private:
  std::string m_text;
};

/// "X Y Z", "X=R11 Y=R12 Z=R13", "R11 R12 R13".
struct SlotText {
  std::string axes;
  std::string words;
  std::string cells;
};

SlotText slotText(const CellMap& cells, int slot) {
  SlotText text;
  const std::vector<int> numbers = cells.slotCells(slot);
  std::size_t next = 0;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!cells.axes[axis]) {
      continue;
    }
    const std::string_view blank = next == 0 ? "" : " ";
    text.axes += fmt::format("{}{}", blank, base::kAxisNames[axis]);
    text.words += fmt::format("{}{}=R{}", blank, base::kAxisNames[axis], numbers[next]);
    text.cells += fmt::format("{}R{}", blank, numbers[next]);
    ++next;
  }
  return text;
}

/// "slot 1", "slots 1 to 3".
std::string slotRange(int first, int last) {
  return first == last ? fmt::format("slot {}", first) : fmt::format("slots {} to {}", first, last);
}

void writeHeader(Listing& out, const TemplateParameters& parameters, const CellMap& cells) {
  const int count = cells.pointsPerLoop;
  const SlotText first = slotText(cells, 0);
  const bool signal = parameters.method == base::MethodKind::Signal;
  out.line("; RIVULET FLEXIBLE PROGRAM: MOVES TO WHAT THE R-PARAMETERS SAY, IN A LOOP");
  out.line("; Do not edit: the client relies on every line. Axes move only while it runs.");
  out.line("; Method {}, {} point{} per loop, layout {}, axes {}",
           base::methodName(parameters.method), count, count == 1 ? "" : "s",
           layoutName(parameters.layout), first.axes);
  if (signal && parameters.signalStop == SignalStop::OncePerLoop) {
    out.line(
        "; FOR STUDY ONLY: one STOPRE per loop, so the first signal comes ahead of the motion");
  }
  out.line(";");
  if (signal) {
    const int half = count / 2;
    out.line("; R{}  signal: 0 = {} passed, 1 = {} passed, 2 = refilled by the client",
             cells.signal, slotRange(1, half), slotRange(half + 1, count));
  }
  out.line("; R{}  run: the client writes 1 to start", cells.run);
  out.line("; R{}  stop: the client writes 1 to end the program at the end of the loop",
           cells.stop);
  out.line("; R{}  feed in mm/min, written by the client before the start", cells.feed);
  out.line("; R{}  number of this program's layout, checked by the client", cells.layout);
  for (int slot = 0; slot < count; ++slot) {
    out.line("; {}  slot {}: {}", slotText(cells, slot).cells, slot + 1, first.axes);
  }
  out.line(";");
}

void writeSlots(Listing& out, const CellMap& cells, int from, int to) {
  for (int slot = from; slot < to; ++slot) {
    out.line("G1 {} F=R{}", slotText(cells, slot).words, cells.feed);
  }
}

void writeLoop(Listing& out, const TemplateParameters& parameters, const CellMap& cells) {
  const int count = cells.pointsPerLoop;
  out.line("RIV_LOOP:");
  if (parameters.method == base::MethodKind::Position) {
    writeSlots(out, cells, 0, count);
    out.line("STOPRE");
    return;
  }
  // An assignment takes effect when it is interpreted. Behind a STOPRE that is when the axes have
  // passed the slots before it; without one it may be a whole block buffer too early.
  const int half = count / 2;
  writeSlots(out, cells, 0, half);
  if (parameters.signalStop == SignalStop::EachSignal) {
    out.line("STOPRE");
  }
  out.line("R{}=0", cells.signal);
  writeSlots(out, cells, half, count);
  out.line("STOPRE");
  out.line("R{}=1", cells.signal);
}

}  // namespace

base::Result<std::string> generateTemplate(const TemplateParameters& parameters) {
  const base::Result<CellMap> plan = planCells(parameters);
  if (!plan) {
    return base::fail(plan.error());
  }
  const CellMap& cells = *plan;
  Listing out;
  writeHeader(out, parameters, cells);
  // The layout number comes last: a client that sees it knows that the resets are done.
  out.line("R{}=0", cells.run);
  out.line("R{}=0", cells.stop);
  out.line("R{}=2", cells.signal);
  out.line("G90 G94 G64");
  out.line("STOPRE");
  out.line("R{}={}", cells.layout, layoutNumber(parameters));
  out.line("RIV_WAIT:");
  out.line("STOPRE");
  out.line("G4 F0.02");
  out.line("IF R{}>0 GOTOF RIV_END", cells.stop);
  out.line("IF R{}<1 GOTOB RIV_WAIT", cells.run);
  writeLoop(out, parameters, cells);
  out.line("IF R{}<1 GOTOB RIV_LOOP", cells.stop);
  out.line("RIV_END:");
  out.line("M30");
  return out.take();
}

std::string templateFileName(const TemplateParameters& parameters) {
  constexpr std::size_t kLongest = 24;
  std::string name = base::toUpper(
      fmt::format("RIVULET_{}_{}", base::methodName(parameters.method), parameters.pointsPerLoop));
  // Letters tell variants apart, so that one never takes the place of another on the control.
  name += parameters.layout == Layout::Contiguous ? "C" : "";
  const bool once = parameters.method == base::MethodKind::Signal &&
                    parameters.signalStop == SignalStop::OncePerLoop;
  name += once ? "L" : "";
  if (parameters.axes != TemplateParameters{}.axes) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (parameters.axes[axis]) {
        name += base::kAxisNames[axis];
      }
    }
  }
  if (name.size() > kLongest) {
    name = fmt::format("RIVULET_{}", layoutNumber(parameters));
  }
  return name + ".MPF";
}

}  // namespace rivulet::templates
