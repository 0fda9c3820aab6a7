// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sources/socket_source.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>

#include "live/error.h"
#include "platform/input.h"
#include "platform/port_owner.h"

namespace rivulet::sources {

namespace {

using base::Result;
using SourcePtr = std::unique_ptr<live::Source>;

constexpr std::size_t kDatagramMax = 65'536;
constexpr std::string_view kTaken = "{\"error\":\"Another sender has this source.\"}\n";
/// For bursts: the run looks every few milliseconds.
constexpr int kDatagramBuffer = 4 << 20;
/// A sender that hears the end closes its side within this time.
constexpr int kGoodbyeMs = 200;
/// One that goes on sending is not waited for any longer.
constexpr std::chrono::seconds kGoodbyeMost{1};

Result<Descriptor> cannotOpen(const std::string& name) {
  return base::fail(
      live::LiveError::NotOpened,
      fmt::format("The source cannot be opened: {}. Choose another address.", std::strerror(errno)),
      name);
}

/// @param type  SOCK_STREAM, SOCK_DGRAM @param port  receives the one that was taken
Result<Descriptor> bindLoopback(int type, int& port, const std::string& name) {
  Descriptor socket(::socket(AF_INET, type | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!socket.isOpen()) {
    return cannotOpen(name);
  }
  const int one = 1;
  if (type == SOCK_STREAM) {
    ::setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &one, sizeof one);
  } else {
    ::setsockopt(socket.number(), SOL_SOCKET, SO_RCVBUF, &kDatagramBuffer, sizeof kDatagramBuffer);
  }
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  socklen_t length = sizeof address;
  auto* const plain = reinterpret_cast<sockaddr*>(&address);
  if (::bind(socket.number(), plain, length) != 0 ||
      ::getsockname(socket.number(), plain, &length) != 0 ||
      (type == SOCK_STREAM && ::listen(socket.number(), 4) != 0)) {
    return cannotOpen(name);
  }
  port = ntohs(address.sin_port);
  return socket;
}

/// A socket whose program has died is in the way; anything else is not ours to remove.
void removeStale(const std::string& path, const sockaddr* address, socklen_t length) {
  struct stat found {};
  if (::lstat(path.c_str(), &found) != 0 || !S_ISSOCK(found.st_mode)) {
    return;
  }
  const Descriptor probe(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (::connect(probe.number(), address, length) != 0 && errno == ECONNREFUSED) {
    ::unlink(path.c_str());
  }
}

}  // namespace

Result<SourcePtr> StreamSocketSource::listenUnix(const std::string& path) {
  const std::string name = "unix:" + path;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path) {
    errno = ENAMETOOLONG;
    return base::fail(cannotOpen(name).error());
  }
  std::copy(path.begin(), path.end(), address.sun_path);
  const auto* const plain = reinterpret_cast<const sockaddr*>(&address);
  removeStale(path, plain, sizeof address);
  Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const mode_t before = ::umask(0077);
  const bool isBound = socket.isOpen() && ::bind(socket.number(), plain, sizeof address) == 0 &&
                       ::listen(socket.number(), 4) == 0;
  const int why = errno;
  ::umask(before);
  if (!isBound) {
    errno = why;
    return base::fail(cannotOpen(name).error());
  }
  return SourcePtr(new StreamSocketSource(name, std::move(socket), path));
}

Result<SourcePtr> StreamSocketSource::listenTcp(int port) {
  Result<Descriptor> socket = bindLoopback(SOCK_STREAM, port, fmt::format("tcp:{}", port));
  if (!socket) {
    return base::fail(socket.error());
  }
  return SourcePtr(new StreamSocketSource(fmt::format("tcp:{}", port), std::move(*socket), {}));
}

/// The last reply is lost if lines of the sender are left unread: they are read, for a short time.
void StreamSocketSource::sayGoodbye() {
  ::shutdown(m_sender.number(), SHUT_WR);
  std::array<char, kDatagramMax> bytes;
  const auto until = std::chrono::steady_clock::now() + kGoodbyeMost;
  while (std::chrono::steady_clock::now() < until) {
    pollfd asked{m_sender.number(), POLLIN, 0};
    if (::poll(&asked, 1, kGoodbyeMs) <= 0 ||
        ::read(m_sender.number(), bytes.data(), bytes.size()) <= 0) {
      return;
    }
  }
}

StreamSocketSource::~StreamSocketSource() {
  if (m_sender.isOpen()) {
    sayGoodbye();
  }
  if (!m_path.empty()) {
    ::unlink(m_path.c_str());
  }
}

void StreamSocketSource::accept() {
  Descriptor caller(::accept4(m_listener.number(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
  if (!caller.isOpen()) {
    return;
  }
  if (m_sender.isOpen() || m_isClosed) {
    sendNow(caller.number(), std::string(kTaken));
    return;
  }
  const int one = 1;  // a reply is of use at once; fails for UNIX sockets, which do not need it
  ::setsockopt(caller.number(), IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
  m_sender = std::move(caller);
}

std::size_t StreamSocketSource::read(std::span<char> into) {
  accept();
  if (!m_sender.isOpen() || m_isClosed) {
    return 0;
  }
  const platform::Input read = platform::readNow(m_sender.number(), into);
  m_isClosed = read.isAtEnd || read.isBroken;
  return read.bytes;
}

void StreamSocketSource::tell(const live::Progress& progress) {
  // What it has sent before it closed its side is still to be read.
  m_isDeaf = !sendNow(m_sender.number(), live::progressLine(progress));
}

Result<SourcePtr> DatagramSource::listen(int port) {
  Result<Descriptor> socket = bindLoopback(SOCK_DGRAM, port, fmt::format("udp:{}", port));
  if (!socket) {
    return base::fail(socket.error());
  }
  return SourcePtr(new DatagramSource(fmt::format("udp:{}", port), std::move(*socket)));
}

bool DatagramSource::isSender(std::uint16_t port) {
  if (m_sender == 0 && port != 0 && !platform::isPortOfAnother(platform::PortKind::Udp, port)) {
    m_sender = port;
  }
  return m_sender != 0 && port == m_sender;
}

std::size_t DatagramSource::read(std::span<char> into) {
  // Others may send as much as they want: each look takes a few of theirs.
  constexpr int kStrangersMax = 100;
  for (int i = 0; m_rest.empty() && i < kStrangersMax; ++i) {
    sockaddr_in from{};
    socklen_t length = sizeof from;
    auto* const plain = reinterpret_cast<sockaddr*>(&from);
    m_rest.resize(kDatagramMax);
    const ssize_t count =
        ::recvfrom(m_socket.number(), m_rest.data(), m_rest.size(), MSG_DONTWAIT, plain, &length);
    m_rest.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    if (count < 0) {
      break;
    }
    const std::uint16_t port = ntohs(from.sin_port);
    if (!isSender(port)) {
      m_rest.clear();
      if (m_sender != 0 && port != m_refused) {
        m_refused = port;
        ::sendto(m_socket.number(), kTaken.data(), kTaken.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
                 plain, length);
      }
      continue;
    }
    if (!m_rest.empty() && m_rest.back() != '\n') {
      m_rest += '\n';
    }
  }
  const std::size_t count = std::min(into.size(), m_rest.size());
  std::copy_n(m_rest.begin(), count, into.begin());
  m_rest.erase(0, count);
  return count;
}

}  // namespace rivulet::sources
