// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Collects the findings of one program: in order, bounded, words without effect only once, and
/// what the user has accepted as warnings. @threadsafety one object, one thread.
#pragma once

#include <bitset>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "gcode/diagnostic.h"
#include "nc/exec/sink.h"

namespace rivulet::gcode {

class Findings final : public nc::FaultSink {
 public:
  /// @param accepted  names as in `acceptableName`; outlives the object
  explicit Findings(const std::vector<std::string>& accepted) : m_accepted(accepted) {}

  /// Where the findings to come belong. @param file  the called file, empty for the program
  ///        itself; outlives the object
  void setPlace(base::LineNumber line, const std::string& file) {
    m_line = line;
    m_file = &file;
  }

  /// @param argument  cut where it is long
  void report(Severity severity, int column, DiagnosticCode code, std::string argument) override;
  void fault(int column, const nc::Fault& fault) override;
  /// A finding about the whole program, listed however many others there are. It stands at the
  /// first line.
  void reportProgram(Severity severity, DiagnosticCode code, std::string argument);
  /// A word without effect on the path is noted at its first place only: a program with M3 S500 in
  /// every block has one such finding, not a thousand that hide the others.
  void ignore(const nc::Token& token, std::string word) override;
  /// The same by number, for the words of which there are millions.
  void ignoreG(int key, const nc::Token& token) override;
  void ignoreM(Severity severity, int number, const nc::Token& token) override;
  void ignoreLetter(const nc::Token& token) override;

  /// The findings, sorted by place. The object is empty afterwards.
  [[nodiscard]] std::vector<Diagnostic> take();

 private:
  void add(Diagnostic found);

  const std::vector<std::string>& m_accepted;
  std::vector<Diagnostic> m_list;
  base::LineNumber m_line;
  const std::string* m_file = nullptr;
  std::bitset<10000> m_ignoredG;
  std::bitset<10000> m_ignoredM;
  std::bitset<10000> m_warnedM;
  std::bitset<26> m_ignoredLetters;
  std::vector<std::string> m_ignoredNames;
  std::vector<std::string> m_acceptedSeen;
  struct Repeats {
    std::size_t first = 0;  ///< in the list
    std::size_t count = 0;
  };
  std::unordered_map<std::string, Repeats> m_repeats;  ///< by what they say
  std::size_t m_suppressed = 0;
  base::LineNumber m_suppressedLine;
  Severity m_suppressedWorst = Severity::Note;
};

}  // namespace rivulet::gcode
