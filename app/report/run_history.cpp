// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/run_history.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>

#include "base/descriptor.h"
#include "base/file.h"
#include "base/private_file.h"
#include "base/text.h"
#include "base/units.h"
#include "journal/line_file.h"
#include "report/json_fields.h"
#include "report/run_store.h"

namespace rivulet::report {
namespace fs = std::filesystem;

namespace {

using nlohmann::ordered_json;

constexpr std::string_view kReportEnding = ".report.json";
constexpr std::string_view kIndexEnding = ".index.json";
constexpr const char* kLimitsFile = "limits.json";
constexpr double kBytesMax = 1e15;

constexpr auto limitsFields = [](auto& io, auto& limits) {
  io.number("runs_max", limits.runsMax, 1, kJsonCountMax);
  io.number("bytes_max", limits.bytesMax, 0, kBytesMax);
};

base::Result<void> writeJson(const fs::path& file, const ordered_json& root) {
  return base::writePrivateFile(
      file, root.dump(1, ' ', false, ordered_json::error_handler_t::replace) + '\n');
}

/// "20261122T050000Z-rows.nc": sorts by time.
std::string nameOf(const std::string& programName, const std::string& startedAtUtc) {
  std::string name;
  std::copy_if(startedAtUtc.begin(), startedAtUtc.end(), std::back_inserter(name),
               [](char c) { return base::isDigit(c) || base::isNameLetter(c); });
  return name + "-" + plainName(fs::path(programName).filename().string());
}

/// Makes the file, empty, unless there is one: programs that end a run at the same time never get
/// the same name. What else is wrong with it is said by whoever writes it.
bool isOfAnother(const fs::path& path) {
  const int made = base::openToWrite(path, {.mustBeNew = true});
  if (made < 0) {
    return errno == EEXIST;
  }
  base::closeFile(made);
  return false;
}

/// The name, or with a number after it if a run has it already.
template <class IsTaken>
std::string freeName(const std::string& name, IsTaken isTaken) {
  std::string free = name;
  for (int i = 2; isTaken(free); ++i) {
    free = fmt::format("{}-{}", name, i);
  }
  return free;
}

/// As RFC 4180 has it. A text that a spreadsheet would take for a formula begins with a quote.
std::string quoted(const std::string& text) {
  const bool isFormula = !text.empty() && std::string_view("=+-@").find(text[0]) != text.npos;
  std::string quoted = isFormula ? "\"'" : "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + '"';
}

std::uintmax_t sizeOf(const fs::path& file) {
  std::error_code missing;
  const std::uintmax_t size = fs::file_size(file, missing);
  return missing ? 0 : size;
}

}  // namespace

std::string runsCsv(const std::vector<streaming::RunSummary>& runs) {
  std::string text =
      "started_utc,program,program_hash,machine,user,computer,method,points_per_loop,"
      "feed_mm_per_min,override_percent,delta_mm,outcome,finding,executed,points,repeated,skipped,"
      "foreign,"
      "out_of_order,duration_s,pauses,paused_s\n";
  for (const streaming::RunSummary& run : runs) {
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
        quoted(run.origin.startedAtUtc), quoted(run.programName), quoted(run.programHash),
        quoted(run.endpoint), quoted(run.origin.user), quoted(run.origin.computer),
        base::methodName(run.method), run.pointsPerLoop, base::mmPerMinFromMmPerS(run.feedMmPerS),
        run.overrideFactor ? fmt::format("{:g}", 100.0 * *run.overrideFactor) : std::string(),
        run.deltaMm, streaming::outcomeName(run.outcome), streaming::runFindingName(run.finding),
        run.executed, run.total, run.repeated, run.skipped, run.foreign, run.outOfOrder,
        base::toSeconds(run.duration), run.pauses, base::toSeconds(run.paused));
  }
  return text;
}

fs::path RunHistory::folderOfUser() {
  return journal::stateFolderOfUser() / "history";
}

fs::path RunHistory::reportFile(const std::string& id) const {
  return m_folder / (id + std::string(kReportEnding));
}

fs::path RunHistory::indexFile(const std::string& id) const {
  return m_folder / (id + std::string(kIndexEnding));
}

