// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The released window and the released virtual machine, over OPC UA in real time, killed at drawn
/// moments of a run. A new window finds the run; it is watched, stopped and resumed by the buttons
/// an operator presses (see pilot.cpp). Each point must be executed once.

#include <QDeadlineTimer>
#include <QProcess>
#include <QSettings>
#include <QtTest>
#include <array>
#include <csignal>
#include <memory>

#include "base/random.h"
#include "support/kill_scene.h"
#include "support/patience.h"
#include "support/setting.h"
#include "support/test_program.h"
#include "support/window_process.h"

using namespace rivulet;

namespace {

using rivulet::tests::kRunMs;
using Window = rivulet::tests::WindowProcess;
/// Long enough for a window to be executed.
constexpr unsigned long kStaysMs = 500;
/// Of a whole run, about: kills are drawn within it.
constexpr double kStreamMs = 5000.0;

struct Tally {
  int kills = 0;
  std::array<int, 3> bySignal{};
  int machineKills = 0;
  int reconnected = 0;  ///< of these: the same window went on
  int runs = 0;         ///< to the end of the path
  int watched = 0;
  int stopped = 0;  ///< by the window that found the run
  int resumed = 0;
  int refused = 0;  ///< with the reason, because the place on the path is not known for certain
};

}  // namespace

class TestWindowKills : public QObject {
  Q_OBJECT

  static constexpr std::array kSignals{SIGKILL, SIGHUP, SIGTERM};
  enum class Resumed { Runs, AtTheEnd, Refused, Failed };

  tests::KillScene m_scene{QStringLiteral(RIVULET_MACHINE)};
  base::Random m_random{1};
  Tally m_tally;

  void writeSettings(bool credit) const {
    QSettings store(m_scene.path("config") + QStringLiteral("/Rivulet/Rivulet.conf"),
                    QSettings::IniFormat);
    store.setValue(QStringLiteral("language"), QStringLiteral("en"));
    store.setValue(QStringLiteral("stream/method"),
                   credit ? QStringLiteral("credit") : QStringLiteral("window"));
    store.setValue(QStringLiteral("stream/job"), QStringLiteral("motion"));
    store.setValue(QStringLiteral("stream/points"), 4);
    store.setValue(QStringLiteral("stream/feed"), QStringLiteral("fixed"));
    store.setValue(QStringLiteral("stream/feedMmPerMin"), 1500.0);
  }

  [[nodiscard]] std::unique_ptr<Window> openWindow(bool isNew) const {
    return std::make_unique<Window>(m_scene.environment(), m_scene.endpoint(),
                                    isNew ? m_scene.programFile() : QString());
  }
  static bool start(Window& window) {
    return window.ask("press start") == "pressed" && window.ask("hold start") == "held" &&
           window.awaitState({"Running", "Done"});
  }

