// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// How the real window looks: every page at the sizes, themes and languages it is used in, with the
/// checks of look_check. ctest takes a part of them; scripts/pictures takes all and keeps the
/// pictures, to be looked at.

#include <QDir>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTranslator>
#include <QtTest>
#include <cmath>

#include "base/units.h"
#include "base/utc.h"
#include "gui/look_check.h"
#include "hmi/main_window.h"
#include "language/translator.h"
#include "opcua/error.h"
#include "support/patience.h"
#include "support/simulated_control.h"
#include "support/test_program.h"
#include "widgets/common/focus_frame.h"
#include "widgets/common/help_page.h"
#include "widgets/common/log_view.h"
#include "widgets/connection/certificates_page.h"
#include "widgets/connection/machine_button.h"
#include "widgets/connection/rights_page.h"
#include "widgets/connection/trust_sheet.h"
#include "widgets/program/path_canvas.h"
#include "widgets/program/program_page.h"
#include "widgets/setup/set_up_page.h"
#include "widgets/streaming/run_panel.h"
#include "widgets/trace/trace_page.h"

using namespace rivulet;
using hmi::MainWindow;
using widgets::Theme;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;
constexpr double kInteractivePace = 8.0;
/// While pictures of a run are made, which take minutes on a busy computer.
constexpr double kPicturedPace = 0.5;
constexpr int kWholePathPx = 768;  ///< windows of this height show it whole

const QString kScorpion = QStringLiteral(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");
const QString kPseudo = QStringLiteral("pseudo");

struct Look {
  QSize size;  ///< of the window, in the units of the layout
  Theme theme;
  QString language;
};

/// Where scripts/pictures wants all of them; empty in ctest.
QString pictureFolder() {
  return qEnvironmentVariable("RIVULET_PICTURE_FOLDER");
}

std::vector<Look> looks() {
  if (pictureFolder().isEmpty()) {
    // Each size, theme and translation at least once; 960x540 is FullHD at 200 %. Where the pseudo
    // language has room, English has, too.
    const auto code = [](const char* language) { return QString::fromLatin1(language); };
    return {{{1024, 768}, Theme::Dark, code("fr")},     {{1024, 768}, Theme::Contrast, kPseudo},
            {{960, 540}, Theme::Light, code("de")},     {{960, 540}, Theme::Contrast, kPseudo},
            {{1280, 720}, Theme::Light, kPseudo},       {{1440, 900}, Theme::Dark, code("it")},
            {{1920, 1080}, Theme::Contrast, code("es")}};
  }
  QStringList languages{kPseudo};
  for (const language::Language& language : language::languages()) {
    languages.append(language.code);
  }
  // The script sets the scale of the screen; at 150 and 200 % only FullHD is asked for.
  const double scale = std::max(1.0, qEnvironmentVariable("QT_SCALE_FACTOR").toDouble());
  std::vector<QSize> sizes{{1920, 1080}};
  if (scale == 1.0) {
    sizes = {{1024, 768}, {1280, 800}, {1920, 1080}};
  }
  std::vector<Look> all;
  for (const QSize size : sizes) {
    for (const Theme theme : {Theme::Light, Theme::Dark, Theme::Contrast}) {
      for (const QString& language : languages) {
        all.push_back({(QSizeF(size) / scale).toSize(), theme, language});
      }
    }
  }
  return all;
}

opcua::CertificateFacts certificate(char digit) {
  opcua::CertificateFacts facts;
  facts.fingerprint = std::string(62, digit) + "42";
  facts.subject = "CN=SINUMERIK OPC UA Server@cell-4, O=Siemens AG, OU=Machine tools, C=DE";
  facts.issuer = facts.subject;
  facts.validFrom = *base::utcOfText("2026-01-02T03:04:05.000Z");
  facts.validTo = *base::utcOfText("2031-01-01T03:04:05.000Z");
  facts.applicationUris = {"urn:cell-4:Siemens:SinumerikOpcUaServer"};
  facts.hostNames = {"cell-4", "192.168.214.241"};
  return facts;
}

opcua::TrustQuestion questionOf(opcua::TrustQuestion::Kind kind) {
  opcua::TrustQuestion question;
  question.kind = kind;
  question.endpoint = "opc.tcp://192.168.214.242:4840";
  question.shown = certificate('a');
  question.isValidNow = true;
  if (kind == opcua::TrustQuestion::Kind::ChangedServer) {
    question.accepted = certificate('b');
    question.acceptedFingerprint = question.accepted->fingerprint;
  } else if (kind == opcua::TrustQuestion::Kind::Protection) {
    question.wasEncrypted = true;
    for (const char* text : {"Basic256Sha256/Sign", "Basic128Rsa15", "None"}) {
      question.choices.push_back(*opcua::securityChoiceOf(text));
    }
  }
  return question;
}

}  // namespace

