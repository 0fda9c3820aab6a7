// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A streaming method as a state machine without I/O. The driver drains `poll` after every
/// `handle`, performs what it gets on a link and feeds the answer back. Nothing here knows
/// whether the control is real, nor asks the time: every call is told `now`.
/// @threadsafety one object, one thread. No allocation between the first poll and the end.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/instant.h"
#include "base/timer_table.h"
#include "gcode/trajectory.h"
#include "opcua/link.h"
#include "streaming/run.h"
#include "templates/cells.h"

namespace rivulet::streaming {

/// One access a method asks for. The spans stay valid until the answer has been handled.
struct Action {
  enum class Kind { Read, Write, Store } kind = Kind::Read;
  std::span<const opcua::Variable> variables;      ///< Read
  std::span<const opcua::Assignment> assignments;  ///< Write
  std::size_t points = 0;                          ///< points of the program this write hands over
  std::string_view name = {};                      ///< Store: of the program
  std::string_view text = {};                      ///< Store
};

/// The answer to the action polled last.
struct Answer {
  base::Instant sent{};
  base::Instant at{};
  std::span<const opcua::Reading> readings;  ///< Read; empty for a write
};

/// What a method expects of the time to come.
enum class Expectation {
  Access,    ///< the next access is not needed before; stopped: none is needed
  Progress,  ///< later progress means something is slower than planned; stopped: none is expected
  Points,    ///< when the axes run out of delivered points; stopped: not known
  Count,
};

/// What a method tells the world.
struct Progress {
  std::size_t executed = 0;       ///< points known to be passed
  std::size_t stopsPassed = 0;    ///< STOPREs of the template known to be passed
  std::size_t brokenSignals = 0;  ///< signals that came out of turn: a window was missed
  std::optional<base::Instant> lastProgress;  ///< nothing: the stream has not begun
  base::TimerTable<Expectation> expected;
  bool hasNothingToBring = false;  ///< methods with windows: all the control takes is there
  bool allSent = false;            ///< every point is on the control
  bool granted = false;            ///< methods with windows: the control obeys this run
  bool stopWritten = false;        ///< the program on the control has been told to end
};

class Method {
 public:
  virtual ~Method() = default;

  /// The next access; nothing while an answer is outstanding or there is nothing left to do.
  /// The order is: cells of the first N points, then `run`, then the stream. Method window asks for
  /// the cells first.
  [[nodiscard]] virtual std::optional<Action> poll(base::Instant now) = 0;

  /// Exactly one call per action polled.
  virtual void handle(const Answer& answer, base::Instant now) = 0;

  /// In place of `handle`: no answer came in time, the request may or may not have been carried
  /// out. @return true if the method goes on and asks again; false: the stream is to be abandoned
  virtual bool answerLost(base::Instant /*now*/) { return false; }

  /// Why the stream must end without another write; nothing while all is well.
  [[nodiscard]] virtual std::optional<base::Error> failure() const { return std::nullopt; }

  /// Method window: the machine is to wait in front of the next window, or to go on.
  virtual void requestHold(bool /*hold*/) {}

  /// The operator wants the program to end after the loop or window it is in. Refilling goes on
  /// until the control has left the loop: what it still passes must be new points, never old ones.
  /// (Method window brings nothing more: its control waits by itself.)
  virtual void requestStop() = 0;

  [[nodiscard]] virtual const Progress& progress() const = 0;

  /// Tool position contained in the answer handled last, if the method reads it anyway.
  [[nodiscard]] virtual std::optional<base::Vec3> positionMm() const { return std::nullopt; }
  /// True if it does; the driver reads no position for the display then.
  [[nodiscard]] virtual bool readsPosition() const { return false; }

  /// True if the machine waits where the client is late: an answer that does not come is no harm.
  [[nodiscard]] virtual bool waitsForClient() const = 0;
  /// What the control does without its client, and what to do; for the user, in English.
  [[nodiscard]] virtual std::string_view adviceWhenLost() const = 0;
  /// Why there may be no progress, and what to do; for the user, in English.
  [[nodiscard]] virtual std::string_view adviceWhenStalled() const = 0;
};

/// What every method is made from.
struct MethodSetup {
  std::vector<gcode::StreamPoint> points;  ///< at least one
  base::Vec3 startMm;  ///< where the tool stands before the run, workpiece frame
  templates::CellMap cells;
  RunSettings settings;
  base::RotaryDeg startDeg{};  ///< the same of A, B, C
};

/// How a program ended and how far it came, in its own words.
struct ProgramEnd {
  std::optional<std::size_t> executed;  ///< points of this run; nothing: not known
  bool isKnown = false;                 ///< its cells could be read
  bool isDone = false;                  ///< it reached its end
  base::Error error;                    ///< why it ended; code clear: nothing was wrong
};

/// What a job has to know of a method before and after the stream. One per method, with the method
/// in `methods/`; `methodType` is where they are registered. @threadsafety no state.
class MethodType {
 public:
  MethodType() = default;
  MethodType(const MethodType&) = delete;
  MethodType& operator=(const MethodType&) = delete;
  virtual ~MethodType() = default;

  [[nodiscard]] virtual std::unique_ptr<Method> make(MethodSetup setup) const = 0;

  /// Fills in what the user leaves open. @param entropy  of this run
  virtual void complete(RunSettings& /*settings*/, std::uint64_t /*entropy*/) const {}

  /// Points at whose end the axes stand between windows or loops, in order.
  /// @param points N, >= 1, points per loop or window  @param place  see `cutWindows`
  [[nodiscard]] virtual std::vector<std::size_t> pausesBefore(
      std::span<const gcode::StreamPoint> points, std::size_t pointsPerLoop, bool place) const = 0;

  /// What a run needs to be resumed later; nothing: this method cannot be.
  [[nodiscard]] virtual std::optional<Checkpoint> checkpoint(const RunSettings& /*settings*/,
                                                             const Resume& /*from*/) const {
    return std::nullopt;
  }
  /// Windows the program may have taken and not executed; 0: this method has none.
  [[nodiscard]] virtual int windowsTakenMax(
      const templates::TemplateParameters& /*parameters*/) const {
    return 0;
  }
  /// Asks a program that has ended how it did. Nothing: it cannot say.
  [[nodiscard]] virtual std::optional<ProgramEnd> askEnd(
      opcua::Link& /*link*/, const templates::CellMap& /*cells*/, const RunSettings& /*settings*/,
      std::span<const gcode::StreamPoint> /*points*/) const {
    return std::nullopt;
  }
};

[[nodiscard]] const MethodType& methodType(base::MethodKind method);

}  // namespace rivulet::streaming
