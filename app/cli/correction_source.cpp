// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/correction_source.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <utility>

#include "base/descriptor.h"
#include "base/file.h"
#include "platform/input.h"
#include "platform/log.h"

namespace rivulet::cli {

namespace {

/// A source with a lot of data must not hold up the stream: the rest is read the next time.
constexpr int kReadsMax = 16;

}  // namespace

base::Result<CorrectionSource> CorrectionSource::open(const std::string& path) {
  if (path == "-") {
    return CorrectionSource("standard input", platform::kStandardInput, false);
  }
  const int descriptor = base::openToRead(path);
  if (descriptor < 0) {
    return base::fail(base::FileError::Unreadable,
                      "The source of corrections cannot be opened. Check the path and its "
                      "permissions.",
                      path);
  }
  return CorrectionSource(path, descriptor, true);
}

CorrectionSource::CorrectionSource(CorrectionSource&& other) noexcept
    : m_name(std::move(other.m_name)),
      m_descriptor(std::exchange(other.m_descriptor, -1)),
      m_isOwn(other.m_isOwn),
      m_hasTold(other.m_hasTold),
      m_lines(std::move(other.m_lines)) {
}

CorrectionSource::~CorrectionSource() {
  if (m_isOwn && m_descriptor >= 0) {
    base::closeFile(m_descriptor);
  }
}

base::Vec3 CorrectionSource::valueMm() {
  std::array<char, 4096> bytes;
  for (int i = 0; i < kReadsMax; ++i) {
    const platform::Input read = platform::readNow(m_descriptor, bytes);
    if (read.bytes == 0) {
      break;  // nothing now; a file or a pipe may have more later
    }
    m_lines.add({bytes.data(), read.bytes});
  }
  if (!m_hasTold && m_lines.firstUnknown() > 0) {
    m_hasTold = true;
    log::logger().warn(
        "{}: line {} is not a correction (X 0.01 Y -0.02, or the same as JSON). It is ignored, and "
        "so are all others like it.",
        m_name, m_lines.firstUnknown());
  }
  return m_lines.valueMm();
}

}  // namespace rivulet::cli
