// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "base/sha256.h"
#include "base/text.h"
#include "opcua/der.h"
#include "opcua/error.h"

namespace rivulet::opcua {

namespace {

using der::DerReader;
using der::printable;

// Tags of a certificate's own.
constexpr unsigned char kVersion = 0xA0;
constexpr unsigned char kExtensions = 0xA3;
constexpr unsigned char kDnsName = 0x82;
constexpr unsigned char kUri = 0x86;
constexpr unsigned char kIpAddress = 0x87;
constexpr std::size_t kIpv4Length = 4;

constexpr std::string_view kSubjectAltName{"\x55\x1D\x11", 3};  // 2.5.29.17

void readAlternativeNames(std::string_view extension, CertificateFacts& facts) {
  DerReader outer(extension);
  const auto names = outer.take(der::kSequence);
  DerReader reader(names ? names->content : std::string_view());
  while (const auto name = reader.takeAny()) {
    if (name->tag == kUri) {
      facts.applicationUris.push_back(printable(name->content));
    } else if (name->tag == kDnsName) {
      facts.hostNames.push_back(printable(name->content));
    } else if (name->tag == kIpAddress && name->content.size() == kIpv4Length) {
      const auto part = [&](std::size_t at) {
        return static_cast<unsigned char>(name->content[at]);
      };
      facts.hostNames.push_back(fmt::format("{}.{}.{}.{}", part(0), part(1), part(2), part(3)));
    }
  }
}

void readExtensions(std::string_view content, CertificateFacts& facts) {
  DerReader outer(content);
  const auto list = outer.take(der::kSequence);
  DerReader reader(list ? list->content : std::string_view());
  while (const auto extension = reader.take(der::kSequence)) {
    DerReader members(extension->content);
    const auto identifier = members.take(der::kObjectIdentifier);
    members.take(der::kBoolean);  // whether it is critical
    const auto value = members.take(der::kOctetString);
    if (identifier && value && identifier->content == kSubjectAltName) {
      readAlternativeNames(value->content, facts);
    }
  }
}

std::optional<CertificateFacts> factsOf(std::string_view certificate) {
  DerReader signedPart(certificate);
  const auto body = signedPart.take(der::kSequence);
  DerReader reader(body ? body->content : std::string_view());
  reader.take(kVersion);
  reader.takeAny();  // serial number
  reader.takeAny();  // algorithm of the signature
  const auto issuer = reader.take(der::kSequence);
  const auto validity = reader.take(der::kSequence);
  const auto subject = reader.take(der::kSequence);
  const auto key = reader.take(der::kSequence);
  if (!issuer || !validity || !subject || !key) {
    return std::nullopt;
  }
  DerReader times(validity->content);
  const auto from = der::timeOf(times.takeAny());
  const auto to = der::timeOf(times.takeAny());
  if (!from || !to) {
    return std::nullopt;
  }
  CertificateFacts facts;
  facts.subject = der::nameText(subject->content);
  facts.issuer = der::nameText(issuer->content);
  facts.validFrom = *from;
  facts.validTo = *to;
  while (const auto element = reader.takeAny()) {
    if (element->tag == kExtensions) {
      readExtensions(element->content, facts);
    }
  }
  return facts;
}

}  // namespace

std::string_view leafOf(std::string_view chain) {
  const auto certificate = DerReader(chain).peek();
  return certificate && certificate->tag == der::kSequence ? chain.substr(0, certificate->length)
                                                           : std::string_view();
}

base::Result<CertificateFacts> readCertificate(std::string_view der) {
  const std::string_view leaf = leafOf(der);
  const auto certificate = DerReader(leaf).peek();
  auto facts = certificate ? factsOf(certificate->content) : std::nullopt;
  if (!facts) {
    return base::fail(LinkError::CertificateInvalid,
                      "The certificate cannot be read. Create a new one on the server.");
  }
  facts->fingerprint = base::sha256Hex(leaf);
  return *facts;
}

std::string fingerprintText(std::string_view fingerprint) {
  std::string text;
  for (std::size_t i = 0; i < fingerprint.size(); ++i) {
    if (i > 0 && i % 2 == 0) {
      text += ':';
    }
    text += base::toUpper(fingerprint[i]);
  }
  return text;
}

std::string fingerprintOf(std::string_view text) {
  return base::sha256OfText(text);
}

bool isForHost(const CertificateFacts& facts, std::string_view host) {
  const std::string wanted = base::toUpper(host);
  return std::any_of(facts.hostNames.begin(), facts.hostNames.end(),
                     [&](const std::string& name) { return base::toUpper(name) == wanted; });
}

int daysLeft(const CertificateFacts& facts, base::UtcMs now) {
  constexpr base::UtcMs kDayMs = 86'400'000;
  const base::UtcMs left = facts.validTo - now;
  return static_cast<int>(left >= 0 ? left / kDayMs : -((-left + kDayMs - 1) / kDayMs));
}

}  // namespace rivulet::opcua
