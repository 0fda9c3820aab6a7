// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Native blocks in the language of LinuxCNC. A plan has them in that of a SINUMERIK, whatever the
/// source was written in: this is the table from there, and nothing beside it. @threadsafety one
/// object, one thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>

#include "nc/syntax/dialect.h"

namespace rivulet::nc {
struct Token;
struct Language;
}  // namespace rivulet::nc

namespace rivulet::job {

/// Goes through the blocks of a job in their order: what stays in force from one to the next is
/// written where it changes.
class LinuxCncText {
 public:
  /// @param source  of the program. What a control does with a compensation of the radius at its
  /// beginning, and with M functions of the machine, differs: only what is the same is translated
  explicit LinuxCncText(nc::Dialect source) : m_source(source) {}

  /// @param text  lines for a SINUMERIK @return lines, empty: LinuxCNC needs none; or the word that
  /// has no translation
  [[nodiscard]] tl::expected<std::string, std::string> convert(std::string_view text);
  /// What follows in machine coordinates is a move to a fixed point of LinuxCNC's own. @param word
  /// "G28" or "G30"; empty: it is not
  void setFixedPoint(std::string word) { m_fixedPoint = std::move(word); }
  /// G41 or G42 is in force.
  [[nodiscard]] bool compensates() const { return m_compensates; }
  /// The loop of the job has been called: G17, G21, G90, G91.1 and G94 are in force.
  void loopCalled();

 private:
  struct Block;
  /// @return the word that has no translation; empty: none
  [[nodiscard]] std::string convertLine(std::string_view line, std::string& out);
  [[nodiscard]] bool take(const nc::Token& token, Block& block);
  [[nodiscard]] bool takeWord(const nc::Token& token, Block& block);
  [[nodiscard]] bool takeG(double number, Block& block);
  [[nodiscard]] bool takeM(int number, Block& block) const;
  [[nodiscard]] static bool takeValue(std::string_view name, const nc::Token& token, Block& block);
  [[nodiscard]] static bool takeName(std::string_view name, Block& block);
  [[nodiscard]] bool takeAxis(char letter, const nc::Token& token, Block& block) const;
  static void setModal(int& inForce, int g, Block& block);

  nc::Dialect m_source;
  std::string m_fixedPoint;
  // G functions in force; 0: not known.
  int m_plane = 0;
  int m_units = 0;
  int m_distance = 0;
  int m_feedMode = 0;
  int m_motion = -1;  ///< as the source has it; -1: not known
  bool m_compensates = false;
};

}  // namespace rivulet::job
