// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The streaming methods, by name. What they do is in `streaming/methods`.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace rivulet::base {

enum class MethodKind {
  Position,  ///< method 1 of [P1], Algorithm II: polls the position
  Signal,    ///< method 2 of [P1], Algorithm III: polls a signal cell
  Window,    ///< numbered windows: the control takes none that has not been delivered
};

/// In the order they are offered.
inline constexpr std::array<MethodKind, 3> kMethodKinds{MethodKind::Window, MethodKind::Position,
                                                        MethodKind::Signal};
/// Those of [P1], kept as published.
inline constexpr std::array<MethodKind, 2> kPaperMethods{MethodKind::Position, MethodKind::Signal};

/// The name used in files, on the command line and in templates.
[[nodiscard]] constexpr std::string_view methodName(MethodKind method) {
  switch (method) {
    case MethodKind::Position:
      return "position";
    case MethodKind::Signal:
      return "signal";
    case MethodKind::Window:
      break;
  }
  return "window";
}

/// Inverse of `methodName`; nothing for an unknown name.
[[nodiscard]] constexpr std::optional<MethodKind> methodFromName(std::string_view name) {
  for (const MethodKind method : kMethodKinds) {
    if (methodName(method) == name) {
      return method;
    }
  }
  return std::nullopt;
}

}  // namespace rivulet::base
