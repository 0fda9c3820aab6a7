// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A timed coloured Petri net as a value: colour sets, places, transitions with guards, priorities
/// and delays. Pages and fusion places are already resolved (`net_file.h`); what is left of them is
/// the name of each place and transition, "Top.CNC.Interpreter.start". Expressions are nodes of a
/// table, each with its colour set, so that a net that does not fit its colour sets is not made.
///
/// A value of a colour set is a sequence of 64-bit words: numbers, truth values and texts one word,
/// a record its fields one after another, a list its length and then its elements.
/// @threadsafety plain values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <system_error>
#include <vector>

namespace rivulet::petri {

using Word = std::int64_t;
using Words = std::vector<Word>;

enum class PetriError {
  NotANet = 1,    ///< the text is not one; the message names the place in it
  Unknown,        ///< a name that is not defined
  WrongColour,    ///< a value does not fit its colour set
  TooManyStates,  ///< the state space is larger than allowed
  NotAnalysable,  ///< the untimed net would not cover the timed one
};

[[nodiscard]] std::error_code make_error_code(PetriError code);

using ColourId = std::size_t;

enum class ColourKind { Int, Bool, String, Unit, Record, List };

struct Field {
  std::string name;
  ColourId colour = 0;
  std::size_t offset = 0;   ///< words from the start of the record
  bool isMeasured = false;  ///< recorded only: no guard reads it, and the state space leaves it out
};

struct Colour {
  std::string name;
  ColourKind kind = ColourKind::Int;
  std::vector<Field> fields;  ///< Record
  ColourId element = 0;       ///< List; never a list
  std::size_t width = 1;      ///< words; of a list: of one element
};

// Colour sets that every net has. `kAnyList` is that of "[]".
inline constexpr ColourId kInt = 0;
inline constexpr ColourId kBool = 1;
inline constexpr ColourId kString = 2;
inline constexpr ColourId kUnit = 3;
inline constexpr ColourId kAnyList = 4;

enum class Op : std::uint8_t {
  Constant,  ///< `value`
  Variable,  ///< `index`: number of the variable
  Member,    ///< of a record: `index` words from its start
  Now,       ///< present time
  Negate,
  Not,
  Add,
  Subtract,
  Multiply,
  Divide,  ///< rounds down; by zero: 0
  Modulo,  ///< not negative; by zero: 0
  Less,
  LessEqual,
  Equal,
  NotEqual,
  And,
  Or,
  If,
  Construct,  ///< a record of its fields
  Update,     ///< the first operand with other fields; `offsets` where the others go
  Call,       ///< `index`: number of the function
  Head,
  Tail,
  Length,
  Append,  ///< of an element to a list
  Sort,    ///< of a list, stable; `index`: function that compares two elements, then other operands
  Uniform,  ///< whole number between two, both included; drawn
  Tokens,   ///< number of tokens of place `index`, or of the elements of its list
};

using NodeId = std::uint32_t;

struct Node {
  Op op = Op::Constant;
  ColourId colour = kInt;
  Word value = 0;
  std::uint32_t index = 0;
  bool isMeasured = false;
  std::vector<NodeId> operands;
  std::vector<std::uint32_t> offsets;
};

struct Function {
  std::string name;
  std::vector<ColourId> parameters;
  NodeId body = 0;
};

struct Token {
  Word time = 0;  ///< from when on it is available
  Words value;
};

struct Place {
  std::string name;
  ColourId colour = kInt;
  std::vector<Token> initial;
  bool isObserver = false;  ///< only recorded: its tokens are handed out and not kept
};

struct InputArc {
  std::size_t place = 0;
  bool binds = false;  ///< the token becomes variable `variable`; else it equals `value`
  std::uint32_t variable = 0;
  NodeId value = 0;
  bool isEarly = false;        ///< takes a token before its time ("@any")
  std::vector<NodeId> guards;  ///< conditions that can be judged once this arc has its token
  std::vector<NodeId> timedGuards;
  std::string text;
};

struct OutputArc {
  std::size_t place = 0;
  NodeId value = 0;
  bool hasDelay = false;
  NodeId delay = 0;
  std::string text;
};

struct Transition {
  std::string name;
  int priority = 0;  ///< the lowest number fires first
  std::vector<InputArc> inputs;
  std::vector<OutputArc> outputs;
  std::vector<NodeId> lets;  ///< values that the outputs share: variables after those of the inputs
  std::vector<NodeId> guards;  ///< conditions without variables
  std::string guardText;
  bool asksTime = false;  ///< a guard depends on the present time
};

/// What stands on a page, for pictures of it.
struct PageNode {
  enum class Kind : std::uint8_t { Place, Transition, Substitution };
  Kind kind = Kind::Place;
  std::string name;  ///< on its page
  std::size_t index =
      0;                ///< of the place or transition; of the page that a substitution stands for
  bool isPort = false;  ///< Place: connected from outside
  bool isFusion = false;  ///< Place: the same on several pages
  bool hasPosition = false;
  double column = 0.0;  ///< of its centre, to the right
  double row = 0.0;     ///< of its centre, downwards
};

/// A page where it stands in the hierarchy: a page of the file may stand in several places.
struct NetPage {
  std::string path;        ///< "Top.CNC.Interpreter"
  std::size_t parent = 0;  ///< index of the page it stands on; of the first one: its own
  std::vector<PageNode> nodes;
};

/// A condition that holds in each marking.
struct Invariant {
  std::string name;
  NodeId condition = 0;
  std::string text;
};

/// Largest number of variables of a transition or function.
inline constexpr std::size_t kVariablesMax = 16;

struct Net {
  std::string name;
  std::string timeUnit;
  std::vector<Colour> colours;
  std::vector<std::string> texts;  ///< a text value is an index into it
  std::vector<Node> nodes;
  std::vector<Function> functions;
  std::vector<Place> places;
  std::vector<Transition> transitions;
  std::vector<Invariant> invariants;
  std::vector<NetPage> pages;              ///< the top page first, each before those on it
  std::map<std::string, Word> parameters;  ///< as used

  /// Index of a place or transition; the number of them if there is none.
  [[nodiscard]] std::size_t placeOf(const std::string& placeName) const;
  [[nodiscard]] std::size_t transitionOf(const std::string& transitionName) const;
  /// Where a field is in a record, words from its start. @param field  of the colour set
  [[nodiscard]] std::size_t offsetOf(ColourId colour, const std::string& field) const;
  /// A value as the language writes it.
  [[nodiscard]] std::string textOf(ColourId colour, const Word* words) const;
  /// Length of a value, words.
  [[nodiscard]] std::size_t sizeOf(ColourId colour, const Word* words) const {
    const Colour& set = colours[colour];
    return set.kind == ColourKind::List ? 1 + set.width * static_cast<std::size_t>(words[0])
                                        : set.width;
  }
};

}  // namespace rivulet::petri

template <>
struct std::is_error_code_enum<rivulet::petri::PetriError> : std::true_type {};
