// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Ends a run whose axes are held by Stop. @threadsafety GUI thread.
#pragma once

#include <QTest>

#include "support/patience.h"
#include "widgets/common/hold_button.h"

namespace rivulet::tests {

inline void endByHand(const QWidget& window) {
  auto* end = window.findChild<widgets::HoldButton*>(QStringLiteral("end-here"));
  QTRY_VERIFY_WITH_TIMEOUT(end->isVisible(), kSoonMs);
  QTest::mousePress(end, Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(!end->isVisible(), kSoonMs);
  QTest::mouseRelease(end, Qt::LeftButton);
}

}  // namespace rivulet::tests
