// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "forecast/machine_verdict.h"

#include <algorithm>

#include "feasibility/probability.h"
#include "forecast/region.h"

namespace rivulet::forecast {

namespace {

/// Methods position and signal: feeds are looked at from this share of the one that the equations
/// allow. What needs still less is not allowed at all: slow runs take long to follow.
constexpr double kSlowest = 0.2;
/// Methods with windows: from this share of the feed that is judged.
constexpr double kSlowestWithWindows = 0.01;

/// What is judged, at any feed.
class Judged {
 public:
  Judged(const machine::MachineConfig& machine, const std::vector<gcode::StreamPoint>& points,
         const feasibility::OperatingPoint& operatingPoint,
         const feasibility::ProgramDistances& distances, const feasibility::AccessModel& access)
      : m_point(operatingPoint) {
    const std::size_t around =
        feasibility::tightestPlace(distances, operatingPoint.method).point.value;
    m_points = stretchOf(points, std::min(around, points.size() - 1), kJudgedPointsMax);
    m_failuresMax =
        static_cast<double>(m_points.size()) / static_cast<double>(points.size()) / kRunsPerFailure;
    machine::MachineConfig charged = machine;
    if (access.measured) {
      charge(charged.access, *access.measured);
    }
    for (const machine::Dynamics dynamics : {machine::Dynamics::Brisk, machine::Dynamics::Soft}) {
      charged.resetDynamics = dynamics;
      m_models.push_back(streamModelOf(charged));
    }
  }

  [[nodiscard]] bool goesWrongAt(double feedMmPerS) const {
    return std::ranges::any_of(m_models, [&](const feasibility::StreamModel& model) {
      return at(feedMmPerS, model).failureProbability > m_failuresMax ||
             at(feedMmPerS * kFeedReserve, model).failureProbability > m_failuresMax;
    });
  }
  [[nodiscard]] bool waitsAt(double feedMmPerS) const {
    return std::ranges::any_of(m_models, [&](const feasibility::StreamModel& model) {
      return at(feedMmPerS, model).waiting > base::Duration::zero();
    });
  }

 private:
  [[nodiscard]] feasibility::Prediction at(double feedMmPerS,
                                           const feasibility::StreamModel& model) const {
    feasibility::OperatingPoint point = m_point;
    point.feedMmPerS = feedMmPerS;
    std::vector<gcode::StreamPoint> points = m_points;
    for (gcode::StreamPoint& one : points) {
      one.feedMmPerS *= feedMmPerS / m_point.feedMmPerS;
    }
    return feasibility::predict(points, point, model);
  }

  feasibility::OperatingPoint m_point;
  std::vector<gcode::StreamPoint> m_points;
  std::vector<feasibility::StreamModel> m_models;  ///< each of the dynamics
  double m_failuresMax = 0.0;
};

}  // namespace

void charge(machine::AccessCost& cost, const feasibility::MeasuredAccess& measured) {
  const double before = static_cast<double>(std::max<std::int64_t>(1, cost.nodeTimeMean.count()));
  cost.readOverhead = measured.read.overhead;
  cost.writeOverhead = measured.write.overhead;
  cost.nodeTimeMean = std::max(measured.read.perNode, measured.write.perNode);
  const double scale = static_cast<double>(cost.nodeTimeMean.count()) / before;
  const auto scaled = [scale](base::Duration duration) {
    return base::Duration(
        static_cast<base::Duration::rep>(static_cast<double>(duration.count()) * scale));
  };
  cost.nodeTimeDeviation = scaled(cost.nodeTimeDeviation);
  cost.nodeTimeMin = scaled(cost.nodeTimeMin);
}

base::Result<feasibility::Verdict> judgeOn(const machine::MachineConfig& machine,
                                           const std::vector<gcode::StreamPoint>& points,
                                           const feasibility::OperatingPoint& operatingPoint,
                                           const feasibility::ProgramDistances& distances,
                                           const feasibility::AccessModel& access,
                                           const feasibility::SafetyFactors& safety) {
  auto verdict = feasibility::judge(operatingPoint, distances, access, safety);
  if (!verdict || points.size() < 2) {
    return verdict;
  }
  const Judged judged(machine, points, operatingPoint, distances, access);
  const bool hasWindows = base::hasWindows(operatingPoint.method);
  double largestMmPerS = verdict->feedMmPerSMax;
  if (hasWindows) {
    const double fastestMmPerS = std::max(machine.rapidMmPerS, 2.0 * operatingPoint.feedMmPerS);
    largestMmPerS = feasibility::largestFeedMmPerS(
        [&judged](double feedMmPerS) { return judged.waitsAt(feedMmPerS); },
        kSlowestWithWindows * operatingPoint.feedMmPerS, fastestMmPerS);
  } else if (largestMmPerS > 0.0) {
    largestMmPerS = feasibility::largestFeedMmPerS(
        [&judged](double feedMmPerS) { return judged.goesWrongAt(feedMmPerS); },
        kSlowest * largestMmPerS, largestMmPerS);
    // The probability can rise and fall again over the feed: the search may have passed over the
    // very feed that is asked for.
    const double askedMmPerS = operatingPoint.feedMmPerS;
    if (askedMmPerS < largestMmPerS && judged.goesWrongAt(askedMmPerS)) {
      const double slowestMmPerS = kSlowest * askedMmPerS;
      largestMmPerS = askedMmPerS / kFeedReserve;
      while (largestMmPerS > slowestMmPerS && judged.goesWrongAt(largestMmPerS)) {
        largestMmPerS /= kFeedReserve;
      }
      largestMmPerS = largestMmPerS > slowestMmPerS ? largestMmPerS : 0.0;
    }
  }
  feasibility::Condition condition{feasibility::Equation::Machine,
                                   largestMmPerS / operatingPoint.feedMmPerS, true,
                                   feasibility::tightestPlace(distances, operatingPoint.method)};
  const bool decides = hasWindows || largestMmPerS < verdict->feedMmPerSMax;
  if (hasWindows) {
    for (feasibility::Condition& other : verdict->conditions) {
      other.decides = false;
    }
  }
  verdict->conditions.push_back(condition);
  if (decides) {
    verdict->limiting = condition;
    verdict->feedMmPerSMax = largestMmPerS;
    verdict->feasible = hasWindows || condition.margin > 1.0;
    verdict->waits = hasWindows && condition.margin <= 1.0;
  }
  return verdict;
}

}  // namespace rivulet::forecast
