// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/native_times.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>

#include "base/instant.h"
#include "base/text.h"

namespace rivulet::session {

namespace {

/// Of a word as M6 or F2.5, wherever it stands in the block; not part of a name.
std::optional<double> wordOf(std::string_view text, char address) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool isFirst = at == 0 || std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0;
    if (text[at] != address || !isFirst) {
      continue;
    }
    std::size_t begin = at + 1;
    begin += begin < text.size() && text[begin] == '=' ? 1 : 0;
    std::size_t end = begin;
    while (end < text.size() &&
           (std::isdigit(static_cast<unsigned char>(text[end])) != 0 || text[end] == '.')) {
      ++end;
    }
    if (const auto number = base::parseNumber(text.substr(begin, end - begin))) {
      return number;
    }
  }
  return std::nullopt;
}

bool hasWord(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool isFirst = at == 0 || std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0;
    const bool isLast =
        end == text.size() || std::isdigit(static_cast<unsigned char>(text[end])) == 0;
    if (isFirst && isLast) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<NativeTime> nativeTimes(const job::Plan& plan, const machine::MachineConfig& machine) {
  std::vector<NativeTime> times(1);
  for (const job::Part& part : plan.parts) {
    const auto* native = std::get_if<job::NativeBlock>(&part);
    if (native == nullptr) {
      if (std::get<job::Stretch>(part).number > 0) {
        times.emplace_back();
      }
      continue;
    }
    const std::string_view text = std::string_view(native->text).substr(0, native->text.find(';'));
    NativeTime& time = times.back();
    if (hasWord(text, "M6") || hasWord(text, "M06")) {
      time.toolChangesS += machine.tools ? base::toSeconds(machine.tools->changeTime) : 0.0;
    }
    if (hasWord(text, "G4") || hasWord(text, "G04")) {
      time.othersS += wordOf(text, 'F').value_or(0.0);  // with S it counts turns of the spindle
    }
    if (machine.spindle && (hasWord(text, "M3") || hasWord(text, "M4"))) {
      const double speed = wordOf(text, 'S').value_or(machine.spindle->speedPerMinMax);
      time.othersS += base::toSeconds(
          machine.spindle->runUpTime(std::min(speed, machine.spindle->speedPerMinMax)));
    }
    if (machine.coolantTime &&
        (hasWord(text, "M7") || hasWord(text, "M8") || hasWord(text, "M9"))) {
      time.othersS += base::toSeconds(*machine.coolantTime);
    }
  }
  return times;
}

}  // namespace rivulet::session
