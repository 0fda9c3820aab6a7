// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace_fetch/http.h"

#include "base/error.h"

namespace rivulet::trace_fetch {

std::error_code make_error_code(FetchError code) {
  static const base::NamedCategory category("trace fetch");
  return {static_cast<int>(code), category};
}

bool isOfConnection(const base::Error& error) {
  return error.code == FetchError::NotReachable || error.code == FetchError::TimedOut;
}

}  // namespace rivulet::trace_fetch
