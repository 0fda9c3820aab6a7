// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/alarm.h"

#include "base/text.h"

namespace rivulet::machine {

namespace {

int numberOf(nc::FaultCode code) {
  using enum nc::FaultCode;
  switch (code) {
    case DivisionByZero:
    case OutOfDomain:
    case NotFinite:
    case ValueUnknown:
      return 14051;
    case NoSuchR:
    case RUnset:
    case IndexOutsideArray:
    case TooManyValues:
      return 17020;
    case NotDefined:
    case OnlyOnControl:
    case NeitherNameNorProgram:
      return 12550;
    case TypeMismatch:
    case OutOfRange:
    case TextCalculated:
    case TooManyArguments:
    case ReferenceNeedsVariable:
    case ReferenceTypeDiffers:
    case ArrayIndexMissing:
    case ArrayTooManyIndices:
    case ArrayTooFewIndices:
    case IndexFromMainRun:
      return 12150;
    case UnknownGCode:
    case UnsupportedGCode:
    case CycleNotRun:
      return 12470;
    case UnknownWord:
      return 12550;
    case ConflictingGCodes:
      return 12060;
    case RepeatedWord:
      return 12010;
    case ArcWithoutCentre:
    case ArcRadiusMismatch:
    case ArcRadiusTooSmall:
    case CentreOutsidePlane:
      return 14040;
    case FeedNotPositive:
      return 14800;
    case FeedMissing:
    case FeedLost:
      return 10860;
    case TargetMissing:
      return 14080;
    case SubprogramMissing:
    case CallsTooDeep:
      return 14011;
    default:
      return 12080;  // syntax error
  }
}

}  // namespace

Alarm alarmOf(const nc::Fault& fault) {
  std::string text = nc::describe(fault);
  text[0] = base::toUpper(std::string_view(text).substr(0, 1))[0];
  return {numberOf(fault.code), text + "."};
}

}  // namespace rivulet::machine
