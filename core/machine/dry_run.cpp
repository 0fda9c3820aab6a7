// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/dry_run.h"

#include <fmt/format.h>

#include <cmath>

#include "machine/equipment.h"
#include "machine/interpreter.h"
#include "machine/path_planner.h"
#include "nc/syntax/programs.h"

namespace rivulet::machine {

namespace {

/// More blocks than any program has: a program that jumps back for ever ends here.
constexpr std::size_t kBlocksMax = 10'000'000;

class DryRunner {
 public:
  DryRunner(const MachineConfig& config, const DryRunOptions& options)
      : m_config(config), m_options(options), m_at(options.start) {
    if (m_config.tools) {
      m_config.tools->acceptsMissing = true;  // it is found by the tool that takes its place
    }
  }

  DryRun run(const std::string& text) {
    RParameters parameters(m_config.rParameterCount);
    InterpreterOptions options = interpreterOptions(m_config, m_at);
    options.library = [](const std::string&) { return nullptr; };
    Interpreter interpreter(nc::parseSinumerik(text, m_options.budget), parameters, options);
    for (std::size_t block = 0; block < kBlocksMax && !m_hasEnded; ++block) {
      if (memoryBytes() > m_options.budget.left()) {
        find(interpreter.line()).alarm = alarmOf(nc::Fault{nc::FaultCode::ProgramTooLarge, {}, {}});
        break;
      }
      const Prepared prepared = interpreter.next();
      if (std::holds_alternative<PreparedStopre>(prepared)) {
        interpreter.refresh();
      } else if (const auto* const alarm = std::get_if<Alarm>(&prepared)) {
        find(interpreter.line()).alarm = *alarm;
        break;
      }
      std::visit([&](const auto& what) { take(what); }, prepared);
    }
    m_run.isComplete = m_hasEnded;
    m_run.equipment = m_equipment.state(m_now);
    m_run.zeroMm = interpreter.zeroMm();
    m_run.axesMm = m_at.mm;
    return std::move(m_run);
  }

 private:
  template <class Other>
  void take(const Other&) {}
  void take(const PreparedEnd&) { m_hasEnded = true; }

  void take(const PreparedMotion& motion) {
    m_run.motions.push_back({motion.line,
                             {m_at.mm - motion.zeroMm, m_at.deg},
                             motion.targetMm - motion.zeroMm,
                             motion.zeroMm,
                             motion.isRapid});
    m_hasEnded = m_options.endsWithFeed && !motion.isRapid;
    if (const std::optional<BeyondTravel> travel = beyondTravel(m_config, motion)) {
      find(motion.line).travel = travel;
    }
    if (isTimed(motion.line)) {
      PathPlanner planner(m_config, m_at.mm, m_at.deg);
      planner.append(motion);
      std::vector<trace::ExecutedBlock> executed;
      base::Instant now{};
      while (planner.blockCount() > 0) {
        planner.step(now += m_config.interpolationCycle, executed);
      }
      add(motion.line, now.time_since_epoch());
    }
    m_at = {motion.targetMm, motion.targetDeg};
  }

  void take(const PreparedDwell& dwell) { add(dwell.line, dwell.duration); }

  void take(const PreparedActions& actions) {
    for (const MachineAction& action : actions.actions) {
      using Kind = MachineAction::Kind;
      if (action.kind == Kind::SelectTool && action.tool.isAssumed) {
        find(actions.line).tool =
            action.tool.name.empty() ? fmt::format("T{}", action.tool.number) : action.tool.name;
      } else if (action.kind == Kind::SpindleSpeed &&
                 action.value > m_config.spindle->speedPerMinMax) {
        find(actions.line).speedPerMin = action.value;
      }
    }
    std::vector<trace::ControlEvent> events;
    const double seconds = m_equipment.carryOut(actions, m_now, events);
    const base::Duration time =
        std::isfinite(seconds) ? base::fromSeconds(seconds) : base::Duration{};
    m_now += time;
    add(actions.line, time);
  }

  /// Of what was found.
  [[nodiscard]] std::size_t memoryBytes() const {
    return base::Budget::bytesOf(m_run.findings) + base::Budget::bytesOf(m_run.times) +
           base::Budget::bytesOf(m_run.motions);
  }
  [[nodiscard]] bool isTimed(base::LineNumber line) const {
    return m_options.isTimed && m_options.isTimed(line);
  }
  void add(base::LineNumber line, base::Duration time) {
    if (!isTimed(line)) {
      return;
    }
    if (m_run.times.empty() || m_run.times.back().line != line) {
      m_run.times.push_back({line, {}});
    }
    m_run.times.back().duration += time;
  }
  DryFinding& find(base::LineNumber line) {
    DryFinding& finding = m_run.findings.emplace_back();
    finding.line = line;
    return finding;
  }

  MachineConfig m_config;
  const DryRunOptions& m_options;
  base::AxisPosition m_at;
  Equipment m_equipment{m_config};
  base::Instant m_now{};
  bool m_hasEnded = false;
  DryRun m_run;
};

}  // namespace

DryRun dryRun(const MachineConfig& config, const std::string& text, const DryRunOptions& options) {
  return DryRunner(config, options).run(text);
}

}  // namespace rivulet::machine
