// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The loaded CAM program: where it comes from, its figures and what is wrong with it. Files
/// come by button, by the list of recent files, or dropped anywhere on the panel.
/// @threadsafety GUI thread.
#pragma once

#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "feasibility/verdict.h"
#include "gcode/program.h"
#include "widgets/common/page.h"

class QGridLayout;
class QGroupBox;
class QLabel;
class QMenu;
class QPushButton;
class QTableView;

namespace rivulet::widgets {

class DiagnosticModel;
class StatusLabel;

class ProgramPanel final : public Page {
  Q_OBJECT

 public:
  explicit ProgramPanel(QWidget* parent = nullptr);

  /// @param program  null: none is loaded
  void setProgram(std::shared_ptr<const gcode::Program> program);
  /// d_min and d_min^N of the points that will be streamed; nothing if there are none.
  void setDistances(const std::optional<feasibility::ProgramDistances>& distances);
  /// @param paths  newest first
  void setRecentFiles(const QStringList& paths);
  /// While a run lasts another program cannot be opened.
  void setOpenEnabled(bool enabled);
  /// Asks for a file, as the button does.
  void chooseFile();

 Q_SIGNALS:
  void openRequested(const QString& path);
  void fileDropped(const QString& path);

 protected:
  void retranslate() override;
  void restyle() override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  enum Figure {
    Lines,
    Motions,
    Points,
    BoundsX,
    BoundsY,
    BoundsZ,
    CutLength,
    RapidLength,
    Feeds,
    PointDistance,
    WindowLength,
    FigureCount
  };

  void showProgram();
  void showDistances();
  void fillRecentMenu();
  void showFinding();

  std::shared_ptr<const gcode::Program> m_program;
  std::optional<feasibility::ProgramDistances> m_distances;
  QStringList m_recentFiles;
  bool m_openEnabled = true;
  bool m_dropHovers = false;

  QPushButton* m_open;
  QPushButton* m_recent;
  QMenu* m_recentMenu;
  QLabel* m_name;
  QLabel* m_hash;
  StatusLabel* m_summary;
  QGroupBox* m_figuresGroup;
  std::vector<QLabel*> m_figureNames;
  std::vector<QLabel*> m_figureValues;
  QGroupBox* m_findingsGroup;
  DiagnosticModel* m_findings;
  QTableView* m_findingsTable;
  QLabel* m_finding;  ///< the whole sentence of the finding chosen in the table
};

}  // namespace rivulet::widgets
