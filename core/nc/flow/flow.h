// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// In which order the statements of a program are executed: jumps, branches, repetitions and
/// subprograms with their parameters. @threadsafety one object, one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "nc/eval/variables.h"
#include "nc/syntax/tree.h"

namespace rivulet::nc {

/// Programs by their name in upper case; null: there is none.
using Library = std::function<std::shared_ptr<const Tree>(const std::string& name)>;

/// Told where a subprogram begins and ends, to save and restore what the dialect says.
class CallObserver {
 public:
  virtual ~CallObserver() = default;
  virtual void entered(const Tree& program) = 0;
  virtual void left() = 0;
};

class Flow {
 public:
  /// @param variables  must outlive the flow; it enters and leaves scopes there
  /// @param calls  must outlive the flow; null: nobody is told
  Flow(std::shared_ptr<const Tree> program, Variables& variables, Library library,
       CallObserver* calls = nullptr);

  /// Begins there instead of at the first statement.
  void startAt(std::size_t statement) { level().next = statement; }
  /// The statement that is due; null at the end of a program's text.
  [[nodiscard]] const Statement* due() const;
  /// Steps over it, as is done before it is executed.
  void step();
  /// True if what is due stands in the block of the statement stepped over last.
  [[nodiscard]] bool continuesBlock() const;

  /// Executes a statement that has just been stepped over: Assignment, Definition, Jump, Branch,
  /// RepeatLabel and Call. Others are the caller's. @return true if it led somewhere else
  [[nodiscard]] Expected<bool> execute(const Statement& statement);
  /// The call in progress is that of blocks of the program that calls.
  [[nodiscard]] bool isInLocal() const { return m_levels.back().isLocal; }
  /// Ends the program in progress and the calls of its own blocks. @return false in the main
  /// program
  [[nodiscard]] bool leaveProgram();
  /// M17, RET or the end of the text. @return false in the main program
  [[nodiscard]] bool leave();
  /// M99 P50: back to that block of the caller, or in the main program to its own.
  /// @param stays  the block is one of the present program
  [[nodiscard]] Expected<bool> leaveTo(const std::string& label, bool stays);
  /// True if the last jump back was made before and no variable has changed since: the program
  /// would never end.
  [[nodiscard]] bool isStuck() const { return m_isStuck; }
  /// Programs within each other, 1: the main program.
  [[nodiscard]] std::size_t depth() const { return m_levels.size(); }

 private:
  /// Blocks that REPEAT runs again, up to the statement `end`.
  struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t back = 0;  ///< where to continue after the last round
    int left = 0;
  };
  struct Level {
    std::shared_ptr<const Tree> program;
    std::size_t next = 0;
    std::map<std::size_t, int> repeats;  ///< REPEAT statements in progress, rounds left
    std::vector<Range> ranges;
    std::size_t begin = 0;       ///< where a further round begins
    bool isLocal = false;        ///< of blocks of the program that calls
    bool keepsValues = false;    ///< in further rounds
    int callsLeft = 0;           ///< rounds of this program still to come
    std::optional<Scope> scope;  ///< as at the call; nothing: shared with the caller
    /// Branches whose condition is not known: their loops are run once.
    std::set<std::size_t> unknown;
    /// Jumps back, by their statement: what `changes` was when they were made last.
    std::map<std::size_t, std::uint64_t> jumpsBack;
  };

  [[nodiscard]] Level& level() { return m_levels.back(); }
  void goTo(std::size_t target);
  void enter(std::shared_ptr<const Tree> program, std::size_t begin, std::optional<Scope> scope,
             int callsLeft);
  [[nodiscard]] bool leave(bool again);
  /// Of all that a condition may depend on; never 0.
  [[nodiscard]] std::uint64_t changes() const { return m_variables.changes() + m_rounds + 1; }
  [[nodiscard]] Expected<bool> branch(const Branch& branch);
  [[nodiscard]] Expected<std::optional<Scope>> scopeOf(const Call& call, const Tree& program) const;
  [[nodiscard]] Expected<bool> holds(const std::optional<Expression>& condition) const;
  [[nodiscard]] Expected<int> rounds(const std::optional<Expression>& times) const;
  [[nodiscard]] Expected<bool> jump(const Jump& jump);
  [[nodiscard]] Expected<bool> repeat(const RepeatLabel& repeat);
  [[nodiscard]] Expected<bool> call(const Call& call);

  Variables& m_variables;
  Library m_library;
  std::vector<Level> m_levels;
  CallObserver* m_calls;
  std::size_t m_stepped = 0;
  std::uint64_t m_rounds = 0;  ///< of REPEAT and of calls, begun
  bool m_isStuck = false;
  bool m_moved = false;  ///< by a jump, since the last step
};

}  // namespace rivulet::nc
