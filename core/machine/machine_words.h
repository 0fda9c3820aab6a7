// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What T, M6, D, S and the other M functions of a block do on the machine. The pre-run knows which
/// tool will be in the spindle, so it adds the tool's length to the path and finds tools that do
/// not exist; the rest happens in the main run. @threadsafety one object, one thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "machine/alarm_sink.h"
#include "machine/config.h"
#include "machine/prepared.h"
#include "nc/modal/state.h"

namespace rivulet::machine {

/// Those words of one block, as numbers.
struct BlockMachineWords {
  base::LineNumber line;
  std::optional<double> speedPerMin;    ///< S
  std::optional<double> tool;           ///< T5
  std::optional<std::string> toolName;  ///< T="MILL"
  std::optional<double> edge;           ///< D
  std::vector<int> functions;           ///< M
};

class MachineWords {
 public:
  /// @param machine  null: such words do nothing @param tool  in the spindle
  MachineWords(const MachineConfig* machine, Tool tool, AlarmSink& alarms)
      : m_machine(machine), m_inSpindle(tool), m_next(std::move(tool)), m_alarms(alarms) {
    m_edge = machine != nullptr && machine->tools && machine->tools->inSpindle.exists() ? 1 : 0;
  }

  /// Before the block is executed: the length of its tool counts for its motion.
  /// Alarms as on the control: 17190 no such tool, 17180 no such edge.
  void apply(const BlockMachineWords& words, bool isDwell, nc::ModalState& state);

  /// TOFFL: of the next block on, until another one.
  void setLengthOffset(double mm) { m_lengthOffsetMm = mm; }
  /// The next block tells the machine which one holds.
  void workOffsetsChanged() { m_workOffset = -1; }
  [[nodiscard]] bool hasEdge() const { return m_inSpindle.exists() && m_edge > 0; }
  /// Of the tool and edge in effect.
  [[nodiscard]] double radiusMm() const;

  struct Actions {
    std::vector<MachineAction> before;  ///< the motion of the block waits for them
    std::vector<MachineAction> after;
  };
  /// Of the block applied last. @param state  after the block
  [[nodiscard]] Actions take(const nc::ModalState& state);

 private:
  using Kind = MachineAction::Kind;
  void applyTool(const BlockMachineWords& words, bool changes);
  void applyEdge(const BlockMachineWords& words);
  void applySpindle(const BlockMachineWords& words, nc::ModalState& state);
  void applyFunction(int number);
  [[nodiscard]] std::optional<Tool> find(const BlockMachineWords& words);

  const MachineConfig* m_machine;
  Tool m_inSpindle;
  Tool m_next;  ///< selected by T
  int m_edge = 0;
  double m_lengthOffsetMm = 0.0;
  int m_workOffset = kNoWorkOffset;
  std::size_t m_planeFirstAxis = 0;
  Actions m_actions;
  AlarmSink& m_alarms;
};

}  // namespace rivulet::machine
