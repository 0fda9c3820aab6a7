// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Finds a text in a program, in slices between other events: a million lines never hold the window
/// up. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <string>
#include <vector>

#include "overview/program_view.h"

namespace rivulet::widgets {

class TextSearch final : public QObject {
  Q_OBJECT

 public:
  /// Lines that are listed; a text that is found more often is found as often as anybody looks.
  static constexpr std::size_t kFoundMax = 100'000;
  /// Bytes looked at in one slice.
  static constexpr std::size_t kSliceBytes = std::size_t{1} << 20U;

  explicit TextSearch(QObject* parent = nullptr);

  /// @param view  null: none
  void setProgram(std::shared_ptr<const overview::ProgramView> view);
  /// Upper and lower case are the same. Empty: finds nothing.
  void start(const QString& wanted);
  [[nodiscard]] bool isBusy() const { return m_slices.isActive(); }
  [[nodiscard]] bool isEmpty() const { return m_wanted.empty(); }
  /// Lines with the text, from 1, ascending; more come while it is busy.
  [[nodiscard]] const std::vector<std::uint32_t>& lines() const { return m_lines; }
  /// The next line with the text after a line (before it, backwards), around the end. 0: none.
  [[nodiscard]] std::size_t next(std::size_t line, bool isForward) const;

 Q_SIGNALS:
  /// `lines` has grown, or the search has ended.
  void changed();

 private:
  void searchSlice();

  std::shared_ptr<const overview::ProgramView> m_program;
  std::string m_wanted;  ///< in lower case
  std::vector<std::uint32_t> m_lines;
  std::size_t m_nextLine = 0;  ///< from 0
  QTimer m_slices;
};

}  // namespace rivulet::widgets
