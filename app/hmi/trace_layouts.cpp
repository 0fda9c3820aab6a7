// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/trace_layouts.h"

#include <nlohmann/json.hpp>

#include "base/file.h"
#include "folders/user_folders.h"

namespace rivulet::hmi {

namespace {

using nlohmann::ordered_json;

widgets::ScopeLayout layoutOf(const ordered_json& json) {
  widgets::ScopeLayout layout;
  if (!json.is_object() || !json.contains("name") || !json["name"].is_string() ||
      !json.contains("panes") || !json["panes"].is_array()) {
    return layout;
  }
  for (const ordered_json& pane : json["panes"]) {
    QStringList formulas;
    for (const ordered_json& formula : pane) {
      if (formula.is_string()) {
        formulas.append(QString::fromStdString(formula.get<std::string>()));
      }
    }
    if (!formulas.isEmpty()) {
      layout.panes.push_back(formulas);
    }
  }
  if (json.contains("heights") && json["heights"].is_array()) {
    for (const ordered_json& height : json["heights"]) {
      layout.heights.append(height.is_number_integer() ? height.get<int>() : 1);
    }
  }
  if (!layout.panes.empty()) {
    layout.name = QString::fromStdString(json["name"].get<std::string>());
  }
  return layout;
}

}  // namespace

std::filesystem::path traceLayoutsFile() {
  return folders::configHome() / "rivulet" / "trace_panes.json";
}

widgets::ScopeLayouts loadTraceLayouts(const std::filesystem::path& file) {
  widgets::ScopeLayouts layouts;
  const auto text = base::readFile(file);
  const ordered_json json =
      text ? ordered_json::parse(*text, nullptr, false) : ordered_json::object();
  if (!json.is_object()) {
    return layouts;
  }
  if (json.contains("layouts") && json["layouts"].is_array()) {
    for (const ordered_json& one : json["layouts"]) {
      widgets::ScopeLayout layout = layoutOf(one);
      if (!layout.name.isEmpty()) {
        layouts.keep(std::move(layout));
      }
    }
  }
  if (json.contains("standard") && json["standard"].is_string()) {
    const QString name = QString::fromStdString(json["standard"].get<std::string>());
    layouts.standard = layouts.find(name) != nullptr ? name : QString();
  }
  return layouts;
}

base::Result<void> saveTraceLayouts(const std::filesystem::path& file,
                                    const widgets::ScopeLayouts& layouts) {
  ordered_json list = ordered_json::array();
  for (const widgets::ScopeLayout& layout : layouts.list) {
    ordered_json panes = ordered_json::array();
    for (const QStringList& pane : layout.panes) {
      ordered_json formulas = ordered_json::array();
      for (const QString& formula : pane) {
        formulas.push_back(formula.toStdString());
      }
      panes.push_back(std::move(formulas));
    }
    list.push_back({{"name", layout.name.toStdString()},
                    {"panes", std::move(panes)},
                    {"heights", std::vector<int>(layout.heights.begin(), layout.heights.end())}});
  }
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  return base::writeFile(
      file,
      ordered_json{{"standard", layouts.standard.toStdString()}, {"layouts", std::move(list)}}.dump(
          2) +
          "\n");
}

}  // namespace rivulet::hmi
