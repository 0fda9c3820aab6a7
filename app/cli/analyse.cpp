// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/file.h"
#include "base/sha256.h"
#include "base/units.h"
#include "cli/commands.h"
#include "cli/trace_files.h"
#include "report/report_json.h"
#include "report/rule.h"
#include "report/run_trend.h"
#include "report/stream_quality.h"
#include "report/trace_json.h"
#include "report/trace_source.h"
#include "streaming/run/run.h"
#include "trace/analysis/pauses.h"
#include "trace/analysis/statistics.h"
#include "trace/analysis/trace_analysis.h"
#include "trace/import/import_error.h"
#include "trace/signal_file.h"
#ifdef RIVULET_WITH_REPORTS
#include "trace_report/write_page.h"
#endif

namespace rivulet::cli {

namespace {

using nlohmann::ordered_json;
using streaming::Outcome;
using streaming::RunFinding;

/// The analysis of one file.
struct Analysed {
  ordered_json json;
  std::string text;
  bool isWrong = false;
  streaming::Outcome outcome = Outcome::Completed;  ///< of a recording
  RunFinding finding = RunFinding::NotJudged;
  std::optional<report::StreamQuality> stream;
  std::optional<report::RunFigures> figures;  ///< of a recording
};

/// The report of a recorded run, as far as the finding depends on it.
streaming::RunReport reportOf(const trace::Recording& recording,
                              const trace::TraceAnalysis& analysis) {
  streaming::RunReport report;
  for (const Outcome outcome : {Outcome::Completed, Outcome::Stopped}) {
    if (recording.end && recording.end->outcome == streaming::outcomeName(outcome)) {
      report.outcome = outcome;
    }
  }
  report.counters.total = recording.points.points.size();
  report.integrity = analysis.blocks;
  return report;
}

/// The same as the run itself said. A recording without its end says nothing good.
RunFinding findingOf(const trace::Recording& recording, const streaming::RunReport& report) {
  if (recording.complete) {
    return report.finding();
  }
  const bool isWrong = report.integrity.judged && !report.integrity.isFaultless();
  return isWrong ? RunFinding::Faulty : RunFinding::NotJudged;
}

RunFinding judgedFinding(bool isJudged, bool isWrong) {
  return !isJudged ? RunFinding::NotJudged : (isWrong ? RunFinding::Faulty : RunFinding::Faultless);
}

void addIntegrity(ordered_json& json, const trace::Integrity& integrity) {
  json["judged"] = integrity.judged;
  json["executed"] = integrity.executed;
  json["repeated"] = integrity.repeated;
  json["skipped"] = integrity.skipped;
  json["foreign"] = integrity.foreign;
  json["out_of_order"] = integrity.outOfOrder;
}

std::string integrityText(const trace::Integrity& integrity, std::size_t points) {
  return fmt::format(
      "  executed {} of {} points, repeated {}, skipped {}, foreign {}, out of order {}\n",
      integrity.executed, points, integrity.repeated, integrity.skipped, integrity.foreign,
      integrity.outOfOrder);
}

std::string pausesText(const std::vector<trace::Pause>& pauses) {
  base::Duration paused{};
  for (const trace::Pause& pause : pauses) {
    paused += pause.duration;
  }
  return fmt::format("  {} pauses, {:.3f} s in total\n", pauses.size(), base::toSeconds(paused));
}

void addPauses(ordered_json& json, const std::vector<trace::Pause>& pauses, base::Instant origin) {
  base::Duration paused{};
  for (const trace::Pause& pause : pauses) {
    paused += pause.duration;
  }
  json["pauses"] = report::pausesJson(pauses, origin);
  json["paused_s"] = base::toSeconds(paused);
}

trace::DurationStatistics accessTimes(const trace::Recording& recording) {
  std::vector<base::Duration> perNode;
  for (const trace::Access& access : recording.accesses) {
    perNode.push_back(access.took / std::max(access.nodes, 1));
  }
  return trace::durationStatistics(perNode);
}

std::string recordingText(const trace::Recording& recording, const trace::Integrity& integrity,
                          const std::vector<trace::Pause>& pauses) {
  std::string text =
      fmt::format("{} with method {}, N {}, {}\n", recording.start.programName,
                  recording.start.method, recording.start.pointsPerLoop,
                  recording.end ? recording.end->outcome : std::string("outcome unknown"));
  if (!recording.complete) {
    text +=
        "  the recording was cut off before the end of the run: its disk was full, or the program "
        "was ended\n";
  }
  if (recording.unreadableLines > 0) {
    text +=
        fmt::format("  {} lines could not be read and were ignored\n", recording.unreadableLines);
  }
  text += integrity.judged
              ? integrityText(integrity, recording.points.points.size())
              : fmt::format("  not judged: {}\n",
                            !recording.controlTrace ? "the recording holds no trace of the control"
                            : recording.controlTrace->truncated
                                ? "the trace of the control is incomplete"
                                : "points are missing in the recording");
  const trace::DurationStatistics access = accessTimes(recording);
  return text + pausesText(pauses) +
         fmt::format("  access per node: mean {:.2f} ms, p99 {:.2f} ms, max {:.2f} ms\n",
                     base::toMilliseconds(access.mean), base::toMilliseconds(access.p99),
                     base::toMilliseconds(access.max));
}

Analysed analyseRecording(const trace::Recording& recording, const trace::TraceAnalysis& analysis) {
  const streaming::RunReport run = reportOf(recording, analysis);
  const RunFinding finding = findingOf(recording, run);
  std::vector<trace::Pause> pauses = recording.pauses;
  base::Instant origin{};
  if (recording.controlTrace) {
    if (!recording.controlTrace->truncated) {
      pauses = trace::findPauses(*recording.controlTrace);
    }
    if (!recording.controlTrace->samples.empty()) {
      origin = recording.controlTrace->samples.front().at;
    }
  }
  const trace::DurationStatistics access = accessTimes(recording);
  Analysed analysed;
  analysed.isWrong =
      finding == RunFinding::Faulty || run.outcome == Outcome::Failed || !recording.complete;
  analysed.outcome = run.outcome;
  analysed.finding = finding;
  analysed.json = {{"method", recording.start.method},
                   {"program", recording.start.programName},
                   {"endpoint", recording.start.endpoint},
                   {"complete", recording.complete},
                   {"unreadable_lines", recording.unreadableLines},
                   {"outcome", recording.end ? recording.end->outcome : std::string("unknown")},
                   {"finding", streaming::runFindingName(finding)},
                   {"faultless", finding == RunFinding::Faultless},
                   {"points", recording.points.points.size()}};
  addIntegrity(analysed.json, run.integrity);
  analysed.json["duration_s"] = recording.end
                                    ? ordered_json(base::toSeconds(recording.end->duration))
                                    : ordered_json(nullptr);
  addPauses(analysed.json, pauses, origin);
  analysed.json["access_ms"] = {{"mean", base::toMilliseconds(access.mean)},
                                {"p50", base::toMilliseconds(access.p50)},
                                {"p95", base::toMilliseconds(access.p95)},
                                {"p99", base::toMilliseconds(access.p99)},
                                {"max", base::toMilliseconds(access.max)}};
  analysed.figures = {recording.start.endpoint,
                      {},
                      report::daysOf(recording.start.startedAtUtc),
                      base::toMilliseconds(access.mean),
                      analysed.json["paused_s"].get<double>()};
  analysed.text = recordingText(recording, run.integrity, pauses);
  if (!recording.accesses.empty()) {
    analysed.stream = report::judgeStream(recording, analysis);
    analysed.json["stream"] = report::streamQualityJson(*analysed.stream);
    analysed.text += report::streamQualityText(*analysed.stream);
  }
  return analysed;
}

Analysed analyseControlTrace(const trace::ControlTrace& controlTrace,
                             const trace::TraceAnalysis& analysis) {
  Analysed analysed;
  analysed.json["format"] = "trace of the control";
  analysed.json["complete"] = !controlTrace.truncated;
  analysed.text =
      fmt::format("trace of the control: {} samples, {} blocks{}\n", controlTrace.samples.size(),
                  controlTrace.blocks.size(), controlTrace.truncated ? ", incomplete" : "");
  const std::vector<trace::Pause> pauses = trace::findPauses(controlTrace);
  if (analysis.programPath) {
    const std::size_t points = analysis.programPath->points().size();
    analysed.json["points"] = points;
    analysed.isWrong = analysis.blocks.judged && !analysis.blocks.isFaultless();
    analysed.finding = judgedFinding(analysis.blocks.judged, analysed.isWrong);
    analysed.text += analysis.blocks.judged ? integrityText(analysis.blocks, points)
                                            : "  not judged: the trace is incomplete\n";
  }
  addIntegrity(analysed.json, analysis.blocks);
  addPauses(analysed.json, pauses,
            controlTrace.samples.empty() ? base::Instant{} : controlTrace.samples.front().at);
  analysed.text += pausesText(pauses);
  return analysed;
}

Analysed analyseImported(const trace::ImportedTrace& imported,
                         const trace::TraceAnalysis& analysis) {
  Analysed analysed;
  ordered_json names = ordered_json::array();
  for (const trace::Signal& signal : imported.trace.signalList) {
    names.push_back({{"name", signal.name}, {"unit", signal.unit}});
  }
  ordered_json remarks = ordered_json::array();
  for (const trace::Remark& remark : imported.trace.remarks) {
    remarks.push_back(trace::remarkText(remark));
  }
  analysed.json = {{"format", imported.trace.format},
                   {"columns", trace::printColumnRoles(imported.columns)},
                   {"signals", std::move(names)},
                   {"remarks", std::move(remarks)}};
  const trace::PathMatch& path = analysis.path;
  analysed.json["judged"] = path.judged;
  if (path.judged) {
    analysed.isWrong = !path.isFaultless();
    analysed.finding = judgedFinding(true, analysed.isWrong);
    analysed.json["points"] = path.points;
    analysed.json["executed"] = path.executed;
    analysed.json["repeated"] = path.repeated;
    analysed.json["skipped"] = path.skipped;
    analysed.json["foreign"] = path.foreign;
  }
  analysed.text =
      fmt::format("{}: {} signals, {} samples of a position every {:g} ms\n", imported.trace.format,
                  imported.trace.signalList.size(), analysis.motion.samples.size(),
                  base::toMilliseconds(analysis.motion.step));
  analysed.text += fmt::format("  columns: {}\n", trace::printColumnRoles(imported.columns));
  for (const trace::Remark& remark : imported.trace.remarks) {
    const bool isUnit = remark.code == trace::RemarkCode::TimeUnitAssumed;
    const bool isRate = remark.code == trace::RemarkCode::RateAssumed;
    analysed.text += fmt::format("  {}{}\n", trace::remarkText(remark),
                                 isUnit   ? " Say another one with --map time=COLUMN:UNIT."
                                 : isRate ? " Give the rate with --rate."
                                          : "");
  }
  return analysed;
}

/// Without a position there is nothing to analyse: what was looked for, and where.
base::Error noPosition(const trace::ImportedTrace& imported) {
  std::vector<std::string> names;
  for (const trace::Signal& signal : imported.trace.signalList) {
    names.push_back(signal.name);
  }
  std::string why;
  for (const trace::Remark& remark : imported.trace.remarks) {
    why += " " + trace::remarkText(remark);
  }
  const bool isKnown = std::any_of(
      imported.columns.begin(), imported.columns.end(),
      [](const trace::ColumnRole& column) { return column.role != trace::SignalRole::Time; });
  return base::makeError(
      trace::ImportError::BadMapping,
      isKnown
          ? fmt::format("No sample has a time and all positions of {}.{} Say what the columns mean "
                        "with --map x_act=COLUMN,time=COLUMN:UNIT.",
                        trace::printColumnRoles(imported.columns), why)
          : fmt::format("No column is known as the position of an axis (X, Y or Z; set, act, cmd, "
                        "fb, soll, ist, ...): the columns are {}.{} Say which with --map "
                        "x_act=COLUMN; with --save, all signals are saved as they are.",
                        fmt::join(names, ", "), why));
}

std::string summaryCell(const ordered_json& json, std::string_view column) {
  const ordered_json* value = nullptr;
  if (column == "access") {
    value = json.contains("access_ms") ? &json["access_ms"]["p99"] : nullptr;
  } else if (column == "contour") {
    value = json.contains("contour_error") ? &json["contour_error"]["max_mm"] : nullptr;
  } else if (json.contains(std::string(column))) {
    value = &json[std::string(column)];
  }
  if (value == nullptr || value->is_null()) {
    return "";
  }
  if (value->is_number_float()) {
    return fmt::format("{:.4g}", value->get<double>());
  }
  return value->is_string() ? value->get<std::string>() : value->dump();
}

/// A page for a person.
base::Result<void> writeReport([[maybe_unused]] const AnalyseOptions& options,
                               [[maybe_unused]] const std::string& file,
                               [[maybe_unused]] const trace::Trace& source,
                               [[maybe_unused]] const Analysed& analysed,
                               [[maybe_unused]] const trace::TraceAnalysis& analysis) {
#ifdef RIVULET_WITH_REPORTS
  trace_report::TraceFacts facts;
  facts.analysis = &analysis;
  facts.recording = source.recording();
  facts.stream = analysed.stream ? &*analysed.stream : nullptr;
  facts.outcome = analysed.outcome;
  facts.finding = analysed.finding;
  facts.format = analysed.json.value("format", std::string());
  facts.file = std::filesystem::path(file).filename().string();
  facts.programFile = options.program;
  facts.appVersion = RIVULET_VERSION;
  const auto bytes = base::readFile(file, memoryBudget());
  facts.fileHash = bytes ? base::sha256Hex(*bytes) : std::string();
  return trace_report::writeTracePage(options.report, options.language, facts);
#else
  return base::fail(base::FileError::NotWritable,
                    "This rivulet-cli was built without reports. Use --json.");
#endif
}

base::Result<Analysed> analyseFile(const std::string& file, const AnalyseOptions& options,
                                   const gcode::Program* program) {
  const auto source = openTrace(file, options);
  if (!source) {
    return base::fail(source.error());
  }
  const trace::TraceAnalysis analysis = trace::analyseTrace(*source, analysisOf(options, program));
  if (source->imported() != nullptr && analysis.motion.samples.empty() && options.save.empty()) {
    return base::fail(noPosition(*source->imported()));
  }
  Analysed analysed =
      source->recording() != nullptr  ? analyseRecording(*source->recording(), analysis)
      : source->imported() != nullptr ? analyseImported(*source->imported(), analysis)
                                      : analyseControlTrace(*source->control(), analysis);
  report::addTraceAnalysis(analysed.json, analysis);
  analysed.text += report::traceAnalysisText(analysis);
  if (!options.save.empty()) {
    const trace::ShownTrace shown = trace::makeShownTrace(*source, analysis);
    if (auto done = trace::saveSignals(options.save, trace::signalFileOf(shown)); !done) {
      return base::fail(done.error());
    }
  }
  if (!options.report.empty()) {
    if (auto done = writeReport(options, file, *source, analysed, analysis); !done) {
      return base::fail(done.error());
    }
  }
  return analysed;
}

/// What the table of many runs shows of each.
constexpr std::array<std::string_view, 12> kSummaryColumns{
    "finding",  "points", "executed", "repeated",   "skipped",          "foreign",
    "paused_s", "access", "contour",  "duration_s", "standstill_count", "rule"};

std::string_view summaryHeading(std::string_view column) {
  return column == "access" ? "access_p99_ms" : (column == "contour" ? "contour_max_mm" : column);
}

std::string summaryField(std::string_view text, bool asCsv) {
  return asCsv ? fmt::format(",{}", text) : fmt::format(" {:>16}", text);
}

void printSummary(const std::vector<ordered_json>& results, bool asCsv) {
  std::string line = asCsv ? "file" : fmt::format("{:40}", "file");
  for (const std::string_view column : kSummaryColumns) {
    line += summaryField(summaryHeading(column), asCsv);
  }
  fmt::print("{}\n", line);
  for (const ordered_json& result : results) {
    const std::string file = result["file"].get<std::string>();
    line = asCsv ? fmt::format("\"{}\"", file) : fmt::format("{:40}", file);
    for (const std::string_view column : kSummaryColumns) {
      std::string cell = summaryCell(result, column);
      cell = column == "finding" && result.contains("error") ? "unreadable" : cell;
      line += summaryField(cell, asCsv);
    }
    fmt::print("{}\n", line);
  }
}

/// The table is also printed, below that of the files.
base::Result<void> writeTrend(const AnalyseOptions& options,
                              std::vector<report::RunFigures> figures) {
  const auto trends = report::trendsOf(std::move(figures));
  const std::string suffix = std::filesystem::path(options.trend).extension().string();
  if (suffix != ".html" && suffix != ".svg" && suffix != ".json") {
    return base::fail(base::FileError::NotWritable,
                      "A trend is written as .html, .svg or .json: choose one of them.",
                      options.trend);
  }
  if (!options.json && !options.csv) {
    fmt::print("\n{}", report::trendText(trends));
  }
  if (suffix == ".json") {
    return base::writeFile(options.trend,
                           report::trendJson(trends).dump(
                               2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
                               "\n");
  }
#ifdef RIVULET_WITH_REPORTS
  const report::TrendTexts texts = trace_report::trendTexts(options.language);
#else
  if (options.language != "en") {
    return base::fail(base::FileError::NotWritable,
                      "This rivulet-cli was built without translations. Leave out --language.");
  }
  const report::TrendTexts texts;
#endif
  return base::writeFile(options.trend, report::trendPicture(trends, suffix == ".html", texts));
}

std::string ruleText(const report::Rule::Verdict& verdict) {
  return verdict.applies ? "applies" : verdict.unknown.empty() ? "does not apply" : "unknown";
}

}  // namespace

Exit analyse(const AnalyseOptions& options) {
  std::optional<report::Rule> rule;
  if (!options.failIf.empty()) {
    auto parsed = report::Rule::parse(options.failIf);
    if (!parsed) {
      return reportError(parsed.error(), options.json);
    }
    rule = std::move(*parsed);
  }
  const auto program = report::loadComparedProgram(options.program, options.loading.loadOptions());
  if (!program) {
    return reportError(program.error(), options.json);
  }
  const bool isBatch = options.files.size() > 1 || options.summary;
  std::vector<ordered_json> results;
  std::vector<report::RunFigures> figures;
  Exit exit = Exit::Done;
  bool applies = false;
  for (const std::string& file : options.files) {
    auto analysed = analyseFile(file, options, *program ? &**program : nullptr);
    if (!analysed) {
      // One file that cannot be read does not end a batch.
      if (!isBatch) {
        return reportError(analysed.error(), options.json);
      }
      fmt::print(stderr, "{}\n", analysed.error().text());
      results.push_back({{"file", file}, {"error", analysed.error().message}});
      exit = Exit::BadInput;
      continue;
    }
    exit = analysed->isWrong && exit == Exit::Done ? Exit::Wrong : exit;
    ordered_json result{{"file", file}};
    result.update(analysed->json);
    if (analysed->figures) {
      analysed->figures->file = file;
      figures.push_back(std::move(*analysed->figures));
    }
    if (rule) {
      const report::Rule::Verdict verdict = rule->judge(result);
      // What is not known is not allowed either.
      applies = applies || verdict.applies || !verdict.unknown.empty();
      result["rule"] = ruleText(verdict);
      for (const std::string& figure : verdict.unknown) {
        fmt::print(stderr, "{}: the rule asks for {}, which is not known of this file.\n", file,
                   figure);
      }
    }
    if (!options.json && !options.summary) {
      fmt::print("{}{}", isBatch ? fmt::format("{}: ", file) : std::string(), analysed->text);
    }
    results.push_back(std::move(result));
  }
  if (options.summary && !options.json) {
    printSummary(results, options.csv);
  } else if (options.json) {
    printJson(isBatch ? ordered_json(results) : results.front());
  }
  if (!options.trend.empty()) {
    if (const auto done = writeTrend(options, std::move(figures)); !done) {
      return reportError(done.error(), options.json);
    }
  }
  return applies ? Exit::RuleApplies : exit;
}

}  // namespace rivulet::cli
