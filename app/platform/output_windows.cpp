// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <io.h>
#include <windows.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace rivulet::output {

namespace {

int g_error = 0;  ///< the first of the system, of standard output

}  // namespace

/// Lines end as everywhere else, so that a result has the same bytes; a console shows UTF-8 and
/// knows how a line is erased.
void guard() {
  for (std::FILE* stream : {stdin, stdout, stderr}) {
    _setmode(_fileno(stream), _O_BINARY);
  }
  SetConsoleOutputCP(CP_UTF8);
  HANDLE errors = GetStdHandle(STD_ERROR_HANDLE);
  DWORD mode = 0;
  if (GetConsoleMode(errors, &mode) != 0) {
    SetConsoleMode(errors, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
  }
  std::setvbuf(stdout, nullptr, _IOFBF, BUFSIZ);
  std::setvbuf(stderr, nullptr, _IONBF, 0);
}

bool isLost() {
  return g_error != 0 || std::ferror(stdout) != 0;
}

std::string failure() {
  if ((std::fflush(stdout) != 0 || std::ferror(stdout) != 0) && g_error == 0) {
    g_error = errno != 0 ? errno : EIO;
  }
  // A reader that has gone is EINVAL for this C library.
  return g_error == 0 || g_error == EPIPE || g_error == EINVAL
             ? std::string()
             : fmt::format("Not all output could be written: {}.",
                           std::generic_category().message(g_error));
}

}  // namespace rivulet::output
