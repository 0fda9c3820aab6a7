// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/file.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#if defined(__unix__)
#include <fcntl.h>
#include <unistd.h>

#include "base/descriptor.h"
#endif

namespace rivulet::base {
namespace fs = std::filesystem;
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string reason(int errorNumber) {
  return std::generic_category().message(errorNumber);
}

tl::unexpected<Error> unreadable(const fs::path& path, std::string_view why) {
  return fail(FileError::Unreadable, fmt::format("The file cannot be read: {}.", why),
              path.string());
}

tl::unexpected<Error> tooLarge(const fs::path& path, std::uintmax_t bytesMax) {
  return unreadable(path, fmt::format("it is larger than {} MiB", bytesMax >> 20));
}

tl::unexpected<Error> notWritable(const fs::path& path, std::string_view why) {
  return fail(FileError::NotWritable, fmt::format("The file cannot be written: {}.", why),
              path.string());
}

/// Writes everything and makes sure that it is on the disk. @return 0 or the system's error number
int writeAll(File file, std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
      std::fflush(file.get()) != 0) {
    return errno != 0 ? errno : EIO;
  }
#if defined(__unix__)
  // The new name must not become visible before the content is on the disk.
  if (const int error = syncToDisk(fileno(file.get())); error != 0) {
    return error;
  }
#endif
  // Some file systems report a full disk only here.
  return std::fclose(file.release()) == 0 ? 0 : (errno != 0 ? errno : EIO);
}

/// The new name survives a loss of power only if its folder is on the disk, too. File systems that
/// cannot do this are not at fault.
void syncFolder([[maybe_unused]] const fs::path& folder) {
#if defined(__unix__)
  const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (descriptor >= 0) {
    fsync(descriptor);
    close(descriptor);
  }
#endif
}

}  // namespace

std::error_code make_error_code(FileError code) {
  static const NamedCategory category("file");
  return {static_cast<int>(code), category};
}

Result<std::string> readFile(const fs::path& path, std::uintmax_t bytesMax) {
  std::error_code status;
  if (fs::is_directory(path, status)) {
    return unreadable(path, "it is a folder");
  }
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) {
    return unreadable(path, reason(errno));
  }
  std::string text;
  const std::uintmax_t size = fs::file_size(path, status);
  if (!status && size > bytesMax) {
    return tooLarge(path, bytesMax);
  }
  if (!status) {
    text.reserve(static_cast<std::size_t>(size));
  }
  std::array<char, 65536> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
    text.append(buffer.data(), count);
    if (text.size() > bytesMax) {
      return tooLarge(path, bytesMax);
    }
  }
  if (std::ferror(file.get()) != 0) {
    return unreadable(path, reason(errno));
  }
  return text;
}

Result<void> writeFile(const fs::path& requested, std::string_view text) {
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
    File file(std::fopen(path.c_str(), "wb"));
    const int error = file ? writeAll(std::move(file), text) : errno;
    return error == 0 ? Result<void>{} : notWritable(requested, reason(error));
  }

  // "x": an existing file belongs to another writer or is a left-over, and is not changed.
  constexpr int kNamesMax = 100;
  fs::path temporary;
  File file;
  int error = EEXIST;
  for (int i = 0; i < kNamesMax && !file && error == EEXIST; ++i) {
    temporary = path;
    temporary += fmt::format(".part{}", i);
    file.reset(std::fopen(temporary.c_str(), "wbx"));
    error = file ? 0 : errno;
  }
  if (file) {
    error = writeAll(std::move(file), text);
    if (error == 0) {
      if (fs::exists(kind)) {
        fs::permissions(temporary, kind.permissions(), status);  // a refusal is not an error
      }
      fs::rename(temporary, path, status);
      if (!status) {
        syncFolder(path.parent_path());
        return {};
      }
      error = status.value();
    }
    fs::remove(temporary, status);
  }
  return notWritable(requested, reason(error));
}

}  // namespace rivulet::base
