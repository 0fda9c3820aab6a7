// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How many transitions of a Petri net fire in a second on one core: a pipeline of counters, and the
// net of [P3] under both policies. Medians of several rounds are printed.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "base/median.h"
#include "petri/net_file.h"
#include "petri/simulator.h"

namespace {

using namespace rivulet;

constexpr const char* kPipeline = R"(
name = "pipeline"
time_unit = "us"
top = "Top"
[parameters]
capacity = 100
[pages.Top.places]
clock = { colour = "INT", initial = "0" }
B1 = { colour = "INT", initial = "0" }
B2 = { colour = "INT", initial = "0" }
[pages.Top.transitions.produce]
in = { clock = "n", B1 = "b" }
guard = "b < capacity"
out = { clock = "n + 1 @+ 5", B1 = "b + 1" }
[pages.Top.transitions.move]
in = { B1 = "b", B2 = "c" }
guard = "b > 0 andalso c < capacity"
out = { B1 = "b - 1", B2 = "c + 1" }
[pages.Top.transitions.consume]
in = { B2 = "b" }
guard = "b > 0"
out = { B2 = "b - 1" }
)";

int measure(const std::string& name, const base::Result<petri::Net>& net) {
  if (!net) {
    fmt::print(stderr, "{}\n", net.error().text());
    return 1;
  }
  constexpr std::uint64_t kFirings = 2'000'000;
  std::vector<double> perSecond;
  for (int round = 0; round < 7; ++round) {
    petri::Simulator simulator(*net);
    const auto start = std::chrono::steady_clock::now();
    while (simulator.firings() < kFirings && simulator.step()) {
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    perSecond.push_back(static_cast<double>(simulator.firings()) / taken.count());
  }
  std::sort(perSecond.begin(), perSecond.end());
  fmt::print("{:<24} {:>6.2f} million firings per second ({:.2f} to {:.2f})\n", name,
             base::median(perSecond) / 1e6, perSecond.front() / 1e6, perSecond.back() / 1e6);
  return 0;
}

}  // namespace

int main() {
  return measure("pipeline of counters", petri::parseNet(kPipeline, "pipeline")) +
         measure("p3, task dependency", petri::loadNet("p3", {{"policy", 0}})) +
         measure("p3, data flow", petri::loadNet("p3", {{"policy", 1}}));
}
