// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Common to all commands: exit codes, output, errors. @threadsafety main thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/budget.h"
#include "base/error.h"
#include "base/method_kind.h"
#include "streaming/run/run.h"
#include "templates/cells.h"

namespace rivulet::cli {

/// Exit codes of rivulet-cli (docs/cli.md).
enum class Exit { Done = 0, Wrong = 1, BadInput = 2, Connection = 3, RuleApplies = 4 };

/// Of each file that is read and each thing that is expanded, from now on (--memory-limit).
void setMemoryBudget(const base::Budget& budget);
[[nodiscard]] const base::Budget& memoryBudget();

/// Prints the object on standard output, as one JSON text.
void printJson(const nlohmann::ordered_json& json);

/// Sets up the log and writes the command line into it.
void startLog(const std::string& level, const std::vector<std::string>& words);

/// Prints the error on standard error, or as {"error": …} with `asJson`.
/// @return the exit code that belongs to the error
Exit reportError(const base::Error& error, bool asJson);

/// Said while a run waits for the cells (`StartClaim`).
inline constexpr const char* kClaimMayLapse =
    "Another client has claimed the R-parameters, but may have died. Its claim lapses after 10 s.";

/// The exit code for a failure: connection trouble is 3, everything else that was given 2.
[[nodiscard]] Exit exitFor(const base::Error& error);

/// The exit code of a run or job that has ended with this error: that of `exitFor` if the
/// connection failed or the control belongs to somebody else, else Wrong.
[[nodiscard]] Exit exitForRun(const base::Error& error);

/// Options of an operating point, common to several commands.
struct OperatingOptions {
  std::string method = "window";
  int pointsPerLoop = 7;  ///< method window: per window
  int windows = 2;
  int baseCell = 0;
  int windowsAhead = 3;
  bool noSlowDown = false;
  std::string control = "sinumerik";
  double deltaMm = 0.3;
  double feedMmPerMin = 0.0;       ///< of all moves; 0: the feeds of the program
  double overridePercent = 100.0;  ///< on the feeds of the program
  double rapidMmPerMin = 0.0;      ///< of the program's rapids; 0: that of the machine
  std::string feedCells = "auto";  ///< auto, window, point
  std::string layout = "paper";
  bool packed = false;                  ///< the points after the first of a window, in a cell each
  double correctionLimitMm = 0.0;       ///< online correction; 0: none
  double liftMm = 0.0;                  ///< the tool may be lifted while held; 0: not
  std::vector<double> factor;           ///< bounds of a factor of the override; empty: none
  std::optional<double> silenceLimitS;  ///< see `templates::WindowSettings`; nothing: the machine's
  std::optional<double> stopLimitS;     ///< see `streaming::stopLimitS`; nothing: the machine's
  std::string
      axes;  ///< letters; empty: X Y Z, and for a run also the rotary axes that the program moves

  /// Checked and in internal units. The names are checked by the option parser.
  [[nodiscard]] templates::TemplateParameters parameters() const;
};

}  // namespace rivulet::cli
