// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Any well-formed answer of an OPC UA server is taken by the client: first a byte that says what
// the client asks for, then the values of variables (as a ReadResponse) or the outputs of a method
// (as a CallMethodResult). New answers are made of values of all kinds, and of pieces of a trace.
// With the highest bit of the first byte, three more bytes say what becomes damaged on the way.

#include <open62541/server.h>
#include <open62541/server_config_default.h>

#include <algorithm>
#include <chrono>
#include <cstdarg>
#include <memory>
#include <string>
#include <vector>

#include "base/random.h"
#include "fuzz/memory_network.h"
#include "fuzz/require.h"
#include "fuzz/ua_values.h"
#include "opcua/node_map.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/ua_link.h"
#include "support/soiled_stack.h"
#include "trace/control_trace.h"

using namespace rivulet;
using opcua::Variable;
using opcua::VariableKind;
using tests::require;

namespace {

constexpr base::Duration kPatience = std::chrono::seconds{2};
constexpr int kArrayFirst = 10;
constexpr int kArrayCount = 20;
constexpr int kConnectionsMax = 1000;

const std::vector<Variable>& variables() {
  static const std::vector<Variable> all = [] {
    std::vector<Variable> list{{VariableKind::ChannelStatus, 0}, {VariableKind::ProgramName, 0},
                               {VariableKind::PathFeed, 0},      {VariableKind::AxisName, 1},
                               {VariableKind::Alarm, 0},         {VariableKind::GFunction, 8}};
    for (int cell = 0; cell < 6; ++cell) {
      list.push_back({VariableKind::RParameter, cell});
    }
    return list;
  }();
  return all;
}

/// A server of the library that answers with what it is told, while its client waits.
class Answers {
 public:
  Answers() {
    m_logger.log = [](void*, UA_LogLevel, UA_LogCategory, const char*, va_list) {};
    UA_ServerConfig config{};
    config.logging = &m_logger;
    require(UA_ServerConfig_setMinimal(&config, 0, nullptr) == UA_STATUSCODE_GOOD);
    config.maxSecureChannels = config.maxSessions = 2 * kConnectionsMax;  // damage leaves some open
    UA_String_clear(&config.serverUrls[0]);
    config.serverUrls[0] = UA_String_fromChars("opc.tcp://127.0.0.1:0");
    m_server = UA_Server_newWithConfig(&config);
    m_control = UA_Server_addNamespace(m_server, std::string(opcua::kNamespaceUri).c_str());
    m_beyond = UA_Server_addNamespace(m_server, std::string(opcua::kVirtualNamespaceUri).c_str());
    for (const Variable& variable : variables()) {
      addVariable(opcua::nodeIdentifier(variable));
    }
    for (const opcua::Grouping form : {opcua::Grouping::ArrayCount, opcua::Grouping::ArrayRange}) {
      addVariable(opcua::arrayIdentifier({kArrayFirst, kArrayCount, form}));
    }
    addObject(m_beyond, opcua::kVirtualObject);
    addObject(m_control, opcua::kMethodsObject);
    for (const std::string_view name :
         {opcua::kCycleStart, opcua::kReset, opcua::kFetchTrace, opcua::kFetchTracePiece}) {
      addMethod(m_beyond, opcua::kVirtualObject, name);
    }
    for (const std::string_view name : {opcua::kCopyToServer, opcua::kCopyFromServer,
                                        opcua::kSelect, opcua::kGetMyAccessRights}) {
      addMethod(m_control, opcua::kMethodsObject, name);
    }
    require(UA_Server_run_startup(m_server) == UA_STATUSCODE_GOOD);
    m_endpoint =
        opcua::view(UA_Server_getConfig(m_server)->applicationDescription.discoveryUrls[0]);
    tests::setPartner([this] { UA_Server_run_iterate(m_server, false); });
  }
  ~Answers() {
    tests::setPartner({});
    UA_Server_run_shutdown(m_server);
    UA_Server_delete(m_server);
  }
  Answers(const Answers&) = delete;
  Answers& operator=(const Answers&) = delete;

  [[nodiscard]] const std::string& endpoint() const { return m_endpoint; }
  /// What is answered from now on. @param values,outputs  null: nothing special; they stay the
  /// caller's
  void tell(const UA_ReadResponse* values, const UA_CallMethodResult* outputs) {
    m_values = values;
    m_outputs = outputs;
    m_next = 0;
  }

