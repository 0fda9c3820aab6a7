// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/machine_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/hash.h"

namespace rivulet::report {

std::string machineFileName(const std::string& endpoint, const opcua::ServerIdentity& server) {
  // Many characters of an endpoint cannot stand in a file name.
  std::string name;
  for (const char letter : endpoint) {
    const bool plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '.';
    if (plain || (!name.empty() && name.back() != '-')) {
      name += plain ? letter : '-';
    }
  }
  constexpr std::size_t kNameMax = 100;
  name.resize(std::min(name.size(), kNameMax));
  return fmt::format("{}-{:016x}.json", name,
                     base::hashOf(endpoint + '\n' + server.applicationUri));
}

}  // namespace rivulet::report
