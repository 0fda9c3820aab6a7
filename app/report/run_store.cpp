// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/run_store.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstring>
#include <ctime>
#include <limits>

#include "base/file.h"
#include "base/private_file.h"
#include "base/text.h"
#include "base/units.h"
#include "gcode/facts.h"
#include "journal/line_file.h"
#include "platform/process.h"
#include "report/run_fields.h"
#include "streaming/recovery/resume.h"
#include "templates/job_loop.h"

namespace rivulet::report {
namespace fs = std::filesystem;

namespace {

using nlohmann::ordered_json;
using streaming::StreamError;

constexpr int kRunFormat = 1;
constexpr const char* kRunFormatKey = "rivulet_run";
/// Runs that nobody resumed are removed, the oldest first.
constexpr std::size_t kRunsMax = 20;

static_assert(std::endian::native == std::endian::little,
              "points are stored as they are in memory");

constexpr auto readingFields = []<class Io>(Io& io, auto& reading) {
  io.ifThere().named("centres", reading.centres, gcode::centreReadingName,
                     gcode::centreReadingOfName);
  io.ifThere().number("chord_tolerance_mm", reading.chordToleranceMm, 1e-6,
                      gcode::TextReading::kChordToleranceMmMax);
  io.words("accepted", reading.accepted);
  if (io.has("dialect", reading.dialect)) {
    io.named("dialect", *reading.dialect, gcode::dialectName, gcode::dialectOfName);
  }
  if (io.has("units", reading.units)) {
    io.named("units", *reading.units, gcode::fileUnitsName, gcode::saidUnitsOfName);
  }
  if (io.has("no_point", reading.noPoint)) {
    io.named("no_point", *reading.noPoint, gcode::noPointName, gcode::noPointOfName);
  }
  io.ifSet().number("move_s_max", reading.moveRules.secondsMax, 0.0, kWindowSMost);
  io.ifSet().number("move_feed_mm_per_s", reading.moveRules.feedMmPerS, 0.0, kJsonCountMax);
  maybe(io, "move_feeds", reading.moveRules.feeds, feedLimitFields);
  io.ifSet().number("tolerance_mm", reading.moveRules.tolerance, 0.0, gcode::kStreamToleranceMax);
  if (Io::kReads || reading.moveRules.onSteps) {
    io.ifThere().flag("on_steps", reading.moveRules.onSteps);
  }
  std::string settings = gcode::textOf(reading.settings);
  io.ifSet().text("settings", settings);
  if constexpr (Io::kReads) {
    const auto known = gcode::controlSettingsOf(settings);
    reading.settings = known.value_or(reading.settings);
    if (!known) {
      io.refuse("settings");
    }
  }
};

constexpr auto restFields = []<class Io>(Io& io, auto& rest) {
  io.count("part", rest.part);
  maybe(io, "resume", rest.resume, [](auto& inner, auto& resume) {
    inner.count("point", resume.point);
    inner.place("start_mm", resume.startMm);
    inner.numbers("start_deg", resume.startDeg, -kJsonPlaceMax, kJsonPlaceMax);
  });
  if (io.has("tool_mm", rest.toolMm)) {
    io.place("tool_mm", *rest.toolMm);
  }
};

constexpr auto savedJobFields = [](auto& io, auto& job) {
  io.number("number", job.number, 1, templates::JobProtocol::kJobMax);
  io.number("first_run", job.firstRun, 0, streaming::kRunNumberMax);
  maybe(io, "rest", job.rest, restFields);
};

constexpr auto savedRunFields = [](auto& io, auto& run) {
  int format = kRunFormat;
  io.ifThere().number(kRunFormatKey, format, 1, kJsonCellMax);
  io.ifThere().text("program", run.programName);
  io.ifThere().text("program_file", run.programFile);
  io.ifThere().text("endpoint", run.endpoint);
  io.ifThere().object("started_by", run.settings.origin, originFields);
  io.ifThere().text("tool_version", run.toolVersion);
  io.ifThere().text("recording", run.recording);
  io.words("command", run.command);
  io.ifThere().object("reading", run.reading, readingFields);
  io.object("settings", run.settings, settingsFields);
  io.object("checkpoint", run.checkpoint, checkpointFields);
  maybe(io, "job", run.job, savedJobFields);
  maybe(io, "driven_back", run.back, [](auto& inner, auto& part) {
    inner.count("first_point", part.first);
    inner.count("next_point", part.next);
  });
};

/// "rivulet-points 2\n", then per point six coordinates and its own feed, its line, and whether its
/// move is a rapid. Version 1 has no feeds.
constexpr std::string_view kPointsBegin = "rivulet-points 2\n";
constexpr std::string_view kPointsBeginWithoutFeeds = "rivulet-points 1\n";
constexpr std::size_t kCoordinatesPerPoint = base::kAxisCount + base::kRotaryAxisCount;
constexpr std::size_t kPlacesPerPoint = kCoordinatesPerPoint + 1;
constexpr std::size_t kPointBytes = kPlacesPerPoint * sizeof(double) + sizeof(std::uint32_t) + 1;

std::string printPoints(std::span<const gcode::StreamPoint> points) {
  std::string text(kPointsBegin);
  text.reserve(text.size() + points.size() * kPointBytes);
  for (const gcode::StreamPoint& point : points) {
    std::array<char, kPointBytes> bytes{};
    std::array<double, kPlacesPerPoint> places{};
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      places[axis] = point.positionMm[axis];
    }
    std::copy(point.rotaryDeg.begin(), point.rotaryDeg.end(), places.begin() + base::kAxisCount);
    places.back() = point.feedMmPerS;
    const std::uint32_t line = point.line.value;
    std::memcpy(bytes.data(), places.data(), sizeof places);
    std::memcpy(bytes.data() + sizeof places, &line, sizeof line);
    bytes.back() = static_cast<char>(point.kind == gcode::MoveKind::Rapid);
    text.append(bytes.data(), bytes.size());
  }
  return text;
}

std::vector<gcode::StreamPoint> parsePoints(std::string_view text) {
  static_assert(kPointsBegin.size() == kPointsBeginWithoutFeeds.size());
  const bool hasFeeds = text.starts_with(kPointsBegin);
  const std::size_t count = kPlacesPerPoint - (hasFeeds ? 0 : 1);
  const std::size_t pointBytes = count * sizeof(double) + sizeof(std::uint32_t) + 1;
  if ((!hasFeeds && !text.starts_with(kPointsBeginWithoutFeeds)) ||
      (text.size() - kPointsBegin.size()) % pointBytes != 0) {
    return {};
  }
  text.remove_prefix(kPointsBegin.size());
  std::vector<gcode::StreamPoint> points(text.size() / pointBytes);
  for (gcode::StreamPoint& point : points) {
    std::array<double, kPlacesPerPoint> places{};
    std::uint32_t line = 0;
    std::memcpy(places.data(), text.data(), count * sizeof(double));
    std::memcpy(&line, text.data() + count * sizeof(double), sizeof line);
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      point.positionMm.set(axis, places[axis]);
    }
    std::copy(places.begin() + base::kAxisCount, places.begin() + kCoordinatesPerPoint,
              point.rotaryDeg.begin());
    point.feedMmPerS = places.back();
    point.line.value = line;
    point.kind = text[pointBytes - 1] != 0 ? gcode::MoveKind::Rapid : gcode::MoveKind::Feed;
    text.remove_prefix(pointBytes);
  }
  return points;
}

