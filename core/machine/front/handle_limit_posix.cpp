// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/handle_limit.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>

#include "machine/front/server.h"

namespace rivulet::machine {

base::Result<void> requireHandles(std::size_t connections) {
  // Log, kept state, programs that are written, the event loop: a dozen are open at a time.
  constexpr std::size_t kOthers = 40;
  const auto needed = static_cast<rlim_t>(connections + kOthers);
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= needed) {
    return {};
  }
  limit.rlim_cur = std::min(needed, limit.rlim_max);
  if (limit.rlim_cur == needed && setrlimit(RLIMIT_NOFILE, &limit) == 0) {
    return {};
  }
  return base::fail(
      FrontError::TooFewHandles,
      fmt::format("This program may open {} files and connections at a time, and the server needs "
                  "{}. Raise the limit (ulimit -n), then start it again.",
                  limit.rlim_max, needed));
}

}  // namespace rivulet::machine
