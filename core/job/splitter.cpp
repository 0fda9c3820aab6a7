// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Splits a program while it is interpreted: what the executor tells of a block decides who executes
// it.

#include <fmt/format.h>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/contract.h"
#include "base/hash.h"
#include "base/text.h"
#include "gcode/block_observer.h"
#include "gcode/interpreter.h"
#include "job/hole_cycles.h"
#include "job/motion_text.h"
#include "job/plan.h"
#include "job/regions.h"
#include "job/translation.h"
#include "nc/eval/evaluate.h"
#include "nc/function_number.h"
#include "nc/nc_number.h"
#include "nc/syntax/expression.h"

namespace rivulet::job {

namespace {

using nc::FaultCode;
using nc::MachineWord;
using nc::Motion;
using nc::Severity;
using nc::Token;
using nc::TokenKind;

/// Chords of an arc, where only what it reaches counts.
constexpr double kReachMm = 0.1;

constexpr int kTipOffOfTnc = 129;
/// M functions of a TNC that switch off what no job has on: M101, M110, M116, M144, M148, and M128
/// in most.
constexpr std::array kSwitchOff{102, 111, 117, 129, 145, 149};

/// M functions that the five-axis configurations of LinuxCNC have for its kinematics: X, Y and Z
/// are those of the tool's tip, or of the axes.
constexpr int kTipOn = 428;
constexpr int kTipOff = 429;
/// G41.1, G42.1
constexpr int kLeftByDiameter = 411;
constexpr int kRightByDiameter = 421;

/// The motion of a block can be streamed without such a word.
bool isSeparable(NativeReason reason) {
  return reason >= NativeReason::Tool;
}

std::string placeWord(char axis, double value) {
  return fmt::format("{}={}", axis, nc::ncNumber(value));
}
std::string incrementWord(char axis, double value) {
  return fmt::format("{}=IC({})", axis, nc::ncNumber(value));
}

/// A curve that goes over several blocks.
bool isLongCurve(Motion motion) {
  return motion == Motion::BSpline || motion == Motion::Nurbs;
}

/// The arguments of a call, or nothing if they cannot be read.
std::optional<std::vector<std::optional<nc::Expression>>> argumentsOf(const Token& token) {
  const std::size_t open = token.text.find('(');
  if (open == std::string_view::npos) {
    return std::nullopt;
  }
  nc::Reader reader(token.text.substr(open), nc::sinumerikNotation());
  auto arguments = reader.arguments();
  return arguments ? std::optional(*std::move(arguments)) : std::nullopt;
}

/// True if a call or calculation needs a value that only Rivulet has computed. What asks the
/// control for all it reads ($P_TOOLNO) does not.
bool readsVariables(const Token& token) {
  const auto isOwn = [](const nc::Expression& expression) {
    bool found = false;
    nc::forEachNode(expression, [&found](const nc::Expression& node) {
      found =
          found || node.op == nc::Op::R || node.op == nc::Op::Variable || node.op == nc::Op::Hash;
    });
    return found;
  };
  if (token.calculation != nullptr) {
    const nc::Expression* const value = token.calculated();
    return value == nullptr || isOwn(*value);
  }
  if (token.kind != TokenKind::Call) {
    return false;
  }
  const auto arguments = argumentsOf(token);
  return !arguments || std::any_of(arguments->begin(), arguments->end(), [&](const auto& argument) {
    return argument && isOwn(*argument);
  });
}

/// A fault or note of a block, kept until it is known who executes the block.
struct Heard {
  enum class Kind : unsigned char { Report, Word, G, M, Letter };
  Kind kind = Kind::Report;
  Severity severity = Severity::Note;
  int number = 0;  ///< column, key of G, number of M
  FaultCode code = FaultCode::IgnoredCode;
  std::string text;
  Token token;
};

/// What stands for a calculation in a block of the control: written only if the control gets it.
struct Stand {
  const Token* token = nullptr;
  std::optional<double> number;  ///< that the address gets; nothing: see `text`
  std::string text;
};

std::string textOf(const Stand& stand) {
  if (!stand.number) {
    return stand.text;
  }
  const std::string_view address = stand.token->text.substr(0, stand.token->text.find('='));
  const std::string_view from = nc::referenceWord((*stand.token->calculation)->reference);
  const std::string text = nc::ncNumber(*stand.number);
  return from.empty() ? fmt::format("{}={}", address, text)
                      : fmt::format("{}={}({})", address, from, text);
}

/// What is not known of the position behind a block.
struct Forgets {
  bool all = false;
  bool named = false;  ///< the axes it names
  /// Along these axes a tool length acts, or acted, that it changes.
  std::array<bool, base::kAxisCount> length{};
};

/// What only the control knows of the position from which a block moves.
struct Unknown {
  bool turns = false;  ///< a rotary axis, how far only the control knows
  bool beginsArc = false;
  /// It moves the axis by an increment from there.
  std::array<bool, base::kAxisCount> axis{};
  std::array<bool, base::kRotaryAxisCount> rotary{};
};

/// What one block says.
struct BlockNotes {
  explicit BlockNotes(const nc::ModalState& state) : before(state) {}

  nc::Place place;
  std::string_view text;
  std::span<const Token> tokens;
  bool isInSubprogram = false;
  nc::ModalState before;
  std::vector<std::string> frame;  ///< before it
  base::Vec3 startMm;              ///< workpiece frame
  std::size_t firstPoint = 0;
  bool continuesCurve = false;  ///< one was in progress

  std::optional<NativeReason> reason;  ///< of its own words
  std::optional<NativeReason> region;
  bool isSeparable = true;  ///< its words do not concern its motion
  Forgets forgets;
  Unknown unknown;
  bool isMissing = false;  ///< the subprogram it calls is not at hand
  bool calls = false;
  bool moves = false;
  bool movesAlongTool = false;  ///< in coordinates of the workpiece
  bool setsFrame = false;
  std::array<bool, base::kAxisCount> increments{};
  std::bitset<nc::kProgrammedAxisCount> given;  ///< axes that it names
  std::vector<ForeignWord> words;
  std::optional<HomeMove> home;
  std::string fixedPoint;           ///< "G28": it goes to such a point; empty: it does not
  bool isInHoleCycle = false;       ///< the position after it is known
  std::vector<std::string> motion;  ///< its moves as lines for the control (not SINUMERIK)
  std::string corner;               ///< ,R or ,C
  const nc::Variables* variables = nullptr;
  std::vector<Heard> heard;
  std::vector<Stand> values;

