// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/heidenhain/heidenhain.h"

#include <array>

namespace rivulet::nc::heidenhain {

DialectWords words() {
  static constexpr std::array kM{
      MFunction{91, MEffect::MachineMove}, MFunction{92, MEffect::MachineMove},
      MFunction{140, MEffect::Retract},
      // They change the path, the feed or how axes turn (TNC 640 User's Manual Conversational
      // Programming, chapter "Miscellaneous functions"): display of a rotary axis, corners of a
      // compensated contour, feed on arcs, rounding between blocks, geometry of the machine, feed
      // of rotary axes, their shortest way, the tip of the tool, the untilted coordinates.
      MFunction{94, MEffect::Refused}, MFunction{95, MEffect::Refused},
      MFunction{98, MEffect::Refused}, MFunction{104, MEffect::Refused},
      MFunction{109, MEffect::Refused}, MFunction{110, MEffect::Refused},
      MFunction{112, MEffect::Refused}, MFunction{114, MEffect::Refused},
      MFunction{116, MEffect::Refused}, MFunction{126, MEffect::Refused},
      MFunction{128, MEffect::Refused}, MFunction{130, MEffect::Refused},
      MFunction{144, MEffect::Refused}};
  DialectWords made{{},
                    kM,
                    {{"A3", NameEffect::Address},
                     {"B3", NameEffect::Address},
                     {"C3", NameEffect::Address},
                     {"TURN", NameEffect::Address},
                     {"BLK", NameEffect::None},
                     {"TOOL", NameEffect::None}}};
  const GMarks mark(made.g);
  markCommon(mark);
  return made;
}

}  // namespace rivulet::nc::heidenhain
