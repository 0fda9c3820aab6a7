// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sources/server_map.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/file.h"
#include "live/error.h"
#include "opcua/table_reader.h"

namespace rivulet::sources {

namespace {

using base::Result;

constexpr std::array<std::pair<std::string_view, opcua::Variable>, 9> kPoints{
    {{"n", kNumberVariable},
     {"line", kLineVariable},
     {"f", kFeedVariable},
     {"x", axisVariable(0)},
     {"y", axisVariable(1)},
     {"z", axisVariable(2)},
     {"a", axisVariable(3)},
     {"b", axisVariable(4)},
     {"c", axisVariable(5)}}};
constexpr std::array<std::pair<std::string_view, opcua::Variable>, 2> kReplies{
    {{"accepted", kAcceptedVariable}, {"executed", kExecutedVariable}}};

class MapReader {
 public:
  explicit MapReader(const std::string& path)
      : m_reader(path, live::LiveError::BadSourceFile,
                 "docs/live.md shows what the file of a source has to have.") {}

  Result<ServerMap> read(std::string_view text) {
    const toml::table root = m_reader.parse(text);
    for (const auto& [key, node] : root) {
      if (std::string* const into = place(key.str())) {
        m_reader.takeText(key.str(), node, *into);
      } else if (key.str() == "points") {
        takeNodes(key.str(), node, kPoints);
      } else if (key.str() == "replies") {
        takeNodes(key.str(), node, kReplies);
      } else {
        m_reader.unknown(node, key.str());
      }
    }
    requireWhole();
    const base::Error& problem = m_reader.firstProblem();
    return problem.code ? Result<ServerMap>(base::fail(problem)) : Result<ServerMap>(m_map);
  }

 private:
  std::string* place(std::string_view key) {
    return key == "endpoint"        ? &m_map.request.endpoint
           : key == "user"          ? &m_map.request.user
           : key == "fingerprint"   ? &m_map.request.fingerprint
           : key == "password_file" ? &m_map.passwordFile
                                    : nullptr;
  }

  template <std::size_t count>
  void takeNodes(std::string_view name, const toml::node& node,
                 const std::array<std::pair<std::string_view, opcua::Variable>, count>& known) {
    const toml::table* const section = m_reader.section(name, node);
    if (section == nullptr) {
      return;
    }
    for (const auto& [key, value] : *section) {
      const std::string_view variable = key.str();
      const auto* const found = std::find_if(
          known.begin(), known.end(), [&](const auto& one) { return one.first == variable; });
      if (found == known.end()) {
        m_reader.unknown(value, variable, name);
      } else {
        m_reader.takeText(variable, value, m_map.request.nodes[found->second]);
      }
    }
  }

  void requireWhole() {
    bool hasAxis = false;
    for (std::size_t axis = 0; axis < base::kAxisCount + base::kRotaryAxisCount; ++axis) {
      hasAxis = hasAxis || m_map.has(axisVariable(static_cast<int>(axis)));
    }
    const bool hasWords = m_map.has(kNumberVariable) || m_map.has(kFeedVariable) || hasAxis;
    if (m_map.request.endpoint.empty()) {
      m_reader.problem("endpoint is missing");
    } else if (m_map.has(kLineVariable) && hasWords) {
      m_reader.problem("[points] must have either line or n and axes, not both");
    } else if (!m_map.has(kLineVariable) && !(m_map.has(kNumberVariable) && hasAxis)) {
      m_reader.problem("[points] must have line, or n and at least one axis");
    }
  }

  opcua::TableReader m_reader;
  ServerMap m_map;
};

}  // namespace

Result<ServerMap> readServerMap(const std::string& path) {
  const auto text = base::readFile(path, opcua::TableReader::kBytesMax);
  if (!text) {
    return base::fail(text.error());
  }
  auto map = MapReader(path).read(*text);
  if (map) {
    map->request.sessionName = "Rivulet live source";
  }
  return map;
}

}  // namespace rivulet::sources
