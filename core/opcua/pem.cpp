// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/pem.h"

#include <cstdint>

namespace rivulet::opcua {

namespace {

/// The six bits of a character of base64 (RFC 4648); nothing for others.
std::optional<std::uint32_t> sixBits(char c) {
  constexpr std::string_view kAlphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t at = kAlphabet.find(c);
  return at == std::string_view::npos ? std::nullopt
                                      : std::optional(static_cast<std::uint32_t>(at));
}

std::optional<std::string> bytesOfBase64(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  bool hasEnded = false;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
      continue;
    }
    if (c == '=') {
      hasEnded = true;
      continue;
    }
    const auto six = sixBits(c);
    if (!six || hasEnded) {
      return std::nullopt;
    }
    bits = (bits << 6U) | *six;
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>((bits >> static_cast<unsigned>(count)) & 0xFFU);
    }
  }
  return bytes;
}

std::string beginOf(std::string_view label) {
  return "-----BEGIN " + std::string(label) + "-----";
}

}  // namespace

bool hasPemPart(std::string_view text, std::string_view label) {
  return text.find(beginOf(label)) != std::string_view::npos;
}

std::optional<std::string> pemPart(std::string_view text, std::string_view label) {
  const std::string begin = beginOf(label);
  const std::size_t from = text.find(begin);
  const std::size_t to =
      from == std::string_view::npos ? from : text.find("-----END " + std::string(label), from);
  if (to == std::string_view::npos) {
    return std::nullopt;
  }
  return bytesOfBase64(text.substr(from + begin.size(), to - from - begin.size()));
}

}  // namespace rivulet::opcua