fs::path pointsPathOf(const fs::path& file) {
  return fs::path(file).replace_extension(".points");
}

}  // namespace

std::string plainName(std::string_view name) {
  constexpr std::size_t kLongest = 60;
  std::string plain(name.substr(0, kLongest));
  std::replace_if(
      plain.begin(), plain.end(),
      [](char c) { return !base::isNameLetter(c) && !base::isDigit(c) && c != '.' && c != '-'; },
      '-');
  return plain.empty() || plain.front() == '.' ? "run" + plain : plain;
}

std::string SavedRun::name() const {
  return fmt::format("{}-{}", plainName(fs::path(programName).filename().string()), number());
}

bool SavedRun::isUntouched() const {
  const bool isAtBeginning =
      !job || !job->rest || (job->rest->part == 0 && !job->rest->resume.has_value());
  return isAtBeginning && (job ? streaming::isBeforeFirstBlock(checkpoint)
                               : !checkpoint.granted && checkpoint.firstPoint == 0);
}

streaming::RunOrigin thisUser() {
  const std::string host = platform::hostName();
  return {platform::userName(), host.empty() ? "unknown" : host,
          fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr)))};
}

base::Result<SavedRun> savedRunOf(const nlohmann::json& json, const fs::path& file) {
  Members members(json);
  if (!members.has("/checkpoint") || !members.has("/settings")) {
    return base::fail(StreamError::CannotResume,
                      "This is not the report of a run of method window or credit. Give the output "
                      "of stream --json of the run to be resumed, or its file from "
                      "rivulet-cli runs.",
                      file.string());
  }
  if (members.has("/rivulet_run") &&
      members.integer<int>("/rivulet_run", 1, kJsonCellMax) > kRunFormat) {
    return base::fail(StreamError::CannotResume,
                      "The run was kept by a later version of Rivulet. Use that one.",
                      file.string());
  }
  SavedRun run;
  FieldReader io(members);
  savedRunFields(io, run);
  run.file = file;
  if (!base::hasWindows(run.settings.parameters.method)) {
    members.refuse("/settings/method");
  }
  run.settings.runNumber = run.checkpoint.runNumber;
  run.settings.placePauses = run.checkpoint.pausesPlaced;
  if (!members.bad().empty()) {
    return base::fail(StreamError::CannotResume,
                      fmt::format("The file of the run is damaged: its member {} is missing or "
                                  "cannot be right. Start from the beginning.",
                                  members.bad()),
                      file.string());
  }
  return run;
}

