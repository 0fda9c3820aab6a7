// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Marks comments, labels, R-parameters and the words of the control's language in an NC text.
/// @threadsafety GUI thread.
#pragma once

#include <QPalette>
#include <QSyntaxHighlighter>

namespace rivulet::widgets {

class NcHighlighter final : public QSyntaxHighlighter {
  Q_OBJECT

 public:
  explicit NcHighlighter(QTextDocument* document);

  void setColors(const QPalette& palette);

 protected:
  void highlightBlock(const QString& text) override;

 private:
  QPalette m_palette;
};

}  // namespace rivulet::widgets
