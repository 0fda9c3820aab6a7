// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "live/line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/text.h"
#include "live/error.h"
#include "live/number_object.h"

namespace rivulet::live {

namespace {

using base::Result;
using base::toUpper;

constexpr std::string_view kNumberLetters = "0123456789+-.eE";

Result<Line> notALine() {
  return base::fail(LiveError::NotALine,
                    "This is no point. Send X1.5 Y2 Z-0.3 F500, the same as JSON, hold, end or "
                    "comment.");
}

Result<Line> notFinite(char letter) {
  return base::fail(LiveError::NotFinite, fmt::format("{} has no finite number.", letter));
}

/// The place of a word's value; null: no such word.
std::optional<double>* place(Line& line, char letter) {
  if (const std::size_t axis = std::string_view("XYZ").find(letter);
      axis != std::string_view::npos) {
    return &line.mm[axis];
  }
  if (const std::size_t axis = std::string_view("ABC").find(letter);
      axis != std::string_view::npos) {
    return &line.deg[axis];
  }
  return letter == 'F' ? &line.feedMmPerMin : letter == 'N' ? &line.number : nullptr;
}

/// A line that names only F or N says where the tool stays: that is no point.
Result<Line> asPoint(Line line) {
  const auto isNamed = [](const std::optional<double>& value) { return value.has_value(); };
  line.kind = std::any_of(line.mm.begin(), line.mm.end(), isNamed) ||
                      std::any_of(line.deg.begin(), line.deg.end(), isNamed)
                  ? Line::Kind::Point
                  : Line::Kind::Nothing;
  return line.kind == Line::Kind::Point ? Result<Line>(line) : notALine();
}

Result<Line> parseWords(std::string_view text) {
  Line line;
  while (!text.empty() && text.front() != ';' && text.front() != '#') {
    const char letter = toUpper(text.front());
    std::optional<double>* const value = place(line, letter);
    if (value == nullptr || *value) {
      return notALine();
    }
    text.remove_prefix(1);
    text.remove_prefix(std::min(text.find_first_not_of(" \t="), text.size()));
    const std::size_t end = std::min(text.find_first_not_of(kNumberLetters), text.size());
    *value = base::parseNumber(text.substr(0, end));
    if (!*value || !std::isfinite(**value)) {
      return notFinite(letter);
    }
    text.remove_prefix(end);
    text.remove_prefix(std::min(text.find_first_not_of(" \t,"), text.size()));
  }
  return asPoint(line);
}

/// One flat object; each key once.
class ObjectReader final : public NumberObject {
 public:
  [[nodiscard]] Result<Line> read(std::string_view text) {
    if (!nlohmann::json::sax_parse(text, this)) {
      return m_badNumber != 0 ? notFinite(m_badNumber) : notALine();
    }
    if (m_line.factor) {
      const bool isAlone = !asPoint(m_line) && !m_line.feedMmPerMin && !m_line.number &&
                           m_line.kind == Line::Kind::Nothing && !m_isComment;
      m_line.kind = Line::Kind::Feed;
      return isAlone ? Result<Line>(m_line) : notALine();
    }
    return m_line.kind == Line::Kind::Nothing && !m_isComment ? asPoint(m_line)
                                                              : Result<Line>(m_line);
  }

  bool key(std::string& name) override {
    m_key = name;
    return true;
  }
  bool boolean(bool value) override {
    if (!value || (m_key != "end" && m_key != "hold")) {
      return false;
    }
    m_line.kind = m_key == "end" ? Line::Kind::End : Line::Kind::Hold;
    return true;
  }
  bool string(std::string&) override { return m_isComment = m_key == "comment"; }
  bool null() override {
    m_badNumber = m_key.size() == 1 ? toUpper(m_key.front()) : '\0';
    return false;
  }

 private:
  bool take(double number) override {
    if (m_key == "feed") {
      return !std::exchange(m_line.factor, number).has_value();
    }
    std::optional<double>* const value =
        m_key.size() == 1 ? place(m_line, toUpper(m_key.front())) : nullptr;
    if (value == nullptr || *value) {
      return false;
    }
    if (!std::isfinite(number)) {
      m_badNumber = toUpper(m_key.front());
      return false;
    }
    *value = number;
    return true;
  }

  Line m_line;
  std::string m_key;
  char m_badNumber = 0;
  bool m_isComment = false;
};

}  // namespace

Result<Line> parseLine(std::string_view text) {
  text = base::trim(text);
  if (text.empty() || text.front() == '#' || text.front() == ';' || text.front() == '(') {
    return Line{};
  }
  if (text.front() == '{') {
    return ObjectReader().read(text);
  }
  const std::string word = base::toUpper(text.substr(0, text.find_first_of(" \t:")));
  if (word == "COMMENT") {
    return Line{};
  }
  if (word == "FEED") {
    Line line;
    line.kind = Line::Kind::Feed;
    line.factor = base::parseNumber(base::trim(text.substr(word.size())))
                      .value_or(std::numeric_limits<double>::quiet_NaN());
    return line;
  }
  if (text.size() == word.size() && (word == "END" || word == "HOLD")) {
    Line line;
    line.kind = word == "END" ? Line::Kind::End : Line::Kind::Hold;
    return line;
  }
  return parseWords(text);
}

}  // namespace rivulet::live
