// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trust/own_certificate.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "base/file.h"
#include "base/private_file.h"
#include "opcua/error.h"
#include "opcua/open62541/encryption.h"
#include "platform/process.h"
#include "platform/user_folders.h"
#include "trust/private_file.h"

namespace rivulet::trust {

namespace fs = std::filesystem;

namespace {

constexpr const char* kCertificateFile = "certificate.der";
constexpr const char* kKeyFile = "key.der";

std::string hostName() {
  const std::string name = platform::hostName();
  return name.empty() ? "localhost" : name;
}

base::Result<opcua::OwnCertificate> load(const fs::path& folder) {
  auto certificate = base::readFile(folder / kCertificateFile, kCertificateBytesMax);
  if (!certificate) {
    return base::fail(certificate.error());
  }
  auto key = readPrivateFile(folder / kKeyFile);
  if (!key) {
    return base::fail(key.error());
  }
  const auto facts = opcua::readCertificate(*certificate);
  if (!facts || facts->applicationUris.empty()) {
    return base::fail(opcua::LinkError::CertificateInvalid,
                      "The certificate of this computer is damaged. Renew it: rivulet-cli "
                      "certificate --renew, or --renew-certificate of the server.",
                      (folder / kCertificateFile).string());
  }
  return opcua::OwnCertificate{std::move(*certificate), std::move(*key),
                               facts->applicationUris.front()};
}

opcua::CertificateRequest requestFor(const Application& application) {
  const std::string host = hostName();
  std::string name = fmt::format("{}@{}", application.name, host);
  if (application.uri.empty()) {
    return {std::move(name), fmt::format("urn:{}:rivulet", host), {host}};
  }
  return {std::move(name), std::string(application.uri), {host, "localhost"}};
}

/// Makes certificate and key in a new folder beside the one that it is for.
base::Result<fs::path> make(const fs::path& folder, const Application& application) {
  const auto made = opcua::makeCertificate(requestFor(application));
  if (!made) {
    return base::fail(made.error());
  }
  if (auto done = base::makePrivateFolder(folder); !done) {
    return base::fail(done.error());
  }
  const fs::path fresh =
      folder / fmt::format("{}.new-{}", application.folder, platform::processId());
  std::error_code status;
  fs::remove_all(fresh, status);
  auto done = base::makePrivateFolder(fresh);
  if (done) {
    done = writePrivateFile(fresh / kKeyFile, made->privateKey);
  }
  if (done) {
    done = writePrivateFile(fresh / kCertificateFile, made->certificate);
  }
  return done ? base::Result<fs::path>(fresh) : base::fail(done.error());
}

/// Gives the folder its name as a whole: another program may be doing the same.
base::Result<opcua::OwnCertificate> install(const fs::path& fresh, const fs::path& target) {
  std::error_code status;
  fs::rename(fresh, target, status);
  if (status) {
    std::error_code ignored;
    fs::remove_all(fresh, ignored);  // another program was faster
  }
  return load(target);
}

}  // namespace

fs::path trustFolder() {
  return folders::configHome() / "rivulet" / "trust";
}

fs::path certificatePath(const fs::path& folder, const Application& application) {
  return folder / application.folder / kCertificateFile;
}

base::Result<opcua::OwnCertificate> ownCertificate(const fs::path& folder,
                                                   const Application& application) {
  const fs::path target = folder / application.folder;
  std::error_code status;
  if (fs::exists(target, status)) {
    return load(target);
  }
  const auto fresh = make(folder, application);
  return fresh ? install(*fresh, target) : base::fail(fresh.error());
}

base::Result<opcua::OwnCertificate> renewCertificate(const fs::path& folder,
                                                     const Application& application) {
  const auto fresh = make(folder, application);
  if (!fresh) {
    return base::fail(fresh.error());
  }
  const fs::path target = folder / application.folder;
  std::error_code status;
  for (int number = 1; fs::exists(target, status); ++number) {
    const fs::path old = target.string() + fmt::format(".old-{}", number);
    if (!fs::exists(old, status)) {
      fs::rename(target, old, status);
      if (status) {
        return base::fail(base::FileError::NotWritable, "The old certificate cannot be moved.",
                          target.string());
      }
    }
  }
  return install(*fresh, target);
}

}  // namespace rivulet::trust
