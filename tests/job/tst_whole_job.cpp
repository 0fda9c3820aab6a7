// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whole jobs on the virtual machine, in virtual time: native blocks and streamed stretches by
// turns.

#include <fmt/format.h>

#include <QtTest>

#include "base/random.h"
#include "gcode/feeds.h"
#include "job/main_program.h"
#include "machine/machine.h"
#include "plan_text.h"
#include "streaming/methods/feed_plan.h"
#include "streaming/recovery/run_on_control.h"
#include "streaming/run/job_trace.h"
#include "streaming/run/whole_job.h"
#include "streaming/simulation/faulty_link.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"
#include "support/whole_trace_link.h"
#include "templates/lint/lint.h"

using namespace rivulet;

namespace {

using streaming::Outcome;

job::Plan planOf(const std::string& text) {
  gcode::LoadOptions options;
  options.dialect = gcode::Dialect::Sinumerik;
  const auto plan = job::makePlan("PART.MPF", text, options);
  if (!plan) {
    qFatal("%s", plan.error().text().c_str());
  }
  return *plan;
}

/// Follows a job; stops or holds it where a test wants.
class Watcher : public streaming::WholeJobSink, public streaming::RunOrders {
 public:
  void update(const streaming::LiveUpdate& update) override {
    if (events.empty() || events.back() != streaming::runStateName(update.state)) {
      events.emplace_back(streaming::runStateName(update.state));
    }
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note& note) override { notes.push_back(note.text); }
  void nativeBlocks(int next) override {
    nativeBefore = next;
    inNative = true;
  }
  void stretchBegins(const job::Stretch& stretch, base::Vec3 startMm) override {
    begun.push_back(stretch.number);
    starts.push_back(startMm);
    inNative = false;
  }
  bool waitsForCycleStart() override {
    ++programStops;
    return pressesCycleStart;
  }
  bool stopRequested(base::Instant now) override { return stopWhen && stopWhen(now); }
  bool holdRequested(base::Instant now) override { return holdWhen && holdWhen(now); }

  std::function<bool(base::Instant)> stopWhen;
  std::function<bool(base::Instant)> holdWhen;
  std::vector<std::string> events;
  std::vector<std::string> notes;
  std::vector<int> begun;
  std::vector<base::Vec3> starts;
  int nativeBefore = 0;
  int programStops = 0;
  bool inNative = false;
  bool pressesCycleStart = true;
};

/// Keeps the whole trace of the machine; the report has its beginning.
class TraceWatcher final : public Watcher {
 public:
  explicit TraceWatcher(const machine::Machine& machine) : m_machine(machine) {}
  void update(const streaming::LiveUpdate& update) override {
    if (update.waitingFor == "trace") {  // before it is fetched, and forgotten by the machine
      whole = m_machine.trace();
    }
    Watcher::update(update);
  }

  trace::ControlTrace whole;

 private:
  const machine::Machine& m_machine;
};

streaming::RunSettings settingsOf(base::MethodKind method = base::MethodKind::Window) {
  streaming::RunSettings settings;
  settings.parameters.method = method;
  settings.parameters.pointsPerLoop = 5;
  settings.isCommissioned = true;
  settings.feedMmPerS = 20.0;
  return settings;
}

/// Ends of the blocks that moved, "X1 Y2 Z3", as the control's trace has them, to 0.01 mm: an
/// axis whose position was read from the control trembles.
QStringList motions(const trace::ControlTrace& trace) {
  QStringList ends;
  for (const trace::ExecutedBlock& block : trace.blocks) {
    if (block.lengthMm > 0.01) {
      QString end;
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        const double rounded = std::round(block.targetMm[axis] * 100.0) / 100.0;
        end += QStringLiteral(" %1%2")
                   .arg(QLatin1Char(base::kAxisNames[axis]))
                   .arg(rounded == 0.0 ? 0.0 : rounded);
      }
      ends << end.mid(1);
    }
  }
  return ends;
}

