// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Opens a recording of any length at once: its ends and its index are read, and then the times
/// that are asked for. `parseRecording` reads a recording as a whole. @threadsafety one thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/budget.h"
#include "base/byte_source.h"
#include "base/result.h"
#include "trace/recording.h"
#include "trace/recording_index.h"

namespace rivulet::trace {

class RecordingReader {
 public:
  /// A recording without its index (cut off, or of an earlier version) is read once as a whole.
  /// @param bytes  not null
  /// @param budget  of each call
  /// @return errors of `parseRecording`, and of the source
  [[nodiscard]] static base::Result<RecordingReader> open(std::unique_ptr<base::ByteSource> bytes,
                                                          const base::Budget& budget = {});

  [[nodiscard]] const RunStart& start() const { return m_start; }
  /// Nothing: the recording was cut off.
  [[nodiscard]] const std::optional<RunEnd>& end() const { return m_end; }
  /// Extremes and counts of each part of the file: what an overview shows.
  [[nodiscard]] const RecordingIndex& index() const { return m_index; }
  /// The index was found. False: it was made when the file was opened.
  [[nodiscard]] bool hadIndex() const { return m_hadIndex; }

  /// Samples, accesses, pauses, notes and the control's samples, blocks and events that begin in
  /// this time, with start and end of the run, without its points. Groups of frames that hold
  /// nothing of it are not read.
  /// @param until  >= `from`
  [[nodiscard]] base::Result<Recording> read(base::Instant from, base::Instant until);

 private:
  explicit RecordingReader(const base::Budget& budget) : m_budget(budget) {}
  [[nodiscard]] base::Result<void> readIndex();
  [[nodiscard]] base::Result<void> makeIndex();
  /// The text of a part of the file. @param held  bytes of the parts before
  [[nodiscard]] base::Result<std::string> textAt(std::uint64_t at, std::uint64_t bytes,
                                                 std::uint64_t held);

  base::Budget m_budget;
  std::unique_ptr<base::ByteSource> m_bytes;
  RunStart m_start;
  std::optional<RunEnd> m_end;
  RecordingIndex m_index;
  bool m_hadIndex = false;
};

}  // namespace rivulet::trace
