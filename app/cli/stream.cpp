// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <memory>

#include "base/units.h"
#include "cli/access_text.h"
#include "cli/calibration_choice.h"
#include "cli/commands.h"
#include "cli/connection.h"
#include "cli/correction_source.h"
#include "feasibility/verdict.h"
#include "gcode/program.h"
#include "machine/config.h"
#include "report/calibration_json.h"
#include "report/machine_store.h"
#include "report/operating_point.h"
#include "report/report_json.h"
#include "streaming/commissioning.h"
#include "streaming/control_axes.h"
#include "streaming/job.h"
#include "streaming/resume.h"
#include "streaming/simulation/template_proof.h"
#include "templates/generator.h"
#include "trace/file.h"
#include "trace/recording.h"

namespace rivulet::cli {

namespace {

/// Stop by Ctrl-C, or at the time of the run that the command line gives.
class ConsoleOrders final : public streaming::RunOrders {
 public:
  /// @param source  of corrections; null: none
  ConsoleOrders(double stopAfterS, CorrectionSource* source)
      : m_stopAfterS(stopAfterS), m_source(source) {}
  bool stopRequested(base::Instant now) override {
    if (wasInterrupted()) {
      return true;
    }
    if (m_stopAfterS <= 0.0) {
      return false;
    }
    if (!m_first) {
      m_first = now;
    }
    return now - *m_first >= base::fromSeconds(m_stopAfterS);
  }
  base::Vec3 correctionMm(base::Instant) override {
    return m_source != nullptr ? m_source->valueMm() : base::Vec3{};
  }

 private:
  double m_stopAfterS;
  CorrectionSource* m_source;
  std::optional<base::Instant> m_first;
};

/// A progress line on a terminal, nothing in a pipe.
class ConsoleSink final : public streaming::RunSink {
 public:
  ConsoleSink() : m_isTerminal(isTerminal()) {}
  ~ConsoleSink() override {
    if (m_drawn) {
      std::fputs("\r\x1b[K", stderr);
    }
  }
  void update(const streaming::LiveUpdate& update) override {
    if (!m_isTerminal || update.counters.total == 0) {
      return;
    }
    const std::size_t share = 40 * update.counters.executed / update.counters.total;
    if (m_drawn && share == m_share && update.state == m_state) {
      return;
    }
    m_drawn = true;
    m_share = share;
    m_state = update.state;
    fmt::print(stderr, "\r{:<8} [{:<40}] {} of {} points", streaming::runStateName(update.state),
               std::string(share, '#'), update.counters.executed, update.counters.total);
    std::fflush(stderr);
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}

