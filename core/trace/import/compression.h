// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Files compressed with zstd. @threadsafety pure.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/budget.h"
#include "base/result.h"

namespace rivulet::trace {

[[nodiscard]] bool isCompressed(std::string_view bytes);

struct Unpacked {
  std::string text;
  bool whole = true;  ///< false: the archive is cut or damaged; `text` is what came before
};

/// @param bytes  of which `isCompressed` is true
/// @return error BudgetError::Exceeded: the text is larger
[[nodiscard]] base::Result<Unpacked> unpack(std::string_view bytes,
                                            const base::Budget& budget = {});

/// The first characters of the text, at most `count`; fewer: there are no more that can be read.
[[nodiscard]] std::string unpackFirst(std::string_view bytes, std::size_t count);

/// One frame, with its checksum.
[[nodiscard]] std::string pack(std::string_view text, int level);

}  // namespace rivulet::trace
