// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/byte_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>

#include "base/descriptor.h"
#include "base/file.h"

namespace rivulet::base {

namespace {

tl::unexpected<Error> cannotBeRead(const std::filesystem::path& path, int errorNumber) {
  return fail(FileError::Unreadable,
              fmt::format("The file cannot be read: {}.",
                          std::generic_category().message(errorNumber != 0 ? errorNumber : EIO)),
              path.string());
}

}  // namespace

Result<FileBytes> FileBytes::open(const std::filesystem::path& path) {
  std::error_code error;
  const bool isFolder = std::filesystem::is_directory(path, error);
  FileBytes source;
  source.m_path = path;
  source.m_file.reset(isFolder ? nullptr : openStream(path));
  if (!source.m_file) {
    return cannotBeRead(path, isFolder ? EISDIR : errno);
  }
  source.m_size = std::filesystem::file_size(path, error);
  if (error) {
    return cannotBeRead(path, error.default_error_condition().value());
  }
  return source;
}

Result<std::string> FileBytes::read(std::uint64_t at, std::uint64_t bytes) {
  if (at >= m_size) {
    return std::string();
  }
  std::string out(static_cast<std::size_t>(std::min(bytes, m_size - at)), '\0');
  if (!readFrom(m_file.get(), at)) {
    return cannotBeRead(m_path, errno);
  }
  out.resize(std::fread(out.data(), 1, out.size(), m_file.get()));
  if (std::ferror(m_file.get()) != 0) {
    return cannotBeRead(m_path, errno);
  }
  return out;
}

}  // namespace rivulet::base