 private:
  bool m_isTerminal;
  bool m_drawn = false;
  std::size_t m_share = 0;
  streaming::RunState m_state = streaming::RunState::Idle;
};

/// The verdict before anything moved.
struct Judgement {
  bool feasible = false;
  opcua::Grouping form = opcua::Grouping::List;  ///< expected form of access of the run
  std::optional<feasibility::Verdict> verdict;   ///< nothing for a single point
};

/// Judged before anything moves. @return why the run must not start; nothing if it may
std::optional<base::Error> objection(const StreamOptions& options, const Connection& connection,
                                     const gcode::Program& program,
                                     const streaming::RunSettings& settings,
                                     const CalibrationChoice& calibrated, Judgement& judged) {
  const feasibility::OperatingPoint point = report::operatingPointOf(settings);
  const gcode::PointList list = gcode::streamPoints(program.trajectory, {});
  if (list.points.size() < 2 || point.method == base::MethodKind::File) {
    judged.feasible = true;  // a single point needs no refill; method file waits
    return std::nullopt;
  }
  feasibility::AccessModel access;
  if (const streaming::CalibrationRecord* record = calibrated.usable()) {
    judged.form = settings.access == streaming::AccessChoice::Fixed ? settings.grouping
                                                                    : record->calibration.best();
    access = report::accessModel(record->calibration, judged.form);
  }
  const auto verdict = feasibility::judge(
      point, feasibility::programDistances(list.points, point.pointsPerLoop), access);
  if (!verdict) {
    return verdict.error();
  }
  judged.feasible = verdict->feasible;
  judged.verdict = *verdict;
  if (judged.feasible || options.acceptInfeasible || connection.control->isVirtualMachine()) {
    return std::nullopt;
  }
  return base::makeError(
      streaming::StreamError::ProgramNotStreamable,
      fmt::format("Not feasible: equation {} does not hold, the control would repeat points. "
                  "Reduce the feed to {:.0f} mm/min, or give --accept-infeasible.",
                  feasibility::equationLabel(verdict->limiting.equation),
                  base::mmPerMinFromMmPerS(verdict->feedMmPerSMax)));
}

/// Asks the control where the run of a `stream --json` report resumes.
base::Result<streaming::Resume> resumeOf(const std::string& path, const Connection& connection,
                                         const gcode::Program& program,
                                         const streaming::RunSettings& settings) {
  const base::Result<std::string> text = trace::readFile(path);
  if (!text) {
    return base::fail(text.error());
  }
  const auto json = nlohmann::json::parse(*text, nullptr, false);
  const auto number = [&json](const char* pointer) {
    const nlohmann::json::json_pointer at(pointer);
    return json.is_object() && json.contains(at) && json.at(at).is_number()
               ? std::optional(json.at(at).get<double>())
               : std::nullopt;
  };
  const auto run = number("/checkpoint/run_number");
  const auto first = number("/checkpoint/first_point");
  const auto points = number("/settings/points_per_loop");
  const auto windows = number("/settings/windows");
  const auto baseCell = number("/settings/base_cell");
  const std::array<std::optional<double>, 3> start{number("/checkpoint/start_mm/0"),
                                                   number("/checkpoint/start_mm/1"),
                                                   number("/checkpoint/start_mm/2")};
  if (!run || !first || *first < 0.0 || !points || !windows || !baseCell || !start[0] ||
      !start[1] || !start[2]) {
    return base::fail(streaming::StreamError::CannotResume,
                      "This is not the report of a run of method window or credit. Give the output "
                      "of stream --json of the run to be resumed.",
                      path);
  }
  streaming::RunSettings earlier = settings;
  const auto method = base::methodFromName(
      json.value(nlohmann::json::json_pointer("/settings/method"), std::string("window")));
  earlier.parameters.method =
      method && base::hasWindows(*method) ? *method : base::MethodKind::Window;
  earlier.parameters.windowsAhead =
      static_cast<int>(number("/settings/windows_ahead").value_or(earlier.parameters.windowsAhead));
  earlier.parameters.slowDown =
      json.value(nlohmann::json::json_pointer("/settings/slow_down"), earlier.parameters.slowDown);
  earlier.parameters.pointsPerLoop = static_cast<int>(*points);
  earlier.parameters.windows = static_cast<int>(*windows);
  earlier.parameters.baseCell = static_cast<int>(*baseCell);
  earlier.parameters.correctionLimitMm = number("/settings/correction_limit_mm").value_or(0.0);
  const std::string axes =
      json.value(nlohmann::json::json_pointer("/settings/axes"), std::string("XYZ"));
  if (const auto chosen = templates::chooseAxes(earlier.parameters, axes); !chosen) {
    return base::fail(chosen.error());
  }
  streaming::Checkpoint checkpoint;
  checkpoint.runNumber = static_cast<int>(*run);
  checkpoint.firstPoint = static_cast<std::size_t>(*first);
  checkpoint.granted = json.value(nlohmann::json::json_pointer("/checkpoint/granted"), true);
  checkpoint.pausesPlaced =
      json.value(nlohmann::json::json_pointer("/checkpoint/pauses_placed"), true);
  checkpoint.startMm = {*start[0], *start[1], *start[2]};
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    checkpoint.startDeg[axis] =
        number(fmt::format("/checkpoint/start_deg/{}", axis).c_str()).value_or(0.0);
  }
  return streaming::resumeFrom(*connection.link, program, earlier, checkpoint);
}

void print(const streaming::RunReport& report, const CalibrationChoice& calibrated,
           const Judgement& judged) {
  fmt::print("{}: {} of {} points executed", streaming::outcomeName(report.outcome),
             report.counters.executed, report.counters.total);
  if (report.integrity.judged) {
    fmt::print(", {} repeated, {} skipped, {} foreign", report.integrity.repeated,
               report.integrity.skipped, report.integrity.foreign);
  } else {
    fmt::print(" (not judged: {})",
               report.controlTrace ? "longer than the control's trace" : "no trace of the control");
  }
  base::Duration paused{};
  for (const trace::Pause& pause : report.pauses) {
    paused += pause.duration;
  }
  fmt::print("\n{:.1f} s, {} pauses of {:.1f} ms on average\n", base::toSeconds(report.duration),
             report.pauses.size(),
             report.pauses.empty()
                 ? 0.0
                 : base::toMilliseconds(paused) / static_cast<double>(report.pauses.size()));
  if (report.transfer) {
    fmt::print("program on the control: {}, {}\n",
               report.transfer->written ? "written" : "already there",
               report.transfer->compared ? "read back and identical" : "could not be read back");
  }
  fmt::print("access form: {}\n", accessText(report.settings.grouping, report.accessForms));
  fmt::print("access per variable: mean {:.2f} ms, p99 {:.2f} ms, max {:.2f} ms\n",
             base::toMilliseconds(report.access.perNode.mean),
             base::toMilliseconds(report.access.perNode.p99),
             base::toMilliseconds(report.access.perNode.max));
  if (judged.verdict) {
    fmt::print("{}\n", accessSourceText(calibrated, judged.form, *judged.verdict));
  }
  if (!judged.feasible) {
    fmt::print("The settings were outside the feasible region.\n");
  }
  if (report.error.code) {
    fmt::print(stderr, "rivulet-cli: {}\n", report.error.text());
  }
}

/// Writes the flexible program to a file and prints what to do with it.
base::Result<void> printSteps(const StreamOptions& options,
                              const templates::TemplateParameters& parameters) {
  const auto text = templates::generateTemplate(parameters);
  if (!text) {
    return base::fail(text.error());
  }
  const std::string name = templates::templateFileName(parameters);
  const std::string path = options.programFile.empty() ? name : options.programFile;
  if (const auto written = trace::writeFile(path, *text); !written) {
    return base::fail(written.error());
  }
  fmt::print(stderr,
             "The program is in {}.\n1. Copy it to the part programs of the control as {}. Do not "
             "change it.\n2. Select it in channel 1.\n3. Press cycle start. It waits; the axes "
             "move only after Rivulet has found the\n   layout number {} in R{}.\nRivulet waits up "
             "to {:.0f} s from now on.\n",
             path, name, templates::layoutNumber(parameters),
             templates::planCells(parameters)->layout,
             base::toSeconds(streaming::RunSettings{}.startDeadline));
  return {};
}

/// Method credit only if its test has been passed. In virtual time the test is made now.
base::Result<void> requireTest(const StreamOptions& options, const Connection& connection) {
  if (!options.simulate) {
    const auto identity = connection.control->identity();
    if (!identity) {
      return base::fail(identity.error());
    }
    const auto test = report::MachineStore().creditTest(connection.name, *identity);
    return test ? streaming::requireCreditTest(*test, connection.name, *identity)
                : base::Result<void>(base::fail(test.error()));
  }
  streaming::CommissioningPlan plan;
  plan.firstCell = options.point.baseCell;
  const auto result = streaming::commission(*connection.link, *connection.control, plan);
  if (!result) {
    return base::fail(result.error());
  }
  if (!result->passed()) {
    return base::fail(streaming::StreamError::NotCommissioned,
                      "This virtual machine does not pass the test of method credit: see "
                      "commission --simulate. Choose method window.");
  }
  return {};
}

}  // namespace

