// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A file with what one of several computers has computed of an experiment. @threadsafety pure.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

#include "base/budget.h"
#include "base/result.h"
#include "base/share.h"

namespace rivulet::report {

enum class SweepPartError {
  Unreadable = 1,  ///< no part of an experiment, or a damaged one
  Unlike,          ///< the parts are not of one and the same experiment
};

[[nodiscard]] std::error_code make_error_code(SweepPartError code);

/// What all parts of an experiment have in common.
struct SweepOrigin {
  std::string version;     ///< of the program that computed it
  std::string experiment;  ///< "figure4"
  std::size_t seeds = 0;   ///< 0: the usual number
  std::string preset;      ///< a name or a file, as it was given
  std::string presetHash;  ///< SHA-256 of the file; empty for a name

  bool operator==(const SweepOrigin&) const = default;
};

struct SweepPart {
  SweepOrigin origin;
  base::ShareNumbers numbers;
};

[[nodiscard]] std::string sweepPartText(const SweepPart& part);

/// @param name  of the file, for the message
/// @return error Unreadable, BudgetError::Exceeded
[[nodiscard]] base::Result<SweepPart> sweepPartOf(std::string_view text, const std::string& name,
                                                  const base::Budget& budget = {});

/// All parts of one experiment. @return the whole of it; Unlike, or what base::merged returns
[[nodiscard]] base::Result<SweepPart> mergedParts(const std::vector<SweepPart>& parts);

}  // namespace rivulet::report

template <>
struct std::is_error_code_enum<rivulet::report::SweepPartError> : std::true_type {};
