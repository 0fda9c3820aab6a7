// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/methods/linuxcnc.h"

#include <algorithm>

#include "templates/job_loop.h"
#include "templates/linuxcnc_protocol.h"

namespace rivulet::templates {

namespace {

using Protocol = LinuxCncProtocol;

/// Passes of the waiting loop, 20 ms each, without a window and without a change of the heartbeat,
/// before the program ends.
constexpr int kSilentPausesMax = 1000;
/// Passes of the loop that asks while the axes move, after the last block has been executed: then
/// the program stops to look. More if the motion of the last window has not begun: its blocks may
/// be on their way to the axes, or it has none that moves.
constexpr int kStandingPassesMax = 20;
constexpr int kNotBegunPassesMax = 300;
/// The copy of the window is in numbered parameters from here on. The interpreter keeps those
/// above 5000 for itself.
constexpr int kFirstCopy = 1000;
constexpr int kCopiesMax = 4000;
/// O-words before it are those of the loop.
constexpr int kFirstPointLabel = 1000;

/// The value that the cell has at this moment.
std::string read(int cell) {
  return fmt::format("#<_hal[{}{}]>", Protocol::kCellPin, cell);
}

std::string readOutput(Protocol::Output output) {
  return fmt::format("#<_hal[{}{:02}]>", Protocol::kOutputPin, static_cast<int>(output));
}

int copyOf(const CellMap& cells, int place, int value) {
  return kFirstCopy + place * copiedPerPoint(cells) + value;
}

/// "G1 X#1000 Y#1001 F#<riv_f>". @param mark  comment
void writePoint(Listing& out, const CellMap& cells, int place, std::string_view mark) {
  std::string words;
  int value = 0;
  for (const char letter : lettersOf(cells)) {
    words += fmt::format("{}#{} ", letter, copyOf(cells, place, value++));
  }
  out.line("G1 {}F{}{}", words,
           cells.feedPerPoint ? fmt::format("#{}", copyOf(cells, place, value)) : "#<riv_f>", mark);
}

/// All points of a full window, or as many as it has. @param window  in the ring: each O-word of a
/// program has a number of its own
void writePoints(Listing& out, const CellMap& cells, int window, std::string_view mark) {
  const int label = kFirstPointLabel + window * cells.pointsPerLoop;
  out.line("o{} if [ABS[#<riv_k>] GE {}]", label, cells.pointsPerLoop);
  for (int place = 0; place < cells.pointsPerLoop; ++place) {
    writePoint(out, cells, place, mark);
  }
  out.line("o{} else", label);
  for (int place = 0; place + 1 < cells.pointsPerLoop; ++place) {
    out.line("o{} if [ABS[#<riv_k>] GE {}]", label + 1 + place, place + 1);
    writePoint(out, cells, place, mark);
    out.line("o{} endif", label + 1 + place);
  }
  out.line("o{} endif", label);
}

/// The axes stand: the outputs follow at once.
void writeProgress(Listing& out) {
  out.line("M68 E{} Q#<riv_l>", static_cast<int>(Protocol::Latched));
  out.line("M68 E{} Q#<riv_l>", static_cast<int>(Protocol::Executed));
}

/// The numbers of the program begin anew, and the bridge sets the cells of the client to 0.
/// Answered when it has done so: what it has told until then is what these lines have set.
void writeHandshake(Listing& out) {
  out.line("#<riv_start>=[{}+1]", readOutput(Protocol::Start));
  out.line("M68 E{} Q#<riv_start>", static_cast<int>(Protocol::Start));
  out.line("o90 while [#<_hal[{}]> NE #<riv_start>]", Protocol::kStartedPin);
  out.line("M66 E0 L0");
  out.line("G4 P0.01");
  out.line("o90 endwhile");
}

/// All that was copied is executed first.
void writeEnding(Listing& out, WindowState state) {
  out.line("M66 E0 L0");
  writeProgress(out);
  out.line("M68 E{} Q{}", static_cast<int>(Protocol::State), static_cast<int>(state));
  out.line("M52 P0");
  out.line("M2");
}

/// A pass of a waiting loop in which nothing has come: after too many without a sign of the client
/// the program ends.
void writeSilentPass(Listing& out, const CellMap& cells, int label) {
  out.line("o{} if [{} EQ #<riv_beat>]", label, read(cells.heartbeat));
  out.line("#<riv_idle>=[#<riv_idle>+1]");
  out.line("o{} else", label);
  out.line("#<riv_idle>=0");
  out.line("#<riv_beat>={}", read(cells.heartbeat));
  out.line("o{} endif", label);
  out.line("o{} if [#<riv_idle> GT {}]", label + 1, kSilentPausesMax);
  writeEnding(out, WindowState::Abandoned);
  out.line("o{} endif", label + 1);
}

/// A method's program as the loop of a whole job, at the beginning of the job's program: lines in
/// motion are told by their number alone. Its arguments are those of `SubprogramTemplate`.
template <class Base>
class LinuxCncSubprogramTemplate final : public Base {
 public:
  explicit LinuxCncSubprogramTemplate(std::string name) : m_name(std::move(name)) {}

