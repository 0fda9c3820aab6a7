// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/advice.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/contract.h"
#include "base/units.h"
#include "gcode/feeds.h"

namespace rivulet::feasibility {

namespace {

/// Steps in which an operator types δ and the feed.
constexpr double kDeltaStepMm = 0.01;
constexpr double kFeedStepMmPerMin = 1.0;
constexpr double kOverrideStep = 0.01;

class Adviser {
 public:
  Adviser(const std::vector<gcode::StreamPoint>& points, const AdviceQuestion& question,
          const std::function<bool()>& goOn)
      : m_points(points), m_question(question), m_goOn(goOn) {}

  std::vector<Advice> advise() {
    const auto verdict = judged(m_question.operatingPoint);
    if (!verdict) {
      return {};
    }
    m_feedMmPerSMax = verdict->feedMmPerSMax;
    lowerOrRaiseFeed(*verdict);
    changePointsPerLoop();
    changeDelta();
    changeMethod();
    if (!goesOn()) {
      return {};
    }
    sortByGain(m_list);
    return m_list;
  }

 private:
  [[nodiscard]] bool goesOn() const { return !m_goOn || m_goOn(); }

  [[nodiscard]] bool usesProgramFeeds() const { return m_question.fullFeedMmPerS > 0.0; }

  [[nodiscard]] OperatingPoint completed(const OperatingPoint& point) const {
    return m_question.complete ? m_question.complete(point) : point;
  }

  /// No override is larger than the largest that can be set.
  [[nodiscard]] double reachable(double feedMmPerS) const {
    return usesProgramFeeds()
               ? std::min(feedMmPerS, gcode::kOverrideMax * m_question.fullFeedMmPerS)
               : feedMmPerS;
  }

  /// A feed or an override as it is typed, strictly below the limit.
  [[nodiscard]] double typedBelow(double feedMmPerSMax) const {
    const double stepMmPerS = usesProgramFeeds() ? kOverrideStep * m_question.fullFeedMmPerS
                                                 : base::mmPerSFromMmPerMin(kFeedStepMmPerMin);
    return reachable(std::max(1.0, std::ceil(feedMmPerSMax / stepMmPerS) - 1.0) * stepMmPerS);
  }

  [[nodiscard]] std::optional<Verdict> judged(const OperatingPoint& point) const {
    if (point.pointsPerLoop < 2) {
      return std::nullopt;
    }
    const auto verdict =
        judge(point, programDistances(m_points, point.pointsPerLoop, m_question.fullFeedMmPerS),
              m_question.access, m_question.safety);
    return verdict ? std::optional(*verdict) : std::nullopt;
  }

  void add(AdviceKind kind, const OperatingPoint& after, double feedMmPerSMax) {
    const Advice advice{kind, m_question.operatingPoint, after, reachable(m_feedMmPerSMax),
                        reachable(feedMmPerSMax)};
    if (advice.gain() >= kAdviceGainMin && std::isfinite(advice.gain())) {
      m_list.push_back(advice);
    }
  }

  void lowerOrRaiseFeed(const Verdict& verdict) {
    OperatingPoint after = m_question.operatingPoint;
    after.feedMmPerS = typedBelow(m_feedMmPerSMax);
    if (verdict.feasible && !verdict.waits) {
      add(AdviceKind::Feed, after, m_feedMmPerSMax);
    } else if (after.feedMmPerS < m_question.operatingPoint.feedMmPerS) {
      m_list.push_back(
          {AdviceKind::Feed, m_question.operatingPoint, after, m_feedMmPerSMax, m_feedMmPerSMax});
    }
  }

  void changePointsPerLoop() {
    OperatingPoint best = m_question.operatingPoint;
    double bestMmPerS = m_feedMmPerSMax;
    OperatingPoint tried = best;
    for (int n = 2; n <= m_question.pointsPerLoopMax && goesOn(); ++n) {
      tried.pointsPerLoop = n;
      tried = completed(tried);
      const auto verdict = judged(tried);
      // A hair more is no reason for more points on the way.
      if (verdict && verdict->feedMmPerSMax > bestMmPerS * (1.0 + 1e-9)) {
        best = tried;
        bestMmPerS = verdict->feedMmPerSMax;
      }
    }
    add(AdviceKind::PointsPerLoop, best, bestMmPerS);
  }

  /// The smallest δ with which (2) no longer limits the feed. Beyond half the smallest distance,
  /// the tool would be within δ of two points at once.
  void changeDelta() {
    OperatingPoint after = m_question.operatingPoint;
    if (!base::usesDelta(after.method)) {
      return;
    }
    const double largestMm =
        programDistances(m_points, std::max(2, after.pointsPerLoop)).pointDistanceMmMin / 2.0;
    const auto steps = static_cast<int>(std::floor(largestMm / kDeltaStepMm));
    after.deltaMm = steps * kDeltaStepMm;
    if (!(after.deltaMm > m_question.operatingPoint.deltaMm)) {
      return;
    }
    const auto most = judged(after);
    if (!most) {
      return;
    }
    // At the feed that (1) permits, (2) needs just this much.
    OperatingPoint needed = after;
    needed.feedMmPerS = most->feedMmPerSMax;
    if (const auto atLimit = judged(needed)) {
      after.deltaMm =
          std::min(after.deltaMm, std::ceil(atLimit->deltaMmMin / kDeltaStepMm) * kDeltaStepMm);
    }
    if (const auto verdict = judged(after)) {
      add(AdviceKind::Delta, after, verdict->feedMmPerSMax);
    }
  }

  void changeMethod() {
    for (const base::MethodKind method : m_question.methods) {
      OperatingPoint after = m_question.operatingPoint;
      if (method == after.method || !goesOn()) {
        continue;
      }
      after.method = method;
      after = completed(after);
      if (const auto verdict = judged(after)) {
        add(AdviceKind::Method, after, verdict->feedMmPerSMax);
      }
    }
  }

  const std::vector<gcode::StreamPoint>& m_points;
  const AdviceQuestion& m_question;
  const std::function<bool()>& m_goOn;
  double m_feedMmPerSMax = 0.0;
  std::vector<Advice> m_list;
};

}  // namespace

double Advice::gain() const {
  return kind == AdviceKind::Feed ? after.feedMmPerS / before.feedMmPerS
                                  : feedMmPerSMaxAfter / feedMmPerSMaxBefore;
}

void sortByGain(std::vector<Advice>& list) {
  std::stable_sort(list.begin(), list.end(), [](const Advice& a, const Advice& b) {
    const bool firstIsRemedy = a.gain() < 1.0;
    const bool secondIsRemedy = b.gain() < 1.0;
    return firstIsRemedy != secondIsRemedy ? firstIsRemedy : a.gain() > b.gain();
  });
}

std::vector<Advice> advise(const std::vector<gcode::StreamPoint>& points,
                           const AdviceQuestion& question, const std::function<bool()>& goOn) {
  RIVULET_ASSERT(points.size() >= 2);
  return Adviser(points, question, goOn).advise();
}

}  // namespace rivulet::feasibility
