// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/packed_points.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "base/contract.h"
#include "trace/signals.h"

namespace rivulet::trace {

namespace {

using Points = std::array<SeriesPoint, PackedPoints::kBlockSize>;
using Codes = std::array<std::uint64_t, PackedPoints::kBlockSize>;

constexpr std::array<double, 10> kPowers{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
/// A code of so many bits is within eight bytes wherever it begins.
constexpr unsigned kCodeBitsMax = 57;
constexpr unsigned kWholeBits = 64;
/// Multiples beyond are not exact in a double.
constexpr double kMultipleMax = 4503599627370496.0;  // 2^52

unsigned bitsFor(std::uint64_t largest) {
  const auto bits = static_cast<unsigned>(std::bit_width(largest));
  return bits > kCodeBitsMax ? kWholeBits : bits;
}

std::uint64_t load(const std::uint8_t* from) {
  std::uint64_t value = 0;
  std::memcpy(&value, from, sizeof value);
  return value;
}

void store(std::uint8_t* to, std::uint64_t value) {
  std::memcpy(to, &value, sizeof value);
}

std::uint64_t readCode(const std::uint8_t* codes, std::size_t index, unsigned bits) {
  if (bits == 0) {
    return 0;
  }
  if (bits == kWholeBits) {
    return load(codes + sizeof(std::uint64_t) * index);
  }
  const std::size_t bit = index * bits;
  return (load(codes + bit / 8) >> (bit % 8)) & ((std::uint64_t{1} << bits) - 1);
}

void writeCode(std::uint8_t* codes, std::size_t index, unsigned bits, std::uint64_t code) {
  if (bits == kWholeBits) {
    store(codes + sizeof code * index, code);
  } else if (bits > 0) {
    const std::size_t bit = index * bits;
    store(codes + bit / 8, load(codes + bit / 8) | (code << (bit % 8)));
  }
}

std::uint64_t nanoseconds(const SeriesPoint& point) {
  return static_cast<std::uint64_t>(point.at.time_since_epoch().count());
}

/// Whole multiples of 10^-decimals, as their distance from the smallest.
struct Multiples {
  std::int64_t smallest = 0;
  std::uint64_t range = 0;
  unsigned decimals = 0;
  bool hasGaps = false;
};

std::optional<Multiples> multiplesOf(const Points& points, unsigned decimals, Codes& codes) {
  Multiples found{std::numeric_limits<std::int64_t>::max(), 0, decimals, false};
  std::int64_t largest = std::numeric_limits<std::int64_t>::min();
  const double power = kPowers[decimals];
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double value = points[i].value;
    if (std::isnan(value)) {
      found.hasGaps = true;
      continue;
    }
    const double multiple = std::nearbyint(value * power);
    // Negated, so that infinity fails.
    if (!(std::abs(multiple) < kMultipleMax) || multiple / power != value) {
      return std::nullopt;
    }
    const auto whole = static_cast<std::int64_t>(multiple);
    codes[i] = static_cast<std::uint64_t>(whole);
    found.smallest = std::min(found.smallest, whole);
    largest = std::max(largest, whole);
  }
  if (largest < found.smallest) {
    found.smallest = largest = 0;  // gaps only
  }
  found.range = static_cast<std::uint64_t>(largest - found.smallest);
  for (std::size_t i = 0; i < points.size(); ++i) {
    codes[i] -= static_cast<std::uint64_t>(found.smallest);
  }
  return found;
}

}  // namespace

PackedPoints::Block PackedPoints::pack(const Points& points) {
  Block block;
  constexpr std::size_t n = kBlockSize;
  Codes times{};
  const std::uint64_t first = nanoseconds(points.front());
  block.stepNs = (nanoseconds(points.back()) - first) / (n - 1);
  std::int64_t smallest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    times[i] = nanoseconds(points[i]) - first - i * block.stepNs;
    smallest = std::min(smallest, static_cast<std::int64_t>(times[i]));
  }
  std::uint64_t timeRange = 0;
  for (std::uint64_t& time : times) {
    time -= static_cast<std::uint64_t>(smallest);
    timeRange = std::max(timeRange, time);
  }
  block.firstNs = first + static_cast<std::uint64_t>(smallest);
  block.timeBits = static_cast<std::uint8_t>(bitsFor(timeRange));

