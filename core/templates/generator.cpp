// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/generator.h"

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "base/contract.h"
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
  void text(std::string_view lines) { m_text += lines; }
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

/// In the order of a slot's cells.
std::string lettersOf(const CellMap& cells) {
  TemplateParameters chosen;
  chosen.axes = cells.axes;
  chosen.rotaryAxes = cells.rotaryAxes;
  return axisLetters(chosen);
}

/// "X Y Z".
std::string spacedLettersOf(const CellMap& cells) {
  return fmt::format("{}", fmt::join(lettersOf(cells), " "));
}

SlotText slotText(const CellMap& cells, int slot) {
  SlotText text;
  const std::vector<int> numbers = cells.slotCells(slot);
  std::size_t next = 0;
  for (const char letter : lettersOf(cells)) {
    const std::string_view blank = next == 0 ? "" : " ";
    text.axes += fmt::format("{}{}", blank, letter);
    text.words += fmt::format("{}{}=R{}", blank, letter, numbers[next]);
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

/// Pieces on as few lines as take them, each line begun anew.
void writePieces(Listing& out, const std::string& begin, const std::vector<std::string>& pieces,
                 std::string_view between) {
  constexpr std::size_t kLineMax = 110;
  std::string line;
  for (const std::string& piece : pieces) {
    if (!line.empty() && line.size() + between.size() + piece.size() > kLineMax) {
      out.line("{}", line);
      line.clear();
    }
    line += line.empty() ? begin : std::string(between);
    line += piece;
  }
  if (!line.empty()) {
    out.line("{}", line);
  }
}

/// Passes of the waiting loop without a window and without a change of the heartbeat, before the
/// program ends. A pass takes 20 ms and more.
constexpr int kSilentPassesMax = 1000;

/// Method credit. Passes of the loop that waits while the axes move, before the program stops to
/// look: minutes. Only a control that does not show what is new without a stop comes to that.
constexpr int kAskingPassesMax = 100'000;
/// Passes in which no block was left to execute, before the program stops to look. The stop also
/// has a block executed that the control holds back until it knows the next one.
constexpr int kDryPassesMax = 25;

/// Numbers of the synchronized actions that lay the corrections over X, Y and Z.
constexpr int kCorrectionAction = 11;

/// "X" with its cell and its action, for each axis that is corrected.
struct Corrected {
  char letter;
  int cell;
  int action;
};

std::vector<Corrected> correctedAxes(const CellMap& cells) {
  std::vector<Corrected> axes;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (cells.correction[axis] >= 0) {
      axes.push_back({base::kAxisNames[axis], cells.correction[axis],
                      kCorrectionAction + static_cast<int>(axis)});
    }
  }
  return axes;
}

std::string windowSubprogram(int file) {
  return fmt::format("RIVULET_W{}", file + 1);
}

void writeWindowHeader(Listing& out, const TemplateParameters& parameters, const CellMap& cells) {
  const int count = cells.pointsPerLoop;
  const std::string axes = spacedLettersOf(cells);
  out.line("; RIVULET FLEXIBLE PROGRAM: MOVES TO WHAT THE {} SAY, WINDOW BY WINDOW",
           cells.inFiles ? "SUBPROGRAMS" : "R-PARAMETERS");
  out.line("; Do not edit: the client relies on every line. Axes move only while it runs.");
  out.line("; Method {}, {} point{} per window, {} window{}, axes {}",
           base::methodName(parameters.method), count, count == 1 ? "" : "s", cells.windows,
           cells.windows == 1 ? "" : "s", axes);
  if (base::any(cells.rotaryAxes)) {
    out.line("; Rotary axes in degrees; where only they turn, the feed is in deg/min.");
  }
  if (cells.corrects()) {
    out.line("; Online correction: what the last cells say is laid over the axes, also while they");
    out.line(
        "; stand. Its motion comes on top of the feed. It is gone again when the program ends.");
  }
  if (cells.inFiles) {
    out.line(
        "; FOR COMPARISON: each window is a subprogram that the client transfers. It is executed");
    out.line("; only once it has been delivered, and if it bears its number and that of the run.");
  } else {
    out.line("; A window is executed only once its number has been delivered and its check number");
    out.line("; fits: where the client is late, the axes wait.");
  }
  if (parameters.method == base::MethodKind::Credit) {
    out.line(
        "; EXPERIMENTAL: between windows it does not stop. It asks again and again while the axes");
    out.line(
        "; move, and relies on a control that reads R-parameters each time it passes a block.");
    out.line("; At most {} windows are copied and not executed: so many follow behind a stop.",
             parameters.windowsAhead);
  }
  out.line(";");
  out.line("; R{}  run, by the client: 0 hold, 1 run, 2 end before the next window", cells.run);
  out.line("; R{}  windows delivered, written by the client last of each window", cells.delivered);
  out.line("; R{}  windows {}", cells.latched,
           cells.inFiles ? "begun by this program"
                         : "copied by this program: their cells may be written again");
  out.line("; R{}  windows executed to the end", cells.executed);
  out.line("; R{}  number of this program's layout, checked by the client", cells.layout);
  out.line("; R{}  state: 0 runs, 1 done, 2 stopped, 3 window damaged, 4 client silent{}",
           cells.state, cells.corrects() ? "," : "");
  if (cells.corrects()) {
    out.line("; 5 not begun: overlay left from before, 6 not begun: overlay adds up");
  }
  out.line("; R{}  number of the client's run, R{} number of the run this program obeys",
           cells.client, cells.owner);
  out.line("; R{}  heartbeat of the client", cells.heartbeat);
  if (cells.inFiles) {
    out.line("; R{}  the window asked for, then the answer of its subprogram", cells.asked);
  }
  for (int window = 0; window < cells.windows && !cells.inFiles; ++window) {
    out.line("; R{} R{} R{}  window {}: points (negative: the last window), feed in mm/min, check",
             cells.windowCount(window), cells.windowFeed(window), cells.windowCheck(window),
             window + 1);
    for (int place = 0; place < count; ++place) {
      const SlotText slot = slotText(cells, window * count + place);
      out.line("; {}  window {} point {}: {}", slot.cells, window + 1, place + 1, axes);
    }
  }
  for (const Corrected& axis : correctedAxes(cells)) {
    out.line("; R{}  online correction of {} in mm, by the client; obeyed up to {:.3f}", axis.cell,
             axis.letter, correctionSteps(parameters) / 1000.0);
  }
  out.line(";");
}

/// "G1 X=RIV_C[3] Y=RIV_C[4] F=RIV_F": from the program's own copy, never from the cells.
void writeCopiedPoint(Listing& out, const CellMap& cells, int place, int axisCount) {
  std::string words;
  int next = place * axisCount;
  for (const char letter : lettersOf(cells)) {
    words += fmt::format("{}=RIV_C[{}] ", letter, next++);
  }
  out.line("G1 {}F=RIV_F", words);
}

/// Below this an overlay is gone, mm.
constexpr double kOverlayGoneMm = 0.0005;
/// Passes of 20 ms in which the overlay has to be gone at the end.
constexpr int kOverlayPassesMax = 500;

/// "ABS($AA_OFF_VAL[X])>0.0005" of all axes.
std::string overlayThere(const CellMap& cells) {
  std::string condition;
  for (const Corrected& axis : correctedAxes(cells)) {
    condition += fmt::format("{}(ABS($AA_OFF_VAL[{}])>{})", condition.empty() ? "" : " OR ",
                             axis.letter, kOverlayGoneMm);
  }
  return condition;
}

/// Nothing may lie over the axes when the client asks where they stand, and a control that adds up
/// what it is given would drive away.
void writeOverlayCheck(Listing& out, const CellMap& cells) {
  out.line("; Only where nothing is laid over the axes, and where it is no sum (MD36750).");
  out.line("RIV_IDLE={}", static_cast<int>(WindowState::OverlayLeft));
  out.line("IF {} GOTOF RIV_UNFIT", overlayThere(cells));
  out.line("RIV_IDLE={}", static_cast<int>(WindowState::OverlayIntegrates));
  std::string integrates;
  for (const Corrected& axis : correctedAxes(cells)) {
    integrates += fmt::format("{}(($MA_AA_OFF_MODE[{}] B_AND 1)>0)",
                              integrates.empty() ? "" : " OR ", axis.letter);
  }
  out.line("IF {} GOTOF RIV_UNFIT", integrates);
  out.line("RIV_IDLE=0");
}

/// A value beyond the limit is not obeyed: what was obeyed last stays. For what is no number no
/// comparison holds.
void writeCorrections(Listing& out, const TemplateParameters& parameters, const CellMap& cells) {
  const double limitMm = correctionSteps(parameters) / 1000.0;
  for (const Corrected& axis : correctedAxes(cells)) {
    out.line("ID={} WHENEVER ($R{}>=-{:.3f}) AND ($R{}<={:.3f}) DO $AA_OFF[{}]=$R{}", axis.action,
             axis.cell, limitMm, axis.cell, limitMm, axis.letter, axis.cell);
  }
}

/// The same numbers again take the place of what obeyed the client. The axes have arrived where
/// the path ends before the program ends.
void writeOverlayBack(Listing& out, const TemplateParameters& parameters, const CellMap& cells) {
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
  out.line("R{}=RIV_IDLE R{}={}", cells.state, cells.layout, layoutNumber(parameters));
  out.line("M30");
}

/// Behind a stop everything copied has been executed; state and end say so.
void writeEnd(Listing& out, const CellMap& cells, std::string_view label, WindowState state,
              bool stands) {
  out.line("{}:", label);
  if (!stands) {
    out.line("STOPRE");
    out.line("R{}=RIV_L R{}={}", cells.executed, cells.state, static_cast<int>(state));
  } else {
    out.line("R{}={}", cells.state, static_cast<int>(state));
  }
  out.line("{}", cells.corrects() ? "GOTOF RIV_OFF" : "M30");
}

/// Method credit: waits for the next window while those before are under way. Nothing in here goes
/// to the main run, so nothing keeps the axes from moving on.
void writeAsking(Listing& out, const TemplateParameters& parameters, const CellMap& cells) {
  out.line("RIV_MORE:");
  out.line("RIV_TURN=0 RIV_DRY=0");
  out.line("RIV_ASK:");
  out.line("IF R{}>1 GOTOF RIV_STOPPED", cells.run);
  out.line("IF (R{}>0) AND (R{}>RIV_L) AND (R{}<=RIV_L+{}) AND (RIV_L-R{}<{}) GOTOF RIV_TAKE",
           cells.run, cells.delivered, cells.delivered, cells.windows, cells.executed,
           parameters.windowsAhead);
  out.line("RIV_TURN=RIV_TURN+1");
  out.line("IF $AC_IPO_BUF>0 GOTOF RIV_FED");
  out.line("RIV_DRY=RIV_DRY+1");
  out.line("RIV_FED:");
  out.line("IF (RIV_TURN<{}) AND (RIV_DRY<{}) GOTOB RIV_ASK", kAskingPassesMax, kDryPassesMax);
  out.line("GOTOB RIV_NEXT");
}

/// The layout number comes later: a client that sees it knows that these are done.
void writeResets(Listing& out, const CellMap& cells) {
  out.line("R{}=0 R{}=0 R{}=0 R{}=0", cells.run, cells.delivered, cells.latched, cells.executed);
  out.line("R{}=0 R{}=0 R{}=0", cells.state, cells.client, cells.owner);
}

/// The axes stand; the program asks what is new, and gives up where nobody is there any more.
void writeWaiting(Listing& out, const CellMap& cells) {
  // Behind this STOPRE the axes stand and what the client has written is read afresh.
  out.line("RIV_NEXT:");
  out.line("STOPRE");
  out.line("R{}=RIV_L R{}=RIV_L", cells.latched, cells.executed);
  out.line("IF R{}>1 GOTOF RIV_STOPPED", cells.run);
  out.line("IF (R{}>0) AND (RIV_OWN>0) AND (R{}>RIV_L) AND (R{}<=RIV_L+{}) GOTOF RIV_TAKE",
           cells.run, cells.delivered, cells.delivered, cells.windows);
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

/// Calls the subprogram of each window in turn, and goes on only if its answer is the right one.
std::string fileTemplate(const TemplateParameters& parameters, const CellMap& cells) {
  Listing out;
  writeWindowHeader(out, parameters, cells);
  out.line("DEF REAL RIV_OWN,RIV_BEAT,RIV_K");
  out.line("DEF INT RIV_L,RIV_IDLE");
  writeResets(out, cells);
  out.line("RIV_L=0 RIV_OWN=0 RIV_IDLE=0");
  out.line("G90 G94 G64");
  out.line("STOPRE");
  out.line("RIV_BEAT=R{}", cells.heartbeat);
  out.line("R{}={}", cells.layout, layoutNumber(parameters));
  writeWaiting(out, cells);
  out.line("RIV_TAKE:");
  out.line("RIV_IDLE=0 RIV_L=RIV_L+1");
  out.line("R{}=RIV_L R{}=RIV_L", cells.latched, cells.asked);
  for (int file = 1; file < cells.windows; ++file) {
    out.line("IF (RIV_L-1) MOD {}=={} GOTOF RIV_FILE{}", cells.windows, file, file + 1);
  }
  for (int file = 0; file < cells.windows; ++file) {
    if (file > 0) {
      out.line("RIV_FILE{}:", file + 1);
    }
    out.line("CALL \"{}\"", windowSubprogram(file));
    if (file + 1 < cells.windows) {
      out.line("GOTOF RIV_ANSWER");
    }
  }
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

std::string windowTemplate(const TemplateParameters& parameters, const CellMap& cells) {
  const bool isCredit = parameters.method == base::MethodKind::Credit;
  const std::string_view next = isCredit ? "RIV_MORE" : "RIV_NEXT";
  const int count = cells.pointsPerLoop;
  const int first = cells.windowCount(0);
  const std::vector<int> slot = cells.slotCells(0);
  const int axisCount = static_cast<int>(slot.size());
  Listing out;
  writeWindowHeader(out, parameters, cells);
  // What the program relies on it keeps in variables of its own, which no client can write.
  out.line("DEF REAL RIV_C[{}],RIV_F,RIV_K,RIV_S,RIV_OWN,RIV_BEAT", count * axisCount);
  out.line("DEF INT RIV_L,RIV_N,RIV_B,RIV_IDLE{}", isCredit ? ",RIV_TURN,RIV_DRY" : "");
  writeResets(out, cells);
  out.line("RIV_L=0 RIV_OWN=0 RIV_B={} RIV_IDLE=0", first);
  std::string uncorrected;
  for (const Corrected& axis : correctedAxes(cells)) {
    uncorrected += fmt::format("{}R{}=0", uncorrected.empty() ? "" : " ", axis.cell);
  }
  if (!uncorrected.empty()) {
    out.line("{}", uncorrected);
  }
  out.line("G90 G94 G64");
  out.line("STOPRE");
  out.line("RIV_BEAT=R{}", cells.heartbeat);
  if (cells.corrects()) {
    writeOverlayCheck(out, cells);
    writeCorrections(out, parameters, cells);
  }
  if (isCredit && parameters.slowDown) {
    out.line("; Slower while nothing is left behind the window in motion.");
    out.line("ID=1 WHENEVER ($R{}-$R{})<2 DO $AC_OVR={}", cells.latched, cells.executed,
             kCreditSlowPercent);
  }
  out.line("R{}={}", cells.layout, layoutNumber(parameters));
  writeWaiting(out, cells);
  if (isCredit) {
    writeAsking(out, parameters, cells);
  }
  // First a copy, then the check of the copy, then the motion from the copy: whatever is written
  // meanwhile, and by whom, the axes go where the client of this run meant them to go.
  out.line("RIV_TAKE:");
  out.line("RIV_IDLE=0 RIV_K=R[RIV_B] RIV_F=R[RIV_B+1] RIV_S=R[RIV_B+2]");
  std::vector<std::string> copies;
  std::vector<std::string> terms;
  for (int place = 0; place < count; ++place) {
    for (int axis = 0; axis < axisCount; ++axis) {
      const int number = place * axisCount + axis;
      const int offset = 3 + place * cells.slotStride + axis;
      copies.push_back(fmt::format("RIV_C[{}]=R[RIV_B+{}]", number, offset));
      terms.push_back(fmt::format("{:.6f}*RIV_C[{}]", checkFactor(number), number));
    }
  }
  writePieces(out, "", copies, " ");
  out.line("RIV_S=RIV_OWN+{}*(RIV_L+1)+{}*RIV_K+{}*RIV_F-RIV_S", kCheckNumber, kCheckCount,
           kCheckFeed);
  writePieces(out, "RIV_S=RIV_S+", terms, "+");
  out.line("IF ABS(RIV_S)>0.000001 GOTOF RIV_DAMAGED");
  out.line("RIV_L=RIV_L+1 RIV_N=ABS(RIV_K)");
  out.line("R{}=RIV_L", cells.latched);
  if (cells.windows > 1) {
    out.line("RIV_B=RIV_B+{}", cells.windowStride);
    out.line("IF RIV_B<={} GOTOF RIV_MOVE", cells.windowCount(cells.windows - 1));
    out.line("RIV_B={}", first);
    out.line("RIV_MOVE:");
  }
  out.line("IF RIV_K<{} GOTOF RIV_SHORT", count);
  // The main run writes it when it comes to the first block of this window: those before are done.
  const std::string before =
      isCredit ? fmt::format("DO $R{}=R{}-1\n", cells.executed, cells.latched) : std::string();
  out.text(before);
  for (int place = 0; place < count; ++place) {
    writeCopiedPoint(out, cells, place, axisCount);
  }
  out.line("GOTOB {}", next);
  out.line("RIV_SHORT:");
  if (isCredit && parameters.slowDown) {
    out.line("IF RIV_K>0 GOTOF RIV_PART");
    out.line("CANCEL(1)");
    out.line("RIV_PART:");
  }
  out.text(before);
  for (int place = 0; place < count; ++place) {
    writeCopiedPoint(out, cells, place, axisCount);
    if (place + 1 < count) {
      out.line("IF RIV_N<{} GOTOF RIV_TAIL", place + 2);
    }
  }
  out.line("RIV_TAIL:");
  out.line("IF RIV_K>0 GOTOB {}", next);
  out.line("STOPRE");
  out.line("R{}=RIV_L R{}={}", cells.executed, cells.state, static_cast<int>(WindowState::Done));
  out.line("{}", cells.corrects() ? "GOTOF RIV_OFF" : "M30");
  writeEnd(out, cells, "RIV_STOPPED", WindowState::Stopped, !isCredit);
  writeEnd(out, cells, "RIV_DAMAGED", WindowState::Damaged, !isCredit);
  writeEnd(out, cells, "RIV_LOST", WindowState::Abandoned, true);
  if (cells.corrects()) {
    writeOverlayBack(out, parameters, cells);
  }
  return out.take();
}

}  // namespace

base::Result<std::string> generateTemplate(const TemplateParameters& parameters) {
  const base::Result<CellMap> plan = planCells(parameters);
  if (!plan) {
    return base::fail(plan.error());
  }
  const CellMap& cells = *plan;
  if (cells.inFiles) {
    return fileTemplate(parameters, cells);
  }
  if (base::hasWindows(parameters.method)) {
    return windowTemplate(parameters, cells);
  }
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

std::string windowFileText(const CellMap& cells, const WindowFile& window) {
  const std::string letters = lettersOf(cells);
  RIVULET_ASSERT(cells.inFiles && !window.coordinates.empty());
  RIVULET_ASSERT(window.coordinates.size() % letters.size() == 0);
  Listing out;
  const std::size_t count = window.coordinates.size() / letters.size();
  out.line("; RIVULET: WINDOW {} OF RUN {}, {} POINTS. WRITTEN ANEW WHILE THE MACHINE RUNS",
           window.number, window.run, count);
  out.line("IF (R{}<>{}) OR (R{}<>{}) GOTOF RIV_END", cells.asked, window.number, cells.owner,
           window.run);
  // A file that has been cut off has no such label: the control stops before anything moves.
  out.line("GOTOF RIV_WHOLE");
  out.line("RIV_GO:");
  out.line("R{}=-{}", cells.asked, 2 * window.number + (window.isLast ? 1 : 0));
  std::size_t next = 0;
  for (std::size_t point = 0; point < count; ++point) {
    std::string words;
    for (const char letter : letters) {
      words += fmt::format(" {}{:.6f}", letter, window.coordinates[next++]);
    }
    out.line("G1{}{}", words,
             point == 0 ? fmt::format(" F{}", base::formatNumber(window.feedMmPerMin)) : "");
  }
  out.line("RIV_END:");
  out.line("M17");
  out.line("RIV_WHOLE:");
  out.line("GOTOB RIV_GO");
  return out.take();
}

std::string windowFileName(int file) {
  return windowSubprogram(file) + ".SPF";
}

std::string templateFileName(const TemplateParameters& parameters) {
  constexpr std::size_t kLongest = 24;
  std::string name = base::toUpper(
      fmt::format("RIVULET_{}_{}", base::methodName(parameters.method), parameters.pointsPerLoop));
  // Letters tell variants apart, so that one never takes the place of another on the control.
  const bool window = base::hasWindows(parameters.method);
  if (window) {
    name += fmt::format("X{}", parameters.windows);
    name += parameters.baseCell != 0 ? fmt::format("B{}", parameters.baseCell) : "";
    name += parameters.slotStride != 0 ? fmt::format("S{}", parameters.slotStride) : "";
    const int steps = correctionSteps(parameters);
    name += steps > 0 ? fmt::format("K{}", steps) : "";
  }
  if (parameters.method == base::MethodKind::Credit) {
    name += fmt::format("A{}{}", parameters.windowsAhead, parameters.slowDown ? "" : "F");
  }
  name += !window && parameters.layout == Layout::Contiguous ? "C" : "";
  const bool once = parameters.method == base::MethodKind::Signal &&
                    parameters.signalStop == SignalStop::OncePerLoop;
  name += once ? "L" : "";
  if (parameters.axes != TemplateParameters{}.axes || base::any(parameters.rotaryAxes)) {
    name += axisLetters(parameters);
  }
  if (name.size() > kLongest) {
    name = fmt::format("RIVULET_{}", layoutNumber(parameters));
  }
  return name + ".MPF";
}

}  // namespace rivulet::templates
