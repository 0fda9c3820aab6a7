// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/exec/block_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "nc/function_number.h"
#include "nc/unknown.h"

namespace rivulet::nc {

namespace {

/// Index in `AxisValues`; from kProgrammedAxisCount on: no axis.
std::size_t axisOf(char address) {
  if (address >= 'X') {
    return static_cast<std::size_t>(address - 'X');
  }
  if (address >= 'U') {
    return static_cast<std::size_t>(address - 'U') + kFirstFurther;
  }
  return address <= 'C' ? static_cast<std::size_t>(address - 'A') + kFirstRotary
                        : kProgrammedAxisCount;
}

/// #1 to #26 of G65 by letter; 0: none.
int argumentOf(char letter) {
  static constexpr std::array<int, 26> kNumbers{1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                                0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  return kNumbers[static_cast<std::size_t>(letter - 'A')];
}

}  // namespace

BlockReader::BlockReader(const Language& language, bool runsCannedCycles, ModalState& state,
                         Variables& variables, Sinks to)
    : m_language(language),
      m_runsCannedCycles(runsCannedCycles),
      m_g(gTable(language.dialect)),
      m_state(state),
      m_variables(variables),
      m_to(to) {
}

void BlockReader::read(const Token& token, BlockWords& words) {
  if (token.calculation != nullptr && !m_language.hasCalculations) {
    m_to.faults.error(token, FaultCode::UnknownWord, std::string(token.text));
    return;
  }
  switch (token.kind) {
    case TokenKind::Word:
      if (isVariable(token)) {
        assign(token, words);
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
      readText(token, words);
      break;
    case TokenKind::IndexedWord:
      readIndexed(token, words);
      break;
    case TokenKind::Expression:
      if (isVariable(token)) {
        assign(token, words);
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
      m_to.faults.ignore(token, "/");
      break;
    case TokenKind::Label:
    case TokenKind::Tape:
    case TokenKind::Comment:
      break;
    default:
      readUnreadable(token);
      break;
  }
}

void BlockReader::readUnreadable(const Token& token) {
  if (token.kind == TokenKind::NumberMissing) {
    m_to.faults.error(token, FaultCode::NumberMissing, std::string(tokenName(token)));
  } else if (token.kind == TokenKind::NumberMalformed) {
    const bool hasBlank = token.text.find_first_of(" \t\v\f") != std::string_view::npos;
    m_to.faults.error(token, hasBlank && !m_language.ignoresBlanksInNumbers
                                 ? FaultCode::BlankInNumber
                                 : FaultCode::NumberMalformed);
  } else if (token.kind == TokenKind::CommentNotClosed) {
    m_to.faults.error(token, FaultCode::CommentNotClosed, {});
  } else if (token.kind == TokenKind::CommentNested) {
    // What the control takes for words; a lone bracket moves nothing.
    const std::string_view behind = token.text.substr(token.text.find(')'));
    const bool hasWords = behind.find_first_not_of(" \t)") != std::string_view::npos;
    m_to.faults.report(hasWords ? Severity::Error : Severity::Warning, token.column,
                       FaultCode::CommentNested, std::string(token.text));
  } else if (std::string code = base::invisibleCharacter(token.text); !code.empty()) {
    m_to.faults.error(token, FaultCode::InvisibleCharacter, std::move(code));
  } else if (static_cast<unsigned char>(token.text.front()) < 0x20) {
    // Left over from a transfer: no control reads it as a word.
    m_to.faults.report(Severity::Warning, token.column, FaultCode::UnexpectedCharacter,
                       "\\x" + fmt::format("{:02x}", token.text.front()));
  } else {
    m_to.faults.error(token, FaultCode::UnexpectedCharacter);
  }
}

// --- calculations -------------------------------------------------------------------------------

/// I=5 is not a centre if the program has defined a variable I.
bool BlockReader::isVariable(const Token& token) const {
  return m_language.lettersMayBeVariables && token.text.size() > 2 &&
         (token.text[1] == '=' || token.text[1] == ' ') &&
         m_variables.find(std::string_view(&token.address, 1)) != nullptr;
}

void BlockReader::assign(const Token& token, BlockWords& words) {
  if (m_language.assignsBehindBlock && token.calculated() != nullptr) {
    assignLater(token);
    return;
  }
  const Expected<void> done = token.calculation == nullptr ? m_variables.assign(assignmentOf(token))
                              : *token.calculation         ? m_variables.assign(**token.calculation)
                                                           : fail(token.calculation->error());
  if (!done) {
    m_to.faults.fault(token.column, done.error());
    words.ends = words.ends || done.error().code == FaultCode::AlarmRaised;
  }
}

/// All words of the block, and its other assignments, read what was there before it.
void BlockReader::assignLater(const Token& token) {
  Pending pending{token, (*token.calculation)->target, kUnknown};
  for (Expression& index : pending.target.operands) {
    const Expected<double> number = m_variables.number(index);
    if (!number) {
      m_to.faults.fault(token.column, number.error());
      return;
    }
    index = Expression::constant(*number);
  }
  Expected<Value> value = evaluate(*token.calculated(), m_variables, m_variables.semantics());
  if (value) {
    pending.value = *std::move(value);
  } else {
    m_to.faults.fault(token.column, value.error());
  }
  m_pending.push_back(std::move(pending));
}

void BlockReader::assignPending() {
  for (Pending& each : m_pending) {
    if (const Expected<void> done = m_variables.assign(each.target, std::move(each.value)); !done) {
      m_to.faults.fault(each.token.column, done.error());
    }
  }
  m_pending.clear();
}

/// H12 with T2 in the spindle is no fault, but rarely meant.
void BlockReader::compareLength() {
  ToolWords& tool = m_tool;
  if (tool.changes) {
    tool.inSpindle = tool.next;
  }
  if (tool.takesLength && tool.length && *tool.length != 0.0 &&
      tool.inSpindle.value_or(*tool.length) != *tool.length) {
    m_to.faults.report(Severity::Warning, tool.lengthColumn, FaultCode::OtherToolLength,
                       fmt::format("H{}", *tool.length));
  }
  tool.isNamed = tool.changes = tool.takesLength = false;
  tool.length.reset();
}

/// X#24 and X-#24 of a variable without a value: the control leaves the address out.
bool BlockReader::isVacant(const Expression& value) const {
  if (!m_variables.semantics().knowsVacant) {
    return false;
  }
  if (value.op == Op::Negate) {
    return isVacant(value.operands.front());
  }
  const Expected<Value> read =
      value.op == Op::Hash ? evaluate(value, m_variables, m_variables.semantics()) : Value(0.0);
  return read && std::holds_alternative<Vacant>(*read);
}

std::optional<double> BlockReader::numberOf(const Token& token) {
  const Expression* const value = token.calculated();
  const Expected<double> number = value != nullptr     ? m_variables.number(*value)
                                  : *token.calculation ? fail(FaultCode::ListMalformed)
                                                       : fail(token.calculation->error());
  if (!number) {
    m_to.faults.fault(token.column, number.error());
  }
  return number ? std::optional(*number) : std::nullopt;
}

void BlockReader::readCalculated(const Token& token, BlockWords& words) {
  if (token.calculated() != nullptr && isVacant(*token.calculated())) {
    return;
  }
  const std::optional<double> result = numberOf(token);
  if (!result && axisOf(token.address) >= kProgrammedAxisCount) {
    return;
  }
  Token computed = token;
  computed.kind = TokenKind::Word;
  computed.hasPoint = true;
  computed.reference = *token.calculation ? (*token.calculation)->reference : Reference::Modal;
  // The block still moves; where to is not known.
  computed.value = result.value_or(std::nan(""));
  m_calculated.push_back(computed);
  readWord(m_calculated.back(), words);
}

/// AX[variable]=..., where the variable of type AXIS holds the name of the axis.
void BlockReader::readIndexedAxis(const Token& token, BlockWords& words) {
  const bool hasIndex =
      token.calculated() != nullptr && (*token.calculation)->target.operands.size() == 1;
  const std::string index = hasIndex ? (*token.calculation)->target.operands.front().name : "";
  const Variable* const variable = m_variables.find(index);
  const std::string axis = variable == nullptr ? index : textOf(variable->values.front());
  if (axis.size() != 1 || axisOf(axis[0]) >= kProgrammedAxisCount) {
    m_to.faults.error(token, FaultCode::UnsupportedExpression);
    return;
  }
  Token named = token;
  named.address = axis[0];
  readCalculated(named, words);
}

void BlockReader::readAssignment(const Token& token, BlockWords& words) {
  const std::string name = base::toUpper(tokenName(token));
  if (name == "AX" && m_language.hasIndexedWords) {
    readIndexedAxis(token, words);
    return;
  }
  if (token.address == 'T') {
    // T="MILL_"<<R1: which tool it is does not touch the path.
    m_to.faults.ignore(token, "T");
    return;
  }
  if (!name.empty() && m_variables.find(name) == nullptr) {
    switch (nameEffect(m_language.dialect, name)) {
      case NameEffect::Address:
      case NameEffect::MachineAxis: {
        if (const std::optional<double> value = numberOf(token)) {
          Token computed = token;
          computed.value = *value;
          computed.reference = (*token.calculation)->reference;
          m_calculated.push_back(computed);
          setNamed(name, m_calculated.back(), words);
        }
        return;
      }
      case NameEffect::BlockFeed:
      case NameEffect::Override:
      case NameEffect::OtherOverride:
      case NameEffect::SpeedLimit: {
        if (const std::optional<double> value = numberOf(token)) {
          Token computed = token;
          computed.value = *value;
          m_calculated.push_back(computed);
          readFeedName(nameEffect(m_language.dialect, name), m_calculated.back(), name, words);
        }
        return;
      }
      case NameEffect::None:
      case NameEffect::Dynamics:
      case NameEffect::Rounding:
        m_to.faults.ignore(token, name);
        return;
      case NameEffect::Mode:
      case NameEffect::Feed:
      case NameEffect::TakesBlock:
        m_to.faults.error(token, FaultCode::UnsupportedGCode, name);
        return;
      default:
        break;
    }
  }
  if (name.empty() && !token.text.empty() && token.text.front() == '$') {
    // Commands of a sender, and variables of the control.
    m_to.faults.error(token, FaultCode::UnknownWord);
    return;
  }
  assign(token, words);
}

/// M1=3, M[R1]=3 and S2=500 are the spindles'; G[6]=2 is a G function by group and number.
void BlockReader::readIndexed(const Token& token, BlockWords& words) {
  if (token.address != 'G') {
    if (token.text.size() > 1 && token.text[1] == '1' && token.calculation == nullptr) {
      if (token.address == 'M' && !functionNumber(token.value)) {
        m_to.faults.error(token, FaultCode::ValueOutOfRange);
        return;
      }
      m_to.path.firstSpindle(token.address, token.value);
    }
    m_to.faults.ignore(token, std::string(token.text));
    return;
  }
  if (token.calculated() == nullptr || (*token.calculation)->target.operands.size() != 1) {
    m_to.faults.error(token, FaultCode::UnknownWord);
    return;
  }
  const Expected<double> index = m_variables.number((*token.calculation)->target.operands.front());
  const Expected<double> number = index ? m_variables.number(*token.calculated()) : index;
  if (!number) {
    m_to.faults.fault(token.column, number.error());
    return;
  }
  const std::optional<int> key = gOfGroup(static_cast<int>(std::clamp(*index, 0.0, 1000.0)),
                                          static_cast<int>(std::clamp(*number, 0.0, 1000.0)));
  if (!key) {
    m_to.faults.error(token, FaultCode::UnsupportedGCode);
    return;
  }
  Token named = token;
  named.kind = TokenKind::Word;
  named.value = static_cast<double>(*key) / 10.0;
  m_calculated.push_back(named);
  readG(m_calculated.back(), words);
}

void BlockReader::readText(const Token& token, BlockWords& words) {
  if (token.address == 'T') {
    const std::size_t open = token.text.find('"');
    m_to.path.toolName(token.text.substr(open + 1, token.text.size() - open - 2), words.line);
    m_to.faults.ignore(token, "T");
    return;
  }
  const std::string name = base::toUpper(tokenName(token));
  if (token.address == 0 && m_variables.find(name) != nullptr) {
    assign(token, words);
  } else if (nameEffect(m_language.dialect, name) == NameEffect::None) {
    m_to.faults.ignore(token, name);
  } else {
    m_to.faults.error(token, FaultCode::UnknownWord);
  }
}

// --- letters ------------------------------------------------------------------------------------

void BlockReader::readWord(const Token& token, BlockWords& words) {
  using Read = void (BlockReader::*)(const Token&, BlockWords&);
  constexpr Read kFurther = &BlockReader::readFurtherAxis;
  constexpr Read kMachine = &BlockReader::readMachineWord;
  static constexpr std::array<Read, 26> kLetters{
      kFurther,                  // A
      kFurther,                  // B
      kFurther,                  // C
      kMachine,                  // D
      &BlockReader::readE,       // E
      &BlockReader::readFeed,    // F
      &BlockReader::readG,       // G
      kMachine,                  // H
      &BlockReader::readCentre,  // I
      &BlockReader::readCentre,  // J
      &BlockReader::readCentre,  // K
      &BlockReader::readL,       // L
      &BlockReader::readM,       // M
      &BlockReader::readNumber,  // N
      &BlockReader::readNumber,  // O
      &BlockReader::readP,       // P
      &BlockReader::readQ,       // Q
      &BlockReader::readRadius,  // R
      kMachine,                  // S
      kMachine,                  // T
      kFurther,                  // U
      kFurther,                  // V
      kFurther,                  // W
      &BlockReader::readAxis,    // X
      &BlockReader::readAxis,    // Y
      &BlockReader::readAxis,    // Z
  };
  const char address = token.address;
  const auto letter = static_cast<std::size_t>(address - 'A');
  if (letter >= kLetters.size()) {
    readPolarSign(token, words);
    return;
  }
  if (words.rare && words.rare->isMacro() &&
      std::string_view("GNOPL").find(address) == std::string_view::npos) {
    readArgument(token, *words.rare);
    return;
  }
  const bool isFunction = address == 'G' || address == 'M';
  const unsigned bit = isFunction ? 0U : 1U << letter;
  if ((words.repeated & bit) != 0) {
    reportRepetition(token);
  }
  words.repeated |= bit;
  (this->*kLetters[letter])(token, words);
}

/// FANUC Series 30i Operator's Manual B-63944EN, "Simple call (G65)", argument specification I and
/// II: I, J and K again begin the next three variables, and what is written last holds.
void BlockReader::readArgument(const Token& token, RareWords& call) const {
  constexpr int kPerSet = 3;
  constexpr int kLast = 33;
  int number = argumentOf(token.address);
  if (token.address >= 'I' && token.address <= 'K') {
    const bool isNext = m_language.hasArgumentSets && call.argumentLetter >= token.address;
    call.argumentSet += isNext ? 1 : 0;
    call.argumentLetter = token.address;
    number += kPerSet * call.argumentSet;
  }
  if (number <= 0 || number > kLast) {
    m_to.faults.error(token, FaultCode::UnknownWord);
    return;
  }
  call.arguments[number] = token.value;
}

void BlockReader::reportRepetition(const Token& token) {
  const bool path = std::string_view("XYZIJKRFABC").find(token.address) != std::string_view::npos;
  m_to.faults.report(path ? Severity::Error : Severity::Warning, token.column,
                     FaultCode::RepeatedWord, std::string(1, token.address));
}

void BlockReader::noteColumn(const Token& token, BlockWords& words) {
  if (words.motionColumn == 0) {
    words.motionColumn = token.column;
  }
}

void BlockReader::readAxis(const Token& token, BlockWords& words) {
  const std::size_t axis = axisOf(token.address);
  words.axes.set(axis, token.value, token.reference);
  words.axes.relative = m_state.relative;
  words.axes.token[axis] = &token;
  noteColumn(token, words);
}

void BlockReader::readFurtherAxis(const Token& token, BlockWords& words) {
  if (m_state.isLathe && (token.address == 'U' || token.address == 'W')) {
    // Increments of X and Z, whatever else holds.
    Token increment = token;
    increment.address = token.address == 'U' ? 'X' : 'Z';
    increment.reference = Reference::Incremental;
    m_calculated.push_back(increment);
    readAxis(m_calculated.back(), words);
    return;
  }
  readAxis(token, words);
  words.hasRotary = true;
  if (token.address == 'U') {
    words.parameter = &token;
  }
}

void BlockReader::readCentre(const Token& token, BlockWords& words) {
  const auto axis = static_cast<std::size_t>(token.address - 'I');
  words.centre.set(axis, token.value, token.reference);
  words.centre.token[axis] = &token;
  noteColumn(token, words);
}

void BlockReader::readRadius(const Token& token, BlockWords& words) {
  if (m_language.notation.hasNames) {
    m_to.faults.error(token, FaultCode::UnknownWord, std::string(token.text));  // a parameter
    return;
  }
  setRadius(token, words);
  words.radiusIsWord = true;
}

void BlockReader::setRadius(const Token& token, BlockWords& words) {
  if (words.hasRadius) {
    m_to.faults.error(token, FaultCode::RepeatedWord, "CR=");
  }
  words.radius = token.value;
  words.hasRadius = true;
  words.radiusToken = &token;
  noteColumn(token, words);
}

void BlockReader::readFeed(const Token& token, BlockWords& words) {
  words.feed = &token;
}

void BlockReader::readMachineWord(const Token& token, BlockWords& words) {
  m_to.faults.ignoreLetter(token);
  if (token.address == 'S') {
    words.spindle = &token;
    m_to.path.machineWord(MachineWord::Spindle, token.value, words.line);
  } else if (token.address == 'T') {
    m_to.path.machineWord(MachineWord::Tool, token.value, words.line);
    m_tool.next = token.value;
    if (m_language.toolChangesZ) {
      m_to.words.forget(2);
    }
  } else if (token.address == 'H') {
    m_tool.length = token.value;
    m_tool.lengthColumn = token.column;
    m_tool.isNamed = true;
  } else if (token.address == 'D') {
    words.edge = &token;
    m_to.path.machineWord(MachineWord::Edge, token.value, words.line);
  }
}

void BlockReader::readP(const Token& token, BlockWords& words) {
  if (words.rare) {
    words.rare->hasVariableP = token.calculation != nullptr;
  }
  words.p = token.value;
  words.parameter = &token;
}

void BlockReader::readQ(const Token& token, BlockWords& words) {
  words.q = token.value;
  words.parameter = &token;
}

void BlockReader::readL(const Token& token, BlockWords& words) {
  if (m_language.namesAreCalls) {
    words.rareWords().call = token;
    return;
  }
  words.l = token.value;
  words.parameter = &token;
}

/// @ and ^ of RS-274.
void BlockReader::readPolarSign(const Token& token, BlockWords& words) {
  if (token.address != '@' && token.address != '^') {
    refuseWord(token, words);
    return;
  }
  words.rareWords().named[token.address == '@' ? "RP" : "AP"] = {token.value, token.reference};
  noteColumn(token, words);
}

/// A parameter of M functions.
void BlockReader::readE(const Token& token, BlockWords& words) {
  if (m_language.hasParameterE) {
    words.parameter = &token;
  } else {
    refuseWord(token, words);
  }
}

void BlockReader::refuseWord(const Token& token, BlockWords& words) {
  if (token.address == 'E' && words.tolerance) {
    return;  // G187 P1 E0.05 of Haas
  }
  m_to.faults.error(token, FaultCode::UnknownWord);
}

}  // namespace rivulet::nc
