// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Files compressed with zstd. @threadsafety pure.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rivulet::trace {

/// A file may not become larger than this: a few bytes can stand for any amount.
inline constexpr std::size_t kUnpackedBytesMax = std::size_t{1} << 30U;

[[nodiscard]] bool isCompressed(std::string_view bytes);

struct Unpacked {
  std::string text;
  bool whole = true;        ///< false: the archive is cut or damaged; `text` is what came before
  bool isTooLarge = false;  ///< larger than `kUnpackedBytesMax`; `text` is empty
};

/// @param bytes  of which `isCompressed` is true
[[nodiscard]] Unpacked unpack(std::string_view bytes);

/// One frame, with its checksum.
[[nodiscard]] std::string pack(std::string_view text, int level);

}  // namespace rivulet::trace
