// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDateTime>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QScrollArea>
#include <QSplitter>
#include <QStandardPaths>
#include <QStyle>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "base/units.h"
#include "report/calibration_json.h"
#include "report/operating_point.h"
#include "templates/generator.h"
#include "trace/file.h"
#include "widgets/calibration/calibration_page.h"
#include "widgets/common/error_text.h"
#include "widgets/common/log_view.h"
#include "widgets/common/message_area.h"
#include "widgets/common/number_format.h"
#include "widgets/connection/connection_panel.h"
#include "widgets/feasibility/feasibility_page.h"
#include "widgets/program/file_bars.h"
#include "widgets/program/path_view.h"
#include "widgets/program/program_page.h"
#include "widgets/program/program_panel.h"
#include "widgets/streaming/correction_panel.h"
#include "widgets/streaming/method_panel.h"
#include "widgets/streaming/report_panel.h"
#include "widgets/streaming/resume_bar.h"
#include "widgets/streaming/run_panel.h"
#include "widgets/templates/template_page.h"
#include "widgets/trace/trace_page.h"

namespace rivulet::hmi {

namespace {

using gcode::Severity;

/// Points a simulation of the region is made with.
constexpr std::size_t kSimulatedPoints = 200;
/// Where the tool is taken to stand while no machine has been seen.
constexpr base::Vec3 kOriginMm{0.0, 0.0, 0.0};
/// After the last change of a setting the time of the run is reckoned again.
constexpr int kReckonMs = 400;
/// From here on the points a program leaves open are made anew.
constexpr double kToolMovedMm = 0.01;

/// Where the command line looks as well, except in Qt's test mode.
report::MachineFolders machineFolders() {
  const auto path = [](QStandardPaths::StandardLocation location) {
    return std::filesystem::path(QStandardPaths::writableLocation(location).toStdString());
  };
  return report::MachineFolders::below(path(QStandardPaths::GenericDataLocation),
                                       path(QStandardPaths::GenericConfigLocation));
}

widgets::ConnectionState connectionState(session::LinkState state) {
  switch (state) {
    case session::LinkState::Disconnected:
      return widgets::ConnectionState::Disconnected;
    case session::LinkState::Connecting:
      return widgets::ConnectionState::Connecting;
    case session::LinkState::Connected:
      return widgets::ConnectionState::Connected;
    case session::LinkState::Lost:
      return widgets::ConnectionState::Lost;
  }
  return widgets::ConnectionState::Disconnected;
}

/// Counted in the whole program, also for a run that was resumed.
streaming::Counters inProgram(streaming::Counters counters, std::size_t firstPoint) {
  if (counters.total > 0) {
    counters.sent += firstPoint;
    counters.accepted += firstPoint;
    counters.executed += firstPoint;
    counters.total += firstPoint;
  }
  return counters;
}

/// A column that scrolls when the window is lower than its page. It is never narrower than its
/// page: a cut button cannot be pressed.
class Column final : public QScrollArea {
 public:
  Column(QWidget* page, QWidget* parent) : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidget(page);
  }

