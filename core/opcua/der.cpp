// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/der.h"

#include <array>
#include <utility>

namespace rivulet::opcua::der {

namespace {

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

}  // namespace

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

}  // namespace rivulet::opcua::der
