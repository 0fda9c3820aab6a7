// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QEventLoop>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QScreen>
#include <QScrollArea>
#include <QShortcut>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <initializer_list>

#include "hmi/input_guard.h"
#include "platform/utc_now.h"
#include "report/run_store.h"
#include "widgets/alarms/alarm_page.h"
#include "widgets/calibration/calibration_page.h"
#include "widgets/common/blocked_text.h"
#include "widgets/common/focus_frame.h"
#include "widgets/common/folding_columns.h"
#include "widgets/common/help_page.h"
#include "widgets/common/notice_area.h"
#include "widgets/common/number_field.h"
#include "widgets/common/place_tabs.h"
#include "widgets/common/sheet_area.h"
#include "widgets/common/theme.h"
#include "widgets/connection/machines_page.h"
#include "widgets/connection/trust_sheet.h"
#include "widgets/program/program_page.h"
#include "widgets/program/program_panel.h"
#include "widgets/program/start_steps.h"
#include "widgets/streaming/close_bar.h"
#include "widgets/trace/trace_page.h"

namespace rivulet::hmi {

namespace {

constexpr int kHeaderHeightPx = 48;

/// The key that opens a page: digits in their order on the keyboard, then none.
QKeySequence pageKey(int page) {
  constexpr int kKeys = 10;
  return page < kKeys ? QKeySequence(QStringLiteral("Alt+%1").arg((page + 1) % kKeys))
                      : QKeySequence();
}

}  // namespace

MainWindow::MainWindow(Settings settings, bool persistent, opcua::Connector connector,
                       QWidget* parent)
    : QMainWindow(parent),
      m_settings(std::move(settings)),
      m_persistent(persistent),
      m_alarms(m_messages, m_settings.stateFolder),
      m_users(m_settings.usersFile, QString::fromStdString(report::thisUser().user)),
      m_audit(m_messages, m_settings.stateFolder, utc::now),
      m_session(std::move(connector), report::MachineStore()),
      m_document(m_settings.stream),
      m_logins(systemKeyring(), m_settings.passwordFile),
      m_machine(m_session, report::MachineStore(), m_messages),
      m_runs(m_session, m_document, m_machine, m_messages),
      m_live(m_session, m_document, m_runs, m_messages),
      m_releases(m_settings.stateFolder, m_users, m_document, m_machine, m_messages),
      m_preflight(m_document, m_machine, m_runs),
      m_found(m_session, m_document, m_machine, m_runs, m_messages),
      m_pastRuns(m_document, m_runs, m_messages),
      m_tests(m_session, m_machine, m_runs, m_document, report::MachineStore()),
      m_profiles(m_document, m_machine, m_runs, m_messages, report::MachineStore()),
      m_machines(m_document, m_machine, m_runs, m_pastRuns, report::MachineStore()),
      m_services(m_settings.services, report::MachineStore()),
      m_offline{.traces = Traces(m_document), .certificates = Certificates(m_messages)} {
  m_translator.setLanguage(m_settings.language);
  widgets::applyTheme(m_settings.theme);
  setAcceptDrops(true);
  m_machine.setLogins(m_logins);
  m_machine.setEndpoint(m_settings.endpoint);
  m_live.setSetup(m_settings.live);
  // Before there are fields: they are polished as soon as a layout asks for their size.
  new InputGuard(
      [this] {
        // Whoever started it: the machine in the title stops.
        if (isRunning() || (!m_found.isOnControl() && m_machine.mayMove())) {
          m_runs.stop();
        } else if (!isRunning() && m_found.isOnControl()) {
          m_found.stop();
        }
      },
      [this] { m_users.noticeInput(); }, this);
  new widgets::FocusFrame(this);
  watchOperator();
  buildPages();
  buildMenu();
  showLock();
  connect(&m_document, &Document::programLoaded, this, &MainWindow::showTitle);
  connect(&m_runs, &RunController::permissionsChanged, this, [this] {
    m_actions.open->setEnabled(!isRunning() && !m_users.isLocked());
    m_actions.live->setEnabled(m_actions.open->isEnabled());
  });
  connect(&m_runs, &RunController::started, this, &MainWindow::runStarted);
  connect(&m_runs, &RunController::finished, this, &MainWindow::runFinished);
  connect(&m_alarms, &Alarms::listRequested, this, &MainWindow::showAlarms);
  connect(&m_machines, &Machines::found, this, &MainWindow::showFirstPage);
  connect(&m_services, &Services::listChanged, this, [this] {
    m_settings.services = m_services.endpoints();
    if (m_persistent) {
      saveSettings(m_settings);
    }
  });
  connect(
      &m_runs, &RunController::finished, this,
      [this] {
        m_frame.closeBar->hide();
        if (m_closesAfterRun) {
          close();
        }
      },
      Qt::QueuedConnection);
  retranslate();
  m_document.judge();
  resize(QSize(1440, 900).boundedTo(screen()->availableSize()));
  if (!m_settings.geometry.isEmpty()) {
    restoreGeometry(m_settings.geometry);
  }
}

MainWindow::~MainWindow() {
  // Pages refer to the models, which are members and would be gone before them.
  delete takeCentralWidget();
}

void MainWindow::buildPages() {
  auto* central = new QWidget(this);
  auto* above = new QVBoxLayout;
  m_frame.rail = new widgets::PlaceRail(central);
  auto* beside = widgets::inRow({m_frame.rail, widgets::InBox(above, 1)}, nullptr, QMargins());
  // Header and the strip with Stop have the whole width: in a narrow window the rail would cut
  // them.
  auto* rows =
      widgets::inColumn({makeHeader(central), widgets::InBox(beside, 1)}, central, QMargins());
  for (QBoxLayout* each : std::initializer_list<QBoxLayout*>{above, beside, rows}) {
    each->setSpacing(0);
  }
  above->addWidget(makePositionLine(&m_machine, central));
  above->addWidget(makeLoadBar(&m_document, central));
  above->addWidget(makeFileBanner(&m_messages, &m_document, &m_runs, central));

  m_frame.centre = new widgets::SheetArea(central);
  m_frame.tabs = new widgets::PlaceTabs(m_frame.centre);
  m_parts.say(m_frame.rail->addPlace("place-work"), {.text = QT_TR_NOOP("Work")});
  m_parts.say(m_frame.rail->addPlace("place-analyse"), {.text = QT_TR_NOOP("Analyse")});
  m_parts.say(m_frame.rail->addPlace("place-set-up"), {.text = QT_TR_NOOP("Set up")});
  connect(m_frame.tabs, &widgets::PlaceTabs::placeChanged, m_frame.rail,
          &widgets::PlaceRail::setPlace);
  connect(m_frame.rail, &widgets::PlaceRail::placeChosen, this, [this](int place) {
    leaveSheets();
    m_frame.tabs->openPlace(place);
  });
  addPages();
  connectSteps();
  m_frame.centre->addWidget(m_frame.tabs);
  m_frame.centre->addWidget(
      widgets::makeColumn(makePreflightSheet(&m_runs, &m_preflight, nullptr)));
  m_frame.trustSheet =
      makeTrustSheet(&m_users, &m_machine, &m_runs, &m_offline.certificates, nullptr);
  m_frame.centre->addWidget(widgets::makeColumn(m_frame.trustSheet));
  m_frame.help = new widgets::HelpPage(QStringLiteral(":/rivulet/docs"));
  m_frame.centre->addWidget(m_frame.help);
  connect(m_frame.help, &widgets::HelpPage::closeRequested, this, &MainWindow::showCentre);
  auto* setUp = new QWidget;
  auto* setUpRows = new QVBoxLayout(setUp);
  setUpRows->setContentsMargins(0, 0, 0, 0);
  setUpRows->setSpacing(0);
  setUpRows->addWidget(makeCorrectionPanel(&m_document, &m_runs));
  setUpRows->addWidget(makeMethodPanel(&m_document, &m_runs), 1);
  setUpRows->addWidget(makeFactorPanel(&m_document, &m_runs));
  // Before the panel hears of it, which gives the focus to the field that is missing.
  connect(&m_logins, &Logins::changed, this, &MainWindow::showLogin);
  m_frame.columns = new widgets::FoldingColumns(
      m_frame.centre, makeConnectionPanel(&m_machine, &m_runs, &m_logins), setUp, central);
  // The page takes what header, notices and strip leave.
  m_frame.columns->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);
  above->addWidget(m_frame.columns, 1);
  for (int i = 0; i < m_frame.tabs->count(); ++i) {
    auto* key = new QShortcut(pageKey(i), this);
    connect(key, &QShortcut::activated, this, [this, i] { openPage(i); });
  }
  connect(m_frame.columns, &widgets::FoldingColumns::changed, this, &MainWindow::showColumns);
  connect(m_frame.centre, &widgets::SheetArea::opened, m_frame.columns,
          &widgets::FoldingColumns::uncover);
  connect(&m_preflight, &Preflight::openChanged, this, &MainWindow::showCentre);
  connect(&m_machine, &MachineModel::linkChanged, this, &MainWindow::showQuestion);

