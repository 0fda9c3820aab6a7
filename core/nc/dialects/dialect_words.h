// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a folder of nc/dialects says of one dialect: its `Language` and its words. Each folder has
/// a header with these two functions. @threadsafety pure.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string_view>
#include <unordered_map>

#include "nc/modal/vocabulary.h"

namespace rivulet::nc {

using NameTable = std::unordered_map<std::string_view, NameEffect>;

struct MFunction {
  int number = 0;
  MEffect effect = MEffect::None;
};

struct DialectWords {
  GTable g{};
  std::span<const MFunction> m;
  NameTable names;
};

/// Marks functions of a table, by key; what is marked later wins.
class GMarks {
 public:
  explicit GMarks(GTable& table) : m_table(table) {}
  void operator()(GEffect effect, std::initializer_list<int> keys) const {
    for (const int key : keys) {
      m_table[static_cast<std::size_t>(key)] = effect;
    }
  }

 private:
  GTable& m_table;
};

/// G functions that mean the same in all dialects.
void markCommon(const GMarks& mark);
/// M functions that mean the same in all dialects.
[[nodiscard]] std::span<const MFunction> commonMFunctions();

}  // namespace rivulet::nc
