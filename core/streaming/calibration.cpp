// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "streaming/access_probe.h"
#include "streaming/job.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Result;

constexpr std::array<int, 7> kCounts{1, 2, 5, 10, 20, 50, 100};
constexpr double kReset = 0.0;

/// One request, and how long it took.
Result<Duration> shoot(opcua::Link& link, bool write, std::span<const opcua::Variable> variables,
                       std::span<const opcua::Assignment> assignments, opcua::Grouping grouping,
                       Duration deadline) {
  const base::RequestId id = write ? link.write(assignments, deadline, grouping)
                                   : link.read(variables, deadline, grouping);
  const Result<opcua::Event> event = awaitAnswer(link, id, deadline);
  if (!event) {
    return base::fail(event.error());
  }
  return event->at - event->sent;
}

AccessFit fitOf(const std::vector<AccessSeries>& series, bool write, opcua::Grouping grouping) {
  double n = 0.0;
  double sx = 0.0;
  double sy = 0.0;
  double sv = 0.0;
  double sxx = 0.0;
  double sxy = 0.0;
  double sxv = 0.0;
  const auto each = [&](auto use) {
    for (const AccessSeries& one : series) {
      if (one.write == write && one.grouping == grouping) {
        use(static_cast<double>(one.nodes), base::toMilliseconds(one.durations.mean),
            one.deviationMs * one.deviationMs);
      }
    }
  };
  each([&](double x, double y, double v) {
    n += 1.0;
    sx += x;
    sy += y;
    sv += v;
    sxx += x * x;
    sxy += x * y;
    sxv += x * v;
  });
  AccessFit fit;
  const double spread = n * sxx - sx * sx;
  if (spread <= 0.0) {
    fit.nodeMs = n > 0.0 ? sy / sx : 0.0;  // one size only: all of it counts as nodes
    return fit;
  }
  fit.nodeMs = (n * sxy - sx * sy) / spread;
  fit.overheadMs = (sy - fit.nodeMs * sx) / n;
  fit.nodeDeviationMs = std::sqrt(std::max(0.0, (n * sxv - sx * sv) / spread));
  double squares = 0.0;
  each([&](double x, double y, double) {
    squares += std::pow(y - fit.overheadMs - fit.nodeMs * x, 2);
  });
  fit.residualMs = std::sqrt(squares / n);
  return fit;
}

}  // namespace

std::error_code make_error_code(CalibrationError code) {
  static const base::NamedCategory category("calibration");
  return {static_cast<int>(code), category};
}

Result<Calibration> calibrate(opcua::Link& link, const CalibrationPlan& plan,
                              const std::function<bool(double, Duration)>& progress) {
  const int cells = plan.lastCell - plan.firstCell + 1;
  if (plan.firstCell < 0 || cells < 1 || plan.shots < 2) {
    return base::fail(CalibrationError::NoCells,
                      "Name a range of R-parameters that nobody uses, and at least 2 shots.");
  }
  const std::array<opcua::Variable, 1> channel{{{opcua::VariableKind::ChannelStatus, 0}}};
  const auto status = readNow(link, channel, plan.deadline);
  if (!status) {
    return base::fail(status.error());
  }
  if ((*status)[0].status || (*status)[0].number != kReset) {
    return base::fail(CalibrationError::ChannelBusy,
                      "A program runs on the control. Let it end before measuring.");
  }
  std::vector<opcua::Variable> variables;
  for (int cell = plan.firstCell; cell <= plan.lastCell; ++cell) {
    variables.push_back(opcua::rParameter(cell));
  }
  const auto before = readNow(link, variables, plan.deadline);
  if (!before) {
    return base::fail(before.error());
  }
  std::vector<opcua::Assignment> restore;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if ((*before)[i].status) {
      return base::fail(CalibrationError::NoCells,
                        fmt::format("R{} cannot be read. Choose cells that exist (MD28050).",
                                    variables[i].index));
    }
    restore.push_back({variables[i], (*before)[i].number});
  }

  Calibration result;
  std::vector<opcua::Grouping> groupings{opcua::Grouping::List, opcua::Grouping::Single};
  if (plan.arrays && cells >= ScratchCells::kCountMin) {
    Result<AccessForms> forms = probeAccess(link, {plan.firstCell, plan.lastCell}, plan.deadline);
    if (!forms) {
      return base::fail(forms.error());
    }
    if (const auto array = forms->array()) {
      groupings.push_back(*array);
    }
    result.forms = std::move(*forms);
  }

  // The same values are written that stand there: whatever happens, nothing is lost.
  double total = 0.0;
  for (const int count : kCounts) {
    total +=
        count <= cells ? 2.0 * static_cast<double>(groupings.size()) * count * plan.shots : 0.0;
  }
  double done = 0.0;
  const base::Instant from = link.now();
  for (const int count : kCounts) {
    if (count > cells) {
      break;
    }
    const auto nodes = static_cast<std::size_t>(count);
    for (const bool write : {false, true}) {
      for (const opcua::Grouping grouping : groupings) {
        std::vector<Duration> durations;
        for (int shot = 0; shot < plan.shots; ++shot) {
          const auto took = shoot(link, write, std::span(variables).first(nodes),
                                  std::span(restore).first(nodes), grouping, plan.deadline);
          if (!took) {
            return base::fail(took.error());
          }
          durations.push_back(*took);
          done += count;
          const double share = done / total;
          const Duration left{static_cast<Duration::rep>(
              static_cast<double>((link.now() - from).count()) * (1.0 - share) / share)};
          if (progress && !progress(share, left)) {
            return base::fail(CalibrationError::Cancelled,
                              "The measurement was cancelled; the cells are as they were.");
          }
        }
        AccessSeries series{write, count, grouping, trace::durationStatistics(durations), 0.0};
        double squares = 0.0;
        for (const Duration duration : durations) {
          squares += std::pow(base::toMilliseconds(duration - series.durations.mean), 2);
        }
        series.deviationMs = std::sqrt(squares / (plan.shots - 1));
        result.series.push_back(series);
      }
    }
  }
  result.read = fitOf(result.series, false, opcua::Grouping::List);
  result.write = fitOf(result.series, true, opcua::Grouping::List);
  if (groupings.size() > 2) {
    result.arrayRead = fitOf(result.series, false, groupings.back());
    result.arrayWrite = fitOf(result.series, true, groupings.back());
  }
  return result;
}

}  // namespace rivulet::streaming
