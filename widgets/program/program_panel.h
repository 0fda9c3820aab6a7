// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The loaded CAM program: its origin, dialect, figures and findings. Files come by button, by the
/// list of recent files, or dropped anywhere on the panel.
/// @threadsafety GUI thread.
#pragma once

#include <QStringList>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "overview/program_view.h"
#include "widgets/common/page.h"

class QBoxLayout;
class QComboBox;
class QLabel;
class QMenu;
class QPushButton;
class QSortFilterProxyModel;
class QTabWidget;
class QTableView;
class QToolButton;
class QVBoxLayout;

namespace rivulet::widgets {

class DiagnosticModel;
class DistanceChart;
class ElidedLabel;
class StatusLabel;

class ProgramPanel final : public Page {
  Q_OBJECT

 public:
  explicit ProgramPanel(QWidget* parent = nullptr);

  /// @param view  null: none is loaded
  void setProgram(std::shared_ptr<const overview::ProgramView> view);
  /// The settings with which the program was read.
  /// @param dialect   nothing: as detected
  /// @param accepted  names of the words that were accepted without being understood
  /// @param centres  meaning of I, J and K
  void setReading(std::optional<gcode::Dialect> dialect, const std::vector<std::string>& accepted,
                  gcode::CentreReading centres = gcode::CentreReading::AsProgrammed);
  /// d_min and d_min^N of the points that will be streamed; nothing if there are none.
  void setDistances(const std::optional<feasibility::ProgramDistances>& distances);
  /// @param times  null: not known (yet)
  void setTimes(std::shared_ptr<const overview::ProgramTimes> times);
  /// @param paths  newest first
  void setRecentFiles(const QStringList& paths);
  /// During a run no other program can be opened.
  void setOpenEnabled(bool enabled);
  /// Asks for a file, as the button does.
  void chooseFile();

  /// The text of the program, as the first tab. @param find  shows the fields to search it; beside
  /// the tabs
  void setTextPage(QWidget* page, QToolButton* find);

  enum Tab : std::size_t { Text, Figures, Findings };
  void showTab(Tab tab);

 Q_SIGNALS:
  void openRequested(const QString& path);
  void fileDropped(const QString& path);
  /// Points that arrive during the run are to take the place of a program.
  void liveRequested();
  /// The operator wants to see a place in the text.
  void lineChosen(std::size_t line);
  void dialectRequested(const std::optional<rivulet::gcode::Dialect>& dialect);
  /// The operator was asked and takes the responsibility.
  void acceptRequested(const QString& name);
  void takeBackRequested(const QString& name);
  /// The operator wants another meaning of I, J and K.
  void centresRequested(rivulet::gcode::CentreReading centres);

 protected:
  void retranslate() override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  enum Figure {
    Lines,
    Motions,
    Points,
    Units,
    BoundsX,
    BoundsY,
    BoundsZ,
    CutLength,
    RapidLength,
    Kinds,
    Feeds,
    ProgrammedTime,
    StreamedTime,
    PointDistance,
    WindowLength,
    Distances,
    Corners,
    FigureCount
  };

  QWidget* makeFigures();
  QWidget* makeFindings();
  void showProgram();
  void showSummary();
  void fitTitle();
  /// @param values  one per `Figure`
  void fillFigures(std::vector<QString>& values) const;
  [[nodiscard]] static QString unitsText(gcode::FileUnits units);
  [[nodiscard]] QString kindsText() const;
  [[nodiscard]] QString feedsText(const std::vector<double>& feedsMmPerMin) const;
  void showDistances();
  void showTimes();
  void showDialect();
  void showAccepted();
  void fillRecentMenu();
  void showFinding();
  void askToAccept();
  /// A row that says how the text is read, and a button that ends it.
  QPushButton* addReadingRow(const QString& text, const QString& accessibleName);
  [[nodiscard]] const gcode::Diagnostic* currentFinding() const;
  void followLink(const QString& link);

  std::shared_ptr<const overview::ProgramView> m_program;
  std::shared_ptr<const overview::ProgramTimes> m_times;
  std::optional<feasibility::ProgramDistances> m_distances;
  /// How the program was read.
  struct Reading {
    std::optional<gcode::Dialect> dialect;
    std::vector<std::string> accepted;
    gcode::CentreReading centres{gcode::CentreReading::AsProgrammed};
  };
  Reading m_reading;
  QStringList m_recentFiles;
  bool m_openEnabled = true;
  bool m_dropHovers = false;

  QPushButton* m_open =
      button({.text = QT_TR_NOOP("Open…"), .icon = "open"}, &ProgramPanel::chooseFile);
  QPushButton* m_recent = button({.text = QT_TR_NOOP("Recent")});
  QPushButton* m_live =
      button({.text = QT_TR_NOOP("Live …"),
              .tip = QT_TR_NOOP("Points that another program computes while the machine moves"),
              .id = "live-points"},
             &ProgramPanel::liveRequested);
  QMenu* m_recentMenu;
  ElidedLabel* m_name;
  ElidedLabel* m_about;  ///< below the name: lines and control
  QBoxLayout* m_title;
  QLabel* m_hash = value({.isMuted = true});
  StatusLabel* m_summary = status({.wraps = true});
  QComboBox* m_dialect = list();
  QLabel* m_evidence = value({.isMuted = true, .wraps = true});
  QTabWidget* m_tabs;
  std::array<QWidget*, 3> m_pages{};  ///< by Tab; null: not there
  std::vector<QLabel*> m_figureNames;
  std::vector<QLabel*> m_figureValues;
  DistanceChart* m_chart = nullptr;
  DiagnosticModel* m_findings;
  QSortFilterProxyModel* m_sorted;  ///< the findings in the order of the table
  QTableView* m_findingsTable;
  QLabel* m_finding =
      value({.wraps = true});  ///< the whole sentence of the finding selected in the table
  QPushButton* m_accept = button({}, &ProgramPanel::askToAccept);
  QWidget* m_acceptedArea;
  QVBoxLayout* m_acceptedRows;
};

}  // namespace rivulet::widgets