  [[nodiscard]] const Stand* valueOf(const Token& token) const {
    const auto found = std::find_if(values.begin(), values.end(),
                                    [&token](const Stand& each) { return each.token == &token; });
    return found == values.end() ? nullptr : &*found;
  }
};

class Splitter final : public gcode::BlockObserver,
                       private nc::PathSink,
                       private nc::FaultSink,
                       private nc::WordObserver {
 public:
  Splitter(const gcode::LoadOptions& options, const Profile& profile,
           std::function<void(const Part&)> each)
      : m_options(options),
        m_profile(profile),
        m_translator(profile, options.accepted),
        m_holes(options.settings),
        m_each(std::move(each)) {}

  [[nodiscard]] std::size_t nativeBlocks() const override { return m_parts.size(); }
  [[nodiscard]] std::size_t memoryBytes() const override {
    return base::Budget::bytesOf(m_parts) + m_textBytes + (m_open ? m_open->blocks.bytes() : 0);
  }
  [[nodiscard]] bool knowsFrame() const override { return m_knowsFrame; }

  nc::Sinks observe(const nc::Language& language, nc::Sinks own) override {
    m_language = &language;
    m_own.emplace(own);
    return {*this, *this, *this};
  }

  void begin(const gcode::SourceBlock& block, nc::Executor& executor) override {
    m_executor = &executor;
    m_fileName = &block.fileName;
    m_block.emplace(executor.state());
    m_block->place = block.place;
    m_block->text = block.text;
    m_block->tokens = block.tokens;
    m_block->isInSubprogram = block.isInSubprogram;
    m_block->variables = &block.variables;
    m_block->frame = m_frame;
    const nc::Position& position = executor.start();
    m_block->startMm = position.frame.toWorkpiece(position.programmedMm);
    m_block->firstPoint = m_points;
    m_block->continuesCurve = isLongCurve(executor.state().motion);
    if (!isForeign()) {
      noteValues(block);
    }
  }

  void executed(const nc::BlockWords& words, nc::Executor& executor) override {
    BlockNotes& block = *m_block;
    if (block.reason == NativeReason::UnknownPosition && isLongCurve(executor.state().motion)) {
      m_regions.curve();
    }
    block.calls = words.rare && (words.rare->call || words.rare->call98 || words.rare->macroCall);
    block.moves = words.moves() || words.hasAnyCentre();
    block.setsFrame = words.rare && !words.rare->frame.empty();
    block.given = words.axes.named;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      block.increments[axis] = isForeign() ? block.unknown.axis[axis]
                                           : words.axes.has(axis) && words.axes.isIncrement(axis);
    }
    if ((words.ends || (words.rare && words.rare->returns)) && !block.isInSubprogram) {
      add(NativeReason::End);
      block.words.push_back({ForeignWord::Kind::M, 30.0, "M30"});
    }
    if (isForeign()) {
      endAtCorner(executor);
      drillHoles(words, executor);
      keepIncrements(words, executor);
      setWorkOffset(words, executor);
      selectListedOffset(words);
      noteSetPosition(words);
    }
    if (!isForeign() && executor.state().planeFirstAxis != block.before.planeFirstAxis) {
      addLength();  // it now acts on another axis
    }
    noteFrame(words, executor.state());
    if (block.reason == NativeReason::Retract) {
      block.home.emplace();
      block.home->toFixedPoint = !block.fixedPoint.empty();
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        if (words.axes.has(axis)) {
          block.home->targetMm[axis] = words.axes.value[axis] * executor.state().lengthFactor;
        }
        if (const std::size_t rotary = axis + nc::kFirstRotary; block.given[rotary]) {
          block.home->targetDeg[axis] = words.axes.value[rotary];
        }
      }
    }
    // LinuxCNC moves with the feed there; the translation is rapid.
    if (block.home && block.fixedPoint.empty() && m_language->dialect == nc::Dialect::LinuxCnc &&
        executor.state().motion != Motion::Rapid) {
      refuse(RefusalCode::NotTranslated, "G53 G1");
    }
    for (std::size_t axis = nc::kFirstFurther; block.home && axis < nc::kProgrammedAxisCount;
         ++axis) {
      if (words.axes.has(axis)) {
        addMachineAxis(*words.axes.token[axis]);
      }
    }
    block.region = regionReason();
    m_regions.blockExecuted(words, executor.state());
    constexpr std::size_t kToolAxis = 2;
    block.movesAlongTool = words.axes.has(kToolAxis) && !words.taken && !words.dwell && !block.home;
  }

  void modalCall(std::string_view name) override {
    add(NativeReason::Cycle);
    m_regions.modalCall(!name.empty());
  }

  void end(nc::Executor& executor, std::size_t points) override {
    m_points = points;
    BlockNotes& block = *m_block;
    const std::optional<NativeReason> reason = nativeReason();
    if (!reason) {
      forward();
      stretch().blocks.add(block.place);
    } else if (isForeign()) {
      endForeign(*reason);
    } else {
      closeStretch(points);
      pushNative(*reason, verbatim(), block.before);
      noteInterruption();
    }
    if (block.movesAlongTool && !m_translator.foreignLength().empty() &&
        m_keptLength != m_translator.foreignLength()) {
      m_keptLength = m_translator.foreignLength();  // once for each change
      if (m_profile.assumesTool) {
        assumeLength(m_keptLength);
      } else {
        refuse(RefusalCode::LengthKept, m_keptLength);
      }
    }
    if (reason) {
      constexpr std::array kMayChangeFrame{NativeReason::Transformation, NativeReason::Subprogram,
                                           NativeReason::Probing, NativeReason::Other};
      m_knowsFrame = m_knowsFrame && std::find(kMayChangeFrame.begin(), kMayChangeFrame.end(),
                                               *reason) == kMayChangeFrame.end();
      forgetPosition(*reason);
    }
    if (isForeign() && block.home && block.home->targetMm[2]) {
      m_wayUp = m_translator.wayUp(*block.home);
    }
    const Motion motion = executor.state().motion;
    m_curveIsStreamed = isLongCurve(motion) && !reason;
    m_block.reset();
  }

  void finish(std::size_t points) override { closeStretch(points); }

  void take(Plan& plan) {
    plan.parts = std::move(m_parts);
    plan.refusals = std::move(m_refusals);
    for (const gcode::TrajectoryPoint& point : plan.program.trajectory.points) {
      reach(point.positionMm);
    }
    for (auto& [name, use] : m_functions) {
      plan.functions.push_back(std::move(use));
    }
    plan.lastEdge = m_lastEdge;
    plan.assumedTool = m_assumed.tool;
    plan.assumedLengths = std::move(m_assumed.lengths);
    plan.minMm = m_box.minMm;
    plan.maxMm = m_box.maxMm;
  }

 private:
  // --- moves of other dialects that the control makes
  // ---------------------------------------------

  /// Canned cycles.
  void drillHoles(const nc::BlockWords& words, nc::Executor& executor) {
    BlockNotes& block = *m_block;
    if (executor.state().motion != Motion::Unsupported) {
      m_holes.end();
    }
    if (!m_holes.isOn()) {
      return;
    }
    block.isInHoleCycle = true;
    if (words.taken || words.dwell || words.machineToken != nullptr || !block.fixedPoint.empty()) {
      return;
    }
    auto lines = m_holes.drill(words, dwellSeconds(words), executor, m_wayUp);
    noteSettings();
    if (lines) {
      block.motion = *std::move(lines);
      return;
    }
    block.isInHoleCycle = false;
    if (isAccepted(m_cycleWord)) {
      return;
    }
    if (lines.error().empty()) {
      refuse(RefusalCode::StartUnknown, std::string(base::trim(block.text)));
    } else {
      refuse(RefusalCode::CycleIncomplete, fmt::format("{} ({})", m_cycleWord, lines.error()));
    }
  }

  /// What the holes of this block take from settings is said once for each cycle.
  void noteSettings() {
    const gcode::ControlSettings& taken = m_holes.taken();
    if (taken.empty()) {
      return;
    }
    m_own->faults.report(Severity::Warning, 1, FaultCode::ControlSettingOpen,
                         fmt::format("{}: {}", m_cycleWord, gcode::textOf(taken)));
  }

  /// P of a cycle. @return nothing: there is none
  [[nodiscard]] std::optional<double> dwellSeconds(const nc::BlockWords& words) const {
    const auto& tokens = m_block->tokens;
    const auto token = std::find_if(tokens.begin(), tokens.end(),
                                    [](const Token& each) { return each.address == 'P'; });
    if (!words.p || token == tokens.end()) {
      return std::nullopt;
    }
    // Fanuc counts milliseconds where there is no point.
    return m_language->dwellInMilliseconds && !token->hasPoint ? *words.p / 1000.0 : *words.p;
  }

  /// Of a word, also where it is calculated.
  [[nodiscard]] std::optional<double> numberOf(const Token& token) const {
    const nc::Expression* const calculated = token.calculated();
    if (calculated == nullptr) {
      return token.kind == TokenKind::Word ? std::optional(token.value) : std::nullopt;
    }
    const nc::Expected<double> number = m_block->variables->number(*calculated);
    return number ? std::optional(*number) : std::nullopt;
  }

  /// G41.1 D6: beside the contour by half of D, whatever the tool. What its radius lacks is an
  /// allowance.
  void compensateBy(int key, std::string word) {
    const auto& tokens = m_block->tokens;
    const auto token = std::find_if(tokens.begin(), tokens.end(),
                                    [](const Token& each) { return each.address == 'D'; });
    const std::optional<double> diameter = token == tokens.end() ? std::nullopt : numberOf(*token);
    if (!diameter || !std::isfinite(*diameter)) {
      m_block->words.push_back({ForeignWord::Kind::Other, 0.0, std::move(word)});
      return;
    }
    // LinuxCNC: a negative D is that of the other side.
    const bool isLeft = (key == kLeftByDiameter) == (*diameter >= 0.0);
    const double radiusMm = std::abs(*diameter) * m_executor->state().lengthFactor / 2.0;
    m_block->words.push_back(
        {ForeignWord::Kind::Compensation, 0.0,
         fmt::format("G{} OFFN={}-$P_TOOLR", isLeft ? 41 : 42, base::formatFixed(radiusMm, 6))});
    m_hasAllowance = true;
  }

