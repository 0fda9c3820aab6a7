// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/heidenhain/heidenhain.h"

#include <array>
#include <initializer_list>
#include <string_view>

namespace rivulet::nc::heidenhain {

namespace {

constexpr std::string_view kPathContours = "TNC 640 User's Manual Klartext, Programming contours";
constexpr std::string_view kMisc = "TNC 640 User's Manual Klartext, Miscellaneous functions";
/// M120 calculates ahead; only a path with RL or RR becomes another one.
constexpr std::string_view kLookAhead =
    "TNC 640 User's Manual Klartext, Miscellaneous functions, M120";

/// What the reader of plain text makes of its words.
constexpr std::array kG{GRow{0, G::Rapid, Changes::Path, {}, kPathContours},
                        GRow{10, G::Line, Changes::Path, "F", kPathContours},
                        GRow{20, G::ArcClockwise, Changes::Path, "IJKRPF", kPathContours},
                        GRow{30, G::ArcCounter, Changes::Path, "IJKRPF", kPathContours},
                        GRow{40, G::Dwell, Changes::Nothing, "PX", kPathContours},
                        GRow{170, G::PlaneXY, Changes::State, {}, kPathContours},
                        GRow{180, G::PlaneZX, Changes::State, {}, kPathContours},
                        GRow{190, G::PlaneYZ, Changes::State, {}, kPathContours},
                        GRow{900, G::Absolute, Changes::State, {}, kPathContours},
                        GRow{910, G::Incremental, Changes::State, {}, kPathContours},
                        GRow{930, G::FeedInverseTime, Changes::Feed, "F", kPathContours},
                        GRow{940, G::FeedPerMinute, Changes::Feed, "F", kPathContours},
                        GRow{200, G::Inches, Changes::State, {}, kPathContours},
                        GRow{210, G::Millimetres, Changes::State, {}, kPathContours},
                        GRow{740, G::Cycle, Changes::Path, {}, kPathContours},
                        GRow{760, G::Cycle, Changes::Path, {}, kPathContours},
                        GRow{840, G::Cycle, Changes::Path, {}, kPathContours},
                        GRow{800, G::CycleOff, Changes::State, {}, kPathContours},
                        GRow{980, G::Harmless, Changes::Nothing, {}, kPathContours},
                        GRow{990, G::Harmless, Changes::Nothing, {}, kPathContours},
                        GRow{400, G::Harmless, Changes::Nothing, {}, kPathContours},
                        GRow{410, G::Mode, Changes::Path, {}, kPathContours},
                        GRow{420, G::Mode, Changes::Path, {}, kPathContours},
                        GRow{530, G::MachineMove, Changes::Path, {}, kPathContours},
                        GRow{950, G::FeedPerRevolution, Changes::Feed, "F", kPathContours}};

constexpr std::array kM{MRow{2, MEffect::End, Changes::Path, kMisc},
                        MRow{30, MEffect::End, Changes::Path, kMisc},
                        MRow{91, MEffect::MachineMove, Changes::Path, kMisc},
                        MRow{92, MEffect::MachineMove, Changes::Path, kMisc},
                        MRow{140, MEffect::Retract, Changes::Path, kMisc},
                        MRow{0, MEffect::None, Changes::Nothing, kMisc},
                        MRow{1, MEffect::None, Changes::Nothing, kMisc},
                        MRow{3, MEffect::None, Changes::Nothing, kMisc},
                        MRow{4, MEffect::None, Changes::Nothing, kMisc},
                        MRow{5, MEffect::None, Changes::Nothing, kMisc},
                        MRow{6, MEffect::None, Changes::Nothing, kMisc},
                        MRow{7, MEffect::None, Changes::Nothing, kMisc},
                        MRow{8, MEffect::None, Changes::Nothing, kMisc},
                        MRow{9, MEffect::None, Changes::Nothing, kMisc},
                        MRow{13, MEffect::None, Changes::Nothing, kMisc},
                        MRow{14, MEffect::None, Changes::Nothing, kMisc},
                        MRow{101, MEffect::None, Changes::Nothing, kMisc},
                        MRow{102, MEffect::None, Changes::Nothing, kMisc},
                        MRow{107, MEffect::None, Changes::Nothing, kMisc},
                        MRow{108, MEffect::None, Changes::Nothing, kMisc},
                        MRow{111, MEffect::None, Changes::Nothing, kMisc},
                        MRow{117, MEffect::None, Changes::Nothing, kMisc},
                        MRow{141, MEffect::None, Changes::Nothing, kMisc},
                        MRow{145, MEffect::None, Changes::Nothing, kMisc},
                        MRow{149, MEffect::None, Changes::Nothing, kMisc},
                        MRow{120, MEffect::None, Changes::Nothing, kLookAhead},
                        MRow{126, MEffect::TurnsShortest, Changes::State, kMisc},
                        MRow{127, MEffect::TurnsAsWritten, Changes::State, kMisc},
                        MRow{128, MEffect::Refused, Changes::Path, kMisc},
                        MRow{129, MEffect::None, Changes::Nothing, kMisc},
                        MRow{136, MEffect::FeedPerRevolution, Changes::Feed, kMisc},
                        MRow{137, MEffect::FeedPerMinute, Changes::Feed, kMisc},
                        MRow{94, MEffect::Refused, Changes::Path, kMisc},
                        MRow{95, MEffect::Refused, Changes::Path, kMisc},
                        MRow{104, MEffect::Refused, Changes::Path, kMisc},
                        MRow{112, MEffect::Refused, Changes::Path, kMisc},
                        MRow{114, MEffect::Refused, Changes::Path, kMisc},

                        MRow{97, MEffect::Refused, Changes::Path, kMisc},
                        MRow{98, MEffect::Refused, Changes::Path, kMisc},
                        MRow{103, MEffect::Refused, Changes::Path, kMisc},
                        MRow{109, MEffect::Refused, Changes::Path, kMisc},
                        MRow{110, MEffect::Refused, Changes::Path, kMisc},
                        MRow{115, MEffect::Refused, Changes::Path, kMisc},
                        MRow{116, MEffect::Refused, Changes::Path, kMisc},
                        MRow{118, MEffect::Refused, Changes::Path, kMisc},
                        MRow{130, MEffect::Refused, Changes::Path, kMisc},
                        MRow{138, MEffect::Refused, Changes::Path, kMisc},
                        MRow{143, MEffect::Refused, Changes::Path, kMisc},
                        MRow{144, MEffect::Refused, Changes::Path, kMisc},
                        MRow{197, MEffect::Refused, Changes::Path, kMisc}};

NameTable names() {
  NameTable table;
  table.add(NameEffect::Address, kPathContours,
            {"A3", "B3", "C3", "TURN", "VRT", "RPA", "RPO", "POSS", "RFF", "OFFN"});
  table.add(NameEffect::None, kPathContours, {"BLK", "TOOL"});
  return table;
}

}  // namespace

DialectWords words() {
  return {GTable(kG), kM, names()};
}

}  // namespace rivulet::nc::heidenhain
