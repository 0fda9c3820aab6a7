// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/budget.h"

#include <fmt/format.h>

#include <array>

namespace rivulet::base {

namespace {

/// "12.3 GB"; units of a thousand, as the option counts them.
std::string bytesText(double bytes) {
  static constexpr std::array kUnits{"bytes", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  while (bytes >= 1000.0 && unit + 1 < kUnits.size()) {
    bytes /= 1000.0;
    ++unit;
  }
  return fmt::format("{:.3g} {}", bytes, kUnits[unit]);
}

}  // namespace

std::error_code make_error_code(BudgetError code) {
  static const NamedCategory category("budget");
  return {static_cast<int>(code), category};
}

Result<void> Budget::require(double bytes, std::string_view what) const {
  return bytes <= static_cast<double>(m_left) ? Result<void>{} : fail(exceeded(what, bytes));
}

Error Budget::exceeded(std::string_view what, double bytes) const {
  const std::string limit = bytesText(static_cast<double>(m_whole));
  const std::string taken =
      bytes > static_cast<double>(m_whole)
          ? fmt::format("{} of memory, and {} may be taken", bytesText(bytes), limit)
          : fmt::format("more than {} of memory", limit);
  return makeError(
      BudgetError::Exceeded,
      fmt::format("{} would take {}. Give a smaller one, or allow more with rivulet-cli "
                  "--memory-limit.",
                  what, taken));
}

}  // namespace rivulet::base
