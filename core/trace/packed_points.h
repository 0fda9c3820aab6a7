// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The samples of a signal in little memory, without loss. Blocks of 128 samples keep times as
/// differences from equal steps, and values as whole multiples of a power of ten where they are
/// such, as traces of controls are: 1 to 3 bytes per sample. Other values need 8 bytes.
/// @threadsafety one object, one thread; several may read what nobody appends to.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/instant.h"

namespace rivulet::trace {

struct SeriesPoint {
  base::Instant at{};
  double value = 0.0;  ///< NaN: the signal has a gap here, the line is interrupted

  friend bool operator==(const SeriesPoint&, const SeriesPoint&) = default;
};

class PackedPoints {
 public:
  static constexpr std::size_t kBlockSize = 128;

  void append(const SeriesPoint& point);
  void clear();

  [[nodiscard]] std::size_t size() const { return m_size; }
  [[nodiscard]] bool empty() const { return m_size == 0; }
  /// O(1). @param index < size()
  [[nodiscard]] SeriesPoint operator[](std::size_t index) const {
    return {timeAt(index), valueAt(index)};
  }
  [[nodiscard]] base::Instant timeAt(std::size_t index) const;
  [[nodiscard]] double valueAt(std::size_t index) const;
  /// Of the samples, without the object itself.
  [[nodiscard]] std::size_t memoryBytes() const;

 private:
  /// The times are first + i * step + code, the values (base + code) / 10^decimals, or as they are.
  struct Block {
    std::uint64_t firstNs = 0;  ///< calculated modulo 2^64
    std::uint64_t stepNs = 0;
    std::int64_t base = 0;
    std::unique_ptr<std::uint8_t[]> codes;  ///< those of the times, then those of the values
    std::uint16_t valueOffset = 0;          ///< bytes
    std::uint16_t byteCount = 0;
    std::uint8_t timeBits = 0;
    std::uint8_t valueBits = 0;  ///< of one code; 64: the double itself
    std::uint8_t decimals = 0;
    bool hasGaps = false;  ///< the largest code is a NaN
  };

  [[nodiscard]] static Block pack(const std::array<SeriesPoint, kBlockSize>& points);

  std::vector<Block> m_blocks;
  std::array<SeriesPoint, kBlockSize> m_tail{};  ///< of a block that is not full
  std::size_t m_size = 0;
  std::size_t m_codeBytes = 0;
};

}  // namespace rivulet::trace
