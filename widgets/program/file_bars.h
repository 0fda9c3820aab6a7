// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Two bars over the pages: a program is being read, and the file of the loaded one has changed.
/// Each is hidden while it does not apply. @threadsafety GUI thread.
#pragma once

#include <QTimer>
#include <optional>

#include "widgets/common/page.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace rivulet::widgets {

class LoadBar final : public Page {
  Q_OBJECT

 public:
  explicit LoadBar(QWidget* parent = nullptr);

  /// Shown only if reading takes longer than a moment: a small program is loaded before the bar
  /// appears.
  /// @param share  0 to 1; nothing: no program is being read
  void setProgress(const std::optional<double>& share, const QString& name = {});

 Q_SIGNALS:
  void cancelRequested();

 protected:
  void retranslate() override;

 private:
  QTimer m_showTimer{this};
  QString m_fileName;
  QLabel* m_name = label({});
  QProgressBar* m_bar;
  QPushButton* m_cancel =
      button({.text = QT_TR_NOOP("Cancel"), .icon = "dismiss"}, &LoadBar::cancelRequested);
};

class FileBanner final : public Page {
  Q_OBJECT

 public:
  enum class State {
    Same,     ///< nothing to say
    Changed,  ///< the file has another text
    Gone,     ///< deleted or moved away
  };

  explicit FileBanner(QWidget* parent = nullptr);

  void setState(State state);
  [[nodiscard]] State state() const { return m_state; }
  /// @param hash  of the program as loaded, which a run keeps
  void setProgram(const QString& name, const QString& hash);
  /// During a run the file cannot be reloaded.
  void setRunning(bool running);

 Q_SIGNALS:
  void reloadRequested();

 protected:
  void retranslate() override;
  void restyle() override;
  void paintEvent(QPaintEvent* event) override;

 private:
  State m_state = State::Same;
  bool m_running = false;
  QString m_fileName;
  QString m_hash;
  QLabel* m_icon = label({});
  QLabel* m_text = value({.wraps = true});
  QPushButton* m_reload = button({.text = QT_TR_NOOP("Reload")}, &FileBanner::reloadRequested);
};

}  // namespace rivulet::widgets
