// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A calibration on its way to a file and back, and what a run makes of it.

#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "machine/machine.h"
#include "report/calibration_json.h"
#include "streaming/control/machine_facts.h"
#include "streaming/run/job.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"

using namespace rivulet;
using base::Duration;
using opcua::Grouping;
using streaming::CalibrationRecord;
using streaming::MachineFileError;

namespace {

CalibrationRecord recordOf(const char* preset) {
  machine::Machine machine(*machine::loadPreset(preset), 5);
  streaming::SimulatedLink link(machine);
  streaming::CalibrationPlan plan;
  plan.firstCell = 0;
  plan.lastCell = 49;
  plan.shots = 120;
  plan.budget = std::chrono::seconds{40};
  CalibrationRecord record;
  record.endpoint = "opc.tcp://10.0.0.5:4840";
  record.server = {"urn:maker:control", "Control", "4.95", "7"};
  record.measuredAtUtc = "2026-05-04T09:30:00Z";
  record.toolVersion = "1.2.3";
  record.calibration = streaming::calibrate(link, plan).value();
  return record;
}

class Orders final : public streaming::RunOrders {
 public:
  bool stopRequested(base::Instant) override { return false; }
};

class Margins final : public streaming::RunSink {
 public:
  void update(const streaming::LiveUpdate& update) override {
    if (update.margin) {
      margins.push_back({accesses, *update.margin});
    }
  }
  void access(const trace::Access& access) override {
    ++accesses;
    longest = std::max(longest, access.took);
  }
  void note(const trace::Note&) override {}

  struct Seen {
    std::size_t accesses;
    Duration margin;
  };
  std::vector<Seen> margins;
  std::size_t accesses = 0;
  Duration longest{};
};

/// A run of 300 points on a machine that is always the same.
Margins run(const std::shared_ptr<const streaming::Calibration>& calibration) {
  machine::Machine machine(*machine::loadPreset("dmu75"), 5);
  streaming::SimulatedLink link(machine);
  const gcode::Program program =
      gcode::loadProgram(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap", {}).value();
  streaming::RunSettings settings;
  settings.feedMmPerS = 30.0;
  settings.calibration = calibration;
  Orders orders;
  Margins margins;
  const streaming::RunReport report =
      streaming::runJob(link, link, program, settings, orders, margins);
  if (!report.isFaultless()) {
    qFatal("%s", report.error.text().c_str());
  }
  return margins;
}

}  // namespace

class TestCalibrationFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void comesBackAsItWas() {
    const CalibrationRecord record = recordOf("dmu75-arrays");
    QVERIFY(record.calibration.isCut());
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath(QStringLiteral("a.json")).toStdString();
    QVERIFY(base::writeFile(path, report::calibrationJson(record).dump()));
    const auto read = report::readCalibration(path);
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(report::calibrationJson(*read).dump(), report::calibrationJson(record).dump());
    QVERIFY(read->server == record.server);
    const streaming::Calibration& then = record.calibration;
    const streaming::Calibration& now = read->calibration;
    QCOMPARE(now.series.size(), then.series.size());
    for (std::size_t i = 0; i < now.series.size(); ++i) {
      QVERIFY(now.series[i].histogram == then.series[i].histogram);
      QVERIFY(now.series[i].percentiles == then.series[i].percentiles);
      QVERIFY(now.series[i].max == then.series[i].max);
    }
    QVERIFY(now.best() == Grouping::ArrayCount);
    for (const int nodes : {1, 3, 24, 80}) {
      QVERIFY(now.tail(true, Grouping::ArrayCount, nodes) ==
              then.tail(true, Grouping::ArrayCount, nodes));
    }
  }

