// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes are a file that Rivulet keeps itself: a calibration, or a run that can be resumed.

#include <nlohmann/json.hpp>

#include "fuzz/require.h"
#include "report/calibration_json.h"
#include "report/run_store.h"

using namespace rivulet;
using tests::require;

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto json = nlohmann::json::parse(tests::textOf(data, size), nullptr, false);
  const auto calibration = report::calibrationOf(json, "fuzz.json");
  require(calibration || !calibration.error().message.empty());
  if (calibration) {
    require(report::calibrationOf(report::calibrationJson(*calibration), "again.json").has_value());
  }
  const auto run = report::savedRunOf(json, "fuzz.json");
  require(run || !run.error().message.empty());
  return 0;
}
