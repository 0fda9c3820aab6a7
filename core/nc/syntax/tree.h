// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// An NC program as a list of statements. Control structures are branches with targets: IF, WHILE,
/// FOR, LOOP, REPEAT … UNTIL and CASE leave nothing but conditions and places to go to, so that a
/// loop runs over the list and no text is read twice. What cannot be read becomes a `Faulty`
/// statement: like the control, a reader complains about a block when it reaches it.
/// @threadsafety plain values, immutable once read.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "nc/fault.h"
#include "nc/syntax/expression.h"
#include "nc/syntax/lexer.h"

namespace rivulet::nc {

struct PreprocessingStop {};
struct Message {
  std::optional<Expression> text;
};

enum class JumpDirection : std::uint8_t {
  ForwardThenBackward,
  Forward,
  Backward,
  ForwardNoAlarm,
  Start
};
/// To a label, if the condition holds (no condition: always).
struct Jump {
  std::optional<Expression> condition;
  JumpDirection direction = JumpDirection::ForwardThenBackward;
  std::string label;                 ///< upper case, or "N10" for a block number
  std::optional<Expression> number;  ///< a block number that is calculated
};
/// To statement `target` if the condition does not hold (no condition: always).
struct Branch {
  std::optional<Expression> condition;
  std::size_t target = 0;
};
/// REPEAT label P=n: the blocks from the label up to here n times more; REPEAT from to P=n: from
/// one label to the other; REPEATB label P=n: the block of the label.
struct RepeatLabel {
  std::string label;
  std::string endLabel;
  bool isBlockOnly = false;
  std::optional<Expression> times;
};
/// A subprogram by its name.
struct Call {
  std::string name;
  bool isPlainName = false;            ///< a word that might as well be a name misspelt
  std::optional<Expression> computed;  ///< CALL with a text that is not known before
  std::optional<Expression> times;
  std::vector<std::optional<Expression>> arguments;
  bool isNumbered = false;       ///< the arguments become #1 and on
  bool sharesVariables = false;  ///< M98: the # variables are those of the caller
  bool keepsValues = false;      ///< further rounds begin with what the one before has left
  bool isLocal = false;          ///< M97: `name` is a block number of the calling program
};

/// MCALL NAME(...): the call is executed after each block that moves; alone: no more.
struct RepeatedCall {
  std::optional<Call> call;
};

/// When a synchronized action is executed.
enum class Trigger : std::uint8_t {
  Always,    ///< no keyword: every cycle
  When,      ///< once, when the condition holds
  Whenever,  ///< in every cycle in which it holds
  From,      ///< in every cycle from the first in which it holds
  Every,     ///< each time it begins to hold
};
struct Synchronized {
  int id = 0;             ///< 0: for the next block alone
  bool isStatic = false;  ///< IDS
  Trigger trigger = Trigger::Always;
  std::optional<Expression> condition;
  std::vector<Assignment> assignments;
};
struct Cancel {
  Expression id;
};
/// M17, RET: back to where the program was called; in the main program its end.
struct Return {
  std::optional<Expression> value;  ///< O100 RETURN [#1*2]
};
struct End {};
struct Faulty {
  Fault fault;
};

struct Statement {
  using What =
      std::variant<Words, Assignment, Definition, PreprocessingStop, Message, Jump, Branch,
                   RepeatLabel, Call, RepeatedCall, Synchronized, Cancel, Return, End, Faulty>;
  Place place;
  What what;
  /// False for the second and later statements of one block.
  bool beginsBlock = true;
  /// Asks a variable of the main run: its value belongs to the moment in which the axes stand.
  bool readsMainRun = false;
};

struct Label {
  std::string name;  ///< upper case, or "N10" for a block number
  std::size_t statement = 0;
};

struct Tree {
  std::shared_ptr<const std::string> text;  ///< that tokens point into; null: it is the reader's
  std::vector<Statement> statements;
  std::vector<Label> labels;           ///< in the order of the text
  std::vector<Definition> parameters;  ///< of PROC
  bool saves = false;                  ///< PROC NAME SAVE: see `CallObserver`

  /// Where a jump from statement `from` goes. @return nothing if the label is not found
  [[nodiscard]] std::optional<std::size_t> find(std::string_view label, JumpDirection direction,
                                                std::size_t from) const;
  /// The first statement of the block after that of `statement`.
  [[nodiscard]] std::size_t nextBlock(std::size_t statement) const;
};

/// Calls `visit` for each expression of the statement.
void forEachExpression(const Statement& statement,
                       const std::function<void(const Expression&)>& visit);

}  // namespace rivulet::nc
