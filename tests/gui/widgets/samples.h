// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Values as a real session hands them to the pages: a pocket with arcs, a run on it, its trace.
#pragma once

#include <memory>
#include <vector>

#include "alarm/alarm.h"
#include "feasibility/advice.h"
#include "feasibility/verdict.h"
#include "gcode/program.h"
#include "overview/program_view.h"
#include "streaming/control/machine_facts.h"
#include "streaming/run/run.h"
#include "streaming/setup/calibration_record.h"
#include "trace/control_trace.h"
#include "trace/signal_set.h"
#include "widgets/connection/machine_view.h"
#include "widgets/feasibility/region_chart.h"
#include "widgets/runs/run_sheet.h"

namespace rivulet::test {

/// NC text of a pocket milled as a spiral, with a few words Rivulet warns of.
[[nodiscard]] std::string pocketText();
/// The pocket, interpreted.
[[nodiscard]] std::shared_ptr<const gcode::Program> pocket();
[[nodiscard]] std::shared_ptr<const gcode::Program> programFrom(const std::string& name,
                                                                const std::string& text);
/// A program with errors, interpreted.
[[nodiscard]] std::shared_ptr<const gcode::Program> brokenProgram();
[[nodiscard]] std::vector<gcode::StreamPoint> streamed(const gcode::Program& program);
/// As the page gets it, for a tool at the origin and N = 7.
[[nodiscard]] std::shared_ptr<const overview::ProgramView> viewOf(
    const std::shared_ptr<const gcode::Program>& program);
/// Two tools, coolant that is switched on while the tool moves, a retract, and drilling by a cycle.
[[nodiscard]] std::string jobText();
/// That program as a job.
[[nodiscard]] std::shared_ptr<const overview::ProgramView> jobView();
/// A program of points alone, one line each. @param positions >= 1
[[nodiscard]] std::shared_ptr<const gcode::Program> programOf(
    const std::vector<gcode::StreamPoint>& points);
/// Times of a machine that runs a point a tenth of a second.
[[nodiscard]] std::shared_ptr<const overview::ProgramTimes> timesOf(
    const overview::ProgramView& view);
/// A path of many points, built without a text. @param points >= 2
[[nodiscard]] std::vector<gcode::StreamPoint> manyPoints(std::size_t points);
[[nodiscard]] widgets::MachineView runningMachine();
[[nodiscard]] widgets::FeasibilityModel feasibilityModel(base::MethodKind method,
                                                         double feedMmPerMin);
/// 4 ms samples along the pocket at 500 mm/min, standing still every `pauseEveryS`.
[[nodiscard]] std::shared_ptr<const trace::ControlTrace> controlTrace(double pauseEveryS);
/// A trace as the page shows it, analysed. @param program  null: compared with none
[[nodiscard]] std::shared_ptr<const trace::ShownTrace> shownTrace(
    const trace::ControlTrace& trace, const std::string& name = {},
    const gcode::Program* program = nullptr);
[[nodiscard]] std::vector<trace::Pause> pausesOf(const trace::ControlTrace& trace);
[[nodiscard]] streaming::RunReport report();
/// One of each state, the most important first.
[[nodiscard]] std::vector<alarm::Alarm> alarms();
/// Runs of several programs and machines, the newest first; the second has no recording.
[[nodiscard]] std::vector<streaming::RunSummary> pastRuns();
/// The report with a path that has rapids.
[[nodiscard]] widgets::RunSheet runSheet();

/// A calibration of the virtual machine in virtual time, of 50 cells, with little time for the long
/// kinds.
[[nodiscard]] std::shared_ptr<const streaming::CalibrationRecord> calibrationRecord();

[[nodiscard]] streaming::CreditTest creditTest(bool passed);
/// What is advised for the pocket at the operating point of a model.
[[nodiscard]] std::vector<feasibility::Advice> advice(const widgets::FeasibilityModel& model);
/// A simulated region that fits a model and a chart's grid; some points run, some fail.
[[nodiscard]] widgets::SimulatedRegion simulatedRegion(const widgets::FeasibilityModel& model,
                                                       const widgets::SimulationWanted& wanted,
                                                       double limitMmPerMin);

}  // namespace rivulet::test
