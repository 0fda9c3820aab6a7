// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The words of one block, collected before anything is executed: on a control, the order of words
/// in a block does not matter. @threadsafety plain values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "base/axes.h"
#include "nc/modal/vocabulary.h"
#include "nc/syntax/lexer.h"

namespace rivulet::nc {

/// The values that a block gives to addresses of one kind, each with what it counts from. NaN: a
/// value that could not be computed.
template <std::size_t Count>
struct AddressValues {
  // Set for what the block names: a block is made for every line of a program.
  std::array<double, Count> value;
  std::array<Reference, Count> reference;
  std::array<const Token*, Count> token;
  std::uint16_t named = 0;  ///< bit per address

  [[nodiscard]] bool has(std::size_t address) const { return (named >> address & 1U) != 0; }
  [[nodiscard]] bool hasAny(std::size_t first, std::size_t end) const {
    return (named >> first & ((1U << (end - first)) - 1U)) != 0;
  }
  void set(std::size_t address, double number, Reference from) {
    value[address] = number;
    reference[address] = from;
    named = static_cast<std::uint16_t>(named | 1U << address);
  }
  void remove(std::size_t address) { named = static_cast<std::uint16_t>(named & ~(1U << address)); }
};

/// The axes a block names, in the unit of the program.
struct AxisValues : AddressValues<kProgrammedAxisCount> {
  bool relative = false;  ///< G91 holds in this block

  [[nodiscard]] bool isIncrement(std::size_t axis) const {
    return reference[axis] == Reference::Incremental ||
           (relative && reference[axis] == Reference::Modal);
  }
};

/// A value that came with a name: CR=, AP=, TURN=.
struct NamedWord {
  double value = 0.0;
  Reference reference = Reference::Modal;
};

/// Words only few blocks have. They are made when the first one is met.
struct RareWords {
  std::map<std::string, NamedWord, std::less<>> named;
  std::map<int, double> arguments;  ///< of G65: #1 and on
  int argumentSet = 0;              ///< I J K of G65: how many began before
  char argumentLetter = 0;          ///< the last of them
  bool hasVariableP = false;        ///< G65 P#1
  std::string frame;                ///< TRANS, ROT, ...
  std::optional<Token> call;        ///< a subprogram by name, or L and its number
  std::optional<Token> statement;
  bool macroCall = false;
  bool modalMacro = false;     ///< G66
  bool modalMacroOff = false;  ///< G67
  bool call98 = false;
  bool call97 = false;
  bool returns = false;
  GEffect offset = GEffect::None;  ///< SetPosition to SetWorkOffset
  const GRow* pole = nullptr;
  const GRow* spline = nullptr;
  bool tangentArc = false;
  bool threePointArc = false;
  bool bSpline = false;
  const GRow* workOffset = nullptr;  ///< G54.1, G154: which offset says P
  const Token* workOffsetToken = nullptr;
  const Token* fixedPoint = nullptr;   ///< G75
  const Token* machineAxis = nullptr;  ///< FP=, X1=
  const Token* blockFeed = nullptr;    ///< FB=
  const Token* speedMax = nullptr;     ///< LIMS=, D with G96 of RS-274
  const GRow* spindleMode = nullptr;   ///< G96, G97
  MEffect savedState = MEffect::None;  ///< M70 to M73
  const Token* savedStateToken = nullptr;

  /// The words of the block are arguments.
  [[nodiscard]] bool isMacro() const { return macroCall || modalMacro; }
};

/// The G function of each group, null where the block names none.
struct GroupWords {
  const GRow* turning = nullptr;  ///< G90 or G94, which are cycles of a lathe beside axes
  const GRow* motion = nullptr;
  const GRow* distance = nullptr;
  const GRow* plane = nullptr;
  const GRow* units = nullptr;
  const GRow* blockEnd = nullptr;
  const GRow* compensationMode = nullptr;
};

/// Tokens that are pointed at live as long as the block is executed.
struct BlockWords {
  base::LineNumber line;
  AxisValues axes;                         ///< in the unit of the file
  AddressValues<base::kAxisCount> centre;  ///< I, J, K
  double radius = 0.0;
  bool hasRadius = false;
  bool radiusIsWord = false;  ///< R12 instead of CR=12
  bool dwell = false;
  bool tolerance = false;
  bool takesParameter = false;  ///< P and Q belong to an M function
  bool taken = false;           ///< a statement takes the axis words: no motion
  bool exactStop = false;       ///< G9
  bool changesLength = false;   ///< G43, G49: where Z is afterwards, the control alone knows
  bool foreignMotion = false;   ///< a cycle or thread begins: what was in progress ends
  bool ends = false;
  bool hasRotary = false;  ///< an axis beyond X, Y, Z
  GroupWords g;
  unsigned repeated = 0;                ///< bit per letter seen
  int motionColumn = 0;                 ///< of the first axis, centre or radius word
  const Token* feed = nullptr;          ///< F
  const Token* parameter = nullptr;     ///< the last of P, Q, L and U
  const Token* compensation = nullptr;  ///< G40 to G42
  const Token* spindle = nullptr;       ///< S; of a dwell: turns of the spindle
  const Token* edge = nullptr;          ///< D
  std::optional<double> p;
  std::optional<double> q;
  std::optional<double> l;
  const Token* radiusToken = nullptr;
  const Token* machineToken = nullptr;  ///< G53, SUPA: the block is in machine coordinates
  std::optional<RareWords> rare;

  [[nodiscard]] bool movesLinear() const { return axes.hasAny(0, base::kAxisCount); }
  [[nodiscard]] bool moves() const { return movesLinear() || hasRotary; }
  [[nodiscard]] bool hasAnyCentre() const { return centre.named != 0; }
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
