// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What executing a block has for result: a path, faults, and what the block has for the machine.
/// The preview builds a trajectory and findings of it, the virtual machine its next prepared block
/// and alarms. @threadsafety one object, one thread.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/axes.h"
#include "nc/exec/block_words.h"
#include "nc/exec/position.h"
#include "nc/fault.h"
#include "nc/geometry/arc.h"
#include "nc/geometry/spline.h"
#include "nc/modal/state.h"
#include "nc/modal/vocabulary.h"

namespace rivulet::nc {

/// What a move has besides its geometry.
struct Move {
  base::LineNumber line;  ///< of the block that ends the move
  Motion motion = Motion::Line;
  double feedMmPerS = 0.0;      ///< 0: none is known
  bool turns = false;           ///< names a rotary axis
  base::RotaryDeg rotaryDeg{};  ///< where those axes stand afterwards, if it does; NaN: not known
  std::optional<base::Vec3> toolDirection;  ///< unit vector, programmed coordinates
  bool exactStop = false;                   ///< G9
  int column = 0;                           ///< of the first word of the move
};

class Sink {
 public:
  virtual ~Sink() = default;

  // The path, from `from` in programmed coordinates.
  virtual void line(const Position& from, base::Vec3 targetMm, const Move& move) = 0;
  virtual void arc(const Position& from, const Arc& arc, const Move& move) = 0;
  virtual void spaceArc(const Position& from, const SpaceArc& arc, base::Vec3 targetMm,
                        const Move& move) = 0;
  virtual void spline(const Position& from, const Spline& spline, const Move& move) = 0;
  /// To a place whose way is not known: a fault has been reported.
  virtual void unknownWay(const Position& from, base::Vec3 targetMm, const Move& move) = 0;

  // What is wrong.
  virtual void report(Severity severity, int column, FaultCode code, std::string argument) = 0;
  /// Of a value or of the order of blocks. @param column  of the word it belongs to
  virtual void fault(int column, const Fault& fault) = 0;
  void error(const Token& token, FaultCode code) { error(token, code, std::string(token.text)); }
  void error(const Token& token, FaultCode code, std::string argument) {
    report(Severity::Error, token.column, code, std::move(argument));
  }

  // What has no effect on the path: of each kind the first one may be worth a note.
  virtual void ignore(const Token& /*token*/, std::string /*word*/) {}
  virtual void ignoreG(int /*key*/, const Token& /*token*/) {}
  virtual void ignoreM(Severity /*severity*/, int /*number*/, const Token& /*token*/) {}
  virtual void ignoreLetter(const Token& /*token*/) {}

  // For the machine.
  virtual void machineWord(MachineWord /*kind*/, double /*value*/) {}
  virtual void toolName(std::string_view /*name*/) {}

  // What the words say as they are written, whatever comes of it.
  /// @param g  0 to 3; -1 before any of them
  virtual void programmed(int /*g*/, const AxisValues& /*axes*/) {}
  /// @param arc  plane, direction and turns
  virtual void programmedArc(const AxisValues& /*axes*/, const Arc& /*arc*/,
                             const ArcWords& /*words*/) {}
  /// In machine coordinates.
  virtual void programmedForMachine(int /*g*/, const AxisValues& /*axes*/) {}
  /// A motion that is none of G0 to G3.
  virtual void programmedOther() {}
  virtual void programmedFeed(double /*feed*/, std::optional<double> /*mmPerMin*/) {}
  virtual void programmedUnits(bool /*inches*/) {}
  /// Where the axes (or this one) stand in the program's coordinates is not known any more.
  virtual void forgetPosition(std::optional<std::size_t> /*axis*/) {}
  void forgetPosition() { forgetPosition(std::nullopt); }
  void otherMotion() {
    programmedOther();
    forgetPosition();
  }
};

}  // namespace rivulet::nc
