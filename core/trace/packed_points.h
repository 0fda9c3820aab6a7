// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The samples of signals in little memory, without loss. Blocks of 128 keep times as differences
/// from equal steps, and values as whole multiples of a power of ten where they are such, as traces
/// of controls are: 1 to 3 bytes per sample. Other values need 8 bytes.
/// @threadsafety one object, one thread; several may read what nobody appends to.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/contract.h"
#include "base/instant.h"

namespace rivulet::trace {

struct SeriesPoint {
  base::Instant at{};
  double value = 0.0;  ///< NaN: the signal has a gap here, the line is interrupted

  friend bool operator==(const SeriesPoint&, const SeriesPoint&) = default;
};

inline constexpr std::size_t kPackedBlockSize = 128;

/// How a block of times is packed: first + i * step + code.
struct TimePacking {
  using Item = base::Instant;
  struct Block {
    std::uint64_t firstNs = 0;  ///< calculated modulo 2^64
    std::uint64_t stepNs = 0;
    std::unique_ptr<std::uint8_t[]> codes;
    std::uint16_t byteCount = 0;
    std::uint8_t bits = 0;  ///< of one code
  };
  using Items = std::array<Item, kPackedBlockSize>;

  [[nodiscard]] static Block pack(std::span<const Item, kPackedBlockSize> items);
  [[nodiscard]] static Item at(const Block& block, std::size_t index);
  static void unpack(const Block& block, Items& items);
};

/// How a block of values is packed: (base + code) / 10^decimals, or as they are.
struct ValuePacking {
  using Item = double;
  struct Block {
    std::int64_t base = 0;
    std::unique_ptr<std::uint8_t[]> codes;
    std::uint16_t byteCount = 0;
    std::uint8_t bits = 0;  ///< of one code; 64: the double itself
    std::uint8_t decimals = 0;
    bool hasGaps = false;  ///< the largest code is a NaN
  };
  using Items = std::array<Item, kPackedBlockSize>;

  [[nodiscard]] static Block pack(std::span<const Item, kPackedBlockSize> items);
  [[nodiscard]] static Item at(const Block& block, std::size_t index);
  static void unpack(const Block& block, Items& items);
};

/// A list that grows at its end. A copy shares what it holds until one of both is appended to.
template <class Packing>
class PackedList {
 public:
  using Item = typename Packing::Item;
  using value_type = Item;

  class Iterator {
   public:
    using iterator_category = std::random_access_iterator_tag;
    using value_type = Item;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = Item;

    Iterator() = default;
    Iterator(const PackedList* list, std::size_t index) : m_list(list), m_index(index) {}
    Item operator*() const { return (*m_list)[m_index]; }
    Item operator[](difference_type by) const { return *(*this + by); }
    Iterator& operator+=(difference_type by) {
      m_index += static_cast<std::size_t>(by);
      return *this;
    }
    Iterator& operator-=(difference_type by) { return *this += -by; }
    Iterator& operator++() { return *this += 1; }
    Iterator& operator--() { return *this -= 1; }
    Iterator operator++(int) { return std::exchange(*this, *this + 1); }
    Iterator operator--(int) { return std::exchange(*this, *this - 1); }
    friend Iterator operator+(Iterator from, difference_type by) { return from += by; }
    friend Iterator operator+(difference_type by, Iterator from) { return from += by; }
    friend Iterator operator-(Iterator from, difference_type by) { return from -= by; }
    friend difference_type operator-(const Iterator& a, const Iterator& b) {
      return static_cast<difference_type>(a.m_index) - static_cast<difference_type>(b.m_index);
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.m_index == b.m_index; }
    friend auto operator<=>(const Iterator& a, const Iterator& b) {
      return a.m_index <=> b.m_index;
    }

   private:
    const PackedList* m_list = nullptr;
    std::size_t m_index = 0;
  };

  PackedList() = default;
  template <class List>
  explicit PackedList(const List& items) {
    for (const Item& item : items) {
      push_back(item);
    }
  }

  void push_back(Item item);
  void clear() { m_data.reset(); }

