// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "live/error.h"
#include "sources/socket_source.h"

namespace rivulet::sources {

namespace {

base::Result<std::unique_ptr<live::Source>> refused(const std::string& kind) {
  return base::fail(live::LiveError::NotOpened,
                    "On Windows, points cannot come over a socket yet. Give - (standard input) or "
                    "opcua:FILE.",
                    kind);
}

}  // namespace

base::Result<std::unique_ptr<live::Source>> StreamSocketSource::listenUnix(
    const std::string& path) {
  return refused("unix:" + path);
}

base::Result<std::unique_ptr<live::Source>> StreamSocketSource::listenTcp(int port) {
  return refused("tcp:" + std::to_string(port));
}

base::Result<std::unique_ptr<live::Source>> DatagramSource::listen(int port) {
  return refused("udp:" + std::to_string(port));
}

}  // namespace rivulet::sources
