// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Writes a recording to its file on a thread of its own, compressed in frames (`trace/frames`), so
/// that a disk or a pipe that hangs never holds up the stream. If this program is killed, what came
/// in the last half second is lost. What waits to be written is bounded: a recording that falls
/// behind is cut off at a whole line.
/// @threadsafety all functions: one thread, which is that of the run.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

#include "base/result.h"
#include "trace/recording.h"

namespace rivulet::recorder {

struct RecordingLimits {
  std::size_t queueBytesMax = std::size_t{64} << 20U;
  /// How long a file may accept nothing while somebody waits for it.
  std::chrono::milliseconds patience = std::chrono::seconds{5};
};

class RecordingFile {
 public:
  /// Replaces the file. A pipe must have a reader. @return NotWritable
  [[nodiscard]] static base::Result<std::unique_ptr<RecordingFile>> open(
      const std::filesystem::path& path, const RecordingLimits& limits = {});
  /// As `finish`.
  ~RecordingFile();
  RecordingFile(const RecordingFile&) = delete;
  RecordingFile& operator=(const RecordingFile&) = delete;

  /// Takes whole lines. The records of a stream, which are short, never wait. The lists before and
  /// after it come in large pieces: these wait for room as long as the file accepts anything.
  /// @return false if there is no room, or if the file cannot be written
  bool append(std::string_view lines);
  /// For a `RecordingWriter` that does not outlive this.
  [[nodiscard]] trace::RecordingSink sink();

  /// From the first record on the disk to the last one.
  [[nodiscard]] base::Duration recorded() const;
  /// Until now. @return NotWritable: nothing more is taken, and why
  [[nodiscard]] base::Result<void> soFar() const;

  /// Waits until everything is on the disk, or until the file has accepted nothing for the time of
  /// the limits; then the thread is left alone with what hangs. Later calls return the same.
  /// @return NotWritable: the recording is incomplete, and why
  [[nodiscard]] base::Result<void> finish();

 private:
  struct State;
  RecordingFile(std::shared_ptr<State> state, std::filesystem::path path)
      : m_state(std::move(state)), m_path(std::move(path)) {}
  [[nodiscard]] base::Result<void> result() const;

  std::shared_ptr<State> m_state;  ///< shared with the thread, which may outlive this
  std::filesystem::path m_path;
};

}  // namespace rivulet::recorder
