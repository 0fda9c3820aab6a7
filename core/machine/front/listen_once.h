// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What `port_probe` asks the system. @threadsafety pure.
#pragma once

#include <cstdint>
#include <string>

namespace rivulet::machine {

struct ListenAttempt {
  enum class Outcome {
    Works,
    PortTaken,
    Unresolved,  ///< the address is none of this computer
    Refused,
  };
  Outcome outcome = Outcome::Works;
  std::string why;  ///< in the words of the system
};

/// Listens for a moment on each address that the name stands for.
[[nodiscard]] ListenAttempt listenOnce(const std::string& host, std::uint16_t port);

}  // namespace rivulet::machine
