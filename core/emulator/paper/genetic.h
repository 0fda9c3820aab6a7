// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A genetic algorithm with the operators that [P2] names. It minimises a score over positive
/// numbers and knows nothing of machines.
///
/// It is written here because pagmo2's `sga` has none of the three: its selection is `tournament`
/// or `truncated`, its crossover `exponential`, `binomial`, `single` or `sbx`, its mutation
/// `gaussian`, `uniform` or `polynomial`.
///
/// One generation: the best (5 %) stay. Of the others, 80 % are children of two parents and the
/// rest mutants of one. Parents are chosen by stochastic uniform selection: each individual has a
/// section of a line, as long as 1 / sqrt(rank), and a pointer moves along it in equal steps from a
/// random start. A child is, gene by gene, a uniformly weighted average of its parents. A mutant
/// goes from its parent in a random direction; the length of the step adapts (4 times as long after
/// a generation that found a better best, at most the start range, else a quarter), and is halved
/// until all genes are above their bounds.
///
/// @source [P2] sections 2.3 and 3.1.
/// @deviation The paper names the operators and the tool (MATLAB's ga), not their details: rank
/// scaling, the direction and the change of the step are our choice.
/// @threadsafety one object, one thread; the caller's `EvaluateAll` may use more.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace rivulet::emulator::paper {

struct GeneticSettings {
  std::size_t populationSize = 50;  ///< at least 4
  int generations = 100;            ///< after the first population
  double eliteShare = 0.05;         ///< of the population, rounded up
  double crossoverShare = 0.8;      ///< of the population without the elite
  std::uint64_t seed = 1;
};

struct Gene {
  double lowest = 0.0;  ///< any value is above it
  double startLow = 0.0;
  double startHigh = 1.0;
};

struct Individual {
  std::vector<double> genes;
  double score = 0.0;  ///< the lower the better
};

/// All that is needed to continue.
struct GeneticState {
  int generation = 0;     ///< of `population`; 0: the first
  double stepSize = 1.0;  ///< of mutation, in start ranges
  /// Sorted by score, the best first.
  std::vector<Individual> population;
};

/// Scores candidates: scores[i] is that of candidates[i]. Called with all new individuals of a
/// generation at once, so that it can share them among threads.
using EvaluateAll =
    std::function<void(std::span<const std::vector<double>> candidates, std::span<double> scores)>;

/// A first population, uniform in the start ranges.
[[nodiscard]] std::vector<std::vector<double>> drawPopulation(const GeneticSettings& settings,
                                                              const std::vector<Gene>& genes);

/// Size of the elite.
[[nodiscard]] std::size_t eliteCount(const GeneticSettings& settings);

class Genetic {
 public:
  /// Evaluates the first population. @param first  of the settings' size
  Genetic(const GeneticSettings& settings, std::vector<Gene> genes, EvaluateAll evaluateAll,
          std::vector<std::vector<double>> first);
  /// Continues. @param state  its population has the settings' size
  Genetic(const GeneticSettings& settings, std::vector<Gene> genes, EvaluateAll evaluateAll,
          GeneticState state);

  [[nodiscard]] bool done() const { return m_state.generation >= m_settings.generations; }
  /// One generation. The same seed gives the same result, wherever it was interrupted.
  void step();

  [[nodiscard]] const GeneticState& state() const { return m_state; }
  [[nodiscard]] const Individual& best() const { return m_state.population.front(); }

 private:
  GeneticSettings m_settings;
  std::vector<Gene> m_genes;
  EvaluateAll m_evaluateAll;
  GeneticState m_state;
};

}  // namespace rivulet::emulator::paper
