// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Runs on disk: what is written is read back, and nothing that may stand in such a file ends the
/// program.

#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "report/report_json.h"
#include "report/run_store.h"
#include "run/run_record.h"
#include "streaming/recovery/resume.h"
#include "support/test_program.h"

using namespace rivulet;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

report::SavedRun someRun() {
  report::SavedRun run;
  run.programName = "rows one.nc";
  run.programFile = "/programs/rows one.nc";
  run.endpoint = "opc.tcp://control:4840";
  run.toolVersion = "1.2.3";
  run.recording = "run.rivulet";
  run.command = {"rivulet-cli", "stream", "rows one.nc"};
  run.reading.dialect = gcode::Dialect::LinuxCnc;
  run.reading.accepted = {"M700", "G187"};
  run.reading.centres = gcode::CentreReading::Absolute;
  run.reading.chordToleranceMm = 0.02;
  run.settings.origin = {"anna", "cell-pc-3", "2026-11-22T05:00:00Z"};
  run.settings.parameters.method = base::MethodKind::Credit;
  run.settings.parameters.pointsPerLoop = 4;
  run.settings.parameters.windows = 3;
  run.settings.parameters.baseCell = 20;
  run.settings.parameters.slotStride = 6;
  run.settings.parameters.rParameterCount = 200;
  run.settings.parameters.windowsAhead = 2;
  run.settings.parameters.slowDown = false;
  run.settings.parameters.rotaryAxes = {false, false, false};
  run.checkpoint.runNumber = 123456;
  run.checkpoint.firstPoint = 17;
  run.checkpoint.startMm = {1.5, -2.25, 300.125};
  run.checkpoint.startDeg = {0.0, 0.0, 45.5};
  run.checkpoint.granted = true;
  run.checkpoint.pausesPlaced = false;
  run.checkpoint.pointCount = 3;
  run.checkpoint.pointsHash = 0xFEDCBA9876543210ULL;
  return run;
}

std::vector<gcode::StreamPoint> somePoints() {
  return {{{1.0, 2.0, 3.0}, base::LineNumber{4}, gcode::MoveKind::Rapid, {}},
          {{0.1, -0.2, 1e-9}, base::LineNumber{5}, gcode::MoveKind::Feed, {1.5, 0.0, -90.0}},
          {{7.0, 8.0, 9.0}, base::LineNumber{6}, gcode::MoveKind::ArcPiece, {}}};
}

/// Every place in a JSON text, the members of lists included.
void collect(const json& value, const json::json_pointer& at,
             std::vector<json::json_pointer>& out) {
  out.push_back(at);
  if (value.is_object()) {
    for (const auto& item : value.items()) {
      collect(item.value(), at / item.key(), out);
    }
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      collect(value[i], at / i, out);
    }
  }
}

}  // namespace