  rows->addWidget(makeNotices(central));
  rows->addWidget(
      makeRunPanel(&m_users, &m_machine, &m_document, &m_runs, &m_preflight, &m_found, central));
  setCentralWidget(central);
  const auto complain = [this](const QString& reason) {
    m_messages.show(gcode::Severity::Warning, [reason] { return reason; });
  };
  for (const auto* field : central->findChildren<widgets::NumberField*>()) {
    connect(field, &widgets::NumberField::refused, this, complain);
  }
  for (const auto* field : central->findChildren<widgets::WholeNumberField*>()) {
    connect(field, &widgets::WholeNumberField::refused, this, complain);
  }
}

QWidget* MainWindow::makeNotices(QWidget* parent) {
  m_frame.closeBar = new widgets::CloseBar(parent);
  connect(m_frame.closeBar, &widgets::CloseBar::stopAndCloseRequested, this,
          &MainWindow::stopAndClose);
  m_frame.foundBar = makeFoundRunBar(&m_runs, &m_found, parent);
  m_frame.resumeBar = makeResumeBar(&m_runs, &m_preflight, parent);
  auto* notices = new widgets::NoticeArea(parent);
  notices->add(m_frame.closeBar);
  notices->add(makeWrongMotionBar(&m_alarms, &m_runs, parent));
  notices->add(m_frame.foundBar);
  notices->add(m_frame.resumeBar);
  return notices;
}

