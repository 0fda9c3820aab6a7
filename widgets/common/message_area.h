// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The one place for messages to the operator: the newest message, with its severity as shape and
/// text, to be copied or dismissed. Hidden while there is none. Two lines: the tool tip and the log
/// have all of a longer one.
/// @threadsafety GUI thread.
#pragma once

#include "gcode/diagnostic.h"
#include "widgets/common/page.h"

class QLabel;
class QToolButton;

namespace rivulet::widgets {

class ElidedLabel;

class MessageArea final : public Page {
  Q_OBJECT

 public:
  using Severity = gcode::Severity;

  explicit MessageArea(QWidget* parent = nullptr);

  void showMessage(Severity severity, const QString& text);
  /// Removes the message without a signal.
  void clear();
  [[nodiscard]] QString text() const;

 Q_SIGNALS:
  void dismissed();

 protected:
  void retranslate() override;
  void restyle() override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  Severity m_severity = Severity::Note;
  QLabel* m_icon;
  QLabel* m_severityText;
  ElidedLabel* m_text;
  QToolButton* m_copy;
  QToolButton* m_dismiss;
};

}  // namespace rivulet::widgets
