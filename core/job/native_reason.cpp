// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/native_reason.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/text.h"
#include "nc/modal/vocabulary.h"

namespace rivulet::job {

namespace {

using nc::FaultCode;
using nc::GEffect;

constexpr std::array<NativeReasonRow, kNativeReasonCount> kRows{{
    {NativeReason::Transformation, "transformation",
     "it swivels or transforms the coordinates, or lies between such blocks",
     PositionAfter::ControlOnly},
    {NativeReason::RadiusCompensation, "radius-compensation",
     "it switches the tool radius compensation, or moves with it", PositionAfter::Known},
    {NativeReason::Cycle, "cycle", "it is a cycle of the control, or a position for one",
     PositionAfter::ControlOnly},
    {NativeReason::Subprogram, "subprogram", "it calls a subprogram that is not at hand",
     PositionAfter::ControlOnly},
    {NativeReason::Probing, "probing", "it measures, or asks the control for a value",
     PositionAfter::ControlOnly},
    {NativeReason::Retract, "retract", "it moves in machine coordinates or to a fixed point",
     PositionAfter::ControlOnly},
    {NativeReason::OtherMotion, "other-motion",
     "the control makes the path: a thread, a spline, a positioning axis",
     PositionAfter::ControlOnly},
    {NativeReason::Corner, "corner", "the control rounds or chamfers the corner to the next motion",
     PositionAfter::Known},
    {NativeReason::UnknownPosition, "unknown-position",
     "it counts from a position that only the control knows", PositionAfter::Known},
    {NativeReason::Tool, "tool", "it selects or changes the tool or its length",
     PositionAfter::ControlOnly},
    {NativeReason::WorkOffset, "work-offset", "it selects or sets a work offset",
     PositionAfter::ControlOnly},
    {NativeReason::Spindle, "spindle", "it is for the spindle", PositionAfter::Known},
    {NativeReason::Coolant, "coolant", "it is for the coolant", PositionAfter::Known},
    {NativeReason::Stop, "stop", "the program stops until cycle start", PositionAfter::Known},
    {NativeReason::Dwell, "dwell", "the program dwells", PositionAfter::Known},
    {NativeReason::Message, "message", "it is shown at the control", PositionAfter::Known},
    {NativeReason::Mode, "mode", "it sets how the control moves", PositionAfter::Known},
    {NativeReason::Other, "other", "it is an M function or a variable of the machine",
     PositionAfter::ControlOnly},
    {NativeReason::End, "end", "the program ends", PositionAfter::Known},
}};

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    if (kRows[i].reason != static_cast<NativeReason>(i)) {
      return false;
    }
  }
  return true;
}
static_assert(isInOrder(), "one row for each reason, in the order of the reasons");

template <class Key>
struct Entry {
  Key first;
  Key last;
  NativeReason reason;
};

/// G functions that have no effect on the path, and those that Rivulet does not execute.
constexpr std::array kG{
    Entry<int>{250, 260, NativeReason::Mode},  // limits of spindle and working area
    Entry<int>{280, 300, NativeReason::Retract},
    Entry<int>{301, 301, NativeReason::Retract},
    Entry<int>{310, 310, NativeReason::Probing},
    Entry<int>{330, 350, NativeReason::OtherMotion},
    Entry<int>{380, 385, NativeReason::Probing},
    Entry<int>{410, 421, NativeReason::RadiusCompensation},
    Entry<int>{580, 590, NativeReason::WorkOffset},
    Entry<int>{630, 630, NativeReason::OtherMotion},
    Entry<int>{740, 750, NativeReason::Retract},
    Entry<int>{960, 970, NativeReason::Spindle},
    Entry<int>{1400, 1480, NativeReason::RadiusCompensation},
    Entry<int>{2470, 2480, NativeReason::RadiusCompensation},
    Entry<int>{3310, 3320, NativeReason::OtherMotion},
    Entry<int>{3400, 3480, NativeReason::RadiusCompensation},
    Entry<int>{4500, 4510, NativeReason::RadiusCompensation},
    Entry<int>{4600, 4620, NativeReason::RadiusCompensation},
    Entry<int>{9610, 9730, NativeReason::Spindle},
};

std::optional<NativeReason> listedG(int key) {
  const auto* const found = std::find_if(kG.begin(), kG.end(), [key](const Entry<int>& entry) {
    return key >= entry.first && key <= entry.last;
  });
  return found == kG.end() ? std::nullopt : std::optional(found->reason);
}

