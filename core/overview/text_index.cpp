// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overview/text_index.h"

#include <algorithm>

#include "base/contract.h"

namespace rivulet::overview {

bool isUtf8(std::string_view bytes) {
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  for (std::size_t i = 0; i < bytes.size();) {
    const unsigned char lead = at(i);
    if (lead < 0x80) {
      ++i;
      continue;
    }
    // The bounds of the second byte shut out overlong forms and surrogates.
    std::size_t more = 0;
    unsigned char low = 0x80;
    unsigned char high = 0xBF;
    if (lead >= 0xC2 && lead <= 0xDF) {
      more = 1;
    } else if (lead >= 0xE0 && lead <= 0xEF) {
      more = 2;
      low = lead == 0xE0 ? 0xA0 : low;
      high = lead == 0xED ? 0x9F : high;
    } else if (lead >= 0xF0 && lead <= 0xF4) {
      more = 3;
      low = lead == 0xF0 ? 0x90 : low;
      high = lead == 0xF4 ? 0x8F : high;
    } else {
      return false;
    }
    if (i + more >= bytes.size() || at(i + 1) < low || at(i + 1) > high) {
      return false;
    }
    for (std::size_t k = 2; k <= more; ++k) {
      if (at(i + k) < 0x80 || at(i + k) > 0xBF) {
        return false;
      }
    }
    i += more + 1;
  }
  return true;
}

TextIndex::TextIndex(std::string_view text) : m_isUtf8(overview::isUtf8(text)) {
  RIVULET_ASSERT(text.size() < 0xFFFF'FFFFU);
  std::size_t start = 0;
  const auto add = [&](std::size_t end) {
    m_starts.push_back(static_cast<std::uint32_t>(start));
    m_longestBytes = std::max(m_longestBytes, end - start);
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n' || text[i] == '\r') {
      add(i);
      if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') {
        ++i;
      }
      start = i + 1;
    }
  }
  if (start < text.size()) {
    add(text.size());
  }
  m_starts.shrink_to_fit();
}

std::string_view TextIndex::line(std::string_view text, std::size_t line) const {
  RIVULET_ASSERT(line < m_starts.size());
  const std::size_t start = m_starts[line];
  std::size_t end = line + 1 < m_starts.size() ? m_starts[line + 1] : text.size();
  // At most one line end belongs to the line.
  if (end > start && text[end - 1] == '\n') {
    --end;
    if (end > start && text[end - 1] == '\r') {
      --end;
    }
  } else if (end > start && text[end - 1] == '\r') {
    --end;
  }
  return text.substr(start, end - start);
}

}  // namespace rivulet::overview
