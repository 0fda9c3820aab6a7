// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The file of a machine: its calibration and its test of method credit, what the files of earlier
/// versions had, and that nothing else in it is lost.

#include <QTemporaryDir>
#include <QtTest>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/file.h"
#include "job/plan.h"
#include "report/calibration_json.h"
#include "report/control_test_json.h"
#include "report/known_machine.h"
#include "report/load_machine.h"
#include "report/machine_store.h"
#include "streaming/run/run.h"
#include "support/test_program.h"

using namespace rivulet;
using report::MachineStore;
using streaming::CalibrationRecord;
using streaming::CreditTest;
using streaming::MachineFileError;

namespace {

const std::string kEndpoint = "opc.tcp://192.168.214.1:4840";
const opcua::ServerIdentity kServer{"urn:control", "Control", "4.95", "7"};

CreditTest makeTest(bool passed = true) {
  CreditTest test;
  test.endpoint = kEndpoint;
  test.server = kServer;
  test.testedAtUtc = "2026-05-04T09:30:00Z";
  test.toolVersion = "0.1.0";
  test.result.checks = {{"answers-while-busy", passed, "20 of 20"}, {"buffer-level", true, "yes"}};
  test.result.asked = 20;
  test.result.answered = passed ? 20 : 0;
  test.result.slowestAnswer = std::chrono::milliseconds{42};
  return test;
}

CalibrationRecord makeRecord() {
  CalibrationRecord record;
  record.endpoint = kEndpoint;
  record.server = kServer;
  record.measuredAtUtc = "2026-05-03T08:00:00Z";
  record.toolVersion = "0.1.0";
  record.calibration.plan.firstCell = 50;
  record.calibration.plan.lastCell = 99;
  for (const bool write : {false, true}) {
    streaming::AccessFit fit;
    fit.write = write;
    fit.overheadMs = 1.0;
    fit.nodeMs = 4.25;
    record.calibration.fits.push_back(fit);
  }
  return record;
}

std::string textOf(const nlohmann::ordered_json& json) {
  return json.dump(2) + "\n";
}

}  // namespace

