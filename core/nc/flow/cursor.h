// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The blocks of a program file in the order of their execution. A program that neither jumps,
/// repeats nor calls is read once from top to end by the lexer; at the first statement that does,
/// the file is made into trees and the flow continues there. @threadsafety one object, one thread.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "nc/dialects/heidenhain/made.h"
#include "nc/eval/variables.h"
#include "nc/flow/flow.h"
#include "nc/limits.h"
#include "nc/syntax/programs.h"

namespace rivulet::nc {

namespace heidenhain {
class Control;
}

/// A subprogram from elsewhere.
struct LoadedText {
  std::string text;
  std::string fileName;  ///< for messages
};

struct CursorOptions {
  /// Blocks with "/" are left out. Only plain text asks here: its blocks change more than the path.
  bool blockSkip = false;
  /// Statements executed beyond the lines of the file before a program counts as endless.
  std::size_t repeatedLinesMax = kRepeatedLinesMax;
  /// The text of a subprogram that is not in the file: by its name in upper case, "O100" for
  /// numbers. Nothing: there is none. May be empty.
  std::function<std::optional<LoadedText>(std::string_view name)> load;
  /// Of the trees, without the text of the program itself.
  base::Budget budget{};
  /// Of the machine on which the program is to run. Only plain text asks: its cycles need it.
  heidenhain::ToolRadius toolRadiusMm;
  /// Outlives the cursor; null: nobody is told of calls.
  CallObserver* calls = nullptr;
};

/// Lines of the program file with blocks that were not executed.
struct Unreached {
  enum class What : std::uint8_t {
    Blocks,       ///< of a program that was executed, or behind its end
    Subprogram,   ///< that nobody called
    MainProgram,  ///< another one
  };
  What what = What::Blocks;
  std::string program;  ///< its name; empty: it has none
  base::LineNumber first;
  base::LineNumber last;
  /// The program decides or jumps by values: with others the blocks might be executed.
  bool dependsOnValues = false;
};

/// What came of a statement or call that was not simply executed.
struct SubprogramMissing {
  std::string name;
};
struct ModalCall {
  std::string name;          ///< MCALL: called after each motion from now on; "": no more
  std::optional<Call> call;  ///< of a program that is at hand
};
struct Ignored {
  std::string word;  ///< no effect on the path
};
struct Unsupported {
  std::string word;
};
using Outcome =
    std::variant<std::monostate, Fault, SubprogramMissing, ModalCall, Ignored, Unsupported>;

class Cursor {
 public:
  enum class Step : std::uint8_t {
    Block,   ///< the words of a block are to be executed
    Report,  ///< a statement was not executed as written: see `outcome`
    End,
  };

  /// @param text, variables, options  outlive the cursor
  Cursor(std::string_view text, Dialect dialect, Variables& variables,
         const CursorOptions& options);
  ~Cursor();
  Cursor(const Cursor&) = delete;
  Cursor& operator=(const Cursor&) = delete;

  [[nodiscard]] Step next();
  /// Of the block that `next` gave; until it is called again.
  [[nodiscard]] const Words& words() const { return *m_words; }
  [[nodiscard]] const Outcome& outcome() const { return m_outcome; }
  /// After the last block: what of the program file was not executed, in the order of the text.
  [[nodiscard]] std::vector<Unreached> unreached() const;

  /// Executes the statement of the block that `next` gave.
  [[nodiscard]] Outcome execute(const Token& statement);
  /// A subprogram that a word of the block calls: PART(1,,A), PART, L123.
  [[nodiscard]] Outcome call(const Token& token, int times);
  /// M98 shares the # variables of the caller; G65 has `numbers` as its own.
  [[nodiscard]] Outcome callNumber(int number, int times,
                                   const std::optional<std::map<int, double>>& numbers);
  /// What MCALL has named.
  [[nodiscard]] Outcome callAgain(const Call& call) { return this->call(Call(call)); }
  /// M97 of Haas: the blocks from N on, up to M99.
  [[nodiscard]] Outcome callBlock(int number, int times);
  /// M17, RET, M99. @return false in the main program
  [[nodiscard]] bool leaveSubprogram() { return m_flow && m_flow->leave(); }
  /// M99 P50: see `Flow::leaveTo`.
  [[nodiscard]] Outcome leaveTo(int number, bool stays);
  [[nodiscard]] bool isInSubprogram() const { return depth() > 1; }
  /// Programs within each other, 1: the main program.
  [[nodiscard]] std::size_t depth() const { return m_flow ? m_flow->depth() : 1; }

