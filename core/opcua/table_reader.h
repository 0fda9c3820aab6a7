// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// TOML files of a person that name nodes of a server: one sentence with file and line for the
/// first thing that is wrong. Only for readers of such files: it brings the TOML library along.
/// @threadsafety plain values.
#pragma once

#include <fmt/format.h>
#include <toml++/toml.h>

#include <string>
#include <utility>

#include "base/file.h"
#include "base/result.h"

namespace rivulet::opcua {

class TableReader {
 public:
  /// A description is short.
  static constexpr std::size_t kBytesMax = 65'536;

  /// @param code  of all problems @param hint  where the form of the file is described
  TableReader(std::string path, std::error_code code, std::string hint)
      : m_path(std::move(path)), m_code(code), m_hint(std::move(hint)) {}

  /// The table of a text; empty, with a problem noted, if it is no TOML.
  [[nodiscard]] toml::table parse(std::string_view text) {
    try {
      return toml::parse(text);
    } catch (const toml::parse_error& error) {
      m_problem = base::makeError(m_code, fmt::format("This is no TOML: {}.", error.description()),
                                  fmt::format("{}, line {}", m_path, error.source().begin.line));
      return {};
    }
  }

  void problem(const std::string& what, const std::string& place = {}) {
    if (!m_problem.code) {
      m_problem = base::makeError(m_code, fmt::format("{}. {}", what, m_hint), m_path + place);
    }
  }
  void problem(const toml::node& node, const std::string& what) {
    problem(what, fmt::format(", line {}", node.source().begin.line));
  }
  void unknown(const toml::node& node, std::string_view key, std::string_view section = {}) {
    problem(node, section.empty() ? fmt::format("{} is not known here", key)
                                  : fmt::format("{} is not known in [{}]", key, section));
  }

  void takeText(std::string_view key, const toml::node& node, std::string& into) {
    const auto text = node.value<std::string>();
    if (!text || text->empty()) {
      problem(node, fmt::format("{} must be a text in quotes", key));
    } else {
      into = *text;
    }
  }
  /// Null, with a problem noted, if it is no section.
  [[nodiscard]] const toml::table* section(std::string_view key, const toml::node& node) {
    if (!node.is_table()) {
      problem(node, fmt::format("{} must be a section: [{}]", key, key));
    }
    return node.as_table();
  }

  [[nodiscard]] const base::Error& firstProblem() const { return m_problem; }

 private:
  std::string m_path;
  std::error_code m_code;
  std::string m_hint;
  base::Error m_problem;
};

}  // namespace rivulet::opcua
