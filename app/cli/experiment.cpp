// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>

#include "cli/commands.h"
#include "cli/connection.h"
#include "experiments/catalogue.h"
#include "experiments/lookahead.h"
#include "parallel/thread_executor.h"
#include "report/experiment_report.h"
#include "report/svg_plot.h"

namespace rivulet::cli {

namespace {

namespace fs = std::filesystem;

base::Result<void> writeFile(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.flush();
  if (!file) {
    return base::fail(trace::TraceError::FileNotWritable,
                      "The file cannot be written. Check the folder and the permissions.",
                      path.string());
  }
  return {};
}

/// The share done, on a terminal only.
class ProgressLine {
 public:
  explicit ProgressLine(std::string name) : m_name(std::move(name)) {}
  ~ProgressLine() {
    if (m_drawn) {
      std::fputs("\r\x1b[K", stderr);
    }
  }
  bool operator()(double share) {
    const std::lock_guard lock(m_mutex);
    const int percent = static_cast<int>(100.0 * share);
    if (isTerminal() && percent != m_percent) {
      m_percent = percent;
      m_drawn = true;
      fmt::print(stderr, "\r{} {} %", m_name, percent);
      std::fflush(stderr);
    }
    return !wasInterrupted();
  }

 private:
  std::mutex m_mutex;
  std::string m_name;
  int m_percent = -1;
  bool m_drawn = false;
};

/// "curve.svg", "curve-2.svg", ...
fs::path numbered(const fs::path& path, std::size_t index) {
  return index == 0 ? path
                    : path.parent_path() / fmt::format("{}-{}{}", path.stem().string(), index + 1,
                                                       path.extension().string());
}

// REUSE-IgnoreStart
constexpr const char* kPageLicense =
    "<!--\nSPDX-FileCopyrightText: 2026 The Rivulet authors\n"
    "SPDX-License-Identifier: GPL-3.0-or-later\n-->\n";
constexpr const char* kPictureLicense =
    "SPDX-FileCopyrightText: 2026 The Rivulet authors\n\n"
    "SPDX-License-Identifier: GPL-3.0-or-later\n";
// REUSE-IgnoreEnd

base::Result<void> writeReport(const fs::path& folder,
                               const std::vector<experiments::Experiment>& results) {
  std::error_code error;
  fs::create_directories(folder / "images" / "fidelity", error);
  std::string text =
      std::string(kPageLicense) +
      "# Fidelity of the virtual machine\n\n"
      "Written by `scripts/fidelity`; do not edit. Every figure was measured by the run that wrote "
      "this page, with preset `dmu75` in virtual time. [P1] is explained in "
      "[methods.md](methods.md), the preset and its fitted numbers in [machine.md](machine.md).\n\n"
      "| experiment | what | checks passed |\n| --- | --- | --- |\n";
  for (const experiments::Experiment& result : results) {
    const auto passed =
        std::count_if(result.checks.begin(), result.checks.end(),
                      [](const experiments::Check& check) { return check.passed(); });
    text += fmt::format("| [`{0}`](#{0}) | {1} | {2} of {3} |\n", result.name, result.title, passed,
                        result.checks.size());
  }
  for (const experiments::Experiment& result : results) {
    std::vector<std::string> images;
    for (std::size_t i = 0; i < result.plots.size(); ++i) {
      const fs::path image =
          fs::path("images") / "fidelity" / numbered(result.name + ".svg", i).string();
      images.push_back(image.generic_string());
      if (auto done = writeFile(folder / image, report::svgPlot(result.plots[i])); !done) {
        return done;
      }
      if (auto done = writeFile(folder / (image.string() + ".license"), kPictureLicense); !done) {
        return done;
      }
    }
    text += fmt::format("\n<a id=\"{}\"></a>\n\n", result.name) +
            report::experimentMarkdown(result, images);
  }
  return writeFile(folder / "fidelity.md", text);
}

base::Result<experiments::Experiment> run(const std::string& name,
                                          const ExperimentCommandOptions& options,
                                          const machine::MachineConfig& machine,
                                          Connection* connection) {
  if (name == "lookahead") {
    return experiments::runLookahead(options.recordings);
  }
  parallel::ThreadExecutor executor(options.threads);
  ProgressLine progress(name);
  experiments::ExperimentOptions experiment{machine, options.seeds, executor,
                                            [&progress](double share) { return progress(share); }};
  if (connection == nullptr) {
    return experiments::runExperiment(name, experiment);
  }
  return experiments::runExperimentOn(
      name, {*connection->link, *connection->control, connection->name}, experiment);
}

}  // namespace

Exit experiment(const ExperimentCommandOptions& options) {
  std::vector<std::string> names = options.names;
  if (names == std::vector<std::string>{"all"}) {
    names = experiments::experimentNames();
    if (!options.recordings.empty()) {
      names.emplace_back("lookahead");
    }
  }
  const auto machine = machine::loadPreset(options.preset);
  if (!machine) {
    return reportError(machine.error(), false);
  }
  std::optional<Connection> connection;
  if (!options.endpoint.empty()) {
    auto opened = connectTo(options.endpoint);
    if (!opened) {
      return reportError(opened.error(), false);
    }
    connection = std::move(*opened);
  }
  watchForInterrupt();
  std::vector<experiments::Experiment> results;
  for (const std::string& name : names) {
    auto result = run(name, options, *machine, connection ? &*connection : nullptr);
    if (!result) {
      return reportError(result.error(), false);
    }
    fmt::print("{}{}", results.empty() ? "" : "\n", report::experimentText(*result));
    std::fflush(stdout);
    results.push_back(std::move(*result));
  }

  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  std::string csv;
  std::size_t plots = 0;
  bool passed = true;
  for (const experiments::Experiment& result : results) {
    passed = passed && result.passed();
    json.push_back(report::experimentJson(result));
    csv += (csv.empty() ? "" : "\n") + report::experimentCsv(result);
    for (const experiments::Plot& plot : result.plots) {
      if (!options.plot.empty()) {
        if (auto done = writeFile(numbered(options.plot, plots++), report::svgPlot(plot)); !done) {
          return reportError(done.error(), false);
        }
      }
    }
  }
  const auto write = [](const std::string& path, const std::string& text) -> base::Result<void> {
    return path.empty() ? base::Result<void>{} : writeFile(path, text);
  };
  for (const auto& done :
       {write(options.json, json.dump(2) + "\n"), write(options.csv, csv),
        options.report.empty() ? base::Result<void>{} : writeReport(options.report, results)}) {
    if (!done) {
      return reportError(done.error(), false);
    }
  }
  fmt::print("\n{}\n", passed ? "All figures are within their tolerance."
                              : "Some figures are OUTSIDE their tolerance.");
  return passed ? Exit::Done : Exit::Wrong;
}

}  // namespace rivulet::cli
