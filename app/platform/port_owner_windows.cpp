// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/port_owner.h"

namespace rivulet::platform {

/// Windows tells which process has a port, but not to everybody of which user that is.
std::optional<std::set<UserNumber>> ownersOfPort(PortKind /*kind*/, std::uint16_t /*port*/,
                                                 const std::filesystem::path& /*table*/) {
  return std::nullopt;
}

bool isPortOfAnother(PortKind /*kind*/, std::uint16_t /*port*/,
                     const std::filesystem::path& /*table*/) {
  return false;
}

}  // namespace rivulet::platform