constexpr std::array kM{
    Entry<int>{0, 1, NativeReason::Stop},      Entry<int>{3, 5, NativeReason::Spindle},
    Entry<int>{6, 6, NativeReason::Tool},      Entry<int>{7, 9, NativeReason::Coolant},
    Entry<int>{19, 19, NativeReason::Spindle}, Entry<int>{40, 45, NativeReason::Spindle},
    Entry<int>{70, 70, NativeReason::Spindle},
};

struct Names {
  NativeReason reason;
  std::span<const std::string_view> names;
};

constexpr std::array<std::string_view, 9> kMessages{"MSG",          "WORKPIECE", "GROUP_BEGIN",
                                                    "GROUP_END",    "DISPLOF",   "DISPLON",
                                                    "GROUP_ADDEND", "ACTBLOCNO", "SETAL"};
constexpr std::array<std::string_view, 7> kSpindle{"SPOS",  "SPOSA", "LIMS", "SETMS",
                                                   "SPCON", "SPCOF", "SVC"};
constexpr std::array<std::string_view, 12> kTool{"T",       "TCARR",  "TCOABS", "TCOFR",
                                                 "TOFFOF",  "TOWSTD", "TOWMCS", "TOWWCS",
                                                 "GETSELT", "DL",     "TLIFT",  "SETPIECE"};
constexpr std::array<std::string_view, 17> kCompensation{
    "CUT2D", "CUT2DF", "CUT3DC", "CUT3DF", "CUTCONON", "CUTCONOF", "CDOF", "CDOF2", "CDON",
    "NORM",  "KONT",   "KONTC",  "KONTT",  "DISC",     "OFFN",     "RL",   "RR"};
constexpr std::array<std::string_view, 41> kTransformation{
    "CYCLE800", "TRAORI",   "TRAFOOF", "TRANSMIT", "TRACYL",   "TRAANG",   "TRACON",
    "TRAFOON",  "ROTS",     "AROTS",   "TOFRAME",  "TOFRAMEX", "TOFRAMEY", "TOFRAMEZ",
    "TOROT",    "TOROTOF",  "PAROT",   "PAROTOF",  "GEOAX",    "LEAD",     "TILT",
    "ORIWKS",   "ORIMKS",   "ORIAXES", "ORIVECT",  "ORIEULER", "ORIRPY",   "ORIRPY2",
    "ORIVIRT1", "ORIVIRT2", "ORIC",    "ORID",     "ORISON",   "ORISOF",   "ORIRESET",
    "ORIPLANE", "OSC",      "ORIPATH", "ORICURVE", "ORICONCW", "ORICONCCW"};
constexpr std::array<std::string_view, 14> kProbing{
    "MEAS",   "MEAW",       "MEASA",    "MEAWA",    "GETT",     "GETDNO",   "READ",
    "ISFILE", "GETFREELOC", "CYCLE976", "CYCLE977", "CYCLE978", "CYCLE979", "DELETE"};
constexpr std::array<std::string_view, 23> kOtherMotion{
    "BAUTO", "BNAT",   "BTAN",    "EAUTO",   "ENAT", "ETAN",    "ANG",  "ANG1",
    "INVCW", "INVCCW", "ASPLINE", "CSPLINE", "POLY", "PO",      "DISR", "DISCL",
    "DISRP", "OSCILL", "POS",     "POSA",    "POSP", "TRAILON", "FXS"};
constexpr std::array<std::string_view, 8> kCorners{"RND", "RNDM", "FRC", "FRCM",
                                                   "CHF", "CHR",  ",R",  ",C"};
constexpr std::array<std::string_view, 1> kRetract{"M140"};
constexpr std::array<std::string_view, 20> kOther{
    "WAITM",  "WAITMC",  "WAITE",  "WAITP", "NEWCONF", "EXTCLOSE", "WRITE",
    "ENABLE", "DISABLE", "DELDTG", "SBLOF", "SBLON",   "WALIMON",  "WALIMOF",
    "CLRINT", "PRIO",    "COUPON", "EGON",  "SETINT",  "BLSYNC"};
