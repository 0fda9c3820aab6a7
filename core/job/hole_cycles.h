// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The canned drilling cycles of ISO and RS-274 (G73, G74, G76, G81 to G89) as the moves they
/// consist of, in the language of a SINUMERIK: what such a cycle does depends on G90 and G91, G98
/// and G99, and on words that stay in force, for which the cycles of a SINUMERIK have no place.
/// @threadsafety plain values.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/vec3.h"
#include "gcode/control_settings.h"
#include "nc/exec/executor.h"

namespace rivulet::job {

class HoleCycles {
 public:
  /// @param given  what is known of the settings of the control; outlives the object
  explicit HoleCycles(const gcode::ControlSettings& given) : m_given(given) {}

  /// A G function with this key begins. @return false: it is no cycle that is known here
  bool begin(nc::Dialect dialect, int key);
  void end() { m_key.reset(); }
  [[nodiscard]] bool isOn() const { return m_key.has_value(); }
  /// G98, G99.
  void retractToStart(bool isToStart) { m_toStart = isToStart; }
  /// M3, M4.
  void spindleTurns(int function) { m_spindle = function; }

  /// Takes the words of a block in a cycle, and drills where it names a place. The executor stands
  /// above the last hole afterwards. @param dwellS  P, seconds  @param wayUp  lines that bring the
  /// tool back to the height before the cycle where only the control knows it; empty: none do
  /// @return lines, or the word that the program has left to the control ("R"); empty: the height
  /// before the cycle is not known
  [[nodiscard]] tl::expected<std::vector<std::string>, std::string> drill(
      const nc::BlockWords& words, std::optional<double> dwellS, nc::Executor& executor,
      const std::vector<std::string>& wayUp);
  /// What the last holes have taken from settings that nobody has said.
  [[nodiscard]] const gcode::ControlSettings& taken() const { return m_taken; }

 private:
  /// A number as the program has it: relative to another height with G91.
  struct Height {
    double valueMm = 0.0;
    bool isIncrement = false;
  };
  class Writer;
  void takeWords(const nc::BlockWords& words, std::optional<double> dwellS,
                 const nc::ModalState& state);
  [[nodiscard]] bool retractsToStart() const { return m_toStart.value_or(true); }
  [[nodiscard]] std::string lacks(double feedMmPerS, double spindlePerMin) const;
  [[nodiscard]] double setting(gcode::ControlSetting which);
  void takeSettings(const nc::BlockWords& words, const nc::ModalState& state);
  [[nodiscard]] std::optional<base::Vec3> liftMm(const nc::BlockWords& words,
                                                 const nc::ModalState& state);
  struct Hole {
    double startMm = 0.0;  ///< NaN: not known
    double retractMm = 0.0;
    double depthMm = 0.0;
    double afterMm = 0.0;
    double feedMmPerS = 0.0;
    double spindlePerMin = 0.0;
  };
  void writeHole(Writer& to, const Hole& hole);
  void writePecks(Writer& to, const Hole& hole);
  [[nodiscard]] double strokeMm(const Hole& hole, int number) const;
  void writeTap(Writer& to, const Hole& hole) const;
  void writeFineBore(Writer& to, const Hole& hole) const;
  void writeBackBore(Writer& to, const Hole& hole) const;

  const gcode::ControlSettings& m_given;
  gcode::ControlSettings m_taken;
  nc::Dialect m_dialect = nc::Dialect::Fanuc;
  bool m_hasSettings = false;  ///< a control of this make takes from settings what is left out
  std::optional<int> m_key;
  /// Where the program has said neither, LinuxCNC keeps what the one before has left; the others
  /// begin with G98.
  std::optional<bool> m_toStart;
  int m_spindle = 3;
  double m_startMm = 0.0;  ///< height when the cycle began; NaN: not known
  bool m_isFirst = false;
  std::optional<Height> m_retract;  ///< R
  std::optional<Height> m_depth;
  std::optional<double> m_strokeMm;  ///< Q
  double m_dwellS = 0.0;             ///< P
  /// I, J and K of a Haas: the first stroke, by how much each one is shorter, the shortest.
  std::optional<std::array<double, base::kAxisCount>> m_strokesMm;
  /// Of tapping with chip breaking: how far back, 0 out of the hole; nothing: Q means something
  /// else.
  std::optional<double> m_breakBackMm;
  struct Orientation {
    base::Vec3 asideMm;
    double degrees = 0.0;
    double backMmPerS = 0.0;  ///< 0: rapid
  };
  std::optional<Orientation> m_orientation;  ///< of fine boring and back boring
};

}  // namespace rivulet::job
