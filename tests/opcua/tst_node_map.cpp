// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <array>

#include "opcua/node_map.h"

using namespace rivulet::opcua;

class TestNodeMap : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void namesAreThoseOfTheControl_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("index");
    QTest::addColumn<QString>("identifier");
    const auto row = [](const char* identifier, VariableKind kind, int index) {
      QTest::newRow(identifier) << static_cast<int>(kind) << index
                                << QString::fromLatin1(identifier);
    };
    row("/Channel/Parameter/R[u1,0]", VariableKind::RParameter, 0);
    row("/Channel/Parameter/R[u1,11]", VariableKind::RParameter, 11);
    row("/Channel/GeometricAxis/aaAcsRel[u1,1]", VariableKind::ActualPosition, 0);
    row("/Channel/GeometricAxis/aaDtew[u1,3]", VariableKind::DistanceToGo, 2);
    row("/Channel/State/actFeedRateIpo", VariableKind::PathFeed, 0);
    row("/Channel/State/progStatus", VariableKind::ProgramStatus, 0);
    row("/Channel/State/chanStatus", VariableKind::ChannelStatus, 0);
    row("/Channel/State/chanAlarm", VariableKind::Alarm, 0);
    row("/Channel/ProgramInfo/actLineNumber", VariableKind::LineNumber, 0);
    row("/Channel/ProgramInfo/selectedWorkPProg", VariableKind::ProgramName, 0);
    row("/Channel/ProgramInfo/msg", VariableKind::Message, 0);
  }

  void namesAreThoseOfTheControl() {
    QFETCH(int, kind);
    QFETCH(int, index);
    QFETCH(QString, identifier);
    const Variable variable{static_cast<VariableKind>(kind), index};
    QCOMPARE(QString::fromStdString(nodeIdentifier(variable)), identifier);
    const auto back = variableOf(identifier.toStdString());
    QVERIFY(back.has_value());
    QVERIFY(*back == variable);
  }

  void unitAndFirstIndexMayBeLeftOut() {
    QVERIFY(variableOf("/Channel/Parameter/R[7]") == rParameter(7));
    QVERIFY(variableOf("/Channel/Parameter/R") == rParameter(1));
    QVERIFY(
        (variableOf("/Channel/GeometricAxis/aaDtew") == Variable{VariableKind::DistanceToGo, 0}));
  }

  void otherIdentifiersAreRefused_data() {
    QTest::addColumn<QString>("identifier");
    for (const char* identifier :
         {"", "R[u1,11]", "/channel/parameter/r[u1,11]", "/Channel/Parameter/R[u2,11]",
          "/Channel/Parameter/R[u1,]", "/Channel/Parameter/R[]", "/Channel/Parameter/R[u1,-1]",
          "/Channel/Parameter/R[u1,+1]", "/Channel/Parameter/R[u1,1", "/Channel/Parameter/R[u1,1]x",
          "/Channel/Parameter/R[u1, 1]", "/Channel/Parameter/R[u1,1,5]",
          "/Channel/Parameter/R[u1,99999999999]", "/Channel/GeometricAxis/aaDtew[u1,0]",
          "/Channel/State/progStatus[u1,1]", "/Channel/Parameter/RG[u1,1]"}) {
      QTest::newRow(identifier) << QString::fromLatin1(identifier);
    }
  }

  void otherIdentifiersAreRefused() {
    QFETCH(QString, identifier);
    QVERIFY(!variableOf(identifier.toStdString()));
  }

  void programPathsGoBothWays() {
    QCOMPARE(programPath("A.MPF"), std::string("Sinumerik/FileSystem/Part Program/A.MPF"));
    QCOMPARE(programNameOf(programPath("A.MPF")).value_or(""), std::string("A.MPF"));
    QVERIFY(!programNameOf("Sinumerik/FileSystem/Sub Program/A.SPF"));
    QVERIFY(!programNameOf("Sinumerik/FileSystem/Part Program/"));
    QVERIFY(!programNameOf("Sinumerik/FileSystem/Part Program/DIR/A.MPF"));
    QVERIFY(!programNameOf(programPath(std::string(33, 'A'))));
    QVERIFY(programNameOf(programPath(std::string(32, 'A'))));
  }

  void membersStandBelowTheirObject() {
    QCOMPARE(memberIdentifier(kMethodsObject, kSelect), std::string("/Methods/Select"));
  }
};

QTEST_APPLESS_MAIN(TestNodeMap)
#include "tst_node_map.moc"
