// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "base/contract.h"
#include "base/text.h"
#include "base/units.h"
#include "gcode/block_words.h"
#include "gcode/findings.h"
#include "gcode/path_builder.h"
#include "nc/flow/cursor.h"
#include "nc/modal/vocabulary.h"

namespace rivulet::gcode {

namespace {

using base::Vec3;
using nc::Block;
using nc::GEffect;
using nc::NameEffect;
using nc::Token;
using nc::TokenKind;

enum class Motion : unsigned char {
  None,
  Rapid,
  Line,
  ArcClockwise,
  ArcCounter,
  ThreePointArc,
  TangentArc,
  BSpline,
  CubicSpline,      ///< G5
  QuadraticSpline,  ///< G5.1
  Nurbs,            ///< G5.2
  Unsupported,
};

enum class FeedMode : unsigned char { PerMinute, InverseTime, PerRevolution, Unknown };

/// Full circles on top of an arc, as on the control.
constexpr double kTurnsMax = 999.0;

/// Blocks between two calls of `LoadOptions::progress`.
constexpr std::size_t kProgressBlocks = 16384;

using base::isDigit;

/// #1 to #26 of G65 by letter; 0: none.
int argumentOf(char letter) {
  static constexpr std::array<int, 26> kNumbers{1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                                0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  return kNumbers[static_cast<std::size_t>(letter - 'A')];
}

/// The variables of the program, and of the control's own those that follow from the path.
class ProgramVariables final : public nc::Variables {
 public:
  using PositionOf = std::function<std::optional<double>(char axis, bool inWorkpiece)>;
  ProgramVariables(const nc::Semantics& semantics, PositionOf positionOf)
      : Variables(semantics), m_positionOf(std::move(positionOf)) {}

  [[nodiscard]] nc::Expected<nc::Value> system(std::string_view name,
                                               std::span<const nc::Value> indices) const override {
    const std::string axis = indices.size() == 1 ? nc::textOf(indices[0]) : std::string();
    if (axis.size() == 1 && (name == "$AA_IW" || name == "$P_EP" || name == "$AA_IM")) {
      if (const std::optional<double> known = m_positionOf(axis[0], name == "$AA_IM")) {
        return *known;
      }
    }
    return nc::fail(nc::FaultCode::OnlyOnControl,
                    axis.empty() ? std::string(name) : fmt::format("{}[{}]", name, axis));
  }

  /// #<_x>
  [[nodiscard]] nc::Expected<nc::Value> variable(std::string_view name,
                                                 std::span<const int> indices) const override {
    nc::Expected<nc::Value> value = Variables::variable(name, indices);
    if (!value && name.size() == 4 && name.substr(0, 2) == "<_") {
      if (const std::optional<double> known = m_positionOf(name[2], false)) {
        return *known;
      }
    }
    return value;
  }

  /// #5420 and on: the position.
  [[nodiscard]] nc::Expected<double> numbered(int number) const override {
    constexpr int kFirst = 5420;
    if (number >= kFirst && number < kFirst + static_cast<int>(base::kAxisCount)) {
      const char axis = base::kAxisNames[static_cast<std::size_t>(number - kFirst)];
      if (const std::optional<double> known = m_positionOf(axis, false)) {
        return *known;
      }
    }
    return Variables::numbered(number);
  }

 private:
  PositionOf m_positionOf;
};

class Interpreter {
 public:
  Interpreter(std::string_view text, const LoadOptions& options, nc::DialectGuess guess)
      : m_text(text),
        m_options(options),
        m_dialect(guess.dialect),
        m_g(nc::gTable(guess.dialect)),
        m_findings(options.accepted),
        m_variables(
            nc::notationOf(guess.dialect).hasNames ? nc::sinumerikSemantics() : nc::hashSemantics(),
            [this](char axis, bool inWorkpiece) { return positionOf(axis, inWorkpiece); }),
        m_cursorOptions{options.repeatedLinesMax, options.subprogram},
        m_flow(text, guess.dialect, m_variables, m_cursorOptions),
        m_path(options, m_out.trajectory, m_out.statistics) {
    if (guess.dialect == Dialect::Iso && !guess.turningCycle.empty()) {
      m_isLathe = true;
      m_diameter = true;
      m_diameterIncrements = true;
      m_planeFirstAxis = 2;
      m_findings.reportProgram(Severity::Warning, DiagnosticCode::LatheAssumed, guess.turningCycle);
    }
    m_out.dialect = guess.dialect;
    m_out.dialectEvidence = std::move(guess.evidence);
  }

  Interpretation run() {
    const auto lineFeeds = static_cast<std::size_t>(std::count(m_text.begin(), m_text.end(), '\n'));
    m_out.trajectory.points.reserve(std::min(lineFeeds + 1, kTrajectoryPointsMax));
    if (m_text.substr(0, 4096).find('\0') != std::string_view::npos) {
      m_findings.report(Severity::Error, 1, DiagnosticCode::NotAnyDialect, {});
    }
    Block block;
    std::size_t untilProgress = kProgressBlocks;
    while (!m_ended) {
      const nc::Cursor::Step step = m_flow.next(block);
      if (step == nc::Cursor::Step::End) {
        break;
      }
      if (--untilProgress == 0) {
        untilProgress = kProgressBlocks;
        if (!goesOn(lineFeeds)) {
          m_out.cancelled = true;
          break;
        }
      }
      if (step == nc::Cursor::Step::Block && block.tokens.empty()) {
        continue;
      }
      m_line = m_flow.line();
      const nc::Place place = m_flow.place();
      m_findings.setPlace(place.line, m_flow.fileName(place.file));
      if (step == nc::Cursor::Step::Report) {
        Token statement;
        statement.column = place.column;
        settle(m_flow.outcome(), statement);
        continue;
      }
      interpretBlock(block);
      if (m_out.trajectory.points.size() > kTrajectoryPointsMax) {
        m_findings.report(Severity::Error, 1, DiagnosticCode::TooManyPoints,
                          fmt::format("{}", kTrajectoryPointsMax));
        m_tailReported = true;
        break;
      }
    }
    finish();
    return std::move(m_out);
  }

 private:
  [[nodiscard]] bool goesOn(std::size_t lines) const {
    const double share =
        lines == 0 ? 1.0 : static_cast<double>(m_flow.linesRead()) / static_cast<double>(lines + 1);
    return !m_options.progress || m_options.progress(std::min(1.0, share));
  }

  /// In the unit of the file; nothing: no motion has said it yet.
  [[nodiscard]] std::optional<double> positionOf(char axisName, bool inWorkpiece) const {
    if (axisName < 'X' || axisName > 'Z') {
      return std::nullopt;
    }
    const Vec3 position = inWorkpiece ? m_path.frame().toWorkpiece(programmed()) : programmed();
    const double value = position[static_cast<std::size_t>(axisName - 'X')] / m_lengthFactor;
    return std::isnan(value) ? std::nullopt : std::optional(value);
  }

  /// What cannot be computed, or where the program continues.
  void report(const Token& token, const nc::Fault& fault) {
    m_findings.error(
        token,
        nc::isAboutOrder(fault.code) ? DiagnosticCode::FlowFault : DiagnosticCode::ExpressionFault,
        nc::describe(fault));
  }

  [[nodiscard]] std::optional<double> numberOf(const Token& token,
                                               const nc::Expected<nc::CalculatedValue>& value) {
    const nc::Expected<double> number =
        value ? m_variables.number(value->value) : nc::fail(value.error());
    if (!number) {
      report(token, number.error());
    }
    return number ? std::optional(*number) : std::nullopt;
  }

  void assign(const Token& token) {
    const nc::Expected<nc::Assignment>& assignment = m_flow.assignment(token);
    const nc::Expected<void> done =
        assignment ? m_variables.assign(*assignment) : nc::fail(assignment.error());
    if (!done) {
      report(token, done.error());
    }
  }

  // --- one block -------------------------------------------------------------------------

  void interpretBlock(const Block& block) {
    BlockWords words;
    bool counts = false;
    if (m_options.blockSkip && hasBlockSkip(block)) {
      return;
    }
    for (const Token& token : block.tokens) {
      const bool isNumber =
          token.kind == TokenKind::Word && (token.address == 'N' || token.address == 'O');
      counts |= !isNumber && token.kind != TokenKind::Tape && token.kind != TokenKind::BlockSkip;
      read(token, words);
    }
    if (counts) {
      ++m_out.blocks;
    }
    if (block.tokens.front().kind == TokenKind::Tape) {
      // The first "%" starts the tape, one after the blocks ends it.
      m_ended = m_out.blocks > 0 && !m_flow.leaveSubprogram();
      return;
    }
    execute(words);
    if (words.ends) {
      endProgram();
    }
  }

  static bool hasBlockSkip(const Block& block) {
    return std::any_of(block.tokens.begin(), block.tokens.end(),
                       [](const Token& token) { return token.kind == TokenKind::BlockSkip; });
  }

  void endProgram() {
    flushSpline();
    // M30 in a subprogram of the ISO dialects ends everything.
    const bool returns = m_dialect == Dialect::Sinumerik && m_flow.isInSubprogram();
    if (!returns || !m_flow.leaveSubprogram()) {
      m_ended = true;
    }
  }

  void read(const Token& token, BlockWords& words) {
    switch (token.kind) {
      case TokenKind::Word:
        if (isVariable(token)) {
          assign(token);
        } else {
          readWord(token, words);
        }
        break;
      case TokenKind::Name:
      case TokenKind::NamedValue:
      case TokenKind::Call:
        readName(token, words);
        break;
      case TokenKind::TextWord:
        readText(token);
        break;
      case TokenKind::IndexedWord:
        readIndexed(token, words);
        break;
      case TokenKind::Label:
        break;
      case TokenKind::Expression:
        if (isVariable(token)) {
          assign(token);
        } else {
          readCalculated(token, words);
        }
        break;
      case TokenKind::Assignment:
        readAssignment(token, words);
        break;
      case TokenKind::Statement:
        words.rareWords().statement = token;
        break;
      case TokenKind::BlockSkip:
        m_findings.ignore(Severity::Note, token, "/");
        break;
      case TokenKind::Tape:
        break;
      case TokenKind::UnexpectedCharacter:
        if (static_cast<unsigned char>(token.text.front()) < 0x20) {
          // Left over from a transfer: no control reads it as a word.
          m_findings.report(Severity::Warning, token.column, DiagnosticCode::UnexpectedCharacter,
                            "\\x" + fmt::format("{:02x}", token.text.front()));
          break;
        }
        m_findings.error(token, DiagnosticCode::UnexpectedCharacter, std::string(token.text));
        break;
      case TokenKind::NumberMissing:
        m_findings.error(token, DiagnosticCode::NumberMissing, std::string(tokenName(token)));
        break;
      case TokenKind::NumberMalformed:
        m_findings.error(token, DiagnosticCode::NumberMalformed, std::string(token.text));
        break;
      case TokenKind::CommentNotClosed:
        m_findings.error(token, DiagnosticCode::CommentNotClosed, {});
        break;
    }
  }

  /// I=5 is not a centre if the program has defined a variable I.
  [[nodiscard]] bool isVariable(const Token& token) const {
    return m_dialect == Dialect::Sinumerik && token.text.size() > 2 &&
           (token.text[1] == '=' || token.text[1] == ' ') &&
           m_variables.find(std::string_view(&token.address, 1)) != nullptr;
  }

  /// M1=3, M[R1]=3 and S2=500 are the spindles'; G[6]=2 is a G function by group and number.
  void readIndexed(const Token& token, BlockWords& words) {
    if (token.address != 'G') {
      m_findings.ignore(Severity::Note, token, std::string(token.text));
      return;
    }
    const nc::Expected<nc::Assignment>& group = m_flow.assignment(token);
    if (!group || group->target.operands.size() != 1) {
      m_findings.error(token, DiagnosticCode::UnknownWord);
      return;
    }
    const nc::Expected<double> index = m_variables.number(group->target.operands.front());
    const nc::Expected<double> number =
        index ? m_variables.number(*group->initial.values.front()) : index;
    if (!number) {
      report(token, number.error());
      return;
    }
    const std::optional<int> key = nc::gOfGroup(static_cast<int>(std::clamp(*index, 0.0, 1000.0)),
                                                static_cast<int>(std::clamp(*number, 0.0, 1000.0)));
    if (!key) {
      m_findings.error(token, DiagnosticCode::UnsupportedGCode);
      return;
    }
    Token named = token;
    named.kind = TokenKind::Word;
    named.value = static_cast<double>(*key) / 10.0;
    m_calculated.push_back(named);
    readG(m_calculated.back(), words);
  }

  void readText(const Token& token) {
    if (token.address == 'T') {
      const std::size_t open = token.text.find('"');
      m_out.trajectory.toolNames.emplace_back(
          token.text.substr(open + 1, token.text.size() - open - 2));
      event(PathEvent::Kind::NamedTool, static_cast<double>(m_out.trajectory.toolNames.size() - 1));
      m_findings.ignore(Severity::Note, token, "T");
    } else if (token.address == 0 && m_variables.find(base::toUpper(tokenName(token))) != nullptr) {
      assign(token);
    } else if (nc::nameEffect(m_dialect, base::toUpper(tokenName(token))) == NameEffect::None) {
      m_findings.ignore(Severity::Note, token, base::toUpper(tokenName(token)));
    } else {
      m_findings.error(token, DiagnosticCode::UnknownWord);
    }
  }

  // --- calculated words ---------------------------------------------------------------------

  void readCalculated(const Token& token, BlockWords& words) {
    const nc::Expected<nc::CalculatedValue>& value = m_flow.value(token);
    Token computed = token;
    computed.kind = TokenKind::Word;
    computed.hasPoint = true;
    const auto reference = value ? value->reference : nc::Word::Reference::Modal;
    computed.isIncrement = reference == nc::Word::Reference::Incremental;
    const std::optional<double> result = numberOf(token, value);
    if (!result && axisOf(token.address) >= kProgrammedAxisCount) {
      return;
    }
    // The block still moves; where to is not known.
    computed.value = result.value_or(std::nan(""));
    // The words of a block are read again when it is executed: the token must live on.
    m_calculated.push_back(computed);
    readWord(m_calculated.back(), words);
    if (reference == nc::Word::Reference::Absolute) {
      markAbsolute(token.address, words);
    }
  }

  /// AX[variable]=..., where the variable of type AXIS holds the name of the axis.
  void readIndexedAxis(const Token& token, BlockWords& words) {
    const std::size_t open = token.text.find('[');
    const std::size_t close = token.text.find(']');
    const std::size_t equals = token.text.find('=');
    const std::string index =
        open == std::string_view::npos || close == std::string_view::npos || close < open
            ? std::string()
            : base::toUpper(base::trim(token.text.substr(open + 1, close - open - 1)));
    const nc::Variable* const variable = m_variables.find(index);
    const std::string axis = variable == nullptr ? index : nc::textOf(variable->values.front());
    if (axis.size() != 1 || axisOf(axis[0]) >= kProgrammedAxisCount ||
        equals == std::string_view::npos) {
      m_findings.error(token, DiagnosticCode::UnsupportedExpression);
      return;
    }
    Token named = token;
    named.address = axis[0];
    named.text = token.text.substr(equals);
    readCalculated(named, words);
  }

  static void markAbsolute(char address, BlockWords& words) {
    if (const std::size_t axis = axisOf(address); axis < kProgrammedAxisCount) {
      words.axes.isIncrement[axis] = false;
      words.hasOwnMode[axis] = true;
    } else if (address >= 'I' && address <= 'K') {
      words.centreIsAbsolute[static_cast<std::size_t>(address - 'I')] = true;
    }
  }

  void readAssignment(const Token& token, BlockWords& words) {
    if (m_dialect == Dialect::Heidenhain) {
      m_findings.ignore(Severity::Note, token, "Q");  // for cycles; a word made of one is refused
      return;
    }
    const std::string name = base::toUpper(tokenName(token));
    const bool isDefined = m_variables.find(name) != nullptr;
    if (name == "AX" && m_dialect == Dialect::Sinumerik) {
      readIndexedAxis(token, words);
      return;
    }
    if (token.address == 'T') {
      // T="MILL_"<<R1: which tool it is does not touch the path.
      m_findings.ignore(Severity::Note, token, "T");
      return;
    }
    if (!isDefined && !name.empty()) {
      switch (nc::nameEffect(m_dialect, name)) {
        case NameEffect::Address: {
          const nc::Expected<nc::CalculatedValue>& parsed = m_flow.value(token);
          const std::optional<double> value = numberOf(token, parsed);
          if (value && name == "CR") {
            Token radius = token;
            radius.value = *value;
            m_calculated.push_back(radius);
            setRadius(m_calculated.back(), words);
          } else if (value) {
            words.rareWords().named[name] = {*value,
                                             parsed->reference == nc::Word::Reference::Incremental};
            noteColumn(token, words);
          }
          return;
        }
        case NameEffect::None:
          m_findings.ignore(Severity::Note, token, name);
          return;
        case NameEffect::Mode:
        case NameEffect::TakesBlock:
          m_findings.error(token, DiagnosticCode::UnsupportedGCode, name);
          return;
        default:
          break;
      }
    }
    if (name.empty() && !token.text.empty() && token.text.front() == '$') {
      // Commands of a sender, and variables of the control.
      m_findings.error(token, DiagnosticCode::UnknownWord);
      return;
    }
    assign(token);
  }

  // --- words ----------------------------------------------------------------------------------

  static std::size_t axisOf(char address) {
    if (address >= 'X') {
      return static_cast<std::size_t>(address - 'X');
    }
    if (address >= 'U') {
      return static_cast<std::size_t>(address - 'U') + 6;
    }
    return address <= 'C' ? static_cast<std::size_t>(address - 'A') + 3 : kProgrammedAxisCount;
  }

  void readWord(const Token& token, BlockWords& words) {
    const char address = token.address;
    if (address == 'G') {
      readG(token, words);
      return;
    }
    if (address == 'M') {
      readM(token, words);
      return;
    }
    if (words.rare && words.rare->macroCall && address != 'N' && address != 'P' && address != 'L') {
      if (const int number = argumentOf(address); number > 0) {
        words.rare->arguments[number] = token.value;
      }
      return;
    }
    const unsigned bit = 1U << static_cast<unsigned>(address - 'A');
    if ((words.repeated & bit) != 0) {
      const bool path = std::string_view("XYZIJKRFABC").find(address) != std::string_view::npos;
      m_findings.report(path ? Severity::Error : Severity::Warning, token.column,
                        DiagnosticCode::RepeatedWord, std::string(1, address));
    }
    words.repeated |= bit;
    switch (address) {
      case 'X':
      case 'Y':
      case 'Z':
        setAxis(token, words);
        words.axisTokens[axisOf(address)] = &token;
        break;
      case 'I':
      case 'J':
      case 'K': {
        const auto axis = static_cast<std::size_t>(address - 'I');
        words.centre[axis] = token.value;
        words.hasCentre[axis] = true;
        words.centreIsAbsolute[axis] = m_centreIsAbsolute;
        words.centreTokens[axis] = &token;
        noteColumn(token, words);
        break;
      }
      case 'A':
      case 'B':
      case 'C':
      case 'U':
      case 'V':
      case 'W':
        readFurtherAxis(token, words);
        break;
      case 'R':
        setRadius(token, words);
        words.radiusIsWord = true;
        break;
      case 'F':
        words.feed = token.value;
        words.hasFeed = true;
        m_feedToken = token;
        break;
      case 'N':
        break;
      case 'O':
        readProgramNumber(token);
        break;
      case 'S':
      case 'T':
      case 'D':
      case 'H':
        readMachineWord(token);
        break;
      case 'P':
        words.p = token.value;
        words.parameter = &token;
        break;
      case 'Q':
        words.q = token.value;
        words.parameter = &token;
        break;
      case 'L':
        if (m_dialect == Dialect::Sinumerik) {
          words.rareWords().call = token;
        } else {
          words.l = token.value;
          words.parameter = &token;
        }
        break;
      default:
        m_findings.error(token, DiagnosticCode::UnknownWord);
        break;
    }
  }

  void setAxis(const Token& token, BlockWords& words) {
    const std::size_t axis = axisOf(token.address);
    words.axes.value[axis] = token.value;
    words.axes.given[axis] = true;
    words.axes.isIncrement[axis] = token.isIncrement || m_relative;
    words.hasOwnMode[axis] = token.isIncrement;
    noteColumn(token, words);
  }

  void readFurtherAxis(const Token& token, BlockWords& words) {
    if (m_isLathe && (token.address == 'U' || token.address == 'W')) {
      // Increments of X and Z, whatever else holds.
      Token increment = token;
      increment.address = token.address == 'U' ? 'X' : 'Z';
      increment.isIncrement = true;
      m_calculated.push_back(increment);
      setAxis(increment, words);
      words.axisTokens[axisOf(increment.address)] = &m_calculated.back();
      return;
    }
    setAxis(token, words);
    words.hasRotary = true;
    if (token.address == 'U') {
      words.parameter = &token;
    }
    if (token.address >= 'U' && !words.dwell) {
      m_furtherTokens.push_back(token);
    }
  }

  /// A program number after the first blocks starts another program: the one before has ended.
  void readProgramNumber(const Token& token) {
    if (m_out.blocks == 0 || m_flow.isInSubprogram()) {
      return;
    }
    m_findings.error(token, DiagnosticCode::UnknownWord);
  }

  void readMachineWord(const Token& token) {
    m_findings.ignoreLetter(token);
    if (token.address == 'S') {
      m_spindlePerMin = token.value;
      event(PathEvent::Kind::Spindle, token.value);
    } else if (token.address == 'T') {
      event(PathEvent::Kind::Tool, token.value);
      if (m_dialect == Dialect::Heidenhain) {
        m_facts.forget(2);
      }
    }
  }

  void event(PathEvent::Kind kind, double value) {
    std::vector<PathEvent>& events = m_out.trajectory.events;
    events.push_back({m_out.trajectory.points.size(), value, m_line, kind});
  }

  static void noteColumn(const Token& token, BlockWords& words) {
    if (words.motionColumn == 0) {
      words.motionColumn = token.column;
    }
  }

  void setRadius(const Token& token, BlockWords& words) {
    if (words.hasRadius) {
      m_findings.error(token, DiagnosticCode::RepeatedWord, "CR=");
    }
    words.radius = token.value;
    words.hasRadius = true;
    words.radiusToken = &token;
    noteColumn(token, words);
  }

  /// What a G function does when it is read. `isNoted`: without effect on the path by itself;
  /// `takesBlock`: the axis words of the block are its own.
  struct GRow {
    GEffect effect;
    void (Interpreter::*read)(int key, const Token& token, BlockWords& words) = nullptr;
    bool isNoted = false;
    bool takesBlock = false;
  };

  [[nodiscard]] static const GRow& rowOf(GEffect effect) {
    static constexpr std::array kRows{
        GRow{GEffect::Unknown, &Interpreter::refuseG},
        GRow{GEffect::Motion, &Interpreter::readModal},
        GRow{GEffect::Distance, &Interpreter::readDistanceMode},
        GRow{GEffect::CentreMode, &Interpreter::readCentreMode, true},
        GRow{GEffect::Plane, &Interpreter::readModal},
        GRow{GEffect::Units, &Interpreter::readUnits},
        GRow{GEffect::FeedMode, &Interpreter::readFeedMode, true},
        GRow{GEffect::Diameter, &Interpreter::readDiameter, true},
        GRow{GEffect::Dwell, &Interpreter::readDwell, true},
        GRow{GEffect::Pole, &Interpreter::readPole, false, true},
        GRow{GEffect::PolarOn, &Interpreter::readPolar, true},
        GRow{GEffect::PolarOff, &Interpreter::readPolar, true},
        GRow{GEffect::Spline, &Interpreter::readSplineMode},
        GRow{GEffect::None, &Interpreter::readNone, true},
        GRow{GEffect::Tolerance, &Interpreter::readTolerance, true},
        GRow{GEffect::ToolLength, &Interpreter::readToolLength, true},
        GRow{GEffect::CycleOff, &Interpreter::readCycleOff, true},
        GRow{GEffect::WorkOffset, &Interpreter::readWorkOffset},
        GRow{GEffect::WorkOffsetP, &Interpreter::readWorkOffsetP},
        GRow{GEffect::MachineMove, &Interpreter::readMachineMove},
        GRow{GEffect::SetPosition, &Interpreter::readOffsetWord, false, true},
        GRow{GEffect::ResetPosition, &Interpreter::readOffsetWord, false, true},
        GRow{GEffect::LocalOffset, &Interpreter::readOffsetWord, false, true},
        GRow{GEffect::MacroCall, &Interpreter::readMacroCall, false, true},
        GRow{GEffect::Mode, &Interpreter::refuseG},
        GRow{GEffect::MotionMode, &Interpreter::readForeignMotion},
        GRow{GEffect::Cycle, &Interpreter::readForeignMotion},
        GRow{GEffect::TakesBlock, &Interpreter::readForeignBlock, false, true},
    };
    static_assert(
        [] {
          for (std::size_t i = 0; i < kRows.size(); ++i) {
            if (static_cast<std::size_t>(kRows[i].effect) != i) {
              return false;
            }
          }
          return true;
        }(),
        "a row is found by its effect");
    return kRows[static_cast<std::size_t>(effect)];
  }

  void readG(const Token& token, BlockWords& words) {
    const double scaled = token.value * 10.0;
    const int key =
        token.value >= 0.0 && token.value < 1000.0 ? static_cast<int>(std::lround(scaled)) : -1;
    if (key < 0 || std::abs(scaled - key) > 1e-6) {
      m_findings.error(token, DiagnosticCode::UnknownGCode, Findings::wordText(token));
      return;
    }
    if (m_isLathe && key >= 700 && key <= 730) {
      readTurningCycle(token, words);
      return;
    }
    const GRow& row = rowOf(effectOf(key));
    (this->*row.read)(key, token, words);
    words.taken |= row.takesBlock;
    if (row.isNoted) {
      m_findings.ignoreG(static_cast<std::size_t>(key), token);
    }
  }

  [[nodiscard]] GEffect effectOf(int key) const { return m_g[static_cast<std::size_t>(key)]; }

  void refuseG(int key, const Token& token, BlockWords& /*words*/) {
    m_findings.error(token,
                     effectOf(key) == GEffect::Unknown ? DiagnosticCode::UnknownGCode
                                                       : DiagnosticCode::UnsupportedGCode,
                     Findings::wordText(token));
  }

  /// Two different functions of one group in a block contradict each other.
  void setModal(int& slot, int key, const Token& token) {
    if (slot >= 0 && slot != key) {
      m_findings.error(token, DiagnosticCode::ConflictingGCodes,
                       fmt::format("G{} {}", slot / 10, Findings::wordText(token)));
    }
    slot = key;
  }

  void readModal(int key, const Token& token, BlockWords& words) {
    setModal(effectOf(key) == GEffect::Motion ? words.motionKey : words.planeKey, key, token);
  }

  void readDistanceMode(int key, const Token& token, BlockWords& words) {
    words.latheKey = m_isLathe ? key : words.latheKey;
    setModal(words.distanceKey, key, token);
    readDistance(key == 910, words);
  }

  void readCentreMode(int key, const Token& /*token*/, BlockWords& words) {
    m_centreIsAbsolute = key == 901;
    words.centreIsAbsolute.fill(m_centreIsAbsolute);
  }

  void readUnits(int key, const Token& token, BlockWords& words) {
    setModal(words.unitsKey, key, token);
  }

  void readFeedMode(int key, const Token& /*token*/, BlockWords& words) {
    struct Mode {
      int key;
      FeedMode mode;
    };
    static constexpr std::array kModes{
        Mode{930, FeedMode::InverseTime}, Mode{940, FeedMode::PerMinute},
        Mode{9610, FeedMode::PerMinute}, Mode{950, FeedMode::PerRevolution},
        Mode{9510, FeedMode::PerRevolution}};
    words.latheKey = m_isLathe && key == 940 ? key : words.latheKey;
    const auto* const found = std::find_if(kModes.begin(), kModes.end(),
                                           [key](const Mode& mode) { return mode.key == key; });
    m_feedMode = found == kModes.end() ? FeedMode::Unknown : found->mode;
    m_feedMmPerS = 0.0;
  }

  void readDiameter(int key, const Token& /*token*/, BlockWords& /*words*/) {
    m_diameter = key == 70;
    m_diameterIncrements = m_diameter;
  }

  void readDwell(int /*key*/, const Token& /*token*/, BlockWords& words) { words.dwell = true; }

  void readPole(int key, const Token& /*token*/, BlockWords& words) {
    words.rareWords().pole = true;
    words.rare->poleKey = key;
  }

  void readPolar(int key, const Token& /*token*/, BlockWords& /*words*/) {
    m_polar = effectOf(key) == GEffect::PolarOn;
  }

  void readSplineMode(int key, const Token& /*token*/, BlockWords& words) {
    words.rareWords().splineKey = key;
  }

  void readNone(int key, const Token& /*token*/, BlockWords& /*words*/) {
    m_tipWord = key == 434 ? "G43.4" : m_tipWord;
  }

  void readTolerance(int /*key*/, const Token& /*token*/, BlockWords& words) {
    words.tolerance = true;
  }

  void readToolLength(int key, const Token& /*token*/, BlockWords& words) {
    m_tipWord.clear();
    m_facts.forget(2);
    words.taken |= key == 431;  // G43.1 gives the offset itself, it is not a move
  }

  void readCycleOff(int /*key*/, const Token& /*token*/, BlockWords& /*words*/) {
    m_motion = m_motion == Motion::Unsupported ? m_motionBeforeUnsupported : m_motion;
  }

  void readWorkOffset(int key, const Token& token, BlockWords& /*words*/) {
    selectWorkOffset(key, token);
  }

  void readWorkOffsetP(int key, const Token& token, BlockWords& words) {
    words.rareWords().workOffsetKey = key;
    words.rare->workOffsetToken = &token;
  }

  void readMachineMove(int /*key*/, const Token& token, BlockWords& words) {
    words.machineMove = true;
    words.machineToken = &token;
  }

  void readOffsetWord(int key, const Token& /*token*/, BlockWords& words) {
    RareWords& rare = words.rareWords();
    rare.setsPosition |= effectOf(key) == GEffect::SetPosition;
    rare.resetsPosition |= effectOf(key) == GEffect::ResetPosition;
    rare.localOffset |= effectOf(key) == GEffect::LocalOffset;
  }

  void readMacroCall(int /*key*/, const Token& /*token*/, BlockWords& words) {
    words.rareWords().macroCall = true;
  }

  /// A motion or cycle that is not made here; it stays until another motion is named.
  void readForeignMotion(int key, const Token& token, BlockWords& /*words*/) {
    m_findings.error(token,
                     effectOf(key) == GEffect::Cycle ? DiagnosticCode::CycleNotRun
                                                     : DiagnosticCode::UnsupportedGCode,
                     Findings::wordText(token));
    if (m_motion != Motion::Unsupported) {
      m_motionBeforeUnsupported = m_motion;
    }
    flushSpline();
    m_motion = Motion::Unsupported;
    m_facts.forget();
  }

  void readForeignBlock(int key, const Token& token, BlockWords& words) {
    refuseG(key, token, words);
    m_facts.otherMotion();
    m_facts.forget();
  }

  /// G70 to G73 of a lathe: the words of the block are the cycle's, and no state is changed.
  void readTurningCycle(const Token& token, BlockWords& words) {
    m_findings.error(token, DiagnosticCode::CycleNotRun, Findings::wordText(token));
    words.taken = true;
    m_facts.otherMotion();
    m_facts.forget();
  }

  /// G90 and G91 hold for the whole block, also for the words before them.
  void readDistance(bool relative, BlockWords& words) {
    if (relative != m_relative) {
      m_relative = relative;
      for (std::size_t axis = 0; axis < kProgrammedAxisCount; ++axis) {
        if (!words.hasOwnMode[axis]) {
          words.axes.isIncrement[axis] = words.axes.given[axis] && relative;
        }
      }
    }
  }

  /// The streamed points carry no work offset: the one active at the control holds for all of
  /// them. So the program's first choice is a note; another one once the tool has moved would
  /// send it to a wrong place.
  /// @param number  of the further offsets of G54.1 and G154
  void selectWorkOffset(int key, const Token& token, double number = 0.0) {
    const bool isOther = key != m_workOffset || number != m_workOffsetNumber;
    if (m_moved && isOther) {
      m_findings.error(token, DiagnosticCode::UnsupportedGCode, Findings::wordText(token));
    } else {
      m_findings.ignoreG(static_cast<std::size_t>(key), token);
    }
    if (isOther) {
      m_facts.forget();
    }
    m_workOffset = key;
    m_workOffsetNumber = number;
  }

  void readM(const Token& token, BlockWords& words) {
    const double value = token.value;
    if (!(value >= 0.0 && value < 10000.0) || value != std::floor(value)) {
      m_findings.error(token, DiagnosticCode::ValueOutOfRange);
      return;
    }
    const auto number = static_cast<int>(value);
    switch (number) {
      case 2:
      case 30:
        words.ends = true;
        return;
      case 17:
        if (m_dialect == Dialect::Sinumerik) {
          words.rareWords().returns = true;
          return;
        }
        break;
      case 98:
        words.rareWords().call98 = true;
        return;
      case 99:
        if (m_dialect == Dialect::Heidenhain) {
          m_findings.error(token, DiagnosticCode::CycleNotRun, "CYCL CALL");
          return;
        }
        words.rareWords().returns = true;
        return;
      case 96:
      case 97:
        m_findings.error(token, DiagnosticCode::UnsupportedGCode, Findings::wordText(token));
        return;
      case 91:
      case 92:
        if (m_dialect == Dialect::Heidenhain) {
          words.machineMove = true;
          words.machineToken = &token;
          return;
        }
        break;
      case 140:
        if (m_dialect == Dialect::Heidenhain) {
          // A retract along the tool, to where only the control knows.
          m_findings.error(token, DiagnosticCode::UnsupportedGCode, "M140");
          m_facts.otherMotion();
          m_facts.forget();
          return;
        }
        break;
      default:
        break;
    }
    event(PathEvent::Kind::M, value);
    // If the program makes the machine wait for a person or a tool, a stream does not wait.
    const bool waits = number == 0 || number == 1 || (number == 6 && m_moved);
    m_findings.ignoreM(waits ? Severity::Warning : Severity::Note, static_cast<std::size_t>(number),
                       token);
  }

  void readName(const Token& token, BlockWords& words) {
    const std::string_view raw = tokenName(token);
    const std::string name = base::toUpper(raw);
    if (m_dialect == Dialect::Heidenhain && name == "CYCL") {
      readKlartextCycle(token);
      return;
    }
    if (token.kind == TokenKind::NamedValue && m_variables.find(name) != nullptr) {
      readAssignment(token, words);
      return;
    }
    switch (nc::nameEffect(m_dialect, name)) {
      case NameEffect::None:
        m_findings.ignore(Severity::Note, token, name);
        break;
      case NameEffect::Query:
        forgetArguments(token);
        m_findings.ignore(Severity::Note, token, name);
        break;
      case NameEffect::End:
        words.rareWords().returns = true;
        break;
      case NameEffect::Mode:
        m_findings.error(token, DiagnosticCode::UnsupportedGCode, name);
        break;
      case NameEffect::TakesBlock:
        m_findings.error(token, DiagnosticCode::UnsupportedGCode, name);
        words.taken = true;
        m_facts.forget();
        break;
      case NameEffect::Cycle:
        readCycle(token, name, words);
        break;
      case NameEffect::Frame:
        words.rareWords().frame = name;
        words.taken = true;
        break;
      case NameEffect::Motion:
        (name == "CIP" ? words.rareWords().threePointArc : words.rareWords().tangentArc) = true;
        break;
      case NameEffect::Spline:
        words.rareWords().bSpline = true;
        break;
      case NameEffect::MachineMove:
        words.machineMove = true;
        words.machineToken = &token;
        break;
      case NameEffect::Diameter:
        m_diameter = name != "DIAMOF";
        m_diameterIncrements = name == "DIAMON";
        m_findings.ignore(Severity::Note, token, name);
        break;
      case NameEffect::Transformation:
        m_tipWord = name == "TRAORI" ? "TRAORI" : "";
        m_findings.ignore(Severity::Note, token, name);
        break;
      case NameEffect::Address:
        if (token.kind != TokenKind::NamedValue) {
          m_findings.error(token, DiagnosticCode::UnknownWord);
        } else if (name == "CR") {
          setRadius(token, words);
        } else {
          words.rareWords().named[name] = {token.value, token.isIncrement};
          noteColumn(token, words);
        }
        break;
      case NameEffect::Unknown:
        readUnknownName(token, words);
        break;
    }
  }

  /// What a call has written to its variables only the control knows.
  void forgetArguments(const Token& token) {
    std::string_view rest = token.text.substr(std::min(token.text.find('('), token.text.size()));
    while (!rest.empty()) {
      rest.remove_prefix(1);
      const std::size_t end = std::min(rest.find_first_of(",)"), rest.size());
      nc::Expression variable;
      variable.op = nc::Op::Variable;
      variable.name = base::toUpper(base::trim(rest.substr(0, end)));
      if (m_variables.find(variable.name) != nullptr) {
        (void)m_variables.assign(variable, std::nan(""));
      }
      rest.remove_prefix(end);
    }
  }

  /// On a SINUMERIK a name alone, or with arguments, calls a subprogram.
  void readUnknownName(const Token& token, BlockWords& words) {
    if (m_dialect != Dialect::Sinumerik || token.kind == TokenKind::NamedValue) {
      m_findings.error(token, token.kind == TokenKind::Name
                                  ? DiagnosticCode::UnknownWord
                                  : DiagnosticCode::UnsupportedExpression);
      return;
    }
    words.rareWords().call = token;
  }

  void readCycle(const Token& token, const std::string& name, BlockWords& words) {
    words.taken = true;
    const std::size_t open = token.text.find('(');
    const std::string_view arguments =
        open == std::string_view::npos ? "" : token.text.substr(open + 1);
    m_facts.forget();
    if (name == "CYCLE800" && base::trim(arguments) == ")") {
      m_findings.ignore(Severity::Note, token, name);  // swivels back to the frame of the machine
      return;
    }
    m_findings.error(
        token, name == "CYCLE800" ? DiagnosticCode::UnsupportedGCode : DiagnosticCode::CycleNotRun,
        name);
    m_facts.otherMotion();
  }

  void readKlartextCycle(const Token& token) {
    const std::string text = base::toUpper(token.text);
    std::string_view digits = text;
    while (!digits.empty() && !isDigit(digits.front())) {
      digits.remove_prefix(1);
    }
    const int number = base::parseInteger(digits).value_or(0);
    const bool calls = text.find("CALL") != std::string::npos;
    // Cycles that move nothing themselves: shift, mirror, rotation, scale and tilt of the plane.
    static constexpr std::array kFrames{7, 8, 10, 11, 19, 26, 247};
    if (calls) {
      m_findings.error(token, DiagnosticCode::CycleNotRun, "CYCL CALL");
      m_facts.forget();
    } else if (std::find(kFrames.begin(), kFrames.end(), number) != kFrames.end()) {
      m_findings.error(token, DiagnosticCode::UnsupportedGCode, fmt::format("CYCL DEF {}", number));
      m_facts.forget();
    } else {
      m_findings.ignore(Severity::Note, token, fmt::format("CYCL DEF {}", number));
    }
  }

  // --- execution ---------------------------------------------------------------------------

  [[nodiscard]] Vec3 programmed() const { return m_splineEnd ? *m_splineEnd : m_path.position(); }

  /// G90 X Z and G94 X Z of a lathe go along a rectangle; with G0 to G3 they are what they are on
  /// a mill.
  void executeTurningCycle(BlockWords& words) {
    m_findings.report(Severity::Error, words.motionColumn, DiagnosticCode::CycleNotRun,
                      fmt::format("G{}", words.latheKey / 10));
    m_facts.otherMotion();
    m_facts.forget();
    words.taken = true;
  }

  void execute(BlockWords& words) {
    if (words.latheKey >= 0 && words.latheKey != 910 && words.motionKey < 0 &&
        words.movesLinear()) {
      executeTurningCycle(words);
    }
    setModes(words);
    if (words.rare) {
      executeRare(words);
    }
    if (words.parameter != nullptr && !words.dwell && !words.tolerance && !words.taken &&
        m_motion != Motion::Unsupported && m_motion != Motion::CubicSpline &&
        m_motion != Motion::Nurbs && !usesParameter(words)) {
      m_findings.error(*words.parameter, DiagnosticCode::UnknownWord);
    }
    if (words.dwell) {
      executeDwell(words);
    } else {
      if (words.hasFeed && !(words.taken && words.rare && words.rare->macroCall)) {
        setFeed(words);
      }
      if (words.taken) {
        m_furtherTokens.clear();
      } else {
        executeMotion(words);
      }
    }
    if (words.rare) {
      executeFlow(words);
    }
    if (!m_calculated.empty()) {
      m_calculated.clear();
    }
  }

  [[nodiscard]] bool usesParameter(const BlockWords& words) const {
    return words.rare && (words.rare->call98 || words.rare->workOffsetToken != nullptr ||
                          words.rare->call || words.rare->returns);
  }

  void setModes(const BlockWords& words) {
    if (words.unitsKey >= 0) {
      const bool inches = words.unitsKey == 200 || words.unitsKey == 700 || words.unitsKey == 7000;
      const double factor = inches ? base::kMmPerInch : 1.0;
      // G70 of a SINUMERIK speaks of lengths only: the feed stays in the control's unit, mm/min.
      const bool lengthsOnly = words.unitsKey == 700 && m_dialect == Dialect::Sinumerik;
      setUnits(factor, lengthsOnly ? 1.0 : factor);
    }
    if (words.planeKey >= 0) {
      m_planeFirstAxis = words.planeKey == 170 ? 0 : (words.planeKey == 180 ? 2 : 1);
    }
    if (words.motionKey >= 0) {
      flushSpline();
      static constexpr std::array kMotions{Motion::Rapid, Motion::Line, Motion::ArcClockwise,
                                           Motion::ArcCounter};
      m_motion = kMotions[static_cast<std::size_t>(words.motionKey / 10)];
    }
  }

  void setUnits(double lengthFactor, double feedFactor) {
    m_lengthFactor = lengthFactor;
    m_feedFactor = feedFactor;
    m_facts.units(lengthFactor != 1.0);
  }

  /// What must happen before the axes of the block are read.
  void executeRare(BlockWords& words) {
    const RareWords& rare = *words.rare;
    if (rare.threePointArc || rare.tangentArc) {
      flushSpline();
      m_motion = rare.threePointArc ? Motion::ThreePointArc : Motion::TangentArc;
    }
    if (rare.bSpline) {
      flushSpline();
      m_motion = Motion::BSpline;
      m_splineDegree = 3;
    }
    if (const NamedWord* const degree = words.named("SD")) {
      m_splineDegree = degree->value >= 2.0 && degree->value < 3.0 ? 2 : 3;
    }
    if (rare.splineKey >= 0) {
      selectSpline(rare.splineKey);
    }
    if (rare.workOffsetToken != nullptr && !words.p) {
      m_findings.report(Severity::Error, rare.workOffsetToken->column,
                        DiagnosticCode::NumberMissing, "P");
    } else if (rare.workOffsetToken != nullptr) {
      selectWorkOffset(rare.workOffsetKey, *rare.workOffsetToken, *words.p);
    }
    if (rare.pole) {
      setPole(words);
    }
    if (!rare.frame.empty()) {
      setFrame(rare.frame, words);
    }
    if (rare.setsPosition || rare.resetsPosition || rare.localOffset) {
      setOffset(words);
    }
  }

  void selectSpline(int key) {
    flushSpline();
    if (key == 50) {
      m_motion = Motion::CubicSpline;
    } else if (key == 51) {
      m_motion = Motion::QuadraticSpline;
    } else if (key == 52) {
      m_motion = Motion::Nurbs;
      m_splineDegree = 2;
    } else {
      m_motion = Motion::None;  // G5.3 closes the curve: the next block names its own motion
      m_motionNamed = true;
    }
    m_lastTangent = {};
  }

  void executeFlow(BlockWords& words) {
    const RareWords rare = std::move(*words.rare);
    if (rare.statement) {
      settle(m_flow.execute(*rare.statement), *rare.statement);
    }
    if (rare.call) {
      callByName(*rare.call, static_cast<int>(std::clamp(words.p.value_or(1.0), 0.0, 1e6)));
    }
    if ((rare.call98 || rare.macroCall) && !words.p) {
      m_findings.report(Severity::Error, 1, DiagnosticCode::NumberMissing, "P");
    } else if (rare.call98 || rare.macroCall) {
      int number = static_cast<int>(std::clamp(*words.p, 0.0, 1e9));
      int times = static_cast<int>(std::clamp(words.l.value_or(1.0), 0.0, 1e6));
      constexpr int kNumbers = 10000;
      if (number >= kNumbers && !words.l && rare.call98) {
        // P31000 of a Fanuc: three times O1000.
        times = number / kNumbers;
        number %= kNumbers;
      }
      Token token;
      settle(m_flow.callNumber(number, times,
                               rare.macroCall ? std::optional(rare.arguments) : std::nullopt),
             token);
    }
    if (rare.returns && !m_flow.leaveSubprogram()) {
      flushSpline();
      m_ended = true;
    }
  }

  /// PART(1,2), PART P3 and L123.
  void callByName(const Token& token, int times) {
    const std::string numbered =
        token.address == 'L' ? fmt::format("L{:.0f}", token.value) : std::string();
    settle(m_flow.call(numbered.empty() ? token.text : numbered, token.column, times), token);
  }

  void settle(const nc::Outcome& outcome, const Token& token) {
    if (const auto* const fault = std::get_if<nc::Fault>(&outcome)) {
      m_facts.incomplete();
      report(token, *fault);
    } else if (const auto* const missing = std::get_if<nc::SubprogramMissing>(&outcome)) {
      m_findings.error(token, DiagnosticCode::SubprogramMissing, missing->name);
    } else if (const auto* const unsupported = std::get_if<nc::Unsupported>(&outcome)) {
      m_facts.incomplete();
      m_findings.error(token, DiagnosticCode::UnsupportedExpression, unsupported->word);
    } else if (const auto* const ignored = std::get_if<nc::Ignored>(&outcome)) {
      if (!ignored->word.empty()) {
        m_findings.ignore(Severity::Note, token, ignored->word);
      }
    } else if (const auto* const modal = std::get_if<nc::ModalCall>(&outcome)) {
      if (!modal->name.empty()) {
        m_findings.error(token, DiagnosticCode::CycleNotRun, modal->name);
        m_facts.otherMotion();
      }
    }
  }

  /// X, F, S, P and U of a dwell are times; what else it names would be lost.
  void executeDwell(const BlockWords& words) {
    for (std::size_t axis = 1; axis < base::kAxisCount; ++axis) {
      if (words.axes.given[axis]) {
        m_findings.error(*words.axisTokens[axis], DiagnosticCode::UnknownWord);
      }
    }
    rejectArcWords(words);
    m_furtherTokens.clear();
    double seconds = std::nan("");
    if (words.hasFeed) {
      seconds = words.feed;
    } else if (words.p) {
      // Fanuc counts milliseconds where there is no point, RS-274/NGC seconds.
      const bool milliseconds = m_dialect == Dialect::Iso && !words.parameter->hasPoint;
      seconds = milliseconds ? *words.p / 1000.0 : *words.p;
    } else if (words.axes.given[0]) {
      seconds = words.axes.value[0];
    } else if (words.axes.given[6]) {
      seconds = words.axes.value[6];
    }
    event(PathEvent::Kind::Dwell, seconds);
  }

  void rejectArcWords(const BlockWords& words) {
    if (words.hasRadius) {
      m_findings.error(*words.radiusToken, DiagnosticCode::UnknownWord);
    }
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (words.hasCentre[axis]) {
        m_findings.error(*words.centreTokens[axis], DiagnosticCode::UnknownWord);
      }
    }
  }

  void setFeed(const BlockWords& words) {
    m_facts.feed(words.feed);
    if (!(words.feed > 0.0)) {
      m_findings.error(m_feedToken, DiagnosticCode::FeedNotPositive,
                       base::formatNumber(words.feed));
      return;
    }
    double feedMmPerMin = words.feed * m_feedFactor;
    if (m_feedMode == FeedMode::PerRevolution) {
      feedMmPerMin = words.feed * m_lengthFactor * m_spindlePerMin;
    } else if (m_feedMode != FeedMode::PerMinute) {
      return;  // known block by block, or not at all
    }
    if (!(feedMmPerMin <= kCoordinateMmMax)) {
      m_findings.error(m_feedToken, DiagnosticCode::ValueOutOfRange);
      return;
    }
    m_feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
    std::vector<double>& feeds = m_out.statistics.feedsMmPerMin;
    if (feedMmPerMin > 0.0 && (feeds.empty() || feeds.back() != feedMmPerMin)) {
      feeds.push_back(feedMmPerMin);
    }
  }

  // --- frames and offsets ---------------------------------------------------------------------

  [[nodiscard]] double lengthMm(const BlockWords& words, std::size_t axis) const {
    return words.axes.value[axis] * m_lengthFactor;
  }

  void setFrame(const std::string& name, const BlockWords& words) {
    flushSpline();
    const bool additive = name[0] == 'A';
    const std::string_view kind = additive ? std::string_view(name).substr(1) : name;
    Frame frame = additive ? m_path.frame() : m_baseFrame;
    if (!knowsAllAxes(words, name)) {
      return;
    }
    const NamedWord* const inPlane = words.named("RPL");
    if (kind == "TRANS") {
      Vec3 offset;
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        offset.set(axis, words.axes.given[axis] ? lengthMm(words, axis) : 0.0);
      }
      if (words.movesLinear()) {
        frame.translate(offset);
      }
    } else if (kind == "ROT") {
      // About Z, then the turned Y, then the turned X.
      for (std::size_t axis = base::kAxisCount; axis-- > 0;) {
        if (words.axes.given[axis]) {
          frame.rotate(axis, words.axes.value[axis]);
        }
      }
      if (inPlane != nullptr) {
        frame.rotate((m_planeFirstAxis + 2) % base::kAxisCount, inPlane->value);
      }
    } else {
      Vec3 factors{1.0, 1.0, 1.0};
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        if (!words.axes.given[axis]) {
          continue;
        }
        const double factor = kind == "MIRROR" ? -1.0 : words.axes.value[axis];
        if (factor == 0.0) {
          m_findings.error(*words.axisTokens[axis], DiagnosticCode::ValueOutOfRange);
          return;
        }
        factors.set(axis, factor);
      }
      if (words.movesLinear()) {
        frame.scale(factors);
      }
    }
    const Vec3 before = m_path.position();
    m_path.setFrame(frame);
    m_facts.forget();
    // The next increment of an axis counts from what was programmed, so that it passes the shift
    // of the frame as well (SD42440, as delivered).
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      m_incrementFrom[axis] = m_incrementFrom[axis].value_or(before[axis]);
    }
  }

  /// Frames shift, turn and scale X, Y and Z; where the other axes would go is not known.
  bool knowsAllAxes(const BlockWords& words, const std::string& statement) {
    if (words.hasRotary) {
      m_findings.report(Severity::Error, words.motionColumn, DiagnosticCode::UnsupportedGCode,
                        statement);
    }
    return !words.hasRotary;
  }

  /// G92: where the axes stand gets these coordinates. Where that is for an axis that has not
  /// moved yet, the operator has seen to: its offset is zero.
  void setPosition(const BlockWords& words) {
    const Vec3 position = m_path.position();
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (words.axes.given[axis] && std::isnan(position[axis])) {
        m_path.place(axis, lengthMm(words, axis));
      } else if (words.axes.given[axis]) {
        m_setOffsetMm.set(axis, m_setOffsetMm[axis] + position[axis] - lengthMm(words, axis));
      }
      const std::size_t rotary = axis + base::kAxisCount;
      if (words.axes.given[rotary] && std::isnan(m_path.rotary(axis))) {
        m_path.placeRotary(axis, words.axes.value[rotary]);
        m_rotaryFirst[axis] = words.axes.value[rotary];
      } else if (words.axes.given[rotary]) {
        m_rotaryOffset[axis] = m_path.rotary(axis) - words.axes.value[rotary];
      }
    }
  }

  /// G92, G92.1 and G52.
  void setOffset(const BlockWords& words) {
    flushSpline();
    const RareWords& rare = *words.rare;
    m_facts.forget();
    constexpr std::size_t kFirstFurther = 6;  // U, V, W
    const bool further = std::find(words.axes.given.begin() + kFirstFurther, words.axes.given.end(),
                                   true) != words.axes.given.end();
    if ((rare.localOffset || further) && !knowsAllAxes(words, rare.localOffset ? "G52" : "G92")) {
      return;
    }
    if (rare.setsPosition && !words.moves()) {
      return;  // G92 S: a limit of the spindle; G92 alone: nothing
    }
    if (rare.setsPosition) {
      setPosition(words);
    } else if (rare.resetsPosition) {
      m_setOffsetMm = {};
      m_rotaryOffset = {};
    } else {
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        if (words.axes.given[axis]) {
          m_localOffsetMm.set(axis, lengthMm(words, axis));
        }
      }
    }
    m_baseFrame = {};
    const Vec3 offset = m_setOffsetMm + m_localOffsetMm;
    if (offset != Vec3{}) {
      m_baseFrame.translate(offset);
    }
    m_path.setFrame(m_baseFrame);
  }

  /// G110, G111, G112, and CC of Heidenhain's plain text.
  void setPole(const BlockWords& words) {
    const Vec3 position = programmed();
    Vec3 pole = words.rare->poleKey == 1100        ? position
                : words.rare->poleKey == 1120      ? m_poleMm
                : m_dialect == Dialect::Heidenhain ? m_poleMm
                                                   : Vec3{};
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (!words.axes.given[axis]) {
        continue;
      }
      // IX of Heidenhain counts from the position, as G110 does.
      const bool relative = words.rare->poleKey != 1110;
      const double origin = words.axes.isIncrement[axis] ? position[axis]
                            : relative                   ? pole[axis]
                                                         : 0.0;
      pole.set(axis, origin + lengthMm(words, axis));
    }
    if (const NamedWord* const radius = words.named("RP")) {
      const NamedWord* const angle = words.named("AP");
      addPolar(pole, radius->value * m_lengthFactor, angle == nullptr ? 0.0 : angle->value);
    }
    m_poleMm = pole;
  }

  void addPolar(Vec3& point, double radiusMm, double degrees) const {
    const double radians = degrees * std::acos(-1.0) / 180.0;
    const std::size_t second = (m_planeFirstAxis + 1) % base::kAxisCount;
    point.set(m_planeFirstAxis, point[m_planeFirstAxis] + radiusMm * std::cos(radians));
    point.set(second, point[second] + radiusMm * std::sin(radians));
  }

  // --- motion -------------------------------------------------------------------------------

  void executeMotion(BlockWords& words) {
    const bool arcMode = m_motion == Motion::ArcClockwise || m_motion == Motion::ArcCounter;
    const bool isPolar =
        words.rare && (words.named("AP") != nullptr || words.named("RP") != nullptr);
    const bool isTurn = words.rare && words.named("AR") != nullptr;
    const bool moves = words.moves() || isPolar || (arcMode && (words.hasAnyCentre() || isTurn));
    if (words.machineMove && words.moves()) {
      moveInMachine(words);
      return;
    }
    if (m_motion == Motion::Unsupported) {
      if (moves) {
        m_facts.otherMotion();
        m_facts.forget();
      }
      return;
    }
    if (!m_furtherTokens.empty()) {
      for (const Token& token : m_furtherTokens) {
        m_findings.error(token, DiagnosticCode::UnknownWord);
      }
      m_furtherTokens.clear();
    }
    if (!arcMode && m_motion != Motion::CubicSpline && m_motion != Motion::QuadraticSpline) {
      rejectArcWords(words);
    }
    if (m_motion == Motion::Nurbs && words.rare && words.rare->splineKey == 52 && !moves) {
      m_nurbsFirstWeight = words.p.value_or(1.0);
    }
    if (moves) {
      move(words);
    }
  }

  /// SUPA, G53, M91: where that is in the workpiece is not known.
  void moveInMachine(const BlockWords& words) {
    m_findings.error(*words.machineToken, DiagnosticCode::MachineCoordinates,
                     words.machineToken->kind == TokenKind::Word
                         ? Findings::wordText(*words.machineToken)
                         : base::toUpper(tokenName(*words.machineToken)));
    m_furtherTokens.clear();
    if (const int g = motionNumber(); g >= -1) {
      m_facts.machineMotion(g, words.axes);
    } else {
      m_facts.otherMotion();
      m_facts.forget();
    }
  }

  /// 0 to 3 for G0 to G3, -1 before any of them, -2 for other motions.
  [[nodiscard]] int motionNumber() const {
    switch (m_motion) {
      case Motion::None:
        return -1;
      case Motion::Rapid:
        return 0;
      case Motion::Line:
        return m_motionAssumed ? -1 : 1;
      case Motion::ArcClockwise:
        return 2;
      case Motion::ArcCounter:
        return 3;
      default:
        return -2;
    }
  }

  /// Takes the programmed axes over. @return the new position, programmed coordinates
  Vec3 targetOf(const BlockWords& words) {
    const Vec3 from = programmed();
    Vec3 target = from;
    const std::size_t second = (m_planeFirstAxis + 1) % base::kAxisCount;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (!words.axes.given[axis]) {
        continue;
      }
      double value = words.axes.value[axis] * m_lengthFactor;
      if (std::isnan(value)) {
        continue;  // has been reported
      }
      if (!(std::abs(value) <= kCoordinateMmMax)) {
        m_findings.error(*words.axisTokens[axis], DiagnosticCode::ValueOutOfRange);
        continue;
      }
      if (m_diameter && axis == 0 && (!words.axes.isIncrement[axis] || m_diameterIncrements)) {
        value /= 2.0;
      }
      if (words.axes.isIncrement[axis]) {
        const double origin = m_incrementFrom[axis].value_or(from[axis]);
        if (std::isnan(origin)) {
          m_findings.error(*words.axisTokens[axis], DiagnosticCode::RelativeFromUnknownPosition,
                           std::string(1, base::kAxisNames[axis]));
          continue;
        }
        value += origin;
      }
      m_incrementFrom[axis].reset();
      target.set(axis, value);
    }
    if (m_polar && (words.axes.given[m_planeFirstAxis] || words.axes.given[second])) {
      // G16: the first axis of the plane is the radius, the second the angle.
      m_polarRadiusMm = words.axes.given[m_planeFirstAxis]
                            ? words.axes.value[m_planeFirstAxis] * m_lengthFactor
                            : m_polarRadiusMm;
      m_polarDegrees = words.axes.given[second] ? words.axes.value[second] : m_polarDegrees;
      setPolar(target);
    } else if (words.rare) {
      takePolarWords(words, from, target);
    }
    return target;
  }

  void setPolar(Vec3& target) const {
    const std::size_t second = (m_planeFirstAxis + 1) % base::kAxisCount;
    const Vec3 pole = m_polar ? Vec3{} : m_poleMm;
    target.set(m_planeFirstAxis, pole[m_planeFirstAxis]);
    target.set(second, pole[second]);
    addPolar(target, m_polarRadiusMm, m_polarDegrees);
  }

  void takePolarWords(const BlockWords& words, Vec3 from, Vec3& target) {
    const NamedWord* const radius = words.named("RP");
    const NamedWord* const angle = words.named("AP");
    if (radius == nullptr && angle == nullptr) {
      return;
    }
    const std::size_t second = (m_planeFirstAxis + 1) % base::kAxisCount;
    const double first = from[m_planeFirstAxis] - m_poleMm[m_planeFirstAxis];
    const double other = from[second] - m_poleMm[second];
    // CP of Heidenhain names no radius: it is that of the start.
    if (radius != nullptr) {
      m_polarRadiusMm =
          radius->value * m_lengthFactor + (radius->isIncrement ? m_polarRadiusMm : 0.0);
    } else if (m_dialect == Dialect::Heidenhain) {
      m_polarRadiusMm = std::hypot(first, other);
    }
    const double degrees = std::atan2(other, first) * 180.0 / std::acos(-1.0);
    m_polarTurnDegrees = 0.0;
    if (angle != nullptr) {
      const bool relative = angle->isIncrement || m_relative;
      if (relative) {
        m_polarTurnDegrees = angle->value;
      }
      m_polarDegrees = angle->value + (relative ? degrees : 0.0);
    }
    setPolar(target);
    if (m_polarTurnDegrees != 0.0 && std::fmod(m_polarTurnDegrees, 360.0) == 0.0) {
      target.set(m_planeFirstAxis, from[m_planeFirstAxis]);
      target.set(second, from[second]);
    }
  }

  [[nodiscard]] MoveWords moveWords(const BlockWords& words, Vec3 target) {
    MoveWords move;
    move.line = m_line;
    move.feedMmPerS = m_feedMmPerS;
    if (m_feedMode == FeedMode::InverseTime) {
      move.feedMmPerS = words.hasFeed ? m_path.lengthTo(target) * words.feed / 60.0 : 0.0;
    }
    if (words.hasRotary) {
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        if (!words.axes.given[axis + 3]) {
          continue;
        }
        double degrees = words.axes.value[axis + 3];
        if (words.axes.isIncrement[axis + 3]) {
          if (std::isnan(m_path.rotary(axis))) {
            m_findings.report(Severity::Error, words.motionColumn,
                              DiagnosticCode::RelativeFromUnknownPosition,
                              std::string(1, kProgrammedAxes[axis + 3]));
            continue;
          }
          degrees += m_path.rotary(axis);
        } else {
          degrees += m_rotaryOffset[axis];
        }
        move.rotaryDegrees[axis] = degrees;
        noteRotary(axis, degrees, words.motionColumn);
      }
    }
    if (words.rare) {
      takeDirection(words, move);
    }
    return move;
  }

  void takeDirection(const BlockWords& words, MoveWords& move) {
    const NamedWord* const a = words.named("A3");
    const NamedWord* const b = words.named("B3");
    const NamedWord* const c = words.named("C3");
    if (a == nullptr && b == nullptr && c == nullptr) {
      return;
    }
    const auto value = [](const NamedWord* word) { return word == nullptr ? 0.0 : word->value; };
    const Vec3 direction{value(a), value(b), value(c)};
    const double length = base::norm(direction);
    if (!(length > 0.0)) {
      m_findings.report(Severity::Error, words.motionColumn, DiagnosticCode::ValueOutOfRange,
                        "A3= B3= C3=");
      return;
    }
    move.toolDirection = (1.0 / length) * direction;
    if (!m_directionReported) {
      m_directionReported = true;
      m_findings.report(Severity::Warning, words.motionColumn, DiagnosticCode::ToolDirections,
                        "A3 B3 C3");
    }
  }

  void noteRotary(std::size_t axis, double degrees, int column) {
    // An axis first named in mid-path turns there: where it stood before is not known.
    const bool turns = m_rotaryFirst[axis] ? *m_rotaryFirst[axis] != degrees : m_pathBegun;
    m_rotaryFirst[axis] = m_rotaryFirst[axis].value_or(degrees);
    if (turns && !m_tipWord.empty() && !m_tipReported) {
      m_tipReported = true;
      m_findings.report(Severity::Warning, column, DiagnosticCode::ToolTip, m_tipWord);
    }
    if (turns && !m_rotaryReported[axis]) {
      m_rotaryReported[axis] = true;
      m_findings.report(Severity::Warning, column, DiagnosticCode::RotaryAxes,
                        std::string(1, kProgrammedAxes[axis + 3]));
    }
  }

  void move(BlockWords& words) {
    if (m_motion == Motion::None) {
      m_findings.report(Severity::Warning, words.motionColumn, DiagnosticCode::MotionModeAssumed,
                        {});
      m_motion = Motion::Line;
      m_motionAssumed = !m_motionNamed;
    }
    m_motionAssumed = m_motionAssumed && words.motionKey < 0;
    m_moved = true;
    const Vec3 target = targetOf(words);
    const MoveWords details = moveWords(words, target);
    m_pathBegun = m_pathBegun || words.movesLinear() || words.rare || words.hasAnyCentre();
    const bool rapid = m_motion == Motion::Rapid;
    if (!rapid && details.feedMmPerS == 0.0 && !m_feedMissingReported &&
        !(m_feedMode == FeedMode::InverseTime && words.hasFeed)) {
      m_findings.report(Severity::Warning, words.motionColumn, DiagnosticCode::FeedMissing, {});
      m_feedMissingReported = true;
    }
    Statistics& statistics = m_out.statistics;
    switch (m_motion) {
      case Motion::Rapid:
      case Motion::Line:
        ++statistics.motions[rapid ? 0 : 1];
        m_facts.motion(motionNumber(), words.axes);
        m_path.line(target, rapid, details);
        break;
      case Motion::ArcClockwise:
      case Motion::ArcCounter:
        moveArc(words, target, details);
        break;
      case Motion::ThreePointArc:
      case Motion::TangentArc:
        m_facts.otherMotion();
        m_facts.forget();
        moveSpaceArc(words, target, details);
        break;
      case Motion::BSpline:
      case Motion::Nurbs:
        m_facts.otherMotion();
        m_facts.forget();
        addControlPoint(words, target, details);
        break;
      case Motion::CubicSpline:
      case Motion::QuadraticSpline:
        m_facts.otherMotion();
        m_facts.forget();
        moveBezier(words, target, details);
        break;
      case Motion::None:
      case Motion::Unsupported:
        break;
    }
  }

  void moveArc(BlockWords& words, Vec3 target, const MoveWords& details) {
    const bool clockwise = m_motion == Motion::ArcClockwise;
    ++m_out.statistics.motions[clockwise ? 2 : 3];
    Arc arc;
    arc.firstAxis = m_planeFirstAxis;
    arc.clockwise = clockwise;
    if (const NamedWord* const turns = words.named("TURN");
        turns != nullptr && !(turns->value >= 0.0 && turns->value <= kTurnsMax &&
                              turns->value == std::floor(turns->value))) {
      m_findings.report(Severity::Error, words.motionColumn, DiagnosticCode::ValueOutOfRange,
                        "TURN=");
      m_facts.motion(clockwise ? 2 : 3, words.axes);
      m_path.unknownWay(target, details);
      return;
    }
    ArcWords arcWords = arcWordsOf(words, arc);
    countArc(words, arc, arcWords);
    for (const std::size_t axis : {0U, 1U, 2U}) {
      if (arcWords.centre[axis] && !centreFits(words, axis)) {
        m_path.unknownWay(target, details);
        return;
      }
      if (arcWords.centre[axis]) {
        // I=AC() is a diameter where X is one; an increment, and G90.1, is not.
        const bool isDiameter =
            m_diameter && axis == 0 && words.centreIsAbsolute[axis] && !m_centreIsAbsolute;
        *arcWords.centre[axis] *= isDiameter ? m_lengthFactor / 2.0 : m_lengthFactor;
      }
    }
    if (arcWords.radius) {
      *arcWords.radius *= m_lengthFactor;
      if (!(std::abs(*arcWords.radius) <= kCoordinateMmMax)) {
        m_findings.error(*words.radiusToken, DiagnosticCode::ValueOutOfRange);
        m_path.unknownWay(target, details);
        return;
      }
    }
    const std::size_t second = (m_planeFirstAxis + 1) % base::kAxisCount;
    const std::size_t third = (m_planeFirstAxis + 2) % base::kAxisCount;
    usePoleAsCentre(words, arcWords);
    if (!arcWords.centre[m_planeFirstAxis] && !arcWords.centre[second] && !arcWords.centre[third] &&
        !arcWords.radius && !arcWords.degrees) {
      m_findings.report(Severity::Error, words.motionColumn, DiagnosticCode::ArcWithoutCentre, {});
      m_path.unknownWay(target, details);
      return;
    }
    const Vec3 from = m_path.position();
    for (const std::size_t axis : {m_planeFirstAxis, second, third}) {
      const bool needed = axis != third || words.axes.given[third];
      if (needed && std::isnan(from[axis])) {
        m_findings.report(Severity::Error, words.motionColumn,
                          DiagnosticCode::ArcFromUnknownPosition,
                          std::string(1, base::kAxisNames[axis]));
        m_path.unknownWay(target, details);
        return;
      }
    }
    arc.startMm = from;
    arc.endMm = target;
    const double across = arcWords.centre[third].value_or(0.0);
    if (m_dialect == Dialect::Sinumerik && across != 0.0 && words.axes.given[third]) {
      // A helix: the centre is a place in the plane, its third coordinate has no meaning.
      m_findings.report(Severity::Warning, words.centreTokens[third]->column,
                        DiagnosticCode::CentreOutsidePlane,
                        std::string(words.centreTokens[third]->text));
      arcWords.centre[third].reset();
    }
    arcWords = readAs(m_options.centres, arcWords);
    if (m_polarTurnDegrees != 0.0 && words.named("AP") != nullptr) {
      arc.turns =
          std::max(0, static_cast<int>(std::ceil(std::abs(m_polarTurnDegrees) / 360.0)) - 1);
    }
    const ResolvedArc resolved = resolveArc(arc, arcWords);
    if (!reportArcProblem(resolved, words)) {
      m_path.unknownWay(target, details);
      return;
    }
    const ArcRadii radii = arcRadii(resolved.arc);
    if (!hasFewChords(arcSweep(resolved.arc), std::max(radii.startMm, radii.endMm), words)) {
      m_path.unknownWay(target, details);
      return;
    }
    MoveWords arcDetails = details;
    if (m_feedMode == FeedMode::InverseTime && words.hasFeed) {
      // How long an ellipse is, is not known in advance.
      arcDetails.feedMmPerS =
          m_path.frame().keepsCircles()
              ? arcLength(resolved.arc) * m_path.frame().stretchMax() * words.feed / 60.0
              : 0.0;
    }
    m_path.arc(resolved.arc, arcDetails);
  }

  ArcWords arcWordsOf(const BlockWords& words, Arc& arc) const {
    ArcWords arcWords;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (words.hasCentre[axis]) {
        arcWords.centre[axis] = words.centre[axis];
        arcWords.centreIsAbsolute[axis] = words.centreIsAbsolute[axis];
      }
    }
    if (words.hasRadius) {
      arcWords.radius = words.radius;
    }
    const std::size_t second = (m_planeFirstAxis + 1) % base::kAxisCount;
    arcWords.endIsGiven = words.axes.given[m_planeFirstAxis] || words.axes.given[second];
    if (words.rare) {
      if (const NamedWord* const angle = words.named("AR")) {
        arcWords.degrees = angle->value;
      }
      if (const NamedWord* const turns = words.named("TURN")) {
        arc.turns = static_cast<int>(turns->value);
      }
    }
    return arcWords;
  }

  /// Arcs of Heidenhain's plain text, and those with AP=, turn about the pole.
  void usePoleAsCentre(const BlockWords& words, ArcWords& arcWords) const {
    const bool hasCentre = words.hasAnyCentre() || words.hasRadius || arcWords.degrees;
    const bool turnsAboutPole = m_dialect == Dialect::Heidenhain || words.named("AP") != nullptr;
    if (hasCentre || !turnsAboutPole) {
      return;
    }
    for (const std::size_t axis : {m_planeFirstAxis, (m_planeFirstAxis + 1) % base::kAxisCount}) {
      arcWords.centre[axis] = m_poleMm[axis];
      arcWords.centreIsAbsolute[axis] = true;
    }
  }

  void countArc(const BlockWords& words, const Arc& arc, ArcWords arcWords) {
    const int g = arc.clockwise ? 2 : 3;
    if (words.named("AP") != nullptr) {
      // The end of a polar arc is calculated, not programmed.
      m_facts.otherMotion();
      m_facts.forget();
      return;
    }
    usePoleAsCentre(words, arcWords);
    for (const std::size_t axis : {m_planeFirstAxis, (m_planeFirstAxis + 1) % base::kAxisCount}) {
      if (m_dialect == Dialect::Heidenhain && arcWords.centre[axis]) {
        *arcWords.centre[axis] /= m_lengthFactor;
      }
    }
    m_facts.arc(g, words.axes, arc, arcWords);
  }

  bool centreFits(const BlockWords& words, std::size_t axis) {
    if (words.centreTokens[axis] == nullptr ||
        std::abs(words.centre[axis] * m_lengthFactor) <= kCoordinateMmMax) {
      return true;
    }
    m_findings.error(*words.centreTokens[axis], DiagnosticCode::ValueOutOfRange);
    return false;
  }

  /// One block may not fill the memory, however large its arc and small the tolerance.
  bool hasFewChords(double sweepRad, double radiusMm, const BlockWords& words) {
    constexpr double kChordsMax = 1e6;
    if (chordCount(sweepRad, radiusMm, m_path.chordToleranceMm()) <= kChordsMax) {
      return true;
    }
    m_findings.report(Severity::Error, words.motionColumn, DiagnosticCode::TooManyPoints,
                      fmt::format("{:.0f}", kChordsMax));
    return false;
  }

  /// @return true if there is none
  bool reportArcProblem(const ResolvedArc& resolved, const BlockWords& words) {
    const int column = words.motionColumn;
    switch (resolved.problem) {
      case ArcProblem::None:
        return true;
      case ArcProblem::CentreMissing:
        m_findings.report(Severity::Error, column, DiagnosticCode::ArcWithoutCentre, {});
        break;
      case ArcProblem::CentreOutsidePlane:
        m_findings.error(*words.centreTokens[resolved.axis], DiagnosticCode::CentreOutsidePlane);
        break;
      case ArcProblem::CentreAndRadius:
        m_findings.report(Severity::Error, column, DiagnosticCode::ConflictingGCodes,
                          words.radiusIsWord ? "I J K and R" : "I J K and CR=");
        break;
      case ArcProblem::RadiusMismatch:
        if (isAllowedSpiral(resolved)) {
          m_findings.report(Severity::Warning, column, DiagnosticCode::ArcRadiusMismatch,
                            base::formatFixed(resolved.mismatch, 4));
          return true;
        }
        m_findings.report(Severity::Error, column, DiagnosticCode::ArcRadiusMismatch,
                          base::formatFixed(resolved.mismatch, 4));
        break;
      case ArcProblem::RadiusTooSmall:
        m_findings.report(Severity::Error, column, DiagnosticCode::ArcRadiusTooSmall,
                          fmt::format("{} < {}", base::formatFixed(resolved.mismatch, 4),
                                      base::formatFixed(resolved.halfChord, 4)));
        break;
    }
    return false;
  }

  /// RS-274/NGC and what follows it make a spiral of an arc whose radii differ by a thousandth.
  [[nodiscard]] bool isAllowedSpiral(const ResolvedArc& resolved) const {
    constexpr double kShare = 1e-3;
    const ArcRadii radii = arcRadii(resolved.arc);
    return m_dialect != Dialect::Sinumerik && m_dialect != Dialect::Heidenhain &&
           resolved.mismatch <= kShare * std::max(radii.startMm, radii.endMm);
  }

  void moveSpaceArc(const BlockWords& words, Vec3 target, const MoveWords& details) {
    const Vec3 from = m_path.position();
    if (!base::isFinite(from) || !base::isFinite(target)) {
      m_findings.report(Severity::Error, words.motionColumn, DiagnosticCode::ArcFromUnknownPosition,
                        "X Y Z");
      m_path.unknownWay(target, details);
      return;
    }
    std::optional<SpaceArc> arc;
    if (m_motion == Motion::ThreePointArc) {
      Vec3 middle = from;
      static constexpr std::array<std::string_view, base::kAxisCount> kNames{"I1", "J1", "K1"};
      bool given = false;
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        if (const NamedWord* const word = words.named(kNames[axis])) {
          middle.set(axis, word->value * m_lengthFactor + (m_relative ? from[axis] : 0.0));
          given = true;
        }
      }
      arc = given ? arcThrough(from, middle, target) : std::nullopt;
    } else {
      arc = tangentArc(from, m_path.direction(), target);
      if (!arc && base::norm(m_path.direction()) > 0.0) {
        m_path.line(target, false, details);  // straight on
        return;
      }
    }
    if (!arc) {
      m_findings.report(Severity::Error, words.motionColumn, DiagnosticCode::ArcWithoutCentre, {});
      m_path.unknownWay(target, details);
      return;
    }
    if (!hasFewChords(arc->sweepRad, base::distance(arc->centreMm, from), words)) {
      m_path.unknownWay(target, details);
      return;
    }
    m_path.spaceArc(*arc, target, details);
  }

  // --- splines ------------------------------------------------------------------------------

  void addControlPoint(const BlockWords& words, Vec3 target, const MoveWords& details) {
    const Vec3 from = programmed();
    if (!base::isFinite(from)) {
      m_findings.report(Severity::Error, words.motionColumn, DiagnosticCode::ArcFromUnknownPosition,
                        "X Y Z");
      m_path.unknownWay(target, details);
      return;
    }
    if (!m_splineEnd) {
      m_spline = {};
      m_spline.controlMm.push_back(from);
      m_spline.weights.push_back(m_motion == Motion::Nurbs ? m_nurbsFirstWeight : 1.0);
      m_nurbsFirstWeight = 1.0;
    }
    double weight = 1.0;
    if (m_motion == Motion::Nurbs) {
      weight = words.p.value_or(1.0);
      if (words.l) {
        m_splineDegree = static_cast<int>(std::clamp(*words.l - 1.0, 1.0, 9.0));
      }
    } else if (const NamedWord* const given = words.named("PW")) {
      weight = given->value;
    }
    if (words.named("PL") != nullptr) {
      m_findings.report(Severity::Error, words.motionColumn, DiagnosticCode::UnsupportedGCode,
                        "PL");
    }
    if (!(weight > 0.0)) {
      m_findings.report(Severity::Error, words.motionColumn, DiagnosticCode::ValueOutOfRange, "PW");
      weight = 1.0;
    }
    m_spline.controlMm.push_back(target);
    m_spline.weights.push_back(weight);
    m_splineEnd = target;
    m_splineDetails = details;
  }

  void flushSpline() {
    if (!m_splineEnd) {
      return;
    }
    m_splineEnd.reset();
    const std::size_t points = m_spline.controlMm.size();
    m_spline.degree = std::min(m_splineDegree, static_cast<int>(points) - 1);
    m_spline.knots = clampedKnots(points, m_spline.degree);
    m_path.spline(m_spline, m_splineDetails);
  }

  /// G5: I J from the start, P Q from the end. G5.1: I J only.
  void moveBezier(const BlockWords& words, Vec3 target, const MoveWords& details) {
    const Vec3 from = m_path.position();
    const bool cubic = m_motion == Motion::CubicSpline;
    if (!base::isFinite(from) || m_planeFirstAxis != 0) {
      m_findings.report(Severity::Error, words.motionColumn, DiagnosticCode::ArcFromUnknownPosition,
                        "X Y Z");
      m_path.unknownWay(target, details);
      return;
    }
    const bool hasStart = words.hasCentre[0] || words.hasCentre[1];
    const Vec3 start =
        hasStart ? Vec3{words.centre[0] * m_lengthFactor, words.centre[1] * m_lengthFactor, 0.0}
                 : -1.0 * m_lastTangent;
    if (!hasStart && m_lastTangent == Vec3{}) {
      m_findings.report(Severity::Error, words.motionColumn, DiagnosticCode::ArcWithoutCentre, {});
      m_path.unknownWay(target, details);
      return;
    }
    Spline spline;
    spline.controlMm = {from, from + start};
    if (cubic) {
      const Vec3 end{words.p.value_or(0.0) * m_lengthFactor, words.q.value_or(0.0) * m_lengthFactor,
                     0.0};
      spline.controlMm.push_back(target + end);
      m_lastTangent = end;
    }
    spline.controlMm.push_back(target);
    spline.degree = static_cast<int>(spline.controlMm.size()) - 1;
    spline.weights.assign(spline.controlMm.size(), 1.0);
    spline.knots = clampedKnots(spline.controlMm.size(), spline.degree);
    m_path.spline(spline, details);
  }

  // --- the end -----------------------------------------------------------------------------------

  void finish() {
    flushSpline();
    if (const std::optional<base::LineNumber> line = m_flow.endlessLoop()) {
      m_findings.setPlace(*line, m_flow.fileName(0));
      m_findings.report(Severity::Error, 1, DiagnosticCode::EndlessLoop,
                        fmt::format("{}", m_options.repeatedLinesMax));
      m_facts.incomplete();
    }
    Statistics& statistics = m_out.statistics;
    if (m_ended && !m_tailReported && !m_out.cancelled) {
      reportTail();
    }
    statistics.lines = m_out.cancelled ? 0 : m_flow.fileLines();
    m_out.facts = m_facts.take();
    if (m_out.facts.centreReading != CentreReading::AsProgrammed &&
        m_options.centres == CentreReading::AsProgrammed) {
      m_findings.reportProgram(Severity::Note, DiagnosticCode::CentreReading,
                               std::string(centreReadingName(m_out.facts.centreReading)));
    }
    if (m_out.trajectory.points.empty() && !m_out.cancelled) {
      m_findings.reportProgram(Severity::Warning, DiagnosticCode::NoMotion, {});
    }
    m_out.diagnostics = m_findings.take();
    std::vector<double>& feeds = statistics.feedsMmPerMin;
    std::sort(feeds.begin(), feeds.end());
    feeds.erase(std::unique(feeds.begin(), feeds.end()), feeds.end());
    statistics.points = m_out.trajectory.points.size();
  }

  /// What follows the end of a program is not read; subprograms after it are.
  void reportTail() {
    Block block;
    while (m_flow.nextBehindEnd(block)) {
      if (block.tokens.empty() || block.tokens.front().kind == TokenKind::Tape) {
        continue;
      }
      m_findings.setPlace(block.line, m_flow.fileName(0));
      m_findings.report(Severity::Warning, block.tokens.front().column,
                        DiagnosticCode::TextAfterProgramEnd, {});
      return;
    }
  }

  std::string_view m_text;
  const LoadOptions& m_options;
  Dialect m_dialect;
  const nc::GTable& m_g;
  Interpretation m_out;
  Findings m_findings;
  ProgramVariables m_variables;
  nc::CursorOptions m_cursorOptions;
  nc::Cursor m_flow;
  PathBuilder m_path;
  FactCounter m_facts;

  // Modal state of the control.
  double m_feedMmPerS = 0.0;
  FeedMode m_feedMode = FeedMode::PerMinute;
  double m_spindlePerMin = 0.0;
  double m_lengthFactor = 1.0;
  double m_feedFactor = 1.0;
  std::size_t m_planeFirstAxis = 0;
  Motion m_motion = Motion::None;
  Motion m_motionBeforeUnsupported = Motion::None;
  bool m_motionAssumed = false;  ///< G1 by default, not by a word
  bool m_motionNamed = false;
  bool m_relative = false;
  bool m_centreIsAbsolute = false;
  bool m_diameter = false;
  bool m_diameterIncrements = false;
  bool m_isLathe = false;  ///< ISO: turning cycles, U and W as increments
  bool m_moved = false;
  bool m_pathBegun = false;  ///< X, Y or Z has moved
  int m_workOffset = -1;
  double m_workOffsetNumber = 0.0;

  // Frames and poles, programmed coordinates.
  Frame m_baseFrame;  ///< G52 and G92; TRANS and ROT work on it
  /// Programmed coordinates from before a change of the frame, for increments.
  std::array<std::optional<double>, base::kAxisCount> m_incrementFrom;
  Vec3 m_setOffsetMm;
  Vec3 m_localOffsetMm;
  std::array<double, base::kRotaryAxisCount> m_rotaryOffset{};  ///< G92, degrees
  Vec3 m_poleMm;
  bool m_polar = false;  ///< G16
  double m_polarRadiusMm = 0.0;
  double m_polarDegrees = 0.0;
  double m_polarTurnDegrees = 0.0;  ///< of the present block, where it is an increment

  // A spline in progress.
  Spline m_spline;
  std::optional<Vec3> m_splineEnd;  ///< its last control point so far
  MoveWords m_splineDetails;
  int m_splineDegree = 3;
  double m_nurbsFirstWeight = 1.0;
  Vec3 m_lastTangent;  ///< P Q of the last G5

  // Reading.
  base::LineNumber m_line;
  bool m_ended = false;
  bool m_tailReported = false;
  Token m_feedToken;
  std::deque<Token> m_calculated;      ///< of the present block
  std::vector<Token> m_furtherTokens;  ///< U, V, W of the present block

  // Findings made once.
  bool m_feedMissingReported = false;
  bool m_directionReported = false;
  std::array<std::optional<double>, base::kAxisCount> m_rotaryFirst;
  std::array<bool, base::kAxisCount> m_rotaryReported{};
  std::string m_tipWord;  ///< what keeps X Y Z at the tip of the tool; empty: nothing
  bool m_tipReported = false;
};

}  // namespace

Interpretation interpret(std::string_view text, const LoadOptions& options,
                         std::string_view fileName) {
  RIVULET_ASSERT(options.chordToleranceMm > 0.0);
  nc::DialectGuess guess = detectDialect(text, fileName);
  if (options.dialect) {
    guess.dialect = *options.dialect;
    guess.evidence.clear();
  }
  return Interpreter(text, options, std::move(guess)).run();
}

}  // namespace rivulet::gcode
