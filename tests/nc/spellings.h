// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One path, many spellings: a path is drawn, and written as a program for each control in ways
/// that are drawn as well. It knows from the controls' manuals what it writes, and nothing of the
/// reader it is to judge. Lengths are mm, angles degrees, feeds mm/min. @threadsafety pure.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"

namespace rivulet::tests {

enum class Control : unsigned char { Sinumerik, Fanuc, Haas, LinuxCnc, Grbl, Heidenhain };
inline constexpr std::array kControls{Control::Sinumerik, Control::Fanuc, Control::Haas,
                                      Control::LinuxCnc,  Control::Grbl,  Control::Heidenhain};
[[nodiscard]] std::string_view controlName(Control control);

/// A way of writing that a program may use. Without any of them it is absolute, in mm, with all
/// words.
enum class Feature : unsigned char {
  Increments,      ///< G91, IX of Heidenhain
  PerValue,        ///< X=AC() Y=IC()
  Inch,            ///< G20, G70, G700
  ArcRadius,       ///< R, CR=, CR of Heidenhain
  AbsoluteCentre,  ///< I=AC(), G90.1
  ArcAngle,        ///< AR=
  ArcThrough,      ///< CIP
  Tangent,         ///< CT
  Polar,           ///< AP= RP=, G16, @ ^, LP and CP
  PlaneWords,      ///< a plane that the next move does not need
  Shift,           ///< TRANS, ATRANS, G52, CYCL DEF 7
  Turn,            ///< ROT, AROT, G68, CYCL DEF 10
  Scale,           ///< SCALE, ASCALE, G51
  Mirror,          ///< MIRROR, AMIRROR, CYCL DEF 8
  SetPosition,     ///< G92
  Loop,
  Call,        ///< moves stand in a subprogram
  Arguments,   ///< values of a subprogram come from its call
  SavedState,  ///< PROC SAVE, M70 M72
  Variables,   ///< R1, #101, #<name>, Q1 and expressions in place of numbers
  Deferred,    ///< #3=6 G1 X#3 of LinuxCNC
  Repeated,    ///< modal words again
  BlockNumbers,
  Blanks,       ///< none, several, tabs
  InnerBlanks,  ///< blanks inside numbers
  Comments,
  Exponent,
  NumberForms,  ///< +1, 01, .5, 1.50
  Header,       ///< %, O1234, %_N_NAME_MPF
  LineEnds,     ///< CRLF, CR
  LowerCase,
  Order,  ///< of the words of a block
  InverseTime,
  PerRevolution,
  Count
};
[[nodiscard]] std::string_view featureName(Feature feature);

struct DrawnMove {
  enum class Kind : unsigned char { Rapid, Line, Arc, Steps };
  Kind kind = Kind::Line;
  std::uint64_t id = 0;            ///< what is drawn of its spelling depends on it
  std::array<bool, 3> given{};     ///< of a line
  base::Vec3 value;                ///< its end, or the increment of each step
  int plane = 2;                   ///< of an arc: the axis across it
  std::array<double, 2> centre{};  ///< from its start, in the plane
  bool tangent = false;            ///< the centre is moved so that it goes on with the line before
  double sweepDeg = 0.0;           ///< counterclockwise about the axis across, if positive
  double rise = 0.0;               ///< along that axis
  int count = 1;                   ///< of steps
  double feed = 0.0;
};

/// A move of the path.
struct PathMove {
  enum class Kind : unsigned char { Rapid, Line, Arc };
  Kind kind = Kind::Line;
  base::Vec3 end;
  base::Vec3 centre;      ///< of an arc, at the height of its start
  base::Vec3 axis;        ///< unit vector; the turn is counterclockwise seen against it
  double sweepDeg = 0.0;  ///< > 0
  double feed = 0.0;
};

[[nodiscard]] std::vector<DrawnMove> drawMoves(std::uint64_t seed);
[[nodiscard]] std::vector<PathMove> pathOf(const std::vector<DrawnMove>& moves);

struct Spelling {
  Control control = Control::Sinumerik;
  std::uint64_t seed = 0;
  std::set<Feature> without;  ///< not used
};

struct Written {
  std::string text;
  std::map<std::string, std::string, std::less<>> beside;  ///< subprograms in files, by name
  std::set<Feature> used;
};

[[nodiscard]] Written writePath(const std::vector<DrawnMove>& moves, const Spelling& spelling);

}  // namespace rivulet::tests
