// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/input.h"

#include <conio.h>
#include <io.h>
#include <windows.h>

#include <algorithm>

namespace rivulet::platform {

namespace {

HANDLE handleOf(int descriptor) {
  return reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
}

/// Keys, as they are pressed.
Input readKeys(std::span<char> into) {
  Input read;
  while (read.bytes < into.size() && _kbhit() != 0) {
    into[read.bytes++] = static_cast<char>(_getch());
  }
  return read;
}

}  // namespace

Input readNow(int descriptor, std::span<char> into) {
  HANDLE handle = handleOf(descriptor);
  DWORD ready = static_cast<DWORD>(into.size());
  switch (GetFileType(handle)) {
    case FILE_TYPE_CHAR:
      return readKeys(into);
    case FILE_TYPE_PIPE:
      if (PeekNamedPipe(handle, nullptr, 0, nullptr, &ready, nullptr) == 0) {
        return {0, GetLastError() == ERROR_BROKEN_PIPE, GetLastError() != ERROR_BROKEN_PIPE};
      }
      if (ready == 0) {
        return {};
      }
      break;
    case FILE_TYPE_DISK:
      break;
    default:
      return {0, false, true};
  }
  DWORD count = std::min(ready, static_cast<DWORD>(into.size()));
  if (ReadFile(handle, into.data(), count, &count, nullptr) == 0) {
    return {0, GetLastError() == ERROR_BROKEN_PIPE, GetLastError() != ERROR_BROKEN_PIPE};
  }
  return {count, count == 0, false};
}

bool isInputFed() {
  const DWORD kind = GetFileType(handleOf(kStandardInput));
  return kind == FILE_TYPE_PIPE || kind == FILE_TYPE_DISK;
}

}  // namespace rivulet::platform
