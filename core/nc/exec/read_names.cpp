// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Words that are names: SOFT, CR=12, CYCLE83(...).

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "nc/exec/block_reader.h"

namespace rivulet::nc {

namespace {

void setState(NameEffect effect, std::string_view name, double value, ModalState& state) {
  if (effect == NameEffect::Dynamics) {
    state.dynamics = name == "SOFT" ? Dynamics::Soft : Dynamics::Brisk;
  } else if (effect == NameEffect::Rounding) {
    state.roundingMm = std::max(0.0, value);
  } else if (effect == NameEffect::Diameter) {
    state.diameter = name != "DIAMOF";
    state.diameterIncrements = name == "DIAMON";
  } else if (effect == NameEffect::Transformation) {
    state.tipWord = name == "TRAORI" ? "TRAORI" : "";
  } else if (name == "KONT" || name == "NORM") {
    state.goesAroundStart = name == "KONT";
  }
}

}  // namespace

void BlockReader::readName(const Token& token, BlockWords& words) {
  const std::string name = base::toUpper(tokenName(token));
  if (token.kind == TokenKind::NamedValue && m_variables.find(name) != nullptr) {
    assign(token, words);
    return;
  }
  const NameEffect effect = nameEffect(m_language.dialect, name);
  switch (effect) {
    case NameEffect::Dynamics:
    case NameEffect::Rounding:
    case NameEffect::Diameter:
    case NameEffect::Transformation:
    case NameEffect::None:
      setState(effect, name, token.value, m_state);
      m_to.faults.ignore(token, name);
      break;
    case NameEffect::Query:
      forgetArguments(token);
      m_to.faults.ignore(token, name);
      break;
    case NameEffect::End:
      words.rareWords().returns = true;
      break;
    case NameEffect::BlockFeed:
    case NameEffect::Override:
    case NameEffect::OtherOverride:
    case NameEffect::SpeedLimit:
      if (token.kind != TokenKind::NamedValue) {
        m_to.faults.error(token, FaultCode::UnknownWord);
      } else {
        readFeedName(effect, token, name, words);
      }
      break;
    case NameEffect::FeedGroup:
      readFeedGroup(token, name);
      break;
    case NameEffect::Mode:
    case NameEffect::Feed:
      m_to.faults.error(token, FaultCode::UnsupportedGCode, name);
      break;
    case NameEffect::TakesBlock:
      m_to.faults.error(token, FaultCode::UnsupportedGCode, name);
      words.taken = true;
      m_to.words.forget(std::nullopt);
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
    case NameEffect::OtherCurve:
      m_to.faults.error(token, FaultCode::UnsupportedGCode, name);
      beginForeignMotion(words);
      break;
    case NameEffect::MachineMove:
      words.machineToken = &token;
      break;
    case NameEffect::Address:
    case NameEffect::MachineAxis:
      readNamedAddress(token, name, words);
      break;
    case NameEffect::Unknown:
      readUnknownName(token, words);
      break;
  }
}

void BlockReader::readNamedAddress(const Token& token, const std::string& name, BlockWords& words) {
  if (token.kind != TokenKind::NamedValue) {
    m_to.faults.error(token, FaultCode::UnknownWord);
  } else {
    setNamed(name, token, words);
  }
}

void BlockReader::setNamed(const std::string& name, const Token& token, BlockWords& words) {
  if (name == "CR") {
    setRadius(token, words);
    return;
  }
  words.rareWords().named[name] = {token.value, token.reference};
  if (nameEffect(m_language.dialect, name) == NameEffect::MachineAxis) {
    words.rare->machineAxis = &token;
  }
  noteColumn(token, words);
}

/// Where F counts an axis beside X, Y and Z, or leaves one of them out, it is no feed along their
/// path. FGROUP() brings back the group of the machine.
void BlockReader::readFeedGroup(const Token& token, const std::string& name) {
  const std::string text = base::toUpper(token.text);
  const bool isOfPath = std::all_of(
      text.begin() + static_cast<std::ptrdiff_t>(name.size()), text.end(), [](char letter) {
        return std::string_view("XYZ,() \t").find(letter) != std::string_view::npos;
      });
  const auto axes = static_cast<std::size_t>(
      std::count_if(base::kAxisNames.begin(), base::kAxisNames.end(),
                    [&](char axis) { return text.find(axis, name.size()) != std::string::npos; }));
  if (isOfPath && (axes == 0 || axes == base::kAxisCount)) {
    m_to.faults.ignore(token, name);
  } else {
    m_to.faults.error(token, FaultCode::UnsupportedGCode, name);
  }
}

/// Names that change the feed, with a value.
void BlockReader::readFeedName(NameEffect effect, const Token& token, const std::string& name,
                               BlockWords& words) {
  constexpr double kPercent = 100.0;
  constexpr double kPercentMax = 200.0;
  if (!(token.value >= 0.0)) {
    m_to.faults.error(token, FaultCode::ValueOutOfRange);
  } else if (effect == NameEffect::BlockFeed) {
    words.rareWords().blockFeed = &token;
  } else if (effect == NameEffect::SpeedLimit) {
    words.rareWords().speedMax = &token;
    m_to.faults.ignore(token, name);
  } else if (effect == NameEffect::Override && token.value > 0.0 && token.value <= kPercentMax) {
    m_state.feedOverride = token.value / kPercent;
  } else if (effect == NameEffect::Override) {
    m_to.faults.error(token, FaultCode::ValueOutOfRange);
  } else if (token.value != kPercent) {
    m_to.faults.error(token, FaultCode::UnsupportedGCode, name);
  } else {
    m_to.faults.ignore(token, name);
  }
}

/// On a SINUMERIK a name alone, or with arguments, calls a subprogram.
void BlockReader::readUnknownName(const Token& token, BlockWords& words) {
  if (!m_language.namesAreCalls || token.kind == TokenKind::NamedValue) {
    m_to.faults.error(token, token.kind == TokenKind::Name ? FaultCode::UnknownWord
                                                           : FaultCode::UnsupportedExpression);
    return;
  }
  words.rareWords().call = token;
}

/// What a call has written to its variables only the control knows.
void BlockReader::forgetArguments(const Token& token) {
  std::string_view rest = token.text.substr(std::min(token.text.find('('), token.text.size()));
  while (!rest.empty()) {
    rest.remove_prefix(1);
    const std::size_t end = std::min(rest.find_first_of(",)"), rest.size());
    Expression variable;
    variable.op = Op::Variable;
    variable.name = base::toUpper(base::trim(rest.substr(0, end)));
    if (m_variables.find(variable.name) != nullptr) {
      (void)m_variables.assign(variable, std::nan(""));
    }
    rest.remove_prefix(end);
  }
}

void BlockReader::readCycle(const Token& token, const std::string& name, BlockWords& words) {
  words.taken = true;
  const std::size_t open = token.text.find('(');
  const std::string_view arguments =
      open == std::string_view::npos ? "" : token.text.substr(open + 1);
  m_to.words.forget(std::nullopt);
  const bool swivels = name == "CYCLE800";
  if (swivels && base::trim(arguments) == ")") {
    m_to.faults.ignore(token, name);  // swivels back to the frame of the machine
    return;
  }
  m_to.faults.error(token, swivels ? FaultCode::UnsupportedGCode : FaultCode::CycleNotRun, name);
  m_to.words.otherMotion();
}

}  // namespace rivulet::nc