base::Result<SavedRun> readSavedRun(const fs::path& file, const base::Budget& budget) {
  const auto json = readJson(file, budget);
  return json ? savedRunOf(*json, file) : base::fail(json.error());
}

fs::path RunStore::folderOfUser() {
  return journal::stateFolderOfUser() / "runs";
}

fs::path RunStore::folderOfJobs() {
  return journal::stateFolderOfUser() / "jobs";
}

fs::path RunStore::pathOf(const SavedRun& run) const {
  return m_folder / (run.name() + ".json");
}

base::Result<void> RunStore::save(const SavedRun& run,
                                  std::span<const gcode::StreamPoint> points) const {
  (void)base::makePrivateFolder(m_folder);  // writing says what is wrong
  const fs::path path = pathOf(run);
  // The points first: a run that is listed is complete.
  if (!points.empty()) {
    if (base::Result<void> written =
            base::writePrivateFile(pointsPathOf(path), printPoints(points));
        !written) {
      return written;
    }
  }
  const ordered_json json =
      jsonInPlaceOf(readJson(path).value_or(nlohmann::json()), run, savedRunFields);
  return base::writePrivateFile(
      path, json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n');
}

std::vector<SavedRun> RunStore::runs() const {
  std::vector<SavedRun> runs;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(m_folder, ignored)) {
    if (entry.path().extension() != ".json") {
      continue;
    }
    if (base::Result<SavedRun> run = readSavedRun(entry.path())) {
      runs.push_back(std::move(*run));
    }
  }
  std::sort(runs.begin(), runs.end(), [](const SavedRun& a, const SavedRun& b) {
    return std::pair(a.settings.origin.startedAtUtc, a.checkpoint.runNumber) >
           std::pair(b.settings.origin.startedAtUtc, b.checkpoint.runNumber);
  });
  return runs;
}

std::optional<SavedRun> RunStore::find(int runNumber) const {
  for (SavedRun& run : runs()) {
    if (run.number() == runNumber) {
      return std::move(run);
    }
  }
  return std::nullopt;
}

std::optional<SavedRun> RunStore::findJob(const streaming::RunOnControl& onControl) const {
  for (SavedRun& run : runs()) {
    // The numbers of its stretches follow each other. One that waits for its client has none yet.
    const int number = run.checkpoint.runNumber;
    const bool isThisRun =
        onControl.number == 0 ||
        (number >= onControl.number - onControl.stretch && number <= onControl.number);
    if (isThisRun && (!run.job || run.job->number == onControl.job)) {
      return std::move(run);
    }
  }
  return std::nullopt;
}

std::optional<SavedRun> RunStore::leftOn(const std::string& endpoint) const {
  for (SavedRun& run : runs()) {
    if (run.endpoint == endpoint) {
      return std::move(run);
    }
  }
  return std::nullopt;
}

