// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The history of runs on disk: what is kept is read back, the bounds hold, and what cannot be read
/// says why.

#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "report/report_json.h"
#include "report/run_history.h"
#include "support/test_program.h"

using namespace rivulet;
using nlohmann::json;
using report::ReportError;
using report::RunHistory;
namespace fs = std::filesystem;

namespace {

streaming::RunReport someReport(const std::string& startedAtUtc) {
  streaming::RunReport report;
  report.outcome = streaming::Outcome::Stopped;
  report.programName = "rows one.nc";
  report.counters = {40, 35, 30, 100};
  report.integrity.judged = true;
  report.integrity.executed = 29;
  report.integrity.repeated = 2;
  report.integrity.skipped = 1;
  report.integrity.faults = {{trace::IntegrityFault::Kind::Skipped, base::PointIndex{7}, {}}};
  report.pauses = {{base::Instant{}, std::chrono::milliseconds{40}, trace::PauseOrigin::Measured},
                   {base::Instant{std::chrono::seconds{2}}, std::chrono::milliseconds{50},
                    trace::PauseOrigin::Inferred}};
  report.duration = std::chrono::milliseconds{12'500};
  report.access.requests = 77;
  report.access.perNode = {77,
                           std::chrono::microseconds{4300},
                           std::chrono::microseconds{4100},
                           std::chrono::microseconds{6000},
                           std::chrono::microseconds{9000},
                           std::chrono::microseconds{12'000}};
  report.settings.parameters.method = base::MethodKind::Position;
  report.settings.parameters.pointsPerLoop = 5;
  report.settings.deltaMm = 0.25;
  report.settings.feedMmPerS = 12.0;
  report.settings.grouping = opcua::Grouping::Single;
  report.settings.passedBy = streaming::PassedBy::DistanceToGo;
  report.settings.origin = {"anna", "cell-pc-3", startedAtUtc};
  report.settings.resume.emplace();
  report.settings.resume->point = 11;
  report.stopConfirmedAfter = std::chrono::milliseconds{830};
  report.accessForms.emplace();
  report.accessForms->proofs = {{opcua::Grouping::ArrayCount, true, false, "no arrays"},
                                {opcua::Grouping::Single, true, true, ""}};
  report.transfer = {true, false, true};
  report.error = base::makeError(streaming::StreamError::ControlAlarm, "Alarm 12345.");
  return report;
}

streaming::RunSummary known() {
  streaming::RunSummary known;
  known.programFile = "/programs/rows one.nc";
  known.programHash = "8c2f1f0a6d3b9e47";
  known.endpoint = "opc.tcp://control:4840";
  known.toolVersion = "1.2.3";
  return known;
}

std::vector<gcode::StreamPoint> somePoints() {
  std::vector<gcode::StreamPoint> points;
  for (int i = 0; i < 20'000; ++i) {
    points.push_back({{i * 0.01, (i % 2) * 5.0, 0.0},
                      base::LineNumber{static_cast<std::uint32_t>(i + 1)},
                      i == 0 ? gcode::MoveKind::Rapid : gcode::MoveKind::Feed,
                      {}});
  }
  return points;
}

class RunHistoryTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  [[nodiscard]] fs::path folder() const {
    return fs::path(m_folder.path().toStdString()) / "history";
  }
  [[nodiscard]] RunHistory history() const { return RunHistory(folder()); }
  streaming::RunSummary add(const std::string& startedAtUtc) const {
    const auto added = history().add(someReport(startedAtUtc), known(), somePoints());
    return added ? *added : streaming::RunSummary{};
  }
  static json reportJsonOf(const fs::path& file) {
    return json::parse(base::readFile(file).value_or(""), nullptr, false);
  }

 private Q_SLOTS:
  void init() { fs::remove_all(folder()); }

  void keepsTheOverrideOfTheFeedsOfTheProgram() {
    streaming::RunReport report = someReport("2026-11-22T05:00:00Z");
    report.settings.programFeeds = gcode::ProgramFeeds{0.8, 500.0, 600.0};
    const auto added = history().add(report, known(), somePoints());
    QVERIFY(added);
    QVERIFY(history().list().runs.front().overrideFactor == 0.8);
    const auto kept = report::readFinishedRun(history().reportFile(added->id));
    QVERIFY(kept && kept->report.settings.programFeeds == report.settings.programFeeds);
  }

  void readsBackWhatItKept() {
    const streaming::RunSummary added = add("2026-11-22T05:00:00Z");
    QVERIFY(!added.id.empty());
    const auto list = history().list();
    QCOMPARE(list.runs.size(), std::size_t{1});
    QVERIFY(list.unreadable.empty());
    const streaming::RunSummary& run = list.runs.front();
    QCOMPARE(run.id, added.id);
    QCOMPARE(run.programName, std::string("rows one.nc"));
    QCOMPARE(run.programHash, known().programHash);
    QCOMPARE(run.origin.user, std::string("anna"));
    QCOMPARE(run.executed, std::size_t{29});
    QCOMPARE(run.repeated, std::size_t{2});
    QCOMPARE(run.pauses, std::size_t{2});
    QCOMPARE(run.paused, base::Duration{std::chrono::milliseconds{90}});
    QVERIFY(run.finding == streaming::RunFinding::Faulty);
    QVERIFY(!run.overrideFactor);

    const auto whole = report::readFinishedRun(history().reportFile(run.id));
    QVERIFY2(whole.has_value(), whole ? "" : whole.error().text().c_str());
    const streaming::RunReport was = someReport("2026-11-22T05:00:00Z");
    const streaming::RunReport& is = whole->report;
    QVERIFY(is.outcome == was.outcome);
    QCOMPARE(is.counters.executed, was.counters.executed);
    QCOMPARE(is.integrity.executed, was.integrity.executed);
    QCOMPARE(is.duration, was.duration);
    QCOMPARE(is.pauses.size(), was.pauses.size());
    QCOMPARE(is.pauses[1].duration, was.pauses[1].duration);
    QVERIFY(is.pauses[1].origin == was.pauses[1].origin);
    QCOMPARE(is.access.perNode.p99, was.access.perNode.p99);
    QCOMPARE(is.access.requests, was.access.requests);
    QVERIFY(is.settings.parameters.method == was.settings.parameters.method);
    QVERIFY(is.settings.passedBy == was.settings.passedBy);
    QVERIFY(is.settings.grouping == was.settings.grouping);
    QCOMPARE(is.settings.deltaMm, was.settings.deltaMm);
    QCOMPARE(is.settings.feedMmPerS, was.settings.feedMmPerS);
    QCOMPARE(is.settings.resume->point, was.settings.resume->point);
    QCOMPARE(*is.stopConfirmedAfter, *was.stopConfirmedAfter);
    QCOMPARE(is.accessForms->proofs.size(), std::size_t{2});
    QCOMPARE(is.accessForms->proofs[0].why, std::string("no arrays"));
    QVERIFY(*is.transfer == *was.transfer);
    QVERIFY(is.error.code == streaming::StreamError::ControlAlarm);
    QCOMPARE(is.error.message, std::string("Alarm 12345."));
  }

  void keepsTheShapeOfThePathInFewPoints() {
    const streaming::RunSummary added = add("2026-11-22T05:00:00Z");
    const auto whole = report::readFinishedRun(history().reportFile(added.id));
    QVERIFY(whole);
    QVERIFY(whole->sketch.size() > 100);
    QVERIFY(whole->sketch.size() <= RunHistory::kSketchPointsMax);
    QCOMPARE(whole->sketch.front().positionMm, somePoints().front().positionMm);
    QCOMPARE(whole->sketch.back().positionMm, somePoints().back().positionMm);
    QVERIFY(whole->sketch.front().isRapid && !whole->sketch.back().isRapid);
  }

  void listsTheNewestFirst() {
    add("2026-11-22T05:00:00Z");
    add("2026-11-22T07:00:00Z");
    add("2026-11-22T06:00:00Z");
    add("2026-11-22T06:00:00Z");  // in the same second
    const auto list = history().list();
    QCOMPARE(list.runs.size(), std::size_t{4});
    QCOMPARE(list.runs[0].origin.startedAtUtc, std::string("2026-11-22T07:00:00Z"));
    QCOMPARE(list.runs[3].origin.startedAtUtc, std::string("2026-11-22T05:00:00Z"));
  }

  void makesALostIndexAgain() {
    const streaming::RunSummary added = add("2026-11-22T05:00:00Z");
    QVERIFY(fs::remove(folder() / (added.id + ".index.json")));
    for (int i = 0; i < 2; ++i) {
      const auto list = history().list();
      QCOMPARE(list.runs.size(), std::size_t{1});
      QCOMPARE(list.runs.front().id, added.id);
      QCOMPARE(list.runs.front().skipped, std::size_t{1});
      QVERIFY(fs::exists(folder() / (added.id + ".index.json")));
    }
  }

  /// Two programs may ask at once, before either has written anything.
  void givesNoNameTwice() {
    const auto first = history().newRecording("rows one.nc", "2026-11-22T05:00:00Z");
    const auto second = history().newRecording("rows one.nc", "2026-11-22T05:00:00Z");
    QVERIFY(first && second);
    QVERIFY(*first != *second);
  }

  void removesTheOldestBeyondTheNumber() {
    QVERIFY(history().setLimits({2, 1'000'000'000}));
    add("2026-11-22T05:00:00Z");
    add("2026-11-22T06:00:00Z");
    add("2026-11-22T07:00:00Z");
    const auto list = history().list();
    QCOMPARE(list.runs.size(), std::size_t{2});
    QCOMPARE(list.runs[1].origin.startedAtUtc, std::string("2026-11-22T06:00:00Z"));
    QVERIFY(history().setLimits({1, 1'000'000'000}));
    QCOMPARE(history().list().runs.size(), std::size_t{1});
    QCOMPARE(history().limits().runsMax, std::size_t{1});
    const fs::path file = folder() / "limits.json";
    auto later = nlohmann::json::parse(base::readFile(file).value());
    later["days_max"] = 30;
    QVERIFY(base::writeFile(file, later.dump()).has_value());
    QVERIFY(history().setLimits({3, 1'000'000'000}));
    later["runs_max"] = 3;
    QVERIFY(nlohmann::json::parse(base::readFile(file).value()) == later);
  }

  /// Recordings count and go with their runs, unless the user named the file.
  void removesTheOldestBeyondTheSize() {
    const auto addRecorded = [this](const std::string& startedAtUtc, bool owns) {
      const auto file = history().newRecording("rows one.nc", startedAtUtc);
      if (!file || !base::writeFile(*file, std::string(1'000'000, 'x'))) {
        return fs::path();
      }
      streaming::RunSummary summary = known();
      summary.recording = file->string();
      summary.ownsRecording = owns;
      const auto added = history().add(someReport(startedAtUtc), summary, {});
      return added ? *file : fs::path();
    };
    QVERIFY(history().setLimits({100, 1'500'000}));
    const fs::path own = addRecorded("2026-11-22T05:00:00Z", true);
    const fs::path named = addRecorded("2026-11-22T06:00:00Z", false);
    QVERIFY(fs::exists(own) && fs::exists(named));
    QCOMPARE(history().list().runs.size(), std::size_t{2});
    const fs::path newest = addRecorded("2026-11-22T07:00:00Z", true);
    const auto list = history().list();
    QCOMPARE(list.runs.size(), std::size_t{2});
    QVERIFY(!fs::exists(own));
    QVERIFY(fs::exists(named) && fs::exists(newest));
    // The one that has just been made stays even if it is too large alone.
    QVERIFY(history().setLimits({100, 10}));
    const fs::path large = addRecorded("2026-11-22T08:00:00Z", true);
    QCOMPARE(history().list().runs.size(), std::size_t{1});
    QVERIFY(fs::exists(large));
  }

  /// What `stream --json` printed before there was a history.
  void opensAReportOfAnEarlierVersion() {
    json old = json::parse(report::runJson(someReport("2026-11-22T05:00:00Z")).dump());
    old["endpoint"] = "opc.tcp://control:4840";
    old.erase("out_of_order");
    const auto run = report::finishedRunOf(old, "old.json");
    QVERIFY2(run.has_value(), run ? "" : run.error().text().c_str());
    QCOMPARE(run->summary.programName, std::string("rows one.nc"));
    QCOMPARE(run->summary.executed, std::size_t{30});
    QCOMPARE(run->summary.endpoint, std::string("opc.tcp://control:4840"));
    QVERIFY(run->sketch.empty());
  }

  void saysWhyAFileIsNotRead() {
    const auto codeOf = [](const json& json) {
      const auto run = report::finishedRunOf(json, "file.json");
      return run ? std::error_code() : run.error().code;
    };
    QVERIFY(codeOf(json::parse("{]", nullptr, false)) == ReportError::NotAReport);
    QVERIFY(codeOf(json::array()) == ReportError::NotAReport);
    QVERIFY(codeOf({{"programs", 3}}) == ReportError::NotAReport);
    const streaming::RunSummary added = add("2026-11-22T05:00:00Z");
    json newer = reportJsonOf(history().reportFile(added.id));
    newer["rivulet_finished_run"] = 2;
    QVERIFY(codeOf(newer) == ReportError::NewerVersion);
    // In the history such a file is not hidden.
    QVERIFY(base::writeFile(history().reportFile(added.id), newer.dump()));
    QVERIFY(fs::remove(folder() / (added.id + ".index.json")));
    const auto list = history().list();
    QVERIFY(list.runs.empty());
    QCOMPARE(list.unreadable.size(), std::size_t{1});
    QVERIFY(list.unreadable.front().error.code == ReportError::NewerVersion);
  }

  /// Each member in turn is something else: refused or read, but never a crash.
  void survivesAnyMember() {
    const streaming::RunSummary added = add("2026-11-22T05:00:00Z");
    json good = reportJsonOf(history().reportFile(added.id));
    good["sketch"] = {good["sketch"][0]};
    const json flat = good.flatten();
    QVERIFY(flat.size() > 60);
    const std::vector<json> others{nullptr, true,           -1.0,          1e300,
                                   "x",     json::object(), json::array(), 0.5};
    int refused = 0;
    for (const auto& [at, value] : flat.items()) {
      for (const json& other : others) {
        json bad = good;
        bad[json::json_pointer(at)] = other;
        const auto run = report::finishedRunOf(bad, "bad.json");
        refused += run ? 0 : 1;
        if (!run) {
          QVERIFY(!run.error().message.empty());
        }
      }
    }
    QVERIFY(refused > 100);
  }
};

}  // namespace

RIVULET_TEST(RunHistoryTest)
#include "tst_run_history.moc"
