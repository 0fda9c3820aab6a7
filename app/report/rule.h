// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Rules on results, such as "skipped>0 or contour_error.max>0.05". @threadsafety pure.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace rivulet::report {

enum class RuleError { BadRule = 1 };
[[nodiscard]] std::error_code make_error_code(RuleError code);

/// Comparisons (`< <= > >= == !=`) of figures with numbers, joined by `and` and `or`; `and` binds
/// more tightly. A figure is named by its place in the JSON: `feed.kept_share`. The unit at the end
/// of its name may be left out: `contour_error.max`.
class Rule {
 public:
  /// @return error BadRule
  [[nodiscard]] static base::Result<Rule> parse(std::string_view text);

  struct Verdict {
    bool applies = false;
    /// Figures that the result does not have, or that are null: their comparisons do not apply.
    std::vector<std::string> unknown;
  };
  [[nodiscard]] Verdict judge(const nlohmann::ordered_json& result) const;

 private:
  struct Comparison {
    std::string figure;
    std::string sign;
    double value = 0.0;
  };
  std::vector<std::vector<Comparison>> m_alternatives;  ///< each: all must apply
};

}  // namespace rivulet::report

template <>
struct std::is_error_code_enum<rivulet::report::RuleError> : std::true_type {};
