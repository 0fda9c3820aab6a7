// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "base/descriptor.h"
#include "base/private_file.h"

namespace rivulet::base {

int openToWrite(const std::filesystem::path& path, const Opening& how) {
  constexpr mode_t kSharedMode = 0666;  // less what the user's mask takes away
  const int flags = O_WRONLY | O_CREAT | O_CLOEXEC | (how.mustBeNew ? O_EXCL : 0) |
                    (how.isEmptied ? O_TRUNC : 0) | (how.neverWaits ? O_NONBLOCK : 0);
  return open(path.c_str(), flags, how.isForOwner ? kPrivateFileMode : kSharedMode);
}

int openToRead(const std::filesystem::path& path) {
  return open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
}

std::FILE* openStream(const std::filesystem::path& path) {
  return std::fopen(path.c_str(), "rb");
}

std::FILE* openStreamToWrite(const std::filesystem::path& path) {
  return std::fopen(path.c_str(), "wb");
}

bool readFrom(std::FILE* stream, std::uint64_t at) {
  return fseeko(stream, static_cast<off_t>(at), SEEK_SET) == 0;
}

void letWait(int descriptor) {
  fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
}

int closeFile(int descriptor) {
  return close(descriptor) != 0 ? errno : 0;
}

int writeWhole(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = write(descriptor, text.data(), text.size());
    if (count < 0 && errno != EINTR) {
      return errno;
    }
    text.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  return 0;
}

int writeAt(int descriptor, std::string_view text, std::uint64_t at) {
  while (!text.empty()) {
    const ssize_t count = pwrite(descriptor, text.data(), text.size(), static_cast<off_t>(at));
    if (count < 0 && errno != EINTR) {
      return errno;
    }
    const std::size_t done = count > 0 ? static_cast<std::size_t>(count) : 0;
    text.remove_prefix(done);
    at += done;
  }
  return 0;
}

std::ptrdiff_t writeSome(int descriptor, std::string_view text) {
  return write(descriptor, text.data(), text.size());
}

std::string readAt(int descriptor, std::uint64_t at, std::size_t bytes) {
  std::string text(bytes, '\0');
  const ssize_t count = pread(descriptor, text.data(), bytes, static_cast<off_t>(at));
  text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return text;
}

std::int64_t sizeOf(int descriptor) {
  struct stat facts {};
  return fstat(descriptor, &facts) == 0 ? facts.st_size : -1;
}

bool cutTo(int descriptor, std::uint64_t bytes) {
  return ftruncate(descriptor, static_cast<off_t>(bytes)) == 0;
}

int syncToDisk(int descriptor) {
  const bool failed =
      fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP;
  return failed ? errno : 0;
}

bool hasName(int descriptor, const std::filesystem::path& path) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

}  // namespace rivulet::base
