// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <filesystem>
#include <vector>

#include "papers/lookahead.h"
#include "support/test_program.h"
#include "training/recorded_run.h"

using namespace rivulet;

class TestLookahead : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void readsPrograms() {
    const auto blocks = training::parseRecordedProgram(
        "(comment)\nG21 G17 G90\nG64 P0.01\nG1 X15 Y0 F600\nG3 X20 Y5 I0 J5\nG4 "
        "P0.5\nG61\nX0\nM2\n",
        {});
    QVERIFY(blocks);
    QCOMPARE(blocks->size(), std::size_t{3});
    QCOMPARE((*blocks)[0].roundingMm, 0.01);
    QCOMPARE((*blocks)[0].feedMmPerS, 10.0);
    QVERIFY((*blocks)[1].arc.has_value());
    QVERIFY(std::abs((*blocks)[1].arc->sweepRad - std::acos(0.0)) < 1e-12);
    QVERIFY((*blocks)[2].end == machine::BlockEnd::ExactStop);
    QVERIFY(!training::parseRecordedProgram("G1 X1.2.3\n", {}));
    // A comment that nobody ends goes to the end of the line.
    const auto open = training::parseRecordedProgram("G1 X1 (as far as here\nX2\n", {});
    QVERIFY(open);
    QCOMPARE(open->size(), std::size_t{2});
  }

  void readsTables() {
    const auto samples =
        training::parseRecordedSamples("t_s,x_cmd,y_cmd,z_cmd,other,v_path\n0.001,1,2,3,9,4.5\n");
    QVERIFY(samples);
    QCOMPARE(samples->size(), std::size_t{1});
    QCOMPARE(samples->front().pathMmPerS, 4.5);
    QVERIFY(!training::parseRecordedSamples("t_s,x_cmd\n0,1\n"));
    QVERIFY(!training::parseRecordedSamples("t_s,x_cmd,y_cmd,z_cmd,v_path\n0,1,2,3\n"));
  }

  /// Cycle times with exact stops within 3 % of the recorded planner; no axis limit exceeded.
  void agreesWithTheRecordings() {
    const std::filesystem::path folder = RIVULET_SOURCE_DIR "/../shared/groundtruth";
    std::error_code missing;
    if (!std::filesystem::exists(folder, missing)) {
      QSKIP("The recordings of the other motion planner are not here.");
    }
    const auto result = papers::runLookahead(folder);
    QVERIFY2(result, result ? "" : result.error().text().c_str());
    QVERIFY(result->checks.size() >= 16);
    for (const papers::Check& check : result->checks) {
      qInfo("%s: %g, accepted %g to %g", check.what.c_str(), check.ours, check.lowest,
            check.highest);
      QVERIFY2(check.passed(), check.what.c_str());
    }
    for (const auto& row : result->tables.back().rows) {
      qInfo("%s %s %s", row[0].c_str(), row[1].c_str(), row[2].c_str());
    }
    QCOMPARE(result->plots.size(), std::size_t{1});
  }

  /// Each check fails on some wrong planner, and each wrong planner fails some check.
  void wrongPlannersAreCaught() {
    const std::filesystem::path folder = RIVULET_SOURCE_DIR "/../shared/groundtruth";
    std::error_code missing;
    if (!std::filesystem::exists(folder, missing)) {
      QSKIP("The recordings of the other motion planner are not here.");
    }
    struct Planner {
      const char* name;
      void (*change)(machine::MachineConfig& config);
    };
    const auto scaleAcceleration = [](machine::MachineConfig& config, double factor) {
      for (machine::AxisLimits& axis : config.axes) {
        axis.accelerationMmPerS2Max *= factor;
      }
    };
    static const auto scaled = scaleAcceleration;
    const std::vector<Planner> planners{
        {"half the acceleration", [](machine::MachineConfig& config) { scaled(config, 0.5); }},
        {"a tenth of the acceleration",
         [](machine::MachineConfig& config) { scaled(config, 0.1); }},
        {"a fifth more acceleration", [](machine::MachineConfig& config) { scaled(config, 1.2); }},
        {"a fifth of the speed",
         [](machine::MachineConfig& config) {
           for (machine::AxisLimits& axis : config.axes) {
             axis.speedMmPerSMax *= 0.2;
           }
         }},
        {"three times the acceleration",
         [](machine::MachineConfig& config) { scaled(config, 3.0); }},
    };
    const auto right = papers::runLookahead(folder);
    QVERIFY(right.has_value());
    std::vector<int> catches(right->checks.size(), 0);
    for (const Planner& planner : planners) {
      const auto wrong = papers::runLookahead(folder, planner.change);
      QVERIFY(wrong.has_value());
      int caught = 0;
      for (std::size_t i = 0; i < catches.size(); ++i) {
        const bool isCaught = right->checks[i].passed() && !wrong->checks[i].passed();
        catches[i] += isCaught ? 1 : 0;
        caught += isCaught ? 1 : 0;
      }
      qInfo("%s: caught by %d of %d checks", planner.name, caught,
            static_cast<int>(catches.size()));
      QVERIFY2(caught > 0, planner.name);
    }
    for (std::size_t i = 0; i < catches.size(); ++i) {
      QVERIFY2(catches[i] > 0, right->checks[i].what.c_str());
      QVERIFY2(right->checks[i].mark != papers::Mark::None, right->checks[i].what.c_str());
    }
  }
};

RIVULET_TEST(TestLookahead)
#include "tst_lookahead.moc"
