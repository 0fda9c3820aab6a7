// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The words, numbers and formulas of one plain-text block, read from its front. A number is
/// written with a point or a comma, or is a Q parameter; a formula is calculated while it is read.
/// @threadsafety plain values.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nc/fault.h"

namespace rivulet::nc::heidenhain {

/// Q, QL, QR and QS parameters. Q and QR belong to the control and all its programs, QL to the
/// program that is running (TNC 640 Conversational Programming, chapter Q parameters, "Principle
/// and overview of functions").
class Parameters {
 public:
  /// @param name  upper case, without leading zeros: "Q5", "QL1"
  /// @return fault NotDefined, ValueUnknown, OnlyOnControl
  [[nodiscard]] Expected<double> number(const std::string& name) const;
  [[nodiscard]] Expected<std::string> text(const std::string& name) const;
  [[nodiscard]] bool has(const std::string& name) const;
  /// @param value  NaN: not known
  void set(const std::string& name, double value);
  void setText(const std::string& name, std::string value);
  /// A value that the control sets by itself, such as Q108, the radius of the tool. Nothing: only
  /// the control knows it.
  void setOfControl(int number, std::optional<double> value);

  /// How often a value has become another one.
  [[nodiscard]] std::uint64_t changes() const { return m_changes; }

  void enterProgram() { m_local.emplace_back(); }
  void leaveProgram() {
    if (m_local.size() > 1) {
      m_local.pop_back();
    }
  }

 private:
  [[nodiscard]] const std::map<std::string, double, std::less<>>& of(
      const std::string& name) const {
    return name.size() > 1 && name[1] == 'L' ? m_local.back() : m_global;
  }
  std::map<std::string, double, std::less<>> m_global;
  std::vector<std::map<std::string, double, std::less<>>> m_local{1};
  std::map<std::string, std::string, std::less<>> m_texts;
  std::uint64_t m_changes = 0;
  std::map<std::string, double, std::less<>> m_ofControl;
};

/// The same text with blanks in place of comments, line ends and "~". Columns stay.
[[nodiscard]] std::string withoutComments(std::string_view block);

class Scanner {
 public:
  /// @param text  upper case but for texts, without comments; outlives the scanner
  /// @param begin  place of its first character
  Scanner(std::string_view text, const Parameters& parameters, Place begin)
      : m_text(text), m_parameters(parameters), m_begin(begin) {}

  void skipBlanks();
  [[nodiscard]] bool isAtEnd();
  [[nodiscard]] char peek() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }
  /// What has been taken last.
  [[nodiscard]] char previous() const { return m_at > 0 ? m_text[m_at - 1] : '\0'; }
  /// Blanks before it are skipped in any case.
  bool take(char c);
  /// The letters, whatever follows them.
  bool takePrefix(std::string_view letters);
  /// The same, where no letter follows.
  bool takeWord(std::string_view word);
  /// Letters.
  [[nodiscard]] std::string takeName();
  /// Digits. @return nothing if there are none
  [[nodiscard]] std::optional<int> takeInteger();
  /// "NAME" in quotes, or the text of a QS parameter. @return nothing if there is neither
  [[nodiscard]] std::optional<Expected<std::string>> takeText();
  /// Q5, QL5, QR5. @return empty if there is none
  [[nodiscard]] std::string takeParameter();
  /// True if a number, a sign or a parameter comes next.
  [[nodiscard]] bool isAtValue();
  /// A signed number or parameter: what an address has for its value.
  [[nodiscard]] Expected<double> value();
  /// What stands behind "=", with brackets and functions, and FN 0 to FN 8 and FN 13.
  [[nodiscard]] Expected<double> formula();

  [[nodiscard]] std::size_t at() const { return m_at; }
  void goTo(std::size_t at) { m_at = at; }
  void skipRest() { m_at = m_text.size(); }
  [[nodiscard]] int column() const { return m_begin.column + static_cast<int>(m_at); }
  [[nodiscard]] Place place() const { return {m_begin.line, m_begin.file, column()}; }
  [[nodiscard]] std::string_view rest() const { return m_text.substr(m_at); }
  /// What is next, up to a blank: for messages.
  [[nodiscard]] std::string nextText();

  template <class T = double>
  [[nodiscard]] Expected<T> fault(FaultCode code, std::string argument = {}) const {
    return fail(code, std::move(argument), place());
  }

 private:
  [[nodiscard]] Expected<double> number();
  [[nodiscard]] Expected<double> sum();
  [[nodiscard]] Expected<double> product();
  [[nodiscard]] Expected<double> power();
  [[nodiscard]] Expected<double> signedOperand();
  [[nodiscard]] Expected<double> operand();
  [[nodiscard]] Expected<double> function(const std::string& name, double argument) const;

  std::string_view m_text;
  const Parameters& m_parameters;
  Place m_begin;
  std::size_t m_at = 0;
  int m_depth = 0;
};

}  // namespace rivulet::nc::heidenhain
