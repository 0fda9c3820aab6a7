// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Nets as TOML files (docs/parallel.md describes the format): pages, substitution transitions with
/// sockets and constants, fusion places. @threadsafety pure, except `loadNet`, which reads a file.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/budget.h"
#include "base/result.h"
#include "petri/net.h"

namespace rivulet::petri {

/// Values of parameters that differ from those of the file.
using ParameterValues = std::map<std::string, Word>;

/// @param origin  names the text in errors
/// @param budget  of the net, without the text
/// @return NotANet, Unknown or WrongColour, with one sentence that names the place in the net;
/// BudgetError::Exceeded
[[nodiscard]] base::Result<Net> parseNet(std::string_view text, const std::string& origin,
                                         const ParameterValues& parameters = {},
                                         const base::Budget& budget = {});

/// A net that comes with Rivulet ("p3") or the path of a .toml file.
[[nodiscard]] base::Result<Net> loadNet(const std::string& nameOrPath,
                                        const ParameterValues& parameters = {},
                                        const base::Budget& budget = {});
[[nodiscard]] std::vector<std::string> netNames();

}  // namespace rivulet::petri