void MainWindow::addPages() {
  const auto add = [this](const PageEntry& entry, QWidget* page) {
    m_entries.push_back(entry);
    m_frame.tabs->addPage(widgets::makeScrolling(page), static_cast<int>(entry.place));
  };
  add({QT_TRANSLATE_NOOP("Pages", "Program"), "The program"},
      makeProgramPage(&m_settings, &m_messages, &m_machine, &m_document, &m_runs, &m_live, &m_found,
                      nullptr));
  add({QT_TRANSLATE_NOOP("Pages", "Feasibility"), "Feasibility"},
      makeFeasibilityPage(&m_messages, &m_document, &m_runs, nullptr));
  add({QT_TRANSLATE_NOOP("Pages", "Traces"), "Traces", Place::Analyse},
      makeTracePage(&m_alarms, &m_document, &m_runs, &m_pastRuns, &m_offline.traces, nullptr));
  add({QT_TRANSLATE_NOOP("Pages", "Runs"), "Runs", Place::Analyse},
      makeRunsPage(&m_messages, &m_runs, &m_pastRuns, nullptr));
  add({QT_TRANSLATE_NOOP("Pages", "Alarms"), "Alarms"},
      makeAlarmPage(&m_alarms, &m_users, nullptr));
  add({QT_TRANSLATE_NOOP("Pages", "Messages"), "Messages", Place::SetUp},
      makeLogPage(&m_messages, nullptr));
  add({QT_TRANSLATE_NOOP("Pages", "Audit"), "Audit", Place::SetUp},
      makeAuditPage(&m_messages, &m_audit, nullptr));
  add({QT_TRANSLATE_NOOP("Pages", "Users"), "Users", Place::SetUp},
      makeUsersPage(&m_messages, &m_users, nullptr));
  add({QT_TRANSLATE_NOOP("Pages", "Configure"), "Configure", Place::SetUp},
      makeSetUpPage(&m_messages, &m_users, &m_machine, &m_document, &m_runs, &m_tests, &m_profiles,
                    &m_offline.certificates, &m_logins, nullptr));
  auto* machines = makeMachinesPage(&m_messages, &m_alarms, &m_machine, &m_runs, &m_profiles,
                                    &m_machines, nullptr);
  connectServices(&m_users, &m_runs, &m_services, &m_offline.certificates, *machines);
  add({QT_TRANSLATE_NOOP("Pages", "Machines"), "Machines", Place::SetUp}, machines);
  add({QT_TRANSLATE_NOOP("Pages", "Emulator"), "Emulator", Place::Analyse},
      makeEmulatorPage(&m_runs, &m_offline.learning, nullptr));
  add({QT_TRANSLATE_NOOP("Pages", "CNC tasks"), "CNC tasks", Place::Analyse},
      makeParallelPage(&m_document, &m_runs, &m_offline.player, nullptr));
}

