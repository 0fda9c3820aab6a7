// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/setup/job_test_round.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "opcua/await.h"
#include "templates/job_loop.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using job::NativeReason;
using templates::JobProtocol;
using templates::WindowProtocol;

constexpr Duration kWithheld = std::chrono::milliseconds{1500};
/// Of the move: the axis is on its way, and far from where it would stand anyway.
constexpr double kWayLeast = 0.1;
constexpr double kWayMost = 0.35;
constexpr Duration kHeldFor = std::chrono::seconds{1};
constexpr Duration kHoldPatience = std::chrono::seconds{5};
/// A control that has not ended by then does not.
constexpr Duration kEndPatience = std::chrono::minutes{1};
/// Beside the moves: what is tried may be a change of the tool.
constexpr Duration kPatience = std::chrono::minutes{2};

template <class Value>
void compare(std::vector<std::string>& shown, const char* name, const std::optional<Value>& before,
             const std::optional<Value>& after) {
  if (before && after && *before != *after) {
    shown.push_back(fmt::format("{} {} → {}", name, *before, *after));
  }
}

/// What the control shows that a block of this kind may have changed.
std::vector<std::string> shownOf(NativeReason kind, const EquipmentSeen& before,
                                 const EquipmentSeen& after) {
  std::vector<std::string> shown;
  if (kind == NativeReason::Spindle) {
    compare(shown, "spindle set to", before.spindleSetPerMin, after.spindleSetPerMin);
    compare(shown, "spindle", before.spindlePerMin, after.spindlePerMin);
  } else if (kind == NativeReason::Coolant) {
    compare(shown, "flood", before.flood, after.flood);
    compare(shown, "mist", before.mist, after.mist);
  } else if (kind == NativeReason::Tool) {
    compare(shown, "tool", before.tool, after.tool);
    compare(shown, "tool", before.toolName, after.toolName);
    compare(shown, "edge", before.edge, after.edge);
  } else if (kind == NativeReason::WorkOffset) {
    compare(shown, "work offset", before.workOffset, after.workOffset);
  }
  return shown;
}

bool isMotion(NativeReason kind) {
  return kind < NativeReason::Tool && kind != NativeReason::Subprogram &&
         kind != NativeReason::Probing;
}

}  // namespace

JobTestRound::JobTestRound(opcua::Link& link, opcua::Control& control, const JobTestJob& job,
                           const JobTestPlan& plan, JobTestScene scene, double beforeMm,
                           bool isFirst, const JobTestTalk& talk)
    : m_control(link),
      m_machine(control),
      m_link(link, opcua::rParameter(job.programs.loop.cells.run),
             opcua::rParameter(job.programs.loop.cells.heartbeat)),
      m_job(job),
      m_plan(plan),
      m_scene(scene),
      m_beforeMm(beforeMm),
      m_startStep(isFirst ? CommissioningStep::CycleStart : CommissioningStep::CycleStartAgain),
      m_talk(talk) {
  if (scene == JobTestScene::StopInBlock) {
    m_link.withhold(WindowProtocol::kRun, kWithheld);
  }
}

void JobTestRound::endHold(bool held) {
  if (m_holds.now) {
    (m_holds.now->isInBlock ? m_holds.inBlock : m_holds.inStretch) = held;
    m_holds.now.reset();
  }
}

void JobTestRound::proceed() {
  m_changedAt = m_control.now();
}

void JobTestRound::nativeBlocks(int next) {
  endHold(false);
  m_isArmed = false;
  m_isNative = true;
  m_gap = next;
  m_inGap.movedMm = 0.0;
  m_inGap.hasWaited = false;
  m_phaseStartMm.reset();
  proceed();
}

void JobTestRound::nativeBlock(const job::NativeBlock& /*block*/) {
  proceed();
}

