// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The cost of variable access in wall time. The library's callbacks see single variables, not
/// the request they belong to; so a request begins with the first variable after an answer was
/// sent, and ends when the next message is sent.
/// @threadsafety one object, one thread at a time, but for the counters.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "base/instant.h"
#include "machine/machine.h"
#include "opcua/open62541/monotonic_clock.h"

namespace rivulet::machine {

class VariableService {
 public:
  /// What a request and its answer take beside the service on the loopback of a PC, both programs
  /// asleep in between (measured: single accesses took 0.5 ms longer than the model). It is part
  /// of the presets' overheads.
  static constexpr base::Duration kOnTheWay = std::chrono::microseconds{500};

  /// Machine time goes on from where the machine stands, beginning now.
  explicit VariableService(Machine& machine);

  /// Accesses cost nothing before this: the library reads every variable while it is created.
  void goLive() { m_live = true; }
  [[nodiscard]] Machine& machine() const { return m_machine; }

  /// Moves the machine to the present.
  void advance();
  /// Waits until the next variable of the present request is served and moves the machine to
  /// that moment; the caller reads or writes there.
  void serve(AccessKind kind);
  /// Waits until a program of this size is written, a request of its own.
  void serveProgram(std::size_t bytes);
  /// The present request is complete; the next variable belongs to another one.
  void endRequest() { m_request.reset(); }

  [[nodiscard]] std::uint64_t requestsServed() const { return m_requests.load(); }
  [[nodiscard]] std::uint64_t nodesServed() const { return m_nodes.load(); }

 private:
  [[nodiscard]] base::Instant now() const { return m_clock.now() + m_offset; }

  Machine& m_machine;
  opcua::MonotonicClock m_clock;
  base::Duration m_offset;  ///< machine time when the clock was started
  bool m_live = false;
  std::optional<AccessKind> m_request;  ///< kind of the request being served
  std::atomic<std::uint64_t> m_requests{0};
  std::atomic<std::uint64_t> m_nodes{0};
};

}  // namespace rivulet::machine