 protected:
  bool eventFilter(QObject* object, QEvent* event) override {
    if (object == widget() && event->type() == QEvent::LayoutRequest) {
      const QSize page = widget()
                             ->sizeHint()
                             .expandedTo(widget()->minimumSizeHint())
                             .expandedTo(widget()->minimumSize());
      setMinimumWidth(page.width() + style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    }
    return QScrollArea::eventFilter(object, event);
  }
};

}  // namespace

MainWindow::MainWindow(Settings settings, bool persistent, opcua::Connector connector,
                       QWidget* parent)
    : QMainWindow(parent),
      m_settings(std::move(settings)),
      m_persistent(persistent),
      m_machines(machineFolders()),
      m_session(std::move(connector), m_machines) {
  m_translator.setLanguage(m_settings.language);
  widgets::applyTheme(m_settings.theme);
  setAcceptDrops(true);
  buildPages();
  buildMenus();
  connectPages();
  m_connection->setEndpoint(m_settings.endpoint);
  m_programPanel->setRecentFiles(m_settings.recentFiles);
  m_method->setSettings(m_settings.stream);
  retranslate();
  judge();
  resize(1440, 900);
  if (!m_settings.geometry.isEmpty()) {
    restoreGeometry(m_settings.geometry);
  }
}

MainWindow::~MainWindow() = default;

void MainWindow::buildPages() {
  auto* central = new QWidget(this);
  auto* rows = new QVBoxLayout(central);
  m_messages = new widgets::MessageArea(central);
  rows->addWidget(m_messages);
  m_loadBar = new widgets::LoadBar(central);
  rows->addWidget(m_loadBar);
  m_fileBanner = new widgets::FileBanner(central);
  rows->addWidget(m_fileBanner);

  auto* columns = new QSplitter(Qt::Horizontal, central);
  m_connection = new widgets::ConnectionPanel;
  columns->addWidget(new Column(m_connection, columns));

  m_tabs = new QTabWidget(columns);
  m_programPage = new widgets::ProgramPage(m_tabs);
  m_path = m_programPage->path();
  m_programPanel = m_programPage->panel();
  m_feasibility = new widgets::FeasibilityPage(m_tabs);
  m_trace = new widgets::TracePage(m_tabs);
  m_template = new widgets::TemplatePage(m_tabs);
  m_calibration = new widgets::CalibrationPage(m_tabs);
  m_reportPanel = new widgets::ReportPanel(m_tabs);
  m_log = new widgets::LogView(m_tabs);
  for (QWidget* page : {static_cast<QWidget*>(m_programPage), static_cast<QWidget*>(m_feasibility),
                        static_cast<QWidget*>(m_trace), static_cast<QWidget*>(m_template),
                        static_cast<QWidget*>(m_calibration), static_cast<QWidget*>(m_reportPanel),
                        static_cast<QWidget*>(m_log)}) {
    m_tabs->addTab(page, QString());
  }
  columns->addWidget(m_tabs);

  m_method = new widgets::MethodPanel;
  m_correction = new widgets::CorrectionPanel;
  auto* right = new QWidget;
  auto* rightRows = new QVBoxLayout(right);
  rightRows->setContentsMargins(0, 0, 0, 0);
  rightRows->setSpacing(0);
  rightRows->addWidget(m_correction);
  rightRows->addWidget(m_method, 1);
  columns->addWidget(new Column(right, columns));
  columns->setStretchFactor(0, 0);
  columns->setStretchFactor(1, 1);
  columns->setStretchFactor(2, 0);
  columns->setChildrenCollapsible(false);
  rows->addWidget(columns, 1);

  m_resumeBar = new widgets::ResumeBar(central);
  rows->addWidget(m_resumeBar);
  m_runProgram = widgets::makeValueLabel(central);
  m_runProgram->setContentsMargins(12, 0, 12, 0);
  m_runProgram->hide();
  rows->addWidget(m_runProgram);
  m_run = new widgets::RunPanel(central);
  rows->addWidget(m_run);
  setCentralWidget(central);
}

void MainWindow::buildMenus() {
  m_fileMenu = menuBar()->addMenu(QString());
  m_openAction = m_fileMenu->addAction(QString(), this, [this] { m_programPanel->chooseFile(); });
  m_openAction->setShortcut(QKeySequence::Open);
  m_fileMenu->addSeparator();
  m_quitAction = m_fileMenu->addAction(QString(), this, &MainWindow::close);
  m_quitAction->setShortcut(QKeySequence::Quit);

  m_viewMenu = menuBar()->addMenu(QString());
  m_languageMenu = m_viewMenu->addMenu(QString());
  m_languages = new QActionGroup(this);
  const auto addLanguage = [this](const QString& name, const QString& code) {
    // A language is named in itself, so that everybody finds the own one.
    QAction* action = m_languageMenu->addAction(name, this, [this, code] { setLanguage(code); });
    action->setCheckable(true);
    action->setChecked(m_translator.language() == code);
    m_languages->addAction(action);
  };
  addLanguage(QStringLiteral("English"), QStringLiteral("en"));
  addLanguage(QStringLiteral("Deutsch"), QStringLiteral("de"));
  m_themeMenu = m_viewMenu->addMenu(QString());
  m_themes = new QActionGroup(this);
  for (const widgets::Theme theme :
       {widgets::Theme::Light, widgets::Theme::Dark, widgets::Theme::System}) {
    QAction* action = m_themeMenu->addAction(QString(), this, [this, theme] { setTheme(theme); });
    action->setCheckable(true);
    action->setChecked(m_settings.theme == theme);
    m_themes->addAction(action);
  }

  m_helpMenu = menuBar()->addMenu(QString());
  m_aboutAction = m_helpMenu->addAction(QString(), this, [this] {
    QMessageBox::about(this, tr("About Rivulet"),
                       tr("Rivulet %1\nStreams a tool path to a CNC machine over OPC UA while the "
                          "machine moves.\n\nStop ends the program at the end of its loop. It is "
                          "not an emergency stop.\n\nGPL-3.0-or-later")
                           .arg(QStringLiteral(RIVULET_VERSION)));
  });
}

void MainWindow::connectPages() {
  using widgets::ConnectionPanel;
  connect(m_connection, &ConnectionPanel::connectRequested, this, &MainWindow::connectTo);
  connect(m_connection, &ConnectionPanel::disconnectRequested, this,
          [this] { m_session.disconnectFrom(); });
  connect(m_programPanel, &widgets::ProgramPanel::openRequested, this, &MainWindow::openProgram);
  connect(m_programPanel, &widgets::ProgramPanel::fileDropped, this, &MainWindow::openProgram);
  connect(m_method, &widgets::MethodPanel::settingsChanged, this,
          [this](const widgets::StreamSettings& stream) {
            m_settings.stream = stream;
            judge();
          });
  connect(m_feasibility, &widgets::FeasibilityPage::operatingPointRequested, this,
          [this](const feasibility::OperatingPoint& point) {
            m_settings.stream.parameters.pointsPerLoop = point.pointsPerLoop;
            m_settings.stream.deltaMm = point.deltaMm;
            m_settings.stream.feedMmPerS = point.feedMmPerS;
            m_method->setSettings(m_settings.stream);
            judge();
          });
  connect(m_feasibility, &widgets::FeasibilityPage::simulationRequested, this,
          &MainWindow::simulateRegion);
  connect(m_feasibility, &widgets::FeasibilityPage::simulationCancelRequested, &m_region,
          &session::RegionWorker::cancel);
  connect(&m_region, &session::RegionWorker::progressed, m_feasibility,
          &widgets::FeasibilityPage::setSimulationProgress);
  connect(&m_region, &session::RegionWorker::cancelled, m_feasibility,
          [this] { m_feasibility->setSimulationProgress(std::nullopt); });
  connect(&m_region, &session::RegionWorker::finished, this,
          [this](const std::shared_ptr<const session::RegionOutcome>& outcome) {
            showRegion(*outcome);
          });
  connect(m_calibration, &widgets::CalibrationPage::calibrationRequested, this,
          &MainWindow::calibrate);
  connect(m_calibration, &widgets::CalibrationPage::cancelRequested, &m_session,
          &session::StreamSession::stop);
  connect(&m_session, &session::StreamSession::calibrationProgressed, this,
          [this](const streaming::CalibrationProgress& progress) {
            if (m_session.isCalibrating()) {
              m_calibration->setProgress(progress);
            }
          });
  connect(&m_session, &session::StreamSession::calibrationFinished, this,
          &MainWindow::showCalibrated);
  connect(m_template, &widgets::TemplatePage::saveRequested, this,
          [this](const QString& path) { saveText(path, m_template->text()); });
  connect(m_log, &widgets::LogView::saveRequested, this,
          [this](const QString& path) { saveText(path, m_log->toText()); });
  connectCorrection();
  connect(m_run, &widgets::RunPanel::startRequested, this, &MainWindow::start);
  connect(m_run, &widgets::RunPanel::stopRequested, this, &MainWindow::stop);
  connect(m_run, &widgets::RunPanel::holdRequested, this, &MainWindow::hold);
  connect(m_run, &widgets::RunPanel::resumeRequested, this, &MainWindow::askResume);
  connect(m_resumeBar, &widgets::ResumeBar::goOnRequested, this, &MainWindow::resume);
  connect(m_resumeBar, &widgets::ResumeBar::dismissed, this, &MainWindow::forgetResume);

  using widgets::ProgramPanel;
  connect(m_programPanel, &ProgramPanel::dialectRequested, this,
          [this](const std::optional<gcode::Dialect>& dialect) {
            session::Reading reading = m_reading;
            reading.dialect = dialect;
            readAgain(reading);
          });
  connect(m_programPanel, &ProgramPanel::acceptRequested, this, [this](const QString& name) {
    session::Reading reading = m_reading;
    reading.accepted.push_back(name.toStdString());
    readAgain(reading);
  });
  connect(m_programPanel, &ProgramPanel::takeBackRequested, this, [this](const QString& name) {
    session::Reading reading = m_reading;
    std::erase(reading.accepted, name.toStdString());
    readAgain(reading);
  });
  connect(m_programPanel, &ProgramPanel::centresRequested, this,
          [this](gcode::CentreReading centres) {
            session::Reading reading = m_reading;
            reading.centres = centres;
            readAgain(reading);
          });
  connect(m_loadBar, &widgets::LoadBar::cancelRequested, &m_loader,
          &session::ProgramLoader::cancel);
  connect(m_fileBanner, &widgets::FileBanner::reloadRequested, this,
          [this] { readAgain(m_reading); });
  connect(&m_loader, &session::ProgramLoader::progressed, this, [this](double share) {
    m_loadBar->setProgress(share, QFileInfo(m_loadingPath).fileName());
  });
  connect(&m_loader, &session::ProgramLoader::loaded, this, &MainWindow::showProgram);
  connect(&m_loader, &session::ProgramLoader::failed, this, &MainWindow::showLoadError);
  connect(&m_loader, &session::ProgramLoader::cancelled, this, [this] {
    m_loadBar->setProgress(std::nullopt);
    m_programPanel->setReading(m_reading.dialect, m_reading.accepted, m_reading.centres);
    log(Severity::Note, tr("Reading %1 was cancelled.").arg(m_loadingPath));
  });
  connect(&m_loader, &session::ProgramLoader::placed, this,
          [this](const std::shared_ptr<const widgets::ProgramView>& view,
                 const std::shared_ptr<const widgets::ProgramView>& of) {
            if (of != m_view) {
              return;
            }
            m_view = view;
            m_programPage->replaceProgram(m_view);
            m_pauses.reset();
            m_reckonedFor.reset();
            if (!m_session.isRunning()) {
              // What a run came to stays on show; the tool stands elsewhere behind it.
              if (!m_report) {
                m_run->setTotal(points().size());
              }
              judge();
            }
          });
  connect(&m_watch, &session::FileWatch::stateChanged, this, &MainWindow::showFileState);
  connect(&m_timer, &session::ProgramTimer::reckoned, this,
          [this](const std::shared_ptr<const widgets::ProgramTimes>& times,
                 const std::shared_ptr<const widgets::ProgramView>& view) {
            if (m_view && view->program == m_program && times->atS.size() == points().size()) {
              m_programPage->setTimes(times);
              m_runTime = times->run;
              showPauses();
            }
          });
  connect(&m_timer, &session::ProgramTimer::planned, this,
          [this](const std::shared_ptr<const widgets::PauseMap>& pauses,
                 const std::shared_ptr<const widgets::ProgramView>& view) {
            if (m_view == view) {
              m_pauses = pauses;
              m_pausesFor = m_reckonedFor;
              m_path->setPauses(pauses);
              showPauses();
            }
          });
  m_reckonTimer.setSingleShot(true);
  m_reckonTimer.setInterval(kReckonMs);
  connect(&m_reckonTimer, &QTimer::timeout, this, &MainWindow::reckonTimes);
  connect(&m_session, &session::StreamSession::linkChanged, this, &MainWindow::showLink);
  connect(&m_session, &session::StreamSession::machineSeen, this, &MainWindow::showMachine);
  connect(&m_session, &session::StreamSession::updateArrived, this, &MainWindow::showUpdate);
  connect(&m_session, &session::StreamSession::runFinished, this, &MainWindow::showFinished);
  connect(&m_session, &session::StreamSession::resumeFound, this, &MainWindow::showResume);
  connect(&m_session, &session::StreamSession::noteArrived, this, [this](const trace::Note& note) {
    log(Severity::Note, QString::fromStdString(note.text));
  });
}

void MainWindow::connectCorrection() {
  using widgets::CorrectionPanel;
  connect(m_correction, &CorrectionPanel::correctionRequested, this,
          [this](const base::Vec3& valueMm) { m_session.correct(valueMm); });
  connect(m_correction, &CorrectionPanel::inputChanged, this,
          [this](const widgets::CorrectionInput& input) {
            if (input.isLive) {
              m_feed.open(static_cast<quint16>(input.port),
                          static_cast<int>(input.silenceS * 1000.0));
            } else {
              m_feed.close();
            }
          });
  connect(&m_feed, &session::CorrectionFeed::valueArrived, this,
          [this](const base::Vec3& valueMm) { m_session.correct(valueMm); });
  connect(
      &m_feed, &session::CorrectionFeed::stateChanged, this,
      [this](const session::FeedState& state) {
        m_correction->setLiveSource({state.isOpen, state.hasValue, state.isSilent, state.unknown});
      });
}

void MainWindow::retranslate() {
  setWindowTitle(m_program ? tr("%1 – Rivulet").arg(QString::fromStdString(m_program->name))
                           : tr("Rivulet"));
  const QStringList titles{tr("Program"),     tr("Feasibility"), tr("Traces"), tr("Template"),
                           tr("Calibration"), tr("Report"),      tr("Log")};
  for (int i = 0; i < m_tabs->count(); ++i) {
    m_tabs->setTabText(i, titles[i]);
  }
  m_fileMenu->setTitle(tr("&File"));
  m_openAction->setText(tr("&Open program …"));
  m_quitAction->setText(tr("&Quit"));
  m_viewMenu->setTitle(tr("&View"));
  m_languageMenu->setTitle(tr("&Language"));
  m_themeMenu->setTitle(tr("&Theme"));
  const QList<QAction*> themes = m_themes->actions();
  themes[0]->setText(tr("Light"));
  themes[1]->setText(tr("Dark"));
  themes[2]->setText(tr("As the system"));
  m_helpMenu->setTitle(tr("&Help"));
  m_aboutAction->setText(tr("&About Rivulet"));
  refreshStart();
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange && m_aboutAction != nullptr) {
    retranslate();
    judge();
  }
  QMainWindow::changeEvent(event);
}