  /// With DR of plain text the tool is so much larger than the table says.
  void compensate(int key, std::string word) {
    const auto& tokens = m_block->tokens;
    const auto token = std::find_if(tokens.begin(), tokens.end(), [](const Token& each) {
      return each.kind == TokenKind::NamedValue && each.text == "OFFN";
    });
    if (!isForeign() || token == tokens.end()) {
      m_block->words.push_back({ForeignWord::Kind::G, static_cast<double>(key), std::move(word)});
      return;
    }
    const double mm = token->value * m_executor->state().lengthFactor;
    m_block->words.push_back({ForeignWord::Kind::Line, 0.0,
                              fmt::format("G{} OFFN={}", key / 10, base::formatFixed(mm, 6))});
    m_hasAllowance = true;
  }

  /// ,R is RND and ,C is CHR: as much as it takes of both sides.
  void endAtCorner(nc::Executor& executor) {
    BlockNotes& block = *m_block;
    if (block.corner.empty()) {
      return;
    }
    const auto token = std::find_if(
        block.tokens.begin(), block.tokens.end(),
        [&block](const Token& each) { return base::toUpper(nc::tokenName(each)) == block.corner; });
    if (block.motion.empty() || token == block.tokens.end()) {
      block.words.push_back({ForeignWord::Kind::Other, 0.0, block.corner});
      return;
    }
    const double mm =
        token->value * executor.state().lengthFactor * executor.start().frame.stretchMax();
    block.motion.back() +=
        fmt::format(" {}={}", block.corner == ",R" ? "RND" : "CHR", base::formatFixed(mm, 6));
  }

  /// Moves that the control makes, so that their lines are kept.
  [[nodiscard]] bool keepsMoves() const {
    const std::optional<NativeReason> reason = nativeReason();
    return reason == NativeReason::RadiusCompensation || reason == NativeReason::Corner;
  }

