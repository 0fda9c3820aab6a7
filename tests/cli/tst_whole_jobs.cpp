// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Whole jobs by the programs themselves: rivulet-cli in virtual time, and against a live
/// rivulet-machine over OPC UA, in real time.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QDir>
#include <QElapsedTimer>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <atomic>
#include <nlohmann/json.hpp>
#include <thread>

#include "report/run_history.h"
#include "support/kill_scene.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;
using nlohmann::json;

namespace {

using rivulet::tests::kRunMs;

const char* const kPart =
    "N10 G17 G90 G71\n"
    "T1 D1 M6\n"
    "S3000 M3\n"
    "G0 X5 Y5 Z2\n"
    "G1 Z-1 F2000\n"
    "X10\n"
    "Y10\n"
    "SUPA G0 Z20\n"
    "T2 M6\n"
    "G0 X1 Y1 Z17\n"
    "G91 G0 Z-3 M8\n"
    "G90 G1 X3 Y3 F1000\n"
    "M5 M9\n"
    "M30\n";

}  // namespace

class TestWholeJobs : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  [[nodiscard]] QString part(const char* text = kPart) const {
    QFile file(m_folder.filePath(QStringLiteral("part.mpf")));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) < 0) {
      qFatal("the test's folder cannot be written");
    }
    return file.fileName();
  }

  struct Outcome {
    int exit = -1;
    QByteArray output;
    QByteArray errors;
  };
  static Outcome run(const QStringList& arguments, const QProcessEnvironment& environment = {}) {
    return runCli(QStringList{QStringLiteral("job")} + arguments, environment);
  }
  static Outcome runCli(const QStringList& arguments, const QProcessEnvironment& environment = {}) {
    QProcess process;
    if (!environment.isEmpty()) {
      process.setProcessEnvironment(environment);
    }
    process.start(QStringLiteral(RIVULET_CLI), arguments);
    if (!process.waitForFinished(kRunMs)) {
      process.kill();
      process.waitForFinished(kRunMs);
    }
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
  }

  /// Where the machine's last block ended; 0: none.
  static double lastX(const tests::KillScene& scene) {
    const auto blocks = scene.executed();
    return blocks.empty() ? 0.0 : blocks.back().targetMm.x;
  }
  /// Moves of the part that were made, each of them to the next whole millimetre in X; -1: one was
  /// left out, made twice, or foreign. The approach to the place where the job was left is no move.
  static int movesMade(const tests::KillScene& scene) {
    constexpr double kStandsMm = 0.01;
    int moves = 0;
    double xMm = 0.0;
    for (const trace::ExecutedBlock& block : scene.executed()) {
      const bool isApproach = std::abs(block.targetMm.x - xMm) <= kStandsMm;
      xMm = block.targetMm.x;
      if (isApproach) {
        continue;
      }
      ++moves;
      if (block.targetMm.x != moves) {
        return -1;
      }
    }
    return moves;
  }

 private Q_SLOTS:
  void writesItsFiles() {
    const QString folder = m_folder.filePath(QStringLiteral("out"));
    const Outcome outcome = run({part(), QStringLiteral("-o"), folder});
    QCOMPARE(outcome.exit, 0);
    const QStringList files = QDir(folder).entryList(QDir::Files, QDir::Name);
    QCOMPARE(files.size(), 4);
    QVERIFY2(files.join(QLatin1Char(' ')).contains(QStringLiteral("README.txt")),
             qPrintable(files.join(QLatin1Char(' '))));
    QFile readMe(folder + QStringLiteral("/README.txt"));
    QVERIFY(readMe.open(QIODevice::ReadOnly));
    const QByteArray text = readMe.readAll();
    QVERIFY(text.contains("retract             SUPA G0 Z20"));
    for (const QString& name : files) {
      QVERIFY(name == QStringLiteral("README.txt") || name == QStringLiteral("job.json") ||
              text.contains(name.toUtf8()));
    }
  }

  /// `stream` runs all of a program, unless the motion alone is asked for or there is nothing else.
  void streamRunsWholeJobs() {
    const QString program = part("T1 M6\nS1000 M3\nG0 X0 Y0 Z45\nG1 Z40 F1000\nX5\nM5\nX9\nM30\n");
    const auto stream = [](const QStringList& arguments) {
      return runCli(QStringList{QStringLiteral("stream")} + arguments +
                    QStringList{QStringLiteral("--simulate"), QStringLiteral("--json")});
    };
    const QString recording = m_folder.filePath(QStringLiteral("whole.rivulet"));
    const Outcome whole = stream({program, QStringLiteral("--record"), recording});
    QVERIFY2(whole.exit == 0, whole.errors.constData());
    const json job = json::parse(whole.output.toStdString());
    QCOMPARE(job["outcome"].get<std::string>(), std::string("completed"));
    QVERIFY(job["job"].get<int>() > 0);
    QVERIFY(job["recording_complete"].get<bool>());
    const Outcome analysed =
        runCli({QStringLiteral("analyse"), recording, QStringLiteral("--json")});
    QVERIFY2(analysed.exit == 0, analysed.errors.constData());
    const json judged = json::parse(analysed.output.toStdString());
    QVERIFY(judged["faultless"].get<bool>());

    const Outcome motion = stream({program, QStringLiteral("--motion-only")});
    QVERIFY2(motion.exit == 0, motion.errors.constData());
    const json moved = json::parse(motion.output.toStdString());
    QVERIFY(!moved.contains("job"));
    QVERIFY(moved["executed"].get<int>() >= 4);
    QVERIFY(!motion.errors.contains("Only the motion"));
    // An option that the motion alone has says so by itself.
    const Outcome thinned =
        stream({program, QStringLiteral("--tolerance"), QStringLiteral("0.001")});
    QVERIFY2(thinned.exit == 0, thinned.errors.constData());
    QVERIFY(!json::parse(thinned.output.toStdString()).contains("job"));
    QVERIFY2(thinned.errors.contains("Only the motion is streamed: --tolerance"),
             thinned.errors.constData());
    const Outcome plain = stream({part("G0 X0 Y0 Z45\nG1 X5 F1000\nX9\nM30\n")});
    QVERIFY2(plain.exit == 0, plain.errors.constData());
    QVERIFY(!json::parse(plain.output.toStdString()).contains("job"));
  }

  /// What cannot be a job is refused, and the way to stream its motion is named.
  void streamNamesTheMotionOnly() {
    QFile file(m_folder.filePath(QStringLiteral("other.tap")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("G21\nT2 M6\nG43 H5\nG0 X0 Y0 Z45\nG1 X5 F1000\nM30\n");
    file.close();
    // A virtual machine that is set up for the program has the length; one with tools of its own
    // does not say so. The motion alone needs none.
    for (const char* const command : {"stream", "job"}) {
      const Outcome simulated =
          runCli({QLatin1String(command), file.fileName(), QStringLiteral("--simulate")});
      QVERIFY2(simulated.exit == 0, simulated.errors.constData());
    }
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE));
    const QStringList arguments{QStringLiteral("stream"), file.fileName(),
                                QStringLiteral("--endpoint"), machine.endpoint()};
    const Outcome refused = runCli(arguments);
    QCOMPARE(refused.exit, 2);
    QVERIFY2(refused.errors.contains("H5") && refused.errors.contains("--motion-only"),
             refused.errors.constData());
    const Outcome motion = runCli(arguments + QStringList{QStringLiteral("--motion-only")});
    QVERIFY2(motion.exit == 0, motion.errors.constData());
  }

  /// A motion without its blocks is compared with the machine, too: it does not end in an alarm
  /// with the tool in the cut.
  void streamRefusesWhatLeavesTheTravel() {
    tests::KillScene scene(QStringLiteral(RIVULET_MACHINE), QStringLiteral("dmu75-mill"));
    scene.switchOn();
    const QByteArray inside("G0 X0 Y0 Z45\nG1 X5 F1000\nX9\n");
    const auto stream = [&](const QByteArray& text) {
      return runCli({QStringLiteral("stream"), part(text.constData()), QStringLiteral("--endpoint"),
                     scene.endpoint(), QStringLiteral("--motion-only")},
                    scene.environment());
    };
    const Outcome refused = stream(inside + "X5000\n");
    QCOMPARE(refused.exit, 2);
    QVERIFY2(refused.errors.contains("Line 4") && refused.errors.contains("beyond its limit"),
             refused.errors.constData());
    QVERIFY(scene.executed().empty());
    const Outcome done = stream(inside);
    QVERIFY2(done.exit == 0 && !done.errors.contains("not checked"), done.errors.constData());
    // Simulations and live runs as well.
    const Outcome simulated =
        runCli({QStringLiteral("stream"), part((inside + "X5000\n").constData()),
                QStringLiteral("--simulate"), QStringLiteral("--motion-only")});
    QCOMPARE(simulated.exit, 2);
    const Outcome live =
        runCli({QStringLiteral("stream"), QStringLiteral("--live"), QStringLiteral("-"),
                QStringLiteral("--box"), QStringLiteral("0"), QStringLiteral("5000"),
                QStringLiteral("0"), QStringLiteral("1"), QStringLiteral("0"), QStringLiteral("1"),
                QStringLiteral("--endpoint"), scene.endpoint()},
               scene.environment());
    QVERIFY2(live.exit == 2 && live.errors.contains("beyond its limit"), live.errors.constData());
  }

  /// Programs of old computers have letters that are no UTF-8. They go to the control in their
  /// bytes.
  void writesLettersOfOtherEncodings() {
    const QString folder = m_folder.filePath(QStringLiteral("latin"));
    const Outcome outcome = run({part("G0 X0 Y0 Z2\nMSG(\"L\xE4ngs\")\nG1 X5 F1000\nM30\n"),
                                 QStringLiteral("-o"), folder, QStringLiteral("--json")});
    QVERIFY2(outcome.exit == 0, outcome.errors.constData());
    const QStringList mains = QDir(folder).entryList({QStringLiteral("RIVJOB_*.MPF")}, QDir::Files);
    QCOMPARE(mains.size(), 1);
    QFile main(folder + QLatin1Char('/') + mains.front());
    QVERIFY(main.open(QIODevice::ReadOnly));
    QVERIFY(main.readAll().contains("MSG(\"L\xE4ngs\")"));
  }

  /// What would need more memory than a computer has is refused, with the option.
  void refusesTooManyPoints() {
    const Outcome outcome = runCli({QStringLiteral("points"), part("G0 X0 Y0 Z2\nG1 X100 F1000\n"),
                                    QStringLiteral("--split"), QStringLiteral("0.000001")});
    QCOMPARE(outcome.exit, 2);
    QVERIFY2(outcome.errors.contains("--split"), outcome.errors.constData());
  }

  /// A server that closes each connection at once is asked three times a second at most.
  void aServerThatClosesAtOnce() {
    const int listening = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const place = reinterpret_cast<sockaddr*>(&address);
    QVERIFY(bind(listening, place, size) == 0 && listen(listening, 128) == 0);
    QVERIFY(getsockname(listening, place, &size) == 0);
    std::atomic<int> connections = 0;
    std::thread server([&] {
      for (int one = accept(listening, nullptr, nullptr); one >= 0;
           one = accept(listening, nullptr, nullptr)) {
        ++connections;
        close(one);
      }
    });
    QElapsedTimer time;
    time.start();
    QProcess client;
    client.start(QStringLiteral(RIVULET_CLI),
                 {QStringLiteral("runs"), QStringLiteral("--endpoint"),
                  QStringLiteral("opc.tcp://127.0.0.1:%1").arg(ntohs(address.sin_port))});
    const bool hasEnded = client.waitForFinished(kRunMs);
    shutdown(listening, SHUT_RDWR);
    server.join();
    close(listening);
    QVERIFY(hasEnded);
    const qint64 seconds = 1 + time.elapsed() / 1000;
    QCOMPARE(client.exitCode(), 3);
    QVERIFY2(
        connections >= 1 && connections <= 3 * seconds,
        qPrintable(QStringLiteral("%1 connections in %2 s").arg(connections.load()).arg(seconds)));
  }

  void refusesWhatIsNoJob() {
    const Outcome outcome =
        run({part("G0 X1\nG999\n"), QStringLiteral("--simulate"), QStringLiteral("--json")});
    QCOMPARE(outcome.exit, 2);
    QVERIFY(outcome.output.contains("G999"));
  }

  /// What is beyond the machine is said before anything moves.
  void refusesWhatTheMachineCannot() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE),
                                        {QStringLiteral("--preset"), QStringLiteral("dmu75-mill")});
    const Outcome outcome = run({part("T99 M6\nG0 X500\nM30\n"), QStringLiteral("--endpoint"),
                                 machine.endpoint(), QStringLiteral("--json")});
    QCOMPARE(outcome.exit, 2);
    const json result = json::parse(outcome.output.toStdString());
    QCOMPARE(result["hazards"].size(), std::size_t{2});
    QCOMPARE(result["hazards"][0]["line"].get<int>(), 1);
    QCOMPARE(result["hazards"][1]["axis"].get<std::string>(), std::string("X"));
    QCOMPARE(result["hazards"][1]["target"].get<double>(), 500.0);
    QVERIFY(result["error"]["message"].get<std::string>().find("tool T99") != std::string::npos);
  }

  /// A machine that is named is taken as it is; else it is as large as the job needs, and says so.
  void largeMachine() {
    const QStringList job{part("G54\nG0 X0 Y0 Z10\nX2000\nM30\n"), QStringLiteral("--simulate"),
                          QStringLiteral("--json")};
    const Outcome fits = run(job);
    QVERIFY2(fits.exit == 0, fits.output.constData());
    QVERIFY(fits.output.contains("more travel than the machine has: X goes"));
    const Outcome named =
        run(job + QStringList{QStringLiteral("--preset"), QStringLiteral("dmu75-mill")});
    QCOMPARE(named.exit, 2);
    QVERIFY(named.output.contains("beyond its limit"));
  }

  /// Higher, and only where that is safe.
  void runsDry() {
    const QString file =
        part("G17 G90 G71\nT1 D1 M6\nS3000 M3\nG0 X5 Y5 Z2\nG1 Z-1 F2000\nX10\nM5\nM30\n");
    const Outcome outcome = run({file, QStringLiteral("--simulate"), QStringLiteral("--json"),
                                 QStringLiteral("--dry-run"), QStringLiteral("30")});
    QVERIFY2(outcome.exit == 0, outcome.output.constData());
    const json result = json::parse(outcome.output.toStdString());
    QCOMPARE(result["dry_run_mm"].get<double>(), 30.0);
    QCOMPARE(result["outcome"].get<std::string>(), std::string("completed"));
    // An increment of Z after a tool.
    const Outcome refused = run(
        {part(), QStringLiteral("--simulate"), QStringLiteral("--dry-run"), QStringLiteral("30")});
    QCOMPARE(refused.exit, 2);
    QVERIFY2(refused.errors.contains("part.mpf:11"), refused.errors.constData());
  }

  void inVirtualTime() {
    const Outcome outcome = run({part(), QStringLiteral("--simulate"), QStringLiteral("--json")});
    QVERIFY2(outcome.exit == 0, outcome.output.constData());
    const json result = json::parse(outcome.output.toStdString());
    QCOMPARE(result["outcome"].get<std::string>(), std::string("completed"));
    QCOMPARE(result["runs"].size(), std::size_t{3});
    QCOMPARE(result["executed_points"].get<int>(), 6);
    QCOMPARE(result["reached"]["stretch"].get<int>(), 3);
    QVERIFY(result["times"]["streamed_s"].get<double>() > 0.0);
    QVERIFY(result["estimated"]["total_s"].get<double>() > 0.0);
  }

  /// The control has no more to do when the client is done: it is in reset, and can be started
  /// again.
  void overOpcUa() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE));
    QVERIFY(!machine.endpoint().isEmpty());
    const report::RunHistory history;
    const std::size_t before = history.list().runs.size();
    for (int round = 0; round < 2; ++round) {
      const Outcome outcome =
          run({part(), QStringLiteral("--endpoint"), machine.endpoint(), QStringLiteral("--json")});
      QVERIFY2(outcome.exit == 0, (outcome.output + outcome.errors).constData());
      const json result = json::parse(outcome.output.toStdString());
      QCOMPARE(result["outcome"].get<std::string>(), std::string("completed"));
      QCOMPARE(result["executed_points"].get<int>(), 6);
      QCOMPARE(result["runs"][1]["start_mm"].size(), std::size_t{3});
    }
    // Each of them is in the history, as if the window had run it.
    const auto runs = history.list().runs;
    QCOMPARE(runs.size(), before + 2);
    QCOMPARE(runs.front().programName, std::string("part.mpf"));
    QCOMPARE(runs.front().total, std::size_t{6});
    QVERIFY(runs.front().outcome == streaming::Outcome::Completed);
    QVERIFY(runs.front().jobTimes && runs.front().ownsRecording);
    QVERIFY(!runs.front().recording.empty());
  }

  /// A client that is killed in a stretch: the next one finds where the job was left, says what is
  /// done first, and goes on only when that is confirmed. Each motion is made once.
  void killedAndResumed() {
    constexpr int kMoves = 30;
    tests::KillScene scene(QStringLiteral(RIVULET_MACHINE), QStringLiteral("dmu75-mill"),
                           tests::KillScene::Kept::Jobs);
    scene.switchOn();
    QByteArray text("G54\nT1 D1 M6\nS3000 M3\nG0 X0 Y0 Z20\n");
    for (int i = 1; i <= kMoves; ++i) {
      text += "G1 X" + QByteArray::number(i) + " Y" + QByteArray::number(i % 2) + " F600\n";
    }
    const QStringList arguments{part((text + "M8\nG0 Z30\nM30\n").constData()),
                                QStringLiteral("--endpoint"), scene.endpoint(),
                                QStringLiteral("--json")};
    QProcess killed;
    killed.setProcessEnvironment(scene.environment());
    killed.start(QStringLiteral(RIVULET_CLI), QStringList{QStringLiteral("job")} + arguments);
    QTRY_VERIFY_WITH_TIMEOUT(scene.isGranted() && lastX(scene) >= 5.0, kRunMs);
    killed.kill();
    killed.waitForFinished();
    QCOMPARE(scene.savedRuns().size(), 1);
    scene.awaitStandstill();
    QVERIFY(lastX(scene) < kMoves);

    const QStringList resume =
        arguments + QStringList{QStringLiteral("--resume"), scene.savedRuns().front()};
    const Outcome asked = run(resume, scene.environment());
    QCOMPARE(asked.exit, 2);
    QVERIFY2(asked.output.contains("--yes"), asked.output.constData());
    const Outcome done = run(resume + QStringList{QStringLiteral("--yes")}, scene.environment());
    QVERIFY2(done.exit == 0, (done.output + done.errors).constData());
    const json result = json::parse(done.output.toStdString());
    QCOMPARE(result["outcome"].get<std::string>(), std::string("completed"));
    QCOMPARE(result["restart"][0].get<std::string>(), std::string("G54"));
    QCOMPARE(movesMade(scene), kMoves);
  }

  /// A client that is killed while the first tool is changed, then while the job goes on, and once
  /// more: the same command goes on with it each time, and no other begins it anew unasked.
  void killedBeforeTheFirstStretchAndAgain() {
    constexpr int kMoves = 60;
    tests::KillScene scene(QStringLiteral(RIVULET_MACHINE), QStringLiteral("dmu75-mill"),
                           tests::KillScene::Kept::Jobs);
    scene.switchOn();
    QByteArray text("G54\nT1 D1 M6\nS3000 M3\nM8\nG4 F12\nG0 X0 Y0 Z20\n");
    for (int i = 1; i <= kMoves; ++i) {
      text += "G1 X" + QByteArray::number(i) + " Y" + QByteArray::number(i % 2) + " F1200\n";
    }
    const QString file = part((text + "G0 Z30\nM5 M9\nM30\n").constData());
    const QStringList job{QStringLiteral("job"), file, QStringLiteral("--endpoint"),
                          scene.endpoint()};
    const auto startAndKill = [&](const QStringList& arguments, const auto& when) {
      QProcess killed;
      killed.setProcessEnvironment(scene.environment());
      killed.start(QStringLiteral(RIVULET_CLI), arguments);
      QByteArray said;
      const bool came = QTest::qWaitFor(
          [&] {
            said += killed.readAllStandardOutput();
            return when(said) || killed.state() == QProcess::NotRunning;
          },
          kRunMs);
      const bool ran = came && killed.state() == QProcess::Running;
      killed.kill();
      killed.waitForFinished();
      if (!ran) {
        qWarning() << said << killed.readAllStandardError();
      }
      return ran;
    };
    QVERIFY(startAndKill(job, [](const QByteArray& said) { return said.contains("line 2: T1"); }));
    QCOMPARE(scene.savedRuns().size(), 1);
    const QString kept = scene.savedRuns().front();
    const QStringList runs{QStringLiteral("runs"), QStringLiteral("--endpoint"), scene.endpoint()};
    const Outcome seen = runCli(runs, scene.environment());
    QVERIFY2(seen.output.contains("The control executes the whole job") &&
                 seen.output.contains("whole job "),
             seen.output.constData());
    // Neither while the control goes on with its blocks nor afterwards.
    const Outcome anew = runCli(job, scene.environment());
    QCOMPARE(anew.exit, 2);
    QVERIFY2(anew.errors.contains("--stop"), anew.errors.constData());
    const auto isNative = [&] {
      const Outcome found =
          runCli(runs + QStringList{QStringLiteral("--json")}, scene.environment());
      const json control = json::parse(found.output.toStdString())["on_control"];
      return !control.is_null() && control["is_native"].get<bool>();
    };
    const QStringList resume = job + QStringList{QStringLiteral("--resume"), kept};
    const Outcome busy = runCli(resume + QStringList{QStringLiteral("--yes")}, scene.environment());
    QVERIFY2(busy.exit == 2 && busy.errors.contains("runs --end"), busy.errors.constData());
    // The axes stand before their first move, and the program does not come to its stretch.
    QVERIFY(isNative() && scene.executed().empty());
    const QStringList stop = runs + QStringList{QStringLiteral("--stop")};
    const QStringList end = runs + QStringList{QStringLiteral("--end")};
    QCOMPARE(runCli(stop, scene.environment()).exit, 0);
    static_cast<void>(runCli(end, scene.environment()));  // a dwell comes to its end by itself
    QVERIFY(scene.isReset() && scene.executed().empty());

    const QStringList confirmed = resume + QStringList{QStringLiteral("--yes")};
    QVERIFY(startAndKill(confirmed, [&](const QByteArray&) { return lastX(scene) >= 5.0; }));
    QCOMPARE(scene.savedRuns(), QStringList{kept});
    scene.awaitStandstill();
    // In the approach. The tool is in the spindle: its line takes no time.
    QVERIFY(startAndKill(confirmed, [](const QByteArray& said) {
      return said.contains("the control executes the blocks before stretch 1");
    }));
    QCOMPARE(scene.savedRuns(), QStringList{kept});
    const Outcome stopped = runCli(end, scene.environment());
    QVERIFY2(stopped.exit == 0 && stopped.output.contains("--resume"), stopped.errors.constData());
    const Outcome nothing = runCli(stop, scene.environment());
    QCOMPARE(nothing.exit, 2);
    const Outcome refused = runCli(job, scene.environment());
    QCOMPARE(refused.exit, 2);
    QVERIFY2(refused.errors.contains("--from-start") && refused.errors.contains(kept.toUtf8()),
             refused.errors.constData());
    const Outcome done =
        runCli(confirmed + QStringList{QStringLiteral("--json")}, scene.environment());
    QVERIFY2(done.exit == 0, (done.output + done.errors).constData());
    QCOMPARE(movesMade(scene), kMoves);
    QVERIFY(scene.savedRuns().isEmpty());
  }

  /// Somebody else finds a job whose client was killed, wherever it is, and ends it.
  void foundAndStopped_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("isNative");
    QByteArray stretch("G54\nT1 D1 M6\nS3000 M3\nG0 X0 Y0 Z20\n");
    for (int i = 1; i <= 60; ++i) {
      stretch += "G1 X" + QByteArray::number(i) + " F600\n";
    }
    QTest::newRow("in a stretch") << stretch + "M8\nG0 Z30\nM30\n" << false;
    QTest::newRow("in a block of the control")
        << QByteArray(
               "G54\nG0 X0 Y0 Z50\nX5\nT1 D1 M6\nS3000 M3\nG4 F8\nM8\n"
               "G0 X9\nM30\n")
        << true;
  }

  void foundAndStopped() {
    QFETCH(QByteArray, text);
    QFETCH(bool, isNative);
    tests::KillScene scene(QStringLiteral(RIVULET_MACHINE), QStringLiteral("dmu75-mill"),
                           tests::KillScene::Kept::Jobs);
    scene.switchOn();
    QProcess killed;
    killed.setProcessEnvironment(scene.environment());
    killed.start(QStringLiteral(RIVULET_CLI), {QStringLiteral("job"), part(text.constData()),
                                               QStringLiteral("--endpoint"), scene.endpoint()});
    QByteArray said;
    QTRY_VERIFY_WITH_TIMEOUT(isNative
                                 ? (said += killed.readAllStandardOutput()).contains("line 4: T1")
                                 : scene.isGranted() && lastX(scene) >= 5.0,
                             kRunMs);
    killed.kill();
    killed.waitForFinished();
    // On another computer: nothing of the job is kept there.
    QProcessEnvironment elsewhere = scene.environment();
    elsewhere.insert(QStringLiteral("XDG_STATE_HOME"), m_folder.filePath(QStringLiteral("other")));
    const QStringList runs{QStringLiteral("runs"), QStringLiteral("--endpoint"), scene.endpoint(),
                           QStringLiteral("--json")};
    const Outcome seen = runCli(runs, elsewhere);
    QVERIFY2(seen.exit == 0, seen.errors.constData());
    const json found = json::parse(seen.output.toStdString())["on_control"];
    QVERIFY2(!found.is_null(), seen.output.constData());
    QVERIFY(found["job"].get<int>() > 0);
    QCOMPARE(found["stretch"].get<int>(), 1);
    QCOMPARE(found["is_native"].get<bool>(), isNative);
    QVERIFY(!found["has_client"].get<bool>());
    QVERIFY(!found["can_resume"].get<bool>());
    QVERIFY(!found["started_by"]["user"].get<std::string>().empty());
    const Outcome stopped = runCli(runs + QStringList{QStringLiteral("--stop")}, elsewhere);
    QVERIFY2(stopped.exit == 0, (stopped.output + stopped.errors).constData());
    QVERIFY(isNative || !scene.isReset());  // a dwell comes to its end by itself
    const Outcome ended = runCli(runs + QStringList{QStringLiteral("--end")}, elsewhere);
    QVERIFY2(isNative || ended.exit == 0, (ended.output + ended.errors).constData());
    QVERIFY(scene.isReset());
    QVERIFY(lastX(scene) < (isNative ? 9.0 : 60.0));
  }

  /// The machine loses its power while it changes the tool: the client says how to go on, and the
  /// tool is changed again before the rest of the job.
  void powerLossInAToolChange() {
    tests::KillScene scene(QStringLiteral(RIVULET_MACHINE), QStringLiteral("dmu75-mill"),
                           tests::KillScene::Kept::Jobs);
    scene.switchOn();
    const QStringList arguments{
        part("G54\nG0 X0 Y0 Z50\nX5\nT1 M6\nD1\nS3000 M3\nG0 X1 Y1\nZ20\nG1 X20 F3000\nM30\n"),
        QStringLiteral("--endpoint"), scene.endpoint()};
    QProcess job;
    job.setProcessEnvironment(scene.environment());
    job.start(QStringLiteral(RIVULET_CLI), QStringList{QStringLiteral("job")} + arguments);
    // The change takes 5 s, the other blocks up to the stretch nothing.
    QByteArray said;
    QTRY_VERIFY_WITH_TIMEOUT((said += job.readAllStandardOutput()).contains("line 4: T1 M6"),
                             kRunMs);
    scene.switchOff();
    QVERIFY(job.waitForFinished(kRunMs));
    QCOMPARE(job.exitCode(), 3);
    const QByteArray errors = job.readAllStandardError();
    QVERIFY2(errors.contains("--resume"), errors.constData());
    QCOMPARE(scene.savedRuns().size(), 1);

    scene.switchOn();
    const Outcome done =
        run(arguments + QStringList{QStringLiteral("--resume"), scene.savedRuns().front(),
                                    QStringLiteral("--yes"), QStringLiteral("--json")},
            scene.environment());
    QVERIFY2(done.exit == 0, (done.output + done.errors).constData());
    const json result = json::parse(done.output.toStdString());
    QCOMPARE(result["runs"].size(), std::size_t{1});
    QCOMPARE(result["runs"][0]["stretch"].get<int>(), 2);
    const auto blocks = scene.executed();
    QVERIFY(blocks.size() >= 5);
    QCOMPARE(blocks[1].targetMm.x, 5.0);
    QCOMPARE(blocks[blocks.size() - 2].targetMm.z, 20.0);
    QCOMPARE(blocks.back().targetMm.x, 20.0);
    QVERIFY2(result["times"]["tool_change_s"].get<double>() >= 5.0, done.output.constData());
  }
};

RIVULET_TEST(TestWholeJobs)
#include "tst_whole_jobs.moc"
