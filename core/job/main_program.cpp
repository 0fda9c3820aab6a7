// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/main_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/hash.h"
#include "base/text.h"
#include "base/units.h"
#include "nc/nc_number.h"
#include "nc/syntax/lexer.h"
#include "nc/syntax/parser.h"
#include "templates/feed_cell.h"

namespace rivulet::job {

namespace {

using templates::JobProtocol;
using templates::WindowProtocol;

class Category final : public std::error_category {
 public:
  [[nodiscard]] const char* name() const noexcept override { return "job"; }
  [[nodiscard]] std::string message(int code) const override {
    switch (static_cast<JobError>(code)) {
      case JobError::NotWhole:
        return "the program is no whole job";
      case JobError::ReadsVariables:
        return "a native block reads variables";
      case JobError::IncrementInFrame:
        return "a native block moves by an increment in a frame";
      case JobError::TooManyStretches:
        return "too many stretches";
      case JobError::PositionDiffers:
        return "the tool is not where the program says";
      case JobError::BeyondMachine:
        return "beyond what the machine can do";
      case JobError::FunctionMalformed:
        return "not what a control does for an M function";
      case JobError::NotDry:
        return "no dry run";
    }
    return "unknown error";
  }
};

/// Before a native block a client may stop or hold the job, except where blocks belong together.
constexpr std::string_view kNamePrefix = "RIVJOB_";

bool mayWaitBefore(NativeReason reason) {
  return reason >= NativeReason::Tool;
}

/// A block without the words that end a program: what it does besides is done before. Nothing that
/// stands behind RET is executed.
std::string withoutEnd(std::string_view block) {
  nc::Lexer lexer(block, nc::Dialect::Sinumerik);
  nc::Block words;
  std::string left;
  const char* at = block.data();
  while (lexer.next(words)) {
    for (const nc::Token& token : words.tokens) {
      const nc::EndWord end = nc::endWordOf(token);
      if (end == nc::EndWord::None) {
        left.append(at, token.text.data() + token.text.size());
      } else if (end == nc::EndWord::Ret) {
        return left;
      }
      at = token.text.data() + token.text.size();
    }
  }
  return left;
}

/// After such a block the same coordinates may be another place.
bool mayShift(const NativeBlock& native) {
  switch (native.reason) {
    case NativeReason::Transformation:
    case NativeReason::Cycle:
    case NativeReason::Subprogram:
    case NativeReason::Retract:  // D0
    case NativeReason::Tool:
    case NativeReason::WorkOffset:
    case NativeReason::Other:
      return true;
    default:
      return native.setsFrame;
  }
}

/// Goes through a plan: what stands before a native block, so that it runs in the modal state of
/// the source program, and the frame that a stretch must not have.
class PlanWriter {
 public:
  explicit PlanWriter(const Plan& plan) : m_plan(plan) {}
  virtual ~PlanWriter() = default;

 protected:
  /// What stands in place of a stretch.
  virtual void writeStreamed(const Stretch& stretch) = 0;
  /// Before a native block. @param number  of it, from 1
  virtual void writeDue(const NativeBlock& native, int number) = 0;
  /// What is written of a native block.
  [[nodiscard]] virtual const std::string& textOf(const NativeBlock& native) const {
    return native.text;
  }
  /// Just before the text of a native block.
  virtual void beforeText(const std::string& /*text*/) {}
  /// The text of a native block has just been written.
  virtual void written(const NativeBlock& /*native*/, int /*number*/) {}

  void writeParts(std::size_t until) {
    bool isAfterNative = false;
    for (std::size_t at = 0; at < std::min(until, m_plan.parts.size()); ++at) {
      const Part& part = m_plan.parts[at];
      if (const auto* const native = std::get_if<NativeBlock>(&part)) {
        ++m_natives;
        if (!native->text.empty()) {
          writeNative(*native, isAfterNative);
          isAfterNative = !native->isInserted;
        }
        continue;
      }
      isAfterNative = false;
      if (const auto& stretch = std::get<Stretch>(part); stretch.number > 0) {
        line("; STRETCH {}: lines {} to {}, {} points", stretch.number,
             stretch.blocks.front().line.value, stretch.blocks.back().line.value,
             stretch.pointCount);
        line("G710 DIAMOF G40");
        cancelFrame();
        writeStreamed(stretch);
      }
    }
  }

