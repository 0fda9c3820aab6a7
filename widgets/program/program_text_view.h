// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The text of a program, with selection of lines. Lines that the control executes itself have a
/// coloured edge, and the first line of a stretch has its number. Paints only the visible lines, so
/// a million lines cost no more than a hundred. @threadsafety GUI thread.
#pragma once

#include <QAbstractScrollArea>
#include <QIcon>
#include <QString>
#include <array>
#include <memory>
#include <vector>

#include "overview/program_view.h"

namespace rivulet::widgets {

class ProgramTextView final : public QAbstractScrollArea {
  Q_OBJECT

 public:
  explicit ProgramTextView(QWidget* parent = nullptr);

  /// @param view  null: none
  void setProgram(std::shared_ptr<const overview::ProgramView> view);
  /// Highlights a line and scrolls to it if it is not visible. No signal is emitted.
  /// @param line  from 1; beyond the text: nothing happens
  void setCurrentLine(std::size_t line);
  /// Marks the line a run is at. @param line  0: none @param isFollowed  scrolls to it
  void setRunLine(std::size_t line, bool isFollowed);
  /// Marks a text wherever it stands. Upper and lower case are the same.
  void setHighlighted(const QString& text);
  [[nodiscard]] std::size_t lineCount() const { return lines(); }
  /// From 1; 0: none.
  [[nodiscard]] std::size_t currentLine() const { return m_current; }
  /// A line as it is shown. @param line  from 1, in the text
  [[nodiscard]] QString lineText(std::size_t line) const;
  /// Lines painted by the last event: for tests of speed.
  [[nodiscard]] std::size_t paintedLines() const { return m_painted; }
  [[nodiscard]] std::size_t firstVisibleLine() const;
  /// What is said of a line when it is pointed at; may be empty.
  [[nodiscard]] QString hintOf(std::size_t line) const;

  [[nodiscard]] QSize sizeHint() const override { return {320, 300}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {200, 120}; }

 Q_SIGNALS:
  /// By a click or by the keys.
  void lineChosen(std::size_t line);
  /// By the wheel or the scroll bar.
  void scrolledByHand();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  [[nodiscard]] std::size_t lines() const { return m_program ? m_program->text.lines() : 0; }
  [[nodiscard]] int lineHeightPx() const;
  [[nodiscard]] int marginPx() const;
  [[nodiscard]] int numbersPx() const;  ///< of the margin: signs and line numbers
  void paintPart(QPainter& painter, std::size_t line, int y) const;
  [[nodiscard]] std::size_t pageLines() const;
  [[nodiscard]] std::size_t lineAt(int y) const;
  void setRanges();
  void makeIcons();
  void choose(std::size_t line);
  void bringToSight(std::size_t line);
  void paintHighlights(QPainter& painter, const QString& text, int x, int y) const;

  /// Findings by line, the worst of each.
  struct Mark {
    std::size_t line = 0;
    gcode::Severity severity = gcode::Severity::Note;
    std::size_t diagnostic = 0;
  };

  [[nodiscard]] const Mark* markOf(std::size_t line) const;

  std::shared_ptr<const overview::ProgramView> m_program;
  std::vector<Mark> m_marks;
  std::array<QPixmap, 3> m_icons;
  std::size_t m_current = 0;
  std::size_t m_runLine = 0;
  QString m_highlighted;
  std::size_t m_painted = 0;
  std::size_t m_pageLines = 1;  ///< of the present height
};

}  // namespace rivulet::widgets
