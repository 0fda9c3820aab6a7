// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The one window: puts the pages together, holds what is open, and connects intents of the
/// pages with the session. Values flow session → window → pages; only intents flow back.
/// @threadsafety GUI thread.
#pragma once

#include <QMainWindow>
#include <QTimer>
#include <memory>
#include <optional>

#include "feasibility/verdict.h"
#include "hmi/settings.h"
#include "hmi/translator.h"
#include "session/correction_feed.h"
#include "session/file_watch.h"
#include "session/program_loader.h"
#include "session/program_timer.h"
#include "session/region_worker.h"
#include "session/stream_session.h"
#include "widgets/calibration/access_source.h"
#include "widgets/connection/machine_view.h"
#include "widgets/feasibility/simulated_region.h"

class QAction;
class QActionGroup;
class QLabel;
class QMenu;
class QTabWidget;

namespace rivulet::widgets {
class CalibrationPage;
class ConnectionPanel;
class CorrectionPanel;
class FeasibilityPage;
class FileBanner;
class LoadBar;
class LogView;
class MessageArea;
class MethodPanel;
class PathView;
class ProgramPage;
class ProgramPanel;
class ReportPanel;
class ResumeBar;
class RunPanel;
class TemplatePage;
class TracePage;
}  // namespace rivulet::widgets

namespace rivulet::hmi {

class MainWindow final : public QMainWindow {
  Q_OBJECT

