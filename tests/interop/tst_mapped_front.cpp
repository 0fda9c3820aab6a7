// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A control that is no SINUMERIK, served by node-opcua: other namespaces, other node ids, other
/// units, states as texts. The command line proposes a map of it, and streams through this map.
/// Skipped where node-opcua is not installed; scripts/interop does that.

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <memory>

#include "interop/front_process.h"
#include "interop/node_runtime.h"
#include "opcua/control_map.h"
#include "support/arc_program.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/private_folders.h"
#include "support/test_program.h"

using namespace rivulet;
using opcua::VariableKind;

namespace {

using rivulet::tests::kRunMs;
constexpr int kPoints = 20;
constexpr int kCells = 300;

QJsonObject row(VariableKind kind, int index, const QString& id, const char* folder,
                const QString& name) {
  return {{QStringLiteral("of"), QString::fromStdString(opcua::nodeIdentifier({kind, index}))},
          {QStringLiteral("id"), id},
          {QStringLiteral("folder"), QString::fromUtf8(folder)},
          {QStringLiteral("name"), name}};
}

QJsonObject scaled(QJsonObject row, double factor) {
  row.insert(QStringLiteral("scale"), factor);
  return row;
}

/// Lengths in metres, the feed in mm/s, the state as a text.
QJsonArray variables() {
  QJsonArray list;
  for (int number = 0; number < kCells; ++number) {
    list.append(row(VariableKind::RParameter, number, QStringLiteral("i=%1").arg(5000 + number),
                    "Cells", QStringLiteral("Cell_%1").arg(number)));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const QString letter(QLatin1Char("XYZ"[axis]));
    list.append(scaled(
        row(VariableKind::ActualPosition, axis, QStringLiteral("s=Axes|%1|Actual").arg(letter),
            "Axes", letter + QStringLiteral("ActualPosition")),
        0.001));
    list.append(
        scaled(row(VariableKind::DistanceToGo, axis, QStringLiteral("s=Axes|%1|Rest").arg(letter),
                   "Axes", letter + QStringLiteral("DistanceToGo")),
               0.001));
  }
  list.append(scaled(row(VariableKind::PathFeed, 0, QStringLiteral("s=Motion|Feed"), "Motion",
                         QStringLiteral("ActualFeedrate")),
                     1.0 / 60.0));
  QJsonObject status = row(VariableKind::ChannelStatus, 0,
                           QStringLiteral("g=09087e75-8e5e-499b-"
                                          "954f-f2a9603db28a"),
                           "Motion", QStringLiteral("MachineState"));
  status.insert(QStringLiteral("texts"),
                QJsonArray{QStringLiteral("IDLE"), QStringLiteral("RUN"), QStringLiteral("HOLD")});
  list.append(status);
  list.append(
      row(VariableKind::Alarm, 0, QStringLiteral("i=77"), "Motion", QStringLiteral("AlarmNumber")));
  list.append(row(VariableKind::ProgramName, 0, QStringLiteral("i=78"), "Motion",
                  QStringLiteral("SelectedProgram")));
  return list;
}

QJsonObject method(const char* of, const char* id, const char* name) {
  return {{QStringLiteral("of"), QString::fromUtf8(of)},
          {QStringLiteral("id"), QString::fromUtf8(id)},
          {QStringLiteral("name"), QString::fromUtf8(name)}};
}

}  // namespace

