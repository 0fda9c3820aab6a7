// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Between the handles of Windows and the descriptors of its C library. @threadsafety shares
/// nothing.
#pragma once

#include <io.h>
#include <windows.h>

#include <filesystem>

namespace rivulet::base {

[[nodiscard]] inline HANDLE handleOf(int descriptor) {
  return reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
}

/// The number in `errno` for the last error of this thread.
[[nodiscard]] int errorNumber();

/// As CreateFileW; bytes are read and written as they are. Who else opens the file may read, write,
/// rename and delete it, unless the file is taken alone.
/// @return a descriptor; -1: `errno` says why
[[nodiscard]] int openHandle(const std::filesystem::path& path, DWORD access, DWORD disposition,
                             bool isAlone = false);

}  // namespace rivulet::base
