// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "support/fault_proxy.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "base/contract.h"

namespace rivulet::tests {

namespace {

using base::Duration;
using base::Instant;
using std::chrono::milliseconds;

/// New faults and the end are noticed this often.
constexpr int kPollMsMax = 5;
constexpr std::size_t kPieceBytesMax = 65'536;

constexpr std::array<std::string_view, static_cast<std::size_t>(FaultKind::Count)> kNames{
    "none",     "delay",        "jitter",      "stall",     "cut",       "reset",
    "truncate", "flip-request", "flip-answer", "duplicate", "half-open", "accept-and-close",
    "echo"};

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  return address;
}

void setNoDelay(int socket) {
  const int yes = 1;
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
}

bool hasDuration(FaultKind kind) {
  return kind == FaultKind::Delay || kind == FaultKind::Jitter || kind == FaultKind::Stall ||
         kind == FaultKind::AcceptAndClose;
}

}  // namespace

std::string_view faultName(FaultKind kind) {
  return kNames.at(static_cast<std::size_t>(kind));
}

NetworkFault drawNetworkFault(std::uint64_t seed, Duration afterMax) {
  base::Random random(seed);
  constexpr auto kKinds = static_cast<std::uint64_t>(FaultKind::Count) - 1;
  NetworkFault fault;
  fault.kind = static_cast<FaultKind>(1 + random.below(kKinds));
  fault.after = base::fromSeconds(base::toSeconds(afterMax) * random.uniform());
  fault.duration = base::fromSeconds(10.0 * random.uniform());
  fault.delay = base::fromSeconds((fault.kind == FaultKind::Jitter ? 1.0 : 5.0) * random.uniform());
  fault.isTowardsServer = random.below(2) == 0;
  fault.place = random.uniform();
  fault.seed = random.bits();
  return fault;
}

FaultProxy::FaultProxy(const std::string& server, Duration oneWay) : m_oneWay(oneWay) {
  if (!server.empty()) {
    m_serverPort = static_cast<std::uint16_t>(std::stoi(server.substr(server.rfind(':') + 1)));
  }
  m_listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = loopback(0);
  RIVULET_ASSERT(bind(m_listener, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
  RIVULET_ASSERT(listen(m_listener, SOMAXCONN) == 0);
  socklen_t length = sizeof address;
  RIVULET_ASSERT(getsockname(m_listener, reinterpret_cast<sockaddr*>(&address), &length) == 0);
  m_endpoint = fmt::format("opc.tcp://127.0.0.1:{}", ntohs(address.sin_port));
  m_thread = std::thread([this] { work(); });
}

FaultProxy::~FaultProxy() {
  m_stop.store(true);
  m_thread.join();
  for (const auto& connection : m_connections) {
    close(*connection, false);
  }
  ::close(m_listener);
}

void FaultProxy::begin(const NetworkFault& fault) {
  const std::lock_guard lock(m_mutex);
  m_next = fault;
  m_struck.store(false);
}

void FaultProxy::work() {
  while (!m_stop.load()) {
    {
      const std::lock_guard lock(m_mutex);
      if (m_next) {
        m_fault = *m_next;
        m_next.reset();
        m_begunAt = m_clock.now();
        m_random = base::Random(m_fault.seed);
      }
    }
    strike();
    pollOnce();
    for (const auto& connection : m_connections) {
      pass(*connection, true);
      pass(*connection, false);
    }
    std::erase_if(m_connections, [](const auto& connection) { return connection->isOver; });
  }
}

std::optional<FaultKind> FaultProxy::active() {
  const Duration since = m_clock.now() - m_begunAt;
  if (m_fault.kind == FaultKind::None || since < m_fault.after) {
    return std::nullopt;
  }
  if (hasDuration(m_fault.kind)) {
    m_struck.store(true);
    if (since >= m_fault.after + m_fault.duration) {
      return std::nullopt;
    }
  }
  return m_fault.kind;
}

/// The faults of whole connections; those of single pieces are in `alter`.
void FaultProxy::strike() {
  const std::optional<FaultKind> kind = active();
  if (!kind) {
    return;
  }
  const bool once = !m_struck.load();
  for (const auto& connection : m_connections) {
    if (*kind == FaultKind::AcceptAndClose ||
        (once && (*kind == FaultKind::Cut || *kind == FaultKind::Reset))) {
      close(*connection, *kind == FaultKind::Reset);
    } else if (once && *kind == FaultKind::HalfOpen) {
      ::close(connection->server);
      connection->server = -1;
      connection->isDead = true;
    } else if (*kind == FaultKind::Echo) {
      connection->isEcho = true;
    }
  }
  if (*kind == FaultKind::Cut || *kind == FaultKind::Reset || *kind == FaultKind::HalfOpen ||
      *kind == FaultKind::Echo) {
    m_struck.store(true);
  }
}

void FaultProxy::accept() {
  const int client = accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC);
  if (client < 0) {
    return;
  }
  ++m_accepted;
  if (active() == FaultKind::AcceptAndClose) {
    ::close(client);
    return;
  }
  openConnection(client);
}

void FaultProxy::openConnection(int client) {
  auto connection = std::make_unique<Connection>();
  setNoDelay(client);
  connection->client = client;
  connection->isEcho = active() == FaultKind::Echo;
  if (m_serverPort != 0) {
    connection->server = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = loopback(m_serverPort);
    if (connect(connection->server, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
      close(*connection, true);
      return;
    }
    setNoDelay(connection->server);
  }
  m_connections.push_back(std::move(connection));
}

void FaultProxy::pollOnce() {
  const bool stalled = active() == FaultKind::Stall;
  std::vector<pollfd> polled{{m_listener, POLLIN, 0}};
  std::vector<std::pair<Connection*, bool>> sources;
  Duration wait = milliseconds{kPollMsMax};
  for (const auto& connection : m_connections) {
    for (const bool fromClient : {true, false}) {
      const int socket = fromClient ? connection->client : connection->server;
      const Pipe& pipe = fromClient ? connection->toServer : connection->toClient;
      if (socket >= 0 && !pipe.isAtEnd && !stalled) {
        polled.push_back({socket, POLLIN, 0});
        sources.emplace_back(connection.get(), fromClient);
      }
      if (!pipe.pieces.empty()) {
        wait = std::min(wait, pipe.pieces.front().due - m_clock.now());
      }
    }
  }
  wait = std::max(wait, stalled ? Duration{milliseconds{1}} : Duration{});
  const timespec timeout{0, static_cast<long>(wait.count())};
  if (ppoll(polled.data(), polled.size(), &timeout, nullptr) <= 0) {
    return;
  }
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto [connection, fromClient] = sources[i];
    if (polled[i + 1].revents != 0 && !connection->isOver) {
      take(*connection, fromClient);
    }
  }
  if (polled.front().revents != 0) {
    accept();
  }
}

Duration FaultProxy::delayNow() {
  switch (active().value_or(FaultKind::None)) {
    case FaultKind::Delay:
      return m_oneWay + m_fault.delay;
    case FaultKind::Jitter:
      return m_oneWay + base::fromSeconds(base::toSeconds(m_fault.delay) * m_random.uniform());
    default:
      return m_oneWay;
  }
}

void FaultProxy::take(Connection& connection, bool fromClient) {
  std::string bytes(kPieceBytesMax, '\0');
  const int socket = fromClient ? connection.client : connection.server;
  const ssize_t count = recv(socket, bytes.data(), bytes.size(), MSG_DONTWAIT);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) {
    return;
  }
  Pipe& pipe = fromClient ? connection.toServer : connection.toClient;
  if (count <= 0) {
    pipe.isAtEnd = true;
    return;
  }
  bytes.resize(static_cast<std::size_t>(count));
  m_requests += fromClient ? 1 : 0;
  if (connection.isDead) {
    return;
  }
  if (connection.isEcho) {
    if (fromClient) {
      connection.toClient.pieces.push_back({m_clock.now(), std::move(bytes)});
    }
    return;
  }
  // What was sent first arrives first, whatever the delays are.
  const Instant earliest = pipe.pieces.empty() ? Instant{} : pipe.pieces.back().due;
  pipe.pieces.push_back({std::max(earliest, m_clock.now() + delayNow()), std::move(bytes)});
}

