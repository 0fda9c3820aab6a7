// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// What a service needs after hours of jobs, in virtual time: memory, open files and disk stay
/// where they were. Jobs are held, stopped in the middle and resumed. RIVULET_ENDURANCE_HOURS says
/// for how long; 24 hours take some minutes.

#include <sys/resource.h>

#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>
#include <fstream>

#include "base/random.h"
#include "report/run_history.h"
#include "service/service_session.h"
#include "support/patience.h"
#include "support/simulated_control.h"
#include "support/test_program.h"

using namespace rivulet;
namespace fs = std::filesystem;

namespace {

constexpr double kHours = 0.4;
/// More than this over what the first part of the time needed is a leak. The virtual machine's own
/// record, which is in this process too, grows for its first hours.
constexpr double kGrowthMiB = 48.0;
constexpr std::size_t kHistoryRuns = 10;

/// What this process holds.
struct Need {
  double memoryMiB = 0.0;
  std::size_t files = 0;
  double diskMiB = 0.0;
  std::size_t filesOnDisk = 0;
};

double residentMiB() {
  constexpr double kPageMiB = 4096.0 / (1024.0 * 1024.0);
  std::ifstream file("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  file >> total >> resident;
  return resident * kPageMiB;
}

Need needOf(const fs::path& disk) {
  Need need{residentMiB(), 0, 0.0, 0};
  for ([[maybe_unused]] const auto& file : fs::directory_iterator("/proc/self/fd")) {
    ++need.files;
  }
  for (const auto& entry : fs::recursive_directory_iterator(disk)) {
    if (entry.is_regular_file()) {
      need.diskMiB += static_cast<double>(entry.file_size()) / (1024.0 * 1024.0);
      ++need.filesOnDisk;
    }
  }
  return need;
}

}  // namespace

class TestServiceEndurance : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;
  const service::Caller m_caller{"engineer", {}, false};

  /// Stretches with blocks of the control between them.
  [[nodiscard]] std::string writeJob(base::Random& random) const {
    const auto drawn = [&](int count) {
      return static_cast<int>(random.uniform() * count) % count;
    };
    std::ofstream file(m_folder.path().toStdString() + "/jobs/part.mpf");
    file << "G54 G90 G94\nT" << 1 + drawn(2) << " D1 M6\nS3000 M3\nG0 X0 Y0 Z20\n";
    int x = 0;
    for (int stretches = 2 + drawn(4); stretches > 0; --stretches) {
      for (int points = 40 + drawn(100); points > 0; --points) {
        ++x;
        file << "G1 X" << 0.5 * x << " Y" << x % 2 << " F1200\n";
      }
      file << std::array{"M8\n", "G4 F0.4\n", "S2500 M3\n", "M9\n"}.at(
          static_cast<std::size_t>(drawn(4)));
    }
    file << "G0 Z30\nM5 M9\nM30\n";
    return "part.mpf";
  }
  template <typename Condition>
  static bool turnUntil(service::ServiceSession& session, const Condition& isSo) {
    const auto end =
        service::ServiceSession::Clock::now() + std::chrono::milliseconds(tests::kRunMs);
    while (!isSo(session.snapshot())) {
      const auto now = service::ServiceSession::Clock::now();
      if (now > end) {
        return false;
      }
      session.turn(now);
      std::this_thread::yield();
    }
    return true;
  }
  /// Asks again as long as the answer takes a while.
  template <typename Question>
  static service::Answer ask(service::ServiceSession& session, const Question& question) {
    service::Answer answer;
    turnUntil(session, [&](const service::Snapshot&) {
      answer = question();
      return !service::isNotYet(answer);
    });
    return answer;
  }

