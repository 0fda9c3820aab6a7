// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/status_line.h"

#include <fmt/format.h>

#include <cstdio>

#include "platform/terminal.h"

namespace rivulet::cli {

namespace {

constexpr const char* kEraseLine = "\r\x1b[K";

}  // namespace

bool isTerminal() {
  return platform::isErrorTerminal();
}

void StatusLine::show(const std::string& text) {
  const std::lock_guard lock(m_mutex);
  if (text != m_text && isTerminal()) {
    m_text = text;
    fmt::print(stderr, "{}{}", kEraseLine, text);
    std::fflush(stderr);
  }
}

void StatusLine::clear() {
  const std::lock_guard lock(m_mutex);
  if (!m_text.empty()) {
    m_text.clear();
    std::fputs(kEraseLine, stderr);
  }
}

void sayOverStatus(const std::string& message) {
  fmt::print(stderr, "{}{}\n", isTerminal() ? kEraseLine : "", message);
}

}  // namespace rivulet::cli
