// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/adviser.h"

#include <algorithm>

#include "forecast/region.h"
#include "report/operating_point.h"
#include "session/background.h"
#include "streaming/methods/feed_plan.h"

namespace rivulet::session {

namespace {

/// The settings of the job with what is advised in their place.
streaming::RunSettings settingsAt(const AdviceJob& job, const feasibility::OperatingPoint& point) {
  streaming::RunSettings settings = job.settings;
  settings.parameters.method = point.method;
  settings.parameters.pointsPerLoop = point.pointsPerLoop;
  settings.parameters.feedPerPoint = point.feedPerPoint;
  settings.deltaMm = point.deltaMm;
  settings.feedMmPerS = point.feedMmPerS;
  if (settings.programFeeds && job.question.fullFeedMmPerS > 0.0) {
    settings.programFeeds->overrideFactor = std::clamp(
        point.feedMmPerS / job.question.fullFeedMmPerS, gcode::kOverrideMin, gcode::kOverrideMax);
  }
  return settings;
}

/// With the feeds of the program, N decides where these feeds travel.
feasibility::OperatingPoint completed(const AdviceJob& job,
                                      const feasibility::OperatingPoint& point) {
  streaming::RunSettings settings = settingsAt(job, point);
  settings.parameters.feedPerPoint = false;
  settings.parameters.feedPerPoint =
      settings.programFeeds &&
      streaming::prefersFeedPerPoint(job.view->points.points, settings, job.question.access);
  return report::operatingPointOf(settings);
}

feasibility::ProgramDistances distancesOf(const AdviceJob& job,
                                          const feasibility::OperatingPoint& point) {
  return feasibility::programDistances(job.view->points.points, point.pointsPerLoop,
                                       job.question.fullFeedMmPerS);
}

void renew(std::shared_ptr<std::atomic<bool>>& stop) {
  if (stop) {
    stop->store(true);
  }
  stop = std::make_shared<std::atomic<bool>>(false);
}

/// The largest of the feeds up to the limit at which the simulation makes no wrong point; nothing
/// if none was found or it could not be simulated.
std::optional<double> simulatedFeed(const AdviceJob& job, const feasibility::OperatingPoint& point,
                                    double feedMmPerSMax, const std::atomic<bool>& stop) {
  RehearsalJob rehearsal;
  const feasibility::ProgramDistances distances = distancesOf(job, point);
  rehearsal.points = {job.view, &job.view->points.points};
  rehearsal.tightest = feasibility::tightestPlace(distances, point.method).point.value;
  feasibility::OperatingPoint at = point;
  at.feedMmPerS = feedMmPerSMax;
  rehearsal.settings = settingsAt(job, at);
  rehearsal.machine = job.machine;
  rehearsal.access = job.question.access.measured;
  const RehearsalOutcome outcome = rehearse(rehearsal, stop);
  if (outcome.error.code || outcome.runs == 0) {
    return std::nullopt;
  }
  if (outcome.hasFailed()) {
    return outcome.safeFeedMmPerS;
  }
  return outcome.verdict ? std::min(feedMmPerSMax, outcome.verdict->feedMmPerSMax) : feedMmPerSMax;
}

}  // namespace

std::vector<feasibility::Advice> simulatedAdvice(const AdviceJob& asked,
                                                 const std::atomic<bool>& stop) {
  AdviceJob job = asked;
  job.question.complete = [&job](const feasibility::OperatingPoint& point) {
    return completed(job, point);
  };
  const auto goOn = [&stop] { return !stop.load(); };
  std::vector<feasibility::Advice> list;
  std::optional<double> before;  // the largest feed of the present settings, simulated
  for (feasibility::Advice advice :
       feasibility::advise(job.view->points.points, job.question, goOn)) {
    if (!goOn()) {
      return {};
    }
    const bool isFeed = advice.kind == feasibility::AdviceKind::Feed;
    const auto simulated = simulatedFeed(
        job, advice.after, isFeed ? advice.after.feedMmPerS : advice.feedMmPerSMaxAfter, stop);
    if (!simulated) {
      continue;
    }
    if (isFeed) {
      advice.after.feedMmPerS = *simulated;
    } else {
      if (!before) {
        before = simulatedFeed(job, advice.before, advice.feedMmPerSMaxBefore, stop);
      }
      advice.feedMmPerSMaxBefore = before.value_or(advice.feedMmPerSMaxBefore);
      advice.feedMmPerSMaxAfter = *simulated;
    }
    const bool isRemedy = isFeed && advice.after.feedMmPerS < advice.before.feedMmPerS;
    if (isRemedy || advice.gain() >= feasibility::kAdviceGainMin) {
      list.push_back(advice);
    }
  }
  feasibility::sortByGain(list);
  return goOn() ? list : std::vector<feasibility::Advice>();
}

Adviser::~Adviser() {
  cancel();
}

void Adviser::cancel() {
  for (auto* stop : {&m_stopAdvice, &m_stopVerdict}) {
    if (*stop) {
      (*stop)->store(true);
      stop->reset();
    }
  }
}

void Adviser::advise(AdviceJob job) {
  renew(m_stopAdvice);
  using List = std::shared_ptr<const std::vector<feasibility::Advice>>;
  inBackground(
      this,
      [stop = m_stopAdvice, job = std::move(job)]() -> List {
        return std::make_shared<const std::vector<feasibility::Advice>>(
            simulatedAdvice(job, *stop));
      },
      [stop = m_stopAdvice](Adviser& self, const List& list) {
        if (self.m_stopAdvice == stop) {
          self.m_stopAdvice.reset();
          Q_EMIT self.advised(list);
        }
      });
}

void Adviser::judge(AdviceJob job) {
  renew(m_stopVerdict);
  inBackground(
      this,
      [stop = m_stopVerdict, job = std::move(job)] {
        const feasibility::OperatingPoint& point = job.question.operatingPoint;
        TurnedVerdict turned{point, std::nullopt, {}};
        if (stop->load()) {
          return turned;  // overtaken while it waited: nobody takes it
        }
        const auto verdict =
            feasibility::judge(completed(job, point), distancesOf(job, point), job.question.access);
        if (verdict) {
          turned.verdict = *verdict;
        } else {
          turned.error = verdict.error();
        }
        return turned;
      },
      [stop = m_stopVerdict](Adviser& self, const TurnedVerdict& turned) {
        if (self.m_stopVerdict == stop) {
          self.m_stopVerdict.reset();
          Q_EMIT self.turned(turned);
        }
      });
}

}  // namespace rivulet::session
