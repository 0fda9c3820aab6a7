// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The DER encoding (X.690) as far as certificates, revocation lists and keys need it; for this
/// folder only. @threadsafety pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/utc.h"

namespace rivulet::opcua::der {

// Tags that occur in certificates, lists and keys.
inline constexpr unsigned char kSequence = 0x30;
inline constexpr unsigned char kSet = 0x31;
inline constexpr unsigned char kObjectIdentifier = 0x06;
inline constexpr unsigned char kOctetString = 0x04;
inline constexpr unsigned char kBoolean = 0x01;
inline constexpr unsigned char kUtcTime = 0x17;
inline constexpr unsigned char kGeneralizedTime = 0x18;
inline constexpr unsigned char kInteger = 0x02;

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

  [[nodiscard]] bool isAtEnd() const { return m_rest.empty(); }

 private:
  [[nodiscard]] unsigned char byte(std::size_t at) const {
    return static_cast<unsigned char>(m_rest[at]);
  }

  std::string_view m_rest;
};

/// What a stranger has written, without the characters that would change the line around it.
[[nodiscard]] std::string printable(std::string_view text);
/// A name of X.501, "CN=..., O=...": the attributes that people know. @param name  its content
[[nodiscard]] std::string nameText(std::string_view name);
/// A time of RFC 5280, 4.1.2.5: "YYMMDDhhmmssZ" (1950 to 2049) or "YYYYMMDDhhmmssZ".
[[nodiscard]] std::optional<base::UtcMs> timeOf(const std::optional<Element>& element);

}  // namespace rivulet::opcua::der
