// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Makes statements of what the lexer reads. How words are written is the lexer's; here is what
/// steers a program: jumps, conditions, loops, definitions and calls. @threadsafety one object, one
/// thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nc/syntax/language.h"
#include "nc/syntax/tree.h"

namespace rivulet::nc {

/// What the statements of a tree are.
enum class Detail : std::uint8_t {
  Blocks,      ///< all words of a block are one, for a reader that executes them in their order
  Statements,  ///< assignments, calls, messages and stops of a block are statements of their own
};

/// What a word of a SINUMERIK block says of the end of its program.
enum class EndWord : std::uint8_t {
  None,
  End,     ///< M2, M30: at the end of the block
  Return,  ///< M17: at the end of the block
  Ret,     ///< RET: at once, what stands behind it is not executed
};
[[nodiscard]] EndWord endWordOf(const Token& token);

/// Adds the statements of one program to its tree.
class BlockParser {
 public:
  /// @param tree  outlives the parser
  explicit BlockParser(Tree& tree) : m_tree(tree) {}
  BlockParser(const BlockParser&) = delete;
  BlockParser& operator=(const BlockParser&) = delete;
  virtual ~BlockParser() = default;

  /// What a block does besides steering.
  virtual void words(Words words, Place place) {
    m_place = place;
    append(std::move(words));
  }
  /// One jump, condition, loop, definition or call. @param text  from its first word on
  /// @return what follows it in the block
  virtual std::string_view steer(std::string_view text, Place place) = 0;
  /// Complains about what was not closed.
  void finish();
  void fault(FaultCode code, std::string argument, Place place) {
    m_place = place;
    append(Faulty{{code, std::move(argument), place}});
  }

 protected:
  /// A control structure in progress. It is made of branches whose targets are set when they are
  /// known.
  struct Open {
    std::string kind;  ///< IF, WHILE, ...
    std::string id;    ///< of O words and of DO1: what closes it has the same
    std::string name;  ///< for messages
    Place place;
    std::size_t begin = 0;              ///< where a loop continues
    std::optional<std::size_t> branch;  ///< leads on where the condition does not hold
    std::optional<Assignment> step;     ///< of a loop that counts, after each round
    std::vector<std::size_t> toEnd;     ///< branches of BREAK and of parts of an IF that end
    std::vector<std::size_t> toContinue;
    bool isFaulty = false;  ///< its condition could not be read: its body is not a loop
  };

  /// @return the index of the statement
  template <class What>
  std::size_t append(What what) {
    Statement made;
    made.place = m_place;
    made.what = std::move(what);
    return add(std::move(made));
  }
  [[nodiscard]] std::size_t here() const { return m_tree.statements.size(); }
  /// The branch leads to what comes next; nothing: there is none.
  void patch(std::optional<std::size_t> branch);
  void patch(const std::vector<std::size_t>& branches);
  Open& open(std::string kind, std::optional<std::size_t> branch = std::nullopt);
  /// @param condition  nothing: it could not be read, and its fault is in the tree
  Open& openOn(std::string kind, std::optional<Expression> condition);
  /// Leads back to the beginning of a loop, and what leaves it to what comes next.
  void closeLoop(const Open& ended);
  /// Takes the value out, or adds the fault.
  template <class T>
  std::optional<T> got(Expected<T> read) {
    if (!read) {
      append(Faulty{std::move(read.error())});
      return std::nullopt;
    }
    return std::move(*read);
  }
  std::optional<Expression> expression() { return got(m_in->expression()); }
  [[nodiscard]] std::string digits();

  Tree& m_tree;
  Place m_place;           ///< of the statement in progress
  Reader* m_in = nullptr;  ///< of its text
  std::vector<Open> m_open;

 private:
  std::size_t add(Statement made);
};

[[nodiscard]] std::unique_ptr<BlockParser> sinumerikParser(Tree& tree, const Language& language,
                                                           Detail detail);
/// IF, WHILE ... DO and GOTO of the ISO dialects, O words of RS-274/NGC.
[[nodiscard]] std::unique_ptr<BlockParser> hashParser(Tree& tree, const Language& language,
                                                      Detail detail);

/// The call of a `Call` or `Name` token, or of a word L123.
[[nodiscard]] Expected<Call> callOf(const Token& token, const Notation& notation, Place place);

[[nodiscard]] Expression variableNamed(std::string name);
[[nodiscard]] Expression applied(Op op, Expression left, Expression right);
/// What follows '=', where it is one value.
[[nodiscard]] Initial only(Expression value);

}  // namespace rivulet::nc
