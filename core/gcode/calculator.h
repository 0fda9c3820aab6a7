// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Variables of an NC program and what it calculates with them. Two ways of writing: SINUMERIK's
/// with ( ) and names, and that of the ISO dialects with [ ] and #. Angles in degrees.
/// @threadsafety one object, one thread.
///
/// Priorities, strongest first. SINUMERIK: NOT B_NOT and the sign; * / DIV MOD; + -; B_AND; B_XOR;
/// B_OR; AND; XOR; OR; comparisons. ISO: the sign; **; * / MOD; + -; comparisons; AND OR XOR. Equal
/// rank goes left to right.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gcode/dialect.h"

namespace rivulet::gcode {

struct Variable {
  std::vector<int> sizes;      ///< of an array, at most three; empty: none
  std::vector<double> values;  ///< one, or all of the array row by row
  std::string text;            ///< of a string
  bool isInteger = false;
  bool isString = false;
  bool isAxis = false;  ///< `text` is the name of an axis
};

/// What a program or subprogram calls its own.
struct Scope {
  std::map<std::string, Variable, std::less<>> names;  ///< upper case
  std::map<int, double> numbers;                       ///< #1 to #33
};

class Calculator {
 public:
  /// Values that only the interpreter knows: the position, by names as "$AA_IW[X]", "#5420" or
  /// "#<_x>" in upper case. Nothing: only the control knows it.
  using SystemValues = std::function<std::optional<double>(std::string_view name)>;

  Calculator(Dialect dialect, SystemValues systemValues);

  /// The value of the whole text. @return nothing if it has none; `problem` says why
  [[nodiscard]] std::optional<double> evaluate(std::string_view text);
  /// Reads an expression from the front of `text` and takes it off.
  [[nodiscard]] std::optional<double> take(std::string_view& text);
  /// "R1=5", "DEPTH=-3", "FELD[1,2]=7", "#<a>=[#1+2]", "A=SET(1,2)". @return false: see `problem`
  [[nodiscard]] bool assign(std::string_view text);
  /// "REAL A=5, B[3]=REP(0), C": what follows DEF. @return false: see `problem`
  [[nodiscard]] bool define(std::string_view text);
  /// "X=AC(5)", "X[#1]", "CR=R1": the part behind the address.
  [[nodiscard]] static std::string_view valuePart(std::string_view word);

  [[nodiscard]] const Variable* find(std::string_view upperName) const;
  [[nodiscard]] Variable* find(std::string_view upperName);

  /// A subprogram has variables of its own. @pre leave: entered
  void enter(Scope scope);
  void leave();
  [[nodiscard]] Scope& scope() { return m_scopes.back(); }

  [[nodiscard]] const std::string& problem() const { return m_problem; }

 private:
  class Parser;
  [[nodiscard]] double* numbered(int number, bool create);

  Dialect m_dialect;
  SystemValues m_systemValues;
  std::vector<Scope> m_scopes;
  Scope m_globals;            ///< #31 and on, #<_name>
  std::map<int, double> m_r;  ///< R-parameters
  std::string m_problem;
};

}  // namespace rivulet::gcode
