// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Follows a program block by block while it is interpreted, and may take a block out of the path.
/// @threadsafety one object, one thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "gcode/program.h"
#include "nc/eval/variables.h"
#include "nc/exec/executor.h"
#include "nc/exec/sink.h"
#include "nc/fault.h"
#include "nc/syntax/language.h"
#include "nc/syntax/lexer.h"

namespace rivulet::gcode {

/// A block in the order of its execution.
struct SourceBlock {
  nc::Place place;
  const std::string& fileName;        ///< of a called file; empty: the program itself
  std::string_view text;              ///< its line as written, without the line end
  std::span<const nc::Token> tokens;  ///< empty: a statement of its own
  bool isInSubprogram = false;
  const nc::Variables& variables;  ///< as they are before the block
};

class BlockObserver {
 public:
  virtual ~BlockObserver() = default;
  /// Called once, first. @param own  outlives the observation
  /// @return what gets the moves and faults instead; they decide what `own` gets
  [[nodiscard]] virtual nc::Sinks observe(const nc::Language& language, nc::Sinks own) = 0;
  virtual void begin(const SourceBlock& block, nc::Executor& executor) = 0;
  /// The words have taken effect. Calls and the end of the program have not.
  virtual void executed(const nc::BlockWords& words, nc::Executor& executor) = 0;
  /// MCALL. @param name  empty: no more
  virtual void modalCall(std::string_view name) = 0;
  /// @param points  of the trajectory so far
  virtual void end(nc::Executor& executor, std::size_t points) = 0;
  /// Blocks that it has left to the control.
  [[nodiscard]] virtual std::size_t nativeBlocks() const { return 0; }
  /// What it holds, bytes.
  [[nodiscard]] virtual std::size_t memoryBytes() const { return 0; }
  /// False: one of them may have changed the frame in a way that is not followed.
  [[nodiscard]] virtual bool knowsFrame() const { return true; }
  /// After the last block. A curve may have ended there.
  virtual void finish(std::size_t points) = 0;
};

/// As `interpretProgram` without an observer.
[[nodiscard]] base::Result<Program> interpretProgram(std::string name, std::string text,
                                                     const LoadOptions& options,
                                                     BlockObserver* observer);

/// The same of a program that has been read. The result has no text: it is that of `read`.
[[nodiscard]] base::Result<Program> interpretAgain(const Program& read, const LoadOptions& options,
                                                   BlockObserver& observer);

/// Where `loadProgram` looks for the subprograms of a file: in its folder.
[[nodiscard]] std::function<std::optional<nc::LoadedText>(std::string_view name)> subprogramsBeside(
    const std::filesystem::path& file);

}  // namespace rivulet::gcode