/// Motions, and between them what the machine did besides, in time order. Dwells are left out: the
/// loop waits with them.
QStringList deeds(const trace::ControlTrace& trace) {
  std::vector<std::pair<base::Instant, QString>> all;
  // An event begins at the instant at which the motion after it does.
  for (const trace::ControlEvent& event : trace.events) {
    if (event.kind != trace::ControlEvent::Kind::Dwell) {
      all.emplace_back(
          event.from,
          QStringLiteral("event %1: %2").arg(static_cast<int>(event.kind)).arg(event.value));
    }
  }
  for (const trace::ExecutedBlock& block : trace.blocks) {
    trace::ControlTrace one;
    one.blocks.push_back(block);
    if (const QStringList end = motions(one); !end.isEmpty()) {
      all.emplace_back(block.from, end.front());
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  QStringList deeds;
  for (const auto& [at, deed] : all) {
    deeds << deed;
  }
  return deeds;
}

/// The trace of the source program itself on the same machine; nothing if it ends with an alarm.
std::optional<trace::ControlTrace> traceOfSource(const std::string& text,
                                                 const char* preset = "dmu75") {
  machine::Machine machine(*machine::loadPreset(preset), 1);
  streaming::SimulatedLink link(machine);
  if (!link.uploadProgram("SOURCE.MPF", text, true) || !link.selectProgram("SOURCE.MPF") ||
      !link.cycleStart()) {
    qFatal("the source program does not start");
  }
  const base::Instant until = link.now() + std::chrono::minutes{30};
  while (machine.state().channel != machine::ChannelStatus::Reset && link.now() < until) {
    (void)link.wait(link.now() + std::chrono::milliseconds{100});
  }
  auto trace = link.fetchTrace();
  return trace && machine.state().alarm == 0 ? std::optional(std::move(*trace)) : std::nullopt;
}

QStringList motionsOfSource(const std::string& text) {
  const auto trace = traceOfSource(text);
  return trace ? motions(*trace) : QStringList();
}

/// From the first motion to the last.
double seconds(const trace::ControlTrace& trace) {
  return trace.blocks.empty() ? 0.0
                              : base::toSeconds(trace.blocks.back().to - trace.blocks.front().from);
}

/// A program drawn from a seed: motion, what switches, and modal state, in any order.
std::string drawProgram(std::uint64_t seed) {
  base::Random random(seed);
  const auto pick = [&random](std::initializer_list<const char*> from) {
    return std::string(*(from.begin() + random.below(from.size())));
  };
  const auto number = [&random] {
    return (random.below(2) == 0 ? "" : "-") + std::to_string(random.below(4)) + ".5";
  };
  std::string text = "G17 G90 G71 G94 F2000\nG0 X1 Y1 Z1\n";
  for (std::size_t block = 0; block < 40; ++block) {
    switch (random.below(10)) {
      case 0:
        text += pick({"M8", "M9", "S500 M3", "MSG(\"A\")", "G4 F0.02", "M5"}) + "\n";
        break;
      case 1:
        text += pick({"T1 M6", "D1", "G54", "SUPA G0 Z30", "M60"}) + "\n";
        break;
      case 2:
        text += pick({"G90", "G91", "G17", "G70", "G71", "DIAMON", "DIAMOF", "F1500", "TRANS X2 Y1",
                      "TRANS", "ATRANS Z1", "G64", "G60"}) +
                "\n";
        break;
      case 3:
        text += "G1 X" + number() + " M8\n";
        break;
      default:
        text += pick({"G0", "G1", ""}) + " " + pick({"X", "Y", "Z"}) + number() + "\n";
        break;
    }
  }
  return text + "M30\n";
}

const char* const kPart =
    "N10 G17 G90 G71\n"
    "T1 D1 M6\n"
    "S3000 M3\n"
    "G0 X5 Y5\n"
    "G0 Z2\n"
    "M8\n"
    "G1 Z-1 F400\n"
    "G1 X10\n"
    "Y10\n"
    "X5 Y12\n"
    "M9\n"
    "G0 Z5\n"
    "SUPA G0 Z20\n"
    "T2 M6\n"
    "MSG(\"SECOND TOOL\")\n"
    "G0 X1 Y1 Z17\n"
    "G91 G0 Z-3 M8\n"
    "G1 X2 F300\n"
    "G90 X0 Y0\n"
    "G4 F0.1\n"
    "G1 X3 Y3\n"
    "M5 M9\n"
    "M30\n";

/// Two tools, each with some seconds of streamed motion, and a dwell of half a minute between.
std::string longPart() {
  std::string text = "G17 G90 G71\n";
  for (const char* begin : {"T1 D1 M6\nS3000 M3\nM8\n", "G4 F30\nT2 M6\nS2000 M3\n"}) {
    text += begin;
    for (int i = 0; i <= 40; ++i) {
      text += fmt::format("G1 X{} Y{} F800\n", i, i % 2);
    }
    text += "M9\nM5\nG0 Z5\n";
  }
  return text + "M30\n";
}

const char* const kStops =
    "G17 G90 G71 G94\n"
    "G0 X1 Y1 Z5\n"
    "G1 X5 F1000\n"
    "M0\n"
    "G1 X9\n"
    "M30\n";

}  // namespace

class TestWholeJob : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The texts are those that a person at the control reads.
  void programs() {
    const auto programs = job::makePrograms(planOf("T1 M6\nG0 X1 Y1\nG91 TRANS X1\nM8\nM30\n"),
                                            settingsOf().parameters);
    QVERIFY2(programs.has_value(), programs ? "" : programs.error().text().c_str());
    // A client that finds it running knows it by its name, as the control shows it.
    const auto name = job::jobNameOf("/_N_WKS_DIR/_N_" + programs->mainName);
    QVERIFY(name);
    QCOMPARE(name->number, programs->number);
    QCOMPARE(name->baseCell, programs->loop.parameters.baseCell);
    QVERIFY(!job::jobNameOf(programs->loop.name) && !job::jobNameOf("RIVJOB_7.MPF"));
    QCOMPARE(
        templates::JobProtocol::jobOf(-templates::JobProtocol::callNumber(programs->number, 12)),
        programs->number);
    const QString text = QString::fromStdString(programs->mainText);
    const QString number = QString::number(programs->number);
    QVERIFY2(text.contains(QStringLiteral("T1 M6\n")), qPrintable(text));
    QVERIFY2(
        text.contains(QStringLiteral("%1(%2,1,RIV_RUN+1)\n")
                          .arg(QString::fromStdString(programs->loop.name).remove(".SPF"), number)),
        qPrintable(text));
    QVERIFY2(text.contains(
                 QStringLiteral("G710 DIAMOF\nTRANS X1\nG0 G17 G91 G710 DIAMOF G60 G94\nM8\n")),
             qPrintable(text));
    const auto findings = templates::lintProgram(programs->loop.text, programs->loop);
    QVERIFY2(findings.empty(), findings.empty() ? "" : findings.front().message.c_str());
  }

  void aStopOfTheProgramIsPassed() {
    machine::Machine machine(*machine::loadPreset("dmu75-mill"), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    const auto report =
        streaming::runWholeJob(link, link, planOf(kStops), settingsOf(), watcher, watcher);
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    QCOMPARE(watcher.programStops, 1);
    QCOMPARE(watcher.begun, (std::vector<int>{1, 2}));
  }

  /// The control listens to nobody there, but the job ends.
  void aStopOfTheProgramEndsWithStop() {
    machine::Machine machine(*machine::loadPreset("dmu75-mill"), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    watcher.pressesCycleStart = false;
    watcher.stopWhen = [&watcher](base::Instant) { return watcher.programStops > 0; };
    const auto report =
        streaming::runWholeJob(link, link, planOf(kStops), settingsOf(), watcher, watcher);
    QVERIFY2(report.outcome == Outcome::Stopped, report.error.text().c_str());
    QCOMPARE(watcher.begun, std::vector<int>{1});
    QVERIFY(machine.state().channel == machine::ChannelStatus::Reset);
  }

  void whole_data() {
    QTest::addColumn<int>("method");
    QTest::newRow("window") << static_cast<int>(base::MethodKind::Window);
    QTest::newRow("credit") << static_cast<int>(base::MethodKind::Credit);
  }

  /// The control moves where the source program moves, in the same order, each once.
  void whole() {
    QFETCH(const int, method);
    machine::Machine machine(*machine::loadPreset("dmu75"), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    const job::Plan plan = planOf(kPart);
    QVERIFY(plan.isWhole());
    const streaming::WholeJobReport report = streaming::runWholeJob(
        link, link, plan, settingsOf(static_cast<base::MethodKind>(method)), watcher, watcher);
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    QCOMPARE(report.stretches.size(), plan.stretchCount());
    QVERIFY(report.controlTrace != nullptr);
    QCOMPARE(motions(*report.controlTrace), motionsOfSource(kPart));
    QCOMPARE(motions(*report.controlTrace).size(), 13);
    QCOMPARE(watcher.begun, (std::vector<int>{1, 2, 3, 4, 5, 6}));
  }

  /// Whatever the size of its pieces, and however far samples and blocks are apart in them.
  void theTraceInPiecesSaysTheSame() {
    machine::Machine machine(*machine::loadPreset("dmu75-mill"), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    const job::Plan plan = planOf(longPart());
    const streaming::RunSettings settings = settingsOf();
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, plan, settings, watcher, watcher);
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    const templates::JobLoop loop = job::makePrograms(plan, settings.parameters)->loop;
    std::vector<gcode::StreamPoint> points;
    for (const streaming::StretchReport& stretch : report.stretches) {
      points.insert(points.end(), stretch.points.begin(), stretch.points.end());
    }
    const auto saidOf = [&](std::size_t recordsMax) {
      streaming::JobTrace trace(points, loop, nullptr);
      trace::TracePiece piece;
      do {
        piece = trace::cutPiece(*report.controlTrace, {1, 0, 0, 0}, trace.position(), recordsMax);
        trace.take(piece);
      } while (!piece.isLast);
      const streaming::TraceFindings found = trace.finish();
      QString said = QStringLiteral("%1 %2 %3;")
                         .arg(found.isWhole)
                         .arg(found.integrity.isFaultless())
                         .arg(found.integrity.executed);
      for (const trace::Pause& pause : found.pauses) {
        said += QStringLiteral(" %1+%2")
                    .arg(pause.start.time_since_epoch().count())
                    .arg(pause.duration.count());
      }
      for (const trace::ToolUse& use : trace.tools()) {
        said += QStringLiteral("; T%1 %2 %3 %4")
                    .arg(use.number.value_or(0))
                    .arg(use.inSpindle.count())
                    .arg(use.turning.count())
                    .arg(use.cooling.count());
      }
      return said;
    };
    const QString whole = saidOf(1'000'000);
    QVERIFY2(whole.startsWith(QStringLiteral("1 1 %1; ").arg(points.size())), qPrintable(whole));
    QVERIFY2(whole.contains(QStringLiteral("; T2 ")), qPrintable(whole));
    QVERIFY2(whole.count(QLatin1Char('+')) > 1, qPrintable(whole));
    QVERIFY(report.pauses.size() == static_cast<std::size_t>(whole.count(QLatin1Char('+'))));
    QCOMPARE(report.tools.size(), std::size_t{2});
    for (const std::size_t recordsMax : {1U, 7U, 100U}) {
      QCOMPARE(saidOf(recordsMax), whole);
    }
  }

  /// The memory of the control holds a small part of the job.
  void aJobLongerThanTheTraceOfTheControlIsJudged() {
    machine::MachineConfig config = *machine::loadPreset("dmu75-mill");
    config.traceLimit = std::chrono::seconds{15};
    machine::Machine machine(config, 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, planOf(longPart()), settingsOf(), watcher, watcher);
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    QVERIFY(report.integrity.isFaultless());
    QVERIFY(!report.controlTrace->truncated && seconds(*report.controlTrace) > 40.0);
    QCOMPARE(report.tools.size(), std::size_t{2});
    QVERIFY(machine.trace().truncated);
  }

  /// One recording of the whole job, in which its streamed points are judged like those of a run.
  void isRecordedAndJudged() {
    machine::Machine machine(*machine::loadPreset("dmu75-mill"), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    std::string text;
    trace::RecordingWriter writer([&text](std::string_view lines) {
      text += lines;
      return true;
    });
    streaming::WholeJobOptions options;
    options.writer = &writer;
    options.start.endpoint = "here";
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, planOf(kPart), settingsOf(), watcher, watcher, options);
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    std::size_t points = 0;
    for (const streaming::StretchReport& stretch : report.stretches) {
      points += stretch.points.size();
    }
    QVERIFY(report.integrity.isFaultless());
    QCOMPARE(report.integrity.executed, points);
    QVERIFY(report.access.requests > 0);
    const auto recording = trace::parseRecording(text);
    QVERIFY2(recording.has_value(), recording ? "" : recording.error().text().c_str());
    QVERIFY(recording->complete && recording->pointsComplete);
    QCOMPARE(recording->unreadableLines, std::size_t{0});
    QCOMPARE(recording->start.runNumber, report.runNumber);
    QCOMPARE(recording->points.points.size(), points);
    QVERIFY(trace::judgeRun(recording->points.points, *recording->controlTrace, {}).isFaultless());
    const auto has = [&](std::string_view part) {
      return std::any_of(recording->notes.begin(), recording->notes.end(),
                         [part](const trace::Note& note) { return note.text == part; });
    };
    QVERIFY(has("stretch 2 begins, 1 points") || has("stretch 2 begins, 2 points") ||
            has("stretch 2 begins, 4 points"));
    QVERIFY(has("the control executes line 14: T2 M6"));
    // A point that was left out, and one that is elsewhere, are found.
    trace::ControlTrace wrong = *recording->controlTrace;
    const auto moving = [&wrong] {
      return std::find_if(wrong.blocks.rbegin(), wrong.blocks.rend(),
                          [](const trace::ExecutedBlock& block) { return block.lengthMm > 1.0; });
    };
    moving()->targetMm.x += 1.0;
    QCOMPARE(trace::judgeRun(recording->points.points, wrong, {}).foreign, std::size_t{1});
  }

  /// After a long way the axes still settle when a stretch begins with an axis that it does not
  /// name: what is judged are the points that were streamed.
  void axesThatSettleAreNoWrongMotion() {
    for (int wayMm = 40; wayMm < 340; wayMm += 20) {
      machine::Machine machine(*machine::loadPreset("dmu75-mill"), 1);
      streaming::SimulatedLink link(machine);
      Watcher watcher;
      const std::string way = "SUPA G0 X" + std::to_string(wayMm);
      const job::Plan plan =
          planOf("G17 G90 G71\nG0 X0 Y0 Z20\nG1 X1 F3000\n" + way + " Y30 M8\nG0 Z10\nM9\nM30\n");
      QVERIFY(plan.stretchCount() == 2 && plan.isWhole());
      const streaming::WholeJobReport report =
          streaming::runWholeJob(link, link, plan, settingsOf(), watcher, watcher);
      QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
      QVERIFY2(report.integrity.isFaultless(), way.c_str());
    }
  }

  /// The trace of a control names lines alone: of all blocks in lines in which the loop moves, none
  /// is one of the main program.
  void theMainProgramMovesInLinesOfItsOwn() {
    std::string text = "G90\n";
    for (int i = 0; i < 60; ++i) {
      text += "G0 X" + std::to_string(i) + " M8\n";
    }
    const auto programs =
        job::makePrograms(planOf(text + "G1 X5 F500\nM30\n"), settingsOf().parameters);
    QVERIFY2(programs.has_value(), programs ? "" : programs.error().text().c_str());
    const QStringList main = QString::fromStdString(programs->mainText).split(QLatin1Char('\n'));
    const QStringList loop = QString::fromStdString(programs->loop.text).split(QLatin1Char('\n'));
    QVERIFY(!programs->loop.motionLines.empty());
    QVERIFY(static_cast<std::uint32_t>(main.size()) > programs->loop.motionLines.back());
    for (const std::uint32_t line : programs->loop.motionLines) {
      QVERIFY(loop[static_cast<int>(line) - 1].startsWith(QStringLiteral("G1 ")));
      QVERIFY2(!main[static_cast<int>(line) - 1].contains(QStringLiteral("G0 X")),
               qPrintable(main[static_cast<int>(line) - 1]));
    }
    QVERIFY(
        loop[static_cast<int>(programs->loop.handoverLine) - 1].startsWith(QStringLiteral("G4 ")));
  }

  /// Tools with lengths, work offsets, radius compensation and drilling cycles are the machine's:
  /// what is streamed between them lands in the same place.
  void partOnAMill() {
    const char* const text =
        "N10 G17 G90 G71 G54\n"
        "T2 M6\n"
        "D1\n"
        "S3000 M3\n"
        "M8\n"
        "G0 X0 Y0\n"
        "G0 Z50\n"
        "G0 Z5\n"
        "G1 Z-2 F2000\n"
        "G41 X20 Y0\n"
        "X60\n"
        "Y40\n"
        "G40 X90 Y60\n"
        "G0 Z50\n"
        "X0 Y0\n"
        "SUPA G0 Z200 D0\n"
        "T7 M6\n"
        "D1\n"
        "G55\n"
        "S1000 M3\n"
        "G0 X10 Y10\n"
        "G0 Z10\n"
        "MCALL CYCLE81(10,0,2,-5)\n"
        "X10 Y10\n"
        "X30\n"
        "MCALL\n"
        "G0 Z50\n"
        "G0 X0 Y0\n"
        "M5 M9\n"
        "M30\n";
    const auto source = traceOfSource(text, "dmu75-mill");
    QVERIFY(source.has_value());
    machine::Machine machine(*machine::loadPreset("dmu75-mill"), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    streaming::RunSettings settings = settingsOf();
    settings.feedMmPerS = 100.0;
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, planOf(text), settings, watcher, watcher);
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    QCOMPARE(motions(*report.controlTrace), motions(*source));
    QCOMPARE(deeds(*report.controlTrace), deeds(*source));
    QVERIFY(deeds(*source).size() >= motions(*source).size() + 12);
    QVERIFY(report.stretches.size() >= 4);
  }

  /// Programs drawn at random: the same motion as the source, whatever modal state the native
  /// blocks need.
  void drawnPrograms_data() {
    QTest::addColumn<QByteArray>("preset");
    QTest::newRow("dmu75") << QByteArray("dmu75");
    QTest::newRow("mill") << QByteArray("dmu75-mill");
  }

  void drawnPrograms() {
    QFETCH(const QByteArray, preset);
    int jobs = 0;
    std::size_t natives = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      const std::string text = drawProgram(seed);
      const job::Plan plan = planOf(text);
      streaming::RunSettings settings = settingsOf();
      settings.feedMmPerS = 100.0;
      if (!job::makePrograms(plan, settings.parameters)) {
        continue;
      }
      const auto source = traceOfSource(text, preset.constData());
      if (!source || motions(*source).isEmpty()) {
        continue;  // it leaves the working area
      }
      machine::Machine machine(*machine::loadPreset(preset.constData()), seed);
      streaming::SimulatedLink link(machine);
      Watcher watcher;
      const streaming::WholeJobReport report =
          streaming::runWholeJob(link, link, plan, settings, watcher, watcher);
      QVERIFY2(report.outcome == Outcome::Completed,
               qPrintable(QStringLiteral("seed %1: %2")
                              .arg(seed)
                              .arg(QString::fromStdString(report.error.text()))));
      if (deeds(*report.controlTrace) != deeds(*source)) {
        qInfo("%s", text.c_str());
        qInfo("%s", job::makePrograms(plan, settings.parameters)->mainText.c_str());
      }
      QCOMPARE(deeds(*report.controlTrace), deeds(*source));
      ++jobs;
      natives += plan.nativeCount();
    }
    qInfo("%d jobs, %zu native blocks", jobs, natives);
    QVERIFY(jobs > 20);
  }

  /// Delayed, lost and repeated requests, broken connections: a job may fail, but what the machine
  /// has moved is always the beginning of what the source moves.
  void drawnFaults() {
    int completed = 0;
    int failed = 0;
    int held = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
      const std::string text = drawProgram(seed % 50 + 1);
      const job::Plan plan = planOf(text);
      streaming::RunSettings settings = settingsOf();
      settings.feedMmPerS = 100.0;
      const QStringList source = motionsOfSource(text);
      if (source.isEmpty() || !job::makePrograms(plan, settings.parameters)) {
        continue;
      }
      machine::Machine machine(*machine::loadPreset("dmu75"), seed);
      streaming::LinkFaults faults;
      faults.delayProbability = 0.1;
      faults.delayMax = std::chrono::milliseconds{500};
      faults.lostRequestProbability = seed % 3 == 0 ? 0.0 : 0.002;
      faults.lostAnswerProbability = seed % 3 == 0 ? 0.0 : 0.002;
      faults.stallProbability = 0.01;
      faults.stallMax = std::chrono::seconds{2};
      faults.disconnectProbability = seed % 3 == 1 ? 0.001 : 0.0;
      faults.strayMax = std::chrono::seconds{5};
      streaming::FaultyLink link(machine, faults, seed);
      Watcher watcher;
      const streaming::WholeJobReport report =
          streaming::runWholeJob(link, link, plan, settings, watcher, watcher);
      (report.outcome == Outcome::Completed ? completed : failed) += 1;
      // Without a client the machine comes to its end by itself, or stands where it is until
      // somebody ends the job.
      streaming::SimulatedLink observer(machine);
      const base::Instant until = observer.now() + std::chrono::minutes{2};
      while (machine.state().channel != machine::ChannelStatus::Reset && observer.now() < until) {
        (void)observer.wait(observer.now() + std::chrono::milliseconds{100});
      }
      if (machine.state().channel != machine::ChannelStatus::Reset) {
        const base::Vec3 stood = machine.state().commandMm;
        (void)observer.wait(observer.now() + std::chrono::seconds{10});
        QCOMPARE(base::distance(machine.state().commandMm, stood), 0.0);
        const auto left = streaming::findRun(observer, observer, 0, std::chrono::seconds{3});
        QVERIFY2(left && *left, qPrintable(QString::number(seed)));
        const auto ended = streaming::endRun(observer, **left, settings);
        QVERIFY2(ended, ended ? "" : ended.error().text().c_str());
        ++held;
      }
      QCOMPARE(machine.state().channel, machine::ChannelStatus::Reset);
      const auto trace = observer.fetchTrace();
      QVERIFY(trace.has_value());
      const QStringList moved = motions(*trace);
      QVERIFY2(moved == source.mid(0, moved.size()),
               qPrintable(
                   QStringLiteral("seed %1: %2").arg(seed).arg(moved.join(QStringLiteral(", ")))));
      QVERIFY2(report.outcome != Outcome::Completed || moved.size() == source.size(),
               qPrintable(QString::number(seed)));
    }
    qInfo("%d completed, %d failed, %d held without their client", completed, failed, held);
    QVERIFY(completed > 20 && failed > 20 && held > 0);
  }

  /// Programs of a SINUMERIK written elsewhere, as a job and as they are: each end of a block of
  /// the source is reached, in order; what lies between are the chords of arcs.
  void programsOfOthers() {
    const QString corpus = QStringLiteral(RIVULET_SOURCE_DIR "/../shared/corpus/");
    QFile index(corpus + QStringLiteral("INDEX.tsv"));
    if (!index.open(QIODevice::ReadOnly)) {
      QSKIP("the collection of foreign NC programs is not beside this checkout");
    }
    int compared = 0;
    double sourceS = 0.0;
    double jobS = 0.0;
    for (const QString& line : QString::fromUtf8(index.readAll()).split(QLatin1Char('\n'))) {
      const QString path = line.section(QLatin1Char('\t'), 0, 0);
      QFile file(corpus + path);
      if (!line.contains(QStringLiteral("sinumerik-8")) || !file.open(QIODevice::ReadOnly)) {
        continue;
      }
      const std::string text = file.readAll().toStdString();
      const job::Plan plan = planOf(text);
      streaming::RunSettings settings = settingsOf();
      settings.programFeeds = gcode::ProgramFeeds{};
      settings.programFeeds->rapidMmPerS = 500.0;
      settings.programFeeds->feedMmPerSMax = 500.0;
      settings.feedMmPerS = 500.0;
      settings.parameters.feedPerPoint = true;
      if (plan.stretchCount() == 0 || !job::makePrograms(plan, settings.parameters) ||
          !streaming::requireFeeds(plan.program.trajectory, settings)) {
        continue;
      }
      const auto source = traceOfSource(text);
      if (!source || source->truncated || motions(*source).isEmpty()) {
        continue;
      }
      machine::Machine machine(*machine::loadPreset("dmu75"), 1);
      streaming::SimulatedLink link(machine);
      tests::WholeTraceLink whole(link);
      TraceWatcher watcher(machine);
      const streaming::WholeJobReport report =
          streaming::runWholeJob(whole, link, plan, settings, watcher, watcher);
      QVERIFY2(
          report.outcome == Outcome::Completed,
          qPrintable(path + QStringLiteral(": ") + QString::fromStdString(report.error.text())));
      const QStringList moved = motions(watcher.whole);
      qsizetype at = 0;
      for (const QString& end : motions(*source)) {
        at = moved.indexOf(end, at) + 1;
        QVERIFY2(at > 0, qPrintable(path + QStringLiteral(": ") + end));
      }
      qInfo("%-45s %8.1f s as it is, %8.1f s as a job of %zu stretches", qPrintable(path),
            seconds(*source), seconds(watcher.whole), plan.stretchCount());
      ++compared;
      sourceS += seconds(*source);
      jobS += seconds(watcher.whole);
    }
    qInfo("%d programs: %.1f s as they are, %.1f s as jobs", compared, sourceS, jobS);
    QVERIFY(compared >= 5);
  }

  /// Stop in a stretch: the axes stand after the window, and no native block follows.
  void stopInAStretch() {
    machine::Machine machine(*machine::loadPreset("dmu75"), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    watcher.stopWhen = [&](base::Instant) { return watcher.begun.size() == 2; };
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, planOf(kPart), settingsOf(), watcher, watcher);
    QVERIFY2(report.outcome == Outcome::Stopped, report.error.text().c_str());
    QVERIFY(report.stretches.size() == 2);
    QCOMPARE(machine.state().channel, machine::ChannelStatus::Reset);
    // Nothing after the stretch: the retract to Z 20 was not made.
    QVERIFY(!motions(*report.controlTrace).contains(QStringLiteral("X5 Y12 Z20")));
  }

  /// Stop before the first window of a stretch: what the control has executed of its own is no
  /// wrong motion, for the job as for its recording, which holds only blocks that were streamed.
  void stopBeforeAnythingIsStreamed() {
    machine::Machine machine(*machine::loadPreset("dmu75"), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    watcher.stopWhen = [&](base::Instant) { return watcher.begun.size() == 1; };
    std::string text;
    trace::RecordingWriter writer([&text](std::string_view lines) {
      text += lines;
      return true;
    });
    streaming::WholeJobOptions options;
    options.writer = &writer;
    const streaming::WholeJobReport report = streaming::runWholeJob(
        link, link, planOf("SUPA G0 Z150\nG0 X50 Y50 Z20\nG1 Z-1 F500\nX80\nM30\n"), settingsOf(),
        watcher, watcher, options);
    QVERIFY2(report.outcome == Outcome::Stopped, report.error.text().c_str());
    QVERIFY(!motions(*report.controlTrace).isEmpty());
    QVERIFY(report.integrity.judged && report.integrity.isFaultless());
    QCOMPARE(report.integrity.executed, std::size_t{0});
    const auto recording = trace::parseRecording(text);
    QVERIFY2(recording.has_value(), recording ? "" : recording.error().text().c_str());
    QVERIFY(recording->controlTrace->blocks.empty());
    QVERIFY(trace::judgeRun(recording->points.points, *recording->controlTrace, {}).isFaultless());
  }

  /// Once a program has ended, positions are told without its tool length and offset: that is no
  /// wrong motion, and no changed frame.
  void theEndOfTheProgramIsNoWrongMotion_data() {
    QTest::addColumn<bool>("isReset");
    QTest::newRow("stop") << false;
    QTest::newRow("reset at the control") << true;
  }
  void theEndOfTheProgramIsNoWrongMotion() {
    QFETCH(const bool, isReset);
    int stopped = 0;
    for (int moment = 1; moment <= 60; ++moment) {
      machine::Machine machine(*machine::loadPreset("dmu75-mill"), 1);
      streaming::SimulatedLink link(machine);
      Watcher watcher;
      const base::Instant at = link.now() + std::chrono::milliseconds{301 * moment};
      bool wasReset = false;
      watcher.stopWhen = [&](base::Instant now) {
        if (isReset && now >= at && !wasReset) {
          wasReset = true;
          machine.reset();
        }
        return !isReset && now >= at;
      };
      const streaming::WholeJobReport report =
          streaming::runWholeJob(link, link, planOf(kPart), settingsOf(), watcher, watcher);
      const std::string name = std::to_string(moment) + ": ";
      stopped += report.outcome == Outcome::Completed ? 0 : 1;
      QVERIFY2(report.error.code != job::JobError::PositionDiffers,
               (name + report.error.text()).c_str());
      for (const streaming::StretchReport& stretch : report.stretches) {
        QVERIFY2(!stretch.run.wrong,
                 stretch.run.wrong ? (name + streaming::describe(*stretch.run.wrong)).c_str() : "");
      }
    }
    QVERIFY(stopped > 30);
  }

  /// Stop while the control executes native blocks: it ends before the next one.
  void stopInNativeBlocks() {
    const char* const text = "G0 X1 Y1 Z1\nG4 F2\nG4 F2\nM8\nG0 X9\nM30\n";
    machine::Machine machine(*machine::loadPreset("dmu75"), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    std::optional<base::Instant> since;
    watcher.stopWhen = [&](base::Instant now) {
      if (watcher.inNative && watcher.nativeBefore == 2) {
        since = since.value_or(now);
      }
      return since && now - *since > std::chrono::seconds{1};
    };
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, planOf(text), settingsOf(), watcher, watcher);
    QVERIFY2(report.outcome == Outcome::Stopped, report.error.text().c_str());
    QCOMPARE(watcher.begun, (std::vector<int>{1}));
    QVERIFY(since && link.now() - *since < std::chrono::seconds{3});
    QCOMPARE(machine.state().channel, machine::ChannelStatus::Reset);
  }

  /// Hold while the control executes native blocks: it waits before the next one, then goes on.
  void holdInNativeBlocks() {
    const char* const text = "G0 X1 Y1 Z1\nG4 F1\nM8\nG0 X9\nM30\n";
    machine::Machine machine(*machine::loadPreset("dmu75"), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    std::optional<base::Instant> since;
    watcher.holdWhen = [&](base::Instant now) {
      if (watcher.inNative && watcher.nativeBefore == 2) {
        since = since.value_or(now);
      }
      return since && now - *since < std::chrono::seconds{20};
    };
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, planOf(text), settingsOf(), watcher, watcher);
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    QCOMPARE(motions(*report.controlTrace), motionsOfSource(text));
    QVERIFY(since && link.now() - *since > std::chrono::seconds{20});
    QVERIFY(std::count(watcher.events.begin(), watcher.events.end(), "holding") > 0);
  }

  void stopBeforeTheStart() {
    machine::Machine machine(*machine::loadPreset("dmu75"), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    watcher.stopWhen = [](base::Instant) { return true; };
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, planOf(kPart), settingsOf(), watcher, watcher);
    QVERIFY2(report.outcome == Outcome::Stopped, report.error.text().c_str());
    QVERIFY(report.stretches.empty());
    QVERIFY(motions(*report.controlTrace).empty());
  }

  /// A program that the control runs already is left alone.
  void busyControl() {
    machine::Machine machine(*machine::loadPreset("dmu75"), 1);
    streaming::SimulatedLink link(machine);
    QVERIFY(link.uploadProgram("A.MPF", "G4 F1000\nM30\n", true));
    QVERIFY(link.selectProgram("A.MPF"));
    QVERIFY(link.cycleStart());
    (void)link.wait(link.now() + std::chrono::seconds{1});
    Watcher watcher;
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, planOf(kPart), settingsOf(), watcher, watcher);
    QVERIFY(report.outcome == Outcome::Failed);
    QVERIFY(report.error.code == streaming::StreamError::ChannelBusy);
  }

  /// A native block that the control refuses ends the job with its alarm.
  void alarmInANativeBlock() {
    machine::Machine machine(*machine::loadPreset("dmu75"), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, planOf("G0 X1 Y1 Z1\nM8\nNOT_THERE\nG0 X2\nM30\n"),
                               settingsOf(), watcher, watcher);
    QVERIFY(report.outcome == Outcome::Failed);
    QVERIFY2(report.error.code == streaming::StreamError::ControlAlarm,
             report.error.text().c_str());
    QVERIFY2(report.error.text().find("line 3 of PART.MPF: NOT_THERE") != std::string::npos,
             report.error.text().c_str());
    QCOMPARE(watcher.begun, (std::vector<int>{1}));
  }

  /// A block for the control between the two sides of a corner: the axes stand there, and the path
  /// is that of the source.
  void nativeBlockInACorner() {
    const char* const text =
        "G64 G0 X1 Y1 Z1\nG1 X10 F3000\nSUPA G0 Z20\nG1 Y10\nX1\nG4 F0.1\nY1\nM30\n";
    machine::Machine machine(*machine::loadPreset("dmu75"), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, planOf(text), settingsOf(), watcher, watcher);
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    QCOMPARE(motions(*report.controlTrace), motionsOfSource(text));
  }

  /// The same for the last native block before a stretch.
  void alarmBeforeAStretch() {
    machine::Machine machine(*machine::loadPreset("dmu75"), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    const streaming::WholeJobReport report = streaming::runWholeJob(
        link, link, planOf("G0 X1 Y1 Z1\nG4 F1\nSUPA G0 Z500\nG0 X2 Z1\nM30\n"), settingsOf(),
        watcher, watcher);
    QVERIFY(report.outcome == Outcome::Failed);
    QVERIFY2(report.error.text().find("line 3 of PART.MPF: SUPA G0 Z500") != std::string::npos,
             report.error.text().c_str());
    QCOMPARE(watcher.begun, (std::vector<int>{1}));
  }

  /// If the control has another frame than the program, the job stops before the next point.
  void anotherFrame() {
    machine::Machine machine(*machine::loadPreset("dmu75"), 1);
    streaming::SimulatedLink link(machine);
    // The plan expects the tool where the program left it, as with a shift that nobody knows of.
    job::Plan plan = planOf("G0 X1 Y1 Z1\nM8\nG0 X2\nM30\n");
    for (job::Part& part : plan.parts) {
      auto* const stretch = std::get_if<job::Stretch>(&part);
      if (stretch != nullptr && stretch->number == 2) {
        stretch->startMm.set(2, 5.0);
      }
    }
    Watcher watcher;
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, plan, settingsOf(), watcher, watcher);
    QVERIFY(report.outcome == Outcome::Failed);
    QVERIFY2(report.error.code == job::JobError::PositionDiffers, report.error.text().c_str());
    QCOMPARE(motions(*report.controlTrace), QStringList{QStringLiteral("X1 Y1 Z1")});
  }

  void refusals() {
    const templates::TemplateParameters parameters = settingsOf().parameters;
    const auto code = [&](const char* text) {
      return job::makePrograms(planOf(text), parameters).error().code;
    };
    QVERIFY(code("G999\nM8\nG0 X1\n") == job::JobError::NotWhole);
    QVERIFY(code("R1=5\nOWN(R1)\nG0 X1\n") == job::JobError::ReadsVariables);
    QVERIFY(job::makePrograms(planOf("G0 X1 Y1 Z1\nG18\nG0 X2\n"), parameters).has_value());
    QVERIFY(code("T1 M6\nG0 X1\nG91 Z1 M8\n") == job::JobError::IncrementInFrame);
    QVERIFY(code("G0 X1 Y1 Z1\nTRANS X5\nG1 X1 F100\nG91 X1 M8\n") ==
            job::JobError::IncrementInFrame);
    templates::TemplateParameters position = parameters;
    position.method = base::MethodKind::Position;
    QVERIFY(!job::makePrograms(planOf("M8\nG0 X1\n"), position));
  }
};

RIVULET_TEST(TestWholeJob)
#include "tst_whole_job.moc"
