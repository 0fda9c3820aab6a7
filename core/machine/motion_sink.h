// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Makes a prepared motion of the move of a block. @threadsafety one object, one thread.
#pragma once

#include <optional>
#include <utility>

#include "base/axes.h"
#include "machine/alarm_sink.h"
#include "machine/machine_words.h"
#include "machine/prepared.h"
#include "nc/exec/sink.h"
#include "nc/modal/state.h"

namespace rivulet::machine {

struct MotionSinkOptions {
  base::Vec3 startMm;        ///< where the axes stand, machine coordinates
  double rapidMmPerS = 0.0;  ///< path speed of G0
  double roundingMm = 0.0;   ///< deviation at corners that G64 allows
};

class MotionSink final : public nc::PathSink {
 public:
  /// @param alarms  for paths this machine does not make; outlives the sink
  MotionSink(const MotionSinkOptions& options, AlarmSink& alarms)
      : m_options(options), m_alarms(alarms), m_endMm(options.startMm) {}

  void line(const nc::Position& from, base::Vec3 targetMm, const nc::Move& move) override;
  void arc(const nc::Position& from, const nc::Arc& arc, const nc::Move& move) override;
  void spaceArc(const nc::Position& from, const nc::SpaceArc& arc, base::Vec3 targetMm,
                const nc::Move& move) override;
  void spline(const nc::Position& from, const nc::Spline& spline, const nc::Move& move) override;
  void unknownWay(const nc::Position& /*from*/, base::Vec3 /*targetMm*/,
                  const nc::Move& /*move*/) override {}
  void machineWord(nc::MachineWord kind, double value, base::LineNumber line) override;
  void toolName(std::string_view name, base::LineNumber line) override;
  void firstSpindle(char address, double value) override;

  /// T, S, M and D of the block.
  [[nodiscard]] BlockMachineWords takeWords() { return std::exchange(m_words, {}); }

  /// What the block has moved. @param state  after the block
  [[nodiscard]] Prepared take(const nc::ModalState& state);

 private:
  MotionSinkOptions m_options;
  AlarmSink& m_alarms;
  base::Vec3 m_endMm;  ///< of the last motion, machine coordinates
  std::optional<PreparedMotion> m_motion;
  std::optional<PreparedDwell> m_dwell;
  BlockMachineWords m_words;
  bool m_stops = false;  ///< G9
};

}  // namespace rivulet::machine
