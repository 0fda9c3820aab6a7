// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// What may be started, why not, and with which form of access.

#include <QtTest>
#include <set>

#include "job/plan.h"
#include "live/error.h"
#include "streaming/control/access_policy.h"
#include "streaming/run/run.h"
#include "streaming/setup/calibration.h"
#include "streaming/start/start_policy.h"
#include "support/test_program.h"

using namespace rivulet;
using base::MethodKind;
using streaming::AccessChoice;
using streaming::AccessPreference;
using streaming::Activity;
using streaming::Blocked;
using streaming::BlockReason;
using streaming::StartFacts;

namespace {

gcode::Program programOf(const char* text) {
  gcode::LoadOptions options;
  options.units = gcode::FileUnits::Millimetres;
  return gcode::interpretProgram("a.nc", text, options).value();
}

/// Everything in order; the tests take one thing away at a time.
StartFacts ready(const gcode::Program& program) {
  StartFacts facts;
  facts.isConnected = true;
  facts.program = &program;
  facts.channelStatus = 0;
  facts.alarm = 0;
  facts.controlAxes = base::RotarySet{};
  return facts;
}

std::optional<BlockReason> reasonOf(const std::optional<Blocked>& blocked) {
  return blocked ? std::optional(blocked->reason) : std::nullopt;
}

feasibility::Verdict infeasible() {
  feasibility::Verdict verdict;
  verdict.feasible = false;
  verdict.limiting.equation = feasibility::Equation::Delta;
  verdict.feedMmPerSMax = 10.0;
  return verdict;
}

}  // namespace