void MainWindow::setLanguage(const QString& language) {
  m_settings.language = language;
  m_translator.setLanguage(language);
  if (m_translator.language() == QLatin1String("en")) {
    // Without a translator to install no event would come.
    QEvent change(QEvent::LanguageChange);
    const QWidgetList widgets = QApplication::allWidgets();
    for (QWidget* widget : widgets) {
      QApplication::sendEvent(widget, &change);
    }
  }
}

void MainWindow::setTheme(widgets::Theme theme) {
  m_settings.theme = theme;
  widgets::applyTheme(theme);
}

void MainWindow::setStreamSettings(const widgets::StreamSettings& settings) {
  m_settings.stream = settings;
  m_method->setSettings(settings);
  judge();
}

void MainWindow::openProgram(const QString& path) {
  if (m_session.isRunning()) {
    m_messages->showMessage(Severity::Warning,
                            tr("A run is in progress. Open another program after it has ended."));
    return;
  }
  readProgram(path, {});
}

void MainWindow::readAgain(const session::Reading& reading) {
  if (m_program && !m_session.isRunning()) {
    readProgram(m_programPath, reading);
  }
}

void MainWindow::readProgram(const QString& path, const session::Reading& reading) {
  m_loadingPath = path;
  m_loadBar->setProgress(0.0, QFileInfo(path).fileName());
  m_loader.load({path, reading, m_machine.positionMm.value_or(kOriginMm),
                 std::max(2, m_settings.stream.parameters.pointsPerLoop)});
}

