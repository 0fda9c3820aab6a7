// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <array>

#include "opcua/node_map.h"
#include "support/test_program.h"

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
    row("/Channel/GeometricAxis/name[u1,4]", VariableKind::AxisName, 3);
    row("/Channel/GeometricAxis/aaAcsRel[u1,5]", VariableKind::ActualPosition, 4);
    row("/Channel/State/actTNumber", VariableKind::ToolNumber, 0);
    row("/Channel/State/actToolIdent", VariableKind::ToolName, 0);
    row("/Channel/State/actDNumber", VariableKind::EdgeNumber, 0);
    row("/Channel/Spindle/actSpeed[u1,1]", VariableKind::SpindleSpeed, 0);
    row("/Channel/Spindle/cmdSpeed[u1,1]", VariableKind::SpindleSpeedSet, 0);
    row("/Channel/Spindle/turnState[u1,1]", VariableKind::SpindleTurn, 0);
    row("/Channel/SelectedFunctions/ncFktAct[u1,8]", VariableKind::GFunction, kWorkOffsetGroup);
    row("/Channel/AuxiliaryFunctions/acAuxfuMValue[u1,5]", VariableKind::MFunction, kFloodGroup);
    row("/Channel/AuxiliaryFunctions/acAuxfuMValue[u1,6]", VariableKind::MFunction, kMistGroup);
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

  void arraysGoBothWays() {
    const ParameterArray five{10, 5, Grouping::ArrayCount};
    QCOMPARE(arrayIdentifier(five), std::string("/Channel/Parameter/R[u1,10,#5]"));
    QVERIFY(arrayOf(arrayIdentifier(five)) == five);
    const ParameterArray range{10, 5, Grouping::ArrayRange};
    QCOMPARE(arrayIdentifier(range), std::string("/Channel/Parameter/R[u1,10,14]"));
    QVERIFY(arrayOf(arrayIdentifier(range)) == range);
    QVERIFY(arrayOf("/Channel/Parameter/R[10,#5]") == five);
    QVERIFY(arrayOf("/Channel/Parameter/R[u1,0,0]") ==
            (ParameterArray{0, 1, Grouping::ArrayRange}));
    for (const char* identifier :
         {"", "/Channel/Parameter/R", "/Channel/Parameter/R[u1,10]", "/Channel/Parameter/R[u1,5,4]",
          "/Channel/Parameter/R[u1,5,#0]", "/Channel/Parameter/R[u1,5,#]",
          "/Channel/Parameter/R[u1,5,-7]", "/Channel/Parameter/R[u2,5,7]",
          "/Channel/Parameter/R[u1,5,7,9]", "/Channel/Parameter/R[u1,0,#999999999]",
          "/Channel/Parameter/R[u1,#5]", "/Channel/Parameter/RG[u1,5,7]",
          "/channel/parameter/r[u1,5,7]", "/Channel/Parameter/R[u1,5,7"}) {
      QVERIFY2(!arrayOf(identifier), identifier);
    }
  }

  void ascendingParametersShareANode() {
    const std::array variables{rParameter(10),
                               rParameter(11),
                               rParameter(12),
                               rParameter(14),
                               Variable{VariableKind::ActualPosition, 15},
                               rParameter(13),
                               rParameter(12)};
    constexpr std::array<std::size_t, 7> kLengths{3, 2, 1, 1, 1, 1, 1};
    for (std::size_t i = 0; i < variables.size(); ++i) {
      QCOMPARE(sharedNodeLength(variables, i, Grouping::ArrayCount), kLengths[i]);
      QCOMPARE(sharedNodeLength(variables, i, Grouping::ArrayRange), kLengths[i]);
      QCOMPARE(sharedNodeLength(variables, i, Grouping::List), std::size_t{1});
      QCOMPARE(sharedNodeLength(variables, i, Grouping::Single), std::size_t{1});
    }
  }

  void groupingsHaveNames() {
    for (const Grouping grouping :
         {Grouping::List, Grouping::Single, Grouping::ArrayCount, Grouping::ArrayRange}) {
      QVERIFY(groupingFromName(groupingName(grouping)) == grouping);
    }
    QVERIFY(!groupingFromName("array"));
  }

  void programPathsGoBothWays() {
    QCOMPARE(programPath("A.MPF"), std::string("Sinumerik/FileSystem/Part Program/A.MPF"));
    QCOMPARE(programNameOf(programPath("A.MPF")).value_or(""), std::string("A.MPF"));
    QCOMPARE(programPath("A.SPF"), std::string("Sinumerik/FileSystem/Sub Program/A.SPF"));
    QCOMPARE(programNameOf(programPath("A.SPF")).value_or(""), std::string("A.SPF"));
    QVERIFY(!programNameOf("Sinumerik/FileSystem/Work Pieces/A.SPF"));
    QVERIFY(!programNameOf("Sinumerik/FileSystem/Part Program/"));
    // What is kept under its name must not be a folder, or another name where it is cut.
    for (const std::string name : {".", "..", "A/B.MPF", "A\nB.MPF"}) {
      QVERIFY2(!programNameOf(programPath(name)), name.c_str());
    }
    QVERIFY(!programNameOf(programPath(std::string("A\0B.MPF", 7))));
    QVERIFY(!programNameOf("Sinumerik/FileSystem/Part Program/DIR/A.MPF"));
    QVERIFY(!programNameOf(programPath(std::string(33, 'A'))));
    QVERIFY(programNameOf(programPath(std::string(32, 'A'))));
  }

  void membersStandBelowTheirObject() {
    QCOMPARE(memberIdentifier(kMethodsObject, kSelect), std::string("/Methods/Select"));
  }
};

RIVULET_TEST(TestNodeMap)
#include "tst_node_map.moc"
