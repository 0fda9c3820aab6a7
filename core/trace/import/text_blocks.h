// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A text block by block, each with whole lines: a table may be larger than the memory.
/// @threadsafety one thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/budget.h"
#include "base/byte_source.h"
#include "base/executor.h"
#include "base/result.h"

namespace rivulet::trace {

class TextBlocks {
 public:
  /// Bytes of a block, unless a line is longer.
  static constexpr std::size_t kBlockBytes = std::size_t{8} << 20U;

  virtual ~TextBlocks() = default;
  /// The beginning of the text, at least a block, as long as this object lives.
  [[nodiscard]] virtual std::string_view beginning() const = 0;
  /// The next block, until the next call; nothing: there is none.
  /// @return error Unreadable; BudgetError::Exceeded: a line is too long
  [[nodiscard]] virtual base::Result<std::optional<std::string_view>> next() = 0;
  /// Begins again with the first block.
  virtual void rewind() = 0;
};

/// Of a text in memory.
class BlocksInMemory final : public TextBlocks {
 public:
  explicit BlocksInMemory(std::string_view text) : m_text(text), m_rest(text) {}

  [[nodiscard]] std::string_view beginning() const override { return m_text; }
  [[nodiscard]] base::Result<std::optional<std::string_view>> next() override;
  void rewind() override { m_rest = m_text; }

 private:
  std::string_view m_text;
  std::string_view m_rest;
};

/// Of a file that is read again for each pass.
class BlocksInFile final : public TextBlocks {
 public:
  /// @param bytes   must live as long  @param begin  of the text in it
  /// @param budget  of the longest line  @return error Unreadable
  [[nodiscard]] static base::Result<BlocksInFile> open(base::ByteSource& bytes, std::uint64_t begin,
                                                       const base::Budget& budget);

  [[nodiscard]] std::string_view beginning() const override { return m_first; }
  [[nodiscard]] base::Result<std::optional<std::string_view>> next() override;
  void rewind() override { m_at = m_begin; }

 private:
  BlocksInFile(base::ByteSource& bytes, std::uint64_t begin, const base::Budget& budget)
      : m_bytes(&bytes), m_begin(begin), m_at(begin), m_budget(budget) {}

  base::ByteSource* m_bytes;
  std::uint64_t m_begin;
  std::uint64_t m_at;
  base::Budget m_budget;
  std::string m_first;
  std::string m_block;
};

/// Parts of a block that together are the block, each with whole lines, for several threads.
[[nodiscard]] std::vector<std::string_view> partsOf(std::string_view block);

/// What has to be known of a text before it is read.
struct TextFacts {
  bool isUtf8 = true;
  bool hasNull = false;  ///< the byte 0, which no text has
  std::size_t longestLine = 0;
};
/// Of all blocks from the next one on. @return errors of `TextBlocks::next`
[[nodiscard]] base::Result<TextFacts> factsOf(TextBlocks& blocks, base::Executor& executor);

/// Bytes beyond ASCII come in sequences as UTF-8 has them. The last one may be cut.
[[nodiscard]] bool isUtf8(std::string_view bytes);

}  // namespace rivulet::trace
