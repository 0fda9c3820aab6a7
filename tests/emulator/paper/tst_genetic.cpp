// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "emulator/paper/genetic.h"
#include "support/test_program.h"

using namespace rivulet::emulator::paper;

namespace {

/// A bowl with its bottom at 1, 2, 3, ...
void bowl(std::span<const std::vector<double>> candidates, std::span<double> scores) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (std::size_t gene = 0; gene < candidates[i].size(); ++gene) {
      const double off = candidates[i][gene] - static_cast<double>(gene + 1);
      scores[i] += off * off;
    }
  }
}

std::vector<Gene> genes(std::size_t count) {
  return std::vector<Gene>(count, {0.0, 0.1, 10.0});
}

Genetic makeGenetic(const GeneticSettings& settings, EvaluateAll evaluateAll = bowl) {
  return {settings, genes(4), std::move(evaluateAll), drawPopulation(settings, genes(4))};
}

}  // namespace

class TestGenetic : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void findsTheBottomOfABowl() {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      Genetic genetic = makeGenetic({.seed = seed});
      const double first = genetic.best().score;
      while (!genetic.done()) {
        genetic.step();
      }
      QCOMPARE(genetic.state().generation, 100);
      QCOMPARE_LT(genetic.best().score, 0.02 * first);
    }
  }

  void theBestNeverGetsWorse() {
    Genetic genetic = makeGenetic({.seed = 3});
    while (!genetic.done()) {
      const Individual before = genetic.best();
      genetic.step();
      QVERIFY(genetic.best().score <= before.score);
      QCOMPARE(genetic.state().population.size(), std::size_t{50});
      QVERIFY(std::ranges::is_sorted(genetic.state().population, {}, &Individual::score));
    }
  }

  void evaluatesEachNewIndividualOnce() {
    std::vector<std::size_t> calls;
    Genetic genetic = makeGenetic({.generations = 2}, [&](auto candidates, auto scores) {
      calls.push_back(candidates.size());
      bowl(candidates, scores);
    });
    genetic.step();
    // An elite of 5 % of 50, rounded up, stays.
    QCOMPARE(calls, (std::vector<std::size_t>{50, 47}));
  }

  void keepsGenesAboveTheirBounds() {
    // The bottom is where genes are not allowed.
    const auto score = [](std::span<const std::vector<double>> candidates,
                          std::span<double> scores) {
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        for (const double gene : candidates[i]) {
          QVERIFY(gene > 0.0);
          scores[i] += (gene + 1.0) * (gene + 1.0);
        }
      }
    };
    Genetic genetic = makeGenetic({.seed = 5}, score);
    while (!genetic.done()) {
      genetic.step();
    }
    QCOMPARE_LT(genetic.best().score, 8.0);
  }

  void sameSeedSameResult() {
    Genetic one = makeGenetic({.seed = 7});
    Genetic same = makeGenetic({.seed = 7});
    Genetic other = makeGenetic({.seed = 8});
    while (!one.done()) {
      one.step();
      same.step();
      other.step();
    }
    QCOMPARE(one.best().genes, same.best().genes);
    QVERIFY(one.best().genes != other.best().genes);
  }

  void continuesAsIfNeverStopped() {
    const GeneticSettings settings{.generations = 20, .seed = 9};
    Genetic whole = makeGenetic(settings);
    while (!whole.done()) {
      whole.step();
    }
    Genetic first = makeGenetic(settings);
    for (int i = 0; i < 8; ++i) {
      first.step();
    }
    Genetic second(settings, genes(4), bowl, first.state());
    while (!second.done()) {
      second.step();
    }
    QCOMPARE(second.best().genes, whole.best().genes);
    QCOMPARE(second.state().stepSize, whole.state().stepSize);
  }
};

RIVULET_TEST(TestGenetic)
#include "tst_genetic.moc"