  template <class... Arguments>
  void line(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(m_text), text, std::forward<Arguments>(arguments)...);
    m_text += '\n';
    ++m_lines;
  }
  /// @param text  one line or several
  void lines(const std::string& text) {
    m_text += text;
    m_text += '\n';
    m_lines += 1 + static_cast<unsigned>(std::count(text.begin(), text.end(), '\n'));
  }

  /// Only if there is one: after TRANS an increment counts from the coordinates before it, even if
  /// nothing has changed but the tool.
  void cancelFrame() {
    if (m_hasFrame) {
      line("TRANS");
      m_hasFrame = false;
    }
  }

  /// The feed of streamed points has the override in it already.
  void cancelOverride() {
    if (m_hasOverride) {
      line("OVR=100");
      m_hasOverride = false;
    }
  }

  [[nodiscard]] const Plan& plan() const { return m_plan; }
  [[nodiscard]] unsigned lineCount() const { return m_lines; }
  [[nodiscard]] std::string take() { return std::move(m_text); }

 private:
  void writeNative(const NativeBlock& native, bool isAfterNative) {
    line("; LINE {}{}: {}", native.file.empty() ? std::string() : native.file + " ",
         native.place.line.value, nativeReasonName(native.reason));
    writeDue(native, m_natives);
    const bool isForeign = m_plan.program.dialect != nc::Dialect::Sinumerik;
    if (isForeign) {
      line("G17 G90 G94 G710 DIAMOF");  // a tool length of the others acts along Z in each plane
    } else if (!isAfterNative) {
      line("G710 DIAMOF");
      cancelFrame();
      for (const std::string& frame : native.frame) {
        line("{}", frame);
      }
      if (native.before.feedOverride == 1.0) {
        cancelOverride();
      }
      line("{}", modalWords(native.before));
      m_hasFrame = !native.frame.empty();
    }
    beforeText(textOf(native));
    lines(textOf(native));
    written(native, m_natives);
    m_hasOverride = m_hasOverride || native.before.feedOverride != 1.0 ||
                    base::toUpper(native.text).find("OVR") != std::string::npos;
    m_hasFrame = m_hasFrame || native.setsFrame || native.reason == NativeReason::Subprogram;
  }

  const Plan& m_plan;
  std::string m_text;
  unsigned m_lines = 0;
  int m_natives = 0;
  bool m_hasFrame = false;     ///< the control may have one
  bool m_hasOverride = false;  ///< the same
};

class MainWriter final : public PlanWriter {
 public:
  MainWriter(const Plan& plan, const templates::JobLoop& loop, int number)
      : PlanWriter(plan), m_loop(loop), m_number(number) {
    for (const Part& part : plan.parts) {
      const auto* const native = std::get_if<NativeBlock>(&part);
      if (native == nullptr || !native->text.empty()) {
        m_last = native;
      }
    }
    m_lastText = m_last != nullptr ? withoutEnd(m_last->text) : std::string();
  }

  std::string write() {
    writeHead();
    writeParts(plan().parts.size());
    writeDone();
    line("RIV_END:");
    line("M30");
    return take();
  }

