// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The text of the program with what finds a place in it: search, line number, the parts of a job,
/// and the line that a run is at. @threadsafety GUI thread.
#pragma once

#include <memory>

#include "overview/program_view.h"
#include "widgets/common/page.h"

class QLabel;
class QLineEdit;
class QToolButton;

namespace rivulet::widgets {

class ProgramTextView;
class TextSearch;

class TextPane final : public Page {
  Q_OBJECT

 public:
  explicit TextPane(QWidget* parent = nullptr);

  /// @param view  null: none
  void setProgram(const std::shared_ptr<const overview::ProgramView>& view);
  /// The line of the point that was executed last; 0: no run. The text follows it unless the
  /// operator looks elsewhere.
  void setRunLine(std::size_t line);
  /// A run begins: the text follows it, wherever the operator has looked.
  void followRun();

  [[nodiscard]] ProgramTextView* text() const { return m_text; }
  [[nodiscard]] QLineEdit* search() const { return m_search; }
  [[nodiscard]] QLineEdit* lineField() const { return m_line; }
  /// Shows the row of search and line number, with the focus in one of its fields.
  void showSearch(QLineEdit* field);
  /// Shows and hides that row; has its place beside the tabs.
  [[nodiscard]] QToolButton* find() const { return m_find; }
  /// To the part of a job before the present line, and beyond it.
  [[nodiscard]] QToolButton* previousPart() const { return m_previousPart; }
  [[nodiscard]] QToolButton* nextPart() const { return m_nextPart; }
  [[nodiscard]] QToolButton* follow() const { return m_follow; }
  [[nodiscard]] QToolButton* startHere() const { return m_startHere; }

 Q_SIGNALS:
  /// Found, or typed as a number.
  void lineChosen(std::size_t line);
  /// The operator wants a run to begin at the chosen line.
  void startHereRequested(std::size_t line);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void connectParts();
  void findNext(bool isForward);
  void goToLine();
  void goToPart(bool isForward);
  void showFound();
  void showRunLine();

  TextSearch* m_finder;
  QWidget* m_searchRow;
  QToolButton* m_find;
  QLineEdit* m_search = lineEdit({.name = QT_TR_NOOP("Search the program text"),
                                  .placeholder = QT_TR_NOOP("Search (Ctrl+F)")});
  QToolButton* m_previous;
  QToolButton* m_next;
  QLabel* m_found = label({.isMuted = true});
  QLineEdit* m_line = lineEdit({.tip = QT_TR_NOOP("Go to a line (Ctrl+G)"),
                                .name = QT_TR_NOOP("Go to line"),
                                .isTouch = true});
  QToolButton* m_previousPart;
  QToolButton* m_nextPart;
  QToolButton* m_follow;
  QToolButton* m_startHere;
  QBoxLayout* m_below;      ///< the text: one row, or two in a narrow pane
  ProgramTextView* m_text;  ///< made last: the focus comes to it from above
  std::shared_ptr<const overview::ProgramView> m_program;
  std::size_t m_runLine = 0;
  bool m_wantsFirst = false;  ///< the first line found is to be shown as soon as it is known
};

}  // namespace rivulet::widgets