 private:
  static UA_StatusCode onRead(UA_Server*, const UA_NodeId*, void*, const UA_NodeId*, void* context,
                              UA_Boolean, const UA_NumericRange*, UA_DataValue* value) noexcept {
    auto& self = *static_cast<Answers*>(context);
    if (self.m_values == nullptr || self.m_values->resultsSize == 0) {
      value->hasStatus = true;
      value->status = UA_STATUSCODE_BADNODATA;
      return UA_STATUSCODE_GOOD;
    }
    return UA_DataValue_copy(&self.m_values->results[self.m_next++ % self.m_values->resultsSize],
                             value);
  }
  static UA_StatusCode onWrite(UA_Server*, const UA_NodeId*, void*, const UA_NodeId*, void*,
                               const UA_NumericRange*, const UA_DataValue*) noexcept {
    return UA_STATUSCODE_GOOD;
  }
  static UA_StatusCode onCall(UA_Server*, const UA_NodeId*, void*, const UA_NodeId*, void* context,
                              const UA_NodeId*, void*, std::size_t, const UA_Variant*,
                              std::size_t outputSize, UA_Variant* output) noexcept {
    auto& self = *static_cast<Answers*>(context);
    if (self.m_outputs == nullptr) {
      return UA_STATUSCODE_BADNOTSUPPORTED;
    }
    for (std::size_t i = 0; i < std::min(outputSize, self.m_outputs->outputArgumentsSize); ++i) {
      UA_Variant_copy(&self.m_outputs->outputArguments[i], &output[i]);
    }
    return self.m_outputs->statusCode;
  }

  void addVariable(const std::string& identifier) {
    UA_VariableAttributes attributes = UA_VariableAttributes_default;
    attributes.accessLevel = UA_ACCESSLEVELMASK_READ | UA_ACCESSLEVELMASK_WRITE;
    attributes.valueRank = UA_VALUERANK_ANY;
    UA_Server_addDataSourceVariableNode(m_server, opcua::borrowNodeId(m_control, identifier),
                                        opcua::standardNodeId(UA_NS0ID_OBJECTSFOLDER),
                                        opcua::standardNodeId(UA_NS0ID_ORGANIZES),
                                        UA_QualifiedName{m_control, opcua::borrow(identifier)},
                                        opcua::standardNodeId(UA_NS0ID_BASEDATAVARIABLETYPE),
                                        attributes, {&onRead, &onWrite}, this, nullptr);
  }
  void addObject(UA_UInt16 space, std::string_view identifier) {
    require(UA_Server_addObjectNode(m_server, opcua::borrowNodeId(space, identifier),
                                    opcua::standardNodeId(UA_NS0ID_OBJECTSFOLDER),
                                    opcua::standardNodeId(UA_NS0ID_ORGANIZES),
                                    UA_QualifiedName{space, opcua::borrow(identifier)},
                                    opcua::standardNodeId(UA_NS0ID_BASEOBJECTTYPE),
                                    UA_ObjectAttributes_default, nullptr,
                                    nullptr) == UA_STATUSCODE_GOOD);
  }
  /// With any inputs, and as many outputs as any of the methods has.
  void addMethod(UA_UInt16 space, std::string_view object, std::string_view name) {
    UA_MethodAttributes attributes = UA_MethodAttributes_default;
    attributes.executable = true;
    attributes.userExecutable = true;
    const std::size_t inputs = name == opcua::kFetchTracePiece                                ? 4
                               : name == opcua::kCopyToServer                                 ? 3
                               : name == opcua::kSelect                                       ? 2
                               : name == opcua::kFetchTrace || name == opcua::kCopyFromServer ? 1
                                                                                              : 0;
    std::vector<UA_Argument> arguments(6);
    for (UA_Argument& argument : arguments) {
      UA_Argument_init(&argument);
      argument.dataType = opcua::standardNodeId(UA_NS0ID_BASEDATATYPE);
      argument.valueRank = UA_VALUERANK_ANY;
    }
    require(UA_Server_addMethodNode(
                m_server, opcua::borrowNodeId(space, opcua::memberIdentifier(object, name)),
                opcua::borrowNodeId(space, object), opcua::standardNodeId(UA_NS0ID_HASCOMPONENT),
                UA_QualifiedName{space, opcua::borrow(name)}, attributes, &onCall, inputs,
                arguments.data(), arguments.size(), arguments.data(), this,
                nullptr) == UA_STATUSCODE_GOOD);
  }

