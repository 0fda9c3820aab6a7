// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The methods compared, with few seeds: the order of the figures, which no seed changes.

#include <QtTest>
#include <algorithm>
#include <cmath>

#include "base/executor.h"
#include "base/text.h"
#include "machine/config.h"
#include "papers/catalogue.h"
#include "support/test_program.h"

using namespace rivulet;
using papers::Experiment;

namespace {

double numberOf(const std::string& text) {
  return base::parseNumber(text).value();
}

}  // namespace

class TestMethodComparison : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void windowsAreNeverWrong();
  void creditHasNoPausesOnTime();
  void paperMethodsHaveTheirLimit();
  void figuresFitEachOther();
  void plotsShowRightRunsOnly();

 private:
  /// Row of the table of all feeds.
  [[nodiscard]] const std::vector<std::string>& row(const std::string& method,
                                                    const std::string& feed) const {
    const auto& rows = m_result.tables.at(1).rows;
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& cells) {
      return cells[0] == method && cells[1] == feed;
    });
    if (found == rows.end()) {
      qFatal("no row %s %s", method.c_str(), feed.c_str());
    }
    return *found;
  }
  [[nodiscard]] double largestFeed(const std::string& method) const {
    for (const auto& cells : m_result.tables.at(0).rows) {
      if (cells[0] == method) {
        return numberOf(cells[1]);
      }
    }
    return 0.0;
  }

  Experiment m_result;
};

void TestMethodComparison::initTestCase() {
  base::SerialExecutor executor;
  const auto result =
      papers::runExperiment("methods", {*machine::loadPreset("dmu75"), 4, executor, {}});
  QVERIFY(result);
  m_result = *result;
  QCOMPARE(m_result.tables.size(), std::size_t{2});
  QCOMPARE(m_result.tables[1].rows.size(), std::size_t{72});
}

void TestMethodComparison::windowsAreNeverWrong() {
  QVERIFY(m_result.passed());
  QCOMPARE(m_result.checks.size(), std::size_t{4});
  for (const auto& cells : m_result.tables[1].rows) {
    if (cells[0] != "position" && cells[0] != "signal") {
      QCOMPARE(cells[2], std::string("4 of 4"));
    }
  }
  QCOMPARE(largestFeed("window"), 12000.0);
  QCOMPARE(largestFeed("credit"), 12000.0);
}

/// Up to the reach of the client, which for these contours lies above F 1000.
void TestMethodComparison::creditHasNoPausesOnTime() {
  for (const char* feed : {"100", "200", "300", "500", "700", "1000"}) {
    QCOMPARE(numberOf(row("credit", feed)[3]), 0.0);
    QCOMPARE(numberOf(row("credit", feed)[4]), 0.0);
    QVERIFY(numberOf(row("window", feed)[3]) >= 19.0);
    QVERIFY(numberOf(row("credit", feed)[5]) < numberOf(row("window", feed)[5]));
    QCOMPARE(numberOf(row("credit", feed)[9]), 0.0);
  }
}

void TestMethodComparison::paperMethodsHaveTheirLimit() {
  // d_min 0.15 mm over Δt of 12.9 to 25.8 ms: equation (1) gives 350 to 700 mm/min.
  QVERIFY(largestFeed("position") >= 300.0);
  QVERIFY(largestFeed("position") <= 700.0);
  QVERIFY(largestFeed("signal") > largestFeed("position"));
}

void TestMethodComparison::figuresFitEachOther() {
  for (const auto& cells : m_result.tables[1].rows) {
    if (cells[2] != "4 of 4") {
      continue;
    }
    // 140 points in the time told, to the digits printed.
    const double points = numberOf(cells[5]) * numberOf(cells[6]);
    QVERIFY2(std::abs(points - 140.0) < 1.5, cells[1].c_str());
    QVERIFY(numberOf(cells[4]) > 0.0 || cells[0] == "credit");
    QVERIFY(numberOf(cells[4]) < 100.0);
    // Each of the point's coordinates is written once at least, if not in a file.
    const bool isFile = cells[0].rfind("file", 0) == 0;
    QVERIFY(isFile || numberOf(cells[7]) >= 3.0);
    QVERIFY(isFile || numberOf(cells[8]) <= numberOf(cells[7]));
  }
  // 20 loops of 7 points: one standstill each, with method signal two; after the last none.
  QCOMPARE(numberOf(row("position", "300")[3]), 19.0);
  QCOMPARE(numberOf(row("signal", "300")[3]), 39.0);
  QVERIFY(numberOf(row("window", "300")[3]) >= 19.0);
  QVERIFY(numberOf(row("window", "300")[6]) > numberOf(row("signal", "300")[6]));
  // A file of 70 points: two of them, with one standstill between.
  QCOMPARE(numberOf(row("file, N 70", "300")[3]), 1.0);
  // Asking where the axes are costs more than being told.
  QVERIFY(numberOf(row("position", "300")[7]) > numberOf(row("window", "300")[7]));
}

void TestMethodComparison::plotsShowRightRunsOnly() {
  QCOMPARE(m_result.plots.size(), std::size_t{2});
  for (const auto& plot : m_result.plots) {
    QCOMPARE(plot.series.size(), std::size_t{6});
    for (const auto& series : plot.series) {
      QCOMPARE(series.x.size(), series.y.size());
      QCOMPARE(series.x.back(), largestFeed(series.name));
    }
  }
}

RIVULET_TEST(TestMethodComparison)
#include "tst_method_comparison.moc"
