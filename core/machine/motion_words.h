// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the words of one block mean to the virtual machine. Words of A B C turn those rotary axes
/// the machine has, words of U V W are read and move nothing, M S T D H change nothing that is
/// modelled. Work offsets (G54 ...) are zero. @threadsafety pure.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <variant>

#include "base/axes.h"
#include "base/vec3.h"
#include "machine/alarm.h"
#include "machine/prepared.h"
#include "nc/syntax/tree.h"

namespace rivulet::machine {

enum class PathMode { Rapid, Line, Clockwise, CounterClockwise, Through };

/// A coordinate: as G90/G91 says, or AC(), IC().
struct Coordinate {
  double value = 0.0;
  nc::Word::Reference reference = nc::Word::Reference::Modal;
};

/// Axis words, feed and modal G functions of one block.
struct MotionWords {
  std::array<std::optional<Coordinate>, base::kAxisCount> axes;
  std::array<std::optional<Coordinate>, base::kRotaryAxisCount> rotary;  ///< A B C
  std::array<std::optional<Coordinate>, base::kAxisCount> centre;        ///< I J K
  std::array<std::optional<Coordinate>, base::kAxisCount> through;       ///< I1= J1= K1=
  std::optional<Coordinate> radius;                                      ///< CR=
  std::optional<Coordinate> openingAngle;                                ///< AR=
  std::optional<Coordinate> fullTurns;                                   ///< TURN=
  std::optional<Coordinate> feedMmPerMin;
  std::optional<Coordinate> roundingMm;  ///< ADIS=
  std::optional<PathMode> mode;
  std::optional<std::size_t> plane;  ///< `nc::Arc::firstAxis` of G17, G18, G19
  std::optional<Dynamics> dynamics;
  std::optional<bool> absolute;  ///< G90, G91
  std::optional<bool> inches;    ///< G70, G700; G71, G710
  std::optional<BlockEnd> end;   ///< G60; G64, G641 to G645
  std::optional<RoundingKind> rounding;
  bool exactStopOnce = false;    ///< G9
  bool suppressesFrame = false;  ///< G53, G153, SUPA: this block is in machine coordinates

  /// Names an axis. Rotary ones count even where the machine has none of that name.
  [[nodiscard]] bool moves() const { return axes[0] || axes[1] || axes[2] || isArc() || turns(); }
  [[nodiscard]] bool turns() const { return rotary[0] || rotary[1] || rotary[2]; }
  [[nodiscard]] bool isArc() const { return centre[0] || centre[1] || centre[2]; }
};

/// True if the machine does nothing in such a block: it costs no time.
[[nodiscard]] bool isWithoutEffect(const nc::Words& words);

/// @param valueOf  computes the value of a word
/// @return an alarm for a word this machine does not know, or that contradicts another
[[nodiscard]] std::variant<MotionWords, Alarm> gather(
    const nc::Words& words,
    const std::function<nc::Expected<double>(const nc::Expression&)>& valueOf);

}  // namespace rivulet::machine