 private:
  void writeHead() {
    line("; RIVULET JOB {}: {} OF {}", m_number, plan().program.hash, plan().program.name);
    line("; {} stretches are streamed by the client, {} blocks are executed here.",
         plan().stretchCount(), plan().nativeCount());
    line("; Do not edit: the client relies on every line. Needs {}.", m_loop.name);
    line("; Nothing moves before the client has connected.");
    line("EXTERN {}(REAL,REAL,REAL)", subprogramName(m_loop));
    line("DEF REAL RIV_RUN");
    for (const std::string& block : templates::feedCellBlocks(m_loop.cells)) {
      line("{}", block);
    }
    line("{}({},0,0)", subprogramName(m_loop), m_number);
    line("IF R{}<>{} GOTOF RIV_END", m_loop.cells.state,
         static_cast<int>(templates::WindowState::Done));
    line("RIV_RUN=R{}", m_loop.cells.owner);
    writeBlock(0);
    line("R{}={}", m_loop.cells.run, JobProtocol::goOn(0));
  }

  void writeStreamed(const Stretch& stretch) override {
    // The loop clears its cells when it is interpreted: not before the native blocks are done.
    cancelOverride();
    line("STOPRE");
    writeBlock(-m_due);
    line("{}({},{},RIV_RUN+{})", subprogramName(m_loop), m_number, stretch.number, stretch.number);
    line("IF R{}<>{} GOTOF RIV_END", m_loop.cells.state,
         static_cast<int>(templates::WindowState::Done));
    writeBlock(0);
    m_due = 0;
  }

  /// The block cell is written when the axes have got there: what is interpreted is far ahead of
  /// them, and a reset would leave the number of a block that nobody has executed.
  void writeDue(const NativeBlock& native, int number) override {
    m_due = number;
    m_isDueWithMotion = false;
    if (&native == m_last && base::trim(m_lastText).empty()) {
      return;
    }
    if (mayWaitBefore(native.reason)) {
      writeWait(number - 1);
      writeBlock(number);
    } else if (native.reason == NativeReason::Retract) {
      line("STOPRE");
      writeBlock(number);
    } else {
      m_isDueWithMotion = true;
    }
  }

  void writeDone() {
    line("STOPRE");
    writeBlock(doneNumber(plan()));
  }

  void writeBlock(int value) {
    line("R{}={}", blockCell(m_loop), value);
    m_block = value;
  }

  /// A trace of the control names lines alone: where the loop moves, this program does not.
  void beforeText(const std::string& text) override {
    if (m_isDueWithMotion) {
      // In the main run, with the block that follows; too late, if that is not one of the main run.
      line("WHEN $R{0}=={1} DO $R{0}={2}", blockCell(m_loop), m_block, m_due);
      m_block = m_due;
    }
    const auto count = 1 + static_cast<unsigned>(std::count(text.begin(), text.end(), '\n'));
    const auto isTaken = [this, count](std::uint32_t motion) {
      return motion > lineCount() && motion <= lineCount() + count;
    };
    while (std::any_of(m_loop.motionLines.begin(), m_loop.motionLines.end(), isTaken)) {
      line(";");
    }
  }

  /// Stop and hold between two native blocks. The axes stand. @param done  blocks up to here
  void writeWait(int done) {
    ++m_waits;
    line("STOPRE");
    writeBlock(-done);
    line("RIV_W{}:", m_waits);
    line("STOPRE");
    line("IF R{}=={} GOTOF RIV_END", m_loop.cells.run, WindowProtocol::kEnd);
    line("IF R{}<>{} GOTOF RIV_G{}", m_loop.cells.run, WindowProtocol::kHold, m_waits);
    line("G4 F0.02");
    line("GOTOB RIV_W{}", m_waits);
    line("RIV_G{}:", m_waits);
  }

  [[nodiscard]] const std::string& textOf(const NativeBlock& native) const override {
    return &native == m_last ? m_lastText : native.text;
  }