  UA_Logger m_logger{};
  UA_Server* m_server = nullptr;
  UA_UInt16 m_control = 0;
  UA_UInt16 m_beyond = 0;
  std::string m_endpoint;
  const UA_ReadResponse* m_values = nullptr;
  const UA_CallMethodResult* m_outputs = nullptr;
  std::size_t m_next = 0;
};

enum class Ask {
  List,
  Single,
  Count,
  Range,
  Piece,
  PieceLater,
  Trace,
  Start,
  Reset,
  Select,
  Program,
  Rights,
  Number
};

class World {
 public:
  World() { connect(); }

  void ask(Ask what, const UA_ReadResponse* values, const UA_CallMethodResult* outputs) {
    m_answers.tell(values, outputs);
    carryOut(what);
    m_answers.tell(nullptr, nullptr);
  }
  /// So many that the server has become slow: each session leaves holes in its store of nodes.
  [[nodiscard]] bool isWorn() const { return m_connections > kConnectionsMax; }

 private:
  void connect() {
    ++m_connections;
    tests::setDamage({});
    opcua::ConnectOptions options;
    options.endpoint = m_answers.endpoint();
    options.security = opcua::unencrypted();
    options.commandDeadline = kPatience;
    auto link = opcua::UaLink::connect(options);
    require(link.has_value());
    m_link = std::move(*link);
  }
  void read(opcua::Grouping grouping) {
    std::vector<Variable> asked = variables();
    if (grouping == opcua::Grouping::ArrayCount || grouping == opcua::Grouping::ArrayRange) {
      for (int cell = kArrayFirst; cell < kArrayFirst + kArrayCount; ++cell) {
        asked.push_back({VariableKind::RParameter, cell});
      }
    }
    m_link->read(asked, kPatience, grouping);
    const auto event = m_link->wait(m_link->now() + kPatience);
    require(event.has_value());
    require(event->kind != opcua::EventKind::ReadDone || event->readings.size() == asked.size());
    reconnectIfLost(*event);
  }
  void reconnectIfLost(const opcua::Event& event) {
    if (event.kind == opcua::EventKind::ConnectionLost) {
      connect();
    }
  }
  template <class T>
  void check(const base::Result<T>& result) {
    require(result || !result.error().message.empty());
    if (!result && result.error().code == opcua::LinkError::ConnectionLost) {
      connect();
    }
  }
  void carryOut(Ask what) {
    tests::soilStack();
    switch (what) {
      case Ask::List:
        return read(opcua::Grouping::List);
      case Ask::Single:
        return read(opcua::Grouping::Single);
      case Ask::Count:
        return read(opcua::Grouping::ArrayCount);
      case Ask::Range:
        return read(opcua::Grouping::ArrayRange);
      case Ask::Piece:
        return check(m_link->fetchTracePiece({}));
      case Ask::PieceLater: {
        require(m_link->readTrace({}, kPatience) != base::RequestId{});
        const auto event = m_link->wait(m_link->now() + kPatience);
        require(event && (event->kind != opcua::EventKind::TraceDone || event->trace != nullptr));
        return reconnectIfLost(*event);
      }
      case Ask::Trace:
        return check(m_link->fetchTrace());
      case Ask::Start:
        return check(m_link->cycleStart());
      case Ask::Reset:
        return check(m_link->reset());
      case Ask::Select:
        return check(m_link->selectProgram("A.MPF"));
      case Ask::Program:
        return check(m_link->downloadProgram("A.MPF"));
      case Ask::Rights:
        return check(m_link->accessRights());
      case Ask::Number:
        return;
    }
  }