/// The first minute: a machine, a program.
void MainWindow::connectSteps() {
  using widgets::StartSteps;
  const StartSteps* const steps = programPage()->steps();
  programPage()->steps()->setSample(QFileInfo(sampleFile()).baseName());
  connect(steps, &StartSteps::virtualMachineRequested, &m_virtualMachine, &VirtualMachine::start);
  connect(&m_virtualMachine, &VirtualMachine::listens, this, &MainWindow::connectTo);
  connect(&m_virtualMachine, &VirtualMachine::failed, this, [this](const QString& reason) {
    m_messages.show(gcode::Severity::Warning, [reason] { return reason; });
  });
  connect(steps, &StartSteps::connectRequested, this, [this] {
    m_frame.columns->setOpen(widgets::FoldingColumns::First, true);
    showColumns();
  });
  connect(steps, &StartSteps::openRequested, programPage()->panel(),
          &widgets::ProgramPanel::chooseFile);
  connect(steps, &StartSteps::liveRequested, programPage()->panel(),
          &widgets::ProgramPanel::liveRequested);
  connect(steps, &StartSteps::sampleRequested, this, [this] { openProgram(sampleFile()); });
  connect(&m_machine, &MachineModel::linkChanged, steps,
          [this] { programPage()->steps()->setConnection(m_machine.connectionState()); });
  connect(&m_runs, &RunController::permissionsChanged, steps,
          [this] { programPage()->steps()->setOpenEnabled(!isRunning()); });
}

QWidget* MainWindow::makeHeader(QWidget* parent) {
  auto* header = new QWidget(parent);
  header->setFixedHeight(kHeaderHeightPx);
  header->setBackgroundRole(QPalette::Base);
  header->setAutoFillBackground(true);
  auto* row = new QHBoxLayout(header);
  row->setContentsMargins(4, 0, 4, 0);
  m_buttons.machine = makeMachineButton(&m_machine, header);
  m_buttons.setUp =
      m_parts.say(new QToolButton(header),
                  {.text = QT_TR_NOOP("&Settings"), .tip = QT_TR_NOOP("Method, feed and verdict")});
  m_buttons.setUp->setCheckable(true);
  m_buttons.menu =
      m_parts.say(new QToolButton(header), {.text = QT_TR_NOOP("&Menu"), .id = "menu"});
  m_buttons.menu->setPopupMode(QToolButton::InstantPopup);
  for (const auto& [button, side] : {std::pair(m_buttons.machine, widgets::FoldingColumns::First),
                                     std::pair(m_buttons.setUp, widgets::FoldingColumns::Second)}) {
    connect(button, &QToolButton::clicked, this, [this, side = side](bool open) {
      m_frame.columns->setOpen(side, open);
      showColumns();
    });
  }
  row->addWidget(m_buttons.machine);
  row->addWidget(makeAlarmLine(&m_messages, &m_alarms, &m_users, header), 1);
  row->addStretch();
  row->addWidget(makeUserButton(&m_users, header));
  row->addWidget(m_buttons.setUp);
  row->addWidget(m_buttons.menu);
  return header;
}

void MainWindow::openPage(int page) {
  if (m_users.isLocked()) {
    return;
  }
  leaveSheets();
  m_frame.tabs->setCurrentIndex(page);
}

/// What covers the pages, except a question that has to be answered.
void MainWindow::leaveSheets() {
  m_preflight.close();
  showCentre();
  m_frame.columns->uncover();
}

void MainWindow::showColumns() {
  m_buttons.machine->setChecked(m_frame.columns->isOpen(widgets::FoldingColumns::First));
  m_buttons.setUp->setChecked(m_frame.columns->isOpen(widgets::FoldingColumns::Second));
}

void MainWindow::showCentre() {
  constexpr int kPages = 0;
  constexpr int kPreflight = 1;
  constexpr int kQuestion = 2;
  const bool isAsked = m_machine.question() != nullptr && widgets::isOnSheet(*m_machine.question());
  m_frame.centre->setCurrentIndex(isAsked ? kQuestion : m_preflight.isOpen() ? kPreflight : kPages);
  if (isAsked || m_preflight.isOpen()) {
    m_frame.columns->uncover();
  }
}

