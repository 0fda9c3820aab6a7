// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/port_probe.h"

#include <fmt/format.h>

#include "machine/front/listen_once.h"
#include "machine/front/server.h"

namespace rivulet::machine {

base::Result<void> probePort(const std::string& host, std::uint16_t port) {
  const ListenAttempt attempt = listenOnce(host, port);
  switch (attempt.outcome) {
    case ListenAttempt::Outcome::Works:
      return {};
    case ListenAttempt::Outcome::Unresolved:
      return base::fail(FrontError::AddressUnusable,
                        fmt::format("This address cannot be used to listen on ({}).", attempt.why),
                        host);
    case ListenAttempt::Outcome::PortTaken:
      return base::fail(
          FrontError::PortTaken,
          fmt::format(
              "Port {} is used by another program: stop that program or choose another port.",
              port),
          host);
    case ListenAttempt::Outcome::Refused:
      break;
  }
  return base::fail(
      FrontError::AddressUnusable,
      fmt::format("Cannot listen on port {} of this address ({}).", port, attempt.why), host);
}

}  // namespace rivulet::machine
