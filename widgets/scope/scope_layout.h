// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Arrangements of panes that have a name. @threadsafety plain values.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>
#include <algorithm>
#include <vector>

namespace rivulet::widgets {

struct ScopeLayout {
  QString name;
  std::vector<QStringList> panes;  ///< formulas, pane by pane
  QList<int> heights;              ///< of the panes, in relation to each other

  friend bool operator==(const ScopeLayout&, const ScopeLayout&) = default;
};

struct ScopeLayouts {
  std::vector<ScopeLayout> list;  ///< by name, each once
  /// New traces are shown in this one if they have its signals. Empty: as the page proposes.
  QString standard;

  /// Null: there is none of that name.
  [[nodiscard]] const ScopeLayout* find(const QString& name) const {
    const auto found = std::find_if(list.begin(), list.end(),
                                    [&name](const ScopeLayout& one) { return one.name == name; });
    return found == list.end() ? nullptr : &*found;
  }
  /// Replaces that of the same name.
  void keep(ScopeLayout layout) {
    remove(layout.name);
    const auto place = std::find_if(list.begin(), list.end(), [&layout](const ScopeLayout& one) {
      return layout.name.localeAwareCompare(one.name) < 0;
    });
    list.insert(place, std::move(layout));
  }
  void remove(const QString& name) {
    std::erase_if(list, [&name](const ScopeLayout& one) { return one.name == name; });
  }

  friend bool operator==(const ScopeLayouts&, const ScopeLayouts&) = default;
};

}  // namespace rivulet::widgets
