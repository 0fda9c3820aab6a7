// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "forecast/job_forecast.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/text.h"
#include "forecast/path_time.h"
#include "gcode/trajectory.h"
#include "job/main_program.h"
#include "machine/dry_run.h"
#include "streaming/methods/pause_placement.h"
#include "streaming/run/whole_job.h"

namespace rivulet::forecast {

namespace {

/// What the client's requests take at both ends of a stretch, on average, with the access times of
/// [P1]: checks and the first windows before its motion, and the end of the program after it.
/// Measured on the virtual machine: 11 stretches, methods window and credit.
constexpr base::Duration kStretchEnds = std::chrono::milliseconds{700};
/// The same between control and client, until the next native block or stretch begins.
constexpr base::Duration kHandover = std::chrono::milliseconds{300};

/// Alarms of the language: a name, a program or a value that only the control may know.
bool isOfLanguage(int alarm) {
  constexpr int kSubprogramMissing = 14011;
  return (alarm >= 12000 && alarm < 13000) || alarm == kSubprogramMissing;
}

/// Without the line of the outline at its beginning.
std::string withoutLine(const std::string& text) {
  const std::size_t colon = text.find(": ");
  return text.starts_with("Line ") && colon != std::string::npos ? text.substr(colon + 2) : text;
}

std::vector<const job::NativeBlock*> nativesOf(const job::Plan& plan) {
  std::vector<const job::NativeBlock*> natives;
  for (const job::Part& part : plan.parts) {
    if (const auto* const native = std::get_if<job::NativeBlock>(&part)) {
      natives.push_back(native);
    }
  }
  return natives;
}

/// The tool of the same letters and digits: DRILL_8.5 for "drill 8.5".
std::string nearName(const machine::MachineConfig& machine, std::string_view wanted) {
  const auto essence = [](std::string_view name) {
    std::string text = base::toUpper(name);
    std::erase_if(text, [](char c) { return c == ' ' || c == '_' || c == '-'; });
    return text;
  };
  for (const machine::Tool& tool :
       machine.tools ? machine.tools->tools : std::vector<machine::Tool>{}) {
    if (!tool.name.empty() && essence(tool.name) == essence(wanted)) {
      return tool.name;
    }
  }
  return {};
}

Hazard hazardOf(const machine::DryFinding& found, const machine::MachineConfig& machine) {
  Hazard hazard;
  if (found.travel) {
    hazard.kind = HazardKind::Travel;
    hazard.travel = found.travel;
  } else if (found.speedPerMin > 0.0) {
    hazard.kind = HazardKind::SpindleSpeed;
    hazard.value = found.speedPerMin;
    hazard.limit = machine.spindle->speedPerMinMax;
  } else if (!found.tool.empty()) {
    hazard.kind = HazardKind::ToolMissing;
    hazard.text = found.tool;
    hazard.near = nearName(machine, found.tool);
  } else {
    hazard.kind = isOfLanguage(found.alarm.number) ? HazardKind::NotChecked : HazardKind::Refused;
    hazard.alarm = found.alarm.number;
    hazard.text = withoutLine(found.alarm.text);
  }
  return hazard;
}

/// Of several points of a stretch beyond the same limit, the farthest counts.
bool isFarther(const Hazard& hazard, const Hazard& before) {
  const auto beyond = [](const machine::BeyondTravel& travel) {
    return std::max(travel.target - travel.max, travel.min - travel.target);
  };
  return beyond(*hazard.travel) > beyond(*before.travel);
}

void add(std::vector<Hazard>& hazards, Hazard hazard) {
  const auto same = std::find_if(hazards.begin(), hazards.end(), [&](const Hazard& before) {
    return hazard.travel && hazard.stretch > 0 && before.stretch == hazard.stretch &&
           before.travel && before.travel->axis == hazard.travel->axis &&
           (before.travel->target > before.travel->max) ==
               (hazard.travel->target > hazard.travel->max);
  });
  if (same == hazards.end()) {
    hazards.push_back(std::move(hazard));
  } else if (isFarther(hazard, *same)) {
    *same = std::move(hazard);
  }
}

std::string travelText(const machine::BeyondTravel& travel) {
  const char* const unit = travel.isRotary() ? "°" : " mm";
  const double limit = travel.target > travel.max ? travel.max : travel.min;
  return fmt::format(
      "{} would go to {:.3f}{} in machine coordinates, {:.3f}{} beyond its limit of "
      "{:g}{}. Move the workpiece or change the work offset.",
      travel.axis, travel.target, unit, std::abs(travel.target - limit), unit, limit, unit);
}

std::string whatOf(const Hazard& hazard) {
  switch (hazard.kind) {
    case HazardKind::Travel:
      return travelText(*hazard.travel);
    case HazardKind::SpindleSpeed:
      return fmt::format(
          "S{:g} is {:g} 1/min more than the spindle can turn; the control reduces "
          "it to {:g} 1/min.",
          hazard.value, hazard.value - hazard.limit, hazard.limit);
    case HazardKind::ToolMissing:
      return fmt::format("tool {} is not in the tool table of the machine{}. ", hazard.text,
                         hazard.near.empty() ? "" : ", but " + hazard.near + " is") +
             "Enter it there, or choose another tool.";
    case HazardKind::Refused:
      return fmt::format("the machine would stop with alarm {}: {}", hazard.alarm, hazard.text);
    case HazardKind::NotChecked:
      return fmt::format(
          "from here on the job cannot be checked, because only the control knows "
          "what this block does: {}",
          hazard.text);
  }
  return {};
}

/// A job in short, and what a machine does with it.
struct DryJob {
  DryJob(const job::Plan& plan, const machine::MachineConfig& machine, const HazardOptions& options)
      : nativeCount(plan.nativeCount()),
        outline(job::outlineOf(plan)),
        run(machine::dryRun(machine, outline.text, {options.start, [this](base::LineNumber line) {
                                                      return lineOf(line).native > 0;
                                                    }})) {}
  [[nodiscard]] const job::OutlineLine& lineOf(base::LineNumber line) const {
    return outline.lines[line.value - 1];
  }
  /// By their number in the plan, less 1.
  [[nodiscard]] std::vector<base::Duration> nativeTimes() const {
    std::vector<base::Duration> times(nativeCount);
    for (const machine::DryTime& time : run.times) {
      times[static_cast<std::size_t>(lineOf(time.line).native) - 1] += time.duration;
    }
    return times;
  }

