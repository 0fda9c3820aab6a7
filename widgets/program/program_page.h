// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The page of the program: path, text and figures, linked with each other. A selection in one is
/// shown in the others. @threadsafety GUI thread.
#pragma once

#include <memory>
#include <optional>

#include "live/agreement.h"
#include "overview/program_view.h"
#include "widgets/common/page.h"

class QSplitter;
class QStackedWidget;

namespace rivulet::widgets {

class LivePanel;
class PathView;
class ProgramPanel;
class ProgramTextView;
class ReadingBar;
class StartSteps;
class TextPane;

class ProgramPage final : public Page {
  Q_OBJECT

 public:
  explicit ProgramPage(QWidget* parent = nullptr);

  /// @param view  null: none
  void setProgram(const std::shared_ptr<const overview::ProgramView>& view);
  /// The same program with points for another position of the tool.
  void replaceProgram(const std::shared_ptr<const overview::ProgramView>& view);
  void setTimes(const std::shared_ptr<const overview::ProgramTimes>& times);

  /// A live source in place of a program. @param agreed  with it; nothing: there is a program
  void setLive(const std::optional<live::Agreement>& agreed);

  /// Points executed so far; the text shows the line of the last one. @param count  0: none
  /// @param runLine  the line that is being executed; 0: that of the last of these points
  void setExecuted(std::size_t count, std::size_t runLine = 0);
  /// @param point  index of the first point of the run: the path before it is not executed
  void setRunBegin(std::size_t point);
  /// A run begins: path and text show it.
  void followRun();
  /// The path has the page to itself.
  void setLarge(bool isLarge);

  /// The times of the present program are known.
  [[nodiscard]] bool hasTimes() const { return m_hasTimes; }

  [[nodiscard]] PathView* path() const { return m_path; }
  [[nodiscard]] ProgramTextView* text() const;
  [[nodiscard]] TextPane* textPane() const { return m_text; }
  [[nodiscard]] ProgramPanel* panel() const { return m_panel; }
  [[nodiscard]] LivePanel* livePanel() const { return m_live; }
  [[nodiscard]] ReadingBar* readingBar() const { return m_reading; }
  /// Shown while there is neither a program nor a live source.
  [[nodiscard]] StartSteps* steps() const { return m_steps; }

  /// Shows a line in the text and its moves on the path.
  void showLine(std::size_t line);

 protected:
  void retranslate() override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showPoint(std::size_t point);
  void showSteps(bool areShown);

  std::shared_ptr<const overview::ProgramView> m_program;
  bool m_hasTimes = false;
  PathView* m_path;
  TextPane* m_text;
  ProgramPanel* m_panel;
  LivePanel* m_live;
  ReadingBar* m_reading;
  StartSteps* m_steps;
  QStackedWidget* m_all;   ///< steps, or the program
  QStackedWidget* m_side;  ///< one of both
  QSplitter* m_halves;
};

}  // namespace rivulet::widgets
