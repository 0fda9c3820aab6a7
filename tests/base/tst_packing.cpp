// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Coordinates in one number, against integers: what is taken apart is what was put in, to the last
/// bit, by the operations that a control has.

#include <QtTest>
#include <cmath>
#include <vector>

#include "base/packing.h"
#include "base/random.h"
#include "support/test_program.h"

using namespace rivulet;
using base::Packing;

namespace {

/// As the program on the control does it.
std::vector<double> takenApart(double packed, const Packing& packing,
                               const std::vector<double>& place) {
  std::vector<double> coordinates;
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    const bool isLast = axis + 1 == place.size();
    const double digit = isLast ? packed : std::trunc(packed);
    coordinates.push_back(place[axis] + (digit - packing.middle()) / Packing::kStepsPerUnit);
    packed = (packed - std::trunc(packed)) * packing.base();
  }
  return coordinates;
}

}  // namespace

class TestPacking : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void takesApartWhatWasPutIn_data() {
    QTest::addColumn<int>("axes");
    for (int axes = 1; axes <= 5; ++axes) {
      QTest::addRow("%d axes", axes) << axes;
    }
  }
  void takesApartWhatWasPutIn() {
    QFETCH(int, axes);
    const Packing packing(axes);
    base::Random random(static_cast<std::uint64_t>(axes));
    const double most = packing.middle() - 1.0;
    for (int trial = 0; trial < 20'000; ++trial) {
      std::vector<double> place;
      std::vector<double> point;
      Packing::Number number(packing);
      for (int axis = 0; axis < axes; ++axis) {
        place.push_back(0.001 * std::round(1e6 * (random.uniform() - 0.5)));
        // The ends of what fits are the hardest: every fourth is one.
        const double steps = trial % 4 == 0   ? most
                             : trial % 4 == 1 ? -most
                                              : std::round(most * (2.0 * random.uniform() - 1.0));
        point.push_back(place.back() + steps / 1000.0);
        QVERIFY(packing.fits(place.back(), point.back()));
        number.add(place.back(), point.back());
      }
      const std::vector<double> taken = takenApart(number.value(), packing, place);
      for (std::size_t axis = 0; axis < taken.size(); ++axis) {
        QCOMPARE(taken[axis], Packing::unpacked(place[axis], point[axis]));
        QVERIFY(std::abs(taken[axis] - point[axis]) < 1e-9);
      }
    }
  }

  /// 65 mm around for X Y Z, and no step more; a whole number of steps, and nothing between.
  void knowsWhatFits() {
    const Packing three(3);
    QCOMPARE(three.reach(), 65.535);
    QVERIFY(three.fits(10.0, 10.001) && !three.fits(10.0, 10.0005));
    QVERIFY(three.fits(10.0, 75.535) && three.fits(10.0, -55.535));
    QVERIFY(!three.fits(10.0, 75.536) && !three.fits(10.0, -55.536));
    QVERIFY(!three.fits(0.0, std::nan("")) && !three.fits(0.0, 1e300) && !three.fits(1e300, 0.0));
    QCOMPARE(Packing(5).reach(), 0.511);
    base::Random random(7);
    for (int trial = 0; trial < 1000; ++trial) {
      const double place = Packing::rounded(1000.0 * random.uniform());
      const double anywhere = place + 120.0 * (random.uniform() - 0.5);
      const double coordinate = Packing::rounded(anywhere);
      QVERIFY(std::abs(coordinate - anywhere) <= 0.0005 + 1e-12);
      QVERIFY(three.fits(place, coordinate));
      QVERIFY(std::abs(Packing::unpacked(place, coordinate) - coordinate) < 1e-9);
    }
  }
};

RIVULET_TEST(TestPacking)
#include "tst_packing.moc"
