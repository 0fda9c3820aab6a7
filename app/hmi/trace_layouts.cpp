// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/trace_layouts.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/file.h"
#include "platform/user_folders.h"

namespace rivulet::hmi {

namespace {

using nlohmann::ordered_json;

/// Nothing: it is damaged.
std::optional<widgets::ScopeLayout> layoutOf(const ordered_json& json) {
  if (!json.is_object() || !json.contains("name") || !json["name"].is_string() ||
      !json.contains("panes") || !json["panes"].is_array()) {
    return std::nullopt;
  }
  widgets::ScopeLayout layout;
  layout.name = QString::fromStdString(json["name"].get<std::string>());
  for (const ordered_json& pane : json["panes"]) {
    QStringList formulas;
    for (const ordered_json& formula : pane) {
      if (!formula.is_string()) {
        return std::nullopt;
      }
      formulas.append(QString::fromStdString(formula.get<std::string>()));
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
  return layout.name.isEmpty() || layout.panes.empty() ? std::nullopt : std::optional(layout);
}

/// @return false: a part was damaged and is left out
bool parseLayouts(const std::string& text, widgets::ScopeLayouts& layouts) {
  const ordered_json json = ordered_json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("layouts") || !json["layouts"].is_array()) {
    return false;
  }
  bool isSound = true;
  for (const ordered_json& one : json["layouts"]) {
    std::optional<widgets::ScopeLayout> layout = layoutOf(one);
    if (layout) {
      layouts.keep(std::move(*layout));
    } else {
      isSound = false;
    }
  }
  if (json.contains("standard") && json["standard"].is_string()) {
    const QString name = QString::fromStdString(json["standard"].get<std::string>());
    layouts.standard = layouts.find(name) != nullptr ? name : QString();
  }
  return isSound;
}

}  // namespace

std::filesystem::path traceLayoutsFile() {
  return folders::configHome() / "rivulet" / "trace_panes.json";
}

base::Result<LoadedTraceLayouts> loadTraceLayouts(const std::filesystem::path& file) {
  LoadedTraceLayouts loaded;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    return loaded;
  }
  const auto text = base::readFile(file);
  if (!text) {
    return base::fail(text.error());
  }
  if (parseLayouts(*text, loaded.layouts)) {
    return loaded;
  }
  loaded.keptAs = folders::moveAside(file);
  if (loaded.keptAs.empty()) {
    return base::fail(base::FileError::NotWritable,
                      "The damaged file cannot be renamed. Check that you may write in its folder.",
                      file.string());
  }
  if (!loaded.layouts.list.empty()) {
    if (auto saved = saveTraceLayouts(file, loaded.layouts); !saved) {
      return base::fail(saved.error());
    }
  }
  return loaded;
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
          2, ' ', false, ordered_json::error_handler_t::replace) +
          "\n");
}

}  // namespace rivulet::hmi
