// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// An NC program of the control, compiled line by line into statements the pre-run executes.
/// Like the control, it complains about a block only when the block is interpreted: a line that
/// cannot be compiled becomes an alarm statement. @threadsafety immutable once compiled.
///
/// Control structures become branches: IF, WHILE, FOR, LOOP, REPEAT … UNTIL and CASE leave nothing
/// but conditions and targets. Words of A B C turn those rotary axes the machine has, words of U V
/// W are read and move nothing. Work offsets (G54 …) are zero.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/axes.h"
#include "base/id.h"
#include "base/vec3.h"
#include "machine/arc_geometry.h"
#include "machine/expression.h"
#include "machine/sync_action.h"

namespace rivulet::machine {

/// R[index] = value.
struct AssignStatement {
  Expression index;
  Expression value;
};

/// A variable of the program, or an element of one.
struct LocalAssignStatement {
  int slot = 0;
  std::optional<Expression> element;
  Expression value;
};

/// All elements of an array, in order: SET(), REP(), or what a definition begins with.
struct FillStatement {
  int slot = 0;
  std::vector<std::optional<Expression>> values;
  bool repeats = false;  ///< REP: the last value for the rest
};

/// A coordinate: as G90/G91 says, or AC(), IC().
struct Coordinate {
  enum class Reference { Modal, Absolute, Incremental };
  Expression value;
  Reference reference = Reference::Modal;
};

enum class PathMode { Rapid, Line, Clockwise, CounterClockwise, Through };

/// Axis words, feed and modal G functions of one block, in the order they take effect.
struct MotionStatement {
  std::array<std::optional<Coordinate>, base::kAxisCount> axes;
  std::array<std::optional<Coordinate>, base::kRotaryAxisCount> rotary;  ///< A B C
  std::array<std::optional<Coordinate>, base::kAxisCount> centre;        ///< I J K
  std::array<std::optional<Expression>, base::kAxisCount> through;       ///< I1= J1= K1=
  std::optional<Expression> radius;                                      ///< CR=
  std::optional<Expression> openingAngle;                                ///< AR=
  std::optional<Expression> fullTurns;                                   ///< TURN=
  std::optional<Expression> feedMmPerMin;
  std::optional<Expression> roundingMm;  ///< ADIS=
  std::optional<PathMode> mode;
  std::optional<Plane> plane;
  std::optional<Dynamics> dynamics;
  std::optional<bool> absolute;  ///< G90, G91
  std::optional<bool> inches;    ///< G70, G700; G71, G710
  std::optional<BlockEnd> end;   ///< G60; G64, G641 to G645
  std::optional<RoundingKind> rounding;
  bool exactStopOnce = false;  ///< G9

  /// Names an axis. Rotary ones count even where the machine has none of that name.
  [[nodiscard]] bool moves() const { return axes[0] || axes[1] || axes[2] || isArc() || turns(); }
  [[nodiscard]] bool turns() const { return rotary[0] || rotary[1] || rotary[2]; }
  [[nodiscard]] bool isArc() const { return centre[0] || centre[1] || centre[2]; }
};

struct DwellStatement {
  Expression seconds;
};

struct StopreStatement {};

struct MessageStatement {
  std::string text;
};

enum class JumpDirection { ForwardThenBackward, Forward, Backward, ForwardNoAlarm, Start };

/// Jump to a label found by search, if the condition holds (no condition: always).
struct JumpStatement {
  std::optional<Expression> condition;
  JumpDirection direction = JumpDirection::ForwardThenBackward;
  std::string label;
};

/// Continue at statement `target` if the condition is false (no condition: always). What IF,
/// ELSE, WHILE, FOR, LOOP and UNTIL become.
struct BranchStatement {
  std::optional<Expression> condition;
  std::size_t target = 0;
};

/// REPEAT label P=n: the blocks from the label up to here, n times more.
struct RepeatStatement {
  std::string label;
  std::optional<Expression> times;
};

/// A subprogram by its name, n times, with values for its parameters.
struct CallStatement {
  std::string name;
  bool isPlainName = false;  ///< a word that might as well be a name misspelt
  std::optional<Expression> times;
  std::vector<Expression> arguments;
};

/// TRANS, ATRANS, ROT, AROT.
struct FrameStatement {
  enum class Kind { Translate, Rotate } kind = Kind::Translate;
  bool additive = false;
  std::array<std::optional<Expression>, base::kAxisCount> axes;
  std::optional<Expression> inPlane;  ///< RPL=
};

struct SyncStatement {
  SyncAction action;
};

struct CancelStatement {
  Expression id;
};

/// M17, RET: back to where the program was called; in the main program its end.
struct ReturnStatement {};
struct EndStatement {};

struct AlarmStatement {
  Alarm alarm;
};

struct Statement {
  base::LineNumber line;
  std::variant<AssignStatement, LocalAssignStatement, FillStatement, MotionStatement,
               DwellStatement, StopreStatement, MessageStatement, JumpStatement, BranchStatement,
               RepeatStatement, CallStatement, FrameStatement, SyncStatement, CancelStatement,
               ReturnStatement, EndStatement, AlarmStatement>
      what;
  /// False for the second and later statements of one block: the block is prepared as a whole.
  bool beginsBlock = true;
  /// Asks the main run: the pre-run stops first, as at a STOPRE.
  bool readsMainRun = false;
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

  /// Values the variables of the program need, one after another.
  [[nodiscard]] int slotCount() const { return m_slotCount; }
  [[nodiscard]] const VariableNames& variables() const { return m_variables; }
  /// Elements of the variable that begins at a slot.
  [[nodiscard]] int elementsOf(int slot) const;
  [[nodiscard]] bool isInteger(int slot) const;
  /// Slots of the parameters of PROC, in order.
  [[nodiscard]] const std::vector<int>& parameters() const { return m_parameters; }

  /// Where a jump from statement `from` goes. @return nothing if the label is not found
  [[nodiscard]] std::optional<std::size_t> findLabel(const std::string& name,
                                                     JumpDirection direction,
                                                     std::size_t from) const;

 private:
  friend class NcCompiler;
  std::vector<Statement> m_statements;
  std::vector<Label> m_labels;
  VariableNames m_variables;
  std::vector<int> m_parameters;
  int m_slotCount = 0;
};

}  // namespace rivulet::machine
