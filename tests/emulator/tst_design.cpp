// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "base/random.h"
#include "emulator/design.h"
#include "emulator/emulator_error.h"
#include "support/test_program.h"

using namespace rivulet::emulator;
using rivulet::base::Random;
using rivulet::base::Vec3;
using P = AxisParameter;

namespace {

constexpr double kPeriodS = 0.004;

Emulator twoAxes() {
  Emulator emulator;
  for (const char letter : {'X', 'Y'}) {
    LearnedAxis axis;
    axis.axis = letter;
    axis.parameters[P::PositionGain] = 40.0;
    axis.parameters[P::SpeedGain] = 100.0;
    axis.parameters[P::ResetTime] = 0.02;
    axis.parameters[P::Coulomb] = 60.0;
    axis.parameters[P::CoulombSpeed] = 0.5;
    for (const AxisParameterFacts& facts : axisParameterFacts()) {
      if (const double value = axis.parameters[facts.parameter]; value > 0.0) {
        axis.estimates.push_back({facts.parameter, value, 0.9 * value, 1.1 * value});
      }
    }
    emulator.axes.push_back(axis);
  }
  return emulator;
}

/// Every move at its feed, without acceleration.
PlannedMoves plan(Vec3 startMm, std::span<const DesignMove> moves) {
  PlannedMoves planned{kPeriodS, {startMm}};
  Vec3 at = startMm;
  for (const DesignMove& move : moves) {
    const bool turns = move.radiusMm > 0.0;
    const double length =
        turns ? 2.0 * M_PI * move.radiusMm : rivulet::base::distance(at, move.toMm);
    const int steps = std::max(1, static_cast<int>(length / (move.feedMmPerS * kPeriodS)));
    for (int i = 1; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      const double angle = M_PI + 2.0 * M_PI * share;
      planned.setPointsMm.push_back(turns ? at + Vec3{move.radiusMm * (1.0 + std::cos(angle)),
                                                      move.radiusMm * std::sin(angle), 0.0}
                                          : at + share * (move.toMm - at));
    }
    at = turns ? at : move.toMm;
  }
  return planned;
}

DesignBox box() {
  return {{0.0, 0.0, 5.0}, {40.0, 30.0, 5.0}, 1.0, 40.0, 12.0};
}

}  // namespace

