// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How much memory may be taken by what comes from outside. A few bytes can stand for any amount:
/// an archive, a loop, a long move that is divided finely. Whoever reads or expands is given a
/// budget, asks it before he takes memory, and gives those whom he calls what is left beside his
/// own (`without`). So it holds for one input and all that is made of it. A value that counts
/// nothing behind the scenes; the only owner of the figure and of its sentence.
///
/// Unit: bytes, as they are held at once, copies included. What takes less than some megabytes
/// however large its input is (buffers, the libraries of the formats) is not counted.
/// @threadsafety pure.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/result.h"

namespace rivulet::base {

enum class BudgetError {
  Exceeded = 1,
};

[[nodiscard]] std::error_code make_error_code(BudgetError code);

class Budget {
 public:
  static constexpr std::uint64_t kUsualBytes = 1'000'000'000;

  /// 1 GB, where nobody has said more or less.
  constexpr Budget() = default;
  constexpr explicit Budget(std::uint64_t bytes) : m_whole(bytes), m_left(bytes) {}

  [[nodiscard]] constexpr std::uint64_t left() const { return m_left; }
  /// What is left as long as `bytes` are held; never less than 0.
  [[nodiscard]] constexpr Budget without(std::uint64_t bytes) const {
    Budget rest = *this;
    rest.m_left -= bytes < m_left ? bytes : m_left;
    return rest;
  }
  /// How many items fit. @param bytesEach  > 0
  [[nodiscard]] constexpr std::size_t items(std::size_t bytesEach) const {
    return static_cast<std::size_t>(m_left / bytesEach);
  }

  /// What a list takes while it grows. One that is full moves: for a moment it is there twice.
  /// @param more  items that are added before somebody asks again
  template <class Item>
  [[nodiscard]] static constexpr std::size_t bytesOf(const std::vector<Item>& list,
                                                     std::size_t more = 1) {
    const std::size_t twice = 2 * list.size();
    const bool moves = list.size() + more > list.capacity();
    return (moves ? twice : std::min(list.capacity(), twice)) * sizeof(Item);
  }

  /// @param bytes  that are wanted, >= 0; may be more than any computer has
  /// @param what   takes them, the subject of the sentence: "The unpacked archive"
  /// @return error Exceeded: `bytes` are not left
  [[nodiscard]] Result<void> require(double bytes, std::string_view what) const;
  /// For those who find out on the way. @param bytes  0: nobody knows how many
  [[nodiscard]] Error exceeded(std::string_view what, double bytes = 0.0) const;

 private:
  std::uint64_t m_whole = kUsualBytes;
  std::uint64_t m_left = kUsualBytes;
};

}  // namespace rivulet::base

template <>
struct std::is_error_code_enum<rivulet::base::BudgetError> : std::true_type {};
