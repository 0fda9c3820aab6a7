// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Start, stop and the state of a run. Stop is available in every state in which something may
/// move, needs no confirmation, and shows when the control has confirmed it. It is a programmed
/// stop at the end of a window, not a safety function.
/// @threadsafety GUI thread.
#pragma once

#include <array>
#include <optional>

#include "streaming/run.h"
#include "widgets/common/page.h"

class QGroupBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace rivulet::widgets {

class StateStrip;
class StatusLabel;

class RunPanel final : public Page {
  Q_OBJECT

 public:
  explicit RunPanel(QWidget* parent = nullptr);

  /// State, counters, margin and reason to wait, as the stream reports them.
  void setUpdate(const streaming::LiveUpdate& update);
  /// Number of points of the loaded program, before a run reports it.
  void setTotal(std::size_t points);
  /// Why Start is not possible; empty: it is.
  void setStartBlocked(const QString& reason);
  /// The present run, or the next one, can be held before a window.
  void setCanHold(bool canHold);
  /// An interrupted run can be resumed. @param reason  why it cannot (now); empty: it can
  void setResumeBlocked(const QString& reason);
  /// The stop was requested, and its deadline has passed without an answer of the control.
  void setStopUnconfirmed();

 Q_SIGNALS:
  void startRequested();
  void stopRequested();
  /// @param hold  false: continue
  void holdRequested(bool hold);
  /// Nothing moves yet: the control is to be asked for the place.
  void resumeRequested();

 protected:
  void retranslate() override;
  void restyle() override;

 private:
  void buildProgress();
  enum class StopState { None, Requested, Confirmed, Unconfirmed };

  void showAll();
  void showHoldIcon();
  [[nodiscard]] bool isActive() const;
  [[nodiscard]] QString waitingText() const;

  streaming::LiveUpdate m_update;
  QString m_startBlocked;
  StopState m_stopState = StopState::None;
  bool m_canHold = false;
  QString m_resumeBlocked;

  StateStrip* m_strip;
  QPushButton* m_start;
  QPushButton* m_stop;
  QPushButton* m_hold;
  QPushButton* m_resume;
  StatusLabel* m_startReason;
  StatusLabel* m_stopStatus;
  QGroupBox* m_progressGroup;
  QProgressBar* m_progress;
  std::array<QLabel*, 3> m_counterNames{};
  std::array<QLabel*, 3> m_counterValues{};
  QLabel* m_marginName;
  StatusLabel* m_margin;
  QLabel* m_waitingName;
  QLabel* m_waiting;
};

}  // namespace rivulet::widgets
