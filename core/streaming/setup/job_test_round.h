// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One start of the job of the test: orders what its scene wants once the axis is on its way, and
/// watches what the control does. @threadsafety one object, one thread: that of the job.
#pragma once

#include <optional>
#include <vector>

#include "streaming/run/equipment_watch.h"
#include "streaming/run/whole_job.h"
#include "streaming/setup/job_test_job.h"
#include "streaming/setup/job_test_link.h"

namespace rivulet::streaming {

/// An axis is at its place, or has left it; servo and exact stop are closer.
inline constexpr double kTestPlaceMm = 0.05;
/// An axis that stands is seen to move by less.
inline constexpr double kTestStandsMm = 0.01;

enum class JobTestScene {
  StopInBlock,  ///< and permissions that come late
  StopInStretch,
  LoseInBlock,  ///< the client
  LoseInStretch,
  Whole,  ///< held once in a block, once in a stretch
};

class JobTestRound final : public WholeJobSink, public RunOrders {
 public:
  /// All of them outlive it. @param beforeMm  where the axis is, before the program
  /// @param isFirst  the operator has not pressed cycle start yet
  JobTestRound(opcua::Link& link, opcua::Control& control, const JobTestJob& job,
               const JobTestPlan& plan, JobTestScene scene, double beforeMm, bool isFirst,
               const JobTestTalk& talk);

  /// For the job.
  [[nodiscard]] JobTestLink& link() { return m_link; }

  [[nodiscard]] bool isCancelled() const { return m_isCancelled; }
  /// Nothing has changed for longer than anything of the test takes.
  [[nodiscard]] bool isStalled() const { return m_isStalled; }
  /// The scene's stop, or its loss of the client, came while the axis was on its way.
  [[nodiscard]] bool hasActed() const { return m_hasActed; }
  /// The client was lost, for the scene or because the control did not end.
  [[nodiscard]] bool isLost() const { return m_isLost; }
  /// After which stretch blocks were executed too early, 0: before the first; nothing: never.
  [[nodiscard]] std::optional<int> earlyAfter() const { return m_early; }
  /// Nothing: the job did not come there.
  [[nodiscard]] std::optional<bool> heldInBlock() const { return m_holds.inBlock; }
  [[nodiscard]] std::optional<bool> heldInStretch() const { return m_holds.inStretch; }
  /// It came to the blocks that are tried: what stops there may be theirs.
  [[nodiscard]] bool isTrying() const { return m_isNative && m_gap >= kGapOfFirstTrial; }
  /// Where the axis is in the program, if it is elsewhere than before it: nothing has been moved.
  [[nodiscard]] std::optional<double> countsFromMm() const { return m_countsFromMm; }
  /// The last block that was tried has taken the axis elsewhere: the job was ended there.
  [[nodiscard]] bool isElsewhere() const { return m_isElsewhere; }
  [[nodiscard]] std::vector<TriedBlock> tried() const { return m_tried; }

  // WholeJobSink
  void update(const LiveUpdate& update) override;
  void access(const trace::Access& /*access*/) override {}
  void note(const trace::Note& /*note*/) override {}
  void nativeBlocks(int next) override;
  void nativeBlock(const job::NativeBlock& block) override;
  void stretchBegins(const job::Stretch& stretch, base::Vec3 startMm) override;
  bool waitsForCycleStart() override;
  // RunOrders
  bool stopRequested(base::Instant now) override;
  bool holdRequested(base::Instant /*now*/) override { return m_holds.now.has_value(); }
  /// Whoever aborts the test wants the axes to stand where they are.
  bool letsEnd(base::Instant /*now*/) override { return !m_isCancelled; }
  bool leaves(base::Instant /*now*/) override { return m_isCancelled; }

 private:
  struct Hold {
    base::Instant from;
    base::Instant stoodSince;
    double atMm = 0.0;
    bool isInBlock = false;
  };

  void proceed();
  void watchPermission(double atMm);
  void actOnTheWay(double atMm, base::Instant at);
  void watchHold(double atMm, base::Instant at, const std::optional<FeedSeen>& feed);
  void endHold(bool held);
  [[nodiscard]] bool isSceneOf(bool inBlock) const;
  [[nodiscard]] EquipmentSeen look();
  /// What the control has shown in the gap of a block of this kind.
  [[nodiscard]] std::vector<std::string> shownBy(job::NativeReason kind,
                                                 const EquipmentSeen& after) const;
  void closeTrial(const EquipmentSeen& after, double atMm);

  opcua::Link& m_control;
  opcua::Control& m_machine;
  JobTestLink m_link;
  const JobTestJob& m_job;
  const JobTestPlan& m_plan;
  JobTestScene m_scene;
  double m_beforeMm;
  CommissioningStep m_startStep;
  const JobTestTalk& m_talk;

  bool m_isArmed = true;  ///< the program has not been started
  bool m_isNative = true;
  int m_gap = 0;  ///< of native blocks, in progress or the last
  int m_stretch = 0;
  std::optional<base::Instant> m_changedAt;
  std::optional<double> m_phaseStartMm;
  std::optional<base::Vec3> m_lastMm;

  bool m_stops = false;
  std::optional<base::Instant> m_stoppedAt;
  bool m_isCancelled = false;
  bool m_isStalled = false;
  bool m_hasActed = false;
  bool m_isLost = false;
  bool m_isElsewhere = false;
  std::optional<double> m_countsFromMm;
  std::optional<int> m_early;
  struct Holds {
    std::optional<Hold> now;
    std::optional<bool> inBlock;
    std::optional<bool> inStretch;
  };
  Holds m_holds;

  EquipmentWatch m_equipment;
  /// What the blocks of a gap have done.
  struct Gap {
    EquipmentSeen before;  ///< at the beginning of the stretch before
    double movedMm = 0.0;
    bool hasWaited = false;  ///< for cycle start
  };
  Gap m_inGap;
  std::vector<TriedBlock> m_tried;
};

}  // namespace rivulet::streaming