class TestLook : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<tests::SimulatedControl> m_machine;
  std::unique_ptr<MainWindow> m_window;
  std::unique_ptr<QTranslator> m_pseudo;
  QTemporaryDir m_folder;
  QStringList m_faults;

  void open() {
    streaming::StreamSettings stream;
    stream.parameters.method = base::MethodKind::Window;
    stream.parameters.pointsPerLoop = 7;
    stream.feedMmPerS = base::mmPerSFromMmPerMin(3000.0);
    m_window->setStreamSettings(stream);
    m_window->openProgram(kScorpion);
    m_window->connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
  }

  void dress(const Look& look) {
    QCoreApplication::removeTranslator(m_pseudo.get());
    m_window->setLanguage(look.language == kPseudo ? QStringLiteral("en") : look.language);
    if (look.language == kPseudo) {
      QCoreApplication::installTranslator(m_pseudo.get());
    }
    m_window->setTheme(look.theme);
    m_window->resize(look.size);
  }

  void inspect(const Look& look, const QString& scene) {
    // What is laid out lays out what is in it in the next turn.
    for (int turn = 0; turn < 4; ++turn) {
      QCoreApplication::sendPostedEvents();
      QCoreApplication::processEvents();
    }
    m_window->tracePage()->redrawNow();
    const QImage picture = m_window->grab().toImage();
    const QString name = QStringLiteral("%1x%2-%3-%4-%5")
                             .arg(look.size.width())
                             .arg(look.size.height())
                             .arg(widgets::themeName(look.theme), look.language, scene);
    if (m_window->size() != look.size) {
      m_faults.append(name + QStringLiteral(": the window takes another size"));
    }
    // The path is what an operator looks at: none of it lies below the edge of its page.
    for (const QWidget* canvas : m_window->programPage()->findChildren<widgets::PathCanvas*>()) {
      if (canvas->isVisible() && look.size.height() >= kWholePathPx &&
          canvas->visibleRegion().boundingRect().size() != canvas->size()) {
        m_faults.append(name + QStringLiteral(": the path is cut"));
      }
    }
    noteEnglish(look, name);
    for (const QString& fault : tests::lookFaults(*m_window, picture)) {
      m_faults.append(name + QStringLiteral(": ") + fault);
    }
    if (!pictureFolder().isEmpty()) {
      QVERIFY(picture.save(QDir(pictureFolder()).filePath(name + QStringLiteral(".png"))));
    }
  }

  /// Texts of the pseudo language begin with a bracket: a message without one, or four words in a
  /// label, are English whatever the language.
  void noteEnglish(const Look& look, const QString& name) {
    if (look.language != kPseudo) {
      return;
    }
    const QAbstractItemModel& messages = *m_window->findChild<widgets::LogModel*>();
    for (int row = 0; row < messages.rowCount(); ++row) {
      const QString text = messages.index(row, widgets::LogModel::Text).data().toString();
      if (!text.startsWith(QLatin1Char('['))) {
        m_faults.append(name + QStringLiteral(": not translated: ") + text);
      }
    }
    static const QRegularExpression words(QStringLiteral("([a-z]{2,} ){3}[a-z]{2,}"));
    for (const QLabel* label : m_window->findChildren<QLabel*>()) {
      const QString text = label->isVisible() ? label->text() : QString();
      if (!text.contains(QLatin1Char('[')) && words.match(text).hasMatch()) {
        m_faults.append(QStringLiteral("%1: %2 not translated: %3")
                            .arg(name, label->objectName(), text.simplified()));
      }
    }
  }

  void inspectPages(const Look& look, const QString& scene) {
    for (int page = 0; page < m_window->pages()->count(); ++page) {
      m_window->pages()->setCurrentIndex(page);
      auto* setUp = m_window->findChild<widgets::SetUpPage*>();
      const int steps = setUp->isVisible() ? setUp->steps()->count() : 1;
      for (int step = 0; step < steps; ++step) {
        if (steps > 1) {
          setUp->steps()->setCurrentIndex(step);
        }
        inspect(look, step == 0 ? QStringLiteral("%1-%2").arg(scene).arg(page)
                                : QStringLiteral("%1-%2-%3").arg(scene).arg(page).arg(step));
      }
      auto* panel = m_window->tracePage()->findChild<QTabWidget*>("tracePanel");
      for (int tab = 1; panel->isVisible() && tab < panel->count(); ++tab) {
        panel->setCurrentIndex(tab);
        inspect(look, QStringLiteral("%1-%2-%3").arg(scene).arg(page).arg(tab));
      }
      panel->setCurrentIndex(0);
    }
    m_window->pages()->setCurrentIndex(0);
  }

  void verifyNoFaults() {
    if (!pictureFolder().isEmpty()) {
      QFile file(QDir(pictureFolder())
                     .filePath(QStringLiteral("faults-%1.txt")
                                   .arg(QLatin1String(QTest::currentTestFunction()))));
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(m_faults.join(QLatin1Char('\n')).toUtf8());
    }
    QVERIFY2(m_faults.isEmpty(), qPrintable(QStringLiteral("%1 faults:\n%2")
                                                .arg(m_faults.size())
                                                .arg(m_faults.join(QLatin1Char('\n')))));
  }

 private Q_SLOTS:
  void initTestCase() {
    qputenv("XDG_DATA_HOME", m_folder.path().toUtf8());
    qputenv("XDG_CONFIG_HOME", m_folder.path().toUtf8());
    QCoreApplication::setOrganizationName(QStringLiteral("RivuletTest"));
    m_pseudo = tests::makePseudoTranslator();
    if (!pictureFolder().isEmpty()) {
      QVERIFY(QDir().mkpath(pictureFolder()));
    }
  }

  void init() {
    // A run that an earlier test left would be offered.
    QDir(qEnvironmentVariable("XDG_STATE_HOME")).removeRecursively();
    m_faults.clear();
    m_machine = std::make_unique<tests::SimulatedControl>("dmu75", kInteractivePace);
    hmi::Settings settings;
    settings.language = QStringLiteral("en");
    settings.theme = Theme::Light;
    m_window = std::make_unique<MainWindow>(
        settings, false, [this](const auto& asked) { return m_machine->connect(asked.endpoint); });
    m_window->show();
  }

  void cleanup() {
    QCoreApplication::removeTranslator(m_pseudo.get());
    m_window.reset();
    m_machine.reset();
  }

  /// Before anything was opened.
  void nothingOpen() {
    for (const Look& look : looks()) {
      dress(look);
      inspect(look, QStringLiteral("nothing"));
    }
    verifyNoFaults();
  }

  /// Ready, and what stands before a start.
  void ready() {
    open();
    for (const Look& look : looks()) {
      dress(look);
      inspect(look, QStringLiteral("ready"));
      m_window->showPreflight();
      inspect(look, QStringLiteral("preflight"));
      m_window->closePreflight();
    }
    verifyNoFaults();
  }

  /// During a run and a pause. After a run that was stopped, with the question how to go on, every
  /// page has something to show.
  void afterStop() {
    open();
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed >= 14, kRunMs);
    m_machine->setPace(kPicturedPace);
    for (const Look& look : looks()) {
      dress(look);
      inspect(look, QStringLiteral("running"));
    }
    QCOMPARE(m_window->lastUpdate().state, streaming::RunState::Running);
    m_machine->setPace(kInteractivePace);
    m_window->findChild<widgets::RunPanel*>()->findChild<QPushButton*>("hold")->click();
    QTRY_COMPARE_WITH_TIMEOUT(m_window->lastUpdate().state, streaming::RunState::Holding, kRunMs);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().feed->stoodAfter.has_value(), kRunMs);
    for (const Look& look : looks()) {
      dress(look);
      inspect(look, QStringLiteral("paused"));
    }
    m_window->stop();
    QVERIFY(finished.wait(kRunMs));
    m_machine->setPace(tests::SimulatedControl::kUnlimited);
    for (const Look& look : looks()) {
      dress(look);
      inspectPages(look, QStringLiteral("stopped"));
    }
    verifyNoFaults();
  }

  /// A live source: open, before its start, while it is silent, and after it was refused.
  void liveSource() {
    live::Setup setup;
    setup.address = "tcp:0";
    setup.agreement.highestMm = {20.0, 20.0, 60.0};
    setup.agreement.feedMmPerMinMax = 3000.0;
    setup.limits.endAfter = std::chrono::hours{1};
    m_window->openLive(setup);
    m_window->connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
    for (const Look& look : looks()) {
      dress(look);
      inspect(look, QStringLiteral("live-open"));
      m_window->showPreflight();
      inspect(look, QStringLiteral("live-preflight"));
      m_window->closePreflight();
    }
    QTcpSocket sender;
    const QString name = QString::fromStdString(m_window->program()->name);
    sender.connectToHost(QStringLiteral("127.0.0.1"), name.section(QLatin1Char(':'), 1).toUShort());
    QVERIFY(sender.waitForConnected(kSoonMs));
    for (int i = 1; i <= 150; ++i) {
      const double angle = 0.05 * i;
      const double radiusMm = 0.06 * i;
      sender.write(QByteArrayLiteral("X") + QByteArray::number(radiusMm * std::cos(angle), 'f', 4) +
                   QByteArrayLiteral(" Y") +
                   QByteArray::number(radiusMm * std::sin(angle), 'f', 4) +
                   QByteArrayLiteral(" F2400\n"));
    }
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().state == streaming::RunState::Holding, kRunMs);
    for (const Look& look : looks()) {
      dress(look);
      inspect(look, QStringLiteral("live-silent"));
    }
    sender.write("Z-30\n");
    QVERIFY(finished.wait(kRunMs));
    for (const Look& look : looks()) {
      dress(look);
      inspect(look, QStringLiteral("live-refused"));
    }
    verifyNoFaults();
  }

  /// F1 shows the manual at the page in front, and goes back to it.
  void helpIsAboutThePage() {
    auto* help = m_window->findChild<widgets::HelpPage*>();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    for (int page = 0; page < m_window->pages()->count(); ++page) {
      m_window->pages()->setCurrentIndex(page);
      QTest::keyClick(m_window.get(), Qt::Key_F1);
      QVERIFY(help->isVisible() && !m_window->pages()->isVisible());
      QVERIFY2(
          !help->headingShown().isEmpty() && help->headingShown() != QStringLiteral("The window"),
          qPrintable(m_window->pages()->tabText(page)));
      if (page == 0) {
        for (const Look& look : looks()) {
          dress(look);
          inspect(look, QStringLiteral("help"));
        }
      }
      QTest::keyClick(m_window.get(), Qt::Key_F1);
      QVERIFY(!help->isVisible() && m_window->pages()->isVisible());
    }
    verifyNoFaults();
  }

  /// What the keyboard has reached is framed, on every page.
  void focusIsFramed() {
    open();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_window->resize(1440, 900);
    auto* frame = m_window->findChild<widgets::FocusFrame*>();
    QSet<QWidget*> reached;
    for (int step = 0; step < 60; ++step) {
      QTest::keyClick(m_window.get(), Qt::Key_Tab);
      QWidget* focus = QApplication::focusWidget();
      QVERIFY(focus != nullptr);
      QCOMPARE(frame->target(), focus);
      reached.insert(focus);
    }
    QVERIFY2(reached.size() > 15, qPrintable(QString::number(reached.size())));
    for (const char* name : {"start"}) {
      QVERIFY(reached.contains(m_window->findChild<QWidget*>(QLatin1String(name))));
    }
  }

  /// The connection is lost.
  void lost() {
    open();
    m_machine->kill();
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->startBlockedReason().isEmpty(), kSoonMs);
    for (const Look& look : looks()) {
      dress(look);
      inspect(look, QStringLiteral("lost"));
    }
    verifyNoFaults();
  }

  /// What is asked before a machine is connected.
  void trustIsAsked() {
    for (const auto kind :
         {opcua::TrustQuestion::Kind::NewServer, opcua::TrustQuestion::Kind::ChangedServer,
          opcua::TrustQuestion::Kind::Protection, opcua::TrustQuestion::Kind::Login}) {
      const auto question = std::make_shared<const opcua::TrustQuestion>(questionOf(kind));
      hmi::Settings settings;
      settings.language = QStringLiteral("en");
      m_window = std::make_unique<MainWindow>(settings, false, [question](const auto&) {
        return opcua::Attempt(base::fail(opcua::LinkError::CertificateUnknown, "asked"), question);
      });
      m_window->show();
      m_window->connectTo(QString::fromStdString(question->endpoint));
      auto* sheet = m_window->findChild<widgets::TrustSheet*>();
      auto* machine = m_window->findChild<QToolButton*>(QStringLiteral("machine"));
      if (widgets::isOnSheet(*question)) {
        QTRY_VERIFY_WITH_TIMEOUT(sheet->isVisible(), kSoonMs);
        sheet->setOwnCertificate(certificate('c'));
      } else {
        machine->click();
        QTRY_VERIFY_WITH_TIMEOUT(
            m_window->findChild<QWidget*>(QStringLiteral("login-user"))->isVisible(), kSoonMs);
      }
      for (const Look& look : looks()) {
        dress(look);
        inspect(look, QStringLiteral("trust-%1").arg(static_cast<int>(kind)));
      }
    }
    verifyNoFaults();
  }

  /// Certificates and rights with something in them, and the protection of the connection.
  void trustIsShown() {
    open();
    widgets::CertificatesView view;
    view.own = certificate('c');
    view.ownDaysLeft = 1801;
    view.library = QStringLiteral("/usr/lib/x86_64-linux-gnu/libmbedcrypto.so.16");
    view.servers = {
        {"opc.tcp://192.168.214.241:4840", certificate('a').fingerprint, certificate('a'), 364, ""},
        {"opc.tcp://cell-4.shop.example:4840", "", std::nullopt, 0, "Basic128Rsa15"}};
    view.rejected = {{"opc.tcp://192.168.214.241:4840", certificate('b')}};
    opcua::RightsReport report;
    using opcua::RunRight;
    report.findings = {{RunRight::ReadVariables, true},
                       {RunRight::WriteParameters, false},
                       {RunRight::ReadPrograms, true},
                       {RunRight::WritePrograms, std::nullopt},
                       {RunRight::SelectProgram, false}};
    report.excess = {"SinuWriteAll", "AlarmDelete"};
    auto* setUp = m_window->findChild<widgets::SetUpPage*>();
    auto* certificates = m_window->findChild<widgets::CertificatesPage*>();
    auto* rights = m_window->findChild<widgets::RightsPage*>();
    auto* machine = m_window->findChild<widgets::MachineButton*>();
    m_window->pages()->setCurrentIndex(8);
    QVERIFY(setUp->isVisible());
    for (const Look& look : looks()) {
      dress(look);
      machine->setConnectionState(widgets::ConnectionState::Connected, opcua::Protection::Weak,
                                  QStringLiteral("Basic128Rsa15, SignAndEncrypt"));
      certificates->setCertificates(view);
      rights->setReport(report);
      setUp->steps()->setCurrentIndex(5);
      inspect(look, QStringLiteral("certificates"));
      machine->setConnectionState(widgets::ConnectionState::Connected, opcua::Protection::Encrypted,
                                  QStringLiteral("Aes256_Sha256_RsaPss, SignAndEncrypt"));
      setUp->steps()->setCurrentIndex(6);
      inspect(look, QStringLiteral("rights"));
    }
    verifyNoFaults();
  }
};

RIVULET_TEST(TestLook)
#include "tst_look.moc"
