// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What all cards on the board of machines have: a frame, a name, a button that opens, and one that
/// removes the card and asks before it does. @threadsafety GUI thread.
#pragma once

#include <QFrame>
#include <initializer_list>

class QLabel;
class QProgressBar;
class QPushButton;

namespace rivulet::widgets {

class ElidedLabel;

class BoardCard : public QFrame {
  Q_OBJECT

 public:
  [[nodiscard]] QPushButton* open() const { return m_open; }
  /// Pressed, the card is to be removed.
  [[nodiscard]] QPushButton* confirm() const { return m_confirm; }

 protected:
  /// @param prefix  of the names of the buttons as objects
  BoardCard(const QString& prefix, QWidget* parent);

  [[nodiscard]] ElidedLabel* name() const { return m_name; }
  [[nodiscard]] bool isAsking() const { return m_isAsking; }
  /// Below the name, above the buttons. Once.
  void addRows(std::initializer_list<QWidget*> rows);
  /// To be called when the name is set.
  /// @param isSame  the card shows what it has shown before: a question that is asked stays
  void setRemoval(bool isSame, bool canRemove, const QString& question);

 private:
  void ask(bool isAsking);
  void showQuestion();

  ElidedLabel* m_name;
  QLabel* m_question;
  QPushButton* m_open;
  QPushButton* m_remove;
  QPushButton* m_keep;
  QPushButton* m_confirm;
  bool m_canRemove = false;
  bool m_isAsking = false;
};

/// @param share  0 to 1
void showProgress(QProgressBar& bar, double share);

}  // namespace rivulet::widgets
