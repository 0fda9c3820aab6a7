// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "journal/line_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/descriptor.h"
#include "base/file.h"
#include "base/private_file.h"
#include "platform/user_folders.h"

namespace rivulet::journal {

namespace fs = std::filesystem;

namespace {

tl::unexpected<base::Error> notWritable(const fs::path& path, int error) {
  return base::fail(
      base::FileError::NotWritable,
      fmt::format("The file cannot be written: {}.", std::generic_category().message(error)),
      path.string());
}

class Descriptor {
 public:
  explicit Descriptor(int number) : m_number(number) {}
  ~Descriptor() {
    if (m_number >= 0) {
      close(m_number);  // releases the lock, too
    }
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return m_number; }

 private:
  int m_number;
};

/// The end of a file: the last complete line, and whether something incomplete follows it.
struct Tail {
  std::string last;
  bool isCut = false;
};

Tail tailOf(int descriptor, off_t bytes) {
  constexpr off_t kTailBytes = off_t{1} << 16;  // no line is longer
  const off_t from = std::max<off_t>(0, bytes - kTailBytes);
  std::string text(static_cast<std::size_t>(bytes - from), '\0');
  const ssize_t count = pread(descriptor, text.data(), text.size(), from);
  text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  Tail tail;
  const std::size_t end = text.rfind('\n');
  tail.isCut = !text.empty() && end + 1 != text.size();
  if (end != std::string::npos) {
    const std::size_t before = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    tail.last = text.substr(begin, end - begin);
  }
  return tail;
}

/// Opens the file and locks it. A file that was renamed while this waited is opened again.
int openLocked(const fs::path& path) {
  constexpr mode_t kOwnerOnly = 0600;
  for (;;) {
    const int descriptor = open(path.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, kOwnerOnly);
    if (descriptor < 0) {
      return -1;
    }
    struct stat opened {};
    struct stat named {};
    if (flock(descriptor, LOCK_EX) == 0 && fstat(descriptor, &opened) == 0 &&
        stat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino) {
      return descriptor;
    }
    const int error = errno;
    close(descriptor);
    if (error != ENOENT && error != EINTR && error != 0) {
      errno = error;
      return -1;
    }
  }
}

}  // namespace

fs::path stateFolderOfUser() {
  return folders::stateHome() / "rivulet";
}

std::string textOf(const nlohmann::ordered_json& line, const char* key) {
  const auto found = line.find(key);
  return found != line.end() && found->is_string() ? found->get<std::string>() : std::string();
}

base::Result<Lines> readLines(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    return Lines();
  }
  const base::Result<std::string> text = base::readFile(path);
  if (!text) {
    return base::fail(text.error());
  }
  Lines lines;
  std::size_t begin = 0;
  for (std::size_t end = text->find('\n'); end != std::string::npos;
       end = text->find('\n', begin)) {
    lines.lines.push_back(text->substr(begin, end - begin));
    begin = end + 1;
  }
  lines.isCut = begin < text->size();
  return lines;
}

base::Result<void> appendLine(const fs::path& path, const MakeLine& make, std::uintmax_t bytesMax,
                              const LineDone& done) {
  if (std::error_code status; !fs::exists(path.parent_path(), status)) {
    (void)base::makePrivateFolder(path.parent_path());  // opening says what is wrong
  }
  const Descriptor file(openLocked(path));
  if (file.number() < 0) {
    return notWritable(path, errno);
  }
  struct stat facts {};
  if (fstat(file.number(), &facts) != 0) {
    return notWritable(path, errno);
  }
  if (bytesMax > 0 && static_cast<std::uintmax_t>(facts.st_size) >= bytesMax) {
    fs::path older = path;
    older += ".1";
    std::error_code status;
    fs::rename(path, older, status);
    if (status) {
      return notWritable(path, status.value());
    }
    return appendLine(path, make, bytesMax, done);
  }
  const Tail tail = tailOf(file.number(), facts.st_size);
  const std::string line = make(tail.last);
  const std::string text = (tail.isCut ? "\n" : "") + line + '\n';
  int error = base::writeWhole(file.number(), text);
  error = error == 0 ? base::syncToDisk(file.number()) : error;
  if (error != 0) {
    return notWritable(path, error);
  }
  return done ? done({line, tail.last, static_cast<std::uintmax_t>(facts.st_size),
                      static_cast<std::uintmax_t>(facts.st_size) + text.size()})
              : base::Result<void>{};
}

}  // namespace rivulet::journal
