// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Bytes that are read where they are asked for: a file that is too large to be read as a whole.
/// @threadsafety one thread at a time.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "base/result.h"

namespace rivulet::base {

class ByteSource {
 public:
  virtual ~ByteSource() = default;

  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// @return fewer bytes at the end; error Unreadable
  [[nodiscard]] virtual Result<std::string> read(std::uint64_t at, std::uint64_t bytes) = 0;
};

/// A file as it was when it was opened: what is appended later is not seen.
class FileBytes final : public ByteSource {
 public:
  /// @return error Unreadable: missing, a folder, no permission
  [[nodiscard]] static Result<FileBytes> open(const std::filesystem::path& path);

  [[nodiscard]] std::uint64_t size() const override { return m_size; }
  [[nodiscard]] Result<std::string> read(std::uint64_t at, std::uint64_t bytes) override;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::filesystem::path m_path;
  std::unique_ptr<std::FILE, Close> m_file;
  std::uint64_t m_size = 0;
};

}  // namespace rivulet::base
