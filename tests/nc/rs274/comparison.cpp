// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/rs274/comparison.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <vector>

namespace rivulet::tests {

namespace {

using base::Vec3;

/// Beyond the rounding of what is printed: both compute with doubles, lengths are below a metre.
constexpr double kLengthMm = 1e-6;
constexpr double kAngleDeg = 1e-4;
constexpr double kFeedShare = 1e-5;

bool areNear(double a, double b, double tolerance) {
  return std::isnan(a) || std::isnan(b) || std::abs(a - b) <= tolerance;
}

bool areNear(Vec3 a, Vec3 b, double tolerance) {
  return areNear(a.x, b.x, tolerance) && areNear(a.y, b.y, tolerance) &&
         areNear(a.z, b.z, tolerance);
}

bool isSamePlace(const ReadMove& a, const ReadMove& b, double tolerance) {
  return areNear(a.endMm, b.endMm, tolerance);
}

bool isSameAngle(const ReadMove& a, const ReadMove& b) {
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (!areNear(a.rotaryDeg[axis], b.rotaryDeg[axis], kAngleDeg)) {
      return false;
    }
  }
  return true;
}

/// In what way two moves differ; empty: in none.
std::string differenceOf(const ReadMove& linuxCnc, const ReadMove& rivulet) {
  if (linuxCnc.form != rivulet.form) {
    return "another kind of move";
  }
  if (!isSamePlace(linuxCnc, rivulet, 1.2 * linuxCnc.errorMm + kLengthMm)) {
    return "another end";
  }
  if (!isSameAngle(linuxCnc, rivulet)) {
    return "another angle of a rotary axis";
  }
  if (linuxCnc.form == MoveForm::Arc) {
    const double tolerance = 4.0 * linuxCnc.errorMm + kLengthMm;
    // Where along its axis the centre is given does not matter.
    const Vec3 between = rivulet.centreMm - linuxCnc.centreMm;
    const Vec3 along = base::dot(between, linuxCnc.axis) * linuxCnc.axis;
    if (!areNear(base::distance(between, along), 0.0, tolerance)) {
      return "another centre";
    }
    const double radius = std::max(base::distance(linuxCnc.centreMm, linuxCnc.endMm), tolerance);
    const double sense = base::dot(linuxCnc.axis, rivulet.axis);
    if (!areNear(sense, 1.0, 1e-6) ||
        !areNear(linuxCnc.sweepRad, rivulet.sweepRad, 2.0 * tolerance / radius + 1e-6)) {
      return "another turn";
    }
  }
  const double tolerance = 1.2 * linuxCnc.errorMm + kFeedShare * std::abs(linuxCnc.feedPerMin);
  if (linuxCnc.form != MoveForm::Rapid &&
      !areNear(linuxCnc.feedPerMin, rivulet.feedPerMin, tolerance)) {
    return "another feed";
  }
  return {};
}

/// A straight move to where the tool stands is none.
bool goesNowhere(const std::vector<ReadMove>& moves, std::size_t index) {
  const ReadMove& move = moves[index];
  if (move.form == MoveForm::Arc || move.form == MoveForm::Spline) {
    return false;
  }
  constexpr double kSameMm = 6e-3;  // an inch has four decimals
  return index > 0 && isSamePlace(moves[index - 1], move, kSameMm) &&
         isSameAngle(moves[index - 1], move);
}

/// "Radius to end of arc differs …: start=(X5.0)" is the same for all numbers.
std::string withoutNumbers(const std::string& sentence) {
  std::string text;
  for (const char c : sentence.substr(0, std::min<std::size_t>(60, sentence.find(": start")))) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) {
      text += c;
    } else if (text.empty() || text.back() != '#') {
      text += '#';
    }
  }
  return text;
}

