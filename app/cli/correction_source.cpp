// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/correction_source.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <utility>

#include "base/file.h"
#include "platform/log.h"

namespace rivulet::cli {

namespace {

/// A source with a lot of data must not hold up the stream: the rest is read the next time.
constexpr int kReadsMax = 16;

}  // namespace

base::Result<CorrectionSource> CorrectionSource::open(const std::string& path) {
  if (path == "-") {
    return CorrectionSource("standard input", STDIN_FILENO, false);
  }
  // A pipe without a writer is opened at once.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
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
    ::close(m_descriptor);
  }
}

base::Vec3 CorrectionSource::valueMm() {
  std::array<char, 4096> bytes;
  for (int i = 0; i < kReadsMax; ++i) {
    // Standard input may be shared with other programs: it is polled, not switched to non-blocking
    // mode.
    pollfd asked{m_descriptor, POLLIN, 0};
    if (::poll(&asked, 1, 0) <= 0 || (asked.revents & (POLLIN | POLLHUP)) == 0) {
      break;
    }
    const ssize_t count = ::read(m_descriptor, bytes.data(), bytes.size());
    if (count <= 0) {
      break;  // nothing now; a file or a pipe may have more later
    }
    m_lines.add({bytes.data(), static_cast<std::size_t>(count)});
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
