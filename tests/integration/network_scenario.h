// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Runs over a network with a fault drawn from a seed, in real time: the real client, a proxy, the
/// real server of a virtual machine. Afterwards an operator resumes the run, as often as necessary;
/// where the method cannot be resumed, he resets the control. The result is evidence; the judge is
/// the machine's own trace.
/// @threadsafety pure; runs on the calling thread, and several may run at the same time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "streaming/run/run.h"
#include "support/fault_proxy.h"
#include "trace/analysis/integrity.h"

namespace rivulet::tests {

struct NetworkScenario {
  std::uint64_t seed = 1;
  base::MethodKind method = base::MethodKind::Window;
  std::string preset = "dmu75";
  std::size_t points = 40;
  double feedMmPerMin = 3000.0;
  NetworkFault fault;
  base::Duration oneWay{};  ///< delay of each direction, always
  std::optional<base::Duration> stopAfter;
  std::optional<base::Duration> holdAfter;
  base::Duration holdFor{};
  double correctionLimitMm = 0.0;
  streaming::AccessChoice access = streaming::AccessChoice::Fixed;
  bool monitor = true;
  std::size_t watchedItems = 0;  ///< of another client
  bool hasReader = false;        ///< another client reads 1000 nodes again and again
};

[[nodiscard]] NetworkScenario drawNetworkScenario(std::uint64_t seed, base::MethodKind method);

struct NetworkEvidence {
  std::vector<streaming::RunReport> attempts;
  trace::Integrity integrity;  ///< of all attempts together
  std::size_t total = 0;       ///< points
  std::vector<std::string> notes;
  std::string problem;  ///< why it could not be brought to the end; empty: it could
  bool hasStruck = false;
  /// From the fault to the end of the attempt it hit; only if that attempt failed.
  std::optional<base::Duration> endedAfter;
  std::uint64_t requests = 0;  ///< served by the machine

  /// The first attempt went through.
  [[nodiscard]] bool hasSurvived() const;
  /// Each point once, in order, to the end.
  [[nodiscard]] bool isWhole() const {
    return integrity.isFaultless() && integrity.executed == total;
  }
};

[[nodiscard]] NetworkEvidence exposeToNetwork(const NetworkScenario& scenario);

}  // namespace rivulet::tests
