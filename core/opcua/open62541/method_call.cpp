// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/method_call.h"

#include <cstddef>
#include <utility>

#include "opcua/node_map.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/status.h"
#include "trace/control_trace.h"

namespace rivulet::opcua {

std::array<UA_Variant, 4> traceInputs(trace::TracePosition& from) {
  return {borrowScalar(from.start, UA_TYPES_UINT64), borrowScalar(from.samples, UA_TYPES_UINT64),
          borrowScalar(from.blocks, UA_TYPES_UINT64), borrowScalar(from.events, UA_TYPES_UINT64)};
}

base::Result<trace::TracePiece> tracePieceOf(const UA_CallMethodResult& result) {
  constexpr std::size_t kOutputs = 6;
  const std::span outputs(result.outputArguments, result.outputArgumentsSize);
  const auto unknown = [] { return base::fail(unknownForm(kFetchTracePiece)); };
  if (outputs.size() != kOutputs) {
    return unknown();
  }
  const auto* const text = scalarOf<UA_ByteString>(outputs[0], UA_TYPES_BYTESTRING);
  const auto* const isLast = scalarOf<UA_Boolean>(outputs[kOutputs - 1], UA_TYPES_BOOLEAN);
  trace::TracePiece piece;
  bool isComplete = text != nullptr && isLast != nullptr;
  std::size_t index = 1;
  for (std::uint64_t* const next :
       {&piece.next.start, &piece.next.samples, &piece.next.blocks, &piece.next.events}) {
    const auto* const number = scalarOf<UA_UInt64>(outputs[index++], UA_TYPES_UINT64);
    isComplete = isComplete && number != nullptr;
    *next = number != nullptr ? *number : 0;
  }
  if (!isComplete) {
    return unknown();
  }
  auto records = trace::parseControlTrace(view(*text));
  if (!records) {
    return base::fail(records.error());
  }
  piece.records = std::move(*records);
  piece.isLast = *isLast;
  if (!piece.isLast && piece.records.samples.empty() && piece.records.blocks.empty() &&
      piece.records.events.empty()) {
    return unknown();  // asked for ever, it would never end
  }
  return piece;
}

}  // namespace rivulet::opcua
