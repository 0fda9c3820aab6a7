// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Tool, spindle, coolant and work offset, read from the control for the display. What a control
/// does not serve stays unknown and is not asked again. @threadsafety one object, one thread.
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/instant.h"
#include "opcua/variable.h"

namespace rivulet::streaming {

/// Nothing: the control does not serve it.
struct EquipmentSeen {
  std::optional<int> tool;              ///< T in the spindle; 0: none, or one that has only a name
  std::optional<std::string> toolName;  ///< may be empty
  std::optional<int> edge;              ///< D
  std::optional<std::string> workOffset;   ///< "G54"; "G500": none
  std::optional<double> spindlePerMin;     ///< not negative
  std::optional<double> spindleSetPerMin;  ///< not negative
  std::optional<opcua::SpindleTurn> turn;  ///< only if it agrees with the speed
  std::optional<bool> flood;               ///< M8
  std::optional<bool> mist;                ///< M7

  friend bool operator==(const EquipmentSeen&, const EquipmentSeen&) = default;
};

class EquipmentWatch {
 public:
  /// It changes seldom: where a stream has time, it is read this often.
  static constexpr base::Duration kInterval = std::chrono::seconds{1};

  EquipmentWatch();

  /// What to read; empty: the control serves nothing of it.
  [[nodiscard]] const std::vector<opcua::Variable>& variables() const { return m_variables; }
  /// @param readings  of `variables`, each with its own status
  [[nodiscard]] EquipmentSeen take(std::span<const opcua::Reading> readings);

 private:
  std::vector<opcua::Variable> m_variables;
};

}  // namespace rivulet::streaming
