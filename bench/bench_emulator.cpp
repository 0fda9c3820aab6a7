// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What learning the emulator of [P2] costs: one run of each design, one generation of the genetic
// algorithm on one and on two threads, and a whole learning run on one. Designs as in the paper,
// with set points of constant speed; the machine is an emulator with other parameters.
// Runs: median of the processor's time. Generations: median of the time that passes, so the machine
// has to be quiet for them.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "base/median.h"
#include "emulator/paper/learning.h"
#include "measuring.h"
#include "platform/thread_executor.h"

namespace {

using namespace rivulet;
using emulator::TrainingRun;
using namespace emulator::paper;

double passedS() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A staircase: segments of 12 mm in X and Y in turn.
TrainingRun staircase(const char* name, const std::vector<double>& mmPerS) {
  constexpr double kSegmentMm = 12.0;
  TrainingRun run{name, 0.001, {{'X', {}, {}, {}}, {'Y', {}, {}, {}}}, {}};
  double x = 0.0;
  double y = 0.0;
  double seconds = 0.0;
  for (std::size_t i = 0; i < mmPerS.size(); ++i) {
    const auto steps = static_cast<int>(kSegmentMm / mmPerS[i] / run.period);
    for (int step = 0; step < steps; ++step) {
      (i % 2 == 0 ? x : y) += kSegmentMm / steps;
      run.axes[0].reference.push_back(x);
      run.axes[1].reference.push_back(y);
    }
    seconds += kSegmentMm / mmPerS[i];
  }
  for (double at = 0.0; at < seconds; at += kSampleSpacingS) {
    run.observedAt.push_back(at);
    for (emulator::AxisTrack& track : run.axes) {
      track.observed.push_back(0.0);
      track.observedMmPerS.push_back(0.0);
    }
  }
  return run;
}

Course observed(const TrainingRun& run, const PlantSettings& plant) {
  Parameters truth = nominalParameters();
  truth[22] *= 1.5;  // p23
  Course course = *makeCourse(run, plant.stepS);
  const Emulation emulation = emulate(course, truth, plant);
  course.observedMm = emulation.mm;
  course.observedMmPerS = emulation.mmPerS;
  return course;
}

void measureRun(const Course& course, const PlantSettings& plant) {
  constexpr int kRuns = 51;
  std::vector<double> times;
  for (int i = 0; i < kRuns; ++i) {
    const double before = bench::processorS();
    const Emulation emulation = emulate(course, nominalParameters(), plant);
    times.push_back(bench::processorS() - before);
    if (emulation.diverged()) {
      fmt::print("ran away\n");
    }
  }
  fmt::print("one run of {}: {:.2f} ms ({:.1f} s of motion)\n", course.name,
             1e3 * base::median(times), course.points.back().atS);
}

/// @return median time of a generation, s
double generationS(const Course& course, unsigned threads) {
  parallel::ThreadExecutor executor(threads);
  LearnSettings settings;
  settings.genetic.generations = 20;
  std::vector<double> times;
  double last = passedS();
  const auto learned = learn(course, settings, executor, [&](const Learning& learning) {
    const double now = passedS();
    if (learning.state.generation > 0) {
      times.push_back(now - last);
    }
    last = now;
    return true;
  });
  return learned ? base::median(times) : std::nan("");
}

}  // namespace

int main() {
  const PlantSettings plant;
  const std::vector<Course> courses{
      observed(staircase("G1", std::vector<double>(12, 6.0)), plant),
      observed(staircase("G2", std::vector<double>(48, 6.0)), plant),
      observed(staircase("G3", {3, 3, 3, 3, 6, 6, 6, 6, 16, 16, 16, 16}), plant)};
  for (const Course& course : courses) {
    measureRun(course, plant);
  }
  const double one = generationS(courses[0], 1);
  const double two = generationS(courses[0], 2);
  fmt::print(
      "one generation (47 runs of G1): {:.1f} ms on one thread, {:.1f} ms on two, {:.2f} "
      "times as fast\n",
      1e3 * one, 1e3 * two, one / two);
  for (const Course& course : courses) {
    base::SerialExecutor executor;
    const double before = bench::processorS();
    const auto learned = learn(course, {}, executor);
    if (learned) {
      fmt::print("learning from {}, 100 generations: {:.1f} s on one thread\n", course.name,
                 bench::processorS() - before);
    }
  }
  return 0;
}
