// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gui/widgets/samples.h"

#include <algorithm>
#include <cmath>

#include "alarm/alarm_list.h"
#include "base/contract.h"
#include "base/units.h"
#include "machine/machine.h"
#include "opcua/error.h"
#include "streaming/simulation/simulated_link.h"

namespace rivulet::test {

namespace {

gcode::Program interpreted(const std::string& name, std::string text) {
  auto program = gcode::interpretProgram(name, std::move(text));
  RIVULET_ASSERT(program.has_value());
  return *std::move(program);
}

std::string number(double value) {
  // Locale-free: the tests switch languages.
  const long thousandths = std::lround(value * 1000.0);
  const long size = std::labs(thousandths);
  std::string digits = std::to_string(size % 1000);
  digits.insert(0, 3 - digits.size(), '0');
  return (thousandths < 0 ? "-" : "") + std::to_string(size / 1000) + "." + digits;
}

}  // namespace

std::string pocketText() {
  std::string text =
      "; pocket 60 x 40\nG17 G90 G71\nT1 M6\nS8000 M3\nG0 X0 Y0 Z5\nG1 Z-2 F250\nF500\n";
  for (double r = 0.5; r < 14.0; r += 0.5) {
    for (int step = 0; step < 48; ++step) {
      const double angle = 2.0 * M_PI * step / 48.0;
      const double radius = r + 0.5 * step / 48.0;
      text +=
          "X" + number(radius * std::cos(angle)) + " Y" + number(radius * std::sin(angle)) + "\n";
    }
  }
  text +=
      "G0 Z5\nX-30 Y-20\nG1 Z-2 F250\nX20 F800\nG3 X30 Y-10 CR=10\nG1 Y10\nG3 X20 Y20 CR=10\n"
      "G1 X-30\nY-20\nG0 Z5\nM30\n";
  return text;
}

std::shared_ptr<const gcode::Program> programFrom(const std::string& name,
                                                  const std::string& text) {
  return std::make_shared<const gcode::Program>(interpreted(name, text));
}

std::shared_ptr<const gcode::Program> pocket() {
  return programFrom("POCKET_60x40.MPF", pocketText());
}

std::shared_ptr<const gcode::Program> brokenProgram() {
  return programFrom("BROKEN.MPF",
                     "G0 X0 Y0 Z5\nG1 X10 F500\nG87 X20\nG1 X=R1+3\nG1 X30 Y\nM8\nG1 X40 Y10\n");
}

std::vector<gcode::StreamPoint> streamed(const gcode::Program& program) {
  return gcode::streamPoints(program.trajectory, {0.0, 0.0, 0.0}).points;
}

std::shared_ptr<const overview::ProgramView> viewOf(
    const std::shared_ptr<const gcode::Program>& program) {
  return overview::makeProgramView(program, {0.0, 0.0, 0.0}, 7);
}

std::string jobText() {
  return "; slot and holes\n"  // 1
         "G17 G90 G71\n"
         "T1 M6\n"
         "S8000 M3\n"
         "G0 X0 Y0 Z5\n"  // 5: stretch 1
         "G1 Z-2 F250\n"
         "X40 F500\n"
         "Y10\n"
         "G0 Z5\n"
         "G0 X60 Y30 M8\n"  // 10: the control moves there
         "G1 Z-2 F250\n"    // stretch 2
         "G3 X80 Y30 CR=10 F500\n"
         "G0 Z5\n"
         "M9\n"
         "SUPA G0 Z0 D0\n"  // 15
         "T2 M6\n"
         "S2000 M3\n"
         "G0 X10 Y30 Z5\n"  // stretch 3
         "F100\n"
         "MCALL CYCLE81(5,0,1,-8)\n"  // 20
         "X10 Y30\n"
         "X25 Y30\n"
         "MCALL\n"
         "M5\n"
         "M30\n";  // 25
}

std::shared_ptr<const overview::ProgramView> jobView() {
  auto made = job::makePlan("SLOT.MPF", jobText());
  RIVULET_ASSERT(made.has_value() && made->isWhole());
  const auto plan = std::make_shared<const job::Plan>(*std::move(made));
  const std::shared_ptr<const gcode::Program> program(plan, &plan->program);
  return overview::makeProgramView(program, {0.0, 0.0, 0.0}, 7, {}, {}, plan);
}

std::shared_ptr<const gcode::Program> programOf(const std::vector<gcode::StreamPoint>& points) {
  auto program = std::make_shared<gcode::Program>();
  program->name = "POINTS.MPF";
  for (const gcode::StreamPoint& point : points) {
    gcode::TrajectoryPoint end;
    end.positionMm = point.positionMm;
    end.line = point.line;
    program->trajectory.points.push_back(end);
    program->text += "X" + number(point.positionMm.x) + " Y" + number(point.positionMm.y) + " Z" +
                     number(point.positionMm.z) + "\n";
  }
  program->statistics.lines = points.size();
  program->statistics.points = points.size();
  return program;
}

std::shared_ptr<const overview::ProgramTimes> timesOf(const overview::ProgramView& view) {
  auto times = std::make_shared<overview::ProgramTimes>();
  for (std::size_t i = 0; i < view.points.points.size(); ++i) {
    times->atS.push_back(0.1F * static_cast<float>(i));
  }
  times->programmedS = times->atS.back();
  times->run = overview::RunTime{{}, 2.0 * times->programmedS, 12.5, 39};
  times->machine = "dmu75";
  return times;
}

std::vector<gcode::StreamPoint> manyPoints(std::size_t points) {
  std::vector<gcode::StreamPoint> list;
  list.reserve(points);
  for (std::size_t index = 0; index < points; ++index) {
    const double along = static_cast<double>(index);
    const double radius = 50.0 * along / static_cast<double>(points);
    list.push_back({{radius * std::cos(along * 0.05), radius * std::sin(along * 0.05), 0.0},
                    base::LineNumber{static_cast<std::uint32_t>(index + 1)}});
  }
  return list;
}

widgets::MachineView runningMachine() {
  widgets::MachineView machine;
  machine.channelStatus = 1;
  machine.programStatus = 3;
  machine.programName = QStringLiteral("RIVULET_SIGNAL_7.MPF");
  machine.alarmNumber = 0;
  machine.message = QStringLiteral("RIVULET: window 12");
  machine.positionMm = base::Vec3{-12.3456, 105.0, -2.0};
  machine.feedMmPerS = base::mmPerSFromMmPerMin(500.0);
  machine.isVirtualMachine = true;
  machine.positionAgeS = machine.feedAgeS = machine.stateAgeS = 0.1;
  return machine;
}

widgets::FeasibilityModel feasibilityModel(base::MethodKind method, double feedMmPerMin) {
  widgets::FeasibilityModel model;
  model.operatingPoint.method = method;
  model.operatingPoint.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  const auto points = streamed(*pocket());
  model.distances = feasibility::programDistances(points, model.operatingPoint.pointsPerLoop);
  for (std::size_t index = 1; index < points.size(); ++index) {
    model.smallestDistancesMm.push_back(
        base::distance(points[index - 1].positionMm, points[index].positionMm));
  }
  std::sort(model.smallestDistancesMm.begin(), model.smallestDistancesMm.end());
  model.smallestDistancesMm.resize(std::min<std::size_t>(model.smallestDistancesMm.size(), 200));
  model.pointsPerLoopMax = 29;
  model.verdict = *feasibility::judge(model.operatingPoint, model.distances);
  return model;
}

streaming::CreditTest creditTest(bool passed) {
  streaming::CreditTest test;
  test.endpoint = "opc.tcp://127.0.0.1:4840";
  test.server = {"urn:maker:control", "SINUMERIK OPC UA", "3.2 SP1", "117"};
  test.testedAtUtc = "2026-05-04T09:30:00Z";
  test.result.checks = {{"answers-while-busy", passed,
                         passed ? "40 of 40 numbers came back." : "3 of 40 numbers came back."},
                        {"main-run-seen-by-client", true, "Seen."},
                        {"main-run-seen-by-program", true, "Seen."},
                        {"action-with-its-block", true, "Seen."},
                        {"buffer-level", true, "Seen."}};
  test.result.asked = 40;
  test.result.answered = passed ? 40 : 3;
  test.result.slowestAnswer = std::chrono::milliseconds{37};
  return test;
}

std::vector<feasibility::Advice> advice(const widgets::FeasibilityModel& model) {
  feasibility::AdviceQuestion question;
  question.operatingPoint = model.operatingPoint;
  question.pointsPerLoopMax = model.pointsPerLoopMax;
  question.methods = {base::MethodKind::Window, base::MethodKind::Position,
                      base::MethodKind::Signal};
  return feasibility::advise(streamed(*pocket()), question);
}

widgets::SimulatedRegion simulatedRegion(const widgets::FeasibilityModel& model,
                                         const widgets::SimulationWanted& wanted,
                                         double limitMmPerMin) {
  widgets::SimulatedRegion region;
  region.axis = wanted.axis;
  region.operatingPoint = model.operatingPoint;
  region.programPoints = 200;
  const double limit = base::mmPerSFromMmPerMin(limitMmPerMin);
  for (const double abscissa : wanted.abscissas) {
    const double here = limit * std::sqrt(abscissa / wanted.abscissas.back());
    for (const double feed : wanted.feedsMmPerS) {
      const std::size_t failures = feed < 0.9 * here ? 0 : feed < 1.3 * here ? 2 : 4;
      region.points.push_back({abscissa, feed, 4, failures});
    }
    region.band.push_back({abscissa, 0.85 * here, 1.1 * here});
  }
  return region;
}

std::shared_ptr<const trace::ControlTrace> controlTrace(double pauseEveryS) {
  auto trace = std::make_shared<trace::ControlTrace>();
  trace->cycle = std::chrono::milliseconds{4};
  const double feed = base::mmPerSFromMmPerMin(500.0);
  double sincePause = 0.0;
  double angle = 0.0;
  for (int cycle = 0; cycle < 5000; ++cycle) {
    sincePause += 0.004;
    const double pause = sincePause - pauseEveryS;
    const double speed = pause > 0.0 ? 0.0 : feed * std::min(1.0, sincePause / 0.02);
    if (pause > 0.041) {
      sincePause = 0.0;
    }
    angle += speed * 0.004 / 10.0;
    trace::ControlSample sample;
    sample.at = base::Instant{std::chrono::milliseconds{1000 + 4 * cycle}};
    sample.commandMm = {10.0 * std::cos(angle), 10.0 * std::sin(angle), -2.0};
    sample.actualMm = sample.commandMm;
    sample.feedMmPerS = speed;
    trace->samples.push_back(sample);
  }
  return trace;
}

std::shared_ptr<const trace::ShownTrace> shownTrace(const trace::ControlTrace& trace,
                                                    const std::string& name,
                                                    const gcode::Program* program) {
  const trace::Trace of(trace);
  trace::ShownTrace shown = trace::makeShownTrace(of, trace::analyseTrace(of, {program}));
  shown.name = name;
  return std::make_shared<const trace::ShownTrace>(std::move(shown));
}

std::vector<trace::Pause> pausesOf(const trace::ControlTrace& trace) {
  std::vector<trace::Pause> pauses;
  bool stands = false;
  for (const trace::ControlSample& sample : trace.samples) {
    const bool standsNow = sample.feedMmPerS <= 0.0;
    if (standsNow && !stands) {
      pauses.push_back({sample.at, {}, trace::PauseOrigin::Measured});
    }
    if (stands) {
      pauses.back().duration = sample.at - pauses.back().start;
    }
    stands = standsNow;
  }
  return pauses;
}

streaming::RunReport report() {
  streaming::RunReport report;
  report.outcome = streaming::Outcome::Completed;
  report.counters = {1353, 1353, 1353, 1353};
  report.integrity.judged = true;
  report.integrity.executed = 1353;
  const auto trace = controlTrace(0.9);
  report.pauses = pausesOf(*trace);
  report.duration = std::chrono::milliseconds{184'320};
  report.access.requests = 5412;
  report.access.nodes = 9021;
  report.access.perNode.count = 9021;
  report.access.perNode.mean = std::chrono::microseconds{4310};
  report.access.perNode.p50 = std::chrono::microseconds{4280};
  report.access.perNode.p95 = std::chrono::microseconds{5130};
  report.access.perNode.p99 = std::chrono::microseconds{6900};
  report.access.perNode.max = std::chrono::microseconds{12'040};
  report.programName = "POCKET_60x40.MPF";
  report.settings.feedMmPerS = base::mmPerSFromMmPerMin(500.0);
  return report;
}

std::vector<alarm::Alarm> alarms() {
  constexpr base::UtcMs kAt = 1'795'336'205'000;
  alarm::AlarmList list;
  list.raise(alarm::Code::FileChanged, {"POCKET_60x40.MPF"}, kAt);
  list.acknowledge(1, "anna", kAt);
  list.raise(alarm::Code::NotJudged, {"POCKET_60x40.MPF"}, kAt + 60'000);
  list.settle(alarm::Code::NotJudged, kAt + 70'000);
  list.raise(alarm::Code::NotRecorded, {"/var/runs"}, kAt + 80'000);
  list.shelve(3, kAt + 7'200'000, "anna", kAt + 90'000);
  list.raise(alarm::Code::WrongMotion, {"POCKET_60x40.MPF", "14", "2"}, kAt + 100'000);
  list.raise(alarm::Code::ConnectionLost, {"opc.tcp://127.0.0.1:4840"}, kAt + 110'000,
             base::makeError(opcua::LinkError::ConnectionLost,
                             "The connection to the control is lost. Check the machine, then "
                             "connect again."));
  return list.alarms();
}

std::vector<streaming::RunSummary> pastRuns() {
  using streaming::Outcome;
  using streaming::RunFinding;
  const auto run = [](int number, const char* program, const char* user, Outcome outcome,
                      RunFinding finding, std::size_t executed, std::size_t total,
                      double durationS) {
    streaming::RunSummary one;
    one.id = "run-" + std::to_string(number);
    one.programName = program;
    one.programHash = "8c2f1f0a6d3b9e47";
    one.programFile = std::string("/programs/") + program;
    one.endpoint = number % 2 == 0 ? "opc.tcp://192.168.214.1:4840" : "opc.tcp://cell-3:4840";
    one.recording = number == 124 ? "" : "/recordings/run.rivulet";
    one.origin = {user, "cell-pc-3", "2026-11-2" + std::to_string(number % 10) + "T05:12:07Z"};
    one.method = number % 3 == 0 ? base::MethodKind::Position : base::MethodKind::Window;
    one.pointsPerLoop = 7;
    one.feedMmPerS = base::mmPerSFromMmPerMin(500.0 + 10.0 * number);
    one.deltaMm = 0.3;
    one.runNumber = number;
    one.outcome = outcome;
    one.finding = finding;
    one.judged = finding != RunFinding::NotJudged;
    one.executed = executed;
    one.total = total;
    one.repeated = finding == RunFinding::Faulty ? 214 : 0;
    one.skipped = finding == RunFinding::Faulty ? 75 : 0;
    one.duration = base::fromSeconds(durationS);
    one.pauses = executed / 7;
    one.paused = base::fromSeconds(static_cast<double>(one.pauses) * 0.04);
    return one;
  };
  return {
      run(125, "POCKET_60x40.MPF", "anna", Outcome::Completed, RunFinding::Faultless, 1353, 1353,
          184.3),
      run(124, "scorpion.tap", "bert", Outcome::Completed, RunFinding::NotJudged, 270, 270, 95.2),
      run(123, "impeller_roughing_5_axes.mpf", "anna", Outcome::Stopped, RunFinding::Faultless, 210,
          12'000, 61.0),
      run(122, "POCKET_60x40.MPF", "anna", Outcome::Completed, RunFinding::Faulty, 1340, 1353,
          180.0),
      run(121, "POCKET_60x40.MPF", "bert", Outcome::Failed, RunFinding::Faulty, 400, 1353, 12.5),
      run(120, "impeller_roughing_5_axes.mpf", "anna", Outcome::Completed, RunFinding::Faultless,
          12'000, 12'000, 3725.0)};
}

widgets::RunSheet runSheet() {
  widgets::RunSheet sheet;
  sheet.report = report();
  sheet.summary = streaming::summaryOf(sheet.report, pastRuns().front());
  sheet.summary.origin = pastRuns().front().origin;
  sheet.summary.runNumber = pastRuns().front().runNumber;
  sheet.summary.toolVersion = "0.9.0";
  sheet.appVersion = QStringLiteral("1.0.0");
  const auto points = streamed(*pocket());
  sheet.sketch = gcode::sketchOf(points, 4000);
  return sheet;
}

std::shared_ptr<const streaming::CalibrationRecord> calibrationRecord() {
  machine::Machine machine(machine::loadPreset("dmu75-arrays").value(), 5);
  streaming::SimulatedLink link(machine);
  streaming::CalibrationPlan plan;
  plan.firstCell = 50;
  plan.lastCell = 99;
  plan.budget = std::chrono::minutes{2};
  auto record = std::make_shared<streaming::CalibrationRecord>();
  record->endpoint = "opc.tcp://127.0.0.1:4840";
  record->server = {"urn:maker:control", "SINUMERIK OPC UA", "3.2 SP1", "117"};
  record->measuredAtUtc = "2026-05-04T09:30:00Z";
  record->calibration = streaming::calibrate(link, plan).value();
  return record;
}

}  // namespace rivulet::test
