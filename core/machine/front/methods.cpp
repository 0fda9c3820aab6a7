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

/// Number and types of the arguments have been checked before a method's work begins.
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
                     void* /*objectContext*/, std::size_t inputSize, const UA_Variant* input,
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
  return opcua::areScalars(input, inputSize) ? work(methods, input, output)
                                             : UA_STATUSCODE_BADINVALIDARGUMENT;
}

struct Parameter {
  std::string_view name;
  std::size_t type;
  std::string_view description;
};

struct Signature {
  std::string_view name;
  std::string_view description;
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
    arguments[i].description = localized(parameters[i].description);
  }
  return arguments;
}

[[nodiscard]] UA_StatusCode addMethod(UA_Server* server, UA_UInt16 namespaceIndex,
                                      std::string_view object, const Signature& signature,
                                      Methods& methods) {
  UA_MethodAttributes attributes = UA_MethodAttributes_default;
  attributes.displayName.text = opcua::borrow(signature.name);
  attributes.description = localized(signature.description);
  attributes.executable = true;
  attributes.userExecutable = true;
  const std::string identifier = opcua::memberIdentifier(object, signature.name);
  const auto inputs = argumentsOf(signature.inputs);
  const auto outputs = argumentsOf(signature.outputs);
  const std::string inputsId = opcua::memberIdentifier(identifier, "InputArguments");
  const std::string outputsId = opcua::memberIdentifier(identifier, "OutputArguments");
  const UA_NodeId inputsNode = opcua::borrowNodeId(namespaceIndex, inputsId);
  const UA_NodeId outputsNode = opcua::borrowNodeId(namespaceIndex, outputsId);
  UA_QualifiedName browseName{namespaceIndex, opcua::borrow(signature.name)};
  UA_StatusCode status = UA_Server_addMethodNodeEx(
      server, opcua::borrowNodeId(namespaceIndex, identifier),
      opcua::borrowNodeId(namespaceIndex, object), opcua::standardNodeId(UA_NS0ID_HASCOMPONENT),
      browseName, attributes, signature.callback, inputs.size(), inputs.data(), inputsNode, nullptr,
      outputs.size(), outputs.data(), outputsNode, nullptr, &methods, nullptr);
  if (status == UA_STATUSCODE_GOOD && !inputs.empty()) {
    status = UA_Server_writeDescription(server, inputsNode,
                                        localized("What a caller gives to the method."));
  }
  if (status == UA_STATUSCODE_GOOD && !outputs.empty()) {
    status = UA_Server_writeDescription(server, outputsNode, localized("What the method answers."));
  }
  return status;
}

Parameter statusOutput() {
  return {"Status", UA_TYPES_INT32,
          "0 done, 1 no such channel, 2 no such program, 3 channel not in reset, 4 rejected."};
}

std::vector<Signature> methodsOfSinumerik() {
  return {{opcua::kCopyToServer,
           "Stores a part program on the control.",
           &onCall<&copyFileToServer, Right::WriteFiles>,
           {{"TargetFilename", UA_TYPES_STRING, "Path of the program on the control."},
            {"Data", UA_TYPES_BYTESTRING, "Text of the program."},
            {"Overwrite", UA_TYPES_BOOLEAN, "Whether a program of this name is replaced."}},
           {}},
          {opcua::kCopyFromServer,
           "Gives the text of a part program.",
           &onCall<&copyFileFromServer, Right::ReadFiles>,
           {{"SourceFile", UA_TYPES_STRING, "Path of the program on the control."}},
           {{"Data", UA_TYPES_BYTESTRING, "Text of the program."}}},
          {opcua::kSelect,
           "Selects a part program for the next cycle start; does not start it.",
           &onCall<&select, Right::Select>,
           {{"SourceFileNodeId", UA_TYPES_STRING, "Path of the program on the control."},
            {"ChannelNumber", UA_TYPES_UINT32, "1: there is one channel."}},
           {statusOutput()}},
          {opcua::kGetMyAccessRights,
           "Lists the rights of the user who asks.",
           &onCall<&getMyAccessRights, Right::Anyone>,
           {},
           {{"Rights", UA_TYPES_STRING, "Names of the rights, separated by semicolons."}}}};
}

