// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/sending_limit.h"

#include <winsock2.h>
#include <ws2tcpip.h>

namespace rivulet::opcua {

namespace {

/// TCP_MAXRT, which MinGW does not name.
constexpr int kTcpMaxRetransmission = 5;

}  // namespace

/// In whole seconds: the system knows no parts of one.
void endWhenUnconfirmed(std::uintptr_t socket, unsigned milliseconds) {
  const DWORD seconds = (milliseconds + 999) / 1000;
  setsockopt(static_cast<SOCKET>(socket), IPPROTO_TCP, kTcpMaxRetransmission,
             reinterpret_cast<const char*>(&seconds), sizeof seconds);
}

}  // namespace rivulet::opcua