class TestRunStore : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  [[nodiscard]] report::RunStore store() const {
    return report::RunStore(fs::path(m_folder.path().toStdString()) / "runs");
  }
  [[nodiscard]] json saved() const {
    const auto text = base::readFile(store().pathOf(someRun()));
    return text ? json::parse(*text) : json();
  }

 private Q_SLOTS:
  void init() {
    fs::remove_all(fs::path(m_folder.path().toStdString()) / "runs");
    QVERIFY(store().save(someRun(), somePoints()).has_value());
  }

  /// A job that goes on takes the place of the one that was left, once it streams: a start that
  /// does not come about loses nothing.
  void whatWasLeftStaysUntilSomethingStreams() {
    qputenv("XDG_STATE_HOME", m_folder.path().toUtf8());
    const report::RunStore jobs(report::RunStore::folderOfJobs());
    QVERIFY(jobs.save(someRun(), somePoints()).has_value());
    run::RunFacts facts;
    facts.kind = run::RunKind::WholeJob;
    facts.programName = "rows one.nc";
    facts.endpoint = someRun().endpoint;
    facts.startedAtUtc = "2026-11-22T06:00:00Z";
    facts.job = report::SavedJob{4711, 0, streaming::JobRest{3, {}, base::Vec3{1.0, 2.0, 3.0}}};
    run::RunRecord record(facts);
    QVERIFY(record.open().has_value());
    QVERIFY(jobs.leftOn(facts.endpoint).has_value());
    streaming::Checkpoint checkpoint;
    checkpoint.runNumber = 200;
    const auto& settings = someRun().settings;
    QVERIFY(record.keeper()->keep(checkpoint, settings, {}).has_value());
    QCOMPARE(jobs.runs().size(), std::size_t{2});
    checkpoint.granted = true;
    QVERIFY(record.keeper()->keep(checkpoint, settings, {}).has_value());
    const auto left = jobs.runs();
    QCOMPARE(left.size(), std::size_t{1});
    QVERIFY(left.front().job && left.front().job->rest);
    QCOMPARE(left.front().job->number, 4711);
    QCOMPARE(left.front().job->rest->part, std::size_t{3});
    QVERIFY(left.front().job->rest->toolMm == (base::Vec3{1.0, 2.0, 3.0}));
    // However far it comes, it stays in its file.
    checkpoint.runNumber = 203;
    QVERIFY(record.keeper()->keep(checkpoint, settings, {}).has_value());
    QCOMPARE(jobs.runs().size(), std::size_t{1});
    QCOMPARE(jobs.runs().front().file, left.front().file);
    QVERIFY(record.left() && record.left()->number() == 200);
  }

  /// However its windows were cut: with pauses placed, the rapid ends the first one early.
  void countsPointsAsTheWindowsWereCut() {
    report::SavedRun run = someRun();
    run.checkpoint.firstPoint = 1;
    std::vector<gcode::StreamPoint> points;
    for (std::size_t i = 0; i < 10; ++i) {
      const auto kind = i == 3 ? gcode::MoveKind::Rapid : gcode::MoveKind::Feed;
      points.push_back({{static_cast<double>(i), 0.0, 0.0}, base::LineNumber{1}, kind, {}});
    }
    const auto ends = [&](bool arePlaced) {
      run.checkpoint.pausesPlaced = arePlaced;
      // As in a run that was not read from its file: it may be placed or not by its settings.
      run.settings.placePauses = true;
      return store().save(run, points) ? report::pointsAfterWindows(store(), run)
                                       : std::vector<std::size_t>();
    };
    QCOMPARE(ends(false), (std::vector<std::size_t>{1, 5, 9, 10}));
    QCOMPARE(ends(true), (std::vector<std::size_t>{1, 4, 6, 10}));
    // And of one that was.
    run.checkpoint.pausesPlaced = false;
    QVERIFY(store().save(run, points).has_value());
    const auto read = store().find(run.checkpoint.runNumber);
    QVERIFY(read);
    QCOMPARE(report::pointsAfterWindows(store(), *read), (std::vector<std::size_t>{1, 5, 9, 10}));
    // Nothing is known of a run whose points are not kept.
    store().remove(run);
    QVERIFY(report::pointsAfterWindows(store(), run).empty());
  }

  void readsWhatWasSaved() {
    QCOMPARE(store().pathOf(someRun()).filename().string(), std::string("rows-one.nc-123456.json"));
    const auto runs = store().runs();
    QCOMPARE(runs.size(), std::size_t{1});
    const report::SavedRun& run = runs.front();
    const report::SavedRun expected = someRun();
    QCOMPARE(run.programName, expected.programName);
    QCOMPARE(run.programFile, expected.programFile);
    QCOMPARE(run.endpoint, expected.endpoint);
    QCOMPARE(run.recording, expected.recording);
    QVERIFY(run.command == expected.command);
    QVERIFY(run.reading.dialect == expected.reading.dialect);
    QVERIFY(run.reading.accepted == expected.reading.accepted);
    QVERIFY(run.reading.centres == expected.reading.centres);
    QCOMPARE(run.reading.chordToleranceMm, expected.reading.chordToleranceMm);
    QVERIFY(run.settings.origin == expected.settings.origin);
    const templates::TemplateParameters& parameters = run.settings.parameters;
    QCOMPARE(run.settings.feedMmPerS, expected.settings.feedMmPerS);
    QCOMPARE(parameters.method, base::MethodKind::Credit);
    QCOMPARE(parameters.pointsPerLoop, 4);
    QCOMPARE(parameters.windows, 3);
    QCOMPARE(parameters.baseCell, 20);
    QCOMPARE(parameters.slotStride, 6);
    QCOMPARE(parameters.rParameterCount, 200);
    QCOMPARE(parameters.windowsAhead, 2);
    QVERIFY(!parameters.slowDown);
    QCOMPARE(run.checkpoint.runNumber, 123456);
    QCOMPARE(run.checkpoint.firstPoint, std::size_t{17});
    QVERIFY(run.checkpoint.startMm == expected.checkpoint.startMm);
    QVERIFY(run.checkpoint.startDeg == expected.checkpoint.startDeg);
    QVERIFY(run.checkpoint.granted);
    QVERIFY(!run.checkpoint.pausesPlaced);
    QCOMPARE(run.checkpoint.pointCount, std::size_t{3});
    QCOMPARE(run.checkpoint.pointsHash, expected.checkpoint.pointsHash);
    const auto points = store().points(run);
    QCOMPARE(streaming::hashOfPoints(points), streaming::hashOfPoints(somePoints()));
    QCOMPARE(points[1].line.value, 5U);
    QVERIFY(store().find(123456).has_value());
    QVERIFY(!store().find(1).has_value());
    QVERIFY(store().leftOn("opc.tcp://control:4840").has_value());
    QVERIFY(!store().leftOn("opc.tcp://another:4840").has_value());
    store().remove(run);
    QVERIFY(fs::is_empty(fs::path(m_folder.path().toStdString()) / "runs"));
  }

  /// Each member in turn is missing, or has another type, or an impossible value.
  void readsAnything() {
    const json good = saved();
    QVERIFY(report::savedRunOf(good, {}).has_value());
    std::vector<json::json_pointer> places;
    collect(good, json::json_pointer(), places);
    const std::vector<json> values{nullptr,
                                   true,
                                   "text",
                                   "",
                                   -1,
                                   0,
                                   1.5,
                                   1e300,
                                   -1e300,
                                   1e9,
                                   2147483648LL,
                                   json::array(),
                                   json::array({1, "a", nullptr}),
                                   json::object(),
                                   json{{"0", 1}},
                                   std::string(100000, 'x')};
    std::size_t tried = 0;
    for (const json::json_pointer& place : places) {
      for (const json& value : values) {
        json bad = good;
        bad[place] = value;
        const auto run = report::savedRunOf(bad, "file");
        // What is accepted can be used.
        if (run) {
          QVERIFY2(templates::requireProgram(run->settings.parameters).has_value(),
                   place.to_string().c_str());
          QVERIFY(run->checkpoint.runNumber >= 1 && run->checkpoint.runNumber <= 999'999);
        } else {
          QVERIFY(run.error().code == streaming::StreamError::CannotResume);
        }
        ++tried;
      }
      if (!place.empty()) {
        json less = good;
        json& parent = less[place.parent_pointer()];
        if (parent.is_object()) {
          parent.erase(place.back());
          static_cast<void>(report::savedRunOf(less, "file"));
          ++tried;
        }
      }
    }
    QVERIFY(tried > 500);
    for (const char* text : {"", "[]", "{", "null", "3", "\"a\"", "{\"checkpoint\": 3}"}) {
      QVERIFY(!report::savedRunOf(json::parse(text, nullptr, false), {}).has_value());
    }
  }

  /// A later version wrote the record and this one writes it again: nothing of it is lost, and
  /// nothing that is over comes back.
  void keepsWhatALaterVersionWrote() {
    const fs::path path = store().pathOf(someRun());
    json later = saved();
    later["shift"] = "night";
    later["reading"]["tool_table"] = {{"7", "END_MILL"}};
    later["settings"]["damping"] = 0.5;
    later["settings"]["program_feeds"] = {
        {"override", 1.0}, {"rapid_mm_per_s", 100.0}, {"limit_mm_per_s", 50.0}, {"ramp", 2.0}};
    later["checkpoint"]["load"] = json::array({1, 2});
    QVERIFY(base::writeFile(path, later.dump()).has_value());
    report::SavedRun run = *report::readSavedRun(path);
    run.checkpoint.firstPoint = 20;
    run.settings.programFeeds.reset();
    QVERIFY(store().save(run, {}).has_value());
    json expected = later;
    expected["checkpoint"]["first_point"] = 20;
    expected["settings"].erase("program_feeds");
    QCOMPARE(saved(), expected);
    QVERIFY(report::readSavedRun(path).has_value());
  }

  /// How the text was read is not guessed: with another meaning of it, the run would go on on
  /// another path.
  void anUnknownReadingIsRefused() {
    for (const char* name : {"dialect", "centres", "units", "no_point", "settings"}) {
      json later = saved();
      later["reading"][name] = "of a later version";
      QVERIFY2(!report::savedRunOf(later, {}), name);
    }
  }

  /// A file that is cut off or damaged is left out of the list, and its points are not used.
  void damageIsNoticed() {
    const fs::path path = store().pathOf(someRun());
    const std::string text = *base::readFile(path);
    QVERIFY(base::writeFile(path, text.substr(0, text.size() / 2)).has_value());
    QVERIFY(store().runs().empty());
    fs::path points = path;
    points.replace_extension(".points");
    const std::string all = *base::readFile(points);
    QVERIFY(base::writeFile(points, all.substr(0, all.size() - 3)).has_value());
    QVERIFY(store().points(someRun()).empty());
    QVERIFY(!report::readSavedRun("/dev/null").has_value());
    QVERIFY(!report::readSavedRun("/").has_value());
    QVERIFY(!report::readSavedRun("/dev/zero").has_value());
  }

  /// A run that completed is forgotten; one that was left stays; a later run on the same control
  /// takes its place.
  void keepsWhatCanBeResumed() {
    store().remove(someRun());
    const auto keepRun = [this](int number, const char* endpoint, streaming::Outcome outcome,
                                bool granted = true, std::size_t firstPoint = 0) {
      report::SavedRun run = someRun();
      run.endpoint = endpoint;
      report::RunKeeper keeper(store(), run);
      streaming::Checkpoint checkpoint = run.checkpoint;
      checkpoint.runNumber = number;
      checkpoint.granted = false;
      checkpoint.firstPoint = firstPoint;
      if (!keeper.keep(checkpoint, run.settings, somePoints()) || !keeper.left()) {
        qFatal("the store cannot be written");
      }
      checkpoint.granted = granted;
      if (granted && !keeper.keep(checkpoint, run.settings, {})) {
        qFatal("the store cannot be written");
      }
      streaming::RunReport report;
      report.outcome = outcome;
      report.checkpoint = checkpoint;
      keeper.finish(report);
    };
    keepRun(1, "opc.tcp://a", streaming::Outcome::Completed);
    QVERIFY(store().runs().empty());
    keepRun(2, "opc.tcp://a", streaming::Outcome::Failed);
    keepRun(3, "opc.tcp://b", streaming::Outcome::Stopped);
    QCOMPARE(store().runs().size(), std::size_t{2});
    keepRun(4, "opc.tcp://a", streaming::Outcome::Stopped, false);  // nothing moved for it
    QCOMPARE(store().runs().size(), std::size_t{2});
    QVERIFY(store().find(2).has_value());
    // Part of it had been executed when it was resumed.
    keepRun(5, "opc.tcp://d", streaming::Outcome::Stopped, false, 7);
    QVERIFY(!store().find(5)->checkpoint.granted);
    keepRun(5, "opc.tcp://a", streaming::Outcome::Failed);
    QVERIFY(!store().find(2).has_value());
    QVERIFY(store().find(3).has_value());
    QCOMPARE(store().points(*store().find(5)).size(), std::size_t{3});
    for (int number = 10; number < 60; ++number) {
      keepRun(number, ("opc.tcp://c" + std::to_string(number)).c_str(), streaming::Outcome::Failed);
    }
    QVERIFY(store().runs().size() <= 20);
    QVERIFY(store().find(59).has_value());
  }

  void whatCannotBeWrittenIsSaid() {
    const report::RunStore nowhere("/proc/no-such-folder");
    QVERIFY(nowhere.save(someRun(), somePoints()).error().code == base::FileError::NotWritable);
    QVERIFY(nowhere.runs().empty());
  }
};

RIVULET_TEST(TestRunStore)
#include "tst_run_store.moc"
