// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A live source over standard input. @threadsafety one object, one thread; nothing waits.
#pragma once

#include <string>

#include "live/source.h"

namespace rivulet::sources {

/// Standard input. Its end is the end of the points.
class PipeSource final : public live::Source {
 public:
  explicit PipeSource(int descriptor) : m_descriptor(descriptor) {}
  std::string name() const override { return "standard input"; }
  std::size_t read(std::span<char> into) override;
  bool isClosed() const override { return m_isClosed; }
  bool endsByClosing() const override { return true; }

 private:
  int m_descriptor;  ///< not ours to close
  bool m_isClosed = false;
};

}  // namespace rivulet::sources