  /// One job to its end. @param stops  how often it is stopped on its way, and resumed
  void execute(service::ServiceSession& session, base::Random& random, int stops) {
    const service::Answer loaded = session.loadJob(m_caller, writeJob(random), {});
    QVERIFY2(loaded.accepted, loaded.message.c_str());
    const service::Answer shown = ask(session, [&] { return session.preflight(m_caller); });
    QVERIFY2(!shown.confirmation.empty(), shown.message.c_str());
    service::Answer begun = session.start(m_caller, shown.confirmation);
    for (;;) {
      QVERIFY2(begun.accepted, begun.message.c_str());
      const auto after = static_cast<std::uint32_t>(10.0 + 60.0 * random.uniform());
      QVERIFY(turnUntil(session, [&](const service::Snapshot& now) {
        return !session.isRunning() || (stops > 0 && now.pointsDone >= after);
      }));
      if (!session.isRunning()) {
        break;
      }
      --stops;
      session.stop(m_caller);
      QVERIFY(turnUntil(session, [&](const service::Snapshot& now) {
        return now.stands || !session.isRunning();
      }));
      session.stop(m_caller);
      session.hold(m_caller, false);
      QVERIFY(turnUntil(session, [&](const auto&) { return !session.isRunning(); }));
      if (session.snapshot().outcome == "completed") {
        break;  // it came to its end all the same
      }
      QVERIFY2(session.snapshot().outcome == "stopped" && session.snapshot().alarm.empty(),
               session.snapshot().alarm.c_str());
      QVERIFY(turnUntil(session, [](const service::Snapshot& now) { return now.canResume; }));
      const service::Answer place = ask(session, [&] { return session.preflightResume(m_caller); });
      QVERIFY2(!place.confirmation.empty(), place.message.c_str());
      begun = session.resumeRun(m_caller, place.confirmation);
    }
    QVERIFY2(session.snapshot().outcome == "completed", session.snapshot().alarm.c_str());
  }

 private Q_SLOTS:
  void initTestCase() {
    for (const char* name : {"DATA", "STATE", "CONFIG"}) {
      qputenv((std::string("XDG_") + name + "_HOME").c_str(), m_folder.path().toUtf8());
    }
    fs::create_directory(m_folder.path().toStdString() + "/jobs");
  }

  void nothingGrows() {
    const bool isLong = qEnvironmentVariableIsSet("RIVULET_ENDURANCE_HOURS");
    const double hours =
        isLong ? qEnvironmentVariable("RIVULET_ENDURANCE_HOURS").toDouble() : kHours;
    QVERIFY(report::RunHistory().setLimits({kHistoryRuns}));
    const tests::SimulatedControl machine("dmu75-mill");
    opcua::ConnectRequest request;
    request.endpoint = tests::SimulatedControl::endpoint();
    const fs::path folder = m_folder.path().toStdString();
    service::ServiceSession session(
        {request, folder / "jobs", folder},
        [&machine](const opcua::ConnectRequest& asked) {
          return opcua::Attempt{machine.connect(asked.endpoint)};
        },
        report::MachineStore());
    QVERIFY(turnUntil(session, [](const service::Snapshot& now) {
      return now.isConnected && !now.positionMm.empty();
    }));
    base::Random random(1);
    std::optional<Need> first;
    double nextH = 0.0;
    int jobs = 0;
    const auto passedH = [&] { return base::toSeconds(machine.now() - base::Instant{}) / 3600.0; };
    // On a busy computer a job takes longer: the history is full in any case.
    for (; passedH() < hours || jobs < 2 * static_cast<int>(kHistoryRuns); ++jobs) {
      execute(session, random, jobs % 4 == 3 ? 2 : 0);
      if (QTest::currentTestFailed()) {
        return;
      }
      if (passedH() >= nextH) {
        const Need need = needOf(folder);
        qInfo("%5.2f h, %d jobs: %.1f MiB, %zu open files, %.1f MiB in %zu files", passedH(),
              jobs + 1, need.memoryMiB, need.files, need.diskMiB, need.filesOnDisk);
        nextH += hours / 24.0;
      }
      if (!first && passedH() > hours / 4.0 && jobs >= static_cast<int>(kHistoryRuns)) {
        first = needOf(folder);
      }
    }
    QVERIFY(first.has_value());
    const Need last = needOf(folder);
    QVERIFY2(last.memoryMiB < first->memoryMiB + kGrowthMiB,
             qPrintable(QStringLiteral("%1 to %2 MiB").arg(first->memoryMiB).arg(last.memoryMiB)));
    QVERIFY2(last.files <= first->files,
             qPrintable(QStringLiteral("%1 to %2").arg(first->files).arg(last.files)));
    // The trail grows by a line with each act; all else is a number of files that stays.
    QVERIFY2(last.filesOnDisk <= first->filesOnDisk + kHistoryRuns,
             qPrintable(QStringLiteral("%1 to %2").arg(first->filesOnDisk).arg(last.filesOnDisk)));
  }
};

RIVULET_TEST(TestServiceEndurance)
#include "tst_service_endurance.moc"
