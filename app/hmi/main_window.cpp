// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <initializer_list>

#include "hmi/input_guard.h"
#include "report/run_store.h"
#include "widgets/alarms/alarm_page.h"
#include "widgets/calibration/calibration_page.h"
#include "widgets/common/blocked_text.h"
#include "widgets/common/folding_columns.h"
#include "widgets/common/icons.h"
#include "widgets/common/number_field.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/program/program_page.h"
#include "widgets/program/program_panel.h"
#include "widgets/trace/trace_page.h"

namespace rivulet::hmi {

namespace {

constexpr int kHeaderHeightPx = 48;

QString linkText(const session::LinkChanged& link) {
  switch (link.state) {
    case session::LinkState::Disconnected:
      return MainWindow::tr("Not connected");
    case session::LinkState::Connecting:
      return MainWindow::tr("Connecting …");
    case session::LinkState::Connected:
      return link.isVirtualMachine ? MainWindow::tr("Virtual machine")
                                   : MainWindow::tr("Connected");
    case session::LinkState::Lost:
      return MainWindow::tr("Connection lost");
  }
  return {};
}

widgets::Status linkStatus(const session::LinkChanged& link) {
  switch (link.state) {
    case session::LinkState::Disconnected:
      return widgets::Status::Unknown;
    case session::LinkState::Connecting:
      return widgets::Status::Busy;
    case session::LinkState::Connected:
      return link.isVirtualMachine ? widgets::Status::Simulated : widgets::Status::Good;
    case session::LinkState::Lost:
      return widgets::Status::Fault;
  }
  return widgets::Status::Unknown;
}

}  // namespace

MainWindow::MainWindow(Settings settings, bool persistent, opcua::Connector connector,
                       QWidget* parent)
    : QMainWindow(parent),
      m_settings(std::move(settings)),
      m_persistent(persistent),
      m_alarms(m_messages, m_settings.stateFolder),
      m_users(m_settings.usersFile, QString::fromStdString(report::thisUser().user)),
      m_audit(m_messages, m_settings.stateFolder, Alarms::utcNow),
      m_session(std::move(connector), report::MachineStore()),
      m_document(m_settings.stream),
      m_machine(m_session, report::MachineStore(), m_messages),
      m_runs(m_session, m_document, m_machine, m_messages),
      m_releases(m_settings.stateFolder, m_users, m_document, m_machine, m_messages),
      m_preflight(m_document, m_machine, m_runs) {
  m_translator.setLanguage(m_settings.language);
  widgets::applyTheme(m_settings.theme);
  setAcceptDrops(true);
  m_machine.setEndpoint(m_settings.endpoint);
  // Before there are fields: they are polished as soon as a layout asks for their size.
  new InputGuard(
      [this] {
        if (isRunning() && !std::exchange(m_isStopRequested, true)) {
          m_runs.stop();
        }
      },
      [this] { m_users.noticeInput(); }, this);
  watchOperator();
  buildPages();
  buildMenus();
  showLock();
  connect(&m_runs, &RunController::started, this, [this] { m_isStopRequested = false; });
  connect(&m_document, &Document::programLoaded, this, &MainWindow::retranslate);
  connect(&m_runs, &RunController::permissionsChanged, this,
          [this] { m_openAction->setEnabled(!isRunning()); });
  connect(&m_runs, &RunController::started, this, &MainWindow::runStarted);
  connect(&m_runs, &RunController::finished, this, &MainWindow::runFinished);
  connect(&m_alarms, &Alarms::listRequested, this, &MainWindow::showAlarms);
  retranslate();
  m_document.judge();
  resize(1440, 900);
  if (!m_settings.geometry.isEmpty()) {
    restoreGeometry(m_settings.geometry);
  }
}

MainWindow::~MainWindow() {
  // Pages refer to the models, which are members and would be gone before them.
  delete takeCentralWidget();
}

void MainWindow::buildPages() {
  const Models models{m_settings, m_messages, m_alarms, m_users,    m_audit,
                      m_machine,  m_document, m_runs,   m_preflight};
  auto* central = new QWidget(this);
  auto* rows = new QVBoxLayout(central);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  rows->addWidget(makeHeader(models, central));
  rows->addWidget(makePositionLine(models, central));
  rows->addWidget(makeLoadBar(models, central));
  rows->addWidget(makeFileBanner(models, central));

  m_centre = new QStackedWidget(central);
  m_tabs = new QTabWidget(m_centre);
  for (const PageEntry& entry : pageEntries()) {
    m_tabs->addTab(widgets::makeScrolling(entry.make(models, nullptr)), QString());
  }
  m_centre->addWidget(m_tabs);
  m_centre->addWidget(widgets::makeColumn(makePreflightSheet(models, nullptr)));
  auto* setUp = new QWidget;
  auto* setUpRows = new QVBoxLayout(setUp);
  setUpRows->setContentsMargins(0, 0, 0, 0);
  setUpRows->setSpacing(0);
  setUpRows->addWidget(makeCorrectionPanel(models));
  setUpRows->addWidget(makeMethodPanel(models), 1);
  m_columns = new widgets::FoldingColumns(makeConnectionPanel(models), m_centre, setUp, central);
  rows->addWidget(m_columns, 1);
  connect(m_columns, &widgets::FoldingColumns::changed, this, &MainWindow::showHeader);
  connect(&m_preflight, &Preflight::openChanged, this, [this] {
    m_centre->setCurrentIndex(m_preflight.isOpen() ? 1 : 0);
    if (m_preflight.isOpen()) {
      m_columns->uncover();
    }
  });

  m_resumeBar = makeResumeBar(models, central);
  rows->addWidget(m_resumeBar);
  rows->addWidget(makeRunPanel(models, central));
  setCentralWidget(central);
  for (const auto* field : central->findChildren<widgets::NumberField*>()) {
    connect(field, &widgets::NumberField::refused, this, [this](const QString& reason) {
      m_messages.show(gcode::Severity::Warning, [reason] { return reason; });
    });
  }
}

QWidget* MainWindow::makeHeader(const Models& models, QWidget* parent) {
  auto* header = new QWidget(parent);
  header->setFixedHeight(kHeaderHeightPx);
  auto* row = new QHBoxLayout(header);
  row->setContentsMargins(4, 0, 4, 0);
  m_machineButton = new QToolButton(header);
  m_setUpButton = new QToolButton(header);
  const auto add = [this](QToolButton* button, widgets::FoldingColumns::Side side) {
    button->setCheckable(true);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setMinimumHeight(widgets::kTouchHeightPx);
    connect(button, &QToolButton::clicked, this, [this, side](bool open) {
      m_columns->setOpen(side, open);
      showHeader();
    });
  };
  add(m_machineButton, widgets::FoldingColumns::Left);
  add(m_setUpButton, widgets::FoldingColumns::Right);
  row->addWidget(m_machineButton);
  row->addWidget(makeAlarmLine(models, header), 1);
  row->addStretch();
  row->addWidget(makeUserButton(models, header));
  row->addWidget(m_setUpButton);
  connect(&m_machine, &MachineModel::linkChanged, this, &MainWindow::showHeader);
  return header;
}

void MainWindow::showHeader() {
  const session::LinkChanged& link = m_machine.link();
  const widgets::Status status = linkStatus(link);
  m_machineButton->setText(linkText(link));
  m_machineButton->setIcon(widgets::themedIcon(widgets::statusIconName(status),
                                               widgets::statusColor(status, palette())));
  m_machineButton->setToolTip(tr("Connection and state of the machine"));
  m_setUpButton->setText(tr("Set-up"));
  m_setUpButton->setToolTip(tr("Method, feed and verdict"));
  if (m_columns != nullptr) {
    m_machineButton->setChecked(m_columns->isOpen(widgets::FoldingColumns::Left));
    m_setUpButton->setChecked(m_columns->isOpen(widgets::FoldingColumns::Right));
  }
}

void MainWindow::buildMenus() {
  m_fileMenu = menuBar()->addMenu(QString());
  m_openAction =
      m_fileMenu->addAction(QString(), this, [this] { programPage()->panel()->chooseFile(); });
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

void MainWindow::retranslate() {
  const auto program = m_document.program();
  setWindowTitle(program ? tr("%1 – Rivulet").arg(QString::fromStdString(program->name))
                         : tr("Rivulet"));
  for (int i = 0; i < m_tabs->count(); ++i) {
    m_tabs->setTabText(i, pageTitle(pageEntries()[static_cast<std::size_t>(i)]));
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
  showHeader();
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange && m_aboutAction != nullptr) {
    retranslate();
    m_document.judge();
  } else if (event->type() == QEvent::PaletteChange && m_aboutAction != nullptr) {
    showHeader();
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

void MainWindow::openProgram(const QString& path) {
  Q_EMIT programPage()->panel()->openRequested(path);
}

QString MainWindow::startBlockedReason() const {
  return widgets::blockedText(m_runs.startBlocked());
}

QString MainWindow::resumeBlockedReason() const {
  return widgets::blockedText(m_runs.resumeBlocked());
}

widgets::ProgramPage* MainWindow::programPage() const {
  return m_tabs->findChild<widgets::ProgramPage*>();
}

void MainWindow::watchOperator() {
  using permission::Act;
  m_runs.setGate([this](Act act) { return m_users.refusal(act, m_releases.isReleased()); });
  m_preflight.setReleases(m_releases, m_users);
  connect(&m_releases, &Releases::changed, &m_runs, &RunController::permissionsChanged);
  connect(&m_users, &Users::loggedIn, this, [this](const QString& name) {
    m_audit.setWho(name.toStdString(), std::string(permission::roleName(m_users.standing().role)));
    m_messages.didAct(Act::LogIn);
    m_messages.clear();  // it answered somebody else
  });
  connect(&m_users, &Users::logInFailed, this, [this](const QString& name) {
    m_messages.didAct(Act::LogInFailed, {{"user", name.toStdString()}});
  });
  connect(&m_users, &Users::locked, this, [this](bool byItself) {
    m_messages.didAct(Act::Lock, {{"cause", byItself ? "idle" : "by hand"}});
  });
  connect(&m_users, &Users::changed, this, &MainWindow::showLock);
  connect(&m_alarms, &Alarms::happened, &m_audit, &Audit::take);
  connect(&m_document, &Document::judged, &m_audit,
          [this] { m_audit.follow(m_document.settings()); });
  connect(&m_runs, &RunController::corrected, &m_audit, &Audit::followCorrection);
  if (m_users.fileError().code) {
    m_messages.log(gcode::Severity::Error, Messages::Source::Computer,
                   [error = m_users.fileError()] { return userErrorText(error); });
  }
  m_audit.refresh();
  m_audit.setWho(m_users.name().toStdString(), "");
  m_messages.didAct(Act::ProgramStart,
                    {{"version", RIVULET_VERSION}, {"computer", report::thisUser().computer}});
}

void MainWindow::showLock() {
  const permission::Standing standing = m_users.standing();
  m_audit.setWho(m_users.name().toStdString(),
                 m_users.isSetUp() && !standing.isLocked
                     ? std::string(permission::roleName(standing.role))
                     : std::string());
  m_alarms.setUser(m_users.name().toStdString());
  const bool isOpen = !m_users.isLocked();
  for (QWidget* part : std::initializer_list<QWidget*>{m_columns, m_machineButton, m_setUpButton,
                                                       m_resumeBar, menuBar()}) {
    part->setEnabled(isOpen);
  }
  setAcceptDrops(isOpen);
  Q_EMIT m_runs.permissionsChanged();
}

void MainWindow::showAlarms() {
  // A page stands in a scroll area.
  const auto* page = m_tabs->findChild<widgets::AlarmPage*>();
  for (int i = 0; i < m_tabs->count(); ++i) {
    if (m_tabs->widget(i)->isAncestorOf(page)) {
      m_preflight.close();
      m_tabs->setCurrentIndex(i);
    }
  }
}

widgets::TracePage* MainWindow::tracePage() const {
  return m_tabs->findChild<widgets::TracePage*>();
}

widgets::CalibrationPage* MainWindow::calibrationPage() const {
  return m_tabs->findChild<widgets::CalibrationPage*>();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (isRunning()) {
    // Closing must neither leave the machine alone nor stop it by surprise.
    m_messages.show(gcode::Severity::Warning, [] {
      return tr("A run is in progress. Press Stop, wait until the run has ended, then close.");
    });
    event->ignore();
    return;
  }
  if (m_persistent) {
    m_settings.geometry = saveGeometry();
    m_settings.endpoint = m_machine.endpoint();
    m_settings.stream = m_document.settings();
    saveSettings(m_settings);
  }
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls() && !isRunning()) {
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
