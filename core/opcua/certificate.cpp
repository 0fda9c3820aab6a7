// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/sha256.h"
#include "base/text.h"
#include "opcua/error.h"

namespace rivulet::opcua {

namespace {

// Tags of DER (X.690) as they occur in a certificate.
constexpr unsigned char kSequence = 0x30;
constexpr unsigned char kSet = 0x31;
constexpr unsigned char kObjectIdentifier = 0x06;
constexpr unsigned char kOctetString = 0x04;
constexpr unsigned char kBoolean = 0x01;
constexpr unsigned char kUtcTime = 0x17;
constexpr unsigned char kGeneralizedTime = 0x18;
constexpr unsigned char kVersion = 0xA0;
constexpr unsigned char kExtensions = 0xA3;
constexpr unsigned char kDnsName = 0x82;
constexpr unsigned char kUri = 0x86;
constexpr unsigned char kIpAddress = 0x87;
constexpr std::size_t kIpv4Length = 4;

constexpr std::string_view kSubjectAltName{"\x55\x1D\x11", 3};  // 2.5.29.17

struct Element {
  unsigned char tag = 0;
  std::string_view content;
  std::size_t length = 0;  ///< of tag, length and content
};

/// Takes one element after another out of a text; a damaged one ends it.
class DerReader {
 public:
  explicit DerReader(std::string_view rest) : m_rest(rest) {}

  [[nodiscard]] std::optional<Element> peek() const {
    if (m_rest.size() < 2) {
      return std::nullopt;
    }
    std::size_t length = byte(1);
    std::size_t head = 2;
    if (length >= 0x80) {
      const std::size_t count = length & 0x7FU;
      if (count == 0 || count > 4 || m_rest.size() < 2 + count) {
        return std::nullopt;
      }
      length = 0;
      for (std::size_t i = 0; i < count; ++i) {
        length = (length << 8U) | byte(2 + i);
      }
      head += count;
    }
    if (length > m_rest.size() - head) {
      return std::nullopt;
    }
    return Element{byte(0), m_rest.substr(head, length), head + length};
  }

  /// The next element if it has this tag. Otherwise it stays.
  std::optional<Element> take(unsigned char tag) {
    const auto element = peek();
    if (!element || element->tag != tag) {
      return std::nullopt;
    }
    m_rest.remove_prefix(element->length);
    return element;
  }

  std::optional<Element> takeAny() {
    const auto element = peek();
    if (element) {
      m_rest.remove_prefix(element->length);
    }
    return element;
  }

 private:
  [[nodiscard]] unsigned char byte(std::size_t at) const {
    return static_cast<unsigned char>(m_rest[at]);
  }

  std::string_view m_rest;
};

/// Short names of the attributes that people know; others are left out.
std::string_view attributeName(std::string_view identifier) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kNames{
      {{{"\x55\x04\x03", 3}, "CN"},
       {{"\x55\x04\x0A", 3}, "O"},
       {{"\x55\x04\x0B", 3}, "OU"},
       {{"\x55\x04\x07", 3}, "L"},
       {{"\x55\x04\x08", 3}, "ST"},
       {{"\x55\x04\x06", 3}, "C"}}};
  for (const auto& [bytes, name] : kNames) {
    if (identifier == bytes) {
      return name;
    }
  }
  return {};
}

/// What a stranger has written, without the characters that would change the line around it.
std::string printable(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      c = '?';
    }
  }
  return result;
}

std::string nameText(std::string_view name) {
  std::string text;
  DerReader sets(name);
  while (const auto set = sets.take(kSet)) {
    DerReader attributes(set->content);
    while (const auto attribute = attributes.take(kSequence)) {
      DerReader members(attribute->content);
      const auto identifier = members.take(kObjectIdentifier);
      const auto value = members.takeAny();
      const std::string_view shortName =
          identifier ? attributeName(identifier->content) : std::string_view();
      if (value && !shortName.empty()) {
        text +=
            (text.empty() ? "" : ", ") + std::string(shortName) + "=" + printable(value->content);
      }
    }
  }
  return text;
}

/// A time of RFC 5280, 4.1.2.5: "YYMMDDhhmmssZ" (1950 to 2049) or "YYYYMMDDhhmmssZ".
std::optional<base::UtcMs> timeOf(const std::optional<Element>& element) {
  if (!element || (element->tag != kUtcTime && element->tag != kGeneralizedTime)) {
    return std::nullopt;
  }
  std::string digits(element->content);
  constexpr std::size_t kShortLength = 13;
  if (element->tag == kUtcTime && digits.size() == kShortLength) {
    digits.insert(0, digits < "50" ? "20" : "19");
  }
  constexpr std::size_t kLength = 15;
  if (digits.size() != kLength || digits.back() != 'Z') {
    return std::nullopt;
  }
  return base::utcOfText(digits.substr(0, 4) + "-" + digits.substr(4, 2) + "-" +
                         digits.substr(6, 2) + "T" + digits.substr(8, 2) + ":" +
                         digits.substr(10, 2) + ":" + digits.substr(12, 2) + ".000Z");
}

void readAlternativeNames(std::string_view extension, CertificateFacts& facts) {
  DerReader outer(extension);
  const auto names = outer.take(kSequence);
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
  const auto list = outer.take(kSequence);
  DerReader reader(list ? list->content : std::string_view());
  while (const auto extension = reader.take(kSequence)) {
    DerReader members(extension->content);
    const auto identifier = members.take(kObjectIdentifier);
    members.take(kBoolean);  // whether it is critical
    const auto value = members.take(kOctetString);
    if (identifier && value && identifier->content == kSubjectAltName) {
      readAlternativeNames(value->content, facts);
    }
  }
}

std::optional<CertificateFacts> factsOf(std::string_view certificate) {
  DerReader signedPart(certificate);
  const auto body = signedPart.take(kSequence);
  DerReader reader(body ? body->content : std::string_view());
  reader.take(kVersion);
  reader.takeAny();  // serial number
  reader.takeAny();  // algorithm of the signature
  const auto issuer = reader.take(kSequence);
  const auto validity = reader.take(kSequence);
  const auto subject = reader.take(kSequence);
  const auto key = reader.take(kSequence);
  if (!issuer || !validity || !subject || !key) {
    return std::nullopt;
  }
  DerReader times(validity->content);
  const auto from = timeOf(times.takeAny());
  const auto to = timeOf(times.takeAny());
  if (!from || !to) {
    return std::nullopt;
  }
  CertificateFacts facts;
  facts.subject = nameText(subject->content);
  facts.issuer = nameText(issuer->content);
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
  return certificate && certificate->tag == kSequence ? chain.substr(0, certificate->length)
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
  constexpr std::size_t kDigits = 64;
  std::string digits;
  for (const char c : text) {
    if (base::isDigit(c) || (c >= 'a' && c <= 'f')) {
      digits += c;
    } else if (c >= 'A' && c <= 'F') {
      digits += static_cast<char>(c - 'A' + 'a');
    } else if (c != ':' && c != ' ') {
      return {};
    }
  }
  return digits.size() == kDigits ? digits : std::string();
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
