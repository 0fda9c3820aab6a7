// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QTimer>
#include <algorithm>

#include "hmi/document.h"
#include "hmi/messages.h"
#include "hmi/pages/pages.h"
#include "hmi/run_controller.h"
#include "hmi/settings.h"
#include "report/operating_point.h"
#include "session/adviser.h"
#include "session/region_worker.h"
#include "widgets/common/error_text.h"
#include "widgets/feasibility/advice_panel.h"
#include "widgets/feasibility/feasibility_page.h"

namespace rivulet::hmi {

using session::RegionWorker;
using widgets::FeasibilityPage;

namespace {

/// Points a simulation of the region is made with.
constexpr std::size_t kSimulatedPoints = 200;

/// Empty: one feed for all moves.
widgets::FeedScale feedScaleOf(const Document& document) {
  return {document.settings().usesProgramFeeds() && document.view() ? document.view()->fastestMmPerS
                                                                    : 0.0};
}

/// N that may be tried: the feeds of the program may travel with the windows instead.
int pointsPerLoopMax(const Document& document) {
  templates::TemplateParameters parameters = document.parameters();
  parameters.feedPerPoint = false;
  return templates::pointsPerLoopMax(parameters);
}

/// With the feeds of the program the chart has distances in time, the simulation real ones.
/// @return the real d_min of the job as a share of the one in time
double realPerTimed(const session::RegionJob& job) {
  if (!job.settings.programFeeds || job.axis != feasibility::SweepAxis::PointDistance) {
    return 1.0;
  }
  const double timedMm =
      feasibility::programDistances(job.points, 2, job.settings.feedMmPerS).pointDistanceMmMin;
  return timedMm > 0.0 ? feasibility::programDistances(job.points, 2).pointDistanceMmMin / timedMm
                       : 1.0;
}

/// The stretch of the program with the tightest distances, at the points of the grid.
session::RegionJob jobOf(const Document& document, const widgets::SimulationWanted& wanted) {
  session::RegionJob job;
  const streaming::RunSettings settings = document.runSettings();
  job.settings.parameters = settings.parameters;
  job.settings.deltaMm = settings.deltaMm;
  job.settings.feedMmPerS = settings.feedMmPerS;
  job.settings.programFeeds = settings.programFeeds;
  const feasibility::Place& tightest =
      feasibility::tightestPlace(*document.findings().distances, job.settings.parameters.method);
  job.points = forecast::stretchOf(document.points(), tightest.point.value, kSimulatedPoints);
  forecast::commandFeeds(job.points, settings.programFeeds);
  job.machine = document.machine();
  job.axis = wanted.axis;
  job.feedsMmPerS = wanted.feedsMmPerS;
  const int fits = templates::pointsPerLoopMax(job.settings.parameters);
  for (const double abscissa : wanted.abscissas) {
    if (wanted.axis != feasibility::SweepAxis::PointsPerLoop || abscissa <= fits) {
      job.abscissas.push_back(abscissa * realPerTimed(job));
    }
  }
  return job;
}

widgets::SimulatedRegion regionOf(const session::RegionOutcome& outcome,
                                  const widgets::FeedScale& scale) {
  const double perShown = realPerTimed(outcome.job);
  widgets::SimulatedRegion region;
  region.scale = scale;
  region.axis = outcome.job.axis;
  region.operatingPoint = report::operatingPointOf(outcome.job.settings);
  region.programPoints = outcome.job.points.size();
  for (const forecast::RegionPoint& point : outcome.points) {
    region.points.push_back(
        {point.abscissa / perShown, point.feedMmPerS, point.runs, point.failures()});
  }
  for (const session::RegionBandPoint& point : outcome.band) {
    region.band.push_back({point.abscissa / perShown, point.rareMmPerS, point.halfMmPerS});
  }
  return region;
}

void showFindings(FeasibilityPage* page, const Document& document) {
  const Findings& findings = document.findings();
  widgets::FeasibilityModel model;
  model.operatingPoint = findings.operatingPoint;
  model.access = findings.access;
  model.source = findings.source;
  model.scale = feedScaleOf(document);
  model.pointsPerLoopMax = pointsPerLoopMax(document);
  if (findings.overrideLimit) {
    model.limitedBy = widgets::overrideLimitText(*findings.overrideLimit);
  }
  model.verdict = findings.verdict;
  if (findings.distances) {
    model.distances = *findings.distances;
  }
  if (document.view()) {
    model.smallestDistancesMm = model.scale.isOverride() ? document.view()->smallestTimedMm
                                                         : document.view()->smallestDistancesMm;
  }
  page->setModel(model);
}

void connectSimulation(FeasibilityPage* page, Messages* messages, Document* document,
                       RunController* runs) {
  auto* worker = new RegionWorker(page);
  const auto scale = std::make_shared<widgets::FeedScale>();  // of the job in progress
  QObject::connect(page, &FeasibilityPage::simulationRequested, worker,
                   [page, worker, scale, document, runs](const widgets::SimulationWanted& wanted) {
                     if (document->findings().distances && !runs->isRunning()) {
                       *scale = feedScaleOf(*document);
                       worker->start(jobOf(*document, wanted));
                       page->setSimulationProgress(0);
                     }
                   });
  QObject::connect(page, &FeasibilityPage::simulationCancelRequested, worker,
                   &RegionWorker::cancel);
  QObject::connect(worker, &RegionWorker::progressed, page,
                   &FeasibilityPage::setSimulationProgress);
  QObject::connect(worker, &RegionWorker::cancelled, page,
                   [page] { page->setSimulationProgress(std::nullopt); });
  QObject::connect(
      worker, &RegionWorker::finished, page,
      [page, scale, messages](const std::shared_ptr<const session::RegionOutcome>& outcome) {
        page->setSimulationProgress(std::nullopt);
        if (outcome->error.code) {
          messages->show(gcode::Severity::Warning,
                         [error = outcome->error] { return widgets::errorText(error); });
        }
        page->setRegion(regionOf(*outcome, *scale));
      });
  // During a run the processors belong to the stream.
  QObject::connect(runs, &RunController::started, worker, &RegionWorker::cancel);
  QObject::connect(document, &Document::programLoaded, worker, [page, worker] {
    worker->cancel();
    page->clearRegions();
  });
}

/// Methods that the program may be streamed with instead. Credit needs a test of the control, and
/// of file nothing is known. Only method window takes the feeds of the program.
std::vector<base::MethodKind> otherMethods(const Document& document) {
  const base::RotarySet& turned = document.view()->turnedAxes;
  const bool isTurned = std::find(turned.begin(), turned.end(), true) != turned.end();
  std::vector<base::MethodKind> methods;
  for (const base::MethodTraits& traits : base::kMethods) {
    if (!traits.needsCommissioning && !traits.sendsBlocks &&
        !document.settings().usesProgramFeeds() && (traits.streamsRotary || !isTurned)) {
      methods.push_back(traits.kind);
    }
  }
  return methods;
}

/// What the advice depends on; the feed as well, because it may be advised.
struct AdviceKey {
  std::shared_ptr<const overview::ProgramView> view;
  feasibility::OperatingPoint point;
  base::Duration accessTime{};
  int layoutNumber = 0;  ///< of the flexible program
  widgets::FeedScale scale;
};

bool isSame(const AdviceKey& a, const AdviceKey& b) {
  return a.view == b.view && a.point.method == b.point.method &&
         a.point.pointsPerLoop == b.point.pointsPerLoop && a.point.deltaMm == b.point.deltaMm &&
         a.point.feedMmPerS == b.point.feedMmPerS && a.accessTime == b.accessTime &&
         a.layoutNumber == b.layoutNumber && a.scale == b.scale;
}

session::AdviceJob adviceJob(const Document& document) {
  const Findings& findings = document.findings();
  session::AdviceJob job;
  job.view = document.view();
  job.settings = document.runSettings();
  job.machine = document.machine();
  job.question = {
      findings.operatingPoint,    findings.access,        {},
      pointsPerLoopMax(document), otherMethods(document), feedScaleOf(document).fullFeedMmPerS};
  return job;
}

void connectAdvice(FeasibilityPage* page, Document* document, RunController* runs) {
  auto* adviser = new session::Adviser(page);
  widgets::AdvicePanel* panel = page->advice();
  // Settings change while an operator turns them: wait for a rest.
  auto* rest = new QTimer(page);
  constexpr int kRestMs = 500;
  rest->setSingleShot(true);
  rest->setInterval(kRestMs);
  const auto asked = std::make_shared<AdviceKey>();
  QObject::connect(document, &Document::judged, page, [=] {
    const Findings& findings = document->findings();
    if (!findings.verdict) {
      *asked = {};
      rest->stop();
      adviser->cancel();
      panel->setAdvice({});
      return;
    }
    const AdviceKey key{document->view(), findings.operatingPoint, findings.verdict->accessTime,
                        findings.flexible ? findings.flexible->layoutNumber : 0,
                        feedScaleOf(*document)};
    if (!isSame(key, *asked) && !runs->isRunning()) {
      *asked = key;
      adviser->cancel();
      panel->setBusy();
      rest->start();
    }
  });
  QObject::connect(rest, &QTimer::timeout, page, [=] { adviser->advise(adviceJob(*document)); });
  QObject::connect(adviser, &session::Adviser::advised, panel,
                   [panel](const std::shared_ptr<const std::vector<feasibility::Advice>>& list) {
                     panel->setAdvice(*list);
                   });
  QObject::connect(panel, &widgets::AdvicePanel::turnRequested, adviser,
                   [=](const feasibility::OperatingPoint& point) {
                     if (document->findings().distances) {
                       session::AdviceJob job = adviceJob(*document);
                       job.question.operatingPoint = point;
                       adviser->judge(std::move(job));
                     }
                   });
  QObject::connect(adviser, &session::Adviser::turned, panel,
                   [panel](const session::TurnedVerdict& turned) {
                     panel->setTurned(turned.point, turned.verdict);
                   });
  // During a run the processors belong to the stream; afterwards it is looked for again.
  QObject::connect(runs, &RunController::started, page, [=] {
    rest->stop();
    adviser->cancel();
    *asked = {};
    panel->setAdvice({});
  });
}

}  // namespace

QWidget* makeFeasibilityPage(Messages* messages, Document* document, RunController* runs,
                             QWidget* parent) {
  auto* page = new FeasibilityPage(parent);
  connectSimulation(page, messages, document, runs);
  connectAdvice(page, document, runs);
  QObject::connect(document, &Document::judged, page,
                   [page, document] { showFindings(page, *document); });
  QObject::connect(page, &FeasibilityPage::operatingPointRequested, document,
                   [document](const feasibility::OperatingPoint& point) {
                     streaming::StreamSettings settings = document->settings();
                     if (settings.parameters.method != point.method) {
                       // What is advised was judged with the feeds as they are now.
                       settings.programFeeds = settings.usesProgramFeeds();
                     }
                     settings.parameters.method = point.method;
                     settings.parameters.pointsPerLoop = point.pointsPerLoop;
                     settings.deltaMm = point.deltaMm;
                     if (const double fastest = settings.usesProgramFeeds() && document->view()
                                                    ? document->view()->fastestMmPerS
                                                    : 0.0;
                         fastest > 0.0) {
                       settings.overrideFactor = std::clamp(
                           point.feedMmPerS / fastest, gcode::kOverrideMin, gcode::kOverrideMax);
                     } else {
                       settings.feedMmPerS = point.feedMmPerS;
                     }
                     document->setSettings(settings);
                   });
  QObject::connect(runs, &RunController::permissionsChanged, page,
                   [page, runs] { page->setEditable(runs->canChangeSettings()); });
  return page;
}

}  // namespace rivulet::hmi
