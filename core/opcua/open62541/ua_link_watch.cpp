// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <utility>

#include "base/contract.h"
#include "opcua/open62541/method_call.h"
#include "opcua/open62541/ua_link_impl.h"
#include "opcua/open62541/values.h"
#include "opcua/request.h"

namespace rivulet::opcua {

using base::Duration;
using base::Instant;
using std::chrono::milliseconds;

namespace {

/// While nothing changes, a server with a subscription is heard that often.
constexpr Duration kKeepAlive = std::chrono::seconds(1);
/// For how long it keeps a subscription that is not asked for any more.
constexpr Duration kSubscriptionLifetime = std::chrono::seconds(60);

}  // namespace

void UaLink::Impl::takePublish(const UA_PublishResponse& response) {
  const UA_NotificationMessage& message = response.notificationMessage;
  if (message.notificationDataSize > 0) {
    m_subscription->unconfirmed = message.sequenceNumber;
  }
  m_connection.isLost = m_connection.isLost || !takeNotification(message, m_changes);
  std::erase_if(m_changes,
                [this](const NodeChange& change) { return change.index >= m_subscription->items; });
}

void UaLink::Impl::publish() {
  UA_SubscriptionAcknowledgement heard;
  UA_SubscriptionAcknowledgement_init(&heard);
  UA_PublishRequest request;
  UA_PublishRequest_init(&request);
  request.requestHeader.timeoutHint = kLibraryTimeoutMs;
  if (m_subscription->unconfirmed) {
    heard.subscriptionId = m_subscription->id;
    heard.sequenceNumber = *m_subscription->unconfirmed;
    request.subscriptionAcknowledgements = &heard;
    request.subscriptionAcknowledgementsSize = 1;
  }
  m_subscription->unconfirmed.reset();
  m_subscription->serial = nextSerial();
  void* const serial = reinterpret_cast<void*>(static_cast<std::uintptr_t>(m_subscription->serial));
  const UA_StatusCode status = __UA_Client_AsyncService(
      m_client, &request, &UA_TYPES[UA_TYPES_PUBLISHREQUEST], &Impl::onAnswer,
      &UA_TYPES[UA_TYPES_PUBLISHRESPONSE], serial, nullptr);
  m_connection.isLost = m_connection.isLost || isBad(status);
}

base::Result<void> UaLink::Impl::watch(std::span<const std::string> addresses, Duration interval) {
  RIVULET_ASSERT(!m_subscription);
  std::vector<NodeId> ids;
  std::vector<UA_MonitoredItemCreateRequest> items;
  const double intervalMs = std::chrono::duration<double, std::milli>(interval).count();
  for (const std::string& address : addresses) {
    auto id = parsed(address);
    if (!id) {
      return base::fail(LinkError::VariableMissing, sentenceOf(LinkError::VariableMissing),
                        address);
    }
    ids.push_back(*std::move(id));
    UA_MonitoredItemCreateRequest& item = items.emplace_back();
    UA_MonitoredItemCreateRequest_init(&item);
    item.itemToMonitor.nodeId = ids.back()->nodeId;
    item.itemToMonitor.attributeId = UA_ATTRIBUTEID_VALUE;
    item.monitoringMode = UA_MONITORINGMODE_REPORTING;
    item.requestedParameters.clientHandle = static_cast<UA_UInt32>(items.size() - 1);
    item.requestedParameters.samplingInterval = intervalMs;
    item.requestedParameters.queueSize = 1;
    item.requestedParameters.discardOldest = true;
  }
  UA_CreateSubscriptionRequest create;
  UA_CreateSubscriptionRequest_init(&create);
  create.requestHeader.timeoutHint = kLibraryTimeoutMs;
  create.requestedPublishingInterval = intervalMs;
  create.requestedMaxKeepAliveCount =
      std::max<UA_UInt32>(1, static_cast<UA_UInt32>(kKeepAlive / interval));
  create.requestedLifetimeCount = static_cast<UA_UInt32>(kSubscriptionLifetime / interval);
  create.publishingEnabled = true;
  Handle<UA_CreateSubscriptionResponse, UA_TYPES_CREATESUBSCRIPTIONRESPONSE> created;
  UA_StatusCode status =
      exchange(&create, &UA_TYPES[UA_TYPES_CREATESUBSCRIPTIONREQUEST], created.get(),
               created.type(), addSaturating(now(), m_options.commandDeadline));
  if (isBad(status)) {
    return base::fail(requestError(status, Operation::Read, endpoint()));
  }
  UA_CreateMonitoredItemsRequest monitor;
  UA_CreateMonitoredItemsRequest_init(&monitor);
  monitor.requestHeader.timeoutHint = kLibraryTimeoutMs;
  monitor.subscriptionId = created->subscriptionId;
  monitor.timestampsToReturn = UA_TIMESTAMPSTORETURN_NEITHER;
  monitor.itemsToCreate = items.data();
  monitor.itemsToCreateSize = items.size();
  Handle<UA_CreateMonitoredItemsResponse, UA_TYPES_CREATEMONITOREDITEMSRESPONSE> monitored;
  status = exchange(&monitor, &UA_TYPES[UA_TYPES_CREATEMONITOREDITEMSREQUEST], monitored.get(),
                    monitored.type(), addSaturating(now(), m_options.commandDeadline));
  if (!isBad(status) && monitored->resultsSize != items.size()) {
    status = UA_STATUSCODE_BADUNKNOWNRESPONSE;
  }
  if (isBad(status)) {
    return base::fail(requestError(status, Operation::Read, endpoint()));
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (isBad(monitored->results[i].statusCode)) {
      return base::fail(
          requestError(monitored->results[i].statusCode, Operation::Read, addresses[i]));
    }
  }
  m_subscription = Subscription{created->subscriptionId, 0, std::nullopt, items.size()};
  publish();
  return {};
}

}  // namespace rivulet::opcua
