// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The pipeline in real time: as threads and as processes it moves the axes as the planner in one
// loop does, to the bit; a task that is killed is named, and nothing is skipped or sent twice.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <bit>
#include <csignal>
#include <thread>

#include "base/file.h"
#include "base/random.h"
#include "cnc/cnc_run.h"
#include "cnc/event_file.h"
#include "cnc/real_time.h"
#include "cnc/segment.h"
#include "cnc/worker.h"
#include "pipeline/conformance.h"
#include "pipeline/reference.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using pipeline::kTaskCount;
using pipeline::PolicyKind;

namespace {

using rivulet::tests::kRunMs;

/// About a third of a second of motion.
constexpr const char* kProgram = R"nc(G90 G64 S1000 M3
G1 X4 Y1 F6000
G2 X6 Y3 I0 J2
G1 X6 Y5
STOPRE
FOR R1=1 TO 5
X=6+R1 Y=5+R1*0.5
ENDFOR
G3 X9 Y6 CR=3
M5
G0 X0 Y0
M30
)nc";

/// Some seconds: kills are drawn within it.
constexpr const char* kLongProgram = R"nc(G90 G64
FOR R1=1 TO 40
G1 X10 Y10 F4000
G2 X10 Y10 I2 J0
G1 X2 Y1
ENDFOR
M30
)nc";

cnc::RunOptions optionsOf(PolicyKind policy, const std::string& program) {
  cnc::RunOptions options;
  options.preset = machine::kDefaultPreset;
  options.program = program;
  options.policy = policy;
  options.dispatch.positionCycle = 1ms;
  options.dispatch.processors = 2;
  return options;
}

tests::Planned plan(const char* text) {
  cnc::Setup setup;
  setup.preset = decltype(setup.preset)(machine::kDefaultPreset);
  setup.cycleNs = 1'000'000;
  return tests::planInProcess(*cnc::machineOf(setup), text);
}

bool sameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Whether these are the first set points of the program. @param isWhole  and all of them
QByteArray difference(const tests::Planned& planned, const trace::ControlTrace& trace,
                      bool isWhole) {
  // The end of the program is one more.
  if (trace.samples.size() > planned.cycles.size() + 1 ||
      (isWhole && trace.samples.size() != planned.cycles.size() + 1)) {
    return QByteArray::number(static_cast<qulonglong>(trace.samples.size())) + " set points";
  }
  for (std::size_t i = 0; i < std::min(trace.samples.size(), planned.cycles.size()); ++i) {
    const trace::ControlSample& sample = trace.samples[i];
    const tests::Planned::Cycle& cycle = planned.cycles[i];
    if (!sameBits(sample.commandMm.x, cycle.mm.x) || !sameBits(sample.commandMm.y, cycle.mm.y) ||
        !sameBits(sample.commandMm.z, cycle.mm.z) || !sameBits(sample.feedMmPerS, cycle.speed) ||
        sample.line != cycle.line) {
      return "set point " + QByteArray::number(static_cast<qulonglong>(i + 1));
    }
  }
  return {};
}

/// rivulet-cnc as a user starts it.
class Program {
 public:
  explicit Program(const QStringList& arguments) {
    m_process.start(QStringLiteral(RIVULET_CNC), arguments);
    if (!m_process.waitForStarted(kRunMs)) {
      qFatal("rivulet-cnc does not start");
    }
  }
  /// Reads what it says until a line begins with a text. @return the rest of that line
  [[nodiscard]] QByteArray said(const QByteArray& begin) {
    while (m_process.canReadLine() || m_process.waitForReadyRead(kRunMs)) {
      while (m_process.canReadLine()) {
        const QByteArray line = m_process.readLine().trimmed();
        if (line.startsWith(begin)) {
          return line.mid(begin.size());
        }
      }
    }
    return {};
  }
  [[nodiscard]] int finished() {
    if (m_process.state() != QProcess::NotRunning && !m_process.waitForFinished(kRunMs)) {
      m_process.kill();
      m_process.waitForFinished();
      return -1;
    }
    return m_process.exitStatus() == QProcess::NormalExit ? m_process.exitCode() : -2;
  }
  [[nodiscard]] bool runsFor(int ms) {
    return m_process.state() == QProcess::Running && !m_process.waitForFinished(ms);
  }
  [[nodiscard]] QByteArray errors() { return m_process.readAllStandardError(); }
  [[nodiscard]] qint64 id() const { return m_process.processId(); }

