// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How control may pass through an NC program, and which values an expression may have: the ground
/// the lint stands on. @threadsafety plain values; functions pure.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "nc/syntax/tree.h"

namespace rivulet::templates {

/// All values a variable may have at a place; unknown: any.
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

/// What an expression may come to.
struct Evaluation {
  ValueSet result;
  std::vector<int> reads;        ///< R numbers it may ask for, ascending
  bool hasUnknownIndex = false;  ///< an R number comes from what is not known
  Environment whereTrue;         ///< values with which it may hold
  Environment whereFalse;        ///< … with which it may not
  bool mayBeTrue = false;
  bool mayBeFalse = false;

  [[nodiscard]] bool asks(int cell) const;
};

[[nodiscard]] Evaluation evaluate(const nc::Expression& expression, const Environment& environment);

/// Variables from which R numbers are computed, with all their values unknown until assigned.
[[nodiscard]] std::vector<std::string> indexVariables(const nc::Tree& program);

/// Where control goes from a statement. The index behind the last statement is the end of the text.
struct Exits {
  std::optional<std::size_t> whenTrue;   ///< of the condition, or always
  std::optional<std::size_t> whenFalse;  ///< only where there is a condition
  const nc::Expression* condition = nullptr;
  bool ends = false;
  bool misses = false;  ///< its label does not exist
};
[[nodiscard]] Exits exitsOf(const nc::Tree& program, std::size_t statement);

}  // namespace rivulet::templates