class TestMachineStore : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
  report::MachineFolders m_folders;

  [[nodiscard]] MachineStore store() const { return MachineStore(m_folders); }
  void write(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::create_directories(path.parent_path());
    QVERIFY(base::writeFile(path, text).has_value());
  }

 private Q_SLOTS:
  void init() {
    m_folder = std::make_unique<QTemporaryDir>();
    const std::filesystem::path root = m_folder->path().toStdString();
    m_folders = report::MachineFolders::below(root / "data", root / "config");
  }

  void oneFileKeepsBothFacts() {
    QVERIFY(!store().calibration(kEndpoint, kServer)->has_value());
    QVERIFY(!store().creditTest(kEndpoint, kServer)->has_value());
    QVERIFY(store().save(makeRecord()).has_value());
    QVERIFY(store().save(makeTest()).has_value());
    const auto record = store().calibration(kEndpoint, kServer);
    QVERIFY(record && *record);
    QCOMPARE(report::calibrationJson(**record).dump(),
             report::calibrationJson(makeRecord()).dump());
    const auto test = store().creditTest(kEndpoint, kServer);
    QVERIFY(test && *test);
    QCOMPARE(report::testJson(**test).dump(), report::testJson(makeTest()).dump());
    QVERIFY(!store().feedTest(kEndpoint, kServer).value());
    for (const bool moves : {false, true}) {
      streaming::FeedTest made{kEndpoint, kServer, "2026-05-04T09:30:00Z", "0.1.0", {}};
      made.result.checks = {{"actions-follow", true, "yes"}};
      made.result.move = moves ? std::optional(streaming::AirMove{2, -20.0, 400.0}) : std::nullopt;
      made.result.braking = std::chrono::milliseconds{moves ? 60 : 0};
      QVERIFY(store().save(made).has_value());
      const auto feed = store().feedTest(kEndpoint, kServer);
      QVERIFY(feed && *feed);
      QVERIFY((*feed)->result.move == made.result.move);
      QCOMPARE((*feed)->result.proves(), moves);
      QCOMPARE(report::testJson(**feed).dump(), report::testJson(made).dump());
    }
    // A move that says nothing certain is none: the test has not been passed.
    nlohmann::ordered_json damaged = report::testJson(**store().feedTest(kEndpoint, kServer));
    damaged["air_move"]["axis"] = "X";
    QVERIFY(!report::feedTestOf(damaged).result.passed());
    const std::filesystem::path path = store().pathOf(kEndpoint, kServer);
    QVERIFY(std::filesystem::exists(path));
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(path.parent_path())) {
      files += entry.path().extension() == ".json" ? 1 : 0;
    }
    QCOMPARE(files, std::size_t{1});
    // `feasibility --calibration` takes the file of a machine as well.
    QVERIFY(report::readCalibration(path).has_value());
  }

  /// What a test of whole jobs says, and to which blocks it says so.
  void theTestOfJobsReleasesWhatItTried() {
    QVERIFY(!store().jobTest(kEndpoint, kServer).value());
    streaming::JobTest made{kEndpoint, kServer, "2026-05-04T09:30:00Z", "0.1.0", {}};
    made.result.checks = {{"hand-over", true, "yes"}};
    made.result.move = {0, 20.0, 400.0};
    made.result.tried = {
        {"S500 M3", {job::NativeReason::Spindle}, streaming::Witness::Control, "spindle 0 → 500."},
        {"M27", {job::NativeReason::Other}, streaming::Witness::Nobody, "nothing"}};
    QVERIFY(store().save(made).has_value());
    const auto kept = store().jobTest(kEndpoint, kServer);
    QVERIFY(kept && *kept);
    QVERIFY((*kept)->result.tried == made.result.tried);
    QCOMPARE(report::testJson(**kept).dump(), report::testJson(made).dump());
    const auto planOf = [](const char* text) {
      gcode::LoadOptions options;
      options.dialect = gcode::Dialect::Sinumerik;
      return *job::makePlan("PART.MPF", text, options);
    };
    const job::Plan spindle = planOf("G90 G1 X5 F100\nS900 M4\nG4 F1\nX9\nM30\n");
    const job::Plan other = planOf("G90 G1 X5 F100\nS900 M4\nM27\nX9\nM30\n");
    const auto release = store().jobRelease(kEndpoint, kServer, false);
    QVERIFY(release && release->runsJobs());
    QVERIFY(release->require(spindle).has_value());
    const auto refused = release->require(other);
    QVERIFY(!refused && refused.error().code == streaming::StreamError::NotCommissioned);
    QVERIFY2(refused.error().message.starts_with("Line 3: \"M27\" (other)"),
             refused.error().message.c_str());
    // A virtual machine needs no test; another version of the server needs another one.
    QVERIFY(store().jobRelease(kEndpoint, kServer, true)->require(other).has_value());
    opcua::ServerIdentity newer = kServer;
    newer.softwareVersion += "1";
    const auto outdated = store().jobRelease(kEndpoint, newer, false);
    QVERIFY(outdated && !outdated->runsJobs() && !outdated->require(spindle));
    // A witness or a kind that says nothing certain: the test has not been passed.
    for (const auto& [key, value] :
         {std::pair<const char*, nlohmann::ordered_json>{"seen_by", "somebody"},
          {"kinds", nlohmann::ordered_json::array({"spindles"})}}) {
      nlohmann::ordered_json damaged = report::testJson(made);
      damaged["tried"][0][key] = value;
      QVERIFY2(!report::jobTestOf(damaged).result.passed(), key);
    }
    // Whoever fails later runs none any more.
    made.result.checks[0].passed = false;
    QVERIFY(store().save(made).has_value());
    QVERIFY(!store().jobRelease(kEndpoint, kServer, false)->runsJobs());
  }

  void whatSeveralProgramsSaveAtATimeStays() {
    // Each fact is of another program: each reads the file, changes its own part, writes the file.
    constexpr int kRounds = 20;
    for (int round = 0; round < kRounds; ++round) {
      init();
      std::thread calibrating([this] { static_cast<void>(store().save(makeRecord())); });
      std::thread testing([this] { static_cast<void>(store().save(makeTest())); });
      calibrating.join();
      testing.join();
      QVERIFY(store().calibration(kEndpoint, kServer)->has_value());
      QVERIFY(store().creditTest(kEndpoint, kServer)->has_value());
    }
  }

  void whatItDoesNotKnowStays() {
    const std::filesystem::path path = store().pathOf(kEndpoint, kServer);
    write(path, R"({"rivulet_machine":1,"x":[1,2],"credit_test":{"passed":true}})");
    QVERIFY(store().save(makeTest(false)).has_value());
    const auto json = nlohmann::json::parse(base::readFile(path).value());
    QCOMPARE(json["x"].size(), std::size_t{2});
    QVERIFY(!json["credit_test"]["passed"].get<bool>());
  }

  /// Limits that are entered anew leave alone what a later version has entered besides.
  void whatALaterVersionEnteredStays() {
    auto profile = report::profileOfPreset("dmu75-5axis").value();
    profile.endpoint = kEndpoint;
    profile.server = kServer;
    QVERIFY(store().save(profile).has_value());
    const std::filesystem::path path = store().pathOf(kEndpoint, kServer);
    auto json = nlohmann::json::parse(base::readFile(path).value());
    json["profile"]["coolant_bar_max"] = 70;
    json["profile"]["axes"]["X"]["backlash_mm"] = 0.002;
    write(path, json.dump());
    profile.rapidMmPerS = 123.0;
    QVERIFY(store().save(profile).has_value());
    json["profile"]["rapid_mm_per_s"] = 123.0;
    QVERIFY(nlohmann::json::parse(base::readFile(path).value()) == json);
  }

  void numbersThatCannotBeAreLeftOut() {
    write(store().pathOf(kEndpoint, kServer),
          R"({"rivulet_machine":1,"credit_test":{"asked":1e300,"slowest_answer_ms":1e300}})");
    const auto test = store().creditTest(kEndpoint, kServer);
    QVERIFY(test && *test);
    QCOMPARE((*test)->result.asked, 0);
    QCOMPARE((*test)->result.slowestAnswer, base::Duration{});
  }

  /// A calibration and a profile that an earlier version left in two folders, under other names.
  void factsOfEarlierVersionsAreFound() {
    write(m_folders.earlierCalibrations / "opc.tcp-192.168.214.1-4840-0123456789abcdef.json",
          textOf(report::calibrationJson(makeRecord())));
    CalibrationRecord other = makeRecord();
    other.server.applicationUri = "urn:other";
    write(m_folders.earlierCalibrations / "other.json", textOf(report::calibrationJson(other)));
    write(m_folders.earlierCalibrations / "damaged.json", "{");
    const nlohmann::ordered_json profile{{"rivulet_machine_profile", 1},
                                         {"credit_test", report::testJson(makeTest())},
                                         {"note", "by the window"}};
    write(m_folders.earlierProfiles / "opc.tcp-192.168.214.1-4840-0123456789abcdef.json",
          textOf(profile));
    QVERIFY(store().calibration(kEndpoint, kServer)->has_value());
    QVERIFY(store().creditTest(kEndpoint, kServer)->has_value());
    QVERIFY(!std::filesystem::exists(store().pathOf(kEndpoint, kServer)));

    // Saving one fact takes the other over; from then on the file of the machine counts.
    QVERIFY(store().save(makeTest(false)).has_value());
    QVERIFY(!(*store().creditTest(kEndpoint, kServer))->result.passed());
    QVERIFY(store().calibration(kEndpoint, kServer)->has_value());
    const auto json =
        nlohmann::json::parse(base::readFile(store().pathOf(kEndpoint, kServer)).value());
    QCOMPARE(json["note"], "by the window");
    QVERIFY(!json.contains("rivulet_machine_profile"));
    std::filesystem::remove_all(m_folders.earlierCalibrations);
    QVERIFY(store().calibration(kEndpoint, kServer)->has_value());
  }

  void machinesAreToldApart() {
    QVERIFY(store().save(makeRecord()).has_value());
    QVERIFY(!store().calibration("opc.tcp://192.168.214.2:4840", kServer)->has_value());
    opcua::ServerIdentity other = kServer;
    other.applicationUri = "urn:other";
    QVERIFY(!store().calibration(kEndpoint, other)->has_value());
    // Another version of the same machine: found, and known to be outdated.
    other = kServer;
    QVERIFY(!(*store().calibration(kEndpoint, other))->isOutdated(other));
    other.softwareVersion = "4.96";
    QVERIFY((*store().calibration(kEndpoint, other))->isOutdated(other));
  }

  /// Nothing that is said beside the checks makes a test a passed one.
  void onlyChecksCount() {
    for (const char* section :
         {R"({"passed":true})", R"({"passed":true,"checks":[]})", R"({"checks":"all"})",
          R"({"checks":[{"name":"a","passed":"yes"}]})", R"({"checks":[7],"server":3})",
          R"({"checks":[{"name":"a","passed":true,"message":5},{"name":"b","passed":false}]})"}) {
      const CreditTest test = report::creditTestOf(nlohmann::ordered_json::parse(section));
      QVERIFY2(!test.result.passed(), section);
    }
  }

  void otherFilesAreRefusedAndKept() {
    const std::filesystem::path path = store().pathOf(kEndpoint, kServer);
    for (const char* text : {"no json", "[]", "{}", R"({"rivulet_machine":"1"})"}) {
      write(path, text);
      const auto test = store().creditTest(kEndpoint, kServer);
      QVERIFY(!test && test.error().code == MachineFileError::NotAMachineFile);
      QVERIFY(!store().calibration(kEndpoint, kServer));
      QVERIFY(!store().save(makeTest()));
      QCOMPARE(base::readFile(path).value(), std::string(text));
    }
    write(path, R"({"rivulet_machine":2})");
    const auto newer = store().creditTest(kEndpoint, kServer);
    QVERIFY(!newer && newer.error().code == MachineFileError::OtherVersion);
  }

  /// Nothing is deleted, and the machine is new at the next connection.
  void aRemovedMachineIsPutAside() {
    QVERIFY(store().save(makeTest()).has_value());
    QVERIFY(store().machines().front().hasCreditTest && !store().machines().front().hasLimits);
    const std::filesystem::path path = store().pathOf(kEndpoint, kServer);
    const base::UtcMs now = *base::utcOfText("2026-05-04T09:30:00.000Z");
    QVERIFY(store().remove(kEndpoint, now).has_value());
    QVERIFY(store().remove("opc.tcp://127.0.0.1:4999", now + 1).has_value());
    QVERIFY(store().machines().empty());
    QVERIFY(!store().creditTest(kEndpoint, kServer).value());
    QVERIFY(std::filesystem::exists(path.string() + ".removed"));
    const auto removed = store().removed();
    QCOMPARE(removed.size(), std::size_t{2});
    QCOMPARE(removed.at(kEndpoint), now);
  }

  /// Limits come back as they were entered, beside the other facts; a machine with a file is known
  /// by its name.
  void limitsAreKept() {
    QVERIFY(store().machines().empty());
    QVERIFY(!store().profile(kEndpoint, kServer).value());
    auto profile = report::profileOfPreset("dmu75-5axis").value();
    profile.endpoint = kEndpoint;
    profile.server = kServer;
    profile.enteredAtUtc = "2026-05-04T09:30:00Z";
    profile.enteredBy = "anna";
    profile.name = "Mill 3";
    profile.axes[1].positionMax = 444.5;
    profile.tools = {{7, "END_MILL", 81.25, 4.0}};
    QVERIFY(store().save(makeTest()).has_value());
    QCOMPARE(store().machines().size(), std::size_t{1});
    QVERIFY(store().machines().front().name.empty());
    QVERIFY(store().save(profile).has_value());
    QVERIFY(store().profile(kEndpoint, kServer).value() == profile);
    QVERIFY(store().creditTest(kEndpoint, kServer).value().has_value());
    QCOMPARE(store().machines().size(), std::size_t{1});
    QCOMPARE(store().machines().front().name, std::string("Mill 3"));
    QCOMPARE(store().machines().front().endpoint, std::string(kEndpoint));
    const machine::MachineConfig config = report::configOf(&profile);
    QCOMPARE(config.axes[1].positionMmMax, 444.5);
    QCOMPARE(config.tools->find(7)->edges.front().lengthMm, 81.25);
    QCOMPARE(config.rotarySet(), machine::loadPreset("dmu75-5axis")->rotarySet());
    // A value that cannot be is refused, and the file stays.
    profile.axes[0].speedPerSMax = 0.0;
    QVERIFY(streaming::problemOf(profile)->what == streaming::ProfileProblem::What::Speed);
    QVERIFY(store().save(profile).has_value());
    const auto damaged = store().profile(kEndpoint, kServer);
    QVERIFY(!damaged && damaged.error().code == MachineFileError::Damaged);
  }

  void creditNeedsAPassedTestOfThisVersion() {
    const auto why = [](const std::optional<CreditTest>& test, const opcua::ServerIdentity& now) {
      const auto allowed = streaming::requireCreditTest(test, kEndpoint, now);
      if (allowed) {
        return QString();
      }
      const bool isRefusal = allowed.error().code == streaming::StreamError::NotCommissioned;
      return isRefusal ? QString::fromStdString(allowed.error().message) : QStringLiteral("?");
    };
    QVERIFY(why(std::nullopt, kServer).contains(QStringLiteral("has not been tested")));
    QVERIFY(why(std::nullopt, kServer)
                .contains(QStringLiteral("rivulet-cli commission --endpoint opc.tcp://192")));
    QVERIFY(why(makeTest(), kServer).isEmpty());
    opcua::ServerIdentity later = kServer;
    later.softwareVersion = "4.96";
    QVERIFY(
        why(makeTest(), later).contains(QStringLiteral("Control 4.95 7; now it is Control 4.96")));
    QVERIFY(
        why(makeTest(false), kServer).contains(QStringLiteral("failed the test on 2026-05-04")));
  }

  /// What was said of M functions is kept with the machine, beside everything else.
  void keepsFunctions() {
    const auto given = job::functionsOf({"163=ignore", "M11=pass", "51= M8 "});
    QVERIFY(given.has_value());
    QCOMPARE(*given, (job::Functions{{{11}, "M11"}, {{51}, "M8"}, {{163}, ""}}));
    for (const char* wrong : {"163", "=ignore", "X=ignore", "163=", "163=M1\nM2"}) {
      QVERIFY(!job::functionsOf({std::string(wrong)}));
    }
    QCOMPARE(job::textOf(*given), std::string("11=pass; 51=M8; 163=ignore"));
    QCOMPARE(*job::functionsOfText(job::textOf(*given)), *given);
    QVERIFY(job::functionsOfText(" ; ")->empty());
    QVERIFY(!job::functionsOfText("163=ignore; 11"));
    QVERIFY(store().functions(kEndpoint).empty());
    QVERIFY(store().save(makeTest()).has_value());
    QVERIFY(store().save(kEndpoint, kServer, *given).has_value());
    QCOMPARE(store().functions(kEndpoint), *given);
    QVERIFY(store().functions("opc.tcp://127.0.0.1:4840").empty());
    QVERIFY(store().creditTest(kEndpoint, kServer)->has_value());
    // A simulation leaves out what nobody has spoken of, a control gets no job with it.
    QVERIFY(!store().jobProfile(kEndpoint, false).leavesOutFunctions);
    QVERIFY(store().jobProfile("", true).leavesOutFunctions);
  }

  /// The preset that stands for a control has its limits, not its tools: a radius that nobody has
  /// entered is not known.
  void radiiOfTools() {
    const auto radiusOf = [](const report::LoadMachine& machine, int number) {
      gcode::LoadOptions options;
      machine.tell(options);
      return options.toolRadiusMm(number, "");
    };
    opcua::ServerIdentity server;
    server.buildNumber = "dmu75-mill";
    const report::LoadMachine pictured =
        report::loadMachineOf(store(), kEndpoint, server, true, nullptr);
    const auto table = machine::loadPreset("dmu75-mill")->tools;
    const int known = table->tools.front().number;
    QCOMPARE(radiusOf(pictured, known), std::optional(table->tools.front().edges.front().radiusMm));
    QCOMPARE(radiusOf(pictured, 9999), std::optional<double>());
    QVERIFY(report::loadMachineOf(store(), kEndpoint, server, true, nullptr) == pictured);

    streaming::MachineProfile limits = *report::profileOfPreset("dmu75-mill");
    limits.tools.clear();
    const report::LoadMachine unknown =
        report::loadMachineOf(store(), kEndpoint, server, false, &limits);
    QCOMPARE(radiusOf(unknown, known), std::optional<double>());
    QCOMPARE(radiusOf(report::loadMachineOf(store(), "", {}, true, nullptr), known),
             std::optional<double>());
    limits.tools = {{7, "MILL", 50.0, 4.0}};
    const report::LoadMachine entered =
        report::loadMachineOf(store(), kEndpoint, server, false, &limits);
    QCOMPARE(radiusOf(entered, 7), std::optional(4.0));
    QVERIFY(!(entered == unknown));
    report::LoadMachine larger = entered;
    larger.tools->tools.front().edges.front().radiusMm = 5.0;
    QVERIFY(!(larger == entered));
    // One that is set up for the program.
    const report::LoadMachine fitted{{}, std::nullopt, true};
    QCOMPARE(radiusOf(fitted, 5), std::optional(0.0));
  }
};

RIVULET_TEST(TestMachineStore)
#include "tst_machine_store.moc"
