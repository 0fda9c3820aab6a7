// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "gcode/program.h"

namespace rivulet::gcode {

namespace {

std::string shortened(std::string text) {
  constexpr std::size_t kLongest = 120;
  if (text.size() <= kLongest) {
    return text;
  }
  text.resize(kLongest);
  // A cut inside a UTF-8 character would make the text unreadable for the display.
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0x80) != 0) {
    text.pop_back();
  }
  return text + "...";
}

}  // namespace

void Findings::report(Severity severity, int column, DiagnosticCode code, std::string argument) {
  add({severity, m_line, column, code, shortened(std::move(argument))});
}

void Findings::add(Diagnostic found) {
  found.file = m_file == nullptr ? std::string() : *m_file;
  if (found.code == DiagnosticCode::UnknownWord && !m_list.empty()) {
    // R and Q of a G function that is not known are its own; and one word is one finding.
    const Diagnostic& last = m_list.back();
    const bool isOfBlock = last.line == found.line && last.file == found.file;
    const bool isSame = last.column == found.column && last.code == found.code;
    if (isOfBlock && (isSame || last.code == DiagnosticCode::UnknownGCode)) {
      return;
    }
  }
  if (found.severity == Severity::Error && !m_accepted.empty()) {
    std::string name = acceptableName(found);
    if (!name.empty() &&
        std::find(m_accepted.begin(), m_accepted.end(), name) != m_accepted.end()) {
      // One warning per name says what was accepted and where it begins.
      if (std::find(m_acceptedSeen.begin(), m_acceptedSeen.end(), name) != m_acceptedSeen.end()) {
        return;
      }
      m_acceptedSeen.push_back(name);
      found.severity = Severity::Warning;
      found.code = DiagnosticCode::Accepted;
      found.argument = std::move(name);
    }
  }
  const auto [repeats, isFirst] =
      m_repeats.try_emplace(fmt::format("{} {} {} {}", static_cast<int>(found.severity),
                                        static_cast<int>(found.code), found.file, found.argument),
                            Repeats{m_list.size(), 0});
  if (++repeats->second.count > kRepeatsListed) {
    m_list[repeats->second.first].count = repeats->second.count;
    return;
  }
  // Whoever runs the program must see each of them, so none is cut.
  const bool isSetting = found.code == DiagnosticCode::ControlSettingOpen;
  if (isSetting && !isFirst) {
    return;
  }
  if (m_list.size() >= kDiagnosticsMax && !isSetting) {
    if (isFirst) {
      m_repeats.erase(repeats);
    }
    if (m_suppressed++ == 0) {
      m_suppressedLine = m_line;
    }
    m_suppressedWorst = std::max(m_suppressedWorst, found.severity);
    return;
  }
  m_list.push_back(std::move(found));
}

void Findings::reportProgram(Severity severity, DiagnosticCode code, std::string argument) {
  m_list.push_back({severity, base::LineNumber{1}, 1, code, std::move(argument), {}});
}

void Findings::fault(int column, const nc::Fault& fault) {
  const DiagnosticCode code =
      nc::isAboutOrder(fault.code) ? DiagnosticCode::FlowFault : DiagnosticCode::ExpressionFault;
  add({Severity::Error, m_line, column, code, shortened(fault.argument), {}, fault.code});
}

void Findings::ignore(const nc::Token& token, std::string word) {
  if (std::find(m_ignoredNames.begin(), m_ignoredNames.end(), word) != m_ignoredNames.end()) {
    return;
  }
  if (m_ignoredNames.size() < kDiagnosticsMax) {
    m_ignoredNames.push_back(word);
  }
  report(Severity::Note, token.column, DiagnosticCode::IgnoredCode, std::move(word));
}

void Findings::ignoreG(int key, const nc::Token& token) {
  const auto index = static_cast<std::size_t>(key);
  if (!m_ignoredG.test(index)) {
    m_ignoredG.set(index);
    report(Severity::Note, token.column, DiagnosticCode::IgnoredCode, nc::wordText(token));
  }
}

void Findings::ignoreM(Severity severity, int number, const nc::Token& token) {
  if (severity == Severity::Error) {
    report(severity, token.column, DiagnosticCode::UnknownMFunction, nc::wordText(token));
    return;
  }
  auto& seen = severity == Severity::Note ? m_ignoredM : m_warnedM;
  const auto index = static_cast<std::size_t>(number);
  if (!seen.test(index)) {
    seen.set(index);
    report(severity, token.column, DiagnosticCode::IgnoredCode, nc::wordText(token));
  }
}

void Findings::ignoreLetter(const nc::Token& token) {
  const auto letter = static_cast<std::size_t>(token.address - 'A');
  if (!m_ignoredLetters.test(letter)) {
    m_ignoredLetters.set(letter);
    report(Severity::Note, token.column, DiagnosticCode::IgnoredCode,
           std::string(1, token.address));
  }
}

std::vector<Diagnostic> Findings::take() {
  // Within a block the findings about the motion come after those about its words.
  std::stable_sort(m_list.begin(), m_list.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.file, a.line, a.column) < std::tie(b.file, b.line, b.column);
  });
  if (m_suppressed > 0) {
    m_list.push_back({m_suppressedWorst,
                      m_suppressedLine,
                      1,
                      DiagnosticCode::MoreFindings,
                      fmt::format("{}", m_suppressed),
                      {}});
  }
  return std::move(m_list);
}

}  // namespace rivulet::gcode
