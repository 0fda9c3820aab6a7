// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "papers/equations.h"
#include "support/hard_machine.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::papers;

namespace {

EquationsOptions small() {
  EquationsOptions options;
  options.contours = 2;
  options.runsPerPoint = 1;
  options.pointsPerRun = 50;
  return options;
}

}  // namespace

class TestEquationsExperiment : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void countsEveryRunOnce() {
    base::SerialExecutor executor;
    std::size_t done = 0;
    const auto result =
        runEquations(small(), tests::hardMachine(), executor, [&](std::size_t now, std::size_t) {
          done = std::max(done, now);
          return true;
        });
    QVERIFY(result);
    const Experiment& experiment = *result;
    QCOMPARE(experiment.name, std::string("equations"));
    const Table& confusion = experiment.tables.at(0);
    QCOMPARE(confusion.rows.size(), std::size_t{6});
    std::size_t position = 0;
    std::size_t signal = 0;
    for (const auto& row : confusion.rows) {
      std::size_t sum = 0;
      for (std::size_t column = 1; column <= 4; ++column) {
        sum += std::stoul(row[column]);
      }
      (row[0].find("(3)") == std::string::npos ? position : signal) = sum;
      // Both sides of the border were tried.
      QVERIFY(std::stoul(row[1]) > 0 && std::stoul(row[4]) > 0);
    }
    QCOMPARE(position + signal, done);
    for (const Table& table : experiment.tables) {
      for (const auto& row : table.rows) {
        QCOMPARE(row.size(), table.columns.size());
      }
    }
    QCOMPARE(experiment.plots.size(), std::size_t{4});
    QVERIFY(experiment.checks.size() >= 5);
    // Few runs, but the model must not be far off.
    for (const Check& check : experiment.checks) {
      if (check.what.starts_with("extended model")) {
        QVERIFY2(check.ours < 0.15, std::to_string(check.ours).c_str());
      }
    }
  }

  void cancelledRunDoesNotPass() {
    base::SerialExecutor executor;
    const auto experiment = runEquations(small(), tests::hardMachine(), executor,
                                         [](std::size_t done, std::size_t) { return done < 10; });
    QVERIFY(experiment && !experiment->passed());
  }
};

RIVULET_TEST(TestEquationsExperiment)
#include "tst_equations_experiment.moc"
