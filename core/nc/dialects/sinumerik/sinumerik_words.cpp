// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/sinumerik/sinumerik.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>

namespace rivulet::nc::sinumerik {

namespace {

// Programming Manual Fundamentals, by chapter.
constexpr std::string_view kList = "Fundamentals, List of G functions";
constexpr std::string_view kMotion = "Fundamentals, Motion commands";
constexpr std::string_view kFeed = "Fundamentals, Feed control";
constexpr std::string_view kSpindle = "Fundamentals, Spindle motion";
constexpr std::string_view kGeometry = "Fundamentals, Geometry settings";
constexpr std::string_view kPath = "Fundamentals, Path action";
constexpr std::string_view kRadius = "Fundamentals, Tool radius compensation";
constexpr std::string_view kTool = "Fundamentals, Tool offsets";
constexpr std::string_view kAuxiliary = "Fundamentals, Auxiliary function outputs, M functions";
constexpr std::string_view kFrames = "Fundamentals, Coordinate transformations (frames)";
constexpr std::string_view kJob = "Programming Manual Job Planning, List of statements";
constexpr std::string_view kSplines = "Programming Manual Job Planning, Spline interpolation";
constexpr std::string_view kCycles = "Programming Manual Cycles, List of cycles";
constexpr std::string_view kIsoMode = "ISO Milling; of that language alone";
constexpr std::string_view kIso = "DIN 66025-2, miscellaneous functions";

constexpr std::array kG{GRow{0, G::Rapid, Changes::Path, {}, kMotion},
                        GRow{10, G::Line, Changes::Path, "F", kMotion},
                        GRow{20, G::ArcClockwise, Changes::Path, "IJKRPF", kMotion},
                        GRow{30, G::ArcCounter, Changes::Path, "IJKRPF", kMotion},
                        GRow{40, G::Dwell, Changes::Nothing, "FS", kFeed},
                        GRow{170, G::PlaneXY, Changes::State, {}, kGeometry},
                        GRow{180, G::PlaneZX, Changes::State, {}, kGeometry},
                        GRow{190, G::PlaneYZ, Changes::State, {}, kGeometry},
                        GRow{900, G::Absolute, Changes::State, {}, kGeometry},
                        GRow{910, G::Incremental, Changes::State, {}, kGeometry},
                        GRow{930, G::FeedInverseTime, Changes::Feed, "F", kFeed},
                        GRow{940, G::FeedPerMinute, Changes::Feed, "F", kFeed},
                        GRow{950, G::FeedPerRevolution, Changes::Feed, "F", kFeed},
                        GRow{700, G::InchesOfLengths, Changes::State, {}, kGeometry},
                        GRow{710, G::MillimetresOfLengths, Changes::State, {}, kGeometry},
                        GRow{7000, G::Inches, Changes::State, {}, kGeometry},
                        GRow{7100, G::Millimetres, Changes::State, {}, kGeometry},
                        GRow{540, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{550, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{560, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{570, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5000, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5050, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5060, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5070, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5080, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5090, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5100, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5110, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5120, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5130, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5140, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5150, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5160, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5170, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5180, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5190, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5200, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5210, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5220, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5230, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5240, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5250, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5260, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5270, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5280, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5290, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5300, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5310, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5320, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5330, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5340, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5350, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5360, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5370, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5380, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5390, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5400, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5410, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5420, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5430, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5440, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5450, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5460, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5470, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5480, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5490, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5500, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5510, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5520, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5530, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5540, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5550, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5560, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5570, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5580, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5590, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5600, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5610, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5620, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5630, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5640, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5650, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5660, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5670, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5680, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5690, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5700, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5710, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5720, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5730, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5740, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5750, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5760, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5770, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5780, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5790, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5800, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5810, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5820, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5830, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5840, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5850, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5860, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5870, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5880, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5890, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5900, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5910, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5920, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5930, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5940, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5950, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5960, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5970, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5980, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{5990, G::WorkOffset, Changes::State, {}, kGeometry},
                        GRow{530, G::MachineMove, Changes::Path, {}, kGeometry},
                        GRow{1530, G::MachineMove, Changes::Path, {}, kGeometry},
                        GRow{90, G::ExactStopOnce, Changes::Nothing, {}, kPath},
                        GRow{600, G::ExactStop, Changes::Nothing, {}, kPath},
                        GRow{640, G::Continuous, Changes::Nothing, {}, kPath},
                        GRow{6420, G::Continuous, Changes::Nothing, {}, kPath},
                        GRow{6430, G::Continuous, Changes::Nothing, {}, kPath},
                        GRow{6440, G::Continuous, Changes::Nothing, {}, kPath},
                        GRow{6450, G::Continuous, Changes::Nothing, {}, kPath},
                        GRow{6410, G::ContinuousByDistance, Changes::Nothing, {}, kPath},
                        GRow{601, G::Harmless, Changes::Nothing, {}, kPath},
                        GRow{6010, G::Harmless, Changes::Nothing, {}, kPath},
                        GRow{6020, G::Harmless, Changes::Nothing, {}, kPath},
                        GRow{6030, G::Harmless, Changes::Nothing, {}, kPath},
                        GRow{4500, G::CornersRound, Changes::Nothing, {}, kRadius},
                        GRow{4510, G::CornersIntersect, Changes::Nothing, {}, kRadius},
                        GRow{4600, G::Harmless, Changes::Nothing, {}, kRadius},
                        GRow{4610, G::Harmless, Changes::Nothing, {}, kRadius},
                        GRow{4620, G::Harmless, Changes::Nothing, {}, kRadius},
                        GRow{1400, G::Harmless, Changes::Nothing, {}, kRadius},
                        GRow{1410, G::Harmless, Changes::Nothing, {}, kRadius},
                        GRow{1420, G::Harmless, Changes::Nothing, {}, kRadius},
                        GRow{1430, G::Harmless, Changes::Nothing, {}, kRadius},
                        GRow{3400, G::Harmless, Changes::Nothing, {}, kRadius},
                        GRow{3410, G::Harmless, Changes::Nothing, {}, kRadius},
                        GRow{400, G::CompensationOff, Changes::Path, {}, kRadius},
                        GRow{410, G::CompensationLeft, Changes::Path, {}, kRadius},
                        GRow{420, G::CompensationRight, Changes::Path, {}, kRadius},
                        GRow{2900, G::Harmless, Changes::Nothing, {}, kList},
                        GRow{960, G::SurfaceSpeedPerRevolution, Changes::Feed, "S", kSpindle},
                        GRow{9610, G::SurfaceSpeedPerMinute, Changes::Feed, "S", kSpindle},
                        GRow{9620, G::SurfaceSpeed, Changes::Feed, "S", kSpindle},
                        GRow{970, G::SpindleSpeedPerRevolution, Changes::Feed, "S", kSpindle},
                        GRow{9710, G::SpindleSpeedPerMinute, Changes::Feed, "S", kSpindle},
                        GRow{9720, G::SpindleSpeed, Changes::Feed, "S", kSpindle},
                        GRow{9730, G::SpindleSpeed, Changes::Feed, "S", kSpindle},
                        GRow{9310, G::FeedUnknown, Changes::Feed, "F", kFeed},
                        GRow{9420, G::FeedPerMinute, Changes::Feed, "F", kFeed},
                        GRow{9520, G::FeedPerRevolution, Changes::Feed, "F", kFeed},
                        GRow{1100, G::PoleFromPosition, Changes::State, {}, kMotion},
                        GRow{1110, G::PoleFromZero, Changes::State, {}, kMotion},
                        GRow{1120, G::PoleFromPole, Changes::State, {}, kMotion},
                        GRow{2910, G::Mode, Changes::Path, {}, kList},
                        GRow{1470, G::Mode, Changes::Path, {}, kList},
                        GRow{1480, G::Mode, Changes::Path, {}, kList},
                        GRow{2470, G::Mode, Changes::Path, {}, kList},
                        GRow{2480, G::Mode, Changes::Path, {}, kList},
                        GRow{3470, G::Mode, Changes::Path, {}, kList},
                        GRow{3480, G::Mode, Changes::Path, {}, kList},
                        GRow{50, G::Mode, Changes::Path, {}, kList},
                        GRow{70, G::Mode, Changes::Path, {}, kList},
                        GRow{160, G::Mode, Changes::Path, {}, kList},
                        GRow{330, G::MotionMode, Changes::Path, {}, kMotion},
                        GRow{340, G::MotionMode, Changes::Path, {}, kMotion},
                        GRow{350, G::MotionMode, Changes::Path, {}, kMotion},
                        GRow{630, G::MotionMode, Changes::Path, {}, kMotion},
                        GRow{3310, G::MotionMode, Changes::Path, {}, kMotion},
                        GRow{3320, G::MotionMode, Changes::Path, {}, kMotion},
                        GRow{740, G::TakesBlock, Changes::Path, {}, kList},
                        GRow{580, G::TakesBlock, Changes::Path, {}, kList},
                        GRow{590, G::TakesBlock, Changes::Path, {}, kList},
                        GRow{250, G::TakesBlock, Changes::Path, {}, kList},
                        GRow{260, G::TakesBlock, Changes::Path, {}, kList},
                        GRow{100, G::TakesBlock, Changes::Path, {}, kIsoMode},
                        GRow{280, G::TakesBlock, Changes::Path, {}, kIsoMode},
                        GRow{300, G::TakesBlock, Changes::Path, {}, kIsoMode},
                        GRow{510, G::TakesBlock, Changes::Path, {}, kIsoMode},
                        GRow{520, G::TakesBlock, Changes::Path, {}, kIsoMode},
                        GRow{680, G::TakesBlock, Changes::Path, {}, kIsoMode},
                        GRow{920, G::TakesBlock, Changes::Path, {}, kIsoMode},
                        GRow{750, G::FixedPoint, Changes::Path, {}, kMotion}};

constexpr std::array kM{MRow{2, MEffect::End, Changes::Path, kAuxiliary},
                        MRow{30, MEffect::End, Changes::Path, kAuxiliary},
                        MRow{17, MEffect::Return, Changes::Path, kAuxiliary},
                        MRow{98, MEffect::Call, Changes::Path, kIsoMode},
                        MRow{99, MEffect::Return, Changes::Path, kIsoMode},
                        MRow{0, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{1, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{3, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{4, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{5, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{6, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{19, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{40, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{41, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{42, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{43, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{44, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{45, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{70, MEffect::None, Changes::Nothing, kAuxiliary},
                        MRow{7, MEffect::None, Changes::Nothing, kIso},
                        MRow{8, MEffect::None, Changes::Nothing, kIso},
                        MRow{9, MEffect::None, Changes::Nothing, kIso},
                        MRow{10, MEffect::None, Changes::Nothing, kIso},
                        MRow{11, MEffect::None, Changes::Nothing, kIso},
                        MRow{13, MEffect::None, Changes::Nothing, kIso},
                        MRow{14, MEffect::None, Changes::Nothing, kIso},
                        MRow{48, MEffect::None, Changes::Nothing, kIso},
                        MRow{49, MEffect::None, Changes::Nothing, kIso}};

/// Names without effect on the path.
void addIgnored(NameTable& table) {
  // Dynamics, look-ahead, compressor: how exactly and how softly, not where.
  table.add(NameEffect::None, kPath,
            {"SOFTA",     "BRISKA",   "DRIVEA",   "FFWON",    "FFWOF",    "COMPOF",     "COMPON",
             "COMPCAD",   "COMPCURV", "COMPSURF", "COMPPATH", "UPATH",    "SPATH",      "FIFOCTRL",
             "STARTFIFO", "STOPFIFO", "STOPRE",   "CFC",      "CFTCP",    "CFIN",       "FNORM",
             "CPRECON",   "CPRECOF",  "DYNNORM",  "DYNPOS",   "DYNROUGH", "DYNSEMIFIN", "DYNFINISH",
             "DYNPREC",   "RTLION",   "RTLIOF",   "ADISPOS",  "CTOL",     "OTOL",       "CYCLE832",
             "ACC",       "ACCLIMA",  "VELOLIMA", "JERKLIMA", "PACCLIM"});
  // States that are the default, or that guard and do not move; orientation of the tool.
  table.add(NameEffect::None, kRadius,
            {"CUT2D",    "CUT2DF", "CUT3DC",   "CUT3DF",   "CUTCONON", "CUTCONOF", "WALIMON",
             "WALIMOF",  "CDOF",   "CDON",     "CDOF2",    "NORM",     "KONT",     "KONTC",
             "KONTT",    "DISC",   "OFFN",     "ORIWKS",   "ORIMKS",   "ORIAXES",  "ORIVECT",
             "ORIEULER", "ORIRPY", "ORIRPY2",  "ORIVIRT1", "ORIVIRT2", "ORIC",     "ORID",
             "ORISON",   "ORISOF", "ORIRESET", "ORIPLANE", "LEAD",     "TILT",     "TCARR",
             "TCOABS",   "TCOFR",  "TOFFOF",   "TOWSTD",   "TOWMCS",   "TOWWCS"});
  // An offset of the tool's length, which the control alone knows.
  table.add(NameEffect::Mode, kTool, {"TOFFL"});
  // Spindle, tool, display, and what a program says of itself.
  table.add(
      NameEffect::None, kAuxiliary,
      {"SPOS",        "SPOSA",     "SETMS",        "SPCON",    "SPCOF",   "MSG",    "WORKPIECE",
       "GROUP_BEGIN", "GROUP_END", "GROUP_ADDEND", "DISPLOF",  "DISPLON", "SBLOF",  "SBLON",
       "ACTBLOCNO",   "SETPIECE",  "SETAL",        "DELDTG",   "WAITM",   "WAITMC", "WAITE",
       "WAITP",       "GETSELT",   "NEWCONF",      "EXTCLOSE", "WRITE",   "ENABLE", "DISABLE",
       "SVC",         "DL",        "TLIFT",        "ISD"});
  table.add(NameEffect::None, kJob, {"CLRINT", "PRIO", "BLSYNC"});
}

NameTable sharedNames() {
  NameTable table;
  addIgnored(table);
  table.add(NameEffect::Dynamics, kPath, {"SOFT", "BRISK", "DRIVE"});
  table.add(NameEffect::Rounding, kPath, {"ADIS"});
  table.add(NameEffect::FeedGroup, kFeed, {"FGROUP"});
  // "Path feed", "Feedrate with handwheel override", "Limiting the velocity of synchronous axes".
  table.add(NameEffect::BlockFeed, kFeed, {"FB"});
  table.add(NameEffect::Override, kFeed, {"OVR"});
  table.add(NameEffect::OtherOverride, kFeed, {"OVRRAP", "OVRA"});
  table.add(NameEffect::SpeedLimit, kSpindle, {"LIMS"});
  table.add(NameEffect::Feed, kFeed, {"FZ", "FL", "FD", "FA", "FLIN", "FCUB", "FGREF", "VELOLIM"});
  table.add(NameEffect::Query, kJob, {"GETT", "GETDNO", "DELETE", "READ", "ISFILE", "GETFREELOC"});
  table.add(NameEffect::End, kJob, {"RET"});
  // Another form of the path in a block that moves.
  table.add(NameEffect::Mode, kMotion,
            {"RND", "RNDM", "FRC", "FRCM", "CHF", "CHR", "ANG", "ANG1", "PO", "DISR", "DISCL",
             "DISRP", "OSCILL", "POS", "POSA", "POSP", "G290"});
  // Group 1, as G0 to G3 and BSPLINE: in force until another of them.
  table.add(NameEffect::OtherCurve, kMotion, {"INVCW", "INVCCW", "ASPLINE", "CSPLINE", "POLY"});
  // Groups 19 and 20: how ASPLINE and CSPLINE begin and end; no other motion heeds them.
  table.add(NameEffect::None, kSplines, {"BAUTO", "BNAT", "BTAN", "EAUTO", "ENAT", "ETAN"});
  // A text that becomes a block while the program runs; axes that follow others, or get another
  // place; blocks that stand in a text of another control.
  table.add(NameEffect::TakesBlock, kJob,
            {"EXECSTRING", "EXECTAB",  "ISOCALL",  "PRESETON", "PRESETONS", "LEADON",
             "LEADOF",     "TRAILOF",  "COUPDEF",  "COUPOF",   "COUPRES",   "EGDEF",
             "EGOFS",      "EGOFC",    "TANG",     "TANGON",   "TANGOF",    "CTABDEF",
             "CTABEND",    "LIFTFAST", "POLFMASK", "POLFMLIN", "CROTS",     "MEAFRAME",
             "PUTFTOC",    "PUTFTOCF", "FTOCON",   "FTOCOF",   "REPOSL",    "REPOSQ",
             "REPOSQA",    "REPOSH",   "REPOSHA",  "REPOSA",   "DRFOF",     "AXTOCHAN"});
  // Frames of other kinds, and transformations that change what X, Y, Z mean.
  table.add(
      NameEffect::TakesBlock, kJob,
      {"ROTS",     "AROTS",    "TRANSMIT", "TRACYL", "TRAANG",  "TRACON",  "TRAFOON", "TOFRAME",
       "TOFRAMEX", "TOFRAMEY", "TOFRAMEZ", "TOROT",  "TOROTOF", "PAROT",   "PAROTOF", "MEAS",
       "MEAW",     "MEASA",    "MEAWA",    "COUPON", "EGON",    "TRAILON", "FXS",     "GEOAX"});
  table.add(NameEffect::Cycle, kCycles,
            {"CYCLE800", "CYCLE60", "CYCLE61",  "CYCLE62",  "CYCLE63",  "CYCLE64",  "CYCLE70",
             "CYCLE71",  "CYCLE72", "CYCLE73",  "CYCLE74",  "CYCLE75",  "CYCLE76",  "CYCLE77",
             "CYCLE78",  "CYCLE79", "CYCLE81",  "CYCLE82",  "CYCLE83",  "CYCLE84",  "CYCLE840",
             "CYCLE85",  "CYCLE86", "CYCLE87",  "CYCLE88",  "CYCLE89",  "CYCLE90",  "CYCLE92",
             "CYCLE93",  "CYCLE94", "CYCLE95",  "CYCLE951", "CYCLE952", "CYCLE96",  "CYCLE97",
             "CYCLE98",  "CYCLE99", "CYCLE899", "CYCLE976", "CYCLE977", "CYCLE978", "CYCLE979",
             "HOLES1",   "HOLES2",  "LONGHOLE", "SLOT1",    "SLOT2",    "POCKET1",  "POCKET2",
             "POCKET3",  "POCKET4", "CYCLE801", "CYCLE802"});
  table.add(NameEffect::Frame, kFrames,
            {"TRANS", "ATRANS", "ROT", "AROT", "SCALE", "ASCALE", "MIRROR", "AMIRROR"});
  table.add(NameEffect::Motion, kMotion, {"CIP", "CT"});
  table.add(NameEffect::Spline, kJob, {"BSPLINE"});
  table.add(NameEffect::MachineMove, kGeometry, {"SUPA"});
  table.add(NameEffect::Diameter, kGeometry, {"DIAMON", "DIAMOF", "DIAM90"});
  table.add(NameEffect::Transformation, kJob, {"TRAORI", "TRAFOOF"});
  table.add(NameEffect::Address, kMotion,
            {"CR", "AR", "AP", "RP", "RPL", "TURN", "I1", "J1", "K1", "A3", "B3", "C3", "A2", "B2",
             "C2", "PW", "SD", "PL"});
  // Of G75 alone: the fixed point, and the axes of the machine.
  table.add(NameEffect::MachineAxis, kMotion, {"FP", "X1", "Y1", "Z1", "B1"});
  return table;
}

}  // namespace

DialectWords words() {
  return {GTable(kG), kM, sharedNames()};
}

}  // namespace rivulet::nc::sinumerik

namespace rivulet::nc {

std::optional<int> gOfGroup(int group, int number) {
  struct Group {
    int group;
    std::array<int, 6> keys;  ///< of the functions from number 1 on; -1: none
  };
  static constexpr std::array kGroups{
      Group{1, {0, 10, 20, 30, -1, -1}},          Group{6, {170, 180, 190, -1, -1, -1}},
      Group{8, {5000, 540, 550, 560, 570, 5050}}, Group{10, {600, 640, 6410, 6420, 6430, 6440}},
      Group{13, {700, 710, 7000, 7100, -1, -1}},  Group{14, {900, 910, -1, -1, -1, -1}},
      Group{15, {930, 940, 950, 960, 970, -1}},
  };
  // The settable frames go on: 7 is G506.
  constexpr int kLastListed = 6;
  if (group == 8 && number > kLastListed && number <= 100) {
    return 5050 + 10 * (number - kLastListed);
  }
  const auto* const found = std::find_if(kGroups.begin(), kGroups.end(),
                                         [group](const Group& g) { return g.group == group; });
  if (found == kGroups.end() || number < 1 || number > kLastListed) {
    return std::nullopt;
  }
  const int key = found->keys[static_cast<std::size_t>(number - 1)];
  return key < 0 ? std::nullopt : std::optional(key);
}

}  // namespace rivulet::nc
