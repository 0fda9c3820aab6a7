// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/fanuc/fanuc.h"

#include <array>
#include <initializer_list>
#include <string_view>

namespace rivulet::nc::fanuc {

namespace {

// Operator's Manual of the Series 0i-D, B-64304EN, by chapter.
constexpr std::string_view kPreparatory = "B-64304EN, Preparatory function (G function)";
constexpr std::string_view kInterpolation = "B-64304EN, Interpolation functions";
constexpr std::string_view kFeed = "B-64304EN, Feed functions";
constexpr std::string_view kDimension = "B-64304EN, Coordinate value and dimension";
constexpr std::string_view kCoordinates = "B-64304EN, Coordinate system";
constexpr std::string_view kSpindle = "B-64304EN, Spindle speed function (S function)";
constexpr std::string_view kAuxiliary = "B-64304EN, Auxiliary function";
constexpr std::string_view kSimplify = "B-64304EN, Functions to simplify programming";
constexpr std::string_view kCompensation = "B-64304EN, Compensation function";
constexpr std::string_view kMacro = "B-64304EN, Custom macro";
constexpr std::string_view kHighSpeed = "B-64304EN, High-speed cutting functions";
/// Of lathes, G code system A.
constexpr std::string_view kLathe = "B-64304EN-1, G function list of the T series";
/// Numbers that no manual of a control defines: what machines have in common.
constexpr std::string_view kIso = "DIN 66025-2, miscellaneous functions";

constexpr std::array kG{
    GRow{0, G::Rapid, Changes::Path, {}, kInterpolation},
    GRow{10, G::Line, Changes::Path, "F", kInterpolation},
    GRow{20, G::ArcClockwise, Changes::Path, "IJKRPF", kInterpolation},
    GRow{30, G::ArcCounter, Changes::Path, "IJKRPF", kInterpolation},
    GRow{40, G::Dwell, Changes::Nothing, "PX", kFeed},
    GRow{170, G::PlaneXY, Changes::State, {}, kPreparatory},
    GRow{180, G::PlaneZX, Changes::State, {}, kPreparatory},
    GRow{190, G::PlaneYZ, Changes::State, {}, kPreparatory},
    GRow{900, G::Absolute, Changes::State, {}, kDimension},
    GRow{910, G::Incremental, Changes::State, {}, kDimension},
    GRow{930, G::FeedInverseTime, Changes::Feed, "F", kFeed},
    GRow{940, G::FeedPerMinute, Changes::Feed, "F", kFeed},
    GRow{950, G::FeedPerRevolution, Changes::Feed, "F", kFeed},
    GRow{200, G::Inches, Changes::State, {}, kDimension},
    GRow{700, G::Inches, Changes::State, {}, kDimension},
    GRow{210, G::Millimetres, Changes::State, {}, kDimension},
    GRow{710, G::Millimetres, Changes::State, {}, kDimension},
    GRow{901, G::CentreAbsolute, Changes::State, {}, kDimension},
    GRow{911, G::CentreIncremental, Changes::State, {}, kDimension},
    GRow{150, G::PolarOff, Changes::State, {}, kDimension},
    GRow{160, G::PolarOn, Changes::State, {}, kDimension},
    GRow{90, G::ExactStopOnce, Changes::Nothing, {}, kFeed},
    GRow{600, G::ExactStop, Changes::Nothing, {}, kFeed},
    GRow{610, G::ExactPath, Changes::Nothing, "PQ", kFeed},
    GRow{611, G::ExactPath, Changes::Nothing, "PQ", kFeed},
    GRow{640, G::Continuous, Changes::Nothing, "PQ", kFeed},
    // Slower at inner corners while the radius of the tool is compensated, and as G64 else.
    GRow{620, G::Continuous, Changes::Nothing, {}, "B-63944EN, Automatic corner override (G62)"},
    GRow{430, G::ToolLength, Changes::Tool, "H", kCompensation},
    GRow{440, G::ToolLength, Changes::Tool, "H", kCompensation},
    GRow{431, G::TakesBlock, Changes::Tool, {}, kCompensation},
    GRow{490, G::ToolLengthOff, Changes::Tool, {}, kCompensation},
    GRow{530, G::MachineMove, Changes::Path, {}, kCoordinates},
    GRow{540, G::WorkOffset, Changes::State, {}, kCoordinates},
    GRow{550, G::WorkOffset, Changes::State, {}, kCoordinates},
    GRow{560, G::WorkOffset, Changes::State, {}, kCoordinates},
    GRow{570, G::WorkOffset, Changes::State, {}, kCoordinates},
    GRow{580, G::WorkOffset, Changes::State, {}, kCoordinates},
    GRow{590, G::WorkOffset, Changes::State, {}, kCoordinates},
    GRow{591, G::WorkOffset, Changes::State, {}, kCoordinates},
    GRow{592, G::WorkOffset, Changes::State, {}, kCoordinates},
    GRow{593, G::WorkOffset, Changes::State, {}, kCoordinates},
    GRow{541, G::WorkOffsetP, Changes::State, "P", kCoordinates},
    GRow{1540, G::WorkOffsetP, Changes::State, "P", kCoordinates},
    GRow{520, G::LocalOffset, Changes::State, {}, kCoordinates},
    GRow{920, G::SetPosition, Changes::State, "S", kCoordinates},
    GRow{921, G::ResetPosition, Changes::State, {}, kCoordinates},
    GRow{500, G::ScaleOff, Changes::State, "S", kSimplify},
    GRow{650, G::MacroCall, Changes::Path, {}, kMacro},
    GRow{800, G::CycleOff, Changes::State, {}, kSimplify},
    GRow{400, G::Harmless, Changes::Nothing, {}, kCompensation},
    GRow{434, G::TipLength, Changes::Tool, "H", kCompensation},
    GRow{50, G::Harmless, Changes::Nothing, "PQR", kHighSpeed},
    GRow{51, G::Harmless, Changes::Nothing, "PQR", kHighSpeed},
    GRow{690, G::TurnOff, Changes::State, {}, "B-63944EN-1, Coordinate system rotation (G68, G69)"},
    GRow{501,
         G::MirrorOff,
         Changes::State,
         {},
         "B-63944EN-1, Programmable mirror image (G50.1, G51.1)"},
    GRow{670, G::ModalMacroOff, Changes::State, {}, kMacro},
    GRow{980, G::Harmless, Changes::Nothing, {}, kSimplify},
    GRow{990, G::Harmless, Changes::Nothing, {}, kSimplify},
    GRow{960, G::SurfaceSpeed, Changes::Feed, "S", kSpindle},
    GRow{970, G::SpindleSpeed, Changes::Feed, "S", kSpindle},
    GRow{410, G::Mode, Changes::Path, "D", kCompensation},
    GRow{420, G::Mode, Changes::Path, "D", kCompensation},
    GRow{435, G::Mode, Changes::Path, "H", kCompensation},
    GRow{60, G::MotionMode, Changes::Path, {}, kInterpolation},
    GRow{61, G::MotionMode, Changes::Path, {}, kInterpolation},
    GRow{62, G::MotionMode, Changes::Path, {}, kInterpolation},
    GRow{310, G::MotionMode, Changes::Path, {}, kInterpolation},
    GRow{320, G::MotionMode, Changes::Path, {}, kInterpolation},
    GRow{330, G::MotionMode, Changes::Path, {}, kInterpolation},
    GRow{331, G::MotionMode, Changes::Path, {}, kInterpolation},
    GRow{340, G::MotionMode, Changes::Path, {}, kInterpolation},
    GRow{350, G::MotionMode, Changes::Path, {}, kInterpolation},
    GRow{380, G::MotionMode, Changes::Path, {}, kInterpolation},
    GRow{382, G::MotionMode, Changes::Path, {}, kInterpolation},
    GRow{383, G::MotionMode, Changes::Path, {}, kInterpolation},
    GRow{384, G::MotionMode, Changes::Path, {}, kInterpolation},
    GRow{385, G::MotionMode, Changes::Path, {}, kInterpolation},
    GRow{120, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{130, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{720, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{730, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{740, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{750, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{760, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{770, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{810, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{820, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{830, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{840, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{841, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{842, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{843, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{850, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{860, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{870, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{880, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{890, G::Cycle, Changes::Path, {}, kSimplify},
    GRow{922, G::TakesBlock, Changes::Path, {}, kPreparatory},
    GRow{923, G::TakesBlock, Changes::Path, {}, kPreparatory},
    GRow{100, G::SetWorkOffset, Changes::State, "LPR",
         "B-63944EN-1, Workpiece coordinate system, G10 L2"},
    GRow{110, G::TakesBlock, Changes::Path, {}, kPreparatory},
    GRow{250, G::TakesBlock, Changes::Path, {}, kPreparatory},
    GRow{260, G::TakesBlock, Changes::Path, {}, kPreparatory},
    GRow{270, G::TakesBlock, Changes::Path, {}, kPreparatory},
    GRow{280, G::TakesBlock, Changes::Path, {}, kPreparatory},
    GRow{281, G::TakesBlock, Changes::Path, {}, kPreparatory},
    GRow{290, G::TakesBlock, Changes::Path, {}, kPreparatory},
    GRow{300, G::TakesBlock, Changes::Path, {}, kPreparatory},
    GRow{301, G::TakesBlock, Changes::Path, {}, kPreparatory},
    GRow{510, G::Scale, Changes::State, "PIJK", "B-63944EN-1, Scaling (G50, G51)"},
    GRow{511,
         G::Mirror,
         Changes::State,
         {},
         "B-63944EN-1, Programmable mirror image (G50.1, G51.1)"},
    GRow{660, G::ModalMacro, Changes::Path, {}, kMacro},
    GRow{680, G::Turn, Changes::State, "R", "B-63944EN-1, Coordinate system rotation (G68, G69)"},
    GRow{682, G::TakesBlock, Changes::Path, {}, kPreparatory}};

constexpr std::array kLatheG{GRow{500, G::SetPosition, Changes::State, "S", kLathe},
                             GRow{700, G::TurningCycle, Changes::Path, "PQUWRDFST", kLathe},
                             GRow{710, G::TurningCycle, Changes::Path, "PQUWRDFST", kLathe},
                             GRow{720, G::TurningCycle, Changes::Path, "PQUWRDFST", kLathe},
                             GRow{730, G::TurningCycle, Changes::Path, "PQUWRDFST", kLathe},
                             GRow{900, G::AbsoluteOrTurning, Changes::State, {}, kLathe},
                             GRow{940, G::FeedPerMinuteOrFacing, Changes::Feed, {}, kLathe},
                             GRow{980, G::FeedPerMinute, Changes::Feed, "F", kLathe},
                             GRow{990, G::FeedPerRevolution, Changes::Feed, "F", kLathe}};

constexpr std::array kM{MRow{2, MEffect::End, Changes::Path, kAuxiliary},
                        MRow{30, MEffect::End, Changes::Path, kAuxiliary},
                        MRow{98, MEffect::Call, Changes::Path, kAuxiliary},
                        MRow{99, MEffect::Return, Changes::Path, kAuxiliary},
                        MRow{96, MEffect::Refused, Changes::Path, kAuxiliary},
                        MRow{97, MEffect::Refused, Changes::Path, kAuxiliary},
                        MRow{0, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{1, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{3, MEffect::None, Changes::Nothing, kIso},
                        MRow{4, MEffect::None, Changes::Nothing, kIso},
                        MRow{5, MEffect::None, Changes::Nothing, kIso},
                        MRow{6, MEffect::None, Changes::Nothing, kIso},
                        MRow{7, MEffect::None, Changes::Nothing, kIso},
                        MRow{8, MEffect::None, Changes::Nothing, kIso},
                        MRow{9, MEffect::None, Changes::Nothing, kIso},
                        MRow{19, MEffect::None, Changes::Nothing, kIso},
                        MRow{29, MEffect::None, Changes::Nothing, kSimplify},
                        MRow{10, MEffect::None, Changes::Nothing, kIso},
                        MRow{11, MEffect::None, Changes::Nothing, kIso},
                        MRow{13, MEffect::None, Changes::Nothing, kIso},
                        MRow{14, MEffect::None, Changes::Nothing, kIso},
                        MRow{48, MEffect::None, Changes::Nothing, kIso},
                        MRow{49, MEffect::None, Changes::Nothing, kIso}};

// Output of a macro to a device: "External output commands".
NameTable names() {
  NameTable table;
  table.add(NameEffect::None, "B-64304EN, Custom macro, External output commands",
            {"POPEN", "PCLOS", "SETVN"});
  // Optional chamfering and corner R, in front of the next motion.
  table.add(NameEffect::Mode, kSimplify, {",R", ",C"});
  return table;
}

}  // namespace

DialectWords words() {
  return {GTable(kG, kLatheG), kM, names()};
}

}  // namespace rivulet::nc::fanuc
