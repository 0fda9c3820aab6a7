// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A streaming method as a state machine without I/O. The driver drains `poll` after every
/// `handle`, performs the action on a link and passes the answer back. Nothing here knows whether
/// the control is real or reads a clock: every call gets `now`.
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
#include "live/point_supplier.h"
#include "opcua/link.h"
#include "streaming/methods/pause_placement.h"
#include "streaming/run/run.h"
#include "templates/cells.h"

namespace rivulet::templates {
class MethodTemplate;
}  // namespace rivulet::templates

namespace rivulet::streaming {

/// One access a method asks for. The spans stay valid until the answer has been handled.
struct Action {
  enum class Kind { Read, Write, Store } kind = Kind::Read;
  std::span<const opcua::Variable> variables;      ///< Read
  std::span<const opcua::Assignment> assignments;  ///< Write
  std::size_t points = 0;                          ///< points of the program in this write
  std::string_view name = {};                      ///< Store: of the program
  std::string_view text = {};                      ///< Store
};

/// The answer to the last action.
struct Answer {
  base::Instant sent{};
  base::Instant at{};
  std::span<const opcua::Reading> readings;  ///< Read; empty for a write
};

/// Times that a method expects.
enum class Expectation {
  Access,    ///< the next access is not needed before; stopped: none is needed
  Progress,  ///< later progress means something is slower than planned; stopped: none is expected
  Points,    ///< when the axes run out of delivered points; stopped: not known
  Poll,      ///< when `poll` is to be asked again although nothing has happened
  Count,
};

/// The state of a method, as seen from outside.
struct Progress {
  std::size_t executed = 0;                   ///< points known to be passed
  std::size_t stopsPassed = 0;                ///< STOPREs of the template known to be passed
  std::size_t brokenSignals = 0;              ///< signals out of sequence: a window was missed
  std::optional<base::Instant> lastProgress;  ///< nothing: the stream has not begun
  base::TimerTable<Expectation> expected;
  bool hasNothingToBring =
      false;                 ///< methods with windows: everything that the control accepts is there
  bool allSent = false;      ///< every point is on the control
  bool granted = false;      ///< methods with windows: the control obeys this run
  bool stopWritten = false;  ///< the program on the control has been commanded to end
};

class Method {
 public:
  virtual ~Method() = default;

  /// The next access; nothing while an answer is outstanding or there is nothing left to do.
  /// The order is: cells of the first N points, then `run`, then the stream. Method window asks for
  /// the cells first.
  [[nodiscard]] virtual std::optional<Action> poll(base::Instant now) = 0;

  /// Exactly one call per action.
  virtual void handle(const Answer& answer, base::Instant now) = 0;

  /// Instead of `handle`: no answer arrived in time; the request may or may not have been carried
  /// out. @return true if the method repeats the request; false: the stream must be abandoned
  virtual bool answerLost(base::Instant /*now*/) { return false; }

  /// Why the stream must end without another write; nothing while all is well.
  [[nodiscard]] virtual std::optional<base::Error> failure() const { return std::nullopt; }

  /// Method window: the machine is to wait before the next window, or to continue.
  virtual void requestHold(bool /*hold*/) {}

  /// The operator wants the program to end after the loop or window it is in. Refilling continues
  /// until the control has left the loop, so that it passes only new points. (Method window
  /// delivers nothing more: its control waits by itself.)
  virtual void requestStop() = 0;

  [[nodiscard]] virtual const Progress& progress() const = 0;

  /// Tool position in the last answer, if the method reads it anyway.
  [[nodiscard]] virtual std::optional<base::Vec3> positionMm() const { return std::nullopt; }
  /// True if it does; the driver reads no position for the display then.
  [[nodiscard]] virtual bool readsPosition() const { return false; }

  /// True if the machine waits when the client is late: a missing answer does no harm.
  [[nodiscard]] virtual bool waitsForClient() const = 0;
  /// What the control does without its client, and what the user should do; in English.
  [[nodiscard]] virtual std::string_view adviceWhenLost() const = 0;
  /// Why there may be no progress, and what the user should do; in English.
  [[nodiscard]] virtual std::string_view adviceWhenStalled() const = 0;
};

/// Input of every method.
struct MethodSetup {
  std::vector<gcode::StreamPoint> points;  ///< at least one; with a supplier none
  base::Vec3 startMm;                      ///< the tool's position before the run, workpiece frame
  templates::CellMap cells;
  RunSettings settings;
  base::RotaryDeg startDeg{};  ///< the same of A, B, C
  /// Where a method with windows pulls them from, and whom it tells how far the run is. Null: they
  /// are made of `points`.
  live::PointSupplier* supplier = nullptr;
};

/// How a program ended and how far it came, according to its cells.
struct ProgramEnd {
  std::optional<std::size_t> executed;  ///< points of this run; nothing: not known
  std::optional<std::size_t> windows;   ///< the same, windows
  bool isStopped = false;               ///< it ended because its client asked for it
  bool isKnown = false;                 ///< its cells could be read
  bool isDone = false;                  ///< it reached its end
  base::Error error;                    ///< why it ended; code clear: nothing was wrong
};

/// What a job needs of a method before and after the stream. One per method, next to the method in
/// `methods/`; `methodType` registers them. @threadsafety no state.
class MethodType {
 public:
  MethodType() = default;
  MethodType(const MethodType&) = delete;
  MethodType& operator=(const MethodType&) = delete;
  virtual ~MethodType() = default;

  [[nodiscard]] virtual std::unique_ptr<Method> make(MethodSetup setup) const = 0;

  /// Completes the settings that the user leaves open. @param entropy  of this run
  virtual void complete(RunSettings& /*settings*/, std::uint64_t /*entropy*/) const {}

  /// Points at whose end the axes stop between windows or loops, in order.
  /// @param pointsPerLoop N, >= 1, points per loop or window  @param cut  see `cutWindows`
  [[nodiscard]] virtual std::vector<std::size_t> pausesBefore(
      std::span<const gcode::StreamPoint> points, std::size_t pointsPerLoop,
      WindowCut cut) const = 0;

  /// What is needed to resume a run later; nothing: this method cannot be resumed.
  [[nodiscard]] virtual std::optional<Checkpoint> checkpoint(const RunSettings& /*settings*/,
                                                             const Resume& /*from*/) const {
    return std::nullopt;
  }
  /// Windows that the program may have copied but not executed; 0: this method has none.
  [[nodiscard]] virtual int windowsTakenMax(
      const templates::TemplateParameters& /*parameters*/) const {
    return 0;
  }
  /// Asks a program that has ended for its result. Nothing: it cannot report one.
  [[nodiscard]] virtual std::optional<ProgramEnd> askEnd(
      opcua::Link& /*link*/, const templates::CellMap& /*cells*/, const RunSettings& /*settings*/,
      std::span<const gcode::StreamPoint> /*points*/) const {
    return std::nullopt;
  }
};

[[nodiscard]] const MethodType& methodType(base::MethodKind method);

/// Adds a method: what is known of it, its program on the control, its client. They have to last.
/// Before the first run, on one thread. @return its kind
base::MethodKind registerMethod(const base::MethodTraits& traits,
                                const templates::MethodTemplate& program, const MethodType& type);

}  // namespace rivulet::streaming
