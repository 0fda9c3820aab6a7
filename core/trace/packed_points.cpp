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

using Codes = std::array<std::uint64_t, kPackedBlockSize>;

constexpr std::array<double, 10> kPowers{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
/// A code of so many bits is within eight bytes wherever it begins.
constexpr unsigned kCodeBitsMax = 57;
constexpr unsigned kWholeBits = 64;
/// Multiples beyond are not exact in a double, and are not rounded by adding `kRounding`.
constexpr double kMultipleMax = 2251799813685248.0;  // 2^51
/// A double of this size has no decimals: adding and subtracting it rounds to the nearest whole.
constexpr double kRounding = 3.0 * kMultipleMax;

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

std::uint64_t wholeNs(base::Instant at) {
  return static_cast<std::uint64_t>(at.time_since_epoch().count());
}

/// Room for so many codes; null: none is needed. A code is read as eight bytes, also the last one.
template <class Block>
void makeRoom(Block& block) {
  const std::size_t bytes = kPackedBlockSize * block.bits / 8;
  if (bytes > 0) {
    block.byteCount = static_cast<std::uint16_t>(bytes + sizeof(std::uint64_t));
    block.codes = std::make_unique<std::uint8_t[]>(block.byteCount);
  }
}

void writeCodes(std::uint8_t* to, unsigned bits, const Codes& codes) {
  for (std::size_t i = 0; i < codes.size(); ++i) {
    writeCode(to, i, bits, codes[i]);
  }
}

/// Whole multiples of 10^-decimals, as their distance from the smallest.
struct Multiples {
  std::int64_t smallest = 0;
  std::uint64_t range = 0;
  unsigned decimals = 0;
  bool hasGaps = false;
};

/// @return nothing: not all values are such multiples, to the bit
std::optional<Multiples> multiplesOf(std::span<const double, kPackedBlockSize> values,
                                     unsigned decimals, Codes& codes) {
  Multiples found{std::numeric_limits<std::int64_t>::max(), 0, decimals, false};
  std::int64_t largest = std::numeric_limits<std::int64_t>::min();
  const double power = kPowers[decimals];
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = values[i];
    if (std::isnan(value)) {
      found.hasGaps = true;
      continue;
    }
    const double multiple = value * power + kRounding - kRounding;
    // Negated, so that infinity fails. The bits tell -0 from 0.
    if (!(std::abs(multiple) < kMultipleMax) ||
        std::bit_cast<std::uint64_t>(multiple / power) != std::bit_cast<std::uint64_t>(value)) {
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
  for (std::uint64_t& code : codes) {
    code -= static_cast<std::uint64_t>(found.smallest);
  }
  return found;
}

}  // namespace

TimePacking::Block TimePacking::pack(std::span<const Item, kPackedBlockSize> items) {
  Block block;
  Codes codes{};
  const std::uint64_t first = wholeNs(items.front());
  block.stepNs = (wholeNs(items.back()) - first) / (kPackedBlockSize - 1);
  std::int64_t smallest = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    codes[i] = wholeNs(items[i]) - first - i * block.stepNs;
    smallest = std::min(smallest, static_cast<std::int64_t>(codes[i]));
  }
  std::uint64_t range = 0;
  for (std::uint64_t& code : codes) {
    code -= static_cast<std::uint64_t>(smallest);
    range = std::max(range, code);
  }
  block.firstNs = first + static_cast<std::uint64_t>(smallest);
  block.bits = static_cast<std::uint8_t>(bitsFor(range));
  makeRoom(block);
  writeCodes(block.codes.get(), block.bits, codes);
  return block;
}

TimePacking::Item TimePacking::at(const Block& block, std::size_t index) {
  const std::uint64_t ns =
      block.firstNs + index * block.stepNs + readCode(block.codes.get(), index, block.bits);
  return base::Instant{base::Duration{static_cast<std::int64_t>(ns)}};
}

void TimePacking::unpack(const Block& block, Items& items) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    items[i] = at(block, i);
  }
}

