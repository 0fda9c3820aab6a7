// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What is drawn of a machine and its emulator.

#include <QtTest>

#include "emulator/emulator_error.h"
#include "emulator/overlay.h"
#include "support/test_program.h"
#include "trace/analysis/program_path.h"

using namespace rivulet;
using namespace rivulet::emulator;

namespace {

/// Around a square of 20 mm at 20 mm/s, X late by 1/40 s, Y by 1/30 s.
TrainingRun square() {
  TrainingRun run{"square", 0.004, {{'X', {}, {}}, {'Y', {}, {}}}, {}};
  const std::array<std::pair<double, double>, 5> corners{
      {{0.0, 0.0}, {20.0, 0.0}, {20.0, 20.0}, {0.0, 20.0}, {0.0, 0.0}}};
  for (std::size_t side = 0; side + 1 < corners.size(); ++side) {
    for (int i = 0; i < 250; ++i) {
      const double share = i / 250.0;
      run.axes[0].reference.push_back(corners[side].first +
                                      share * (corners[side + 1].first - corners[side].first));
      run.axes[1].reference.push_back(corners[side].second +
                                      share * (corners[side + 1].second - corners[side].second));
      run.observedAt.push_back(0.004 * static_cast<double>(run.observedAt.size()));
    }
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const AxisParameters law = firstOrderLag(axis == 0 ? 1.0 / 40.0 : 1.0 / 30.0);
    for (const AxisState& state :
         predict(law, setPointGrid(run.axes[axis], run.period, false), run.observedAt)) {
      run.axes[axis].observed.push_back(state.mm);
    }
  }
  return run;
}

Emulator emulatorOf(double xPerS, double yPerS) {
  Emulator emulator;
  for (const auto& [letter, gain] : {std::pair{'X', xPerS}, std::pair{'Y', yPerS}}) {
    LearnedAxis axis;
    axis.axis = letter;
    axis.parameters = firstOrderLag(1.0 / gain);
    emulator.axes.push_back(axis);
  }
  return emulator;
}

const OverlayNames kNames{"Machine", "Emulator", {"X apart", "Y apart", "Z apart"}};

double largest(const trace::ShownTrace& shown, const char* name) {
  const trace::Channel* channel = shown.signalSet.find(name);
  if (channel == nullptr) {
    return -1.0;
  }
  double most = 0.0;
  for (std::size_t i = 0; i < channel->samples->size(); ++i) {
    most = std::max(most, std::abs(channel->samples->valueAt(i)));
  }
  return most;
}

}  // namespace

class TestOverlay : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void showsHowFarTheTwoAreApart() {
    const auto overlay = overlayOf(emulatorOf(40.0, 40.0), square(), kNames);
    QVERIFY(overlay);
    QCOMPARE(overlay->machine->name, std::string("Machine"));
    QCOMPARE(overlay->emulated->name, std::string("Emulator"));
    QVERIFY(largest(*overlay->machine, "X apart") < 1e-3);
    // At 20 mm/s: 20/30 - 20/40 mm.
    QVERIFY(std::abs(largest(*overlay->machine, "Y apart") - 166.7) < 1.0);
    QCOMPARE(largest(*overlay->machine, "Z apart"), -1.0);
    QCOMPARE(overlay->machine->length, overlay->emulated->length);
  }

  void bothHaveAPlaceOnThePathOfTheSetPoints() {
    const TrainingRun run = square();
    const auto overlay = overlayOf(emulatorOf(40.0, 30.0), run, kNames);
    QVERIFY(overlay);
    for (const auto& shown : {overlay->machine, overlay->emulated}) {
      QVERIFY(shown->programPath != nullptr);
      const trace::Channel* lengths = shown->signalSet.find("program_length_act");
      QVERIFY(lengths != nullptr);
      QCOMPARE(lengths->samples->size(), run.observedAt.size());
      for (std::size_t i = 0; i < lengths->samples->size(); ++i) {
        if (run.observedAt[i] < knownFromS(run)) {
          continue;  // late by its lag, the axis is before the begin of the path
        }
        const base::Vec3 place = shown->programPath->at(lengths->samples->valueAt(i));
        const base::Vec3 seen{run.axes[0].observed[i], run.axes[1].observed[i], 0.0};
        // The corners are cut by less than the larger lag.
        QVERIFY(base::distance(place, seen) < 0.5);
      }
    }
  }

  void refusesAnAxisThatWasNotLearned() {
    Emulator only;
    only.axes.push_back(emulatorOf(40.0, 40.0).axes.front());
    const auto overlay = overlayOf(only, square(), kNames);
    QVERIFY(!overlay);
    QVERIFY(overlay.error().code == EmulatorError::NoMotion);
  }
};

RIVULET_TEST(TestOverlay)
#include "tst_overlay.moc"
