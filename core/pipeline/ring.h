// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A bounded ring buffer of plain bytes between one producer and one consumer, in the memory of one
/// process or in memory that two processes share. Nothing in that memory is believed: each item has
/// its number and a check sum, and both sides keep their own place; what cannot have been written
/// by the other side is refused with a sentence. A producer that dies while it writes leaves
/// nothing.
/// @threadsafety one writer, one reader; each from one thread. No locks, no allocation.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/hash.h"
#include "base/result.h"
#include "pipeline/error.h"

namespace rivulet::pipeline {

inline constexpr std::uint64_t kRingCapacity = 64;
static_assert(std::has_single_bit(kRingCapacity), "places wrap by a mask");

/// Says what is wrong with a ring. @param what  a clause: "item 7 has a wrong check sum"
[[nodiscard]] base::Error ringError(PipelineError code, std::string_view ring,
                                    const std::string& what);

template <class T>
struct RingMemory {
  static_assert(std::is_trivially_copyable_v<T>, "an item is copied byte by byte");
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "processes share no locks");

  struct Slot {
    std::uint64_t number = 0;  ///< of the item, from 0
    std::uint64_t check = 0;
    alignas(T) std::array<char, sizeof(T)> bytes{};

    [[nodiscard]] std::uint64_t sum() const {
      return base::hashOfFile({bytes.data(), bytes.size()}) ^ (number * base::kHashPrime);
    }
  };

  /// Of this type of item in this version.
  static constexpr std::uint64_t kLayout =
      base::hashOf(T::kLayout) ^ (sizeof(Slot) * base::kHashPrime) ^ kRingCapacity;

  std::uint64_t layout = kLayout;
  alignas(64) std::atomic<std::uint64_t> written{0};
  alignas(64) std::atomic<std::uint64_t> taken{0};
  alignas(64) std::array<Slot, kRingCapacity> places{};

  /// How many items are in it; only for display.
  [[nodiscard]] std::uint64_t level() const {
    return written.load(std::memory_order_relaxed) - taken.load(std::memory_order_relaxed);
  }
};

/// Name of a ring in messages: "B3".
template <class T>
[[nodiscard]] constexpr std::string_view ringName() {
  return T::kLayout.substr(0, 2);
}

template <class T>
class RingWriter {
 public:
  /// @param memory  outlives the writer @return RingLayout
  [[nodiscard]] static base::Result<RingWriter> open(RingMemory<T>& memory) {
    if (memory.layout != RingMemory<T>::kLayout) {
      return base::fail(
          ringError(PipelineError::RingLayout, ringName<T>(), "it has another layout"));
    }
    return RingWriter(memory);
  }

  /// @return false if it is full; RingRubbish
  [[nodiscard]] base::Result<bool> push(const T& item) {
    const std::uint64_t taken = m_memory->taken.load(std::memory_order_acquire);
    if (m_memory->written.load(std::memory_order_relaxed) != m_written || taken > m_written ||
        m_written - taken > kRingCapacity) {
      return base::fail(ringError(PipelineError::RingRubbish, ringName<T>(),
                                  "its counts are not those of its two tasks"));
    }
    if (m_written - taken == kRingCapacity) {
      return false;
    }
    typename RingMemory<T>::Slot& slot = m_memory->places[m_written & (kRingCapacity - 1)];
    slot.number = m_written;
    std::memcpy(slot.bytes.data(), &item, sizeof(T));
    slot.check = slot.sum();
    m_memory->written.store(++m_written, std::memory_order_release);
    return true;
  }

 private:
  explicit RingWriter(RingMemory<T>& memory) : m_memory(&memory), m_written(memory.written) {}

  RingMemory<T>* m_memory;
  std::uint64_t m_written;
};

template <class T>
class RingReader {
 public:
  /// @param memory  outlives the reader @return RingLayout
  [[nodiscard]] static base::Result<RingReader> open(RingMemory<T>& memory) {
    if (memory.layout != RingMemory<T>::kLayout) {
      return base::fail(
          ringError(PipelineError::RingLayout, ringName<T>(), "it has another layout"));
    }
    return RingReader(memory);
  }

  /// @return nothing if it is empty; RingRubbish
  [[nodiscard]] base::Result<std::optional<T>> pop() {
    const std::uint64_t written = m_memory->written.load(std::memory_order_acquire);
    if (m_memory->taken.load(std::memory_order_relaxed) != m_taken || written < m_taken ||
        written - m_taken > kRingCapacity) {
      return base::fail(ringError(PipelineError::RingRubbish, ringName<T>(),
                                  "its counts are not those of its two tasks"));
    }
    if (written == m_taken) {
      return std::optional<T>{};
    }
    // A copy first: what is checked must be what is used.
    const typename RingMemory<T>::Slot slot = m_memory->places[m_taken & (kRingCapacity - 1)];
    if (slot.number != m_taken || slot.check != slot.sum()) {
      return base::fail(ringError(PipelineError::RingRubbish, ringName<T>(),
                                  "item " + std::to_string(m_taken) + " has a wrong check sum"));
    }
    std::optional<T> item(std::in_place);
    std::memcpy(static_cast<void*>(&*item), slot.bytes.data(), sizeof(T));
    m_memory->taken.store(++m_taken, std::memory_order_release);
    return item;
  }

 private:
  explicit RingReader(RingMemory<T>& memory) : m_memory(&memory), m_taken(memory.taken) {}

  RingMemory<T>* m_memory;
  std::uint64_t m_taken;
};

}  // namespace rivulet::pipeline
