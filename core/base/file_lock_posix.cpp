// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/file_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "base/file.h"

namespace rivulet::base {

namespace fs = std::filesystem;

namespace {

/// @return -1: not to be had; `errno` says why
int openLockFile(const fs::path& path) {
  constexpr mode_t kOwnerOnly = 0600;
  return open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kOwnerOnly);
}

tl::unexpected<Error> notLocked(const fs::path& path, int errorNumber) {
  return fail(FileError::NotWritable,
              fmt::format("The file cannot be locked: {}. Check the rights of its folder.",
                          std::generic_category().message(errorNumber)),
              path.string());
}

}  // namespace

Result<FileLock> FileLock::take(const fs::path& path) {
  FileLock lock(openLockFile(path));
  if (lock.m_descriptor < 0) {
    return notLocked(path, errno);
  }
  while (flock(lock.m_descriptor, LOCK_EX) != 0) {
    if (errno != EINTR) {
      return notLocked(path, errno);
    }
  }
  return lock;
}

Result<std::optional<FileLock>> FileLock::tryToTake(const fs::path& path) {
  FileLock lock(openLockFile(path));
  if (lock.m_descriptor < 0) {
    return notLocked(path, errno);
  }
  if (flock(lock.m_descriptor, LOCK_EX | LOCK_NB) == 0) {
    return std::optional(std::move(lock));
  }
  if (errno != EWOULDBLOCK) {
    return notLocked(path, errno);
  }
  return std::optional<FileLock>();
}

FileLock::~FileLock() {
  if (m_descriptor >= 0) {
    close(m_descriptor);
  }
}

FileLock::FileLock(FileLock&& other) noexcept
    : m_descriptor(std::exchange(other.m_descriptor, -1)) {
}

}  // namespace rivulet::base
