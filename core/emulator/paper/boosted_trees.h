// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Least-squares boosting of regression trees, and the importance of each predictor. Each tree is
/// fitted to what the trees before it leave of the output, and a share of it is added. A tree grows
/// at the leaf whose best split reduces the squared error most. What all splits at a predictor
/// reduce, averaged over the trees, is its importance.
///
/// It is written here because Debian's only library for it, XGBoost, starts threads of its own.
/// @threadsafety one object, one thread; const functions from any.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rivulet::emulator::paper {

/// @deviation [P2] gives none of these numbers.
struct BoostingSettings {
  int trees = 100;
  int splits = 10;            ///< of a tree at most
  double rate = 0.1;          ///< share of a tree that is added, above 0 to 1
  std::size_t leafRows = 10;  ///< of a leaf at least
};

class BoostedTrees {
 public:
  /// @param predictors  by rows, `columns` in each   @param outputs  one of each row, at least one
  BoostedTrees(std::span<const double> predictors, std::size_t columns,
               std::span<const double> outputs, const BoostingSettings& settings = {});

  [[nodiscard]] double predict(std::span<const double> row) const;

  /// Of each column: squared error that its splits take away, for one row and tree on average.
  /// @source [P2] eq. (6)
  [[nodiscard]] const std::vector<double>& importance() const { return m_importance; }
  /// Share of the outputs' variance that the trees explain, of the rows they were fitted to.
  [[nodiscard]] double explainedShare() const { return m_explainedShare; }

 private:
  /// A leaf has no children.
  struct Node {
    std::size_t column = 0;
    double threshold = 0.0;  ///< rows that are not above it go to `below`
    std::size_t below = 0;
    std::size_t above = 0;
    double value = 0.0;
  };
  using Tree = std::vector<Node>;

  class Grower;

  [[nodiscard]] static double valueOf(const Tree& tree, std::span<const double> row);

  double m_mean = 0.0;
  double m_rate = 1.0;
  std::vector<Tree> m_trees;
  std::vector<double> m_importance;
  double m_explainedShare = 0.0;
};

}  // namespace rivulet::emulator::paper
