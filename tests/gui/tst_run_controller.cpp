// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The models of the window without a window: what is open, what may be done and why not, and a
/// run on a virtual machine in virtual time.

#include <sys/resource.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <csignal>
#include <set>

#include "base/file.h"
#include "base/units.h"
#include "hmi/document.h"
#include "hmi/machine_model.h"
#include "hmi/preflight.h"
#include "hmi/run_controller.h"
#include "machine/machine.h"
#include "report/run_history.h"
#include "streaming/simulation/simulated_link.h"
#include "support/patience.h"
#include "support/test_program.h"
#include "widgets/alarms/alarm_text.h"
#include "widgets/common/blocked_text.h"

using namespace rivulet;
using hmi::Document;
using hmi::RunController;
using streaming::BlockReason;

namespace {

using rivulet::tests::kSoonMs;
const QString kScorpion = QStringLiteral(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");

const QString kMill = QStringLiteral("opc.tcp://mill");

/// Two tools, coolant that is switched on while the tool moves, a retract, and a cycle.
const char* const kJob =
    "G17 G90 G71\n"
    "T1 M6\n"
    "S2000 M3\n"
    "G0 X0 Y0 Z5\n"  // 4: stretch 1
    "G1 Z-2 F600\n"
    "X40\n"
    "G0 X60 Y30 Z5 M8\n"  // 7: the control moves there
    "G1 Z-2 F600\n"
    "G3 X80 Y30 CR=10\n"
    "G0 Z5\n"
    "M9\n"
    "SUPA G0 Z0 D0\n"
    "T2 M6 D1\n"
    "S1000 M3\n"
    "G0 X10 Y30 Z5\n"  // 15: stretch 3
    "F100\n"
    "MCALL CYCLE81(5,0,1,-8)\n"
    "X10 Y30\n"
    "X25 Y30\n"
    "MCALL\n"
    "M5\n"
    "M30\n";

struct Cell {
  explicit Cell(const char* preset) : machine(*machine::loadPreset(preset), 1) {}
  machine::Machine machine;
  streaming::SimulatedLink link{machine};
};

base::Result<opcua::Connection> connectToCell(const opcua::ConnectRequest& asked) {
  auto cell =
      std::make_shared<Cell>(asked.endpoint == kMill.toStdString() ? "dmu75-mill" : "dmu75");
  return opcua::Connection{cell, &cell->link, &cell->link, asked.endpoint};
}

streaming::StreamSettings settings(base::MethodKind method, double feedMmPerMin) {
  streaming::StreamSettings stream;
  stream.parameters.method = method;
  stream.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  return stream;
}

/// The newest whole job of the history; another test's run may be of the same second.
/// @param dryRunMm  see `RunSummary`
streaming::RunSummary keptJob(double dryRunMm) {
  const auto runs = report::RunHistory().list().runs;
  const auto found = std::find_if(runs.begin(), runs.end(), [dryRunMm](const auto& run) {
    return run.jobTimes && run.dryRunMm == dryRunMm;
  });
  return found == runs.end() ? streaming::RunSummary{} : *found;
}

/// All models, with machine files in a folder of their own.
struct Models {
  QTemporaryDir folder;
  report::MachineStore store{
      report::MachineFolders::below(folder.filePath(QStringLiteral("data")).toStdString(),
                                    folder.filePath(QStringLiteral("config")).toStdString())};
  hmi::Messages messages;
  session::StreamSession session{connectToCell, store};
  Document document{settings(base::MethodKind::Window, 1500.0)};
  hmi::MachineModel machine{session, store, messages};
  RunController runs{session, document, machine, messages};

  /// Connects to a machine with tools, and opens a program that needs them.
  void openJob(const char* text = kJob) {
    load(text);
    QTRY_VERIFY_WITH_TIMEOUT(document.view() && !reason(), kSoonMs);
  }
  void load(const char* text) {
    streaming::StreamSettings whole = document.settings();
    whole.wholeJob = true;
    whole.parameters.method = base::MethodKind::Window;
    document.setSettings(whole);
    const QString path = folder.filePath(QStringLiteral("JOB.MPF"));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) < 0) {
      qFatal("the program cannot be written");
    }
    file.close();
    machine.connectTo(kMill);
    document.open(path);
  }

