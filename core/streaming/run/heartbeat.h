// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The client's sign of life: a cell that it changes again and again, whatever else is due. The
/// program watches it in each interpolation cycle (`templates::watchesClient`) and wherever it
/// waits, and others see by it that the run has its client. No I/O. @threadsafety one object, one
/// thread.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "base/instant.h"
#include "opcua/link.h"
#include "templates/cells.h"

namespace rivulet::streaming {

class Heartbeat {
 public:
  /// @param cells  of the program on the control
  explicit Heartbeat(const templates::CellMap& cells);

  /// False: the program knows no client. Nothing is due then.
  [[nodiscard]] bool exists() const { return m_exists; }
  [[nodiscard]] bool isDue(base::Instant now) const { return m_exists && now >= m_next; }
  /// The next one, valid until the next call. The one after it is due an interval after its
  /// arrival; if that is never confirmed, two intervals from now.
  [[nodiscard]] std::span<const opcua::Assignment> next(base::Instant now);
  void arrived(base::Instant at) { m_next = at + m_interval; }
  /// Several of them go unnoticed before the axes stand.
  [[nodiscard]] base::Duration interval() const { return m_interval; }

 private:
  bool m_exists;
  base::Duration m_interval;
  std::array<opcua::Assignment, 1> m_assignment;
  base::Instant m_next{};
};

}  // namespace rivulet::streaming
