// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QSignalSpy>
#include <QTest>

#include "base/random.h"
#include "base/units.h"
#include "session/region_worker.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;
using session::RegionJob;
using session::RegionOutcome;
using session::RegionWorker;
using Outcome = std::shared_ptr<const RegionOutcome>;

namespace {

using rivulet::tests::kSoonMs;

RegionJob regionJob() {
  base::Random random(5);
  RegionJob job;
  for (const base::Vec3& point : streaming::drawContour({60, 0.3, 0.15}, random)) {
    job.points.push_back({point, base::LineNumber{}});
  }
  job.settings.parameters.method = base::MethodKind::Position;
  job.settings.deltaMm = 0.3;
  job.axis = feasibility::SweepAxis::Delta;
  job.abscissas = {0.05, 0.3};
  for (const double feed : {300.0, 800.0, 12000.0}) {
    job.feedsMmPerS.push_back(base::mmPerSFromMmPerMin(feed));
  }
  return job;
}

}  // namespace

class TestRegionWorker : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void bringsPointsAndBand() {
    RegionWorker worker;
    Outcome outcome;
    connect(&worker, &RegionWorker::finished, this, [&](const Outcome& value) { outcome = value; });
    QSignalSpy progress(&worker, &RegionWorker::progressed);
    worker.start(regionJob());
    QVERIFY(worker.isBusy());
    QTRY_VERIFY_WITH_TIMEOUT(outcome != nullptr, kSoonMs);
    QVERIFY(!worker.isBusy());
    QVERIFY(!outcome->error.code);
    QCOMPARE(outcome->points.size(), std::size_t{6});
    QCOMPARE(outcome->points[3].failures(), std::size_t{0});
    QCOMPARE(outcome->points[2].failures(), outcome->points[2].runs);
    QCOMPARE(outcome->band.size(), std::size_t{2});
    for (const session::RegionBandPoint& point : outcome->band) {
      QVERIFY(point.rareMmPerS > 0.0);
      QVERIFY(point.halfMmPerS > point.rareMmPerS);
    }
    int before = 0;
    for (const QList<QVariant>& told : progress) {
      QVERIFY(told.first().toInt() > before);
      before = told.first().toInt();
    }
    QCOMPARE(before, 100);
    // The threads it runs on do not change the result.
    forecast::RegionRequest same;
    same.points = outcome->job.points;
    same.settings = outcome->job.settings;
    same.machine = *machine::loadPreset("dmu75");
    same.axis = outcome->job.axis;
    same.abscissas = outcome->job.abscissas;
    same.feedsMmPerS = outcome->job.feedsMmPerS;
    same.seedsPerPoint = outcome->job.seedsPerPoint;
    base::SerialExecutor serial;
    const auto expected = forecast::simulateRegion(same, serial);
    for (std::size_t i = 0; i < expected.points.size(); ++i) {
      QCOMPARE(outcome->points[i].failures(), expected.points[i].failures());
    }
  }

  void cancelledJobReportsNothing() {
    RegionWorker worker;
    int finished = 0;
    connect(&worker, &RegionWorker::finished, this, [&](const Outcome&) { ++finished; });
    QSignalSpy cancelled(&worker, &RegionWorker::cancelled);
    RegionJob large = regionJob();
    large.seedsPerPoint = 100000;
    worker.start(large);
    worker.cancel();
    QCOMPARE(cancelled.count(), 1);
    QVERIFY(!worker.isBusy());
    // The next job is done although the one before was cancelled.
    worker.start(regionJob());
    QTRY_COMPARE_WITH_TIMEOUT(finished, 1, kSoonMs);
    QCoreApplication::processEvents();
    QCOMPARE(finished, 1);
  }

  void endsWithItsOwner() {
    auto worker = std::make_unique<RegionWorker>();
    RegionJob large = regionJob();
    large.seedsPerPoint = 100000;
    worker->start(large);
    worker.reset();
    QCoreApplication::processEvents();
  }
};

RIVULET_TEST(TestRegionWorker)
#include "tst_region_worker.moc"
