// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/lines.h"

#include <fast_float/fast_float.h>
#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace rivulet::trace::lines {

namespace {

/// In the order of `ControlEvent::Kind`.
constexpr std::array<std::string_view, 7> kEventNames{"tool",    "edge",  "offset", "spindle",
                                                      "coolant", "dwell", "stop"};

}  // namespace

std::optional<LineReader::Line> LineReader::next() {
  if (m_rest.empty()) {
    return std::nullopt;
  }
  Line line;
  line.number = ++m_number;
  const std::size_t end = m_rest.find('\n');
  line.whole = end != std::string_view::npos;
  line.text = m_rest.substr(0, end);
  m_rest.remove_prefix(line.whole ? end + 1 : m_rest.size());
  if (!line.text.empty() && line.text.back() == '\r') {
    line.text.remove_suffix(1);
  }
  return line;
}

void Fields::skipBlanks() {
  m_rest.remove_prefix(std::min(m_rest.find_first_not_of(' '), m_rest.size()));
}

bool Fields::atEnd() {
  skipBlanks();
  return m_rest.empty();
}

std::string_view Fields::word() {
  skipBlanks();
  const std::string_view text = m_rest.substr(0, m_rest.find(' '));
  m_rest.remove_prefix(text.size());
  m_ok = m_ok && !text.empty();
  return text;
}

double Fields::number() {
  const std::string_view text = word();
  double value = 0.0;
  const auto [end, status] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  m_ok = m_ok && status == std::errc{} && end == text.data() + text.size();
  return value;
}

base::Vec3 Fields::vector() {
  base::Vec3 value;
  value.x = number();
  value.y = number();
  value.z = number();
  return value;
}

std::string Fields::quoted() {
  skipBlanks();
  std::string text;
  if (m_rest.empty() || m_rest.front() != '"') {
    m_ok = false;
    return text;
  }
  for (std::size_t i = 1; i < m_rest.size(); ++i) {
    const char c = m_rest[i];
    if (c == '"') {
      m_rest.remove_prefix(i + 1);
      // A quote ends a field: only a blank or the end of the line may follow.
      m_ok = m_ok && (m_rest.empty() || m_rest.front() == ' ');
      return text;
    }
    if (c != '\\') {
      text += c;
      continue;
    }
    ++i;
    const char escaped = i < m_rest.size() ? m_rest[i] : '\0';
    if (escaped == '"' || escaped == '\\') {
      text += escaped;
    } else if (escaped == 'n') {
      text += '\n';
    } else if (escaped == 'r') {
      text += '\r';
    } else if (escaped == '0') {
      text += '\0';
    } else {
      break;
    }
  }
  m_ok = false;
  m_rest = {};
  return text;
}

std::string_view Fields::key() {
  skipBlanks();
  const std::size_t end = m_rest.find_first_of("= ");
  if (end == std::string_view::npos || end == 0 || m_rest[end] != '=') {
    m_ok = false;
    m_rest = {};
    return {};
  }
  const std::string_view name = m_rest.substr(0, end);
  m_rest.remove_prefix(end + 1);
  // "key= value" is damage: without this the blank would be skipped and the next field taken.
  m_ok = m_ok && !m_rest.empty() && m_rest.front() != ' ';
  return name;
}

void Fields::skipValue() {
  if (!m_rest.empty() && m_rest.front() == '"') {
    static_cast<void>(quoted());
  } else {
    static_cast<void>(word());
  }
}

void appendQuoted(std::string& out, std::string_view text) {
  out += '"';
  for (const char c : text) {
    switch (c) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\r':
        out += "\\r";
        break;
      case '\0':
        out += "\\0";
        break;
      default:
        out += c;
    }
  }
  out += '"';
}

void appendAngles(std::string& out, const base::RotaryDeg& angles, const base::RotarySet& of) {
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (of[axis]) {
      fmt::format_to(std::back_inserter(out), FMT_COMPILE(" {}"), angles[axis]);
    }
  }
}

base::RotaryDeg readAngles(Fields& fields, const base::RotarySet& of) {
  base::RotaryDeg angles{};
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (of[axis]) {
      angles[axis] = fields.number();
    }
  }
  return angles;
}

