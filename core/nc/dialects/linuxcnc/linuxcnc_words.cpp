// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/linuxcnc/linuxcnc.h"

#include <array>
#include <initializer_list>
#include <string_view>

namespace rivulet::nc::linuxcnc {

namespace {

constexpr std::string_view kGCode = "LinuxCNC documentation, G-Codes";
constexpr std::string_view kMCode = "LinuxCNC documentation, M-Codes";

constexpr std::array kG{GRow{0, G::Rapid, Changes::Path, {}, kGCode},
                        GRow{10, G::Line, Changes::Path, "F", kGCode},
                        GRow{20, G::ArcClockwise, Changes::Path, "IJKRPF", kGCode},
                        GRow{30, G::ArcCounter, Changes::Path, "IJKRPF", kGCode},
                        GRow{40, G::Dwell, Changes::Nothing, "P", kGCode},
                        GRow{170, G::PlaneXY, Changes::State, {}, kGCode},
                        GRow{180, G::PlaneZX, Changes::State, {}, kGCode},
                        GRow{190, G::PlaneYZ, Changes::State, {}, kGCode},
                        GRow{900, G::Absolute, Changes::State, {}, kGCode},
                        GRow{910, G::Incremental, Changes::State, {}, kGCode},
                        GRow{930, G::FeedInverseTime, Changes::Feed, "F", kGCode},
                        GRow{940, G::FeedPerMinute, Changes::Feed, "F", kGCode},
                        GRow{950, G::FeedPerRevolution, Changes::Feed, "F", kGCode},
                        GRow{200, G::Inches, Changes::State, {}, kGCode},
                        GRow{210, G::Millimetres, Changes::State, {}, kGCode},
                        GRow{901, G::CentreAbsolute, Changes::State, {}, kGCode},
                        GRow{911, G::CentreIncremental, Changes::State, {}, kGCode},
                        GRow{70, G::Diameter, Changes::State, {}, kGCode},
                        GRow{80, G::Radius, Changes::State, {}, kGCode},
                        GRow{50, G::CubicSpline, Changes::Path, "IJPQ", kGCode},
                        GRow{51, G::QuadraticSpline, Changes::Path, "IJ", kGCode},
                        GRow{52, G::NurbsOn, Changes::Path, "PL", kGCode},
                        GRow{53, G::NurbsOff, Changes::State, {}, kGCode},
                        GRow{62, G::NurbsWithKnots, Changes::Path, "KPR", kGCode},
                        GRow{610, G::ExactPath, Changes::Nothing, {}, kGCode},
                        GRow{611, G::ExactPath, Changes::Nothing, {}, kGCode},
                        GRow{640, G::Continuous, Changes::Nothing, "PQ", kGCode},
                        GRow{430, G::ToolLength, Changes::Tool, "H", kGCode},
                        GRow{432, G::TakesBlock, Changes::Tool, "H", kGCode},
                        GRow{431, G::TakesBlock, Changes::Tool, {}, kGCode},
                        GRow{490, G::ToolLengthOff, Changes::Tool, {}, kGCode},
                        GRow{530, G::MachineMove, Changes::Path, {}, kGCode},
                        GRow{540, G::WorkOffset, Changes::State, {}, kGCode},
                        GRow{550, G::WorkOffset, Changes::State, {}, kGCode},
                        GRow{560, G::WorkOffset, Changes::State, {}, kGCode},
                        GRow{570, G::WorkOffset, Changes::State, {}, kGCode},
                        GRow{580, G::WorkOffset, Changes::State, {}, kGCode},
                        GRow{590, G::WorkOffset, Changes::State, {}, kGCode},
                        GRow{591, G::WorkOffset, Changes::State, {}, kGCode},
                        GRow{592, G::WorkOffset, Changes::State, {}, kGCode},
                        GRow{593, G::WorkOffset, Changes::State, {}, kGCode},
                        GRow{520, G::LocalOffset, Changes::State, {}, kGCode},
                        GRow{920, G::SetPosition, Changes::State, {}, kGCode},
                        GRow{921, G::ResetPosition, Changes::State, {}, kGCode},
                        GRow{922, G::SuspendPosition, Changes::State, {}, kGCode},
                        GRow{923, G::RestorePosition, Changes::State, {}, kGCode},
                        GRow{100, G::SetWorkOffset, Changes::State, "LPR", kGCode},
                        GRow{800, G::CycleOff, Changes::State, {}, kGCode},
                        GRow{400, G::Harmless, Changes::Nothing, {}, kGCode},
                        GRow{980, G::RetractToStart, Changes::Nothing, {}, kGCode},
                        GRow{990, G::RetractToR, Changes::Nothing, {}, kGCode},
                        GRow{960, G::SurfaceSpeed, Changes::Feed, "SD", kGCode},
                        GRow{970, G::SpindleSpeed, Changes::Feed, "S", kGCode},
                        GRow{410, G::Mode, Changes::Path, "DL", kGCode},
                        GRow{411, G::Mode, Changes::Path, "DL", kGCode},
                        GRow{420, G::Mode, Changes::Path, "DL", kGCode},
                        GRow{421, G::Mode, Changes::Path, "DL", kGCode},
                        GRow{330, G::MotionMode, Changes::Path, {}, kGCode},
                        GRow{331, G::MotionMode, Changes::Path, {}, kGCode},
                        GRow{382, G::MotionMode, Changes::Path, {}, kGCode},
                        GRow{383, G::MotionMode, Changes::Path, {}, kGCode},
                        GRow{384, G::MotionMode, Changes::Path, {}, kGCode},
                        GRow{385, G::MotionMode, Changes::Path, {}, kGCode},
                        GRow{730, G::Cycle, Changes::Path, {}, kGCode},
                        GRow{740, G::Cycle, Changes::Path, {}, kGCode},
                        GRow{760, G::Cycle, Changes::Path, {}, kGCode},
                        GRow{810, G::Cycle, Changes::Path, {}, kGCode},
                        GRow{820, G::Cycle, Changes::Path, {}, kGCode},
                        GRow{830, G::Cycle, Changes::Path, {}, kGCode},
                        GRow{840, G::Cycle, Changes::Path, {}, kGCode},
                        GRow{850, G::Cycle, Changes::Path, {}, kGCode},
                        GRow{860, G::Cycle, Changes::Path, {}, kGCode},
                        GRow{870, G::Cycle, Changes::Path, {}, kGCode},
                        GRow{880, G::Cycle, Changes::Path, {}, kGCode},
                        GRow{890, G::Cycle, Changes::Path, {}, kGCode},
                        GRow{280, G::TakesBlock, Changes::Path, {}, kGCode},
                        GRow{281, G::Harmless, Changes::Nothing, {}, kGCode},
                        GRow{300, G::TakesBlock, Changes::Path, {}, kGCode},
                        GRow{301, G::Harmless, Changes::Nothing, {}, kGCode}};

constexpr std::array kM{MRow{2, MEffect::End, Changes::Path, kMCode},
                        MRow{30, MEffect::End, Changes::Path, kMCode},
                        MRow{98, MEffect::Call, Changes::Path, kMCode},
                        MRow{99, MEffect::Return, Changes::Path, kMCode},
                        MRow{0, MEffect::None, Changes::Nothing, kMCode},
                        MRow{1, MEffect::None, Changes::Nothing, kMCode},
                        MRow{3, MEffect::None, Changes::Nothing, kMCode},
                        MRow{4, MEffect::None, Changes::Nothing, kMCode},
                        MRow{5, MEffect::None, Changes::Nothing, kMCode},
                        MRow{6, MEffect::None, Changes::Nothing, kMCode},
                        MRow{7, MEffect::None, Changes::Nothing, kMCode},
                        MRow{8, MEffect::None, Changes::Nothing, kMCode},
                        MRow{9, MEffect::None, Changes::Nothing, kMCode},
                        MRow{19, MEffect::None, Changes::Nothing, kMCode, "PQ"},
                        MRow{48, MEffect::None, Changes::Nothing, kMCode},
                        MRow{49, MEffect::None, Changes::Nothing, kMCode},
                        MRow{50, MEffect::None, Changes::Nothing, kMCode, "PQ"},
                        MRow{51, MEffect::None, Changes::Nothing, kMCode, "PQ"},
                        MRow{53, MEffect::None, Changes::Nothing, kMCode, "PQ"},
                        MRow{60, MEffect::None, Changes::Nothing, kMCode},
                        MRow{61, MEffect::None, Changes::Nothing, kMCode, "PQ"},
                        MRow{62, MEffect::None, Changes::Nothing, kMCode, "PQ"},
                        MRow{63, MEffect::None, Changes::Nothing, kMCode, "PQ"},
                        MRow{64, MEffect::None, Changes::Nothing, kMCode, "PQ"},
                        MRow{65, MEffect::None, Changes::Nothing, kMCode, "PQ"},
                        MRow{66, MEffect::None, Changes::Nothing, kMCode, "PQ"},
                        MRow{67, MEffect::None, Changes::Nothing, kMCode, "PQ"},
                        MRow{68, MEffect::None, Changes::Nothing, kMCode, "PQ"},
                        MRow{52, MEffect::Refused, Changes::Feed, kMCode, "PQ"},
                        MRow{70, MEffect::SaveState, Changes::State, kMCode},
                        MRow{71, MEffect::ForgetState, Changes::State, kMCode},
                        MRow{72, MEffect::RestoreState, Changes::State, kMCode},
                        MRow{73, MEffect::SaveUntilReturn, Changes::State, kMCode}};

}  // namespace

DialectWords words() {
  return {GTable(kG), kM, {}};
}

}  // namespace rivulet::nc::linuxcnc