  const templates::JobLoop& m_loop;
  int m_number;
  const NativeBlock* m_last = nullptr;  ///< with which the job ends; null: with a stretch
  std::string m_lastText;               ///< without the end of the program
  int m_waits = 0;
  int m_due = 0;    ///< the last native block since the stretch; 0: none
  int m_block = 0;  ///< in the block cell, where the program is
  bool m_isDueWithMotion = false;
};

/// The words of a point, "X1 Y2 C90", as far as the program has named the axes.
std::string pointWords(const gcode::Trajectory& trajectory, std::size_t point) {
  std::string words;
  const auto add = [&words](char axis, double value) {
    if (!std::isnan(value)) {
      words += fmt::format("{}{} ", axis, nc::ncNumber(value));
    }
  };
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    add(base::kAxisNames[axis], trajectory.points[point].positionMm[axis]);
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount && !trajectory.rotary.empty(); ++axis) {
    add(base::kRotaryAxisNames[axis], trajectory.rotary[point].degrees[axis]);
  }
  return words;
}

class PlainWriter final : public PlanWriter {
 public:
  PlainWriter(const Plan& plan, const std::optional<gcode::ProgramFeeds>& feeds, double feedMmPerS)
      : PlanWriter(plan), m_feeds(feeds), m_feedMmPerS(feedMmPerS) {}

  std::string write() {
    writeParts(plan().parts.size());
    line("M30");
    return take();
  }

 private:
  void writeStreamed(const Stretch& stretch) override {
    const gcode::Trajectory& trajectory = plan().program.trajectory;
    cancelOverride();
    line("G90 G94 G64");
    for (std::size_t i = 0; i < stretch.pointCount; ++i) {
      const std::size_t point = stretch.firstPoint + i;
      const double mmPerS =
          m_feeds ? gcode::commandedMmPerS(trajectory.points[point], *m_feeds) : m_feedMmPerS;
      line("G1 {}F{}", pointWords(trajectory, point),
           nc::ncNumber(base::mmPerMinFromMmPerS(mmPerS)));
    }
  }
  void writeDue(const NativeBlock&, int) override {}

  const std::optional<gcode::ProgramFeeds>& m_feeds;
  double m_feedMmPerS;
};

class OutlineWriter final : public PlanWriter {
 public:
  using PlanWriter::PlanWriter;

  Outline write(std::size_t untilPart) {
    writeParts(untilPart);
    cancelFrame();
    line("M30");
    m_outline.text = take();
    m_outline.lines.resize(lineCount());
    return std::move(m_outline);
  }

 private:
  /// What was inserted may read the position of the axes, which is not known here.
  [[nodiscard]] const std::string& textOf(const NativeBlock& native) const override {
    return native.isInserted ? native.source : native.text;
  }
  void writeStreamed(const Stretch& stretch) override {
    const gcode::Trajectory& trajectory = plan().program.trajectory;
    for (const std::size_t point : extremes(stretch)) {
      line("G0 G90 {}", pointWords(trajectory, point));
      place({0, stretch.number, trajectory.points[point].line});
    }
  }
  void writeDue(const NativeBlock& native, int number) override {
    place({number, 0, native.place.line});
  }
  void written(const NativeBlock& native, int number) override {
    place({number, 0, native.place.line});
  }

  /// All lines since the last call stand for this.
  void place(const OutlineLine& what) { m_outline.lines.resize(lineCount(), what); }

  /// In each axis the farthest points either way, and the last one, in their order.
  [[nodiscard]] std::vector<std::size_t> extremes(const Stretch& stretch) const {
    const gcode::Trajectory& trajectory = plan().program.trajectory;
    const std::size_t last = stretch.firstPoint + stretch.pointCount - 1;
    std::vector<std::size_t> points{last};
    const auto search = [&](const auto& valueAt) {
      std::size_t low = last;
      std::size_t high = last;
      for (std::size_t point = stretch.firstPoint; point < last; ++point) {
        // Not known at the end: not known before it either.
        low = valueAt(point) < valueAt(low) ? point : low;
        high = valueAt(point) > valueAt(high) ? point : high;
      }
      points.insert(points.end(), {low, high});
    };
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      search([&](std::size_t point) { return trajectory.points[point].positionMm[axis]; });
    }
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount && !trajectory.rotary.empty();
         ++axis) {
      search([&](std::size_t point) { return trajectory.rotary[point].degrees[axis]; });
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
  }

  Outline m_outline;
};

}  // namespace

