// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A service on the board of machines: what its machine does now. A click opens it.
/// @threadsafety GUI thread.
#pragma once

#include "widgets/connection/board_card.h"
#include "widgets/connection/service_view.h"

namespace rivulet::widgets {

class ServiceCard final : public BoardCard {
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
  ServiceView m_view;
  ElidedLabel* m_endpoint;
  StatusLabel* m_state;
  ElidedLabel* m_program;
  QProgressBar* m_progress;
  QLabel* m_points;
  StatusLabel* m_waiting;
  StatusLabel* m_alarm;
};

}  // namespace rivulet::widgets
