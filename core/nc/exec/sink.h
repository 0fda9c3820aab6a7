// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What comes of executing a block: a path and faults. The preview makes a trajectory and findings
/// of them, the virtual machine its next prepared block and alarms. @threadsafety one object, one
/// thread.
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
  double feedDegPerS = 0.0;     ///< the same number, for moves that only turn
  bool turns = false;           ///< names a rotary axis
  base::RotaryDeg rotaryDeg{};  ///< where those axes stand afterwards, if it does; NaN: not known
  std::optional<base::Vec3> toolDirection;  ///< unit vector, programmed coordinates
  bool exactStop = false;                   ///< G9
  int column = 0;                           ///< of the first word of the move
};

/// Where the path goes, from `from` in programmed coordinates.
class PathSink {
 public:
  virtual ~PathSink() = default;
  virtual void line(const Position& from, base::Vec3 targetMm, const Move& move) = 0;
  virtual void arc(const Position& from, const Arc& arc, const Move& move) = 0;
  virtual void spaceArc(const Position& from, const SpaceArc& arc, base::Vec3 targetMm,
                        const Move& move) = 0;
  virtual void spline(const Position& from, const Spline& spline, const Move& move) = 0;
  /// To a place whose way is not known: a fault has been reported.
  virtual void unknownWay(const Position& from, base::Vec3 targetMm, const Move& move) = 0;
  virtual void feed(double /*mmPerMin*/) {}
  virtual void machineWord(MachineWord /*kind*/, double /*value*/, base::LineNumber /*line*/) {}
  virtual void toolName(std::string_view /*name*/, base::LineNumber /*line*/) {}
  /// S1=2000, M1=3: a word of the spindle by its number.
  virtual void firstSpindle(char /*address*/, double /*value*/) {}
};

/// What is wrong, and what has no effect on the path.
class FaultSink {
 public:
  virtual ~FaultSink() = default;
  virtual void report(Severity severity, int column, FaultCode code, std::string argument) = 0;
  /// Of a value or of the order of blocks. @param column  of the word it belongs to
  virtual void fault(int column, const Fault& fault) = 0;
  void error(const Token& token, FaultCode code) { error(token, code, std::string(token.text)); }
  void error(const Token& token, FaultCode code, std::string argument) {
    report(Severity::Error, token.column, code, std::move(argument));
  }
  // Of each word without effect the first one may be worth a note.
  virtual void ignore(const Token& /*token*/, std::string /*word*/) {}
  virtual void ignoreG(int /*key*/, const Token& /*token*/) {}
  virtual void ignoreM(Severity /*severity*/, int /*number*/, const Token& /*token*/) {}
  virtual void ignoreLetter(const Token& /*token*/) {}
};

/// What the words say as they are written, whatever comes of it.
class WordObserver {
 public:
  virtual ~WordObserver() = default;
  /// @param g  0 to 3; -1 before any of them
  virtual void motion(int /*g*/, const AxisValues& /*axes*/) {}
  /// @param arc  plane, direction and turns
  virtual void arc(const AxisValues& /*axes*/, Arc /*arc*/, ArcWords /*words*/) {}
  virtual void machineMotion(int /*g*/, const AxisValues& /*axes*/) {}
  /// None of G0 to G3.
  virtual void otherMotion() {}
  virtual void feed(double /*value*/) {}
  virtual void units(bool /*inches*/) {}
  /// Where the axis (nothing: all) stands in the program's coordinates is not known any more.
  virtual void forget(std::optional<std::size_t> /*axis*/) {}
  void foreignMotion() {
    otherMotion();
    forget(std::nullopt);
  }
};

struct Sinks {
  PathSink& path;
  FaultSink& faults;
  WordObserver& words;
};

}  // namespace rivulet::nc
