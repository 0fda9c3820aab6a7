// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The class of each move of a program: by kind, feed, margin of the method or time. The appearance
/// of a class is not defined here. @threadsafety pure; O(points).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "feasibility/verdict.h"
#include "overview/program_view.h"

namespace rivulet::overview {

enum class PathColouring : unsigned char { Kind, Feed, Margin, Time, Pauses };

struct PathClasses {
  PathColouring colouring = PathColouring::Kind;
  std::vector<std::uint8_t> ofPoint;  ///< class of the move that ends at each streamed point
  std::size_t count = 0;
  /// The last class is that of the gaps of a job (`ProgramView::gaps`), which are not part of the
  /// path.
  bool hasGaps = false;
  /// If several moves are drawn as one, show the highest class; otherwise that of the last.
  bool highestWins = false;
  /// Kind: empty. Feed (mm/s), margin and time (s): class i (feed: i + 1) reaches from
  /// borders[i] to borders[i + 1]; feeds of few values: class i + 1 is borders[i] itself. Pauses
  /// (mm, descending): class i + 1 reaches from borders[i] down to borders[i + 1].
  std::vector<double> borders;
  bool eachFeedItsOwn = false;
};

/// Classes of `PathColouring::Kind`; rapids are class 0 with `Feed` too.
enum class KindClass : unsigned char { Rapid, Line, Arc, Spline };

/// Margins between classes, from good to bad: class 0 keeps the limit more than threefold, the
/// last one does not keep it.
inline constexpr double kMarginAmple = 3.0;
inline constexpr double kMarginFair = 1.5;
inline constexpr double kMarginNone = 1.0;
inline constexpr std::size_t kMarginClasses = 4;

inline constexpr std::size_t kFeedClassesMax = 6;
inline constexpr std::size_t kTimeClasses = 5;
inline constexpr std::size_t kPauseClasses = 4;  ///< beside that without pauses

/// The classes as the levels of the path show them. @threadsafety immutable once made
struct DrawnClasses {
  PathClasses classes;                             ///< without `ofPoint`: that is `ofLevel.front()`
  std::vector<std::vector<std::uint8_t>> ofLevel;  ///< per level of the view, per kept point
  std::vector<bool> present;                       ///< per class: a move is of it
};
/// Puts the moves of gaps into a class of their own.
[[nodiscard]] std::shared_ptr<const DrawnClasses> drawnClasses(PathClasses classes,
                                                               const ProgramView& view);

[[nodiscard]] PathClasses classesByKind(const ProgramView& view);

/// With few values of the feed, each is a class; with many, the classes have equal ratios.
[[nodiscard]] PathClasses classesByFeed(const ProgramView& view);

/// By the margin of each move: with method position from its own length in (1); with signal from
/// the shortest window of ⌊N/2⌋ steps it belongs to, in (3); with window from that of M steps, in
/// the reach. Moves drawn as one show their smallest margin. @param access  as in the verdict
/// @param ownFeeds  each move has its own feed; that of `point` is the largest
[[nodiscard]] PathClasses classesByMargin(const ProgramView& view,
                                          const feasibility::OperatingPoint& point,
                                          const feasibility::AccessModel& access = {},
                                          bool ownFeeds = false);
/// The margins themselves; infinite for the first point, because no move of the program leads to
/// it.
[[nodiscard]] std::vector<float> localMargins(const ProgramView& view,
                                              const feasibility::OperatingPoint& point,
                                              const feasibility::AccessModel& access = {},
                                              bool ownFeeds = false);

/// By the length of path from one pause to the next: the last class has the shortest ways. Moves
/// drawn as one show their densest. Class 0: no pause is planned there. @param pauses  null: not
/// known
[[nodiscard]] PathClasses classesByPauses(const ProgramView& view, const PauseMap* pauses);

/// @param atS  one per streamed point, ascending
[[nodiscard]] PathClasses classesByTime(const std::vector<float>& atS);

}  // namespace rivulet::overview
