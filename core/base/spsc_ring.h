// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A bounded queue between exactly one producer thread and one consumer thread, without locks.
/// Overflow policy: `tryPush` refuses and counts; the newest value is the one that is lost.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>
#include <utility>

namespace rivulet::base {

template <class T, std::size_t Capacity>
class SpscRing {
  static_assert(Capacity >= 2 && (Capacity & (Capacity - 1)) == 0,
                "the capacity is a power of two, so that indices wrap by a mask");

 public:
  /// @threadsafety producer only. @return false if full; the loss is counted.
  bool tryPush(T value) {
    const std::size_t head = m_head.load(std::memory_order_relaxed);
    if (head - m_tail.load(std::memory_order_acquire) == Capacity) {
      m_lost.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    m_items[head & (Capacity - 1)] = std::move(value);
    m_head.store(head + 1, std::memory_order_release);
    return true;
  }

  /// @threadsafety consumer only. @return the oldest value, nothing if empty.
  std::optional<T> tryPop() {
    const std::size_t tail = m_tail.load(std::memory_order_relaxed);
    if (tail == m_head.load(std::memory_order_acquire)) {
      return std::nullopt;
    }
    T value = std::move(m_items[tail & (Capacity - 1)]);
    m_tail.store(tail + 1, std::memory_order_release);
    return value;
  }

  /// @threadsafety consumer only.
  [[nodiscard]] bool isEmpty() const {
    return m_tail.load(std::memory_order_relaxed) == m_head.load(std::memory_order_acquire);
  }

  /// Values refused because the ring was full. @threadsafety any thread.
  [[nodiscard]] std::size_t lost() const { return m_lost.load(std::memory_order_relaxed); }

 private:
  std::array<T, Capacity> m_items{};
  std::atomic<std::size_t> m_head{0};
  std::atomic<std::size_t> m_tail{0};
  std::atomic<std::size_t> m_lost{0};
};

}  // namespace rivulet::base