  void refusesWhatIsNoCalibration() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath(QStringLiteral("a.json")).toStdString();
    const auto codeOf = [&path](const nlohmann::ordered_json& json) {
      [[maybe_unused]] const auto written = base::writeFile(path, json.dump());
      const auto read = report::readCalibration(path);
      return read ? std::error_code() : read.error().code;
    };
    const nlohmann::ordered_json good = report::calibrationJson(recordOf("dmu75"));
    QVERIFY(!codeOf(good));
    QVERIFY(codeOf(3) == MachineFileError::NotAMachineFile);
    auto bad = good;
    bad["rivulet_calibration"] = 1;
    QVERIFY(codeOf(bad) == MachineFileError::OtherVersion);
    bad = good;
    bad["fits"] = nlohmann::json::array();
    QVERIFY(codeOf(bad) == MachineFileError::Damaged);
    for (const char* key : {"server", "series", "shots_ordered", "took_s", "measured_at_utc"}) {
      bad = good;
      bad.erase(key);
      QVERIFY2(codeOf(bad) == MachineFileError::Damaged, key);
    }
    bad = good;
    bad["series"][0]["max_ms"] = "long";
    QVERIFY(codeOf(bad) == MachineFileError::Damaged);
    bad = good;
    bad["series"][0]["form"] = "parcel";
    QVERIFY(codeOf(bad) == MachineFileError::Damaged);
  }

  /// The model of feasibility has the lines of the form; a form that was not measured those of
  /// lists.
  void givesTheEquationsTheirLines() {
    const CalibrationRecord record = recordOf("dmu75-arrays");
    const auto list = report::accessModel(record.calibration, Grouping::List);
    const auto array = report::accessModel(record.calibration, Grouping::ArrayCount);
    QVERIFY(list.measured && array.measured);
    QVERIFY(std::abs(base::toMilliseconds(list.measured->write.perNode) - 4.3) < 0.2);
    QVERIFY(base::toMilliseconds(array.measured->write.perNode) < 0.1);
    const auto method = base::MethodKind::Window;
    QVERIFY(8 * array.timePerNode({method, 14}) < list.timePerNode({method, 14}));
    CalibrationRecord plain = recordOf("dmu75");
    std::erase_if(plain.calibration.fits,
                  [](const auto& fit) { return fit.grouping != Grouping::List; });
    QVERIFY(report::accessModel(plain.calibration, Grouping::ArrayCount).measured->read.perNode ==
            report::accessModel(plain.calibration, Grouping::List).measured->read.perNode);
  }

  /// While the first windows are delivered, nothing moves, so nothing can be too late.
  void nothingIsLateBeforeTheFirstMove() {
    const Margins margins = run(nullptr);
    QVERIFY(margins.margins.size() > 3);
    for (const Margins::Seen& seen : margins.margins) {
      QVERIFY2(seen.margin >= Duration{}, qPrintable(QString::number(seen.accesses)));
    }
  }

  /// Before the run has a hundred accesses of its own, what was measured speaks for the slow ones.
  void theLiveMarginKnowsSlowAccessFromTheStart() {
    const Margins plain = run(nullptr);
    auto slow = std::make_shared<streaming::Calibration>(recordOf("dmu75").calibration);
    const Duration tail = std::chrono::seconds{30};
    for (streaming::AccessSeries& series : slow->series) {
      for (trace::Percentile& percentile : series.percentiles) {
        percentile.value = tail;
      }
      series.max = tail;
    }
    const Margins calibrated = run(slow);
    QVERIFY(plain.longest < tail);
    QVERIFY(!plain.margins.empty() && !calibrated.margins.empty());
    std::size_t early = 0;
    std::size_t late = 0;
    for (const Margins::Seen& seen : calibrated.margins) {
      if (seen.accesses < 100) {
        ++early;
        QVERIFY(seen.margin < Duration{});  // no two windows last half a minute
      } else if (seen.margin > -plain.longest) {
        ++late;
      }
    }
    QVERIFY(early > 0 && late > 0);
    // Without a calibration the same moments looked better.
    QVERIFY(plain.margins.front().margin > calibrated.margins.front().margin);
  }
};

RIVULET_TEST(TestCalibrationFile)
#include "tst_calibration_file.moc"