Exit stream(const StreamOptions& options) {
  auto program = gcode::loadProgram(options.file, options.loading.loadOptions());
  if (!program) {
    return reportError(program.error(), options.json);
  }
  if (program->trajectory.points.empty()) {
    return reportError(
        base::makeError(
            gcode::GcodeError::NoMotion,
            "The program moves no axis: choose one with G0, G1, G2 or G3 and X, Y or Z.",
            program->name),
        options.json);
  }
  program->trajectory = options.resampling.resampled(std::move(program->trajectory));
  streaming::RunSettings settings;
  settings.parameters = options.point.parameters();
  if (options.point.axes.empty()) {
    settings.parameters = streaming::withTurnedAxes(settings.parameters, program->trajectory);
  }
  settings.deltaMm = options.point.deltaMm;
  settings.feedMmPerS = base::mmPerSFromMmPerMin(options.point.feedMmPerMin);
  settings.grouping = options.access == "single" ? opcua::Grouping::Single : opcua::Grouping::List;
  if (options.access == "array") {
    settings.access = streaming::AccessChoice::Array;
  } else if (options.access == "auto" && base::hasWindows(settings.parameters.method)) {
    // The other two are kept as they were published.
    settings.access = streaming::AccessChoice::Best;
  }
  settings.monitor = !options.noMonitor;
  if (options.transfer == "by-hand") {
    settings.transfer = streaming::TransferWay::ByHand;
  }
  settings.placePauses = !options.evenPauses;

  if (const auto cells = templates::planCells(settings.parameters); !cells) {
    return reportError(cells.error(), options.json);
  }
  if (!options.simulate) {
    if (const auto proven = streaming::requireProven(settings.parameters); !proven) {
      return reportError(proven.error(), options.json);
    }
  }
  std::optional<CorrectionSource> source;
  if (!options.correct.empty()) {
    base::Result<CorrectionSource> opened = CorrectionSource::open(options.correct);
    if (!opened) {
      return reportError(opened.error(), options.json);
    }
    source.emplace(std::move(*opened));
  }
  auto connection =
      options.simulate ? simulate(options.preset, options.seed) : connectTo(options.endpoint);
  if (!connection) {
    return reportError(connection.error(), options.json);
  }
  if (settings.parameters.method == base::MethodKind::Credit) {
    if (const auto tested = requireTest(options, *connection); !tested) {
      return reportError(tested.error(), options.json);
    }
    settings.isCommissioned = true;
  }
  CalibrationChoice calibrated;
  if (!options.simulate) {
    auto choice = calibrationOf(*connection);
    if (!choice) {
      return reportError(choice.error(), options.json);
    }
    calibrated = std::move(*choice);
    if (const streaming::CalibrationRecord* record = calibrated.usable()) {
      settings.calibration = std::make_shared<const streaming::Calibration>(record->calibration);
    }
  }
  Judgement judged;
  if (const auto error = objection(options, *connection, *program, settings, calibrated, judged)) {
    return reportError(*error, options.json);
  }

  if (!options.resume.empty()) {
    const auto resume = resumeOf(options.resume, *connection, *program, settings);
    if (!resume) {
      return reportError(resume.error(), options.json);
    }
    settings.resume = *resume;
  }

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(nullptr, std::fclose);
  std::unique_ptr<trace::RecordingWriter> writer;
  if (!options.record.empty()) {
    file.reset(std::fopen(options.record.c_str(), "wb"));
    if (!file) {
      return reportError(
          base::makeError(trace::TraceError::FileNotWritable,
                          "The recording cannot be written. Check the folder and the permissions.",
                          options.record),
          options.json);
    }
    writer = std::make_unique<trace::RecordingWriter>([&file](std::string_view text) {
      return std::fwrite(text.data(), 1, text.size(), file.get()) == text.size() &&
             std::fflush(file.get()) == 0;
    });
  }
  streaming::JobRecorder recorder;
  recorder.writer = writer.get();
  recorder.start.toolVersion = RIVULET_VERSION;
  recorder.start.endpoint = connection->name;
  recorder.start.startedAtUtc = utcNow();

  if (settings.transfer == streaming::TransferWay::ByHand) {
    if (const auto printed = printSteps(options, settings.parameters); !printed) {
      return reportError(printed.error(), options.json);
    }
  }
  watchForInterrupt();
  ConsoleOrders orders(options.stopAfterS, source ? &*source : nullptr);
  streaming::RunReport report;
  {
    ConsoleSink sink;
    report = streaming::runJob(*connection->link, *connection->control, *program, settings, orders,
                               sink, recorder);
  }
  const bool recorded = !writer || writer->ok();
  if (options.json) {
    nlohmann::ordered_json json = report::runJson(report);
    json["feasible"] = judged.feasible;
    if (judged.verdict) {
      json["access_time"] = accessSourceJson(calibrated, judged.form, *judged.verdict);
    }
    json["endpoint"] = connection->name;
    if (!options.record.empty()) {
      json["recording"] = options.record;
    }
    printJson(json);
  } else {
    print(report, calibrated, judged);
  }
  if (!recorded) {
    fmt::print(
        stderr,
        "rivulet-cli: {}: The recording is incomplete: the disk is full or cannot be written.\n",
        options.record);
  }
  if (report.error.code && exitFor(report.error) == Exit::Connection) {
    return Exit::Connection;
  }
  return report.finding() != streaming::RunFinding::Faulty && recorded ? Exit::Done : Exit::Wrong;
}

}  // namespace rivulet::cli
