// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cnc/program_input.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace rivulet::cnc {

namespace {

constexpr std::size_t kReadBytes = 1U << 16U;

std::string systemText() {
  return std::generic_category().message(errno);
}

void closeIf(int descriptor) {
  if (descriptor >= 0) {
    ::close(descriptor);
  }
}

}  // namespace

ProgramInput::ProgramInput(ProgramInput&& other) noexcept
    : m_listener(std::exchange(other.m_listener, -1)),
      m_input(std::exchange(other.m_input, -1)),
      m_port(other.m_port) {
}

ProgramInput::~ProgramInput() {
  closeIf(m_listener);
  closeIf(m_input);
}

base::Result<ProgramInput> ProgramInput::ofFile(const std::string& path) {
  ProgramInput input;
  input.m_input = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (input.m_input < 0) {
    return base::fail(std::error_code(errno, std::generic_category()),
                      fmt::format("The program cannot be read ({}). Check its name.", systemText()),
                      path);
  }
  return input;
}

base::Result<ProgramInput> ProgramInput::listen(std::uint16_t port) {
  ProgramInput input;
  input.m_listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int on = 1;
  ::setsockopt(input.m_listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  auto* const generic = reinterpret_cast<sockaddr*>(&address);
  if (input.m_listener < 0 || ::bind(input.m_listener, generic, length) != 0 ||
      ::listen(input.m_listener, 1) != 0 ||
      ::getsockname(input.m_listener, generic, &length) != 0) {
    return base::fail(
        std::error_code(errno, std::generic_category()),
        fmt::format("Port {} of 127.0.0.1 cannot be used ({}). Choose another one, or "
                    "0 for any that is free.",
                    port, systemText()));
  }
  input.m_port = ntohs(address.sin_port);
  return input;
}

std::optional<std::string> ProgramInput::read(base::Duration atMost) {
  pollfd wanted{m_input >= 0 ? m_input : m_listener, POLLIN, 0};
  const int timeoutMs = static_cast<int>(atMost / std::chrono::milliseconds{1});
  if (::poll(&wanted, 1, timeoutMs) <= 0) {
    return std::string();
  }
  if (m_input < 0) {
    m_input = ::accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC);
    return std::string();
  }
  std::array<char, kReadBytes> buffer{};
  const ssize_t bytes = ::read(m_input, buffer.data(), buffer.size());
  if (bytes < 0 && (errno == EINTR || errno == EAGAIN)) {
    return std::string();
  }
  if (bytes <= 0) {
    return std::nullopt;
  }
  return std::string(buffer.data(), static_cast<std::size_t>(bytes));
}

}  // namespace rivulet::cnc
