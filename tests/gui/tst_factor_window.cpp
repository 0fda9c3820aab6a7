// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Adaptive feed in the window: a real socket, the real window, a virtual machine in virtual time.
/// The factor acts, what was not agreed holds the axes, and the operator always wins.

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QtTest>

#include "base/units.h"
#include "gui/end_by_hand.h"
#include "hmi/main_window.h"
#include "hmi/settings.h"
#include "live/error.h"
#include "report/run_history.h"
#include "support/patience.h"
#include "support/simulated_control.h"
#include "support/test_program.h"
#include "widgets/common/folding_columns.h"
#include "widgets/common/hold_button.h"
#include "widgets/common/number_field.h"
#include "widgets/common/status_label.h"
#include "widgets/streaming/factor_panel.h"
#include "widgets/streaming/preflight_sheet.h"
#include "widgets/streaming/run_panel.h"

using namespace rivulet;
using namespace std::chrono_literals;
using hmi::MainWindow;
using live::FactorState;
using streaming::Outcome;
using streaming::RunReport;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;
/// Seconds of the machine in one second, where a test acts in the middle of a run.
constexpr double kPace = 4.0;
const QString kProgram = QStringLiteral(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");

hmi::Settings settings() {
  hmi::Settings settings;
  settings.language = QStringLiteral("en");
  settings.theme = widgets::Theme::Light;
  return settings;
}

streaming::StreamSettings slowly() {
  streaming::StreamSettings stream;
  stream.parameters.pointsPerLoop = 7;
  stream.feedMmPerS = base::mmPerSFromMmPerMin(3000.0);
  return stream;
}

/// Nobody listens there: what took it has let it go.
quint16 freePort() {
  QTcpServer server;
  server.listen(QHostAddress::LocalHost);
  return server.serverPort();
}

QString shown(const QWidget& widget) {
  QStringList texts;
  for (const auto* label : widget.findChildren<QLabel*>()) {
    texts.append(label->isVisible() ? label->text() : QString());
  }
  return texts.join(QLatin1Char('\n')).replace(QChar::Nbsp, QLatin1Char(' '));
}

}  // namespace