/// How the control moves: the loop has its own.
constexpr std::array<std::string_view, 36> kModes{
    "SOFTA",    "BRISKA",     "DRIVEA",    "FFWON",    "FFWOF",    "COMPOF",
    "COMPON",   "COMPCAD",    "COMPCURV",  "COMPSURF", "COMPPATH", "UPATH",
    "SPATH",    "FIFOCTRL",   "CPRECON",   "CPRECOF",  "DYNNORM",  "DYNPOS",
    "DYNROUGH", "DYNSEMIFIN", "DYNFINISH", "DYNPREC",  "RTLION",   "RTLIOF",
    "CTOL",     "OTOL",       "CYCLE832",  "FGROUP",   "FGREF",    "ACC",
    "ACCLIMA",  "VELOLIMA",   "JERKLIMA",  "OVR",      "OVRRAP",   "OVRA"};

constexpr std::array kNames{
    Names{NativeReason::Message, kMessages},
    Names{NativeReason::Spindle, kSpindle},
    Names{NativeReason::Tool, kTool},
    Names{NativeReason::RadiusCompensation, kCompensation},
    Names{NativeReason::Transformation, kTransformation},
    Names{NativeReason::Probing, kProbing},
    Names{NativeReason::OtherMotion, kOtherMotion},
    Names{NativeReason::Corner, kCorners},
    Names{NativeReason::Retract, kRetract},
    Names{NativeReason::Other, kOther},
    Names{NativeReason::Mode, kModes},
};

/// "G54" → 540; nothing: no G function.
std::optional<int> keyOf(std::string_view word) {
  const std::optional<double> number =
      word.size() > 1 && word.front() == 'G' ? base::parseNumber(word.substr(1)) : std::nullopt;
  const bool isOne = number && *number >= 0.0 && *number < 1000.0;
  return isOne ? std::optional(static_cast<int>(std::lround(*number * 10.0))) : std::nullopt;
}

}  // namespace

const NativeReasonRow& rowOf(NativeReason reason) {
  return kRows[static_cast<std::size_t>(reason)];
}

std::optional<NativeReason> nativeReasonFromName(std::string_view name) {
  const auto row = std::find_if(kRows.begin(), kRows.end(),
                                [name](const NativeReasonRow& each) { return each.name == name; });
  return row == kRows.end() ? std::nullopt : std::optional(row->reason);
}

std::optional<NativeReason> reasonOfG(nc::Dialect dialect, int key) {
  switch (nc::gTable(dialect)[static_cast<std::size_t>(key)]) {
    case GEffect::Dwell:
      return NativeReason::Dwell;
    case GEffect::ToolLength:
      return NativeReason::Tool;
    case GEffect::WorkOffset:
    case GEffect::WorkOffsetP:
    case GEffect::SetWorkOffset:
      return NativeReason::WorkOffset;
    case GEffect::MachineMove:
      return NativeReason::Retract;
    case GEffect::Cycle:
      return NativeReason::Cycle;
    case GEffect::None:
    case GEffect::FixedPoint:
    case GEffect::Compensation:
    case GEffect::Mode:
    case GEffect::MotionMode:
    case GEffect::TakesBlock:
      return listedG(key);
    default:
      return std::nullopt;
  }
}

NativeReason reasonOfM(int number) {
  const auto* const found = std::find_if(kM.begin(), kM.end(), [number](const Entry<int>& entry) {
    return number >= entry.first && number <= entry.last;
  });
  return found == kM.end() ? NativeReason::Other : found->reason;
}

std::optional<NativeReason> reasonOfName(std::string_view name) {
  for (const Names& each : kNames) {
    if (std::find(each.names.begin(), each.names.end(), name) != each.names.end()) {
      return each.reason;
    }
  }
  return std::nullopt;
}

std::optional<NativeReason> reasonOfFault(nc::Dialect dialect, FaultCode code,
                                          std::string_view word) {
  switch (code) {
    case FaultCode::CycleNotRun:
      return reasonOfName(word).value_or(NativeReason::Cycle);
    case FaultCode::SubprogramMissing:
      return NativeReason::Subprogram;
    case FaultCode::MachineCoordinates:
      return NativeReason::Retract;
    case FaultCode::RelativeFromUnknownPosition:
    case FaultCode::ArcFromUnknownPosition:
      return NativeReason::UnknownPosition;
    case FaultCode::UnsupportedGCode: {
      const std::optional<int> key = keyOf(word);
      return key ? reasonOfG(dialect, *key) : reasonOfName(word);
    }
    case FaultCode::UnknownWord:
      // $P_UIFR[1,X,TR]=5 sets a variable of the control.
      return !word.empty() && word.front() == '$' ? std::optional(NativeReason::Other)
                                                  : std::nullopt;
    default:
      return std::nullopt;
  }
}

}  // namespace rivulet::job
