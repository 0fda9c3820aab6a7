// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/syntax/dialect.h"

#include <algorithm>
#include <cstddef>

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
    Evidence{Dialect::Grbl, "$H", 10, true},
    Evidence{Dialect::Grbl, "$X", 10, true},
    Evidence{Dialect::Grbl, "$J=", 10, true},
    Evidence{Dialect::Grbl, "$$", 10, true},
    Evidence{Dialect::Grbl, "$G", 5, true},
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
  return text;
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

/// A place in a plain line at which a G function identifies the dialect.
bool hasTellingG(std::string_view line) {
  for (std::size_t at = 0; at + 1 < line.size(); ++at) {
    if ((line[at] == 'G' || line[at] == 'g') &&
        (line[at + 1] == '5' || line[at + 1] == '6' || line[at + 1] == '7' || line[at + 1] == '4' ||
         line[at + 1] == '0')) {
      return true;
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
  std::array<int, kDialects.size()> weight{};
  std::array<std::pair<int, std::string_view>, kDialects.size()> strongest{};
  const auto count = [&](const Evidence& evidence) {
    const auto index = static_cast<std::size_t>(evidence.dialect);
    weight[index] += evidence.weight;
    if (evidence.weight > strongest[index].first) {
      strongest[index] = {evidence.weight, evidence.text};
    }
  };
  const std::string file = base::toUpper(fileName);
  for (const Evidence& ending : kEndings) {
    if (file.size() >= ending.text.size() &&
        file.compare(file.size() - ending.text.size(), std::string::npos, ending.text) == 0) {
      count(ending);
    }
  }
  std::string_view turningCycle;
  std::size_t lines = 0;
  while (!text.empty() && lines++ < kLinesLookedAt) {
    const std::size_t end = text.find_first_of("\r\n");
    const std::string_view raw = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    // No word of a dialect fits into a line of coordinates only.
    constexpr std::size_t kLongestLookedAt = 400;
    const std::string_view front = raw.substr(0, kLongestLookedAt);
    if (isPlain(front) && !hasTellingG(front)) {
      continue;
    }
    const std::string line = relevantPart(front);
    if (line.size() < 2) {
      continue;
    }
    for (const Evidence& evidence : kEvidence) {
      if (evidence.atStart ? startsWith(line, evidence.text) : contains(line, evidence.text)) {
        count(evidence);
      }
    }
    if (turningCycle.empty()) {
      turningCycle = turningCycleOf(line);
    }
  }
  const auto* const best = std::max_element(weight.begin(), weight.end());
  if (*best < 3) {
    return {Dialect::Fanuc, {}, std::string(turningCycle)};
  }
  const auto index = static_cast<std::size_t>(best - weight.begin());
  std::string shown(base::trim(strongest[index].second));
  std::replace(shown.begin(), shown.end(), '#',
               index == static_cast<std::size_t>(Dialect::LinuxCnc) ? '#' : 'n');
  return {static_cast<Dialect>(index), std::move(shown), std::string(turningCycle)};
}

}  // namespace rivulet::nc
