// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The language of inscriptions, a small part of Standard ML: numbers, texts, records `TASK{ID =
/// 1}` and `t {ID = 1}` (another value of a field), `t.ID`, lists (`[]`, head, tail, length, empty,
/// ins, sort), `if … then … else …`, andalso, orelse, not, comparisons, + - * div mod, min, max,
/// uniform, now, and the functions of the net. @threadsafety pure.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "petri/net.h"

namespace rivulet::petri {

/// What names mean at one place of a net.
struct Scope {
  struct Variable {
    std::string name;
    ColourId colour = kInt;
  };
  std::vector<Variable> variables;            ///< their index is the number of the variable
  std::map<std::string, NodeId> constants;    ///< parameters of net and page
  std::map<std::string, std::size_t> places;  ///< for `tokens`; empty: it is not allowed
};

/// Appends the nodes of an expression to the net.
/// @return the root; NotANet, Unknown or WrongColour with a sentence that quotes the text
[[nodiscard]] base::Result<NodeId> parseExpression(Net& net, const Scope& scope,
                                                   std::string_view text);

/// Whether a value of one colour set may stand where another is expected.
[[nodiscard]] bool fits(const Net& net, ColourId value, ColourId expected);

/// Appends the function `fun name(a:INT, b:TASK) = expression`. @return as parseExpression
[[nodiscard]] base::Result<void> parseFunction(Net& net, const Scope& scope, std::string_view text);

/// The operands of `andalso`, or the expression itself.
void splitConditions(const Net& net, NodeId condition, std::vector<NodeId>& parts);
/// Calls `visit` for an expression, its parts and the functions it calls, except for the variables
/// of these functions.
void visitNodes(const Net& net, NodeId root, const std::function<void(const Node&)>& visit);

}  // namespace rivulet::petri
