// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The virtual machine: NC text → pre-run → buffer → look-ahead → interpolator → servo, and the
/// variable service. Time is an argument: `advance` moves the machine to a time, and nothing inside
/// reads a clock. The OPC UA front advances it with the wall clock, the simulated link with the
/// virtual clock. The same config, seed and calls give the same run, to the bit.
/// @threadsafety one object, one thread at a time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/axes.h"
#include "base/instant.h"
#include "base/result.h"
#include "base/vec3.h"
#include "machine/config.h"
#include "trace/control_trace.h"
#include "trace/trace_piece.h"

namespace rivulet::machine {

enum class ChannelStatus { Reset = 0, Active = 1, Interrupted = 2 };
enum class ProgramStatus { Interrupted = 1, Stopped = 2, Running = 3, Waiting = 4, Aborted = 5 };

/// Spindle, tool and coolant at one moment.
struct EquipmentState {
  int tool = 0;  ///< in the spindle; 0: none, or one that has only a name
  std::string toolName;
  int nextTool = 0;  ///< selected by T
  std::string nextToolName;
  int edge = 0;                       ///< D
  double spindlePerMin = 0.0;         ///< positive: clockwise, M3
  double spindleCommandPerMin = 0.0;  ///< the same sign
  double programmedPerMin = 0.0;      ///< S
  bool spindleLimited = false;        ///< S is greater than the spindle can turn
  bool flood = false;                 ///< M8
  bool mist = false;                  ///< M7
  int workOffset = kNoWorkOffset;     ///< number of the G function
};

/// What the control shows at one moment.
struct MachineState {
  ChannelStatus channel = ChannelStatus::Reset;
  ProgramStatus program = ProgramStatus::Aborted;  ///< SINUMERIK shows "aborted" in reset
  base::Vec3 actualMm;                             ///< workpiece frame, tool's tip, after the servo
  base::Vec3 commandMm;                            ///< set point, workpiece frame
  base::Vec3 zeroMm;          ///< of the workpiece frame, machine coordinates: adds up with the two
  base::Vec3 overlayMm;       ///< part of it that is an overlay on the path ($AA_OFF)
  base::Vec3 distanceToGoMm;  ///< to the end of the block in motion
  base::RotaryDeg actualDeg{};  ///< A, B, C; 0 if there is no such axis
  base::RotaryDeg commandDeg{};
  base::RotaryDeg distanceToGoDeg{};
  double feedMmPerS = 0.0;  ///< path speed of the set point; deg/s if only rotary axes turn
  double feedCommandMmPerS = 0.0;
  unsigned line = 0;  ///< block in motion
  int bufferedBlocks = 0;
  int alarm = 0;  ///< alarm number as on the control; 0 none
  std::string alarmText;
  std::string programName;
  std::string message;         ///< MSG("...")
  bool waitsForStart = false;  ///< M0 or M1: until the next cycle start
  EquipmentState equipment;
};

enum class AccessKind { Read, Write };

class Machine {
 public:
  Machine(MachineConfig config, std::uint64_t seed);
  ~Machine();
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  [[nodiscard]] const MachineConfig& config() const;

  /// Advances the machine. @param until not before `now()` (earlier: no effect)
  void advance(base::Instant until);
  [[nodiscard]] base::Instant now() const;
  [[nodiscard]] MachineState state() const;

  // --- R-parameters -----------------------------------------------------------------------
  [[nodiscard]] bool hasRParameter(int index) const;
  /// As the variable service returns it: after a write the new value, although the NC program sees
  /// it only from the next interpolation boundary on. @param index hasRParameter
  [[nodiscard]] double rParameter(int index) const;
  /// As the NC program sees it at this moment. @param index hasRParameter
  [[nodiscard]] double ncRParameter(int index) const;
  /// Becomes visible at the next interpolation boundary. @param index hasRParameter
  void writeRParameter(int index, double value);

  // --- variable service: the cost of OPC UA access ------------------------------------------
  /// Begins a request that arrived at `arrival`; it waits until earlier ones are served.
  /// @return when the first node's turn comes
  base::Instant beginRequest(AccessKind kind, base::Instant arrival);
  /// Serves the next node of the request begun last. @return when the node is done: advance
  /// the machine to it, then read or write the variable
  base::Instant serveNode();
  /// Serves the writing of a program in the request begun last. @return when it is done
  base::Instant serveProgram(std::size_t bytes);

  // --- programs ---------------------------------------------------------------------------
  /// @param name as on the control, e.g. "A.MPF"; upper and lower case are the same
  base::Result<void> storeProgram(const std::string& name, std::string text, bool overwrite);
  [[nodiscard]] base::Result<std::string> programText(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> programNames() const;
  base::Result<void> selectProgram(const std::string& name);
  /// Starts the program selected; continues one that M0 or M1 has stopped.
  base::Result<void> cycleStart();
  /// Ends whatever is in progress; the axes brake to a standstill first. Always allowed.
  void reset();

  /// The control's own trace since the last cycle start, as far as it has not been taken.
  [[nodiscard]] const trace::ControlTrace& trace() const;
  /// The next part of it. Of what lies before `from`, only the last minutes are kept; so a client
  /// that takes the trace while the program runs gets all of it, however long the run is. While the
  /// program runs, the last event is held back: it may still change.
  [[nodiscard]] trace::TracePiece takeTrace(const trace::TracePosition& from);

 private:
  class Impl;
  std::unique_ptr<Impl> m_impl;
};

}  // namespace rivulet::machine
