// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The variables of a program that is read for its path. @threadsafety one object, one thread.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "nc/eval/variables.h"

namespace rivulet::gcode {

/// The program's own, and of the control's those that follow from the path.
class ProgramVariables final : public nc::Variables {
 public:
  using PositionOf = std::function<std::optional<double>(char axis)>;
  /// In machine coordinates; nothing: only the control knows it.
  using MachinePositionOf = std::function<std::optional<double>(char axis)>;
  /// Of a # variable of the control.
  using KnownNumber = std::function<std::optional<double>(int number)>;
  ProgramVariables(const nc::Semantics& semantics, PositionOf positionOf,
                   MachinePositionOf machinePositionOf, KnownNumber knownNumber,
                   std::function<bool()> countsInches);

  [[nodiscard]] nc::Expected<nc::Value> system(std::string_view name,
                                               std::span<const nc::Value> indices) const override;
  /// #<_x>
  [[nodiscard]] nc::Expected<nc::Value> variable(std::string_view name,
                                                 std::span<const int> indices) const override;
  /// Of the control's, what its dialect knows.
  [[nodiscard]] nc::Expected<nc::Value> numbered(int number) const override;

  /// Variables of the control are not followed: a fault, as without a control.
  [[nodiscard]] nc::Expected<void> setSystem(std::string_view name,
                                             std::span<const nc::Value> indices,
                                             double value) override;
  /// The program has written to one, which may be an offset.
  [[nodiscard]] bool setsControl() const { return m_setsControl; }

  [[nodiscard]] double leastIncrement() const override { return m_countsInches() ? 1e-4 : 1e-3; }

 private:
  PositionOf m_positionOf;
  MachinePositionOf m_machinePositionOf;
  KnownNumber m_knownNumber;
  std::function<bool()> m_countsInches;
  bool m_setsControl = false;
};

}  // namespace rivulet::gcode
