// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>
#include <open62541/plugin/historydata/history_data_backend_memory.h>
#include <open62541/plugin/historydata/history_data_gathering_default.h>
#include <open62541/plugin/historydata/history_database_default.h>
#include <open62541/server.h>
#include <open62541/server_config_default.h>

#include <QtTest>
#include <atomic>
#include <cstdarg>
#include <deque>
#include <thread>

#include "opcua/control_map.h"
#include "opcua/error.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/ua_link.h"
#include "support/test_program.h"
#include "trace/import/import.h"
#include "trace/motion.h"
#include "trace_fetch/history.h"
#include "trace_fetch/http.h"

using namespace rivulet;
using namespace rivulet::trace_fetch;

namespace {

constexpr base::UtcMs kStart = 1'767'322'800'000;  // 2026-01-02T03:00:00Z

/// A server with two recorded variables, ns=1;s=X and ns=1;s=Y, and two that are not:
/// ns=1;s=plain, and ns=1;s=unrecorded, which says it is.
class HistoryServer {
 public:
  /// @param valuesPerNode  of X and Y each
  explicit HistoryServer(int valuesPerNode) {
    m_logger.log = [](void*, UA_LogLevel, UA_LogCategory, const char*, va_list) {};
    UA_ServerConfig config{};
    config.logging = &m_logger;
    UA_ServerConfig_setMinimal(&config, 0, nullptr);
    UA_String_clear(&config.serverUrls[0]);
    config.serverUrls[0] = UA_String_fromChars("opc.tcp://127.0.0.1:0");
    m_gathering = UA_HistoryDataGathering_Default(2);
    config.historyDatabase = UA_HistoryDatabase_default(m_gathering);
    config.accessHistoryDataCapability = true;
    config.maxReturnDataValues = 7;  // a page
    m_server = UA_Server_newWithConfig(&config);
    for (const char* name : {"X", "Y"}) {
      const UA_NodeId id = add(name, UA_ACCESSLEVELMASK_HISTORYREAD);
      UA_HistorizingNodeIdSettings setting{};
      setting.historizingBackend =
          UA_HistoryDataBackend_Memory(1, static_cast<std::size_t>(valuesPerNode) + 1);
      setting.maxHistoryDataResponseSize = 7;
      setting.historizingUpdateStrategy = UA_HISTORIZINGUPDATESTRATEGY_USER;
      m_gathering.registerNodeId(m_server, m_gathering.context, &id, setting);
      for (int i = 0; i < valuesPerNode; ++i) {
        record(setting.historizingBackend, id, i, 0.5 * i, i == 3 && name[0] == 'X');
      }
    }
    add("plain", 0);
    add("unrecorded", UA_ACCESSLEVELMASK_HISTORYREAD);
    if (UA_Server_run_startup(m_server) != UA_STATUSCODE_GOOD) {
      qFatal("no server on 127.0.0.1");
    }
    m_endpoint =
        opcua::view(UA_Server_getConfig(m_server)->applicationDescription.discoveryUrls[0]);
    m_thread = std::thread([this] {
      while (!m_stop) {
        UA_Server_run_iterate(m_server, true);
      }
    });
  }
  ~HistoryServer() {
    m_stop = true;
    m_thread.join();
    UA_Server_run_shutdown(m_server);
    UA_Server_delete(m_server);
  }
  HistoryServer(const HistoryServer&) = delete;
  HistoryServer& operator=(const HistoryServer&) = delete;

  [[nodiscard]] const std::string& endpoint() const { return m_endpoint; }

