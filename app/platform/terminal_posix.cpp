// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/terminal.h"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

namespace rivulet::platform {

namespace {

/// The terminal of this process with its echo off.
class QuietTerminal {
 public:
  QuietTerminal() : m_descriptor(open("/dev/tty", O_RDWR | O_CLOEXEC)) {
    if (m_descriptor >= 0 && tcgetattr(m_descriptor, &m_before) == 0) {
      termios quiet = m_before;
      quiet.c_lflag &= ~static_cast<tcflag_t>(ECHO);
      m_isQuiet = tcsetattr(m_descriptor, TCSAFLUSH, &quiet) == 0;
    }
  }
  ~QuietTerminal() {
    if (m_isQuiet) {
      tcsetattr(m_descriptor, TCSAFLUSH, &m_before);
    }
    if (m_descriptor >= 0) {
      close(m_descriptor);
    }
  }
  QuietTerminal(const QuietTerminal&) = delete;
  QuietTerminal& operator=(const QuietTerminal&) = delete;

  [[nodiscard]] bool isThere() const { return m_isQuiet; }
  void print(const std::string& text) const {
    (void)!write(m_descriptor, text.data(), text.size());
  }
  [[nodiscard]] std::string readLine() const {
    std::string line;
    for (char c = '\0'; read(m_descriptor, &c, 1) == 1 && c != '\n';) {
      line += c;
    }
    return line;
  }

 private:
  int m_descriptor;
  termios m_before{};
  bool m_isQuiet = false;
};

}  // namespace

bool isInputTerminal() {
  return isatty(STDIN_FILENO) == 1;
}

bool isErrorTerminal() {
  return isatty(STDERR_FILENO) == 1;
}

bool isInForeground() {
  return tcgetpgrp(STDIN_FILENO) == getpgrp();
}

struct SingleKeys::Mode {
  termios attributes{};
};

SingleKeys::SingleKeys(std::unique_ptr<Mode> before) : m_before(std::move(before)) {
}

std::unique_ptr<SingleKeys> SingleKeys::take() {
  auto before = std::make_unique<Mode>();
  if (!isInputTerminal() || !isInForeground() ||
      tcgetattr(STDIN_FILENO, &before->attributes) != 0) {
    return nullptr;
  }
  termios raw = before->attributes;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  return std::unique_ptr<SingleKeys>(new SingleKeys(std::move(before)));
}

SingleKeys::~SingleKeys() {
  if (isInForeground()) {
    tcsetattr(STDIN_FILENO, TCSANOW, &m_before->attributes);
  }
}

bool askInSecret(const std::string& question, std::string& answer) {
  const QuietTerminal terminal;
  if (!terminal.isThere()) {
    return false;
  }
  terminal.print(question);
  answer = terminal.readLine();
  terminal.print("\n");
  return true;
}

}  // namespace rivulet::platform
