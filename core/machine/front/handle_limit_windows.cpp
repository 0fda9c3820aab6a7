// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/handle_limit.h"

namespace rivulet::machine {

/// A socket is no file here, and there is no limit that a server would meet.
base::Result<void> requireHandles(std::size_t /*connections*/) {
  return {};
}

}  // namespace rivulet::machine
