// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/translation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "nc/fault.h"
#include "nc/nc_number.h"

namespace rivulet::job {

namespace {

void addWord(std::string& line, const std::string& word) {
  line += line.empty() ? "" : " ";
  line += word;
}

}  // namespace

std::optional<std::string> workOffsetOf(int key) {
  struct Row {
    int key;
    const char* word;
  };
  static constexpr std::array kOffsets{Row{540, "G54"},  Row{550, "G55"},  Row{560, "G56"},
                                       Row{570, "G57"},  Row{580, "G505"}, Row{590, "G506"},
                                       Row{591, "G507"}, Row{592, "G508"}, Row{593, "G509"}};
  const auto* const found = std::find_if(kOffsets.begin(), kOffsets.end(),
                                         [key](const Row& row) { return row.key == key; });
  return found == kOffsets.end() ? std::nullopt : std::optional<std::string>(found->word);
}

std::string Translator::toolChange() const {
  return m_tool ? nc::filled(m_profile.toolChange, *m_tool) : "M6";
}

namespace {
constexpr std::array kBefore{3, 4, 7, 8};
constexpr std::array kAfter{0, 1, 5, 9, 19, 30};
/// Rigid tapping comes next: CYCLE84 is rigid.
constexpr int kRigid = 29;
}  // namespace

bool Translator::knowsM(nc::Dialect dialect, int number) {
  static constexpr std::array kOthers{2, 6, 13, 14};
  const bool isRigid =
      number == kRigid && (dialect == nc::Dialect::Fanuc || dialect == nc::Dialect::Haas);
  const auto has = [number](const auto& numbers) {
    return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
  };
  return has(kBefore) || has(kAfter) || has(kOthers) || isRigid;
}

bool Translator::isOfLanguage(nc::Dialect dialect, int number) {
  switch (dialect) {
    case nc::Dialect::LinuxCnc:  // tool number, input, saved state: M codes of LinuxCNC
      return number == 61 || number == 66 || (number >= 70 && number <= 73);
    case nc::Dialect::Heidenhain:  // miscellaneous functions for path behaviour and rotary axes
      return number >= 89 && number <= 199;
    case nc::Dialect::Fanuc:
    case nc::Dialect::Haas:  // a program from another device
      return number == 198;
    default:
      return false;
  }
}

NativeReason Translator::reasonOfM(int number) {
  const NativeReason reason = job::reasonOfM(number);
  return reason == NativeReason::Other ? NativeReason::Spindle : reason;  // M13, M14, M29
}

void Translator::translateM(int number, const ForeignWord& word, std::string& before,
                            Translation& out) {
  if (number == kRigid) {
    return;
  }
  if (number == 6) {
    addWord(before, toolChange());
  } else if (number == 13 || number == 14) {  // of plain text
    addWord(before, number == 13 ? "M3 M8" : "M4 M8");
  } else if (number == 2) {
    out.after.emplace_back("M30");
  } else if (std::find(kBefore.begin(), kBefore.end(), number) != kBefore.end()) {
    addWord(before, fmt::format("M{}", number));
  } else if (std::find(kAfter.begin(), kAfter.end(), number) != kAfter.end()) {
    out.after.push_back(fmt::format("M{}", number));
  } else {
    out.missing.push_back(word.text);
  }
}

std::vector<std::string> Translator::wayUp(const HomeMove& home) const {
  constexpr std::size_t kZ = 2;
  std::vector<std::string> lines = offsetLines();
  const bool isTop = home.toFixedPoint || *home.targetMm[kZ] == 0.0;
  lines.insert(
      lines.begin(),
      isTop ? m_profile.retract : fmt::format("SUPA G0 Z{} D0", nc::ncNumber(*home.targetMm[kZ])));
  return lines;
}

/// First away from the part, then the other axes: nobody has said how the source does it.
void Translator::goHome(const HomeMove& home, Translation& out) const {
  constexpr std::size_t kZ = 2;
  if (home.targetMm[kZ]) {
    out.before.push_back(wayUp(home).front());
  }
  if (home.targetMm[0] || home.targetMm[1]) {
    std::string line = home.toFixedPoint ? m_profile.home : "SUPA G0";
    for (std::size_t axis = 0; axis < kZ && !home.toFixedPoint; ++axis) {
      if (home.targetMm[axis]) {
        addWord(line,
                fmt::format("{}{}", base::kAxisNames[axis], nc::ncNumber(*home.targetMm[axis])));
      }
    }
    out.before.push_back(line);
  }
  std::string turn;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (home.targetDeg[axis]) {
      const double degrees = home.toFixedPoint ? 0.0 : *home.targetDeg[axis];
      turn += fmt::format(" {}{}", base::kRotaryAxisNames[axis], base::formatFixed(degrees, 6));
    }
  }
  if (!turn.empty()) {
    out.before.push_back("SUPA G0" + turn);
  }
  if (home.targetMm[kZ]) {
    // The source keeps its length offset, and the line above has cancelled it.
    const std::vector<std::string> again = offsetLines();
    out.before.insert(out.before.end(), again.begin(), again.end());
  }
}

