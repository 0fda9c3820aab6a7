// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How far a run is, as lines of JSON for the program that has started it (docs/python.md). A
/// reader that is slow, or gone, never holds up the run: what has no room is left out.
/// @threadsafety one object, the thread of the run.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "streaming/run/margins.h"
#include "streaming/run/run.h"

namespace rivulet::cli {

/// Of the lines and their members. A member that is added does not change it.
inline constexpr int kProgressVersion = 1;

class ProgressLines {
 public:
  /// @param path  file, or a pipe that somebody reads @return FileError::NotWritable
  [[nodiscard]] static base::Result<ProgressLines> open(const std::string& path);
  ProgressLines(ProgressLines&& other) noexcept;
  ProgressLines& operator=(ProgressLines&&) = delete;
  ~ProgressLines();

  /// Writes a line when something has changed: a new state or order at once, anything else twenty
  /// times a second.
  void tell(const streaming::LiveUpdate& update);

 private:
  explicit ProgressLines(int descriptor) : m_descriptor(descriptor) {}
  void write(const std::string& line) const;

  int m_descriptor;
  std::optional<base::Instant> m_toldAt;
  std::string m_toldOrder;  ///< state and order of the last line
  std::optional<base::Vec3> m_positionMm;
  streaming::Margins m_margins;
};

}  // namespace rivulet::cli
