// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/encryption.h"

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

}  // namespace rivulet::opcua
