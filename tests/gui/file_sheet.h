// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Answers the question for a file that a window shows. @threadsafety GUI thread.
#pragma once

#include <QFileDialog>
#include <QLineEdit>
#include <QTest>
#include <algorithm>

namespace rivulet::tests {

/// @param names  as typed: one, or several in quotation marks
inline void typeFileName(const QWidget& window, const QString& names) {
  const auto sheets = window.findChildren<QFileDialog*>();  // an answered one may still be there
  const auto shown = std::find_if(sheets.begin(), sheets.end(),
                                  [](const QFileDialog* sheet) { return sheet->isVisible(); });
  QVERIFY(shown != sheets.end());
  auto* name = (*shown)->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
  name->setText(names);
  QTest::keyClick(name, Qt::Key_Return);
}

}  // namespace rivulet::tests
