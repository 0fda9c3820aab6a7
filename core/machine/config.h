// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Every behaviour of the virtual machine as a named setting with a unit. A preset is a TOML
/// file (resources/presets/*.toml); docs/machine.md says where each number comes from.
/// @threadsafety plain values.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/axes.h"
#include "base/instant.h"
#include "base/result.h"
#include "base/vec3.h"
#include "emulator/axis_model.h"
#include "machine/prepared.h"
#include "machine/tool.h"
#include "machine/user.h"

namespace rivulet::machine {

/// Key of G500: no settable work offset is selected.
inline constexpr int kNoWorkOffsetKey = 5000;

enum class MachineError {
  PresetMissing = 1,
  PresetMalformed,  ///< TOML error, unknown key, wrong type or a value out of range
  ProgramMissing,
  NotInReset,
  NoProgramSelected,
  NotActive,
  FileExists,
  FileTooLarge,
};

[[nodiscard]] std::error_code make_error_code(MachineError code);

/// When the pre-run sees a value written from outside.
enum class RParameterReading {
  AtInterpretation,   ///< whenever the block is interpreted
  CachedUntilStopre,  ///< only after a STOPRE (the stricter wording of [P1])
};

struct AxisLimits {
  double positionMmMin = 0.0;
  double positionMmMax = 0.0;
  double speedMmPerSMax = 0.0;
  double accelerationMmPerS2Max = 0.0;
  double jerkMmPerS3Max = 0.0;      ///< with SOFT
  double servoTimeConstantS = 0.0;  ///< first-order lag of the position loop
  double startMm = 0.0;             ///< where the axis stands when the machine is switched on
};

/// A rotary axis. Its angle is not reduced to one turn; it is bounded by the limits only.
struct RotaryLimits {
  double positionDegMin = 0.0;
  double positionDegMax = 0.0;
  double speedDegPerSMax = 0.0;
  double accelerationDegPerS2Max = 0.0;
  double jerkDegPerS3Max = 0.0;     ///< with SOFT
  double servoTimeConstantS = 0.0;  ///< first-order lag of the position loop
  double startDeg = 0.0;            ///< where the axis stands when the machine is switched on
};

/// Effect of writing an array of R-parameters as one node.
enum class ArrayWrite {
  All,        ///< every element is written
  Refused,    ///< arrays can only be read
  FirstOnly,  ///< reported as done, but only the first element was written
};

/// What the variable service charges for an array node.
enum class ArrayCharge {
  Node,     ///< as much as one variable
  Element,  ///< as much as its elements one by one
};

/// Access to several R-parameters through one node.
struct ArrayAccess {
  bool count = false;  ///< there are nodes R[u1,first,#count]
  bool range = false;  ///< there are nodes R[u1,first,last]
  ArrayWrite write = ArrayWrite::All;
  ArrayCharge charge = ArrayCharge::Element;
};

/// Cost of variable access; one service for all clients, one node after another.
struct AccessCost {
  base::Duration readOverhead{};   ///< once per read request
  base::Duration writeOverhead{};  ///< once per write request
  base::Duration nodeTimeMean{};
  base::Duration nodeTimeDeviation{};  ///< standard deviation of one node
  base::Duration nodeTimeMin{};        ///< never below
  base::Duration programOverhead{};    ///< once per program that is stored
  double programBytesPerS = 0.0;       ///< of its text
  base::Duration samplingMin{};        ///< shortest sampling and publishing interval
  ArrayAccess arrays;
  /// Without a program, too, positions are told in the frame of the workpiece and with the length
  /// of the tool. Optional in a preset; of LinuxCNC.
  bool keepsFrame = false;

  /// Of storing a program of this size.
  [[nodiscard]] base::Duration programTime(std::size_t bytes) const {
    return programOverhead + base::fromSeconds(static_cast<double>(bytes) / programBytesPerS);
  }
};

struct SpindleConfig {
  double speedPerMinMax = 0.0;  ///< MD35100: a greater S is reduced to it
  base::Duration runUp{};       ///< from standstill to the greatest speed, evenly

  [[nodiscard]] base::Duration runUpTime(double changePerMin) const {
    return base::fromSeconds(base::toSeconds(runUp) * changePerMin / speedPerMinMax);
  }
};

struct ToolTable {
  base::Duration changeTime{};
  bool acceptsMissing = false;  ///< a tool that is not in the table has length and radius 0
  std::vector<Tool> tools;
  Tool inSpindle;  ///< when the machine is switched on, with D1

