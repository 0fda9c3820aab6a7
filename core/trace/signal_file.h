// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Signals as a file, in the format that its name says: .csv a table, .h5 or .hdf5 HDF5 with the
/// events. `importTrace` reads both. @threadsafety writes a file; shares nothing.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "trace/export.h"
#include "trace/signal_set.h"

namespace rivulet::trace {

struct SignalFile {
  std::vector<ExportedSignal> exported;
  std::vector<SignalEvent> events;
  base::Instant from{};  ///< what is written, both included
  base::Instant to{};
  std::string_view timeName = "t";  ///< as `printSignals`
  std::string_view timeUnit = "s";
};

/// All that was recorded.
[[nodiscard]] SignalFile signalFileOf(const ShownTrace& shown);

[[nodiscard]] bool isSignalFile(const std::filesystem::path& path);

/// @param path  of which `isSignalFile` is true
/// @return error ImportError::NoHdf5, FileError::NotWritable
[[nodiscard]] base::Result<void> saveSignals(const std::filesystem::path& path,
                                             const SignalFile& file);

}  // namespace rivulet::trace
