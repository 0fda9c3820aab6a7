// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "live/line_reader.h"

namespace rivulet::live {

void LineReader::add(std::string_view bytes) {
  m_bytes.erase(0, m_begin);
  m_begin = 0;
  m_bytes.append(bytes);
}

std::optional<std::string_view> LineReader::next() {
  const std::size_t end = m_bytes.find('\n', m_begin);
  if (end == std::string::npos) {
    return std::nullopt;
  }
  std::string_view line = std::string_view(m_bytes).substr(m_begin, end - m_begin);
  m_begin = end + 1;
  if (!line.empty() && line.back() == '\r') {
    line.remove_suffix(1);
  }
  return line;
}

bool LineReader::hasLine() const {
  return m_bytes.find('\n', m_begin) != std::string::npos;
}

std::string_view LineReader::rest() const {
  return std::string_view(m_bytes).substr(m_begin);
}

}  // namespace rivulet::live
