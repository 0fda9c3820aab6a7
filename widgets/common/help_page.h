// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The manual in the window: the Markdown files of `docs`, which are part of the program. Links
/// between them work; nothing is read from the network.
/// @threadsafety GUI thread.
#pragma once

#include "widgets/common/page.h"

class QTextBrowser;

namespace rivulet::widgets {

class HelpPage final : public Page {
  Q_OBJECT

 public:
  /// @param folder  of the Markdown files; may be one of the program's resources
  explicit HelpPage(const QString& folder, QWidget* parent = nullptr);

  /// Shows a file from one of its headings on. An unknown heading: from the beginning.
  void open(const QString& file, const QString& heading);
  /// The heading that stands at the top of what is shown.
  [[nodiscard]] QString headingShown() const;

 Q_SIGNALS:
  void closeRequested();

 protected:
  void restyle() override;

 private:
  QPushButton* m_back = button({.text = QT_TR_NOOP("Back")});
  QPushButton* m_close =
      button({.text = QT_TR_NOOP("Close"), .icon = "dismiss"}, &HelpPage::closeRequested);
  QTextBrowser* m_text;
};

}  // namespace rivulet::widgets