  /// The present block is a move that a cycle or a corner of plain text makes.
  [[nodiscard]] bool isMade() const { return m_control && m_made.isMade; }

  /// Where the present block or statement stands.
  [[nodiscard]] Place place() const { return m_place; }
  /// Name of a file of `place`; empty for the program file itself.
  [[nodiscard]] const std::string& fileName(std::uint16_t file) const {
    return file == 0 ? m_sources.front().fileName : m_sources[file].fileName;
  }
  /// The line of the program file in progress; in a subprogram of another file, the line that
  /// called it.
  [[nodiscard]] base::LineNumber line() const { return m_line; }
  /// Statements executed, for the progress.
  [[nodiscard]] std::size_t linesRead() const { return m_executed; }
  /// The line that jumped back last, if the program did not end.
  [[nodiscard]] std::optional<base::LineNumber> endlessLoop() const { return m_endless; }
  /// Statements executed beyond the lines of the file.
  [[nodiscard]] std::size_t repeatedLines() const {
    const std::size_t lines = m_sources.front().programs.lines;
    return m_flow && m_executed > lines ? m_executed - lines : 0;
  }
  /// What the trees take, and the texts of files beside the program, bytes.
  [[nodiscard]] std::uint64_t memoryBytes() const { return m_bytes; }
  /// That is more than the budget: the end came before that of the program.
  [[nodiscard]] bool isCut() const { return m_isCut; }
  /// The file has programs with names, be they empty.
  [[nodiscard]] bool holdsPrograms() const { return !m_sources.front().programs.named.empty(); }
  /// Lines of the program file.
  [[nodiscard]] std::size_t fileLines();

 private:
  struct Source {
    std::string own;  ///< of a file beside the program
    std::string_view text;
    std::string fileName;
    Programs programs;
  };

  /// Of Heidenhain: what its control makes of the next blocks.
  [[nodiscard]] Step nextOfKlartext();
  /// @return false at the end
  [[nodiscard]] bool readKlartextBlock();
  [[nodiscard]] Expected<void> steer(const heidenhain::Steering& steering);
  void grow();
  [[nodiscard]] std::shared_ptr<const Tree> find(const std::string& name);
  /// Makes trees of the text, as far as the budget goes.
  void read(Source& source, std::uint16_t file);
  void setPlace(const Place& place);
  [[nodiscard]] Outcome leave(const Return& with);
  void setReturned(std::optional<double> value);
  [[nodiscard]] Outcome call(Call call);
  [[nodiscard]] Outcome modalCall(Reader& reader, int column);
  [[nodiscard]] static Outcome outcomeOf(Fault fault);

  const Language& m_language;
  Variables& m_variables;
  const CursorOptions& m_options;
  Lexer m_lexer;
  Block m_block;  ///< of the text, as long as there is no tree
  const Words* m_words = &m_block;
  std::deque<Source> m_sources;  ///< the program file first
  std::map<std::string, std::size_t, std::less<>> m_loaded;
  std::unique_ptr<heidenhain::Control> m_control;      ///< of Heidenhain; else null
  heidenhain::Made m_made;                             ///< the present block of `m_control`
  Place m_readPlace;                                   ///< of the block read last
  std::map<std::uint32_t, std::uint64_t> m_jumpsBack;  ///< by line: changes when it was made last
  std::uint64_t m_rounds = 0;                          ///< of repeats and of calls
  base::LineNumber m_readLine;                         ///< of the program file
  bool m_isFinished = false;
  std::optional<Flow> m_flow;  ///< from the first statement on that needs it
  Outcome m_outcome;
  Place m_place;
  base::LineNumber m_line;
  std::size_t m_executed = 0;
  std::uint64_t m_bytes = 0;
  bool m_isCut = false;
  bool m_hasWords = false;      ///< without a tree: a block of the program has been read
  bool m_isAtHeading = false;   ///< without a tree: another program ended this one
  std::vector<bool> m_reached;  ///< with a tree: lines of the program file
  base::LineNumber m_jumpedFrom;
  std::optional<base::LineNumber> m_endless;
};

}  // namespace rivulet::nc
