// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/linuxcnc_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/text.h"
#include "job/native_reason.h"
#include "job/translation.h"
#include "nc/function_number.h"
#include "nc/nc_number.h"
#include "nc/syntax/language.h"
#include "nc/syntax/lexer.h"
#include "templates/linuxcnc_protocol.h"

namespace rivulet::job {

namespace {

using nc::Reference;
using nc::Token;
using nc::TokenKind;

/// M functions that mean the same on both.
constexpr std::array kSameM{0, 1, 3, 4, 5, 6, 7, 8, 9};
/// Dynamics of a SINUMERIK, which LinuxCNC takes from its configuration.
constexpr std::array<std::string_view, 3> kDynamics{"SOFT", "BRISK", "DRIVE"};
/// These say how fast the path is, or raise an alarm.
constexpr std::array<std::string_view, 6> kNotLeftOut{"OVR",    "OVRRAP", "OVRA",
                                                      "FGROUP", "FGREF",  "SETAL"};
/// LinuxCNC's user-defined M functions.
constexpr int kFirstUserM = 100;
constexpr int kLastUserM = 199;

template <class List, class Value>
bool isIn(const List& list, const Value& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

/// Of a number, also "-2" as a calculation. Nothing: it is more than that.
std::optional<double> constantOf(const nc::Expression& expression) {
  if (expression.op == nc::Op::Number) {
    return expression.number;
  }
  if (expression.op == nc::Op::Negate) {
    const std::optional<double> of = constantOf(expression.operands.front());
    return of ? std::optional(-*of) : std::nullopt;
  }
  return std::nullopt;
}

struct Number {
  double value = 0.0;
  Reference reference = Reference::Modal;
};
std::optional<Number> numberOf(const Token& token) {
  if (token.calculation == nullptr) {
    const bool isNumber = token.kind == TokenKind::Word || token.kind == TokenKind::NamedValue;
    return isNumber ? std::optional(Number{token.value, token.reference}) : std::nullopt;
  }
  const nc::Expression* const calculated = token.calculated();
  const auto value = calculated == nullptr ? std::nullopt : constantOf(*calculated);
  return value ? std::optional(Number{*value, (*token.calculation)->reference}) : std::nullopt;
}

/// Of "Z=MAXVAL($AA_IW[Z],5)": not below where the axis stands.
std::optional<double> leastOf(char letter, const Token& token) {
  const nc::Expression* const value = token.calculated();
  if (value == nullptr || value->op != nc::Op::MaxVal || value->operands.size() != 2) {
    return std::nullopt;
  }
  const nc::Expression& place = value->operands.front();
  const bool isPlace = place.op == nc::Op::System && place.name == "$AA_IW" &&
                       place.operands.size() == 1 &&
                       place.operands.front().name == std::string(1, letter);
  return isPlace ? constantOf(value->operands.back()) : std::nullopt;
}

/// "G505" is G58 of LinuxCNC.
std::optional<std::string> workOffset(int number) {
  constexpr int kFirst = 540;
  constexpr int kLast = 593;
  for (int key = kFirst; key <= kLast; ++key) {
    if (workOffsetOf(key) == fmt::format("G{}", number)) {
      return key % 10 == 0 ? fmt::format("G{}", key / 10)
                           : fmt::format("G{}.{}", key / 10, key % 10);
    }
  }
  return std::nullopt;
}

/// "$P_UIFR[1,X,TR]=5" is "G10 L2 P1 X5" of LinuxCNC, "$P_UIFR[1,Z,RT]=0" its "R0".
struct SetOffset {
  std::string number;
  std::string word;
};
std::optional<SetOffset> setOffsetOf(std::string_view text) {
  constexpr std::string_view kName = "$P_UIFR[";
  const std::size_t equals = text.find("]=");
  if (!text.starts_with(kName) || equals == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view index = text.substr(kName.size(), equals - kName.size());
  const std::size_t axis = index.find(',');
  const auto value = base::parseNumber(text.substr(equals + 2));
  if (axis == std::string_view::npos || axis + 5 != index.size() || !value) {
    return std::nullopt;
  }
  const bool isTurn = index.ends_with(",Z,RT") && *value == 0.0;
  if (!isTurn && !index.ends_with(",TR")) {
    return std::nullopt;
  }
  return SetOffset{std::string(index.substr(0, axis)),
                   (isTurn ? 'R' : index[axis + 1]) + nc::ncNumber(*value)};
}

}  // namespace

/// The words of a block, by what LinuxCNC needs to know of them.
struct LinuxCncText::Block {
  std::vector<std::string> words;
  std::vector<std::string> axes;
  std::string centre;  ///< I, J and K
  std::optional<int> motion;
  bool isDwell = false;
  bool hasSpeed = false;   ///< S, with G4 turns of the spindle
  bool isMachine = false;  ///< in machine coordinates
  bool centreIsAbsolute = false;
  bool centreIsIncrement = false;
  std::string side;              ///< G41 or G42
  std::optional<double> radius;  ///< of the compensation, mm; nothing: that of the tool
  std::optional<double> feed;    ///< F
  std::string offset;            ///< G10 L2 with its words
};

void LinuxCncText::loopCalled() {
  m_plane = 17;
  m_units = 21;
  m_distance = 90;
  m_feedMode = 94;
}

tl::expected<std::string, std::string> LinuxCncText::convert(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string missing = convertLine(text.substr(0, end), out);
    if (!missing.empty()) {
      return tl::unexpected(std::move(missing));
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

std::string LinuxCncText::convertLine(std::string_view line, std::string& out) {
  const nc::Words words = nc::readWords(line, nc::languageOf(nc::Dialect::Sinumerik), {});
  Block block;
  for (const Token& token : words.tokens) {
    if (!take(token, block)) {
      return std::string(base::trim(token.text));
    }
  }
  if (block.motion) {
    m_motion = *block.motion;
  }
  if (!block.side.empty()) {
    // G41.1 has a radius of its own.
    block.words.push_back(
        block.radius ? fmt::format("{}.1 D{}", block.side, nc::ncNumber(2.0 * *block.radius))
                     : block.side);
    m_compensates = true;
  }
  if (block.feed) {
    block.words.push_back((block.isDwell ? "P" : "F") + nc::ncNumber(*block.feed));
  }
  const bool moves = !block.axes.empty() || !block.centre.empty();
  if (!block.offset.empty()) {
    block.words.push_back(block.offset);
    if (moves || block.words.size() > 1) {
      return block.offset;
    }
  }
  if (block.isMachine && !moves) {
    return "SUPA";
  }
  if (block.isDwell && (moves || block.hasSpeed || !block.feed)) {
    return "G4";
  }
  if (moves && block.isMachine && !m_fixedPoint.empty()) {
    // By way of where the axes are.
    for (std::string& axis : block.axes) {
      const char letter = static_cast<char>(axis.front() - 'A' + 'a');
      axis = fmt::format("{}[#<_{}>]", axis.front(), letter);
    }
    block.words.push_back(m_fixedPoint);
    block.words.insert(block.words.end(), block.axes.begin(), block.axes.end());
  } else if (moves) {
    const bool isStraight = m_motion == 0 || m_motion == 1;
    if (m_motion < 0 || m_motion > 3 || (block.isMachine && !isStraight) ||
        (block.centreIsAbsolute && block.centreIsIncrement)) {
      return std::string(base::trim(line));
    }
    block.words.push_back(fmt::format("{}G{}", block.isMachine ? "G53 " : "", m_motion));
    block.words.insert(block.words.end(), block.axes.begin(), block.axes.end());
    if (!block.centre.empty()) {
      block.words.push_back(block.centre);
    }
  }
  if (block.words.empty()) {
    return {};
  }
  const auto add = [&out](std::string_view text) {
    out += out.empty() ? "" : "\n";
    out += text;
  };
  const bool switchesCentre = block.centreIsAbsolute;
  if (switchesCentre) {
    add("G90.1");
  }
  add(fmt::format("{}", fmt::join(block.words, " ")));
  if (switchesCentre) {
    add("G91.1");
  }
  return {};
}

bool LinuxCncText::take(const Token& token, Block& block) {
  switch (token.kind) {
    case TokenKind::Comment:
    case TokenKind::BlockSkip:
      return true;
    case TokenKind::Word:
    case TokenKind::Expression:
      return takeWord(token, block);
    case TokenKind::NamedValue:
    case TokenKind::Assignment:
      return takeValue(base::toUpper(nc::tokenName(token)), token, block);
    case TokenKind::Name:
    case TokenKind::Call:
      return takeName(base::toUpper(nc::tokenName(token)), block);
    default:
      return false;
  }
}

bool LinuxCncText::takeWord(const Token& token, Block& block) {
  const char letter = base::toUpper(token.address);
  if ((letter >= 'X' && letter <= 'Z') || (letter >= 'A' && letter <= 'C')) {
    return takeAxis(letter, token, block);
  }
  const std::optional<Number> number = numberOf(token);
  if (!number) {
    return false;
  }
  const double value = number->value;
  const bool isModal = number->reference == Reference::Modal;
  if (letter >= 'I' && letter <= 'K') {
    (number->reference == Reference::Absolute ? block.centreIsAbsolute : block.centreIsIncrement) =
        true;
    block.centre +=
        fmt::format("{}{}{}", block.centre.empty() ? "" : " ", letter, nc::ncNumber(value));
    return number->reference <= Reference::Incremental;
  }
  if (!isModal) {
    return false;
  }
  const std::optional<int> function = nc::functionNumber(value);
  switch (letter) {
    case 'N':
      return true;
    case 'G':
      return takeG(value, block);
    case 'M':
      return function && takeM(*function, block);
    case 'F':
      block.feed = value;
      return true;
    case 'S':
      block.words.push_back("S" + nc::ncNumber(value));
      block.hasSpeed = true;
      return true;
    case 'T':
      block.words.push_back(fmt::format("T{}", function.value_or(0)));
      return function && *function >= 0;
    case 'D':  // of the tool in the spindle, which has one length here
      block.words.emplace_back(value == 0.0 ? "G49" : "G43");
      return value == 0.0 || value == 1.0;
    default:
      return false;
  }
}

bool LinuxCncText::takeAxis(char letter, const Token& token, Block& block) const {
  const auto constant = numberOf(token);
  if (!constant) {
    const std::optional<double> least = leastOf(letter, token);
    if (least) {  // the greater of both
      block.axes.push_back(fmt::format("{0}[[#<_{1}>+{2}+ABS[#<_{1}>-[{2}]]]/2]", letter,
                                       static_cast<char>(letter - 'A' + 'a'),
                                       nc::ncNumber(*least)));
    }
    return least.has_value();
  }
  const Number number = *constant;
  const std::string value = nc::ncNumber(number.value);
  switch (number.reference) {
    case Reference::Modal:
      block.axes.push_back(letter + value);
      return true;
    case Reference::Absolute:
      block.axes.push_back(letter + value);
      return m_distance == 90;
    case Reference::Incremental: {
      // From where LinuxCNC has the axis, in the coordinates of the program.
      const std::string sum = number.value < 0.0 ? value : "+" + value;
      block.axes.push_back(
          fmt::format("{}[#<_{}>{}]", letter, static_cast<char>(letter - 'A' + 'a'), sum));
      return m_distance == 90;
    }
    default:
      return false;
  }
}

/// A G function of a group of which one is always in force.
void LinuxCncText::setModal(int& inForce, int g, Block& block) {
  if (inForce != g) {
    inForce = g;
    block.words.push_back(fmt::format("G{}", g));
  }
}

bool LinuxCncText::takeG(double number, Block& block) {
  const std::optional<int> g = nc::functionNumber(number);
  if (!g) {
    return false;
  }
  if (const auto offset = workOffset(*g)) {
    block.words.push_back(*offset);
    return true;
  }
  switch (*g) {
    case 0:
    case 1:
    case 2:
    case 3:
      block.motion = *g;
      return true;
    case 4:
      block.isDwell = true;
      block.words.emplace_back("G4");
      return true;
    case 17:
    case 18:
    case 19:
      setModal(m_plane, *g, block);
      return true;
    case 90:
    case 91:
      setModal(m_distance, *g, block);
      return true;
    case 94:
    case 95:
      setModal(m_feedMode, *g, block);
      return true;
    case 700:
      setModal(m_units, 20, block);
      return true;
    case 710:
      setModal(m_units, 21, block);
      return true;
    case 40:
      if (m_compensates) {
        block.words.emplace_back("G40");
        m_compensates = false;
      }
      return true;
    case 41:
    case 42:  // where the tool goes at the beginning differs between makes
      block.side = fmt::format("G{}", *g);
      return m_source == nc::Dialect::LinuxCnc;
    case 53:
    case 153:
      block.isMachine = true;
      return true;
    case 60:
      block.words.emplace_back("G61");
      return true;
    case 601:  // when a block of G60 has ended
    case 602:
    case 603:
      return true;
    case 64:
    case 641:
    case 642:
    case 643:
    case 644:
    case 645:
      block.words.push_back(
          fmt::format("G64 P{} Q0", templates::LinuxCncProtocol::kPathToleranceMm));
      return true;
    default:
      return false;
  }
}

bool LinuxCncText::takeM(int number, Block& block) const {
  const bool isUsers = m_source != nc::Dialect::Sinumerik && number >= kFirstUserM &&
                       number <= kLastUserM;  // said by the user for this machine
  if (number == 2 || number == 30) {
    block.words.emplace_back("M2");
    return true;
  }
  block.words.push_back(fmt::format("M{}", number));
  return isIn(kSameM, number) || isUsers;
}

bool LinuxCncText::takeValue(std::string_view name, const Token& token, Block& block) {
  const std::optional<Number> number = numberOf(token);
  const std::string text = base::toUpper(token.text);
  if (const auto set = setOffsetOf(text)) {
    const std::string begin = "G10 L2 P" + set->number;
    block.offset += (block.offset.empty() ? begin : "") + " " + set->word;
    return block.offset.starts_with(begin + " ");
  }
  if (name == "OFFN" && !number) {  // "OFFN=3-$P_TOOLR": the radius is 3
    constexpr std::string_view kBegin = "OFFN=";
    constexpr std::string_view kEnd = "-$P_TOOLR";
    if (!text.starts_with(kBegin) || !text.ends_with(kEnd)) {
      return false;
    }
    block.radius = base::parseNumber(
        std::string_view(text).substr(kBegin.size(), text.size() - kBegin.size() - kEnd.size()));
    return block.radius.has_value();
  }
  if (name == "TOFFL") {  // D1 without its length
    const bool isNone = number && number->value == 0.0;
    if (!isNone) {
      block.words.emplace_back("G49");
    }
    return isNone || text == "TOFFL=-$P_TOOLL[1]";
  }
  if (!number || number->reference != Reference::Modal) {
    return false;
  }
  if (name == "CR") {
    block.centre += "R" + nc::ncNumber(number->value);
    return true;
  }
  if (name == "TURN") {
    block.centre += fmt::format(" P{}", std::lround(number->value) + 1);
    return number->value >= 0.0;
  }
  if (name == "SPOS") {
    block.words.push_back("M19 R" + nc::ncNumber(number->value));
    return true;
  }
  return (name == "OVR" && number->value == 100.0) || (name == "OFFN" && number->value == 0.0);
}

bool LinuxCncText::takeName(std::string_view name, Block& block) {
  if (name == "SUPA") {
    block.isMachine = true;
    return true;
  }
  const std::optional<NativeReason> reason = reasonOfName(name);
  const bool concernsNothing = reason == NativeReason::Mode || reason == NativeReason::Message;
  return name == "DIAMOF" || isIn(kDynamics, name) || (concernsNothing && !isIn(kNotLeftOut, name));
}

}  // namespace rivulet::job
