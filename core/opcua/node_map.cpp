// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/node_map.h"

#include <fmt/format.h>
#include <algorithm>

#include <array>

#include "base/contract.h"
#include "base/text.h"

namespace rivulet::opcua {

namespace {

/// How the index of a variable appears in its identifier.
enum class Indexing {
  None,      ///< one value per channel
  FromZero,  ///< the number is the index: R0 is R[u1,0], G group 8 is [u1,8]
  FromOne,   ///< axes count from 1 on the control, from 0 here
};

struct Row {
  VariableKind kind;
  std::string_view path;
  Indexing indexing;
};

constexpr std::string_view kParameterPath = "/Channel/Parameter/R";
constexpr std::string_view kUnit = "u1,";
constexpr int kIndexMax = 1'000'000;

constexpr std::array kRows{
    Row{VariableKind::RParameter, kParameterPath, Indexing::FromZero},
    Row{VariableKind::ActualPosition, "/Channel/GeometricAxis/aaAcsRel", Indexing::FromOne},
    Row{VariableKind::DistanceToGo, "/Channel/GeometricAxis/aaDtew", Indexing::FromOne},
    Row{VariableKind::PathFeed, "/Channel/State/actFeedRateIpo", Indexing::None},
    Row{VariableKind::ProgramStatus, "/Channel/State/progStatus", Indexing::None},
    Row{VariableKind::ChannelStatus, "/Channel/State/chanStatus", Indexing::None},
    Row{VariableKind::LineNumber, "/Channel/ProgramInfo/actLineNumber", Indexing::None},
    Row{VariableKind::ProgramName, "/Channel/ProgramInfo/selectedWorkPProg", Indexing::None},
    Row{VariableKind::Message, "/Channel/ProgramInfo/msg", Indexing::None},
    Row{VariableKind::Alarm, "/Channel/State/chanAlarm", Indexing::None},
    Row{VariableKind::AxisName, "/Channel/GeometricAxis/name", Indexing::FromOne},
    Row{VariableKind::ToolNumber, "/Channel/State/actTNumber", Indexing::None},
    Row{VariableKind::ToolName, "/Channel/State/actToolIdent", Indexing::None},
    Row{VariableKind::EdgeNumber, "/Channel/State/actDNumber", Indexing::None},
    Row{VariableKind::SpindleSpeed, "/Channel/Spindle/actSpeed", Indexing::FromOne},
    Row{VariableKind::SpindleSpeedSet, "/Channel/Spindle/cmdSpeed", Indexing::FromOne},
    Row{VariableKind::SpindleTurn, "/Channel/Spindle/turnState", Indexing::FromOne},
    Row{VariableKind::GFunction, "/Channel/SelectedFunctions/ncFktAct", Indexing::FromZero},
    Row{VariableKind::MFunction, "/Channel/AuxiliaryFunctions/acAuxfuMValue", Indexing::FromZero},
};

/// The longest name a SINUMERIK program can have, extension included.
constexpr std::size_t kProgramNameLengthMax = 32;
constexpr std::string_view kPartPrograms = "Sinumerik/FileSystem/Part Program/";
constexpr std::string_view kSubPrograms = "Sinumerik/FileSystem/Sub Program/";

/// Digits only: the control takes neither signs nor blanks in an index.
std::optional<int> parseIndex(std::string_view text) {
  if (text.empty() || text.find_first_not_of("0123456789") != std::string_view::npos) {
    return std::nullopt;
  }
  return base::parseInteger(text);
}

/// The number in "[u1,n]" or "[n]".
std::optional<int> parseSubscript(std::string_view text) {
  if (text.size() < 3 || text.front() != '[' || text.back() != ']') {
    return std::nullopt;
  }
  text = text.substr(1, text.size() - 2);
  if (text.substr(0, kUnit.size()) == kUnit) {
    text.remove_prefix(kUnit.size());
  }
  return parseIndex(text);
}

}  // namespace

std::string memberIdentifier(std::string_view object, std::string_view member) {
  return fmt::format("{}/{}", object, member);
}

std::string nodeIdentifier(const Variable& variable) {
  RIVULET_ASSERT(variable.index >= 0);
  for (const Row& row : kRows) {
    if (row.kind == variable.kind) {
      switch (row.indexing) {
        case Indexing::None:
          return std::string(row.path);
        case Indexing::FromZero:
          return fmt::format("{}[u1,{}]", row.path, variable.index);
        case Indexing::FromOne:
          return fmt::format("{}[u1,{}]", row.path, variable.index + 1);
      }
    }
  }
  base::contractViolated("every kind of variable has a row", __FILE__, __LINE__);
}

std::optional<Variable> variableOf(std::string_view identifier) {
  const std::size_t bracket = identifier.find('[');
  const std::string_view path = identifier.substr(0, bracket);
  const bool hasSubscript = bracket != std::string_view::npos;
  for (const Row& row : kRows) {
    if (row.path != path) {
      continue;
    }
    if (row.indexing == Indexing::None) {
      return hasSubscript ? std::nullopt : std::optional(Variable{row.kind, 0});
    }
    const std::optional<int> number =
        hasSubscript ? parseSubscript(identifier.substr(bracket)) : std::optional(1);
    if (!number) {
      return std::nullopt;
    }
    const int index = row.indexing == Indexing::FromOne ? *number - 1 : *number;
    return index < 0 ? std::nullopt : std::optional(Variable{row.kind, index});
  }
  return std::nullopt;
}

std::string arrayIdentifier(const ParameterArray& array) {
  RIVULET_ASSERT(array.first >= 0 && array.count >= 1 && isArray(array.form));
  return array.form == Grouping::ArrayCount
             ? fmt::format("{}[u1,{},#{}]", kParameterPath, array.first, array.count)
             : fmt::format("{}[u1,{},{}]", kParameterPath, array.first,
                           array.first + array.count - 1);
}

std::optional<ParameterArray> arrayOf(std::string_view identifier) {
  if (!identifier.starts_with(kParameterPath)) {
    return std::nullopt;
  }
  std::string_view text = identifier.substr(kParameterPath.size());
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') {
    return std::nullopt;
  }
  text = text.substr(1, text.size() - 2);
  if (text.starts_with(kUnit)) {
    text.remove_prefix(kUnit.size());
  }
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) {
    return std::nullopt;
  }
  const std::optional<int> first = parseIndex(text.substr(0, comma));
  std::string_view rest = text.substr(comma + 1);
  const bool isCount = rest.starts_with('#');
  if (isCount) {
    rest.remove_prefix(1);
  }
  const std::optional<int> second = parseIndex(rest);
  // Far beyond any control, and nothing that is added to it overflows.
  if (!first || !second || *first > kIndexMax || *second > kIndexMax) {
    return std::nullopt;
  }
  const int count = isCount ? *second : *second - *first + 1;
  if (count < 1) {
    return std::nullopt;
  }
  return ParameterArray{*first, count, isCount ? Grouping::ArrayCount : Grouping::ArrayRange};
}

bool isSubprogramName(std::string_view name) {
  return name.size() >= 4 && base::toUpper(name.substr(name.size() - 4)) == ".SPF";
}

std::string programPath(std::string_view name) {
  return std::string(isSubprogramName(name) ? kSubPrograms : kPartPrograms).append(name);
}

std::optional<std::string> programNameOf(std::string_view path) {
  std::string_view name;
  for (const std::string_view folder : {kPartPrograms, kSubPrograms}) {
    if (path.substr(0, folder.size()) == folder) {
      name = path.substr(folder.size());
    }
  }
  if (name.empty() || name.size() > kProgramNameLengthMax ||
      name.find('/') != std::string_view::npos || name == "." || name == ".." ||
      std::any_of(name.begin(), name.end(), [](char c) { return c >= 0 && c < ' '; })) {
    return std::nullopt;
  }
  return std::string(name);
}

}  // namespace rivulet::opcua
