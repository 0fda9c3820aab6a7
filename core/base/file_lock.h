// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A lock that programs share through a file: window, command line and service of one user keep
/// what they know in the same files. It ends with the object, and with the program, however that
/// ends.
/// @threadsafety owns a file descriptor; shares nothing. Two objects of one program exclude each
/// other as two programs do.
#pragma once

#include <filesystem>
#include <optional>

#include "base/result.h"

namespace rivulet::base {

class FileLock {
 public:
  /// Waits until nobody else holds it: for the moment in which a file is read, changed and written
  /// again. The file of the lock is made if it is missing, its folder is not. It stays: who removed
  /// it would take it from under those that wait.
  /// @return error NotWritable: it cannot be made
  [[nodiscard]] static Result<FileLock> take(const std::filesystem::path& path);
  /// Does not wait. @return nothing: somebody else holds it; error as `take`
  [[nodiscard]] static Result<std::optional<FileLock>> tryToTake(const std::filesystem::path& path);

  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// Of the file of the lock, open for reading and writing. It stays this object's.
  [[nodiscard]] int descriptor() const { return m_descriptor; }

 private:
  explicit FileLock(int descriptor) : m_descriptor(descriptor) {}

  int m_descriptor;
};

}  // namespace rivulet::base
