// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/modal/vocabulary.h"

#include <algorithm>
#include <initializer_list>
#include <span>
#include <unordered_map>

namespace rivulet::nc {

namespace {

struct GEntry {
  int key;
  GEffect effect;
};

/// What all dialects share; a dialect's own list comes after it and wins.
constexpr std::array kCommonG{
    GEntry{0, GEffect::Motion},
    GEntry{10, GEffect::Motion},
    GEntry{20, GEffect::Motion},
    GEntry{30, GEffect::Motion},
    GEntry{40, GEffect::Dwell},
    GEntry{90, GEffect::None},  // exact stop of one block
    GEntry{170, GEffect::Plane},
    GEntry{180, GEffect::Plane},
    GEntry{190, GEffect::Plane},
    GEntry{200, GEffect::Units},
    GEntry{210, GEffect::Units},
    GEntry{700, GEffect::Units},
    GEntry{710, GEffect::Units},
    GEntry{400, GEffect::None},  // radius compensation off
    GEntry{410, GEffect::Mode},
    GEntry{420, GEffect::Mode},
    GEntry{430, GEffect::ToolLength},
    GEntry{431, GEffect::ToolLength},
    GEntry{440, GEffect::ToolLength},
    GEntry{490, GEffect::ToolLength},
    GEntry{434, GEffect::None},  // the tool's tip is guided: X, Y, Z are its own
    GEntry{435, GEffect::Mode},
    GEntry{530, GEffect::MachineMove},
    GEntry{540, GEffect::WorkOffset},
    GEntry{550, GEffect::WorkOffset},
    GEntry{560, GEffect::WorkOffset},
    GEntry{570, GEffect::WorkOffset},
    GEntry{580, GEffect::WorkOffset},
    GEntry{590, GEffect::WorkOffset},
    GEntry{591, GEffect::WorkOffset},
    GEntry{592, GEffect::WorkOffset},
    GEntry{593, GEffect::WorkOffset},
    GEntry{541, GEffect::WorkOffsetP},
    GEntry{1540, GEffect::WorkOffsetP},
    GEntry{600, GEffect::None},
    GEntry{610, GEffect::Tolerance},
    GEntry{611, GEffect::Tolerance},
    GEntry{640, GEffect::Tolerance},
    GEntry{690, GEffect::None},
    GEntry{800, GEffect::CycleOff},
    GEntry{900, GEffect::Distance},
    GEntry{910, GEffect::Distance},
    GEntry{901, GEffect::CentreMode},
    GEntry{911, GEffect::CentreMode},
    GEntry{930, GEffect::FeedMode},
    GEntry{940, GEffect::FeedMode},
    GEntry{950, GEffect::FeedMode},
    GEntry{960, GEffect::None},
    GEntry{970, GEffect::None},
    GEntry{980, GEffect::None},
    GEntry{990, GEffect::None},
    GEntry{150, GEffect::PolarOff},
    GEntry{160, GEffect::PolarOn},
    GEntry{70, GEffect::Diameter},
    GEntry{80, GEffect::Diameter},
    GEntry{520, GEffect::LocalOffset},
    GEntry{920, GEffect::SetPosition},
    GEntry{921, GEffect::ResetPosition},
    GEntry{922, GEffect::TakesBlock},
    GEntry{923, GEffect::TakesBlock},
    // High-speed modes: how exactly, not where.
    GEntry{50, GEffect::None},
    GEntry{51, GEffect::None},
    GEntry{1870, GEffect::None},
    GEntry{1030, GEffect::None},
    // Motions Rivulet does not make.
    GEntry{60, GEffect::MotionMode},
    GEntry{61, GEffect::MotionMode},
    GEntry{62, GEffect::MotionMode},
    GEntry{120, GEffect::Cycle},
    GEntry{130, GEffect::Cycle},
    GEntry{310, GEffect::MotionMode},
    GEntry{320, GEffect::MotionMode},
    GEntry{330, GEffect::MotionMode},
    GEntry{331, GEffect::MotionMode},
    GEntry{340, GEffect::MotionMode},
    GEntry{350, GEffect::MotionMode},
    GEntry{380, GEffect::MotionMode},
    GEntry{382, GEffect::MotionMode},
    GEntry{383, GEffect::MotionMode},
    GEntry{384, GEffect::MotionMode},
    GEntry{385, GEffect::MotionMode},
    GEntry{720, GEffect::Cycle},
    GEntry{730, GEffect::Cycle},
    GEntry{740, GEffect::Cycle},
    GEntry{750, GEffect::Cycle},
    GEntry{760, GEffect::Cycle},
    GEntry{770, GEffect::Cycle},
    GEntry{810, GEffect::Cycle},
    GEntry{820, GEffect::Cycle},
    GEntry{830, GEffect::Cycle},
    GEntry{840, GEffect::Cycle},
    GEntry{841, GEffect::Cycle},
    GEntry{842, GEffect::Cycle},
    GEntry{850, GEffect::Cycle},
    GEntry{860, GEffect::Cycle},
    GEntry{870, GEffect::Cycle},
    GEntry{880, GEffect::Cycle},
    GEntry{890, GEffect::Cycle},
    GEntry{100, GEffect::TakesBlock},
    GEntry{110, GEffect::TakesBlock},
    GEntry{250, GEffect::TakesBlock},
    GEntry{260, GEffect::TakesBlock},
    GEntry{270, GEffect::TakesBlock},
    GEntry{280, GEffect::TakesBlock},
    GEntry{281, GEffect::TakesBlock},
    GEntry{290, GEffect::TakesBlock},
    GEntry{300, GEffect::TakesBlock},
    GEntry{301, GEffect::TakesBlock},
    GEntry{500, GEffect::TakesBlock},
    GEntry{510, GEffect::TakesBlock},
    GEntry{511, GEffect::TakesBlock},
    GEntry{501, GEffect::None},
    GEntry{650, GEffect::MacroCall},
    GEntry{660, GEffect::TakesBlock},
    GEntry{670, GEffect::None},
    GEntry{680, GEffect::TakesBlock},
    GEntry{682, GEffect::TakesBlock},
};

constexpr std::array kSinumerikG{
    GEntry{7000, GEffect::Units},
    GEntry{7100, GEffect::Units},
    GEntry{5000, GEffect::WorkOffset},
    GEntry{1530, GEffect::MachineMove},
    GEntry{601, GEffect::None},
    GEntry{6010, GEffect::None},
    GEntry{6020, GEffect::None},
    GEntry{6030, GEffect::None},
    GEntry{6410, GEffect::Tolerance},
    GEntry{6420, GEffect::Tolerance},
    GEntry{6430, GEffect::Tolerance},
    GEntry{6440, GEffect::Tolerance},
    GEntry{6450, GEffect::Tolerance},
    // Corners and approaches of a radius compensation that is off.
    GEntry{4500, GEffect::None},
    GEntry{4510, GEffect::None},
    GEntry{4600, GEffect::None},
    GEntry{4610, GEffect::None},
    GEntry{4620, GEffect::None},
    GEntry{1400, GEffect::None},
    GEntry{1410, GEffect::None},
    GEntry{1420, GEffect::None},
    GEntry{1430, GEffect::None},
    GEntry{3400, GEffect::None},
    GEntry{3410, GEffect::None},
    GEntry{2900, GEffect::None},  // SINUMERIK language
    GEntry{2910, GEffect::Mode},
    GEntry{9510, GEffect::FeedMode},
    GEntry{9610, GEffect::FeedMode},
    GEntry{9310, GEffect::FeedMode},
    GEntry{9620, GEffect::None},
    GEntry{9720, GEffect::None},
    GEntry{9730, GEffect::None},
    GEntry{9710, GEffect::None},
    GEntry{1100, GEffect::Pole},
    GEntry{1110, GEffect::Pole},
    GEntry{1120, GEffect::Pole},
    GEntry{1470, GEffect::Mode},
    GEntry{1480, GEffect::Mode},
    GEntry{2470, GEffect::Mode},
    GEntry{2480, GEffect::Mode},
    GEntry{3470, GEffect::Mode},
    GEntry{3480, GEffect::Mode},
    GEntry{630, GEffect::MotionMode},
    GEntry{3310, GEffect::MotionMode},
    GEntry{3320, GEffect::MotionMode},
    GEntry{740, GEffect::TakesBlock},
    GEntry{750, GEffect::TakesBlock},
    GEntry{50, GEffect::Mode},
    GEntry{51, GEffect::Unknown},
    GEntry{70, GEffect::Mode},
    GEntry{80, GEffect::Unknown},
    GEntry{580, GEffect::TakesBlock},  // axial programmable offsets
    GEntry{590, GEffect::TakesBlock},
    GEntry{150, GEffect::None},
    GEntry{160, GEffect::Mode},
};

constexpr std::array kLinuxCncG{
    GEntry{50, GEffect::Spline}, GEntry{51, GEffect::Spline}, GEntry{52, GEffect::Spline},
    GEntry{53, GEffect::Spline}, GEntry{740, GEffect::Cycle}, GEntry{610, GEffect::None},
};

constexpr std::array kHeidenhainG{
    GEntry{1100, GEffect::Pole},
    GEntry{1110, GEffect::Pole},
};

std::span<const GEntry> ownG(Dialect dialect) {
  switch (dialect) {
    case Dialect::Sinumerik:
      return kSinumerikG;
    case Dialect::LinuxCnc:
      return kLinuxCncG;
    case Dialect::Heidenhain:
      return kHeidenhainG;
    case Dialect::Grbl:
    case Dialect::Iso:
      break;
  }
  return {};
}

GTable makeTable(Dialect dialect) {
  GTable table{};
  for (const GEntry& entry : kCommonG) {
    table[static_cast<std::size_t>(entry.key)] = entry.effect;
  }
  // Settable frames G505 to G599 of a SINUMERIK are beyond the numbers of the others.
  for (std::size_t key = 5050; key <= 5990 && dialect == Dialect::Sinumerik; key += 10) {
    table[key] = GEffect::WorkOffset;
  }
  for (const GEntry& entry : ownG(dialect)) {
    table[static_cast<std::size_t>(entry.key)] = entry.effect;
  }
  return table;
}

using NameTable = std::unordered_map<std::string_view, NameEffect>;

NameTable makeNames() {
  NameTable table;
  const auto add = [&table](NameEffect effect, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
      table.emplace(name, effect);
    }
  };
  // Dynamics, look-ahead, compressor: how exactly and how softly, not where.
  add(NameEffect::None,
      {"SOFT",    "SOFTA",  "BRISK",    "BRISKA",     "DRIVE",     "DRIVEA",   "FFWON",
       "FFWOF",   "COMPOF", "COMPON",   "COMPCAD",    "COMPCURV",  "COMPSURF", "COMPPATH",
       "UPATH",   "SPATH",  "FIFOCTRL", "STARTFIFO",  "STOPFIFO",  "STOPRE",   "CFC",
       "CFTCP",   "CFIN",   "FNORM",    "FLIN",       "FCUB",      "CPRECON",  "CPRECOF",
       "DYNNORM", "DYNPOS", "DYNROUGH", "DYNSEMIFIN", "DYNFINISH", "DYNPREC",  "RTLION",
       "RTLIOF",  "ADIS",   "ADISPOS",  "CTOL",       "OTOL",      "CYCLE832", "FGROUP",
       "FGREF",   "FL",     "ACC",      "ACCLIMA",    "VELOLIMA",  "JERKLIMA", "PACCLIM",
       "OVR",     "OVRRAP", "OVRA",     "FB",         "FD",        "FA",       "FZ"});
  // States that are the default, or that guard and do not move; orientation of the tool.
  add(NameEffect::None,
      {"CUT2D",    "CUT2DF", "CUT3DC",   "CUT3DF",   "CUTCONON", "CUTCONOF", "WALIMON",
       "WALIMOF",  "CDOF",   "CDON",     "CDOF2",    "NORM",     "KONT",     "KONTC",
       "KONTT",    "DISC",   "OFFN",     "ORIWKS",   "ORIMKS",   "ORIAXES",  "ORIVECT",
       "ORIEULER", "ORIRPY", "ORIRPY2",  "ORIVIRT1", "ORIVIRT2", "ORIC",     "ORID",
       "ORISON",   "ORISOF", "ORIRESET", "ORIPLANE", "LEAD",     "TILT",     "TCARR",
       "TCOABS",   "TCOFR",  "TOFFOF",   "GEOAX",    "TOWSTD",   "TOWMCS",   "TOWWCS"});
  // Spindle, tool, display, and what a program says of itself.
  add(NameEffect::None,
      {"SPOS",      "SPOSA",       "LIMS",      "SETMS",        "SPCON",    "SPCOF",   "MSG",
       "WORKPIECE", "GROUP_BEGIN", "GROUP_END", "GROUP_ADDEND", "DISPLOF",  "DISPLON", "SBLOF",
       "SBLON",     "ACTBLOCNO",   "SETPIECE",  "SETAL",        "DELDTG",   "WAITM",   "WAITMC",
       "WAITE",     "WAITP",       "GETSELT",   "NEWCONF",      "EXTCLOSE", "WRITE",   "ENABLE",
       "DISABLE",   "SVC",         "DL",        "TLIFT",        "ISD"});
  add(NameEffect::None, {"CLRINT", "PRIO", "BLSYNC"});
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
  return table;
}

}  // namespace

const GTable& gTable(Dialect dialect) {
  static const std::array<GTable, kDialects.size()> tables = [] {
    std::array<GTable, kDialects.size()> made{};
    for (const Dialect each : kDialects) {
      made[static_cast<std::size_t>(each)] = makeTable(each);
    }
    return made;
  }();
  return tables[static_cast<std::size_t>(dialect)];
}

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

NameEffect nameEffect(Dialect dialect, std::string_view name) {
  if (dialect == Dialect::Heidenhain) {
    static const NameTable plain{{"CT", NameEffect::Motion},  {"AP", NameEffect::Address},
                                 {"RP", NameEffect::Address}, {"A3", NameEffect::Address},
                                 {"B3", NameEffect::Address}, {"C3", NameEffect::Address},
                                 {"BLK", NameEffect::None},   {"TOOL", NameEffect::None}};
    const auto found = plain.find(name);
    return found == plain.end() ? NameEffect::Unknown : found->second;
  }
  static const NameTable names = makeNames();
  const auto found = names.find(name);
  return found == names.end() ? NameEffect::Unknown : found->second;
}

}  // namespace rivulet::nc
