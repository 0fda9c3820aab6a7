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

/// What the client brings to the control at once; equations and distances are of it.
enum class Portion {
  Point,     ///< one point, when the tool is within δ of it
  HalfLoop,  ///< half of the points of the loop, at a signal
  Window,    ///< a window of N points
};

/// What the other folders have to know of a method: one row each.
struct MethodTraits {
  MethodKind kind{};
  std::string_view name;  ///< in files, on the command line and in templates
  Portion portion = Portion::Window;
  bool isPublished = false;  ///< of [P1]: kept as published
  /// The control takes numbered windows, and only those that have been delivered. Where the client
  /// is late, the machine waits; a run that was left can be resumed.
  bool hasWindows = false;
  bool streamsRotary = false;       ///< rotary axes beside X, Y and Z
  bool needsCommissioning = false;  ///< starts only on a control that has passed its test
  /// A window is NC blocks, each with its own feed and type of motion. What it costs to store them
  /// on a control is not known: such a method is for comparison, on the command line.
  bool sendsBlocks = false;
  bool goesOn = false;  ///< the axes do not stop between portions
};

/// In the order they are offered.
inline constexpr std::array<MethodTraits, 5> kMethods{{
    {.kind = MethodKind::Window, .name = "window", .hasWindows = true, .streamsRotary = true},
    {.kind = MethodKind::Position,
     .name = "position",
     .portion = Portion::Point,
     .isPublished = true},
    {.kind = MethodKind::Signal,
     .name = "signal",
     .portion = Portion::HalfLoop,
     .isPublished = true},
    {.kind = MethodKind::Credit,
     .name = "credit",
     .hasWindows = true,
     .needsCommissioning = true,
     .goesOn = true},
    {.kind = MethodKind::File,
     .name = "file",
     .hasWindows = true,
     .streamsRotary = true,
     .sendsBlocks = true},
}};
inline constexpr MethodKind kDefaultMethod = kMethods.front().kind;
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

/// A method that is not in this table, see `streaming::registerMethod`: `kind` is ignored, `name`
/// has to last. Before anything asks for it, on one thread. @return its kind
MethodKind addMethod(MethodTraits traits);
/// Null: there is no such method.
[[nodiscard]] const MethodTraits* addedMethod(MethodKind method);
[[nodiscard]] const MethodTraits* addedMethod(std::string_view name);

[[nodiscard]] constexpr const MethodTraits& methodTraits(MethodKind method) {
  for (const MethodTraits& traits : kMethods) {
    if (traits.kind == method) {
      return traits;
    }
  }
  const MethodTraits* const added = addedMethod(method);
  return added != nullptr ? *added : kMethods.front();
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
/// The points of a window are in cells, so that they may have a feed of their own there, and a
/// correction.
[[nodiscard]] constexpr bool fillsWindows(MethodKind method) {
  return hasWindows(method) && !sendsBlocks(method);
}
/// The points may arrive while the machine moves, because it waits for numbered points.
[[nodiscard]] constexpr bool takesLivePoints(MethodKind method) {
  return fillsWindows(method);
}
/// A point has been passed when the tool is within δ of it.
[[nodiscard]] constexpr bool usesDelta(MethodKind method) {
  return methodTraits(method).portion == Portion::Point;
}
[[nodiscard]] constexpr bool goesOn(MethodKind method) {
  return methodTraits(method).goesOn;
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
  const MethodTraits* const added = addedMethod(name);
  return added != nullptr ? std::optional(added->kind) : std::nullopt;
}

}  // namespace rivulet::base