void JobTestRound::stretchBegins(const job::Stretch& stretch, base::Vec3 startMm) {
  endHold(false);  // what was to stand has come to its end
  const double atMm = startMm[static_cast<std::size_t>(m_plan.move.axis)];
  if (stretch.number == kStretchInPlace && std::abs(atMm - m_beforeMm) > kTestPlaceMm) {
    m_countsFromMm = atMm;
    m_stops = true;
  }
  const EquipmentSeen after = look();
  if (m_gap >= kGapOfFirstTrial) {
    closeTrial(after, atMm);
  }
  m_inGap.before = after;
  m_isNative = false;
  m_stretch = stretch.number;
  m_phaseStartMm.reset();
  proceed();
  if (m_scene == JobTestScene::StopInBlock && stretch.number == kStretchInPlace) {
    m_link.withhold(JobProtocol::goOn(stretch.number), kWithheld);
  }
}

bool JobTestRound::waitsForCycleStart() {
  m_inGap.hasWaited = true;
  proceed();
  if (m_machine.abilities().startsOnRequest) {
    return true;
  }
  if (m_talk.progress && !m_talk.progress(CommissioningStep::CycleStartAgain)) {
    m_isCancelled = true;
  }
  return false;
}

bool JobTestRound::stopRequested(Instant now) {
  if (m_talk.progress && !m_talk.progress(m_isArmed ? m_startStep : CommissioningStep::Running)) {
    m_isCancelled = true;
  }
  const Duration patience = kPatience + 3 * m_plan.move.duration();
  if (!m_isArmed && m_changedAt && now - *m_changedAt > patience && !m_stops) {
    m_isStalled = m_stops = true;
  }
  const bool stops = m_stops || m_isCancelled;
  if (stops && !m_stoppedAt) {
    m_stoppedAt = now;
  }
  if (m_stoppedAt && !m_isArmed && now - *m_stoppedAt > kEndPatience) {
    m_isLost = true;
    m_link.lose();
  }
  return stops;
}

void JobTestRound::update(const LiveUpdate& update) {
  if (m_talk.watch) {
    m_talk.watch(update);
  }
  if (!update.sample || !update.sample->positionMm || m_isArmed) {
    return;
  }
  const base::Vec3 here = *update.sample->positionMm;
  m_inGap.movedMm += m_lastMm ? base::distance(here, *m_lastMm) : 0.0;
  m_lastMm = here;
  const double atMm = here[static_cast<std::size_t>(m_plan.move.axis)];
  m_phaseStartMm = m_phaseStartMm.value_or(atMm);
  if (m_link.isWithholding()) {
    watchPermission(atMm);
  } else if (m_holds.now) {
    watchHold(atMm, update.at, update.feed);
  } else {
    actOnTheWay(atMm, update.at);
  }
}

/// The loop has not returned and been called again, and no axis has moved.
void JobTestRound::watchPermission(double atMm) {
  const std::array<opcua::Variable, 1> call{opcua::rParameter(m_job.programs.loop.callCell)};
  const auto seen = opcua::readNumbers(m_control, call, kSetupDeadline);
  const bool isExecuted =
      seen && (*seen)[0] != JobProtocol::callNumber(m_job.programs.number, m_gap - 1);
  if (isExecuted || std::abs(atMm - *m_phaseStartMm) > kTestPlaceMm) {
    m_early = m_gap - 1;
    m_stops = true;
  }
}

bool JobTestRound::isSceneOf(bool inBlock) const {
  const bool isPlace = inBlock ? m_isNative && m_gap == kGapOfTwoMoves : !m_isNative;
  switch (m_scene) {
    case JobTestScene::StopInBlock:
    case JobTestScene::LoseInBlock:
      return isPlace && inBlock && !m_hasActed;
    case JobTestScene::StopInStretch:
    case JobTestScene::LoseInStretch:
      return isPlace && !inBlock && m_stretch == kStretchOfWay && !m_hasActed;
    case JobTestScene::Whole:
      return isPlace &&
             (inBlock ? !m_holds.inBlock : m_stretch == kStretchOfWay && !m_holds.inStretch);
  }
  return false;
}