  Answers m_answers;
  std::unique_ptr<opcua::UaLink> m_link;
  int m_connections = 0;
};

bool isRead(Ask what) {
  return what <= Ask::Range;
}

constexpr std::uint8_t kDamaged = 0x80;
constexpr std::size_t kDamageSize = 3;

/// One byte of a message is another. @param bytes  place in the message, little endian, and the
/// bits
void agreeDamage(const std::uint8_t* bytes) {
  const std::size_t place = bytes[0] + 256U * bytes[1];
  const std::uint8_t bits = bytes[2];
  tests::setDamage([place, bits](std::string& message) {
    char& one = message[place % message.size()];
    one = static_cast<char>(static_cast<std::uint8_t>(one) ^ bits);
  });
}

/// A trace as a server prints it, sometimes damaged.
std::string traceText(base::Random& random, tests::Values& values) {
  trace::ControlTrace trace;
  trace.cycle = base::Duration{static_cast<std::int64_t>(random.below(10'000'000))};
  trace.rotaryAxes = {random.below(2) == 0, false, random.below(2) == 0};
  trace.samples.resize(random.below(4));
  trace.blocks.resize(random.below(4));
  trace.events.resize(random.below(2));
  for (trace::ControlSample& sample : trace.samples) {
    sample.commandMm = {values.number(), values.number(), values.number()};
    sample.feedMmPerS = values.number();
  }
  for (trace::ExecutedBlock& block : trace.blocks) {
    block.lengthMm = values.number();
  }
  std::string text = trace::printControlTrace(trace);
  if (random.below(3) == 0) {
    text.resize(random.below(text.size()));
  }
  return text;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Made before the variable is, so that the network it uses outlives it.
  static auto world = std::make_unique<World>();
  if (world->isWorn()) {
    world.reset();
    world = std::make_unique<World>();
  }
  if (size == 0) {
    return 0;
  }
  const bool isDamaged = (data[0] & kDamaged) != 0;
  const std::size_t head = 1 + (isDamaged ? kDamageSize : 0);
  if (size < head) {
    return 0;
  }
  const auto what = static_cast<Ask>((data[0] & ~kDamaged) % static_cast<int>(Ask::Number));
  const tests::Decoded answer(tests::textOf(data + head, size - head),
                              isRead(what) ? UA_TYPES_READRESPONSE : UA_TYPES_CALLMETHODRESULT);
  if (answer.isGood() && isDamaged) {
    agreeDamage(data + 1);
  }
  if (answer.isGood() && isRead(what)) {
    world->ask(what, static_cast<const UA_ReadResponse*>(answer.get()), nullptr);
  } else if (answer.isGood()) {
    world->ask(what, nullptr, static_cast<const UA_CallMethodResult*>(answer.get()));
  }
  tests::setDamage({});
  return 0;
}

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t sizeMax, unsigned seed) {
  base::Random random(seed);
  if (random.below(4) != 0) {
    return LLVMFuzzerMutate(data, size, sizeMax);
  }
  const auto what = static_cast<Ask>(random.below(static_cast<std::uint64_t>(Ask::Number)));
  tests::Values values(random);
  std::string bytes;
  if (isRead(what)) {
    std::vector<UA_DataValue> results(1 + random.below(12));
    for (UA_DataValue& result : results) {
      UA_DataValue_init(&result);
      result.hasValue = random.below(8) != 0;
      result.value = values.variant();
      result.hasStatus = random.below(4) == 0;
      result.status = random.below(2) == 0 ? UA_STATUSCODE_BADNODEIDUNKNOWN
                                           : static_cast<UA_StatusCode>(random.below(1U << 31U));
    }
    UA_ReadResponse response;
    UA_ReadResponse_init(&response);
    response.results = results.data();
    response.resultsSize = results.size();
    bytes = tests::encoded(response, UA_TYPES_READRESPONSE);
  } else {
    std::vector<UA_Variant> outputs;
    for (int i = 0; i < 6; ++i) {
      outputs.push_back(random.below(3) == 0
                            ? values.string(traceText(random, values), UA_TYPES_BYTESTRING)
                            : values.variant());
    }
    if (random.below(2) == 0) {
      // As a piece of a trace.
      outputs[0] = values.string(traceText(random, values), UA_TYPES_BYTESTRING);
      for (std::size_t i = 1; i < 5; ++i) {
        outputs[i] = values.integer(random.below(1U << 31U), UA_TYPES_UINT64);
      }
      outputs[5] = values.integer(random.below(2), UA_TYPES_BOOLEAN);
    }
    UA_CallMethodResult result;
    UA_CallMethodResult_init(&result);
    result.statusCode = random.below(6) == 0 ? UA_STATUSCODE_BADINVALIDSTATE : UA_STATUSCODE_GOOD;
    result.outputArguments = outputs.data();
    result.outputArgumentsSize = outputs.size();
    bytes = tests::encoded(result, UA_TYPES_CALLMETHODRESULT);
  }
  auto kind = static_cast<std::uint8_t>(what);
  if (random.below(4) == 0) {
    kind |= kDamaged;
    const std::uint64_t place = random.below(random.below(2) == 0 ? 64 : 1024);
    const std::uint64_t bits = random.below(2) == 0 ? 1U << random.below(8) : random.below(256);
    bytes.insert(
        0, {static_cast<char>(place), static_cast<char>(place >> 8U), static_cast<char>(bits)});
  }
  return tests::replacedBy(bytes, kind, data, size, sizeMax);
}
