// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/fault.h"

#include <algorithm>
#include <array>

#include "base/sentence.h"

namespace rivulet::nc {

namespace {

struct Clause {
  FaultCode code;
  const char* text;
};

// clang-format off
constexpr std::array kClauses{
    Clause{FaultCode::UnexpectedCharacter, RIVULET_SENTENCE("FaultTexts", "the character \"%1\" has no meaning here")},
    Clause{FaultCode::NumberMalformed, RIVULET_SENTENCE("FaultTexts", "\"%1\" is not a number")},
    Clause{FaultCode::BlankInNumber, RIVULET_SENTENCE("FaultTexts", "a blank is inside the number \"%1\"")},
    Clause{FaultCode::InvisibleCharacter, RIVULET_SENTENCE("FaultTexts", "the invisible character %1 has no meaning here")},
    Clause{FaultCode::CommentNested, RIVULET_SENTENCE("FaultTexts", "a bracket is opened within the comment %1")},
    Clause{FaultCode::CommentNotClosed, RIVULET_SENTENCE("FaultTexts", "a comment is not closed")},
    Clause{FaultCode::UnknownGCode, RIVULET_SENTENCE("FaultTexts", "%1 is not known to this machine")},
    Clause{FaultCode::UnknownWord, RIVULET_SENTENCE("FaultTexts", "the word %1 is not understood here")},
    Clause{FaultCode::UnsupportedGCode, RIVULET_SENTENCE("FaultTexts", "%1 is not known to this machine")},
    Clause{FaultCode::UnsupportedExpression, RIVULET_SENTENCE("FaultTexts", "\"%1\" is not understood")},
    Clause{FaultCode::ConflictingGCodes, RIVULET_SENTENCE("FaultTexts", "two functions of one group are in the block: %1")},
    Clause{FaultCode::RepeatedWord, RIVULET_SENTENCE("FaultTexts", "the address %1 is programmed more than once in the block")},
    Clause{FaultCode::ArcWithoutCentre, RIVULET_SENTENCE("FaultTexts", "circle end-point error: there is no circle through these points")},
    Clause{FaultCode::ArcRadiusMismatch, RIVULET_SENTENCE("FaultTexts", "circle end-point error: the radii at start and end differ by %1 mm")},
    Clause{FaultCode::ArcRadiusTooSmall, RIVULET_SENTENCE("FaultTexts", "circle end-point error: the radius is too small (%1)")},
    Clause{FaultCode::ArcFromUnknownPosition, RIVULET_SENTENCE("FaultTexts", "the arc starts at an unknown position: %1")},
    Clause{FaultCode::RelativeFromUnknownPosition, RIVULET_SENTENCE("FaultTexts", "the increment of %1 starts at an unknown position")},
    Clause{FaultCode::WordMissing, RIVULET_SENTENCE("FaultTexts", "the block lacks a word that the control needs (%1)")},
    Clause{FaultCode::FeedMissing, RIVULET_SENTENCE("FaultTexts", "no feed is programmed")},
    Clause{FaultCode::FeedLost, RIVULET_SENTENCE("FaultTexts", "the unit of the feed was chosen behind the last F")},
    Clause{FaultCode::FeedNotPositive, RIVULET_SENTENCE("FaultTexts", "the programmed path speed %1 is not positive")},
    Clause{FaultCode::ValueOutOfRange, RIVULET_SENTENCE("FaultTexts", "the value of %1 is out of range")},
    Clause{FaultCode::CentreOutsidePlane, RIVULET_SENTENCE("FaultTexts", "circle end-point error: %1 is not in the plane of the arc")},
    Clause{FaultCode::CycleNotRun, RIVULET_SENTENCE("FaultTexts", "%1 is not a cycle of this machine")},
    Clause{FaultCode::ValueMissing, RIVULET_SENTENCE("FaultTexts", "a value is missing")},
    Clause{FaultCode::NotAValue, RIVULET_SENTENCE("FaultTexts", "\"%1\" is not a value")},
    Clause{FaultCode::NotANumber, RIVULET_SENTENCE("FaultTexts", "\"%1\" is not a number")},
    Clause{FaultCode::ConstantMalformed, RIVULET_SENTENCE("FaultTexts", "a constant in quotes is written 'H1F' or 'B101'")},
    Clause{FaultCode::TextNotClosed, RIVULET_SENTENCE("FaultTexts", "a text in quotes is expected")},
    Clause{FaultCode::BracketNotClosed, RIVULET_SENTENCE("FaultTexts", "a bracket is not closed")},
    Clause{FaultCode::OperandMissing, RIVULET_SENTENCE("FaultTexts", "an operand is missing")},
    Clause{FaultCode::NestedTooDeeply, RIVULET_SENTENCE("FaultTexts", "the calculation is nested too deeply")},
    Clause{FaultCode::RestNotUnderstood, RIVULET_SENTENCE("FaultTexts", "\"%1\" is not understood")},
    Clause{FaultCode::NameUnknown, RIVULET_SENTENCE("FaultTexts", "%1 is neither a variable nor a function")},
    Clause{FaultCode::ArgumentsMissing, RIVULET_SENTENCE("FaultTexts", "%1 needs its argument in brackets")},
    Clause{FaultCode::TooFewArguments, RIVULET_SENTENCE("FaultTexts", "%1 needs more arguments")},
    Clause{FaultCode::AtanMalformed, RIVULET_SENTENCE("FaultTexts", "ATAN is written ATAN[y]/[x]")},
    Clause{FaultCode::ExistsMalformed, RIVULET_SENTENCE("FaultTexts", "EXISTS is written EXISTS[#<name>]")},
    Clause{FaultCode::RNumberMissing, RIVULET_SENTENCE("FaultTexts", "R needs a number or an index in brackets")},
    Clause{FaultCode::VariableNumberMissing, RIVULET_SENTENCE("FaultTexts", "the number of a variable is missing or too large")},
    Clause{FaultCode::VariableNameNotClosed, RIVULET_SENTENCE("FaultTexts", "the name of a variable is not closed with >")},
    Clause{FaultCode::NoSuchHash, RIVULET_SENTENCE("FaultTexts", "%1 is not a variable")},
    Clause{FaultCode::IndexMissing, RIVULET_SENTENCE("FaultTexts", "%1 needs an axis or an index in brackets")},
    Clause{FaultCode::EqualsMissing, RIVULET_SENTENCE("FaultTexts", "an equals sign is missing")},
    Clause{FaultCode::NotAssignable, RIVULET_SENTENCE("FaultTexts", "\"%1\" cannot be assigned to")},
    Clause{FaultCode::ListMalformed, RIVULET_SENTENCE("FaultTexts", "SET and REP need a list in brackets, with commas between its values")},
    Clause{FaultCode::NameMissing, RIVULET_SENTENCE("FaultTexts", "the name of a variable is missing")},
    Clause{FaultCode::NoSuchType, RIVULET_SENTENCE("FaultTexts", "%1 is not a type for DEF")},
    Clause{FaultCode::SizeMalformed, RIVULET_SENTENCE("FaultTexts", "the size of an array is missing or too large")},
    Clause{FaultCode::ParametersMalformed, RIVULET_SENTENCE("FaultTexts", "the parameters of PROC are written PROC name(type name, ...)")},
    Clause{FaultCode::SyntaxCharacter, RIVULET_SENTENCE("FaultTexts", "\"%1\" is missing, or has no meaning here")},
    Clause{FaultCode::NumberMissing, RIVULET_SENTENCE("FaultTexts", "an address needs a number or \"=\"")},
    Clause{FaultCode::NoTarget, RIVULET_SENTENCE("FaultTexts", "the jump has no target")},
    Clause{FaultCode::IfMalformed, RIVULET_SENTENCE("FaultTexts", "only GOTO may follow a condition")},
    Clause{FaultCode::ForMalformed, RIVULET_SENTENCE("FaultTexts", "FOR is written FOR i = a TO b")},
    Clause{FaultCode::CaseMalformed, RIVULET_SENTENCE("FaultTexts", "CASE is written CASE(value) OF constant GOTOF target")},
    Clause{FaultCode::NotClosed, RIVULET_SENTENCE("FaultTexts", "the %1 that begins here is not closed")},
    Clause{FaultCode::NoBeginning, RIVULET_SENTENCE("FaultTexts", "%1 has no beginning")},
    Clause{FaultCode::StructuresTooDeep, RIVULET_SENTENCE("FaultTexts", "control structures are nested more than 16 deep")},
    Clause{FaultCode::ActionNumber, RIVULET_SENTENCE("FaultTexts", "a synchronized action needs a number from 1 to 255")},
    Clause{FaultCode::ActionMalformed, RIVULET_SENTENCE("FaultTexts", "a synchronized action is written ID=1 WHEN condition DO assignment")},
    Clause{FaultCode::ActionTarget, RIVULET_SENTENCE("FaultTexts", "a synchronized action can only assign to $R and variables of the main run")},
    Clause{FaultCode::TargetMissing, RIVULET_SENTENCE("FaultTexts", "the target %1 is missing")},
    Clause{FaultCode::SubprogramMissing, RIVULET_SENTENCE("FaultTexts", "the program %1 does not exist")},
    Clause{FaultCode::NeitherNameNorProgram, RIVULET_SENTENCE("FaultTexts", "%1 is not defined, and there is no program of this name")},
    Clause{FaultCode::CallsTooDeep, RIVULET_SENTENCE("FaultTexts", "subprograms call each other too deeply")},
    Clause{FaultCode::DivisionByZero, RIVULET_SENTENCE("FaultTexts", "a division by zero")},
    Clause{FaultCode::OutOfDomain, RIVULET_SENTENCE("FaultTexts", "%1 has no value")},
    Clause{FaultCode::NotFinite, RIVULET_SENTENCE("FaultTexts", "the result is too large")},
    Clause{FaultCode::ValueUnknown, RIVULET_SENTENCE("FaultTexts", "it needs a value that is not known")},
    Clause{FaultCode::RUnset, RIVULET_SENTENCE("FaultTexts", "R%1 is read before the program sets it: only the control knows it")},
    Clause{FaultCode::NoSuchR, RIVULET_SENTENCE("FaultTexts", "R[%1] does not exist")},
    Clause{FaultCode::NotDefined, RIVULET_SENTENCE("FaultTexts", "%1 is not defined")},
    Clause{FaultCode::ArrayIndexMissing, RIVULET_SENTENCE("FaultTexts", "an array needs its index in brackets")},
    Clause{FaultCode::ArrayTooManyIndices, RIVULET_SENTENCE("FaultTexts", "the array has fewer dimensions")},
    Clause{FaultCode::ArrayTooFewIndices, RIVULET_SENTENCE("FaultTexts", "the array has more dimensions")},
    Clause{FaultCode::IndexOutsideArray, RIVULET_SENTENCE("FaultTexts", "the index is outside the array")},
    Clause{FaultCode::TextCalculated, RIVULET_SENTENCE("FaultTexts", "a calculation uses a text")},
    Clause{FaultCode::TypeMismatch, RIVULET_SENTENCE("FaultTexts", "the value is not of type %1")},
    Clause{FaultCode::OutOfRange, RIVULET_SENTENCE("FaultTexts", "the value is outside the range of type %1")},
    Clause{FaultCode::TooManyValues, RIVULET_SENTENCE("FaultTexts", "the list has more values than the array has elements")},
    Clause{FaultCode::TooManyVariables, RIVULET_SENTENCE("FaultTexts", "the program has more than %1 variables")},
    Clause{FaultCode::OnlyOnControl, RIVULET_SENTENCE("FaultTexts", "only the control knows the value of %1")},
    Clause{FaultCode::ControlWritten, RIVULET_SENTENCE("FaultTexts", "a variable of the control would be written")},
    Clause{FaultCode::NumberNotWritable, RIVULET_SENTENCE("FaultTexts", "%1 cannot be written by a program here")},
    Clause{FaultCode::AlarmRaised, RIVULET_SENTENCE("FaultTexts", "the program stops here with its alarm %1")},
    Clause{FaultCode::ProgramTooLarge, RIVULET_SENTENCE("FaultTexts", "the program takes more memory than is allowed: split it")},
    Clause{FaultCode::ProgramTwice, RIVULET_SENTENCE("FaultTexts", "the file holds two programs of the name %1: rename or remove one of them")},
    Clause{FaultCode::TooManyArguments, RIVULET_SENTENCE("FaultTexts", "the subprogram takes %1 values")},
    Clause{FaultCode::ReferenceNeedsVariable, RIVULET_SENTENCE("FaultTexts", "the parameter %1 is given by reference and needs a variable")},
    Clause{FaultCode::ReferenceTypeDiffers, RIVULET_SENTENCE("FaultTexts", "the parameter %1 is given by reference and needs a variable of its own type")},
    Clause{FaultCode::IndexFromMainRun, RIVULET_SENTENCE("FaultTexts", "a synchronized action reads R or an array by an index of the main run: use $R")},
    Clause{FaultCode::ThenExpected, RIVULET_SENTENCE("FaultTexts", "GOTO or THEN must follow a condition")},
    Clause{FaultCode::WhileMalformed, RIVULET_SENTENCE("FaultTexts", "WHILE is written WHILE [condition] DO1")},
    Clause{FaultCode::ONameMissing, RIVULET_SENTENCE("FaultTexts", "an O word needs a number or <name>")},
    Clause{FaultCode::OWordUnknown, RIVULET_SENTENCE("FaultTexts", "%1 is not known")},
    Clause{FaultCode::NotInLoop, RIVULET_SENTENCE("FaultTexts", "%1 is not in a loop")},
    Clause{FaultCode::NotCalled, RIVULET_SENTENCE("FaultTexts", "%1 has no call")},
    Clause{FaultCode::SubprogramInside, RIVULET_SENTENCE("FaultTexts", "a subprogram is defined inside %1")},
};
// clang-format on

}  // namespace

std::string filled(std::string_view sentence, std::string_view parameter) {
  std::string text(sentence);
  for (std::size_t at = text.find("%1"); at != std::string::npos;
       at = text.find("%1", at + parameter.size())) {
    text.replace(at, 2, parameter);
  }
  return text;
}

const char* clausePattern(FaultCode code) {
  const auto* const found = std::find_if(kClauses.begin(), kClauses.end(),
                                         [code](const Clause& each) { return each.code == code; });
  // A finding that others have a sentence for, and a control that executes the block meets.
  return found != kClauses.end()
             ? found->text
             : RIVULET_SENTENCE("FaultTexts", "the block cannot be executed here (%1)");
}

std::string describe(const Fault& fault) {
  return filled(clausePattern(fault.code), fault.argument);
}

}  // namespace rivulet::nc
