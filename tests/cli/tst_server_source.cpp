// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Live points in the variables of another OPC UA server: real servers, real sockets, and a virtual
/// machine as the control.

#include <fmt/format.h>

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <memory>
#include <optional>

#include "live/error.h"
#include "sources/server_map.h"
#include "support/live_run.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/patient_sender.h"
#include "support/plain_server.h"
#include "support/test_program.h"

using namespace rivulet;
using tests::angleOf;
using tests::kExecuted;
using tests::kNumbers;
using tests::kPoints;
using tests::kReplies;
using tests::kWords;
using tests::LiveRun;
using tests::PatientSender;
using tests::PlainServer;

class TestServerSource : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyPointOnceOverOpcUaOnBothSides() {
    const tests::MachineProcess machine(
        QStringLiteral(RIVULET_MACHINE),
        QStringList{QStringLiteral("--preset"), QStringLiteral("dmu75-arrays")});
    PatientSender sender;
    const PlainServer server(kNumbers, {}, std::ref(sender));
    LiveRun run(m_folder.path(), arguments(write(server, kWords + kReplies)) + " --endpoint " +
                                     machine.endpoint().toStdString());
    QCOMPARE(run.finish(), 0);
    QVERIFY2(run.isRight(), run.report.dump(1).c_str());
    QCOMPARE(run.number("executed"), std::size_t{kPoints});
    // The last reply may come after the server's own end.
    QVERIFY(sender.m_mostExecuted > 0.0);
  }

  void linesInOneText() {
    int sent = 0;
    const PlainServer server({{"accepted", -1.0}}, {{"line", "N0 X99"}}, [&](PlainServer& self) {
      if (self.number("accepted") < sent) {
        return;
      }
      // Five lines at a time, and the end with the last ones.
      std::string text;
      for (int i = 0; i < 5 && sent < kPoints; ++i) {
        ++sent;
        text += fmt::format("N{} X{:.4f} Y{:.4f}\n", sent, 5.0 * (std::cos(angleOf(sent)) - 1.0),
                            5.0 * std::sin(angleOf(sent)));
      }
      if (!text.empty()) {
        self.set("line", text + (sent == kPoints ? "end" : "comment"));
      }
    });
    LiveRun run(m_folder.path(),
                arguments(write(server,
                                "[points]\n"
                                "line = \"nsu=http://open62541.org/does-not-exist;s=line\"\n")) +
                    kSimulated);
    QCOMPARE(run.finish(), 3);  // a namespace that is not there
    LiveRun right(m_folder.path(), arguments(write(server,
                                                   "[points]\n"
                                                   "line = \"ns=1;s=line\"\n"
                                                   "[replies]\n"
                                                   "accepted = \"ns=1;s=accepted\"\n")) +
                                       kSimulated);
    QCOMPARE(right.finish(), 0);
    QVERIFY2(right.isRight(), right.report.dump(1).c_str());
    QCOMPARE(right.number("executed"), std::size_t{kPoints});
  }

  void whatIsNoNumberEndsTheRunBehindTheLastGoodPoint() {
    PatientSender sender;
    sender.m_poisoned = 31;
    const PlainServer server(kNumbers, {}, std::ref(sender));
    LiveRun run(m_folder.path(), arguments(write(server, kWords + kReplies)) + kSimulated);
    QCOMPARE(run.finish(), 1);
    QVERIFY2(run.isRight(), run.report.dump(1).c_str());
    QCOMPARE(run.number("executed"), 30U);
    QVERIFY2(run.error().find("Y has no finite number.") != std::string::npos, run.error().c_str());
  }

  /// Without this reply the server cannot wait: a point that was overwritten is missed, and said.
  void aPointThatWasOverwrittenIsMissed() {
    int turn = 0;
    int sent = 0;
    const PlainServer server(kNumbers, {}, [&](PlainServer& self) {
      // The run has begun when the first reply is there.
      if (self.number("executed") >= 0.0 && ++turn % 100 == 0) {
        sent += sent == 20 ? 2 : 1;
        self.set("x", 0.1 * sent);
        self.set("f", 900.0);
        self.set("n", sent);
      }
    });
    LiveRun run(m_folder.path(), arguments(write(server, kWords + kExecuted)) + kSimulated);
    QCOMPARE(run.finish(), 1);
    QVERIFY2(run.isRight(), run.report.dump(1).c_str());
    QVERIFY2(run.error().find("N21 was expected after N20, but N22 came") != std::string::npos,
             run.error().c_str());
  }

  void aServerThatGoesEndsTheRun() {
    PatientSender sender;
    sender.m_most = 20;
    auto server = std::make_unique<PlainServer>(kNumbers, std::map<std::string, std::string>{},
                                                std::ref(sender));
    LiveRun run(m_folder.path(), arguments(write(*server, kWords + kReplies)) + kSimulated);
    QTRY_VERIFY_WITH_TIMEOUT(sender.m_mostExecuted >= 14.0, tests::kRunMs);
    server.reset();
    QCOMPARE(run.finish(), 1);
    QVERIFY2(run.isRight(), run.report.dump(1).c_str());
    QVERIFY2(run.error().find("The source was closed without `end`.") != std::string::npos,
             run.error().c_str());
  }

  void nobodyIsThere() {
    std::string endpoint;
    {
      const PlainServer server;
      endpoint = server.endpoint();
    }
    LiveRun run(m_folder.path(),
                arguments(writeText("endpoint = \"" + endpoint + "\"\n" + kWords)) + kSimulated);
    QCOMPARE(run.finish(), 3);
  }

  void filesThatAreNone_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("says");
    const QString endpoint = QStringLiteral("endpoint = \"opc.tcp://127.0.0.1:1\"\n");
    const auto row = [](const char* name, const QString& text, const char* says) {
      QTest::newRow(name) << text << QString::fromUtf8(says);
    };
    row("nothing", QString(), "endpoint is missing");
    row("no points", endpoint, "[points] must have line, or n and at least one axis");
    row("no number", endpoint + QStringLiteral("[points]\nx=\"i=1\"\n"), "n and at least one axis");
    row("no axis", endpoint + QStringLiteral("[points]\nn=\"i=1\"\n"), "n and at least one axis");
    row("both", endpoint + QStringLiteral("[points]\nline=\"i=1\"\nx=\"i=2\"\n"),
        "either line or n and axes");
    row("unknown", endpoint + QStringLiteral("[points]\nw=\"i=1\"\n"),
        "line 3: w is not known in [points]");
    row("unknown section", endpoint + QStringLiteral("colour=\"red\"\n"),
        "line 2: colour is not known here");
    row("no text", endpoint + QStringLiteral("[points]\nx=5\n"),
        "line 3: x must be a text in quotes");
    row("no section", endpoint + QStringLiteral("points=5\n"), "line 2: points must be a section");
    row("no TOML", QStringLiteral("endpoint = \n"), "line 1: This is no TOML");
  }
  void filesThatAreNone() {
    QFETCH(QString, text);
    QFETCH(QString, says);
    const auto map = sources::readServerMap(writeText(text.toStdString()));
    QVERIFY(!map);
    QVERIFY2(map.error().code == live::LiveError::BadSourceFile, map.error().text().c_str());
    QVERIFY2(map.error().text().find(says.toStdString()) != std::string::npos,
             map.error().text().c_str());
  }

 private:
  const std::string kSimulated = " --simulate --preset dmu75-arrays";

  [[nodiscard]] static std::string arguments(const std::string& file) {
    return "--points 13 --live opcua:" + file;
  }
  [[nodiscard]] std::string write(const PlainServer& server, const std::string& rest) const {
    return writeText("endpoint = \"" + server.endpoint() + "\"\n" + rest);
  }
  [[nodiscard]] std::string writeText(const std::string& text) const {
    QFile file(m_folder.filePath(QStringLiteral("source.toml")));
    if (!file.open(QIODevice::WriteOnly) || file.write(text.data()) < 0) {
      qFatal("cannot write");
    }
    return file.fileName().toStdString();
  }

  QTemporaryDir m_folder;
};

RIVULET_TEST(TestServerSource)
#include "tst_server_source.moc"
