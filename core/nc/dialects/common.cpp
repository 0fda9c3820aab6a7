// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <array>

#include "nc/dialects/dialect_words.h"

namespace rivulet::nc {

void markCommon(const GMarks& mark) {
  mark(GEffect::Motion, {0, 10, 20, 30});
  mark(GEffect::Dwell, {40});
  mark(GEffect::Plane, {170, 180, 190});
  mark(GEffect::Units, {200, 210, 700, 710});
  mark(GEffect::Distance, {900, 910});
  mark(GEffect::CentreMode, {901, 911});
  mark(GEffect::FeedMode, {930, 940, 950});
  mark(GEffect::Diameter, {70, 80});
  mark(GEffect::PolarOff, {150});
  mark(GEffect::PolarOn, {160});
  mark(GEffect::BlockEnd, {90, 600});
  mark(GEffect::Tolerance, {610, 611, 640, 1870});
  mark(GEffect::ToolLength, {430, 431, 440, 490});
  mark(GEffect::MachineMove, {530});
  mark(GEffect::WorkOffset, {540, 550, 560, 570, 580, 590, 591, 592, 593});
  mark(GEffect::WorkOffsetP, {541, 1540});
  mark(GEffect::LocalOffset, {520});
  mark(GEffect::SetPosition, {920});
  mark(GEffect::ResetPosition, {921});
  mark(GEffect::ScaleOff, {500});
  mark(GEffect::MacroCall, {650});
  mark(GEffect::CycleOff, {800});
  // Radius compensation off, high-speed modes, spindle speed; G43.4 guides the tool's tip.
  mark(GEffect::None, {400, 434, 50, 51, 1030, 690, 960, 970, 980, 990, 501, 670});
  mark(GEffect::Mode, {410, 420, 435});
  // Motions Rivulet does not make.
  mark(GEffect::MotionMode, {60, 61, 62, 310, 320, 330, 331, 340, 350, 380, 382, 383, 384, 385});
  mark(GEffect::Cycle, {120, 130, 720, 730, 740, 750, 760, 770, 810, 820,
                        830, 840, 841, 842, 843, 850, 860, 870, 880, 890});
  mark(GEffect::TakesBlock,
       {922, 923, 100, 110, 250, 260, 270, 280, 281, 290, 300, 301, 510, 511, 660, 680, 682});
}

std::span<const MFunction> commonMFunctions() {
  static constexpr std::array kFunctions{
      MFunction{2, MEffect::End},      MFunction{30, MEffect::End},
      MFunction{98, MEffect::Call},    MFunction{99, MEffect::Return},
      MFunction{96, MEffect::Refused}, MFunction{97, MEffect::Refused}};
  return kFunctions;
}

}  // namespace rivulet::nc
