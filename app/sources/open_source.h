// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Live sources by their address. @threadsafety main thread or that of the run.
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "live/source.h"

namespace rivulet::sources {

/// Standard input is a pipe, a file or a socket, not a terminal or nothing: points can come from
/// it.
[[nodiscard]] bool inputBringsPoints();

/// "tcp:PORT" or "udp:PORT": a source that names no file.
[[nodiscard]] bool isPort(const std::string& address);

/// @param address  "-": standard input; "unix:PATH"; "tcp:PORT" and "udp:PORT" on this computer;
/// "opcua:FILE": variables of another server, see `server_map.h`
/// @return NotOpened, and what a connection returns
[[nodiscard]] base::Result<std::unique_ptr<live::Source>> openSource(const std::string& address);

}  // namespace rivulet::sources
