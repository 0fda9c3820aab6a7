// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A service on the board of machines: what its machine does now. A click opens it.
/// @threadsafety GUI thread.
#pragma once

#include <QFrame>

#include "widgets/connection/service_view.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace rivulet::widgets {

class ElidedLabel;

class ServiceCard final : public QFrame {
  Q_OBJECT

 public:
  explicit ServiceCard(QWidget* parent);

  void show(const ServiceView& view);
  [[nodiscard]] const ServiceView& view() const { return m_view; }

 Q_SIGNALS:
  void openRequested(const QString& endpoint);
  void removeRequested(const QString& endpoint);

 protected:
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void ask(bool isAsking);
  void showQuestion();

  ServiceView m_view;
  ElidedLabel* m_name;
  ElidedLabel* m_endpoint;
  StatusLabel* m_state;
  ElidedLabel* m_program;
  QProgressBar* m_progress;
  QLabel* m_points;
  StatusLabel* m_waiting;
  StatusLabel* m_alarm;
  QLabel* m_question;
  QPushButton* m_open;
  QPushButton* m_remove;
  QPushButton* m_keep;
  QPushButton* m_confirm;
  bool m_isAsking = false;
};

}  // namespace rivulet::widgets