/// What a SINUMERIK does not offer to clients.
std::vector<Signature> methodsBeyond(const ServedFacts& facts) {
  std::vector<Signature> beyond;
  if (facts.abilities.startsOnRequest) {
    beyond.push_back({opcua::kCycleStart,
                      "Starts the selected program, or continues the one that waits.",
                      &onCall<&cycleStart, Right::Start>,
                      {},
                      {statusOutput(), {"Message", UA_TYPES_STRING, "Why it was not started."}}});
    beyond.push_back({opcua::kReset,
                      "Ends the program and acknowledges alarms, like the key RESET.",
                      &onCall<&reset, Right::Start>,
                      {},
                      {}});
  }
  if (facts.abilities.keepsTrace) {
    beyond.push_back({opcua::kFetchTrace,
                      "Gives a part of the trace since the last cycle start.",
                      &onCall<&fetchTrace, Right::Anyone>,
                      {{"Offset", UA_TYPES_UINT64, "First byte; 0 reads the trace anew."}},
                      {{"Data", UA_TYPES_BYTESTRING, "Text of the trace from there on."},
                       {"Total", UA_TYPES_UINT64, "Bytes of the whole trace."}}});
  }

  if (facts.tracePieces) {
    constexpr std::string_view kFrom = "As the call before answered; 0 at the first call.";
    constexpr std::string_view kNext = "For the next call.";
    beyond.push_back({opcua::kFetchTracePiece,
                      "Gives what was recorded since the piece before, and forgets that one.",
                      &onCall<&fetchTracePiece, Right::Anyone>,
                      {{"Start", UA_TYPES_UINT64, kFrom},
                       {"Samples", UA_TYPES_UINT64, kFrom},
                       {"Blocks", UA_TYPES_UINT64, kFrom},
                       {"Events", UA_TYPES_UINT64, kFrom}},
                      {{"Data", UA_TYPES_BYTESTRING, "Text of the piece."},
                       {"NextStart", UA_TYPES_UINT64, kNext},
                       {"NextSamples", UA_TYPES_UINT64, kNext},
                       {"NextBlocks", UA_TYPES_UINT64, kNext},
                       {"NextEvents", UA_TYPES_UINT64, kNext},
                       {"IsLast", UA_TYPES_BOOLEAN, "Nothing more is there yet."}}});
  }
  return beyond;
}

}  // namespace

base::Result<void> Methods::build(UA_UInt16 namespaceIndex) {
  const ServedFacts& facts = control().facts();
  UA_StatusCode status =
      addObject(m_server, namespaceIndex, opcua::borrowNodeId(namespaceIndex, "Sinumerik"),
                opcua::kMethodsObject, "Methods", "File transfer, selection and rights.");
  for (const Signature& signature : methodsOfSinumerik()) {
    status |= addMethod(m_server, namespaceIndex, opcua::kMethodsObject, signature, *this);
  }

  const std::string uri(facts.isVirtual ? opcua::kVirtualNamespaceUri : opcua::kBridgeNamespaceUri);
  const UA_UInt16 virtualIndex = UA_Server_addNamespace(m_server, uri.c_str());
  const std::string_view object = facts.isVirtual ? opcua::kVirtualObject : opcua::kBridgeObject;
  status |= addObject(m_server, virtualIndex, opcua::standardNodeId(UA_NS0ID_OBJECTSFOLDER), object,
                      object, "What a SINUMERIK does not offer to clients.");
  for (const Signature& signature : methodsBeyond(facts)) {
    status |= addMethod(m_server, virtualIndex, object, signature, *this);
  }
  UA_Boolean simulated = facts.isVirtual;
  UA_String preset = opcua::borrow(facts.name);
  const auto add = [&](std::string_view name, const UA_Variant& value,
                       std::string_view description) {
    const std::string identifier = opcua::memberIdentifier(object, name);
    status |= addProperty(m_server, opcua::borrowNodeId(virtualIndex, object),
                          opcua::borrowNodeId(virtualIndex, identifier),
                          {virtualIndex, opcua::borrow(name)}, value, description);
  };
  add(opcua::kSimulated, opcua::borrowScalar(simulated, UA_TYPES_BOOLEAN),
      "Whether no real axis moves.");
  add(opcua::kPresetName, opcua::borrowScalar(preset, UA_TYPES_STRING),
      "Name of the preset or of the machine.");
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
