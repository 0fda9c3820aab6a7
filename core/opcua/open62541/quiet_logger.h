// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A logger for the open62541 library that prints nothing and keeps its last warning or error, so
/// that an `Error` can carry it as context. @threadsafety one object, one thread at a time.
#pragma once

#include <open62541/plugin/log.h>

#include <array>
#include <string>

namespace rivulet::opcua {

/// Must outlive the client or server that logs into it.
class QuietLogger {
 public:
  QuietLogger();
  QuietLogger(const QuietLogger&) = delete;
  QuietLogger& operator=(const QuietLogger&) = delete;

  [[nodiscard]] UA_Logger* handle() { return &m_logger; }
  /// The last warning or error; empty if there was none.
  [[nodiscard]] std::string lastMessage() const { return m_message.data(); }

 private:
  static void log(void* context, UA_LogLevel level, UA_LogCategory category, const char* format,
                  va_list arguments) noexcept;

  UA_Logger m_logger{};
  std::array<char, 256> m_message{};
};

}  // namespace rivulet::opcua
