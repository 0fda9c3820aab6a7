// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "journal/line_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/descriptor.h"
#include "base/file.h"
#include "base/file_lock.h"
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

/// The end of a file: the last complete line, and whether something incomplete follows it.
struct Tail {
  std::string last;
  bool isCut = false;
};

Tail tailOf(int descriptor, std::uintmax_t bytes) {
  constexpr std::uintmax_t kTailBytes = std::uintmax_t{1} << 16U;  // no line is longer
  const std::uintmax_t count = std::min(bytes, kTailBytes);
  const std::string text = base::readAt(descriptor, bytes - count, static_cast<std::size_t>(count));
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
base::Result<base::FileLock> openLocked(const fs::path& path) {
  for (;;) {
    base::Result<base::FileLock> file = base::FileLock::take(path);
    if (!file || base::hasName(file->descriptor(), path)) {
      return file;
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
  const base::Result<base::FileLock> file = openLocked(path);
  if (!file) {
    return base::fail(file.error());
  }
  const std::int64_t size = base::sizeOf(file->descriptor());
  if (size < 0) {
    return notWritable(path, errno);
  }
  const auto bytesBefore = static_cast<std::uintmax_t>(size);
  if (bytesMax > 0 && bytesBefore >= bytesMax) {
    fs::path older = path;
    older += ".1";
    std::error_code status;
    fs::rename(path, older, status);
    if (status) {
      return notWritable(path, status.default_error_condition().value());
    }
    return appendLine(path, make, bytesMax, done);
  }
  const Tail tail = tailOf(file->descriptor(), bytesBefore);
  const std::string line = make(tail.last);
  const std::string text = (tail.isCut ? "\n" : "") + line + '\n';
  int error = base::writeAt(file->descriptor(), text, bytesBefore);
  error = error == 0 ? base::syncToDisk(file->descriptor()) : error;
  if (error != 0) {
    return notWritable(path, error);
  }
  return done ? done({line, tail.last, bytesBefore, bytesBefore + text.size()})
              : base::Result<void>{};
}

}  // namespace rivulet::journal