 private:
  UA_NodeId add(const char* name, int rights) {
    UA_VariableAttributes attributes = UA_VariableAttributes_default;
    UA_Double zero = 0.0;
    UA_Variant_setScalar(&attributes.value, &zero, &UA_TYPES[UA_TYPES_DOUBLE]);
    attributes.dataType = UA_TYPES[UA_TYPES_DOUBLE].typeId;
    attributes.accessLevel = static_cast<UA_Byte>(UA_ACCESSLEVELMASK_READ | rights);
    attributes.historizing = rights != 0;
    std::string text = name;
    const UA_NodeId id = opcua::borrowNodeId(1, m_names.emplace_back(std::move(text)));
    UA_Server_addVariableNode(
        m_server, id, UA_NODEID_NUMERIC(0, UA_NS0ID_OBJECTSFOLDER),
        UA_NODEID_NUMERIC(0, UA_NS0ID_ORGANIZES),
        UA_QUALIFIEDNAME(1, const_cast<char*>(name)),  // NOLINT: it is only read
        UA_NODEID_NUMERIC(0, UA_NS0ID_BASEDATAVARIABLETYPE), attributes, nullptr, nullptr);
    return id;
  }
  void record(UA_HistoryDataBackend& backend, const UA_NodeId& id, int i, double value,
              bool isBad) {
    UA_DataValue one;
    UA_DataValue_init(&one);
    one.hasSourceTimestamp = one.hasServerTimestamp = one.hasValue = one.hasStatus = true;
    one.sourceTimestamp = UA_DATETIME_UNIX_EPOCH + (kStart + 10 * i) * UA_DATETIME_MSEC;
    one.serverTimestamp = one.sourceTimestamp;
    one.status = isBad ? UA_STATUSCODE_BADSENSORFAILURE : UA_STATUSCODE_GOOD;
    UA_Variant_setScalar(&one.value, &value, &UA_TYPES[UA_TYPES_DOUBLE]);
    backend.serverSetHistoryData(m_server, backend.context, nullptr, nullptr, &id, true, &one);
  }

  UA_Logger m_logger{};
  UA_HistoryDataGathering m_gathering{};
  UA_Server* m_server = nullptr;
  std::deque<std::string> m_names;
  std::string m_endpoint;
  std::atomic<bool> m_stop = false;
  std::thread m_thread;
};

std::unique_ptr<opcua::UaLink> linkTo(const HistoryServer& server) {
  opcua::ConnectOptions options;
  options.endpoint = server.endpoint();
  options.security = opcua::unencrypted();
  options.map = std::make_shared<opcua::ControlMap>();
  auto link = opcua::UaLink::connect(options);
  if (!link) {
    qFatal("%s", link.error().message.c_str());
  }
  return std::move(*link);
}

HistoryRequest requestOf(std::vector<std::string> nodes, int fromMs = 0, int untilMs = 60'000) {
  HistoryRequest request;
  for (const std::string& node : nodes) {
    request.nodes.push_back(*parseHistoryNode(node));
  }
  request.from = kStart + fromMs;
  request.until = kStart + untilMs;
  return request;
}

}  // namespace

class TestHistory : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void understandsNodes();
  void readsAllPages();
  void readsOnlyTheTimeThatIsAsked();
  void refusesWhatIsNotRecorded();
  void isBounded();
  void sortsAndBoundsWhatAServerSays();
};

void TestHistory::understandsNodes() {
  const auto node = parseHistoryNode("x_act=ns=2;s=Axis.X=1");
  QVERIFY(node && node->name == "x_act" && node->address == "ns=2;s=Axis.X=1");
  for (const char* wrong : {"", "x", "x=", "=i=5", "ns=2;s=X", "x=X", "x==5"}) {
    const auto none = parseHistoryNode(wrong);
    QVERIFY2(!none && none.error().code == FetchError::BadAddress, wrong);
  }
}