  [[nodiscard]] std::optional<Tool> find(int number) const;
  /// @param name  in any case of letters
  [[nodiscard]] std::optional<Tool> find(std::string_view name) const;
};

struct MachineConfig {
  std::string name;
  std::array<AxisLimits, base::kAxisCount> axes;
  std::array<std::optional<RotaryLimits>, base::kRotaryAxisCount> rotaryAxes;  ///< A B C
  /// How X, Y and Z follow their set points, learned from traces; one that was not learned has its
  /// time constant. Optional in a preset.
  std::array<std::optional<emulator::AxisParameters>, base::kAxisCount> learnedAxes;
  base::Duration interpolationCycle{};  ///< IPO cycle
  base::Duration positionCycle{};       ///< servo
  base::Duration blockPreparation{};    ///< pre-run time per block
  int bufferedBlocksMax = 0;            ///< prepared blocks the main run has not finished
  base::Duration standstillMean{};      ///< standstill of the axes at a STOPRE
  base::Duration standstillDeviation{};
  base::Duration relatch{};  ///< from standstill until the pre-run continues
  RParameterReading rRead = RParameterReading::AtInterpretation;
  bool jumpStops = false;                    ///< jumps stop the pre-run as STOPRE does
  Dynamics resetDynamics = Dynamics::Brisk;  ///< until the program says otherwise (MD20150)
  double blocksPerCycleMax = 0.0;  ///< path speed within a block: blocks per IPO cycle; 0: any
  /// $AA_OFF of X, Y and Z. Optional in a preset.
  struct Overlay {
    /// MD36750: 1 adds up the values written, 2 is kept at a reset of the channel and at the end of
    /// a program.
    int mode = 0;
    double mostMm = 10.0;  ///< SD43350
  };
  Overlay overlay;
  double roundingMm = 0.0;   ///< deviation at corners that G64 and G642 allow
  int rParameterCount = 0;   ///< MD28050
  double rapidMmPerS = 0.0;  ///< path speed of G0
  /// SD42110: the feed of a program until it names one. Optional in a preset: 0, a move without F
  /// is an alarm.
  double defaultFeedMmPerS = 0.0;
  base::Duration traceLimit{};  ///< longest recording of the control's own trace
  AccessCost access;
  UserManagement users;  ///< optional in a preset: without it, everybody is let in

  // What makes the part, each optional in a preset. Words for what a machine lacks have no effect.
  std::optional<SpindleConfig> spindle;
  std::optional<ToolTable> tools;
  std::optional<base::Duration> coolantTime;  ///< until the next block may begin
  /// By key of G500 and of G54 to G599 (nc/modal/vocabulary). G500 holds at the beginning of a
  /// program and after its end.
  std::map<int, base::Vec3> workOffsetsMm;
  std::map<int, base::Vec3> fixedPointsMm;  ///< MD30600, of G75, by number; machine coordinates
  bool programStop = false;                 ///< M0 waits for cycle start; else it does nothing
  bool optionalStop = false;                ///< M1 waits as well

  /// Of a work offset; zero if it has none. @param key  of its G function
  [[nodiscard]] base::Vec3 workOffsetMm(int key) const {
    const auto found = workOffsetsMm.find(key);
    return found == workOffsetsMm.end() ? base::Vec3{} : found->second;
  }
  [[nodiscard]] base::RotarySet rotarySet() const {
    return {rotaryAxes[0].has_value(), rotaryAxes[1].has_value(), rotaryAxes[2].has_value()};
  }
  /// The rotary axis that is axis `index` of the channel: the rotary ones follow X, Y and Z without
  /// a gap. @param index  from 0 @return 0 to 2 for A, B, C; nothing for a geometry axis or none
  [[nodiscard]] std::optional<std::size_t> rotaryAt(int index) const;
  /// No feed can be larger: the speed of the fastest linear axis, or that of G0; mm/s.
  [[nodiscard]] double feedMmPerSMax() const;
  /// How X, Y or Z follows its set point. @return nothing: exactly
  [[nodiscard]] std::optional<emulator::AxisParameters> axisLaw(std::size_t axis) const;
  /// Of the slowest of X, Y and Z: how late it is where its set point was, at constant speed.
  [[nodiscard]] base::Duration followingLag() const;
  /// Positions of all axes when the machine is switched on.
  [[nodiscard]] base::AxisPosition start() const;
};

/// The number after G that cancels the settable work offset.
inline constexpr int kNoWorkOffset = 500;

/// The virtual machine that is meant where none is named.
inline constexpr const char* kDefaultPreset = "dmu75";
/// Presets have a few kilobytes.
inline constexpr std::uintmax_t kPresetBytesMax = std::uintmax_t{1} << 20U;

/// Names of the presets that are built in, sorted.
[[nodiscard]] std::vector<std::string> presetNames();

/// True of the path of a TOML file (anything with a '/' or ".toml"), false of a name.
[[nodiscard]] bool isPresetPath(const std::string& nameOrPath);

/// A built-in preset by name, or a TOML file by path.
/// @return PresetMissing (the message lists the names), PresetMalformed (line and key)
[[nodiscard]] base::Result<MachineConfig> loadPreset(const std::string& nameOrPath);

/// Parses the text of a preset. All keys are required except those of A, B and C, which a machine
/// need not have; an unknown key is an error. The file of a learned emulator (emulator/emulator.h)
/// is a preset too: its `emulator.preset` names the one that has the keys which it lacks.
/// @param origin  of the text; a path that it names begins in the same folder
[[nodiscard]] base::Result<MachineConfig> parsePreset(std::string_view text,
                                                      const std::string& origin);

}  // namespace rivulet::machine

template <>
struct std::is_error_code_enum<rivulet::machine::MachineError> : std::true_type {};
