// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>

#include "support/test_program.h"
#include "trace/comparison.h"

using namespace rivulet;
using namespace rivulet::trace;

namespace {

using Runs = std::vector<std::shared_ptr<const ShownTrace>>;

base::Instant at(double seconds) {
  return base::Instant{base::fromSeconds(seconds)};
}

/// 10 mm in X, a pause, 10 mm in Y. @param scaleY  of the second side
ControlTrace course(double mmPerS, double pauseS, double scaleY = 1.0) {
  ControlTrace trace;
  trace.cycle = std::chrono::milliseconds{4};
  double seconds = 3.0;
  const auto add = [&](double x, double y) {
    ControlSample sample;
    sample.at = at(seconds);
    sample.commandMm = {x, y, 0.0};
    sample.actualMm = sample.commandMm + base::Vec3{0.0, 0.001, 0.0};
    sample.feedMmPerS = mmPerS;
    trace.samples.push_back(sample);
    seconds += 0.004;
  };
  const double step = mmPerS * 0.004;
  for (double x = 0.0; x < 10.0 - 1e-9; x += step) {
    add(x, 0.0);
  }
  for (double waited = 0.0; waited < pauseS; waited += 0.004) {
    add(10.0, 0.0);
  }
  for (double y = 0.0; y < 10.0 + 1e-9; y += step) {
    add(10.0, y * scaleY);
  }
  return trace;
}

const gcode::Program& square() {
  static const gcode::Program program = [] {
    auto parsed =
        gcode::interpretProgram("square.mpf", "G90 G94\nG1 X10 Y0 Z0 F600\nG1 X10 Y10\nM30\n");
    return parsed ? *parsed : gcode::Program{};
  }();
  return program;
}

std::shared_ptr<const ShownTrace> shown(const char* name, const ControlTrace& trace,
                                        const gcode::Program* program = nullptr) {
  const Trace of(trace);
  ShownTrace result = makeShownTrace(of, analyseTrace(of, {program}));
  result.name = name;
  return std::make_shared<const ShownTrace>(std::move(result));
}

Envelope samples(const std::vector<std::pair<double, double>>& points) {
  Envelope envelope;
  for (const auto& [seconds, value] : points) {
    envelope.append(at(seconds), value);
  }
  return envelope;
}

const DifferenceFigures* find(const std::vector<SignalDifference>& differences,
                              const char* formula) {
  for (const SignalDifference& one : differences) {
    if (one.offer.formula == formula) {
      return &one.figures;
    }
  }
  return nullptr;
}

}  // namespace

