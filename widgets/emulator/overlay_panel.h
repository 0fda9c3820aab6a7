// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A machine and its emulator drawn together: positions and how far they are apart over time, and
/// both paths with their errors as large as wanted. @threadsafety GUI thread.
#pragma once

#include <QStringList>

#include "emulator/overlay.h"
#include "widgets/common/page.h"
#include "widgets/scope/scope_curves.h"
#include "widgets/scope/stop_row.h"

class QComboBox;
class QSplitter;

namespace rivulet::widgets {

class PathPane;
class ScopeCursors;
class ScopeView;
class TimeWindow;

class OverlayPanel final : public Page {
  Q_OBJECT

 public:
  explicit OverlayPanel(QWidget* parent = nullptr);

  /// Where calculations are done; without it, at once.
  void setRunner(WorkRunner runner);
  /// What can be drawn; the first is asked for. Nothing: the panel is emptied.
  void setRuns(const QStringList& names);
  /// @param overlay  of the run asked for last
  void setOverlay(const emulator::Overlay& overlay);
  /// Names of the two, and of what they differ by, in the present language.
  [[nodiscard]] emulator::OverlayNames names() const;
  [[nodiscard]] ScopeView* view() const { return m_view; }
  [[nodiscard]] PathPane* path() const { return m_path; }
  /// Draws pending changes at once: for pictures and tests.
  void redrawNow();

 Q_SIGNALS:
  void overlayRequested(int run);

 protected:
  void retranslate() override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showEnlargement();

  std::vector<StopRow> m_noStops;
  TimeWindow* m_window;
  ScopeCurves* m_curves;
  ScopeCursors* m_cursors;
  ScopeView* m_view;
  PathPane* m_path;
  QSplitter* m_body;
  QComboBox* m_run =
      list({.tip = QT_TR_NOOP("Recording on which machine and emulator are compared"),
            .name = QT_TR_NOOP("Recording"),
            .id = "emulatorOverlayRun"});
  QComboBox* m_enlargement =
      list({.tip = QT_TR_NOOP(
                "How many times larger the distance to the path of the set points is drawn"),
            .name = QT_TR_NOOP("Errors drawn larger"),
            .id = "emulatorEnlargement"});
};

}  // namespace rivulet::widgets
