// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The server as any other client sees it: address space, status codes, ports. A client of the
/// bare library asks, so that nothing of our link hides what goes over the wire.

#include <open62541/client.h>
#include <open62541/client_config_default.h>
#include <open62541/client_highlevel.h>
#include <open62541/client_subscriptions.h>

#include <QtTest>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "machine/front/clients.h"
#include "opcua/await.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/quiet_logger.h"
#include "support/empty_arrays.h"
#include "support/idle_connection.h"
#include "support/loopback_machine.h"
#include "support/patience.h"
#include "support/plain_client.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using tests::LoopbackMachine;

namespace {

class RawClient : public tests::PlainClient {
 public:
  using PlainClient::PlainClient;

  [[nodiscard]] UA_StatusCode read(const std::string& identifier) const {
    opcua::Handle<UA_Variant, UA_TYPES_VARIANT> value;
    return UA_Client_readValueAttribute(get(), opcua::borrowNodeId(2, identifier), value.get());
  }
  template <class T>
  [[nodiscard]] UA_StatusCode write(const std::string& identifier, T value,
                                    std::size_t type) const {
    const UA_Variant variant = opcua::borrowScalar(value, type);
    return UA_Client_writeValueAttribute(get(), opcua::borrowNodeId(2, identifier), &variant);
  }
  /// Type of the value of a node; null if it cannot be read.
  [[nodiscard]] const UA_DataType* typeOf(const std::string& identifier) const {
    opcua::Handle<UA_Variant, UA_TYPES_VARIANT> value;
    UA_Client_readValueAttribute(get(), opcua::borrowNodeId(2, identifier), value.get());
    return value->type;
  }
  /// Identifiers of the children of a node.
  [[nodiscard]] std::vector<std::string> children(const UA_NodeId& node) const {
    UA_BrowseDescription description;
    UA_BrowseDescription_init(&description);
    description.nodeId = node;
    description.referenceTypeId = opcua::standardNodeId(UA_NS0ID_HIERARCHICALREFERENCES);
    description.includeSubtypes = true;
    UA_BrowseRequest request;
    UA_BrowseRequest_init(&request);
    request.nodesToBrowse = &description;
    request.nodesToBrowseSize = 1;
    opcua::Handle<UA_BrowseResponse, UA_TYPES_BROWSERESPONSE> response;
    *response.get() = UA_Client_Service_browse(get(), request);
    std::vector<std::string> found;
    for (std::size_t i = 0; i < response->results[0].referencesSize; ++i) {
      const UA_NodeId& id = response->results[0].references[i].nodeId.nodeId;
      if (id.identifierType == UA_NODEIDTYPE_STRING) {
        found.emplace_back(opcua::view(id.identifier.string));
      }
    }
    return found;
  }

  /// Sessions of the server, also those that are not logged in: each has a node.
  [[nodiscard]] std::size_t sessions() const {
    UA_BrowseDescription description;
    UA_BrowseDescription_init(&description);
    description.nodeId =
        opcua::standardNodeId(UA_NS0ID_SERVER_SERVERDIAGNOSTICS_SESSIONSDIAGNOSTICSSUMMARY);
    description.referenceTypeId = opcua::standardNodeId(UA_NS0ID_HASCOMPONENT);
    UA_BrowseRequest request;
    UA_BrowseRequest_init(&request);
    request.nodesToBrowse = &description;
    request.nodesToBrowseSize = 1;
    opcua::Handle<UA_BrowseResponse, UA_TYPES_BROWSERESPONSE> response;
    *response.get() = UA_Client_Service_browse(get(), request);
    std::size_t count = 0;
    for (std::size_t i = 0; i < response->results[0].referencesSize; ++i) {
      const UA_NodeId& id = response->results[0].references[i].nodeId.nodeId;
      count += id.identifierType == UA_NODEIDTYPE_GUID ? 1U : 0U;
    }
    return count;
  }
};

/// Makes sessions and activates none of them.
class HalfOpener {
 public:
  explicit HalfOpener(const std::string& endpoint) : m_endpoint(endpoint) {
    UA_ClientConfig config{};
    config.logging = m_logger.handle();
    RIVULET_ASSERT(UA_ClientConfig_setDefault(&config) == UA_STATUSCODE_GOOD);
    m_client = UA_Client_newWithConfig(&config);
    RIVULET_ASSERT(UA_Client_connectSecureChannel(m_client, endpoint.c_str()) ==
                   UA_STATUSCODE_GOOD);
  }
  ~HalfOpener() { UA_Client_delete(m_client); }
  HalfOpener(const HalfOpener&) = delete;
  HalfOpener& operator=(const HalfOpener&) = delete;

