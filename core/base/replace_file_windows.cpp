// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/replace_file.h"

#include <fmt/format.h>

#include <cerrno>

#include "base/descriptor.h"
#include "base/file.h"
#include "base/private_file.h"
#include "base/system_handle_windows.h"

namespace rivulet::base {
namespace fs = std::filesystem;
namespace {

std::string reasonOf(int errorNumber) {
  return std::generic_category().message(errorNumber);
}

tl::unexpected<Error> notWritable(const fs::path& path, std::string_view why) {
  return fail(FileError::NotWritable, fmt::format("The file cannot be written: {}.", why),
              path.string());
}

/// Makes a temporary file, which its writer has alone. So one that can be deleted was left by a
/// program that was killed, and makes room.
/// @return a descriptor, or -1 and in `errno` EEXIST: somebody else has this name
int makeTemporary(const fs::path& path) {
  const auto make = [&path] { return openHandle(path, GENERIC_WRITE, CREATE_NEW, true); };
  int descriptor = make();
  if (descriptor < 0 && (errno == EEXIST || errno == EACCES)) {
    descriptor = DeleteFileW(path.c_str()) != 0 ? make() : -1;
    errno = EEXIST;
  }
  return descriptor;
}

/// Writes everything and makes sure that it is on the disk. @return 0 or the system's error number
int writeAndClose(int descriptor, std::string_view text) {
  int error = writeWhole(descriptor, text);
  error = error != 0 ? error : syncToDisk(descriptor);
  const int closing = closeFile(descriptor);
  return error != 0 ? error : closing;
}

}  // namespace

/// Its rights are those of its folder: below a user's profile, nobody else has any.
Result<void> replaceFile(const fs::path& requested, std::string_view text, bool /*isPrivate*/) {
  std::error_code status;
  // The name may be a link: its target is replaced, the link stays.
  fs::path path =
      fs::is_symlink(requested, status) ? fs::weakly_canonical(requested, status) : requested;
  if (status || path.empty()) {
    path = requested;
  }
  const fs::file_status kind = fs::status(path, status);
  if (fs::is_directory(kind)) {
    return notWritable(requested, "it is a folder");
  }
  if (fs::exists(kind) && !fs::is_regular_file(kind)) {
    const int device = openHandle(path, GENERIC_WRITE, OPEN_EXISTING);
    const int error = device < 0 ? errno : writeAndClose(device, text);
    return error == 0 ? Result<void>{} : notWritable(requested, reasonOf(error));
  }
  constexpr int kNamesMax = 100;
  int error = EEXIST;
  for (int i = 0; i < kNamesMax && error == EEXIST; ++i) {
    const fs::path temporary =
        path.parent_path() / fmt::format(".{}.rivulet{}", path.filename().string(), i);
    const int file = makeTemporary(temporary);
    if (file < 0) {
      error = errno;
      continue;
    }
    error = writeAndClose(file, text);
    if (error == 0 && MoveFileExW(temporary.c_str(), path.c_str(),
                                  MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) == 0) {
      error = errorNumber();
    }
    if (error == 0) {
      return {};
    }
    DeleteFileW(temporary.c_str());
    break;
  }
  return notWritable(requested, reasonOf(error));
}

Result<void> makePrivateFolder(const fs::path& folder) {
  std::error_code status;
  fs::create_directories(folder, status);
  if (!fs::is_directory(folder, status)) {
    return notWritable(folder, reasonOf(EACCES));
  }
  return {};
}

bool isForOwnerAlone(const fs::path& /*path*/) {
  return true;
}

}  // namespace rivulet::base
