// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sources/server_map.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <array>
#include <utility>

#include "base/file.h"
#include "live/error.h"

namespace rivulet::sources {

namespace {

using base::Result;

/// A description is short.
constexpr std::size_t kMapBytesMax = 65'536;

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
  explicit MapReader(std::string path) : m_path(std::move(path)) {}

  Result<ServerMap> read(const toml::table& root) {
    for (const auto& [key, node] : root) {
      if (std::string* const text = place(key.str())) {
        takeText(key.str(), node, *text);
      } else if (key.str() == "points") {
        takeNodes(key.str(), node, kPoints);
      } else if (key.str() == "replies") {
        takeNodes(key.str(), node, kReplies);
      } else {
        problem(node, fmt::format("{} is not known here", key.str()));
      }
    }
    requireWhole();
    return m_problem.code ? Result<ServerMap>(base::fail(m_problem)) : Result<ServerMap>(m_map);
  }

 private:
  std::string* place(std::string_view key) {
    return key == "endpoint"        ? &m_map.request.endpoint
           : key == "user"          ? &m_map.request.user
           : key == "fingerprint"   ? &m_map.request.fingerprint
           : key == "password_file" ? &m_map.passwordFile
                                    : nullptr;
  }

  void takeText(std::string_view key, const toml::node& node, std::string& into) {
    const auto text = node.value<std::string>();
    if (!text || text->empty()) {
      problem(node, fmt::format("{} must be a text in quotes", key));
    } else {
      into = *text;
    }
  }

  template <std::size_t count>
  void takeNodes(std::string_view section, const toml::node& node,
                 const std::array<std::pair<std::string_view, opcua::Variable>, count>& known) {
    if (!node.is_table()) {
      problem(node, fmt::format("{} must be a section: [{}]", section, section));
      return;
    }
    for (const auto& [key, value] : *node.as_table()) {
      const auto* const found = std::find_if(
          known.begin(), known.end(), [&](const auto& one) { return one.first == key.str(); });
      if (found == known.end()) {
        problem(value, fmt::format("{} is not known in [{}]", key.str(), section));
      } else {
        takeText(key.str(), value, m_map.request.nodes[found->second]);
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
      problem("endpoint is missing");
    } else if (m_map.has(kLineVariable) && hasWords) {
      problem("[points] must have either line or n and axes, not both");
    } else if (!m_map.has(kLineVariable) && !(m_map.has(kNumberVariable) && hasAxis)) {
      problem("[points] must have line, or n and at least one axis");
    }
  }

  void problem(const std::string& what, const std::string& place = {}) {
    if (!m_problem.code) {
      m_problem = base::makeError(
          live::LiveError::BadSourceFile,
          fmt::format("{}. docs/live.md shows what the file of a source has to have.", what),
          m_path + place);
    }
  }
  void problem(const toml::node& node, const std::string& what) {
    problem(what, fmt::format(", line {}", node.source().begin.line));
  }

  std::string m_path;
  ServerMap m_map;
  base::Error m_problem;
};

}  // namespace

Result<ServerMap> readServerMap(const std::string& path) {
  const auto text = base::readFile(path, kMapBytesMax);
  if (!text) {
    return base::fail(text.error());
  }
  try {
    auto map = MapReader(path).read(toml::parse(*text));
    if (map) {
      map->request.sessionName = "Rivulet live source";
    }
    return map;
  } catch (const toml::parse_error& error) {
    return base::fail(live::LiveError::BadSourceFile,
                      fmt::format("This is no TOML: {}.", error.description()),
                      fmt::format("{}, line {}", path, error.source().begin.line));
  }
}

}  // namespace rivulet::sources
