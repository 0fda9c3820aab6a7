// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The line at the top of the window: the most important alarm and what to do, with its button to
/// acknowledge it and the number of alarms; a click opens the list. Answers to what the operator
/// has just done stand in the same place: in front of an alarm for a few seconds, else until they
/// are dismissed. @threadsafety GUI thread.
#pragma once

#include <QTimer>
#include <functional>
#include <optional>

#include "alarm/alarm.h"
#include "gcode/diagnostic.h"
#include "widgets/common/page.h"

class QLabel;
class QToolButton;

namespace rivulet::widgets {

class ElidedLabel;

class AlarmLine final : public Page {
  Q_OBJECT

 public:
  /// A text that is made again when the language changes.
  using Text = std::function<QString()>;
  static constexpr int kNoteMs = 8000;

  explicit AlarmLine(QWidget* parent = nullptr);

  /// @param alarm  the most important; nothing: there is none
  /// @param count  of all alarms that are not shelved
  void setAlarm(const std::optional<alarm::Alarm>& alarm, std::size_t count);
  void showNote(gcode::Severity severity, Text text);
  /// Removes the note.
  void clearNote();
  /// What is shown: the note, or the alarm and what to do; empty: nothing.
  [[nodiscard]] QString text() const;

 Q_SIGNALS:
  void acknowledgeRequested(int number);
  void listRequested();

 protected:
  void retranslate() override;
  void restyle() override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] gcode::Severity severity() const;
  /// Shows note or alarm, or nothing.
  void refresh();

  std::optional<alarm::Alarm> m_alarm;
  std::size_t m_count = 0;
  gcode::Severity m_noteSeverity = gcode::Severity::Note;
  Text m_note;  ///< empty: no note
  QTimer m_noteTimer;
  QLabel* m_icon = label({});
  ElidedLabel* m_title;   ///< of an alarm
  ElidedLabel* m_remedy;  ///< of an alarm
  ElidedLabel* m_noteText;
  QToolButton* m_acknowledge;
  QToolButton* m_list;
  QToolButton* m_dismiss;
};

}  // namespace rivulet::widgets
