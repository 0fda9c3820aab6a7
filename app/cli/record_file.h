// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The recording of a run, as `--record` asks for it. @threadsafety one object, one thread.
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "platform/recording_file.h"
#include "trace/recording.h"

namespace rivulet::cli {

/// @param file, writer  set if the file could be opened  @return why it could not
[[nodiscard]] base::Result<void> openRecordingFile(const std::string& path,
                                                   std::unique_ptr<recorder::RecordingFile>& file,
                                                   std::unique_ptr<trace::RecordingWriter>& writer);

}  // namespace rivulet::cli