base::Result<fs::path> RunHistory::newRecording(const std::string& programName,
                                                const std::string& startedAtUtc) const {
  const fs::path recordings = m_folder / "recordings";
  (void)base::makePrivateFolder(m_folder);
  (void)base::makePrivateFolder(recordings);  // a folder of somebody else may be there already
  std::error_code status;
  if (!fs::is_directory(recordings, status)) {
    return base::fail(base::FileError::NotWritable,
                      "The folder cannot be created. Check permissions and free space.",
                      recordings.string());
  }
  const auto file = [&recordings](const std::string& name) {
    return recordings / (name + ".rivulet");
  };
  return file(freeName(nameOf(programName, startedAtUtc),
                       [&file](const std::string& name) { return isOfAnother(file(name)); }));
}

base::Result<streaming::RunSummary> RunHistory::add(
    const streaming::RunReport& report, streaming::RunSummary known,
    std::span<const gcode::StreamPoint> points) const {
  (void)base::makePrivateFolder(m_folder);  // writing says what is wrong
  FinishedRun run;
  run.report = report;
  run.report.controlTrace.reset();
  run.sketch = gcode::sketchOf(points, kSketchPointsMax);
  known.id = freeName(nameOf(report.programName, report.settings.origin.startedAtUtc),
                      [this](const std::string& id) { return isOfAnother(reportFile(id)); });
  run.summary = streaming::summaryOf(report, std::move(known));
  // The report first: a run of the index is complete.
  if (base::Result<void> written = writeJson(reportFile(run.summary.id), finishedRunJson(run));
      !written) {
    return base::fail(written.error());
  }
  if (base::Result<void> written = writeJson(indexFile(run.summary.id), summaryJson(run.summary));
      !written) {
    return base::fail(written.error());
  }
  prune(run.summary.id);
  return run.summary;
}

HistoryList RunHistory::list() const {
  HistoryList list;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(m_folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(kReportEnding)) {
      continue;
    }
    const std::string id = name.substr(0, name.size() - kReportEnding.size());
    if (const auto json = readJson(indexFile(id))) {
      if (auto summary = summaryOf(*json, indexFile(id))) {
        summary->id = id;
        list.runs.push_back(std::move(*summary));
        continue;
      }
    }
    // Without its line in the index: from the report, and the line is made again.
    auto run = readFinishedRun(entry.path());
    if (!run) {
      list.unreadable.push_back({entry.path(), run.error()});
      continue;
    }
    run->summary.id = id;
    static_cast<void>(writeJson(indexFile(id), summaryJson(run->summary)));
    list.runs.push_back(std::move(run->summary));
  }
  std::sort(list.runs.begin(), list.runs.end(),
            [](const streaming::RunSummary& a, const streaming::RunSummary& b) {
              return std::pair(a.origin.startedAtUtc, a.id) >
                     std::pair(b.origin.startedAtUtc, b.id);
            });
  return list;
}

void RunHistory::remove(const streaming::RunSummary& run) const {
  std::error_code ignored;  // somebody else may have removed it
  fs::remove(reportFile(run.id), ignored);
  fs::remove(indexFile(run.id), ignored);
  if (run.ownsRecording && !run.recording.empty()) {
    fs::remove(run.recording, ignored);
  }
}

HistoryLimits RunHistory::limits() const {
  HistoryLimits limits;
  const auto root = readJson(m_folder / kLimitsFile);
  if (!root) {
    return limits;
  }
  Members members(*root);
  HistoryLimits read;
  FieldReader io(members);
  limitsFields(io, read);
  return members.bad().empty() ? read : limits;
}

base::Result<void> RunHistory::setLimits(const HistoryLimits& limits) const {
  (void)base::makePrivateFolder(m_folder);  // writing says what is wrong
  const fs::path file = m_folder / kLimitsFile;
  const auto written = writeJson(
      file, jsonInPlaceOf(readJson(file).value_or(nlohmann::json()), limits, limitsFields));
  if (written) {
    prune({});
  }
  return written;
}

void RunHistory::prune(const std::string& keep) const {
  const HistoryLimits bounds = limits();
  std::size_t kept = 0;
  std::uintmax_t bytes = 0;
  bool isFull = false;
  for (const streaming::RunSummary& run : list().runs) {
    const std::uintmax_t size = sizeOf(reportFile(run.id)) + sizeOf(indexFile(run.id)) +
                                (run.ownsRecording ? sizeOf(run.recording) : 0);
    // Once one does not fit, no older one is kept in its place.
    isFull = isFull || kept + 1 > bounds.runsMax || bytes + size > bounds.bytesMax;
    if (isFull && run.id != keep) {
      remove(run);
    } else {
      ++kept;
      bytes += size;
    }
  }
}

}  // namespace rivulet::report
