// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/heidenhain/heidenhain.h"

#include <array>

namespace rivulet::nc::heidenhain {

DialectWords words() {
  static constexpr std::array kM{
      MFunction{91, MEffect::MachineMove}, MFunction{92, MEffect::MachineMove},
      MFunction{99, MEffect::CycleCall}, MFunction{140, MEffect::Retract}};
  DialectWords made{{},
                    kM,
                    {{"CT", NameEffect::Motion},
                     {"AP", NameEffect::Address},
                     {"RP", NameEffect::Address},
                     {"A3", NameEffect::Address},
                     {"B3", NameEffect::Address},
                     {"C3", NameEffect::Address},
                     {"BLK", NameEffect::None},
                     {"TOOL", NameEffect::None}}};
  const GMarks mark(made.g);
  markCommon(mark);
  mark(GEffect::Pole, {1100, 1110});
  return made;
}

}  // namespace rivulet::nc::heidenhain
