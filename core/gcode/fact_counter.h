// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Counts the facts of a program while it is interpreted, from the words as they are written.
/// @threadsafety one object, one thread.
#pragma once

#include <array>
#include <cstddef>

#include "gcode/arc.h"
#include "gcode/facts.h"

namespace rivulet::gcode {

/// The axes a block names, as written. NaN: a value that could not be computed.
struct AxisValues {
  std::array<double, kProgrammedAxisCount> value{};
  std::array<bool, kProgrammedAxisCount> given{};
  std::array<bool, kProgrammedAxisCount> isIncrement{};
};

class FactCounter {
 public:
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
  /// Where the axes stand in the program's coordinates is not known any more.
  void forget();
  void forget(std::size_t axis) { m_known[axis] = false; }
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
