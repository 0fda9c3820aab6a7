// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Calls of methods, as the library wants them. @threadsafety plain values.
#pragma once

#include <open62541/types.h>
#include <open62541/types_generated.h>

#include <array>
#include <span>

#include "base/result.h"
#include "trace/trace_piece.h"

namespace rivulet::opcua {

/// When the library forgets a call: never while the connection lasts.
inline constexpr UA_UInt32 kLibraryTimeoutMs = 3'600'000;

/// A request to call one method; borrows all its parts and points into itself.
struct MethodCall {
  MethodCall(UA_NodeId object, UA_NodeId method, std::span<UA_Variant> inputs) {
    UA_CallMethodRequest_init(&item);
    item.objectId = object;
    item.methodId = method;
    item.inputArguments = inputs.data();
    item.inputArgumentsSize = inputs.size();
    UA_CallRequest_init(&request);
    request.requestHeader.timeoutHint = kLibraryTimeoutMs;
    request.methodsToCall = &item;
    request.methodsToCallSize = 1;
  }
  MethodCall(const MethodCall&) = delete;
  MethodCall& operator=(const MethodCall&) = delete;

  UA_CallMethodRequest item;
  UA_CallRequest request;
};

/// The arguments of `kFetchTracePiece`. @param from  outlives them
[[nodiscard]] std::array<UA_Variant, 4> traceInputs(trace::TracePosition& from);
/// Its answer. @return error Rejected: it is none
[[nodiscard]] base::Result<trace::TracePiece> tracePieceOf(const UA_CallMethodResult& result);

}  // namespace rivulet::opcua
