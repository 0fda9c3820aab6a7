// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The test of method credit as JSON (docs/cli.md names every field). @threadsafety pure.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "streaming/control/machine_facts.h"

namespace rivulet::report {

[[nodiscard]] nlohmann::ordered_json creditTestJson(const streaming::CreditTest& test);
/// Inverse of `creditTestJson`. A value of another type counts as missing: a test that says so
/// little has not been passed.
[[nodiscard]] streaming::CreditTest creditTestOf(const nlohmann::ordered_json& json);

}  // namespace rivulet::report
