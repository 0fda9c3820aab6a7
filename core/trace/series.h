// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Storage that only grows, in chunks: appending never moves existing values, so a long run causes
/// no sudden copy of everything. @threadsafety one object, one thread.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "base/contract.h"

namespace rivulet::trace {

template <class T, std::size_t ChunkSize = 4096>
class Series {
  static_assert(ChunkSize > 0 && (ChunkSize & (ChunkSize - 1)) == 0,
                "the chunk's size is a power of two, so that an index splits without a division");

 public:
  void append(const T& value) {
    if (m_size % ChunkSize == 0) {
      m_chunks.push_back(std::make_unique<std::array<T, ChunkSize>>());
    }
    (*m_chunks.back())[m_size % ChunkSize] = value;
    ++m_size;
  }

  /// @param index < size()
  [[nodiscard]] const T& operator[](std::size_t index) const {
    RIVULET_ASSERT(index < m_size);
    return (*m_chunks[index / ChunkSize])[index % ChunkSize];
  }
  [[nodiscard]] std::size_t size() const { return m_size; }
  [[nodiscard]] bool empty() const { return m_size == 0; }
  void clear() {
    m_chunks.clear();
    m_size = 0;
  }

 private:
  std::vector<std::unique_ptr<std::array<T, ChunkSize>>> m_chunks;
  std::size_t m_size = 0;
};

}  // namespace rivulet::trace
