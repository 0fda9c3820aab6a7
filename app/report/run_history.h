// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The runs that have ended on this computer, of window and command line alike: per run a report
/// and a line of the index, and the recording if it was made for the history (docs/formats.md). The
/// oldest are removed beyond a number and a size. Several programs may write at once: no file is
/// shared by two runs.
/// @threadsafety reads and writes files; shares nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "report/report_reader.h"

namespace rivulet::report {

struct HistoryLimits {
  std::size_t runsMax = 1000;                                        ///< >= 1
  std::uintmax_t bytesMax = std::uintmax_t{4} * 1024 * 1024 * 1024;  ///< with the recordings

  friend bool operator==(const HistoryLimits&, const HistoryLimits&) = default;
};

/// A run of the history that cannot be shown, and why.
struct UnreadableRun {
  std::filesystem::path file;
  base::Error error;
};

struct HistoryList {
  std::vector<streaming::RunSummary> runs;  ///< the newest first
  std::vector<UnreadableRun> unreadable;
};

/// One line per run, for a spreadsheet: numbers with a decimal point, times in UTC.
[[nodiscard]] std::string runsCsv(const std::vector<streaming::RunSummary>& runs);

class RunHistory {
 public:
  /// Points of the sketch that is kept of a path.
  static constexpr std::size_t kSketchPointsMax = 4000;

  /// Below $XDG_STATE_HOME, or ~/.local/state.
  [[nodiscard]] static std::filesystem::path folderOfUser();

  explicit RunHistory(std::filesystem::path folder = folderOfUser())
      : m_folder(std::move(folder)) {}

  [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }
  /// A file for the recording of a run that begins now. Makes its folder.
  /// @return NotWritable
  [[nodiscard]] base::Result<std::filesystem::path> newRecording(
      const std::string& programName, const std::string& startedAtUtc) const;

  /// Keeps a run and removes the oldest beyond the limits, but never the one added.
  /// @param known  the part of the summary that is not in the report; an `id` is given to it
  /// @param points  the path, for the sketch
  /// @return the run as it is kept; NotWritable
  base::Result<streaming::RunSummary> add(const streaming::RunReport& report,
                                          streaming::RunSummary known,
                                          std::span<const gcode::StreamPoint> points) const;

  [[nodiscard]] HistoryList list() const;
  [[nodiscard]] std::filesystem::path reportFile(const std::string& id) const;
  /// Removes the report and, if it was made for the history, the recording.
  void remove(const streaming::RunSummary& run) const;

  /// The default if none are set.
  [[nodiscard]] HistoryLimits limits() const;
  /// Removes at once what is beyond them. @return NotWritable
  [[nodiscard]] base::Result<void> setLimits(const HistoryLimits& limits) const;

 private:
  [[nodiscard]] std::filesystem::path indexFile(const std::string& id) const;
  /// @param keep  id of a run that stays; may be empty
  void prune(const std::string& keep) const;

  std::filesystem::path m_folder;
};

}  // namespace rivulet::report
