// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sources/pipe_source.h"

#include "platform/input.h"

namespace rivulet::sources {

std::size_t PipeSource::read(std::span<char> into) {
  const platform::Input read = platform::readNow(m_descriptor, into);
  m_isClosed = m_isClosed || read.isAtEnd || read.isBroken;
  return read.bytes;
}

}  // namespace rivulet::sources
