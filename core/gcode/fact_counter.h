// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Counts the facts of a program while it is interpreted, from the words as they are written.
/// @threadsafety one object, one thread.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "gcode/facts.h"
#include "nc/exec/block_words.h"
#include "nc/geometry/arc.h"

namespace rivulet::gcode {

class FactCounter {
 public:
  using AxisValues = nc::AxisValues;
  using Arc = nc::Arc;
  using ArcWords = nc::ArcWords;

  /// @param g  0 to 3; -1 before any of them
  void motion(int g, const AxisValues& axes) {
    count(g);
    if (g == 1) {
      line(axes);
    } else {
      takeOver(axes);
    }
  }
  /// @param g  2 or 3  @param arc  plane, direction and turns; start and end are found here
  void arc(int g, const AxisValues& axes, Arc arc, ArcWords words);
  /// A move in machine coordinates: counted, but its values are others.
  void machineMotion(int g, const AxisValues& axes);
  void otherMotion() { ++m_facts.otherMotions; }
  /// Where the axis (nothing: all) stands in the program's coordinates is not known any more.
  void forget(std::optional<std::size_t> axis);
  void feed(double value);
  void units(bool inches);
  void incomplete() { m_facts.complete = false; }

  [[nodiscard]] ProgramFacts take();

 private:
  void count(int g) {
    ++(g < 0 ? m_facts.defaultMotions : m_facts.motions[static_cast<std::size_t>(g)]);
  }
  struct ArcReading {
    double length = 0.0;
    double mismatch = 0.0;
  };
  void line(const AxisValues& axes);
  void takeOver(const AxisValues& axes);

  ProgramFacts m_facts;
  std::array<ArcReading, kCentreReadings.size()> m_readings;
  std::array<double, kProgrammedAxisCount> m_value{};
  std::array<bool, kProgrammedAxisCount> m_known{};
};

}  // namespace rivulet::gcode