  /// A straight move by increments from where only the control knows the axes to stand.
  void keepIncrements(const nc::BlockWords& words, nc::Executor& executor) {
    const BlockNotes& block = *m_block;
    if (block.unknown.beginsArc) {
      keepArcWithoutStart(words, executor);
      return;
    }
    const nc::ModalState& state = executor.state();
    const auto any = [](const auto& of) {
      return std::find(of.begin(), of.end(), true) != of.end();
    };
    const bool turns = any(block.unknown.rotary);
    if (!turns && !any(block.unknown.axis)) {
      return;
    }
    if (turns && !words.movesLinear() && !state.polar && !m_regions.reason()) {
      keepTurns(words, executor);
      return;
    }
    std::array<std::optional<double>, base::kAxisCount> incrementsMm;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (block.unknown.axis[axis]) {
        incrementsMm[axis] = words.axes.value[axis] * state.lengthFactor;
      }
    }
    const nc::Position& at = executor.start();
    const bool isRapid = state.motion == Motion::Rapid;
    const bool isPlain = !words.hasRotary && !state.diameter && !state.polar && !m_regions.reason();
    keepMotion(isPlain
                   ? incrementText(at.frame, block.startMm, at.frame.toWorkpiece(at.programmedMm),
                                   incrementsMm,
                                   isRapid ? std::nullopt : std::optional(executor.feedMmPerS()))
                   : std::nullopt);
  }

  /// A turn of rotary axes alone, some by increments.
  void keepTurns(const nc::BlockWords& words, nc::Executor& executor) {
    const nc::ModalState& state = executor.state();
    const bool isRapid = state.motion == Motion::Rapid;
    std::string line = isRapid ? "G0" : "G1";
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      const std::size_t word = axis + nc::kFirstRotary;
      if (words.axes.has(word)) {
        line +=
            ' ' + (m_block->unknown.rotary[axis]
                       ? incrementWord(base::kRotaryAxisNames[axis], words.axes.value[word])
                       : placeWord(base::kRotaryAxisNames[axis], executor.start().rotaryDeg[axis]));
      }
    }
    const double degPerMin = 60.0 * state.feedDegPerS * state.feedOverride;
    const bool hasFeed = state.feedMode == nc::FeedMode::PerMinute && degPerMin > 0.0;
    if (!isRapid && hasFeed) {
      line += " F" + nc::ncNumber(degPerMin);
    }
    keepMotion(isRapid || hasFeed ? std::optional(std::move(line)) : std::nullopt);
  }

  /// Its centre counts from there, and so the control can make it.
  void keepArcWithoutStart(const nc::BlockWords& words, nc::Executor& executor) {
    const BlockNotes& block = *m_block;
    const nc::ModalState& state = executor.state();
    const nc::Position& at = executor.start();
    ArcWithoutStart arc;
    arc.isClockwise = state.motion == Motion::ArcClockwise;
    arc.endMm = at.frame.toWorkpiece(at.programmedMm);
    arc.feedMmPerS = executor.feedMmPerS();
    bool isPlain = state.planeFirstAxis == 0 && !state.diameter && !state.polar &&
                   !state.centreIsAbsolute && !words.hasRotary && !words.p &&
                   m_options.centres == gcode::CentreReading::AsProgrammed;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (block.unknown.axis[axis]) {
        arc.incrementsMm[axis] = words.axes.value[axis] * state.lengthFactor;
      } else if (!block.given[axis]) {
        arc.endMm.set(axis, kNowhere);
      }
    }
    for (const Token& token : block.tokens) {
      const bool isCentre = token.address >= 'I' && token.address <= 'K';
      isPlain = isPlain && (!isCentre || (token.kind == TokenKind::Word && token.address != 'K'));
      if (isCentre && isPlain) {
        arc.centreMm[static_cast<std::size_t>(token.address - 'I')] =
            token.value * state.lengthFactor;
      }
    }
    if (words.hasRadius) {
      arc.radiusMm = words.radius * state.lengthFactor;
    }
    if (auto text = isPlain ? arcText(at.frame, arc) : std::nullopt) {
      keepMotion(std::move(text));
    } else {
      refuse(RefusalCode::StartUnknown, std::string(base::trim(block.text)));
    }
  }

  /// G10 L2. The executor adds the turn and the rotary axes to the path: the control has none.
  void setWorkOffset(const nc::BlockWords& words, nc::Executor& executor) {
    const bool sets = words.rare && words.rare->offset == nc::GEffect::SetWorkOffset && words.p &&
                      m_block->reason == NativeReason::WorkOffset;
    if (!sets) {
      return;
    }
    const std::optional<int> chosen = nc::functionNumber(*words.p);
    if (!chosen) {
      return;  // the reader has said so
    }
    const int active = executor.workOffsetNumber();
    const int number = *chosen == 0 ? active : *chosen;
    std::string line;
    const auto set = [&line, number](char axis, std::string_view what, double value) {
      line += fmt::format("{}$P_UIFR[{},{},{}]={}", line.empty() ? "" : " ", number, axis, what,
                          nc::ncNumber(value));
    };
    for (std::size_t axis = 0; axis < nc::kFirstFurther; ++axis) {
      if (words.axes.has(axis)) {
        const bool isLinear = axis < base::kAxisCount;
        set(nc::kProgrammedAxes[axis], "TR", isLinear ? executor.radiusMm(words, axis) : 0.0);
      }
    }
    if (words.hasRadius) {
      set('Z', "RT", 0.0);
    }
    m_block->words.push_back({ForeignWord::Kind::Line, 0.0, std::move(line)});
    if (number == active) {
      const int key = executor.state().workOffset;
      m_block->words.push_back({ForeignWord::Kind::Line, 0.0, workOffsetOf(key).value_or("G54")});
    }
  }

  /// G54.1 P1 and on: which settable frames they are is a matter of the control.
  void selectListedOffset(const nc::BlockWords& words) {
    const bool selects = words.rare && words.rare->workOffsetToken != nullptr && words.p;
    const auto word =
        std::find_if(m_block->words.begin(), m_block->words.end(), [](const ForeignWord& each) {
          constexpr std::array kListed{541.0, 1540.0};
          return each.kind == ForeignWord::Kind::G &&
                 std::find(kListed.begin(), kListed.end(), each.value) != kListed.end();
        });
    if (!selects || word == m_block->words.end()) {
      return;
    }
    constexpr auto kSetting = gcode::ControlSetting::Offset;
    constexpr double kLastFrame = 599.0;
    const auto given = m_options.settings.find(kSetting);
    const bool isGiven = given != m_options.settings.end();
    const double first = isGiven ? given->second : gcode::machineDefault(kSetting);
    const double frame = first + *words.p - 1.0;
    if (!(*words.p >= 1.0) || *words.p != std::floor(*words.p) || frame > kLastFrame) {
      return;  // refused as a word without a translation
    }
    if (!isGiven) {
      m_own->faults.report(Severity::Warning, 1, FaultCode::ControlSettingOpen,
                           fmt::format("{} P: {}", word->text, gcode::textOf({{kSetting, first}})));
    }
    *word = {ForeignWord::Kind::Line, 0.0, fmt::format("G{:.0f}", frame)};
  }

  /// G92 gives a place its coordinates. If only the control knows that place, nobody knows where
  /// motion after it goes. Before anything has moved, the operator has seen to it.
  void noteSetPosition(const nc::BlockWords& words) {
    const nc::GEffect offset = words.rare ? words.rare->offset : nc::GEffect::None;
    if (offset == nc::GEffect::ResetPosition || offset == nc::GEffect::SuspendPosition) {
      m_isSetUnknown.fill(false);
    }
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (!words.axes.has(axis)) {
        continue;
      }
      if (offset == nc::GEffect::SetPosition) {
        m_isSetUnknown[axis] = m_hasMoved[axis] && std::isnan(m_block->startMm[axis]);
      } else if (!words.taken) {
        m_hasMoved[axis] = true;
        if (words.machineToken == nullptr && m_isSetUnknown[axis] && !isAccepted("G92")) {
          refuse(RefusalCode::NotTranslated, "G92");
        }
      }
    }
  }

  [[nodiscard]] bool isArc() const {
    const Motion motion = m_executor->state().motion;
    return motion == Motion::ArcClockwise || motion == Motion::ArcCounter;
  }
  [[nodiscard]] bool isStraight() const {
    const Motion motion = m_executor->state().motion;
    return motion == Motion::Rapid || motion == Motion::Line;
  }

  /// A move that is not streamed, as the control gets it.
  void keepLine(const nc::Position& from, base::Vec3 targetMm, const nc::Move& move) {
    if (!keepsMoves()) {
      return;
    }
    const bool isRapid = move.motion == Motion::Rapid;
    keepMotion(move.turns ? std::nullopt
                          : std::optional(
                                lineText(from.frame.toWorkpiece(from.programmedMm),
                                         from.frame.toWorkpiece(targetMm),
                                         isRapid ? std::nullopt : std::optional(move.feedMmPerS))));
  }
  /// @param line  nothing: there is none for the control
  void keepMotion(std::optional<std::string> line) {
    if (line && !line->empty()) {
      m_block->motion.push_back(*std::move(line));
    } else if (line) {
      return;  // nothing moves
    } else {
      m_block->words.push_back(
          {ForeignWord::Kind::Other, 0.0, std::string(base::trim(m_block->text))});
    }
  }
  void refuseCurve() {
    if (isForeign() && keepsMoves()) {
      keepMotion(std::nullopt);
    }
  }

  /// fmin and fmax pass over the NaN of an axis that is not known.
  void reach(base::Vec3 placeMm) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      m_box.minMm.set(axis, std::fmin(m_box.minMm[axis], placeMm[axis]));
      m_box.maxMm.set(axis, std::fmax(m_box.maxMm[axis], placeMm[axis]));
    }
  }

  [[nodiscard]] bool isForeign() const { return m_language->dialect != nc::Dialect::Sinumerik; }

  [[nodiscard]] bool isAccepted(const std::string& name) const {
    const std::vector<std::string>& names = m_options.accepted;
    return !name.empty() && std::find(names.begin(), names.end(), name) != names.end();
  }

  /// The values that Rivulet has computed take the place of calculations: the control does not know
  /// the variables. A variable that is only set is Rivulet's.
  void noteValues(const gcode::SourceBlock& block) {
    for (const Token& token : block.tokens) {
      if (token.kind == TokenKind::Call) {
        noteArguments(token, block.variables);
      }
      if (token.calculation == nullptr || token.text.empty() || token.text.front() == '$') {
        continue;
      }
      const std::string name = base::toUpper(nc::tokenName(token));
      const bool isVariable = token.kind == TokenKind::Assignment &&
                              nc::nameEffect(m_language->dialect, name) == nc::NameEffect::Unknown;
      const nc::Expression* const value = token.calculated();
      if (isVariable) {
        m_block->values.push_back({&token, {}, {}});
      } else if (const nc::Expected<double> number =
                     value != nullptr ? block.variables.number(*value)
                                      : nc::Expected<double>(nc::fail(FaultCode::ListMalformed))) {
        m_block->values.push_back({&token, *number, {}});
      }
    }
  }

  /// CYCLE81(R1,0,2): a cycle of the control gets the values. A program of the user may write to
  /// its arguments.
  void noteArguments(const Token& token, const nc::Variables& variables) {
    const std::string name = base::toUpper(nc::tokenName(token));
    const nc::NameEffect effect = nc::nameEffect(m_language->dialect, name);
    const bool isOwn = effect == nc::NameEffect::Unknown || effect == nc::NameEffect::Query;
    if (isOwn || !readsVariables(token)) {
      return;
    }
    const auto arguments = argumentsOf(token);
    if (!arguments) {
      return;
    }
    std::string text(token.text.substr(0, token.text.find('(') + 1));
    for (std::size_t i = 0; i < arguments->size(); ++i) {
      text += i > 0 ? "," : "";
      if (!(*arguments)[i]) {
        continue;
      }
      const nc::Expected<nc::Value> value =
          nc::evaluate(*(*arguments)[i], variables, variables.semantics());
      if (!value) {
        return;  // refused later, as what reads variables
      }
      const auto* const number = std::get_if<double>(&*value);
      text += number != nullptr ? nc::ncNumber(*number) : '"' + nc::textOf(*value) + '"';
    }
    m_block->values.push_back({&token, {}, text + ')'});
  }

  // --- whose the block is -----------------------------------------------------------------------

  [[nodiscard]] std::optional<NativeReason> regionReason() const {
    const std::optional<NativeReason> reason = m_regions.reason();
    if (!reason && m_executor->state().motion == Motion::Unsupported) {
      return NativeReason::Cycle;
    }
    return reason;
  }

  [[nodiscard]] std::optional<NativeReason> nativeReason() const {
    if (!m_block) {
      return std::nullopt;
    }
    const std::optional<NativeReason> region = m_block->region ? m_block->region : regionReason();
    // Nothing may stop the control within a compensation, whatever else a block says; and whatever
    // moves calls a modal cycle.
    const bool encloses = region && (*region <= NativeReason::RadiusCompensation ||
                                     (*region == NativeReason::Cycle && m_block->moves));
    return m_block->reason && !encloses ? m_block->reason : region;
  }

  /// The motion of the present block is part of the path.
  [[nodiscard]] bool isStreamed() const {
    if (!nativeReason()) {
      return true;
    }
    return isForeign() && m_block->isSeparable && !m_block->region && !regionReason();
  }

  void add(NativeReason reason) {
    if (isForeign() && (reason == NativeReason::Mode || reason == NativeReason::Message)) {
      return;  // nothing the path or the machine needs
    }
    BlockNotes& block = *m_block;
    addReason(reason);
    if (reason == NativeReason::Retract) {
      block.forgets.named = true;
    } else if (rowOf(reason).after == PositionAfter::ControlOnly) {
      block.forgets.all = true;
      if (isForeign() && isSeparable(reason)) {
        forgetAll();  // the motion of the block begins there
      }
    }
  }

  void addReason(NativeReason reason) {
    BlockNotes& block = *m_block;
    block.reason = block.reason ? std::min(*block.reason, reason) : reason;
    block.isSeparable = block.isSeparable && isSeparable(reason);
  }

  /// A tool length is selected, left out, or acts on another axis: only along that axis is it not
  /// known where the tool stands in the coordinates of the program.
  void addLength() {
    BlockNotes& block = *m_block;
    constexpr std::size_t kAxisOfIso = 2;
    block.forgets.length[isForeign() ? kAxisOfIso : block.before.planeThirdAxis()] = true;
    if (!isForeign()) {
      block.forgets.length[m_executor->state().planeThirdAxis()] = true;
    }
    addReason(NativeReason::Tool);
    if (isForeign()) {
      forgetLength();  // the motion of the block begins there
    }
  }
  void forgetLength() {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (m_block->forgets.length[axis]) {
        forget(axis);
      }
    }
  }
  [[nodiscard]] static bool hasLength(const BlockNotes& block) {
    return std::find(block.forgets.length.begin(), block.forgets.length.end(), true) !=
           block.forgets.length.end();
  }
  [[nodiscard]] static std::array<bool, base::kAxisCount> allAxes() { return {true, true, true}; }

  void forgetPosition(NativeReason reason) {
    const BlockNotes& block = *m_block;
    if (block.isInHoleCycle && reason == NativeReason::Cycle) {
      return;
    }
    if (block.forgets.all || (!block.reason && rowOf(reason).after == PositionAfter::ControlOnly)) {
      if (!isForeign() || !isSeparable(reason)) {
        forgetAll();
      }
      return;
    }
    if (!isForeign() || !isSeparable(reason)) {
      forgetLength();
    }
    if (block.forgets.named || block.unknown.turns) {
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        if (block.forgets.named && (block.given[axis] || !block.fixedPoint.empty())) {
          forget(axis);
        }
        if (block.given[axis + nc::kFirstRotary]) {
          m_executor->start().rotaryDeg[axis] = std::numeric_limits<double>::quiet_NaN();
        }
      }
    }
  }

  void forgetAll() {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      forget(axis);
    }
    m_executor->start().rotaryDeg.fill(std::numeric_limits<double>::quiet_NaN());
  }

  void forget(std::size_t axis) {
    nc::Position& position = m_executor->start();
    position.programmedMm.set(axis, std::numeric_limits<double>::quiet_NaN());
    m_block->startMm.set(axis, std::numeric_limits<double>::quiet_NaN());
    position.direction = {};
    m_executor->state().incrementFrom[axis].reset();
    m_wayUp.clear();  // the tool may stand elsewhere
  }

  // --- what the executor tells ------------------------------------------------------------------

  void line(const nc::Position& from, base::Vec3 targetMm, const nc::Move& move) override {
    if (isStreamed()) {
      m_own->path.line(from, targetMm, move);
    } else {
      reach(from.frame.toWorkpiece(targetMm));
      if (isForeign()) {
        keepLine(from, targetMm, move);
      }
    }
  }
  void arc(const nc::Position& from, const nc::Arc& arc, const nc::Move& move) override {
    if (isStreamed()) {
      m_own->path.arc(from, arc, move);
    } else {
      std::vector<base::Vec3> chords;
      (void)nc::flattenArc(arc, kReachMm, chords);
      for (const base::Vec3& chord : chords) {
        reach(from.frame.toWorkpiece(chord));
      }
      if (isForeign() && keepsMoves()) {
        keepMotion(move.turns ? std::nullopt : arcText(from, arc, move));
      }
    }
  }
  void spaceArc(const nc::Position& from, const nc::SpaceArc& arc, base::Vec3 targetMm,
                const nc::Move& move) override {
    if (isStreamed()) {
      m_own->path.spaceArc(from, arc, targetMm, move);
    } else {
      refuseCurve();
    }
  }
  void spline(const nc::Position& from, const nc::Spline& spline, const nc::Move& move) override {
    const bool isEarlier = !m_block || m_block->continuesCurve;
    if (isEarlier ? m_curveIsStreamed : isStreamed()) {
      m_own->path.spline(from, spline, move);
    } else if (m_block) {
      refuseCurve();
    }
  }
  void unknownWay(const nc::Position& from, base::Vec3 targetMm, const nc::Move& move) override {
    if (isStreamed()) {
      m_own->path.unknownWay(from, targetMm, move);
    } else {
      refuseCurve();
    }
  }
  void feed(double mmPerMin) override { m_own->path.feed(mmPerMin); }

  void machineWord(MachineWord kind, double value, base::LineNumber line) override {
    m_own->path.machineWord(kind, value, line);
    std::vector<ForeignWord>& words = m_block->words;
    switch (kind) {
      case MachineWord::Spindle:
        add(NativeReason::Spindle);
        words.push_back({ForeignWord::Kind::Spindle, value, "S"});
        break;
      case MachineWord::M: {
        const int number = static_cast<int>(value);
        if (number == 3 || number == 4) {
          m_holes.spindleTurns(number);
        }
        if (m_language->dialect == nc::Dialect::LinuxCnc &&
            (number == kTipOn || number == kTipOff)) {
          add(NativeReason::Transformation);
          words.push_back({ForeignWord::Kind::Line, 0.0, number == kTipOn ? "TRAORI" : "TRAFOOF"});
          break;
        }
        if (isForeign() && !Translator::knowsM(m_language->dialect, number)) {
          addMachineFunction(number, line);
          break;
        }
        add(isForeign() ? Translator::reasonOfM(number) : reasonOfM(number));
        words.push_back({ForeignWord::Kind::M, value, fmt::format("M{}", number)});
        break;
      }
      case MachineWord::Tool:
      case MachineWord::NamedTool:
        // Alone it makes the next tool ready. A control that changes it at once has moved the axes,
        // which is found where the next stretch begins.
        if (isForeign() && !m_language->toolChangesZ) {
          addReason(NativeReason::Tool);
        } else {
          add(NativeReason::Tool);
        }
        words.push_back({ForeignWord::Kind::Tool, value, "T"});
        if (m_language->toolChangesZ) {
          words.push_back({ForeignWord::Kind::M, 6.0, "M6"});
        }
        break;
      case MachineWord::Dwell:
        add(NativeReason::Dwell);
        words.push_back({ForeignWord::Kind::Dwell, value, "G4"});
        break;
      case MachineWord::Edge:  // a letter without effect on the path, as H: `ignoreLetter`
        m_lastEdge = std::max(m_lastEdge, static_cast<int>(std::clamp(value, 0.0, 1e4)));
        break;
    }
  }
  /// M128 and M129 of a TNC.
  void switchTip(bool isOn) {
    m_tipIsOn = isOn;
    add(NativeReason::Transformation);
    m_block->words.push_back({ForeignWord::Kind::Line, 0.0, isOn ? "TRAORI" : "TRAFOOF"});
  }
  /// @param but  not counted
  [[nodiscard]] bool movesHere(const std::optional<Token>& but = {}) const {
    return std::any_of(m_block->tokens.begin(), m_block->tokens.end(), [&](const Token& token) {
      return token.kind == TokenKind::Word && (!but || token.column != but->column) &&
             std::find(nc::kProgrammedAxes.begin(), nc::kProgrammedAxes.end(), token.address) !=
                 nc::kProgrammedAxes.end();
    });
  }

  /// An M function of the source's own machine. What is left out moves nothing; what takes its
  /// place may.
  void addMachineFunction(int number, base::LineNumber line) {
    const std::string name = fmt::format("M{}", number);
    if (isAccepted(name)) {
      return;
    }
    if (nc::mEffect(m_language->dialect, number) != nc::MEffect::None) {
      return;  // followed here
    }
    if (Translator::isOfLanguage(m_language->dialect, number)) {
      if (m_tipIsOn && number == kTipOffOfTnc) {
        switchTip(false);
        return;
      }
      if (m_language->isKlartext &&
          std::find(kSwitchOff.begin(), kSwitchOff.end(), number) != kSwitchOff.end()) {
        ++m_functions.try_emplace({number}, FunctionUse{{number}, line, 0, {}, false})
              .first->second.count;
        return;
      }
      add(NativeReason::Other);
      m_block->words.push_back({ForeignWord::Kind::Other, 0.0, name});
      return;
    }
    const std::optional<std::string> text = meaningOf({number}, line);
    if (!text) {
      add(NativeReason::Other);
    } else if (!text->empty()) {
      add(NativeReason::Other);
      m_block->words.push_back({ForeignWord::Kind::Line, 0.0, *text});
    }
  }

  /// What the control gets for a word of another machine. @return nothing: it is refused
  std::optional<std::string> meaningOf(FunctionName name, base::LineNumber line) {
    const auto given = m_profile.functions.find(name);
    const bool isGiven = given != m_profile.functions.end();
    if (!isGiven && !m_profile.leavesOutFunctions) {
      refuse(RefusalCode::FunctionUnknown, textOf(name));
      return std::nullopt;
    }
    std::string text = isGiven ? given->second : std::string();
    ++m_functions.try_emplace(name, FunctionUse{name, line, 0, text, !isGiven}).first->second.count;
    return text;
  }

  /// U, V or W as a word of this block.
  [[nodiscard]] const Token* furtherAxis(std::string_view word) const {
    const auto token = std::find_if(
        m_block->tokens.begin(), m_block->tokens.end(),
        [word](const Token& each) { return each.text == word && each.kind != TokenKind::Comment; });
    return token != m_block->tokens.end() && token->address >= 'U' && token->address <= 'W'
               ? &*token
               : nullptr;
  }

  /// An axis of the source's own machine. Where a program of another control is to move it, it does
  /// so alone: beside X, Y and Z nobody knows its share of the feed.
  void addMachineAxis(const Token& token) {
    if (!isForeign()) {
      add(NativeReason::OtherMotion);
      return;
    }
    const std::optional<std::string> text = meaningOf({0, token.address}, m_block->place.line);
    if (text && text->empty()) {
      return;
    }
    add(NativeReason::Other);
    const std::optional<double> value = numberOf(token);
    const nc::ModalState& state = m_executor->state();
    if (!text) {
      return;
    }
    if (movesHere(token) || !value || state.motion != Motion::Rapid) {
      m_block->words.push_back({ForeignWord::Kind::Other, 0.0, nc::wordText(token)});
      return;
    }
    const double mm = *value * state.lengthFactor;
    m_block->words.push_back({ForeignWord::Kind::Line, 0.0,
                              "G0 " + (state.relative ? incrementWord(token.address, mm)
                                                      : placeWord(token.address, mm))});
  }

  void toolName(std::string_view name, base::LineNumber line) override {
    m_own->path.toolName(name, line);
    add(NativeReason::Tool);
    m_block->words.push_back({ForeignWord::Kind::NamedTool, 0.0, std::string(name)});
    if (m_language->toolChangesZ) {
      m_block->words.push_back({ForeignWord::Kind::M, 6.0, "M6"});
    }
  }

  void report(Severity severity, int column, FaultCode code, std::string argument) override {
    if (!m_block) {
      m_own->faults.report(severity, column, code, std::move(argument));
      return;
    }
    const bool isLeftOut =
        isAccepted(gcode::acceptableName({severity, {}, column, code, argument}));
    if (m_language->isKlartext && argument == "M128" && !isLeftOut && !movesHere()) {
      switchTip(true);
      return;
    }
    if (const Token* const axis =
            code == FaultCode::UnknownWord && !isLeftOut ? furtherAxis(argument) : nullptr) {
      addMachineAxis(*axis);
      return;
    }
    const bool turnsFromUnknown =
        severity == Severity::Warning && code == FaultCode::RelativeFromUnknownPosition;
    if (turnsFromUnknown && isForeign() && !m_profile.assumesTool) {
      refuse(RefusalCode::StartUnknown, std::string(base::trim(m_block->text)));
    }
    // A SINUMERIK turns the shortest way itself, from where it has the axis.
    const bool isControls = turnsFromUnknown && !isForeign();
    m_block->unknown.turns = m_block->unknown.turns || isControls;
    const std::optional<NativeReason> reason =
        (severity == Severity::Error || isControls) && !isLeftOut
            ? reasonOfFault(m_language->dialect, code, argument)
            : std::nullopt;
    if (!reason) {
      m_block->heard.push_back(
          {Heard::Kind::Report, severity, column, code, std::move(argument), {}});
      return;
    }
    add(*reason);
    m_regions.word(argument, false);
    m_block->isMissing = m_block->isMissing || code == FaultCode::SubprogramMissing;
    const std::optional<int> key = keyOfFault(argument);
    if (isForeign() && code == FaultCode::CycleNotRun && key &&
        m_holes.begin(m_language->dialect, *key)) {
      m_cycleWord = std::move(argument);
    } else if (isForeign() && code == FaultCode::RelativeFromUnknownPosition && isStraight() &&
               argument.size() == 1 && argument.front() >= 'X' && argument.front() <= 'Z') {
      m_block->unknown.axis[static_cast<std::size_t>(argument.front() - 'X')] = true;
    } else if (isForeign() && code == FaultCode::RelativeFromUnknownPosition && isStraight() &&
               argument.size() == 1 && argument.front() >= 'A' && argument.front() <= 'C') {
      m_block->unknown.rotary[static_cast<std::size_t>(argument.front() - 'A')] = true;
    } else if (isForeign() && *reason == NativeReason::UnknownPosition && isArc() &&
               !m_regions.reason()) {
      m_block->unknown.beginsArc = true;
      if (code == FaultCode::RelativeFromUnknownPosition && argument.front() >= 'X' &&
          argument.front() <= 'Z') {
        m_block->unknown.axis[static_cast<std::size_t>(argument.front() - 'X')] = true;
      }
    } else if (isForeign() && *reason == NativeReason::UnknownPosition) {
      refuse(RefusalCode::StartUnknown, std::string(base::trim(m_block->text)));
    } else if (isForeign() && *reason == NativeReason::Corner) {
      m_block->corner = std::move(argument);
    } else if (*reason == NativeReason::RadiusCompensation && (key == 410 || key == 420)) {
      compensate(*key, std::move(argument));
    } else if (*reason == NativeReason::RadiusCompensation &&
               (key == kLeftByDiameter || key == kRightByDiameter)) {
      compensateBy(*key, std::move(argument));
    } else if (*reason == NativeReason::Retract) {
      if (code != FaultCode::MachineCoordinates) {
        m_block->fixedPoint = std::move(argument);
      }
    } else if (*reason == NativeReason::WorkOffset && key == 100) {
      // G10: see `setWorkOffset`.
    } else if (*reason == NativeReason::WorkOffset && keyOfG(argument)) {
      m_block->words.push_back(
          {ForeignWord::Kind::G, static_cast<double>(*keyOfG(argument)), std::move(argument)});
    } else {
      m_block->words.push_back({ForeignWord::Kind::Other, 0.0, std::move(argument)});
    }
  }
  void fault(int column, const nc::Fault& fault) override { m_own->faults.fault(column, fault); }

  void ignore(const Token& token, std::string word) override {
    const bool isIndexed = token.kind == TokenKind::IndexedWord;
    const std::optional<NativeReason> reason =
        !isIndexed                                     ? reasonOfName(word)
        : token.address == 'T' || token.address == 'D' ? std::optional(NativeReason::Tool)
        : token.address == 'H'                         ? std::optional(NativeReason::Other)
                                                       : std::optional(NativeReason::Spindle);
    if (!reason || !m_block) {
      hear({Heard::Kind::Word, Severity::Note, 0, FaultCode::IgnoredCode, std::move(word), token});
      return;
    }
    add(*reason);
    const std::string_view text = token.text;
    m_regions.word(word, text.size() >= 2 && text.substr(text.size() - 2) == "()");
    if (*reason != NativeReason::Tool || isIndexed) {  // else told by `machineWord`
      m_block->words.push_back({ForeignWord::Kind::Other, 0.0, std::move(word)});
    }
  }
  void ignoreG(int key, const Token& token) override {
    constexpr int kCompensationOff = 400;
    if (key == kCompensationOff) {
      if (isForeign() && m_block && m_regions.reason() == NativeReason::RadiusCompensation) {
        m_block->words.push_back({ForeignWord::Kind::G, static_cast<double>(key), "G40"});
        if (std::exchange(m_hasAllowance, false)) {
          m_block->words.push_back({ForeignWord::Kind::Line, 0.0, "OFFN=0"});
        }
      }
      m_regions.compensationOff();
    }
    constexpr int kToStart = 980;
    constexpr int kToRetractPlane = 990;
    if (key == kToStart || key == kToRetractPlane) {
      m_holes.retractToStart(key == kToStart);
    }
    constexpr int kTipLength = 434;
    if (key == kTipLength && isForeign() && m_block && !isAccepted(nc::wordText(token))) {
      refuse(RefusalCode::NotTranslated, nc::wordText(token));
    }
    const std::optional<NativeReason> reason = reasonOfG(m_language->dialect, key);
    if (!reason || !m_block) {
      hear({Heard::Kind::G, Severity::Note, key, FaultCode::IgnoredCode, {}, token});
      return;
    }
    // G43.1 and G43.2 may offset any axis.
    constexpr std::array kAlongTool{430, 440, 490};
    if (std::find(kAlongTool.begin(), kAlongTool.end(), key) != kAlongTool.end()) {
      addLength();
    } else {
      add(*reason);
    }
    if (*reason != NativeReason::Dwell) {
      m_block->words.push_back(
          {ForeignWord::Kind::G, static_cast<double>(key), nc::wordText(token)});
    }
  }
  void ignoreM(Severity severity, int number, const Token& token) override {
    if (!m_block) {
      m_own->faults.ignoreM(severity, number, token);
    }  // else told by `machineWord`
  }
  void ignoreLetter(const Token& token) override {
    if (!m_block) {
      m_own->faults.ignoreLetter(token);
    } else if (token.address == 'D' && isForeign()) {
      // The cell of a radius: the control takes that of the tool, with G41.
      hear({Heard::Kind::Letter, Severity::Note, 0, FaultCode::IgnoredCode, {}, token});
    } else if (token.address == 'D' || token.address == 'H') {
      if (token.address == 'D' || isForeign()) {
        addLength();
      } else {
        add(NativeReason::Other);
      }
      m_block->words.push_back({ForeignWord::Kind::LengthCell, token.value, nc::wordText(token)});
    }
  }

  void motion(int g, const nc::AxisValues& axes) override { m_own->words.motion(g, axes); }
  void arc(const nc::AxisValues& axes, nc::Arc arc, nc::ArcWords words) override {
    m_own->words.arc(axes, arc, words);
  }
  void machineMotion(int g, const nc::AxisValues& axes) override {
    m_own->words.machineMotion(g, axes);
  }
  void otherMotion() override { m_own->words.otherMotion(); }
  void units(bool inches) override { m_own->words.units(inches); }
  void forget(std::optional<std::size_t> axis) override { m_own->words.forget(axis); }

  void hear(Heard heard) {
    if (m_block) {
      m_block->heard.push_back(std::move(heard));
    } else {
      tell(heard);
    }
  }

  void tell(const Heard& heard) {
    switch (heard.kind) {
      case Heard::Kind::Report:
        m_own->faults.report(heard.severity, heard.number, heard.code, heard.text);
        break;
      case Heard::Kind::Word:
        m_own->faults.ignore(heard.token, heard.text);
        break;
      case Heard::Kind::G:
        m_own->faults.ignoreG(heard.number, heard.token);
        break;
      case Heard::Kind::M:
        m_own->faults.ignoreM(heard.severity, heard.number, heard.token);
        break;
      case Heard::Kind::Letter:
        m_own->faults.ignoreLetter(heard.token);
        break;
    }
  }

  void forward() {
    for (const Heard& heard : m_block->heard) {
      tell(heard);
    }
  }

  // --- parts ------------------------------------------------------------------------------------

  Stretch& stretch() {
    if (!m_open) {
      m_open.emplace();
      m_open->firstPoint = m_block->firstPoint;
      m_open->startMm = m_block->startMm;
    }
    return *m_open;
  }

  /// @param points  of the trajectory at its end
  void closeStretch(std::size_t points) {
    if (!m_open) {
      return;
    }
    Stretch closed = *std::exchange(m_open, std::nullopt);
    closed.pointCount = points - closed.firstPoint;
    closed.number = closed.pointCount > 0 ? ++m_stretches : 0;
    keep(std::move(closed));
  }

  void pushNative(NativeReason reason, std::string text, const nc::ModalState& before) {
    const BlockNotes& block = *m_block;
    NativeBlock native;
    native.place = block.place;
    native.file = *m_fileName;
    native.reason = reason;
    native.source = base::trim(block.text);
    native.text = std::move(text);
    native.before = before;
    native.frame = block.frame;
    native.moves = block.moves;
    native.fixedPoint = block.fixedPoint;
    native.setsFrame = block.setsFrame;
    const nc::ModalState& now = m_executor->state();
    const bool isRapid =
        now.motion == Motion::Rapid || !block.fixedPoint.empty() || (isForeign() && block.home);
    native.usesDefaultFeed = block.moves && !isRapid && now.feedIsDefault;
    native.shifts = block.forgets.all || !hasLength(block) ? allAxes() : block.forgets.length;
    native.increments = block.increments;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      native.places[axis] = block.given[axis] && !block.increments[axis];
    }
    native.isHalf = isForeign() && m_points > block.firstPoint;
    native.calculates =
        !isForeign() &&
        std::any_of(block.tokens.begin(), block.tokens.end(), [&block](const Token& token) {
          return block.valueOf(token) == nullptr && readsVariables(token);
        });
    keep(std::move(native));
  }

  /// What the part holds beside itself.
  [[nodiscard]] static std::size_t textBytes(const Part& part) {
    const auto* const native = std::get_if<NativeBlock>(&part);
    if (native == nullptr) {
      return std::get<Stretch>(part).blocks.bytes();
    }
    std::size_t bytes = native->source.capacity() + native->text.capacity();
    for (const std::string& line : native->frame) {
      bytes += sizeof(line) + line.capacity();
    }
    return bytes;
  }

  void keep(Part part) {
    if (m_each) {
      m_each(part);
    } else {
      m_textBytes += textBytes(part);
      m_parts.push_back(std::move(part));
    }
  }

  /// The line without what Rivulet has followed (labels, skip marks, calls, returns), with values
  /// in place of calculations.
  [[nodiscard]] std::string verbatim() const {
    const BlockNotes& block = *m_block;
    std::string text(block.text);
    for (auto token = block.tokens.rbegin(); token != block.tokens.rend(); ++token) {
      const Stand* const value = block.valueOf(*token);
      if (value == nullptr && !isFollowed(*token)) {
        continue;
      }
      const auto at = static_cast<std::size_t>(token->column - 1);
      RIVULET_ASSERT(block.text.substr(at, token->text.size()) == token->text);
      text.replace(at, token->text.size(), value == nullptr ? "" : textOf(*value));
    }
    return std::string(base::trim(text));
  }

  [[nodiscard]] bool isFollowed(const Token& token) const {
    const BlockNotes& block = *m_block;
    const bool isCall = token.kind == TokenKind::Call || token.kind == TokenKind::Name ||
                        (token.kind == TokenKind::Word && token.address == 'L');
    switch (token.kind) {
      case TokenKind::BlockSkip:
      case TokenKind::Label:
        return true;
      case TokenKind::Word:
        if (token.address == 'M' && block.isInSubprogram) {
          const std::optional<int> number = nc::functionNumber(token.value);
          const nc::MEffect effect =
              number ? nc::mEffect(m_language->dialect, *number) : nc::MEffect::None;
          return effect == nc::MEffect::End || effect == nc::MEffect::Return;
        }
        break;
      default:
        break;
    }
    const std::string name = base::toUpper(nc::tokenName(token));
    if (block.isInSubprogram && token.kind == TokenKind::Name &&
        nc::nameEffect(m_language->dialect, name) == nc::NameEffect::End) {
      return true;
    }
    const bool isOwnCall = isCall && block.calls && !block.isMissing &&
                           (token.kind == TokenKind::Word ||
                            nc::nameEffect(m_language->dialect, name) == nc::NameEffect::Unknown);
    return isOwnCall;
  }

  /// A spline ends where a native block stands in it, which the source does not say.
  void noteInterruption() {
    if (m_block->continuesCurve && m_curveIsStreamed && isLongCurve(m_executor->state().motion)) {
      refuse(RefusalCode::CurveInterrupted, std::string(base::trim(m_block->text)));
    }
  }

  void refuse(RefusalCode code, std::string argument) {
    if (m_refusals.size() < gcode::kDiagnosticsMax) {
      m_refusals.push_back({code, m_block->place.line, *m_fileName, std::move(argument)});
    }
  }

  void endForeign(NativeReason reason) {
    BlockNotes& block = *m_block;
    forward();
    const Translation translation = m_translator.translate(block.words, block.home, *m_language);
    if (m_tipIsOn && block.home) {
      // SUPA is in the coordinates of the tip there, and not in those of the machine.
      refuse(RefusalCode::NotTranslated, "M91");
    }
    for (const std::string& word : translation.missing) {
      if (!isAccepted(word)) {
        refuse(RefusalCode::NotTranslated, word);
      }
    }
    for (const auto& [code, argument] : translation.refused) {
      refuse(code, argument);
    }
    if (m_assumed.tool.word.empty()) {
      m_assumed.tool = {block.place.line, m_translator.assumedTool()};
    }
    assumeLength(translation.assumedLength);
    const auto lines = [](const std::vector<std::string>& of) {
      return fmt::format("{}", fmt::join(of, "\n"));
    };
    const bool isHalf = m_points > block.firstPoint;
    if (!isHalf) {
      std::vector<std::string> all = translation.before;
      all.insert(all.end(), block.motion.begin(), block.motion.end());
      all.insert(all.end(), translation.after.begin(), translation.after.end());
      closeStretch(m_points);
      pushNative(reason, lines(all), block.before);
      return;
    }
    if (!translation.before.empty()) {
      closeStretch(block.firstPoint);
      pushNative(reason, lines(translation.before), block.before);
    }
    stretch().blocks.add(block.place);
    if (!translation.after.empty()) {
      closeStretch(m_points);
      pushNative(reason, lines(translation.after), m_executor->state());
    }
    noteInterruption();
  }

  /// @param word  "H3 (T2)"; empty: none
  void assumeLength(const std::string& word) {
    const bool isKnown =
        std::any_of(m_assumed.lengths.begin(), m_assumed.lengths.end(),
                    [&word](const AssumedTool& each) { return each.word == word; });
    if (!word.empty() && !isKnown) {
      m_assumed.lengths.push_back({m_block->place.line, word});
    }
  }

  /// TRANS, ROT, SCALE and MIRROR as lines that repeat them.
  void noteFrame(const nc::BlockWords& words, const nc::ModalState& state) {
    if (!words.rare || words.rare->frame.empty()) {
      return;
    }
    const std::string& name = words.rare->frame;
    if (name.front() != 'A') {
      m_frame.clear();  // it replaces what there was
    }
    std::string text = name;
    const double factor = name == "TRANS" || name == "ATRANS" ? state.lengthFactor : 1.0;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (words.axes.has(axis)) {
        text += fmt::format(" {}{}", base::kAxisNames[axis],
                            nc::ncNumber(words.axes.value[axis] * factor));
      }
    }
    if (const nc::NamedWord* const turn = words.named("RPL")) {
      m_frame.emplace_back(state.planeFirstAxis == 0   ? "G17"
                           : state.planeFirstAxis == 2 ? "G18"
                                                       : "G19");
      text += " RPL=" + nc::ncNumber(turn->value);
    }
    if (text != name) {
      m_frame.push_back(std::move(text));
    }
  }

  /// RL and RR of plain text are G41 and G42, the other way round in a mirrored plane.
  [[nodiscard]] std::optional<int> keyOfFault(std::string_view word) const {
    for (const Token& token : m_block->tokens) {
      if (m_language->isKlartext && token.address == 'G' && token.text == word) {
        return static_cast<int>(std::lround(token.value * 10.0));
      }
    }
    return keyOfG(word);
  }
  [[nodiscard]] static std::optional<int> keyOfG(std::string_view word) {
    const std::optional<double> number =
        word.size() > 1 && word.front() == 'G' ? base::parseNumber(word.substr(1)) : std::nullopt;
    return number ? std::optional(static_cast<int>(std::lround(*number * 10.0))) : std::nullopt;
  }

  const gcode::LoadOptions& m_options;
  const Profile& m_profile;
  Translator m_translator;
  const nc::Language* m_language = nullptr;
  std::optional<nc::Sinks> m_own;
  nc::Executor* m_executor = nullptr;
  const std::string* m_fileName = nullptr;
  Regions m_regions;
  std::optional<BlockNotes> m_block;  ///< nothing: between two blocks
  HoleCycles m_holes;
  std::vector<std::string> m_wayUp;  ///< to where a move in machine coordinates has left the tool
  std::string m_cycleWord;           ///< as written, e.g. "G81"
  std::array<bool, base::kAxisCount> m_hasMoved{};
  std::array<bool, base::kAxisCount> m_isSetUnknown{};  ///< by G92, from where is not known
  std::vector<std::string> m_frame;
  bool m_curveIsStreamed = false;
  bool m_knowsFrame = true;
  bool m_tipIsOn = false;       ///< M128 of a TNC
  bool m_hasAllowance = false;  ///< OFFN, until G40
  std::size_t m_points = 0;

  std::optional<Stretch> m_open;
  int m_stretches = 0;                      ///< that move
  std::function<void(const Part&)> m_each;  ///< gets the parts; empty: they are kept
  std::vector<Part> m_parts;
  std::size_t m_textBytes = 0;  ///< held by the parts beside themselves
  std::vector<Refusal> m_refusals;
  std::map<FunctionName, FunctionUse> m_functions;
  int m_lastEdge = 0;
  std::string m_keptLength;  ///< refused last
  /// Of the tool in the spindle before the job.
  struct Assumed {
    AssumedTool tool;
    std::vector<AssumedTool> lengths;
  };
  Assumed m_assumed;
  /// What the moves of the job reach.
  struct Box {
    base::Vec3 minMm{kNowhere, kNowhere, kNowhere};
    base::Vec3 maxMm{kNowhere, kNowhere, kNowhere};
  };
  Box m_box;
};