void MainWindow::showQuestion() {
  if (m_machine.question() == m_frame.question) {
    return;  // something else of the connection has changed
  }
  m_frame.question = m_machine.question();
  showCentre();
  if (m_frame.trustSheet->isVisible()) {
    m_frame.trustSheet->findChild<QWidget*>(QStringLiteral("trust-decline"))->setFocus();
  }
}

/// Who is asked for user and password sees the fields, and why.
void MainWindow::showLogin() {
  if (m_logins.view().reason != widgets::LoginView::Reason::None && !m_users.isLocked()) {
    m_frame.columns->setOpen(widgets::FoldingColumns::First, true);
    showColumns();
  }
}

void MainWindow::toggleHelp() {
  if (m_frame.centre->currentWidget() == m_frame.help) {
    showCentre();
    return;
  }
  const auto page = static_cast<std::size_t>(m_frame.tabs->currentIndex());
  const char* heading = m_preflight.isOpen() ? "Running" : m_entries[page].help;
  m_frame.columns->uncover();
  m_frame.centre->setCurrentWidget(m_frame.help);
  m_frame.help->open(QStringLiteral("hmi.md"), QString::fromLatin1(heading));
}

/// The page has the window, but for header, position and strip.
void MainWindow::toggleLarge() {
  const bool isLarge = m_frame.rail->isVisibleTo(this);
  m_frame.rail->setVisible(!isLarge);
  m_frame.tabs->setBarShown(!isLarge);
  programPage()->setLarge(isLarge);
}

void MainWindow::buildMenu() {
  auto* menu = new QMenu(m_buttons.menu);
  m_buttons.menu->setMenu(menu);
  const auto addItem = [this, menu](const char* text, const QKeySequence& key, auto chosen) {
    QAction* action = m_parts.say(menu->addAction(QString(), this, chosen), {.text = text});
    action->setShortcut(key);
    addAction(action);  // so that its key works while the menu is closed
    return action;
  };
  m_actions.open = addItem(QT_TR_NOOP("&Open program …"), QKeySequence::Open,
                           [this] { programPage()->panel()->chooseFile(); });
  m_actions.live =
      addItem(QT_TR_NOOP("Li&ve points …"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_L),
              [this] { Q_EMIT programPage()->panel()->liveRequested(); });
  menu->addSeparator();
  const auto addChoice = [this](QMenu* choices, QActionGroup* group, const QString& text,
                                bool isChosen, auto chosen) {
    QAction* action = choices->addAction(text, this, chosen);
    action->setCheckable(true);
    action->setChecked(isChosen);
    return group->addAction(action);
  };
  auto* languageMenu = m_parts.say(menu->addMenu(QString()), {.text = QT_TR_NOOP("&Language")});
  auto* languageGroup = new QActionGroup(this);
  for (const language::Language& one : language::languages()) {
    addChoice(languageMenu, languageGroup, one.name, m_translator.language() == one.code,
              [this, code = one.code] { setLanguage(code); });
  }
  auto* themeMenu = m_parts.say(menu->addMenu(QString()), {.text = QT_TR_NOOP("&Theme")});
  auto* themeGroup = new QActionGroup(this);
  for (const auto& [theme, name] : {std::pair(widgets::Theme::Light, QT_TR_NOOP("Light")),
                                    {widgets::Theme::Dark, QT_TR_NOOP("Dark")},
                                    {widgets::Theme::Contrast, QT_TR_NOOP("High contrast")},
                                    {widgets::Theme::System, QT_TR_NOOP("As the system")}}) {
    m_parts.say(addChoice(themeMenu, themeGroup, QString(), m_settings.theme == theme,
                          [this, theme = theme] { setTheme(theme); }),
                {.text = name});
  }
  menu->addSeparator();
  addItem(QT_TR_NOOP("La&rge view"), QKeySequence(Qt::Key_F11), [this] {
    toggleLarge();
  })->setCheckable(true);
  addItem(QT_TR_NOOP("&Help"), QKeySequence(Qt::Key_F1), [this] { toggleHelp(); });
  addItem(QT_TR_NOOP("&About Rivulet"), {}, [this] {
    auto* about =
        new QMessageBox(QMessageBox::NoIcon, tr("About Rivulet"),
                        tr("Rivulet %1\nStreams a tool path to a CNC machine over OPC UA while the "
                           "machine moves.\n\nStop ends the program at the end of its loop. It is "
                           "not an emergency stop.\n\nGPL-3.0-or-later")
                            .arg(QStringLiteral(RIVULET_VERSION)),
                        QMessageBox::Ok);
    widgets::openSheet(about, this);
  });
  menu->addSeparator();
  m_actions.quit = addItem(QT_TR_NOOP("&Quit"), QKeySequence::Quit, [this] { close(); });
}

