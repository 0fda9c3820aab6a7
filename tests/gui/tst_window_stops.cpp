// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Stop of the released window, whoever has started what moves, over OPC UA in real time: at drawn
/// moments of a motion, with drawn pages and dialogs open. It must be there to be pressed, and the
/// axes must stand on their way and stay. RIVULET_STOPS=204 draws as many from the seed
/// RIVULET_FIRST on; who has started what moves comes by turns.

#include <fmt/format.h>

#include <QSettings>
#include <QtTest>
#include <array>
#include <cmath>
#include <map>
#include <memory>

#include "base/random.h"
#include "support/fault_proxy.h"
#include "support/kill_scene.h"
#include "support/patience.h"
#include "support/service_process.h"
#include "support/setting.h"
#include "support/test_program.h"
#include "support/window_process.h"

using namespace rivulet;

namespace {

using rivulet::tests::kRunMs;
using tests::KillScene;
using tests::ServiceProcess;
using tests::WindowProcess;

constexpr unsigned long kPollMs = 20;
/// Within it nothing has moved.
constexpr double kStandsMm = 1e-4;
/// From the end of a move: the tool is on its way.
constexpr double kOnItsWayMm = 0.01;

/// One motion of some 20 s in X, there and back; before it comes nothing of that length.
constexpr double kFromMm = 1.0;
constexpr double kToMm = 301.0;
constexpr auto kMoves = "G90 G1 X1 Y1 Z20 F3000\nX301 F800\nX1\nX301\nX1\nM30\n";
/// The control drills for as long; X stays.
constexpr auto kDrills =
    "G54\nT1 D1 M6\nS3000 M3\nG0 X50 Y50 Z20\nG1 Z15 F3000\nF60\n"
    "CYCLE81(15,10,1,-30)\nM5\nM30\n";

/// Who has started what moves.
enum class Who {
  Window,
  WindowOfACredit,
  WindowOfAJob,
  WindowThatWasKilled,
  WindowWithoutNetwork,
  CommandLine,
  CommandLineOfAJob,
  CommandLineThatWasKilled,
  CommandLineThatHangs,
  Service,
  Nobody,  ///< a program that is no run
  KilledTest,
};
constexpr std::array kAll{
    std::pair(Who::Window, "the window"),
    std::pair(Who::WindowOfACredit, "the window, method credit"),
    std::pair(Who::WindowOfAJob, "the window, a cycle of a whole job"),
    std::pair(Who::WindowThatWasKilled, "a window that was killed"),
    std::pair(Who::WindowWithoutNetwork, "the window, whose network is lost"),
    std::pair(Who::CommandLine, "the command line"),
    std::pair(Who::CommandLineOfAJob, "the command line, a cycle of a whole job"),
    std::pair(Who::CommandLineThatWasKilled, "a command line that was killed"),
    std::pair(Who::CommandLineThatHangs, "a command line that hangs"),
    std::pair(Who::Service, "a service"),
    std::pair(Who::Nobody, "somebody else's program"),
    std::pair(Who::KilledTest, "a test whose client was killed"),
};

/// What is open over the page that shows a run.
constexpr std::array kKeys{"",      "Alt+1", "Alt+2", "Alt+3", "Alt+4", "Alt+5",  "Alt+6",
                           "Alt+7", "F1",    "F11",   "Alt+8", "Alt+9", "Ctrl+O", "Ctrl+Shift+L"};

}  // namespace

class TestWindowStops : public QObject {
  Q_OBJECT

  base::Random m_random{1};
  struct Count {
    int stops = 0;
    int inMotion = 0;  ///< the others had been held by then, as their client was gone
  };
  std::map<Who, Count> m_counts;