class TestComparison : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The difference of straight lines is one: maximum, mean and RMS are known exactly.
  void measuresADifference() {
    const Envelope a = samples({{0.0, 0.0}, {10.0, 10.0}});
    const Envelope b = samples({{-1.0, 0.0}, {0.0, 1.0}, {2.0, 1.0}, {10.0, 9.0}, {11.0, 9.0}});
    const auto difference = differenceOf(a, b);
    QCOMPARE(difference->size(), std::size_t{3});  // outside, there is nothing to compare with
    const DifferenceFigures all =
        differenceFigures(*difference, base::Instant::min(), base::Instant::max());
    QCOMPARE(all.max, 1.0);
    QCOMPARE(all.atAxis, 0.0);
    // From 1 to -1 in 2 s, then -1 for 8 s.
    QVERIFY(std::abs(all.mean - (-0.8)) < 1e-12);
    QVERIFY(std::abs(all.rms - std::sqrt((2.0 / 3.0 + 8.0) / 10.0)) < 1e-12);
    const DifferenceFigures late = differenceFigures(*difference, at(1.0), at(5.0));
    QCOMPARE(late.count, std::size_t{1});
    QCOMPARE(late.max, -1.0);
    QCOMPARE(late.rms, 1.0);
    QCOMPARE(differenceFigures(*difference, at(20.0), at(30.0)).count, std::size_t{0});
  }

  void aGapIsNoDifference() {
    const Envelope a = samples({{0.0, 0.0}, {4.0, 0.0}});
    const Envelope b = samples({{0.0, 2.0}, {1.0, 2.0}, {2.0, std::nan("")}, {3.0, 2.0}});
    const DifferenceFigures figures =
        differenceFigures(*differenceOf(a, b), base::Instant::min(), base::Instant::max());
    QCOMPARE(figures.count, std::size_t{3});
    QVERIFY(std::abs(figures.mean - 2.0) < 1e-12);
  }

  /// By time, the pause of one run makes everything after it differ; by path and by point it
  /// does not, and what remains is the time that was lost.
  void placesDoNotDependOnPauses() {
    const Runs runs{shown("a", course(10.0, 0.0), &square()),
                    shown("b", course(10.0, 0.4), &square())};
    for (const RunAxis axis : {RunAxis::Time, RunAxis::Path, RunAxis::Point}) {
      const auto alignment = alignRuns(runs, axis);
      QVERIFY(alignment);
      QCOMPARE(alignment->isOfProgram, axis != RunAxis::Time);
      const auto differences = compareRuns(runs, *alignment, 0, 1, {});
      QVERIFY(differences);
      const DifferenceFigures* y = find(*differences, "y_set");
      QVERIFY(y != nullptr);
      const bool isLate = axis == RunAxis::Time;
      QVERIFY2(isLate ? std::abs(y->max) > 3.9 : std::abs(y->max) < 1e-6,
               qPrintable(QString("%1 at %2").arg(y->max).arg(y->atAxis)));
      const DifferenceFigures* time = find(*differences, "time");
      QCOMPARE(time != nullptr, axis != RunAxis::Time);
      QVERIFY(time == nullptr || std::abs(time->max - 0.4) < 0.005);
    }
  }

  /// Without a program, the lengths are those of the runs themselves.
  void movedLengthsNeedNoProgram() {
    const Runs runs{shown("a", course(10.0, 0.0)), shown("b", course(20.0, 0.1))};
    const auto alignment = alignRuns(runs, RunAxis::Path);
    QVERIFY(alignment);
    QVERIFY(!alignment->isOfProgram);
    for (const auto& places : alignment->places) {
      QVERIFY(std::abs(places->valueAt(places->size() - 1) - 20.0) < 1e-6);
    }
    const auto differences =
        compareRuns(runs, *alignment, 0, 1, {"hypot(x_set, y_set)", "per_min(path_speed)"});
    QVERIFY(differences);
    QCOMPARE(differences->size(), std::size_t{2});
    QVERIFY(std::abs(differences->front().figures.max) < 1e-6);
    QVERIFY(std::abs(differences->back().figures.mean - 600.0) < 6.0);
    QCOMPARE(differences->back().offer.unit, std::string("mm/min"));
  }

  /// The second point is reached at 2 on the axis, whatever the length of the path.
  void pointsAreAligned() {
    const Runs runs{shown("a", course(10.0, 0.2), &square())};
    const auto alignment = alignRuns(runs, RunAxis::Point);
    QVERIFY(alignment);
    const auto x = onAxis(runs[0]->signalSet.find("x_set")->samples, alignment->places[0].get());
    QVERIFY(std::abs(valueAt(*x, at(0.5)) - 5.0) < 1e-6);
    QVERIFY(std::abs(valueAt(*x, at(1.0)) - 10.0) < 1e-6);
    const auto y = onAxis(runs[0]->signalSet.find("y_set")->samples, alignment->places[0].get());
    QVERIFY(std::abs(valueAt(*y, at(1.25)) - 2.5) < 1e-6);
    QVERIFY(std::isnan(valueAt(*y, at(2.5))));
  }

  void saysWhatCannotBeCompared() {
    const auto with = shown("with.csv", course(10.0, 0.0), &square());
    const auto without = shown("without.csv", course(10.0, 0.0));
    const auto points = alignRuns({with, without}, RunAxis::Point);
    QVERIFY(!points && points.error().code == ComparisonError::NoProgram);
    QCOMPARE(points.error().context, std::string("without.csv"));
    const auto nothing = std::make_shared<const ShownTrace>();
    const auto path = alignRuns({with, nothing}, RunAxis::Path);
    QVERIFY(!path && path.error().code == ComparisonError::NoPositions);
    const auto other =
        gcode::interpretProgram("other.mpf", "G1 X10 Y0 Z0 F600\nG1 X10 Y5\nG1 X10 Y20\nM30\n");
    QVERIFY(other);
    const auto different =
        alignRuns({with, shown("c", course(10.0, 0.0, 2.0), &*other)}, RunAxis::Point);
    QVERIFY(!different && different.error().code == ComparisonError::DifferentPrograms);
    const auto alignment = alignRuns({with, without}, RunAxis::Time);
    QVERIFY(alignment);
    QVERIFY(!compareRuns({with, without}, *alignment, 0, 1, {"contour_error"}));
  }

  void axesHaveNames() {
    for (const RunAxis axis : {RunAxis::Time, RunAxis::Path, RunAxis::Point}) {
      QVERIFY(runAxisFrom(runAxisName(axis)) == axis);
    }
    QVERIFY(!runAxisFrom("length"));
  }
};

RIVULET_TEST(TestComparison)
#include "tst_comparison.moc"
