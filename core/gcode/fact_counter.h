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
#include "nc/exec/sink.h"

namespace rivulet::gcode {

class FactCounter final : public nc::WordObserver {
 public:
  void motion(int g, const nc::AxisValues& axes) override;
  void arc(const nc::AxisValues& axes, nc::Arc arc, nc::ArcWords words) override;
  /// Counted, but its values are others.
  void machineMotion(int g, const nc::AxisValues& axes) override;
  void otherMotion() override { ++m_facts.otherMotions; }
  void feed(double value) override;
  void units(bool inches) override;
  void forget(std::optional<std::size_t> axis) override;
  /// Moves that no word of the program names are left out until it is said otherwise.
  void leaveOut(bool isMade) { m_isMade = isMade; }
  void incomplete() { m_facts.complete = false; }

  [[nodiscard]] ProgramFacts take();

 private:
  void count(int g) {
    ++(g < 0 ? m_facts.defaultMotions : m_facts.motions[static_cast<std::size_t>(g)]);
  }
  void noteUnits(const nc::AxisValues& axes) {
    m_facts.movesBeforeUnits |= m_facts.units == FileUnits::Unspecified &&
                                axes.hasAny(0, base::kAxisCount);
  }
  struct ArcReading {
    double length = 0.0;
    double mismatch = 0.0;
  };
  void line(const nc::AxisValues& axes);
  void takeOver(const nc::AxisValues& axes);

  ProgramFacts m_facts;
  std::array<ArcReading, kCentreReadings.size()> m_readings;
  std::array<double, kProgrammedAxisCount> m_value{};
  std::array<bool, kProgrammedAxisCount> m_known{};
  bool m_isMade = false;
};

}  // namespace rivulet::gcode
