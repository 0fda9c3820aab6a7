// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/main_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/hash.h"
#include "base/text.h"
#include "base/units.h"
#include "job/main_writer.h"
#include "job/plan_writer.h"
#include "nc/nc_number.h"

namespace rivulet::job {

namespace {

using templates::JobProtocol;

class Category final : public std::error_category {
 public:
  [[nodiscard]] const char* name() const noexcept override { return "job"; }
  [[nodiscard]] std::string message(int code) const override {
    switch (static_cast<JobError>(code)) {
      case JobError::NotWhole:
        return "the program is no whole job";
      case JobError::ReadsVariables:
        return "a native block reads variables";
      case JobError::IncrementInFrame:
        return "a native block moves by an increment in a frame";
      case JobError::TooManyStretches:
        return "too many stretches";
      case JobError::PositionDiffers:
        return "the tool is not where the program says";
      case JobError::BeyondMachine:
        return "beyond what the machine can do";
      case JobError::FunctionMalformed:
        return "not what a control does for an M function";
      case JobError::NotDry:
        return "no dry run";
      case JobError::NotTranslated:
        return "no words for a block on this control";
    }
    return "unknown error";
  }
};

constexpr std::string_view kNamePrefix = "RIVJOB_";

/// After such a block the same coordinates may be another place.
bool mayShift(const NativeBlock& native) {
  switch (native.reason) {
    case NativeReason::Transformation:
    case NativeReason::Cycle:
    case NativeReason::Subprogram:
    case NativeReason::Retract:  // D0
    case NativeReason::Tool:
    case NativeReason::WorkOffset:
    case NativeReason::Other:
      return true;
    default:
      return native.setsFrame;
  }
}

/// The words of a point, "X1 Y2 C90", as far as the program has named the axes.
std::string pointWords(const gcode::Trajectory& trajectory, std::size_t point) {
  std::string words;
  const auto add = [&words](char axis, double value) {
    if (!std::isnan(value)) {
      words += fmt::format("{}{} ", axis, nc::ncNumber(value));
    }
  };
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    add(base::kAxisNames[axis], trajectory.points[point].positionMm[axis]);
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount && !trajectory.rotary.empty(); ++axis) {
    add(base::kRotaryAxisNames[axis], trajectory.rotary[point].degrees[axis]);
  }
  return words;
}

class PlainWriter final : public PlanWriter {
 public:
  PlainWriter(const Plan& plan, const std::optional<gcode::ProgramFeeds>& feeds, double feedMmPerS)
      : PlanWriter(plan), m_feeds(feeds), m_feedMmPerS(feedMmPerS) {}

  std::string write() {
    writeParts(plan().parts.size());
    line("M30");
    return take();
  }

 private:
  void writeStreamed(const Stretch& stretch) override {
    const gcode::Trajectory& trajectory = plan().program.trajectory;
    cancelOverride();
    line("G90 G94 G64");
    for (std::size_t i = 0; i < stretch.pointCount; ++i) {
      const std::size_t point = stretch.firstPoint + i;
      const double mmPerS =
          m_feeds ? gcode::commandedMmPerS(trajectory.points[point], *m_feeds) : m_feedMmPerS;
      line("G1 {}F{}", pointWords(trajectory, point),
           nc::ncNumber(base::mmPerMinFromMmPerS(mmPerS)));
    }
  }
  void writeDue(const NativeBlock&, int) override {}

  const std::optional<gcode::ProgramFeeds>& m_feeds;
  double m_feedMmPerS;
};

class OutlineWriter final : public PlanWriter {
 public:
  using PlanWriter::PlanWriter;

  Outline write(std::size_t untilPart) {
    writeParts(untilPart);
    cancelFrame();
    line("M30");
    m_outline.text = take();
    m_outline.lines.resize(lineCount());
    return std::move(m_outline);
  }