base::Result<void> requireWhole(const Plan& plan) {
  if (!plan.isWhole()) {
    const auto isError = [](const gcode::Diagnostic& found) {
      return found.severity == gcode::Severity::Error;
    };
    const auto& found = plan.program.diagnostics;
    const auto first = std::find_if(found.begin(), found.end(), isError);
    const auto reading = std::find_if(found.begin(), found.end(), [](const auto& each) {
      return each.code == gcode::DiagnosticCode::CentreReading;
    });
    if (first != found.end() && reading != found.end() &&
        first->code == gcode::DiagnosticCode::ArcRadiusMismatch) {
      return base::fail(
          JobError::NotWhole,
          fmt::format(
              "Not all arcs fit as their centres are written, but all fit if I, J and K are "
              "read as {0}: if the post-processor writes them so, confirm it with "
              "--arc-centres {0}.",
              reading->argument),
          fmt::format("{}:{}", plan.program.name, first->line.value));
    }
    return plan.refusals.empty()
               ? base::fail(JobError::NotWhole, gcode::describe(*first),
                            fmt::format("{}:{}", plan.program.name, first->line.value))
               : base::fail(
                     JobError::NotWhole, describe(plan.refusals.front()),
                     fmt::format("{}:{}", plan.program.name, plan.refusals.front().line.value));
  }
  // An increment also passes the shift of a tool, offset or frame, unless the axis has been placed
  // since: which streaming does with every axis.
  std::array<bool, base::kAxisCount> isShifted{};   ///< the axis has not been placed since
  std::array<bool, base::kAxisCount> losesShift{};  ///< and a stretch has been streamed
  bool isAfterNative = false;
  for (const Part& part : plan.parts) {
    const auto* const native = std::get_if<NativeBlock>(&part);
    if (native == nullptr) {
      const auto& stretch = std::get<Stretch>(part);
      for (std::size_t axis = 0; axis < base::kAxisCount && stretch.number > 0; ++axis) {
        const std::size_t last = stretch.firstPoint + stretch.pointCount - 1;
        isShifted[axis] =
            isShifted[axis] && std::isnan(plan.program.trajectory.points[last].positionMm[axis]);
        losesShift[axis] = isShifted[axis];
      }
      isAfterNative = false;
      continue;
    }
    const auto refuse = [&](JobError code, const char* reason) {
      return base::fail(code, reason + native->source,
                        fmt::format("{}:{}", plan.program.name, native->place.line.value));
    };
    if (native->calculates) {
      return refuse(JobError::ReadsVariables,
                    "A block for the control reads variables, whose values only Rivulet has "
                    "computed. Write the values into it: ");
    }
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const bool hasFrame = !native->frame.empty() || native->before.incrementFrom[axis];
      if (native->increments[axis] && (losesShift[axis] || (hasFrame && !isAfterNative))) {
        return refuse(JobError::IncrementInFrame,
                      "A block for the control moves by an increment after a tool, an offset or a "
                      "frame has shifted the axis. Write it with G90: ");
      }
      const bool shifts = mayShift(*native) && native->shifts[axis];
      isShifted[axis] = (isShifted[axis] || shifts) && !native->places[axis];
      losesShift[axis] = losesShift[axis] && !native->places[axis];
    }
    isAfterNative = true;
  }
  if (plan.stretchCount() > static_cast<std::size_t>(JobProtocol::kStretchesMax)) {
    return base::fail(JobError::TooManyStretches,
                      fmt::format("The program has {} stretches, more than {}: split it.",
                                  plan.stretchCount(), JobProtocol::kStretchesMax));
  }
  return {};
}

std::string plainProgramOf(const Plan& plan, const std::optional<gcode::ProgramFeeds>& feeds,
                           double feedMmPerS) {
  return PlainWriter(plan, feeds, feedMmPerS).write();
}

