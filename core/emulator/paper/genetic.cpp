// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/paper/genetic.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/contract.h"
#include "base/random.h"

namespace rivulet::emulator::paper {

namespace {

constexpr double kStepGrowth = 4.0;
constexpr double kStepSizeMin = 1e-6;
constexpr int kHalvingsMax = 20;

/// `count` indices of a population sorted by score, the best first, in random succession.
std::vector<std::size_t> selectParents(std::size_t populationSize, std::size_t count,
                                       base::Random& random) {
  double length = 0.0;
  for (std::size_t rank = 1; rank <= populationSize; ++rank) {
    length += 1.0 / std::sqrt(static_cast<double>(rank));
  }
  const double step = length / static_cast<double>(count);
  double pointer = step * random.uniform();
  double end = 1.0;
  std::size_t index = 0;
  std::vector<std::size_t> parents;
  parents.reserve(count);
  for (std::size_t i = 0; i < count; ++i, pointer += step) {
    while (pointer >= end && index + 1 < populationSize) {
      ++index;
      end += 1.0 / std::sqrt(static_cast<double>(index + 1));
    }
    parents.push_back(index);
  }
  // Neighbours on the line are alike: pairs are formed at random.
  for (std::size_t i = count; i > 1; --i) {
    std::swap(parents[i - 1], parents[random.below(i)]);
  }
  return parents;
}

std::vector<double> average(const std::vector<double>& mother, const std::vector<double>& father,
                            base::Random& random) {
  std::vector<double> child(mother.size());
  for (std::size_t i = 0; i < child.size(); ++i) {
    child[i] = mother[i] + random.uniform() * (father[i] - mother[i]);
  }
  return child;
}

bool feasible(const std::vector<double>& values, const std::vector<Gene>& genes) {
  for (std::size_t i = 0; i < genes.size(); ++i) {
    if (!(values[i] > genes[i].lowest)) {
      return false;
    }
  }
  return true;
}

std::vector<double> mutate(const std::vector<double>& parent, const std::vector<Gene>& genes,
                           double stepSize, base::Random& random) {
  std::vector<double> direction(genes.size());
  double norm = 0.0;
  for (double& one : direction) {
    one = random.normal();
    norm += one * one;
  }
  norm = std::sqrt(norm);
  std::vector<double> mutant(genes.size());
  double length = stepSize;
  for (int halving = 0; halving < kHalvingsMax; ++halving, length *= 0.5) {
    for (std::size_t i = 0; i < genes.size(); ++i) {
      const double range = genes[i].startHigh - genes[i].startLow;
      mutant[i] = parent[i] + length * range * direction[i] / norm;
    }
    if (feasible(mutant, genes)) {
      return mutant;
    }
  }
  return parent;
}

void sortByScore(std::vector<Individual>& population) {
  // Stable: equal scores keep their succession, on every platform.
  std::ranges::stable_sort(population, {}, &Individual::score);
}

std::vector<Individual> evaluated(std::vector<std::vector<double>> candidates,
                                  const EvaluateAll& evaluateAll) {
  std::vector<double> scores(candidates.size(), 0.0);
  evaluateAll(candidates, scores);
  std::vector<Individual> individuals;
  individuals.reserve(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    RIVULET_ASSERT(!std::isnan(scores[i]));
    individuals.push_back({std::move(candidates[i]), scores[i]});
  }
  return individuals;
}

}  // namespace

std::vector<std::vector<double>> drawPopulation(const GeneticSettings& settings,
                                                const std::vector<Gene>& genes) {
  base::Random random = base::Random(settings.seed).fork(0);
  std::vector<std::vector<double>> population(settings.populationSize);
  for (std::vector<double>& values : population) {
    for (const Gene& gene : genes) {
      RIVULET_ASSERT(gene.startLow > gene.lowest);
      values.push_back(gene.startLow + random.uniform() * (gene.startHigh - gene.startLow));
    }
  }
  return population;
}

std::size_t eliteCount(const GeneticSettings& settings) {
  return static_cast<std::size_t>(
      std::ceil(settings.eliteShare * static_cast<double>(settings.populationSize) - 1e-9));
}

Genetic::Genetic(const GeneticSettings& settings, std::vector<Gene> genes, EvaluateAll evaluateAll,
                 std::vector<std::vector<double>> first)
    : m_settings(settings), m_genes(std::move(genes)), m_evaluateAll(std::move(evaluateAll)) {
  RIVULET_ASSERT(m_settings.populationSize >= 4);
  RIVULET_ASSERT(first.size() == m_settings.populationSize);
  m_state.population = evaluated(std::move(first), m_evaluateAll);
  sortByScore(m_state.population);
}

Genetic::Genetic(const GeneticSettings& settings, std::vector<Gene> genes, EvaluateAll evaluateAll,
                 GeneticState state)
    : m_settings(settings),
      m_genes(std::move(genes)),
      m_evaluateAll(std::move(evaluateAll)),
      m_state(std::move(state)) {
  RIVULET_ASSERT(m_state.population.size() == m_settings.populationSize);
  for (const Individual& one : m_state.population) {
    RIVULET_ASSERT(one.genes.size() == m_genes.size());
  }
  sortByScore(m_state.population);
}

void Genetic::step() {
  const std::vector<Individual>& parents = m_state.population;
  const std::size_t size = parents.size();
  const std::size_t elite = eliteCount(m_settings);
  const auto children = static_cast<std::size_t>(
      std::lround(m_settings.crossoverShare * static_cast<double>(size - elite)));
  const std::size_t mutants = size - elite - children;

  // A sequence of its own for each generation: a run that is continued draws the same numbers.
  base::Random random =
      base::Random(m_settings.seed).fork(static_cast<std::uint64_t>(m_state.generation) + 1);
  const std::vector<std::size_t> chosen = selectParents(size, 2 * children + mutants, random);
  std::vector<std::vector<double>> candidates;
  candidates.reserve(children + mutants);
  for (std::size_t i = 0; i < children; ++i) {
    candidates.push_back(
        average(parents[chosen[2 * i]].genes, parents[chosen[2 * i + 1]].genes, random));
  }
  for (std::size_t i = 0; i < mutants; ++i) {
    candidates.push_back(
        mutate(parents[chosen[2 * children + i]].genes, m_genes, m_state.stepSize, random));
  }

  const double bestBefore = best().score;
  std::vector<Individual> next(parents.begin(),
                               parents.begin() + static_cast<std::ptrdiff_t>(elite));
  std::ranges::move(evaluated(std::move(candidates), m_evaluateAll), std::back_inserter(next));
  sortByScore(next);
  m_state.population = std::move(next);
  ++m_state.generation;
  m_state.stepSize = best().score < bestBefore
                         ? std::min(1.0, kStepGrowth * m_state.stepSize)
                         : std::max(kStepSizeMin, m_state.stepSize / kStepGrowth);
}

}  // namespace rivulet::emulator::paper
