// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "service/node_table.h"

#include <array>

namespace rivulet::service {

namespace {

constexpr std::array kVariables{
    VariableRow{"Identification/Manufacturer", "Maker of this server.",
                [](const Snapshot&) -> NodeValue { return std::string("Rivulet"); }},
    VariableRow{"Identification/SoftwareRevision", "Version of this service.",
                [](const Snapshot&) -> NodeValue { return std::string(RIVULET_VERSION); }},
    VariableRow{"Identification/Model",
                "Product and build of the machine's own server; empty: not known yet.",
                [](const Snapshot& seen) -> NodeValue { return seen.model; }},
    VariableRow{"Identification/ProductInstanceUri",
                "Address of the machine that this service streams to.",
                [](const Snapshot& seen) -> NodeValue { return seen.machine; }},
    VariableRow{"MachineryItemState/CurrentState",
                "NotAvailable, NotExecuting or Executing, as OPC 40001-1 has it.",
                [](const Snapshot& seen) -> NodeValue { return seen.itemState; }},
    VariableRow{"Monitoring/IsConnected", "The machine answers.",
                [](const Snapshot& seen) -> NodeValue { return seen.isConnected; }},
    VariableRow{"Monitoring/State",
                "disconnected, connecting, idle, loaded, left (a run can be resumed), armed, "
                "running, holding, stopping.",
                [](const Snapshot& seen) -> NodeValue { return seen.state; }},
    VariableRow{"Monitoring/WaitingFor",
                "What the run waits for: claim, network, proof, cycle-start, ...; empty: nothing.",
                [](const Snapshot& seen) -> NodeValue { return seen.waitingFor; }},
    VariableRow{"Monitoring/Position", "X, Y and Z of the tool, mm; empty: not known.",
                [](const Snapshot& seen) -> NodeValue { return seen.positionMm; }},
    VariableRow{"Monitoring/LateWindows",
                "How often in this run the next points were due before they could be there.",
                [](const Snapshot& seen) -> NodeValue { return seen.lateWindows; }},
    VariableRow{"Monitoring/LeastMargin",
                "Smallest time in this run that was left before the next points were due, s.",
                [](const Snapshot& seen) -> NodeValue { return seen.leastMarginS; }},
    VariableRow{"Production/ActiveProgram/Name", "The program that is loaded; empty: none.",
                [](const Snapshot& seen) -> NodeValue { return seen.program; }},
    VariableRow{"Production/ActiveProgram/State/CurrentState",
                "Initializing, Running, Interrupted, Ended or Aborted, as OPC 40501-1 has it.",
                [](const Snapshot& seen) -> NodeValue { return seen.programState; }},
    VariableRow{"Production/ActiveProgram/PointsDone", "Points that the machine has executed.",
                [](const Snapshot& seen) -> NodeValue { return seen.pointsDone; }},
    VariableRow{"Production/ActiveProgram/Points", "Points of the program.",
                [](const Snapshot& seen) -> NodeValue { return seen.points; }},
    VariableRow{"Production/ActiveProgram/Progress", "Part of the points that is executed, %.",
                [](const Snapshot& seen) -> NodeValue { return seen.progressPercent; }},
    VariableRow{"Production/ActiveProgram/TimeLeft",
                "Time left at the pace of the run so far, s; below 0: not known.",
                [](const Snapshot& seen) -> NodeValue { return seen.timeLeftS; }},
    VariableRow{"Production/ActiveProgram/RunNumber",
                "Number by which the control knows the last run; 0: none.",
                [](const Snapshot& seen) -> NodeValue { return seen.runNumber; }},
    VariableRow{"ProductionPlan/File", "File of the program that is loaded.",
                [](const Snapshot& seen) -> NodeValue { return seen.file; }},
    VariableRow{"ProductionPlan/Hash", "Of its text: tells versions of the program apart.",
                [](const Snapshot& seen) -> NodeValue { return seen.hash; }},
    VariableRow{"ProductionPlan/Settings", "Settings of the job, name=value;...",
                [](const Snapshot& seen) -> NodeValue { return seen.settings; }},
    VariableRow{"ProductionPlan/CanResume", "A run was left that can be resumed.",
                [](const Snapshot& seen) -> NodeValue { return seen.canResume; }},
    VariableRow{"ProductionPlan/LeftRun", "Program and number of that run; empty: none.",
                [](const Snapshot& seen) -> NodeValue { return seen.leftRun; }},
    VariableRow{"Notification/Alarm", "Why nothing goes on; empty: no alarm.",
                [](const Snapshot& seen) -> NodeValue { return seen.alarm; }},
    VariableRow{"Notification/Message", "What has happened last.",
                [](const Snapshot& seen) -> NodeValue { return seen.message; }},
    VariableRow{"Session/LastOutcome",
                "How the last run has ended: completed, stopped or failed; empty: none has.",
                [](const Snapshot& seen) -> NodeValue { return seen.outcome; }},
    VariableRow{"Session/LastReport", "File of its report on the computer of the service.",
                [](const Snapshot& seen) -> NodeValue { return seen.report; }},
};

}  // namespace

std::span<const VariableRow> variableRows() {
  return kVariables;
}

const std::vector<MethodRow>& methodRows() {
  using Inputs = std::vector<std::string>;
  static const std::vector<MethodRow> rows{
      {"LoadJob",
       "Loads an NC program. File: in the folder of jobs. Settings: name=value;... as in "
       "ProductionPlan/Settings; empty: the usual ones, or those that were released.",
       {"File", "Settings"},
       [](ServiceSession& session, const Caller& caller, const Inputs& inputs) {
         return session.loadJob(caller, inputs[0], inputs[1]);
       }},
      {"Preflight",
       "Says what Start would do now. Nothing moves. Its confirmation is what Start asks for.",
       {},
       [](ServiceSession& session, const Caller& caller, const Inputs&) {
         return session.preflight(caller);
       }},
      {"Start",
       "Starts the job. Confirmation: as the last Preflight has returned it.",
       {"Confirmation"},
       [](ServiceSession& session, const Caller& caller, const Inputs& inputs) {
         return session.start(caller, inputs[0]);
       }},
      {"Hold",
       "The machine waits before the next window.",
       {},
       [](ServiceSession& session, const Caller& caller, const Inputs&) {
         return session.hold(caller, true);
       }},
      {"Resume",
       "Goes on after Hold.",
       {},
       [](ServiceSession& session, const Caller& caller, const Inputs&) {
         return session.hold(caller, false);
       }},
      {"Stop",
       "Ends the run after the window in motion. Always permitted.",
       {},
       [](ServiceSession& session, const Caller& caller, const Inputs&) {
         return session.stop(caller);
       }},
      {"PreflightResume",
       "Asks the control where the run was left; call again for the answer. A program that still "
       "waits on the control is ended for it. Its confirmation is what ResumeRun asks for.",
       {},
       [](ServiceSession& session, const Caller& caller, const Inputs&) {
         return session.preflightResume(caller);
       }},
      {"ResumeRun",
       "Goes on with the run that was left. Confirmation: as the last PreflightResume has returned "
       "it.",
       {"Confirmation"},
       [](ServiceSession& session, const Caller& caller, const Inputs& inputs) {
         return session.resumeRun(caller, inputs[0]);
       }},
      {"ForgetRun",
       "The run that was left is not kept any longer, and cannot be resumed.",
       {},
       [](ServiceSession& session, const Caller& caller, const Inputs&) {
         return session.forgetRun(caller);
       }},
      {"EndRun",
       "Ends a program of Rivulet that waits on the control for a client. Always permitted.",
       {},
       [](ServiceSession& session, const Caller& caller, const Inputs&) {
         return session.endRun(caller);
       }},
  };
  return rows;
}

}  // namespace rivulet::service
