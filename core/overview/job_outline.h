// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The parts of a job by the lines of its program: where a stretch begins, and which lines the
/// control executes itself. Lines of called files are not in it.
/// @threadsafety immutable once made; made outside the GUI thread, in linear time.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "job/plan.h"

namespace rivulet::overview {

class JobOutline {
 public:
  JobOutline() = default;
  /// @param plan  of which the program itself is not needed
  explicit JobOutline(std::shared_ptr<const job::Plan> plan);

  /// The native block in a line, the first if loops execute it several times; null: there is none.
  [[nodiscard]] const job::NativeBlock* nativeAt(std::size_t line) const;
  /// The stretch whose first block stands in a line, the first of several; null: there is none.
  [[nodiscard]] const job::Stretch* stretchAt(std::size_t line) const;
  /// First lines of the parts, ascending, each once. Native blocks in lines that follow each other
  /// are one part.
  [[nodiscard]] const std::vector<std::size_t>& partLines() const { return m_partLines; }
  /// The nearest of these beyond a line. @return 0: there is none
  [[nodiscard]] std::size_t partBeyond(std::size_t line, bool isForward) const;
  [[nodiscard]] std::size_t stretches() const { return m_stretchCount; }
  /// Blocks that the machine needs, in the order of the program: without them the motion of the
  /// program alone makes no part. Not among them are messages, modes of motion and the end.
  [[nodiscard]] const std::vector<const job::NativeBlock*>& needed() const { return m_needed; }

 private:
  struct Entry {
    std::size_t line = 0;
    std::size_t part = 0;  ///< of the plan
  };
  [[nodiscard]] const job::Part* partAt(const std::vector<Entry>& entries, std::size_t line) const;

  std::shared_ptr<const job::Plan> m_plan;
  std::vector<Entry> m_natives;    ///< ascending by line, each line once
  std::vector<Entry> m_stretches;  ///< the same
  std::vector<std::size_t> m_partLines;
  std::vector<const job::NativeBlock*> m_needed;
  std::size_t m_stretchCount = 0;
};

/// The tool that a block selects, as its program names it: "5", "MILL_10"; empty: none.
[[nodiscard]] std::string toolOf(const job::NativeBlock& block);

}  // namespace rivulet::overview