  [[nodiscard]] UA_StatusCode createSession() const {
    UA_CreateSessionRequest request;
    UA_CreateSessionRequest_init(&request);
    request.endpointUrl = opcua::borrow(m_endpoint);
    request.requestedSessionTimeout = 3'600'000.0;
    opcua::Handle<UA_CreateSessionResponse, UA_TYPES_CREATESESSIONRESPONSE> response;
    __UA_Client_Service(m_client, &request, &UA_TYPES[UA_TYPES_CREATESESSIONREQUEST],
                        response.get(), &UA_TYPES[UA_TYPES_CREATESESSIONRESPONSE]);
    return response->responseHeader.serviceResult;
  }

 private:
  std::string m_endpoint;
  opcua::QuietLogger m_logger;
  UA_Client* m_client = nullptr;
};

}  // namespace

class TestFront : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theNamespaceHasItsUsualIndex() {
    const LoopbackMachine cell;
    const RawClient client(cell.endpoint());
    const UA_String uri = opcua::borrow("SinumerikVarProvider");
    UA_UInt16 index = 0;
    QCOMPARE(UA_Client_NamespaceGetIndex(client.get(), const_cast<UA_String*>(&uri), &index),
             UA_STATUSCODE_GOOD);
    QCOMPARE(index, UA_UInt16{2});
  }

  void browsingShowsTheFirstElementOnly() {
    const LoopbackMachine cell;
    const RawClient client(cell.endpoint());
    const auto node = [](const char* identifier) { return opcua::borrowNodeId(2, identifier); };
    const auto objects = client.children(opcua::standardNodeId(UA_NS0ID_OBJECTSFOLDER));
    QVERIFY((objects == std::vector<std::string>{"Sinumerik", "VirtualMachine"}));
    QVERIFY(
        (client.children(node("Sinumerik")) == std::vector<std::string>{"/Channel", "/Methods"}));
    QCOMPARE(client.children(node("/Channel")).size(), std::size_t{7});
    QVERIFY((client.children(node("/Channel/Parameter")) ==
             std::vector<std::string>{"/Channel/Parameter/R"}));
    QCOMPARE(client.children(node("/Channel/GeometricAxis")).size(), std::size_t{6});
    QCOMPARE(client.children(node("/Channel/MachineAxis")).size(), std::size_t{3});
    QCOMPARE(client.children(node("/Channel/State")).size(), std::size_t{5});
    QCOMPARE(client.children(node("/Channel/Spindle")).size(), std::size_t{0});
    QCOMPARE(client.children(node("/Channel/ProgramInfo")).size(), std::size_t{4});
    QCOMPARE(client.children(node("/Channel/ChannelDiagnose")).size(), std::size_t{1});
    QCOMPARE(client.children(node("/Methods")).size(), std::size_t{4});
  }

  void elementsThatAreNotListedExist() {
    const LoopbackMachine cell;
    const RawClient client(cell.endpoint());
    for (const char* identifier :
         {"/Channel/Parameter/R[u1,0]", "/Channel/Parameter/R[u1,99]", "/Channel/Parameter/R[11]",
          "/Channel/Parameter/R", "/Channel/GeometricAxis/aaAcsRel[u1,3]",
          "/Channel/GeometricAxis/toolBaseDistToGo[2]", "/Channel/MachineAxis/measPos1[u1,1]",
          "/Channel/State/actFeedRateIpo", "/Channel/ProgramInfo/progName",
          "/Channel/SelectedFunctions/ncFktAct[u1,8]"}) {
      QVERIFY2(client.read(identifier) == UA_STATUSCODE_GOOD, identifier);
    }
    for (const char* identifier :
         {"/Channel/Parameter/R[u1,100]", "/channel/parameter/r[u1,1]",
          "/Channel/Parameter/R[u2,1]", "/Channel/GeometricAxis/aaAcsRel[u1,0]",
          "/Channel/GeometricAxis/aaAcsRel[u1,4]"}) {
      QVERIFY2(client.read(identifier) == UA_STATUSCODE_BADNODEIDUNKNOWN, identifier);
    }
  }

  /// A machine serves what it has: one without tools and spindle has no variables for them.
  void toolsAndSpindleAreServedWhereTheyAre() {
    const LoopbackMachine mill({.preset = "dmu75-mill"});
    const LoopbackMachine bare;
    const RawClient client(mill.endpoint());
    const RawClient other(bare.endpoint());
    const auto node = [](const char* identifier) { return opcua::borrowNodeId(2, identifier); };
    QCOMPARE(client.children(node("/Channel/State")).size(), std::size_t{8});
    QCOMPARE(client.children(node("/Channel/Spindle")).size(), std::size_t{3});
    for (const char* identifier :
         {"/Channel/State/actTNumber", "/Channel/State/actDNumber", "/Channel/State/actToolIdent",
          "/Channel/Spindle/actSpeed[u1,1]", "/Channel/Spindle/cmdSpeed",
          "/Channel/Spindle/turnState[u1,1]", "/Channel/AuxiliaryFunctions/acAuxfuMValue[u1,5]",
          "/Channel/AuxiliaryFunctions/acAuxfuMValue[u1,6]"}) {
      QVERIFY2(client.read(identifier) == UA_STATUSCODE_GOOD, identifier);
      QVERIFY2(other.read(identifier) == UA_STATUSCODE_BADNODEIDUNKNOWN, identifier);
    }
  }

  void aliasesAreTheSameVariable() {
    const LoopbackMachine cell;
    const RawClient client(cell.endpoint());
    QCOMPARE(client.write("/Channel/Parameter/R[1]", 4.5, UA_TYPES_DOUBLE), UA_STATUSCODE_GOOD);
    for (const char* identifier : {"/Channel/Parameter/R[u1,1]", "/Channel/Parameter/R"}) {
      double value = 0.0;
      while (value == 0.0) {  // becomes visible at the next interpolation boundary
        opcua::Handle<UA_Variant, UA_TYPES_VARIANT> variant;
        QCOMPARE(UA_Client_readValueAttribute(client.get(), opcua::borrowNodeId(2, identifier),
                                              variant.get()),
                 UA_STATUSCODE_GOOD);
        const auto* number = opcua::scalarOf<UA_Double>(*variant.get(), UA_TYPES_DOUBLE);
        QVERIFY(number != nullptr);
        value = *number;
      }
      QCOMPARE(value, 4.5);
    }
  }

  void typesAreThoseOfTheControl() {
    const LoopbackMachine cell;
    const RawClient client(cell.endpoint());
    const std::map<std::string, std::size_t> types{
        {"/Channel/Parameter/R[u1,1]", UA_TYPES_DOUBLE},
        {"/Channel/GeometricAxis/aaDtew[u1,1]", UA_TYPES_DOUBLE},
        {"/Channel/State/progStatus", UA_TYPES_UINT16},
        {"/Channel/State/chanStatus", UA_TYPES_UINT16},
        {"/Channel/State/chanAlarm", UA_TYPES_UINT32},
        {"/Channel/ProgramInfo/actLineNumber", UA_TYPES_UINT32},
        {"/Channel/ProgramInfo/msg", UA_TYPES_STRING},
        {"/Channel/ChannelDiagnose/ipoBufLevel", UA_TYPES_UINT16}};
    for (const auto& [identifier, type] : types) {
      QVERIFY2(client.typeOf(identifier) == &UA_TYPES[type], identifier.c_str());
    }
  }

  /// An array is written as a whole, with as many finite doubles as it has, or not at all.
  void arraysKeepTheirShape() {
    const LoopbackMachine cell;
    const RawClient client(cell.endpoint());
    const auto write = [&client](std::span<const double> values) {
      UA_Variant variant;
      UA_Variant_init(&variant);
      UA_Variant_setArray(&variant, const_cast<double*>(values.data()), values.size(),
                          &UA_TYPES[UA_TYPES_DOUBLE]);
      return UA_Client_writeValueAttribute(
          client.get(), opcua::borrowNodeId(2, "/Channel/Parameter/R[u1,10,#3]"), &variant);
    };
    const std::array<double, 4> values{1.0, 2.0, 3.0, 4.0};
    const std::array<double, 3> notFinite{1.0, std::nan(""), 3.0};
    QCOMPARE(write(std::span(values).first(2)), UA_STATUSCODE_BADTYPEMISMATCH);
    QCOMPARE(write(values), UA_STATUSCODE_BADTYPEMISMATCH);
    QCOMPARE(write(notFinite), UA_STATUSCODE_BADOUTOFRANGE);
    double scalar = 5.0;
    UA_Variant variant = opcua::borrowScalar(scalar, UA_TYPES_DOUBLE);
    QCOMPARE(UA_Client_writeValueAttribute(
                 client.get(), opcua::borrowNodeId(2, "/Channel/Parameter/R[u1,10,12]"), &variant),
             UA_STATUSCODE_BADTYPEMISMATCH);
    QCOMPARE(cell.server().nodesServed(), 0U);
    QCOMPARE(write(std::span(values).first(3)), UA_STATUSCODE_GOOD);
    QCOMPARE(cell.server().nodesServed(), 1U);
    opcua::Handle<UA_Variant, UA_TYPES_VARIANT> back;
    QCOMPARE(UA_Client_readValueAttribute(
                 client.get(), opcua::borrowNodeId(2, "/Channel/Parameter/R[u1,9,13]"), back.get()),
             UA_STATUSCODE_GOOD);
    QVERIFY(UA_Variant_hasArrayType(back.get(), &UA_TYPES[UA_TYPES_DOUBLE]));
    const auto* numbers = static_cast<const double*>(back->data);
    QVERIFY((std::vector<double>(numbers, numbers + back->arrayLength) ==
             std::vector<double>{0.0, 1.0, 2.0, 3.0, 0.0}));
  }

  /// Array nodes are made when they are asked for: a client that asks for all of them meets a
  /// limit, and what is there already goes on working.
  void nobodyFillsTheMemoryWithArrays() {
    const LoopbackMachine cell;
    const RawClient client(cell.endpoint());
    std::vector<std::string> identifiers;
    for (int first = 0; first < 100; ++first) {
      for (int last = first; last < 100; ++last) {
        identifiers.push_back("/Channel/Parameter/R[u1," + std::to_string(first) + "," +
                              std::to_string(last) + "]");
        identifiers.push_back("/Channel/Parameter/R[u1," + std::to_string(first) + ",#" +
                              std::to_string(last - first + 1) + "]");
      }
    }
    std::size_t good = 0;
    constexpr std::size_t kBatch = 1000;
    for (std::size_t begin = 0; begin < identifiers.size(); begin += kBatch) {
      std::vector<UA_ReadValueId> items(std::min(kBatch, identifiers.size() - begin));
      for (std::size_t i = 0; i < items.size(); ++i) {
        UA_ReadValueId_init(&items[i]);
        items[i].nodeId = opcua::borrowNodeId(2, identifiers[begin + i]);
        items[i].attributeId = UA_ATTRIBUTEID_VALUERANK;
      }
      UA_ReadRequest request;
      UA_ReadRequest_init(&request);
      request.nodesToRead = items.data();
      request.nodesToReadSize = items.size();
      opcua::Handle<UA_ReadResponse, UA_TYPES_READRESPONSE> response;
      *response.get() = UA_Client_Service_read(client.get(), request);
      QCOMPARE(response->resultsSize, items.size());
      for (std::size_t i = 0; i < items.size(); ++i) {
        const UA_DataValue& value = response->results[i];
        good += value.hasValue && !value.hasStatus ? 1 : 0;
      }
    }
    QCOMPARE(identifiers.size(), std::size_t{10'100});
    QCOMPARE(good, std::size_t{10'000});
    opcua::Handle<UA_Variant, UA_TYPES_VARIANT> value;
    for (const std::string& identifier : {identifiers.front(), identifiers[5000]}) {
      QCOMPARE(UA_Client_readValueAttribute(client.get(), opcua::borrowNodeId(2, identifier),
                                            value.get()),
               UA_STATUSCODE_GOOD);
      UA_Variant_clear(value.get());
    }
    QCOMPARE(UA_Client_readValueAttribute(client.get(), opcua::borrowNodeId(2, identifiers.back()),
                                          value.get()),
             UA_STATUSCODE_BADNODEIDUNKNOWN);
  }

  void refusedWritesSayWhyAndCostNothing() {
    const LoopbackMachine cell;
    const RawClient client(cell.endpoint());
    QCOMPARE(client.write("/Channel/Parameter/R[u1,1]", UA_Int32{1}, UA_TYPES_INT32),
             UA_STATUSCODE_BADTYPEMISMATCH);
    QCOMPARE(client.write("/Channel/Parameter/R[u1,1]", std::numeric_limits<double>::quiet_NaN(),
                          UA_TYPES_DOUBLE),
             UA_STATUSCODE_BADOUTOFRANGE);
    QCOMPARE(client.write("/Channel/State/actFeedRateIpo", 1.0, UA_TYPES_DOUBLE),
             UA_STATUSCODE_BADNOTWRITABLE);
    QCOMPARE(client.write("/Channel/Parameter/R[u1,100]", 1.0, UA_TYPES_DOUBLE),
             UA_STATUSCODE_BADNODEIDUNKNOWN);
    QCOMPARE(cell.server().nodesServed(), 0U);
  }

  void nobodyRebuildsTheAddressSpace() {
    const LoopbackMachine cell;
    const RawClient client(cell.endpoint());
    const std::string identifier = "/Channel/Parameter/R[u1,1]";
    QVERIFY(UA_Client_deleteNode(client.get(), opcua::borrowNodeId(2, identifier), true) !=
            UA_STATUSCODE_GOOD);
    QCOMPARE(client.read(identifier), UA_STATUSCODE_GOOD);
  }

  /// A subscription samples through the same service and so costs it nodes.
  /// An object is no method. The library leaves such a call to a worker that nobody has started.
  void aCallOfAnObjectIsAnswered() {
    const LoopbackMachine cell;
    const RawClient client(cell.endpoint());
    UA_CallMethodRequest call;
    UA_CallMethodRequest_init(&call);
    call.objectId = opcua::standardNodeId(UA_NS0ID_SERVER);
    call.methodId = call.objectId;
    UA_CallRequest request;
    UA_CallRequest_init(&request);
    request.methodsToCall = &call;
    request.methodsToCallSize = 1;
    opcua::Handle<UA_CallResponse, UA_TYPES_CALLRESPONSE> response;
    *response.get() = UA_Client_Service_call(client.get(), request);
    QCOMPARE(response->responseHeader.serviceResult, UA_STATUSCODE_GOOD);
    QCOMPARE(response->resultsSize, std::size_t{1});
    QVERIFY(UA_StatusCode_isBad(response->results[0].statusCode));
  }

  /// The library takes them for scalars, and their data point at nothing.
  void emptyArraysAreNoArguments() {
    const LoopbackMachine cell;
    const auto answersOf = [&cell](std::string_view uri, std::string_view object,
                                   std::string_view name, const std::vector<std::size_t>& inputs) {
      return tests::callWithEmptyArrays(
          cell.endpoint(), {uri, object, opcua::memberIdentifier(object, name), inputs});
    };
    const std::array refused{UA_STATUSCODE_BADINVALIDARGUMENT, UA_STATUSCODE_BADINVALIDARGUMENT};
    QVERIFY(answersOf(opcua::kNamespaceUri, opcua::kMethodsObject, opcua::kCopyToServer,
                      {UA_TYPES_STRING, UA_TYPES_BYTESTRING, UA_TYPES_BOOLEAN}) == refused);
    QVERIFY(answersOf(opcua::kNamespaceUri, opcua::kMethodsObject, opcua::kSelect,
                      {UA_TYPES_STRING, UA_TYPES_UINT32}) == refused);
    QVERIFY(answersOf(opcua::kVirtualNamespaceUri, opcua::kVirtualObject, opcua::kFetchTrace,
                      {UA_TYPES_UINT64}) == refused);
  }

  void subscriptionsCostTheServiceToo() {
    const LoopbackMachine cell;
    const RawClient client(cell.endpoint());
    const UA_CreateSubscriptionResponse subscription = UA_Client_Subscriptions_create(
        client.get(), UA_CreateSubscriptionRequest_default(), nullptr, nullptr, nullptr);
    QCOMPARE(subscription.responseHeader.serviceResult, UA_STATUSCODE_GOOD);
    const std::string identifier = "/Channel/Parameter/R[u1,1]";
    UA_MonitoredItemCreateRequest request =
        UA_MonitoredItemCreateRequest_default(opcua::borrowNodeId(2, identifier));
    request.requestedParameters.samplingInterval = 1.0;
    const UA_MonitoredItemCreateResult item = UA_Client_MonitoredItems_createDataChange(
        client.get(), subscription.subscriptionId, UA_TIMESTAMPSTORETURN_NEITHER, request, nullptr,
        [](UA_Client*, UA_UInt32, void*, UA_UInt32, void*, UA_DataValue*) {}, nullptr);
    QCOMPARE(item.statusCode, UA_STATUSCODE_GOOD);
    QCOMPARE(item.revisedSamplingInterval, 100.0);  // the shortest, as on the control
    QTRY_VERIFY_WITH_TIMEOUT(cell.server().nodesServed() >= 3, 60'000);
  }

  /// Only the client that copies waits for its copy; 10 s pass before it is answered.
  void aLargeCopyHoldsUpNobodyElse() {
    LoopbackMachine::Options options;
    options.preset = "dmu75";
    const LoopbackMachine cell(options);
    const auto copying = cell.connect();
    const auto reading = cell.connect();
    static_cast<void>(copying->store("LARGE.SPF", std::string(std::size_t{2} << 20U, ' '), 60s));
    static_cast<void>(copying->wait(copying->now() + 50ms));
    const std::array watched{opcua::rParameter(1)};
    for (int i = 0; i < 20; ++i) {
      QVERIFY(opcua::readNumbers(*reading, watched, 5s).has_value());
    }
    QVERIFY(!copying->wait(copying->now()).has_value());
    // A small one is answered when its time has come; what follows keeps its order.
    const base::RequestId small = reading->store("SMALL.SPF", "M17\n", 60s);
    const base::RequestId after = reading->read(watched, 60s, opcua::Grouping::List);
    const auto first = reading->wait(reading->now() + 60s);
    const auto second = reading->wait(reading->now() + 60s);
    QVERIFY(first && first->request == small && first->kind == opcua::EventKind::WriteDone);
    QVERIFY(second && second->request == after && second->kind == opcua::EventKind::ReadDone);
    QVERIFY(first->at - first->sent >= 100ms);
  }

  /// Ten clients that vanished have the ten sessions; the eleventh gets one all the same.
  void orphanedSessionsLockNobodyOut() {
    const LoopbackMachine cell;
    std::vector<std::unique_ptr<RawClient>> gone;
    for (int i = 0; i < 10; ++i) {
      gone.push_back(std::make_unique<RawClient>(cell.endpoint()));
    }
    for (const auto& client : gone) {
      UA_Client_disconnectSecureChannel(client->get());  // without closing the session
    }
    for (int i = 0; i < 10; ++i) {
      QCOMPARE(RawClient(cell.endpoint()).read("/Channel/State/chanStatus"), UA_STATUSCODE_GOOD);
    }
  }

  /// Sessions that nobody activates have a share of their own, and a short time.
  void halfOpenSessionsLockNobodyOut() {
    const LoopbackMachine cell;
    const HalfOpener first(cell.endpoint());
    const HalfOpener second(cell.endpoint());
    const RawClient watching(cell.endpoint());
    for (int i = 0; i < 20; ++i) {
      QCOMPARE(first.createSession(), UA_STATUSCODE_GOOD);
      QCOMPARE(second.createSession(), UA_STATUSCODE_GOOD);
    }
    QCOMPARE(watching.sessions(), 1 + machine::kHalfOpenPerAddress);
    std::vector<std::unique_ptr<RawClient>> clients;
    for (int i = 0; i < 9; ++i) {
      clients.push_back(std::make_unique<RawClient>(cell.endpoint()));
      QCOMPARE(clients.back()->read("/Channel/State/chanStatus"), UA_STATUSCODE_GOOD);
      QCOMPARE(first.createSession(), UA_STATUSCODE_GOOD);
    }
    QCOMPARE(watching.sessions(), 10 + machine::kHalfOpenPerAddress);
    QTRY_COMPARE_WITH_TIMEOUT(watching.sessions(), std::size_t{10}, tests::kSoonMs);
    // Sessions that are logged in have their own limit.
    UA_ClientConfig config{};
    opcua::QuietLogger logger;
    config.logging = logger.handle();
    QCOMPARE(UA_ClientConfig_setDefault(&config), UA_STATUSCODE_GOOD);
    UA_Client* eleventh = UA_Client_newWithConfig(&config);
    QCOMPARE(UA_Client_connect(eleventh, cell.endpoint().c_str()),
             UA_STATUSCODE_BADTOOMANYSESSIONS);
    UA_Client_delete(eleventh);
    for (const auto& client : clients) {
      QCOMPARE(client->read("/Channel/State/chanStatus"), UA_STATUSCODE_GOOD);
    }
  }

  /// Who opens connections and sends nothing takes no more than a half of those that nobody has
  /// logged in on, and ends none of another address.
  void idleConnectionsOfOneAddressLockNobodyOut() {
    const LoopbackMachine cell;
    const RawClient watching(cell.endpoint());
    const tests::IdleConnection slow(cell.endpoint(), "127.0.0.3");
    tests::IdleConnections flood;
    for (int i = 0; i < 10; ++i) {
      flood.open(cell.endpoint(), "127.0.0.2", 10);
      QTRY_COMPARE_WITH_TIMEOUT(flood.stillOpen(), std::size_t{5}, tests::kSoonMs);
      QVERIFY(slow.isOpen());
      QCOMPARE(RawClient(cell.endpoint()).read("/Channel/State/chanStatus"), UA_STATUSCODE_GOOD);
    }
    // Of several addresses, the ones with most of them lose theirs.
    tests::IdleConnections more;
    more.open(cell.endpoint(), "127.0.0.4", 10);
    QTRY_COMPARE_WITH_TIMEOUT(flood.stillOpen() + more.stillOpen(), std::size_t{9}, tests::kSoonMs);
    QVERIFY(slow.isOpen());
    QCOMPARE(RawClient(cell.endpoint()).read("/Channel/State/chanStatus"), UA_STATUSCODE_GOOD);
    QCOMPARE(watching.read("/Channel/State/chanStatus"), UA_STATUSCODE_GOOD);
  }

  /// A client that is there keeps its run; the run of one that is gone can be reset.
  void nobodyResetsTheRunOfAnother() {
    const LoopbackMachine cell;
    auto starter = cell.connect();
    const auto other = cell.connect();
    QVERIFY(starter->uploadProgram("WAITS.MPF", "G4 F1000\nM30\n", true).has_value());
    QVERIFY(starter->selectProgram("WAITS.MPF").has_value());
    QVERIFY(starter->cycleStart().has_value());
    const auto refused = other->reset();
    QVERIFY(!refused && refused.error().code == opcua::LinkError::Rejected);
    const auto overwritten = other->uploadProgram("waits.mpf", "M30\n", true);
    QVERIFY(!overwritten && overwritten.error().code == opcua::LinkError::ChannelNotInReset);
    QCOMPARE(other->downloadProgram("WAITS.MPF").value(), std::string("G4 F1000\nM30\n"));
    QVERIFY(other->uploadProgram("ELSE.MPF", "M30\n", true).has_value());
    QVERIFY(starter->reset().has_value());
    QTRY_VERIFY(other->reset().has_value());  // in reset, which takes a moment, it does no harm
    QVERIFY(starter->cycleStart().has_value());
    starter.reset();
    // Once the server has noticed that it is gone, and the axes have stopped.
    QTRY_VERIFY(other->reset().has_value());
    QTRY_VERIFY(other->uploadProgram("WAITS.MPF", "M30\n", true).has_value());
  }

  void aTakenPortIsOneClearSentence() {
    const LoopbackMachine cell;
    machine::ServerOptions options;
    options.port = static_cast<std::uint16_t>(
        std::stoi(cell.endpoint().substr(cell.endpoint().rfind(':') + 1)));
    machine::Machine machine(*machine::loadPreset("ideal"), 1);
    const auto second = machine::Server::start(machine, options);
    QVERIFY(!second);
    QVERIFY(second.error().code == machine::FrontError::PortTaken);
    QVERIFY(second.error().message.find(std::to_string(options.port)) != std::string::npos);

    options.host = "no host";
    const auto nowhere = machine::Server::start(machine, options);
    QVERIFY(!nowhere);
    QVERIFY(nowhere.error().code == machine::FrontError::AddressUnusable);
  }

  /// The operating system keeps a port busy for a while after its connections were closed.
  void aPortCanBeUsedAgainAtOnce() {
    LoopbackMachine::Options options;
    {
      LoopbackMachine cell;
      options.port = static_cast<std::uint16_t>(
          std::stoi(cell.endpoint().substr(cell.endpoint().rfind(':') + 1)));
      const auto link = cell.connect();
      cell.stop();  // the server closes first
    }
    const LoopbackMachine again(options);
    QVERIFY(again.connect()->isVirtualMachine());
  }
};

RIVULET_TEST(TestFront)
#include "tst_front.moc"