 public:
  /// @param settings  where the window begins; written back to the store when it closes if
  ///                  `persistent`
  /// @param connector  opens the connections, on the streaming thread
  explicit MainWindow(Settings settings, bool persistent,
                      opcua::Connector connector = session::connectByOpcUa,
                      QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Reads a program in the background; what is loaded stays until it is there.
  void openProgram(const QString& path);
  void connectTo(const QString& endpoint);
  void setStreamSettings(const widgets::StreamSettings& settings);
  void setLanguage(const QString& language);
  void setTheme(widgets::Theme theme);
  /// Starts if nothing stands in the way. @return false and shows why otherwise
  bool start();
  void stop();
  /// Method window: the machine waits in front of the next window, or goes on.
  void hold(bool hold);
  /// Asks the control where the run was left and shows it. Nothing moves.
  void askResume();
  /// Goes on at the place shown. @return false and shows why if something stands in the way
  bool resume();

  /// The settings with the rotary axes the program turns.
  [[nodiscard]] templates::TemplateParameters parameters() const;
  /// Why no run can be resumed; empty: `askResume` may be called.
  [[nodiscard]] QString resumeBlockedReason() const;
  [[nodiscard]] QString startBlockedReason() const;
  [[nodiscard]] bool isRunning() const { return m_session.isRunning(); }
  [[nodiscard]] const std::optional<feasibility::Verdict>& verdict() const { return m_verdict; }
  [[nodiscard]] std::shared_ptr<const streaming::RunReport> lastReport() const { return m_report; }
  [[nodiscard]] const streaming::LiveUpdate& lastUpdate() const { return m_update; }
  /// The pages, for pictures and tests.
  [[nodiscard]] QTabWidget* pages() const { return m_tabs; }
  [[nodiscard]] widgets::TracePage* tracePage() const { return m_trace; }
  [[nodiscard]] widgets::CalibrationPage* calibrationPage() const { return m_calibration; }
  [[nodiscard]] const widgets::AccessSource& accessSource() const { return m_access; }
  [[nodiscard]] widgets::ProgramPage* programPage() const { return m_programPage; }
  [[nodiscard]] std::shared_ptr<const gcode::Program> program() const { return m_program; }

 Q_SIGNALS:
  void runFinished(const std::shared_ptr<const rivulet::streaming::RunReport>& report);
  void runStarted();

 protected:
  void changeEvent(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildPages();
  void buildMenus();
  void connectPages();
  void connectCorrection();
  void retranslate();

  /// @param reading  how the text is to be read
  void readProgram(const QString& path, const session::Reading& reading);
  void showProgram(const session::LoadedProgram& loaded);
  void showLoadError(const base::Error& error, const QString& path);
  void showLink(const session::LinkChanged& change);
  void showMachine(const session::MachineSeen& seen);
  void showUpdate(const streaming::LiveUpdate& update);
  void showFinished(const session::RunFinished& finished);
  void showPauses();
  void showResume(const session::ResumeFound& found);
  void forgetResume();
  bool startRun(std::optional<streaming::Resume> resume);
  /// What stands in the way whether a run begins or is resumed.
  [[nodiscard]] QString blockedReason() const;
  [[nodiscard]] streaming::RunSettings runSettings() const;
  /// Begins on cells the operator has confirmed, if nothing stands in the way.
  void calibrate(const streaming::CalibrationPlan& plan);
  [[nodiscard]] QString calibrationBlockedReason() const;
  void showCalibrated(const session::CalibrationFinished& finished);
  /// Takes what was measured on this machine before, if anything was.
  void loadCalibration();
  /// What access costs with the present method, and where the figures come from.
  [[nodiscard]] feasibility::AccessModel accessModel();
  void simulateRegion(const widgets::SimulationWanted& wanted);
  void showRegion(const session::RegionOutcome& outcome);

  /// Reads the loaded program's file again, in another way.
  void readAgain(const session::Reading& reading);
  /// Makes the points anew if the program leaves coordinates open and the tool has moved.
  void followTool();
  void showFileState(session::FileWatch::State state);
  void reckonTimes();
  [[nodiscard]] const std::vector<gcode::StreamPoint>& points() const;
  /// Everything that follows from program and settings: verdict, region, template.
  void judge();
  void refreshStart();
  void log(gcode::Severity severity, const QString& text);
  void saveText(const QString& path, const QString& text);
  [[nodiscard]] QString newRecordingPath();

  Settings m_settings;
  bool m_persistent;
  Translator m_translator;
  report::MachineStore m_machines;
  session::StreamSession m_session;
  session::ProgramLoader m_loader;
  session::ProgramTimer m_timer;
  session::FileWatch m_watch;
  session::CorrectionFeed m_feed;
  QTimer m_reckonTimer;  ///< settings change while a hand turns them: reckon when it rests
  session::RegionWorker m_region;

  std::shared_ptr<const gcode::Program> m_program;
  std::shared_ptr<const widgets::ProgramView> m_view;  ///< of `m_program`; null with it
  QString m_programPath;
  QString m_loadingPath;  ///< of the request made last
  session::Reading m_reading;
  std::optional<session::TimeSettings> m_reckonedFor;
  std::optional<feasibility::ProgramDistances> m_distances;
  std::optional<feasibility::Verdict> m_verdict;
  std::optional<QString> m_problem;
  session::LinkChanged m_link;
  widgets::MachineView m_machine;
  widgets::AccessSource m_access;
  streaming::LiveUpdate m_update;
  std::optional<base::Instant> m_runBegan;
  std::shared_ptr<const streaming::RunReport> m_report;
  std::shared_ptr<const widgets::PauseMap> m_pauses;  ///< of program and settings; null: not known
  std::optional<session::TimeSettings> m_pausesFor;
  std::optional<widgets::RunTime> m_runTime;      ///< with them
  std::optional<session::ResumeQuestion> m_left;  ///< the run that could be resumed
  std::optional<streaming::Resume> m_resume;      ///< where it would go on, as the control says
  std::size_t m_firstPoint = 0;                   ///< of the run that lasts or was the last

  widgets::MessageArea* m_messages = nullptr;
  widgets::ConnectionPanel* m_connection = nullptr;
  widgets::MethodPanel* m_method = nullptr;
  widgets::CorrectionPanel* m_correction = nullptr;
  widgets::LoadBar* m_loadBar = nullptr;
  widgets::FileBanner* m_fileBanner = nullptr;
  widgets::ProgramPage* m_programPage = nullptr;
  widgets::ProgramPanel* m_programPanel = nullptr;
  widgets::PathView* m_path = nullptr;
  widgets::FeasibilityPage* m_feasibility = nullptr;
  widgets::TracePage* m_trace = nullptr;
  widgets::CalibrationPage* m_calibration = nullptr;
  widgets::TemplatePage* m_template = nullptr;
  widgets::ReportPanel* m_reportPanel = nullptr;
  widgets::LogView* m_log = nullptr;
  QLabel* m_runProgram = nullptr;  ///< which version of which program a start runs
  widgets::ResumeBar* m_resumeBar = nullptr;
  widgets::RunPanel* m_run = nullptr;
  QTabWidget* m_tabs = nullptr;

  QMenu* m_fileMenu = nullptr;
  QMenu* m_viewMenu = nullptr;
  QMenu* m_languageMenu = nullptr;
  QMenu* m_themeMenu = nullptr;
  QMenu* m_helpMenu = nullptr;
  QAction* m_openAction = nullptr;
  QAction* m_quitAction = nullptr;
  QAction* m_aboutAction = nullptr;
  QActionGroup* m_languages = nullptr;
  QActionGroup* m_themes = nullptr;
};

}  // namespace rivulet::hmi
