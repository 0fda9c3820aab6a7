// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The path override of a run, as on the switch of a machine: a slider with a detent at 100 %, and
/// a step up and down for a finger or a key (Ctrl++, Ctrl+-). In percent. @threadsafety GUI thread.
#pragma once

#include "widgets/common/page.h"

class QPushButton;
class QSlider;

namespace rivulet::widgets {

class OverrideControl final : public Page {
  Q_OBJECT

 public:
  static constexpr int kStepPercent = 5;

  explicit OverrideControl(QWidget* parent = nullptr);

  /// What who is there may set.
  void setMax(double percent);
  /// What the run has; nothing is requested.
  void setPercent(double percent);
  /// In a narrow strip the buttons alone have room.
  void setNarrow(bool isNarrow);

 Q_SIGNALS:
  void percentRequested(double percent);

 private:
  void step(int steps);
  void request(int percent);
  void showPercent();

  int m_percent = 100;
  QLabel* m_text;
  QSlider* m_slider;
  QPushButton* m_less;
  QPushButton* m_more;
};

}  // namespace rivulet::widgets
