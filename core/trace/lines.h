// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Parsing and printing one line of a trace file; shared only by the two formats of
/// docs/formats.md. A line is a keyword and fields separated by blanks; numbers are locale-free and
/// doubles read back to the bit. @threadsafety pure.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "trace/control_trace.h"

namespace rivulet::trace::lines {

/// The lines of a text, one after another. A line without a line feed is not whole.
class LineReader {
 public:
  struct Line {
    std::string_view text;   ///< without line end, also without a CR that an editor may have added
    std::size_t number = 0;  ///< from 1
    bool whole = true;       ///< false: the text ends within this line
  };

  explicit LineReader(std::string_view text) : m_rest(text) {}
  [[nodiscard]] std::optional<Line> next();
  [[nodiscard]] std::size_t linesRead() const { return m_number; }
  /// What has not been read.
  [[nodiscard]] std::string_view rest() const { return m_rest; }

 private:
  std::string_view m_rest;
  std::size_t m_number = 0;
};

/// The fields of a line. After the first field that cannot be read, `ok()` is false and stays so.
class Fields {
 public:
  explicit Fields(std::string_view line) : m_rest(line) {}

  [[nodiscard]] std::string_view word();
  [[nodiscard]] double number();
  [[nodiscard]] base::Vec3 vector();
  template <class Integer>
  [[nodiscard]] Integer integer() {
    const std::string_view text = word();
    Integer value{};
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    m_ok = m_ok && status == std::errc{} && end == text.data() + text.size();
    return value;
  }
  [[nodiscard]] base::Duration duration() { return base::Duration{integer<std::int64_t>()}; }
  [[nodiscard]] base::Instant instant() { return base::Instant{duration()}; }
  /// A text in double quotes, as `appendQuoted` writes it.
  [[nodiscard]] std::string quoted();
  /// The name before '=': `key()` and then one value function reads "key=value".
  [[nodiscard]] std::string_view key();
  /// Skips a value of any kind.
  void skipValue();

  void refuse() { m_ok = false; }
  [[nodiscard]] bool ok() const { return m_ok; }
  [[nodiscard]] bool atEnd();

 private:
  void skipBlanks();

  std::string_view m_rest;
  bool m_ok = true;
};

/// Appends `text` in double quotes; quotes, backslashes and line ends are escaped.
void appendQuoted(std::string& out, std::string_view text);

/// @param rotaryAxes  whose angles are at the end of the line
void appendSample(std::string& out, const ControlSample& sample, const base::RotarySet& rotaryAxes);
void appendBlock(std::string& out, const ExecutedBlock& block, const base::RotarySet& rotaryAxes);
void appendEvent(std::string& out, const ControlEvent& event);
/// Reads what follows the keyword; nothing if a field is missing, wrong or left over.
[[nodiscard]] std::optional<ControlSample> readSample(Fields fields,
                                                      const base::RotarySet& rotaryAxes);
[[nodiscard]] std::optional<ExecutedBlock> readBlock(Fields fields,
                                                     const base::RotarySet& rotaryAxes);
[[nodiscard]] std::optional<ControlEvent> readEvent(Fields fields);

/// Angles of those axes, each after a blank.
void appendAngles(std::string& out, const base::RotaryDeg& angles, const base::RotarySet& of);
[[nodiscard]] base::RotaryDeg readAngles(Fields& fields, const base::RotarySet& of);
/// The axes in a word as `base::rotaryNames` writes it; anything else is refused.
[[nodiscard]] base::RotarySet readRotaryNames(Fields& fields);

/// The first line of a file: "<name> <version> ...".
struct Header {
  bool known = false;  ///< the name is the expected one and the version a number
  int version = 0;
  std::string_view rest;  ///< after the version
};
[[nodiscard]] Header readHeader(std::string_view line, std::string_view name);

}  // namespace rivulet::trace::lines
