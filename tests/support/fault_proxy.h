// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A TCP proxy on 127.0.0.1 with faults, between a client and a server that are both real. It
/// passes bytes on until a fault begins. A fault is a value, drawn from a seed, so that every run
/// can be repeated; only the moments depend on the computer.
/// @threadsafety construct, `begin` and the counters from any thread; it works on a thread of its
/// own.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "base/instant.h"
#include "base/random.h"
#include "opcua/open62541/monotonic_clock.h"

namespace rivulet::tests {

enum class FaultKind {
  None,
  Delay,           ///< everything arrives later, in both directions
  Jitter,          ///< every piece is delayed differently; the order is kept
  Stall,           ///< nothing is passed on
  Cut,             ///< both connections are closed
  Reset,           ///< both connections are reset
  Truncate,        ///< half a piece is passed on, then both connections are closed
  FlipRequest,     ///< one bit of a request is inverted
  FlipAnswer,      ///< one bit of an answer is inverted
  Duplicate,       ///< a piece is passed on twice
  HalfOpen,        ///< the server sees the end; the client hears nothing any more
  AcceptAndClose,  ///< all connections are closed, and every new one as soon as it is accepted
  Echo,            ///< the client gets back what it sends
  Count,
};

/// "none", "delay", …
[[nodiscard]] std::string_view faultName(FaultKind kind);

struct NetworkFault {
  FaultKind kind = FaultKind::None;
  base::Duration after{};  ///< from `begin` on
  /// Delay, Jitter, Stall, AcceptAndClose: then everything is as before.
  base::Duration duration{};
  base::Duration delay{};          ///< Delay: of each direction; Jitter: at most
  bool isTowardsServer = false;    ///< Truncate, Duplicate: which direction
  double place = 0.0;              ///< FlipRequest, FlipAnswer: 0 to 1, where in the piece
  std::optional<std::size_t> bit;  ///< the same, counted from the first of the piece
  std::uint64_t seed = 1;          ///< of what is drawn meanwhile
};

/// @param afterMax  the fault begins before that
[[nodiscard]] NetworkFault drawNetworkFault(std::uint64_t seed, base::Duration afterMax);

class FaultProxy {
 public:
  /// Listens from here on. @param server  "opc.tcp://127.0.0.1:PORT", or empty: nobody, for faults
  /// that need no server  @param oneWay  delay of each direction, always
  explicit FaultProxy(const std::string& server, base::Duration oneWay = {});
  ~FaultProxy();
  FaultProxy(const FaultProxy&) = delete;
  FaultProxy& operator=(const FaultProxy&) = delete;

  /// "opc.tcp://127.0.0.1:PORT" of the proxy.
  [[nodiscard]] const std::string& endpoint() const { return m_endpoint; }
  /// From now on this fault, in place of any other; what has been broken stays broken.
  void begin(const NetworkFault& fault);
  /// Connections accepted so far.
  [[nodiscard]] std::uint64_t connections() const { return m_accepted.load(); }
  /// Pieces of the clients' requests passed on so far.
  [[nodiscard]] std::uint64_t requests() const { return m_requests.load(); }
  /// True once the fault has done its work or, if it has a duration, has begun.
  [[nodiscard]] bool hasStruck() const { return m_struck.load(); }

 private:
  struct Piece {
    base::Instant due;
    std::string bytes;
  };
  struct Pipe {
    std::deque<Piece> pieces;
    bool isAtEnd = false;  ///< the sender has closed
  };
  struct Connection {
    int client = -1;
    int server = -1;
    Pipe toServer;
    Pipe toClient;
    bool isEcho = false;
    bool isDead = false;  ///< the client hears nothing any more
    bool isOver = false;
  };

  void work();
  void accept();
  void openConnection(int client);
  void pollOnce();
  /// Reads what has arrived, and puts it into the pipe with its delay and its fault.
  void take(Connection& connection, bool fromClient);
  /// Passes on what is due.
  void pass(Connection& connection, bool towardsServer);
  /// The fault, if it is in effect now.
  [[nodiscard]] std::optional<FaultKind> active();
  void strike();
  void alter(Connection& connection, std::string& bytes, bool towardsServer);
  static void close(Connection& connection, bool reset);
  [[nodiscard]] base::Duration delayNow();

  opcua::MonotonicClock m_clock;
  base::Duration m_oneWay;
  int m_listener = -1;
  std::uint16_t m_serverPort = 0;
  std::string m_endpoint;
  std::mutex m_mutex;  ///< held to hand over a fault
  std::optional<NetworkFault> m_next;
  NetworkFault m_fault;
  base::Instant m_begunAt{};
  base::Random m_random{1};
  std::vector<std::unique_ptr<Connection>> m_connections;
  std::atomic<bool> m_struck{false};
  std::atomic<std::uint64_t> m_accepted{0};
  std::atomic<std::uint64_t> m_requests{0};
  std::atomic<bool> m_stop{false};
  std::thread m_thread;
};

}  // namespace rivulet::tests
