// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QScreen>
#include <algorithm>

#include "hmi/demo.h"
#include "hmi/end_signals.h"
#include "hmi/main_window.h"
#include "hmi/sleep_guard.h"
#include "platform/log.h"

namespace {

/// What Qt has to say goes to the log as well.
void logQtMessage(QtMsgType type, const QMessageLogContext& /*context*/, const QString& text) {
  const spdlog::level::level_enum level = type == QtDebugMsg     ? spdlog::level::debug
                                          : type == QtInfoMsg    ? spdlog::level::info
                                          : type == QtWarningMsg ? spdlog::level::warn
                                                                 : spdlog::level::err;
  rivulet::log::logger().log(level, text.toStdString());
}

void startLog(const std::string& level) {
  const std::vector<std::string> names = rivulet::log::levelNames();
  const bool isLevel = std::find(names.begin(), names.end(), level) != names.end();
  const auto done = rivulet::log::setUp(
      {"rivulet", isLevel ? level : std::string(), rivulet::log::recordingsFolder()});
  if (!isLevel && !level.empty()) {
    rivulet::log::logger().warn("{} is no level: see --help.", level);
  }
  if (!done) {
    rivulet::log::logger().warn(done.error().text());
  }
  qInstallMessageHandler(&logQtMessage);
  rivulet::log::logger().info("rivulet " RIVULET_VERSION " started");
}

/// What may stand on the command line.
struct CommandLine {
  explicit CommandLine(const QApplication& application) {
    parser.setApplicationDescription(QStringLiteral(
        "Streams a tool path to a CNC machine over OPC UA while the machine moves."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(
        QStringLiteral("FILE"), QStringLiteral("Recordings and traces to open on the page Traces."),
        QStringLiteral("[FILE...]"));
    parser.addOptions({traces, password, log, connect, open, demo, language, theme});
    parser.process(application);
  }

  [[nodiscard]] bool has(const QCommandLineOption& option) const { return parser.isSet(option); }
  [[nodiscard]] QString value(const QCommandLineOption& option) const {
    return parser.value(option);
  }

  const QCommandLineOption connect{QStringLiteral("connect"),
                                   QStringLiteral("Connect to this OPC UA server."),
                                   QStringLiteral("URL")};
  const QCommandLineOption open{QStringLiteral("open"), QStringLiteral("Open this NC program."),
                                QStringLiteral("FILE")};
  const QCommandLineOption demo{
      QStringLiteral("demo"),
      QStringLiteral("Press Start, leave pictures and the report in this folder, and quit."),
      QStringLiteral("FOLDER")};
  const QCommandLineOption language{QStringLiteral("language"),
                                    QStringLiteral("en, de, fr, it or es."),
                                    QStringLiteral("LANGUAGE")};
  const QCommandLineOption theme{QStringLiteral("theme"),
                                 QStringLiteral("light, dark, contrast or system."),
                                 QStringLiteral("THEME")};
  const QCommandLineOption log{
      QStringLiteral("log-level"),
      QStringLiteral("What is logged on standard error (default: warning) and in the log file "
                     "(default: info): trace, debug, info, warning, error, critical or off."),
      QStringLiteral("LEVEL")};
  const QCommandLineOption password{
      QStringLiteral("password-file"),
      QStringLiteral("Where no keyring has it, read the password of the machine's user from this "
                     "file (mode 0600)."),
      QStringLiteral("FILE")};
  const QCommandLineOption traces{QStringLiteral("traces"),
                                  QStringLiteral("Compare the files: show them on one time axis.")};
  QCommandLineParser parser;
};

rivulet::hmi::Settings settingsOf(const CommandLine& line) {
  rivulet::hmi::Settings settings = rivulet::hmi::loadSettings();
  if (line.has(line.demo)) {
    // The same demonstration everywhere, whatever was set here before.
    settings = rivulet::hmi::Settings();
    settings.stream.feedMmPerS = 2000.0 / 60.0;
    settings.language = QStringLiteral("en");
    settings.theme = rivulet::widgets::Theme::Light;
  }
  if (line.has(line.language)) {
    settings.language = line.value(line.language);
  }
  if (line.has(line.theme)) {
    settings.theme = rivulet::widgets::themeFromName(line.value(line.theme));
  }
  settings.passwordFile = line.value(line.password).toStdString();
  return settings;
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("Rivulet"));
  QApplication::setApplicationName(QStringLiteral("Rivulet"));
  QApplication::setApplicationVersion(QStringLiteral(RIVULET_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("rivulet"));
  QApplication::setWindowIcon(QIcon(QStringLiteral(":/rivulet/desktop/rivulet.svg")));

  const CommandLine line(application);
  startLog(line.value(line.log).toStdString());

  const bool isDemo = line.has(line.demo);
  rivulet::hmi::MainWindow window(settingsOf(line), !isDemo);
  if (!isDemo) {
    // Stop must be on the screen, also where no window manager cares.
    window.resize(window.size().boundedTo(window.screen()->availableSize()));
  }
  window.show();
  const rivulet::hmi::EndSignals endSignals;
  QObject::connect(&endSignals, &rivulet::hmi::EndSignals::received, &window,
                   &rivulet::hmi::MainWindow::stopAndClose);
  rivulet::hmi::SleepGuard awake(QDBusConnection::systemBus());
  QObject::connect(&window, &rivulet::hmi::MainWindow::runStarted, &awake,
                   &rivulet::hmi::SleepGuard::hold);
  QObject::connect(&window, &rivulet::hmi::MainWindow::runFinished, &awake,
                   &rivulet::hmi::SleepGuard::release);
  // The end of the session: what is not stopped by then would be killed.
  QObject::connect(
      &application, &QGuiApplication::commitDataRequest, &window,
      [&window] { window.stopAndWait(); }, Qt::DirectConnection);
  if (line.has(line.open)) {
    window.openProgram(line.value(line.open));
  }
  if (!line.parser.positionalArguments().isEmpty()) {
    window.openTraces(line.parser.positionalArguments());
  }
  if (line.has(line.connect)) {
    window.connectTo(line.value(line.connect));
  }
  if (isDemo) {
    new rivulet::hmi::Demo(window, line.value(line.demo));  // the window owns it
  }
  return QApplication::exec();
}