 private:
  /// What was inserted may read the position of the axes, which is not known here.
  [[nodiscard]] const std::string& textOf(const NativeBlock& native) const override {
    return native.isInserted ? native.source : native.text;
  }
  void writeStreamed(const Stretch& stretch) override {
    const gcode::Trajectory& trajectory = plan().program.trajectory;
    for (const std::size_t point : extremes(stretch)) {
      line("G0 G90 {}", pointWords(trajectory, point));
      place({0, stretch.number, trajectory.points[point].line});
    }
  }
  void writeDue(const NativeBlock& native, int number) override {
    place({number, 0, native.place.line});
  }
  void written(const NativeBlock& native, int number) override {
    place({number, 0, native.place.line});
  }

  /// All lines since the last call stand for this.
  void place(const OutlineLine& what) { m_outline.lines.resize(lineCount(), what); }

  /// In each axis the farthest points either way, and the last one, in their order.
  [[nodiscard]] std::vector<std::size_t> extremes(const Stretch& stretch) const {
    const gcode::Trajectory& trajectory = plan().program.trajectory;
    const std::size_t last = stretch.firstPoint + stretch.pointCount - 1;
    std::vector<std::size_t> points{last};
    const auto search = [&](const auto& valueAt) {
      std::size_t low = last;
      std::size_t high = last;
      for (std::size_t point = stretch.firstPoint; point < last; ++point) {
        // Not known at the end: not known before it either.
        low = valueAt(point) < valueAt(low) ? point : low;
        high = valueAt(point) > valueAt(high) ? point : high;
      }
      points.insert(points.end(), {low, high});
    };
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      search([&](std::size_t point) { return trajectory.points[point].positionMm[axis]; });
    }
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount && !trajectory.rotary.empty();
         ++axis) {
      search([&](std::size_t point) { return trajectory.rotary[point].degrees[axis]; });
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
  }

  Outline m_outline;
};

}  // namespace

base::Result<void> requireWhole(const Plan& plan) {
  if (!plan.isWhole()) {
    const auto isError = [](const gcode::Diagnostic& found) {
      return found.severity == gcode::Severity::Error;
    };
    const auto& found = plan.program.diagnostics;
    const auto first = std::find_if(found.begin(), found.end(), isError);
    const auto reading = std::find_if(found.begin(), found.end(), [](const auto& each) {
      return each.code == gcode::DiagnosticCode::CentreReading;
    });
    if (first != found.end() && reading != found.end() &&
        first->code == gcode::DiagnosticCode::ArcRadiusMismatch) {
      return base::fail(
          JobError::NotWhole,
          fmt::format(
              "Not all arcs fit as their centres are written, but all fit if I, J and K are "
              "read as {0}: if the post-processor writes them so, confirm it with "
              "--arc-centres {0}.",
              reading->argument),
          fmt::format("{}:{}", plan.program.name, first->line.value));
    }
    return plan.refusals.empty()
               ? base::fail(JobError::NotWhole, gcode::describe(*first),
                            fmt::format("{}:{}", plan.program.name, first->line.value))
               : base::fail(
                     JobError::NotWhole, describe(plan.refusals.front()),
                     fmt::format("{}:{}", plan.program.name, plan.refusals.front().line.value));
  }
  // An increment also passes the shift of a tool, offset or frame, unless the axis has been placed
  // since: which streaming does with every axis.
  std::array<bool, base::kAxisCount> isShifted{};   ///< the axis has not been placed since
  std::array<bool, base::kAxisCount> losesShift{};  ///< and a stretch has been streamed
  bool isAfterNative = false;
  for (const Part& part : plan.parts) {
    const auto* const native = std::get_if<NativeBlock>(&part);
    if (native == nullptr) {
      const auto& stretch = std::get<Stretch>(part);
      for (std::size_t axis = 0; axis < base::kAxisCount && stretch.number > 0; ++axis) {
        const std::size_t last = stretch.firstPoint + stretch.pointCount - 1;
        isShifted[axis] =
            isShifted[axis] && std::isnan(plan.program.trajectory.points[last].positionMm[axis]);
        losesShift[axis] = isShifted[axis];
      }
      isAfterNative = false;
      continue;
    }
    const auto refuse = [&](JobError code, const char* reason) {
      return base::fail(code, reason + native->source,
                        fmt::format("{}:{}", plan.program.name, native->place.line.value));
    };
    if (native->calculates) {
      return refuse(JobError::ReadsVariables,
                    "A block for the control reads variables, whose values only Rivulet has "
                    "computed. Write the values into it: ");
    }
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const bool hasFrame = !native->frame.empty() || native->before.incrementFrom[axis];
      if (native->increments[axis] && (losesShift[axis] || (hasFrame && !isAfterNative))) {
        return refuse(JobError::IncrementInFrame,
                      "A block for the control moves by an increment after a tool, an offset or a "
                      "frame has shifted the axis. Write it with G90: ");
      }
      const bool shifts = mayShift(*native) && native->shifts[axis];
      isShifted[axis] = (isShifted[axis] || shifts) && !native->places[axis];
      losesShift[axis] = losesShift[axis] && !native->places[axis];
    }
    isAfterNative = true;
  }
  if (plan.stretchCount() > static_cast<std::size_t>(JobProtocol::kStretchesMax)) {
    return base::fail(JobError::TooManyStretches,
                      fmt::format("The program has {} stretches, more than {}: split it.",
                                  plan.stretchCount(), JobProtocol::kStretchesMax));
  }
  return {};
}

