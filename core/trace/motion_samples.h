// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the axes did, sample by sample, in little memory: column by column as `PackedList` keeps
/// it. A column that is the same in all samples takes nothing.
/// @threadsafety one object, one thread; several may read what nobody appends to, each with a
/// reader of its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

#include "base/instant.h"
#include "base/vec3.h"
#include "trace/packed_points.h"

namespace rivulet::trace {

struct MotionSample {
  base::Instant at{};
  base::Vec3 setMm;       ///< set point; valid if `Motion::hasSet`
  base::Vec3 actualMm;    ///< after the servo; valid if `Motion::hasActual`
  double pathMmPerS = 0;  ///< path speed, of the set point if there is one
  double feedMmPerS = 0;  ///< programmed feed; NaN: not known
  double overrideFactor = 1.0;
  std::uint32_t line = 0;  ///< of the program on the control; 0: none
};

/// What is kept of a sample beside its time.
enum class MotionColumn {
  SetX,
  SetY,
  SetZ,
  ActualX,
  ActualY,
  ActualZ,
  Speed,
  Feed,
  Override,
  Line
};
inline constexpr std::size_t kMotionColumns = 10;

class MotionSamples {
 public:
  /// The values of one column.
  struct Column {
    double constant = 0.0;  ///< of all samples, if there are no values
    PackedValues values{};  ///< one per sample, or none
  };
  using Columns = std::array<Column, kMotionColumns>;

  /// Copies of samples, which are made on the way.
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = MotionSample;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = MotionSample;

    Iterator() = default;
    Iterator(const MotionSamples* samples, std::size_t index)
        : m_samples(samples), m_index(index) {}
    MotionSample operator*() const { return (*m_samples)[m_index]; }
    Iterator& operator++() {
      ++m_index;
      return *this;
    }
    Iterator operator++(int) { return {m_samples, m_index++}; }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.m_index == b.m_index; }

   private:
    const MotionSamples* m_samples = nullptr;
    std::size_t m_index = 0;
  };

  MotionSamples() = default;
  explicit MotionSamples(const std::vector<MotionSample>& samples);
  /// @param columns  in the order of `MotionColumn`; lines are whole numbers
  MotionSamples(PackedTimes at, Columns columns);

  void push_back(const MotionSample& sample);

  [[nodiscard]] std::size_t size() const { return m_at.size(); }
  [[nodiscard]] bool empty() const { return m_at.empty(); }
  /// O(1), but `MotionReader` is much quicker for many. @param index < size()
  [[nodiscard]] MotionSample operator[](std::size_t index) const;
  [[nodiscard]] MotionSample front() const { return (*this)[0]; }
  [[nodiscard]] MotionSample back() const { return (*this)[size() - 1]; }
  [[nodiscard]] Iterator begin() const { return {this, 0}; }
  [[nodiscard]] Iterator end() const { return {this, size()}; }

  [[nodiscard]] const PackedTimes& times() const { return m_at; }
  [[nodiscard]] bool isConstant(MotionColumn column) const {
    return m_columns[static_cast<std::size_t>(column)].values.empty();
  }
  /// As many as there are samples. A column that is packed is not copied.
  [[nodiscard]] PackedValues valuesOf(MotionColumn column) const;
  /// First sample at the instant or later; `size()`: there is none. O(log(size)).
  [[nodiscard]] std::size_t indexAt(base::Instant at) const;

 private:
  friend class MotionReader;
  using Block = std::array<MotionSample, kPackedBlockSize>;

  /// A sample of what does not change.
  [[nodiscard]] MotionSample constants() const;
  /// @param items  hold `constants()`
  void unpack(std::size_t block, Block& items) const;

  PackedTimes m_at;
  Columns m_columns{};
};

/// Reads samples more or less one after another, block by block. What it returns is valid until a
/// sample more than 128 samples away is asked for.
class MotionReader {
 public:
  /// @param samples  must not change meanwhile
  explicit MotionReader(const MotionSamples& samples);

  [[nodiscard]] std::size_t size() const { return m_samples->size(); }
  /// @param index < size()
  [[nodiscard]] const MotionSample& operator[](std::size_t index) {
    const std::size_t block = index / kPackedBlockSize;
    const std::size_t slot = block % kSlots;  // two blocks in succession are there at once
    if (m_blocks[slot] != block) {
      load(block);
    }
    return m_items[slot][index % kPackedBlockSize];
  }

 private:
  static constexpr std::size_t kSlots = 2;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void load(std::size_t block);

  const MotionSamples* m_samples;
  std::array<std::size_t, kSlots> m_blocks{kNone, kNone};
  std::array<MotionSamples::Block, kSlots> m_items;
};

}  // namespace rivulet::trace
