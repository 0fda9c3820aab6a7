// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/text_search.h"

#include <algorithm>

namespace rivulet::widgets {

namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

TextSearch::TextSearch(QObject* parent) : QObject(parent) {
  m_slices.setInterval(0);
  connect(&m_slices, &QTimer::timeout, this, &TextSearch::searchSlice);
}

void TextSearch::setProgram(std::shared_ptr<const overview::ProgramView> view) {
  m_program = std::move(view);
  m_lines.clear();
  m_nextLine = 0;
  if (m_program && !m_wanted.empty()) {
    m_slices.start();
  } else {
    m_slices.stop();
  }
  Q_EMIT changed();
}

void TextSearch::start(const QString& wanted) {
  const bool isUtf8 = !m_program || m_program->text.isUtf8();
  m_wanted = (isUtf8 ? wanted.toUtf8() : wanted.toLatin1()).toStdString();
  std::transform(m_wanted.begin(), m_wanted.end(), m_wanted.begin(), lower);
  setProgram(m_program);
}

std::size_t TextSearch::next(std::size_t line, bool isForward) const {
  if (m_lines.empty()) {
    return 0;
  }
  if (isForward) {
    const auto found = std::upper_bound(m_lines.begin(), m_lines.end(), line);
    return found == m_lines.end() ? m_lines.front() : *found;
  }
  const auto found = std::lower_bound(m_lines.begin(), m_lines.end(), line);
  return found == m_lines.begin() ? m_lines.back() : *std::prev(found);
}

void TextSearch::searchSlice() {
  const std::string& text = m_program->program->text;
  std::size_t bytes = 0;
  while (m_nextLine < m_program->text.lines() && bytes < kSliceBytes &&
         m_lines.size() < kFoundMax) {
    const std::string_view line = m_program->text.line(text, m_nextLine++);
    bytes += line.size() + 1;
    const auto found = std::search(line.begin(), line.end(), m_wanted.begin(), m_wanted.end(),
                                   [](char a, char b) { return lower(a) == b; });
    if (found != line.end()) {
      m_lines.push_back(static_cast<std::uint32_t>(m_nextLine));
    }
  }
  if (m_nextLine >= m_program->text.lines() || m_lines.size() >= kFoundMax) {
    m_slices.stop();
  }
  Q_EMIT changed();
}

}  // namespace rivulet::widgets
