// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/correction_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "live/number_object.h"

namespace rivulet::streaming {

namespace {

/// Longer than any correction; keeps what is kept of a line small.
constexpr std::size_t kLineMax = 1000;

std::optional<std::size_t> axisOf(char letter) {
  const std::size_t axis = std::string_view("XYZxyz").find(letter);
  return axis == std::string_view::npos ? std::nullopt : std::optional(axis % base::kAxisCount);
}

/// Takes `letters` from the front of `text`. @return true if there was one at least
bool skip(std::string_view& text, std::string_view letters) {
  const std::size_t end = std::min(text.find_first_not_of(letters), text.size());
  text.remove_prefix(end);
  return end > 0;
}

/// A number up to what ends it. @return nothing if it is none, or not finite
std::optional<double> takeNumber(std::string_view& text, std::string_view ends) {
  const std::size_t end = std::min(text.find_first_of(ends), text.size());
  const std::optional<double> number = base::parseNumber(text.substr(0, end));
  text.remove_prefix(end);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

/// {"x": 0.01, ...}: accepts one flat object whose keys are axes, each once, with finite numbers.
class ObjectReader final : public live::NumberObject {
 public:
  [[nodiscard]] std::optional<CorrectionLine> read(std::string_view text) {
    const bool understood = nlohmann::json::sax_parse(text, this);
    return understood && m_names > 0 ? std::optional(m_line) : std::nullopt;
  }

  bool key(std::string& name) override {
    const std::optional<std::size_t> axis = name.size() == 1 ? axisOf(name.front()) : std::nullopt;
    if (!axis || m_line[*axis]) {
      return false;
    }
    m_axis = *axis;
    ++m_names;
    return true;
  }

 private:
  bool take(double value) override {
    if (m_names == 0 || !std::isfinite(value)) {
      return false;
    }
    m_line[m_axis] = value;
    return true;
  }

  CorrectionLine m_line;
  std::size_t m_axis = 0;
  std::size_t m_names = 0;
};

}  // namespace

std::optional<CorrectionLine> parseCorrectionLine(std::string_view text) {
  text = base::trim(text);
  if (text.empty() || text.front() == '#') {
    return CorrectionLine{};
  }
  if (text.front() == '{') {
    return ObjectReader().read(text);
  }
  CorrectionLine line;
  while (!text.empty()) {
    const std::optional<std::size_t> axis = axisOf(text.front());
    if (!axis || line[*axis]) {
      return std::nullopt;
    }
    text.remove_prefix(1);
    skip(text, " \t=");
    line[*axis] = takeNumber(text, " \t\r;");
    if (!line[*axis]) {
      return std::nullopt;
    }
    skip(text, " \t\r;");
  }
  return line;
}

bool CorrectionLines::add(std::string_view bytes) {
  bool says = false;
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const std::size_t room = kLineMax - m_rest.size();
    m_isTooLong = m_isTooLong || end > room;
    m_rest.append(bytes.substr(0, std::min(end, room)));
    if (end == bytes.size()) {
      break;
    }
    says = takeLine(m_rest) || says;
    m_rest.clear();
    m_isTooLong = false;
    bytes.remove_prefix(end + 1);
  }
  return says;
}

bool CorrectionLines::takeLine(std::string_view text) {
  ++m_lines;
  const std::optional<CorrectionLine> line = m_isTooLong ? std::nullopt : parseCorrectionLine(text);
  if (!line) {
    ++m_unknown;
    m_firstUnknown = m_firstUnknown == 0 ? m_lines : m_firstUnknown;
    return false;
  }
  bool says = false;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if ((*line)[axis]) {
      m_valueMm.set(axis, *(*line)[axis]);
      says = true;
    }
  }
  return says;
}

}  // namespace rivulet::streaming
