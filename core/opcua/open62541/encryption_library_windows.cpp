// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/encryption.h"

namespace rivulet::opcua {

std::string encryptionLibrary() {
  return "Mbed TLS, in the program itself";
}

}  // namespace rivulet::opcua
