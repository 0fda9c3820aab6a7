// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trust/password.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <system_error>

#include "opcua/error.h"
#include "trust/private_file.h"

namespace rivulet::trust {

namespace fs = std::filesystem;

namespace {

/// A line feed at the end belongs to the file, not to the password.
std::string firstLine(std::string text) {
  text.erase(std::min(text.find('\n'), text.size()));
  return text;
}

std::optional<fs::path> systemdCredential() {
  const char* folder = std::getenv("CREDENTIALS_DIRECTORY");
  const fs::path path = folder == nullptr ? fs::path() : fs::path(folder) / "rivulet-password";
  std::error_code status;
  return folder != nullptr && fs::exists(path, status) ? std::optional(path) : std::nullopt;
}

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

base::Result<std::string> askForPassword(const std::string& question, const std::string& option) {
  const QuietTerminal terminal;
  if (!terminal.isThere()) {
    return base::fail(opcua::LinkError::LoginRefused,
                      fmt::format("There is no password and no terminal to ask for it. Give it "
                                  "{}in RIVULET_PASSWORD, or as the systemd credential "
                                  "rivulet-password.",
                                  option.empty() ? "" : "in a file (" + option + "), "));
  }
  terminal.print(question);
  std::string password = terminal.readLine();
  terminal.print("\n");
  return password;
}

base::Result<std::optional<std::string>> givenPassword(const fs::path& file) {
  std::optional<fs::path> path = systemdCredential();
  if (!file.empty()) {
    path = file;
  } else if (const char* variable = std::getenv("RIVULET_PASSWORD")) {
    return std::string(variable);
  }
  if (!path) {
    return std::nullopt;
  }
  auto text = readPrivateFile(*path);
  if (!text) {
    return base::fail(text.error());
  }
  return firstLine(std::move(*text));
}

base::Result<std::string> readPassword(const fs::path& file, const std::string& question,
                                       const std::string& option) {
  auto given = givenPassword(file);
  if (!given) {
    return base::fail(given.error());
  }
  return *given ? base::Result<std::string>(std::move(**given)) : askForPassword(question, option);
}

}  // namespace rivulet::trust