  /// What a window does with the run that it has found, up to its resumption. Watch and Stop are
  /// there for a run on the control only. @param button  that offers to resume it
  Resumed resume(Window& window, const QByteArray& button, bool isOnControl) {
    if (isOnControl && m_random.uniform() < 0.5) {
      ++m_tally.watched;
      if (window.ask("press found-watch") != "pressed" || !window.awaitState({"Watching"})) {
        return Resumed::Failed;
      }
    }
    if (isOnControl && m_random.uniform() < 0.5) {
      ++m_tally.stopped;
      // Not even the windows that were delivered are waited for.
      QByteArray answer = window.ask("press found-stop") == "pressed"
                              ? window.ask("await found-end found-dismiss")
                              : QByteArray();
      if (answer == "found-end" && m_random.uniform() < 0.5) {
        answer = window.ask("press found-end") == "pressed" ? window.ask("await found-dismiss")
                                                            : QByteArray();
      }
      if (answer.isEmpty() || (answer == "found-dismiss" && !m_scene.isReset())) {
        return Resumed::Failed;
      }
    }
    m_scene.awaitStandstill();
    if (window.ask("press " + button) != "pressed") {
      return Resumed::Failed;
    }
    QByteArray answer = window.ask("await go-on not-now");
    if (answer == "not-now") {
      answer = window.ask("read resume-bar");
      qInfo("refused: %s", answer.constData());
      if (answer.contains("Only the rest of the last window is left")) {
        const bool isEnded = window.ask("press not-now") == "pressed" &&
                             (window.ask("await found-end found-stop") == "found-end" ||
                              (window.ask("press found-stop") == "pressed" &&
                               window.ask("await found-end found-dismiss") == "found-end")) &&
                             window.ask("press found-end") == "pressed" &&
                             window.ask("await found-dismiss") == "found-dismiss";
        return isEnded ? Resumed::AtTheEnd : Resumed::Failed;
      }
      return answer.contains("Every point has been executed already") ? Resumed::AtTheEnd
                                                                      : Resumed::Refused;
    }
    ++m_tally.resumed;
    return window.ask("hold go-on") == "held" && window.awaitState({"Running", "Done"})
               ? Resumed::Runs
               : Resumed::Failed;
  }

  /// The machine loses its power. Either this window goes on when it is back, or a new one.
  /// @return the button that offers to resume the run; empty: there is none
  QByteArray switchOffAndOn(std::unique_ptr<Window>& window) {
    ++m_tally.machineKills;
    m_scene.switchOff();
    const bool hasEnded = window->awaitState({"Failed", "Done"});
    m_scene.switchOn();
    if (!hasEnded || window->isIn("Done")) {
      return {};
    }
    if (m_random.uniform() < 0.5) {
      ++m_tally.reconnected;
      if (window->ask("await connect machine") == "machine") {
        window->ask("press machine");  // it hides the panel where there is little room
      }
      return window->ask("press connect") == "pressed" ? "resume" : QByteArray();
    }
    window->signal(SIGTERM);
    if (window->exit() != 0) {
      return {};
    }
    window = openWindow(false);
    return "found-resume";
  }

  /// The window is ended. @return false if something was wrong
  bool killWindow(std::unique_ptr<Window>& window) {
    const auto kind = static_cast<std::size_t>(m_random.uniform() * 3.0);
    ++m_tally.bySignal[kind];
    window->signal(kSignals[kind]);
    const int code = window->exit();
    if (kSignals[kind] != SIGKILL && (code != 0 || !m_scene.isHeldOrReset())) {
      qWarning("exit %d after signal %d, the axes are not held", code, kSignals[kind]);
      return false;
    }
    return true;
  }

  /// One run to the end of the path, killed on the way. @return false if something was wrong
  bool run(bool credit, int killsMax) {
    const std::size_t before = m_scene.executed().size();
    writeSettings(credit);
    std::unique_ptr<Window> window = openWindow(true);
    if (!start(*window)) {
      return false;
    }
    bool wasSwitchedOff = false;
    for (int kills = 0; kills < killsMax; ++kills) {
      if (!window->works(static_cast<int>(m_random.uniform() * kStreamMs))) {
        break;
      }
      ++m_tally.kills;
      QByteArray button("found-resume");
      if (m_random.uniform() < 0.15) {
        wasSwitchedOff = true;
        button = switchOffAndOn(window);
        if (button.isEmpty()) {
          break;  // at its end, or shown by the judge
        }
      } else {
        if (!killWindow(window)) {
          return false;
        }
        if (m_scene.savedRuns().isEmpty()) {
          break;  // it was at its end
        }
        window = openWindow(false);
      }
      const Resumed resumed = resume(*window, button, !m_scene.isReset());
      if (resumed == Resumed::Refused && wasSwitchedOff) {
        // A loss of power on a rounded corner leaves the tool beside the path, for example.
        ++m_tally.refused;
        m_scene.forgetRuns();
        return true;
      }
      if (resumed == Resumed::Refused || resumed == Resumed::Failed) {
        return false;
      }
      if (resumed == Resumed::AtTheEnd) {
        m_scene.forgetRuns();
        window->signal(SIGTERM);
        window->exit();
        break;
      }
    }
    if (window->isOpen() && !m_scene.savedRuns().isEmpty() && !window->awaitState({"Done"})) {
      return false;
    }
    ++m_tally.runs;
    m_scene.awaitStandstill();
    return m_scene.isWhole(before);
  }

