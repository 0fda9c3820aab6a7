// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "opcua/open62541/ua_link_impl.h"
#include "opcua/open62541/values.h"
#include "opcua/request.h"

namespace rivulet::opcua {

namespace {

/// Values that are asked for at once.
constexpr UA_UInt32 kPageValues = 10'000;
constexpr std::int64_t kNsPerTick = 100;

std::int64_t utcNsOf(UA_DateTime time) {
  constexpr std::int64_t kEpoch = UA_DATETIME_UNIX_EPOCH;
  constexpr std::int64_t kTicksMax = std::numeric_limits<std::int64_t>::max() / kNsPerTick;
  return kNsPerTick *
         (std::clamp<std::int64_t>(time, kEpoch - kTicksMax, kEpoch + kTicksMax) - kEpoch);
}

UA_DateTime timeOf(std::int64_t utcNs) {
  return utcNs / kNsPerTick + UA_DATETIME_UNIX_EPOCH;
}

bool meansNoHistory(UA_StatusCode status) {
  return status == UA_STATUSCODE_BADHISTORYOPERATIONUNSUPPORTED ||
         status == UA_STATUSCODE_BADHISTORYOPERATIONINVALID ||
         status == UA_STATUSCODE_BADSERVICEUNSUPPORTED;
}

/// A node without a history is refused by some servers as one that may not be read.
bool mayMeanNoHistory(UA_StatusCode status) {
  return status == UA_STATUSCODE_BADUSERACCESSDENIED || status == UA_STATUSCODE_BADNOTREADABLE;
}

base::Error historyError(UA_StatusCode status, const std::string& address) {
  if (!meansNoHistory(status) && !mayMeanNoHistory(status)) {
    return requestError(status, Operation::Read, address);
  }
  const std::string sentence =
      mayMeanNoHistory(status)
          ? "The server keeps no history of this node, or this user may not read it. Have it "
            "recorded at the server, or check the rights of the user."
          : sentenceOf(LinkError::NoHistory);
  return base::makeError(LinkError::NoHistory,
                         fmt::format("{} ({})", sentence, UA_StatusCode_name(status)), address);
}

void appendValues(const UA_HistoryData& data, NodeValues& read) {
  for (std::size_t i = 0; i < data.dataValuesSize; ++i) {
    const UA_DataValue& one = data.dataValues[i];
    if (!one.hasSourceTimestamp && !one.hasServerTimestamp) {
      ++read.withoutTime;
      continue;
    }
    const bool isGood = one.hasValue && !(one.hasStatus && isBad(one.status));
    const auto number = isGood ? numberOf(one.value) : std::nullopt;
    read.values.push_back(
        {utcNsOf(one.hasSourceTimestamp ? one.sourceTimestamp : one.serverTimestamp),
         number.value_or(std::numeric_limits<double>::quiet_NaN())});
  }
}

}  // namespace

base::Error UaLink::Impl::historyRefusal(UA_StatusCode status, const std::string& address) {
  bool isMissing = linkErrorOf(status, Operation::Read) == LinkError::VariableMissing;
  // Some servers refuse a node that is not there as one that may not be read.
  if (mayMeanNoHistory(status)) {
    const auto facts = examine(std::span(&address, 1));
    isMissing = facts && !facts->empty() && facts->front().status == LinkError::VariableMissing;
  }
  return isMissing
             ? base::makeError(LinkError::VariableMissing, "The server has no such node.", address)
             : historyError(status, address);
}

UA_StatusCode UaLink::Impl::askForHistory(const UA_HistoryReadValueId& item,
                                          const HistorySpan& span, bool isLast,
                                          HistoryResponse& response) {
  UA_ReadRawModifiedDetails details;
  UA_ReadRawModifiedDetails_init(&details);
  details.startTime = timeOf(span.fromUtcNs);
  details.endTime = timeOf(span.untilUtcNs);
  details.numValuesPerNode = kPageValues;
  UA_HistoryReadValueId asked = item;  // borrows what the caller has
  UA_HistoryReadRequest request;
  UA_HistoryReadRequest_init(&request);
  request.requestHeader.timeoutHint = kLibraryTimeoutMs;
  UA_ExtensionObject_setValueNoDelete(&request.historyReadDetails, &details,
                                      &UA_TYPES[UA_TYPES_READRAWMODIFIEDDETAILS]);
  request.timestampsToReturn = UA_TIMESTAMPSTORETURN_BOTH;
  request.nodesToRead = &asked;
  request.nodesToReadSize = 1;
  // A server keeps what belongs to a continuation point until it is told that nobody asks again.
  request.releaseContinuationPoints = isLast;
  const UA_StatusCode status =
      exchange(&request, &UA_TYPES[UA_TYPES_HISTORYREADREQUEST], response.get(), response.type(),
               addSaturating(now(), m_options.commandDeadline));
  if (isBad(status)) {
    return status;
  }
  return response->resultsSize == 1 ? response->results[0].statusCode
                                    : UA_STATUSCODE_BADUNKNOWNRESPONSE;
}

base::Result<NodeValues> UaLink::Impl::history(const std::string& address,
                                               const HistorySpan& span) {
  const auto id = parsed(address);
  if (!id) {
    return base::fail(LinkError::VariableMissing, "The server has no such node.", address);
  }
  UA_HistoryReadValueId item;
  UA_HistoryReadValueId_init(&item);
  item.nodeId = (*id)->nodeId;
  NodeValues read;
  std::string more;
  do {
    HistoryResponse response;
    const UA_StatusCode status = askForHistory(item, span, false, response);
    if (isBad(status)) {
      return base::fail(historyRefusal(status, address));
    }
    const UA_HistoryReadResult& result = response->results[0];
    const UA_ExtensionObject& data = result.historyData;
    const std::size_t before = read.values.size() + read.withoutTime;
    if (data.encoding == UA_EXTENSIONOBJECT_DECODED &&
        data.content.decoded.type == &UA_TYPES[UA_TYPES_HISTORYDATA]) {
      appendValues(*static_cast<const UA_HistoryData*>(data.content.decoded.data), read);
    }
    more = view(result.continuationPoint);
    item.continuationPoint = more.empty() ? UA_BYTESTRING_NULL : UA_ByteString(borrow(more));
    const bool isTooMuch = read.values.size() > span.valuesMax;
    const bool isEmpty = read.values.size() + read.withoutTime == before;
    if (!more.empty() && (isTooMuch || isEmpty)) {
      HistoryResponse ignored;
      static_cast<void>(askForHistory(item, span, true, ignored));
    }
    if (isTooMuch) {
      return base::fail(LinkError::TooManyItems,
                        fmt::format("More than {} values were recorded in that time. Choose a "
                                    "shorter one.",
                                    span.valuesMax),
                        address);
    }
    if (!more.empty() && isEmpty) {
      return base::fail(LinkError::Rejected,
                        "The server goes on with pages of its history that hold no values.",
                        address);
    }
  } while (!more.empty());
  return read;
}

}  // namespace rivulet::opcua
