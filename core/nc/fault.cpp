// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/fault.h"

#include <fmt/format.h>

#include "base/contract.h"

namespace rivulet::nc {

namespace {

/// {} is the argument.
std::string_view clauseOf(FaultCode code) {
  using enum FaultCode;
  switch (code) {
    case ValueMissing:
      return "a value is missing";
    case NotAValue:
      return "\"{}\" is no value";
    case NotANumber:
      return "\"{}\" is no number";
    case ConstantMalformed:
      return "a constant in quotes is written 'H1F' or 'B101'";
    case TextNotClosed:
      return "a text in quotes is expected";
    case BracketNotClosed:
      return "a bracket is not closed";
    case OperandMissing:
      return "an operand is missing";
    case NestedTooDeeply:
      return "the calculation is nested too deeply";
    case RestNotUnderstood:
      return "\"{}\" is not understood";
    case NameUnknown:
      return "{} is no variable and no function";
    case ArgumentsMissing:
      return "{} needs its argument in brackets";
    case TooFewArguments:
      return "{} needs more arguments";
    case AtanMalformed:
      return "ATAN is written ATAN[y]/[x]";
    case ExistsMalformed:
      return "EXISTS is written EXISTS[#<name>]";
    case RNumberMissing:
      return "R needs a number or an index in brackets";
    case VariableNumberMissing:
      return "the number of a variable is missing or too large";
    case VariableNameNotClosed:
      return "the name of a variable is not closed with >";
    case NoSuchHash:
      return "{} is no variable";
    case IndexMissing:
      return "{} needs an axis or an index in brackets";
    case EqualsMissing:
      return "an equals sign is missing";
    case NotAssignable:
      return "\"{}\" cannot be assigned to";
    case ListMalformed:
      return "SET and REP need a list in brackets, with commas between its values";
    case NameMissing:
      return "the name of a variable is missing";
    case NoSuchType:
      return "DEF {} is no type";
    case SizeMalformed:
      return "the size of an array is missing or too large";
    case ParametersMalformed:
      return "the parameters of PROC are written PROC name(type name, ...)";
    case SyntaxCharacter:
      return "\"{}\" is missing, or stands where it has no meaning";
    case NumberMissing:
      return "an address needs a number or \"=\"";
    case NoTarget:
      return "the jump has no target";
    case IfMalformed:
      return "behind a condition stands GOTO or nothing";
    case ForMalformed:
      return "FOR is written FOR i = a TO b";
    case CaseMalformed:
      return "CASE is written CASE(value) OF constant GOTOF target";
    case NotClosed:
      return "the {} that begins here is not closed";
    case NoBeginning:
      return "{} has no beginning";
    case StructuresTooDeep:
      return "control structures are nested more than 16 deep";
    case ActionNumber:
      return "a synchronized action needs a number from 1 to 255";
    case ActionMalformed:
      return "a synchronized action is written ID=1 WHEN condition DO assignment";
    case ActionTarget:
      return "a synchronized action assigns to $R and variables of the main run only";
    case TargetMissing:
      return "the target {} is missing";
    case SubprogramMissing:
      return "the program {} does not exist";
    case NeitherNameNorProgram:
      return "{} is not defined, and there is no program of this name";
    case CallsTooDeep:
      return "subprograms call each other too deeply";
    case DivisionByZero:
      return "a division by zero";
    case OutOfDomain:
      return "{} has no value";
    case NotFinite:
      return "the result is too large";
    case ValueUnknown:
      return "a value it needs is not known";
    case RUnset:
      return "R{} is read before the program sets it: only the control knows it";
    case NoSuchR:
      return "R[{}] does not exist";
    case NotDefined:
      return "{} is not defined";
    case ArrayIndexMissing:
      return "an array needs its index in brackets";
    case ArrayTooManyIndices:
      return "the array has fewer dimensions";
    case ArrayTooFewIndices:
      return "the array has more dimensions";
    case IndexOutsideArray:
      return "the index lies outside the array";
    case TextCalculated:
      return "a text is calculated with";
    case TypeMismatch:
      return "the value is not of type {}";
    case OutOfRange:
      return "the value lies outside the range of type {}";
    case TooManyValues:
      return "the list has more values than the array has elements";
    case OnlyOnControl:
      return "the value of {} is known on the control only";
    case ControlWritten:
      return "a variable of the control is written";
    case TooManyArguments:
      return "the subprogram takes {} values";
    case ReferenceNeedsVariable:
      return "the parameter {} is given by reference and needs a variable";
    case ReferenceTypeDiffers:
      return "the parameter {} is given by reference and needs a variable of its own type";
    case IndexFromMainRun:
      return "a synchronized action reads R or an array by an index of the main run: use $R";
    case ThenExpected:
      return "behind a condition stands GOTO or THEN";
    case WhileMalformed:
      return "WHILE is written WHILE [condition] DO1";
    case ONameMissing:
      return "an O word needs a number or <name>";
    case OWordUnknown:
      return "{} is not known";
    case NotInLoop:
      return "{} is in no loop";
    case NotCalled:
      return "{} has no call";
    case SubprogramInside:
      return "a subprogram is defined inside {}";
  }
  base::contractViolated("every fault has a clause", __FILE__, __LINE__);
}

}  // namespace

std::string describe(const Fault& fault) {
  return fmt::format(fmt::runtime(clauseOf(fault.code)), fault.argument);
}

}  // namespace rivulet::nc