 private Q_SLOTS:
  void initTestCase() {
    m_scene.switchOn();
    QProcess test;  // of method credit
    test.setProcessEnvironment(m_scene.environment());
    test.start(QStringLiteral(RIVULET_CLI), {QStringLiteral("commission"), QStringLiteral("--json"),
                                             QStringLiteral("--endpoint"), m_scene.endpoint()});
    QVERIFY(test.waitForFinished(kRunMs) && test.exitCode() == 0);
  }
  void cleanupTestCase() { m_scene.switchOff(); }

  /// What ends the window holds its run first, waits until the axes stand, and leaves a run that
  /// can be resumed.
  void endSignalsStopTheRunFirst_data() {
    QTest::addColumn<int>("number");
    QTest::newRow("SIGHUP") << SIGHUP;
    QTest::newRow("SIGTERM") << SIGTERM;
    QTest::newRow("SIGINT") << SIGINT;
  }
  void endSignalsStopTheRunFirst() {
    QFETCH(int, number);
    const std::size_t before = m_scene.executed().size();
    writeSettings(false);
    Window window(m_scene.environment(), m_scene.endpoint(), m_scene.programFile());
    QVERIFY(start(window));
    // Before that nothing can move, and there would be nothing to resume.
    QTRY_VERIFY_WITH_TIMEOUT(m_scene.isGranted(), kRunMs);
    window.signal(number);
    QCOMPARE(window.exit(), 0);
    QVERIFY(m_scene.isHeldOrReset());
    const std::size_t executed = m_scene.executed(before).size();
    QThread::msleep(kStaysMs);
    QVERIFY(m_scene.isHeldOrReset());
    QCOMPARE(m_scene.executed(before).size(), executed);
    QCOMPARE(m_scene.savedRuns().size(), 1);
    QVERIFY(m_scene.isGranted());
    const auto program = gcode::loadProgram(m_scene.programFile().toStdString());
    const auto points = gcode::streamPoints(program->trajectory, {}).points;
    QVERIFY(m_scene.executed(before).size() < points.size());
    m_scene.forgetRuns();
  }

  /// RIVULET_KILLS kills from the seed RIVULET_FIRST on.
  void everyPointOnceWhateverIsKilled() {
    const int kills = tests::setting("RIVULET_KILLS", 3);
    const auto seed = static_cast<std::uint64_t>(tests::setting("RIVULET_FIRST", 2));
    m_random = base::Random(seed);
    for (int number = 0; m_tally.kills < kills; ++number) {
      const int most =
          std::min(kills - m_tally.kills, 1 + static_cast<int>(m_random.uniform() * 4.0));
      QVERIFY2(run(number % 2 == 1, most),
               qPrintable(QStringLiteral("seed %1, run %2").arg(seed).arg(number)));
    }
    qInfo(
        "%d kills: %d by KILL, %d by HUP, %d by TERM, %d losses of power (%d windows went on); "
        "%d runs to the end, %d watched, %d stopped, %d resumed; %d refused after a loss of power",
        m_tally.kills, m_tally.bySignal[0], m_tally.bySignal[1], m_tally.bySignal[2],
        m_tally.machineKills, m_tally.reconnected, m_tally.runs, m_tally.watched, m_tally.stopped,
        m_tally.resumed, m_tally.refused);
  }
};

RIVULET_TEST(TestWindowKills)
#include "tst_window_kills.moc"
