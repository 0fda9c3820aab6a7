// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>

#include "base/text.h"
#include "emulator/emulator_error.h"
#include "papers/published_emulator.h"
#include "platform/thread_executor.h"
#include "support/test_program.h"
#include "training/recorded_run.h"

using namespace rivulet;

namespace {

const std::filesystem::path kRecordings = RIVULET_SOURCE_DIR "/../shared/groundtruth";

bool haveRecordings() {
  std::error_code missing;
  return std::filesystem::exists(kRecordings / "data" / "opcua", missing);
}

}  // namespace

class TestPublishedEmulator : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void readsWhatAClientSaw() {
    const auto samples =
        training::parseObservedSamples("t_s,x,y,vx,vy,keep\n0.1,1,2,3,4,1\n0.2,5,6,7,8,0\n");
    QVERIFY(samples);
    QCOMPARE(samples->size(), std::size_t{2});
    QCOMPARE(samples->back().yMm, 6.0);
    QCOMPARE(samples->back().xMmPerS, 7.0);
    QVERIFY(!training::parseObservedSamples("t_s,x,y,vx\n0.1,1,2,3\n"));
  }

  void saysWhichFileIsMissing() {
    parallel::ThreadExecutor executor;
    const auto result = papers::runPublishedEmulator("/no/such/folder", executor, {});
    QVERIFY(!result);
    QVERIFY(result.error().code == training::RecordedRunError::FileUnreadable);
    QVERIFY(result.error().text().find("G1_g61") != std::string::npos);
  }

  /// A small population for a few generations: not what the page shows, and so no verdict on the
  /// paper. What it has to show is that each figure of learning has its null model beside it, and
  /// that on these recordings the null models pass the paper's limits.
  void hasNullModelsBesideItsFigures() {
    if (!haveRecordings()) {
      QSKIP("The recordings of the other motion controller are not here.");
    }
    parallel::ThreadExecutor executor;
    papers::PublishedEmulatorOptions options;
    options.genetic.populationSize = 12;
    options.genetic.generations = 3;
    options.generationsOfTen = 1;
    options.seeds = 2;
    const auto result = papers::runPublishedEmulator(kRecordings, executor, options);
    QVERIFY2(result, result ? "" : result.error().text().c_str());
    int passedByNullModels = 0;
    int learning = 0;
    for (const papers::Check& check : result->checks) {
      qInfo("%s: %g %s ([P2] %g, null model %g)", check.what.c_str(), check.ours,
            check.unit.c_str(), check.reference, check.nullModel);
      const bool isPapers = check.source.starts_with("[P2] Table") && !std::isnan(check.reference);
      passedByNullModels += isPapers && check.nullModelPasses() ? 1 : 0;
      if (check.what.starts_with("greatest share that learning leaves")) {
        ++learning;
        QVERIFY2(!check.nullModelPasses(), check.what.c_str());
      }
    }
    QCOMPARE(passedByNullModels, 4);  // least and greatest of Tables 2 and 3
    QCOMPARE(learning, 3);
    // Position = set point, as planned from the programs (docs/emulator-p2.md).
    const std::array<double, 3> setPointMm{0.145, 0.223, 0.259};
    for (std::size_t design = 0; design < setPointMm.size(); ++design) {
      const double mm = base::parseNumber(result->tables[1].rows[design][4]).value();
      QVERIFY2(std::abs(mm - setPointMm[design]) < 0.001, std::to_string(mm).c_str());
    }
    QVERIFY(result->tables.size() >= 6);
    QCOMPARE(result->plots.size(), std::size_t{6});
    for (const papers::Plot& plot : result->plots) {
      for (const papers::Series& series : plot.series) {
        QVERIFY2(!series.x.empty() && series.x.size() == series.y.size(), plot.title.c_str());
      }
    }
  }

  void stopsWhenToldTo() {
    if (!haveRecordings()) {
      QSKIP("The recordings of the other motion controller are not here.");
    }
    parallel::ThreadExecutor executor;
    papers::PublishedEmulatorOptions options;
    options.genetic.populationSize = 4;
    options.progress = [](double) { return false; };
    const auto result = papers::runPublishedEmulator(kRecordings, executor, options);
    QVERIFY(!result);
    QVERIFY(result.error().code == emulator::EmulatorError::Cancelled);
  }
};

RIVULET_TEST(TestPublishedEmulator)
#include "tst_published_emulator.moc"
