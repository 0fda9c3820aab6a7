// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/replace_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "base/descriptor.h"
#include "base/file.h"
#include "base/private_file.h"

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

/// Closes a file at the end of its scope.
class Opened {
 public:
  explicit Opened(int descriptor) : m_descriptor(descriptor) {}
  ~Opened() {
    if (m_descriptor >= 0) {
      close(m_descriptor);
    }
  }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;

  [[nodiscard]] int descriptor() const { return m_descriptor; }
  explicit operator bool() const { return m_descriptor >= 0; }

 private:
  int m_descriptor;
};

/// Whether the file is open for one program only, under this name, and was made by this user: in a
/// folder that others write, too, a file of theirs must not become ours.
bool isOursAlone(int descriptor, const fs::path& path) {
  struct stat opened {};
  struct stat named {};
  return flock(descriptor, LOCK_EX | LOCK_NB) == 0 && fstat(descriptor, &opened) == 0 &&
         lstat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev && S_ISREG(opened.st_mode) && opened.st_uid == geteuid();
}

/// Makes a temporary file. Its writer holds its lock; so one that nobody has locked was left by a
/// program that was killed, and makes room.
/// @return a descriptor, or -1 and in `errno` EEXIST: somebody else has this name
int makeTemporary(const fs::path& path, mode_t mode) {
  const auto make = [&path, mode] {
    return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  };
  int descriptor = make();
  if (descriptor < 0 && errno == EEXIST) {
    if (const Opened left(open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
        left && isOursAlone(left.descriptor(), path)) {
      unlink(path.c_str());
      descriptor = make();
    } else {
      errno = EEXIST;
    }
  }
  // Another writer may have taken it for one that was left, before it was locked.
  if (descriptor >= 0 && !isOursAlone(descriptor, path)) {
    close(descriptor);
    errno = EEXIST;
    return -1;
  }
  return descriptor;
}

/// Writes everything and makes sure that it is on the disk. @return 0 or the system's error number
int writeAll(int descriptor, std::string_view text) {
  const int error = writeWhole(descriptor, text);
  return error != 0 ? error : syncToDisk(descriptor);
}

/// The new name survives a loss of power only if its folder is on the disk, too. File systems that
/// cannot do this are not at fault.
void syncFolder(const fs::path& folder) {
  const Opened opened(
      open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened) {
    fsync(opened.descriptor());
  }
}

}  // namespace

/// A private file has mode 0600, another one that of the file before, or what the user's mask
/// leaves of 0666.
Result<void> replaceFile(const fs::path& requested, std::string_view text, bool isPrivate) {
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
    const Opened file(open(path.c_str(), O_WRONLY | O_CLOEXEC));
    const int error = file ? writeAll(file.descriptor(), text) : errno;
    return error == 0 ? Result<void>{} : notWritable(requested, reasonOf(error));
  }

  constexpr int kNamesMax = 100;
  constexpr mode_t kSharedMode = 0666;
  int error = EEXIST;
  for (int i = 0; i < kNamesMax && error == EEXIST; ++i) {
    const fs::path temporary =
        path.parent_path() / fmt::format(".{}.rivulet{}", path.filename().string(), i);
    const Opened file(makeTemporary(temporary, isPrivate ? kPrivateFileMode : kSharedMode));
    if (!file) {
      error = errno;
      continue;
    }
    if (fs::exists(kind) && !isPrivate) {
      fs::permissions(temporary, kind.permissions(), status);  // a refusal is not an error
    }
    error = writeAll(file.descriptor(), text);
    if (error == 0) {
      fs::rename(temporary, path, status);
      error = status.value();
    }
    if (error == 0) {
      syncFolder(path.parent_path());
      return {};
    }
    fs::remove(temporary, status);
    break;
  }
  return notWritable(requested, reasonOf(error));
}

Result<void> makePrivateFolder(const fs::path& folder) {
  constexpr mode_t kMode = S_IRWXU;
  fs::path made;
  for (const fs::path& part : folder) {
    made /= part;
    if (mkdir(made.empty() ? "." : made.c_str(), kMode) != 0 && errno != EEXIST) {
      std::error_code status;
      const int why = errno;
      if (!fs::is_directory(made, status)) {
        return notWritable(folder, reasonOf(why));
      }
    }
  }
  if (chmod(folder.c_str(), kMode) != 0) {
    return notWritable(folder, reasonOf(errno));
  }
  return {};
}

bool isForOwnerAlone(const fs::path& path) {
  struct stat facts {};
  return stat(path.c_str(), &facts) != 0 || (facts.st_mode & (S_IRWXG | S_IRWXO)) == 0;
}

}  // namespace rivulet::base
