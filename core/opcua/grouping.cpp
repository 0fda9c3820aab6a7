// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/grouping.h"

#include <array>

#include "base/contract.h"

namespace rivulet::opcua {

namespace {

constexpr std::array kAll{Grouping::List, Grouping::Single, Grouping::ArrayCount,
                          Grouping::ArrayRange};

}  // namespace

std::string_view groupingName(Grouping grouping) {
  switch (grouping) {
    case Grouping::List:
      return "list";
    case Grouping::Single:
      return "single";
    case Grouping::ArrayCount:
      return "array-count";
    case Grouping::ArrayRange:
      return "array-range";
  }
  base::contractViolated("every grouping has a name", __FILE__, __LINE__);
}

std::optional<Grouping> groupingFromName(std::string_view name) {
  for (const Grouping grouping : kAll) {
    if (groupingName(grouping) == name) {
      return grouping;
    }
  }
  return std::nullopt;
}

std::size_t sharedNodeLength(std::span<const Variable> variables, std::size_t first,
                             Grouping grouping) {
  RIVULET_ASSERT(first < variables.size());
  std::size_t length = 1;
  if (!isArray(grouping) || variables[first].kind != VariableKind::RParameter) {
    return length;
  }
  while (first + length < variables.size() &&
         variables[first + length].kind == VariableKind::RParameter &&
         variables[first + length].index == variables[first + length - 1].index + 1) {
    ++length;
  }
  return length;
}

}  // namespace rivulet::opcua
