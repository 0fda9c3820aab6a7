// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// rivulet-machine as the server of a client that others wrote: what a client of node-opcua finds
/// when it looks around (node_opcua_walk.js). Skipped where node-opcua is not installed.

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QtTest>
#include <algorithm>
#include <memory>

#include "interop/node_runtime.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

using rivulet::tests::kRunMs;

const QString kPlain = QStringLiteral("ns=0;i=63");        // BaseDataVariableType
const QString kProperty = QStringLiteral("ns=0;i=68");     // PropertyType
const QString kWithRange = QStringLiteral("ns=0;i=2368");  // AnalogItemType
const QString kWithUnit = QStringLiteral("ns=0;i=17497");  // AnalogUnitType
const QString kChannel = QStringLiteral("ns=2;s=/Channel/");
constexpr int kHistoryBits = 4 | 8;  // of the access level

}  // namespace

class TestNodeWalk : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    if (!tests::NodeRuntime::obstacle().isEmpty()) {
      QSKIP(qPrintable(tests::NodeRuntime::obstacle()));
    }
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE),
                                        {QStringLiteral("--preset"), QStringLiteral("dmu75-mill")});
    QVERIFY(!machine.endpoint().isEmpty());
    QProcess walk;
    tests::NodeRuntime::start(walk, QStringLiteral("node_opcua_walk.js"), machine.endpoint());
    QVERIFY(walk.waitForFinished(kRunMs));
    QCOMPARE(walk.exitCode(), 0);
    m_found = QJsonDocument::fromJson(walk.readAllStandardOutput()).object();
    QVERIFY(!m_found.isEmpty());
    for (const QJsonValue& one : m_found[QStringLiteral("nodes")].toArray()) {
      const QJsonObject node = one.toObject();
      m_nodes.insert(text(node, "id"), node);
    }
  }

  void everyNodeIsDescribed() {
    QVERIFY(m_nodes.size() > 70);
    for (const QJsonObject& node : m_nodes) {
      const QString description = text(node, "description");
      QVERIFY2(description.size() > 10 && description.endsWith(QLatin1Char('.')) &&
                   !description.contains(QLatin1Char('{')),
               qPrintable(text(node, "id")));
    }
    QCOMPARE(description("MachineAxis/measPos1[u1,4]"),
             QStringLiteral("Actual position of axis A in machine coordinates."));
    QCOMPARE(description("Parameter/R[u1,12]"),
             QStringLiteral("R-parameter 12, for NC programs and clients."));
    QCOMPARE(description("Parameter/R[u1,10,#5]"),
             QStringLiteral("R-parameters 10 to 14, for NC programs and clients."));
  }

  void everyVariableIsReadable() {
    for (const QJsonObject& node : m_nodes) {
      if (text(node, "nodeClass") != QStringLiteral("Variable")) {
        continue;
      }
      const char* id = qPrintable(text(node, "id"));
      QVERIFY2(text(node, "status") == QStringLiteral("Good"), id);
      QVERIFY2(text(node, "dataType").startsWith(QStringLiteral("ns=0;i=")), id);
      const int access = node[QStringLiteral("access")].toInt();
      QVERIFY2((access & 1) != 0, id);
      const bool isCell = text(node, "id").startsWith(kChannel + QStringLiteral("Parameter/R"));
      QVERIFY2(((access & 2) != 0) == isCell, id);
    }
  }

  void historyIsNotOffered() {
    for (const QJsonObject& node : m_nodes) {
      const char* id = qPrintable(text(node, "id"));
      QVERIFY2(!node[QStringLiteral("historizing")].toBool(), id);
      QVERIFY2((node[QStringLiteral("access")].toInt() & kHistoryBits) == 0, id);
    }
    const QString refused = text(m_found, "history");
    QVERIFY2(refused.startsWith(QStringLiteral("Bad")), qPrintable(refused));
    QVERIFY(!stated().contains(QStringLiteral("HistoryServerCapabilities")));
  }

  void unitsAndRanges_data() {
    QTest::addColumn<QString>("type");
    QTest::addColumn<QString>("symbol");
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    const auto row = [](const char* name, const QString& type, const char* symbol, double low,
                        double high) {
      QTest::newRow(name) << type << QString::fromUtf8(symbol) << low << high;
    };
    row("GeometricAxis/aaAcsRel", kWithUnit, "mm", 0.0, 0.0);
    row("GeometricAxis/aaDtew", kWithUnit, "mm", 0.0, 0.0);
    row("MachineAxis/measPos1", kWithRange, "mm", -375.0, 375.0);
    row("MachineAxis/measPos1[u1,4]", kWithRange, "\u00b0", -120.0, 120.0);
    row("State/actFeedRateIpo", kWithRange, "mm/min", 0.0, 40000.0);
    row("Spindle/actSpeed", kWithRange, "r/min", 0.0, 20000.0);
    row("State/chanStatus", kPlain, "", 0.0, 0.0);
    row("Parameter/R[u1,12]", kPlain, "", 0.0, 0.0);
    row("Parameter/R[u1,10,#5]", kPlain, "", 0.0, 0.0);
  }
  void unitsAndRanges() {
    QFETCH(QString, type);
    QFETCH(QString, symbol);
    QFETCH(double, low);
    QFETCH(double, high);
    const QString id = kChannel + QString::fromUtf8(QTest::currentDataTag());
    QCOMPARE(text(m_nodes[id], "type"), type);
    const QJsonObject unit = member(id, "EngineeringUnits")[QStringLiteral("unit")].toObject();
    QCOMPARE(text(unit, "symbol"), symbol);
    // What that library knows by the same number; it does not know all units.
    const QJsonArray known = unit[QStringLiteral("known")].toArray();
    QVERIFY(!known.isEmpty() || symbol.isEmpty() || symbol == QStringLiteral("mm/min"));
    if (!known.isEmpty()) {
      QCOMPARE(known[0].toString(), symbol);
      QCOMPARE(known[1].toString(), text(unit, "name"));
    }
    const QJsonArray range = member(id, "EURange")[QStringLiteral("range")].toArray();
    QCOMPARE(range.isEmpty(), type != kWithRange);
    QCOMPARE(range.isEmpty() ? 0.0 : range[0].toDouble(), low);
    QCOMPARE(range.isEmpty() ? 0.0 : range[1].toDouble(), high);
  }

  void everyAnalogVariableHasItsUnit() {
    int seen = 0;
    for (const QJsonObject& node : m_nodes) {
      const QString type = text(node, "type");
      if (type == kWithRange || type == kWithUnit) {
        ++seen;
        QVERIFY(!member(text(node, "id"), "EngineeringUnits").isEmpty());
        QCOMPARE(!member(text(node, "id"), "EURange").isEmpty(), type == kWithRange);
      } else if (text(node, "nodeClass") == QStringLiteral("Variable")) {
        QVERIFY(type == kPlain || type == kProperty);
      }
    }
    QVERIFY(seen >= 13);
  }

  void positionsArrive() {
    const QJsonObject positions = m_found[QStringLiteral("positions")].toObject();
    for (const QJsonValue& status : positions[QStringLiteral("statuses")].toArray()) {
      QCOMPARE(status.toString(), QStringLiteral("Good"));
    }
    const QJsonArray seen = positions[QStringLiteral("seen")].toArray();
    QVERIFY(seen.size() > 5);
    QCOMPARE(seen.first().toDouble(), 0.0);
    QVERIFY(seen.last().toDouble() > 19.99);
    QVERIFY(std::is_sorted(seen.begin(), seen.end(), [](const QJsonValue& a, const QJsonValue& b) {
      return a.toDouble() < b.toDouble();
    }));
    const QJsonObject revised = positions[QStringLiteral("revised")].toObject();
    QCOMPARE(revised[QStringLiteral("sampling")],
             stated()[QStringLiteral("MinSupportedSampleRate")]);
    QCOMPARE(revised[QStringLiteral("queue")],
             stated()[QStringLiteral("MaxMonitoredItemsQueueSize")]);
  }

  void limitsHold_data() {
    QTest::addColumn<int>("limit");
    QTest::addColumn<QString>("refusal");
    const auto row = [](const char* name, int limit, const char* refusal) {
      QTest::newRow(name) << limit << QString::fromUtf8(refusal);
    };
    row("MaxNodesPerRead", 1000, "BadTooManyOperations");
    row("MaxNodesPerWrite", 1000, "BadTooManyOperations");
    row("MaxNodesPerBrowse", 1000, "BadTooManyOperations");
    row("MaxNodesPerTranslateBrowsePathsToNodeIds", 1000, "BadTooManyOperations");
    row("MaxNodesPerRegisterNodes", 1000, "BadTooManyOperations");
    row("MaxNodesPerMethodCall", 1, "BadTooManyOperations");
    row("MaxMonitoredItemsPerCall", 100, "BadTooManyOperations");
    row("MaxMonitoredItems", 100, "BadTooManyMonitoredItems");
    row("MaxSubscriptions", 10, "BadTooManySubscriptions");
    row("MaxSessions", 10, "BadTooManySessions");
    row("MaxArrayLength", 200, "BadNodeIdUnknown");
    row("MaxByteStringLength", 16 << 20, "BadRequestTooLarge");
  }
  void limitsHold() {
    QFETCH(int, limit);
    QFETCH(QString, refusal);
    const QJsonObject tried = m_found[QStringLiteral("exceeded")]
                                  .toObject()[QString::fromUtf8(QTest::currentDataTag())]
                                  .toObject();
    QCOMPARE(tried[QStringLiteral("stated")].toInt(), limit);
    QCOMPARE(text(tried, "at"), QStringLiteral("Good"));
    QCOMPARE(text(tried, "beyond"), refusal);
  }

  /// A limit that is stated is one that is tested, here or with the positions.
  void noOtherLimitIsStated() {
    const QJsonObject tried = m_found[QStringLiteral("exceeded")].toObject();
    const QStringList ofLibrary{QStringLiteral("MaxBrowseContinuationPoints"),
                                QStringLiteral("MaxQueryContinuationPoints"),
                                QStringLiteral("MaxHistoryContinuationPoints")};
    for (const QString& name : stated().keys()) {
      QVERIFY2(!name.startsWith(QStringLiteral("Max")) || tried.contains(name) ||
                   ofLibrary.contains(name) || name == QStringLiteral("MaxMonitoredItemsQueueSize"),
               qPrintable(name));
    }
    const QJsonArray profiles = stated()[QStringLiteral("ServerProfileArray")].toArray();
    QCOMPARE(profiles.size(), 2);
    QVERIFY(profiles[0].toString().endsWith(QStringLiteral("/MicroEmbeddedDevice2017")));
  }

 private:
  [[nodiscard]] static QString text(const QJsonObject& object, const char* key) {
    return object[QString::fromUtf8(key)].toString();
  }
  [[nodiscard]] QString description(const char* name) const {
    return text(m_nodes[kChannel + QString::fromUtf8(name)], "description");
  }
  [[nodiscard]] QJsonObject member(const QString& id, const char* name) const {
    return m_nodes[id + QLatin1Char('/') + QString::fromUtf8(name)];
  }
  [[nodiscard]] QJsonObject stated() const { return m_found[QStringLiteral("stated")].toObject(); }

  QJsonObject m_found;
  QMap<QString, QJsonObject> m_nodes;
};

RIVULET_TEST(TestNodeWalk)
#include "tst_node_walk.moc"
