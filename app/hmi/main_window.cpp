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
#include <QSplitter>
#include <QStyle>
#include <QTabWidget>
#include <QVBoxLayout>

#include "widgets/calibration/calibration_page.h"
#include "widgets/common/blocked_text.h"
#include "widgets/program/program_page.h"
#include "widgets/program/program_panel.h"
#include "widgets/trace/trace_page.h"

namespace rivulet::hmi {

namespace {

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
      m_session(std::move(connector), report::MachineStore()),
      m_document(m_settings.stream),
      m_machine(m_session, report::MachineStore(), m_messages),
      m_runs(m_session, m_document, m_machine, m_messages) {
  m_translator.setLanguage(m_settings.language);
  widgets::applyTheme(m_settings.theme);
  setAcceptDrops(true);
  m_machine.setEndpoint(m_settings.endpoint);
  buildPages();
  buildMenus();
  connect(&m_document, &Document::programLoaded, this, &MainWindow::retranslate);
  connect(&m_runs, &RunController::permissionsChanged, this,
          [this] { m_openAction->setEnabled(!isRunning()); });
  connect(&m_runs, &RunController::started, this, &MainWindow::runStarted);
  connect(&m_runs, &RunController::finished, this, &MainWindow::runFinished);
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
  const Models models{m_settings, m_messages, m_machine, m_document, m_runs};
  auto* central = new QWidget(this);
  auto* rows = new QVBoxLayout(central);
  rows->addWidget(makeMessageArea(models, central));
  rows->addWidget(makeLoadBar(models, central));
  rows->addWidget(makeFileBanner(models, central));

  auto* columns = new QSplitter(Qt::Horizontal, central);
  columns->addWidget(new Column(makeConnectionPanel(models), columns));
  m_tabs = new QTabWidget(columns);
  for (const PageEntry& entry : pageEntries()) {
    m_tabs->addTab(entry.make(models, m_tabs), QString());
  }
  columns->addWidget(m_tabs);
  auto* right = new QWidget;
  auto* rightRows = new QVBoxLayout(right);
  rightRows->setContentsMargins(0, 0, 0, 0);
  rightRows->setSpacing(0);
  rightRows->addWidget(makeCorrectionPanel(models));
  rightRows->addWidget(makeMethodPanel(models), 1);
  columns->addWidget(new Column(right, columns));
  columns->setStretchFactor(0, 0);
  columns->setStretchFactor(1, 1);
  columns->setStretchFactor(2, 0);
  columns->setChildrenCollapsible(false);
  rows->addWidget(columns, 1);

  rows->addWidget(makeResumeBar(models, central));
  rows->addWidget(makeRunTitle(models, central));
  rows->addWidget(makeRunPanel(models, central));
  setCentralWidget(central);
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
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange && m_aboutAction != nullptr) {
    retranslate();
    m_document.judge();
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

widgets::TracePage* MainWindow::tracePage() const {
  return m_tabs->findChild<widgets::TracePage*>();
}

widgets::CalibrationPage* MainWindow::calibrationPage() const {
  return m_tabs->findChild<widgets::CalibrationPage*>();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (isRunning()) {
    // Closing must neither leave the machine alone nor stop it by surprise.
    m_messages.show(
        gcode::Severity::Warning,
        tr("A run is in progress. Press Stop, wait until the run has ended, then close."));
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
