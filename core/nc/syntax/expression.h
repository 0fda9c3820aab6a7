// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Expressions, assignments and definitions of an NC program as a tree. Two notations exist: that
/// of SINUMERIK with ( ) and names, and that of the ISO dialects with [ ] and #. What differs
/// between them stands in the tables of a `Notation`; the tree is the same. @threadsafety pure.
///
/// Priorities, strongest first. SINUMERIK: NOT B_NOT and the sign; * / DIV MOD; + -; B_AND; B_XOR;
/// B_OR; AND; XOR; OR; <<; comparisons. RS-274/NGC: the sign; **; * / MOD; + -; comparisons; AND OR
/// XOR. Those of a macro stand in the folder of its dialect. Equal rank goes left to right.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nc/fault.h"

namespace rivulet::nc {

enum class Op : std::uint8_t {
  // Leaves.
  Number,
  Text,      ///< name: the text
  R,         ///< R5, R[index]: operand 0 is the index
  MainR,     ///< $R5: the R-parameter as the main run sees it
  Variable,  ///< name, indices as operands; "#<name>" as "<NAME>"
  Hash,      ///< #5, #[expression]: operand 0 is the number
  System,    ///< "$AA_IW", indices as operands
  Exists,    ///< EXISTS[#<name>]
  // Operators on numbers and texts.
  Concatenate,
  Equal,
  Unequal,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  // Operators on numbers.
  Negate,
  Not,
  BitNot,
  Or,
  Xor,
  And,
  BitOr,
  BitXor,
  BitAnd,
  Add,
  Subtract,
  Multiply,
  Divide,
  IntegerDivide,
  Modulo,
  WholeModulo,  ///< of both values rounded, with the sign of the first
  FloorModulo,  ///< a rest that is never negative, as in RS-274/NGC
  Power,
  // Functions; angles in degrees.
  Sin,
  Cos,
  Tan,
  Asin,
  AsinPositive,  ///< 270 to 360 and 0 to 90
  Acos,
  Atan2,         ///< -180 to 180
  AtanPositive,  ///< 0 to 360
  Atan,          ///< of one value, -90 to 90
  Sqrt,
  Square,
  Abs,
  Truncate,
  Round,             ///< halves away from zero
  RoundToIncrement,  ///< to the least input increment of the address it stands in
  AwayFromZero,
  RoundUp,
  RoundDown,
  FromBcd,  ///< BIN
  ToBcd,    ///< BCD
  Ln,
  Exp,
  MinVal,
  MaxVal,
  Bound,
};

/// One node, with all that is below it.
struct Expression {
  Op op = Op::Number;
  double number = 0.0;
  std::string name;  ///< upper case but for Text
  std::vector<Expression> operands;
  Place place;

  [[nodiscard]] static Expression constant(double value);
};

/// Calls `visit` for the node and all below it, operands first.
template <class Visit>
void forEachNode(const Expression& expression, const Visit& visit) {
  for (const Expression& operand : expression.operands) {
    forEachNode(operand, visit);
  }
  visit(expression);
}

struct OperatorWord {
  std::string_view word;
  Op op;
};
struct FunctionWord {
  std::string_view word;
  Op op;
  int arguments;
  Op ofOne = Op::Number;  ///< what it is with one argument alone; Number: it needs all
};

/// What a notation calls its operators and functions.
struct Notation {
  std::span<const std::span<const OperatorWord>> levels;  ///< weakest first
  std::span<const FunctionWord> functions;
  char open;
  char close;
  bool hasNames;  ///< variables have names, R-parameters exist, words end at word boundaries
  bool hasCommas = false;        ///< ATAN[y,x] besides ATAN[y]/[x]
  bool roundsAddresses = false;  ///< ROUND in the value of an address goes by its least increment
};
[[nodiscard]] const Notation& sinumerikNotation();
[[nodiscard]] const Notation& hashNotation();

/// What follows '='.
struct Initial {
  enum class Kind : std::uint8_t { One, Set, Rep } kind = Kind::One;
  std::vector<std::optional<Expression>>
      values;  ///< nothing: left out, the element keeps its value
};

/// What a value counts from, and which way it is reached.
enum class Reference : std::uint8_t {
  Modal,        ///< as G90 and G91 say
  Absolute,     ///< AC()
  Incremental,  ///< IC()
  Nearest,      ///< DC(): absolute, a rotary axis turns the shortest way
  Positive,     ///< ACP(): absolute, it turns in the positive direction
  Negative,     ///< ACN(): absolute, it turns in the negative direction
};

/// DC(), ACP(), ACN(): of rotary axes only.
[[nodiscard]] constexpr bool isOfTurns(Reference reference) {
  return reference >= Reference::Nearest;
}

/// AC, IC, DC, ACP, ACN; empty: it is written without a word.
[[nodiscard]] std::string_view referenceWord(Reference reference);

/// R1=5, CR=R2, and the address of an axis with its value: X=AC(R1), X[#1+2].
struct Assignment {
  Expression target;  ///< R, MainR, Variable, Hash or System
  Initial initial;
  Reference reference = Reference::Modal;
  std::string text{};  ///< #3000=1 (TEXT): that of the alarm
};

enum class Type : std::uint8_t { Int, Real, Bool, Char, String, Axis, Frame };
[[nodiscard]] std::string_view typeName(Type type);

/// One variable of a DEF, or one parameter of a PROC.
struct Definition {
  Type type = Type::Real;
  std::string name;                              ///< upper case
  std::vector<std::optional<Expression>> sizes;  ///< of an array; nothing: any, for parameters
  std::optional<Initial> initial;
  bool isReference = false;  ///< VAR
  Place place;
};

/// Reads from the front of a text. After a failure the reader is not to be used any more.
class Reader {
 public:
  /// @param place  of the first character
  Reader(std::string_view text, const Notation& notation, Place place = {});