void MainWindow::showProgram(const session::LoadedProgram& loaded) {
  m_loadBar->setProgress(std::nullopt);
  if (m_session.isRunning()) {
    return;  // a run began while it was read: what runs stays what is shown
  }
  m_view = loaded.view;
  m_program = m_view->program;
  m_programPath = QFileInfo(loaded.request.path).absoluteFilePath();
  m_reading = loaded.request.reading;
  m_region.cancel();
  m_feasibility->clearRegions();
  m_settings.addRecentFile(m_programPath);
  m_programPanel->setRecentFiles(m_settings.recentFiles);
  m_programPage->setProgram(m_view);
  m_programPanel->setReading(m_reading.dialect, m_reading.accepted, m_reading.centres);
  const QString name = QString::fromStdString(m_program->name);
  const QString hash = QString::fromStdString(m_program->hash);
  m_fileBanner->setProgram(name, hash);
  m_fileBanner->setState(widgets::FileBanner::State::Same);
  m_watch.watch(m_programPath, loaded.stamp);
  m_run->setTotal(points().size());
  m_messages->clear();
  log(Severity::Note,
      tr("Opened %1 (%2), %3 points.").arg(name, hash, widgets::countText(points().size())));
  if (m_program->isUnderstood() && !m_program->isStreamable()) {
    m_messages->showMessage(
        Severity::Error,
        points().empty()
            ? tr("%1 moves no axis: there is nothing to stream.").arg(name)
            : tr("%1 needs a transformation of the control. No method can stream it.").arg(name));
  } else if (!m_program->isStreamable()) {
    m_messages->showMessage(Severity::Error, tr("Parts of the path of %1 are not known: see the "
                                                "findings. The program cannot be streamed.")
                                                 .arg(name));
  }
  m_timer.cancel();
  m_reckonedFor.reset();
  m_pauses.reset();
  m_runTime.reset();
  m_left.reset();  // the points of another program are not those of the run
  forgetResume();
  retranslate();
  judge();
}

void MainWindow::showFileState(session::FileWatch::State state) {
  using State = widgets::FileBanner::State;
  switch (state) {
    case session::FileWatch::State::Same:
      m_fileBanner->setState(State::Same);
      return;
    case session::FileWatch::State::Changed:
      m_fileBanner->setState(State::Changed);
      log(Severity::Warning, tr("The file %1 has changed.").arg(m_programPath));
      return;
    case session::FileWatch::State::Gone:
      m_fileBanner->setState(State::Gone);
      log(Severity::Warning, tr("The file %1 is no longer there.").arg(m_programPath));
      return;
  }
}

void MainWindow::followTool() {
  const base::Vec3 startMm = m_machine.positionMm.value_or(kOriginMm);
  // Axes at rest tremble; a hundredth of a millimetre is not seen.
  if (m_view && m_view->dependsOnStart && base::isFinite(startMm) &&
      base::distance(m_view->startMm, startMm) > kToolMovedMm) {
    m_loader.place(m_view, startMm, std::max(2, m_settings.stream.parameters.pointsPerLoop));
  }
}

void MainWindow::reckonTimes() {
  const session::TimeSettings settings{m_settings.stream.parameters.method,
                                       m_settings.stream.parameters.pointsPerLoop,
                                       m_settings.stream.feedMmPerS};
  // The processors belong to the stream.
  if (!m_view || points().size() < 2 || m_session.isRunning() || m_reckonedFor == settings ||
      !(settings.feedMmPerS > 0.0)) {
    return;
  }
  m_reckonedFor = settings;
  m_timer.start(m_view, settings);
}

void MainWindow::showPauses() {
  // Of other settings than those that stand there they would mislead.
  const session::TimeSettings settings{m_settings.stream.parameters.method,
                                       m_settings.stream.parameters.pointsPerLoop,
                                       m_settings.stream.feedMmPerS};
  if (!m_pauses || !m_pausesFor || m_pausesFor->method != settings.method ||
      m_pausesFor->pointsPerLoop != settings.pointsPerLoop) {
    m_path->setPauses(nullptr);
    m_method->setPauses(std::nullopt);
    return;
  }
  widgets::PauseSummary summary;
  summary.count = m_pauses->count();
  summary.inCut = m_pauses->inCut.size();
  if (m_runTime && m_pausesFor == settings && m_runTime->pauses == summary.count) {
    summary.costS = m_runTime->pausesCostS();
    summary.totalS = m_runTime->totalS;
  }
  m_method->setPauses(summary);
}

