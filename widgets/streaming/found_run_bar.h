// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A run that this window does not stream: whose it is, how far it is, and what can be done with
/// it. Hidden while there is none. @threadsafety GUI thread.
#pragma once

#include <cstddef>
#include <optional>

#include "base/instant.h"
#include "widgets/common/notice_bar.h"
#include "widgets/streaming/run_progress.h"

namespace rivulet::widgets {

struct FoundRunView {
  enum class Kind {
    Unclear,  ///< on the control; its client is being looked for
    Waiting,  ///< on the control; its client is gone
    Served,   ///< on the control, with its client
    Left,     ///< not on the control any more; kept on this computer
  };
  Kind kind = Kind::Unclear;
  int number = 0;   ///< 0: a program that waits for its first run
  QString program;  ///< empty: not known here
  QString user;     ///< empty: not known
  QString computer;
  QString startedAtUtc;      ///< ISO 8601
  bool isKeptHere = false;   ///< its checkpoint is on this computer
  std::size_t executed = 0;  ///< points, or windows if `total` is 0
  std::size_t total = 0;     ///< points; 0: not known
  bool isWatched = false;
  bool isStopping = false;  ///< a stop has been requested
  bool isHeld = false;      ///< stopped, and not ended: its axes stand
  /// Its axes move: what its program executes until it has ended, at most. Nothing: not known.
  std::optional<MotionLeft> ahead{};
  /// The stop was confirmed after this time.
  std::optional<base::Duration> stopConfirmedAfter;

  [[nodiscard]] bool isOnControl() const { return kind != Kind::Left; }
  [[nodiscard]] bool canResume() const {
    return isKeptHere && !isStopping && (kind == Kind::Waiting || kind == Kind::Left);
  }
};

/// "Run 123456 of rows.nc, started by anna on cell-pc-3 at …".
[[nodiscard]] QString foundRunText(const FoundRunView& run);

/// "Stop requested: still moving, at most 212 mm, about 34 s". @param ahead  nothing: not known
[[nodiscard]] QString stopRequestedText(const std::optional<MotionLeft>& ahead);

class FoundRunBar final : public NoticeBar {
  Q_OBJECT

 public:
  explicit FoundRunBar(QWidget* parent = nullptr);

  /// @param run  nothing: none, or it is not to be shown
  void setRun(const std::optional<FoundRunView>& run);

 Q_SIGNALS:
  void watchRequested(bool watch);
  void stopRequested();
  /// The program goes on to the end of its window, and ends.
  void endRequested();
  void resumeRequested();
  void dismissed();

 protected:
  void retranslate() override;

 private:
  [[nodiscard]] QString text() const;

  std::optional<FoundRunView> m_run;
  QPushButton* m_watch;
  QPushButton* m_stop;
  QPushButton* m_end;
  QPushButton* m_resume;
  QPushButton* m_dismiss;
};

}  // namespace rivulet::widgets