  std::size_t nativeCount;
  job::Outline outline;
  machine::DryRun run;
};

/// In machine coordinates. Of a motion with feed its beginning as well: there it plunges.
streaming::CutBox cutOf(const job::Plan& plan, const DryJob& dry) {
  streaming::CutBox cut;
  std::map<int, base::Vec3> zeroMm;  // of stretches
  for (const machine::DryMotion& motion : dry.run.motions) {
    const job::OutlineLine& from = dry.lineOf(motion.line);
    if (from.stretch > 0) {
      zeroMm.try_emplace(from.stretch, motion.zeroMm);
    } else if (!motion.isRapid) {
      cut.add(motion.from.mm + motion.zeroMm);
      cut.add(motion.toMm + motion.zeroMm);
    }
  }
  const std::vector<gcode::TrajectoryPoint>& points = plan.program.trajectory.points;
  for (const job::Part& part : plan.parts) {
    const auto* const stretch = std::get_if<job::Stretch>(&part);
    const auto zero = stretch != nullptr ? zeroMm.find(stretch->number) : zeroMm.end();
    for (std::size_t i = 0; zero != zeroMm.end() && i < stretch->pointCount; ++i) {
      const gcode::TrajectoryPoint& point = points[stretch->firstPoint + i];
      if (point.kind != gcode::MoveKind::Rapid) {
        cut.add(point.positionMm + zero->second);
        cut.add((i > 0 ? points[stretch->firstPoint + i - 1].positionMm : stretch->startMm) +
                zero->second);
      }
    }
  }
  return cut;
}

}  // namespace

std::string_view hazardName(HazardKind kind) {
  static constexpr std::array<std::string_view, 5> kNames{"travel", "spindle-speed", "tool-missing",
                                                          "refused", "not-checked"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string describe(const Hazard& hazard) {
  const std::string place = hazard.file.empty()
                                ? fmt::format("Line {}", hazard.line.value)
                                : fmt::format("{}, line {}", hazard.file, hazard.line.value);
  return fmt::format("{}{}: {}", place,
                     hazard.stretch > 0 ? fmt::format(" (stretch {})", hazard.stretch) : "",
                     whatOf(hazard));
}

CheckedJob checkJob(const job::Plan& plan, const machine::MachineConfig& machine,
                    const HazardOptions& options) {
  const DryJob dry(plan, machine, options);
  const std::vector<const job::NativeBlock*> natives = nativesOf(plan);
  CheckedJob checked;
  for (const machine::DryFinding& found : dry.run.findings) {
    const job::OutlineLine& from = dry.lineOf(found.line);
    Hazard hazard = hazardOf(found, machine);
    hazard.line = from.line;
    hazard.stretch = from.stretch;
    if (from.native > 0) {
      hazard.file = natives[static_cast<std::size_t>(from.native) - 1]->file;
    }
    add(checked.hazards, std::move(hazard));
  }
  checked.nativeTimes = dry.nativeTimes();
  checked.cut = cutOf(plan, dry);
  return checked;
}

namespace {

std::optional<streaming::CutOnTheWay> cutFrom(const job::Plan& plan,
                                              const machine::MachineConfig& machine,
                                              const base::AxisPosition& tool,
                                              const streaming::CutBox& cut) {
  const auto stretch =
      std::find_if(plan.parts.begin(), plan.parts.end(), [](const job::Part& part) {
        const auto* const each = std::get_if<job::Stretch>(&part);
        return each != nullptr && each->number > 0;
      });
  const auto until = static_cast<std::size_t>(stretch - plan.parts.begin());
  const machine::DryRun run = machine::dryRun(machine, job::outlineOf(plan, until).text,
                                              {.start = tool, .endsWithFeed = true});
  for (const machine::DryMotion& motion : run.motions) {
    const auto found =
        streaming::cutOnTheWay(motion.from.mm + motion.zeroMm, motion.toMm + motion.zeroMm, cut);
    if (found || !motion.isRapid) {
      return found;
    }
  }
  if (stretch == plan.parts.end() || !run.isComplete) {
    return std::nullopt;
  }
  const gcode::Program program = streaming::programOf(plan, std::get<job::Stretch>(*stretch));
  const base::Vec3 first = streaming::firstPlace(program.trajectory, run.axesMm - run.zeroMm);
  return streaming::cutOnTheWay(run.axesMm, first + run.zeroMm, cut);
}

}  // namespace

std::optional<streaming::CutOnTheWay> cutOnTheWay(const job::Plan& plan,
                                                  const machine::MachineConfig& machine,
                                                  const base::AxisPosition& tool,
                                                  const streaming::CutBox& cut) {
  auto found = cutFrom(plan, machine, tool, cut);
  if (found) {
    base::AxisPosition raised = tool;
    raised.mm.z = found->heightMm;
    found->isClearFromAbove =
        found->heightMm > tool.mm.z && !cutFrom(plan, machine, raised, cut).has_value();
  }
  return found;
}

std::vector<Hazard> hazardsOf(const job::Plan& plan, const machine::MachineConfig& machine,
                              const HazardOptions& options) {
  return checkJob(plan, machine, options).hazards;
}

base::Result<void> requireNoHazard(const job::Plan& plan, const std::vector<Hazard>& hazards) {
  const auto stops = [](const Hazard& hazard) { return hazard.stops(); };
  const auto first = std::find_if(hazards.begin(), hazards.end(), stops);
  if (first == hazards.end()) {
    return {};
  }
  const auto count = std::count_if(hazards.begin(), hazards.end(), stops);
  return base::fail(
      job::JobError::BeyondMachine,
      describe(*first) + (count > 1 ? fmt::format(" ({} more of this kind.)", count - 1) : ""),
      plan.program.name);
}

namespace {

/// Times of stretches and native blocks.
class Forecaster {
 public:
  Forecaster(const job::Plan& plan, const machine::MachineConfig& machine,
             const streaming::RunSettings& settings, const HazardOptions& options)
      : m_plan(plan), m_machine(machine), m_settings(settings) {
    const DryJob dry(plan, machine, options);
    for (const machine::DryMotion& motion : dry.run.motions) {
      m_starts.try_emplace(dry.lineOf(motion.line).stretch, motion.from);
    }
    m_nativeTimes = dry.nativeTimes();
  }

  JobForecast forecast() {
    std::size_t native = 0;
    for (std::size_t part = 0; part < m_plan.parts.size(); ++part) {
      streaming::JobTimes times;
      if (const auto* const block = std::get_if<job::NativeBlock>(&m_plan.parts[part])) {
        const bool isTool = block->reason == job::NativeReason::Tool;
        (isTool ? times.toolChange : times.native) = m_nativeTimes[native++];
      } else if (const auto& stretch = std::get<job::Stretch>(m_plan.parts[part]);
                 stretch.number > 0) {
        times = timesOf(stretch);
      } else {
        continue;
      }
      m_forecast.times += times;
      m_forecast.parts.push_back({part, times});
    }
    return std::move(m_forecast);
  }

 private:
  streaming::JobTimes timesOf(const job::Stretch& stretch) {
    const gcode::Program program = streaming::programOf(m_plan, stretch);
    const auto start = m_starts.find(stretch.number);
    const base::AxisPosition from =
        start != m_starts.end() ? start->second : base::AxisPosition{};  // not checked so far
    const auto points =
        gcode::streamPoints(program.trajectory, from.mm, from.deg,
                            m_settings.programFeeds ? &*m_settings.programFeeds : nullptr)
            .points;
    streaming::JobTimes times;
    times.handover = kHandover;
    if (points.empty()) {
      return times;
    }
    const std::vector<streaming::PlannedPause> pauses =
        streaming::plannedPauses(points, m_settings.parameters.method,
                                 static_cast<std::size_t>(m_settings.parameters.pointsPerLoop),
                                 streaming::windowCut(m_settings));
    PathTimeOptions options;
    options.feedMmPerS = m_settings.programFeeds ? 0.0 : m_settings.feedMmPerS;
    options.programFeeds = m_settings.programFeeds;
    options.pauseS = base::toSeconds(m_machine.standstillMean);
    for (const streaming::PlannedPause& pause : pauses) {
      options.pausesBehind.push_back(pause.point);
    }
    const PathTime path = *pathTime(program.trajectory, from.mm, m_machine, options);
    times.streamed = kStretchEnds + base::fromSeconds(path.totalS - path.standingS);
    times.pauses = base::fromSeconds(path.standingS);
    return times;
  }

  const job::Plan& m_plan;
  const machine::MachineConfig& m_machine;
  const streaming::RunSettings& m_settings;
  std::vector<base::Duration> m_nativeTimes;   ///< by number of the block, less 1
  std::map<int, base::AxisPosition> m_starts;  ///< of stretches, workpiece frame, by number
  JobForecast m_forecast;
};

}  // namespace

JobForecast forecast(const job::Plan& plan, const machine::MachineConfig& machine,
                     const streaming::RunSettings& settings, const HazardOptions& options) {
  return Forecaster(plan, machine, settings, options).forecast();
}

}  // namespace rivulet::forecast
