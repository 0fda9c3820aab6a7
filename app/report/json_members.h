// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// JSON that may hold anything, read member by member. @threadsafety plain values.
#pragma once

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/budget.h"
#include "base/file.h"
#include "base/result.h"

namespace rivulet::report {

inline constexpr double kJsonCountMax = 1e9;  ///< of points, requests, pauses
inline constexpr double kJsonCellMax = 1e6;   ///< number of an R-parameter
inline constexpr double kJsonPlaceMax = 1e9;  ///< mm or degrees

/// Whether the text is JSON that is not nested more deeply than anything of ours: who copies or
/// prints a tree calls himself for each level. Nothing is made of it.
/// @return error BudgetError::Exceeded: its tree would take more; a byte may stand for forty
[[nodiscard]] base::Result<bool> isSoundJson(std::string_view text, const base::Budget& budget);

/// The tree of a text; discarded if `isSoundJson` is false. @return error BudgetError::Exceeded
template <class Json = nlohmann::json>
[[nodiscard]] base::Result<Json> parseJson(std::string_view text, const base::Budget& budget = {}) {
  auto isSound = isSoundJson(text, budget);
  if (!isSound) {
    return base::fail(std::move(isSound.error()));
  }
  return *isSound ? Json::parse(text, nullptr, false) : Json(nlohmann::detail::value_t::discarded);
}

/// That of a file. @return errors of `base::readFile` and `parseJson`
template <class Json = nlohmann::json>
[[nodiscard]] base::Result<Json> readJson(const std::filesystem::path& file,
                                          const base::Budget& budget = {}) {
  const auto text = base::readFile(file, budget);
  if (!text) {
    return base::fail(text.error());
  }
  auto json = parseJson<Json>(*text, budget.without(text->capacity()));
  return json ? std::move(json)
              : base::fail(json.error().code, json.error().message, file.string());
}

/// Reads members of a JSON text that may hold anything. The first that is missing, has another type
/// or is out of range is remembered.
class Members {
 public:
  /// @param asked  gets the pointers that are asked for; null: nobody needs them
  explicit Members(const nlohmann::json& root, std::set<std::string>* asked = nullptr)
      : m_root(root), m_asked(asked) {}

  [[nodiscard]] bool has(const char* pointer) const { return find(pointer) != nullptr; }

  double number(const char* pointer, double min, double max) {
    const nlohmann::json* value = find(pointer);
    if (value != nullptr && value->is_number()) {
      const double number = value->get<double>();
      if (number >= min && number <= max) {
        return number;
      }
    }
    return refuse(pointer), min;
  }
  template <class Integer>
  Integer integer(const char* pointer, double min, double max) {
    const double value = number(pointer, min, max);
    if (value != std::floor(value)) {
      refuse(pointer);
    }
    return static_cast<Integer>(value);
  }
  bool flag(const char* pointer) {
    const nlohmann::json* value = find(pointer);
    if (value != nullptr && value->is_boolean()) {
      return value->get<bool>();
    }
    return refuse(pointer), false;
  }
  std::string text(const char* pointer) {
    const nlohmann::json* value = find(pointer);
    if (value != nullptr && value->is_string()) {
      return value->get<std::string>();
    }
    return refuse(pointer), std::string();
  }
  /// A list of texts; empty if there is none.
  std::vector<std::string> words(const char* pointer) {
    std::vector<std::string> words;
    const nlohmann::json* list = find(pointer);
    if (list == nullptr) {
      return words;
    }
    for (const nlohmann::json& word : list->is_array() ? *list : nlohmann::json::array()) {
      if (word.is_string()) {
        words.push_back(word.get<std::string>());
      }
    }
    if (!list->is_array() || words.size() != list->size()) {
      refuse(pointer);
    }
    return words;
  }
  /// Members that earlier versions did not write keep their value if they are missing.
  template <class Value, class Read>
  void ifThere(const char* pointer, Value& value, Read read) {
    if (has(pointer)) {
      value = read(pointer);
    }
  }
  void refuse(const char* pointer) {
    if (m_bad.empty()) {
      m_bad = pointer;
    }
  }
  /// The first member that cannot be used; empty: none.
  [[nodiscard]] const std::string& bad() const { return m_bad; }
  [[nodiscard]] const nlohmann::json* find(const char* pointer) const {
    if (m_asked != nullptr) {
      m_asked->insert(pointer);
    }
    const nlohmann::json::json_pointer at(pointer);
    return m_root.is_object() && m_root.contains(at) ? &m_root.at(at) : nullptr;
  }

 private:
  const nlohmann::json& m_root;
  std::set<std::string>* m_asked;
  std::string m_bad;
};

/// Puts into a record what the one that it replaces has besides: a later version wrote it. Within
/// lists nothing is kept.
/// @param asked  what a reader of this version asks for (`Members`)
void keepUnknown(nlohmann::ordered_json& record, const nlohmann::json& replaced,
                 const std::set<std::string>& asked);

}  // namespace rivulet::report