 private:
  static constexpr std::string_view kStretch = "#2";
  static constexpr std::string_view kRun = "#3";

  void writeHead(Listing& out) const override {
    out.line("o<{}> sub", m_name);
    out.line("; Called for each stretch of a whole job: #1 number of the job, #2 of the stretch,");
    out.line("; #3 of the run to be obeyed. Stretch 0 waits for the client and moves nothing.");
  }

  /// The override is that of the whole job.
  void writeBeginning(Listing& out, const CellMap& cells) const override {
    out.line("o80 if [{} EQ 0]", kStretch);
    Base::writeBeginning(out, cells);
    out.line("o80 endif");
    out.line("M68 E{} Q{}", static_cast<int>(Protocol::Stretch), kStretch);
  }

  void writeOwner(Listing& out) const override {
    out.line("#<riv_own>={}", kRun);
    out.line("M68 E{} Q#<riv_own>", static_cast<int>(Protocol::Owner));
  }

  /// The number comes last: who sees it knows that the cells are those of this stretch.
  void writeReady(Listing& out, const CellMap&) const override { writeCall(out, ""); }

  void writeLeaving(Listing& out, const CellMap& cells) const override {
    out.line("o115 if [[{} EQ 0] AND [{} EQ {}] AND [#<riv_own> GT 0]]", kStretch, read(cells.run),
             WindowProtocol::kRun);
    writeReturn(out);
    out.line("o115 endif");
  }

  /// The client has to see that the stretch was executed before the control goes on.
  void writeDone(Listing& out, const CellMap& cells) const override {
    out.line("M66 E0 L0");
    writeProgress(out);
    out.line("M68 E{} Q{}", static_cast<int>(Protocol::State), static_cast<int>(WindowState::Done));
    out.line("#<riv_idle>=0");
    out.line("o180 while [{} NE [{}+{}]]", read(cells.run), kStretch, JobProtocol::goOn(0));
    out.line("o181 if [{} EQ {}]", read(cells.run), WindowProtocol::kEnd);
    writeEnding(out, WindowState::Stopped);
    out.line("o181 endif");
    writeSilentPass(out, cells, 182);
    out.line("G4 P0.02");
    out.line("M66 E0 L0");
    out.line("o180 endwhile");
    writeReturn(out);
  }

  [[nodiscard]] std::string_view endWord() const override { return m_end; }

  void writeReturn(Listing& out) const {
    out.line("M68 E{} Q{}", static_cast<int>(Protocol::State), static_cast<int>(WindowState::Done));
    writeCall(out, "-");
    out.line("o<{}> return", m_name);
  }

  static void writeCall(Listing& out, std::string_view sign) {
    out.line("M68 E{} Q[{}[#1*{}+{}]]", static_cast<int>(Protocol::Call), sign,
             JobProtocol::kStretchesMax + 1, kStretch);
  }