void FaultProxy::alter(Connection& connection, std::string& bytes, bool towardsServer) {
  const std::optional<FaultKind> kind = active();
  if (!kind || m_struck.load()) {
    return;
  }
  if (*kind == (towardsServer ? FaultKind::FlipRequest : FaultKind::FlipAnswer)) {
    const auto bits = static_cast<double>(8 * bytes.size());
    const std::size_t bit = std::min(
        m_fault.bit.value_or(static_cast<std::size_t>(m_fault.place * bits)), 8 * bytes.size() - 1);
    bytes[bit / 8] = static_cast<char>(static_cast<unsigned char>(bytes[bit / 8]) ^
                                       (1U << static_cast<unsigned>(bit % 8)));
    m_struck.store(true);
  } else if (m_fault.isTowardsServer == towardsServer) {
    if (*kind == FaultKind::Duplicate) {
      bytes += bytes;
      m_struck.store(true);
    } else if (*kind == FaultKind::Truncate) {
      bytes.resize(bytes.size() / 2);
      m_struck.store(true);
      Pipe& pipe = towardsServer ? connection.toServer : connection.toClient;
      pipe.isAtEnd = true;
      while (pipe.pieces.size() > 1) {
        pipe.pieces.pop_back();
      }
    }
  }
}

void FaultProxy::pass(Connection& connection, bool towardsServer) {
  if (connection.isOver || active() == FaultKind::Stall) {
    return;
  }
  Pipe& pipe = towardsServer ? connection.toServer : connection.toClient;
  const int socket = towardsServer ? connection.server : connection.client;
  while (!pipe.pieces.empty() && pipe.pieces.front().due <= m_clock.now()) {
    if (!connection.isEcho) {
      alter(connection, pipe.pieces.front().bytes, towardsServer);
    }
    std::string& bytes = pipe.pieces.front().bytes;
    const ssize_t count =
        socket < 0 ? static_cast<ssize_t>(bytes.size())
                   : send(socket, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count < 0) {
      if (errno == EAGAIN || errno == EINTR) {
        return;
      }
      pipe.isAtEnd = true;
      pipe.pieces.clear();
      break;
    }
    bytes.erase(0, static_cast<std::size_t>(count));
    if (!bytes.empty()) {
      return;
    }
    pipe.pieces.pop_front();
  }
  if (pipe.isAtEnd && pipe.pieces.empty()) {
    close(connection, false);
  }
}

void FaultProxy::close(Connection& connection, bool reset) {
  for (int* socket : {&connection.client, &connection.server}) {
    if (*socket < 0) {
      continue;
    }
    if (reset) {
      const linger hard{1, 0};
      setsockopt(*socket, SOL_SOCKET, SO_LINGER, &hard, sizeof hard);
    }
    ::close(*socket);
    *socket = -1;
  }
  connection.isOver = true;
}

}  // namespace rivulet::tests
