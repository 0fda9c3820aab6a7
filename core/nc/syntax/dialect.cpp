// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/syntax/dialect.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/contract.h"
#include "base/text.h"

namespace rivulet::nc {

namespace {

constexpr std::size_t kLinesLookedAt = 2000;

struct Evidence {
  Dialect dialect;
  std::string_view text;  ///< upper case; '#' stands for a digit
  int weight;
  bool atStart = false;  ///< of the line, after a block number
};

/// What a reader of NC programs would go by. Heavier evidence decides against lighter.
constexpr std::array kEvidence{
    Evidence{Dialect::Heidenhain, "BEGIN PGM ", 100, true},
    Evidence{Dialect::Heidenhain, "BLK FORM ", 50, true},
    Evidence{Dialect::Heidenhain, "TOOL CALL ", 20, true},
    Evidence{Dialect::Heidenhain, "CYCL DEF ", 20, true},
    Evidence{Dialect::Heidenhain, "END PGM ", 50, true},
    Evidence{Dialect::Sinumerik, "%_N_", 50, true},
    Evidence{Dialect::Sinumerik, ";$PATH=", 50, true},
    Evidence{Dialect::Sinumerik, "DEF REAL ", 20, true},
    Evidence{Dialect::Sinumerik, "DEF INT ", 20, true},
    Evidence{Dialect::Sinumerik, "DEF STRING", 20, true},
    Evidence{Dialect::Sinumerik, "DEF BOOL ", 20, true},
    Evidence{Dialect::Sinumerik, "PROC ", 20, true},
    Evidence{Dialect::Sinumerik, "EXTERN ", 20, true},
    Evidence{Dialect::Sinumerik, "MSG(", 10, true},
    Evidence{Dialect::Sinumerik, "MCALL", 10, true},
    Evidence{Dialect::Sinumerik, "GOTOF ", 10, false},
    Evidence{Dialect::Sinumerik, "GOTOB ", 10, false},
    Evidence{Dialect::Sinumerik, "ENDWHILE", 5, true},
    Evidence{Dialect::Sinumerik, "ENDFOR", 10, true},
    Evidence{Dialect::Sinumerik, "ENDLOOP", 10, true},
    Evidence{Dialect::Sinumerik, "UNTIL ", 10, true},
    Evidence{Dialect::Sinumerik, "STOPRE", 10, true},
    Evidence{Dialect::Sinumerik, "TRAORI", 20, false},
    Evidence{Dialect::Sinumerik, "TRAFOOF", 20, false},
    Evidence{Dialect::Sinumerik, "CYCLE##", 10, false},
    Evidence{Dialect::Sinumerik, "SUPA", 10, false},
    Evidence{Dialect::Sinumerik, "G64#", 5, false},
    Evidence{Dialect::Sinumerik, "G710", 5, false},
    Evidence{Dialect::Sinumerik, "G700", 5, false},
    Evidence{Dialect::Sinumerik, "CR=", 10, false},
    Evidence{Dialect::Sinumerik, "X=", 3, false},
    Evidence{Dialect::Sinumerik, "Y=", 3, false},
    Evidence{Dialect::Sinumerik, "Z=", 3, false},
    Evidence{Dialect::Sinumerik, "=IC(", 10, false},
    Evidence{Dialect::Sinumerik, "=AC(", 10, false},
    Evidence{Dialect::Sinumerik, "A3=", 10, false},
    Evidence{Dialect::Sinumerik, "TRANS ", 10, true},
    Evidence{Dialect::Sinumerik, "BSPLINE", 10, true},
    Evidence{Dialect::Sinumerik, "R#=", 3, true},
    Evidence{Dialect::Sinumerik, "R##=", 3, true},
    Evidence{Dialect::Sinumerik, "T=\"", 10, false},
    Evidence{Dialect::Sinumerik, "$P_", 10, false},
    Evidence{Dialect::Sinumerik, "$A", 5, false},
    Evidence{Dialect::LinuxCnc, "O<", 20, true},
    Evidence{Dialect::LinuxCnc, "#<", 5, false},
    Evidence{Dialect::LinuxCnc, "G5.2", 10, false},
    Evidence{Dialect::LinuxCnc, "G5.3", 10, false},
    Evidence{Dialect::LinuxCnc, "G64 P", 3, false},
    Evidence{Dialect::LinuxCnc, " SUB", 3, false},
    Evidence{Dialect::LinuxCnc, "ENDSUB", 15, false},
    Evidence{Dialect::LinuxCnc, "ENDREPEAT", 15, false},
    Evidence{Dialect::LinuxCnc, " ENDWHILE", 8, false},
    Evidence{Dialect::LinuxCnc, " ENDIF", 8, false},
    Evidence{Dialect::LinuxCnc, " REPEAT [", 10, false},
    Evidence{Dialect::LinuxCnc, " WHILE [", 3, false},
    Evidence{Dialect::LinuxCnc, "G7 ", 5, false},
    Evidence{Dialect::LinuxCnc, "M66 P", 5, false},
    Evidence{Dialect::LinuxCnc, "M68 E", 5, false},
    Evidence{Dialect::Grbl, "$H", 10, true},
    Evidence{Dialect::Grbl, "$X", 10, true},
    Evidence{Dialect::Grbl, "$J=", 10, true},
    Evidence{Dialect::Grbl, "$$", 10, true},
    Evidence{Dialect::Grbl, "$#", 5, true},
    Evidence{Dialect::Grbl, "$G", 5, true},
    // Haas, mill operator's manual, list of G and M codes: pockets, engraving, local subprograms,
    // smoothness, further work offsets, look-ahead, tool centre point.
    Evidence{Dialect::Haas, "G150 ", 10, false},
    Evidence{Dialect::Haas, "G187", 10, false},
    Evidence{Dialect::Haas, "G154 P", 10, false},
    Evidence{Dialect::Haas, "G154P", 10, false},
    Evidence{Dialect::Haas, "G103", 10, false},
    Evidence{Dialect::Haas, "G234", 10, false},
    Evidence{Dialect::Haas, "G47 P", 8, false},
    Evidence{Dialect::Haas, "G12 I", 8, false},
    Evidence{Dialect::Haas, "G13 I", 8, false},
    Evidence{Dialect::Haas, "M97 P", 10, false},
    Evidence{Dialect::Haas, "M97P", 10, false},
    Evidence{Dialect::Fanuc, "G65", 5, false},
    Evidence{Dialect::Fanuc, "G43.4", 5, false},
    Evidence{Dialect::Fanuc, "G05.1", 5, false},
    Evidence{Dialect::Fanuc, "O####", 5, true},
    Evidence{Dialect::Fanuc, ":####", 3, true},
};

/// An ending of the file's name counts like one strong word of the text.
constexpr std::array kEndings{Evidence{Dialect::Sinumerik, ".MPF", 15},
                              Evidence{Dialect::Sinumerik, ".SPF", 15},
                              Evidence{Dialect::LinuxCnc, ".NGC", 8}};

using base::isDigit;

bool startsWith(std::string_view text, std::string_view pattern) {
  if (text.size() < pattern.size()) {
    return false;
  }
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    // "#" stands for a digit, except where a variable begins: "#<".
    const bool digit = pattern[i] == '#' && pattern != "#<";
    if (digit ? !isDigit(text[i]) : text[i] != pattern[i]) {
      return false;
    }
  }
  return true;
}

/// @param pattern  does not begin with a digit
bool contains(std::string_view line, std::string_view pattern) {
  for (std::size_t at = line.find(pattern.front()); at != std::string_view::npos;
       at = line.find(pattern.front(), at + 1)) {
    if (startsWith(line.substr(at), pattern)) {
      return true;
    }
  }
  return false;
}

/// Without comment and block number, in upper case.
std::string relevantPart(std::string_view line) {
  std::string text = base::toUpper(base::trim(line));
  const bool isHeader = text.rfind(";$PATH=", 0) == 0;
  if (const std::size_t comment = text.find(';'); comment != std::string::npos && !isHeader) {
    text.resize(comment);
  }
  // A comment in brackets; MSG(...) and calls have no blank before theirs.
  if (const std::size_t comment = text.find('(');
      comment != std::string::npos && (comment == 0 || text[comment - 1] == ' ')) {
    text.resize(comment);
  }
  std::size_t at = 0;
  if (at < text.size() && text[at] == 'N' && at + 1 < text.size() && isDigit(text[at + 1])) {
    ++at;
  }
  const std::size_t digits = at;
  while (at < text.size() && isDigit(text[at])) {
    ++at;
  }
  if (at > digits) {
    while (at < text.size() && text[at] == ' ') {
      ++at;
    }
    text.erase(0, at);
  }
  // A heading of plain text, "* - MILL D10 CR=0", is free text.
  return text.empty() || text.front() != '*' ? text : std::string();
}

bool isLetter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// True for the many lines of single letters and numbers, in which only a G function can tell.
bool isPlain(std::string_view line) {
  bool afterLetter = false;
  for (const char c : line) {
    const bool letter = isLetter(c);
    if ((letter && afterLetter) ||
        std::string_view("%$;=#([:<\"/oO").find(c) != std::string_view::npos) {
      return false;
    }
    afterLetter = letter;
  }
  return true;
}

/// A place in a plain line at which a G or M function identifies the dialect.
bool hasTellingG(std::string_view line) {
  for (std::size_t at = 0; at + 2 < line.size(); ++at) {
    const char letter = base::toUpper(line[at]);
    if (letter == 'M') {
      if (line[at + 1] == '9' || line[at + 1] == '6' || line[at + 1] == '7') {
        return true;
      }
    } else if (letter == 'G') {
      // G1 and G10 to G19 tell nothing but G12 and G13; G100 and on do.
      const char second = line[at + 1];
      const bool isLong = at + 3 < line.size() && isDigit(line[at + 2]) && isDigit(line[at + 3]);
      if (second == '4' || second == '5' || second == '6' || second == '7' || second == '0' ||
          (second == '1' && (isLong || line[at + 2] == '2' || line[at + 2] == '3')) ||
          (second == '2' && isLong)) {
        return true;
      }
    }
  }
  return false;
}

/// G70 to G73 with the block numbers of a profile, or with the depth and retract of roughing; no
/// mill has such a block. @param line  upper case
std::string_view turningCycleOf(std::string_view line) {
  static constexpr std::array<std::string_view, 4> kCycles{"G70", "G71", "G72", "G73"};
  const auto has = [line](char address) { return line.find(address) != std::string_view::npos; };
  if (has('X') || has('Y') || has('Z') || !((has('P') && has('Q')) || (has('U') && has('R')))) {
    return {};
  }
  for (const std::string_view cycle : kCycles) {
    const std::size_t at = line.find(cycle);
    const std::string_view behind = at == std::string_view::npos ? "0" : line.substr(at + 3);
    if (behind.empty() || (!isDigit(behind.front()) && behind.front() != '.')) {
      return cycle;
    }
  }
  return {};
}

/// Calls `word(letter, number)` for each letter with digits, outside of comments: "G97" is G, 97;
/// "T0101" is T, 101 with four digits.
template <class Word>
void forWords(std::string_view line, Word word) {
  int depth = 0;
  for (std::size_t at = 0; at < line.size() && line[at] != ';'; ++at) {
    depth += line[at] == '(' ? 1 : (line[at] == ')' && depth > 0) ? -1 : 0;
    if (depth > 0 || !isLetter(line[at])) {
      continue;
    }
    const char letter = base::toUpper(line[at]);
    std::size_t digit = at + 1;
    while (digit < line.size() && line[digit] == ' ') {
      ++digit;
    }
    const std::size_t first = digit;
    int number = 0;
    while (digit < line.size() && isDigit(line[digit]) && digit - first < 6) {
      number = number * 10 + (line[digit++] - '0');
    }
    const bool isWhole = digit >= line.size() || line[digit] != '.';
    word(letter, isWhole && digit > first ? number : -1, digit - first);
  }
}

/// Collects what lathes have and mills have not. @source Fanuc, operator's manual for lathe
/// systems, G code list of system A: G50 limits the speed, G96 and G97 say what S is, G98 and G99
/// what F is; T has the offset in its last two digits.
class LatheSigns {
 public:
  void look(std::string_view line) {
    bool limits = false;
    bool hasSpeed = false;
    bool isMotion = false;
    forWords(line, [&](char letter, int number, std::size_t digits) {
      switch (letter) {
        case 'G':
          limits |= number == 50;
          m_hasConstantSpeed |= number == 96;
          m_hasFixedSpeed |= number == 97;
          m_hasPerRevolution |= number == 99;
          m_hasDrilling |= (number >= 81 && number <= 89) || number == 73 || number == 74;
          m_isMill |= number == 17 || number == 43;
          break;
        case 'S':
          hasSpeed = true;
          break;
        case 'T':
          m_hasOffsetInTool |= digits == 4 && number % 100 != 0;
          break;
        case 'X':
          isMotion = m_hasX = true;
          break;
        case 'Z':
          isMotion = m_hasZ = true;
          break;
        case 'U':
        case 'W':
          m_hasIncrements = true;
          break;
        case 'Y':
          m_isMill = true;
          break;
        default:
          break;
      }
    });
    m_limitsSpeed |= limits && hasSpeed && !isMotion;
  }

