// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/import/text_blocks.h"

#include <algorithm>
#include <cstring>

namespace rivulet::trace {

namespace {

/// Parts of a block: more than there are cores, so that none waits long for another one.
constexpr std::size_t kPartBytes = TextBlocks::kBlockBytes / 8;

/// The end of the last whole line that ends at `bytes` or before, or of the first line.
std::size_t lineEnd(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes) {
    return text.size();
  }
  std::size_t end = text.rfind('\n', bytes - 1);
  if (end == std::string_view::npos) {
    end = text.find('\n', bytes);
  }
  return end == std::string_view::npos ? text.size() : end + 1;
}

bool isAscii(const char* bytes) {
  constexpr std::uint64_t kHighBits = 0x8080808080808080;
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  return (word & kHighBits) == 0;
}

TextFacts factsOf(std::string_view part) {
  TextFacts facts;
  facts.isUtf8 = isUtf8(part);
  facts.hasNull = part.find('\0') != std::string_view::npos;
  while (!part.empty()) {
    const std::size_t end = std::min(part.find('\n'), part.size());
    facts.longestLine = std::max(facts.longestLine, end);
    part.remove_prefix(std::min(end + 1, part.size()));
  }
  return facts;
}

}  // namespace

bool isUtf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    while (i + sizeof(std::uint64_t) <= bytes.size() && isAscii(bytes.data() + i)) {
      i += sizeof(std::uint64_t);
    }
    if (i == bytes.size()) {
      return true;
    }
    const auto first = static_cast<unsigned char>(bytes[i]);
    const int more = first < 0x80                    ? 0
                     : first >= 0xC2 && first < 0xE0 ? 1
                     : first >= 0xE0 && first < 0xF0 ? 2
                     : first >= 0xF0 && first < 0xF5 ? 3
                                                     : -1;
    if (more < 0) {
      return false;
    }
    // A file may be cut within its last character.
    for (int left = more; left > 0 && i + 1 < bytes.size(); --left) {
      if ((static_cast<unsigned char>(bytes[++i]) & 0xC0U) != 0x80U) {
        return false;
      }
    }
  }
  return true;
}

base::Result<std::optional<std::string_view>> BlocksInMemory::next() {
  if (m_rest.empty()) {
    return std::nullopt;
  }
  const std::string_view block = m_rest.substr(0, lineEnd(m_rest, kBlockBytes));
  m_rest.remove_prefix(block.size());
  return block;
}

base::Result<BlocksInFile> BlocksInFile::open(base::ByteSource& bytes, std::uint64_t begin,
                                              const base::Budget& budget) {
  auto first = bytes.read(begin, kBlockBytes);
  if (!first) {
    return base::fail(first.error());
  }
  BlocksInFile blocks(bytes, begin, budget);
  blocks.m_first = std::move(*first);
  return blocks;
}

base::Result<std::optional<std::string_view>> BlocksInFile::next() {
  m_block.clear();
  while (m_at + m_block.size() < m_bytes->size()) {
    if (m_block.size() > m_budget.left()) {
      return base::fail(m_budget.exceeded("A row of the table"));
    }
    auto more = m_bytes->read(m_at + m_block.size(), std::max(kBlockBytes, m_block.size()));
    if (!more) {
      return base::fail(more.error());
    }
    if (more->empty()) {
      break;  // the file has become shorter
    }
    m_block = m_block.empty() ? std::move(*more) : m_block + *more;
    const bool isLast = m_at + m_block.size() >= m_bytes->size();
    const std::size_t end = isLast ? m_block.size() : m_block.rfind('\n') + 1;
    if (end > 0) {
      m_at += end;
      return std::string_view(m_block).substr(0, end);
    }
  }
  if (m_block.empty()) {
    return std::nullopt;
  }
  m_at += m_block.size();
  return m_block;
}

std::vector<std::string_view> partsOf(std::string_view block) {
  std::vector<std::string_view> parts;
  while (!block.empty()) {
    parts.push_back(block.substr(0, lineEnd(block, kPartBytes)));
    block.remove_prefix(parts.back().size());
  }
  return parts;
}

base::Result<TextFacts> factsOf(TextBlocks& blocks, base::Executor& executor) {
  TextFacts facts;
  for (;;) {
    const auto block = blocks.next();
    if (!block) {
      return base::fail(block.error());
    }
    if (!*block) {
      return facts;
    }
    const std::vector<std::string_view> parts = partsOf(**block);
    std::vector<TextFacts> ofParts(parts.size());
    executor.forEach(parts.size(), [&](std::size_t part) { ofParts[part] = factsOf(parts[part]); });
    for (const TextFacts& of : ofParts) {
      facts.isUtf8 = facts.isUtf8 && of.isUtf8;
      facts.hasNull = facts.hasNull || of.hasNull;
      facts.longestLine = std::max(facts.longestLine, of.longestLine);
    }
  }
}

}  // namespace rivulet::trace
