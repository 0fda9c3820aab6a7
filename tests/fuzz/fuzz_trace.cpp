// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes are a recording or the trace of another tool: as much as possible is read, and what was
// read of a recording can be written and read again.

#include "fuzz/require.h"
#include "trace/import/compression.h"
#include "trace/import/import.h"
#include "trace/recording.h"

using namespace rivulet;
using tests::require;

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = tests::textOf(data, size);
  const auto recording = trace::parseRecording(bytes);
  require(recording || !recording.error().message.empty());
  if (recording) {
    require(trace::parseRecording(trace::printRecording(*recording)).has_value());
  }
  if (trace::isCompressed(bytes)) {
    return 0;  // the trace of another tool may unpack to what no fuzzer has memory for
  }
  const auto imported = trace::importTrace(bytes);
  require(imported || !imported.error().message.empty());
  return 0;
}
