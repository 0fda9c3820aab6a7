// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/contract.h"

namespace rivulet::nc {

namespace {

struct Clause {
  FaultCode code;
  std::string_view text;  ///< {} is the argument
};

// clang-format off
constexpr std::array kClauses{
    Clause{FaultCode::UnexpectedCharacter, "the character \"{}\" has no meaning here"},
    Clause{FaultCode::NumberMalformed, "\"{}\" is not a number"},
    Clause{FaultCode::CommentNotClosed, "a comment is not closed"},
    Clause{FaultCode::UnknownGCode, "{} is not known to this machine"},
    Clause{FaultCode::UnknownWord, "the word {} is not understood here"},
    Clause{FaultCode::UnsupportedGCode, "{} is not known to this machine"},
    Clause{FaultCode::UnsupportedExpression, "\"{}\" is not understood"},
    Clause{FaultCode::ConflictingGCodes, "two functions of one group are in the block: {}"},
    Clause{FaultCode::RepeatedWord, "the address {} is programmed more than once in the block"},
    Clause{FaultCode::ArcWithoutCentre, "circle end-point error: there is no circle through these points"},
    Clause{FaultCode::ArcRadiusMismatch, "circle end-point error: the radii at start and end differ by {} mm"},
    Clause{FaultCode::ArcRadiusTooSmall, "circle end-point error: the radius is too small ({})"},
    Clause{FaultCode::ArcFromUnknownPosition, "the arc starts at an unknown position: {}"},
    Clause{FaultCode::RelativeFromUnknownPosition, "the increment of {} starts at an unknown position"},
    Clause{FaultCode::FeedMissing, "no feed is programmed"},
    Clause{FaultCode::FeedNotPositive, "the programmed path speed {} is not positive"},
    Clause{FaultCode::ValueOutOfRange, "the value of {} is out of range"},
    Clause{FaultCode::CentreOutsidePlane, "circle end-point error: {} is not in the plane of the arc"},
    Clause{FaultCode::CycleNotRun, "{} is not a cycle of this machine"},
    Clause{FaultCode::ValueMissing, "a value is missing"},
    Clause{FaultCode::NotAValue, "\"{}\" is not a value"},
    Clause{FaultCode::NotANumber, "\"{}\" is not a number"},
    Clause{FaultCode::ConstantMalformed, "a constant in quotes is written 'H1F' or 'B101'"},
    Clause{FaultCode::TextNotClosed, "a text in quotes is expected"},
    Clause{FaultCode::BracketNotClosed, "a bracket is not closed"},
    Clause{FaultCode::OperandMissing, "an operand is missing"},
    Clause{FaultCode::NestedTooDeeply, "the calculation is nested too deeply"},
    Clause{FaultCode::RestNotUnderstood, "\"{}\" is not understood"},
    Clause{FaultCode::NameUnknown, "{} is neither a variable nor a function"},
    Clause{FaultCode::ArgumentsMissing, "{} needs its argument in brackets"},
    Clause{FaultCode::TooFewArguments, "{} needs more arguments"},
    Clause{FaultCode::AtanMalformed, "ATAN is written ATAN[y]/[x]"},
    Clause{FaultCode::ExistsMalformed, "EXISTS is written EXISTS[#<name>]"},
    Clause{FaultCode::RNumberMissing, "R needs a number or an index in brackets"},
    Clause{FaultCode::VariableNumberMissing, "the number of a variable is missing or too large"},
    Clause{FaultCode::VariableNameNotClosed, "the name of a variable is not closed with >"},
    Clause{FaultCode::NoSuchHash, "{} is not a variable"},
    Clause{FaultCode::IndexMissing, "{} needs an axis or an index in brackets"},
    Clause{FaultCode::EqualsMissing, "an equals sign is missing"},
    Clause{FaultCode::NotAssignable, "\"{}\" cannot be assigned to"},
    Clause{FaultCode::ListMalformed, "SET and REP need a list in brackets, with commas between its values"},
    Clause{FaultCode::NameMissing, "the name of a variable is missing"},
    Clause{FaultCode::NoSuchType, "{} is not a type for DEF"},
    Clause{FaultCode::SizeMalformed, "the size of an array is missing or too large"},
    Clause{FaultCode::ParametersMalformed, "the parameters of PROC are written PROC name(type name, ...)"},
    Clause{FaultCode::SyntaxCharacter, "\"{}\" is missing, or has no meaning here"},
    Clause{FaultCode::NumberMissing, "an address needs a number or \"=\""},
    Clause{FaultCode::NoTarget, "the jump has no target"},
    Clause{FaultCode::IfMalformed, "only GOTO may follow a condition"},
    Clause{FaultCode::ForMalformed, "FOR is written FOR i = a TO b"},
    Clause{FaultCode::CaseMalformed, "CASE is written CASE(value) OF constant GOTOF target"},
    Clause{FaultCode::NotClosed, "the {} that begins here is not closed"},
    Clause{FaultCode::NoBeginning, "{} has no beginning"},
    Clause{FaultCode::StructuresTooDeep, "control structures are nested more than 16 deep"},
    Clause{FaultCode::ActionNumber, "a synchronized action needs a number from 1 to 255"},
    Clause{FaultCode::ActionMalformed, "a synchronized action is written ID=1 WHEN condition DO assignment"},
    Clause{FaultCode::ActionTarget, "a synchronized action can only assign to $R and variables of the main run"},
    Clause{FaultCode::TargetMissing, "the target {} is missing"},
    Clause{FaultCode::SubprogramMissing, "the program {} does not exist"},
    Clause{FaultCode::NeitherNameNorProgram, "{} is not defined, and there is no program of this name"},
    Clause{FaultCode::CallsTooDeep, "subprograms call each other too deeply"},
    Clause{FaultCode::DivisionByZero, "a division by zero"},
    Clause{FaultCode::OutOfDomain, "{} has no value"},
    Clause{FaultCode::NotFinite, "the result is too large"},
    Clause{FaultCode::ValueUnknown, "it needs a value that is not known"},
    Clause{FaultCode::RUnset, "R{} is read before the program sets it: only the control knows it"},
    Clause{FaultCode::NoSuchR, "R[{}] does not exist"},
    Clause{FaultCode::NotDefined, "{} is not defined"},
    Clause{FaultCode::ArrayIndexMissing, "an array needs its index in brackets"},
    Clause{FaultCode::ArrayTooManyIndices, "the array has fewer dimensions"},
    Clause{FaultCode::ArrayTooFewIndices, "the array has more dimensions"},
    Clause{FaultCode::IndexOutsideArray, "the index is outside the array"},
    Clause{FaultCode::TextCalculated, "a calculation uses a text"},
    Clause{FaultCode::TypeMismatch, "the value is not of type {}"},
    Clause{FaultCode::OutOfRange, "the value is outside the range of type {}"},
    Clause{FaultCode::TooManyValues, "the list has more values than the array has elements"},
    Clause{FaultCode::OnlyOnControl, "only the control knows the value of {}"},
    Clause{FaultCode::ControlWritten, "a variable of the control would be written"},
    Clause{FaultCode::TooManyArguments, "the subprogram takes {} values"},
    Clause{FaultCode::ReferenceNeedsVariable, "the parameter {} is given by reference and needs a variable"},
    Clause{FaultCode::ReferenceTypeDiffers, "the parameter {} is given by reference and needs a variable of its own type"},
    Clause{FaultCode::IndexFromMainRun, "a synchronized action reads R or an array by an index of the main run: use $R"},
    Clause{FaultCode::ThenExpected, "GOTO or THEN must follow a condition"},
    Clause{FaultCode::WhileMalformed, "WHILE is written WHILE [condition] DO1"},
    Clause{FaultCode::ONameMissing, "an O word needs a number or <name>"},
    Clause{FaultCode::OWordUnknown, "{} is not known"},
    Clause{FaultCode::NotInLoop, "{} is not in a loop"},
    Clause{FaultCode::NotCalled, "{} has no call"},
    Clause{FaultCode::SubprogramInside, "a subprogram is defined inside {}"},
};
// clang-format on

}  // namespace

std::string describe(const Fault& fault) {
  const auto* const found = std::find_if(kClauses.begin(), kClauses.end(), [&](const Clause& each) {
    return each.code == fault.code;
  });
  RIVULET_ASSERT(found != kClauses.end());
  return fmt::format(fmt::runtime(found->text), fault.argument);
}

}  // namespace rivulet::nc
