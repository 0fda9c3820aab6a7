// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// What Rivulet reads of a machine tool by OPC 40501-1 on a server that others wrote
/// (node_opcua_machine_tool.js). Skipped where node-opcua is not installed.

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "interop/node_runtime.h"
#include "support/patience.h"
#include "support/private_folders.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

using rivulet::tests::kRunMs;

}  // namespace

class TestMachineTool : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    if (!tests::NodeRuntime::obstacle().isEmpty()) {
      QSKIP(qPrintable(tests::NodeRuntime::obstacle()));
    }
    tests::NodeRuntime::start(m_server, QStringLiteral("node_opcua_machine_tool.js"),
                              m_folder.path());
    while (m_endpoint.isEmpty() && (m_server.canReadLine() || m_server.waitForReadyRead(kRunMs))) {
      m_endpoint = QJsonDocument::fromJson(m_server.readLine())
                       .object()[QStringLiteral("endpoint")]
                       .toString();
    }
    QVERIFY(!m_endpoint.isEmpty());
  }
  void cleanupTestCase() {
    m_server.terminate();
    m_server.waitForFinished(kRunMs);
  }

  void theMachineIsDescribed() {
    QProcess run;
    run.setProcessEnvironment(tests::environmentIn(m_folder.path()));
    run.start(QStringLiteral(RIVULET_CLI),
              {QStringLiteral("--security"), QStringLiteral("none"), QStringLiteral("map"),
               QStringLiteral("--json"), QStringLiteral("--max-nodes"), QStringLiteral("20"),
               QStringLiteral("--endpoint"), m_endpoint});
    QVERIFY(run.waitForFinished(kRunMs));
    const QByteArray said = run.readAllStandardError();
    QVERIFY2(run.exitCode() == 0, said.constData());
    const QJsonArray machines = QJsonDocument::fromJson(run.readAllStandardOutput())
                                    .object()[QStringLiteral("machines")]
                                    .toArray();
    const QJsonObject expected{
        {QStringLiteral("name"), QStringLiteral("Mill 7")},
        {QStringLiteral("manufacturer"), QStringLiteral("Example Machines")},
        {QStringLiteral("model"), QStringLiteral("EM 500")},
        {QStringLiteral("serial_number"), QStringLiteral("4711")},
        {QStringLiteral("software_revision"), QStringLiteral("8.15")},
        {QStringLiteral("year_of_construction"), QStringLiteral("2021")},
        {QStringLiteral("location"), QStringLiteral("Hall 3")},
        {QStringLiteral("product_instance_uri"), QStringLiteral("urn:example:em500:4711")},
        {QStringLiteral("state"), QStringLiteral("Executing")},
        {QStringLiteral("operation_mode"), QStringLiteral("Processing")},
        {QStringLiteral("program"), QStringLiteral("FLANGE.MPF")},
        {QStringLiteral("program_state"), QStringLiteral("Running")},
        {QStringLiteral("job"), QStringLiteral("Order 12")},
        {QStringLiteral("job_state"), QStringLiteral("Running")},
        {QStringLiteral("runs_completed"), 3},
        {QStringLiteral("runs_planned"), 8}};
    QCOMPARE(machines.size(), 1);
    const QJsonObject found = machines[0].toObject();
    for (const QString& key : expected.keys()) {
      QVERIFY2(found[key] == expected[key], qPrintable(key));
    }
  }

 private:
  QTemporaryDir m_folder;
  QProcess m_server;
  QString m_endpoint;
};

RIVULET_TEST(TestMachineTool)
#include "tst_machine_tool.moc"
