// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The cost of variable access in wall time. The library's callbacks see single variables, not
/// the request they belong to; so a request begins with the first variable after an answer was
/// sent, and ends when the next message is sent.
/// @threadsafety one object, one thread at a time, except the counters.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "base/instant.h"
#include "machine/front/served_control.h"
#include "machine/machine.h"
#include "opcua/open62541/monotonic_clock.h"

namespace rivulet::machine {

class VariableService {
 public:
  /// Time of a request and its answer on the loopback of a PC, in addition to the service, with
  /// both programs asleep in between (measured: single accesses took 0.5 ms longer than the model).
  /// The presets' overheads include it.
  static constexpr base::Duration kOnTheWay = std::chrono::microseconds{500};

  /// The control's time continues now, from its present time.
  explicit VariableService(ServedControl& control);

  /// Before this, accesses cost nothing: the library reads every variable when it is created.
  void goLive() { m_live = true; }
  [[nodiscard]] ServedControl& control() const { return m_control; }

  /// Moves the control to the present.
  void advance();
  /// Waits until the next variable of the present request is served, and advances the machine to
  /// that moment; the caller then reads or writes.
  void serve(AccessKind kind);
  /// A program of this size is written, a request of its own. It takes time, but the variable
  /// service goes on meanwhile. @return when the answer is due
  [[nodiscard]] base::Instant serveProgram(std::size_t bytes);
  /// The present request is complete; the next variable belongs to another one.
  void endRequest() { m_request.reset(); }

  [[nodiscard]] std::uint64_t requestsServed() const { return m_requests.load(); }
  [[nodiscard]] std::uint64_t nodesServed() const { return m_nodes.load(); }

  /// Machine time, which is wall time.
  [[nodiscard]] base::Instant now() const { return m_clock.now() + m_offset; }

 private:
  ServedControl& m_control;
  opcua::MonotonicClock m_clock;
  base::Duration m_offset;  ///< machine time when the clock was started
  bool m_live = false;
  std::optional<AccessKind> m_request;  ///< kind of the request being served
  std::atomic<std::uint64_t> m_requests{0};
  std::atomic<std::uint64_t> m_nodes{0};
};

}  // namespace rivulet::machine