void MainWindow::showTitle() {
  const auto program = m_document.program();
  setWindowTitle(program ? tr("%1 – Rivulet").arg(QString::fromStdString(program->name))
                         : tr("Rivulet"));
}

void MainWindow::retranslate() {
  showTitle();
  QStringList titles;
  QStringList keys;
  for (const PageEntry& entry : m_entries) {
    keys.push_back(pageKey(static_cast<int>(titles.size())).toString());
    titles.push_back(pageTitle(entry));
  }
  m_frame.tabs->setTitles(titles, keys);
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange && m_actions.quit != nullptr) {
    m_parts.retranslateParts();
    retranslate();
    m_document.judge();
  }
  QMainWindow::changeEvent(event);
}

void MainWindow::setLanguage(const QString& language) {
  m_settings.language = language;
  m_translator.setLanguage(language);  // its widgets are told by an event
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
  return m_frame.tabs->findChild<widgets::ProgramPage*>();
}

void MainWindow::watchOperator() {
  using permission::Act;
  m_runs.setGate([this](Act act) {
    const bool mayRepeat = streaming::mayRepeat(m_document.settings().parameters.method);
    return m_users.refusal(act, m_releases.isReleased(), mayRepeat);
  });
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
  m_frame.columns->setColumnsEnabled(isOpen);
  m_frame.centre->setPagesEnabled(isOpen);
  for (QWidget* part :
       std::initializer_list<QWidget*>{m_frame.rail, m_buttons.machine, m_buttons.setUp,
                                       m_frame.resumeBar, m_frame.foundBar, m_buttons.menu}) {
    part->setEnabled(isOpen);
  }
  m_actions.quit->setEnabled(isOpen);
  setAcceptDrops(isOpen);
  Q_EMIT m_runs.permissionsChanged();
}

void MainWindow::showAlarms() {
  // A page stands in a scroll area.
  const auto* page = m_frame.tabs->findChild<widgets::AlarmPage*>();
  for (int i = 0; i < m_frame.tabs->count(); ++i) {
    if (m_frame.tabs->widget(i)->isAncestorOf(page)) {
      leaveSheets();
      m_frame.tabs->setCurrentIndex(i);
    }
  }
}

void MainWindow::showFirstPage() {
  const bool isUntouched = !m_isMachineChosen && m_frame.tabs->currentIndex() == 0 &&
                           m_document.requestedPath().isEmpty() &&
                           m_machine.link().state == session::LinkState::Disconnected;
  const std::vector<widgets::MachineCardView> cards = m_machines.cards();
  const auto count =
      std::count_if(cards.begin(), cards.end(), [](const auto& card) { return !card.isLeftOver; });
  if ((count > 1 || !m_services.endpoints().isEmpty()) && isUntouched) {
    showPageOf(m_frame.tabs->findChild<widgets::MachinesPage*>());
  }
}

QTabWidget* MainWindow::pages() const {
  return m_frame.tabs;
}

widgets::TracePage* MainWindow::tracePage() const {
  return m_frame.tabs->findChild<widgets::TracePage*>();
}

widgets::CalibrationPage* MainWindow::calibrationPage() const {
  return m_frame.tabs->findChild<widgets::CalibrationPage*>();
}

void MainWindow::stopAndClose() {
  m_runs.cancelCalibration();
  if (!isRunning()) {
    close();
    return;
  }
  m_closesAfterRun = true;
  m_runs.leave();
}

void MainWindow::stopAndWait() {
  if (isRunning()) {
    QEventLoop loop;
    connect(&m_runs, &RunController::finished, &loop, &QEventLoop::quit);
    m_runs.leave();
    loop.exec(QEventLoop::ExcludeUserInputEvents);
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (isRunning()) {
    // Closing must neither leave the machine alone nor stop it by surprise.
    m_frame.closeBar->ask();
    event->ignore();
    return;
  }
  if (m_persistent) {
    m_settings.geometry = saveGeometry();
    m_settings.endpoint = m_machine.endpoint();
    m_settings.stream = m_document.settings();
    m_settings.live = m_live.setup();
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
