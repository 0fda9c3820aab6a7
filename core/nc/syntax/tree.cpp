// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/syntax/tree.h"

#include <algorithm>
#include <type_traits>

namespace rivulet::nc {

std::optional<std::size_t> Tree::find(std::string_view label, JumpDirection direction,
                                      std::size_t from) const {
  if (direction == JumpDirection::Start) {
    return 0;
  }
  // Labels are stored in the order of the text; a label at `from` itself is after the jump.
  const auto after = std::find_if(labels.begin(), labels.end(), [&](const Label& candidate) {
    return candidate.statement > from && candidate.name == label;
  });
  const auto before = std::find_if(labels.rbegin(), labels.rend(), [&](const Label& candidate) {
    return candidate.statement <= from && candidate.name == label;
  });
  if (direction != JumpDirection::Backward && after != labels.end()) {
    return after->statement;
  }
  const bool alsoBack = direction == JumpDirection::Backward ||
                        direction == JumpDirection::ForwardThenBackward ||
                        direction == JumpDirection::ForwardNoAlarm;
  if (alsoBack && before != labels.rend()) {
    return before->statement;
  }
  return std::nullopt;
}

std::size_t Tree::nextBlock(std::size_t statement) const {
  do {
    ++statement;
  } while (statement < statements.size() && !statements[statement].beginsBlock);
  return statement;
}

namespace {

using Visit = std::function<void(const Expression&)>;

void each(const std::optional<Expression>& expression, const Visit& visit) {
  if (expression) {
    visit(*expression);
  }
}

void each(const Initial& initial, const Visit& visit) {
  for (const std::optional<Expression>& value : initial.values) {
    each(value, visit);
  }
}

void each(const Assignment& assignment, const Visit& visit) {
  for (const Expression& index : assignment.target.operands) {
    visit(index);
  }
  each(assignment.initial, visit);
}

void each(const Call& call, const Visit& visit) {
  each(call.computed, visit);
  each(call.times, visit);
  for (const std::optional<Expression>& argument : call.arguments) {
    each(argument, visit);
  }
}

}  // namespace

void forEachExpression(const Statement& statement, const Visit& visit) {
  std::visit(
      [&visit](const auto& what) {
        using What = std::decay_t<decltype(what)>;
        if constexpr (std::is_same_v<What, Words>) {
          for (const Token& token : what.tokens) {
            if (token.calculation != nullptr && *token.calculation) {
              each(**token.calculation, visit);
            }
          }
        } else if constexpr (std::is_same_v<What, Assignment>) {
          each(what, visit);
        } else if constexpr (std::is_same_v<What, Definition>) {
          for (const std::optional<Expression>& size : what.sizes) {
            each(size, visit);
          }
          if (what.initial) {
            each(*what.initial, visit);
          }
        } else if constexpr (std::is_same_v<What, Message>) {
          each(what.text, visit);
        } else if constexpr (std::is_same_v<What, Jump> || std::is_same_v<What, Branch>) {
          each(what.condition, visit);
        } else if constexpr (std::is_same_v<What, RepeatLabel>) {
          each(what.times, visit);
        } else if constexpr (std::is_same_v<What, Call>) {
          each(what, visit);
        } else if constexpr (std::is_same_v<What, RepeatedCall>) {
          if (what.call) {
            each(*what.call, visit);
          }
        } else if constexpr (std::is_same_v<What, Return>) {
          each(what.value, visit);
        } else if constexpr (std::is_same_v<What, Cancel>) {
          visit(what.id);
        }
      },
      statement.what);
}

}  // namespace rivulet::nc
