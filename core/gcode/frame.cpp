// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/contract.h"

namespace rivulet::gcode {

namespace {

using base::Vec3;
using Columns = std::array<Vec3, base::kAxisCount>;

/// Lengths and right angles that differ by less do so by rounding.
constexpr double kSameShare = 1e-12;

Vec3 times(const Columns& columns, Vec3 vector) {
  Vec3 sum;
  for (std::size_t row = 0; row < base::kAxisCount; ++row) {
    double value = 0.0;
    for (std::size_t column = 0; column < base::kAxisCount; ++column) {
      // A zero keeps the NaN of an axis that is not known out of the others.
      if (columns[column][row] != 0.0) {
        value += columns[column][row] * vector[column];
      }
    }
    sum.set(row, value);
  }
  return sum;
}

Columns product(const Columns& a, const Columns& b) {
  return {times(a, b[0]), times(a, b[1]), times(a, b[2])};
}

}  // namespace

Vec3 Frame::toWorkpiece(Vec3 programmedMm) const {
  return m_isIdentity ? programmedMm : times(m_columns, programmedMm) + m_translationMm;
}

Vec3 Frame::toProgrammed(Vec3 workpieceMm) const {
  return m_isIdentity ? workpieceMm : times(m_inverseColumns, workpieceMm - m_translationMm);
}

Vec3 Frame::turned(Vec3 programmed) const {
  return times(m_columns, programmed);
}

bool Frame::isAligned() const {
  for (std::size_t column = 0; column < base::kAxisCount; ++column) {
    for (std::size_t row = 0; row < base::kAxisCount; ++row) {
      if (row != column && m_columns[column][row] != 0.0) {
        return false;
      }
    }
  }
  return true;
}

bool Frame::isSkewed() const {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const Vec3& a = m_columns[axis];
    const Vec3& b = m_columns[(axis + 1) % base::kAxisCount];
    if (std::abs(base::dot(a, b)) > kSameShare * base::norm(a) * base::norm(b)) {
      return true;
    }
  }
  return false;
}

bool Frame::keepsCircles() const {
  const double squares = base::dot(m_columns[0], m_columns[0]);
  for (const Vec3& column : m_columns) {
    if (std::abs(base::dot(column, column) - squares) > kSameShare * squares) {
      return false;
    }
  }
  return !isSkewed();
}

double Frame::stretchMax() const {
  if (m_isIdentity) {
    return 1.0;
  }
  double largest = 0.0;
  double sum = 0.0;
  for (const Vec3& column : m_columns) {
    largest = std::max(largest, base::dot(column, column));
    sum += base::dot(column, column);
  }
  // Where the columns are not at right angles, the Frobenius norm bounds the stretch.
  return std::sqrt(isSkewed() ? sum : largest);
}

void Frame::translate(Vec3 offsetMm) {
  m_translationMm = m_translationMm + times(m_columns, offsetMm);
  m_isIdentity = false;
}

void Frame::rotate(std::size_t axis, double degrees) {
  const double radians = degrees * std::numbers::pi / 180.0;
  // Whole quarter turns are exact: they keep the axes apart.
  const double quarters = degrees / 90.0;
  const bool isQuarter = quarters == std::floor(quarters);
  const double cosine = isQuarter ? std::round(std::cos(radians)) : std::cos(radians);
  const double sine = isQuarter ? std::round(std::sin(radians)) : std::sin(radians);
  const auto turn = [axis](double c, double s) {
    Columns columns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const std::size_t first = (axis + 1) % base::kAxisCount;
    const std::size_t second = (axis + 2) % base::kAxisCount;
    columns[first].set(first, c);
    columns[first].set(second, s);
    columns[second].set(first, -s);
    columns[second].set(second, c);
    return columns;
  };
  m_columns = product(m_columns, turn(cosine, sine));
  m_inverseColumns = product(turn(cosine, -sine), m_inverseColumns);
  m_isIdentity = false;
}

void Frame::scale(Vec3 factors) {
  RIVULET_ASSERT(factors.x != 0.0 && factors.y != 0.0 && factors.z != 0.0);
  const Columns scaling{{{factors.x, 0, 0}, {0, factors.y, 0}, {0, 0, factors.z}}};
  const Columns inverse{
      {{1.0 / factors.x, 0, 0}, {0, 1.0 / factors.y, 0}, {0, 0, 1.0 / factors.z}}};
  m_columns = product(m_columns, scaling);
  m_inverseColumns = product(inverse, m_inverseColumns);
  m_isIdentity = false;
}

}  // namespace rivulet::gcode
