// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// All coordinates of a point in one number: the cells of an R-parameter are what a stream is made
/// of, each costs an access, and a double has room for more than one coordinate.
///
/// What is packed are whole steps of 0.001 mm (or degrees) from a place nearby. A double carries 53
/// bits exactly; with n axes each has b = ⌊52/n⌋ of them, at most 26. The number is
///   P = k₁ + k₂·2⁻ᵇ + k₃·2⁻²ᵇ + …,  0 ≤ k < 2ᵇ,
/// and the coordinate is that of the place plus (k − 2ᵇ⁻¹)/1000. Taking it apart asks no more of a
/// control than TRUNC of numbers below 2²⁶, differences, and products with a power of two, and all
/// of them are exact. What is no whole number of steps from the place does not fit.
/// @threadsafety plain values.
#pragma once

#include <algorithm>
#include <cmath>

namespace rivulet::base {

class Packing {
 public:
  /// @param axes  1 to 5
  explicit constexpr Packing(int axes) : m_bits(std::min(26, 52 / axes)) {}

  static constexpr double kStepsPerUnit = 1000.0;

  /// 2ᵇ: a digit of the number lies below it.
  [[nodiscard]] constexpr double base() const { return static_cast<double>(1 << m_bits); }
  /// 2ᵇ⁻¹: the digit of the place itself.
  [[nodiscard]] constexpr double middle() const { return 0.5 * base(); }
  /// A coordinate so far from the place, mm or degrees, in both directions, fits.
  [[nodiscard]] constexpr double reach() const { return (middle() - 1.0) / kStepsPerUnit; }

  [[nodiscard]] bool fits(double place, double coordinate) const {
    constexpr double kWhole = 5e-4;  // of a step: far above the rounding of doubles
    const double whole = steps(place, coordinate);
    return std::abs(whole) < middle() &&
           std::abs((coordinate - place) * kStepsPerUnit - whole) < kWhole;
  }
  /// A coordinate that fits beside others of its kind: off by 0.0005 at most.
  [[nodiscard]] static double rounded(double coordinate) {
    return std::round(coordinate * kStepsPerUnit) / kStepsPerUnit;
  }
  /// Takes the coordinates one after the other. @pre they fit
  class Number {
   public:
    explicit Number(const Packing& packing) : m_packing(packing) {}
    void add(double place, double coordinate) {
      m_value += m_scale * (steps(place, coordinate) + m_packing.middle());
      m_scale /= m_packing.base();
    }
    [[nodiscard]] double value() const { return m_value; }

   private:
    const Packing& m_packing;
    double m_value = 0.0;
    double m_scale = 1.0;
  };
  /// What the control makes of it.
  [[nodiscard]] static double unpacked(double place, double coordinate) {
    return place + steps(place, coordinate) / kStepsPerUnit;
  }

 private:
  [[nodiscard]] static double steps(double place, double coordinate) {
    return std::round((coordinate - place) * kStepsPerUnit);
  }

  int m_bits;
};

}  // namespace rivulet::base