  static void writeSettings(const KillScene& scene, bool credit) {
    QSettings store(scene.path("config") + QStringLiteral("/Rivulet/Rivulet.conf"),
                    QSettings::IniFormat);
    store.setValue(QStringLiteral("language"), QStringLiteral("en"));
    store.setValue(QStringLiteral("stream/method"),
                   credit ? QStringLiteral("credit") : QStringLiteral("window"));
    store.setValue(QStringLiteral("stream/points"), 4);
    store.setValue(QStringLiteral("stream/feed"), QStringLiteral("program"));
  }
  static std::unique_ptr<QProcess> runCli(const KillScene& scene, QStringList arguments) {
    auto client = std::make_unique<QProcess>();
    client->setProcessEnvironment(scene.environment());
    client->setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGKILL); });
    arguments << QStringLiteral("--endpoint") << scene.endpoint();
    client->start(QStringLiteral(RIVULET_CLI), arguments);
    return client->waitForStarted(kRunMs) ? std::move(client) : nullptr;
  }
  /// The tool is on the long way: no other move comes there.
  static bool isOnItsWay(const KillScene::Look& look, bool drills) {
    const double at = drills ? look.toolMm.z : look.toolMm.x;
    return drills ? at > -30.0 + kOnItsWayMm && at < 10.0
                  : at > kFromMm + 2.0 && at < kToMm - kOnItsWayMm;
  }
  static bool awaitMotion(const KillScene& scene, bool drills) {
    const QDeadlineTimer patience(kRunMs);
    while (!patience.hasExpired()) {
      const KillScene::Look look = scene.look();
      if (look.feedMmPerMin > 0.0 && isOnItsWay(look, drills)) {
        return true;
      }
      QThread::msleep(kPollMs);
    }
    return false;
  }
  /// @return where; nothing: it never stands
  static std::optional<KillScene::Look> awaitStand(const KillScene& scene) {
    constexpr int kReads = 10;
    const QDeadlineTimer patience(kRunMs);
    KillScene::Look last = scene.look();
    for (int standing = 0; standing < kReads;) {
      if (patience.hasExpired()) {
        return std::nullopt;
      }
      QThread::msleep(kPollMs);
      const KillScene::Look now = scene.look();
      standing = base::distance(now.toolMm, last.toolMm) < kStandsMm ? standing + 1 : 0;
      last = now;
    }
    return last;
  }

  struct Cast {
    std::unique_ptr<tests::FaultProxy> proxy;  ///< between the machine and the window
    std::unique_ptr<WindowProcess> window;
    std::unique_ptr<QProcess> client;
    std::unique_ptr<ServiceProcess> service;
  };

  static void openWindow(const KillScene& scene, Cast& cast, const QString& program = {}) {
    const QString machine =
        cast.proxy ? QString::fromStdString(cast.proxy->endpoint()) : scene.endpoint();
    cast.window = std::make_unique<WindowProcess>(scene.environment(), machine, program);
  }
  static bool startByWindow(const KillScene& scene, Cast& cast, const QString& program) {
    openWindow(scene, cast, program);
    return cast.window->ask("press start") == "pressed" &&
           cast.window->ask("hold start") == "held" && cast.window->awaitState({"Running"});
  }
  static bool startByService(const KillScene& scene, Cast& cast, const QString& program) {
    cast.service = std::make_unique<ServiceProcess>(
        QStringLiteral(RIVULET_SERVICE), scene.endpoint(), scene.environment(),
        QStringList{QStringLiteral("--jobs"), scene.path("")});
    ServiceProcess& service = *cast.service;
    return service.await("Monitoring/IsConnected", "true") &&
           service.call("LoadJob", {QFileInfo(program).fileName().toStdString(), ""}).accepted &&
           service.call("Start", {service.confirmation("Preflight")}).accepted;
  }
  /// The virtual machine lets nobody else reset as long as the client that started is there.
  static bool startByNobody(const KillScene& scene) {
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = scene.endpoint().toStdString();
    options.connectDeadline = std::chrono::milliseconds(kRunMs);
    const auto link = opcua::UaLink::connect(options);
    return link && (*link)->uploadProgram("JOG.MPF", kMoves, true) &&
           (*link)->selectProgram("JOG.MPF") && (*link)->cycleStart();
  }

  /// @return whether it moves, or what it did was refused
  bool begin(Who who, const KillScene& scene, Cast& cast, const QString& moves,
             const QString& drills) {
    const auto words = [](const char* text) { return QString::fromLatin1(text).split(' '); };
    switch (who) {
      case Who::WindowOfACredit: {
        const auto test = runCli(scene, words("commission"));
        if (!test || !test->waitForFinished(kRunMs) || test->exitCode() != 0) {
          return false;
        }
        return startByWindow(scene, cast, moves);
      }
      case Who::WindowWithoutNetwork:
        cast.proxy = std::make_unique<tests::FaultProxy>(scene.endpoint().toStdString());
        return startByWindow(scene, cast, moves);
      case Who::Window:
      case Who::WindowThatWasKilled:
        return startByWindow(scene, cast, moves);
      case Who::WindowOfAJob:
        return startByWindow(scene, cast, drills);
      case Who::CommandLine:
      case Who::CommandLineThatWasKilled:
      case Who::CommandLineThatHangs:
        cast.client = runCli(scene, words("stream --motion-only --points 2") + QStringList{moves});
        return cast.client != nullptr;
      case Who::CommandLineOfAJob:
        cast.client = runCli(scene, words("job --yes") + QStringList{drills});
        return cast.client != nullptr;
      case Who::Service:
        return startByService(scene, cast, drills);
      case Who::Nobody:
        return startByNobody(scene);
      case Who::KilledTest:
        cast.client = runCli(scene, words("commission --feed-cell --air-move X300 --feed 600"));
        return cast.client != nullptr;
    }
    return false;
  }

  /// What becomes of the client in mid-motion.
  void breakIt(Who who, Cast& cast) {
    switch (who) {
      case Who::CommandLineThatWasKilled:
      case Who::KilledTest:
        cast.client->kill();
        cast.client->waitForFinished(kRunMs);
        break;
      case Who::CommandLineThatHangs:
        ::kill(static_cast<pid_t>(cast.client->processId()), SIGSTOP);
        break;
      case Who::WindowThatWasKilled:
        cast.window->signal(SIGKILL);
        cast.window->exit();
        cast.window.reset();
        break;
      case Who::WindowWithoutNetwork:
        // A cable that is pulled, or a connection that is closed; then up to the end of its
        // patience.
        {
          tests::NetworkFault fault;
          fault.kind =
              m_random.uniform() < 0.5 ? tests::FaultKind::Stall : tests::FaultKind::AcceptAndClose;
          fault.duration = std::chrono::hours(1);
          cast.proxy->begin(fault);
        }
        QThread::msleep(static_cast<unsigned long>(15'000.0 * m_random.uniform()));
        break;
      default:
        break;
    }
  }

  void stops(Who who) {
    KillScene scene{QStringLiteral(RIVULET_MACHINE), QStringLiteral("dmu75-mill")};
    scene.switchOn();
    writeSettings(scene, who == Who::WindowOfACredit);
    const QString moves = scene.path("moves.mpf");
    const QString drills = scene.path("drills.mpf");
    for (const auto& [name, text] : {std::pair(moves, kMoves), std::pair(drills, kDrills)}) {
      QFile file(name);
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) > 0);
    }
    const bool isDrilling =
        who == Who::WindowOfAJob || who == Who::CommandLineOfAJob || who == Who::Service;
    Cast cast;
    const bool isOpenBefore = m_random.uniform() < 0.5;
    QVERIFY(begin(who, scene, cast, moves, drills));
    if (!cast.window && isOpenBefore) {
      openWindow(scene, cast);
    }
    QVERIFY(awaitMotion(scene, isDrilling));
    QThread::msleep(static_cast<unsigned long>(2000.0 * m_random.uniform()));
    breakIt(who, cast);
    if (!cast.window) {
      openWindow(scene, cast);
    }
    // A window that has just been opened looks at the control first.
    QCOMPARE(cast.window->ask("await stop"), QByteArray("stop"));
    const char* const keys = kKeys[static_cast<std::size_t>(m_random.uniform() * kKeys.size())];
    if (*keys != '\0') {
      QCOMPARE(cast.window->ask(QByteArray("type ") + keys), QByteArray("typed"));
    }
    QThread::msleep(static_cast<unsigned long>(500.0 * m_random.uniform()));
    Count& count = m_counts[who];
    ++count.stops;
    count.inMotion += scene.look().feedMmPerMin > 0.0 ? 1 : 0;
    QVERIFY2(cast.window->ask("try stop") == "pressed", keys);
    const auto stands = awaitStand(scene);
    QVERIFY(stands.has_value());
    QVERIFY2(isOnItsWay(*stands, isDrilling),
             fmt::format("X{} Z{}", stands->toolMm.x, stands->toolMm.z).c_str());
    // As long as something may move again.
    QVERIFY(stands->isReset || cast.window->ask("try stop") == "pressed");
    const auto still = awaitStand(scene);
    QVERIFY(still && base::distance(still->toolMm, stands->toolMm) < kStandsMm);
  }

 private Q_SLOTS:
  void whoeverHasStartedIt() {
    const auto seed = static_cast<std::uint64_t>(tests::setting("RIVULET_FIRST", 1));
    const int wanted = tests::setting("RIVULET_STOPS", 4);
    m_random = base::Random(seed);
    for (int number = 0; number < wanted; ++number) {
      const auto& [who, name] = kAll[(seed + static_cast<std::uint64_t>(number)) % kAll.size()];
      qInfo("%d: started by %s", number, name);
      stops(who);
      if (QTest::currentTestFailed()) {
        return;
      }
    }
    for (const auto& [who, name] : kAll) {
      qInfo("%s: %d stops, %d of them in motion", name, m_counts[who].stops,
            m_counts[who].inMotion);
    }
  }
};

RIVULET_TEST(TestWindowStops)
#include "tst_window_stops.moc"
