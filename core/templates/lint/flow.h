// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Control flow of an NC program and possible values of expressions: the basis of the lint.
/// @threadsafety plain values; functions pure.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "nc/syntax/tree.h"

namespace rivulet::templates {

/// All values that a variable may have at a place; unknown: any.
struct ValueSet {
  bool isUnknown = false;
  std::vector<double> values;  ///< ascending

  [[nodiscard]] static ValueSet unknown() { return {true, {}}; }
  /// Too many values become unknown.
  void add(double value);
  /// @return true if it has grown
  bool join(const ValueSet& other);
};

/// Variables that are followed, by name; all others are unknown.
using Environment = std::map<std::string, ValueSet, std::less<>>;

/// Possible results of an expression.
struct Evaluation {
  ValueSet result;
  std::vector<int> reads;        ///< R numbers it may read, ascending
  bool hasUnknownIndex = false;  ///< an R number is computed from unknown values
  Environment whereTrue;         ///< values for which it may be true
  Environment whereFalse;        ///< values for which it may be false
  bool mayBeTrue = false;
  bool mayBeFalse = false;

  [[nodiscard]] bool asks(int cell) const;
};

[[nodiscard]] Evaluation evaluate(const nc::Expression& expression, const Environment& environment);

/// Variables from which R numbers are computed, with all their values unknown until assigned.
[[nodiscard]] std::vector<std::string> indexVariables(const nc::Tree& program);

/// Where control goes from a statement. The index after the last statement is the end of the text.
struct Exits {
  std::optional<std::size_t> whenTrue;   ///< of the condition, or always
  std::optional<std::size_t> whenFalse;  ///< only if there is a condition
  const nc::Expression* condition = nullptr;
  bool ends = false;
  bool misses = false;  ///< its label does not exist
};
[[nodiscard]] Exits exitsOf(const nc::Tree& program, std::size_t statement);

}  // namespace rivulet::templates
