// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/modal/vocabulary.h"

#include <algorithm>
#include <initializer_list>
#include <span>
#include <unordered_map>

namespace rivulet::nc {

namespace {

/// Marks functions of a table, by key; what is marked later wins.
class GMarks {
 public:
  explicit GMarks(GTable& table) : m_table(table) {}
  void operator()(GEffect effect, std::initializer_list<int> keys) const {
    for (const int key : keys) {
      m_table[static_cast<std::size_t>(key)] = effect;
    }
  }

 private:
  GTable& m_table;
};

/// What all dialects share.
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
  mark(GEffect::Tolerance, {610, 611, 640});
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
  mark(GEffect::None, {400, 434, 50, 51, 1870, 1030, 690, 960, 970, 980, 990, 501, 670});
  mark(GEffect::Mode, {410, 420, 435});
  // Motions Rivulet does not make.
  mark(GEffect::MotionMode, {60, 61, 62, 310, 320, 330, 331, 340, 350, 380, 382, 383, 384, 385});
  mark(GEffect::Cycle, {120, 130, 720, 730, 740, 750, 760, 770, 810, 820, 830, 840, 841, 842, 850,
                        860, 870, 880, 890});
  mark(GEffect::TakesBlock,
       {922, 923, 100, 110, 250, 260, 270, 280, 281, 290, 300, 301, 510, 511, 660, 680, 682});
}

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

GTable makeTable(Dialect dialect) {
  GTable table{};
  const GMarks mark(table);
  markCommon(mark);
  switch (dialect) {
    case Dialect::Sinumerik:
      markSinumerik(mark);
      break;
    case Dialect::LinuxCnc:
      mark(GEffect::Spline, {50, 51, 52, 53, 62});
      mark(GEffect::SuspendPosition, {922});
      mark(GEffect::RestorePosition, {923});
      mark(GEffect::SetWorkOffset, {100});
      mark(GEffect::Cycle, {740});
      mark(GEffect::None, {610});
      break;
    case Dialect::Heidenhain:
      mark(GEffect::Pole, {1100, 1110});
      break;
    case Dialect::Grbl:
    case Dialect::Iso:
      break;
  }
  return table;
}

using NameTable = std::unordered_map<std::string_view, NameEffect>;

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

MEffect mEffect(Dialect dialect, int number) {
  struct Function {
    int number;
    MEffect effect;
  };
  static constexpr std::array kCommon{
      Function{2, MEffect::End},      Function{30, MEffect::End},
      Function{98, MEffect::Call},    Function{99, MEffect::Return},
      Function{96, MEffect::Refused}, Function{97, MEffect::Refused}};
  static constexpr std::array kSinumerik{Function{17, MEffect::Return}};
  static constexpr std::array kPlain{
      Function{91, MEffect::MachineMove}, Function{92, MEffect::MachineMove},
      Function{99, MEffect::CycleCall}, Function{140, MEffect::Retract}};
  static constexpr std::array<std::span<const Function>, kDialects.size()> kOwn{
      kSinumerik, {}, {}, {}, kPlain};
  for (const std::span<const Function> functions :
       {kOwn[static_cast<std::size_t>(dialect)], std::span<const Function>(kCommon)}) {
    const auto found =
        std::find_if(functions.begin(), functions.end(),
                     [number](const Function& each) { return each.number == number; });
    if (found != functions.end()) {
      return found->effect;
    }
  }
  return MEffect::None;
}

NameEffect nameEffect(Dialect dialect, std::string_view name) {
  static const NameTable shared = sharedNames();
  static const NameTable plain{{"CT", NameEffect::Motion},  {"AP", NameEffect::Address},
                               {"RP", NameEffect::Address}, {"A3", NameEffect::Address},
                               {"B3", NameEffect::Address}, {"C3", NameEffect::Address},
                               {"BLK", NameEffect::None},   {"TOOL", NameEffect::None}};
  static const std::array<const NameTable*, kDialects.size()> tables{&shared, &shared, &shared,
                                                                     &shared, &plain};
  const NameTable& names = *tables[static_cast<std::size_t>(dialect)];
  const auto found = names.find(name);
  return found == names.end() ? NameEffect::Unknown : found->second;
}

}  // namespace rivulet::nc
