// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The window is to be closed while a run is in progress: asks, without covering Stop. Hidden
/// otherwise. @threadsafety GUI thread.
#pragma once

#include "widgets/common/notice_bar.h"

namespace rivulet::widgets {

class CloseBar final : public NoticeBar {
  Q_OBJECT

 public:
  explicit CloseBar(QWidget* parent = nullptr);

  /// Asks; not to close is what Return does.
  void ask();

 Q_SIGNALS:
  void stopAndCloseRequested();

 protected:
  void retranslate() override;

 private:
  QPushButton* m_keep;
  QPushButton* m_close;
};

}  // namespace rivulet::widgets
