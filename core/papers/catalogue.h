// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The experiments by name. @threadsafety pure; jobs go through the executor of the options.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/executor.h"
#include "base/result.h"
#include "machine/config.h"
#include "opcua/link.h"
#include "papers/experiment.h"

namespace rivulet::streaming {
struct Scenario;
}  // namespace rivulet::streaming

namespace rivulet::papers {

enum class ExperimentError {
  UnknownName = 1,
  Cancelled,
  NotOverOpcUa,  ///< this experiment needs virtual time
  Failed,        ///< the control did not respond as required; the message says how
  OnlyShare,     ///< the executor did a share of the jobs only: no result, but no fault either
};

[[nodiscard]] std::error_code make_error_code(ExperimentError code);

struct ExperimentOptions {
  machine::MachineConfig machine;
  std::size_t seeds = 0;  ///< runs per point, or shots per measurement; 0: the usual number
  base::Executor& executor;
  /// Called with the share done, 0 to 1, possibly from several threads; false cancels. May be
  /// empty.
  std::function<bool(double)> progress;
  /// A wrong method, to see which checks catch it: changes each run before it is made. May be
  /// empty.
  std::function<void(streaming::Scenario&)> wrong{};
};

/// A real control, or the virtual machine behind its server.
struct Endpoint {
  opcua::Link& link;
  opcua::Control& control;
  std::string name;
};

/// In the order of the report.
[[nodiscard]] std::vector<std::string> experimentNames();

/// Those that several computers can share: with base::ShareExecutor they end with OnlyShare.
[[nodiscard]] std::vector<std::string> shareableExperiments();

/// @return UnknownName, Cancelled, OnlyShare
[[nodiscard]] base::Result<Experiment> runExperiment(const std::string& name,
                                                     const ExperimentOptions& options);

/// table1 and figure2 on a connection. @return UnknownName, NotOverOpcUa, or the error of the link
[[nodiscard]] base::Result<Experiment> runExperimentOn(const std::string& name,
                                                       const Endpoint& endpoint,
                                                       const ExperimentOptions& options);

}  // namespace rivulet::papers

template <>
struct std::is_error_code_enum<rivulet::papers::ExperimentError> : std::true_type {};