/// A reader without continuation points has seven values; one that takes the bad one has a position
/// there.
void TestHistory::readsAllPages() {
  const HistoryServer server(100);
  const auto link = linkTo(server);
  auto read = fetchHistory(*link, requestOf({"x_act=ns=1;s=X", "y_act=ns=1;s=Y"}), base::Budget());
  QVERIFY2(read.has_value(), read ? "" : read.error().text().c_str());
  QCOMPARE(read->signalList.size(), std::size_t{2});
  QCOMPARE(read->signalList[0].values.size(), std::size_t{100});
  QVERIFY(std::isnan(read->signalList[0].values[3]));
  QCOMPARE(read->signalList[1].values[3], 1.5);
  QCOMPARE(read->timeBases[0].at[99].time_since_epoch(),
           base::Duration(std::chrono::milliseconds(kStart + 990)));
  const auto imported = trace::importSignals(std::move(*read));
  QVERIFY(imported.has_value());
  QCOMPARE(trace::printColumnRoles(imported->columns), std::string("x_act=x_act,y_act=y_act"));
  const trace::Motion motion = trace::motionOf(*imported);
  QCOMPARE(motion.samples.size(), std::size_t{99});
  QCOMPARE(motion.samples.back().actualMm.x, 49.5);
}

void TestHistory::readsOnlyTheTimeThatIsAsked() {
  const HistoryServer server(100);
  const auto link = linkTo(server);
  const auto read = fetchHistory(*link, requestOf({"x=ns=1;s=X"}, 500, 600), base::Budget());
  QVERIFY(read.has_value());
  QCOMPARE(read->signalList[0].values.front(), 25.0);
  QVERIFY(read->signalList[0].values.back() <= 30.0);
  const auto none = fetchHistory(*link, requestOf({"x=ns=1;s=X"}, 50'000, 60'000), base::Budget());
  QVERIFY(!none);
  QVERIFY2(none.error().message.find("no values") != std::string::npos,
           none.error().text().c_str());
}

void TestHistory::refusesWhatIsNotRecorded() {
  const HistoryServer server(1);
  const auto link = linkTo(server);
  for (const auto& [node, words] :
       {std::pair("ns=1;s=plain", "or this user may not read it"),
        std::pair("ns=1;s=unrecorded", "whose attribute Historizing is true")}) {
    const auto none = fetchHistory(*link, requestOf({fmt::format("x={}", node)}), base::Budget());
    QVERIFY(!none);
    QVERIFY2(none.error().code == opcua::LinkError::NoHistory, none.error().text().c_str());
    QVERIFY2(none.error().message.find(words) != std::string::npos, none.error().text().c_str());
    QCOMPARE(none.error().context, std::string(node));
  }
  const auto missing = fetchHistory(*link, requestOf({"x=ns=1;s=nowhere"}), base::Budget());
  QVERIFY(!missing);
  QVERIFY2(missing.error().code == opcua::LinkError::VariableMissing,
           missing.error().text().c_str());
}

void TestHistory::isBounded() {
  const HistoryServer server(100);
  const auto link = linkTo(server);
  const auto none = fetchHistory(*link, requestOf({"x=ns=1;s=X"}), base::Budget(10'000));
  QVERIFY(!none && none.error().code == opcua::LinkError::TooManyItems);
  // The connection is as good as before.
  QVERIFY(fetchHistory(*link, requestOf({"x=ns=1;s=X"}), base::Budget()).has_value());
}

/// Not all servers send what was asked for, in order.
void TestHistory::sortsAndBoundsWhatAServerSays() {
  class Server : public opcua::NodeHistory {
   public:
    [[nodiscard]] base::Result<opcua::NodeValues> history(const std::string& /*address*/,
                                                          const opcua::HistorySpan& span) override {
      const std::int64_t from = span.fromUtcNs;
      return opcua::NodeValues{
          {{from + 30, 3.0}, {from + 10, 1.0}, {from + 10, 2.0}, {9'000'000'000'000'000'000, 7.0}},
          1};
    }
  };
  Server server;
  const auto read = fetchHistory(server, requestOf({"x=i=5"}), base::Budget());
  QVERIFY(read.has_value());
  const auto& values = read->signalList[0].values;
  QCOMPARE(std::vector<double>(values.begin(), values.end()), (std::vector<double>{2.0, 3.0}));
  QCOMPARE(trace::remarkText(read->remarks[0]).find("left out: 2,") != std::string::npos, true);
  QVERIFY(trace::remarkText(read->remarks[1]).find("instead: 1.") != std::string::npos);
}

RIVULET_TEST(TestHistory)
#include "tst_history.moc"
