// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes are the preset of a machine: it is refused with a sentence, or it is one.

#include "fuzz/require.h"
#include "machine/config.h"

using namespace rivulet;
using tests::require;

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto preset = machine::parsePreset(tests::textOf(data, size), "fuzz.toml");
  require(preset || !preset.error().message.empty());
  if (preset) {
    require(preset->feedMmPerSMax() > 0.0);
  }
  return 0;
}
