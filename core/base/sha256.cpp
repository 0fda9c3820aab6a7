// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/sha256.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/text.h"

namespace rivulet::base {

namespace {

constexpr std::size_t kBlockBytes = 64;
constexpr std::size_t kRounds = 64;
constexpr std::size_t kLengthBytes = 8;
using State = std::array<std::uint32_t, 8>;

/// The first 32 bits of the fractional parts of the cube roots of the first 64 primes.
constexpr std::array<std::uint32_t, kRounds> kConstants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};
/// The same of the square roots of the first eight primes.
constexpr State kInitial{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};

void addBlock(State& state, std::span<const std::uint8_t, kBlockBytes> block) {
  std::array<std::uint32_t, kRounds> words{};
  for (std::size_t t = 0; t < 16; ++t) {
    for (std::size_t i = 0; i < 4; ++i) {
      words[t] = words[t] << 8U | block[4 * t + i];
    }
  }
  for (std::size_t t = 16; t < kRounds; ++t) {
    const std::uint32_t a = words[t - 15];
    const std::uint32_t b = words[t - 2];
    words[t] = words[t - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ (a >> 3U)) + words[t - 7] +
               (std::rotr(b, 17) ^ std::rotr(b, 19) ^ (b >> 10U));
  }
  auto [a, b, c, d, e, f, g, h] = state;
  for (std::size_t t = 0; t < kRounds; ++t) {
    const std::uint32_t first = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) +
                                ((e & f) ^ (~e & g)) + kConstants[t] + words[t];
    const std::uint32_t second =
        (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
    h = g;
    g = f;
    f = e;
    e = d + first;
    d = c;
    c = b;
    b = a;
    a = first + second;
  }
  const State added{a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < state.size(); ++i) {
    state[i] += added[i];
  }
}

/// @param state  after `before` bytes, a multiple of a block
State digest(State state, std::uint64_t before, std::string_view bytes) {
  // The message, a bit of one, zeros, and its length in bits fill whole blocks.
  std::string padded(bytes);
  padded += '\x80';
  while (padded.size() % kBlockBytes != kBlockBytes - kLengthBytes) {
    padded += '\0';
  }
  const std::uint64_t bits = (before + bytes.size()) * 8;
  for (std::size_t i = kLengthBytes; i-- > 0;) {
    padded += static_cast<char>(bits >> (8 * i) & 0xFFU);
  }
  for (std::size_t at = 0; at < padded.size(); at += kBlockBytes) {
    std::array<std::uint8_t, kBlockBytes> block{};
    for (std::size_t i = 0; i < kBlockBytes; ++i) {
      block[i] = static_cast<std::uint8_t>(padded[at + i]);
    }
    addBlock(state, block);
  }
  return state;
}

std::string bytesOf(const State& state) {
  std::string bytes;
  for (const std::uint32_t word : state) {
    for (unsigned shift = 32; shift > 0; shift -= 8) {
      bytes += static_cast<char>(word >> (shift - 8) & 0xFFU);
    }
  }
  return bytes;
}

std::string hexOf(const State& state) {
  std::string hex;
  for (const std::uint32_t word : state) {
    hex += fmt::format("{:08x}", word);
  }
  return hex;
}

/// The key of an HMAC (RFC 2104) as the states after its two blocks.
class Hmac {
 public:
  explicit Hmac(std::string_view key) {
    const std::string shortKey =
        key.size() > kBlockBytes ? bytesOf(digest(kInitial, 0, key)) : std::string(key);
    m_inner = afterKey(shortKey, 0x36);
    m_outer = afterKey(shortKey, 0x5C);
  }

  [[nodiscard]] State operator()(std::string_view message) const {
    return digest(m_outer, kBlockBytes, bytesOf(digest(m_inner, kBlockBytes, message)));
  }

 private:
  static State afterKey(const std::string& key, std::uint8_t pad) {
    std::array<std::uint8_t, kBlockBytes> block{};
    for (std::size_t i = 0; i < kBlockBytes; ++i) {
      const std::uint8_t byte = i < key.size() ? static_cast<std::uint8_t>(key[i]) : std::uint8_t{};
      block[i] = static_cast<std::uint8_t>(byte ^ pad);
    }
    State state = kInitial;
    addBlock(state, block);
    return state;
  }

  State m_inner{};
  State m_outer{};
};

}  // namespace

std::string sha256Hex(std::string_view bytes) {
  return hexOf(digest(kInitial, 0, bytes));
}

std::string passwordHashHex(std::string_view password, std::string_view salt, int iterations) {
  const Hmac hmac(password);
  State turn = hmac(std::string(salt) + std::string("\0\0\0\1", 4));
  State sum = turn;
  for (int i = 1; i < iterations; ++i) {
    turn = hmac(bytesOf(turn));
    for (std::size_t k = 0; k < sum.size(); ++k) {
      sum[k] ^= turn[k];
    }
  }
  return hexOf(sum);
}

std::string sha256OfText(std::string_view text) {
  constexpr std::size_t kDigits = 64;
  std::string digits;
  for (const char c : text) {
    if (isDigit(c) || (c >= 'a' && c <= 'f')) {
      digits += c;
    } else if (c >= 'A' && c <= 'F') {
      digits += static_cast<char>(c - 'A' + 'a');
    } else if (c != ':' && c != ' ') {
      return {};
    }
  }
  return digits.size() == kDigits ? digits : std::string();
}

}  // namespace rivulet::base
