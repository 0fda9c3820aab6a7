// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// An NC program of the control, compiled line by line into statements the pre-run executes.
/// Like the control, it complains about a block only when the block is interpreted: a line that
/// cannot be compiled becomes an alarm statement. @threadsafety immutable once compiled.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/id.h"
#include "base/vec3.h"
#include "machine/expression.h"

namespace rivulet::machine {

/// R[index] = value.
struct AssignStatement {
  Expression index;
  Expression value;
};

/// Axis words, feed and modal G functions of one block, in the order they take effect.
struct MotionStatement {
  std::array<std::optional<Expression>, base::kAxisCount> axes;
  std::optional<Expression> feedMmPerMin;
  std::optional<bool> rapid;      ///< G0 true, G1 false
  std::optional<bool> absolute;   ///< G90, G91
  std::optional<bool> exactStop;  ///< G60, G64
  bool exactStopOnce = false;     ///< G9

  [[nodiscard]] bool moves() const { return axes[0] || axes[1] || axes[2]; }
};

struct DwellStatement {
  Expression seconds;
};

struct StopreStatement {};

struct MessageStatement {
  std::string text;
};

enum class JumpDirection { ForwardThenBackward, Forward, Backward, ForwardNoAlarm };

/// Jump to a label found by search, if the condition holds (no condition: always).
struct JumpStatement {
  std::optional<Expression> condition;
  JumpDirection direction = JumpDirection::ForwardThenBackward;
  std::string label;
};

/// Continue at statement `target` if the condition is false (no condition: always). What IF,
/// ELSE, WHILE and ENDWHILE become.
struct BranchStatement {
  std::optional<Expression> condition;
  std::size_t target = 0;
};

struct EndStatement {};

struct AlarmStatement {
  Alarm alarm;
};

struct Statement {
  base::LineNumber line;
  std::variant<AssignStatement, MotionStatement, DwellStatement, StopreStatement, MessageStatement,
               JumpStatement, BranchStatement, EndStatement, AlarmStatement>
      what;
  /// False for the second and later statements of one block: the block is prepared as a whole.
  bool beginsBlock = true;
};

struct Label {
  std::string name;  ///< upper case, or "N10" for a block number
  std::size_t statement = 0;
};

class NcProgram {
 public:
  /// Never fails: see the file comment.
  [[nodiscard]] static NcProgram compile(std::string_view text);

  [[nodiscard]] const std::vector<Statement>& statements() const { return m_statements; }

  /// Where a jump from statement `from` goes. @return nothing if the label is not found
  [[nodiscard]] std::optional<std::size_t> findLabel(const std::string& name,
                                                     JumpDirection direction,
                                                     std::size_t from) const;

 private:
  friend class NcCompiler;
  std::vector<Statement> m_statements;
  std::vector<Label> m_labels;
};

}  // namespace rivulet::machine
