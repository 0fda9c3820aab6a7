// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/record_file.h"

#include <utility>

namespace rivulet::cli {

base::Result<void> openRecordingFile(const std::string& path,
                                     std::unique_ptr<recorder::RecordingFile>& file,
                                     std::unique_ptr<trace::RecordingWriter>& writer) {
  auto opened = recorder::RecordingFile::open(path);
  if (!opened) {
    return base::fail(opened.error());
  }
  file = std::move(*opened);
  writer = std::make_unique<trace::RecordingWriter>(file->sink());
  return {};
}

}  // namespace rivulet::cli
