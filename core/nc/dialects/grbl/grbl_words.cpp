// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/grbl/grbl.h"

#include <array>
#include <initializer_list>
#include <string_view>

namespace rivulet::nc::grbl {

namespace {

constexpr std::string_view kCommands = "Grbl v1.1 Commands, G-code parser state; gnea/grbl wiki";
constexpr std::string_view kSenders = "FluidNC wiki, Supported G-codes";

constexpr std::array kG{GRow{0, G::Rapid, Changes::Path, {}, kCommands},
                        GRow{10, G::Line, Changes::Path, "F", kCommands},
                        GRow{20, G::ArcClockwise, Changes::Path, "IJKRPF", kCommands},
                        GRow{30, G::ArcCounter, Changes::Path, "IJKRPF", kCommands},
                        GRow{40, G::Dwell, Changes::Nothing, "P", kCommands},
                        GRow{170, G::PlaneXY, Changes::State, {}, kCommands},
                        GRow{180, G::PlaneZX, Changes::State, {}, kCommands},
                        GRow{190, G::PlaneYZ, Changes::State, {}, kCommands},
                        GRow{900, G::Absolute, Changes::State, {}, kCommands},
                        GRow{910, G::Incremental, Changes::State, {}, kCommands},
                        GRow{930, G::FeedInverseTime, Changes::Feed, "F", kCommands},
                        GRow{940, G::FeedPerMinute, Changes::Feed, "F", kCommands},
                        GRow{200, G::Inches, Changes::State, {}, kCommands},
                        GRow{210, G::Millimetres, Changes::State, {}, kCommands},
                        GRow{911, G::CentreIncremental, Changes::State, {}, kCommands},
                        GRow{610, G::ExactPath, Changes::Nothing, {}, kCommands},
                        GRow{490, G::ToolLengthOff, Changes::Tool, {}, kCommands},
                        GRow{530, G::MachineMove, Changes::Path, {}, kCommands},
                        GRow{540, G::WorkOffset, Changes::State, {}, kCommands},
                        GRow{550, G::WorkOffset, Changes::State, {}, kCommands},
                        GRow{560, G::WorkOffset, Changes::State, {}, kCommands},
                        GRow{570, G::WorkOffset, Changes::State, {}, kCommands},
                        GRow{580, G::WorkOffset, Changes::State, {}, kCommands},
                        GRow{590, G::WorkOffset, Changes::State, {}, kCommands},
                        GRow{920, G::SetPosition, Changes::State, {}, kCommands},
                        GRow{921, G::ResetPosition, Changes::State, {}, kCommands},
                        GRow{800, G::CycleOff, Changes::State, {}, kCommands},
                        GRow{400, G::Harmless, Changes::Nothing, {}, kCommands},
                        GRow{382, G::MotionMode, Changes::Path, {}, kCommands},
                        GRow{383, G::MotionMode, Changes::Path, {}, kCommands},
                        GRow{384, G::MotionMode, Changes::Path, {}, kCommands},
                        GRow{385, G::MotionMode, Changes::Path, {}, kCommands},
                        GRow{431, G::TakesBlock, Changes::Tool, {}, kCommands},
                        GRow{100, G::TakesBlock, Changes::Path, {}, kCommands},
                        GRow{280, G::TakesBlock, Changes::Path, {}, kCommands},
                        GRow{281, G::TakesBlock, Changes::Path, {}, kCommands},
                        GRow{300, G::TakesBlock, Changes::Path, {}, kCommands},
                        GRow{301, G::TakesBlock, Changes::Path, {}, kCommands}};

constexpr std::array kM{MRow{2, MEffect::End, Changes::Path, kCommands},
                        MRow{30, MEffect::End, Changes::Path, kCommands},
                        MRow{0, MEffect::None, Changes::Nothing, kCommands},
                        MRow{1, MEffect::None, Changes::Nothing, kCommands},
                        MRow{3, MEffect::None, Changes::Nothing, kCommands},
                        MRow{4, MEffect::None, Changes::Nothing, kCommands},
                        MRow{5, MEffect::None, Changes::Nothing, kCommands},
                        MRow{6, MEffect::None, Changes::Nothing, kCommands},
                        MRow{7, MEffect::None, Changes::Nothing, kCommands},
                        MRow{8, MEffect::None, Changes::Nothing, kCommands},
                        MRow{9, MEffect::None, Changes::Nothing, kCommands},
                        MRow{56, MEffect::None, Changes::Nothing, kCommands},
                        MRow{62, MEffect::None, Changes::Nothing, kSenders, "PQE"},
                        MRow{63, MEffect::None, Changes::Nothing, kSenders, "PQE"},
                        MRow{64, MEffect::None, Changes::Nothing, kSenders, "PQE"},
                        MRow{65, MEffect::None, Changes::Nothing, kSenders, "PQE"},
                        MRow{67, MEffect::None, Changes::Nothing, kSenders, "PQE"},
                        MRow{68, MEffect::None, Changes::Nothing, kSenders, "PQE"}};

}  // namespace

DialectWords words() {
  return {GTable(kG), kM, {}};
}

}  // namespace rivulet::nc::grbl
