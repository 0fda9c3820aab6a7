// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The canned drilling cycles of ISO and RS-274 (G73, G74, G76, G81 to G86, G89) as the moves they
/// consist of, in the language of a SINUMERIK: what such a cycle does depends on G90 and G91, G98
/// and G99, and on words that stay in force, for which the cycles of a SINUMERIK have no place.
/// @threadsafety plain values.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/vec3.h"
#include "nc/exec/executor.h"

namespace rivulet::job {

class HoleCycles {
 public:
  /// A G function with this key begins. @return false: it is no cycle that is known here
  bool begin(int key);
  void end() { m_key.reset(); }
  /// Boring from behind: lifts the tool off the wall, in a direction that a setting gives.
  [[nodiscard]] static bool lifts(int key) { return key == 870; }
  [[nodiscard]] bool isOn() const { return m_key.has_value(); }
  /// G98, G99.
  void retractToStart(bool isToStart) { m_toStart = isToStart; }
  /// M3, M4.
  void spindleTurns(int function) { m_spindle = function; }

  /// Takes the words of a block in a cycle, and drills where it names a place. The executor stands
  /// above the last hole afterwards. @param dwellS  P, seconds
  /// @return lines, or the word that the program has left to the control ("R"); empty: the height
  /// before the cycle is not known
  [[nodiscard]] tl::expected<std::vector<std::string>, std::string> drill(
      const nc::BlockWords& words, std::optional<double> dwellS, nc::Executor& executor);

 private:
  /// A number as the program has it: relative to another height with G91.
  struct Height {
    double valueMm = 0.0;
    bool isIncrement = false;
  };
  class Writer;
  void takeWords(const nc::BlockWords& words, std::optional<double> dwellS,
                 const nc::ModalState& state);
  [[nodiscard]] std::string lacks(double feedMmPerS, double spindlePerMin) const;
  [[nodiscard]] bool needsStart() const {
    return m_toStart || (m_retract && m_retract->isIncrement);
  }
  void writeHole(Writer& to, double retractMm, double depthMm, double feedMmPerS,
                 double spindlePerMin) const;

  std::optional<int> m_key;
  bool m_toStart = true;
  int m_spindle = 3;
  double m_startMm = 0.0;  ///< height when the cycle began; NaN: not known
  bool m_isFirst = false;
  std::optional<Height> m_retract;  ///< R
  std::optional<Height> m_depth;
  double m_strokeMm = 0.0;  ///< Q
  double m_dwellS = 0.0;    ///< P
  /// Of tapping with chip breaking: how far back, 0 out of the hole; nothing: Q means something
  /// else.
  std::optional<double> m_breakBackMm;
  struct Orientation {
    base::Vec3 asideMm;
    double degrees = 0.0;
    double backMmPerS = 0.0;  ///< 0: rapid
  };
  std::optional<Orientation> m_orientation;  ///< of fine boring: named words, see `takeWords`
};

}  // namespace rivulet::job