const std::vector<gcode::StreamPoint>& MainWindow::points() const {
  static const std::vector<gcode::StreamPoint> none;
  return m_view ? m_view->points.points : none;
}

void MainWindow::showLoadError(const base::Error& error, const QString& path) {
  m_loadBar->setProgress(std::nullopt);
  m_programPanel->setReading(m_reading.dialect, m_reading.accepted, m_reading.centres);
  const QString text = widgets::errorText(error);
  m_messages->showMessage(Severity::Error, text);
  log(Severity::Error, QStringLiteral("%1: %2").arg(path, text));
}

void MainWindow::connectTo(const QString& endpoint) {
  m_settings.endpoint = endpoint;
  m_connection->setEndpoint(endpoint);
  m_session.connectTo(endpoint);
}

void MainWindow::showLink(const session::LinkChanged& change) {
  m_link = change;
  const QString why = change.error.code ? widgets::errorText(change.error) : QString();
  m_connection->setConnectionState(connectionState(change.state), why);
  m_machine.isVirtualMachine = change.isVirtualMachine;
  if (change.state != session::LinkState::Connected) {
    m_machine.isStale = m_machine.positionMm.has_value();
  }
  m_connection->setMachineState(m_machine);
  switch (change.state) {
    case session::LinkState::Connected:
      m_messages->clear();
      loadCalibration();
      log(Severity::Note,
          change.isVirtualMachine
              ? tr("Connected to the virtual machine at %1.").arg(m_settings.endpoint)
              : tr("Connected to the control at %1.").arg(m_settings.endpoint));
      break;
    case session::LinkState::Disconnected:
    case session::LinkState::Lost:
      if (!why.isEmpty()) {
        m_messages->showMessage(Severity::Error, why);
        log(Severity::Error, why);
      }
      break;
    case session::LinkState::Connecting:
      break;
  }
  refreshStart();
}

void MainWindow::showMachine(const session::MachineSeen& seen) {
  m_machine.channelStatus = seen.channelStatus;
  m_machine.programStatus = seen.programStatus;
  m_machine.alarmNumber = seen.alarm;
  m_machine.programName = QString::fromStdString(seen.programName);
  m_machine.message = QString::fromStdString(seen.message);
  m_machine.positionMm = seen.positionMm;
  m_machine.feedMmPerS = seen.feedMmPerS;
  m_machine.rotaryAxes = seen.rotaryAxes;
  m_machine.rotaryDeg = seen.rotaryDeg;
  m_machine.isStale = false;
  m_connection->setMachineState(m_machine);
  m_path->setToolPosition(seen.positionMm);
  // A run that was left has the points it began with.
  if (!m_session.isRunning() && !m_left) {
    followTool();
  }
  refreshStart();
}

void MainWindow::judge() {
  streaming::RunSettings settings;
  settings.parameters = parameters();
  settings.deltaMm = m_settings.stream.deltaMm;
  settings.feedMmPerS = m_settings.stream.feedMmPerS;
  const feasibility::OperatingPoint point = report::operatingPointOf(settings);
  const feasibility::AccessModel access = accessModel();
  m_verdict.reset();
  m_problem.reset();
  m_distances.reset();
  const templates::TemplateParameters& chosen = settings.parameters;
  const auto cells = templates::planCells(chosen);
  const auto text = templates::generateTemplate(chosen);
  if (cells && text) {
    m_template->setTemplate(QString::fromStdString(*text),
                            QString::fromStdString(templates::templateFileName(chosen)), *cells,
                            templates::layoutNumber(chosen));
  } else {
    m_problem = widgets::errorText(cells ? text.error() : cells.error());
    m_template->setProblem(*m_problem);
  }
  if (!m_program) {
    m_problem = m_problem.value_or(tr("No program is loaded."));
  } else if (points().size() >= 2) {
    if (m_view->distancesFor == point.pointsPerLoop) {
      m_distances = m_view->distances;
    } else if (point.pointsPerLoop >= 2) {
      m_distances = feasibility::programDistances(points(), point.pointsPerLoop);
    }
    if (!m_problem && m_distances) {
      const auto verdict = feasibility::judge(point, *m_distances, access);
      if (verdict) {
        m_verdict = *verdict;
      } else {
        m_problem = widgets::errorText(verdict.error());
      }
    }
  } else {
    m_problem = tr("The program has fewer than two points.");
  }
  m_programPanel->setDistances(m_distances);
  m_path->setOperatingPoint(point, access);
  m_reckonTimer.start();
  showPauses();
  m_method->setVerdict(m_verdict, m_problem);
  m_correction->setLimit(
      cells && cells->corrects() ? m_settings.stream.parameters.correctionLimitMm : 0.0,
      m_settings.stream.parameters.axes);
  widgets::FeasibilityModel model;
  model.operatingPoint = point;
  model.access = access;
  model.source = m_access;
  if (m_distances) {
    model.distances = *m_distances;
  }
  if (m_view) {
    model.smallestDistancesMm = m_view->smallestDistancesMm;
  }
  m_feasibility->setModel(model);
  refreshStart();
}

templates::TemplateParameters MainWindow::parameters() const {
  templates::TemplateParameters parameters = m_settings.stream.parameters;
  if (m_view && base::streamsRotary(parameters.method)) {
    parameters.rotaryAxes = m_view->turnedAxes;
  }
  return parameters;
}

QString MainWindow::startBlockedReason() const {
  const QString blocked = blockedReason();
  if (blocked.isEmpty() && m_machine.channelStatus.value_or(0) != 0) {
    return tr("A program is running on the control.");
  }
  return blocked;
}

QString MainWindow::resumeBlockedReason() const {
  if (!m_left) {
    return tr("There is no interrupted run of method window.");
  }
  if (!base::hasWindows(m_settings.stream.parameters.method)) {
    return tr("Only method window can resume an interrupted run.");
  }
  // A program that waits for the rest of the run is ended first, when the control is asked.
  return blockedReason();
}

