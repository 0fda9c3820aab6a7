// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Hashes that are the same on every run and in every build, unlike `std::hash`: they are stored in
/// recordings, in file names and on the control. They distinguish versions; they do not protect
/// against tampering. @threadsafety pure.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rivulet::base {

inline constexpr std::uint64_t kHashBasis = 0xCBF29CE484222325ULL;
inline constexpr std::uint64_t kHashPrime = 0x100000001B3ULL;

/// FNV-1a with 64 bits over the bytes of `text`. For names and programs of a few kilobytes.
[[nodiscard]] constexpr std::uint64_t hashOf(std::string_view text) {
  std::uint64_t hash = kHashBasis;
  for (const char byte : text) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * kHashPrime;
  }
  return hash;
}

/// The same over little-endian words of eight bytes, folded after each, for files of many
/// megabytes: byte by byte, the hash took an eighth of the time of loading a program. Its values
/// differ from those of `hashOf`.
[[nodiscard]] constexpr std::uint64_t hashOfFile(std::string_view text) {
  constexpr std::size_t kWordBytes = 8;
  constexpr unsigned kByteBits = 8;
  std::uint64_t hash = kHashBasis;
  const auto mix = [&hash](std::uint64_t word) {
    hash = (hash ^ word) * kHashPrime;
    hash ^= hash >> 32U;
  };
  mix(text.size());
  while (!text.empty()) {
    // Compilers make one load of the loop where the eight bytes are there.
    std::uint64_t word = 0;
    const std::size_t bytes = std::min(text.size(), kWordBytes);
    for (std::size_t i = 0; i < bytes; ++i) {
      word |= static_cast<std::uint64_t>(static_cast<unsigned char>(text[i]))
              << (kByteBits * static_cast<unsigned>(i));
    }
    mix(word);
    text.remove_prefix(bytes);
  }
  return hash;
}

}  // namespace rivulet::base