  [[nodiscard]] std::optional<BlockReason> reason() const {
    const auto blocked = runs.startBlocked();
    return blocked ? std::optional(blocked->reason) : std::nullopt;
  }
};

}  // namespace

class TestRunController : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aDocumentNeedsNoMachine() {
    Document document(settings(base::MethodKind::Window, 1500.0));
    QVERIFY(!document.view() && !document.findings().verdict);
    QVERIFY(document.findings().flexible);
    QSignalSpy judged(&document, &Document::judged);
    QSignalSpy loaded(&document, &Document::programLoaded);
    document.open(kScorpion);
    QVERIFY(loaded.wait(kSoonMs));
    QVERIFY(judged.count() >= 1);
    QVERIFY(document.findings().verdict.has_value());
    // Settings of which no program can be made: one reason, no verdict.
    streaming::StreamSettings tooMany = document.settings();
    tooMany.parameters.pointsPerLoop = 40;
    document.setSettings(tooMany);
    QVERIFY(document.findings().settingsError && !document.findings().verdict);
    QVERIFY(!document.findings().flexible && document.findings().distances);
  }

  void theNextReasonIsNamed() {
    Models models;
    QVERIFY(models.reason() == BlockReason::NotConnected);
    QSignalSpy shown(&models.messages, &hmi::Messages::shown);
    QVERIFY(!models.runs.start());
    QCOMPARE(shown.count(), 1);
    models.machine.connectTo(QStringLiteral("opc.tcp://cell"));
    QTRY_VERIFY_WITH_TIMEOUT(models.reason() == BlockReason::NoProgram, kSoonMs);
    QVERIFY(!models.runs.calibrationBlocked());
    models.document.open(kScorpion);
    QTRY_VERIFY_WITH_TIMEOUT(!models.reason(), kSoonMs);
    models.document.setSettings(settings(base::MethodKind::Position, 20000.0));
    QVERIFY(models.reason() == BlockReason::Infeasible);
    QVERIFY(models.runs.resumeBlocked()->reason == BlockReason::NothingToResume);
  }

  /// Without a connection nothing is live, also in the half second in which it still is young.
  void aLostConnectionIsNotLive() {
    using widgets::Freshness;
    Models models;
    hmi::MachineModel machine{models.session, models.store, models.messages, [] { return 100.0; }};
    Q_EMIT models.session.linkChanged({session::LinkState::Connected, {}, true, {}});
    machine.showSample({base::Instant{}, base::Vec3{1.0, 2.0, 3.0}, 5.0, {}}, std::nullopt);
    QVERIFY(machine.view().positionFreshness() == Freshness::Live && machine.positionNowMm());
    Q_EMIT models.session.linkChanged({session::LinkState::Lost, {}, true, {}});
    QVERIFY(machine.view().positionFreshness() == Freshness::Old);
    QVERIFY(machine.view().feedFreshness() == Freshness::Old && !machine.positionNowMm());
  }

  /// What was seen to move may move until it is seen to stand, also after the connection was lost.
  void whatWasSeenToMoveMayMove() {
    Models models;
    hmi::MachineModel& machine = models.machine;
    QVERIFY(!machine.mayMove());
    Q_EMIT models.session.linkChanged({session::LinkState::Connected, {}, true, {}});
    session::MachineSeen seen;
    seen.channelStatus = 1;
    Q_EMIT models.session.machineSeen(seen);
    QVERIFY(machine.mayMove());
    Q_EMIT models.session.linkChanged({session::LinkState::Lost, {}, true, {}});
    QVERIFY(machine.mayMove());
    // No run of this window: it says what stops the machine.
    QString said;
    connect(&models.messages, &hmi::Messages::shown, this,
            [&said](gcode::Severity, const std::function<QString()>& text) { said = text(); });
    models.runs.stop();
    QVERIFY2(said.contains(QStringLiteral("NC STOP")), qPrintable(said));
    seen.channelStatus = opcua::kChannelReset;
    Q_EMIT models.session.machineSeen(seen);
    QVERIFY(!machine.mayMove());
    // A channel that cannot be read is not one that stands.
    seen.channelStatus.reset();
    Q_EMIT models.session.machineSeen(seen);
    QVERIFY(machine.mayMove());
  }

  /// What may be done is asked again when a reading says something else, whatever that is.
  void whatAReadingSaysAnewIsNews() {
    Models models;
    double nowS = 100.0;
    hmi::MachineModel machine{models.session, models.store, models.messages,
                              [&nowS] { return nowS; }};
    Q_EMIT models.session.linkChanged({session::LinkState::Connected, {}, true, {}});
    bool wasNews = false;
    connect(&machine, &hmi::MachineModel::seen, this, [&](bool isNews) { wasNews = isNews; });
    const auto isNews = [&](const session::MachineSeen& seen) {
      nowS += 0.25;
      Q_EMIT models.session.machineSeen(seen);
      return wasNews;
    };
    session::MachineSeen seen;
    seen.channelStatus = seen.programStatus = seen.alarm = 0;
    seen.positionMm = base::Vec3{1.0, 2.0, 3.0};
    QVERIFY(isNews(seen));
    QVERIFY(!isNews(seen));
    seen.equipment = streaming::EquipmentSeen{};
    seen.equipment->tool = 1;
    QVERIFY(isNews(seen));
    QVERIFY(!isNews(seen));
    seen.equipment->tool = 2;  // changed by hand, at the control
    QVERIFY(isNews(seen));
    seen.equipment.reset();  // not read this time
    QVERIFY(!isNews(seen));
    seen.message = "SPINDLE";
    QVERIFY(isNews(seen));
    seen.alarm = 3000;
    QVERIFY(isNews(seen));
    QVERIFY(!isNews(seen));
    nowS += 2.0;  // nothing was read meanwhile
    QVERIFY(isNews(seen));
  }

  /// What cannot be read is not zero: the axes stay where they were seen, and get old.
  void whatCannotBeReadIsNotZero() {
    Models models;
    double nowS = 100.0;
    hmi::MachineModel machine{models.session, models.store, models.messages,
                              [&nowS] { return nowS; }};
    Q_EMIT models.session.linkChanged({session::LinkState::Connected, {}, true, {}});
    session::MachineSeen seen;
    seen.positionMm = base::Vec3{10.0, 20.0, 30.0};
    seen.feedMmPerS = 5.0;
    Q_EMIT models.session.machineSeen(seen);
    QVERIFY(machine.positionNowMm() == seen.positionMm);
    nowS += 2.0;
    Q_EMIT models.session.machineSeen({});
    QVERIFY(machine.view().positionMm == seen.positionMm);
    QVERIFY(machine.view().feedMmPerS == seen.feedMmPerS);
    QVERIFY(machine.view().positionFreshness() == widgets::Freshness::Old);
  }

  /// A stream without slack reads the axes every 0.9 s: that is said once, not with each read.
  void readsThatComeRarelyAreSaidToBeRare() {
    using widgets::Freshness;
    Models models;
    double nowS = 100.0;
    hmi::MachineModel machine{models.session, models.store, models.messages,
                              [&nowS] { return nowS; }};
    const auto readAfter = [&](double passedS) {
      nowS += passedS;
      machine.showSample({base::Instant{}, base::Vec3{1.0, 2.0, 3.0}, 5.0, {}}, std::nullopt);
    };
    const auto lookAfter = [&](double passedS) {
      nowS += passedS;
      machine.showExecuted(5, {}, 8.0, std::nullopt);
      return machine.view().positionFreshness();
    };
    readAfter(0.0);
    QVERIFY(lookAfter(0.4) == Freshness::Live);
    QVERIFY(lookAfter(0.2) == Freshness::Old);
    for (int i = 0; i < 5; ++i) {
      readAfter(0.1);
      for (int look = 0; look < 4; ++look) {
        QVERIFY(lookAfter(0.2) == Freshness::Planned);
        QVERIFY(machine.view().feedFreshness() == Freshness::Planned);
      }
    }
    QVERIFY(lookAfter(0.5) == Freshness::Old);  // a read is missing
    QVERIFY(!machine.positionNowMm());          // that is not where the tool stands now
    readAfter(0.0);
    QVERIFY(lookAfter(0.1) == Freshness::Planned);
    for (int i = 0; i < 40; ++i) {
      readAfter(0.1);
    }
    QVERIFY(lookAfter(0.1) == Freshness::Live);
  }

  void aRunEndsWithItsReport() {
    Models models;
    models.machine.connectTo(QStringLiteral("opc.tcp://cell"));
    models.document.open(kScorpion);
    QTRY_VERIFY_WITH_TIMEOUT(!models.reason() && models.document.view(), kSoonMs);
    QSignalSpy finished(&models.runs, &RunController::finished);
    QSignalSpy started(&models.runs, &RunController::started);
    QVERIFY(models.runs.start());
    QCOMPARE(started.count(), 1);
    QVERIFY(models.reason() == BlockReason::RunInProgress);
    QVERIFY(models.runs.calibrationBlocked()->reason == BlockReason::RunInProgress);
    // While it is in progress no other program takes the place of its own.
    const auto program = models.document.program();
    QVERIFY(finished.wait(kSoonMs));
    QVERIFY(models.document.program() == program);
    const auto report = models.runs.report();
    QVERIFY2(report && report->isFaultless(), report ? report->error.text().c_str() : "");
    const streaming::LiveUpdate& update = models.runs.update();
    QVERIFY(update.state == streaming::RunState::Done);
    QCOMPARE(update.counters.executed, models.document.points().size());
    QTRY_VERIFY_WITH_TIMEOUT(!models.reason(), kSoonMs);
  }

  /// The control reports a window when it is over: in between, line and share are where the tool
  /// is.
  void theLineIsThatOfTheMove() {
    Models models;
    models.openJob("G17 G90 G71\nG1 X1 F600\nX21\nX41\nX21\nX1\nM30\n");
    QTRY_VERIFY_WITH_TIMEOUT(!models.reason(), kSoonMs);
    const auto& points = models.document.points();
    QCOMPARE(points.size(), std::size_t{5});
    std::set<std::size_t> moves;
    std::size_t before = 0;
    QStringList wrong;
    connect(&models.runs, &RunController::updated, &models.runs,
            [&](const streaming::LiveUpdate& update) {
              const std::size_t passed = models.runs.passed();
              const auto move = models.runs.move();
              if (update.counters.executed == 0 && move && update.sample) {
                moves.insert(*move);
                const double x = update.sample->positionMm->x;
                const double from = *move == 0 ? 0.0 : points[*move - 1].positionMm.x;
                const double to = points[*move].positionMm.x;
                if (x < std::min(from, to) - 1.0 || x > std::max(from, to) + 1.0) {
                  wrong << QStringLiteral("X %1 is not on move %2").arg(x).arg(*move);
                }
              }
              if (passed < before) {
                wrong << QStringLiteral("back from %1 to %2").arg(before).arg(passed);
              }
              before = passed;
            });
    QSignalSpy finished(&models.runs, &RunController::finished);
    QVERIFY(models.runs.start());
    QVERIFY(finished.wait(kSoonMs));
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
    QCOMPARE(moves, (std::set<std::size_t>{0, 1, 2, 3, 4}));  // there and back
    QVERIFY(!models.runs.move());
    QCOMPARE(models.runs.passed(), points.size());
  }

  /// The disk takes no more: one alarm says what is recorded, and the run comes to its end.
  void aRunGoesOnWithoutItsRecording() {
    Models models;
    models.machine.connectTo(QStringLiteral("opc.tcp://cell"));
    models.document.open(kScorpion);
    QTRY_VERIFY_WITH_TIMEOUT(!models.reason() && models.document.view(), kSoonMs);
    std::vector<alarm::Code> raised;
    QString said;
    connect(
        &models.messages, &hmi::Messages::raised, &models.messages,
        [&](alarm::Code code, const std::vector<std::string>& arguments, const base::Error& why) {
          raised.push_back(code);
          alarm::Alarm alarm;
          alarm.code = code;
          alarm.arguments = arguments;
          alarm.error = why;
          said = widgets::alarmText(alarm) + widgets::alarmCause(alarm);
        });
    QSignalSpy finished(&models.runs, &RunController::finished);
    rlimit before{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &before), 0);
    rlimit small = before;
    small.rlim_cur = 3000;
    const auto asBefore = std::signal(SIGXFSZ, SIG_IGN);
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &small), 0);
    const bool isStarted = models.runs.start();
    const bool isFinished = finished.wait(kSoonMs);
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, asBefore);
    QVERIFY(isStarted && isFinished);
    const auto report = models.runs.report();
    QVERIFY2(report && report->isFaultless(), report ? report->error.text().c_str() : "");
    QVERIFY(!raised.empty());
    QVERIFY(std::all_of(raised.begin(), raised.end(),
                        [](alarm::Code code) { return code == alarm::Code::RecordingCut; }));
    QVERIFY2(said.contains(QStringLiteral("scorpion.tap was cut off: the first ")) &&
                 said.contains(QStringLiteral("/recordings")),
             qPrintable(said));
  }

  /// A program with blocks for the control is run as a whole, unless its motion alone is chosen.
  void aWholeJobIsRun() {
    Models models;
    models.openJob();
    QVERIFY(models.document.isJob());
    QCOMPARE(models.document.view()->stretchStarts.size(), std::size_t{3});
    // What is left covers the control's part.
    QTRY_VERIFY_WITH_TIMEOUT(models.document.timeLeft(0), kSoonMs);
    const widgets::TimeLeft left = *models.document.timeLeft(0);
    QVERIFY(left.toolChangesS > 0.0 && left.nativeS > 0.0);
    QVERIFY(left.totalS > left.toolChangesS + left.nativeS + left.pausesS);
    const std::size_t last = models.document.points().size();
    QVERIFY(models.document.timeLeft(last)->toolChangesS == 0.0);
    // The block of the control in progress: what is before it has been done.
    const widgets::TimeLeft atTool = *models.document.timeLeft(0, 13);
    QVERIFY(atTool.totalS < left.totalS && atTool.toolChangesS < left.toolChangesS);
    std::vector<int> stretches;
    std::vector<std::size_t> lines;
    connect(&models.runs, &RunController::jobChanged, &models.runs, [&] {
      const auto& job = models.runs.job();
      if (job && !job->isNative) {
        stretches.push_back(job->stretch);
      } else if (job && job->line.value > 0) {
        lines.push_back(job->line.value);
      }
    });
    std::vector<streaming::RunState> states;
    std::size_t executed = 0;
    connect(&models.runs, &RunController::updated, &models.runs,
            [&](const streaming::LiveUpdate& update) {
              if (states.empty() || states.back() != update.state) {
                states.push_back(update.state);
              }
              QVERIFY(update.counters.executed >= executed);
              executed = update.counters.executed;
            });
    QSignalSpy finished(&models.runs, &RunController::finished);
    QVERIFY(models.runs.start());
    QVERIFY(finished.wait(kSoonMs));
    const auto report = models.runs.report();
    QVERIFY2(report->outcome == streaming::Outcome::Completed, report->error.text().c_str());
    QCOMPARE(stretches, (std::vector<int>{1, 2, 3}));
    QVERIFY(std::find(lines.begin(), lines.end(), 13U) != lines.end());  // the second tool
    QVERIFY(std::is_sorted(lines.begin(), lines.end()));
    using streaming::RunState;
    QCOMPARE(states, (std::vector<RunState>{RunState::Armed, RunState::Running, RunState::Done}));
    QCOMPARE(executed, models.document.points().size());
    QVERIFY(!models.runs.job());
    QVERIFY(report->controlTrace != nullptr);
    // Judged by the trace of the control, recorded as one run, and in the history with its times.
    QVERIFY(report->integrity.isFaultless());
    QVERIFY(report->finding() == streaming::RunFinding::Faultless);
    const streaming::RunSummary kept = keptJob(0.0);
    QVERIFY(kept.jobTimes && kept.jobTimes->toolChange > base::Duration{});
    QCOMPARE(kept.executed, report->counters.total);
    const auto text = base::readFile(kept.recording);
    QVERIFY(text.has_value());
    const auto recording = trace::parseRecording(*text);
    QVERIFY(recording && recording->complete && recording->pointsComplete);
    QCOMPARE(recording->points.points.size(), report->counters.total);
    const auto read = report::readFinishedRun(report::RunHistory().reportFile(kept.id));
    QVERIFY(read && read->summary.jobTimes);
    QCOMPARE(read->summary.jobTimes->total(), kept.jobTimes->total());
    QVERIFY(!kept.tools.empty());
    QCOMPARE(read->summary.tools.size(), kept.tools.size());
    const trace::ToolUse& lastTool = kept.tools.back();
    QCOMPARE(lastTool.number, std::optional(2));
    QVERIFY(lastTool.change > base::Duration{} && lastTool.inSpindle > base::Duration{});
    QCOMPARE(read->summary.tools.back().inSpindle, lastTool.inSpindle);
    QCOMPARE(read->summary.tools.back().number, lastTool.number);
    QCOMPARE(read->summary.tools.back().workOffsets, lastTool.workOffsets);
  }

  /// Motion alone with the wrong tool in the spindle starts only after somebody has said so, each
  /// time anew; another program is a whole job again.
  void motionWithoutItsSetUpIsConfirmed() {
    Models models;
    models.openJob("G17 G90 G71\nT1 M6\nS2000 M3\nG0 X0 Y0 Z5\nG1 Z-2 F600\nX40\nG0 Z5\nM30\n");
    hmi::Preflight preflight(models.document, models.machine, models.runs);
    models.document.chooseJob(false);
    QTRY_VERIFY_WITH_TIMEOUT(models.document.view() && !models.document.isJob(), kSoonMs);
    QTRY_VERIFY_WITH_TIMEOUT(!models.reason() && models.machine.view().equipment, kSoonMs);
    const auto item = [&] {
      const auto items = preflight.items();
      return *std::find_if(items.begin(), items.end(), [](const auto& each) {
        return each.name == QStringLiteral("Motion only");
      });
    };
    for (int time = 0; time < 2; ++time) {
      preflight.open();
      QVERIFY(!preflight.hasPassed());
      QVERIFY(item().status == widgets::Status::Fault);
      QVERIFY2(item().text.contains(QStringLiteral("none in the spindle")),
               qPrintable(item().text));
      preflight.remedy(item().remedyId);
      QVERIFY(preflight.hasPassed());
      QVERIFY(item().status == widgets::Status::Attention);
      preflight.close();
    }
    models.document.open(models.folder.filePath(QStringLiteral("JOB.MPF")));
    QTRY_VERIFY_WITH_TIMEOUT(!models.document.isJob(), kSoonMs);
    QVERIFY(QFile::copy(models.folder.filePath(QStringLiteral("JOB.MPF")),
                        models.folder.filePath(QStringLiteral("OTHER.MPF"))));
    models.document.open(models.folder.filePath(QStringLiteral("OTHER.MPF")));
    QTRY_VERIFY_WITH_TIMEOUT(models.document.isJob(), kSoonMs);
  }

  /// A stop is promised by the feed cell only where that is proved; else the longest window is
  /// said, and a move that takes longer than windows may.
  void aStopIsPromisedWhereItIsProved() {
    Models models;
    models.openJob("G17 G90 G71\nG1 X1 F600\nX51\nX52\nX252\nM30\n");
    hmi::Preflight preflight(models.document, models.machine, models.runs);
    QTRY_VERIFY_WITH_TIMEOUT(!models.reason(), kSoonMs);
    const auto item = [&] {
      const auto items = preflight.items();
      return *std::find_if(items.begin(), items.end(),
                           [](const auto& each) { return each.name == QStringLiteral("Stop"); });
    };
    QVERIFY2(item().text.contains(QStringLiteral("stand")), qPrintable(item().text));
    QVERIFY(item().status == widgets::Status::Plain);
    models.document.setFeedProof(streaming::FeedProof::WithoutMotion, 0.0);
    QVERIFY2(item().text.contains(QStringLiteral("still executes its window, at most 200")),
             qPrintable(item().text));
    QVERIFY2(item().text.contains(QStringLiteral("line 5 alone takes 20")),
             qPrintable(item().text));
    QVERIFY(item().text.contains(QStringLiteral("without motion only")));
    QVERIFY(item().status == widgets::Status::Attention);
  }

  /// A job begins with a stretch: what the program has set before it is listed, and done first.
  void aJobBeginsInTheMiddle() {
    Models models;
    models.openJob();
    hmi::Preflight preflight(models.document, models.machine, models.runs);
    QSignalSpy refused(&models.runs, &RunController::resumeRefused);
    QVERIFY(models.runs.askFromStretch(3));
    QVERIFY(refused.wait(kSoonMs));  // the tools of the machine are not known
    QVERIFY(!models.runs.place());
    models.document.setJobMachine(
        std::make_shared<const machine::MachineConfig>(*machine::loadPreset("dmu75-mill")));
    QTRY_VERIFY_WITH_TIMEOUT(!models.reason(), kSoonMs);
    QVERIFY(models.runs.askFromStretch(3));
    QTRY_VERIFY_WITH_TIMEOUT(models.runs.place(), kSoonMs);
    const widgets::ResumePlace place = *models.runs.place();
    QCOMPARE(place.stretch, 3);
    QVERIFY(std::find(place.steps.begin(), place.steps.end(), "T2 M6") != place.steps.end());
    QVERIFY(preflight.isOpen() && preflight.isForResume() && preflight.hasPassed());
    const auto items = preflight.items();
    QVERIFY(std::any_of(items.begin(), items.end(), [](const auto& item) {
      return item.text.contains(QStringLiteral("T2 M6"));
    }));
    QSignalSpy finished(&models.runs, &RunController::finished);
    QSignalSpy started(&models.runs, &RunController::started);
    QVERIFY(models.runs.resume());
    QCOMPARE(started.front().front().value<std::size_t>(), place.point);
    QVERIFY(finished.wait(kSoonMs));
    const auto report = models.runs.report();
    QVERIFY2(report->outcome == streaming::Outcome::Completed, report->error.text().c_str());
    QVERIFY(report->integrity.isFaultless());
    QCOMPARE(report->counters.total, models.document.points().size() - place.point);
    QVERIFY(!models.runs.hasRunToResume());
  }

  /// A dry run is higher and dry, or does not start. Nothing starts while the choice takes effect.
  void aDryRunIsDryOrIsNotStarted() {
    Models models;
    models.openJob();
    hmi::Preflight preflight(models.document, models.machine, models.runs);
    streaming::StreamSettings dry = models.document.settings();
    dry.dryRunMm = 30.0;
    models.document.setSettings(dry);
    QVERIFY(models.reason() == BlockReason::SettingsInvalid);
    QTRY_VERIFY_WITH_TIMEOUT(!models.reason(), kSoonMs);
    QCOMPARE(models.document.dryRunMm(), 30.0);
    QCOMPARE(models.document.points().front().positionMm.z, 35.0);
    const auto items = preflight.items();
    QVERIFY(std::any_of(items.begin(), items.end(), [](const auto& item) {
      return item.name == QStringLiteral("Dry run") && item.status == widgets::Status::Attention;
    }));
    QSignalSpy finished(&models.runs, &RunController::finished);
    QVERIFY(models.runs.start());
    QVERIFY(finished.wait(kSoonMs));
    const auto report = models.runs.report();
    QVERIFY2(report->outcome == streaming::Outcome::Completed, report->error.text().c_str());
    QVERIFY(report->integrity.isFaultless());
    for (const trace::ControlEvent& event : report->controlTrace->events) {
      QVERIFY(event.kind != trace::ControlEvent::Kind::Spindle || event.value == 0.0);
      QVERIFY(event.kind != trace::ControlEvent::Kind::Coolant || event.value == 0.0);
    }
    QVERIFY(keptJob(30.0).jobTimes);
    // A method that runs no jobs would run the motion where it is programmed.
    dry = models.document.settings();
    dry.parameters.method = base::MethodKind::Position;
    models.document.setSettings(dry);
    QVERIFY(models.reason() == BlockReason::SettingsInvalid);
    QTRY_VERIFY_WITH_TIMEOUT(!models.document.isJob(), kSoonMs);
    QVERIFY(models.reason() && models.document.findings().settingsError);
    // What cannot be raised is named.
    models.openJob();
    QCOMPARE(models.document.dryRunMm(), 30.0);
    models.load("T1 M6\nG0 X1 Y1 Z5\nG91 G0 Z-3 M8\nG90 G1 X5 F500\nM30\n");
    QTRY_VERIFY_WITH_TIMEOUT(models.reason() == BlockReason::SettingsInvalid, kSoonMs);
    const QString why = widgets::blockedText(models.runs.startBlocked());
    QVERIFY2(why.contains(QStringLiteral("JOB.MPF:3")), qPrintable(why));
  }

  /// Travel, spindle and tools are compared before the start; what is found is named with line,
  /// axis and limit.
  void aJobBeyondTheMachineIsNotStarted() {
    Models models;
    hmi::Preflight preflight(models.document, models.machine, models.runs);
    models.document.setJobMachine(
        std::make_shared<const machine::MachineConfig>(*machine::loadPreset("dmu75-mill")));
    models.load("T99 M6\nS99000 M3\nG0 X500 Y0 Z10\nG1 X400 F600\nX20\nM30\n");
    QTRY_VERIFY_WITH_TIMEOUT(models.reason() == BlockReason::BeyondMachine, kSoonMs);
    QVERIFY(!models.runs.start());
    const QString why = widgets::blockedText(models.runs.startBlocked());
    QVERIFY2(why.startsWith(QStringLiteral("Line 1: ")) && why.contains(QStringLiteral("T99")),
             qPrintable(why));
    const auto items = preflight.items();
    const auto item = std::find_if(items.begin(), items.end(), [](const auto& each) {
      return each.name == QStringLiteral("Travel, spindle and tools");
    });
    QVERIFY(item != items.end() && item->status == widgets::Status::Fault);
    for (const char* part : {"T99", "S99000", "X would go to 500.000", "Line 3 (part 1)"}) {
      QVERIFY2(QString(item->text)
                   .replace(QChar(0xA0), QLatin1Char(' '))
                   .remove(QLatin1Char(','))
                   .contains(QLatin1String(part)),
               qPrintable(item->text));
    }
    // What the machine can do starts.
    models.document.setJobMachine(nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(!models.reason(), kSoonMs);
  }

  /// What is chosen, and what machine and method can do, decides how the program is read.
  void theMotionAloneIsRunWhereAWholeJobIsNot() {
    Models models;
    models.openJob();
    QSignalSpy loaded(&models.document, &Document::programLoaded);
    models.document.chooseJob(false);
    QVERIFY(loaded.wait(kSoonMs));
    QVERIFY(!models.document.isJob());
    QVERIFY(models.document.outline() != nullptr);
    QVERIFY(!models.document.jobObstacle());
    models.document.chooseJob(true);
    QVERIFY(loaded.wait(kSoonMs));
    QVERIFY(models.document.isJob());
    streaming::StreamSettings changed = models.document.settings();
    changed.parameters.method = base::MethodKind::Position;
    models.document.setSettings(changed);
    QVERIFY(loaded.wait(kSoonMs));
    QVERIFY(!models.document.isJob());
    QVERIFY(models.document.jobObstacle() == Document::JobObstacle::Method);
    models.document.setJobRelease(
        streaming::JobRelease(std::nullopt, "opc.tcp://real", opcua::ServerIdentity{}, false));
    QVERIFY(models.document.jobObstacle() == Document::JobObstacle::Machine);
  }
};

RIVULET_TEST(TestRunController)
#include "tst_run_controller.moc"
