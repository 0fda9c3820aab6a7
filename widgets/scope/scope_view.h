// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The panes, one below the other, each as high as the operator wants, and the strip of the time.
/// One of them is the current one, which takes signals. @threadsafety GUI thread.
#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

#include "widgets/common/page.h"
#include "widgets/scope/scope_pane.h"

class QSplitter;

namespace rivulet::widgets {

class TimeStrip;

class ScopeView final : public Page {
  Q_OBJECT

 public:
  static constexpr int kPanesMax = 16;

  ScopeView(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors,
            const std::vector<StopRow>* stops, QWidget* parent = nullptr);

  /// Formulas, pane by pane.
  void setArrangement(const std::vector<QStringList>& panes);
  [[nodiscard]] std::vector<QStringList> arrangement() const;
  [[nodiscard]] bool shows(const QString& formula) const;
  /// Shows a signal in a pane of its own, below the current one; it becomes the current one.
  void addPane(const QString& formula);
  /// Shows a signal in the current pane; with none, in a new one.
  void addToPane(const QString& formula);
  void removeSignal(const QString& formula);

  [[nodiscard]] const std::vector<ScopePane*>& panes() const { return m_panes; }
  void scheduleRedraw();
  void redrawNow();
  /// Heights of the panes, in relation to each other.
  [[nodiscard]] QList<int> heights() const;
  void setHeights(const QList<int>& heights);

  /// Writes all panes as they are into a file: .png as on the screen, .svg and .pdf for paper, in
  /// light colours. @param caption  one line above  @return false: it cannot be written
  [[nodiscard]] bool savePicture(const QString& path, const QString& caption);

 Q_SIGNALS:
  /// Another arrangement.
  void changed();

 protected:
  void retranslate() override {}

 private:
  void paintOn(QPainter& painter, const QString& caption);
  ScopePane* makePane(int at);
  void removePane(ScopePane* pane);
  void finishChange();

  ScopeCurves* m_curves;
  TimeWindow* m_window;
  ScopeCursors* m_cursors;
  const std::vector<StopRow>* m_stops;
  QSplitter* m_splitter;
  TimeStrip* m_strip;
  std::vector<ScopePane*> m_panes;
  ScopePane* m_current = nullptr;
};

}  // namespace rivulet::widgets
