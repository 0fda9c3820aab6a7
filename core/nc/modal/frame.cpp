// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/modal/frame.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/contract.h"

namespace rivulet::nc {

namespace {

using base::Vec3;
using Eigen::Matrix3d;

/// Lengths and right angles that differ by less do so by rounding.
constexpr double kSameShare = 1e-12;

Matrix3d matrixOf(const std::array<Vec3, base::kAxisCount>& columns) {
  static_assert(sizeof(Vec3) == base::kAxisCount * sizeof(double), "columns lie one after another");
  return Eigen::Map<const Matrix3d>(&columns[0].x);
}

std::array<Vec3, base::kAxisCount> columnsOf(const Matrix3d& matrix) {
  std::array<Vec3, base::kAxisCount> columns;
  Eigen::Map<Matrix3d>(&columns[0].x) = matrix;
  return columns;
}

Vec3 times(const std::array<Vec3, base::kAxisCount>& columns, Vec3 vector) {
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

}  // namespace

void Frame::setMatrix(const Columns& columns) {
  m_columns = columns;
  m_inverseColumns = columnsOf(matrixOf(columns).inverse());
  m_isIdentity = false;
}

Vec3 Frame::toProgrammed(Vec3 workpieceMm) const {
  return m_isIdentity ? workpieceMm : times(m_inverseColumns, workpieceMm - m_translationMm);
}

Vec3 Frame::turned(Vec3 programmed) const {
  return times(m_columns, programmed);
}

bool Frame::isAligned() const {
  return matrixOf(m_columns).isDiagonal(0.0);
}

bool Frame::mirrors() const {
  return matrixOf(m_columns).determinant() < 0.0;
}

bool Frame::isSkewed() const {
  const Matrix3d squares = matrixOf(m_columns).transpose() * matrixOf(m_columns);
  for (int axis = 0; axis < 3; ++axis) {
    const int next = (axis + 1) % 3;
    if (std::abs(squares(axis, next)) >
        kSameShare * std::sqrt(squares(axis, axis) * squares(next, next))) {
      return true;
    }
  }
  return false;
}

bool Frame::keepsCircles() const {
  const Eigen::Vector3d squares = matrixOf(m_columns).colwise().squaredNorm();
  return !isSkewed() && (squares.array() - squares[0]).abs().maxCoeff() <= kSameShare * squares[0];
}

double Frame::stretchMax() const {
  if (m_isIdentity) {
    return 1.0;
  }
  // Where the columns are not at right angles, the Frobenius norm bounds the stretch.
  const Eigen::Vector3d squares = matrixOf(m_columns).colwise().squaredNorm();
  return std::sqrt(isSkewed() ? squares.sum() : squares.maxCoeff());
}

void Frame::translate(Vec3 offsetMm) {
  m_translationMm = m_translationMm + times(m_columns, offsetMm);
  m_isIdentity = false;
}

void Frame::rotate(std::size_t axis, double degrees) {
  const auto about = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(axis));
  Matrix3d turn = Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, about).toRotationMatrix();
  // Whole quarter turns are exact: they keep the axes apart.
  const double quarters = degrees / 90.0;
  if (quarters == std::floor(quarters)) {
    turn = turn.array().round().matrix();
  }
  setMatrix(columnsOf(matrixOf(m_columns) * turn));
}

void Frame::scale(Vec3 factors) {
  RIVULET_ASSERT(factors.x != 0.0 && factors.y != 0.0 && factors.z != 0.0);
  setMatrix({factors.x * m_columns[0], factors.y * m_columns[1], factors.z * m_columns[2]});
}

}  // namespace rivulet::nc
