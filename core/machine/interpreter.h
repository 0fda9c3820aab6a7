// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Executes an NC program block by block. In the moment of the call R values are latched and
/// assignments take effect. @threadsafety one object, one thread.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/axes.h"
#include "base/instant.h"
#include "machine/alarm_sink.h"
#include "machine/config.h"
#include "machine/contour_corners.h"
#include "machine/machine_words.h"
#include "machine/main_run.h"
#include "machine/motion_sink.h"
#include "machine/prepared.h"
#include "machine/r_parameters.h"
#include "machine/radius_compensation.h"
#include "nc/cycles/drilling.h"
#include "nc/cycles/milling.h"
#include "nc/eval/variables.h"
#include "nc/exec/executor.h"
#include "nc/flow/flow.h"

namespace rivulet::machine {

struct InterpreterOptions {
  base::Vec3 startMm;  ///< where the axes stand, machine coordinates: end of the "block before"
  base::RotaryDeg startDeg{};           ///< the same of A, B, C
  base::RotarySet rotaryAxes{};         ///< those the machine has; words of others move nothing
  double rapidMmPerS = 0.0;             ///< path speed of G0
  double feedMmPerS = 0.0;              ///< until F is programmed; 0: a block without is an alarm
  double roundingMm = 0.0;              ///< deviation at corners that G64 allows
  Dynamics dynamics = Dynamics::Brisk;  ///< until BRISK or SOFT is programmed
  bool cacheUntilStopre = false;        ///< R values from outside are seen only after a STOPRE
  const MainRun* mainRun = nullptr;     ///< for variables of the main run; null: an alarm
  nc::Library library;                  ///< may be empty
  /// Spindle, tools, coolant, offsets; outlives the interpreter. Null: words for them do nothing.
  const MachineConfig* machine = nullptr;
  Tool tool;  ///< in the spindle
};

/// As the machine is configured, with the axes at `start`; its equipment too.
/// @param config  outlives the interpreter
[[nodiscard]] InterpreterOptions interpreterOptions(const MachineConfig& config,
                                                    const base::AxisPosition& start);

class Interpreter final : private nc::CallObserver {
 public:
  /// @param parameters  must outlive the interpreter, as must the main run
  Interpreter(std::shared_ptr<const nc::Tree> program, RParameters& parameters,
              const InterpreterOptions& options);

  /// Interprets the next block. After an alarm or the end it must not be called again.
  [[nodiscard]] Prepared next();

  /// To be called when a STOPRE has been waited for: values are read afresh from here on.
  void refresh();

  /// Of the block interpreted last, in the program that it stands in.
  [[nodiscard]] base::LineNumber line() const { return m_line; }
  /// Of the workpiece frame after it, machine coordinates.
  [[nodiscard]] base::Vec3 zeroMm() { return m_executor.state().zeroMm(); }

 private:
  /// The variables of the program, with the R-parameters and the main run of the machine.
  class Values final : public nc::Variables {
   public:
    Values(RParameters& parameters, const InterpreterOptions& options);
    [[nodiscard]] nc::Expected<double> r(int index) const override;
    [[nodiscard]] nc::Expected<double> mainR(int index) const override;
    [[nodiscard]] nc::Expected<nc::Value> system(std::string_view name,
                                                 std::span<const nc::Value> indices) const override;
    /// Where the control is said to read R only after a STOPRE: reads them.
    void refresh();
    /// $P_TOOLR and $P_TOOLL[1], mm.
    void setTool(double radiusMm, double lengthMm) {
      m_toolRadiusMm = radiusMm;
      m_toolLengthMm = lengthMm;
    }
    /// Work offsets that $P_UIFR has changed; nothing: none since they were taken.
    [[nodiscard]] std::optional<std::map<int, base::Vec3>> takeOffsets();

   private:
    [[nodiscard]] nc::Expected<void> setR(int index, double value) override;
    [[nodiscard]] nc::Expected<void> setSystem(std::string_view name,
                                               std::span<const nc::Value> indices,
                                               double value) override;
    std::map<int, base::Vec3> m_offsetsMm;  ///< by key of the G function
    bool m_hasNewOffsets = false;
    double m_toolRadiusMm = 0.0;
    double m_toolLengthMm = 0.0;
    RParameters& m_parameters;
    const MainRun* m_mainRun;
    std::vector<double> m_cache;  // empty: read live
  };

  /// A drilling cycle or a pattern of holes with its parameters.
  struct CycleCall {
    std::string name;
    std::vector<std::optional<double>> arguments;
  };

  // What a call saves, and its end brings back, is the executor's.
  void entered(const nc::Tree& program) override { m_executor.enterCall(program.saves); }
  void left() override { m_executor.leaveCall(); }
  [[nodiscard]] Prepared execute(const nc::Statement& statement);
  [[nodiscard]] Prepared executeWords(const nc::Words& words, base::LineNumber line);
  void selectWorkOffset(const nc::Words& words);
  [[nodiscard]] Prepared nextBlock();
  [[nodiscard]] Prepared inOrder(Prepared prepared, base::LineNumber line);
  void append(Prepared prepared);
  void compensate(Prepared prepared);
  void finishPath();
  [[nodiscard]] bool readValue(const nc::Token& token);
  [[nodiscard]] base::Vec3 planeNormal();
  [[nodiscard]] Prepared leave();
  [[nodiscard]] Prepared swivel(const nc::Call& call, base::LineNumber line) const;
  // Cycles.
  [[nodiscard]] bool isCycle(const nc::Call& call) const;
  [[nodiscard]] Prepared callCycle(const nc::Call& call, base::LineNumber line);
  [[nodiscard]] Prepared setModalCall(const nc::RepeatedCall& call);
  [[nodiscard]] Prepared callModally(base::LineNumber line);
  [[nodiscard]] nc::Expected<CycleCall> evaluated(const nc::Call& call) const;
  [[nodiscard]] std::optional<Alarm> addSteps(const CycleCall& call, base::Vec3 placeMm);
  [[nodiscard]] Prepared nextStep();
  [[nodiscard]] nc::CycleStart cycleStart(base::Vec3 placeMm);

  Values m_values;
  nc::Flow m_flow;
  base::LineNumber m_line;
  bool m_hasStopped = false;  ///< the stop that the next statement needs has been made
  AlarmSink m_alarms;
  MotionSink m_motions;
  nc::WordObserver m_observer;
  nc::ExecutorOptions m_executorOptions;
  nc::Executor m_executor;
  MachineWords m_machineWords;
  std::deque<Prepared> m_due;  ///< of the block interpreted last
  ContourCorners m_corners;
  std::optional<ContourCorner> m_corner;  ///< of the present block
  double m_roundingMm = 0.0;              ///< RNDM
  double m_allowanceMm = 0.0;             ///< OFFN
  RadiusCompensation m_compensation;
  nc::Library m_library;
  std::optional<CycleCall> m_modalCycle;
  std::optional<nc::Call> m_modalCall;  ///< of a subprogram
  std::size_t m_modalDepth = 0;         ///< of programs, while that one is executed; 0: it is not
  std::deque<nc::CycleStep> m_steps;    ///< of a cycle, still to come
  base::LineNumber m_cycleLine;
};

}  // namespace rivulet::machine
