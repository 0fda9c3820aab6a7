// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The streaming methods, by name. What they do is in `streaming/methods`.
#pragma once

#include <array>
#include <cstddef>
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

/// What the other folders have to know of a method: one row each.
struct MethodTraits {
  MethodKind kind;
  std::string_view name;  ///< in files, on the command line and in templates
  bool isPublished;       ///< of [P1]: kept as published
  /// The control takes numbered windows, and only those that have been delivered. Where the client
  /// is late, the machine waits; a run that was left can be resumed.
  bool hasWindows;
  bool streamsRotary;       ///< rotary axes beside X, Y and Z
  bool needsCommissioning;  ///< starts only on a control that has passed its test
  bool sendsBlocks;         ///< a window is NC blocks, each with its own feed and type of motion
};

/// In the order they are offered.
inline constexpr std::array<MethodTraits, 5> kMethods{{
    {MethodKind::Window, "window", false, true, true, false, false},
    {MethodKind::Position, "position", true, false, false, false, false},
    {MethodKind::Signal, "signal", true, false, false, false, false},
    {MethodKind::Credit, "credit", false, true, false, true, false},
    {MethodKind::File, "file", false, true, true, false, true},
}};
/// The same, without what is known of them.
inline constexpr std::array<MethodKind, kMethods.size()> kMethodKinds = [] {
  std::array<MethodKind, kMethods.size()> kinds{};
  for (std::size_t i = 0; i < kMethods.size(); ++i) {
    kinds[i] = kMethods[i].kind;
  }
  return kinds;
}();
/// Those of [P1].
inline constexpr std::array<MethodKind, 2> kPaperMethods{MethodKind::Position, MethodKind::Signal};

[[nodiscard]] constexpr const MethodTraits& methodTraits(MethodKind method) {
  for (const MethodTraits& traits : kMethods) {
    if (traits.kind == method) {
      return traits;
    }
  }
  return kMethods.front();
}

[[nodiscard]] constexpr bool isPublished(MethodKind method) {
  return methodTraits(method).isPublished;
}
[[nodiscard]] constexpr bool hasWindows(MethodKind method) {
  return methodTraits(method).hasWindows;
}
[[nodiscard]] constexpr bool streamsRotary(MethodKind method) {
  return methodTraits(method).streamsRotary;
}
[[nodiscard]] constexpr bool needsCommissioning(MethodKind method) {
  return methodTraits(method).needsCommissioning;
}
[[nodiscard]] constexpr bool sendsBlocks(MethodKind method) {
  return methodTraits(method).sendsBlocks;
}
/// The points may arrive while the machine moves, because it waits for numbered points.
[[nodiscard]] constexpr bool takesLivePoints(MethodKind method) {
  return hasWindows(method) && !sendsBlocks(method);
}
[[nodiscard]] constexpr std::string_view methodName(MethodKind method) {
  return methodTraits(method).name;
}

/// Inverse of `methodName`; nothing for an unknown name.
[[nodiscard]] constexpr std::optional<MethodKind> methodFromName(std::string_view name) {
  for (const MethodTraits& traits : kMethods) {
    if (traits.name == name) {
      return traits.kind;
    }
  }
  return std::nullopt;
}

}  // namespace rivulet::base