/// @param interpret  with the splitter as its observer
template <class Interpret>
base::Result<Plan> planOf(const gcode::LoadOptions& options, const Profile& profile,
                          std::function<void(const Part&)> each, const Interpret& interpret) {
  Plan plan;
  Splitter splitter(options, profile, std::move(each));
  base::Result<gcode::Program> program = interpret(splitter);
  if (!program) {
    return base::fail(program.error());
  }
  plan.program = std::move(*program);
  splitter.take(plan);
  return plan;
}

}  // namespace

base::Result<Plan> makePlan(std::string name, std::string text, const gcode::LoadOptions& options,
                            const Profile& profile) {
  return planOf(options, profile, {}, [&](Splitter& splitter) {
    return gcode::interpretProgram(std::move(name), std::move(text), options, &splitter);
  });
}

base::Result<Plan> makePlan(const gcode::Program& read, const gcode::LoadOptions& options,
                            const Profile& profile) {
  return planOf(options, profile, {},
                [&](Splitter& splitter) { return gcode::interpretAgain(read, options, splitter); });
}

base::Result<Plan> visitPlan(const gcode::Program& read, const gcode::LoadOptions& options,
                             const std::function<void(const Part&)>& each) {
  return planOf(options, {}, each,
                [&](Splitter& splitter) { return gcode::interpretAgain(read, options, splitter); });
}

}  // namespace rivulet::job
