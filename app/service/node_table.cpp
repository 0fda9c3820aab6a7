// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "service/node_table.h"

#include <fmt/format.h>

#include <array>
#include <type_traits>

namespace rivulet::service {

namespace {

constexpr std::array kVariables{
    VariableRow{"Identification/Manufacturer", "Maker of this server.",
                std::string_view("Rivulet")},
    VariableRow{"Identification/SoftwareRevision", "Version of this service.",
                std::string_view(RIVULET_VERSION)},
    VariableRow{"Identification/Model",
                "Product and build of the machine's own server; empty: not known yet.",
                &Snapshot::model},
    VariableRow{"Identification/ProductInstanceUri",
                "Address of the machine that this service streams to.", &Snapshot::machine},
    VariableRow{"MachineryItemState/CurrentState",
                "NotAvailable, NotExecuting or Executing, as OPC 40001-1 has it.",
                &Snapshot::itemState},
    VariableRow{"Monitoring/IsConnected", "The machine answers.", &Snapshot::isConnected},
    VariableRow{"Monitoring/State",
                "disconnected, connecting, idle, loaded, left (a run can be resumed), armed, "
                "running, holding, stopping.",
                &Snapshot::state},
    VariableRow{"Monitoring/WaitingFor",
                "What the run waits for: claim, network, proof, cycle-start, ...; empty: nothing.",
                &Snapshot::waitingFor},
    VariableRow{"Monitoring/Position", "X, Y and Z of the tool, mm; empty: not known.",
                &Snapshot::positionMm},
    VariableRow{"Monitoring/Override",
                "Path override that the control obeys, %; 0: held; below 0: not known.",
                &Snapshot::overridePercent},
    VariableRow{"Monitoring/FeedFactor",
                "Adaptive feed: factor of the override that is in force; 0: its source holds the "
                "axes; below 0: there is none.",
                &Snapshot::feedFactor},
    VariableRow{"Monitoring/FeedSource",
                "Adaptive feed: where the factors come from, and why none acts; empty: no source.",
                &Snapshot::feedSource},
    VariableRow{"Monitoring/Stands", "The run is held, and the axes were seen to stand.",
                &Snapshot::stands},
    VariableRow{"Monitoring/LateWindows",
                "How often in this run the next points were due before they could be there.",
                &Snapshot::lateWindows},
    VariableRow{"Monitoring/LeastMargin",
                "Smallest time in this run that was left before the next points were due, s.",
                &Snapshot::leastMarginS},
    VariableRow{"Production/ActiveProgram/Name", "The program that is loaded; empty: none.",
                &Snapshot::program, Readers::LoggedIn},
    VariableRow{"Production/ActiveProgram/State/CurrentState",
                "Initializing, Running, Interrupted, Ended or Aborted, as OPC 40501-1 has it.",
                &Snapshot::programState},
    VariableRow{"Production/ActiveProgram/Stretches",
                "Stretches of a whole job, between the blocks of the control; 0: none.",
                &Snapshot::stretches},
    VariableRow{"Production/ActiveProgram/Stretch",
                "Stretch in progress, or the one after the blocks of the control in progress; 0: "
                "none. PreflightStretch takes these numbers.",
                &Snapshot::stretch},
    VariableRow{"Production/ActiveProgram/PointsDone", "Points that the machine has executed.",
                &Snapshot::pointsDone},
    VariableRow{"Production/ActiveProgram/Points", "Points of the program.", &Snapshot::points},
    VariableRow{"Production/ActiveProgram/Progress", "Part of the points that is executed, %.",
                &Snapshot::progressPercent},
    VariableRow{"Production/ActiveProgram/TimeLeft",
                "Time left at the pace of the run so far, s; below 0: not known.",
                &Snapshot::timeLeftS},
    VariableRow{"Production/ActiveProgram/RunNumber",
                "Number by which the control knows the last run; 0: none.", &Snapshot::runNumber},
    VariableRow{"ProductionPlan/Files",
                "Files in the folder of jobs, as LoadJob takes them, one a line: the newest 200.",
                &Snapshot::files, Readers::LoggedIn},
    VariableRow{"ProductionPlan/File", "File of the program that is loaded.", &Snapshot::file,
                Readers::LoggedIn},
    VariableRow{"ProductionPlan/Hash", "Of its text: tells versions of the program apart.",
                &Snapshot::hash, Readers::LoggedIn},
    VariableRow{"ProductionPlan/Settings", "Settings of the job, name=value;...",
                &Snapshot::settings, Readers::LoggedIn},
    VariableRow{"ProductionPlan/CanResume", "A run was left that can be resumed.",
                &Snapshot::canResume},
    VariableRow{"ProductionPlan/LeftRun", "Program and number of that run; empty: none.",
                &Snapshot::leftRun, Readers::LoggedIn},
    VariableRow{"Notification/Alarm", "Why nothing goes on; empty: no alarm.", &Snapshot::alarm},
    VariableRow{"Notification/Message", "What has happened last.", &Snapshot::message,
                Readers::LoggedIn},
    VariableRow{"Session/LastOutcome",
                "How the last run has ended: completed, stopped or failed; empty: none has.",
                &Snapshot::outcome},
    VariableRow{"Session/LastReport", "File of its report on the computer of the service.",
                &Snapshot::report, Readers::LoggedIn},
};

}  // namespace

std::span<const VariableRow> variableRows() {
  return kVariables;
}

NodeValue valueOf(const VariableRow& row, const Snapshot& seen) {
  return std::visit(
      [&seen](auto member) -> NodeValue {
        if constexpr (std::is_member_pointer_v<decltype(member)>) {
          return seen.*member;
        } else {
          return std::string(member);
        }
      },
      row.member);
}

void take(const VariableRow& row, const opcua::NodeValue& value, Snapshot& seen) {
  std::visit(
      [&](auto member) {
        if constexpr (std::is_member_pointer_v<decltype(member)>) {
          auto& into = seen.*member;
          using Member = std::remove_reference_t<decltype(into)>;
          into = {};
          if constexpr (std::is_same_v<Member, std::uint32_t>) {
            const double* number = std::get_if<double>(&value);
            into = number != nullptr && *number >= 0.0 ? static_cast<std::uint32_t>(*number) : 0;
          } else if (const Member* known = std::get_if<Member>(&value)) {
            into = *known;
          }
        }
      },
      row.member);
}

std::string nodeAddress(std::string_view identifier) {
  return fmt::format("nsu={};s={}", kNamespaceUri, identifier);
}

std::string methodIdentifier(std::string_view method) {
  return fmt::format("{}/{}", kMethodsObject, method);
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
      {"PreflightStretch",
       "The same of a job that begins with this stretch (1, 2, ...). Call again for the answer.",
       {"Stretch"},
       [](ServiceSession& session, const Caller& caller, const Inputs& inputs) {
         return session.preflightStretch(caller, inputs[0]);
       }},
      {"Start",
       "Starts the job. Confirmation: as the last Preflight or PreflightStretch has returned it.",
       {"Confirmation"},
       [](ServiceSession& session, const Caller& caller, const Inputs& inputs) {
         return session.start(caller, inputs[0]);
       }},
      {"Hold",
       "The axes stand at once, on the path; without a feed cell before the next window.",
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
      {"SetOverride",
       "Path override of the run. Percent: 0 to 100, for an engineer to 120.",
       {"Percent"},
       [](ServiceSession& session, const Caller& caller, const Inputs& inputs) {
         return session.setOverride(caller, inputs[0]);
       }},
      {"Stop",
       "Ends the run after the window in motion. Always permitted.",
       {},
       [](ServiceSession& session, const Caller& caller, const Inputs&) {
         return session.stop(caller);
       }},
      {"PreflightResume",
       "Asks the control where the run was left, and what its program still executes first; call "
       "again for the answer. Nothing moves. Its confirmation is what ResumeRun asks for.",
       {},
       [](ServiceSession& session, const Caller& caller, const Inputs&) {
         return session.preflightResume(caller);
       }},
      {"ResumeRun",
       "Goes on with the run that was left. Confirmation: as PreflightResume has returned it.",
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