ValuePacking::Block ValuePacking::pack(std::span<const Item, kPackedBlockSize> items) {
  Block block;
  Codes codes{};
  std::optional<Multiples> multiples;
  for (unsigned decimals = 0; decimals < kPowers.size() && !multiples; ++decimals) {
    multiples = multiplesOf(items, decimals, codes);
  }
  // The code after the largest stands for a gap.
  unsigned bits = multiples ? bitsFor(multiples->range + (multiples->hasGaps ? 1 : 0)) : kWholeBits;
  if (bits < kWholeBits) {
    block.base = multiples->smallest;
    block.decimals = static_cast<std::uint8_t>(multiples->decimals);
    block.hasGaps = multiples->hasGaps;
  }
  block.bits = static_cast<std::uint8_t>(bits);
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (bits == kWholeBits) {
      codes[i] = std::bit_cast<std::uint64_t>(items[i]);
    } else if (block.hasGaps && std::isnan(items[i])) {
      codes[i] = (std::uint64_t{1} << bits) - 1;
    }
  }
  makeRoom(block);
  writeCodes(block.codes.get(), bits, codes);
  return block;
}

ValuePacking::Item ValuePacking::at(const Block& block, std::size_t index) {
  const std::uint64_t code = readCode(block.codes.get(), index, block.bits);
  if (block.bits == kWholeBits) {
    return std::bit_cast<double>(code);
  }
  if (block.hasGaps && code == (std::uint64_t{1} << block.bits) - 1) {
    return kNoValue;
  }
  return static_cast<double>(block.base + static_cast<std::int64_t>(code)) /
         kPowers[block.decimals];
}

void ValuePacking::unpack(const Block& block, Items& items) {
  if (block.bits == kWholeBits) {
    std::memcpy(items.data(), block.codes.get(), sizeof items);
    return;
  }
  if (block.hasGaps) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      items[i] = at(block, i);
    }
    return;
  }
  if (block.bits == 0) {
    items.fill(at(block, 0));
    return;
  }
  const double power = kPowers[block.decimals];
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::uint64_t code = readCode(block.codes.get(), i, block.bits);
    items[i] = static_cast<double>(block.base + static_cast<std::int64_t>(code)) / power;
  }
}

template <class Packing>
void PackedList<Packing>::push_back(Item item) {
  if (!m_data) {
    m_data = std::make_shared<Data>();
  } else if (m_data.use_count() > 1) {
    const PackedList shared = std::exchange(*this, part(0, size()));
  }
  add(item);
}

template <class Packing>
void PackedList<Packing>::add(Item item) {
  std::vector<Item>& tail = m_data->tail;
  tail.push_back(item);
  ++m_data->size;
  if (tail.size() == kPackedBlockSize) {
    m_data->blocks.push_back(
        Packing::pack(std::span<const Item, kPackedBlockSize>(tail.data(), kPackedBlockSize)));
    m_data->codeBytes += m_data->blocks.back().byteCount;
    tail.clear();
  }
}

template <class Packing>
PackedList<Packing> PackedList<Packing>::part(std::size_t from, std::size_t until) const {
  RIVULET_ASSERT(from <= until && until <= size());
  PackedList items;
  items.m_data = std::make_shared<Data>();
  PackedReader<PackedList> reader(*this);
  for (std::size_t i = from; i < until; ++i) {
    items.add(reader[i]);
  }
  return items;
}

template <class Packing>
std::size_t PackedList<Packing>::memoryBytes() const {
  return m_data ? m_data->blocks.capacity() * sizeof(typename Packing::Block) + m_data->codeBytes +
                      m_data->tail.capacity() * sizeof(Item)
                : 0;
}

template class PackedList<TimePacking>;
template class PackedList<ValuePacking>;

PackedPoints::PackedPoints(PackedTimes at, PackedValues values, base::Instant origin)
    : m_at(std::move(at)), m_values(std::move(values)), m_origin(origin.time_since_epoch()) {
  RIVULET_ASSERT(m_at.size() == m_values.size());
}

void PackedPoints::append(const SeriesPoint& point) {
  m_at.push_back(point.at + m_origin);
  m_values.push_back(point.value);
}

void PackedPoints::clear() {
  m_at.clear();
  m_values.clear();
}

std::size_t PackedPoints::memoryBytes() const {
  return m_at.memoryBytes() + m_values.memoryBytes();
}

}  // namespace rivulet::trace