  /// The longest expression at the beginning. Blanks before what follows it stay unread.
  [[nodiscard]] Expected<Expression> expression();
  /// R5, DEPTH, FIELD[1,2], $AA_OFF[X], #5: what can precede '='.
  [[nodiscard]] Expected<Expression> target();
  /// "R1=5", "FIELD[1,2]=SET(7,8)", "X=AC(R1)".
  [[nodiscard]] Expected<Assignment> assignment();
  /// "X=#1", "X#1", "X-[#1+2]" of the notation with #.
  [[nodiscard]] Expected<Assignment> address();
  /// What follows DEF: "REAL A=5, B[3]=REP(0), C".
  [[nodiscard]] Expected<std::vector<Definition>> definitions();
  /// What follows PROC NAME: "(INT A, VAR REAL B[], STRING[8] C)", or nothing.
  [[nodiscard]] Expected<std::vector<Definition>> parameters();
  /// What follows the name of a subprogram: "(1,,A)", or nothing.
  [[nodiscard]] Expected<std::vector<std::optional<Expression>>> arguments();

  void skipBlanks();
  [[nodiscard]] char peek() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }
  /// Blanks before `c` are skipped in any case.
  bool take(char c);
  /// The word, in any case of letters, at a word boundary.
  bool takeWord(std::string_view upper);
  /// A name in upper case; empty if there is none.
  [[nodiscard]] std::string name();
  [[nodiscard]] bool isAtEnd();
  [[nodiscard]] std::string_view rest() const { return m_text.substr(m_at); }
  /// Back to an earlier state of a reader of the same text.
  void restore(const Reader& earlier) {
    m_at = earlier.m_at;
    m_fault.reset();
  }
  void skipRest() { m_at = m_text.size(); }
  /// Characters read.
  [[nodiscard]] std::size_t length() const { return m_at; }
  [[nodiscard]] Place place() const;

 private:
  using Result = std::optional<Expression>;

  std::nullopt_t fault(FaultCode code, std::string argument = {});
  template <class T>
  Expected<T> outcome(std::optional<T> value);
  /// An expression of operators that bind as strongly as that level of the notation, or more.
  Result level(std::size_t weakest);
  Result unary();
  Result unaryInner();
  Result primary();
  Result number();
  Result bits();
  Result text();
  Result rParameter(Op op);
  Result system();
  Result hash();
  Result named();
  Result function(const FunctionWord& word, Place place);
  [[nodiscard]] bool hasSecond() const;
  static void roundToIncrement(Expression& node);
  Result exists(Place place);
  Result readTarget();
  bool takeReference(Reference& reference);
  /// "[1,2]" after a name, into the operands. @return false: see the fault
  bool indices(Expression& node);
  std::optional<Initial> initial();
  std::optional<Type> type();
  std::optional<Definition> definition(Type type, bool isParameter);
  struct Ahead {
    Op op = Op::Number;
    std::size_t level = 0;
    std::size_t end = 0;  ///< behind it; 0: none comes next
  };
  [[nodiscard]] Ahead operatorAhead() const;
  bool takeOperator(const OperatorWord& sign);
  /// @return where the operator that stands there ends; `at`: another one or none does
  [[nodiscard]] std::size_t endOf(const OperatorWord& sign, std::size_t at) const;
  [[nodiscard]] std::size_t behindBlanks() const;
  Expression node(Op op, Place place, std::vector<Expression> operands = {}) const;

  std::string_view m_text;
  const Notation& m_notation;
  Place m_begin;
  std::size_t m_at = 0;
  int m_depth = 0;
  std::optional<Fault> m_fault;
};

/// The whole text as one expression.
[[nodiscard]] Expected<Expression> parseExpression(std::string_view text, const Notation& notation,
                                                   Place place = {});

}  // namespace rivulet::nc
