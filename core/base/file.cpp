// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/file.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>

#include "base/descriptor.h"
#include "base/private_file.h"
#include "base/replace_file.h"

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

}  // namespace

std::error_code make_error_code(FileError code) {
  static const NamedCategory category("file");
  return {static_cast<int>(code), category};
}

namespace {

/// @param tooLarge  what is said of a file that is larger than `bytesMax`
Result<std::string> readUpTo(const fs::path& path, std::uintmax_t bytesMax, const Error& tooLarge) {
  std::error_code status;
  if (fs::is_directory(path, status)) {
    return unreadable(path, "it is a folder");
  }
  const File file(openStream(path));
  if (!file) {
    return unreadable(path, reason(errno));
  }
  std::string text;
  const std::uintmax_t size = fs::file_size(path, status);
  if (!status && size > bytesMax) {
    return fail(tooLarge);
  }
  if (!status) {
    text.reserve(static_cast<std::size_t>(size));
  }
  std::array<char, 65536> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
    text.append(buffer.data(), count);
    if (text.size() > bytesMax) {
      return fail(tooLarge);
    }
  }
  if (std::ferror(file.get()) != 0) {
    return unreadable(path, reason(errno));
  }
  return text;
}

}  // namespace

Result<std::string> readFile(const fs::path& path, const Budget& budget) {
  Error tooLarge = budget.exceeded("The file");
  tooLarge.context = path.string();
  return readUpTo(path, budget.left(), tooLarge);
}

Result<std::string> readFile(const fs::path& path, std::uintmax_t bytesMax) {
  return readUpTo(
      path, bytesMax,
      unreadable(path, fmt::format("it is larger than {} MiB", bytesMax >> 20)).value());
}

Result<void> writeFile(const fs::path& path, std::string_view text) {
  return replaceFile(path, text, false);
}

Result<void> writePrivateFile(const fs::path& path, std::string_view text) {
  return replaceFile(path, text, true);
}

}  // namespace rivulet::base