QString MainWindow::blockedReason() const {
  if (m_session.isRunning()) {
    return tr("A run is in progress.");
  }
  if (m_session.isAsking()) {
    return tr("Asking the control where the run was left.");
  }
  if (m_session.isCalibrating()) {
    return tr("A calibration is in progress.");
  }
  if (m_link.state != session::LinkState::Connected) {
    return tr("Connect to a control first.");
  }
  if (!m_program) {
    return tr("Open a program first.");
  }
  if (m_program->isUnderstood() && !m_program->isStreamable()) {
    return points().empty()
               ? tr("The program moves no axis.")
               : tr("The program needs a transformation of the control. No method can stream it.");
  }
  if (!m_program->isStreamable()) {
    return tr("Parts of the program's path are not known: see the findings.");
  }
  const base::RotarySet turned = m_view->turnedAxes;
  if (base::any(turned) && !base::streamsRotary(m_settings.stream.parameters.method)) {
    return tr("The program moves rotary axes: choose method window.");
  }
  if (!base::contains(m_machine.rotaryAxes, turned)) {
    return tr("The program moves %1, but the control does not have all of these axes.")
        .arg(QString::fromStdString(base::rotaryNames(turned)));
  }
  if (m_problem) {
    return *m_problem;
  }
  if (m_verdict && !m_verdict->feasible) {
    return tr("Not feasible: the control would repeat points. Change F, N or δ.");
  }
  if (m_machine.alarmNumber.value_or(0) != 0) {
    return tr("The control reports an alarm.");
  }
  return {};
}

void MainWindow::refreshStart() {
  const bool running = m_session.isRunning();
  m_run->setStartBlocked(startBlockedReason());
  m_run->setResumeBlocked(resumeBlockedReason());
  m_run->setCanHold(base::hasWindows(m_settings.stream.parameters.method));
  m_method->setEditable(!running);
  m_feasibility->setEditable(!running);
  m_programPanel->setOpenEnabled(!running);
  m_fileBanner->setRunning(running);
  m_runProgram->setVisible(m_program != nullptr);
  if (m_program) {
    m_runProgram->setText(
        (running ? tr("Running: %1, version %2") : tr("Program: %1, version %2"))
            .arg(QString::fromStdString(m_program->name), QString::fromStdString(m_program->hash)));
  }
  m_connection->setDisconnectEnabled(!running && !m_session.isCalibrating());
  m_calibration->setBlocked(calibrationBlockedReason());
  m_openAction->setEnabled(!running);
}

void MainWindow::simulateRegion(const widgets::SimulationWanted& wanted) {
  if (!m_distances || m_session.isRunning()) {
    return;
  }
  session::RegionJob job;
  const feasibility::Place& tightest =
      m_settings.stream.parameters.method == base::MethodKind::Position
          ? m_distances->pointDistancePlace
          : m_distances->windowPlace;
  job.points = experiments::stretchOf(points(), tightest.point.value, kSimulatedPoints);
  job.settings.parameters = parameters();
  job.settings.deltaMm = m_settings.stream.deltaMm;
  job.settings.feedMmPerS = m_settings.stream.feedMmPerS;
  job.axis = wanted.axis;
  job.feedsMmPerS = wanted.feedsMmPerS;
  const int fits = templates::pointsPerLoopMax(job.settings.parameters);
  for (const double abscissa : wanted.abscissas) {
    if (wanted.axis != feasibility::SweepAxis::PointsPerLoop || abscissa <= fits) {
      job.abscissas.push_back(abscissa);
    }
  }
  m_region.start(std::move(job));
  m_feasibility->setSimulationProgress(0);
}

void MainWindow::showRegion(const session::RegionOutcome& outcome) {
  m_feasibility->setSimulationProgress(std::nullopt);
  if (outcome.error.code) {
    m_messages->showMessage(Severity::Warning, widgets::errorText(outcome.error));
  }
  widgets::SimulatedRegion region;
  region.axis = outcome.job.axis;
  region.operatingPoint = report::operatingPointOf(outcome.job.settings);
  region.programPoints = outcome.job.points.size();
  for (const experiments::RegionPoint& point : outcome.points) {
    region.points.push_back({point.abscissa, point.feedMmPerS, point.runs, point.failures()});
  }
  for (const session::RegionBandPoint& point : outcome.band) {
    region.band.push_back({point.abscissa, point.rareMmPerS, point.halfMmPerS});
  }
  m_feasibility->setRegion(region);
}

bool MainWindow::start() {
  const QString blocked = startBlockedReason();
  if (!blocked.isEmpty()) {
    m_messages->showMessage(Severity::Warning, blocked);
    return false;
  }
  return startRun(std::nullopt);
}

streaming::RunSettings MainWindow::runSettings() const {
  const widgets::StreamSettings& stream = m_settings.stream;
  streaming::RunSettings settings;
  settings.parameters = parameters();
  settings.deltaMm = stream.deltaMm;
  settings.feedMmPerS = stream.feedMmPerS;
  settings.transfer =
      stream.transferByHand ? streaming::TransferWay::ByHand : streaming::TransferWay::Link;
  switch (stream.access) {
    case widgets::AccessOrder::Automatic:
      // The methods of the paper are kept as they were published.
      if (base::hasWindows(stream.parameters.method)) {
        settings.access = streaming::AccessChoice::Best;
      }
      break;
    case widgets::AccessOrder::Array:
      settings.access = streaming::AccessChoice::Array;
      break;
    case widgets::AccessOrder::List:
      break;
    case widgets::AccessOrder::Single:
      settings.grouping = opcua::Grouping::Single;
      break;
  }
  if (m_access.isUsed()) {
    settings.calibration = std::shared_ptr<const streaming::Calibration>(
        m_access.record, &m_access.record->calibration);
  }
  return settings;
}

void MainWindow::hold(bool hold) {
  m_session.hold(hold);
  log(Severity::Note, hold ? tr("Hold requested.") : tr("Continue requested."));
}

void MainWindow::askResume() {
  const QString blocked = resumeBlockedReason();
  if (!blocked.isEmpty()) {
    m_messages->showMessage(Severity::Warning, blocked);
    return;
  }
  m_resume.reset();
  m_resumeBar->showAsking();
  m_session.askResume(*m_left);
  refreshStart();
}

