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
  Credit,    ///< as Window, without a stop between windows; experimental
  File,      ///< as Window, but each window is a subprogram that is transferred; for comparison
};

/// In the order they are offered.
inline constexpr std::array<MethodKind, 5> kMethodKinds{MethodKind::Window, MethodKind::Position,
                                                        MethodKind::Signal, MethodKind::Credit,
                                                        MethodKind::File};
/// Those of [P1], kept as published.
inline constexpr std::array<MethodKind, 2> kPaperMethods{MethodKind::Position, MethodKind::Signal};

/// The control takes numbered windows, and only those that have been delivered: the cells, the
/// client and the way back are the same.
[[nodiscard]] constexpr bool hasWindows(MethodKind method) {
  return method == MethodKind::Window || method == MethodKind::Credit || method == MethodKind::File;
}

/// It can stream rotary axes beside X, Y and Z.
[[nodiscard]] constexpr bool streamsRotary(MethodKind method) {
  return method == MethodKind::Window || method == MethodKind::File;
}

/// The name used in files, on the command line and in templates.
[[nodiscard]] constexpr std::string_view methodName(MethodKind method) {
  switch (method) {
    case MethodKind::Position:
      return "position";
    case MethodKind::Signal:
      return "signal";
    case MethodKind::Credit:
      return "credit";
    case MethodKind::File:
      return "file";
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