  /// "G97, G99"; "" if it is no lathe.
  [[nodiscard]] std::string shown() const {
    std::string signs;
    int count = 0;
    const auto add = [&](bool has, std::string_view text) {
      if (has) {
        signs += count++ == 0 ? "" : ", ";
        signs += text;
      }
    };
    add(m_limitsSpeed, "G50 S");
    add(m_hasConstantSpeed, "G96");
    add(m_hasFixedSpeed, "G97");
    add(m_hasPerRevolution && !m_hasDrilling, "G99");
    add(m_hasOffsetInTool, "T with four digits");
    add(m_hasIncrements, "U, W");
    return count >= 2 && m_hasX && m_hasZ && !m_isMill ? signs : std::string();
  }

 private:
  bool m_limitsSpeed = false;
  bool m_hasConstantSpeed = false;
  bool m_hasFixedSpeed = false;
  bool m_hasPerRevolution = false;
  bool m_hasDrilling = false;
  bool m_hasOffsetInTool = false;
  bool m_hasIncrements = false;
  bool m_hasX = false;
  bool m_hasZ = false;
  bool m_isMill = false;
};

/// A line that may be one of a lathe: G50, G9x, T with four digits. Cheap, for every line.
bool hintsAtLathe(std::string_view line) {
  for (std::size_t at = 0; at + 2 < line.size(); ++at) {
    const char letter = base::toUpper(line[at]);
    if (letter == 'G' && ((line[at + 1] == '9' && line[at + 2] >= '6') ||
                          (line[at + 1] == '5' && line[at + 2] == '0'))) {
      return true;
    }
  }
  return false;
}

/// Lines of a text, whatever ends them.
std::string_view takeLine(std::string_view& text) {
  const std::size_t end = text.find_first_of("\r\n");
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

/// Controls that a post-processor names in the comments at the beginning.
struct Mention {
  std::string_view text;
  Dialect dialect;
};
constexpr std::array kMentions{
    Mention{"SINUMERIK", Dialect::Sinumerik}, Mention{"840D", Dialect::Sinumerik},
    Mention{"FANUC", Dialect::Fanuc},         Mention{"HAAS", Dialect::Haas},
    Mention{"LINUXCNC", Dialect::LinuxCnc},   Mention{"EMC2", Dialect::LinuxCnc},
    Mention{"GRBL", Dialect::Grbl},           Mention{"FLUIDNC", Dialect::FluidNc}};
constexpr std::size_t kLinesOfHeader = 30;
constexpr int kMentionWeight = 6;

/// Dialects whose words do not contradict each other: one has those of the other.
bool areRelated(Dialect a, Dialect b) {
  const auto isOf = [&](Dialect x, Dialect y) { return (a == x && b == y) || (a == y && b == x); };
  return isOf(Dialect::Fanuc, Dialect::Haas) || isOf(Dialect::LinuxCnc, Dialect::Grbl) ||
         isOf(Dialect::LinuxCnc, Dialect::FluidNc) || isOf(Dialect::Grbl, Dialect::FluidNc);
}

/// "o160 (why) if [1]", which LinuxCNC refuses and FluidNC reads.
bool hasCommentBehindOWord(std::string_view line) {
  line = base::trim(line);
  if (line.empty() || base::toUpper(line.front()) != 'O') {
    return false;
  }
  std::size_t at = line.find_first_not_of("0123456789", 1);
  at = at == 1 || at == std::string_view::npos ? at : line.find_first_not_of(" \t", at);
  if (at == std::string_view::npos || line[at] != '(') {
    return false;
  }
  const std::size_t close = line.find(')', at);
  const std::string_view behind =
      close == std::string_view::npos ? "" : base::trim(line.substr(close + 1));
  return behind.size() >= 2 && isLetter(behind[0]) && isLetter(behind[1]);
}

std::string shownEvidence(std::string_view text, Dialect dialect) {
  std::string shown(base::trim(text));
  std::replace(shown.begin(), shown.end(), '#', dialect == Dialect::LinuxCnc ? '#' : 'n');
  return shown;
}

/// What speaks for each dialect.
class Votes {
 public:
  void count(const Evidence& evidence) {
    const auto index = static_cast<std::size_t>(evidence.dialect);
    m_weight[index] += evidence.weight;
    if (evidence.weight > m_strongest[index].first) {
      m_strongest[index] = {evidence.weight, evidence.text};
    }
  }

  /// Its O words and calculations are those of RS-274/NGC.
  void giveRs274ToFluidNc() {
    auto& ofFluidNc = m_weight[static_cast<std::size_t>(Dialect::FluidNc)];
    if (ofFluidNc > 0) {
      ofFluidNc += std::exchange(m_weight[static_cast<std::size_t>(Dialect::LinuxCnc)], 0);
    }
  }

  void decide(DialectGuess& guess) const {
    const auto* const best = std::max_element(m_weight.begin(), m_weight.end());
    constexpr int kLeastWeight = 3;
    if (*best < kLeastWeight) {
      guess.others = {Dialect::LinuxCnc, Dialect::Grbl};
      return;
    }
    const auto index = static_cast<std::size_t>(best - m_weight.begin());
    guess.dialect = static_cast<Dialect>(index);
    guess.evidence = shownEvidence(m_strongest[index].second, guess.dialect);
    for (const Dialect other : kDialects) {
      const auto its = static_cast<std::size_t>(other);
      constexpr int kStrong = 10;
      if (other == guess.dialect || m_weight[its] < kLeastWeight) {
        continue;
      }
      if (m_strongest[its].first >= kStrong && m_strongest[index].first >= kStrong &&
          !areRelated(other, guess.dialect)) {
        guess.contradiction = shownEvidence(m_strongest[its].second, other);
      } else if (2 * m_weight[its] > *best) {
        guess.others.push_back(other);
      }
    }
  }

 private:
  std::array<int, kDialects.size()> m_weight{};
  std::array<std::pair<int, std::string_view>, kDialects.size()> m_strongest{};
};

/// @return the turning cycle that the line has
std::string_view countLine(std::string_view front, Votes& votes) {
  if (hasCommentBehindOWord(front)) {
    votes.count({Dialect::FluidNc, "O# (...)", 20});
  }
  const std::string line = relevantPart(front);
  if (line.size() < 2) {
    return {};
  }
  for (const Evidence& evidence : kEvidence) {
    if (evidence.atStart ? startsWith(line, evidence.text) : contains(line, evidence.text)) {
      votes.count(evidence);
    }
  }
  return turningCycleOf(line);
}

std::string latheSignsOf(std::string_view text) {
  LatheSigns signs;
  for (std::size_t lines = 0; !text.empty() && lines < kLinesLookedAt; ++lines) {
    signs.look(takeLine(text));
  }
  return signs.shown();
}

}  // namespace

std::string_view dialectName(Dialect dialect) {
  switch (dialect) {
    case Dialect::Sinumerik:
      return "sinumerik";
    case Dialect::Fanuc:
      return "fanuc";
    case Dialect::Haas:
      return "haas";
    case Dialect::LinuxCnc:
      return "linuxcnc";
    case Dialect::Grbl:
      return "grbl";
    case Dialect::Heidenhain:
      return "heidenhain";
    case Dialect::FluidNc:
      return "fluidnc";
  }
  base::contractViolated("every dialect has a name", __FILE__, __LINE__);
}

std::optional<Dialect> dialectOfName(std::string_view name) {
  if (name == "iso") {
    return Dialect::Fanuc;
  }
  const auto* const found =
      std::find_if(kDialects.begin(), kDialects.end(),
                   [name](Dialect dialect) { return dialectName(dialect) == name; });
  return found == kDialects.end() ? std::nullopt : std::optional(*found);
}

DialectGuess detectDialect(std::string_view text, std::string_view fileName) {
  Votes votes;
  const std::string file = base::toUpper(fileName);
  for (const Evidence& ending : kEndings) {
    if (file.size() >= ending.text.size() &&
        file.compare(file.size() - ending.text.size(), std::string::npos, ending.text) == 0) {
      votes.count(ending);
    }
  }
  std::string_view rest = text;
  std::array<bool, kMentions.size()> mentioned{};
  std::string_view turningCycle;
  bool mayBeLathe = false;
  std::size_t lines = 0;
  while (!rest.empty() && lines++ < kLinesLookedAt) {
    const std::string_view raw = takeLine(rest);
    // No word of a dialect fits into a line of coordinates only.
    constexpr std::size_t kLongestLookedAt = 400;
    const std::string_view front = raw.substr(0, kLongestLookedAt);
    if (lines <= kLinesOfHeader && front.find_first_of("(;") != std::string_view::npos) {
      const std::string comment = base::toUpper(front.substr(front.find_first_of("(;")));
      for (std::size_t i = 0; i < kMentions.size(); ++i) {
        mentioned[i] = mentioned[i] || comment.find(kMentions[i].text) != std::string::npos;
      }
    }
    mayBeLathe = mayBeLathe || hintsAtLathe(front);
    if (isPlain(front) && !hasTellingG(front)) {
      continue;
    }
    const std::string_view cycle = countLine(front, votes);
    turningCycle = turningCycle.empty() ? cycle : turningCycle;
  }
  for (std::size_t i = 0; i < kMentions.size(); ++i) {
    if (mentioned[i]) {
      votes.count({kMentions[i].dialect, kMentions[i].text, kMentionWeight});
    }
  }
  votes.giveRs274ToFluidNc();
  DialectGuess guess;
  guess.lathe = turningCycle.empty() && mayBeLathe ? latheSignsOf(text) : std::string(turningCycle);
  if (!guess.lathe.empty()) {
    // Its G codes are those of Fanuc's lathes.
    constexpr int kLatheWeight = 4;
    votes.count({Dialect::Fanuc, guess.lathe, kLatheWeight});
  }
  votes.decide(guess);
  return guess;
}

}  // namespace rivulet::nc