std::vector<gcode::StreamPoint> RunStore::points(const SavedRun& run) const {
  const base::Result<std::string> text = base::readFile(pointsPathOf(pathOf(run)));
  return text ? parsePoints(*text) : std::vector<gcode::StreamPoint>();
}

void RunStore::remove(const SavedRun& run) const {
  std::error_code ignored;  // somebody else may have removed it
  const fs::path path = pathOf(run);
  fs::remove(path, ignored);
  fs::remove(pointsPathOf(path), ignored);
}

base::Result<void> RunKeeper::keep(const streaming::Checkpoint& checkpoint,
                                   const streaming::RunSettings& settings,
                                   std::span<const gcode::StreamPoint> points) {
  m_run.checkpoint = checkpoint;
  m_run.settings = settings;
  if (m_run.job && m_run.job->firstRun == 0) {
    m_run.job->firstRun = checkpoint.runNumber;
  }
  if (base::Result<void> saved = m_store.save(m_run, points); !saved) {
    return saved;
  }
  m_isKept = true;
  std::size_t kept = 0;
  for (const SavedRun& other : m_store.runs()) {
    const bool isThis = m_store.pathOf(other) == m_store.pathOf(m_run);
    // Once this run has its program, the cells of earlier runs on this control are gone.
    const bool isReplaced = checkpoint.granted && other.endpoint == m_run.endpoint &&
                            other.settings.parameters.baseCell == settings.parameters.baseCell &&
                            other.settings.origin.computer == settings.origin.computer;
    if (!isThis && (isReplaced || ++kept >= kRunsMax)) {
      m_store.remove(other);
    }
  }
  return {};
}

void RunKeeper::finish(const streaming::RunReport& report) {
  if (!m_isKept) {
    return;
  }
  // Of a job, what was kept last is where it goes on.
  const bool isNewer = !m_run.job && report.checkpoint;
  if (isNewer) {
    m_run.checkpoint = *report.checkpoint;
  }
  if (report.outcome == streaming::Outcome::Completed || m_run.isUntouched()) {
    m_store.remove(m_run);
    m_isKept = false;
  } else if (isNewer) {
    static_cast<void>(m_store.save(m_run, {}));  // what is there already is not wrong
  }
}

std::optional<SavedRun> RunKeeper::left() const {
  if (!m_isKept) {
    return std::nullopt;
  }
  SavedRun left = m_run;
  left.file = m_store.pathOf(m_run);
  return left;
}

base::Result<std::optional<FoundRun>> findRun(const RunStore& store, opcua::Link& link,
                                              opcua::Control& control, int baseCell,
                                              base::Duration watchFor) {
  base::Result<std::optional<streaming::RunOnControl>> found =
      streaming::findRun(link, control, baseCell, watchFor);
  if (!found) {
    return base::fail(found.error());
  }
  if (!*found) {
    return std::nullopt;
  }
  FoundRun run;
  run.onControl = std::move(**found);
  run.saved = run.onControl.job != 0 ? RunStore(RunStore::folderOfJobs()).findJob(run.onControl)
              : run.onControl.number != 0 ? store.find(run.onControl.number)
                                          : std::nullopt;
  return run;
}

std::vector<std::size_t> pointsAfterWindows(const RunStore& store, const SavedRun& run) {
  const std::vector<gcode::StreamPoint> points = store.points(run);
  return run.checkpoint.firstPoint < points.size()
             ? streaming::windowEnds(points, run.settings, run.checkpoint)
             : std::vector<std::size_t>();
}

std::string describeRun(const FoundRun& run) {
  // A job has another number in each stretch.
  const int number = run.saved ? run.saved->number() : run.onControl.number - run.onControl.stretch;
  std::string text = run.onControl.job != 0      ? fmt::format("the whole job {}", number)
                     : run.onControl.number == 0 ? "a program without a run"
                                                 : fmt::format("run {}", number);
  const std::optional<streaming::RunOrigin> origin = run.onControl.origin ? run.onControl.origin
                                                     : run.saved
                                                         ? std::optional(run.saved->settings.origin)
                                                         : std::nullopt;
  if (run.saved) {
    text += fmt::format(" of {}", run.saved->programName);
  }
  if (origin && !origin->user.empty()) {
    text += fmt::format(", started by {} on {} at {}", origin->user, origin->computer,
                        origin->startedAtUtc);
  }
  return text;
}

}  // namespace rivulet::report
