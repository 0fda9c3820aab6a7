// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The path of the traces with what it looks like (from above or turned, colours, errors drawn
/// larger), and below it the text of their program. The line under cursor A is
/// marked; a click on a line puts cursor A where the trace executed it, another click where it did
/// so next. @threadsafety GUI thread.
#pragma once

#include <QString>
#include <cstddef>
#include <memory>
#include <vector>

#include "overview/program_view.h"
#include "widgets/common/page.h"
#include "widgets/scope/scope_pane.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace rivulet::widgets {

class PathPane;
class ProgramTextView;
class ScopeView;
class TimeWindow;

class PathPanel final : public Page {
  Q_OBJECT

 public:
  PathPanel(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors, ScopeView* view,
            QWidget* parent = nullptr);

  /// The program that the traces are compared with. @param view  null: none
  void setProgram(std::shared_ptr<const overview::ProgramView> view);
  /// Draws pending changes at once: for pictures and tests.
  void redrawNow();
  [[nodiscard]] PathPane* path() const { return m_path; }
  [[nodiscard]] ProgramTextView* text() const { return m_text; }
  /// The line of cursor A; 0: none.
  [[nodiscard]] std::size_t markedLine() const { return m_marked; }

 private:
  /// Why lines and trace cannot be linked.
  enum class Obstacle { None, NoProgram, Live, OtherProgram, NotYet, NoLines };
  [[nodiscard]] Obstacle obstacle() const;
  void follow();
  void listSignals();
  void showView();
  void setEnlargements();
  void choose(std::size_t line);
  void goTo(std::size_t line, const std::vector<trace::ValueSpan>& spans);
  void showNote();

  ScopeCurves* m_curves;
  TimeWindow* m_window;
  ScopeCursors* m_cursors;
  ScopeView* m_view;
  std::shared_ptr<const overview::ProgramView> m_program;
  QPushButton* m_top = button({.text = QT_TR_NOOP("Top"),
                               .tip = QT_TR_NOOP("X and Y, seen from above"),
                               .id = "tracePathTop"},
                              &PathPanel::showView);
  QPushButton* m_spatial = button(
      {.text = QT_TR_NOOP("3D"),
       .tip = QT_TR_NOOP("Seen from the side; drag the path or press the arrow keys to turn it"),
       .id = "tracePath3D"},
      &PathPanel::showView);
  QComboBox* m_error =
      list({.name = QT_TR_NOOP("Enlargement of the error"), .id = "tracePathError"});
  QComboBox* m_colour = list({.tip = QT_TR_NOOP("The signal that gives the path its colours"),
                              .name = QT_TR_NOOP("Colour of the path"),
                              .id = "tracePathColour"});
  PathPane* m_path;
  ProgramTextView* m_text;
  QLabel* m_note = label({.id = "traceProgramNote", .wraps = true});
  std::size_t m_marked = 0;
  std::size_t m_chosen = 0;  ///< line of the last click; 0: none since the cursor moved
  std::size_t m_times = 0;   ///< how often it was executed
  std::size_t m_time = 0;    ///< at which of these the cursor is
  bool m_isGoing = false;
  int m_request = 0;
  std::vector<QString> m_formulas;  ///< of the entries of the list of colours
};

}  // namespace rivulet::widgets