void MainWindow::showResume(const session::ResumeFound& found) {
  if (!m_left) {
    forgetResume();
    return;
  }
  if (!found.resume) {
    const QString why = widgets::errorText(found.error);
    log(Severity::Warning, why);
    m_resumeBar->showRefusal(why);
    refreshStart();
    return;
  }
  // The list of the run that was left: open coordinates as they were then.
  const auto list = gcode::streamPoints(m_left->program->trajectory, found.resume->startMm).points;
  m_resume = found.resume;
  widgets::ResumePlace place;
  place.point = m_resume->point;
  place.points = list.size();
  place.line = list.at(m_resume->point).line;
  place.positionMm = list[m_resume->point].positionMm;
  if (m_machine.positionMm && !m_machine.isStale) {
    place.approachMm = base::distance(*m_machine.positionMm, place.positionMm);
  }
  m_resumeBar->showPlace(place);
  m_path->markPoint(m_resume->point);
  log(Severity::Note,
      tr("The run was left before point %1 of %2.")
          .arg(widgets::countText(place.point + 1), widgets::countText(place.points)));
  refreshStart();
}

void MainWindow::forgetResume() {
  m_resume.reset();
  m_resumeBar->showNothing();
  refreshStart();
}

bool MainWindow::resume() {
  const QString blocked =
      m_resume ? resumeBlockedReason()
               : tr("Press Resume first: it asks the control where the run was left.");
  if (!blocked.isEmpty()) {
    m_messages->showMessage(Severity::Warning, blocked);
    return false;
  }
  return startRun(m_resume);
}

bool MainWindow::startRun(std::optional<streaming::Resume> resume) {
  streaming::RunSettings settings = runSettings();
  settings.resume = resume;
  m_firstPoint = resume ? resume->point : 0;
  forgetResume();
  if (!resume) {
    followTool();
  }
  m_timer.cancel();
  m_path->setExecuted(m_firstPoint);
  m_trace->clear();
  m_report.reset();
  m_reportPanel->setReport(std::nullopt);
  m_runBegan.reset();
  m_messages->clear();
  if (resume) {
    log(Severity::Note,
        tr("The run resumes at point %1.").arg(widgets::countText(m_firstPoint + 1)));
  } else if (m_machine.positionMm && !points().empty()) {
    log(Severity::Note, tr("Start. The tool first moves %1 in a straight line to the first point.")
                            .arg(widgets::lengthText(base::distance(*m_machine.positionMm,
                                                                    points().front().positionMm))));
  }
  if (settings.transfer == streaming::TransferWay::ByHand) {
    m_messages->showMessage(
        Severity::Note,
        tr("Save the template on its page as %1, copy it to the part programs of the control, "
           "select it in channel 1 and press cycle start. The axes move only after the template "
           "has shown its layout number %2.")
            .arg(QString::fromStdString(templates::templateFileName(settings.parameters)))
            .arg(templates::layoutNumber(settings.parameters)));
  }
  // The processors belong to the stream.
  m_region.cancel();
  m_session.start(m_program, settings, newRecordingPath(),
                  resume ? m_left : std::optional<session::ResumeQuestion>{});
  m_feed.forget();
  m_correction->setRunning(true);
  refreshStart();
  Q_EMIT runStarted();
  return true;
}

void MainWindow::stop() {
  m_session.stop();
  log(Severity::Note, tr("Stop requested."));
}

void MainWindow::showUpdate(const streaming::LiveUpdate& update) {
  const bool stateChanged = update.state != m_update.state;
  m_update = update;
  m_update.counters = inProgram(update.counters, m_firstPoint);
  m_run->setUpdate(m_update);
  m_path->setExecuted(m_update.counters.executed);
  m_correction->setCorrection(update.correction);
  if (update.state == streaming::RunState::Running && !m_runBegan) {
    m_runBegan = update.at;
  }
  const base::Instant origin = m_runBegan.value_or(update.at);
  if (stateChanged && update.state == streaming::RunState::Running) {
    // The stream leaves no slot to ask for these; that the program runs is what it lives on.
    m_machine.channelStatus = 1;
    m_machine.programStatus = 3;
    m_machine.programName = QString::fromStdString(templates::templateFileName(parameters()));
    m_connection->setMachineState(m_machine);
  }
  if (update.sample) {
    widgets::TraceSample sample;
    sample.atS = base::toSeconds(update.sample->at - origin);
    sample.positionMm = update.sample->positionMm;
    sample.feedMmPerS = update.sample->feedMmPerS;
    if (m_runBegan && sample.atS >= 0.0) {
      m_trace->append(sample);
    }
    if (sample.positionMm) {
      m_machine.positionMm = sample.positionMm;
      m_path->setToolPosition(sample.positionMm);
    }
    if (update.sample->rotaryDeg) {
      m_machine.rotaryDeg = update.sample->rotaryDeg;
    }
    if (sample.feedMmPerS) {
      m_machine.feedMmPerS = sample.feedMmPerS;
    }
    m_machine.isStale = false;
    m_connection->setMachineState(m_machine);
  }
  if (update.pause) {
    trace::Pause pause = *update.pause;
    pause.start = base::Instant{pause.start - origin};
    m_trace->addPause(pause);
  }
  if (stateChanged) {
    refreshStart();
  }
}

void MainWindow::showFinished(const session::RunFinished& finished) {
  m_report = finished.report;
  m_reportPanel->setReport(*m_report);
  if (m_report->outcome == streaming::Outcome::Completed) {
    m_left.reset();
  } else if (m_report->checkpoint) {
    m_left = session::ResumeQuestion{m_program, m_report->settings, *m_report->checkpoint};
  }
  if (m_report->access.requests > 0) {
    log(Severity::Note, tr("Access: %1.").arg(widgets::groupingText(m_report->settings.grouping)));
  }
  if (m_report->controlTrace) {
    m_trace->showControlTrace(m_report->controlTrace, m_report->pauses);
  }
  streaming::LiveUpdate last = m_update;
  last.state = m_report->outcome == streaming::Outcome::Failed ? streaming::RunState::Aborted
                                                               : streaming::RunState::Done;
  last.counters = inProgram(m_report->counters, m_firstPoint);
  last.stopConfirmedAfter = m_report->stopConfirmedAfter;
  last.waitingFor.clear();
  m_update = last;
  m_run->setUpdate(last);
  m_correction->setRunning(false);
  m_path->setExecuted(last.counters.executed);
  if (m_report->error.code == streaming::StreamError::StopNotConfirmed) {
    m_run->setStopUnconfirmed();
  }
  if (m_report->error.code) {
    const QString text = widgets::errorText(m_report->error);
    m_messages->showMessage(Severity::Error, text);
    log(Severity::Error, text);
  } else if (m_report->finding() == streaming::RunFinding::Faulty) {
    const QString text =
        tr("Wrong motion: the control's trace shows repeated or skipped points. See the report.");
    m_messages->showMessage(Severity::Error, text);
    log(Severity::Error, text);
  } else {
    log(Severity::Note, tr("Run ended: %1 of %2 points executed.")
                            .arg(widgets::countText(last.counters.executed),
                                 widgets::countText(last.counters.total)));
  }
  if (!finished.recordingPath.empty()) {
    log(Severity::Note, tr("Recording: %1").arg(QString::fromStdString(finished.recordingPath)));
  }
  refreshStart();
  if (!m_programPage->hasTimes() || !m_reckonedFor) {
    m_reckonedFor.reset();  // the start has interrupted it
    m_reckonTimer.start();
  }
  Q_EMIT runFinished(m_report);
}

