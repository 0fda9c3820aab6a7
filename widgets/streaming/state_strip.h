// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The state of a run: Idle → Armed → Running → Stopping → Done or Aborted. The present state has a
/// filled arrow, a mark and bold text.
/// @threadsafety GUI thread.
#pragma once

#include "streaming/run.h"
#include "widgets/common/page.h"

namespace rivulet::widgets {

/// "Idle", "Armed", … in the language of the operator.
[[nodiscard]] QString runStateText(streaming::RunState state);

class StateStrip final : public Page {
  Q_OBJECT

 public:
  explicit StateStrip(QWidget* parent = nullptr);

  void setState(streaming::RunState state);
  [[nodiscard]] streaming::RunState state() const { return m_state; }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void retranslate() override;
  void restyle() override;
  void paintEvent(QPaintEvent* event) override;

 private:
  streaming::RunState m_state = streaming::RunState::Idle;
};

}  // namespace rivulet::widgets
