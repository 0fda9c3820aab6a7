// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// In which order the lines of a program are executed: jumps, loops, conditions and subprograms of
/// the dialects. A program without any of them is read once from top to end and costs nothing here.
/// @threadsafety one object, one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gcode/calculator.h"
#include "gcode/diagnostic.h"
#include "gcode/lexer.h"
#include "gcode/program.h"

namespace rivulet::gcode {

class Flow {
 public:
  /// What came of a statement or call.
  struct Outcome {
    enum class Kind {
      Done,       ///< executed; the next block is where it led
      Fault,      ///< `code` and `argument` say why it was not
      Ignored,    ///< no effect on the path; `argument` is the word
      ModalCall,  ///< MCALL: `argument` is called behind each motion from now on; "": no more
    };
    Kind kind = Kind::Done;
    DiagnosticCode code = DiagnosticCode::FlowFault;
    std::string argument;
  };

  /// @param text, calculator, options  outlive the flow
  Flow(std::string_view text, Dialect dialect, Calculator& calculator, const LoadOptions& options);

  /// The next block to execute. @return false at the end of the program
  [[nodiscard]] bool next(Block& block);
  /// The next block of the program file behind its end, for a look at what is not executed.
  /// @return false at the end, and where jumps or calls may have used what stands there
  [[nodiscard]] bool nextBehindEnd(Block& block) { return !m_hasJumped && m_lexer.next(block); }
  /// The line of the program file that is under way; in a subprogram of another file, the line
  /// that called it.
  [[nodiscard]] base::LineNumber line() const { return m_line; }
  /// Lines of the program file seen from the top, for the progress.
  [[nodiscard]] std::size_t linesRead() const { return m_executed; }
  /// Why the execution ended before the end, if it did.
  [[nodiscard]] const std::optional<Outcome>& stopped() const { return m_stopped; }
  /// Where `stopped` belongs.
  [[nodiscard]] base::LineNumber stoppedLine() const { return m_stoppedLine; }
  /// Lines of the program file.
  [[nodiscard]] std::size_t fileLines();

  [[nodiscard]] Outcome execute(std::string_view statement);
  /// @param name  upper case  @param arguments  text between the brackets, or empty
  [[nodiscard]] Outcome call(const std::string& name, std::string_view arguments, int times);
  /// M98 P and G65 P of the ISO dialects. @param numbers  #1 and on for the subprogram
  [[nodiscard]] Outcome callNumber(int number, int times, std::map<int, double> numbers);
  /// M17, RET, M99. @return false in the main program
  [[nodiscard]] bool leaveSubprogram();
  [[nodiscard]] bool isInSubprogram() const { return m_levels.size() > 1; }

 private:
  struct Source {
    std::string own;  ///< of a file beside the program
    std::string_view text;
    bool isFile = false;  ///< the program file itself
    bool indexed = false;
    std::multimap<std::string, Place, std::less<>> labels;
    std::multimap<int, Place> numbers;
    std::map<std::string, Place, std::less<>> subprograms;
  };
  struct Control {
    enum class Kind { While, For, Loop, Repeat, Do, Times };
    Kind kind = Kind::Loop;
    std::string id;  ///< of an O word or DO number
    Place head;      ///< While: of its line; others: of the line behind it
    std::string variable;
    double limit = 0.0;
    int left = 0;
  };
  struct Level {
    Source* source = nullptr;
    Place back;    ///< where the caller goes on
    Place entry;   ///< for further rounds
    int left = 1;  ///< rounds to go, this one included
    std::vector<Control> controls;
    std::map<const char*, int> repeats;  ///< REPEAT LABEL under way: rounds left
    std::optional<std::string> arguments;
    Scope scope;  ///< as at the call, for further rounds
  };

  /// Steps over a line without executing it; it counts like one that is.
  [[nodiscard]] std::optional<std::string_view> passLine();
  /// True in text that is not the program file's own.
  [[nodiscard]] bool isElsewhere() const;
  [[nodiscard]] Level& level() { return m_levels.back(); }
  void index(Source& source);
  void jump(Place target);
  void enter(Source& source, Place entry, int times, Scope scope,
             std::optional<std::string> arguments);
  [[nodiscard]] std::optional<std::pair<Source*, Place>> findSubprogram(const std::string& name);
  [[nodiscard]] Outcome fault(DiagnosticCode code, std::string argument);
  [[nodiscard]] Outcome calculationFault();
  /// Goes behind the line that closes the structure just opened, or to an alternative of it.
  /// @return the word that was found; empty: none, see the fault
  [[nodiscard]] std::string skipStructure(std::string_view open, std::string_view close,
                                          std::string_view alternative);
  /// The same for structures with a number or name of their own.
  [[nodiscard]] std::string skipNumbered(const std::string& id,
                                         const std::vector<std::string_view>& words);
  [[nodiscard]] Outcome goTo(std::string_view kind, std::string_view& rest);
  [[nodiscard]] Outcome sinumerik(const std::string& word, std::string_view rest);
  [[nodiscard]] Outcome condition(std::string_view rest);
  [[nodiscard]] Outcome loopEnd(const std::string& word, std::string_view rest);
  [[nodiscard]] Outcome repeat(std::string_view rest);
  [[nodiscard]] Outcome caseOf(std::string_view rest);
  [[nodiscard]] Outcome procedure(std::string_view rest);
  [[nodiscard]] Outcome iso(const std::string& word, std::string_view rest);
  [[nodiscard]] Outcome oWord(std::string_view statement);
  [[nodiscard]] Outcome oCall(const std::string& id, std::string_view rest);

  Dialect m_dialect;
  Calculator& m_calculator;
  const LoadOptions& m_options;
  std::deque<Source> m_sources;
  std::vector<Level> m_levels;
  Lexer m_lexer;
  Place m_current;  ///< of the line under way
  base::LineNumber m_line;
  std::size_t m_executed = 0;
  std::size_t m_fileLines = 0;
  bool m_hasJumped = false;
  std::optional<Outcome> m_stopped;
  base::LineNumber m_stoppedLine;
  base::LineNumber m_jumpedFrom;
};

}  // namespace rivulet::gcode