QString MainWindow::calibrationBlockedReason() const {
  if (m_session.isRunning()) {
    return tr("A run is in progress.");
  }
  if (m_link.state != session::LinkState::Connected) {
    return tr("Connect to a control first.");
  }
  if (m_machine.channelStatus.value_or(0) != 0) {
    return tr("A program is running on the control.");
  }
  return {};
}

void MainWindow::calibrate(const streaming::CalibrationPlan& plan) {
  const QString blocked = calibrationBlockedReason();
  if (!blocked.isEmpty()) {
    m_messages->showMessage(Severity::Warning, blocked);
    return;
  }
  m_messages->clear();
  m_session.calibrate(plan);
  m_calibration->setProgress(streaming::CalibrationProgress{});
  log(Severity::Note, tr("Calibration on R%1 to R%2 started.")
                          .arg(QString::number(plan.firstCell), QString::number(plan.lastCell)));
  refreshStart();
}

void MainWindow::showCalibrated(const session::CalibrationFinished& finished) {
  m_calibration->setProgress(std::nullopt);
  if (!finished.record) {
    const QString text = widgets::errorText(finished.error);
    const bool wanted = finished.error.code == streaming::CalibrationError::Cancelled;
    m_messages->showMessage(wanted ? Severity::Note : Severity::Error, text);
    log(wanted ? Severity::Note : Severity::Error, text);
    refreshStart();
    return;
  }
  m_access.record = finished.record;
  m_access.isOutdated = false;
  m_calibration->setRecord(m_access.record, false);
  if (const auto saved = m_machines.save(*finished.record); !saved) {
    m_messages->showMessage(Severity::Error, widgets::errorText(saved.error()));
  } else {
    log(Severity::Note,
        tr("Calibrated. Saved %1.")
            .arg(QString::fromStdString(
                m_machines.pathOf(finished.record->endpoint, finished.record->server).string())));
  }
  judge();
}

void MainWindow::loadCalibration() {
  m_access.record.reset();
  m_access.isOutdated = false;
  auto found = m_machines.calibration(m_settings.endpoint.trimmed().toStdString(), m_link.server);
  if (!found) {
    log(Severity::Warning, widgets::errorText(found.error()));
  } else if (*found) {
    m_access.isOutdated = (*found)->isOutdated(m_link.server);
    m_access.record = std::make_shared<const streaming::CalibrationRecord>(std::move(**found));
    if (m_access.isOutdated) {
      log(Severity::Warning,
          tr("The calibration belongs to another version of the server and is not used."));
    }
  }
  m_calibration->setRecord(m_access.record, m_access.isOutdated);
  judge();
}

feasibility::AccessModel MainWindow::accessModel() {
  const bool window = base::hasWindows(m_settings.stream.parameters.method);
  const int points = m_settings.stream.parameters.pointsPerLoop;
  constexpr int kAxes = static_cast<int>(base::kAxisCount);
  m_access.form = opcua::Grouping::List;
  m_access.cellsMax = kAxes;
  if (window) {
    constexpr int kHeader = 3;  // count, feed and check number go with the points
    m_access.cellsMax = kAxes * std::max(points, 1) + kHeader;
  } else if (m_settings.stream.parameters.method == base::MethodKind::Signal) {
    m_access.cellsMax = kAxes * std::max(points / 2, 1) + 1;
  }
  if (!m_access.isUsed()) {
    return {};
  }
  // As the run will: see `runSettings`.
  const widgets::AccessOrder ordered = m_settings.stream.access;
  if (ordered == widgets::AccessOrder::Single) {
    m_access.form = opcua::Grouping::Single;
  } else if (ordered == widgets::AccessOrder::Array ||
             (window && ordered == widgets::AccessOrder::Automatic)) {
    m_access.form = m_access.record->calibration.best();
  }
  return report::accessModel(m_access.record->calibration, m_access.form);
}

void MainWindow::log(Severity severity, const QString& text) {
  m_log->append({QDateTime::currentDateTime(), severity, text});
}

void MainWindow::saveText(const QString& path, const QString& text) {
  const auto written = trace::writeFile(path.toStdString(), text.toStdString());
  if (!written) {
    m_messages->showMessage(Severity::Error, widgets::errorText(written.error()));
    return;
  }
  log(Severity::Note, tr("Saved %1.").arg(path));
}

QString MainWindow::newRecordingPath() {
  const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                    QStringLiteral("/runs"));
  if (!folder.mkpath(QStringLiteral("."))) {
    log(Severity::Warning,
        tr("The run is not recorded: the folder %1 cannot be created.").arg(folder.path()));
    return {};
  }
  return folder.filePath(
      QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz")) +
      QStringLiteral(".rivulet"));
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (m_session.isRunning()) {
    // Closing must neither leave the machine alone nor stop it by surprise.
    m_messages->showMessage(
        Severity::Warning,
        tr("A run is in progress. Press Stop, wait until the run has ended, then close."));
    event->ignore();
    return;
  }
  if (m_persistent) {
    m_settings.geometry = saveGeometry();
    saveSettings(m_settings);
  }
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls() && !m_session.isRunning()) {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (!urls.isEmpty() && urls.first().isLocalFile()) {
    openProgram(urls.first().toLocalFile());
    event->acceptProposedAction();
  }
}

}  // namespace rivulet::hmi
