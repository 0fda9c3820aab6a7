// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/json_members.h"

namespace rivulet::report {

namespace {

/// @param at  of both objects
void keepUnknown(nlohmann::ordered_json& record, const nlohmann::json& replaced,
                 const std::set<std::string>& asked, const nlohmann::json::json_pointer& at) {
  for (const auto& [key, value] : replaced.items()) {
    const nlohmann::json::json_pointer here = at / key;
    const std::string name = here.to_string();
    const auto below = asked.lower_bound(name + '/');
    const bool isKnown =
        asked.contains(name) || (below != asked.end() && below->starts_with(name + '/'));
    const auto own = record.find(key);
    if (own == record.end() && !isKnown) {
      record[key] = value;
    } else if (own != record.end() && own->is_object() && value.is_object()) {
      keepUnknown(*own, value, asked, here);
    }
  }
}

}  // namespace

void keepUnknown(nlohmann::ordered_json& record, const nlohmann::json& replaced,
                 const std::set<std::string>& asked) {
  if (replaced.is_object()) {
    keepUnknown(record, replaced, asked, nlohmann::json::json_pointer());
  }
}

}  // namespace rivulet::report
