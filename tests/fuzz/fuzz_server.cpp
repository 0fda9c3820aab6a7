// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Any well-formed OPC UA request is answered by the server of the virtual machine: first a byte
// that says which service, then the request as it is encoded. New requests are made of the
// machine's own node identifiers and of values of all kinds.

#include <open62541/client.h>
#include <open62541/client_config_default.h>
#include <sanitizer/lsan_interface.h>

#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "base/random.h"
#include "fuzz/memory_network.h"
#include "fuzz/require.h"
#include "fuzz/ua_values.h"
#include "machine/front/server.h"
#include "machine/machine.h"
#include "opcua/node_map.h"
#include "opcua/open62541/handle.h"

using namespace rivulet;
using tests::require;

namespace {

struct Service {
  std::size_t request;
  std::size_t response;
};

constexpr std::array<Service, 8> kServices{
    {{UA_TYPES_READREQUEST, UA_TYPES_READRESPONSE},
     {UA_TYPES_WRITEREQUEST, UA_TYPES_WRITERESPONSE},
     {UA_TYPES_CALLREQUEST, UA_TYPES_CALLRESPONSE},
     {UA_TYPES_BROWSEREQUEST, UA_TYPES_BROWSERESPONSE},
     {UA_TYPES_TRANSLATEBROWSEPATHSTONODEIDSREQUEST,
      UA_TYPES_TRANSLATEBROWSEPATHSTONODEIDSRESPONSE},
     {UA_TYPES_REGISTERNODESREQUEST, UA_TYPES_REGISTERNODESRESPONSE},
     {UA_TYPES_ADDNODESREQUEST, UA_TYPES_ADDNODESRESPONSE},
     {UA_TYPES_DELETENODESREQUEST, UA_TYPES_DELETENODESRESPONSE}}};

/// Longest wait for an answer, of the simulated clock.
constexpr std::chrono::seconds kPatience{2};
/// What the machine does between two requests.
constexpr std::chrono::milliseconds kPause{1};

/// A machine with its server, and a client of the library that is connected to it.
class World {
 public:
  World() : m_machine(*machine::loadPreset("ideal"), 1) {
    // Adding methods with arguments, libopen62541 1.4 loses their 11 identifiers.
    __lsan_disable();
    auto server = machine::Server::start(m_machine, {});
    __lsan_enable();
    require(server.has_value());
    m_server = std::move(*server);
    require(m_machine.storeProgram("A.MPF", "G1 X1 F1000\nM30\n", true).has_value());
    require(m_machine.selectProgram("A.MPF").has_value());
    m_logger.log = [](void*, UA_LogLevel, UA_LogCategory, const char*, va_list) {};
    connect();
  }
  ~World() { disconnect(); }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Sends a request and waits for its answer.
  void serve(const Service& service, void* request) {
    if (!isConnected()) {
      disconnect();
      connect();
    }
    bool answered = false;
    const UA_StatusCode sent = __UA_Client_AsyncService(
        m_client, request, &UA_TYPES[service.request],
        [](UA_Client*, void* seen, UA_UInt32, void*) { *static_cast<bool*>(seen) = true; },
        &UA_TYPES[service.response], &answered, nullptr);
    const auto until = Clock::now() + kPatience;
    while (sent == UA_STATUSCODE_GOOD && !answered && isConnected() && Clock::now() < until) {
      turn();
    }
    // A request that the library could not send, or that broke the connection, has no answer.
    require(answered || sent != UA_STATUSCODE_GOOD || !isConnected());
    if (!answered) {
      disconnect();
      connect();
    }
    m_server->iterate(kPause);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void connect() {
    UA_ClientConfig config{};
    config.logging = &m_logger;
    require(UA_ClientConfig_setDefault(&config) == UA_STATUSCODE_GOOD);
    m_client = UA_Client_newWithConfig(&config);
    require(UA_Client_connectAsync(m_client, m_server->endpoint().c_str()) == UA_STATUSCODE_GOOD);
    const auto until = Clock::now() + kPatience;
    while (!isConnected() && Clock::now() < until) {
      turn();
    }
    require(isConnected());
  }
  void disconnect() {
    tests::setPartner([this] { m_server->iterate({}); });
    UA_Client_delete(m_client);
    tests::setPartner({});
    m_server->iterate({});
  }
  [[nodiscard]] bool isConnected() {
    UA_SessionState session = UA_SESSIONSTATE_CLOSED;
    UA_Client_getState(m_client, nullptr, &session, nullptr);
    return session == UA_SESSIONSTATE_ACTIVATED;
  }
  void turn() {
    UA_Client_run_iterate(m_client, 0);
    m_server->iterate(kPause);
  }

  machine::Machine m_machine;
  std::unique_ptr<machine::Server> m_server;
  UA_Logger m_logger{};
  UA_Client* m_client = nullptr;
};

/// A node of the machine, or one that it does not have.
std::string identifier(base::Random& random) {
  static const std::vector<std::string> kNames{"/Channel/State/chanStatus",
                                               "/Channel/State/progStatus",
                                               "/Channel/State/actFeedRateIpo",
                                               "/Channel/GeometricAxis/name[u1,1]",
                                               "/Channel/ProgramInfo/progName",
                                               "/Methods",
                                               "Sinumerik",
                                               std::string(opcua::kVirtualObject)};
  static const std::vector<std::string_view> kMethods{
      opcua::kCopyToServer, opcua::kCopyFromServer, opcua::kSelect,     opcua::kGetMyAccessRights,
      opcua::kCycleStart,   opcua::kReset,          opcua::kFetchTrace, opcua::kFetchTracePiece};
  const auto number = [&random] {
    return std::to_string(random.below(4) == 0 ? random.below(1U << 31U) : random.below(110));
  };
  switch (random.below(5)) {
    case 0:
      return kNames[random.below(kNames.size())];
    case 1:
      return opcua::memberIdentifier(
          random.below(2) == 0 ? opcua::kMethodsObject : opcua::kVirtualObject,
          kMethods[random.below(kMethods.size())]);
    case 2:
      return "/Channel/Parameter/R[u1," + number() + "," + number() + "]";
    case 3:
      return "/Channel/Parameter/R[u1," + number() + "]";
    default:
      return "/Channel/Parameter/R[" + number() + "]";
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static World world;
  if (size == 0) {
    return 0;
  }
  const Service& service = kServices[data[0] % kServices.size()];
  tests::Decoded request(tests::textOf(data + 1, size - 1), service.request);
  if (request.isGood()) {
    world.serve(service, request.get());
  }
  return 0;
}

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t sizeMax, unsigned seed) {
  base::Random random(seed);
  if (random.below(4) != 0) {
    return LLVMFuzzerMutate(data, size, sizeMax);
  }
  const std::size_t kind = random.below(3);
  const std::string node = identifier(random);
  const auto space = static_cast<UA_UInt16>(random.below(5));
  const UA_NodeId id = opcua::borrowNodeId(space, node);
  tests::Values values(random);
  std::string encoded;
  if (kind == 0) {
    UA_ReadValueId item;
    UA_ReadValueId_init(&item);
    item.nodeId = id;
    item.attributeId =
        random.below(8) == 0 ? static_cast<UA_UInt32>(random.below(30)) : UA_ATTRIBUTEID_VALUE;
    const std::string range = random.below(2) == 0 ? values.range() : std::string();
    item.indexRange = opcua::borrow(range);
    std::vector<UA_ReadValueId> items(1 + random.below(9), item);
    UA_ReadRequest request;
    UA_ReadRequest_init(&request);
    request.nodesToRead = items.data();
    request.nodesToReadSize = items.size();
    encoded = tests::encoded(request, UA_TYPES_READREQUEST);
  } else if (kind == 1) {
    UA_WriteValue item;
    UA_WriteValue_init(&item);
    item.nodeId = id;
    item.attributeId = UA_ATTRIBUTEID_VALUE;
    const std::string range = random.below(3) == 0 ? values.range() : std::string();
    item.indexRange = opcua::borrow(range);
    item.value.hasValue = true;
    item.value.value = values.variant();
    std::vector<UA_WriteValue> items(1 + random.below(9), item);
    UA_WriteRequest request;
    UA_WriteRequest_init(&request);
    request.nodesToWrite = items.data();
    request.nodesToWriteSize = items.size();
    encoded = tests::encoded(request, UA_TYPES_WRITEREQUEST);
  } else {
    const std::size_t cut = node.rfind('/');
    const std::string object = cut == std::string::npos ? node : node.substr(0, cut);
    UA_CallMethodRequest item;
    UA_CallMethodRequest_init(&item);
    item.objectId = opcua::borrowNodeId(space, object);
    item.methodId = id;
    std::vector<UA_Variant> inputs;
    for (std::size_t i = random.below(6); i > 0; --i) {
      inputs.push_back(values.variant());
    }
    item.inputArguments = inputs.data();
    item.inputArgumentsSize = inputs.size();
    UA_CallRequest request;
    UA_CallRequest_init(&request);
    request.methodsToCall = &item;
    request.methodsToCallSize = 1;
    encoded = tests::encoded(request, UA_TYPES_CALLREQUEST);
  }
  return tests::replacedBy(encoded, static_cast<std::uint8_t>(kind), data, size, sizeMax);
}