  Codes values{};
  std::optional<Multiples> multiples;
  for (unsigned decimals = 0; decimals < kPowers.size() && !multiples; ++decimals) {
    multiples = multiplesOf(points, decimals, values);
  }
  // The code after the largest stands for a gap.
  unsigned valueBits = multiples ? bitsFor(multiples->range + (multiples->hasGaps ? 1 : 0)) : 0;
  if (multiples && valueBits < kWholeBits) {
    block.base = multiples->smallest;
    block.decimals = static_cast<std::uint8_t>(multiples->decimals);
    block.hasGaps = multiples->hasGaps;
  } else {
    valueBits = kWholeBits;
  }
  block.valueBits = static_cast<std::uint8_t>(valueBits);
  const std::size_t timeBytes = n * block.timeBits / 8;
  const std::size_t valueBytes = n * valueBits / 8;
  block.valueOffset = static_cast<std::uint16_t>(timeBytes);
  if (timeBytes + valueBytes > 0) {
    // A code is read as eight bytes, also the last one.
    block.byteCount = static_cast<std::uint16_t>(timeBytes + valueBytes + sizeof(std::uint64_t));
    block.codes = std::make_unique<std::uint8_t[]>(block.byteCount);
  }
  for (std::size_t i = 0; i < n; ++i) {
    writeCode(block.codes.get(), i, block.timeBits, times[i]);
  }
  std::uint8_t* const valueCodes = block.codes.get() + timeBytes;
  for (std::size_t i = 0; i < n; ++i) {
    const double value = points[i].value;
    const std::uint64_t code = valueBits == kWholeBits ? std::bit_cast<std::uint64_t>(value)
                               : std::isnan(value)     ? (std::uint64_t{1} << valueBits) - 1
                                                       : values[i];
    writeCode(valueCodes, i, valueBits, code);
  }
  return block;
}

void PackedPoints::append(const SeriesPoint& point) {
  m_tail[m_size % kBlockSize] = point;
  ++m_size;
  if (m_size % kBlockSize == 0) {
    m_blocks.push_back(pack(m_tail));
    m_codeBytes += m_blocks.back().byteCount;
  }
}

void PackedPoints::clear() {
  m_blocks.clear();
  m_size = 0;
  m_codeBytes = 0;
}

base::Instant PackedPoints::timeAt(std::size_t index) const {
  RIVULET_ASSERT(index < m_size);
  if (index / kBlockSize == m_blocks.size()) {
    return m_tail[index % kBlockSize].at;
  }
  const Block& block = m_blocks[index / kBlockSize];
  const std::size_t i = index % kBlockSize;
  const std::uint64_t ns =
      block.firstNs + i * block.stepNs + readCode(block.codes.get(), i, block.timeBits);
  return base::Instant{base::Duration{static_cast<std::int64_t>(ns)}};
}

double PackedPoints::valueAt(std::size_t index) const {
  RIVULET_ASSERT(index < m_size);
  if (index / kBlockSize == m_blocks.size()) {
    return m_tail[index % kBlockSize].value;
  }
  const Block& block = m_blocks[index / kBlockSize];
  const std::uint64_t code =
      readCode(block.codes.get() + block.valueOffset, index % kBlockSize, block.valueBits);
  if (block.valueBits == kWholeBits) {
    return std::bit_cast<double>(code);
  }
  if (block.hasGaps && code == (std::uint64_t{1} << block.valueBits) - 1) {
    return kNoValue;
  }
  return static_cast<double>(block.base + static_cast<std::int64_t>(code)) /
         kPowers[block.decimals];
}

std::size_t PackedPoints::memoryBytes() const {
  return m_blocks.capacity() * sizeof(Block) + m_codeBytes;
}

}  // namespace rivulet::trace
