// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a folder of nc/dialects says of one dialect: its `Language` and its words. Each folder has
/// a header with these two functions. @threadsafety pure.
#pragma once

#include <initializer_list>
#include <span>
#include <string_view>
#include <unordered_map>

#include "nc/modal/vocabulary.h"

namespace rivulet::nc {

/// A word that is a name.
struct NameRow {
  NameEffect effect = NameEffect::Unknown;
  std::string_view source;  ///< manual, and its chapter
};

class NameTable {
 public:
  void add(NameEffect effect, std::string_view source,
           std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
      m_rows.emplace(name, NameRow{effect, source});
    }
  }
  [[nodiscard]] NameEffect effect(std::string_view name) const {
    const auto found = m_rows.find(name);
    return found == m_rows.end() ? NameEffect::Unknown : found->second.effect;
  }

 private:
  std::unordered_map<std::string_view, NameRow> m_rows;
};

struct DialectWords {
  GTable g;
  std::span<const MRow> m;
  NameTable names;
};

}  // namespace rivulet::nc
