// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fcntl.h>
#include <io.h>

#include <algorithm>
#include <cerrno>

#include "base/descriptor.h"
#include "base/system_handle_windows.h"

namespace rivulet::base {

namespace {

/// Of one call of the system.
constexpr std::size_t kBytesMost = std::size_t{1} << 30;

OVERLAPPED placeAt(std::uint64_t at) {
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(at & 0xFFFF'FFFFU);
  place.OffsetHigh = static_cast<DWORD>(at >> 32U);
  return place;
}

/// @param place  null: where the file stands, or a pipe
int writeText(int descriptor, std::string_view text, const std::uint64_t* place) {
  std::uint64_t at = place != nullptr ? *place : 0;
  while (!text.empty()) {
    DWORD done = 0;
    OVERLAPPED there = placeAt(at);
    const auto count = static_cast<DWORD>(std::min(text.size(), kBytesMost));
    if (WriteFile(handleOf(descriptor), text.data(), count, &done,
                  place != nullptr ? &there : nullptr) == 0) {
      return errorNumber();
    }
    text.remove_prefix(done);
    at += done;
  }
  return 0;
}

}  // namespace

int errorNumber() {
  switch (GetLastError()) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_BAD_NETPATH:
    case ERROR_BAD_NET_NAME:
      return ENOENT;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
      return EACCES;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
      return EEXIST;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      return ENOSPC;
    case ERROR_BROKEN_PIPE:
    case ERROR_NO_DATA:
      return EPIPE;
    case ERROR_INVALID_HANDLE:
      return EBADF;
    case ERROR_INVALID_NAME:
    case ERROR_BAD_PATHNAME:
      return EINVAL;
    case ERROR_FILENAME_EXCED_RANGE:
      return ENAMETOOLONG;
    case ERROR_DIRECTORY:
      return ENOTDIR;
    case ERROR_TOO_MANY_OPEN_FILES:
      return EMFILE;
    case ERROR_WRITE_PROTECT:
      return EROFS;
    default:
      return EIO;
  }
}

int openHandle(const std::filesystem::path& path, DWORD access, DWORD disposition, bool isAlone) {
  const DWORD sharing = isAlone ? 0 : FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  HANDLE handle = CreateFileW(path.c_str(), access, sharing, nullptr, disposition,
                              FILE_ATTRIBUTE_NORMAL, nullptr);
  if (handle == INVALID_HANDLE_VALUE) {
    errno = errorNumber();
    return -1;
  }
  const bool isWritten = (access & GENERIC_WRITE) != 0;
  const int descriptor = _open_osfhandle(reinterpret_cast<intptr_t>(handle),
                                         _O_BINARY | (isWritten ? _O_RDWR : _O_RDONLY));
  if (descriptor < 0) {
    CloseHandle(handle);
  }
  return descriptor;
}

/// The rights of a file that is made are those of its folder: below a user's profile, nobody else
/// has any.
int openToWrite(const std::filesystem::path& path, const Opening& how) {
  const DWORD disposition = how.mustBeNew   ? CREATE_NEW
                            : how.isEmptied ? CREATE_ALWAYS
                                            : OPEN_ALWAYS;
  return openHandle(path, GENERIC_WRITE, disposition);
}

int openToRead(const std::filesystem::path& path) {
  return openHandle(path, GENERIC_READ, OPEN_EXISTING);
}

std::FILE* openStream(const std::filesystem::path& path) {
  const int descriptor = openToRead(path);
  return descriptor < 0 ? nullptr : _fdopen(descriptor, "rb");
}

std::FILE* openStreamToWrite(const std::filesystem::path& path) {
  const int descriptor = openToWrite(path, {.isEmptied = true});
  return descriptor < 0 ? nullptr : _fdopen(descriptor, "wb");
}

bool readFrom(std::FILE* stream, std::uint64_t at) {
  return _fseeki64(stream, static_cast<std::int64_t>(at), SEEK_SET) == 0;
}

void letWait(int /*descriptor*/) {
}

int closeFile(int descriptor) {
  return _close(descriptor) != 0 ? errno : 0;
}

int writeWhole(int descriptor, std::string_view text) {
  return writeText(descriptor, text, nullptr);
}

int writeAt(int descriptor, std::string_view text, std::uint64_t at) {
  return writeText(descriptor, text, &at);
}

std::ptrdiff_t writeSome(int descriptor, std::string_view text) {
  DWORD done = 0;
  const auto count = static_cast<DWORD>(std::min(text.size(), kBytesMost));
  return WriteFile(handleOf(descriptor), text.data(), count, &done, nullptr) != 0
             ? static_cast<std::ptrdiff_t>(done)
             : -1;
}

std::string readAt(int descriptor, std::uint64_t at, std::size_t bytes) {
  std::string text(bytes, '\0');
  DWORD done = 0;
  OVERLAPPED there = placeAt(at);
  const auto count = static_cast<DWORD>(std::min(bytes, kBytesMost));
  if (ReadFile(handleOf(descriptor), text.data(), count, &done, &there) == 0) {
    done = 0;
  }
  text.resize(done);
  return text;
}

std::int64_t sizeOf(int descriptor) {
  LARGE_INTEGER size{};
  if (GetFileSizeEx(handleOf(descriptor), &size) == 0) {
    errno = errorNumber();
    return -1;
  }
  return size.QuadPart;
}

bool cutTo(int descriptor, std::uint64_t bytes) {
  return _chsize_s(descriptor, static_cast<std::int64_t>(bytes)) == 0;
}

int syncToDisk(int descriptor) {
  HANDLE handle = handleOf(descriptor);
  return GetFileType(handle) != FILE_TYPE_DISK || FlushFileBuffers(handle) != 0 ? 0 : errorNumber();
}

bool hasName(int descriptor, const std::filesystem::path& path) {
  const int named = openHandle(path, FILE_READ_ATTRIBUTES, OPEN_EXISTING);
  if (named < 0) {
    return false;
  }
  BY_HANDLE_FILE_INFORMATION one{};
  BY_HANDLE_FILE_INFORMATION other{};
  const bool areKnown = GetFileInformationByHandle(handleOf(descriptor), &one) != 0 &&
                        GetFileInformationByHandle(handleOf(named), &other) != 0;
  closeFile(named);
  return areKnown && one.dwVolumeSerialNumber == other.dwVolumeSerialNumber &&
         one.nFileIndexHigh == other.nFileIndexHigh && one.nFileIndexLow == other.nFileIndexLow;
}

}  // namespace rivulet::base
