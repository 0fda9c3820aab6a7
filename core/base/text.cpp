// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/text.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>

namespace rivulet::base {

std::optional<double> parseNumber(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-' && text[1] != '+') {
    text.remove_prefix(1);
  }
  double value = 0.0;
  const auto [end, status] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

std::optional<int> parseInteger(std::string_view text) {
  int value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

std::string formatNumber(double value) {
  return fmt::format("{}", value);
}

std::string formatFixed(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
      text.pop_back();
    }
  }
  return text == "-0" ? "0" : text;
}

std::string_view trim(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string toUpper(std::string_view text) {
  std::string upper(text);
  for (char& c : upper) {
    c = toUpper(c);
  }
  return upper;
}

namespace {

void appendUtf8(std::string& out, std::uint32_t code) {
  const auto byte = [&out](std::uint32_t value) { out += static_cast<char>(value); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xC0 | code >> 6);
    byte(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    byte(0xE0 | code >> 12);
    byte(0x80 | (code >> 6 & 0x3F));
    byte(0x80 | (code & 0x3F));
  } else {
    byte(0xF0 | code >> 18);
    byte(0x80 | (code >> 12 & 0x3F));
    byte(0x80 | (code >> 6 & 0x3F));
    byte(0x80 | (code & 0x3F));
  }
}

enum class Utf16 : std::uint8_t { No, LittleEndian, BigEndian };

/// By the byte order mark, or by a zero in one half of the pairs and none in the other.
Utf16 utf16Of(std::string_view content) {
  constexpr std::size_t kLookedAt = 4096;
  if (content.substr(0, 2) == "\xFF\xFE") {
    return Utf16::LittleEndian;
  }
  if (content.substr(0, 2) == "\xFE\xFF") {
    return Utf16::BigEndian;
  }
  std::array<std::size_t, 2> zeros{};
  const std::size_t looked = std::min(content.size(), kLookedAt) / 2 * 2;
  for (std::size_t i = 0; i < looked; ++i) {
    zeros[i % 2] += content[i] == '\0' ? 1U : 0U;
  }
  // NC text has few characters beyond Latin-1, and those in comments.
  const std::size_t most = looked / 2 - looked / 20;
  if (looked < 4 || (zeros[0] > 0 && zeros[1] > 0)) {
    return Utf16::No;
  }
  return zeros[1] >= most ? Utf16::LittleEndian : zeros[0] >= most ? Utf16::BigEndian : Utf16::No;
}

}  // namespace

std::string asUtf8(std::string content) {
  const Utf16 kind = utf16Of(content);
  if (kind == Utf16::No) {
    return content;
  }
  const std::size_t high = kind == Utf16::BigEndian ? 0 : 1;
  const auto unitAt = [&](std::size_t at) {
    const auto byte = [&](std::size_t i) {
      return static_cast<std::uint32_t>(static_cast<unsigned char>(content[i]));
    };
    return byte(at + high) << 8 | byte(at + 1 - high);
  };
  const auto isHalf = [](std::uint32_t unit, std::uint32_t first) {
    return unit >= first && unit < first + 0x400;
  };
  std::string out;
  out.reserve(content.size() / 2);
  for (std::size_t at = 0; at + 1 < content.size(); at += 2) {
    std::uint32_t code = unitAt(at);
    if (at == 0 && code == 0xFEFF) {
      continue;
    }
    if (isHalf(code, 0xD800) && at + 3 < content.size() && isHalf(unitAt(at + 2), 0xDC00)) {
      code = 0x10000 + ((code - 0xD800) << 10) + (unitAt(at + 2) - 0xDC00);
      at += 2;
    }
    appendUtf8(out, code);
  }
  return out;
}

bool hasEndlessKey(std::string_view text) {
  constexpr int kDotsMax = 500;
  int dots = 0;
  return std::any_of(text.begin(), text.end(), [&dots](char c) {
    dots = c == '\n' ? 0 : dots + (c == '.' ? 1 : 0);
    return dots > kDotsMax;
  });
}

std::string invisibleCharacter(std::string_view text) {
  const auto byte = [&text](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
  };
  const auto follows = [&](std::size_t i) { return i < text.size() && (byte(i) & 0xC0) == 0x80; };
  std::uint32_t code = 0;
  if (text.empty() || byte(0) < 0x7F) {
    return {};
  }
  if (byte(0) == 0xC2 && follows(1)) {
    code = byte(1);
  } else if ((byte(0) & 0xF0) == 0xE0 && follows(1) && follows(2)) {
    code = (byte(0) & 0x0F) << 12 | (byte(1) & 0x3F) << 6 | (byte(2) & 0x3F);
  } else {
    code = byte(0);  // Latin-1
  }
  struct Range {
    std::uint32_t first, last;
  };
  static constexpr std::array kInvisible{
      Range{0x7F, 0xA0},     Range{0xAD, 0xAD},     Range{0x1680, 0x1680},
      Range{0x180E, 0x180E}, Range{0x2000, 0x200F}, Range{0x2028, 0x202F},
      Range{0x205F, 0x2064}, Range{0x3000, 0x3000}, Range{0xFEFF, 0xFEFF}};
  const bool isInvisible = std::any_of(kInvisible.begin(), kInvisible.end(), [code](Range range) {
    return code >= range.first && code <= range.last;
  });
  return isInvisible ? fmt::format("U+{:04X}", code) : std::string();
}

}  // namespace rivulet::base
