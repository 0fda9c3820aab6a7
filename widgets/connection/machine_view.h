// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The state of the machine at a moment, as the HMI shows it. Values that were not read stay empty.
/// @threadsafety plain values.
#pragma once

#include <QString>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "base/axes.h"
#include "base/vec3.h"
#include "streaming/run/equipment_watch.h"

namespace rivulet::opcua {
struct DescribedMachine;
}

namespace rivulet::widgets {

enum class ConnectionState {
  Disconnected,
  Connecting,
  Connected,
  Lost,  ///< it was there and is gone; the operator has to connect again
};

/// What is older is not shown as the present state of the machine.
inline constexpr double kFreshS = 0.5;

/// A stream that leaves no time reads position and feed every 0.9 s
/// (`feasibility::kDisplayIntervalMax`): up to this age they are no older than planned.
inline constexpr double kPlannedS = 1.2;

/// Nothing moves while a run is prepared, and transfer and tests leave no time to read the axes: up
/// to this age that is as expected.
inline constexpr double kPreparingS = 10.0;

/// Tool, spindle, coolant and work offset change seldom and are read once a second
/// (`streaming::EquipmentWatch::kInterval`): up to this age they are shown as present.
inline constexpr double kEquipmentFreshS = 1.5;

/// What a server describes of its machines is read every 10 s: up to this age it is shown as
/// present.
inline constexpr double kDescribedFreshS = 15.0;

[[nodiscard]] inline bool isFresh(std::optional<double> ageS) {
  return ageS && *ageS <= kFreshS;
}

enum class Freshness {
  Live,
  Planned,  ///< read as often as the stream permits, which is not live
  Old,
};

struct MachineView {
  std::optional<int> channelStatus;  ///< opcua::VariableKind::ChannelStatus
  std::optional<int> programStatus;  ///< opcua::VariableKind::ProgramStatus
  std::optional<QString> programName;
  std::optional<int> alarmNumber;  ///< 0: no alarm
  QString alarmText;               ///< may be empty: the number alone is shown
  std::optional<QString> message;  ///< what MSG("…") of the program on the control shows
  std::optional<base::Vec3> positionMm;
  base::RotarySet rotaryAxes{};  ///< those that the machine is known to have
  std::optional<base::RotaryDeg> rotaryDeg;
  std::optional<double> feedMmPerS;
  /// Of a run of this window, commanded for the move in progress; nothing: there is no run.
  std::optional<double> feedSetMmPerS;
  /// Factor by which that run scales the feeds of its program; nothing: it has one feed for all
  /// moves.
  std::optional<double> overrideFactor;
  bool isVirtualMachine = false;
  bool isGone = false;  ///< not connected any more: what was read before is not live

  /// From the position to the end of the move in progress, axis by axis; as old as the position.
  struct ToGo {
    base::Vec3 mm;
    base::RotaryDeg deg{};
    /// From the path of the run and the position; else read from the control.
    bool isComputed = false;

    friend bool operator==(const ToGo&, const ToGo&) = default;
  };
  std::optional<ToGo> toGo;  ///< nothing: not known

  /// What the control serves of tool, spindle, coolant and work offset; nothing: never read.
  std::optional<streaming::EquipmentSeen> equipment;

  /// What the server says of its machines by the companion specifications; null: never read.
  std::shared_ptr<const std::vector<opcua::DescribedMachine>> described;

  /// How long ago each group was read, in s; nothing: never, or before the connection was lost.
  std::optional<double> positionAgeS;
  std::optional<double> feedAgeS;
  std::optional<double> equipmentAgeS;
  std::optional<double> describedAgeS;
  std::optional<double> stateAgeS;  ///< channel, program, alarm
  /// The latest reads have come more than `kFreshS` apart, as often as the stream permits. It lasts
  /// from one read to the next, so that what is shown does not change with each of them.
  bool isPositionRare = false;
  bool isFeedRare = false;
  bool isPreparing = false;  ///< a run of this window is, and nothing moves

  /// Nothing was read for so long, as it has to be now.
  [[nodiscard]] bool isSilentAsPlanned(double ageS) const {
    return isPreparing && !isGone && ageS <= kPreparingS;
  }

  [[nodiscard]] Freshness positionFreshness() const {
    return freshness(positionAgeS, isPositionRare);
  }
  [[nodiscard]] Freshness feedFreshness() const { return freshness(feedAgeS, isFeedRare); }

  [[nodiscard]] Freshness equipmentFreshness() const {
    return !isGone && equipmentAgeS && *equipmentAgeS <= kEquipmentFreshS ? Freshness::Live
                                                                          : Freshness::Old;
  }

  /// The last point of the run in progress that the stream knows to be executed.
  struct Executed {
    std::size_t number = 0;  ///< 1: the first of the program
    base::Vec3 positionMm;
    double ageS = 0.0;  ///< since the stream last reported

    friend bool operator==(const Executed&, const Executed&) = default;
  };
  std::optional<Executed> executed;

  /// The position is old, but the stream says where the run is.
  [[nodiscard]] bool standsIn() const {
    return executed && isFresh(executed->ageS) && positionFreshness() == Freshness::Old;
  }

  friend bool operator==(const MachineView&, const MachineView&) = default;

 private:
  [[nodiscard]] Freshness freshness(std::optional<double> ageS, bool isRare) const {
    if (isGone) {
      return Freshness::Old;
    }
    if (isRare && ageS && *ageS <= kPlannedS) {
      return Freshness::Planned;
    }
    if (isFresh(ageS)) {
      return Freshness::Live;
    }
    return ageS && isSilentAsPlanned(*ageS) ? Freshness::Planned : Freshness::Old;
  }
};

}  // namespace rivulet::widgets
