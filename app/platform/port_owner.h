// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which users of this computer have a port of its loopback address: the kernel tells no program
/// who is at the other end of a TCP or UDP connection, but lists all sockets with their users.
/// @threadsafety reads files of the system; shares nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>

namespace rivulet::platform {

/// Of a user, as the kernel counts them.
using UserNumber = unsigned;

enum class PortKind {
  TcpListener,
  Udp,
};

/// @param table  folder of the kernel's lists
/// @return the users, none if nobody has the port; nothing if the lists cannot be read
[[nodiscard]] std::optional<std::set<UserNumber>> ownersOfPort(
    PortKind kind, std::uint16_t port, const std::filesystem::path& table = "/proc/net");

/// Somebody else than this user and the administrator has the port. False as well if that cannot be
/// found out.
[[nodiscard]] bool isPortOfAnother(PortKind kind, std::uint16_t port,
                                   const std::filesystem::path& table = "/proc/net");

}  // namespace rivulet::platform
