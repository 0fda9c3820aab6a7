// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/sinumerik/sinumerik.h"

#include <algorithm>
#include <array>

namespace rivulet::nc::sinumerik {

namespace {

void markSinumerik(const GMarks& mark) {
  mark(GEffect::Units, {7000, 7100});
  mark(GEffect::WorkOffset, {5000});
  // Settable frames G505 to G599.
  for (int key = 5050; key <= 5990; key += 10) {
    mark(GEffect::WorkOffset, {key});
  }
  mark(GEffect::MachineMove, {1530});
  mark(GEffect::Tolerance, {6410, 6420, 6430, 6440, 6450});
  // Windows of the exact stop; corners and approaches of a radius compensation that is off.
  mark(GEffect::None, {601,  6010, 6020, 6030, 4500, 4510, 4600, 4610, 4620, 1400, 1410,
                       1420, 1430, 3400, 3410, 2900, 9620, 9720, 9730, 9710, 150});
  mark(GEffect::FeedMode, {9310, 9510, 9610});
  mark(GEffect::Pole, {1100, 1110, 1120});
  // G291 is another language; 147 to 348 are smooth approaches; G16 another plane.
  mark(GEffect::Mode, {2910, 1470, 1480, 2470, 2480, 3470, 3480, 50, 70, 160});
  mark(GEffect::MotionMode, {630, 3310, 3320});
  mark(GEffect::TakesBlock, {740, 580, 590});  // G58, G59: axial programmable offsets
  mark(GEffect::FixedPoint, {750});
  mark(GEffect::Compensation, {400, 410, 420});
  mark(GEffect::Unknown, {51, 80});
  mark(GEffect::TakesBlock, {500});
}

/// Names without effect on the path.
void addIgnored(NameTable& table) {
  const auto add = [&table](std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
      table.emplace(name, NameEffect::None);
    }
  };
  // Dynamics, look-ahead, compressor: how exactly and how softly, not where.
  add({"SOFTA",      "BRISKA",    "DRIVEA",   "FFWON",    "FFWOF",   "COMPOF",  "COMPON",
       "COMPCAD",    "COMPCURV",  "COMPSURF", "COMPPATH", "UPATH",   "SPATH",   "FIFOCTRL",
       "STARTFIFO",  "STOPFIFO",  "STOPRE",   "CFC",      "CFTCP",   "CFIN",    "FNORM",
       "FLIN",       "FCUB",      "CPRECON",  "CPRECOF",  "DYNNORM", "DYNPOS",  "DYNROUGH",
       "DYNSEMIFIN", "DYNFINISH", "DYNPREC",  "RTLION",   "RTLIOF",  "ADISPOS", "CTOL",
       "OTOL",       "CYCLE832",  "FGROUP",   "FGREF",    "FL",      "ACC",     "ACCLIMA",
       "VELOLIMA",   "JERKLIMA",  "PACCLIM",  "OVR",      "OVRRAP",  "OVRA",    "FB",
       "FD",         "FA",        "FZ"});
  // States that are the default, or that guard and do not move; orientation of the tool.
  add({"CUT2D",    "CUT2DF", "CUT3DC",   "CUT3DF",   "CUTCONON", "CUTCONOF", "WALIMON",
       "WALIMOF",  "CDOF",   "CDON",     "CDOF2",    "NORM",     "KONT",     "KONTC",
       "KONTT",    "DISC",   "OFFN",     "ORIWKS",   "ORIMKS",   "ORIAXES",  "ORIVECT",
       "ORIEULER", "ORIRPY", "ORIRPY2",  "ORIVIRT1", "ORIVIRT2", "ORIC",     "ORID",
       "ORISON",   "ORISOF", "ORIRESET", "ORIPLANE", "LEAD",     "TILT",     "TCARR",
       "TCOABS",   "TCOFR",  "TOFFOF",   "GEOAX",    "TOWSTD",   "TOWMCS",   "TOWWCS"});
  // Spindle, tool, display, and what a program says of itself.
  add({"SPOS",      "SPOSA",       "LIMS",      "SETMS",        "SPCON",    "SPCOF",   "MSG",
       "WORKPIECE", "GROUP_BEGIN", "GROUP_END", "GROUP_ADDEND", "DISPLOF",  "DISPLON", "SBLOF",
       "SBLON",     "ACTBLOCNO",   "SETPIECE",  "SETAL",        "DELDTG",   "WAITM",   "WAITMC",
       "WAITE",     "WAITP",       "GETSELT",   "NEWCONF",      "EXTCLOSE", "WRITE",   "ENABLE",
       "DISABLE",   "SVC",         "DL",        "TLIFT",        "ISD"});
  add({"CLRINT", "PRIO", "BLSYNC"});
}

NameTable sharedNames() {
  NameTable table;
  addIgnored(table);
  const auto add = [&table](NameEffect effect, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
      table.emplace(name, effect);
    }
  };
  add(NameEffect::Dynamics, {"SOFT", "BRISK", "DRIVE"});
  add(NameEffect::Rounding, {"ADIS"});
  add(NameEffect::Query, {"GETT", "GETDNO", "DELETE", "READ", "ISFILE", "GETFREELOC"});
  add(NameEffect::End, {"RET"});
  // Another form of the path in a block that moves.
  add(NameEffect::Mode, {"RND",   "RNDM",   "FRC",     "FRCM",    "CHF",  "CHR", "ANG",  "ANG1",
                         "INVCW", "INVCCW", "ASPLINE", "CSPLINE", "POLY", "PO",  "DISR", "DISCL",
                         "DISRP", "OSCILL", "POS",     "POSA",    "POSP", "G290"});
  // Frames of other kinds, and transformations that change what X, Y, Z mean.
  add(NameEffect::TakesBlock,
      {"ROTS",     "AROTS",    "TRANSMIT", "TRACYL", "TRAANG",  "TRACON",  "TRAFOON", "TOFRAME",
       "TOFRAMEX", "TOFRAMEY", "TOFRAMEZ", "TOROT",  "TOROTOF", "PAROT",   "PAROTOF", "MEAS",
       "MEAW",     "MEASA",    "MEAWA",    "COUPON", "EGON",    "TRAILON", "FXS"});
  add(NameEffect::Cycle,
      {"CYCLE800", "CYCLE60", "CYCLE61",  "CYCLE62",  "CYCLE63",  "CYCLE64",  "CYCLE70",
       "CYCLE71",  "CYCLE72", "CYCLE73",  "CYCLE74",  "CYCLE75",  "CYCLE76",  "CYCLE77",
       "CYCLE78",  "CYCLE79", "CYCLE81",  "CYCLE82",  "CYCLE83",  "CYCLE84",  "CYCLE840",
       "CYCLE85",  "CYCLE86", "CYCLE87",  "CYCLE88",  "CYCLE89",  "CYCLE90",  "CYCLE92",
       "CYCLE93",  "CYCLE94", "CYCLE95",  "CYCLE951", "CYCLE952", "CYCLE96",  "CYCLE97",
       "CYCLE98",  "CYCLE99", "CYCLE899", "CYCLE976", "CYCLE977", "CYCLE978", "CYCLE979",
       "HOLES1",   "HOLES2",  "LONGHOLE", "SLOT1",    "SLOT2",    "POCKET1",  "POCKET2",
       "POCKET3",  "POCKET4", "CYCLE801", "CYCLE802"});
  add(NameEffect::Frame,
      {"TRANS", "ATRANS", "ROT", "AROT", "SCALE", "ASCALE", "MIRROR", "AMIRROR"});
  add(NameEffect::Motion, {"CIP", "CT"});
  add(NameEffect::Spline, {"BSPLINE"});
  add(NameEffect::MachineMove, {"SUPA"});
  add(NameEffect::Diameter, {"DIAMON", "DIAMOF", "DIAM90"});
  add(NameEffect::Transformation, {"TRAORI", "TRAFOOF"});
  add(NameEffect::Address, {"CR", "AR", "AP", "RP", "RPL", "TURN", "I1", "J1", "K1", "A3", "B3",
                            "C3", "A2", "B2", "C2", "PW", "SD", "PL"});
  // Of G75 alone: the fixed point, and the axes of the machine.
  add(NameEffect::MachineAxis, {"FP", "X1", "Y1", "Z1", "B1"});
  return table;
}

}  // namespace

DialectWords words() {
  static constexpr std::array kM{MFunction{17, MEffect::Return}};
  DialectWords made{{}, kM, sharedNames()};
  const GMarks mark(made.g);
  markCommon(mark);
  markSinumerik(mark);
  return made;
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
      Group{15, {930, 940, 950, -1, -1, -1}},
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
