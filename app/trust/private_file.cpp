// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trust/private_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "base/descriptor.h"
#include "base/file.h"

namespace rivulet::trust {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kPrivateBytesMax = std::uintmax_t{1} << 20U;
constexpr mode_t kOwnerOnly = S_IRUSR | S_IWUSR;

tl::unexpected<base::Error> notWritable(const fs::path& path, int errorNumber) {
  return base::fail(
      base::FileError::NotWritable,
      fmt::format("The file cannot be written: {}.", std::generic_category().message(errorNumber)),
      path.string());
}

}  // namespace

base::Result<void> writePrivateFile(const fs::path& path, std::string_view bytes) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kOwnerOnly);
  if (descriptor < 0) {
    return notWritable(path, errno);
  }
  int error = base::writeWhole(descriptor, bytes);
  if (error == 0) {
    error = base::syncToDisk(descriptor);
  }
  if (close(descriptor) != 0 && error == 0) {
    error = errno;
  }
  return error == 0 ? base::Result<void>() : notWritable(path, error);
}

base::Result<std::string> readPrivateFile(const fs::path& path) {
  struct stat facts {};
  if (stat(path.c_str(), &facts) == 0 && (facts.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    return base::fail(base::FileError::Unreadable,
                      "Others may read this file. Allow it to its owner only (chmod 600).",
                      path.string());
  }
  return base::readFile(path, kPrivateBytesMax);
}

}  // namespace rivulet::trust
