// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trust/private_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

#include "base/descriptor.h"
#include "base/file.h"
#include "base/private_file.h"

namespace rivulet::trust {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kPrivateBytesMax = std::uintmax_t{1} << 20U;

tl::unexpected<base::Error> notWritable(const fs::path& path, int errorNumber) {
  return base::fail(
      base::FileError::NotWritable,
      fmt::format("The file cannot be written: {}.", std::generic_category().message(errorNumber)),
      path.string());
}

}  // namespace

base::Result<void> writePrivateFile(const fs::path& path, std::string_view bytes) {
  const int descriptor = base::openToWrite(path, {.mustBeNew = true, .isForOwner = true});
  if (descriptor < 0) {
    return notWritable(path, errno);
  }
  int error = base::writeWhole(descriptor, bytes);
  if (error == 0) {
    error = base::syncToDisk(descriptor);
  }
  const int closing = base::closeFile(descriptor);
  error = error != 0 ? error : closing;
  return error == 0 ? base::Result<void>() : notWritable(path, error);
}

base::Result<std::string> readPrivateFile(const fs::path& path) {
  if (!base::isForOwnerAlone(path)) {
    return base::fail(base::FileError::Unreadable,
                      "Others may read this file. Allow it to its owner only (chmod 600).",
                      path.string());
  }
  return base::readFile(path, kPrivateBytesMax);
}

}  // namespace rivulet::trust
