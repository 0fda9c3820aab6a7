// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The words of one block, collected before anything is executed: on a control, the order of words
/// in a block does not matter. @threadsafety plain values.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "base/axes.h"
#include "nc/modal/vocabulary.h"
#include "nc/syntax/lexer.h"

namespace rivulet::nc {

/// The axes a block names, as written. NaN: a value that could not be computed.
struct AxisValues {
  std::array<double, kProgrammedAxisCount> value;  ///< has one where `given`
  std::array<bool, kProgrammedAxisCount> given{};
  std::array<bool, kProgrammedAxisCount> isIncrement{};
};

/// A value that came with a name: CR=, AP=, TURN=.
struct NamedWord {
  double value = 0.0;
  bool isIncrement = false;
};

/// Words only few blocks have. They are made when the first one is met.
struct RareWords {
  std::map<std::string, NamedWord, std::less<>> named;
  std::map<int, double> arguments;  ///< of G65: #1 and on
  std::string frame;                ///< TRANS, ROT, ...
  std::optional<Token> call;        ///< a subprogram by name, or L and its number
  std::optional<Token> statement;
  bool macroCall = false;
  bool call98 = false;
  bool returns = false;
  GEffect offset = GEffect::None;  ///< SetPosition to SetWorkOffset
  int poleKey = -1;
  int splineKey = -1;
  bool tangentArc = false;
  bool threePointArc = false;
  bool bSpline = false;
  int workOffsetKey = -1;  ///< G54.1, G154: which offset says P
  const Token* workOffsetToken = nullptr;
  const Token* fixedPoint = nullptr;   ///< G75
  const Token* machineAxis = nullptr;  ///< FP=, X1=
};

/// Tokens that are pointed at live as long as the block is executed.
struct BlockWords {
  base::LineNumber line;
  AxisValues axes;  ///< in the unit of the file
  std::array<double, base::kAxisCount> centre{};
  std::array<bool, base::kAxisCount> hasCentre{};
  std::array<bool, base::kAxisCount> centreIsAbsolute{};
  /// AC(), IC() and the like: G90 and G91 do not count.
  std::array<bool, kProgrammedAxisCount> hasOwnMode{};
  double radius = 0.0;
  bool hasRadius = false;
  bool radiusIsWord = false;  ///< R12 instead of CR=12
  bool dwell = false;
  bool tolerance = false;
  bool taken = false;          ///< a statement takes the axis words: no motion
  bool exactStop = false;      ///< G9
  bool foreignMotion = false;  ///< a cycle or thread begins: what was in progress ends
  bool ends = false;
  bool hasRotary = false;  ///< an axis beyond X, Y, Z
  int latheKey = -1;       ///< G90 or G94, which are turning cycles where they stand with axes
  int motionKey = -1;
  int distanceKey = -1;
  int planeKey = -1;
  int unitsKey = -1;
  int blockEndKey = -1;
  int compensationKey = -1;
  unsigned repeated = 0;                ///< bit per letter seen
  int motionColumn = 0;                 ///< of the first axis, centre or radius word
  const Token* feed = nullptr;          ///< F
  const Token* parameter = nullptr;     ///< the last of P, Q, L and U
  const Token* compensation = nullptr;  ///< G40 to G42
  const Token* spindle = nullptr;       ///< S; of a dwell: turns of the spindle
  double spindleBefore = 0.0;           ///< speed before this block, 1/min
  std::optional<double> p;
  std::optional<double> q;
  std::optional<double> l;
  const Token* radiusToken = nullptr;
  const Token* machineToken = nullptr;  ///< G53, SUPA: the block is in machine coordinates
  // Set for what the block names: a block is made for every line of a program.
  std::array<const Token*, base::kAxisCount> centreTokens;
  std::array<const Token*, kProgrammedAxisCount> axisTokens;
  std::optional<RareWords> rare;

  [[nodiscard]] bool movesLinear() const { return axes.given[0] || axes.given[1] || axes.given[2]; }
  [[nodiscard]] bool moves() const { return movesLinear() || hasRotary; }
  [[nodiscard]] bool hasAnyCentre() const { return hasCentre[0] || hasCentre[1] || hasCentre[2]; }
  [[nodiscard]] const NamedWord* named(std::string_view name) const {
    if (!rare) {
      return nullptr;
    }
    const auto found = rare->named.find(name);
    return found == rare->named.end() ? nullptr : &found->second;
  }
  RareWords& rareWords() { return rare ? *rare : rare.emplace(); }
};

}  // namespace rivulet::nc
