// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "machine/front/listening.h"
#include "machine/front/server.h"
#include "opcua/link.h"
#include "opcua/node_map.h"
#include "opcua/open62541/handle.h"
#include "trace/control_trace.h"

namespace rivulet::machine {

namespace {

using opcua::SelectStatus;

/// The library has checked number and types of the arguments before a method is called.
template <class T>
[[nodiscard]] const T& argument(const UA_Variant* input, std::size_t index) {
  return *static_cast<const T*>(input[index].data);
}

template <class T>
[[nodiscard]] UA_StatusCode answer(UA_Variant& output, const T& value, std::size_t typeIndex) {
  return UA_Variant_setScalarCopy(&output, &value, &UA_TYPES[typeIndex]);
}

[[nodiscard]] UA_StatusCode statusCodeOf(const base::Error& error) {
  if (error.code == MachineError::FileExists) {
    return UA_STATUSCODE_BADENTRYEXISTS;
  }
  if (error.code == MachineError::FileTooLarge) {
    return UA_STATUSCODE_BADREQUESTTOOLARGE;
  }
  if (error.code == MachineError::ProgramMissing) {
    return UA_STATUSCODE_BADNOTFOUND;
  }
  if (error.code == MachineError::NotInReset) {
    return UA_STATUSCODE_BADINVALIDSTATE;
  }
  return UA_STATUSCODE_BADREQUESTNOTALLOWED;
}

[[nodiscard]] SelectStatus selectStatusOf(const base::Result<void>& result) {
  if (result) {
    return SelectStatus::Done;
  }
  const std::error_code code = result.error().code;
  if (code == MachineError::ProgramMissing || code == MachineError::NoProgramSelected) {
    return SelectStatus::NoSuchProgram;
  }
  return code == MachineError::NotInReset ? SelectStatus::NotInReset : SelectStatus::Rejected;
}

/// A method's work: the arguments as the table below lists them.
using Work = UA_StatusCode (*)(Methods&, const UA_Variant* input, UA_Variant* output);

UA_StatusCode copyFileToServer(Methods& methods, const UA_Variant* input, UA_Variant* /*output*/) {
  const auto name = opcua::programNameOf(opcua::view(argument<UA_String>(input, 0)));
  const auto& data = argument<UA_ByteString>(input, 1);
  if (!name) {
    return UA_STATUSCODE_BADINVALIDARGUMENT;
  }
  if (data.length > kFileBytesMax) {
    return UA_STATUSCODE_BADREQUESTTOOLARGE;
  }
  methods.serveProgram(data.length);
  const auto stored = methods.control().storeProgram(*name, std::string(opcua::view(data)),
                                                     argument<UA_Boolean>(input, 2));
  return stored ? UA_STATUSCODE_GOOD : statusCodeOf(stored.error());
}

UA_StatusCode copyFileFromServer(Methods& methods, const UA_Variant* input, UA_Variant* output) {
  const auto name = opcua::programNameOf(opcua::view(argument<UA_String>(input, 0)));
  if (!name) {
    return UA_STATUSCODE_BADINVALIDARGUMENT;
  }
  const auto text = methods.control().programText(*name);
  if (!text) {
    return statusCodeOf(text.error());
  }
  return answer(output[0], opcua::borrow(*text), UA_TYPES_BYTESTRING);
}

UA_StatusCode select(Methods& methods, const UA_Variant* input, UA_Variant* output) {
  const auto name = opcua::programNameOf(opcua::view(argument<UA_String>(input, 0)));
  SelectStatus status = SelectStatus::NoSuchProgram;
  if (argument<UA_UInt32>(input, 1) != 1) {
    status = SelectStatus::NoSuchChannel;
  } else if (name) {
    status = selectStatusOf(methods.control().selectProgram(*name));
  }
  return answer(output[0], static_cast<UA_Int32>(status), UA_TYPES_INT32);
}

UA_StatusCode cycleStart(Methods& methods, const UA_Variant* /*input*/, UA_Variant* output) {
  const auto started = methods.control().cycleStart();
  if (started) {
    methods.rememberStarter();
  }
  const UA_StatusCode status =
      answer(output[0], static_cast<UA_Int32>(selectStatusOf(started)), UA_TYPES_INT32);
  const std::string message = started ? std::string() : started.error().message;
  return status | answer(output[1], opcua::borrow(message), UA_TYPES_STRING);
}

UA_StatusCode reset(Methods& methods, const UA_Variant* /*input*/, UA_Variant* /*output*/) {
  if (!methods.mayReset()) {
    return UA_STATUSCODE_BADUSERACCESSDENIED;
  }
  methods.control().reset();
  return UA_STATUSCODE_GOOD;
}

UA_StatusCode getMyAccessRights(Methods& methods, const UA_Variant* /*input*/, UA_Variant* output) {
  std::string rights;
  for (const std::string& right : userRights()) {
    const bool needsFiles = right == "FsRead" || right == "FsWrite" || right == "ApWrite";
    if (methods.mayCaller(right) && (!needsFiles || methods.hasFileRights())) {
      rights += (rights.empty() ? "" : ";") + right;
    }
  }
  return answer(output[0], opcua::borrow(rights), UA_TYPES_STRING);
}

UA_StatusCode fetchTrace(Methods& methods, const UA_Variant* input, UA_Variant* output) {
  const UA_UInt64 offset = argument<UA_UInt64>(input, 0);
  const std::string& text = methods.traceText(offset == 0);
  if (offset > text.size()) {
    return UA_STATUSCODE_BADOUTOFRANGE;
  }
  const auto chunk = std::string_view(text).substr(offset, kTraceChunkBytesMax);
  return answer(output[0], opcua::borrow(chunk), UA_TYPES_BYTESTRING) |
         answer(output[1], UA_UInt64{text.size()}, UA_TYPES_UINT64);
}

UA_StatusCode fetchTracePiece(Methods& methods, const UA_Variant* input, UA_Variant* output) {
  const trace::TracePiece piece =
      methods.control().takeTrace({argument<UA_UInt64>(input, 0), argument<UA_UInt64>(input, 1),
                                   argument<UA_UInt64>(input, 2), argument<UA_UInt64>(input, 3)});
  const std::string text = trace::printControlTrace(piece.records);
  return answer(output[0], opcua::borrow(text), UA_TYPES_BYTESTRING) |
         answer(output[1], piece.next.start, UA_TYPES_UINT64) |
         answer(output[2], piece.next.samples, UA_TYPES_UINT64) |
         answer(output[3], piece.next.blocks, UA_TYPES_UINT64) |
         answer(output[4], piece.next.events, UA_TYPES_UINT64) |
         answer(output[5], piece.isLast, UA_TYPES_BOOLEAN);
}

}  // namespace

std::string sessionKey(const UA_NodeId* sessionId) {
  opcua::Handle<UA_String, UA_TYPES_STRING> text;
  const bool isPrinted =
      sessionId != nullptr && UA_NodeId_print(sessionId, text.get()) == UA_STATUSCODE_GOOD;
  return isPrinted ? std::string(opcua::view(*text.get())) : std::string();
}

namespace {

enum class Right { ReadFiles, WriteFiles, Select, Start, Anyone };

/// Whether the caller has been given it in the preset. Who may select a program may start it: a
/// SINUMERIK has no right of its own for that, because there the operator presses the key.
bool hasRight(const Methods& methods, Right right) {
  switch (right) {
    case Right::ReadFiles:
      return methods.mayCaller("FsRead");
    case Right::WriteFiles:
      return methods.mayCaller("FsWrite");
    case Right::Select:
    case Right::Start:
      return methods.mayCaller("ApWrite");
    case Right::Anyone:
      break;
  }
  return true;
}

/// The one place where the library enters a method.
template <Work work, Right right>
UA_StatusCode onCall(UA_Server* /*server*/, const UA_NodeId* sessionId, void* sessionContext,
                     const UA_NodeId* /*methodId*/, void* context, const UA_NodeId* /*objectId*/,
                     void* /*objectContext*/, std::size_t /*inputSize*/, const UA_Variant* input,
                     std::size_t /*outputSize*/, UA_Variant* output) noexcept {
  auto& methods = *static_cast<Methods*>(context);
  methods.advance();
  methods.setCaller(sessionKey(sessionId), static_cast<const User*>(sessionContext));
  const bool isOfControl =
      right == Right::ReadFiles || right == Right::WriteFiles || right == Right::Select;
  if (isOfControl && !methods.hasFileRights()) {
    return UA_STATUSCODE_BADNOTSUPPORTED;  // the control's word for a missing protection level
  }
  if (!hasRight(methods, right)) {
    return UA_STATUSCODE_BADUSERACCESSDENIED;
  }
  return work(methods, input, output);
}

struct Parameter {
  std::string_view name;
  std::size_t type;
};

struct Signature {
  std::string_view name;
  UA_MethodCallback callback;
  std::vector<Parameter> inputs;
  std::vector<Parameter> outputs;
};

[[nodiscard]] std::vector<UA_Argument> argumentsOf(const std::vector<Parameter>& parameters) {
  std::vector<UA_Argument> arguments(parameters.size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    UA_Argument_init(&arguments[i]);
    arguments[i].name = opcua::borrow(parameters[i].name);
    arguments[i].dataType = UA_TYPES[parameters[i].type].typeId;
    arguments[i].valueRank = UA_VALUERANK_SCALAR;
  }
  return arguments;
}

[[nodiscard]] UA_StatusCode addMethod(UA_Server* server, UA_UInt16 namespaceIndex,
                                      std::string_view object, const Signature& signature,
                                      Methods& methods) {
  UA_MethodAttributes attributes = UA_MethodAttributes_default;
  attributes.displayName.text = opcua::borrow(signature.name);
  attributes.executable = true;
  attributes.userExecutable = true;
  const std::string identifier = opcua::memberIdentifier(object, signature.name);
  const auto inputs = argumentsOf(signature.inputs);
  const auto outputs = argumentsOf(signature.outputs);
  UA_QualifiedName browseName{namespaceIndex, opcua::borrow(signature.name)};
  return UA_Server_addMethodNode(server, opcua::borrowNodeId(namespaceIndex, identifier),
                                 opcua::borrowNodeId(namespaceIndex, object),
                                 opcua::standardNodeId(UA_NS0ID_HASCOMPONENT), browseName,
                                 attributes, signature.callback, inputs.size(), inputs.data(),
                                 outputs.size(), outputs.data(), &methods, nullptr);
}

[[nodiscard]] UA_StatusCode addProperty(UA_Server* server, UA_UInt16 namespaceIndex,
                                        std::string_view object, std::string_view name,
                                        const UA_Variant& value) {
  UA_VariableAttributes attributes = UA_VariableAttributes_default;
  attributes.displayName.text = opcua::borrow(name);
  attributes.dataType = value.type->typeId;
  attributes.valueRank = UA_VALUERANK_SCALAR;
  attributes.accessLevel = UA_ACCESSLEVELMASK_READ;
  attributes.value = value;
  const std::string identifier = opcua::memberIdentifier(object, name);
  UA_QualifiedName browseName{namespaceIndex, opcua::borrow(name)};
  return UA_Server_addVariableNode(
      server, opcua::borrowNodeId(namespaceIndex, identifier),
      opcua::borrowNodeId(namespaceIndex, object), opcua::standardNodeId(UA_NS0ID_HASPROPERTY),
      browseName, opcua::standardNodeId(UA_NS0ID_PROPERTYTYPE), attributes, nullptr, nullptr);
}

}  // namespace

base::Result<void> Methods::build(UA_UInt16 namespaceIndex) {
  const std::vector<Signature> ofSinumerik{
      {opcua::kCopyToServer,
       &onCall<&copyFileToServer, Right::WriteFiles>,
       {{"TargetFilename", UA_TYPES_STRING},
        {"Data", UA_TYPES_BYTESTRING},
        {"Overwrite", UA_TYPES_BOOLEAN}},
       {}},
      {opcua::kCopyFromServer,
       &onCall<&copyFileFromServer, Right::ReadFiles>,
       {{"SourceFile", UA_TYPES_STRING}},
       {{"Data", UA_TYPES_BYTESTRING}}},
      {opcua::kSelect,
       &onCall<&select, Right::Select>,
       {{"SourceFileNodeId", UA_TYPES_STRING}, {"ChannelNumber", UA_TYPES_UINT32}},
       {{"Status", UA_TYPES_INT32}}},
      {opcua::kGetMyAccessRights,
       &onCall<&getMyAccessRights, Right::Anyone>,
       {},
       {{"Rights", UA_TYPES_STRING}}}};
  const ServedFacts& facts = control().facts();
  std::vector<Signature> beyond;
  if (facts.abilities.startsOnRequest) {
    beyond.push_back({opcua::kCycleStart,
                      &onCall<&cycleStart, Right::Start>,
                      {},
                      {{"Status", UA_TYPES_INT32}, {"Message", UA_TYPES_STRING}}});
    beyond.push_back({opcua::kReset, &onCall<&reset, Right::Start>, {}, {}});
  }
  if (facts.abilities.keepsTrace) {
    beyond.push_back({opcua::kFetchTrace,
                      &onCall<&fetchTrace, Right::Anyone>,
                      {{"Offset", UA_TYPES_UINT64}},
                      {{"Data", UA_TYPES_BYTESTRING}, {"Total", UA_TYPES_UINT64}}});
  }

  if (facts.tracePieces) {
    beyond.push_back({opcua::kFetchTracePiece,
                      &onCall<&fetchTracePiece, Right::Anyone>,
                      {{"Start", UA_TYPES_UINT64},
                       {"Samples", UA_TYPES_UINT64},
                       {"Blocks", UA_TYPES_UINT64},
                       {"Events", UA_TYPES_UINT64}},
                      {{"Data", UA_TYPES_BYTESTRING},
                       {"NextStart", UA_TYPES_UINT64},
                       {"NextSamples", UA_TYPES_UINT64},
                       {"NextBlocks", UA_TYPES_UINT64},
                       {"NextEvents", UA_TYPES_UINT64},
                       {"IsLast", UA_TYPES_BOOLEAN}}});
  }

  UA_StatusCode status =
      addObject(m_server, namespaceIndex, opcua::borrowNodeId(namespaceIndex, "Sinumerik"),
                opcua::kMethodsObject, "Methods");
  for (const Signature& signature : ofSinumerik) {
    status |= addMethod(m_server, namespaceIndex, opcua::kMethodsObject, signature, *this);
  }

  const std::string uri(facts.isVirtual ? opcua::kVirtualNamespaceUri : opcua::kBridgeNamespaceUri);
  const UA_UInt16 virtualIndex = UA_Server_addNamespace(m_server, uri.c_str());
  const std::string_view object = facts.isVirtual ? opcua::kVirtualObject : opcua::kBridgeObject;
  status |= addObject(m_server, virtualIndex, opcua::standardNodeId(UA_NS0ID_OBJECTSFOLDER), object,
                      object);
  for (const Signature& signature : beyond) {
    status |= addMethod(m_server, virtualIndex, object, signature, *this);
  }
  UA_Boolean simulated = facts.isVirtual;
  UA_String preset = opcua::borrow(facts.name);
  status |= addProperty(m_server, virtualIndex, object, opcua::kSimulated,
                        opcua::borrowScalar(simulated, UA_TYPES_BOOLEAN));
  status |= addProperty(m_server, virtualIndex, object, opcua::kPresetName,
                        opcua::borrowScalar(preset, UA_TYPES_STRING));
  if (status != UA_STATUSCODE_GOOD) {
    return base::fail(
        FrontError::SetUpFailed,
        fmt::format("The server's methods cannot be set up ({}).", UA_StatusCode_name(status)));
  }
  return {};
}

const std::string& Methods::traceText(bool anew) {
  if (anew) {
    m_traceText = control().traceText();
  }
  return m_traceText;
}

}  // namespace rivulet::machine