  [[nodiscard]] std::size_t size() const { return m_data ? m_data->size : 0; }
  [[nodiscard]] bool empty() const { return size() == 0; }
  /// O(1); `PackedReader` is quicker for one after another. @param index < size()
  [[nodiscard]] Item operator[](std::size_t index) const {
    RIVULET_ASSERT(index < size());
    const std::size_t block = index / kPackedBlockSize;
    const std::size_t within = index % kPackedBlockSize;
    return block == m_data->blocks.size() ? m_data->tail[within]
                                          : Packing::at(m_data->blocks[block], within);
  }
  [[nodiscard]] Item front() const { return (*this)[0]; }
  [[nodiscard]] Item back() const { return (*this)[size() - 1]; }
  [[nodiscard]] Iterator begin() const { return {this, 0}; }
  [[nodiscard]] Iterator end() const { return {this, size()}; }
  /// @param block  the items from kPackedBlockSize * block on, as far as there are so many
  void unpack(std::size_t block, typename Packing::Items& items) const {
    if (block == m_data->blocks.size()) {
      std::copy(m_data->tail.begin(), m_data->tail.end(), items.begin());
    } else {
      Packing::unpack(m_data->blocks[block], items);
    }
  }
  /// The items [from, until).
  [[nodiscard]] PackedList part(std::size_t from, std::size_t until) const;
  /// Both are copies of one list: their items are the same.
  [[nodiscard]] bool sharesWith(const PackedList& other) const { return m_data == other.m_data; }
  /// Of the items, without the object itself; of copies, each says the same.
  [[nodiscard]] std::size_t memoryBytes() const;

 private:
  struct Data {
    std::vector<typename Packing::Block> blocks;
    std::vector<Item> tail;  ///< of a block that is not full
    std::size_t size = 0;
    std::size_t codeBytes = 0;
  };

  void add(Item item);

  std::shared_ptr<Data> m_data;  ///< null: empty
};

using PackedTimes = PackedList<TimePacking>;
using PackedValues = PackedList<ValuePacking>;
extern template class PackedList<TimePacking>;
extern template class PackedList<ValuePacking>;

/// Reads a list block by block: for whoever needs its items more or less one after another.
template <class List>
class PackedReader {
 public:
  /// @param list  must not change meanwhile
  explicit PackedReader(const List& list) : m_list(&list) {}

  [[nodiscard]] std::size_t size() const { return m_list->size(); }
  /// @param index < size()
  [[nodiscard]] typename List::Item operator[](std::size_t index) {
    const std::size_t block = index / kPackedBlockSize;
    const std::size_t slot = block % kSlots;  // two blocks in succession are there at once
    if (m_blocks[slot] != block) {
      RIVULET_ASSERT(index < m_list->size());
      m_list->unpack(block, m_items[slot]);
      m_blocks[slot] = block;
    }
    return m_items[slot][index % kPackedBlockSize];
  }

 private:
  static constexpr std::size_t kSlots = 2;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  const List* m_list;
  std::array<std::size_t, kSlots> m_blocks{kNone, kNone};
  std::array<std::array<typename List::Item, kPackedBlockSize>, kSlots> m_items{};
};

/// Times and values of one signal.
class PackedPoints {
 public:
  PackedPoints() = default;
  /// @param at, values  of the same length  @param origin  becomes the beginning of time
  PackedPoints(PackedTimes at, PackedValues values, base::Instant origin);

  void append(const SeriesPoint& point);
  void clear();

  [[nodiscard]] std::size_t size() const { return m_values.size(); }
  [[nodiscard]] bool empty() const { return m_values.empty(); }
  /// O(1). @param index < size()
  [[nodiscard]] SeriesPoint operator[](std::size_t index) const {
    return {timeAt(index), valueAt(index)};
  }
  [[nodiscard]] base::Instant timeAt(std::size_t index) const { return m_at[index] - m_origin; }
  [[nodiscard]] double valueAt(std::size_t index) const { return m_values[index]; }
  [[nodiscard]] const PackedValues& values() const { return m_values; }
  /// Of the samples, without the object itself.
  [[nodiscard]] std::size_t memoryBytes() const;

 private:
  PackedTimes m_at;
  PackedValues m_values;
  base::Duration m_origin{};
};

}  // namespace rivulet::trace
