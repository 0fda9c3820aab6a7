// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overview/job_outline.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace rivulet::overview {

namespace {

bool isNeeded(const job::NativeBlock& block) {
  return !block.text.empty() && block.reason != job::NativeReason::Message &&
         block.reason != job::NativeReason::Mode && block.reason != job::NativeReason::End;
}

bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
}

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

}  // namespace

JobOutline::JobOutline(std::shared_ptr<const job::Plan> plan) : m_plan(std::move(plan)) {
  for (std::size_t part = 0; part < m_plan->parts.size(); ++part) {
    if (const auto* native = std::get_if<job::NativeBlock>(&m_plan->parts[part])) {
      if (native->file.empty()) {
        m_natives.push_back({native->place.line.value, part});
      }
      if (isNeeded(*native)) {
        m_needed.push_back(native);
      }
    } else if (const auto& stretch = std::get<job::Stretch>(m_plan->parts[part]);
               stretch.number > 0) {
      ++m_stretchCount;
      m_stretches.push_back({stretch.blocks.front().line.value, part});
    }
  }
  for (std::vector<Entry>* entries : {&m_natives, &m_stretches}) {
    std::stable_sort(entries->begin(), entries->end(),
                     [](const Entry& a, const Entry& b) { return a.line < b.line; });
    entries->erase(std::unique(entries->begin(), entries->end(),
                               [](const Entry& a, const Entry& b) { return a.line == b.line; }),
                   entries->end());
  }
  std::size_t before = 0;
  for (const Entry& entry : m_natives) {
    if (before == 0 || entry.line != before + 1) {
      m_partLines.push_back(entry.line);
    }
    before = entry.line;
  }
  for (const Entry& entry : m_stretches) {
    m_partLines.push_back(entry.line);
  }
  std::sort(m_partLines.begin(), m_partLines.end());
  m_partLines.erase(std::unique(m_partLines.begin(), m_partLines.end()), m_partLines.end());
}

const job::Part* JobOutline::partAt(const std::vector<Entry>& entries, std::size_t line) const {
  const auto found =
      std::lower_bound(entries.begin(), entries.end(), line,
                       [](const Entry& entry, std::size_t wanted) { return entry.line < wanted; });
  return found != entries.end() && found->line == line ? &m_plan->parts[found->part] : nullptr;
}

const job::NativeBlock* JobOutline::nativeAt(std::size_t line) const {
  const job::Part* part = partAt(m_natives, line);
  return part != nullptr ? &std::get<job::NativeBlock>(*part) : nullptr;
}

const job::Stretch* JobOutline::stretchAt(std::size_t line) const {
  const job::Part* part = partAt(m_stretches, line);
  return part != nullptr ? &std::get<job::Stretch>(*part) : nullptr;
}

std::size_t JobOutline::partBeyond(std::size_t line, bool isForward) const {
  if (isForward) {
    const auto next = std::upper_bound(m_partLines.begin(), m_partLines.end(), line);
    return next != m_partLines.end() ? *next : 0;
  }
  const auto next = std::lower_bound(m_partLines.begin(), m_partLines.end(), line);
  return next != m_partLines.begin() ? *std::prev(next) : 0;
}

std::string toolOf(const job::NativeBlock& block) {
  const std::string_view text = std::string_view(block.text).substr(0, block.text.find(';'));
  for (std::size_t at = text.find('T'); at != std::string_view::npos; at = text.find('T', at + 1)) {
    std::size_t begin = at + 1;
    if (at > 0 && isLetter(text[at - 1])) {
      continue;  // part of a name
    }
    if (begin < text.size() && text[begin] == '=') {
      ++begin;
    }
    if (begin < text.size() && text[begin] == '"') {
      const std::size_t end = text.find('"', begin + 1);
      return std::string(text.substr(begin + 1, end - begin - 1));
    }
    std::size_t end = begin;
    while (end < text.size() && isDigit(text[end])) {
      ++end;
    }
    if (end > begin) {
      return std::string(text.substr(begin, end - begin));
    }
  }
  return {};
}

}  // namespace rivulet::overview
