// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "base/random.h"
#include "emulator/paper/boosted_trees.h"
#include "support/test_program.h"

using namespace rivulet::emulator::paper;

namespace {

struct Rows {
  std::vector<double> predictors;
  std::vector<double> outputs;
};

/// Three columns: the first decides most, the second a little, the third nothing.
Rows threeColumns(std::size_t count, std::uint64_t seed) {
  rivulet::base::Random random(seed);
  Rows rows;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = random.uniform();
    const double b = random.uniform();
    const double c = random.uniform();
    rows.predictors.insert(rows.predictors.end(), {a, b, c});
    rows.outputs.push_back(10.0 * a * a + b);
  }
  return rows;
}

}  // namespace

class TestBoostedTrees : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void importanceAsInP2_eq_6() {
    // One tree, one split, worked out by hand: outputs 0 0 6 6 of mean 3 leave 4 · 9 = 36; the
    // split takes all of it. For a row that is 9. The second column never splits.
    const std::vector<double> predictors{1.0, 5.0, 2.0, 5.0, 3.0, 5.0, 4.0, 5.0};
    const std::vector<double> outputs{0.0, 0.0, 6.0, 6.0};
    const BoostedTrees one(predictors, 2, outputs, {1, 1, 1.0, 1});
    QCOMPARE(one.importance(), (std::vector<double>{9.0, 0.0}));
    QCOMPARE(one.explainedShare(), 1.0);
    // Two trees: the second finds nothing left, and the average is half.
    const BoostedTrees two(predictors, 2, outputs, {2, 1, 1.0, 1});
    QCOMPARE(two.importance(), (std::vector<double>{4.5, 0.0}));
    QCOMPARE(two.predict(std::vector<double>{2.4, 0.0}), 0.0);
    QCOMPARE(two.predict(std::vector<double>{2.6, 0.0}), 6.0);
  }

  void predictsRowsItHasNotSeen() {
    const Rows seen = threeColumns(2000, 1);
    const Rows fresh = threeColumns(500, 2);
    const BoostedTrees trees(seen.predictors, 3, seen.outputs);
    double squares = 0.0;
    for (std::size_t i = 0; i < fresh.outputs.size(); ++i) {
      const double error =
          trees.predict(std::span(fresh.predictors).subspan(3 * i, 3)) - fresh.outputs[i];
      squares += error * error;
    }
    // The outputs vary by 3.0 (standard deviation).
    QCOMPARE_LT(std::sqrt(squares / static_cast<double>(fresh.outputs.size())), 0.3);
    QCOMPARE_GT(trees.explainedShare(), 0.98);
  }

  void ranksColumnsByWhatTheyDecide() {
    const Rows rows = threeColumns(2000, 3);
    const std::vector<double> importance =
        BoostedTrees(rows.predictors, 3, rows.outputs).importance();
    QCOMPARE_GT(importance[0], 20.0 * importance[1]);
    QCOMPARE_GT(importance[1], 20.0 * importance[2]);
  }

  void takesOutputsThatDoNotDiffer() {
    const std::vector<double> predictors{1.0, 2.0, 3.0};
    const std::vector<double> outputs{4.0, 4.0, 4.0};
    const BoostedTrees trees(predictors, 1, outputs);
    QCOMPARE(trees.predict(std::vector<double>{7.0}), 4.0);
    QCOMPARE(trees.importance(), std::vector<double>{0.0});
  }
};

RIVULET_TEST(TestBoostedTrees)
#include "tst_boosted_trees.moc"