 private:
  QProcess m_process;
};

}  // namespace

class TestCncRun : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  [[nodiscard]] std::string file(const char* name) const {
    return m_folder.filePath(QString::fromLatin1(name)).toStdString();
  }
  [[nodiscard]] QString path(const char* name) const {
    return m_folder.filePath(QString::fromLatin1(name));
  }
  [[nodiscard]] trace::ControlTrace readTrace() const {
    const auto text = base::readFile(file("trace"));
    const auto trace = text ? trace::parseControlTrace(*text)
                            : base::Result<trace::ControlTrace>(base::fail(text.error()));
    if (!trace) {
      qFatal("%s", trace.error().text().c_str());
    }
    return *trace;
  }

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(base::writeFile(file("program.mpf"), kProgram).has_value());
    QVERIFY(base::writeFile(file("long.mpf"), kLongProgram).has_value());
  }

  void threadsMoveTheAxesAsPlanned() {
    const tests::Planned planned = plan(kProgram);
    QVERIFY(planned.cycles.size() > 200);
    const std::atomic<bool> stop{false};
    for (const pipeline::PolicyFacts& policy : pipeline::policies()) {
      const auto run = cnc::runCnc(optionsOf(policy.kind, file("program.mpf")), stop);
      QVERIFY2(run, run ? "" : run.error().text().c_str());
      QVERIFY2(run->failure.empty(), run->failure.c_str());
      QVERIFY(run->hasEnded);
      const QByteArray what = difference(planned, run->trace, true);
      QVERIFY2(what.isEmpty(), what.constData());
      // The axes follow.
      QVERIFY(run->trace.samples[100].actualMm != run->trace.samples[0].actualMm);
    }
  }

  void auxiliaryFunctionsReachTheMachine() {
    const std::atomic<bool> stop{false};
    cnc::RunOptions options = optionsOf(PolicyKind::TaskDependency, file("program.mpf"));
    options.preset = "dmu75-mill";  // has a spindle
    const auto run = cnc::runCnc(options, stop);
    QVERIFY(run.has_value());
    QVERIFY2(run->failure.empty(), run->failure.c_str());
    QCOMPARE(run->trace.events.size(), std::size_t{3});  // S, M3, M5
  }

  void realRunsAreAllowedByTheNet() {
    const std::atomic<bool> stop{false};
    for (const PolicyKind policy : {PolicyKind::TaskDependency, PolicyKind::DataFlow}) {
      for (const int processors : {1, 2, 6}) {
        cnc::RunOptions options = optionsOf(policy, file("program.mpf"));
        options.dispatch.processors = processors;
        const auto run = cnc::runCnc(options, stop);
        QVERIFY(run.has_value());
        QVERIFY2(run->failure.empty(), run->failure.c_str());
        const auto result = pipeline::checkConformance(run->events, policy, options.dispatch);
        QVERIFY(result.has_value());
        QVERIFY2(!result->violation, result->violation.value_or("").c_str());
        QVERIFY(result->events > 1000);
        for (std::size_t i = 0; i < kTaskCount; ++i) {
          QCOMPARE(run->records[i].count, result->records[i].count);
          QVERIFY(run->records[i].responseSum == result->records[i].responseSum);
        }
      }
    }
  }

  /// The end of the program can arrive before the scheduler has seen the step that asks for it.
  void theEndOfTheProgramIsNotMissed() {
    QVERIFY(base::writeFile(file("end.mpf"), "M30\n").has_value());
    const std::atomic<bool> stop{false};
    cnc::RunOptions options = optionsOf(PolicyKind::TaskDependency, file("end.mpf"));
    options.until = 20s;
    for (int i = 0; i < 300; ++i) {
      const auto run = cnc::runCnc(options, stop);
      QVERIFY(run.has_value());
      QVERIFY2(run->hasEnded, qPrintable(QString::number(i)));
    }
  }

  void processesMoveTheAxesAsPlanned() {
    const tests::Planned planned = plan(kProgram);
    for (const pipeline::PolicyFacts& policy : pipeline::policies()) {
      Program program({"run", path("program.mpf"), "--processes", "--cycle", "1", "--policy",
                       QString::fromUtf8(policy.name.data()), "--trace", path("trace"), "--events",
                       path("events")});
      const int code = program.finished();
      QVERIFY2(code == 0, qPrintable(QStringLiteral("code %1: ").arg(code) + program.errors()));
      const QByteArray what = difference(planned, readTrace(), true);
      QVERIFY2(what.isEmpty(), what.constData());
    }
    // The last one was none of [P3].
    Program wrong({"conformance", path("events")});
    QCOMPARE(wrong.finished(), 2);
    Program program(
        {"run", path("program.mpf"), "--processes", "--cycle", "1", "--events", path("events")});
    QCOMPARE(program.finished(), 0);
    Program check({"conformance", path("events")});
    QVERIFY2(check.finished() == 0, check.errors().constData());
  }

  void aProgramComesOverTcp() {
    const tests::Planned planned = plan(kProgram);
    const std::atomic<bool> stop{false};
    cnc::RunOptions options = optionsOf(PolicyKind::TaskDependency, {});
    std::thread sender;
    options.say = [&](const std::string& text) {
      const int port = std::stoi(text.substr(text.find(' ')));
      sender = std::thread([port] {
        const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        if (::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) {
          const std::string_view all(kProgram);
          for (std::size_t at = 0; at < all.size(); at += 50) {
            const std::string_view part = all.substr(at, 50);
            static_cast<void>(::send(socket, part.data(), part.size(), MSG_NOSIGNAL));
          }
        }
        ::close(socket);
      });
    };
    const auto run = cnc::runCnc(options, stop);
    sender.join();
    QVERIFY(run.has_value());
    QVERIFY2(run->failure.empty(), run->failure.c_str());
    const QByteArray what = difference(planned, run->trace, true);
    QVERIFY2(what.isEmpty(), what.constData());
  }

  /// Each of the six processes, at drawn moments. RIVULET_KILLS: how often each (default 2);
  /// RIVULET_SEED: other moments.
  void aKilledTaskIsNamedAndTheAxesStand() {
    const bool isSet = qEnvironmentVariableIsSet("RIVULET_KILLS");
    const int kills = isSet ? qEnvironmentVariableIntValue("RIVULET_KILLS") : 2;
    base::Random random(1 +
                        static_cast<std::uint64_t>(qEnvironmentVariableIntValue("RIVULET_SEED")));
    const tests::Planned planned = plan(kLongProgram);
    int moved = 0;
    for (int round = 0; round < kills; ++round) {
      for (std::size_t task = 0; task < kTaskCount; ++task) {
        const QByteArray name(pipeline::kTaskNames[task].data());
        Program program(
            {"run", path("long.mpf"), "--processes", "--cycle", "1", "--trace", path("trace")});
        const QString memory = QStringLiteral("rivulet-cnc-%1-*").arg(program.id());
        const QByteArray id = program.said("task " + name + ": process ");
        QVERIFY(!id.isEmpty());
        QVERIFY(program.runsFor(static_cast<int>(random.below(1500))));
        QCOMPARE(::kill(id.toInt(), SIGKILL), 0);
        QCOMPARE(program.finished(), 1);
        const QByteArray errors = program.errors();
        QVERIFY2(errors.contains("The task " + name + " has died"), errors.constData());
        QVERIFY2(errors.contains("ended by signal 9"), errors.constData());
        const trace::ControlTrace trace = readTrace();
        const QByteArray stand = "The axes stand after set point " +
                                 QByteArray::number(static_cast<qulonglong>(trace.samples.size())) +
                                 ";";
        QVERIFY2(errors.contains(stand), errors.constData());
        const QByteArray what = difference(planned, trace, false);
        QVERIFY2(what.isEmpty(), what.constData());
        QVERIFY(trace.samples.size() < planned.cycles.size());
        moved += trace.samples.empty() ? 0 : 1;
        QVERIFY2(QDir(QStringLiteral("/dev/shm")).entryList({memory}).isEmpty(),
                 "shared memory was left behind");
      }
    }
    QVERIFY(moved > 0);
  }

  /// Somebody writes into the memory of a run.
  void rubbishInSharedMemoryIsRefused() {
    Program program(
        {"run", path("long.mpf"), "--processes", "--cycle", "1", "--trace", path("trace")});
    QVERIFY(!program.said("task position control: process ").isEmpty());
    const QStringList names =
        QDir(QStringLiteral("/dev/shm"))
            .entryList({QStringLiteral("rivulet-cnc-%1-*").arg(program.id())});
    QCOMPARE(names.size(), 1);
    auto shared = cnc::SharedSegment::open(names.front().toStdString());
    QVERIFY(shared.has_value());
    auto& ring = shared->segment().rings.b4;
    while (ring.written.load() < 200) {
      std::this_thread::yield();
    }
    ring.written.store(ring.written.load() + 1'000'000);
    QCOMPARE(program.finished(), 1);
    const QByteArray errors = program.errors();
    QVERIFY2(errors.contains("Ring buffer B4 is refused"), errors.constData());
    QVERIFY2(errors.contains("The axes stand after set point"), errors.constData());
    const QByteArray what = difference(plan(kLongProgram), readTrace(), false);
    QVERIFY2(what.isEmpty(), what.constData());
  }

  void anotherMemoryIsRefused() {
    const std::string name = "rivulet-cnc-test-" + std::to_string(::getpid());
    QVERIFY(!cnc::SharedSegment::open(name).has_value());
    auto shared = cnc::SharedSegment::make(name);
    QVERIFY(shared.has_value());
    QVERIFY(!cnc::SharedSegment::make(name).has_value());  // it is in use
    QVERIFY(cnc::SharedSegment::open(name).has_value());
    shared->segment().layout ^= 1U;
    const auto other = cnc::SharedSegment::open(name);
    QVERIFY(!other);
    QVERIFY(other.error().message.find("another version") != std::string::npos);
  }

  void aFailureBeforeTheStartIsASentence() {
    const std::atomic<bool> stop{false};
    const auto missing = cnc::runCnc(optionsOf(PolicyKind::DataFlow, file("none.mpf")), stop);
    QVERIFY(missing.has_value());
    QVERIFY2(missing->failure.find("none.mpf") != std::string::npos, missing->failure.c_str());
    cnc::RunOptions options = optionsOf(PolicyKind::DataFlow, file("program.mpf"));
    options.preset = "none";
    QVERIFY(!cnc::runCnc(options, stop).has_value());
    QVERIFY(!cnc::makeRealTime({1000, -1}).empty());
    QVERIFY(!cnc::makeRealTime({0, 100'000}).empty());
  }

  void eventsAreReadAsTheyWereWritten() {
    const std::atomic<bool> stop{false};
    const auto run = cnc::runCnc(optionsOf(PolicyKind::DataFlow, file("program.mpf")), stop);
    QVERIFY(run.has_value());
    cnc::EventRecording recording{PolicyKind::DataFlow,
                                  optionsOf(PolicyKind::DataFlow, {}).dispatch, run->events};
    recording.events.back().at += 1h;
    const std::string text = cnc::printEvents(recording);
    const auto read = cnc::parseEvents(text);
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY(read->events == recording.events);
    QVERIFY(read->policy == PolicyKind::DataFlow);
    // Whatever is changed in a line, it is refused or read; never believed out of bounds.
    QVERIFY(!cnc::parseEvents("").has_value());
    QVERIFY(!cnc::parseEvents("something else\n").has_value());
    const std::size_t third = text.find('\n', text.find('\n') + 1) + 1;
    for (const char* line : {"", "start", "start 5 7 0 0 0 0 0 0 0 0", "leap 5 1 0 0 0 0 0 0 0 0",
                             "start -5 1 0 0 0 0 0 0 0 0", "start 5 1 0 2 0 0 0 0 0 0",
                             "start 5 1 0 0 0 0 0 0 0 65"}) {
      const auto broken = cnc::parseEvents(text.substr(0, third) + line + "\n");
      QVERIFY(!broken);
      QVERIFY(broken.error().message.find("Line 3") != std::string::npos);
    }
  }
};

RIVULET_TEST(TestCncRun)
#include "tst_cnc_run.moc"
