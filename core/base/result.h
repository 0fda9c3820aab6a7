// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// `Result<T>`: a value or an `Error`. Mark every function that returns one `[[nodiscard]]`.
#pragma once

#include <tl/expected.hpp>
#include <utility>

#include "base/error.h"

namespace rivulet::base {

template <class T>
using Result = tl::expected<T, Error>;

[[nodiscard]] inline tl::unexpected<Error> fail(std::error_code code, std::string message,
                                                std::string context = {}) {
  return tl::unexpected<Error>(makeError(code, std::move(message), std::move(context)));
}

[[nodiscard]] inline tl::unexpected<Error> fail(Error error) {
  return tl::unexpected<Error>(std::move(error));
}

}  // namespace rivulet::base
