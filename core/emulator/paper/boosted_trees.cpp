// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/paper/boosted_trees.h"

#include <algorithm>
#include <numeric>

#include "base/contract.h"

namespace rivulet::emulator::paper {

/// Grows trees on the same rows. Each column keeps the rows in the order of its values; a node is a
/// range of rows, the same one in all columns, so that a split is found in one pass of each.
class BoostedTrees::Grower {
 public:
  Grower(std::span<const double> predictors, std::size_t columns, const BoostingSettings& settings)
      : m_predictors(predictors),
        m_columns(columns),
        m_rows(predictors.size() / columns),
        m_settings(settings),
        m_isBelow(m_rows, false) {
    m_sorted.resize(columns, std::vector<std::uint32_t>(m_rows));
    for (std::size_t column = 0; column < columns; ++column) {
      std::vector<std::uint32_t>& order = m_sorted[column];
      std::iota(order.begin(), order.end(), 0U);
      std::ranges::stable_sort(order, {}, [&](std::uint32_t row) { return at(row, column); });
    }
  }

  /// @param residuals  of each row; those of the tree are taken off, times the rate
  Tree grow(std::vector<double>& residuals, std::vector<double>& importance) {
    m_order = m_sorted;
    m_residuals = residuals;
    Tree tree(1);
    std::vector<Leaf> leaves{leafOf(0, 0, m_rows)};
    for (int split = 0; split < m_settings.splits; ++split) {
      const auto best = std::ranges::max_element(leaves, {}, &Leaf::gain);
      if (best->gain <= 0.0) {
        break;
      }
      const Leaf leaf = *best;
      importance[leaf.column] += leaf.gain;
      const std::size_t middle = partition(leaf);
      const std::size_t child = tree.size();
      tree[leaf.node] = {leaf.column, leaf.threshold, child, child + 1, 0.0};
      tree.resize(child + 2);
      *best = leafOf(child, leaf.begin, middle);
      leaves.push_back(leafOf(child + 1, middle, leaf.end));
    }
    for (const Leaf& leaf : leaves) {
      double& value = tree[leaf.node].value;
      value = leaf.sum / static_cast<double>(leaf.end - leaf.begin);
      for (std::size_t i = leaf.begin; i < leaf.end; ++i) {
        residuals[m_order.front()[i]] -= m_settings.rate * value;
      }
    }
    return tree;
  }

 private:
  struct Leaf {
    std::size_t node = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
    double sum = 0.0;   ///< of the residuals
    double gain = 0.0;  ///< squared error that the best split takes away; 0: none
    std::size_t column = 0;
    double threshold = 0.0;
  };

  [[nodiscard]] double at(std::uint32_t row, std::size_t column) const {
    return m_predictors[row * m_columns + column];
  }

  Leaf leafOf(std::size_t node, std::size_t begin, std::size_t end) {
    Leaf leaf;
    leaf.node = node;
    leaf.begin = begin;
    leaf.end = end;
    for (std::size_t i = begin; i < end; ++i) {
      leaf.sum += m_residuals[m_order.front()[i]];
    }
    for (std::size_t column = 0; column < m_columns; ++column) {
      findSplit(column, leaf);
    }
    return leaf;
  }

  void findSplit(std::size_t column, Leaf& leaf) const {
    const std::vector<std::uint32_t>& order = m_order[column];
    const auto count = static_cast<double>(leaf.end - leaf.begin);
    // A gain that rounding alone could make is none.
    const double least = 1e-12 * (1.0 + leaf.sum * leaf.sum / count);
    double below = 0.0;
    for (std::size_t i = leaf.begin; i + 1 < leaf.end; ++i) {
      below += m_residuals[order[i]];
      const std::size_t rowsBelow = i + 1 - leaf.begin;
      const double value = at(order[i], column);
      const double next = at(order[i + 1], column);
      if (rowsBelow < m_settings.leafRows || leaf.end - i - 1 < m_settings.leafRows ||
          !(value < next)) {
        continue;
      }
      const auto nBelow = static_cast<double>(rowsBelow);
      const double above = leaf.sum - below;
      const double gain =
          below * below / nBelow + above * above / (count - nBelow) - leaf.sum * leaf.sum / count;
      if (gain > std::max(leaf.gain, least)) {
        leaf.gain = gain;
        leaf.column = column;
        // Not above the larger value, wherever rounding puts the middle.
        leaf.threshold = std::max(value, std::min(0.5 * (value + next), next));
        if (!(leaf.threshold < next)) {
          leaf.threshold = value;
        }
      }
    }
  }

  /// Rows below the threshold first, in each column. @return where the others begin
  std::size_t partition(const Leaf& leaf) {
    std::size_t middle = leaf.begin;
    for (std::size_t i = leaf.begin; i < leaf.end; ++i) {
      const std::uint32_t row = m_order.front()[i];
      m_isBelow[row] = at(row, leaf.column) <= leaf.threshold;
      middle += m_isBelow[row] ? 1 : 0;
    }
    for (std::vector<std::uint32_t>& order : m_order) {
      std::stable_partition(order.begin() + static_cast<std::ptrdiff_t>(leaf.begin),
                            order.begin() + static_cast<std::ptrdiff_t>(leaf.end),
                            [this](std::uint32_t row) { return m_isBelow[row]; });
    }
    return middle;
  }

  std::span<const double> m_predictors;
  std::size_t m_columns;
  std::size_t m_rows;
  BoostingSettings m_settings;
  std::vector<std::vector<std::uint32_t>> m_sorted;
  std::vector<std::vector<std::uint32_t>> m_order;
  std::vector<double> m_residuals;
  std::vector<bool> m_isBelow;
};

BoostedTrees::BoostedTrees(std::span<const double> predictors, std::size_t columns,
                           std::span<const double> outputs, const BoostingSettings& settings)
    : m_rate(settings.rate), m_importance(columns, 0.0) {
  RIVULET_ASSERT(!outputs.empty());
  RIVULET_ASSERT(columns > 0);
  RIVULET_ASSERT(predictors.size() == columns * outputs.size());
  RIVULET_ASSERT(settings.trees > 0);
  const auto rows = static_cast<double>(outputs.size());
  m_mean = std::accumulate(outputs.begin(), outputs.end(), 0.0) / rows;
  std::vector<double> residuals;
  for (const double output : outputs) {
    residuals.push_back(output - m_mean);
  }
  const auto squares = [&residuals] {
    return std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0);
  };
  const double before = squares();
  Grower grower(predictors, columns, settings);
  for (int i = 0; i < settings.trees; ++i) {
    m_trees.push_back(grower.grow(residuals, m_importance));
  }
  for (double& one : m_importance) {
    one /= rows * settings.trees;
  }
  m_explainedShare = before > 0.0 ? 1.0 - squares() / before : 1.0;
}

double BoostedTrees::valueOf(const Tree& tree, std::span<const double> row) {
  const Node* node = &tree.front();
  while (node->below != 0) {
    node = &tree[row[node->column] <= node->threshold ? node->below : node->above];
  }
  return node->value;
}

double BoostedTrees::predict(std::span<const double> row) const {
  double value = m_mean;
  for (const Tree& tree : m_trees) {
    value += m_rate * valueOf(tree, row);
  }
  return value;
}

}  // namespace rivulet::emulator::paper
