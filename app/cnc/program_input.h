// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where the bytes of a program come from: a file, or one TCP connection of this computer, whose
/// end is the end of the program. @threadsafety one object, one thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/instant.h"
#include "base/result.h"

namespace rivulet::cnc {

class ProgramInput {
 public:
  [[nodiscard]] static base::Result<ProgramInput> ofFile(const std::string& path);
  /// Listens on 127.0.0.1. @param port  0: any free one
  [[nodiscard]] static base::Result<ProgramInput> listen(std::uint16_t port);
  ProgramInput(ProgramInput&& other) noexcept;
  ProgramInput& operator=(ProgramInput&&) = delete;
  ~ProgramInput();

  [[nodiscard]] std::uint16_t port() const { return m_port; }
  /// Waits until there is something. @return bytes; empty: nothing yet; nothing: the end
  [[nodiscard]] std::optional<std::string> read(base::Duration atMost);

 private:
  ProgramInput() = default;

  int m_listener = -1;
  int m_input = -1;
  std::uint16_t m_port = 0;
};

}  // namespace rivulet::cnc