bool Translator::isAccepted(const std::string& word) const {
  return std::find(m_accepted.begin(), m_accepted.end(), word) != m_accepted.end();
}

/// The offset of the tool before stays in force on the source (H does not follow the tool, and
/// LinuxCNC sets a length with G43 alone), which a SINUMERIK cannot have: D is of its own tool.
void Translator::changeTool(const nc::Language& language) {
  const bool fits = m_lengthNumber == m_tool;
  m_inSpindle = m_tool;
  m_foreignLength.clear();
  if (language.lengthComesWithTool) {
    m_offset = Offset::Tool;
  } else if (m_hasLength && fits) {
    m_offset = Offset::Tool;
  } else {
    m_offset = m_hasLength && m_profile.assumesTool ? Offset::Tool : Offset::None;
    if (m_hasLength) {
      m_foreignLength = fmt::format("{} (T{})", m_lengthNumber ? "H" + *m_lengthNumber : "G43",
                                    m_tool.value_or("?"));
    }
  }
}

/// Offset n is that of tool n. @param word  as written, "H12"
bool Translator::isOwnLength(const std::string& number, const std::string& word, Translation& out) {
  const std::optional<std::string>& tool = m_inSpindle ? m_inSpindle : m_tool;
  if (tool == number || isAccepted(word)) {
    return true;
  }
  if (!tool && m_profile.assumesTool) {
    m_assumedTool = word;
    return true;
  }
  if (tool && m_profile.assumesTool) {
    out.assumedLength = fmt::format("{} (T{})", word, *tool);
    return true;
  }
  if (tool) {
    out.refused.emplace_back(RefusalCode::LengthOfOtherTool, fmt::format("{} (T{})", word, *tool));
  } else {
    out.refused.emplace_back(RefusalCode::ToolNotCalled, word);
  }
  return false;
}

/// A control of another make knows no length until G43 asks for one, and H names its offset; the
/// SINUMERIK has D1 of a tool from the change on. @return the control has to be told
bool Translator::setLength(const std::vector<ForeignWord>& words, const nc::Language& language,
                           Translation& out) {
  using Kind = ForeignWord::Kind;
  const auto find = [&words](Kind kind, double value, bool anyValue) {
    const auto found = std::find_if(words.begin(), words.end(), [&](const ForeignWord& word) {
      return word.kind == kind && (anyValue || word.value == value);
    });
    return found == words.end() ? nullptr : &*found;
  };
  constexpr double kLengthOn = 430.0;
  constexpr double kLengthOff = 490.0;
  const ForeignWord* const cell = find(Kind::LengthCell, 0.0, true);
  const ForeignWord* const on = find(Kind::G, kLengthOn, false);
  if (find(Kind::G, kLengthOff, false) != nullptr || (cell != nullptr && cell->value == 0.0)) {
    m_hasLength = false;
    m_offset = Offset::None;
  } else if (cell != nullptr) {
    m_lengthNumber = nc::ncNumber(cell->value);
    m_hasLength = isOwnLength(*m_lengthNumber, cell->text, out);
    m_offset = m_hasLength ? Offset::Tool : m_offset;
  } else if (on != nullptr && language.lengthIsOfTool) {
    m_lengthNumber = m_inSpindle ? m_inSpindle : m_tool;
    m_hasLength = true;
    m_offset = Offset::Tool;
  } else if (on != nullptr && m_lengthNumber) {  // H stays until another one is named
    m_hasLength = isOwnLength(*m_lengthNumber, "H" + *m_lengthNumber, out);
    m_offset = m_hasLength ? Offset::Tool : m_offset;
  } else if (on != nullptr) {
    out.missing.push_back(on->text);
    return false;
  } else {
    return false;
  }
  m_foreignLength.clear();
  return cell != nullptr;
}

