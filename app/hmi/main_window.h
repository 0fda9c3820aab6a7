// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The one window: makes the models and puts the parts of `hmi/pages` side by side, which connect
/// themselves. Decides nothing. @threadsafety GUI thread.
#pragma once

#include <QMainWindow>
#include <memory>
#include <optional>

#include "hmi/alarms.h"
#include "hmi/audit.h"
#include "hmi/certificates.h"
#include "hmi/control_tests.h"
#include "hmi/document.h"
#include "hmi/emulator_learning.h"
#include "hmi/found_runs.h"
#include "hmi/live_source.h"
#include "hmi/logins.h"
#include "hmi/machine_model.h"
#include "hmi/machine_profiles.h"
#include "hmi/machines.h"
#include "hmi/messages.h"
#include "hmi/net_player.h"
#include "hmi/pages/pages.h"
#include "hmi/past_runs.h"
#include "hmi/preflight.h"
#include "hmi/releases.h"
#include "hmi/run_controller.h"
#include "hmi/services.h"
#include "hmi/settings.h"
#include "hmi/traces.h"
#include "hmi/users.h"
#include "hmi/virtual_machine.h"
#include "language/translator.h"
#include "session/stream_session.h"
#include "widgets/common/parts.h"

class QAction;
class QTabWidget;
class QToolButton;

namespace rivulet::widgets {
class CalibrationPage;
class CloseBar;
class FoldingColumns;
class HelpPage;
class PlaceRail;
class PlaceTabs;
class ProgramPage;
class SheetArea;
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

  /// Reads a program in the background; the present one stays until the new one is there.
  void openProgram(const QString& path);
  /// Listens for live points in place of a program, and agrees on what may move.
  void openLive(const live::Setup& setup) { m_live.open(setup); }
  /// Opens recordings and traces on the page Traces.
  void openTraces(const QStringList& paths) { m_offline.traces.open(paths); }
  void connectTo(const QString& endpoint) {
    m_isMachineChosen = true;
    m_machine.connectTo(endpoint);
  }
  /// Shown where the operator connects; nothing is connected.
  void setEndpoint(const QString& endpoint) { m_machine.setEndpoint(endpoint); }
  void setStreamSettings(const streaming::StreamSettings& settings) {
    m_document.setSettings(settings);
  }
  /// Stops a run in progress, if there is one: its axes are held, and when they stand, the window
  /// closes. The run can be resumed.
  void stopAndClose();
  /// The same without closing, and waits until the axes stand: for the end of the session.
  void stopAndWait();
  void setLanguage(const QString& language);
  void setTheme(widgets::Theme theme);
  /// These four: see `RunController`.
  bool start() { return m_runs.start(); }
  void stop() { m_runs.end(); }
  /// Shows what a start would do; nothing moves.
  void showPreflight() { m_preflight.open(); }
  /// Shows the manual at what is on the screen, or closes it.
  void toggleHelp();
  void toggleLarge();
  void closePreflight() { m_preflight.close(); }
  void askResume() { m_runs.askResume(); }
  bool resume() { return m_runs.resume(); }

  /// One sentence in the operator's language; empty: nothing stands in the way.
  [[nodiscard]] QString startBlockedReason() const;
  [[nodiscard]] QString resumeBlockedReason() const;
  [[nodiscard]] double feedMmPerSMax() const { return m_document.feedMmPerSMax(); }
  [[nodiscard]] bool isRunning() const { return m_runs.isRunning(); }
  [[nodiscard]] const std::optional<feasibility::Verdict>& verdict() const {
    return m_document.findings().verdict;
  }
  [[nodiscard]] std::shared_ptr<const streaming::RunReport> lastReport() const {
    return m_runs.report();
  }
  [[nodiscard]] const streaming::LiveUpdate& lastUpdate() const { return m_runs.update(); }
  [[nodiscard]] const widgets::AccessSource& accessSource() const {
    return m_document.findings().source;
  }
  [[nodiscard]] std::shared_ptr<const gcode::Program> program() const {
    return m_document.program();
  }
  [[nodiscard]] Users& users() { return m_users; }
  [[nodiscard]] Releases& releases() { return m_releases; }
  /// The pages, for pictures and tests.
  [[nodiscard]] QTabWidget* pages() const;
  [[nodiscard]] widgets::TracePage* tracePage() const;
  [[nodiscard]] widgets::CalibrationPage* calibrationPage() const;
  [[nodiscard]] widgets::ProgramPage* programPage() const;

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
  void buildMenu();
  void addPages();
  void connectSteps();
  [[nodiscard]] QWidget* makeHeader(QWidget* parent);
  [[nodiscard]] QWidget* makeNotices(QWidget* parent);
  /// Not while the window is locked.
  void openPage(int page);
  void leaveSheets();
  void showColumns();
  void showCentre();
  /// What has to be decided comes to the front; what is safe has the focus.
  void showQuestion();
  void showLogin();
  void showAlarms();
  /// Where the window begins: with the machines if there are several.
  void showFirstPage();
  /// Connects what the operator does with permissions and with the audit trail.
  void watchOperator();
  /// In a locked window only Stop works.
  void showLock();
  void retranslate();
  void showTitle();

  Settings m_settings;
  bool m_persistent;
  language::Translator m_translator;
  VirtualMachine m_virtualMachine;  ///< ends after the connection to it
  Messages m_messages;
  Alarms m_alarms;
  Users m_users;
  Audit m_audit;
  session::StreamSession m_session;
  Document m_document;
  Logins m_logins;
  MachineModel m_machine;
  RunController m_runs;
  LiveSource m_live;
  Releases m_releases;
  Preflight m_preflight;
  FoundRuns m_found;
  PastRuns m_pastRuns;
  ControlTests m_tests;
  MachineProfiles m_profiles;
  Machines m_machines;
  Services m_services;
  /// What needs no machine.
  struct WithoutMachine {
    Traces traces;
    Certificates certificates;
    EmulatorLearning learning{};
    NetPlayer player{};
  };
  WithoutMachine m_offline;

  bool m_closesAfterRun = false;
  bool m_isMachineChosen = false;  ///< the page Machines does not come first

  widgets::Parts m_parts{this};
  std::vector<PageEntry> m_entries;  ///< of the tabs
  struct Buttons {
    QToolButton* machine = nullptr;
    QToolButton* setUp = nullptr;
    QToolButton* menu = nullptr;
  };
  Buttons m_buttons;
  /// What stands around the pages.
  struct Frame {
    QWidget* resumeBar = nullptr;
    QWidget* foundBar = nullptr;
    widgets::FoldingColumns* columns = nullptr;
    widgets::SheetArea* centre = nullptr;  ///< pages, preflight, what is asked, manual
    widgets::HelpPage* help = nullptr;
    QWidget* trustSheet = nullptr;
    const opcua::TrustQuestion* question = nullptr;  ///< shown; for comparison only
    widgets::PlaceRail* rail = nullptr;
    widgets::PlaceTabs* tabs = nullptr;
    widgets::CloseBar* closeBar = nullptr;
  };
  Frame m_frame;
  struct Actions {
    QAction* open = nullptr;
    QAction* live = nullptr;
    QAction* quit = nullptr;
  };
  Actions m_actions;
};

}  // namespace rivulet::hmi
