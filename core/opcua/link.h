// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The only access to a control. A real connection (`opcua/open62541`) and the simulated one
/// (`streaming/simulation`) implement the same two interfaces; nothing else in Rivulet knows which
/// it has.
/// @threadsafety one object, one thread at a time.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/id.h"
#include "base/instant.h"
#include "base/result.h"
#include "opcua/error.h"
#include "opcua/grouping.h"
#include "opcua/server_identity.h"
#include "opcua/variable.h"
#include "trace/control_trace.h"
#include "trace/trace_piece.h"

namespace rivulet::opcua {

enum class EventKind {
  ReadDone,
  WriteDone,
  TraceDone,
  RequestFailed,   ///< this request; `error` says why; the connection may go on
  ConnectionLost,  ///< everything outstanding has failed; nothing is retried by the link
};

struct Event {
  EventKind kind = EventKind::ReadDone;
  base::RequestId request;
  base::Instant sent{};
  base::Instant at{};                                ///< when the answer arrived
  std::vector<Reading> readings;                     ///< ReadDone: one per variable, in order
  std::vector<std::error_code> statuses;             ///< WriteDone: one per assignment, in order
  base::Error error;                                 ///< RequestFailed, ConnectionLost
  std::shared_ptr<const trace::TracePiece> trace{};  ///< TraceDone
};

/// A connection whose other side is silent for longer, although it was asked, is lost. The same
/// holds for this side: nothing moves again without an operator.
inline constexpr base::Duration kSilenceMax = std::chrono::seconds(10);

/// Asynchronous variable access. Requests are served in order; several may be outstanding.
class Link {
 public:
  virtual ~Link() = default;

  /// The link's clock: wall time for a real link, virtual time for the simulated one.
  [[nodiscard]] virtual base::Instant now() const = 0;

  /// Sends a read. @param deadline from now on; passed: RequestFailed with DeadlineExceeded
  virtual base::RequestId read(std::span<const Variable> variables, base::Duration deadline,
                               Grouping grouping) = 0;

  /// Sends a write. Items are executed in order; the group is not atomic. A value that is not
  /// finite fails the whole request (BadValue) before anything is sent.
  virtual base::RequestId write(std::span<const Assignment> assignments, base::Duration deadline,
                                Grouping grouping) = 0;

  /// Writes a program over one of the same name while a stream runs: WriteDone, without statuses.
  /// Names end in MPF (part programs) or SPF (subprograms).
  virtual base::RequestId store(const std::string& name, const std::string& text,
                                base::Duration deadline) = 0;

  /// Asks for the next part of the control's own trace while a stream runs: TraceDone. What lies
  /// before `from` may be forgotten by the control.
  /// @return 0 if the control gives its trace only as a whole, after the run
  virtual base::RequestId readTrace(const trace::TracePosition& /*from*/,
                                    base::Duration /*deadline*/) {
    return {};
  }

  /// The next event; waits no longer than `until`. @return nothing if that time has come
  virtual std::optional<Event> wait(base::Instant until) = 0;

  /// How long the other side has been silent although it was asked something; zero if every request
  /// has been answered, be it late.
  [[nodiscard]] virtual base::Duration silence() const { return {}; }
};

enum class SelectStatus {
  Done = 0,
  NoSuchChannel = 1,
  NoSuchProgram = 2,
  NotInReset = 3,
  Rejected = 4
};

/// What a control lets a client do beside variables and programs.
struct Abilities {
  bool startsOnRequest = false;  ///< `cycleStart` and `reset`; else the operator presses the keys
  bool keepsTrace = false;       ///< `fetchTrace`: what it executed, and where the axes were
};

/// Commands outside the stream. Each call blocks up to its deadline and must not be made while
/// a stream runs (except `reset`).
class Control {
 public:
  virtual ~Control() = default;

  /// Writes a part program into "Part Program" of the control. @param name e.g. "A.MPF"
  virtual base::Result<void> uploadProgram(const std::string& name, const std::string& text,
                                           bool overwrite) = 0;
  /// Text of a part program on the control. @return ProgramMissing, MethodMissing, ...
  virtual base::Result<std::string> downloadProgram(const std::string& name) = 0;
  /// Selects a part program in channel 1; it does not start.
  virtual base::Result<void> selectProgram(const std::string& name) = 0;

  /// Which server this is; empty if there is none, as in virtual time.
  virtual base::Result<ServerIdentity> identity() { return ServerIdentity{}; }

  /// The rights that the server says this user has, as it names them, separated by semicolons.
  /// @return MethodMissing if it does not tell
  virtual base::Result<std::string> accessRights() {
    return base::fail(LinkError::MethodMissing, "The server does not tell the rights of a user.");
  }
  /// Whether this user may write a variable, as the server says; nothing is written.
  /// @return the error of the request
  virtual base::Result<bool> mayWrite(const Variable& /*variable*/) { return true; }

  /// True if no real axis moves. Use it only for messages and confirmations; a run asks for the
  /// abilities instead.
  [[nodiscard]] virtual bool isVirtualMachine() const = 0;
  [[nodiscard]] virtual Abilities abilities() const = 0;
  virtual base::Result<void> cycleStart() = 0;
  virtual base::Result<void> reset() = 0;
  /// The control's own trace of the last run, as far as it still has it.
  virtual base::Result<trace::ControlTrace> fetchTrace() = 0;
  /// The part of it that follows `from`; the same as `Link::readTrace`, after the stream.
  virtual base::Result<trace::TracePiece> fetchTracePiece(const trace::TracePosition& from);
};

}  // namespace rivulet::opcua
