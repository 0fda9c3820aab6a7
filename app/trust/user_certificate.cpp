// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trust/user_certificate.h"

#include "base/file.h"
#include "trust/own_certificate.h"
#include "trust/private_file.h"

namespace rivulet::trust {

namespace fs = std::filesystem;

base::Result<opcua::UserCertificate> readUserFiles(const fs::path& certificate,
                                                   const fs::path& key) {
  const auto shown = base::readFile(certificate, kCertificateBytesMax);
  if (!shown) {
    return base::fail(shown.error());
  }
  const fs::path& keyFile = key.empty() ? certificate : key;
  const auto secret = readPrivateFile(keyFile);
  if (!secret) {
    return base::fail(secret.error());
  }
  auto user = opcua::readUserCertificate(*shown, *secret);
  if (!user) {
    return base::fail(user.error().code, user.error().message, keyFile.string());
  }
  return user;
}

}  // namespace rivulet::trust