class TestDesign : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The deviation that is foretold is the one that is seen when it is learned many times.
  void foretellsHowWellAParameterWillBeKnown() {
    Emulator emulator;
    LearnedAxis axis;
    axis.parameters[P::PositionGain] = 40.0;
    axis.estimates.push_back({P::PositionGain, 40.0, 40.0, 40.0});
    emulator.axes = {axis};
    const std::vector<DesignMove> moves{{{20.0, 0.0, 0.0}, 10.0, 0.0},
                                        {{5.0, 0.0, 0.0}, 20.0, 0.0}};
    const PlannedMoves planned = plan({}, moves);
    constexpr double kNoiseMm = 0.01;
    const ProposedProgram foretold =
        informationOf(emulator, planned, {.noiseMm = kNoiseMm, .usesIntervals = false});
    QCOMPARE(foretold.gains.size(), std::size_t{1});
    double squares = 0.0;
    constexpr int kDraws = 60;
    for (int draw = 0; draw < kDraws; ++draw) {
      Random random(50 + static_cast<unsigned>(draw));
      TrainingRun run{"draw", kPeriodS, {{'X', {}, {}}}, {}};
      for (std::size_t i = 0; i < planned.setPointsMm.size(); ++i) {
        run.axes[0].reference.push_back(planned.setPointsMm[i].x);
        run.observedAt.push_back(kPeriodS * static_cast<double>(i));
      }
      for (const AxisState& state :
           predict(axis.parameters, setPointGrid(run.axes[0], kPeriodS, false), run.observedAt)) {
        run.axes[0].observed.push_back(state.mm + kNoiseMm * random.normal());
      }
      const auto learned = learnAxis({&run, 1}, 'X', {.structure = &axis.parameters});
      QVERIFY2(learned, learned ? "" : learned.error().text().c_str());
      const double off = std::log(learned->parameters[P::PositionGain] / 40.0);
      squares += off * off / kDraws;
    }
    const double seen = std::sqrt(squares);
    qInfo("foretold %.3g, seen %.3g", foretold.gains[0].deviationAfter, seen);
    // 60 draws know a deviation to 9 %.
    QVERIFY(std::abs(seen / foretold.gains[0].deviationAfter - 1.0) < 0.35);
  }

  void staysInItsBoxAndItsTime() {
    const Emulator emulator = twoAxes();
    const auto program = proposeProgram(emulator, box(), plan, {.exchanges = 60});
    QVERIFY2(program, program ? "" : program.error().text().c_str());
    QVERIFY(program->moves.size() > 3);
    QVERIFY(program->durationS <= 12.0 && program->durationS > 8.0);
    for (const Vec3& mm : plan(box().minMm, program->moves).setPointsMm) {
      QVERIFY(mm.x > -1e-9 && mm.x < 40.0 + 1e-9 && mm.y > -1e-9 && mm.y < 30.0 + 1e-9);
      QCOMPARE(mm.z, 5.0);
    }
    for (const DesignMove& move : program->moves) {
      QVERIFY(move.feedMmPerS >= 1.0 && move.feedMmPerS <= 40.0);
    }
    const auto again = proposeProgram(emulator, box(), plan, {.exchanges = 60});
    QCOMPARE(programText(box().minMm, again->moves), programText(box().minMm, program->moves));
  }

  void tellsMoreThanAPlainSquare() {
    const Emulator emulator = twoAxes();
    const std::vector<DesignMove> square{{{30.0, 0.0, 5.0}, 10.0, 0.0},
                                         {{30.0, 30.0, 5.0}, 10.0, 0.0},
                                         {{0.0, 30.0, 5.0}, 10.0, 0.0},
                                         {{0.0, 0.0, 5.0}, 10.0, 0.0}};
    const ProposedProgram plain = informationOf(emulator, plan(box().minMm, square), {});
    const auto program = proposeProgram(emulator, box(), plan, {.exchanges = 100});
    QVERIFY(program);
    QVERIFY2(program->logDeterminant > plain.logDeterminant + 5.0,
             qPrintable(QString::number(program->logDeterminant - plain.logDeterminant)));
    for (const ParameterGain& gain : program->gains) {
      QVERIFY(gain.deviationAfter < gain.deviationBefore);
    }
  }

  void refusesABoxThatIsNone_data() {
    QTest::addColumn<int>("fault");
    QTest::addColumn<EmulatorError>("code");
    QTest::newRow("turned round") << 0 << EmulatorError::BadNumbers;
    QTest::newRow("not a number") << 1 << EmulatorError::BadNumbers;
    QTest::newRow("no room") << 2 << EmulatorError::NoMotion;
    QTest::newRow("an axis that is not known") << 3 << EmulatorError::NoMotion;
    QTest::newRow("feed 0") << 4 << EmulatorError::BadNumbers;
    QTest::newRow("no time") << 5 << EmulatorError::BadNumbers;
  }
  void refusesABoxThatIsNone() {
    QFETCH(int, fault);
    QFETCH(EmulatorError, code);
    DesignBox bad = box();
    if (fault == 0) {
      std::swap(bad.minMm, bad.maxMm);
    } else if (fault == 1) {
      bad.maxMm.x = std::numeric_limits<double>::quiet_NaN();
    } else if (fault == 2) {
      bad.maxMm = bad.minMm;
    } else if (fault == 3) {
      bad.maxMm = bad.minMm + Vec3{0.0, 0.0, 20.0};
    } else if (fault == 4) {
      bad.feedMmPerSMin = 0.0;
    } else {
      bad.durationS = 0.1;
    }
    const auto program = proposeProgram(twoAxes(), bad, plan, {.exchanges = 1});
    QVERIFY(!program);
    QVERIFY2(program.error().code == code, program.error().text().c_str());
  }

  void writesAProgram() {
    const std::vector<DesignMove> moves{{{10.0, 2.0, 5.0}, 20.0, 0.0},
                                        {{10.0, 2.0, 5.0}, 5.0, 3.0}};
    QCOMPARE(programText({0.0, 0.0, 5.0}, moves),
             std::string("G64 G90 G17\nG0 X0.000 Y0.000 Z5.000\n"
                         "G1 X10.000 Y2.000 Z5.000 F1200\n"
                         "G3 X10.000 Y2.000 I3.000 J0 F300\nM30\n"));
  }
};

RIVULET_TEST(TestDesign)
#include "tst_design.moc"