std::string differenceOf(const std::vector<ReadMove>& linuxCnc,
                         const std::vector<ReadMove>& rivulet) {
  std::size_t a = 0;
  std::size_t b = 0;
  bool isBehindSpline = false;
  while (a < linuxCnc.size() || b < rivulet.size()) {
    const std::string difference = a < linuxCnc.size() && b < rivulet.size()
                                       ? differenceOf(linuxCnc[a], rivulet[b])
                                       : std::string("another number of moves");
    if (difference.empty()) {
      isBehindSpline = linuxCnc[a].form == MoveForm::Spline;
      ++a;
      ++b;
    } else if (isBehindSpline && a < linuxCnc.size() && linuxCnc[a].form == MoveForm::Spline) {
      ++a;  // splines behind each other are one where the reader does not tell them apart
    } else if (isBehindSpline && b < rivulet.size() && rivulet[b].form == MoveForm::Spline) {
      ++b;
    } else if (a < linuxCnc.size() && goesNowhere(linuxCnc, a)) {
      ++a;
    } else if (b < rivulet.size() && goesNowhere(rivulet, b)) {
      ++b;
    } else {
      return difference;
    }
  }
  return {};
}

// --- shrinking ----------------------------------------------------------------------------------

using Pieces = std::vector<std::string>;

std::string joined(const Pieces& pieces) {
  std::string text;
  for (const std::string& piece : pieces) {
    text += piece;
  }
  return text;
}

/// Leaves out ever smaller runs of pieces.
Pieces shrunk(Pieces pieces, const std::function<bool(const std::string&)>& isSame) {
  for (std::size_t run = std::max<std::size_t>(1, pieces.size() / 2); run > 0; run /= 2) {
    for (std::size_t begin = 0; begin < pieces.size();) {
      Pieces fewer = pieces;
      const auto first = fewer.begin() + static_cast<std::ptrdiff_t>(begin);
      fewer.erase(first, first + static_cast<std::ptrdiff_t>(std::min(run, pieces.size() - begin)));
      if (isSame(joined(fewer))) {
        pieces = std::move(fewer);
      } else {
        begin += run;
      }
    }
  }
  return pieces;
}

/// A letter begins a word unless another one stands before it or it is inside brackets.
Pieces words(std::string_view text) {
  Pieces pieces;
  int depth = 0;
  char before = '\n';
  for (const char c : text) {
    const bool isLetter = std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '@' || c == '^';
    const bool wasLetter = std::isalpha(static_cast<unsigned char>(before)) != 0;
    const bool begins =
        c == '\n' || before == '\n' || c == '(' || c == ';' || c == '#' || (isLetter && !wasLetter);
    if (pieces.empty() || (depth == 0 && begins)) {
      pieces.emplace_back();
    }
    depth += c == '[' || c == '(' || c == '<' ? 1 : c == ']' || c == ')' || c == '>' ? -1 : 0;
    depth = c == '\n' ? 0 : depth;
    pieces.back() += c;
    before = c;
  }
  return pieces;
}

Pieces lines(std::string_view text) {
  Pieces pieces;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    pieces.emplace_back(text.substr(0, end + 1));
    text.remove_prefix(end + 1);
  }
  return pieces;
}

}  // namespace

Comparison compared(const PathReading& linuxCnc, const PathReading& rivulet) {
  if (!linuxCnc.accepted) {
    return rivulet.accepted ? Comparison{Agreement::Different,
                                         "LinuxCNC refuses: " + withoutNumbers(linuxCnc.refusal)}
                            : Comparison{Agreement::BothRefuse, withoutNumbers(linuxCnc.refusal)};
  }
  if (!rivulet.accepted) {
    return {Agreement::NotSupported, rivulet.word};
  }
  const std::string difference = differenceOf(linuxCnc.moves, rivulet.moves);
  return difference.empty() ? Comparison{} : Comparison{Agreement::Different, difference};
}

std::string shrunk(std::string_view text, const std::function<bool(const std::string&)>& isSame) {
  const std::size_t kept = std::min(text.find('\n'), text.size() - 1) + 1;
  const std::string head(text.substr(0, kept));
  const auto isSameBehindHead = [&](const std::string& rest) { return isSame(head + rest); };
  std::string small(text.substr(kept));
  for (std::size_t before = small.size() + 1; small.size() < before;) {
    before = small.size();
    small = joined(shrunk(lines(small), isSameBehindHead));
    small = joined(shrunk(words(small), isSameBehindHead));
  }
  return head + small;
}

}  // namespace rivulet::tests
