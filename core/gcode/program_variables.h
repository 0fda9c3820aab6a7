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
  ProgramVariables(const nc::Semantics& semantics, PositionOf positionOf);

  [[nodiscard]] nc::Expected<nc::Value> system(std::string_view name,
                                               std::span<const nc::Value> indices) const override;
  /// #<_x>
  [[nodiscard]] nc::Expected<nc::Value> variable(std::string_view name,
                                                 std::span<const int> indices) const override;
  /// #5420 and on: the position.
  [[nodiscard]] nc::Expected<nc::Value> numbered(int number) const override;

 private:
  PositionOf m_positionOf;
};

}  // namespace rivulet::gcode
