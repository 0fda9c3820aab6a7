// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Rivulet beside an OPC UA stack that others wrote, as the server that the command line connects
/// to, and as the client of rivulet-machine behind it: node-opcua, or with
/// RIVULET_TEST_STACK=asyncua that. Skipped where it is not installed; scripts/interop does that.

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <memory>

#include "base/axes.h"
#include "interop/front_process.h"
#include "opcua/node_map.h"
#include "support/arc_program.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/private_folders.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

using rivulet::tests::kRunMs;
constexpr int kPoints = 20;
const QString kUser = QStringLiteral("setter");
const QString kPassword = QStringLiteral("only for this test");

/// Everything that Rivulet reads or writes on a machine with five axes.
QJsonArray variables() {
  using opcua::VariableKind;
  QJsonArray list;
  const auto add = [&list](VariableKind kind, int index) {
    list.append(QString::fromStdString(opcua::nodeIdentifier({kind, index})));
  };
  for (int number = 0; number < 1000; ++number) {
    add(VariableKind::RParameter, number);
  }
  for (std::size_t axis = 0; axis < base::kAxisCount + base::kRotaryAxisCount; ++axis) {
    for (const auto kind :
         {VariableKind::ActualPosition, VariableKind::DistanceToGo, VariableKind::AxisName}) {
      add(kind, static_cast<int>(axis));
    }
  }
  for (const auto kind : {VariableKind::PathFeed, VariableKind::ProgramStatus,
                          VariableKind::ChannelStatus, VariableKind::LineNumber,
                          VariableKind::ProgramName, VariableKind::Message, VariableKind::Alarm}) {
    add(kind, 0);
  }
  return list;
}

}  // namespace

class TestOtherStack : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    const auto stack = qEnvironmentVariable("RIVULET_TEST_STACK") == QStringLiteral("asyncua")
                           ? tests::Stack::Asyncua
                           : tests::Stack::NodeOpcua;
    const QString obstacle = tests::FrontProcess::obstacle(stack);
    if (!obstacle.isEmpty()) {
      QSKIP(qPrintable(obstacle));
    }
    write("arc.mpf", tests::arcProgram(kPoints));
    m_machine = std::make_unique<tests::MachineProcess>(QStringLiteral(RIVULET_MACHINE));
    QVERIFY(!m_machine->endpoint().isEmpty());
    m_front = std::make_unique<tests::FrontProcess>(
        stack,
        QJsonObject{{QStringLiteral("upstream"), m_machine->endpoint()},
                    {QStringLiteral("user"), kUser},
                    {QStringLiteral("password"), kPassword},
                    {QStringLiteral("variables"), variables()}},
        m_folder.path());
    m_endpoint = m_front->endpoint();
    m_fingerprint = m_front->fingerprint();
    QVERIFY(!m_endpoint.isEmpty());
  }
  void cleanupTestCase() { m_front.reset(); }

  /// Comes first: afterwards the certificate is known.
  void anUnknownServerIsRefused() {
    QProcess run;
    start(run, {QStringLiteral("--security"), QStringLiteral("strongest"), QStringLiteral("rights"),
                QStringLiteral("--endpoint"), m_endpoint});
    const QByteArray said = run.readAllStandardError();
    QCOMPARE(run.exitCode(), 3);
    QVERIFY2(said.contains("--trust"), said.constData());
  }

  void aWrongPasswordIsRefused() {
    QProcess run;
    start(run,
          protectedBy(QStringLiteral("encrypted")) +
              QStringList{QStringLiteral("rights"), QStringLiteral("--endpoint"), m_endpoint},
          QStringLiteral("wrong"));
    QCOMPARE(run.exitCode(), 3);
  }

  /// Method credit is allowed on a control that has passed it.
  void theTestOfCreditPasses() {
    QProcess run;
    start(run,
          protectedBy(QStringLiteral("encrypted")) +
              QStringList{QStringLiteral("commission"), QStringLiteral("--endpoint"), m_endpoint});
    const QByteArray said = run.readAllStandardError() + run.readAllStandardOutput();
    QVERIFY2(run.exitCode() == 0, said.constData());
  }

  void everyPointIsExecutedOnce_data() {
    QTest::addColumn<QString>("method");
    QTest::addColumn<QString>("protection");
    for (const char* method : {"window", "credit", "file", "signal", "position"}) {
      for (const char* protection : {"plain", "encrypted"}) {
        QTest::addRow("%s, %s", method, protection)
            << QString::fromUtf8(method) << QString::fromUtf8(protection);
      }
    }
  }
  void everyPointIsExecutedOnce() {
    QFETCH(QString, method);
    QFETCH(QString, protection);
    QProcess run;
    start(run,
          protectedBy(protection) +
              QStringList{QStringLiteral("stream"), m_folder.filePath(QStringLiteral("arc.mpf")),
                          QStringLiteral("--motion-only"), QStringLiteral("--method"), method,
                          QStringLiteral("--feed"), QStringLiteral("300"), QStringLiteral("--json"),
                          QStringLiteral("--endpoint"), m_endpoint});
    const QByteArray said = run.readAllStandardError();
    const QJsonObject report = QJsonDocument::fromJson(run.readAllStandardOutput()).object();
    QVERIFY2(run.exitCode() == 0, said.constData());
    QCOMPARE(report[QStringLiteral("executed")].toInt(), kPoints);
    QVERIFY(report[QStringLiteral("judged")].toBool());
    for (const char* wrong : {"repeated", "skipped", "foreign", "out_of_order"}) {
      QCOMPARE(report[QString::fromUtf8(wrong)].toInt(-1), 0);
    }
  }

  void theAccessTimeIsMeasured() {
    QProcess run;
    start(run, protectedBy(QStringLiteral("encrypted")) +
                   QStringList{QStringLiteral("calibrate"), QStringLiteral("--json"),
                               QStringLiteral("--first-cell"), QStringLiteral("60"),
                               QStringLiteral("--last-cell"), QStringLiteral("99"),
                               QStringLiteral("--shots"), QStringLiteral("20"),
                               QStringLiteral("--endpoint"), m_endpoint});
    const QByteArray said = run.readAllStandardError();
    QVERIFY2(run.exitCode() == 0, said.constData());
    QVERIFY(!QJsonDocument::fromJson(run.readAllStandardOutput()).object().isEmpty());
  }

 private:
  void write(const char* name, const QByteArray& text) {
    QFile file(m_folder.filePath(QString::fromUtf8(name)));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
  }
  [[nodiscard]] QStringList protectedBy(const QString& protection) const {
    return protection == QStringLiteral("plain")
               ? QStringList{QStringLiteral("--security"), QStringLiteral("none")}
               : QStringList{QStringLiteral("--security"), QStringLiteral("strongest"),
                             QStringLiteral("--trust"),    m_fingerprint,
                             QStringLiteral("--user"),     kUser};
  }
  void start(QProcess& run, const QStringList& arguments, const QString& password = kPassword) {
    QProcessEnvironment environment = tests::environmentIn(m_folder.path());
    environment.insert(QStringLiteral("RIVULET_PASSWORD"), password);
    run.setProcessEnvironment(environment);
    run.start(QStringLiteral(RIVULET_CLI), arguments);
    QVERIFY(run.waitForFinished(kRunMs));
  }

  QTemporaryDir m_folder;
  std::unique_ptr<tests::MachineProcess> m_machine;
  std::unique_ptr<tests::FrontProcess> m_front;
  QString m_endpoint;
  QString m_fingerprint;
};

RIVULET_TEST(TestOtherStack)
#include "tst_other_stack.moc"