class TestMappedFront : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    if (!tests::NodeRuntime::obstacle().isEmpty()) {
      QSKIP(qPrintable(tests::NodeRuntime::obstacle()));
    }
    write("arc.mpf", tests::arcProgram(kPoints));
    m_machine = std::make_unique<tests::MachineProcess>(QStringLiteral(RIVULET_MACHINE));
    QVERIFY(!m_machine->endpoint().isEmpty());
    m_front = std::make_unique<tests::FrontProcess>(
        tests::Stack::NodeOpcua,
        QJsonObject{{QStringLiteral("upstream"), m_machine->endpoint()},
                    {QStringLiteral("namespace"), QStringLiteral("urn:acme:cell-7")},
                    {QStringLiteral("variables"), variables()},
                    {QStringLiteral("methods_object"), method("/Methods", "s=NC|Files", "Files")},
                    {QStringLiteral("methods"),
                     QJsonArray{method("CopyFileToServer", "i=9001", "WriteProgram"),
                                method("CopyFileFromServer", "i=9002", "ReadProgram"),
                                method("Select", "i=9003", "SelectProgram")}}},
        m_folder.path());
    QVERIFY(!m_front->endpoint().isEmpty());
  }
  void cleanupTestCase() { m_front.reset(); }

  void withoutAMapItIsNoSinumerik() {
    QProcess run;
    start(run, {QStringLiteral("rights"), QStringLiteral("--endpoint"), m_front->endpoint()});
    QCOMPARE(run.exitCode(), 3);
    QVERIFY(run.readAllStandardError().contains("not a SINUMERIK"));
  }

  void aMapIsProposed() {
    QProcess run;
    start(run, {QStringLiteral("map"), QStringLiteral("--json"), QStringLiteral("--endpoint"),
                m_front->endpoint(), QStringLiteral("-o"),
                m_folder.filePath(QStringLiteral("proposed.toml"))});
    const QByteArray said = run.readAllStandardError();
    QVERIFY2(run.exitCode() == 0, said.constData());
    const QJsonObject answer = QJsonDocument::fromJson(run.readAllStandardOutput()).object();
    QVERIFY(answer[QStringLiteral("whole")].toBool());
    const QJsonArray mapped = answer[QStringLiteral("mapped")].toArray();
    QVERIFY(!mapped.isEmpty());
    for (const QJsonValue& one : mapped) {
      const QJsonObject node = one.toObject();
      const QByteArray shown = QJsonDocument(node).toJson();
      QVERIFY2(node[QStringLiteral("there")].toBool(), shown.constData());
      QVERIFY2(node[QStringLiteral("readable")].toBool(), shown.constData());
      QCOMPARE(node[QStringLiteral("writable")].toBool(),
               node[QStringLiteral("key")].toString().startsWith(QStringLiteral("cells")));
    }
    // It is not used as it is: a person has to say what the states mean.
    QProcess tooEarly;
    start(tooEarly, {QStringLiteral("rights"), QStringLiteral("--endpoint"), m_front->endpoint(),
                     QStringLiteral("--map"), m_folder.filePath(QStringLiteral("proposed.toml"))});
    QCOMPARE(tooEarly.exitCode(), 2);
    QVERIFY(tooEarly.readAllStandardError().contains("which values mean reset"));
  }

  /// What a person adds to the proposal is what cannot be seen: states, units, arguments.
  void everyPointIsExecutedOnce() {
    QFile file(m_folder.filePath(QStringLiteral("proposed.toml")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QByteArray text = file.readAll();
    for (const auto& [from, to] :
         {std::pair<QByteArray, QByteArray>{"# reset = []", "reset = [\"IDLE\"]"},
          {"# active = []", "active = [\"RUN\"]"},
          {"# interrupted = []", "interrupted = [\"HOLD\"]"},
          {"[position]\n", "[position]\nunit = \"m\"\n"},
          {"[distance_to_go]\n", "[distance_to_go]\nunit = \"m\"\n"},
          {"[feed]\n", "[feed]\nunit = \"mm/s\"\n"},
          {"# [methods]\n",
           "[methods]\nmain = \"Sinumerik/FileSystem/Part Program/{}\"\n"
           "sub = \"Sinumerik/FileSystem/Sub Program/{}\"\n"},
          {"# object", "object"},
          {"# write", "write"},
          {"# read", "read"},
          {"# select", "select"}}) {
      QVERIFY2(text.contains(from), from.constData());
      text.replace(from, to);
    }
    write("cell.toml", text);
    QProcess run;
    start(run, {QStringLiteral("stream"), m_folder.filePath(QStringLiteral("arc.mpf")),
                QStringLiteral("--motion-only"), QStringLiteral("--method"),
                QStringLiteral("window"), QStringLiteral("--feed"), QStringLiteral("300"),
                QStringLiteral("--json"), QStringLiteral("--endpoint"), m_front->endpoint(),
                QStringLiteral("--map"), m_folder.filePath(QStringLiteral("cell.toml"))});
    const QByteArray said = run.readAllStandardError();
    const QByteArray output = run.readAllStandardOutput();
    const QJsonObject report = QJsonDocument::fromJson(output).object();
    const QByteArray error = QJsonDocument(report[QStringLiteral("error")].toObject()).toJson();
    QVERIFY2(run.exitCode() == 0, (said + error).constData());
    QCOMPARE(report[QStringLiteral("executed")].toInt(), kPoints);
    QVERIFY(report[QStringLiteral("judged")].toBool());
    for (const char* wrong : {"repeated", "skipped", "foreign", "out_of_order"}) {
      QCOMPARE(report[QString::fromUtf8(wrong)].toInt(-1), 0);
    }
  }

 private:
  void write(const char* name, const QByteArray& text) {
    QFile file(m_folder.filePath(QString::fromUtf8(name)));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
  }
  void start(QProcess& run, const QStringList& arguments) {
    run.setProcessEnvironment(tests::environmentIn(m_folder.path()));
    run.start(QStringLiteral(RIVULET_CLI), arguments);
    QVERIFY(run.waitForFinished(kRunMs));
  }

  QTemporaryDir m_folder;
  std::unique_ptr<tests::MachineProcess> m_machine;
  std::unique_ptr<tests::FrontProcess> m_front;
};

RIVULET_TEST(TestMappedFront)
#include "tst_mapped_front.moc"
