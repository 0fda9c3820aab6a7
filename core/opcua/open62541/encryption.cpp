// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/encryption.h"

#include <link.h>
#include <open62541/plugin/create_certificate.h>
#include <open62541/types.h>
#include <open62541/util.h>

#include <array>
#include <string_view>

#include "opcua/error.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/quiet_logger.h"

namespace rivulet::opcua {

namespace {

using Bytes = Handle<UA_ByteString, UA_TYPES_BYTESTRING>;

constexpr UA_UInt16 kKeyBits = 2048;

/// Names of the libraries that Debian's packages of open62541 have been built with.
constexpr std::array<std::string_view, 2> kLibraries{"libmbedcrypto", "libcrypto"};

}  // namespace

base::Result<OwnCertificate> makeCertificate(const CertificateRequest& request) {
  const std::array<std::string, 2> subject{"CN=" + request.commonName, "O=Rivulet"};
  std::vector<std::string> names;
  for (const std::string& host : request.hostNames) {
    names.push_back("DNS:" + host);
  }
  names.push_back("URI:" + request.applicationUri);

  std::vector<UA_String> subjectParts;
  for (const std::string& part : subject) {
    subjectParts.push_back(borrow(part));
  }
  std::vector<UA_String> alternativeNames;
  for (const std::string& name : names) {
    alternativeNames.push_back(borrow(name));  // the library relies on the zero after it
  }
  UA_UInt16 keyBits = kKeyBits;
  auto days = static_cast<UA_UInt16>(request.days);
  std::array<UA_KeyValuePair, 2> parameters{
      {{{0, borrow("key-size-bits")}, borrowScalar(keyBits, UA_TYPES_UINT16)},
       {{0, borrow("expires-in-days")}, borrowScalar(days, UA_TYPES_UINT16)}}};
  UA_KeyValueMap map{parameters.size(), parameters.data()};

  QuietLogger logger;
  Bytes key;
  Bytes certificate;
  const UA_StatusCode status = UA_CreateCertificate(
      logger.handle(), subjectParts.data(), subjectParts.size(), alternativeNames.data(),
      alternativeNames.size(), UA_CERTIFICATEFORMAT_DER, &map, key.get(), certificate.get());
  if (status != UA_STATUSCODE_GOOD) {
    return base::fail(LinkError::CertificateInvalid,
                      "The OPC UA library cannot create a certificate. Check that it was built "
                      "with encryption.");
  }
  return OwnCertificate{std::string(view(*certificate.get())), std::string(view(*key.get())),
                        request.applicationUri};
}

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