std::error_code make_error_code(JobError code) {
  static const Category category;
  return {static_cast<int>(code), category};
}

int doneNumber(const Plan& plan) {
  return static_cast<int>(plan.nativeCount()) + 1;
}

int blockCell(const templates::JobLoop& loop) {
  return loop.cells.client;
}

std::string modalWords(const nc::ModalState& state) {
  static constexpr std::array<std::string_view, 4> kMotions{"G0", "G1", "G2", "G3"};
  std::string words;
  if (state.motion < nc::Motion::None) {
    words += fmt::format("{} ", kMotions[static_cast<std::size_t>(state.motion)]);
  }
  words += state.planeFirstAxis == 0 ? "G17" : state.planeFirstAxis == 2 ? "G18" : "G19";
  words += state.relative ? " G91" : " G90";
  const bool inches = state.lengthFactor != 1.0;
  words += !inches ? " G710" : state.feedFactor != 1.0 ? " G700" : " G70";
  words += !state.diameter ? " DIAMOF" : state.diameterIncrements ? " DIAMON" : " DIAM90";
  words += state.blockEnd == nc::BlockEnd::ExactStop ? " G60" : " G64";
  if (state.feedMode == nc::FeedMode::PerRevolution) {
    words += " G95";
    if (state.feedMmPerRev > 0.0) {
      words += " F" + nc::ncNumber(state.feedMmPerRev / state.lengthFactor);
    }
  } else if (state.feedMode == nc::FeedMode::InverseTime) {
    words += " G93";
  } else {
    words += " G94";
    if (state.feedMmPerS > 0.0) {
      words += " F" + nc::ncNumber(state.feedMmPerS * 60.0 / state.feedFactor);
    }
  }
  if (state.feedOverride != 1.0) {
    words += " OVR=" + nc::ncNumber(100.0 * state.feedOverride);
  }
  return words;
}

Outline outlineOf(const Plan& plan, std::size_t untilPart) {
  return OutlineWriter(plan).write(untilPart);
}

std::string mainNameOf(const JobName& name) {
  return fmt::format("{}{}B{}.MPF", kNamePrefix, name.number, name.baseCell);
}

std::optional<JobName> jobNameOf(std::string_view fileName) {
  const std::string name = base::toUpper(fileName);
  const std::size_t begin = name.rfind(kNamePrefix);
  if (begin == std::string::npos) {
    return std::nullopt;
  }
  const std::string_view rest = std::string_view(name).substr(begin + kNamePrefix.size());
  const std::size_t cell = rest.find('B');
  if (cell == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view digits = rest.substr(cell + 1);
  const auto number = base::parseInteger(rest.substr(0, cell));
  const auto baseCell = base::parseInteger(
      digits.substr(0, std::min(digits.size(), digits.find_first_not_of("0123456789"))));
  return number && baseCell ? std::optional(JobName{*number, *baseCell}) : std::nullopt;
}

base::Result<JobPrograms> makePrograms(const Plan& plan,
                                       const templates::TemplateParameters& parameters) {
  if (base::Result<void> whole = requireWhole(plan); !whole) {
    return base::fail(whole.error());
  }
  base::Result<templates::JobLoop> loop = templates::makeJobLoop(parameters);
  if (!loop) {
    return base::fail(loop.error());
  }
  constexpr std::uint64_t kNumbers = (1U << 24U) - 1;
  JobPrograms programs;
  const std::string unnumbered = MainWriter(plan, *loop, 0).write();
  programs.number = 1 + static_cast<int>(base::hashOf(unnumbered + loop->text) % kNumbers);
  programs.mainName = mainNameOf({programs.number, parameters.baseCell});
  programs.mainText = MainWriter(plan, *loop, programs.number).write();
  programs.loop = std::move(*loop);
  return programs;
}

}  // namespace rivulet::job