  std::string m_name;
  std::string m_end = fmt::format("o<{}> endsub", m_name);
};

}  // namespace

base::Result<void> LinuxCncWindowTemplate::check(const TemplateParameters& parameters) const {
  if (parameters.hasOverlay()) {
    return base::fail(TemplateError::NotOnTarget,
                      "There is no online correction and no lift on LinuxCNC: choose 0 for both.");
  }
  if (parameters.packed) {
    return base::fail(TemplateError::NotOnTarget,
                      "There are no packed points on LinuxCNC: do not pack them.");
  }
  if (parameters.hasFactor()) {
    return base::fail(TemplateError::NotOnTarget,
                      "There is no factor of the override on LinuxCNC: leave its bounds out.");
  }
  if (parameters.pointsPerLoop > 0 &&
      parameters.pointsPerLoop > kCopiesMax / std::max(cellsPerPoint(parameters), 1)) {
    return base::fail(
        TemplateError::DoesNotFit,
        fmt::format("A window of {} points does not fit the parameters of LinuxCNC: "
                    "choose at most {}.",
                    parameters.pointsPerLoop, kCopiesMax / std::max(cellsPerPoint(parameters), 1)));
  }
  return WindowTemplate::check(parameters);
}

std::string LinuxCncWindowTemplate::nameSuffix(const TemplateParameters& parameters) const {
  return WindowTemplate::nameSuffix(parameters) + "L";
}

std::string LinuxCncWindowTemplate::program(const TemplateParameters& parameters,
                                            const CellMap& cells, int layoutNumber) const {
  Listing out;
  writeComments(out, parameters, cells);
  writeHead(out);
  writeStart(out, cells, layoutNumber);
  out.line("o100 while [1]");
  writeWait(out, parameters, cells);
  writeTaking(out, cells);
  writeMotion(out, cells);
  out.line("o100 endwhile");
  out.line("{}", endWord());
  return out.take();
}

/// A loop of its own: LinuxCNC reads every line of a branch that it skips.
void LinuxCncWindowTemplate::writeWait(Listing& out, const TemplateParameters& parameters,
                                       const CellMap& cells) const {
  out.line("#<riv_go>=0");
  out.line("#<riv_dry>=0");
  out.line("o101 while [#<riv_go> EQ 0]");
  out.line("o110 if [#<riv_stands> GT 0]");
  out.line("M66 E0 L0");
  out.line("o111 if [#<riv_told> NE #<riv_l>]");
  writeProgress(out);
  out.line("#<riv_told>=#<riv_l>");
  out.line("o111 endif");
  out.line("o110 endif");

  writeLeaving(out, cells);
  out.line("o120 if [{} GT {}]", read(cells.run), WindowProtocol::kRun);
  writeEnding(out, WindowState::Stopped);
  out.line("o120 endif");

  // The lines of the interpreter hold 255 characters, so the question is asked in pieces.
  out.line("#<riv_d>=[{}-#<riv_l>]", read(cells.delivered));
  out.line("#<riv_go>=[[{} GT {}] AND [#<riv_own> GT 0] AND [#<riv_d> GT 0] AND [#<riv_d> LE {}]]",
           read(cells.run), WindowProtocol::kHold, cells.windows);
  if (isCredit()) {
    out.line("#<riv_go>=[[#<riv_go> GT 0] AND [[#<riv_l>-{}] LT {}]]", read(cells.executed),
             parameters.windowsAhead);
  }
  out.line("o130 if [#<riv_go> GT 0]");
  out.line("#<riv_idle>=0");
  out.line("o130 elseif [#<riv_stands> GT 0]");
  writeSilentPass(out, cells, 131);
  out.line("o133 if [#<riv_own> EQ 0]");
  out.line("#<riv_own>={}", read(cells.client));
  out.line("M68 E{} Q#<riv_own>", static_cast<int>(Protocol::Owner));
  out.line("o133 endif");
  out.line("G4 P0.02");
  if (isCredit()) {
    out.line("o130 elseif [#<_hal[motion.in-position]> GT 0]");
    out.line("#<riv_dry>=[#<riv_dry>+1]");
    out.line("o134 if [[#<riv_dry> GT {}] AND [{} EQ #<riv_l>]]", kStandingPassesMax,
             read(cells.latched));
    out.line("#<riv_stands>=1");
    out.line("o134 elseif [#<riv_dry> GT {}]", kNotBegunPassesMax);
    out.line("#<riv_stands>=1");
    out.line("o134 endif");
  }
  out.line("o130 endif");
  out.line("o101 endwhile");
}

void LinuxCncWindowTemplate::writeComments(Listing& out, const TemplateParameters& parameters,
                                           const CellMap& cells) const {
  const Wording wording{"PINS OF THE HAL, LINUXCNC",
                        isCredit() ? "whose motion has begun: their cells may be written again"
                                   : "copied by this program: their cells may be written again"};
  writeTitle(out, parameters, cells, wording);
  out.line("; R<n> is the pin {}<n> of rivulet-linuxcnc, which copies the analog outputs E0 to E{}",
           Protocol::kCellPin, Protocol::Outputs - 1);
  out.line("; of the motion controller into the cells that this program writes.");
  if (isCredit()) {
    out.line("; No stop between windows: at most {} are copied but not executed.",
             parameters.windowsAhead);
  }
  writeHeaderCells(out, cells, wording);
}

void LinuxCncWindowTemplate::writeStart(Listing& out, const CellMap& cells,
                                        int layoutNumber) const {
  // What an aborted program may have left. Q0: every point keeps a block of its own, also on a
  // straight line.
  out.line("G8 G17 G21 G40 G90 G91.1 G94 G64 P{} Q0", Protocol::kPathToleranceMm);
  for (const char* const name : {"l", "own", "b", "idle", "told"}) {
    out.line("#<riv_{}>=0", name);
  }
  out.line("#<riv_stands>=1");
  writeBeginning(out, cells);
  out.line("M68 E{} Q{}", static_cast<int>(Protocol::Block), Protocol::kNoBlock);
  writeHandshake(out);
  writeProgress(out);
  out.line("M68 E{} Q0", static_cast<int>(Protocol::State));
  writeOwner(out);
  out.line("#<riv_beat>={}", read(cells.heartbeat));
  // A client that sees this number knows that the other cells have been reset.
  out.line("M68 E{} Q{}", static_cast<int>(Protocol::Layout), layoutNumber);
  writeReady(out, cells);
}

void LinuxCncWindowTemplate::writeBeginning(Listing& out, const CellMap& cells) const {
  // All that moves from here on obeys the feed cell; the bridge tries it before it answers.
  out.line("M52 P1");
  out.line("M68 E{} Q{:g}", static_cast<int>(Protocol::SilenceLimit), cells.silenceLimitS);
  out.line("M68 E{} Q{}", static_cast<int>(Protocol::Base), cells.run);
  // These numbers of this program must be a change, also if those of the one before were the same.
  for (const Protocol::Output output : {Protocol::Layout, Protocol::Call, Protocol::Stretch}) {
    out.line("M68 E{} Q0", static_cast<int>(output));
  }
}

void LinuxCncWindowTemplate::writeOwner(Listing& out) const {
  out.line("M68 E{} Q0", static_cast<int>(Protocol::Owner));
}

/// Copies a window and checks the copy: whatever is written meanwhile, and by whom, the axes move
/// to the positions sent by the client of this run. A pin cannot be addressed by a number that is
/// computed, so every window has its own lines.
void LinuxCncWindowTemplate::writeTaking(Listing& out, const CellMap& cells) const {
  for (int window = 0; window < cells.windows; ++window) {
    out.line("o140 {} [#<riv_b> EQ {}]", window == 0 ? "if" : "elseif", window);
    out.line("#<riv_k>={}", read(cells.windowCount(window)));
    out.line("#<riv_f>={}", read(cells.windowFeed(window)));
    out.line("#<riv_s>={}", read(cells.windowCheck(window)));
    for (int place = 0; place < cells.pointsPerLoop; ++place) {
      int value = 0;
      for (const int cell : cells.slotCells(window * cells.pointsPerLoop + place)) {
        out.line("#{}={}", copyOf(cells, place, value++), read(cell));
      }
    }
  }
  out.line("o140 endif");
  out.line("#<riv_s>=[#<riv_own>+{}*[#<riv_l>+1]+{}*#<riv_k>+{}*#<riv_f>-#<riv_s>]",
           WindowProtocol::kCheckNumber, WindowProtocol::kCheckCount, WindowProtocol::kCheckFeed);
  for (int number = 0; number < cells.pointsPerLoop * copiedPerPoint(cells); ++number) {
    out.line("#<riv_s>=[#<riv_s>+{:.6f}*#{}]", WindowProtocol::checkFactor(number),
             kFirstCopy + number);
  }
  out.line("o141 if [ABS[#<riv_s>] GT 0.000001]");
  writeEnding(out, WindowState::Damaged);
  out.line("o141 endif");
  out.line("#<riv_l>=[#<riv_l>+1]");
}

void LinuxCncWindowTemplate::writeDone(Listing& out, const CellMap&) const {
  writeEnding(out, WindowState::Done);
}

/// Of method credit, every window of the ring has blocks of its own: the bridge sees at the line in
/// motion how far the axes are. An output that changes with the motion (M67) would make LinuxCNC
/// brake before every window.
void LinuxCncWindowTemplate::writeMotion(Listing& out, const CellMap& cells) const {
  if (!isCredit()) {
    out.line("M68 E{} Q#<riv_l>", static_cast<int>(Protocol::Latched));
    writePoints(out, cells, 0, "");
  } else {
    for (int window = 0; window < cells.windows; ++window) {
      out.line("o160 {} [#<riv_b> EQ {}]", window == 0 ? "if" : "elseif", window);
      writePoints(out, cells, window, fmt::format(" {}{}", Protocol::kMotionMark, window));
    }
    out.line("o160 endif");
  }
  out.line("o170 if [#<riv_k> LT 0]");
  writeDone(out, cells);
  out.line("o170 endif");
  out.line("#<riv_b>=[#<riv_b>+1]");
  out.line("o171 if [#<riv_b> GE {}]", cells.windows);
  out.line("#<riv_b>=0");
  out.line("o171 endif");
  if (isCredit()) {
    // Another feed: the interpreter hands over the last block, which it would keep until it knows
    // the next one.
    out.line("F[#<riv_f>+0.01]");
    out.line("#<riv_stands>=0");
  }
}

std::unique_ptr<MethodTemplate> LinuxCncWindowTemplate::asSubprogram(std::string name) const {
  return std::make_unique<LinuxCncSubprogramTemplate<LinuxCncWindowTemplate>>(std::move(name));
}

std::unique_ptr<MethodTemplate> LinuxCncCreditTemplate::asSubprogram(std::string name) const {
  return std::make_unique<LinuxCncSubprogramTemplate<LinuxCncCreditTemplate>>(std::move(name));
}

base::Result<void> LinuxCncCreditTemplate::check(const TemplateParameters& parameters) const {
  if (parameters.windows == 1) {
    return base::fail(TemplateError::NotOnTarget,
                      "Method credit needs two windows or more on LinuxCNC.");
  }
  if (parameters.slowDown) {
    return base::fail(TemplateError::NotOnTarget,
                      "On LinuxCNC the feed is not lowered before windows run out: switch that off "
                      "(--no-slow-down).");
  }
  return LinuxCncWindowTemplate::check(parameters);
}

std::string LinuxCncCreditTemplate::nameSuffix(const TemplateParameters& parameters) const {
  return LinuxCncWindowTemplate::nameSuffix(parameters) +
         fmt::format("A{}", parameters.windowsAhead);
}

}  // namespace rivulet::templates
