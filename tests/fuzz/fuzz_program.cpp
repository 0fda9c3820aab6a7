// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes are an NC program that the virtual machine executes, that is split into a job, or that
// the lint checks: first a byte that says which.

#include <array>
#include <chrono>
#include <cmath>
#include <string>

#include "base/method_kind.h"
#include "fuzz/require.h"
#include "job/main_program.h"
#include "job/plan.h"
#include "machine/config.h"
#include "machine/machine.h"
#include "templates/lint/lint.h"

using namespace rivulet;
using tests::require;

namespace {

/// Of the machine, for one program.
constexpr base::Duration kTimeMax = std::chrono::milliseconds{400};
constexpr base::Duration kStep = std::chrono::milliseconds{100};

void execute(const machine::MachineConfig& config, const std::string& text) {
  machine::Machine machine(config, 1);
  require(machine.storeProgram("PART.SPF", "G91 G0 X1\nM17\n", false).has_value());
  if (!machine.storeProgram("A.MPF", text, false)) {
    return;
  }
  require(machine.selectProgram("A.MPF").has_value());
  const auto started = machine.cycleStart();
  require(started || !started.error().message.empty());
  for (base::Instant at = machine.now() + kStep; at <= base::Instant{} + kTimeMax; at += kStep) {
    machine.advance(at);
    const machine::MachineState state = machine.state();
    require(base::isFinite(state.actualMm) && base::isFinite(state.commandMm));
    require(std::isfinite(state.feedMmPerS));
    require(state.alarm == 0 || !state.alarmText.empty());
    if (state.waitsForStart) {
      (void)machine.cycleStart();  // what it says was checked above
    } else if (state.channel == machine::ChannelStatus::Reset || state.alarm != 0) {
      break;
    }
  }
  machine.reset();
  machine.advance(machine.now() + kStep);
  require(machine.state().alarm == 0);
}

void split(const std::string& text, unsigned choice) {
  gcode::LoadOptions options;
  options.dialect = gcode::kDialects[choice % gcode::kDialects.size()];
  options.repeatedLinesMax = 200;
  const auto plan = job::makePlan("A.MPF", text, options);
  require(plan || !plan.error().message.empty());
  if (!plan) {
    return;
  }
  for (const job::Refusal& refusal : plan->refusals) {
    require(!job::describe(refusal).empty());
  }
  const auto programs = job::makePrograms(*plan, {});
  require(programs || !programs.error().message.empty());
  if (plan->isWhole()) {
    require(!job::outlineOf(*plan).text.empty());
    require(!job::plainProgramOf(*plan, std::nullopt, 1.0).empty());
  }
}

void lint(const std::string& text, unsigned choice) {
  static const auto kPrograms = [] {
    std::array<templates::FlexibleProgram, base::kMethodKinds.size()> programs;
    for (std::size_t i = 0; i < programs.size(); ++i) {
      templates::TemplateParameters parameters;
      parameters.method = base::kMethodKinds[i];
      programs[i] = *templates::makeProgram(parameters);
    }
    return programs;
  }();
  for (const templates::LintFinding& finding :
       templates::lintProgram(text, kPrograms[choice % kPrograms.size()])) {
    require(!finding.message.empty());
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  static const std::array kMachines{*machine::loadPreset("ideal"),
                                    *machine::loadPreset("dmu75-5axis")};
  const std::string text(tests::textOf(data + 1, size - 1));
  const unsigned choice = data[0] / 4U;
  switch (data[0] % 4U) {
    case 0:
    case 1:
      execute(kMachines[data[0] % 2U], text);
      break;
    case 2:
      split(text, choice);
      break;
    default:
      lint(text, choice);
  }
  return 0;
}