void JobTestRound::actOnTheWay(double atMm, Instant at) {
  const double way = std::abs((atMm - *m_phaseStartMm) / m_plan.move.mm);
  if (!isSceneOf(m_isNative) || way < kWayLeast || way > kWayMost) {
    return;
  }
  proceed();
  switch (m_scene) {
    case JobTestScene::StopInBlock:
    case JobTestScene::StopInStretch:
      m_hasActed = m_stops = true;
      return;
    case JobTestScene::LoseInBlock:
    case JobTestScene::LoseInStretch:
      m_hasActed = m_isLost = true;
      m_link.lose();
      return;
    case JobTestScene::Whole:
      m_holds.now = Hold{at, at, atMm, m_isNative};
      return;
  }
}

void JobTestRound::watchHold(double atMm, Instant at, const std::optional<FeedSeen>& feed) {
  if (std::abs(atMm - m_holds.now->atMm) > kTestStandsMm) {
    m_holds.now->atMm = atMm;
    m_holds.now->stoodSince = at;
  }
  const bool acts = feed && feed->actsPercent == templates::FeedCell::kHold;
  const double way = std::abs((atMm - *m_phaseStartMm) / m_plan.move.mm);
  if (at - m_holds.now->stoodSince >= kHeldFor && acts && way < 1.0 - kWayLeast) {
    endHold(true);
  } else if (at - m_holds.now->from > kHoldPatience) {
    endHold(false);
    m_stops = true;
  }
}

EquipmentSeen JobTestRound::look() {
  if (m_equipment.variables().empty()) {
    return {};
  }
  const auto readings = opcua::readNow(m_control, m_equipment.variables(), kSetupDeadline);
  return readings ? m_equipment.take(*readings) : EquipmentSeen{};
}

std::vector<std::string> JobTestRound::shownBy(NativeReason kind,
                                               const EquipmentSeen& after) const {
  std::vector<std::string> shown = shownOf(kind, m_inGap.before, after);
  if (isMotion(kind) && m_inGap.movedMm > kTestPlaceMm) {
    shown.push_back(fmt::format("the axes moved by {:.3f} mm", m_inGap.movedMm));
  }
  if (kind == NativeReason::Stop && m_inGap.hasWaited) {
    shown.emplace_back("the program waited for cycle start");
  }
  return shown;
}

void JobTestRound::closeTrial(const EquipmentSeen& after, double atMm) {
  const auto index = static_cast<std::size_t>(m_gap - kGapOfFirstTrial);
  if (index >= m_plan.blocks.size()) {
    return;
  }
  TriedBlock block;
  block.text = m_plan.blocks[index];
  block.kinds = m_job.kinds[index];
  std::vector<std::string> shown;
  bool isAllShown = true;
  for (const NativeReason kind : block.kinds) {
    const std::vector<std::string> ofKind = shownBy(kind, after);
    isAllShown = isAllShown && (!ofKind.empty() || isOfTest(kind));
    shown.insert(shown.end(), ofKind.begin(), ofKind.end());
  }
  std::sort(shown.begin(), shown.end());
  shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
  block.witness = isAllShown && !shown.empty() ? Witness::Control : Witness::Nobody;
  block.message = shown.empty() ? std::string("The control shows nothing of it.")
                                : fmt::format("{}{}.", fmt::join(shown, ", "),
                                              isAllShown ? "" : "; of the rest it shows nothing");
  // Where the stretch before has left the axis.
  const double wasMm = index % 2 == 0 ? m_job.nearMm : m_job.farMm;
  if (std::abs(atMm - wasMm) > kTestPlaceMm) {
    block.message +=
        fmt::format(" Then {} stood at {:.3f} mm: the test ended there.",
                    base::kAxisNames[static_cast<std::size_t>(m_plan.move.axis)], atMm);
    m_isElsewhere = m_stops = true;
  }
  m_tried.push_back(std::move(block));
}

}  // namespace rivulet::streaming