class TestStartPolicy : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aLiveSourceTakesThePlaceOfAProgram() {
    StartFacts facts;
    facts.isConnected = true;
    facts.live.emplace();
    QVERIFY(!streaming::startBlocked(facts));
    for (const base::MethodTraits& traits : base::kMethods) {
      facts.method = traits.kind;
      const bool waits = traits.kind == MethodKind::Window || traits.kind == MethodKind::Credit;
      QVERIFY(reasonOf(streaming::startBlocked(facts)) ==
              (waits ? std::nullopt : std::optional(BlockReason::LiveNeedsWindows)));
    }
    facts.method = MethodKind::Window;
    facts.live->obstacle = base::makeError(live::LiveError::NotOpened, "The port is taken.");
    const auto blocked = streaming::startBlocked(facts);
    QVERIFY(reasonOf(blocked) == BlockReason::SourceNotOpen);
    QVERIFY(streaming::blockedError(*blocked).code == live::LiveError::NotOpened);
    // A point may turn what the control does not have.
    facts.live->obstacle.reset();
    facts.turnedAxes = {true, false, false};
    facts.controlAxes = base::RotarySet{};
    QVERIFY(reasonOf(streaming::startBlocked(facts)) == BlockReason::AxesMissing);
  }

  void startsWhenNothingIsInTheWay() {
    const gcode::Program program = programOf("G1 X1 Y2 Z3 F100\nX2\n");
    QVERIFY(!streaming::startBlocked(ready(program)));
    // What is not known blocks nothing.
    StartFacts facts;
    facts.isConnected = true;
    facts.program = &program;
    QVERIFY(!streaming::startBlocked(facts));
  }

  /// The unit a real control takes where a program names none is a setting of its own. Rivulet's
  /// machines are metric and read whole units.
  void aRealControlMayReadAnotherSize() {
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Fanuc;
    gcode::Program program =
        gcode::interpretProgram("O1.nc", "O1\nG90 G0 X10. Y20.\nX5.\nM30\n", options).value();
    StartFacts facts = ready(program);
    facts.isVirtualMachine = true;
    QVERIFY(!streaming::startBlocked(facts));
    facts.isVirtualMachine = StartFacts{}.isVirtualMachine;  // nobody has said so: it is a real one
    const auto blocked = streaming::startBlocked(facts);
    QVERIFY(reasonOf(blocked) == BlockReason::SettingOpen);
    const base::Error error = streaming::blockedError(*blocked);
    QVERIFY(error.code == gcode::GcodeError::Ambiguous);
    QVERIFY2(error.message.find("X 5, Y 0 mm; X 127, Y 0 mm") != std::string::npos,
             error.message.c_str());
    options.units = gcode::FileUnits::Millimetres;
    program = gcode::interpretProgram("O1.nc", "O1\nG90 G0 X10. Y20.\nX5.\nM30\n", options).value();
    QVERIFY(!streaming::startBlocked(facts));
  }

  /// So is what a canned cycle takes in place of a word that the program lacks.
  void aRealControlHasItsOwnSettings() {
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Fanuc;
    const auto plan = job::makePlan(
        "O1.nc", "G21 G0 X1. Y1. Z5.\nG83 R1. Z-5. F100.\nG80\nG0 X9.\nM30\n", options);
    QVERIFY(plan.has_value());
    StartFacts facts = ready(plan->program);
    facts.isVirtualMachine = false;
    QVERIFY(reasonOf(streaming::startBlocked(facts)) == BlockReason::SettingOpen);
    facts.isVirtualMachine = true;
    QVERIFY(!streaming::startBlocked(facts));
  }

  void namesTheFirstReason() {
    const gcode::Program program = programOf("G1 X1 Y2 Z3 F100\nX2\n");
    StartFacts facts = ready(program);
    const auto reason = [&facts] { return reasonOf(streaming::startBlocked(facts)); };
    facts.channelStatus = 1;
    QVERIFY(reason() == BlockReason::ChannelBusy);
    facts.hasFileChanged = true;
    QVERIFY(reason() == BlockReason::FileChanged);
    facts.alarm = 14080;
    QVERIFY(reason() == BlockReason::AlarmActive);
    QCOMPARE(streaming::startBlocked(facts)->arguments.front(), std::string("14080"));
    facts.verdict = infeasible();
    QVERIFY(reason() == BlockReason::Infeasible);
    facts.settingsError = base::makeError(streaming::StreamError::AxisMissing, "why");
    QVERIFY(reason() == BlockReason::SettingsInvalid);
    QCOMPARE(streaming::blockedError(*streaming::startBlocked(facts)).message, std::string("why"));
    facts.program = nullptr;
    QVERIFY(reason() == BlockReason::NoProgram);
    facts.isConnected = false;
    QVERIFY(reason() == BlockReason::NotConnected);
    facts.activity = Activity::Calibrating;
    QVERIFY(reason() == BlockReason::CalibrationInProgress);
    facts.activity = Activity::CheckingResume;
    QVERIFY(reason() == BlockReason::ResumeCheckInProgress);
    facts.activity = Activity::Streaming;
    QVERIFY(reason() == BlockReason::RunInProgress);
  }

  /// The comparison with the machine ends before anything moves, and says what it has found.
  void comparesAJobWithTheMachine() {
    const gcode::Program program = programOf("G1 X1 Y2 Z3 F100\nX2\n");
    StartFacts facts = ready(program);
    facts.jobCheck = streaming::JobCheck{};
    QVERIFY(reasonOf(streaming::startBlocked(facts)) == BlockReason::JobNotChecked);
    facts.jobCheck->isDone = true;
    QVERIFY(!streaming::startBlocked(facts));
    facts.jobCheck->obstacle = base::makeError(streaming::StreamError::AxisMissing, "line 5");
    QVERIFY(reasonOf(streaming::startBlocked(facts)) == BlockReason::BeyondMachine);
    QCOMPARE(streaming::blockedError(*streaming::startBlocked(facts)).message,
             std::string("line 5"));
  }

  /// A locked window hides every other reason; a release comes last.
  void asksWhoIsThere() {
    const gcode::Program program = programOf("G1 X1 Y2 Z3 F100\nX2\n");
    StartFacts facts = ready(program);
    facts.hasRunToResume = true;
    facts.refusal = permission::Refusal::NotReleased;
    QVERIFY(reasonOf(streaming::startBlocked(facts)) == BlockReason::NotReleased);
    QVERIFY(reasonOf(streaming::resumeBlocked(facts)) == BlockReason::NotReleased);
    QVERIFY(!streaming::calibrationBlocked(facts));
    facts.alarm = 14080;
    QVERIFY(reasonOf(streaming::startBlocked(facts)) == BlockReason::AlarmActive);
    facts.refusal = permission::Refusal::NeedsEngineer;
    QVERIFY(reasonOf(streaming::calibrationBlocked(facts)) == BlockReason::NeedsEngineer);
    facts.refusal = permission::Refusal::Locked;
    facts.isConnected = false;
    for (const auto& blocked : {streaming::startBlocked(facts), streaming::resumeBlocked(facts),
                                streaming::calibrationBlocked(facts)}) {
      QVERIFY(reasonOf(blocked) == BlockReason::Locked);
      QVERIFY(!streaming::blockedError(*blocked).message.empty());
    }
  }

  void tellsProgramsApartThatCannotBeStreamed() {
    const gcode::Program unknown = programOf("G1 X1 Y2 Z3 F100\nX=FOO(3)\n");
    QVERIFY(reasonOf(streaming::startBlocked(ready(unknown))) == BlockReason::PathUnknown);
    gcode::Program still = programOf("G1 X1 F100\n");
    still.trajectory.points.clear();
    QVERIFY(reasonOf(streaming::startBlocked(ready(still))) == BlockReason::NoMotion);
    QVERIFY(reasonOf(streaming::programBlocked(programOf("TRAORI\nG1 X1 Y2 Z3 A3=0 B3=0 C3=1 F9\n"
                                                         "X2 A3=1 B3=0 C3=1\n"))) ==
            BlockReason::NeedsTransformation);
  }

  void infeasibleSettingsStartOnlyWhereTheyAreAccepted() {
    const gcode::Program program = programOf("G1 X1 Y2 Z3 F100\nX2\n");
    StartFacts facts = ready(program);
    facts.method = MethodKind::Position;
    facts.verdict = infeasible();
    const auto blocked = streaming::startBlocked(facts);
    QVERIFY(reasonOf(blocked) == BlockReason::Infeasible);
    QCOMPARE(blocked->arguments, (std::vector<std::string>{"equation (2)", "600"}));
    facts.verdict->limiting.equation = feasibility::Equation::Machine;
    const base::Error said = streaming::blockedError(*streaming::startBlocked(facts));
    QVERIFY2(said.text().find("Not feasible by the motion of this machine") != std::string::npos,
             said.text().c_str());
    facts.acceptsInfeasible = true;
    facts.acceptsRepeats = true;
    QVERIFY(!streaming::startBlocked(facts));
  }

  /// Also where the verdict is feasible: a computer may be late once.
  void methodsWithoutWindowsStartOnlyWhereRepeatsAreAccepted() {
    const gcode::Program program = programOf("G1 X1 Y2 Z3 F100\nX2\n");
    StartFacts facts = ready(program);
    for (const MethodKind method : base::kMethodKinds) {
      facts.method = method;
      facts.isCommissioned = true;
      facts.acceptsRepeats = false;
      const auto blocked = streaming::startBlocked(facts);
      QCOMPARE(blocked.has_value(), !base::hasWindows(method));
      QVERIFY(!blocked || blocked->reason == BlockReason::MayRepeat);
      facts.acceptsRepeats = true;
      QVERIFY(!streaming::startBlocked(facts));
    }
  }

  void rotaryAxesNeedAMethodAndAControlThatHaveThem() {
    const gcode::Program program = programOf("G1 X1 Y2 Z3 F100\nX2\n");
    StartFacts facts = ready(program);
    facts.turnedAxes = {true, false, true};
    facts.controlAxes = base::RotarySet{true, false, false};
    const auto missing = streaming::startBlocked(facts);
    QVERIFY(reasonOf(missing) == BlockReason::AxesMissing);
    QCOMPARE(missing->arguments.front(), std::string("AC"));
    facts.controlAxes = base::RotarySet{true, true, true};
    QVERIFY(!streaming::startBlocked(facts));
    for (const MethodKind method : base::kMethodKinds) {
      facts.method = method;
      facts.isCommissioned = true;
      QCOMPARE(reasonOf(streaming::startBlocked(facts)) == BlockReason::RotaryNotStreamed,
               !base::streamsRotary(method));
    }
  }

  void methodCreditNeedsItsTest() {
    const gcode::Program program = programOf("G1 X1 Y2 Z3 F100\nX2\n");
    StartFacts facts = ready(program);
    facts.isCommissioned = false;
    QVERIFY(!streaming::startBlocked(facts));
    facts.method = MethodKind::Credit;
    const auto blocked = streaming::startBlocked(facts);
    QVERIFY(reasonOf(blocked) == BlockReason::NotCommissioned);
    QVERIFY(streaming::blockedError(*blocked).code == streaming::StreamError::NotCommissioned);
    facts.isCommissioned = true;
    QVERIFY(!streaming::startBlocked(facts));
  }

  void onlyMethodsWithWindowsResume() {
    const gcode::Program program = programOf("G1 X1 Y2 Z3 F100\nX2\n");
    StartFacts facts = ready(program);
    QVERIFY(reasonOf(streaming::resumeBlocked(facts)) == BlockReason::NothingToResume);
    facts.hasRunToResume = true;
    QVERIFY(!streaming::resumeBlocked(facts));
    // The program of that run may still wait on the control.
    facts.channelStatus = 1;
    QVERIFY(!streaming::resumeBlocked(facts));
    for (const MethodKind method : base::kPaperMethods) {
      facts.method = method;
      QVERIFY(reasonOf(streaming::resumeBlocked(facts)) == BlockReason::MethodCannotResume);
    }
  }

  void aCalibrationNeedsAChannelInReset() {
    StartFacts facts;
    facts.isConnected = true;
    QVERIFY(!streaming::calibrationBlocked(facts));
    facts.channelStatus = 1;
    QVERIFY(reasonOf(streaming::calibrationBlocked(facts)) == BlockReason::ChannelBusy);
    facts.activity = Activity::Streaming;
    QVERIFY(reasonOf(streaming::calibrationBlocked(facts)) == BlockReason::RunInProgress);
  }

  /// Each reason has a sentence and a code of its own folder.
  void everyReasonIsAnError() {
    std::set<std::string> sentences;
    for (int i = 0; i <= static_cast<int>(BlockReason::MethodCannotResume); ++i) {
      const base::Error error =
          streaming::blockedError({static_cast<BlockReason>(i), {"1", "2"}, std::nullopt});
      QVERIFY(error.code);
      QVERIFY(sentences.insert(error.message).second);
    }
  }

  void methodsOfThePaperUseListsUnlessToldOtherwise() {
    for (const MethodKind method : base::kMethodKinds) {
      const bool isPublished = base::isPublished(method);
      QVERIFY(streaming::accessPlan(AccessPreference::Automatic, method).choice ==
              (isPublished ? AccessChoice::Fixed : AccessChoice::Best));
      QVERIFY(streaming::accessPlan(AccessPreference::Array, method).choice == AccessChoice::Array);
      const auto single = streaming::accessPlan(AccessPreference::Single, method);
      QVERIFY(single.choice == AccessChoice::Fixed);
      QVERIFY(single.grouping == opcua::Grouping::Single);
      const auto list = streaming::accessPlan(AccessPreference::List, method);
      QVERIFY(list.choice == AccessChoice::Fixed && list.grouping == opcua::Grouping::List);
      QVERIFY(list.expected(nullptr) == opcua::Grouping::List);
    }
  }
};

RIVULET_TEST(TestStartPolicy)
#include "tst_start_policy.moc"
