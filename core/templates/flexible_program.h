// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The flexible program for a control: its cells, its text, and the number by which a client
/// recognises it. It is made once for a run; everybody else has a reference to it.
/// @threadsafety pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "templates/cells.h"

namespace rivulet::templates {

struct FlexibleProgram {
  TemplateParameters parameters;
  CellMap cells;
  /// NC text, LF line ends, ASCII. For the methods of [P1] the loop is Algorithm I; the signals of
  /// method 2 follow Algorithm III. For method window it waits for each window, copies it, checks
  /// the copy and moves from the copy; for method credit it does so while earlier windows are still
  /// being executed, without a stop.
  std::string text;
  /// The number that the program writes into its layout cell: a hash of its text (without this
  /// number), so that a client never drives another program. Two programs have the same number by
  /// chance in 1 of 16 million cases. 1 to 2^24 - 1, which a 32-bit real holds.
  int layoutNumber = 0;
  /// File name on the control, e.g. "RIVULET_SIGNAL_7.MPF": at most 24 characters before the dot.
  std::string name;
  /// For study only: it breaks what its method promises on purpose.
  bool isForStudy = false;
};

/// @return why there is none: `requireProgram`
[[nodiscard]] base::Result<FlexibleProgram> makeProgram(const TemplateParameters& parameters);

/// Whether there is a program for these parameters, without writing it.
/// @return DoesNotFit (the message names the MD28050 value that would be enough),
/// TooFewPointsPerLoop, NoAxis, TooManyAxes, RotaryNeedsWindow, BadCorrection, NotOnTarget
[[nodiscard]] base::Result<void> requireProgram(const TemplateParameters& parameters);

/// A window of method file.
struct WindowFile {
  int run = 0;
  std::size_t number = 1;  ///< of the window, from 1
  bool isLast = false;
  std::vector<double> coordinates;  ///< point by point, in the order of the axes; mm, degrees
  /// How a point is approached.
  struct Motion {
    double feedMmPerMin = 0.0;
    bool isRapid = false;  ///< with G0 at the rapid speed of the control

    friend bool operator==(const Motion&, const Motion&) = default;
  };
  std::vector<Motion> motions;  ///< one per point
};

/// The subprogram of this window. It moves only if the program requests this number and obeys this
/// run, and only if it is complete. Then it answers in the cell `asked`: minus twice its number,
/// and one less if it is the last. Coordinates have six decimals. @param cells  of method file
[[nodiscard]] std::string windowFileText(const CellMap& cells, const WindowFile& window);

/// Name on the control of the subprogram for windows whose number from 0 is `file` modulo k.
[[nodiscard]] std::string windowFileName(int file);

/// The first cell that such a file name says, if it is of a method with windows. The control may
/// show the name with its folder. @param otherwise  if the name was too long to say it
/// @return nothing: not the name of a flexible program with windows
[[nodiscard]] std::optional<int> baseCellOf(std::string_view fileName, int otherwise);

}  // namespace rivulet::templates