std::vector<std::string> Translator::offsetLines() const {
  switch (m_offset) {
    case Offset::None:
      return {"D0"};
    case Offset::Tool:
      return {"D1"};
    case Offset::Radius:  // an offset of the length before would be part of $P_TOOLL
      return {"TOFFL=0", "D1", "TOFFL=-$P_TOOLL[1]"};
  }
  return {};
}

/// Behind a tool change, which may be a call, else before the other words of the block.
void Translator::writeOffset(Offset before, bool changes, std::string& line,
                             std::vector<std::string>& first, Translation& out) const {
  std::vector<std::string> lines = offsetLines();
  if (before == Offset::Radius && m_offset != Offset::Radius) {
    lines.insert(lines.begin(), "TOFFL=0");
  }
  if (changes) {
    out.before.insert(out.before.begin(), lines.begin(), lines.end());
  } else if (lines.size() > 1) {
    first = std::move(lines);
  } else {
    addWord(line, lines.front());
  }
}

void Translator::translateWord(const ForeignWord& word, bool changes, std::string& line,
                               Translation& out) {
  using Kind = ForeignWord::Kind;
  switch (word.kind) {
    case Kind::Tool:
    case Kind::NamedTool:
      if (!changes) {
        addWord(line, "T" + *m_tool);
      }
      break;
    case Kind::M:
      translateM(static_cast<int>(word.value), word, line, out);
      break;
    case Kind::Spindle:
      addWord(line, "S" + nc::ncNumber(word.value));
      break;
    case Kind::Dwell:
      if (std::isfinite(word.value)) {
        out.before.push_back("G4 F" + nc::ncNumber(word.value));
      } else {
        out.missing.push_back(word.text);
      }
      break;
    case Kind::LengthCell:
      break;  // see setLength
    case Kind::G: {
      const int key = static_cast<int>(word.value);
      constexpr int kLengthOn = 430;
      constexpr int kLengthOff = 490;
      if (key == 970 || key == 400 || key == 410 || key == 420) {
        addWord(line, fmt::format("G{}", key / 10));
      } else if (const auto offset = workOffsetOf(key)) {
        addWord(line, *offset);
      } else if (key != kLengthOn && key != kLengthOff) {
        out.missing.push_back(word.text);
      }
      break;
    }
    case Kind::Compensation:
    case Kind::Line:
      out.before.push_back(word.text);
      break;
    case Kind::Other:
      out.missing.push_back(word.text);
      break;
  }
}

Translation Translator::translate(const std::vector<ForeignWord>& words,
                                  const std::optional<HomeMove>& home,
                                  const nc::Language& language) {
  using Kind = ForeignWord::Kind;
  Translation out;
  const auto has = [&words](Kind kind, double value) {
    return std::any_of(words.begin(), words.end(), [&](const ForeignWord& word) {
      return word.kind == kind && word.value == value;
    });
  };
  for (const ForeignWord& word : words) {
    if (word.kind == Kind::Tool) {
      m_tool = nc::ncNumber(word.value);
    } else if (word.kind == Kind::NamedTool) {
      m_tool = "=\"" + word.text + "\"";
    }
  }
  const bool changes = has(Kind::M, 6.0);
  std::string line;
  const Offset before = m_offset;
  if (changes) {
    changeTool(language);
  }
  const bool isNamed = setLength(words, language, out);
  const bool compensates = std::any_of(words.begin(), words.end(), [](const ForeignWord& word) {
    return word.kind == Kind::Compensation ||
           (word.kind == Kind::G && (word.value == 410.0 || word.value == 420.0));
  });
  if (compensates && m_offset == Offset::None) {
    m_offset = Offset::Radius;  // D0 has no radius either
  }
  if (compensates && !m_inSpindle && m_assumedTool.empty()) {
    m_assumedTool = "G41";
  }
  std::vector<std::string> first;
  const bool isControls = changes && language.lengthComesWithTool;
  if (isNamed || (changes && !isControls) || before != m_offset) {
    writeOffset(before, changes, line, first, out);
  }
  for (const ForeignWord& word : words) {
    translateWord(word, changes, line, out);
  }
  if (!line.empty()) {
    out.before.insert(out.before.begin(), line);
  }
  out.before.insert(out.before.begin(), first.begin(), first.end());
  if (home) {
    goHome(*home, out);
  }
  return out;
}

}  // namespace rivulet::job
