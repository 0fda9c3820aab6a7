// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Figures of a program as it is written: values as programmed, in the units of the file, without
/// frames, work offsets, arc bulge or cutter radius compensation. Comparable with what any other
/// reader of the same text counts. @threadsafety plain values.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "nc/geometry/arc.h"
#include "nc/modal/vocabulary.h"

namespace rivulet::gcode {

enum class FileUnits : unsigned char { Unspecified, Millimetres, Inches, Mixed };

/// "unspecified", "mm", "in", "mixed".
[[nodiscard]] std::string_view fileUnitsName(FileUnits units);
/// Inverse, of what a program can be said to be in: "mm", "in".
[[nodiscard]] std::optional<FileUnits> saidUnitsOfName(std::string_view name);

using nc::kProgrammedAxes;
using nc::kProgrammedAxisCount;

using nc::CentreReading;
inline constexpr std::array kCentreReadings{CentreReading::AsProgrammed, CentreReading::Absolute,
                                            CentreReading::StartMinusCentre};
/// "as-programmed", "absolute", "start-minus-centre".
[[nodiscard]] std::string_view centreReadingName(CentreReading reading);
[[nodiscard]] std::optional<CentreReading> centreReadingOfName(std::string_view name);

struct ProgrammedRange {
  double smallest = 0.0;
  double largest = 0.0;
};

struct ProgramFacts {
  /// False if something stood in the way of reading every motion (an error, a subprogram whose
  /// text is missing): counts and lengths are then those of what was read, and no facts.
  bool complete = true;
  /// Blocks that name an axis (or an arc centre) while G0, G1, G2, G3 is the modal motion.
  std::array<std::size_t, 4> motions{};
  std::size_t defaultMotions = 0;  ///< blocks with an axis before any of G0 to G3
  std::size_t machineMotions = 0;  ///< of all those, the ones in machine coordinates
  std::size_t otherMotions = 0;    ///< cycles, threads, probing, splines, reference moves
  FileUnits units = FileUnits::Unspecified;
  bool movesBeforeUnits = false;  ///< a block moves X, Y or Z before one says mm or inch
  bool dependsOnDialect = false;  ///< it has words that controls read differently
  /// Of the end points programmed; nothing for an axis that has none with a known value.
  std::array<std::optional<ProgrammedRange>, kProgrammedAxisCount> bounds{};
  /// An increment of the axis started at a value the program had not given.
  std::array<bool, kProgrammedAxisCount> boundsUnknown{};
  bool lengthsKnown = true;  ///< false: a coordinate could not be computed
  /// The way of writing under which all arcs fit, if it is not the one of the dialect.
  CentreReading centreReading = CentreReading::AsProgrammed;
  double g1Length = 0.0;           ///< X Y Z distances of G1
  std::size_t g1Excluded = 0;      ///< G1 blocks whose start is not known
  double arcLength = 0.0;          ///< G2 and G3 with the rise of a helix
  std::size_t arcExcluded = 0;     ///< arcs whose start or centre is not known
  double arcRadiusMismatch = 0.0;  ///< largest difference of start and end radius
  std::vector<double> feeds;       ///< numbers programmed with F, ascending, each once
};

}  // namespace rivulet::gcode
