// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A socket that is closed when it goes out of scope, and sending that never waits.
/// @threadsafety one object, one thread.
#pragma once

#include <string_view>
#include <utility>

namespace rivulet::sources {

class Descriptor {
 public:
  Descriptor() = default;
  /// @param number  below 0: none
  explicit Descriptor(int number) : m_number(number) {}
  Descriptor(Descriptor&& other) noexcept : m_number(std::exchange(other.m_number, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(m_number, other.m_number);
    return *this;
  }
  ~Descriptor();

  [[nodiscard]] int number() const { return m_number; }
  [[nodiscard]] bool isOpen() const { return m_number >= 0; }

 private:
  int m_number = -1;
};

/// Sends what there is room for; a line that does not fit is left out as a whole, unless a part of
/// it has gone. @return false: the other side is gone
bool sendNow(int descriptor, std::string_view line);

}  // namespace rivulet::sources
