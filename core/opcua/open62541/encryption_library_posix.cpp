// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <link.h>

#include <array>
#include <string_view>

#include "opcua/open62541/encryption.h"

namespace rivulet::opcua {

namespace {

/// Names of the libraries that Debian's packages of open62541 have been built with.
constexpr std::array<std::string_view, 2> kLibraries{"libmbedcrypto", "libcrypto"};

}  // namespace

std::string encryptionLibrary() {
  std::string found;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* result) {
        const std::string_view path = info->dlpi_name;
        const std::string_view file = path.substr(path.rfind('/') + 1);
        for (const std::string_view library : kLibraries) {
          if (file.substr(0, library.size()) == library) {
            *static_cast<std::string*>(result) = path;
            return 1;
          }
        }
        return 0;
      },
      &found);
  return found;
}

}  // namespace rivulet::opcua
