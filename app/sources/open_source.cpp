// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sources/open_source.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/text.h"
#include "live/error.h"
#include "platform/input.h"
#include "sources/pipe_source.h"
#include "sources/socket_source.h"
#ifdef RIVULET_WITH_OPEN62541
#include "sources/server_source.h"
#endif

namespace rivulet::sources {

bool inputBringsPoints() {
  return platform::isInputFed();
}

namespace {

/// "tcp" and "4001".
std::pair<std::string, std::string> partsOf(const std::string& address) {
  const std::string kind = address.substr(0, address.find(':'));
  return {kind, address.substr(std::min(kind.size() + 1, address.size()))};
}

std::optional<int> portOf(const std::string& kind, const std::string& rest) {
  const std::optional<int> port = base::parseInteger(rest);
  const bool isPort = (kind == "tcp" || kind == "udp") && port && *port >= 0 && *port <= 65'535;
  return isPort ? port : std::nullopt;
}

}  // namespace

bool isPort(const std::string& address) {
  const auto [kind, rest] = partsOf(address);
  return portOf(kind, rest).has_value();
}

base::Result<std::unique_ptr<live::Source>> openSource(const std::string& address) {
  if (address == "-") {
    return std::unique_ptr<live::Source>(std::make_unique<PipeSource>(platform::kStandardInput));
  }
  const auto [kind, rest] = partsOf(address);
  if (kind == "unix") {
    return StreamSocketSource::listenUnix(rest);
  }
#ifdef RIVULET_WITH_OPEN62541
  if (kind == "opcua" && !rest.empty()) {
    return ServerSource::open(rest);
  }
#endif
  if (const auto port = portOf(kind, rest)) {
    return kind == "tcp" ? StreamSocketSource::listenTcp(*port) : DatagramSource::listen(*port);
  }
  return base::fail(live::LiveError::NotOpened,
                    "This is no live source. Give -, unix:PATH, tcp:PORT, udp:PORT or opcua:FILE.",
                    address);
}

}  // namespace rivulet::sources
