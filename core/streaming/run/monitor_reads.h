// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What is read beside the accesses of the method, and how often: the state of the channel, axes
/// and feed for the display, tool and spindle. @threadsafety one object, one thread.
#pragma once

#include <array>
#include <vector>

#include "base/axes.h"
#include "base/instant.h"
#include "opcua/link.h"
#include "streaming/run/equipment_watch.h"
#include "trace/recording.h"

namespace rivulet::streaming {

/// The display gets at most this many samples a second.
inline constexpr base::Duration kDisplayInterval = std::chrono::milliseconds{33};

class MonitorReads {
 public:
  enum class Kind { Display, Status, Equipment };

  /// @param showsAxes  false: the method reads the axes itself, and only the feed is missing
  MonitorReads(bool showsAxes, base::Instant now);
  /// Rotary axes to be shown beside X, Y and Z. @param axisOf  see `ControlAxes`
  void showRotary(const std::array<int, base::kRotaryAxisCount>& axisOf);

  /// Empty: the control serves nothing of it.
  [[nodiscard]] const std::vector<opcua::Variable>& variables(Kind kind) const;
  [[nodiscard]] int count(Kind kind) const { return static_cast<int>(variables(kind).size()); }
  /// When it may be read again.
  [[nodiscard]] base::Instant next(Kind kind) const { return m_next[index(kind)]; }
  [[nodiscard]] bool isDue(Kind kind, base::Instant now) const {
    return now >= next(kind) && count(kind) > 0;
  }
  /// The axes have not been shown for so long that a method which can wait does so.
  [[nodiscard]] bool isDisplayOverdue(base::Instant now) const;

  void asked(Kind kind, base::Instant now);
  void askStatusAt(base::Instant at) { m_next[index(Kind::Status)] = at; }
  /// Reading the status takes a part of the time only, however slow the control is.
  void statusAnswered(const opcua::Event& event);
  [[nodiscard]] trace::LiveSample takeDisplay(const opcua::Event& event);
  [[nodiscard]] EquipmentSeen takeEquipment(const opcua::Event& event) {
    return m_equipment.take(event.readings);
  }

 private:
  static std::size_t index(Kind kind) { return static_cast<std::size_t>(kind); }

  std::vector<opcua::Variable> m_display;  ///< the feed last
  std::vector<std::size_t> m_rotary;       ///< axes that are shown behind X, Y and Z
  std::vector<opcua::Variable> m_status;
  EquipmentWatch m_equipment;
  std::array<base::Instant, 3> m_next{};
  base::Instant m_shownAt;
};

}  // namespace rivulet::streaming
