// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A supplier of points of one's own is one class that is given to a run: methods, driver and job
/// pull windows from it as from a live source.

#include <QtTest>
#include <algorithm>

#include "streaming/methods/list_supplier.h"
#include "streaming/run/job.h"
#include "streaming/simulation/scenario.h"
#include "support/silent_run.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

/// A path backwards: every point is there before the start.
class Reversed final : public streaming::ListSupplier {
 public:
  explicit Reversed(const std::vector<gcode::StreamPoint>& points)
      : ListSupplier({points.rbegin(), points.rend()}, 7, {}) {}
};

/// A staircase that goes on until it has been executed up to a height: what comes next depends on
/// how far the run is.
class Staircase final : public live::PointSupplier {
 public:
  void begin(const live::SupplyStart& start, base::Instant) override { m_at = start.tool; }
  std::optional<std::size_t> takeWindow(base::Instant) override {
    if (isDry()) {
      return std::nullopt;
    }
    (m_points.size() % 2 == 0 ? m_at.mm.x : m_at.mm.z) += 0.5;
    m_points.push_back({m_at.mm, base::LineNumber{}});
    m_begins.push_back(m_points.size());
    return 1;
  }
  const std::vector<gcode::StreamPoint>& points() const override { return m_points; }
  const std::vector<std::size_t>& windowBegins() const override { return m_begins; }
  bool isDry() const override { return m_executed >= 20; }
  void executed(std::size_t points) override { m_executed = points; }

 private:
  base::AxisPosition m_at;
  std::vector<gcode::StreamPoint> m_points;
  std::vector<std::size_t> m_begins{0};
  std::size_t m_executed = 0;
};

streaming::RunReport run(live::PointSupplier& supplier, base::MethodKind method) {
  machine::Machine machine(*machine::loadPreset("dmu75"), 1);
  streaming::SimulatedLink link(machine);
  streaming::RunSettings settings;
  settings.parameters.method = method;
  settings.isCommissioned = true;
  tests::SilentRun silent;
  return streaming::runLive(link, link, "own", supplier,
                            *templates::makeProgram(settings.parameters), settings, silent, silent);
}

}  // namespace

class TestOwnSupplier : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aPathBackwards() {
    base::Random random(1);
    std::vector<gcode::StreamPoint> points;
    for (const base::Vec3& place : streaming::drawContour({60, 0.3, 0.3}, random)) {
      points.push_back({place, base::LineNumber{static_cast<std::uint32_t>(points.size() + 1)}});
    }
    for (const auto method : {base::MethodKind::Window, base::MethodKind::Credit}) {
      Reversed supplier(points);
      const streaming::RunReport report = run(supplier, method);
      QVERIFY2(report.isFaultless(), report.error.text().c_str());
      QCOMPARE(report.integrity.executed, points.size());
      QVERIFY(report.controlTrace->blocks.back().targetMm == points.front().positionMm);
    }
  }

  void whatDependsOnTheRun() {
    for (const auto method : {base::MethodKind::Window, base::MethodKind::Credit}) {
      Staircase supplier;
      const streaming::RunReport report = run(supplier, method);
      QVERIFY2(report.isFaultless(), report.error.text().c_str());
      QVERIFY(report.integrity.executed >= 20);
      QCOMPARE(report.integrity.executed, supplier.points().size());
    }
  }
};

RIVULET_TEST(TestOwnSupplier)
#include "tst_own_supplier.moc"
