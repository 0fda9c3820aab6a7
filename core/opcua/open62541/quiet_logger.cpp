// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/quiet_logger.h"

#include <cstdio>

namespace rivulet::opcua {

QuietLogger::QuietLogger() {
  m_logger.log = &QuietLogger::log;
  m_logger.context = this;
}

void QuietLogger::log(void* context, UA_LogLevel level, UA_LogCategory /*category*/,
                      const char* format, va_list arguments) noexcept {
  if (level < UA_LOGLEVEL_WARNING) {
    return;
  }
  auto* self = static_cast<QuietLogger*>(context);
  std::vsnprintf(self->m_message.data(), self->m_message.size(), format, arguments);
}

}  // namespace rivulet::opcua
