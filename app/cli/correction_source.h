// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A live source of corrections: a file that grows, a pipe, or standard input. Asking never waits.
/// @threadsafety one object, one thread.
#pragma once

#include <string>

#include "base/result.h"
#include "streaming/run/correction_lines.h"

namespace rivulet::cli {

class CorrectionSource {
 public:
  /// @param path  file or pipe; "-": standard input @return FileUnreadable
  [[nodiscard]] static base::Result<CorrectionSource> open(const std::string& path);
  CorrectionSource(CorrectionSource&& other) noexcept;
  CorrectionSource& operator=(CorrectionSource&&) = delete;
  ~CorrectionSource();

  /// Reads what is available. The first line that is not a correction is reported on standard
  /// error. The last value stays.
  [[nodiscard]] base::Vec3 valueMm();

 private:
  CorrectionSource(std::string name, int descriptor, bool isOwn)
      : m_name(std::move(name)), m_descriptor(descriptor), m_isOwn(isOwn) {}

  std::string m_name;
  int m_descriptor;
  bool m_isOwn;
  bool m_hasTold = false;
  streaming::CorrectionLines m_lines;
};

}  // namespace rivulet::cli