class TestFactorWindow : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<tests::SimulatedControl> m_machine;
  std::unique_ptr<MainWindow> m_window;
  QTemporaryDir m_folder;

  template <class Widget>
  [[nodiscard]] Widget* find(const char* id) const {
    return m_window->findChild<Widget*>(QString::fromLatin1(id));
  }
  [[nodiscard]] QString strip() const { return shown(*m_window->findChild<widgets::RunPanel*>()); }
  [[nodiscard]] double percent() const {
    const auto& feed = m_window->lastUpdate().feed;
    return feed ? feed->actsPercent.value_or(-1.0) : -1.0;
  }
  [[nodiscard]] std::optional<FactorState> state() const {
    const auto& feed = m_window->lastUpdate().feed;
    return feed && feed->source ? std::optional(feed->source->state) : std::nullopt;
  }
  void open(const streaming::StreamSettings& stream = slowly()) {
    m_window->setStreamSettings(stream);
    m_window->openProgram(kProgram);
    m_window->connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
  }
  /// As an operator chooses it.
  void choose(quint16 port) const {
    find<QComboBox>("factor-source")->setCurrentIndex(1);
    find<QSpinBox>("factor-port")->setValue(port);
    find<QDoubleSpinBox>("factor-silence")->setValue(60.0);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
  }
  void keepPicture(const QString& name) const {
    QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS));
    QCoreApplication::processEvents();
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/factor-%1.png").arg(name)));
  }

 private Q_SLOTS:
  void initTestCase() {
    qputenv("XDG_DATA_HOME", m_folder.path().toUtf8());
    QCoreApplication::setOrganizationName(QStringLiteral("RivuletTest"));
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                       m_folder.filePath(QStringLiteral("config")));
  }
  void init() {
    QDir(qEnvironmentVariable("XDG_STATE_HOME")).removeRecursively();
    m_machine = std::make_unique<tests::SimulatedControl>("dmu75", kPace);
    m_window = std::make_unique<MainWindow>(
        settings(), false,
        [this](const opcua::ConnectRequest& asked) { return m_machine->connect(asked.endpoint); });
    m_window->resize(1280, 800);
    m_window->show();
    m_window->findChild<widgets::FoldingColumns*>()->setOpen(widgets::FoldingColumns::Second, true);
  }
  void cleanup() {
    m_window.reset();
    m_machine.reset();
  }

  void theSourceMultipliesTheOverride() {
    const quint16 port = freePort();
    const QString name = QStringLiteral("tcp:%1").arg(port);
    open();
    choose(port);
    keepPicture(QStringLiteral("chosen"));
    auto* start = find<widgets::HoldButton>("start");
    QTest::mouseClick(start, Qt::LeftButton);
    const auto* sheet = m_window->findChild<widgets::PreflightSheet*>();
    const QString agreed = shown(*sheet);
    QVERIFY2(agreed.contains(name + QStringLiteral(" multiplies your override: 20 % to 120 %")),
             qPrintable(agreed));
    keepPicture(QStringLiteral("preflight"));
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QTest::mousePress(start, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isRunning(), kSoonMs);
    QTest::mouseRelease(start, Qt::LeftButton);

    // Nothing moves before the first factor.
    QTRY_VERIFY_WITH_TIMEOUT(state() == FactorState::Waiting && percent() == 0.0, kRunMs);
    QTRY_VERIFY_WITH_TIMEOUT(strip().contains(name + QStringLiteral(": no factor has come yet")),
                             kSoonMs);
    QVERIFY(!find<QComboBox>("factor-source")->isEnabled());
    QTcpSocket sender;
    sender.connectToHost(QStringLiteral("127.0.0.1"), port);
    QVERIFY(sender.waitForConnected(kSoonMs));
    const auto send = [&sender](const char* line) {
      sender.write(line);
      QVERIFY(sender.waitForBytesWritten(kSoonMs));
    };
    send("feed 0.5\n");
    QTRY_COMPARE_WITH_TIMEOUT(percent(), 50.0, kRunMs);
    QTRY_VERIFY_WITH_TIMEOUT(
        strip().contains(QStringLiteral("50 % of your override, from ") + name), kSoonMs);
    QVERIFY(find<widgets::StatusLabel>("factor-status")->text().contains(name));
    keepPicture(QStringLiteral("follows"));

    // It was not agreed: the axes are held, and Stop can be pressed as ever.
    send("feed 250\n");
    QTRY_VERIFY_WITH_TIMEOUT(state() == FactorState::Refused && percent() == 0.0, kRunMs);
    QTRY_VERIFY_WITH_TIMEOUT(strip().contains(QStringLiteral("25,000 % was not agreed")), kSoonMs);
    QVERIFY(find<QPushButton>("stop")->isEnabled());
    keepPicture(QStringLiteral("refused"));
    // The operator goes on without it; its next factor acts again, with his override.
    QTRY_COMPARE_WITH_TIMEOUT(find<QPushButton>("hold")->text(), QStringLiteral("Continue"),
                              kSoonMs);
    QTest::mouseClick(find<QPushButton>("hold"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(percent(), 100.0, kRunMs);
    QVERIFY(state() == FactorState::Released);
    send("feed 0.8\n");
    QTRY_COMPARE_WITH_TIMEOUT(percent(), 80.0, kRunMs);
    QTest::mouseClick(find<QPushButton>("override-less"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(percent(), 76.0, kRunMs);
    QByteArray told;
    const auto isTold = [&] {
      told += sender.readAll();
      return told.contains("\"percent\":76");
    };
    QTRY_VERIFY_WITH_TIMEOUT(isTold(), kSoonMs);

    // Whoever ends the run does not wait for a source that is gone.
    sender.close();
    QTRY_VERIFY_WITH_TIMEOUT(state() == FactorState::Closed && percent() == 0.0, kRunMs);
    QTest::mouseClick(find<QPushButton>("stop"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().feed->wantedPercent == 0.0, kRunMs);
    tests::endByHand(*m_window);
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    const auto report = m_window->lastReport();
    QVERIFY2(report->outcome == Outcome::Stopped, report->error.text().c_str());
    QVERIFY(report->integrity.isFaultless());
    QVERIFY(report->factor.has_value());
    QCOMPARE(report->factor->count.source, name.toStdString());
    QCOMPARE(report->factor->count.values, std::size_t{2});
    QCOMPARE(report->factor->count.refused, std::size_t{1});
    QVERIFY(find<QComboBox>("factor-source")->isEnabled());
    // It is in the history, with what was agreed.
    const auto runs = report::RunHistory().list().runs;
    QCOMPARE(runs.size(), std::size_t{1});
    const auto kept = report::readFinishedRun(report::RunHistory().reportFile(runs.front().id));
    QVERIFY(kept && kept->report.factor);
    QCOMPARE(kept->report.settings.factor, report->settings.factor);
    QCOMPARE(kept->report.settings.parameters.factorMost, 1.2);
  }

  void silenceLeavesTheOverrideAlone() {
    const quint16 port = freePort();
    open();
    choose(port);
    find<QDoubleSpinBox>("factor-silence")->setValue(0.5);
    find<QComboBox>("factor-without")->setCurrentIndex(1);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QTRY_COMPARE_WITH_TIMEOUT(percent(), 100.0, kRunMs);
    QTcpSocket sender;
    sender.connectToHost(QStringLiteral("127.0.0.1"), port);
    QVERIFY(sender.waitForConnected(kSoonMs));
    sender.write("feed 0.3\n");
    QVERIFY(sender.waitForBytesWritten(kSoonMs));
    QTRY_VERIFY_WITH_TIMEOUT(state() == FactorState::Silent && percent() == 100.0, kRunMs);
    QVERIFY(strip().contains(QStringLiteral("your override acts alone")));
    QTest::mouseClick(find<QPushButton>("stop"), Qt::LeftButton);
    tests::endByHand(*m_window);
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    QCOMPARE(m_window->lastReport()->factor->count.silences, std::size_t{1});
    QCOMPARE(m_window->lastReport()->factor->least, 0.3);
  }

  void aPortThatIsTakenStartsNothing() {
    QTcpServer other;
    QVERIFY(other.listen(QHostAddress::LocalHost));
    open();
    choose(other.serverPort());
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    QVERIFY(m_window->lastReport()->error.code == live::LiveError::NotOpened);
    QCOMPARE(m_window->lastReport()->counters.executed, std::size_t{0});
  }

  void aMethodWithoutAFactorIsRefused() {
    streaming::StreamSettings stream = slowly();
    open(stream);
    stream.factor.address = "tcp:4002";
    stream.parameters.factorLeast = 0.2;
    stream.parameters.factorMost = 1.2;
    stream.parameters.method = base::MethodKind::Signal;
    m_window->setStreamSettings(stream);
    QTRY_VERIFY_WITH_TIMEOUT(
        m_window->startBlockedReason().contains(QStringLiteral("has no factor of the override")),
        kSoonMs);
    // It can be chosen away.
    find<QComboBox>("factor-source")->setCurrentIndex(0);
    QTRY_VERIFY_WITH_TIMEOUT(
        !m_window->startBlockedReason().contains(QStringLiteral("has no factor of the override")),
        kSoonMs);
  }

  void isRemembered() {
    hmi::Settings saved = settings();
    saved.stream.factor = {"udp:4711", 2500ms, false};
    saved.stream.parameters.factorLeast = 0.35;
    saved.stream.parameters.factorMost = 1.1;
    hmi::saveSettings(saved);
    const hmi::Settings loaded = hmi::loadSettings();
    QCOMPARE(loaded.stream.factor, saved.stream.factor);
    QCOMPARE(loaded.stream.parameters.factorLeast, 0.35);
    QCOMPARE(loaded.stream.parameters.factorMost, 1.1);
    // A damaged file agrees on nothing.
    for (const auto& [key, value] : std::initializer_list<std::pair<const char*, QVariant>>{
             {"factor/source", QStringLiteral("unix:/tmp/x")},
             {"factor/source", QStringLiteral("tcp:70000")},
             {"factor/most", 3.0},
             {"factor/least", QStringLiteral("nan")}}) {
      hmi::saveSettings(saved);
      QSettings().setValue(QString::fromLatin1(key), value);
      const hmi::Settings damaged = hmi::loadSettings();
      QVERIFY2(damaged.stream.factor.address.empty(), key);
      QVERIFY2(!damaged.stream.parameters.hasFactor(), key);
    }
  }

  /// For a person to look at.
  void pictures() {
    open();
    choose(4002);
    for (const QSize size : {QSize(1024, 768), QSize(1280, 800)}) {
      m_window->resize(size);
      for (const char* language : {"en", "de"}) {
        m_window->setLanguage(QString::fromLatin1(language));
        keepPicture(QStringLiteral("%1-%2").arg(size.width()).arg(QLatin1String(language)));
      }
    }
  }
};

RIVULET_TEST(TestFactorWindow)
#include "tst_factor_window.moc"
