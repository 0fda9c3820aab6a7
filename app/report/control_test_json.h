// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The tests of a control, of method credit and of the feed cell, as JSON (docs/cli.md names every
/// field). @threadsafety pure.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "streaming/control/machine_facts.h"

namespace rivulet::report {

[[nodiscard]] nlohmann::ordered_json testJson(const streaming::CreditTest& test);
[[nodiscard]] nlohmann::ordered_json testJson(const streaming::FeedTest& test);
[[nodiscard]] nlohmann::ordered_json testJson(const streaming::JobTest& test);
/// Inverse of `testJson`. A value of another type counts as missing: a test that says so little has
/// not been passed.
[[nodiscard]] streaming::CreditTest creditTestOf(const nlohmann::ordered_json& json);
[[nodiscard]] streaming::FeedTest feedTestOf(const nlohmann::ordered_json& json);
[[nodiscard]] streaming::JobTest jobTestOf(const nlohmann::ordered_json& json);

}  // namespace rivulet::report
