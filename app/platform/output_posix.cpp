// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#include "base/descriptor.h"

namespace rivulet::output {

namespace {

/// What a stream of the C library leads to.
struct Target {
  int descriptor = -1;
  bool isOpen = true;  ///< at the start
  int error = 0;       ///< the first of the system
};
Target g_output{STDOUT_FILENO};
Target g_errors{STDERR_FILENO};
std::FILE* g_first = nullptr;  ///< standard output of the C library, which `std::cout` uses

/// Of a stream that takes everything. @return `size`
ssize_t take(void* cookie, const char* text, std::size_t size) {
  auto& target = *static_cast<Target*>(cookie);
  if (target.error == 0) {
    target.error = target.isOpen ? base::writeWhole(target.descriptor, {text, size}) : EBADF;
  }
  return static_cast<ssize_t>(size);
}

/// @param stream  a variable in the GNU C library
void replace(std::FILE*& stream, Target& target, int buffering) {
  if (std::FILE* made = fopencookie(&target, "w", {nullptr, &take, nullptr, nullptr})) {
    std::setvbuf(made, nullptr, buffering, BUFSIZ);
    stream = made;
  }
}

}  // namespace

void guard() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) {
      g_output.isOpen = g_output.isOpen && descriptor != STDOUT_FILENO;
      g_errors.isOpen = g_errors.isOpen && descriptor != STDERR_FILENO;
      // The lowest number that is free: this one.
      (void)open("/dev/null", descriptor == STDIN_FILENO ? O_RDONLY : O_WRONLY);
    }
  }
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &ignore, nullptr);
  sigaction(SIGXFSZ, &ignore, nullptr);
  g_first = stdout;
  replace(stdout, g_output, isatty(STDOUT_FILENO) != 0 ? _IOLBF : _IOFBF);
  replace(stderr, g_errors, _IONBF);
}

bool isLost() {
  return g_output.error != 0;
}

std::string failure() {
  std::fflush(stdout);
  if (g_first != nullptr && std::fflush(g_first) != 0 && g_output.error == 0) {
    g_output.error = errno;
  }
  return g_output.error == 0 || g_output.error == EPIPE
             ? std::string()
             : fmt::format("Not all output could be written: {}.",
                           std::generic_category().message(g_output.error));
}

}  // namespace rivulet::output