std::string plainProgramOf(const Plan& plan, const std::optional<gcode::ProgramFeeds>& feeds,
                           double feedMmPerS) {
  return PlainWriter(plan, feeds, feedMmPerS).write();
}

std::error_code make_error_code(JobError code) {
  static const Category category;
  return {static_cast<int>(code), category};
}

int doneNumber(const Plan& plan) {
  return static_cast<int>(plan.nativeCount()) + 1;
}

int blockCell(const templates::JobLoop& loop) {
  return loop.cells.client;
}

Outline outlineOf(const Plan& plan, std::size_t untilPart) {
  return OutlineWriter(plan).write(untilPart);
}

std::string mainNameOf(const JobName& name) {
  return fmt::format("{}{}B{}.MPF", kNamePrefix, name.number, name.baseCell);
}

std::optional<JobName> jobNameOf(std::string_view fileName) {
  const std::string name = base::toUpper(fileName);
  const std::size_t begin = name.rfind(kNamePrefix);
  if (begin == std::string::npos) {
    return std::nullopt;
  }
  const std::string_view rest = std::string_view(name).substr(begin + kNamePrefix.size());
  const std::size_t cell = rest.find('B');
  if (cell == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view digits = rest.substr(cell + 1);
  const auto number = base::parseInteger(rest.substr(0, cell));
  const auto baseCell = base::parseInteger(
      digits.substr(0, std::min(digits.size(), digits.find_first_not_of("0123456789"))));
  return number && baseCell ? std::optional(JobName{*number, *baseCell}) : std::nullopt;
}

base::Result<JobPrograms> makePrograms(const Plan& plan,
                                       const templates::TemplateParameters& parameters) {
  if (base::Result<void> whole = requireWhole(plan); !whole) {
    return base::fail(whole.error());
  }
  base::Result<templates::JobLoop> loop = templates::makeJobLoop(parameters);
  if (!loop) {
    return base::fail(loop.error());
  }
  constexpr std::uint64_t kNumbers = (1U << 24U) - 1;
  JobPrograms programs;
  const base::Result<std::string> unnumbered = mainProgramOf(plan, *loop, 0);
  if (!unnumbered) {
    return base::fail(unnumbered.error());
  }
  programs.number = 1 + static_cast<int>(base::hashOf(*unnumbered + loop->text) % kNumbers);
  programs.mainName = mainNameOf({programs.number, parameters.baseCell});
  programs.mainText = *mainProgramOf(plan, *loop, programs.number);
  programs.loop = std::move(*loop);
  return programs;
}

}  // namespace rivulet::job
