// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Seeded random numbers that are the same on every platform and in every build type: the
/// standard library's distributions differ between implementations, so Rivulet has its own.
/// @threadsafety one object, one thread.
#pragma once

#include <array>
#include <cstdint>

namespace rivulet::base {

/// xoshiro256++ (Blackman, Vigna 2019), seeded by splitmix64.
class Random {
 public:
  explicit Random(std::uint64_t seed);

  [[nodiscard]] std::uint64_t bits();
  /// Uniform in [0, 1).
  [[nodiscard]] double uniform();
  /// Uniform whole number in [0, bound). @param bound > 0
  [[nodiscard]] std::uint64_t below(std::uint64_t bound);
  /// Standard normal (polar method; every value drawn is used once, so runs repeat to the bit).
  [[nodiscard]] double normal();
  /// Exponential with mean 1.
  [[nodiscard]] double exponential();
  /// A generator whose sequence is independent of this one's; `stream` tells them apart.
  [[nodiscard]] Random fork(std::uint64_t stream) const;

 private:
  std::array<std::uint64_t, 4> m_state{};
  double m_spare = 0.0;
  bool m_hasSpare = false;
};

}  // namespace rivulet::base
