// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/file_lock.h"

#include <fmt/format.h>

#include <cerrno>
#include <utility>

#include "base/descriptor.h"
#include "base/file.h"
#include "base/system_handle_windows.h"

namespace rivulet::base {

namespace fs = std::filesystem;

namespace {

int openLockFile(const fs::path& path) {
  return openHandle(path, GENERIC_READ | GENERIC_WRITE, OPEN_ALWAYS);
}

/// Nobody else may read or write what is locked: so it is a byte far behind the end of the file.
bool lockHandle(int descriptor, DWORD flags) {
  OVERLAPPED place{};
  place.OffsetHigh = 0x7FFF'FFFF;
  return LockFileEx(handleOf(descriptor), LOCKFILE_EXCLUSIVE_LOCK | flags, 0, 1, 0, &place) != 0;
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
  if (!lockHandle(lock.m_descriptor, 0)) {
    return notLocked(path, errorNumber());
  }
  return lock;
}

Result<std::optional<FileLock>> FileLock::tryToTake(const fs::path& path) {
  FileLock lock(openLockFile(path));
  if (lock.m_descriptor < 0) {
    return notLocked(path, errno);
  }
  if (lockHandle(lock.m_descriptor, LOCKFILE_FAIL_IMMEDIATELY)) {
    return std::optional(std::move(lock));
  }
  const DWORD why = GetLastError();
  if (why != ERROR_LOCK_VIOLATION && why != ERROR_IO_PENDING) {
    return notLocked(path, errorNumber());
  }
  return std::optional<FileLock>();
}

FileLock::~FileLock() {
  if (m_descriptor >= 0) {
    closeFile(m_descriptor);
  }
}

FileLock::FileLock(FileLock&& other) noexcept
    : m_descriptor(std::exchange(other.m_descriptor, -1)) {
}

}  // namespace rivulet::base