base::RotarySet readRotaryNames(Fields& fields) {
  const std::string_view names = fields.word();
  base::RotarySet set{};
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    set[axis] = names.find(base::kRotaryAxisNames[axis]) != std::string_view::npos;
  }
  if (names.empty() || base::rotaryNames(set) != names) {
    fields.refuse();
  }
  return set;
}

void appendSample(std::string& out, const ControlSample& s, const base::RotarySet& rotaryAxes) {
  fmt::format_to(std::back_inserter(out), FMT_COMPILE("s {} {} {} {} {} {} {} {} {}"),
                 s.at.time_since_epoch().count(), s.commandMm.x, s.commandMm.y, s.commandMm.z,
                 s.actualMm.x, s.actualMm.y, s.actualMm.z, s.feedMmPerS, s.line.value);
  appendAngles(out, s.commandDeg, rotaryAxes);
  appendAngles(out, s.actualDeg, rotaryAxes);
  out += '\n';
}

void appendBlock(std::string& out, const ExecutedBlock& b, const base::RotarySet& rotaryAxes) {
  fmt::format_to(std::back_inserter(out), FMT_COMPILE("b {} {} {} {} {} {} {}"),
                 b.from.time_since_epoch().count(), b.to.time_since_epoch().count(), b.line.value,
                 b.targetMm.x, b.targetMm.y, b.targetMm.z, b.lengthMm);
  if (base::any(rotaryAxes)) {
    appendAngles(out, b.targetDeg, rotaryAxes);
    fmt::format_to(std::back_inserter(out), FMT_COMPILE(" {}"), b.turnDeg);
  }
  out += '\n';
}

std::optional<ControlSample> readSample(Fields fields, const base::RotarySet& rotaryAxes) {
  ControlSample s;
  s.at = fields.instant();
  s.commandMm = fields.vector();
  s.actualMm = fields.vector();
  s.feedMmPerS = fields.number();
  s.line.value = fields.integer<std::uint32_t>();
  s.commandDeg = readAngles(fields, rotaryAxes);
  s.actualDeg = readAngles(fields, rotaryAxes);
  return fields.ok() && fields.atEnd() ? std::optional(s) : std::nullopt;
}

std::optional<ExecutedBlock> readBlock(Fields fields, const base::RotarySet& rotaryAxes) {
  ExecutedBlock b;
  b.from = fields.instant();
  b.to = fields.instant();
  b.line.value = fields.integer<std::uint32_t>();
  b.targetMm = fields.vector();
  b.lengthMm = fields.number();
  if (base::any(rotaryAxes)) {
    b.targetDeg = readAngles(fields, rotaryAxes);
    b.turnDeg = fields.number();
  }
  return fields.ok() && fields.atEnd() ? std::optional(b) : std::nullopt;
}

void appendEvent(std::string& out, const ControlEvent& e) {
  fmt::format_to(std::back_inserter(out), FMT_COMPILE("e {} {} {} {} {} "),
                 e.from.time_since_epoch().count(), e.to.time_since_epoch().count(), e.line.value,
                 kEventNames[static_cast<std::size_t>(e.kind)], e.value);
  appendQuoted(out, e.name);
  out += '\n';
}

std::optional<ControlEvent> readEvent(Fields fields) {
  ControlEvent e;
  e.from = fields.instant();
  e.to = fields.instant();
  e.line.value = fields.integer<std::uint32_t>();
  const auto kind = std::find(kEventNames.begin(), kEventNames.end(), fields.word());
  e.value = fields.number();
  e.name = fields.quoted();
  if (!fields.ok() || !fields.atEnd() || kind == kEventNames.end()) {
    return std::nullopt;
  }
  e.kind = static_cast<ControlEvent::Kind>(kind - kEventNames.begin());
  return e;
}

Header readHeader(std::string_view line, std::string_view name) {
  Header header;
  if (line.substr(0, name.size()) != name || line.size() <= name.size() ||
      line[name.size()] != ' ') {
    return header;
  }
  line.remove_prefix(name.size() + 1);
  const std::string_view version = line.substr(0, line.find(' '));
  header.rest = line.substr(version.size());
  const auto [end, status] =
      std::from_chars(version.data(), version.data() + version.size(), header.version);
  header.known =
      status == std::errc{} && end == version.data() + version.size() && header.version >= 1;
  return header;
}

}  // namespace rivulet::trace::lines
