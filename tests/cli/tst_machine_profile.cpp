// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The profile of a machine: what it says of method credit, and that nothing else in it is lost.

#include <QTemporaryDir>
#include <QtTest>
#include <nlohmann/json.hpp>

#include "report/machine_profile.h"
#include "streaming/run.h"
#include "support/test_program.h"
#include "trace/control_trace.h"
#include "trace/file.h"

using namespace rivulet;
using report::CreditTest;

namespace {

const std::string kEndpoint = "opc.tcp://192.168.214.1:4840";

CreditTest makeTest(bool passed = true) {
  CreditTest test;
  test.endpoint = kEndpoint;
  test.server = {"urn:control", "Control", "4.95", "7"};
  test.testedAtUtc = "2026-05-04T09:30:00Z";
  test.toolVersion = "0.1.0";
  test.result.checks = {{"answers-while-busy", passed, "20 of 20"}, {"buffer-level", true, "yes"}};
  test.result.asked = 20;
  test.result.answered = passed ? 20 : 0;
  test.result.slowestAnswer = std::chrono::milliseconds{42};
  return test;
}

}  // namespace

class TestMachineProfile : public QObject {
  Q_OBJECT

 private slots:
  void comesBackAsItWas() {
    const CreditTest test = makeTest();
    const auto text = report::withCreditTest("", test);
    QVERIFY(text.has_value());
    const auto back = report::creditTestOf(*text);
    QVERIFY(back && *back);
    QVERIFY((*back)->server == test.server);
    QCOMPARE((*back)->endpoint, test.endpoint);
    QCOMPARE((*back)->testedAtUtc, test.testedAtUtc);
    QCOMPARE((*back)->result.answered, 20);
    QVERIFY((*back)->result.slowestAnswer == test.result.slowestAnswer);
    QVERIFY((*back)->result.passed());
    QCOMPARE((*back)->result.checks.size(), std::size_t{2});
    QVERIFY(!*report::creditTestOf(""));
  }

  void whatItDoesNotKnowStays() {
    const char* before =
        R"({"rivulet_machine_profile":1,"calibration":{"node_ms":4.25},"credit_test":{"passed":true},"x":[1,2]})";
    const auto text = report::withCreditTest(before, makeTest(false));
    QVERIFY(text.has_value());
    const auto json = nlohmann::json::parse(*text);
    QCOMPARE(json["calibration"]["node_ms"].get<double>(), 4.25);
    QCOMPARE(json["x"].size(), std::size_t{2});
    QVERIFY(!json["credit_test"]["passed"].get<bool>());
  }

  /// Nothing that is said beside the checks makes a test a passed one.
  void onlyChecksCount() {
    for (const char* section :
         {R"({"passed":true})", R"({"passed":true,"checks":[]})", R"({"checks":"all"})",
          R"({"checks":[{"name":"a","passed":"yes"}]})", R"({"checks":[7],"server":3})"}) {
      const auto test = report::creditTestOf(
          std::string(R"({"rivulet_machine_profile":1,"credit_test":)") + section + "}");
      QVERIFY(test && *test);
      QVERIFY2(!(*test)->result.passed(), section);
    }
  }

  void otherFilesAreRefused() {
    for (const char* text : {"no json", "[]", "{}", R"({"rivulet_machine_profile":"1"})"}) {
      const auto test = report::creditTestOf(text);
      QVERIFY(!test && test.error().code == trace::TraceError::NotATrace);
      QVERIFY(!report::withCreditTest(text, makeTest()));
    }
    const auto newer = report::creditTestOf(R"({"rivulet_machine_profile":2})");
    QVERIFY(!newer && newer.error().code == trace::TraceError::NewerVersion);
  }

  void creditNeedsAPassedTestOfThisVersion() {
    QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath(QStringLiteral("a/b")).toStdString();
    const CreditTest test = makeTest();
    const auto why = [&](const std::string& endpoint, const opcua::ServerIdentity& server) {
      const auto allowed = report::requireCreditTest(path, endpoint, server);
      if (allowed) {
        return QString();
      }
      const bool isRefusal = allowed.error().code == streaming::StreamError::NotCommissioned;
      return isRefusal ? QString::fromStdString(allowed.error().message) : QStringLiteral("?");
    };
    QVERIFY(why(kEndpoint, test.server).contains(QStringLiteral("has not been tested")));
    QVERIFY(why(kEndpoint, test.server)
                .contains(QStringLiteral("rivulet-cli commission --endpoint opc.tcp://192")));
    QVERIFY(report::saveCreditTest(path, test).has_value());
    QVERIFY(why(kEndpoint, test.server).isEmpty());
    QVERIFY(why("opc.tcp://192.168.214.2:4840", test.server).contains(QStringLiteral("has not")));
    opcua::ServerIdentity later = test.server;
    later.softwareVersion = "4.96";
    QVERIFY(
        why(kEndpoint, later).contains(QStringLiteral("Control 4.95 7; now it is Control 4.96")));
    opcua::ServerIdentity other = test.server;
    other.applicationUri = "urn:other";
    QVERIFY(why(kEndpoint, other).contains(QStringLiteral("has not been tested")));
    QVERIFY(report::saveCreditTest(path, makeTest(false)).has_value());
    QVERIFY(why(kEndpoint, test.server).contains(QStringLiteral("failed the test on 2026-05-04")));
    // A file that cannot be read is no permission either.
    QVERIFY(trace::writeFile(report::profilePath(path, kEndpoint, test.server), "x").has_value());
    QCOMPARE(why(kEndpoint, test.server), QStringLiteral("?"));
    QVERIFY(!report::saveCreditTest(path, test));
  }
};

RIVULET_TEST(TestMachineProfile)
#include "tst_machine_profile.moc"
