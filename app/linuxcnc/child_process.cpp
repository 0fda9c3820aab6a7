// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "linuxcnc/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <utility>

#include "base/contract.h"
#include "base/error.h"

extern char** environ;

namespace rivulet::linuxcnc {

namespace {

struct Pipe {
  int reading = -1;
  int writing = -1;
};

/// Its ends are not inherited by other children.
std::optional<Pipe> makePipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    return std::nullopt;
  }
  return Pipe{ends[0], ends[1]};
}

void makeNonBlocking(int file) {
  fcntl(file, F_SETFL, fcntl(file, F_GETFL) | O_NONBLOCK);
}

}  // namespace

std::error_code make_error_code(ProcessError code) {
  static const base::NamedCategory category("linuxcnc.process");
  return {static_cast<int>(code), category};
}

base::Result<ChildProcess> ChildProcess::start(const std::vector<std::string>& words) {
  RIVULET_ASSERT(!words.empty());
  const std::optional<Pipe> in = makePipe();
  const std::optional<Pipe> out = makePipe();
  if (!in || !out) {
    return base::fail(ProcessError::NotStarted, "Too many files are open.", words.front());
  }
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in->reading, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out->writing, STDOUT_FILENO);
  std::vector<char*> arguments;
  for (const std::string& word : words) {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }
  arguments.push_back(nullptr);
  pid_t pid = 0;
  const int status =
      posix_spawnp(&pid, words.front().c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(in->reading);
  close(out->writing);
  if (status != 0) {
    close(in->writing);
    close(out->reading);
    return base::fail(ProcessError::NotStarted,
                      fmt::format("{} cannot be started ({}).", words.front(),
                                  std::error_code(status, std::generic_category()).message()));
  }
  makeNonBlocking(in->writing);
  makeNonBlocking(out->reading);
  return ChildProcess(pid, in->writing, out->reading);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : m_pid(std::exchange(other.m_pid, -1)),
      m_input(std::exchange(other.m_input, -1)),
      m_output(std::exchange(other.m_output, -1)),
      m_arrived(std::move(other.m_arrived)),
      m_next(other.m_next),
      m_isAtEnd(other.m_isAtEnd) {
}

ChildProcess::~ChildProcess() {
  if (m_pid < 0) {
    return;
  }
  close(m_input);
  close(m_output);
  kill(m_pid, SIGTERM);
  waitpid(m_pid, nullptr, 0);
}

base::Result<void> ChildProcess::write(std::string_view line) {
  std::string text(line);
  text += '\n';
  // All or nothing: a pipe takes up to PIPE_BUF bytes at once, and no line is longer.
  const ssize_t written = ::write(m_input, text.data(), text.size());
  if (written != static_cast<ssize_t>(text.size())) {
    return base::fail(ProcessError::Ended,
                      "The helper in LinuxCNC has ended or hangs: start rivulet-linuxcnc again.");
  }
  return {};
}

std::optional<std::string> ChildProcess::readLine() {
  for (;;) {
    const std::size_t end = m_arrived.find('\n', m_next);
    if (end != std::string::npos) {
      std::string line = m_arrived.substr(m_next, end - m_next);
      m_next = end + 1;
      return line;
    }
    m_arrived.erase(0, m_next);
    m_next = 0;
    if (m_isAtEnd) {
      m_arrived.clear();  // a line without its end
      return std::nullopt;
    }
    std::array<char, 1U << 16U> buffer{};
    const ssize_t count = read(m_output, buffer.data(), buffer.size());
    if (count < 0) {
      m_isAtEnd = errno != EAGAIN && errno != EINTR;
      return std::nullopt;
    }
    m_isAtEnd = count == 0;
    m_arrived.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace rivulet::linuxcnc
