// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/ua_link.h"

#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <open62541/client.h>
#include <open62541/client_config_default.h>
#include <open62541/plugin/securitypolicy_default.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <deque>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <unordered_map>
#include <utility>

#include "base/contract.h"
#include "base/random.h"
#include "opcua/control_map.h"
#include "opcua/host_check.h"
#include "opcua/node_map.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/monotonic_clock.h"
#include "opcua/open62541/quiet_logger.h"
#include "opcua/open62541/status.h"
#include "opcua/open62541/tcp_manager.h"
#include "opcua/request.h"
#include "opcua/trace_parts.h"

// How it works. Requests wait in one queue, oldest first. A request of Grouping::List is one
// service call. A request of Grouping::Single is a chain of calls, each sent when the previous one
// has been answered, and nothing after it is sent until the chain is complete: so the server sees
// the items in the order of the requests. Every service call has a serial number that travels
// through the library as its user data; the answer to a call whose request has expired finds no
// request with its serial and is dropped. Callbacks only record; the consequences (an expired
// deadline, a lost connection, the next call) are handled in `settle`, outside the library.
//
// Deadlines are the link's own. The library must never forget a call: it closes the connection when
// an answer comes to a call that it does not know. So its own timeouts are longer than any silence
// that the link endures, and the calls that wait for a late answer are counted (`m_asked`).

namespace rivulet::opcua {

namespace {

using base::Duration;
using base::Instant;
using std::chrono::milliseconds;

using CallResponse = Handle<UA_CallResponse, UA_TYPES_CALLRESPONSE>;
using ReadResponse = Handle<UA_ReadResponse, UA_TYPES_READRESPONSE>;
using NodeId = Handle<UA_ExpandedNodeId, UA_TYPES_EXPANDEDNODEID>;

/// The library waits in whole milliseconds. A shorter remainder is waited for in naps of this
/// length, with a check of the network between them.
constexpr Duration kNap = std::chrono::microseconds(200);
/// Longest single wait inside the library; its timers run in between.
constexpr Duration kIterationMax = milliseconds(200);
/// When the library forgets a call: never while the connection lasts.
constexpr UA_UInt32 kLibraryTimeoutMs = 3'600'000;
/// As on the control.
constexpr UA_UInt32 kSessionTimeoutMs = 60'000;
/// Calls whose deadline has passed and that the server has not answered. As long as there are so
/// many, nothing more is sent: the answers to come would only queue up.
constexpr std::size_t kUnansweredMax = 4;
/// Connecting takes a dozen answers.
constexpr int kConnectDeadlines = 6;
/// Reconnections that belong to connecting: another name of the endpoint, another security policy.
constexpr int kHandshakesMax = 4;
/// Pause before a server that closed the connection is tried again; each is twice as long.
constexpr Duration kRetryPause = milliseconds(100);
/// For closing the session.
constexpr Duration kCloseDeadline = std::chrono::seconds(1);
constexpr UA_UInt32 kCloseStepMs = 10;
/// More nodes below one node are not listed.
constexpr std::size_t kChildrenMax = 20'000;
/// Nodes that are examined in one request; each has three attributes that are read.
constexpr std::size_t kExaminedAtOnce = 100;
/// Of a value that is shown to a person.
constexpr std::size_t kShownCharacters = 60;
constexpr std::size_t kShownElements = 3;
/// While nothing changes, a server with a subscription is heard that often.
constexpr Duration kKeepAlive = std::chrono::seconds(1);
/// For how long it keeps a subscription that is not asked for any more.
constexpr Duration kSubscriptionLifetime = std::chrono::seconds(60);

template <class T>
[[nodiscard]] std::optional<double> numberAs(const UA_Variant& variant, std::size_t typeIndex) {
  const T* value = scalarOf<T>(variant, typeIndex);
  return value == nullptr ? std::nullopt : std::optional(static_cast<double>(*value));
}

/// The number of a scalar of any numeric type.
[[nodiscard]] std::optional<double> numberOf(const UA_Variant& variant) {
  if (variant.type == nullptr || !UA_Variant_isScalar(&variant)) {
    return std::nullopt;
  }
  switch (variant.type->typeKind) {
    case UA_DATATYPEKIND_BOOLEAN:
      return numberAs<UA_Boolean>(variant, UA_TYPES_BOOLEAN);
    case UA_DATATYPEKIND_SBYTE:
      return numberAs<UA_SByte>(variant, UA_TYPES_SBYTE);
    case UA_DATATYPEKIND_BYTE:
      return numberAs<UA_Byte>(variant, UA_TYPES_BYTE);
    case UA_DATATYPEKIND_INT16:
      return numberAs<UA_Int16>(variant, UA_TYPES_INT16);
    case UA_DATATYPEKIND_UINT16:
      return numberAs<UA_UInt16>(variant, UA_TYPES_UINT16);
    case UA_DATATYPEKIND_INT32:
      return numberAs<UA_Int32>(variant, UA_TYPES_INT32);
    case UA_DATATYPEKIND_UINT32:
      return numberAs<UA_UInt32>(variant, UA_TYPES_UINT32);
    case UA_DATATYPEKIND_INT64:
      return numberAs<UA_Int64>(variant, UA_TYPES_INT64);
    case UA_DATATYPEKIND_UINT64:
      return numberAs<UA_UInt64>(variant, UA_TYPES_UINT64);
    case UA_DATATYPEKIND_FLOAT:
      return numberAs<UA_Float>(variant, UA_TYPES_FLOAT);
    case UA_DATATYPEKIND_DOUBLE:
      return numberAs<UA_Double>(variant, UA_TYPES_DOUBLE);
    default:
      return std::nullopt;
  }
}

/// A mask of bits, of whatever numeric type this server uses; no bit for what is none.
[[nodiscard]] unsigned bitsOf(const UA_DataValue& value) {
  const auto number = value.hasValue ? numberOf(value.value) : std::nullopt;
  const bool isMask = number && *number >= 0.0 && *number <= std::numeric_limits<unsigned>::max();
  return isMask ? static_cast<unsigned>(*number) : 0U;
}

[[nodiscard]] std::optional<std::string> textOf(const UA_Variant& variant) {
  if (const auto* string = scalarOf<UA_String>(variant, UA_TYPES_STRING)) {
    return std::string(view(*string));
  }
  if (const auto* localized = scalarOf<UA_LocalizedText>(variant, UA_TYPES_LOCALIZEDTEXT)) {
    return std::string(view(localized->text));
  }
  return std::nullopt;
}

[[nodiscard]] Reading readingOf(const UA_DataValue& value, VariableKind kind) {
  Reading reading;
  if (value.hasStatus && isBad(value.status)) {
    reading.status = linkErrorOf(value.status, Operation::Read);
    return reading;
  }
  if (isText(kind)) {
    if (auto text = value.hasValue ? textOf(value.value) : std::nullopt) {
      reading.text = std::move(*text);
      return reading;
    }
  } else if (const auto number = value.hasValue ? numberOf(value.value) : std::nullopt;
             number && std::isfinite(*number)) {
    reading.number = *number;
    return reading;
  }
  reading.status = LinkError::BadValue;
  return reading;
}

/// A reading of a variable that a map names.
[[nodiscard]] Reading mappedReading(const UA_DataValue& value, const ControlMap& map,
                                    const Variable& variable) {
  if (isText(variable.kind) || (value.hasStatus && isBad(value.status))) {
    return readingOf(value, variable.kind);
  }
  std::optional<StateValue> shown;
  if (const auto number = value.hasValue ? numberOf(value.value) : std::nullopt) {
    shown = *number;
  } else if (auto text = value.hasValue ? textOf(value.value) : std::nullopt) {
    shown = std::move(*text);
  }
  const auto meant = shown ? meaningOf(map, variable, *shown) : std::nullopt;
  Reading reading;
  if (meant && std::isfinite(*meant)) {
    reading.number = *meant;
  } else {
    reading.status = LinkError::BadValue;
  }
  return reading;
}

[[nodiscard]] NodeValue nodeValueOf(const UA_Variant& variant) {
  if (const auto* flag = scalarOf<UA_Boolean>(variant, UA_TYPES_BOOLEAN)) {
    return *flag;
  }
  if (const auto number = numberOf(variant)) {
    return *number;
  }
  if (auto text = textOf(variant)) {
    return *std::move(text);
  }
  if (UA_Variant_hasArrayType(&variant, &UA_TYPES[UA_TYPES_DOUBLE])) {
    const auto* const numbers = static_cast<const double*>(variant.data);
    return std::vector<double>(numbers, numbers + variant.arrayLength);
  }
  return {};
}

/// What a server has told of its subscription.
/// @return false: the subscription has ended
[[nodiscard]] bool takeNotification(const UA_NotificationMessage& message,
                                    std::vector<NodeChange>& changes) {
  for (std::size_t i = 0; i < message.notificationDataSize; ++i) {
    const UA_ExtensionObject& data = message.notificationData[i];
    if (data.encoding < UA_EXTENSIONOBJECT_DECODED) {
      continue;  // of a kind that the library does not know
    }
    const void* const content = data.content.decoded.data;
    if (data.content.decoded.type == &UA_TYPES[UA_TYPES_STATUSCHANGENOTIFICATION]) {
      return !isBad(static_cast<const UA_StatusChangeNotification*>(content)->status);
    }
    if (data.content.decoded.type != &UA_TYPES[UA_TYPES_DATACHANGENOTIFICATION]) {
      continue;
    }
    const auto& told = *static_cast<const UA_DataChangeNotification*>(content);
    for (std::size_t k = 0; k < told.monitoredItemsSize; ++k) {
      const UA_DataValue& value = told.monitoredItems[k].value;
      const bool isGood = value.hasValue && !(value.hasStatus && isBad(value.status));
      changes.push_back(
          {told.monitoredItems[k].clientHandle, isGood ? nodeValueOf(value.value) : NodeValue()});
    }
  }
  return true;
}

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
[[nodiscard]] std::array<UA_Variant, 4> traceInputs(trace::TracePosition& from) {
  return {borrowScalar(from.start, UA_TYPES_UINT64), borrowScalar(from.samples, UA_TYPES_UINT64),
          borrowScalar(from.blocks, UA_TYPES_UINT64), borrowScalar(from.events, UA_TYPES_UINT64)};
}

/// Its answer.
[[nodiscard]] base::Result<trace::TracePiece> tracePieceOf(const UA_CallMethodResult& result) {
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

/// A unit of a request: a variable, or consecutive R-parameters.
struct Node {
  Variable first;
  std::size_t length = 1;
  Grouping form = Grouping::List;  ///< an array form if the length is above 1, else List

  friend bool operator==(const Node&, const Node&) = default;
};

/// A control has far fewer variables of one kind than fit below the kind's bits.
struct NodeHash {
  [[nodiscard]] std::size_t operator()(const Node& node) const {
    constexpr unsigned kIndexBits = 20;
    constexpr unsigned kLengthBits = 20;
    constexpr unsigned kKindBits = 8;
    std::size_t hash = static_cast<std::size_t>(node.form);
    hash = (hash << kKindBits) ^ static_cast<std::size_t>(node.first.kind);
    hash = (hash << kLengthBits) ^ node.length;
    return (hash << kIndexBits) ^ static_cast<std::size_t>(node.first.index);
  }
};

/// The numbers of an array of doubles or floats; empty for anything else, or another length.
[[nodiscard]] std::vector<double> numbersOf(const UA_DataValue& value, std::size_t length) {
  const UA_Variant& array = value.value;
  if (!value.hasValue || array.arrayLength != length) {
    return {};
  }
  if (UA_Variant_hasArrayType(&array, &UA_TYPES[UA_TYPES_DOUBLE])) {
    const auto* const numbers = static_cast<const double*>(array.data);
    return {numbers, numbers + length};
  }
  if (UA_Variant_hasArrayType(&array, &UA_TYPES[UA_TYPES_FLOAT])) {
    const auto* const numbers = static_cast<const float*>(array.data);
    return {numbers, numbers + length};
  }
  return {};
}

/// One reading per element of an array.
void appendReadings(const UA_DataValue& value, std::size_t length, std::vector<Reading>& readings) {
  const bool bad = value.hasStatus && isBad(value.status);
  const std::vector<double> numbers = bad ? std::vector<double>() : numbersOf(value, length);
  for (std::size_t i = 0; i < length; ++i) {
    Reading reading;
    if (bad) {
      reading.status = linkErrorOf(value.status, Operation::Read);
    } else if (numbers.empty() || !std::isfinite(numbers[i])) {
      reading.status = LinkError::BadValue;
    } else {
      reading.number = numbers[i];
    }
    readings.push_back(std::move(reading));
  }
}

constexpr std::string_view kNoneUri = "http://opcfoundation.org/UA/SecurityPolicy#None";

[[nodiscard]] std::optional<UA_UInt16> namespaceIndex(std::span<const UA_String> uris,
                                                      std::string_view uri) {
  const auto found = std::find_if(uris.begin(), uris.end(),
                                  [&](const UA_String& one) { return view(one) == uri; });
  const std::ptrdiff_t index = found - uris.begin();
  return found == uris.end() || index > UA_UINT16_MAX
             ? std::nullopt
             : std::optional(static_cast<UA_UInt16>(index));
}

/// The endpoints of a server, in the library's own memory.
struct Endpoints {
  Endpoints() = default;
  ~Endpoints() { UA_Array_delete(list, count, &UA_TYPES[UA_TYPES_ENDPOINTDESCRIPTION]); }
  Endpoints(const Endpoints&) = delete;
  Endpoints& operator=(const Endpoints&) = delete;

  std::size_t count = 0;
  UA_EndpointDescription* list = nullptr;
};

/// The endpoint that is used.
struct SecureEndpoint {
  Handle<UA_EndpointDescription, UA_TYPES_ENDPOINTDESCRIPTION> description;
};

/// The policy by which a login is encrypted; nothing for one that Rivulet does not know.
[[nodiscard]] std::optional<SecurityPolicy> tokenPolicy(const UA_EndpointDescription& endpoint,
                                                        const UA_UserTokenPolicy& token) {
  return policyOfUri(view(token.securityPolicyUri.length > 0 ? token.securityPolicyUri
                                                             : endpoint.securityPolicyUri));
}

[[nodiscard]] UA_UserTokenType tokenTypeOf(LoginKind login) {
  switch (login) {
    case LoginKind::Anonymous:
      return UA_USERTOKENTYPE_ANONYMOUS;
    case LoginKind::UserName:
      return UA_USERTOKENTYPE_USERNAME;
    case LoginKind::Certificate:
      break;
  }
  return UA_USERTOKENTYPE_CERTIFICATE;
}

/// How an endpoint takes this kind of login: null if it does not, only with a password that can be
/// read on its way, or with a certificate on a channel that somebody else could take over.
[[nodiscard]] const UA_UserTokenPolicy* findToken(const UA_EndpointDescription& endpoint,
                                                  LoginKind login) {
  const UA_UserTokenType wanted = tokenTypeOf(login);
  for (std::size_t i = 0; i < endpoint.userIdentityTokensSize; ++i) {
    const UA_UserTokenPolicy& token = endpoint.userIdentityTokens[i];
    const auto policy = tokenPolicy(endpoint, token);
    const bool isProtected = policy && *policy != SecurityPolicy::None;
    const bool isSafe =
        login == LoginKind::Anonymous ||
        (login == LoginKind::UserName &&
         (isProtected || endpoint.securityMode == UA_MESSAGESECURITYMODE_SIGNANDENCRYPT)) ||
        (isProtected && endpoint.securityMode != UA_MESSAGESECURITYMODE_NONE);
    if (token.tokenType == wanted && policy && isSafe) {
      return &token;
    }
  }
  return nullptr;
}

/// In the order of the list, so that an index means the same. What Rivulet cannot use takes nobody.
[[nodiscard]] std::vector<EndpointOffer> offersOf(const Endpoints& endpoints) {
  std::vector<EndpointOffer> offers;
  for (std::size_t i = 0; i < endpoints.count; ++i) {
    const UA_EndpointDescription& endpoint = endpoints.list[i];
    const auto policy = policyOfUri(view(endpoint.securityPolicyUri));
    const bool isModeKnown = endpoint.securityMode >= UA_MESSAGESECURITYMODE_NONE &&
                             endpoint.securityMode <= UA_MESSAGESECURITYMODE_SIGNANDENCRYPT;
    const std::string_view profile = view(endpoint.transportProfileUri);
    // Siemens servers leave it empty.
    const bool isBinary = profile.empty() || profile.find("uatcp-uasc-uabinary") != profile.npos;
    EndpointOffer offer;
    if (policy && isModeKnown && isBinary) {
      offer.security = {*policy, static_cast<MessageMode>(endpoint.securityMode)};
      offer.takesAnonymous = findToken(endpoint, LoginKind::Anonymous) != nullptr;
      offer.takesUserName = findToken(endpoint, LoginKind::UserName) != nullptr;
      offer.takesCertificate = findToken(endpoint, LoginKind::Certificate) != nullptr;
    } else {
      offer.security = {SecurityPolicy::None,
                        MessageMode::Sign};  // contradicts itself: never taken
    }
    offers.push_back(std::move(offer));
  }
  return offers;
}

using MakePolicy = UA_StatusCode (*)(UA_SecurityPolicy*, UA_ByteString, UA_ByteString,
                                     const UA_Logger*);

[[nodiscard]] MakePolicy makerOf(SecurityPolicy policy) {
  switch (policy) {
    case SecurityPolicy::Basic128Rsa15:
      return &UA_SecurityPolicy_Basic128Rsa15;
    case SecurityPolicy::Basic256:
      return &UA_SecurityPolicy_Basic256;
    case SecurityPolicy::Basic256Sha256:
      return &UA_SecurityPolicy_Basic256Sha256;
    case SecurityPolicy::Aes128Sha256RsaOaep:
      return &UA_SecurityPolicy_Aes128Sha256RsaOaep;
    case SecurityPolicy::Aes256Sha256RsaPss:
      return &UA_SecurityPolicy_Aes256Sha256RsaPss;
    case SecurityPolicy::None:
      break;
  }
  return nullptr;
}

/// Adds a policy to a list of the library; None is always there.
[[nodiscard]] UA_StatusCode addPolicy(std::size_t& count, UA_SecurityPolicy*& list,
                                      SecurityPolicy policy, const OwnCertificate& own,
                                      const UA_Logger* logger) {
  const MakePolicy make = makerOf(policy);
  if (make == nullptr) {
    return UA_STATUSCODE_GOOD;
  }
  auto* grown =
      static_cast<UA_SecurityPolicy*>(UA_realloc(list, (count + 1) * sizeof(UA_SecurityPolicy)));
  if (grown == nullptr) {
    return UA_STATUSCODE_BADOUTOFMEMORY;
  }
  list = grown;
  const UA_StatusCode status =
      make(&list[count], borrow(own.certificate), borrow(own.privateKey), logger);
  count += status == UA_STATUSCODE_GOOD ? 1 : 0;
  return status;
}

/// Only the very certificate of the endpoint is accepted; whether it is trusted has been decided.
UA_StatusCode verifyServer(const UA_CertificateVerification* verification,
                           const UA_ByteString* chain) noexcept {
  const auto* expected = static_cast<const UA_ByteString*>(verification->context);
  return leafOf(view(*chain)) == leafOf(view(*expected)) ? UA_STATUSCODE_GOOD
                                                         : UA_STATUSCODE_BADCERTIFICATEUNTRUSTED;
}

/// The library asks this of our own certificate only.
UA_StatusCode verifyUri(const UA_CertificateVerification* /*verification*/,
                        const UA_ByteString* /*certificate*/,
                        const UA_String* /*applicationUri*/) noexcept {
  return UA_STATUSCODE_GOOD;
}

/// Shows the certificate of the user. That the user has its key, the library proves with the policy
/// of the login.
[[nodiscard]] UA_StatusCode setUserCertificate(UA_ClientConfig& config,
                                               const UserCertificate& user) {
  UA_X509IdentityToken* token = UA_X509IdentityToken_new();
  if (token == nullptr) {
    return UA_STATUSCODE_BADOUTOFMEMORY;
  }
  UA_ExtensionObject_setValue(&config.userIdentityToken, token,
                              &UA_TYPES[UA_TYPES_X509IDENTITYTOKEN]);
  const UA_ByteString certificate = borrow(user.certificate);
  return UA_ByteString_copy(&certificate, &token->certificateData);
}

[[nodiscard]] UA_StatusCode setUser(UA_ClientConfig& config, const ConnectOptions& options) {
  switch (loginKindOf(options)) {
    case LoginKind::Anonymous:
      return UA_STATUSCODE_GOOD;
    case LoginKind::UserName:
      return UA_ClientConfig_setAuthenticationUsername(&config, options.user.c_str(),
                                                       options.password.c_str());
    case LoginKind::Certificate:
      break;
  }
  return setUserCertificate(config, *options.userCertificate);
}

/// Binds a configuration to one endpoint: this policy, this mode, this certificate, this kind of
/// login. @param endpoint  outlives the client
[[nodiscard]] UA_StatusCode protect(UA_ClientConfig& config, const SecureEndpoint& endpoint,
                                    const ConnectOptions& options, const OwnCertificate& own) {
  const UA_EndpointDescription& description = *endpoint.description.get();
  const auto policy = policyOfUri(view(description.securityPolicyUri));
  const LoginKind kind = loginKindOf(options);
  const UA_UserTokenPolicy* token = findToken(description, kind);
  RIVULET_ASSERT(policy && token != nullptr);
  const SecurityPolicy login = *tokenPolicy(description, *token);

  UA_StatusCode status =
      addPolicy(config.securityPoliciesSize, config.securityPolicies, *policy, own, config.logging);
  if (login != *policy) {
    status |=
        addPolicy(config.securityPoliciesSize, config.securityPolicies, login, own, config.logging);
  }
  OwnCertificate signer = own;
  if (kind == LoginKind::Certificate) {
    signer.certificate = options.userCertificate->certificate;
    signer.privateKey = options.userCertificate->privateKey;
  }
  status |= addPolicy(config.authSecurityPoliciesSize, config.authSecurityPolicies, login, signer,
                      config.logging);
  explicit_bzero(signer.privateKey.data(), signer.privateKey.size());
  status |= UA_copy(&description, &config.endpoint, &UA_TYPES[UA_TYPES_ENDPOINTDESCRIPTION]);
  status |= UA_copy(token, &config.userTokenPolicy, &UA_TYPES[UA_TYPES_USERTOKENPOLICY]);
  const UA_String uri = borrow(own.applicationUri);
  UA_String_clear(&config.clientDescription.applicationUri);
  status |= UA_String_copy(&uri, &config.clientDescription.applicationUri);
  status |= setUser(config, options);

  UA_CertificateVerification& verification = config.certificateVerification;
  if (verification.clear != nullptr) {
    verification.clear(&verification);
  }
  verification = {};
  verification.context = const_cast<UA_ByteString*>(&description.serverCertificate);  // only read
  verification.verifyCertificate = &verifyServer;
  verification.verifyApplicationURI = &verifyUri;
  verification.logging = config.logging;
  return status;
}

/// Overwrites the password in the library's memory.
void forgetPassword(UA_ClientConfig& config) {
  UA_ExtensionObject& token = config.userIdentityToken;
  if (token.encoding >= UA_EXTENSIONOBJECT_DECODED &&
      token.content.decoded.type == &UA_TYPES[UA_TYPES_USERNAMEIDENTITYTOKEN]) {
    UA_ByteString_memZero(
        &static_cast<UA_UserNameIdentityToken*>(token.content.decoded.data)->password);
  }
  UA_ExtensionObject_clear(&token);
}

}  // namespace

class UaLink::Impl {
 public:
  explicit Impl(ConnectOptions options) : m_options(std::move(options)) {}
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[nodiscard]] base::Result<void> open();

  [[nodiscard]] Instant now() const { return m_clock.now(); }
  [[nodiscard]] base::Result<ServerIdentity> identity();
  [[nodiscard]] bool isVirtual() const { return m_isVirtual; }
  [[nodiscard]] Abilities abilities() const {
    return m_commands ? m_commands->abilities : Abilities{};
  }
  [[nodiscard]] const std::string& endpoint() const { return m_options.endpoint; }
  [[nodiscard]] const ChannelSecurity& security() const { return m_security; }
  [[nodiscard]] const std::optional<CertificateFacts>& serverCertificate() const {
    return m_certificate;
  }
  [[nodiscard]] base::Result<bool> mayWrite(const Variable& variable);
  [[nodiscard]] base::Result<std::vector<BrowsedNode>> children(const std::string& address);
  [[nodiscard]] base::Result<std::vector<NodeFacts>> examine(
      std::span<const std::string> addresses);
  /// Of a program in the control's file system.
  [[nodiscard]] std::string pathOf(std::string_view name) const {
    return isMapped() ? mappedProgramPath(m_map->methods, name) : programPath(name);
  }

  base::RequestId request(Operation operation, std::vector<Variable> variables,
                          std::vector<double> values, Duration deadline, Grouping grouping);
  base::RequestId store(const std::string& name, const std::string& text, Duration deadline);
  [[nodiscard]] bool givesTracePieces() const { return m_commands && m_commands->tracePieces; }
  base::RequestId readTrace(const trace::TracePosition& from, Duration deadline);
  std::optional<Event> wait(Instant until);
  [[nodiscard]] Duration silence() const;

  /// Calls a method and waits for its answer. @return its output arguments
  [[nodiscard]] base::Result<CallResponse> call(UA_UInt16 namespaceIndex, std::string_view object,
                                                std::string_view method,
                                                std::span<UA_Variant> inputs);
  /// Calls a method of the control's file system, wherever this edition keeps it.
  [[nodiscard]] base::Result<CallResponse> callFileMethod(std::string_view method,
                                                          std::span<UA_Variant> inputs);
  [[nodiscard]] base::Result<CallResponse> callMethods(std::string_view method,
                                                       std::span<UA_Variant> inputs) {
    return isMapped() ? callMapped(method, inputs)
                      : call(m_namespace, kMethodsObject, method, inputs);
  }
  [[nodiscard]] base::Result<CallResponse> callBeyond(std::string_view method,
                                                      std::span<UA_Variant> inputs);
  [[nodiscard]] base::Result<void> watch(std::span<const std::string> addresses, Duration interval);
  [[nodiscard]] std::vector<NodeChange> takeChanges() { return std::exchange(m_changes, {}); }
  [[nodiscard]] base::Result<std::vector<NodeValue>> callMethod(
      const std::string& object, const std::string& method, std::span<const std::string> inputs);

 private:
  /// One request of the caller; its service calls are made from the front of the item list on.
  struct Pending {
    base::RequestId id;
    Operation operation = Operation::Read;
    Grouping grouping = Grouping::List;
    std::vector<Variable> variables;
    std::vector<double> values;                ///< Write: one per variable
    std::string path;                          ///< Call: of the program to be stored
    std::string text;                          ///< Call
    std::optional<trace::TracePosition> from;  ///< Call: for the trace, not for a program
    bool isCalled = false;                     ///< Call: has been sent
    Instant deadline{};
    std::uint64_t serial = 0;  ///< of the service call in progress; 0 none
    std::size_t itemsSent = 0;
    std::size_t nodesSent = 0;  ///< of the service call in progress
    Event event;                ///< grows with every answer
    UA_StatusCode failure = UA_STATUSCODE_GOOD;
    bool done = false;

    [[nodiscard]] bool isSent() const {
      return operation == Operation::Call ? isCalled : itemsSent == variables.size();
    }
  };

  /// One call of `exchange`.
  struct Exchange {
    std::uint64_t serial = 0;
    void* response = nullptr;
    const UA_DataType* responseType = nullptr;
    bool answered = false;
  };

  static void onAnswer(UA_Client* client, void* serial, UA_UInt32 requestId,
                       void* response) noexcept;
  static void onState(UA_Client* client, UA_SecureChannelState channel, UA_SessionState session,
                      UA_StatusCode status) noexcept;
  void answered(std::uint64_t serial, void* response);
  void takeRead(Pending& pending, const UA_ReadResponse& response);
  void takeWrite(Pending& pending, const UA_WriteResponse& response);
  static void takeCall(Pending& pending, const UA_CallResponse& response);
  void takePublish(const UA_PublishResponse& response);
  /// Asks for what the subscription has to tell next; the server answers when there is something.
  void publish();

  [[nodiscard]] base::Error error(LinkError code) const;
  [[nodiscard]] base::Error connectError(UA_StatusCode status) const {
    return opcua::connectError(status, endpoint());
  }

  void limitSending();
  static UA_StatusCode onSend(UA_ConnectionManager* manager, std::uintptr_t connectionId,
                              const UA_KeyValueMap* parameters, UA_ByteString* message) noexcept;
  /// A client that is not connected yet, in place of the present one.
  /// @param endpoint  null: without encryption, whatever the server names
  [[nodiscard]] base::Result<void> createClient(const SecureEndpoint* endpoint);
  void deleteClient();
  [[nodiscard]] base::Result<SecureEndpoint> discover();
  [[nodiscard]] base::Result<void> checkServer(const SecureEndpoint& endpoint);
  [[nodiscard]] base::Result<void> handshake();
  /// After the server has closed the connection while connecting. @return the new status
  [[nodiscard]] UA_StatusCode reconnect(bool wasOpen, Instant deadline);
  [[nodiscard]] bool pauseBefore(Instant deadline);
  void close();
  /// Notes that a service call is about to be made.
  [[nodiscard]] std::uint64_t nextSerial();
  /// Calls that nobody waits for any more and that the server may still answer.
  [[nodiscard]] std::size_t unanswered() const;
  void noticeState();
  [[nodiscard]] base::Error lossError() const;
  void step(Instant until);
  void settle();
  void finishAnswered();
  void expire(Instant now);
  [[nodiscard]] Pending newPending(Operation operation, EventKind kind, Duration deadline);
  /// Takes the call of a method. @param hasMethod  false: the server has none
  base::RequestId begin(Pending pending, bool hasMethod);
  void sendDue();
  void send(Pending& pending);
  [[nodiscard]] UA_StatusCode sendCall(Pending& pending, void* serial);
  void fail(Pending& pending, base::Error error);
  void noticeLoss();
  /// Where a variable is on a server that is no SINUMERIK.
  struct Address {
    NodeId id;          ///< null: nowhere; every server refuses it
    std::string range;  ///< elements of an array; empty: the whole value

    [[nodiscard]] bool isNowhere() const { return UA_NodeId_isNull(&id->nodeId); }
  };
  struct MethodAddress {
    NodeId object;
    NodeId method;
  };

  /// Whether variables have the addresses of a map, be it of a control or of anything else.
  [[nodiscard]] bool isMapped() const { return m_map != nullptr; }
  [[nodiscard]] const std::string& identifier(const Node& node);
  /// Borrows; valid as long as the connection. @param range  set for elements of an array
  [[nodiscard]] UA_NodeId nodeId(const Node& node, UA_String& range);
  [[nodiscard]] const Address& addressOf(const Node& node);
  [[nodiscard]] Reading nowhere(const Variable& variable) const;
  /// Why the values cannot be written into cells of type Float; nothing: they can.
  [[nodiscard]] std::optional<base::Error> lostByFloat(const Pending& pending) const;
  void restoreMeant(const Variable& variable, Reading& reading) const;
  void noteFloats(const Pending& pending);
  /// In the type of the cells; valid until the next request.
  [[nodiscard]] void* numberToSend(Pending& pending, std::size_t item);
  [[nodiscard]] base::Result<void> resolveMap();
  [[nodiscard]] base::Result<void> resolveVariables();
  [[nodiscard]] base::Result<void> resolveMethods();
  [[nodiscard]] base::Result<void> checkAddresses();
  [[nodiscard]] base::Result<NodeId> resolve(const std::string& address, const std::string& key);
  [[nodiscard]] base::Result<NodeId> resolvePath(const std::string& path, const std::string& key);
  /// Nothing for a text that is no node id of this server.
  [[nodiscard]] std::optional<NodeId> parsed(const std::string& address) const;
  [[nodiscard]] std::string addressText(const UA_NodeId& id) const;
  [[nodiscard]] base::Error wrongAddress(const std::string& key, const std::string& what) const;
  [[nodiscard]] base::Result<CallResponse> callMapped(std::string_view method,
                                                      std::span<UA_Variant> inputs);
  [[nodiscard]] base::Result<CallResponse> callNode(const UA_NodeId& object,
                                                    const UA_NodeId& method,
                                                    const std::string& name,
                                                    std::span<UA_Variant> inputs);
  void appendChildren(const UA_BrowseResult& result, std::vector<BrowsedNode>& nodes) const;

  [[nodiscard]] UA_StatusCode exchange(const void* request, const UA_DataType* requestType,
                                       void* response, const UA_DataType* responseType,
                                       Instant deadline);
  [[nodiscard]] base::Result<void> resolveNamespaces(Instant deadline);
  [[nodiscard]] base::Result<bool> exists(const UA_NodeId& node, Instant deadline);
  [[nodiscard]] base::Result<ReadResponse> readAttribute(const UA_NodeId& node,
                                                         UA_AttributeId attribute,
                                                         Instant deadline);

  ConnectOptions m_options;
  ChannelSecurity m_security;
  std::optional<CertificateFacts> m_certificate;
  OwnCertificate m_own;
  std::optional<SecureEndpoint> m_secureEndpoint;  ///< the library refers to it
  MonotonicClock m_clock;
  QuietLogger m_logger;
  UA_Client* m_client = nullptr;
  UA_StatusCode (*m_send)(UA_ConnectionManager*, std::uintptr_t, const UA_KeyValueMap*,
                          UA_ByteString*) = nullptr;
  UA_UInt16 m_namespace = 0;
  /// Where the methods are that a SINUMERIK does not have.
  struct Commands {
    UA_UInt16 nameSpace = 0;
    std::string_view object;
    Abilities abilities;
    bool tracePieces = false;  ///< `kFetchTracePiece`
  };
  bool m_isVirtual = false;
  std::optional<Commands> m_commands;
  std::string_view m_fileMethods = kMethodsObject;  ///< where this edition keeps them

  /// Requests borrow from both: their elements stay where they are.
  std::unordered_map<Node, std::string, NodeHash> m_identifiers;
  std::shared_ptr<const ControlMap> m_map;  ///< null: names of a SINUMERIK
  std::map<Variable, Address> m_addressed;
  std::unordered_map<Node, Address, NodeHash> m_blocks;  ///< of several cells
  bool m_hasFloatCells = false;
  std::map<int, double> m_meant;  ///< last value sent, by R number; with cells of type Float
  std::vector<float> m_floats;    ///< scratch of `send`
  std::map<std::string_view, MethodAddress> m_methods;        ///< by the SINUMERIK's names
  std::map<std::string, std::vector<BrowsedNode>> m_browsed;  ///< while paths are resolved
  std::vector<std::string> m_namespaces;
  std::vector<Node> m_nodes;                ///< scratch of `send`
  std::vector<UA_ReadValueId> m_readItems;  ///< scratch of `send`
  std::vector<UA_WriteValue> m_writeItems;  ///< scratch of `send`

  std::deque<Pending> m_pending;
  std::deque<Event> m_events;
  Exchange m_exchange;
  struct Subscription {
    UA_UInt32 id = 0;
    std::uint64_t serial = 0;              ///< of the request that is open; 0: none
    std::optional<UA_UInt32> unconfirmed;  ///< number of the message that was heard last
    std::size_t items = 0;
  };
  std::optional<Subscription> m_subscription;
  std::vector<NodeChange> m_changes;
  base::RequestId m_lastId;
  std::uint64_t m_lastSerial = 0;
  /// Service calls that the server has not answered, in the order in which they were made.
  struct Asked {
    std::uint64_t serial = 0;
    Instant at{};
  };
  std::deque<Asked> m_asked;
  Instant m_heardAt{};  ///< the last answer, be it late
  int m_handshakes = 0;
  int m_retries = 0;
  bool m_isSilent = false;     ///< the reason of the loss
  bool m_established = false;  ///< from now on a bad state is a loss
  bool m_activity = false;     ///< a callback has run
  bool m_lost = false;
  bool m_lossReported = false;
};

// --- connection ---------------------------------------------------------------------------------

UaLink::Impl::~Impl() {
  deleteClient();
}

void UaLink::Impl::deleteClient() {
  m_established = false;  // what the library reports while it closes is not a loss
  if (m_client != nullptr) {
    close();
    UA_Client_delete(m_client);
    m_client = nullptr;
  }
}

/// The library waits for the end of its connection without a limit, and does not close one on which
/// it has received something that is no OPC UA. So the session gets some time to end, and then all
/// connections are closed below the library.
void UaLink::Impl::close() {
  UA_EventLoop* loop = UA_Client_getConfig(m_client)->eventLoop;
  if (loop == nullptr || loop->state != UA_EVENTLOOPSTATE_STARTED) {
    return;
  }
  const Instant deadline = now() + kCloseDeadline;
  UA_SecureChannelState channel = UA_SECURECHANNELSTATE_CLOSED;
  UA_Client_getState(m_client, &channel, nullptr, nullptr);
  if (channel == UA_SECURECHANNELSTATE_OPEN && !m_isSilent) {
    UA_Client_disconnectAsync(m_client);
    while (channel != UA_SECURECHANNELSTATE_CLOSED && now() < deadline) {
      loop->run(loop, kCloseStepMs);
      UA_Client_getState(m_client, &channel, nullptr, nullptr);
    }
  }
  loop->stop(loop);
  while (loop->state != UA_EVENTLOOPSTATE_STOPPED && now() < deadline + kCloseDeadline) {
    loop->run(loop, kCloseStepMs);
  }
}

base::Result<void> UaLink::Impl::open() {
  if (auto host = requireHost(m_options.endpoint); !host) {
    return host;
  }
  std::optional<SecureEndpoint>& endpoint = m_secureEndpoint;
  const LoginKind login = loginKindOf(m_options);
  if (m_options.security != unencrypted() || login != LoginKind::Anonymous) {
    auto found = discover();
    if (!found) {
      return base::fail(found.error());
    }
    endpoint = std::move(*found);
    if (auto trusted = checkServer(*endpoint); !trusted) {
      return trusted;
    }
  }
  const bool isPlain =
      !endpoint || (m_security == ChannelSecurity{} && login == LoginKind::Anonymous);
  if (auto created = createClient(isPlain ? nullptr : &*endpoint); !created) {
    return created;
  }
  if (auto connected = handshake(); !connected) {
    if (!endpoint && connected.error().code == LinkError::LoginRefused) {
      // The library found nothing to connect with; what the server offers says why.
      if (auto offered = discover(); !offered) {
        return base::fail(offered.error());
      }
    }
    return connected;
  }
  UA_ClientConfig* config = UA_Client_getConfig(m_client);
  config->noNewSession = true;
  forgetPassword(*config);  // the session is never activated again
  explicit_bzero(m_options.password.data(), m_options.password.size());
  if (m_options.userCertificate) {
    std::string& key = m_options.userCertificate->privateKey;
    explicit_bzero(key.data(), key.size());
  }
  m_options.own = nullptr;
  m_options.trust = nullptr;
  m_options.offered = nullptr;
  m_established = true;
  return resolveNamespaces(addSaturating(now(), 2 * m_options.connectDeadline));
}

base::Result<void> UaLink::Impl::createClient(const SecureEndpoint* endpoint) {
  deleteClient();
  UA_ClientConfig config;
  std::memset(&config, 0, sizeof config);
  config.logging = m_logger.handle();
  config.timeout = kLibraryTimeoutMs;
  config.requestedSessionTimeout = kSessionTimeoutMs;
  config.connectivityCheckInterval = 0;  // its answer could come late, too
  config.stateCallback = &Impl::onState;
  config.clientContext = this;
  UA_StatusCode status = UA_ClientConfig_setDefault(&config);
  if (status == UA_STATUSCODE_GOOD && endpoint != nullptr) {
    status = protect(config, *endpoint, m_options, m_own);
  }
  if (status != UA_STATUSCODE_GOOD) {
    UA_ClientConfig_clear(&config);
    return base::fail(LinkError::Rejected, "The OPC UA library cannot be set up.",
                      this->endpoint());
  }
  // The library would connect again at once and without end. While connecting it has to, because
  // the server may name another endpoint; afterwards a lost connection stays lost, because a stream
  // must not continue as if nothing had happened.
  config.noReconnect = true;
  const UA_String name = borrow(m_options.name);
  UA_String_copy(&name, &config.sessionName);
  m_client = UA_Client_newWithConfig(&config);
  RIVULET_ASSERT(m_client != nullptr);
  limitSending();
  return {};
}

/// Asks the server what it offers, on a connection of its own without encryption. Nothing of the
/// answer is trusted: who falsifies it can prevent the connection, not weaken it.
base::Result<SecureEndpoint> UaLink::Impl::discover() {
  const Instant deadline = addSaturating(now(), m_options.connectDeadline);
  Endpoints found;
  UA_StatusCode status = UA_STATUSCODE_BADTIMEOUT;
  do {
    if (auto created = createClient(nullptr); !created) {
      return base::fail(created.error());
    }
    UA_ClientConfig* config = UA_Client_getConfig(m_client);
    config->timeout =
        static_cast<UA_UInt32>(std::chrono::ceil<milliseconds>(m_options.connectDeadline).count());
    config->noReconnect = false;
    // With an endpoint of its own, the library does not look for one that it can open a session on.
    config->endpoint.securityMode = UA_MESSAGESECURITYMODE_NONE;
    const UA_String none = borrow(kNoneUri);
    const UA_String url = borrow(m_options.endpoint);
    UA_String_copy(&none, &config->endpoint.securityPolicyUri);
    UA_String_copy(&url, &config->endpoint.endpointUrl);
    status =
        UA_Client_getEndpoints(m_client, m_options.endpoint.c_str(), &found.count, &found.list);
  } while (status == UA_STATUSCODE_BADCONNECTIONCLOSED && pauseBefore(deadline));
  deleteClient();
  if (isBad(status)) {
    return base::fail(connectError(status));
  }
  const std::vector<EndpointOffer> offers = offersOf(found);
  if (m_options.offered) {
    m_options.offered(offers);
  }
  const auto chosen = chooseOffer(offers, m_options.security, loginKindOf(m_options));
  if (!chosen) {
    return base::fail(chosen.error().code, chosen.error().message, endpoint());
  }
  m_security = offers[*chosen].security;
  SecureEndpoint endpoint;
  UA_copy(&found.list[*chosen], endpoint.description.get(),
          &UA_TYPES[UA_TYPES_ENDPOINTDESCRIPTION]);
  // A server may send the certificates of its issuers along; the library compares the first only.
  UA_ByteString& certificate = endpoint.description->serverCertificate;
  if (const std::size_t length = leafOf(view(certificate)).size(); length > 0) {
    certificate.length = length;
  }
  return endpoint;
}

base::Result<void> UaLink::Impl::checkServer(const SecureEndpoint& endpoint) {
  if (m_security == ChannelSecurity{} && loginKindOf(m_options) == LoginKind::Anonymous) {
    return {};
  }
  if (!m_options.own || !m_options.trust) {
    return base::fail(LinkError::CertificateUnknown,
                      "No certificates are set up on this computer, so nothing can be encrypted.",
                      this->endpoint());
  }
  auto own = m_options.own();
  if (!own) {
    return base::fail(own.error());
  }
  m_own = std::move(*own);
  // The password is encrypted for this certificate even where messages are not.
  const std::string_view der = leafOf(view(endpoint.description->serverCertificate));
  const auto facts = readCertificate(der);
  if (!facts) {
    return base::fail(facts.error().code, facts.error().message, this->endpoint());
  }
  if (auto trusted = m_options.trust(*facts, der); !trusted) {
    return base::fail(trusted.error().code, trusted.error().message, this->endpoint());
  }
  m_certificate = *facts;
  return {};
}

/// While the other side takes no data, the library tries to send for ever. So the system is told to
/// end such a connection. The number of a connection is that of its socket.
void UaLink::Impl::limitSending() {
  if (auto* manager = ownedTcpManager(*UA_Client_getConfig(m_client)->eventLoop, this)) {
    m_send = std::exchange(manager->sendWithConnection, &Impl::onSend);
  }
}

UA_StatusCode UaLink::Impl::onSend(UA_ConnectionManager* manager, std::uintptr_t connectionId,
                                   const UA_KeyValueMap* parameters,
                                   UA_ByteString* message) noexcept {
  const auto* self = static_cast<const Impl*>(ownerOf(*manager));
  const auto limitMs = static_cast<unsigned>(
      std::chrono::duration_cast<milliseconds>(self->m_options.silenceMax).count());
  setsockopt(static_cast<int>(connectionId), IPPROTO_TCP, TCP_USER_TIMEOUT, &limitMs,
             sizeof limitMs);
  return self->m_send(manager, connectionId, parameters, message);
}

base::Result<void> UaLink::Impl::handshake() {
  const Instant limit = addSaturating(now(), kConnectDeadlines * m_options.connectDeadline);
  Instant deadline = addSaturating(now(), m_options.connectDeadline);
  bool wasOpen = false;
  UA_SessionState reached = UA_SESSIONSTATE_CLOSED;
  UA_StatusCode status = UA_Client_connectAsync(m_client, m_options.endpoint.c_str());
  for (;;) {
    UA_SecureChannelState channel = UA_SECURECHANNELSTATE_CLOSED;
    UA_SessionState session = UA_SESSIONSTATE_CLOSED;
    if (!isBad(status)) {
      UA_Client_getState(m_client, &channel, &session, &status);
    }
    if (status == UA_STATUSCODE_BADNOTCONNECTED) {
      status = reconnect(wasOpen, std::min(deadline, limit));
      wasOpen = false;
    }
    if (isBad(status)) {
      return base::fail(connectError(status));
    }
    const bool isOpen = channel == UA_SECURECHANNELSTATE_OPEN;
    if (isOpen && session == UA_SESSIONSTATE_ACTIVATED) {
      return {};
    }
    if ((isOpen && !wasOpen) || session > reached) {
      deadline = addSaturating(now(), 3 * m_options.connectDeadline);
      wasOpen = wasOpen || isOpen;
      reached = std::max(reached, session);
    }
    const Duration left = std::min(deadline, limit) - now();
    if (left <= Duration::zero()) {
      return base::fail(connectError(UA_STATUSCODE_BADTIMEOUT));
    }
    const auto ms = std::chrono::ceil<milliseconds>(std::min(left, kIterationMax)).count();
    status = UA_Client_run_iterate(m_client, static_cast<UA_UInt32>(ms));
  }
}

UA_StatusCode UaLink::Impl::reconnect(bool wasOpen, Instant deadline) {
  if ((!wasOpen || ++m_handshakes > kHandshakesMax) && !pauseBefore(deadline)) {
    return UA_STATUSCODE_BADCONNECTIONCLOSED;
  }
  return UA_Client_connectAsync(m_client, m_options.endpoint.c_str());
}

/// @return false, without a pause, if the deadline would be missed
bool UaLink::Impl::pauseBefore(Instant deadline) {
  // Clients that were turned away together do not come back together.
  base::Random random(static_cast<std::uint64_t>(now().time_since_epoch().count()));
  const double factor = (0.5 + random.uniform()) * std::pow(2.0, m_retries++);
  const Instant next = now() + base::fromSeconds(base::toSeconds(kRetryPause) * factor);
  if (next >= deadline) {
    return false;
  }
  m_clock.sleepUntil(next);
  return true;
}

base::Result<void> UaLink::Impl::resolveNamespaces(Instant deadline) {
  auto answer =
      readAttribute(standardNodeId(UA_NS0ID_SERVER_NAMESPACEARRAY), UA_ATTRIBUTEID_VALUE, deadline);
  if (!answer) {
    return base::fail(answer.error());
  }
  const UA_DataValue& value = (*answer)->results[0];
  std::span<const UA_String> uris;
  if (value.hasValue && UA_Variant_hasArrayType(&value.value, &UA_TYPES[UA_TYPES_STRING])) {
    uris = {static_cast<const UA_String*>(value.value.data), value.value.arrayLength};
  }
  for (const UA_String& uri : uris) {
    m_namespaces.emplace_back(view(uri));
  }
  if (m_options.map != nullptr) {
    m_map = m_options.map;
    if (auto resolved = resolveMap(); !resolved) {
      return resolved;
    }
  } else if (!m_options.nodes.empty()) {
    ControlMap map;
    map.nodes = std::move(m_options.nodes);
    m_map = std::make_shared<const ControlMap>(std::move(map));
    return resolveVariables();  // no control
  }
  const std::optional<UA_UInt16> found = namespaceIndex(uris, kNamespaceUri);
  const std::optional<UA_UInt16> foundVirtual = namespaceIndex(uris, kVirtualNamespaceUri);
  const std::optional<UA_UInt16> foundBridge = namespaceIndex(uris, kBridgeNamespaceUri);
  if (!found && !isMapped()) {
    return base::fail(error(LinkError::NamespaceMissing));
  }
  m_namespace = found.value_or(0);
  // The namespace alone proves nothing; the object itself must be there.
  if (foundVirtual) {
    const auto isThere = exists(borrowNodeId(*foundVirtual, kVirtualObject), deadline);
    if (!isThere) {
      return base::fail(isThere.error());
    }
    if (*isThere) {
      m_isVirtual = true;
      const std::string piece = memberIdentifier(kVirtualObject, kFetchTracePiece);
      const auto givesPieces = exists(borrowNodeId(*foundVirtual, piece), deadline);
      if (!givesPieces) {
        return base::fail(givesPieces.error());
      }
      m_commands = Commands{*foundVirtual, kVirtualObject, {true, true}, *givesPieces};
      return {};
    }
  }
  if (foundBridge) {
    Abilities abilities;
    for (const auto& [method, ability] : {std::pair(kCycleStart, &abilities.startsOnRequest),
                                          {kFetchTrace, &abilities.keepsTrace}}) {
      const std::string identifier = memberIdentifier(kBridgeObject, method);
      const auto isThere = exists(borrowNodeId(*foundBridge, identifier), deadline);
      if (!isThere) {
        return base::fail(isThere.error());
      }
      *ability = *isThere;
    }
    m_commands = Commands{*foundBridge, kBridgeObject, abilities};
  }
  return {};
}

// --- addresses of a map -------------------------------------------------------------------------

std::optional<NodeId> UaLink::Impl::parsed(const std::string& address) const {
  NodeId id;
  if (isBad(UA_ExpandedNodeId_parse(id.get(), borrow(address))) || id->serverIndex != 0) {
    return std::nullopt;
  }
  if (id->namespaceUri.length > 0) {
    const auto found = std::find(m_namespaces.begin(), m_namespaces.end(), view(id->namespaceUri));
    if (found == m_namespaces.end()) {
      return std::nullopt;
    }
    id->nodeId.namespaceIndex = static_cast<UA_UInt16>(found - m_namespaces.begin());
  }
  return id;
}

base::Error UaLink::Impl::wrongAddress(const std::string& key, const std::string& what) const {
  return base::makeError(
      MapError::WrongAddress,
      fmt::format("{} of the map: {} Correct the map; rivulet-cli map shows what the server has.",
                  key, what),
      endpoint());
}

base::Result<NodeId> UaLink::Impl::resolve(const std::string& address, const std::string& key) {
  if (isBrowsePath(address)) {
    return resolvePath(address, key);
  }
  auto id = parsed(address);
  if (!id) {
    return base::fail(wrongAddress(
        key, fmt::format("{} is in a namespace that the server does not have.", address)));
  }
  return std::move(*id);
}

/// By browsing, level after level: names are compared in whatever namespace they are. The levels
/// are kept, because many addresses share them.
base::Result<NodeId> UaLink::Impl::resolvePath(const std::string& path, const std::string& key) {
  std::string at = kObjectsFolder;
  for (const BrowseStep& step : browseSteps(path)) {
    auto known = m_browsed.find(at);
    if (known == m_browsed.end()) {
      auto nodes = children(at);
      if (!nodes) {
        return base::fail(nodes.error());
      }
      known = m_browsed.emplace(at, std::move(*nodes)).first;
    }
    const BrowsedNode* found = nullptr;
    for (const BrowsedNode& node : known->second) {
      if (node.name != step.name || (step.nameSpace && *step.nameSpace != node.nameSpace)) {
        continue;
      }
      if (found != nullptr && found->address != node.address) {
        return base::fail(wrongAddress(
            key, fmt::format("{} is ambiguous: there are two nodes {}. Write the node id.", path,
                             step.name)));
      }
      found = &node;
    }
    if (found == nullptr) {
      return base::fail(
          wrongAddress(key, fmt::format("{} ends at {}: there is no such node.", path, step.name)));
    }
    at = found->address;
  }
  auto id = parsed(at);
  if (!id) {
    return base::fail(wrongAddress(key, fmt::format("{} is on another server.", path)));
  }
  return std::move(*id);
}

base::Result<void> UaLink::Impl::resolveMap() {
  for (const auto step : {&Impl::resolveVariables, &Impl::resolveMethods, &Impl::checkAddresses}) {
    if (auto done = (this->*step)(); !done) {
      return done;
    }
  }
  m_browsed.clear();
  return {};
}

base::Result<void> UaLink::Impl::resolveVariables() {
  for (const auto& [variable, address] : m_map->nodes) {
    if (m_options.map == nullptr) {
      auto id = parsed(address);
      if (!id) {
        return base::fail(LinkError::VariableMissing,
                          fmt::format("{} is no node of this server. Write it like ns=2;s=Robot.X "
                                      "or nsu=urn:robot;s=X, as a browser of OPC UA shows it.",
                                      address),
                          endpoint());
      }
      m_addressed[variable].id = std::move(*id);
      continue;
    }
    auto id = resolve(address, mapKeyOf(variable));
    if (!id) {
      return base::fail(id.error());
    }
    m_addressed[variable].id = std::move(*id);
  }
  const CellNodes& cells = m_map->cells;
  for (int number = cells.first; number <= cells.last; ++number) {
    auto id = resolve(cellAddress(cells, number), mapKeyOf(rParameter(number)));
    if (!id) {
      return base::fail(id.error());
    }
    Address& address = m_addressed[rParameter(number)];
    address.id = std::move(*id);
    if (cells.isArray) {
      address.range = std::to_string(number + cells.offset);
    }
  }
  return {};
}

base::Result<void> UaLink::Impl::resolveMethods() {
  const MethodNodes& methods = m_map->methods;
  const std::array<std::pair<std::string_view, const std::string*>, 3> named{
      {{kCopyToServer, &methods.write},
       {kCopyFromServer, &methods.read},
       {kSelect, &methods.select}}};
  for (const auto& [name, address] : named) {
    if (address->empty()) {
      continue;
    }
    auto object = resolve(methods.object, "methods.object");
    if (!object) {
      return base::fail(object.error());
    }
    auto method = resolve(*address, "methods");
    if (!method) {
      return base::fail(method.error());
    }
    m_methods.emplace(name, MethodAddress{std::move(*object), std::move(*method)});
  }
  return {};
}

/// A wrong address would otherwise be noticed in the middle of a run, or never.
base::Result<void> UaLink::Impl::checkAddresses() {
  const CellNodes& cells = m_map->cells;
  for (const auto& [variable, address] : m_addressed) {
    const bool isCell = variable.kind == VariableKind::RParameter;
    if (isCell && variable.index != cells.first && variable.index != cells.last) {
      continue;  // all others are made in the same way
    }
    const auto answer = readAttribute(address.id->nodeId, UA_ATTRIBUTEID_VALUE,
                                      addSaturating(now(), m_options.commandDeadline));
    if (!answer) {
      return base::fail(answer.error());
    }
    const UA_DataValue& value = (*answer)->results[0];
    const std::string node =
        isCell ? cellAddress(cells, variable.index) : addressText(address.id->nodeId);
    const LinkError status = value.hasStatus && isBad(value.status)
                                 ? linkErrorOf(value.status, Operation::Read)
                                 : LinkError{};
    if (status == LinkError::VariableMissing) {
      return base::fail(
          wrongAddress(mapKeyOf(variable), fmt::format("the server has no variable {}.", node)));
    }
    if (!isCell || status != LinkError{}) {
      continue;  // a value may be missing for a while
    }
    const auto element = static_cast<std::size_t>(variable.index + cells.offset);
    const auto isOf = [&value, &cells, element](std::size_t type) {
      return cells.isArray
                 ? value.hasValue && UA_Variant_hasArrayType(&value.value, &UA_TYPES[type]) &&
                       value.value.arrayLength > element
                 : value.hasValue && UA_Variant_hasScalarType(&value.value, &UA_TYPES[type]);
    };
    m_hasFloatCells = isOf(UA_TYPES_FLOAT);
    if (m_hasFloatCells && cells.resolution <= 0.0) {
      return base::fail(wrongAddress(
          mapKeyOf(variable),
          fmt::format("R{} is {}, a Float, which does not carry every number. Write the smallest "
                      "increment of the axes into [cells], like resolution = 0.001.",
                      variable.index, node)));
    }
    if (!m_hasFloatCells && !isOf(UA_TYPES_DOUBLE)) {
      return base::fail(wrongAddress(
          mapKeyOf(variable),
          fmt::format("R{} is {}, which is no {}. Cells carry numbers of type Double only.",
                      variable.index, node,
                      cells.isArray ? "array of Double with this element" : "Double")));
    }
  }
  return {};
}

std::string UaLink::Impl::addressText(const UA_NodeId& id) const {
  UA_String printed = UA_STRING_NULL;
  if (isBad(UA_NodeId_print(&id, &printed))) {
    return {};
  }
  std::string text(view(printed));
  UA_String_clear(&printed);
  const std::size_t index = id.namespaceIndex;
  if (index > 0 && index < m_namespaces.size() &&
      m_namespaces[index].find(';') == std::string::npos) {
    text = fmt::format("nsu={};{}", m_namespaces[index], text.substr(text.find(';') + 1));
  }
  return text;
}

void UaLink::Impl::appendChildren(const UA_BrowseResult& result,
                                  std::vector<BrowsedNode>& nodes) const {
  for (std::size_t i = 0; i < result.referencesSize; ++i) {
    const UA_ReferenceDescription& reference = result.references[i];
    if (reference.nodeId.serverIndex != 0) {
      continue;
    }
    BrowsedNode node;
    node.address = addressText(reference.nodeId.nodeId);
    node.nameSpace = reference.browseName.namespaceIndex;
    node.name = view(reference.browseName.name);
    node.kind = reference.nodeClass == UA_NODECLASS_VARIABLE ? NodeKind::Variable
                : reference.nodeClass == UA_NODECLASS_OBJECT ? NodeKind::Object
                : reference.nodeClass == UA_NODECLASS_METHOD ? NodeKind::Method
                                                             : NodeKind::Other;
    if (reference.browseName.namespaceIndex < m_namespaces.size()) {
      node.nameUri = m_namespaces[reference.browseName.namespaceIndex];
    }
    nodes.push_back(std::move(node));
  }
}

base::Result<std::vector<BrowsedNode>> UaLink::Impl::children(const std::string& address) {
  const auto id = parsed(address);
  if (!id) {
    return base::fail(LinkError::VariableMissing, "The server has no such node.", address);
  }
  UA_BrowseDescription item;
  UA_BrowseDescription_init(&item);
  item.nodeId = (*id)->nodeId;
  item.browseDirection = UA_BROWSEDIRECTION_FORWARD;
  item.referenceTypeId = standardNodeId(UA_NS0ID_HIERARCHICALREFERENCES);
  item.includeSubtypes = true;
  item.resultMask = UA_BROWSERESULTMASK_NODECLASS | UA_BROWSERESULTMASK_BROWSENAME;
  UA_BrowseRequest request;
  UA_BrowseRequest_init(&request);
  request.requestHeader.timeoutHint = kLibraryTimeoutMs;
  request.nodesToBrowse = &item;
  request.nodesToBrowseSize = 1;
  Handle<UA_BrowseResponse, UA_TYPES_BROWSERESPONSE> response;
  const Instant deadline = addSaturating(now(), m_options.commandDeadline);
  UA_StatusCode status = exchange(&request, &UA_TYPES[UA_TYPES_BROWSEREQUEST], response.get(),
                                  response.type(), deadline);
  if (!isBad(status)) {
    status = response->resultsSize == 1 ? response->results[0].statusCode
                                        : UA_STATUSCODE_BADUNKNOWNRESPONSE;
  }
  if (isBad(status)) {
    return base::fail(requestError(status, Operation::Read, address));
  }
  std::vector<BrowsedNode> nodes;
  appendChildren(response->results[0], nodes);
  std::string more(view(response->results[0].continuationPoint));
  while (!more.empty()) {
    UA_ByteString point = borrow(more);
    UA_BrowseNextRequest next;
    UA_BrowseNextRequest_init(&next);
    next.requestHeader.timeoutHint = kLibraryTimeoutMs;
    next.continuationPoints = &point;
    next.continuationPointsSize = 1;
    next.releaseContinuationPoints = nodes.size() > kChildrenMax;
    Handle<UA_BrowseNextResponse, UA_TYPES_BROWSENEXTRESPONSE> rest;
    status = exchange(&next, &UA_TYPES[UA_TYPES_BROWSENEXTREQUEST], rest.get(), rest.type(),
                      addSaturating(now(), m_options.commandDeadline));
    if (nodes.size() > kChildrenMax) {
      return base::fail(LinkError::TooManyItems,
                        fmt::format("More than {} nodes are below this one.", kChildrenMax),
                        address);
    }
    if (!isBad(status)) {
      status =
          rest->resultsSize == 1 ? rest->results[0].statusCode : UA_STATUSCODE_BADUNKNOWNRESPONSE;
    }
    if (isBad(status)) {
      return base::fail(requestError(status, Operation::Read, address));
    }
    appendChildren(rest->results[0], nodes);
    more = view(rest->results[0].continuationPoint);
  }
  return nodes;
}

namespace {

/// Names of the built-in types, by their numbers. @source OPC UA part 6, 5.1.2
constexpr std::array<std::string_view, 26> kTypeNames{"",
                                                      "Boolean",
                                                      "SByte",
                                                      "Byte",
                                                      "Int16",
                                                      "UInt16",
                                                      "Int32",
                                                      "UInt32",
                                                      "Int64",
                                                      "UInt64",
                                                      "Float",
                                                      "Double",
                                                      "String",
                                                      "DateTime",
                                                      "Guid",
                                                      "ByteString",
                                                      "XmlElement",
                                                      "NodeId",
                                                      "ExpandedNodeId",
                                                      "StatusCode",
                                                      "QualifiedName",
                                                      "LocalizedText",
                                                      "Structure",
                                                      "DataValue",
                                                      "BaseDataType",
                                                      "DiagnosticInfo"};

[[nodiscard]] std::string typeName(const UA_DataValue& value) {
  const auto* id = value.hasValue ? scalarOf<UA_NodeId>(value.value, UA_TYPES_NODEID) : nullptr;
  return id != nullptr && id->namespaceIndex == 0 && id->identifierType == UA_NODEIDTYPE_NUMERIC &&
                 id->identifier.numeric < kTypeNames.size()
             ? std::string(kTypeNames[id->identifier.numeric])
             : std::string();
}

[[nodiscard]] std::string shownValue(const UA_Variant& variant) {
  if (const auto number = numberOf(variant)) {
    return fmt::format("{}", *number);
  }
  if (const auto text = textOf(variant)) {
    return text->size() <= kShownCharacters ? *text : text->substr(0, kShownCharacters - 1) + "…";
  }
  if (UA_Variant_hasArrayType(&variant, &UA_TYPES[UA_TYPES_DOUBLE])) {
    const auto* const numbers = static_cast<const double*>(variant.data);
    std::string text;
    for (std::size_t i = 0; i < std::min(variant.arrayLength, kShownElements); ++i) {
      text += fmt::format("{}{}", i == 0 ? "" : ", ", numbers[i]);
    }
    return variant.arrayLength > kShownElements ? text + ", …" : text;
  }
  return {};
}

[[nodiscard]] NodeFacts factsOf(const UA_DataValue& value, const UA_DataValue& type,
                                const UA_DataValue& level) {
  NodeFacts facts;
  facts.type = typeName(type);
  const unsigned mask = bitsOf(level);
  facts.mayRead = (mask & UA_ACCESSLEVELMASK_READ) != 0;
  facts.mayWrite = (mask & UA_ACCESSLEVELMASK_WRITE) != 0;
  if (value.hasStatus && isBad(value.status)) {
    facts.status = linkErrorOf(value.status, Operation::Read);
    return facts;
  }
  if (!value.hasValue || value.value.type == nullptr) {
    facts.status = LinkError::BadValue;
    return facts;
  }
  const UA_Variant& variant = value.value;
  facts.isArray = !UA_Variant_isScalar(&variant);
  facts.length = facts.isArray ? variant.arrayLength : 1;
  const UA_UInt32 kind = variant.type->typeKind;
  facts.isBoolean = kind == UA_DATATYPEKIND_BOOLEAN;
  facts.isNumber = kind >= UA_DATATYPEKIND_SBYTE && kind <= UA_DATATYPEKIND_DOUBLE;
  facts.isText = kind == UA_DATATYPEKIND_STRING || kind == UA_DATATYPEKIND_LOCALIZEDTEXT;
  facts.value = shownValue(variant);
  return facts;
}

}  // namespace

base::Result<std::vector<NodeFacts>> UaLink::Impl::examine(std::span<const std::string> addresses) {
  constexpr std::array kAttributes{UA_ATTRIBUTEID_VALUE, UA_ATTRIBUTEID_DATATYPE,
                                   UA_ATTRIBUTEID_USERACCESSLEVEL};
  std::vector<NodeFacts> facts;
  while (!addresses.empty()) {
    const auto some = addresses.first(std::min(addresses.size(), kExaminedAtOnce));
    addresses = addresses.subspan(some.size());
    std::vector<NodeId> ids;
    std::vector<UA_ReadValueId> items;
    for (const std::string& address : some) {
      auto id = parsed(address);
      ids.push_back(id ? std::move(*id) : NodeId());
      for (const UA_AttributeId attribute : kAttributes) {
        UA_ReadValueId& item = items.emplace_back();
        UA_ReadValueId_init(&item);
        item.nodeId = ids.back()->nodeId;
        item.attributeId = static_cast<UA_UInt32>(attribute);
      }
    }
    UA_ReadRequest request;
    UA_ReadRequest_init(&request);
    request.requestHeader.timeoutHint = kLibraryTimeoutMs;
    request.timestampsToReturn = UA_TIMESTAMPSTORETURN_NEITHER;
    request.nodesToRead = items.data();
    request.nodesToReadSize = items.size();
    ReadResponse response;
    UA_StatusCode status =
        exchange(&request, &UA_TYPES[UA_TYPES_READREQUEST], response.get(), ReadResponse::type(),
                 addSaturating(now(), m_options.commandDeadline));
    if (!isBad(status) && response->resultsSize != items.size()) {
      status = UA_STATUSCODE_BADUNKNOWNRESPONSE;
    }
    if (isBad(status)) {
      return base::fail(requestError(status, Operation::Read, endpoint()));
    }
    for (std::size_t i = 0; i < some.size(); ++i) {
      const UA_DataValue* const of = &response->results[i * kAttributes.size()];
      facts.push_back(factsOf(of[0], of[1], of[2]));
    }
  }
  return facts;
}

// --- further questions --------------------------------------------------------------------------

base::Result<bool> UaLink::Impl::exists(const UA_NodeId& node, Instant deadline) {
  const auto answer = readAttribute(node, UA_ATTRIBUTEID_NODECLASS, deadline);
  if (!answer) {
    return base::fail(answer.error());
  }
  const UA_DataValue& nodeClass = (*answer)->results[0];
  return nodeClass.hasValue && !(nodeClass.hasStatus && isBad(nodeClass.status));
}

base::Result<ServerIdentity> UaLink::Impl::identity() {
  const Instant deadline = addSaturating(now(), m_options.commandDeadline);
  ServerIdentity identity;
  // The first entry of its server array is the server itself.
  const auto servers =
      readAttribute(standardNodeId(UA_NS0ID_SERVER_SERVERARRAY), UA_ATTRIBUTEID_VALUE, deadline);
  if (!servers) {
    return base::fail(servers.error());
  }
  const UA_DataValue& uris = (*servers)->results[0];
  if (uris.hasValue && UA_Variant_hasArrayType(&uris.value, &UA_TYPES[UA_TYPES_STRING]) &&
      uris.value.arrayLength > 0) {
    identity.applicationUri = view(*static_cast<const UA_String*>(uris.value.data));
  }
  const std::array<std::pair<UA_UInt32, std::string*>, 3> members{
      {{UA_NS0ID_SERVER_SERVERSTATUS_BUILDINFO_PRODUCTNAME, &identity.productName},
       {UA_NS0ID_SERVER_SERVERSTATUS_BUILDINFO_SOFTWAREVERSION, &identity.softwareVersion},
       {UA_NS0ID_SERVER_SERVERSTATUS_BUILDINFO_BUILDNUMBER, &identity.buildNumber}}};
  for (const auto& [node, text] : members) {
    const auto answer = readAttribute(standardNodeId(node), UA_ATTRIBUTEID_VALUE, deadline);
    if (!answer) {
      return base::fail(answer.error());
    }
    const UA_DataValue& value = (*answer)->results[0];
    *text = (value.hasValue ? textOf(value.value) : std::nullopt).value_or(std::string());
  }
  return identity;
}

base::Result<ReadResponse> UaLink::Impl::readAttribute(const UA_NodeId& node,
                                                       UA_AttributeId attribute, Instant deadline) {
  UA_ReadValueId item;
  UA_ReadValueId_init(&item);
  item.nodeId = node;
  item.attributeId = static_cast<UA_UInt32>(attribute);
  UA_ReadRequest request;
  UA_ReadRequest_init(&request);
  request.requestHeader.timeoutHint = kLibraryTimeoutMs;
  request.timestampsToReturn = UA_TIMESTAMPSTORETURN_NEITHER;
  request.nodesToRead = &item;
  request.nodesToReadSize = 1;
  ReadResponse response;
  UA_StatusCode status = exchange(&request, &UA_TYPES[UA_TYPES_READREQUEST], response.get(),
                                  ReadResponse::type(), deadline);
  if (!isBad(status) && response->resultsSize != 1) {
    status = UA_STATUSCODE_BADUNKNOWNRESPONSE;
  }
  if (isBad(status)) {
    return base::fail(requestError(status, Operation::Read, endpoint()));
  }
  return response;
}

base::Result<bool> UaLink::Impl::mayWrite(const Variable& variable) {
  const Node node{variable, 1, Grouping::List};
  const std::string name = isMapped() ? mapKeyOf(variable) : identifier(node);
  UA_String range{};
  const auto answer = readAttribute(nodeId(node, range), UA_ATTRIBUTEID_USERACCESSLEVEL,
                                    addSaturating(now(), m_options.commandDeadline));
  if (!answer) {
    return base::fail(answer.error());
  }
  const UA_DataValue& value = (*answer)->results[0];
  if (value.hasStatus && isBad(value.status)) {
    return base::fail(requestError(value.status, Operation::Read, name));
  }
  return (bitsOf(value) & UA_ACCESSLEVELMASK_WRITE) != 0;
}

base::Error UaLink::Impl::error(LinkError code) const {
  return base::makeError(code, sentenceOf(code), endpoint());
}

// --- callbacks of the library -------------------------------------------------------------------

void UaLink::Impl::onState(UA_Client* client, UA_SecureChannelState channel,
                           UA_SessionState session, UA_StatusCode status) noexcept {
  auto* self = static_cast<Impl*>(UA_Client_getContext(client));
  if (self->m_established && (isBad(status) || channel != UA_SECURECHANNELSTATE_OPEN ||
                              session != UA_SESSIONSTATE_ACTIVATED)) {
    self->m_lost = true;
    self->m_activity = true;
  }
}

void UaLink::Impl::onAnswer(UA_Client* client, void* serial, UA_UInt32 /*requestId*/,
                            void* response) noexcept {
  auto* self = static_cast<Impl*>(UA_Client_getContext(client));
  self->m_activity = true;
  self->answered(reinterpret_cast<std::uintptr_t>(serial), response);
}

std::uint64_t UaLink::Impl::nextSerial() {
  m_asked.push_back({++m_lastSerial, now()});
  return m_lastSerial;
}

std::size_t UaLink::Impl::unanswered() const {
  const auto awaited = std::count_if(m_pending.begin(), m_pending.end(),
                                     [](const Pending& pending) { return pending.serial != 0; });
  const bool publishes = m_subscription && m_subscription->serial != 0;
  return m_asked.size() - static_cast<std::size_t>(awaited) - (publishes ? 1 : 0) -
         (m_exchange.serial != 0 && !m_exchange.answered ? 1 : 0);
}

Duration UaLink::Impl::silence() const {
  return m_asked.empty() ? Duration{} : now() - std::max(m_heardAt, m_asked.front().at);
}

void UaLink::Impl::answered(std::uint64_t serial, void* response) {
  m_heardAt = now();
  std::erase_if(m_asked, [&](const Asked& asked) { return asked.serial == serial; });
  const UA_StatusCode status = static_cast<const UA_ResponseHeader*>(response)->serviceResult;
  if (meansConnectionLost(status)) {
    m_lost = m_lost || m_established;
    return;
  }
  if (m_exchange.serial == serial) {
    // Moved out; the library clears what is left.
    std::memcpy(m_exchange.response, response, m_exchange.responseType->memSize);
    UA_init(response, m_exchange.responseType);
    m_exchange.answered = true;
    return;
  }
  if (m_subscription && m_subscription->serial == serial) {
    m_subscription->serial = 0;
    m_lost = m_lost || isBad(status);  // what it tells would be missed without a word
    if (!isBad(status)) {
      takePublish(*static_cast<const UA_PublishResponse*>(response));
    }
    return;
  }
  const auto pending = std::find_if(m_pending.begin(), m_pending.end(),
                                    [&](const Pending& p) { return p.serial == serial; });
  if (pending == m_pending.end()) {
    return;  // it has expired
  }
  pending->serial = 0;
  pending->event.at = now();
  if (isBad(status)) {
    pending->failure = status;
    pending->done = true;
    return;
  }
  if (pending->operation == Operation::Read) {
    takeRead(*pending, *static_cast<const UA_ReadResponse*>(response));
  } else if (pending->operation == Operation::Call) {
    takeCall(*pending, *static_cast<const UA_CallResponse*>(response));
  } else {
    takeWrite(*pending, *static_cast<const UA_WriteResponse*>(response));
  }
}

void UaLink::Impl::takeRead(Pending& pending, const UA_ReadResponse& response) {
  std::vector<Reading>& readings = pending.event.readings;
  const std::size_t readingsBefore = readings.size();
  if (response.resultsSize != pending.nodesSent) {
    pending.failure = UA_STATUSCODE_BADUNKNOWNRESPONSE;
    pending.done = true;
    return;
  }
  for (std::size_t i = 0; i < response.resultsSize; ++i) {
    const std::size_t length =
        sharedNodeLength(pending.variables, readings.size(), pending.grouping);
    const Variable& variable = pending.variables[readings.size()];
    const Address* const address =
        isMapped() ? &addressOf({variable, length, length > 1 ? pending.grouping : Grouping::List})
                   : nullptr;
    if (address != nullptr && address->isNowhere()) {
      readings.insert(readings.end(), length, nowhere(variable));
    } else if (length > 1 || (address != nullptr && !address->range.empty())) {
      appendReadings(response.results[i], length, readings);
    } else if (address != nullptr) {
      readings.push_back(mappedReading(response.results[i], *m_map, variable));
    } else {
      readings.push_back(readingOf(response.results[i], variable.kind));
    }
  }
  for (std::size_t i = readingsBefore; i < readings.size(); ++i) {
    restoreMeant(pending.variables[i], readings[i]);
  }
  pending.done = readings.size() == pending.variables.size();
}

void UaLink::Impl::takeWrite(Pending& pending, const UA_WriteResponse& response) {
  std::vector<std::error_code>& statuses = pending.event.statuses;
  if (response.resultsSize != pending.nodesSent) {
    pending.failure = UA_STATUSCODE_BADUNKNOWNRESPONSE;
    pending.done = true;
    return;
  }
  for (std::size_t i = 0; i < response.resultsSize; ++i) {
    const std::size_t length =
        sharedNodeLength(pending.variables, statuses.size(), pending.grouping);
    const Variable& variable = pending.variables[statuses.size()];
    const bool isNowhere =
        isMapped() &&
        addressOf({variable, length, length > 1 ? pending.grouping : Grouping::List}).isNowhere();
    const UA_StatusCode status = isNowhere ? UA_STATUSCODE_BADNODEIDUNKNOWN : response.results[i];
    statuses.insert(
        statuses.end(), length,
        isBad(status) ? make_error_code(linkErrorOf(status, Operation::Write)) : std::error_code());
  }
  pending.done = statuses.size() == pending.variables.size();
}

void UaLink::Impl::takeCall(Pending& pending, const UA_CallResponse& response) {
  pending.failure =
      response.resultsSize == 1 ? response.results[0].statusCode : UA_STATUSCODE_BADUNKNOWNRESPONSE;
  pending.done = true;
  if (!pending.from || isBad(pending.failure)) {
    return;
  }
  if (auto piece = tracePieceOf(response.results[0])) {
    pending.event.trace = std::make_shared<const trace::TracePiece>(*std::move(piece));
  } else {
    pending.failure = UA_STATUSCODE_BADUNKNOWNRESPONSE;
  }
}

// --- requests -----------------------------------------------------------------------------------

UaLink::Impl::Pending UaLink::Impl::newPending(Operation operation, EventKind kind,
                                               Duration deadline) {
  Pending pending;
  pending.id = ++m_lastId;
  pending.operation = operation;
  pending.event.kind = kind;
  pending.event.request = pending.id;
  pending.event.sent = now();
  pending.event.at = pending.event.sent;
  pending.deadline = addSaturating(pending.event.sent, deadline);
  return pending;
}

void UaLink::Impl::takePublish(const UA_PublishResponse& response) {
  const UA_NotificationMessage& message = response.notificationMessage;
  if (message.notificationDataSize > 0) {
    m_subscription->unconfirmed = message.sequenceNumber;
  }
  m_lost = m_lost || !takeNotification(message, m_changes);
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
  m_lost = m_lost || isBad(status);
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

base::RequestId UaLink::Impl::begin(Pending pending, bool hasMethod) {
  noticeLoss();  // comes before this request
  if (m_lost) {
    fail(pending, error(LinkError::ConnectionLost));
  } else if (!hasMethod) {
    fail(pending, error(LinkError::MethodMissing));
  } else {
    m_pending.push_back(std::move(pending));
    sendDue();
  }
  return m_lastId;
}

base::RequestId UaLink::Impl::request(Operation operation, std::vector<Variable> variables,
                                      std::vector<double> values, Duration deadline,
                                      Grouping grouping) {
  Pending pending = newPending(
      operation, operation == Operation::Read ? EventKind::ReadDone : EventKind::WriteDone,
      deadline);
  const bool isControl = m_options.map != nullptr || !isMapped();
  pending.grouping = isControl ? grouping : Grouping::List;
  pending.variables = std::move(variables);
  pending.values = std::move(values);
  if (operation == Operation::Read) {
    pending.event.readings.reserve(pending.variables.size());
  } else {
    pending.event.statuses.reserve(pending.variables.size());
  }

  noticeLoss();  // comes before this request
  if (m_lost) {
    fail(pending, error(LinkError::ConnectionLost));
  } else if (const auto fault = requestFault(pending.variables, pending.values)) {
    fail(pending, error(*fault));
  } else if (const auto lost = lostByFloat(pending)) {
    fail(pending, *lost);
  } else if (pending.variables.empty()) {
    m_events.push_back(std::move(pending.event));  // nothing to request from the server
  } else {
    m_pending.push_back(std::move(pending));
    sendDue();
  }
  return m_lastId;
}

std::optional<base::Error> UaLink::Impl::lostByFloat(const Pending& pending) const {
  if (!m_hasFloatCells) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < pending.values.size(); ++i) {
    const double value = pending.values[i];
    if (!asFloat(value, m_map->cells.resolution)) {
      return base::makeError(
          LinkError::BadValue,
          fmt::format("R{} cannot be {}: the cells of this server are of type Float, which is off "
                      "by more than half the resolution of {}. Stay nearer to the origin, or give "
                      "the control cells of type Double.",
                      pending.variables[i].index, value, m_map->cells.resolution),
          endpoint());
    }
  }
  return std::nullopt;
}

/// A cell of type Float that carries what was sent shows what was meant.
void UaLink::Impl::restoreMeant(const Variable& variable, Reading& reading) const {
  if (!m_hasFloatCells || variable.kind != VariableKind::RParameter) {
    return;
  }
  const auto meant = m_meant.find(variable.index);
  if (meant != m_meant.end() &&
      static_cast<double>(static_cast<float>(meant->second)) == reading.number) {
    reading.number = meant->second;
  }
}

base::RequestId UaLink::Impl::store(const std::string& name, const std::string& text,
                                    Duration deadline) {
  Pending pending = newPending(Operation::Call, EventKind::WriteDone, deadline);
  pending.path = pathOf(name);
  pending.text = text;
  return begin(std::move(pending), !isMapped() || m_methods.contains(kCopyToServer));
}

base::RequestId UaLink::Impl::readTrace(const trace::TracePosition& from, Duration deadline) {
  if (!givesTracePieces()) {
    return {};
  }
  Pending pending = newPending(Operation::Call, EventKind::TraceDone, deadline);
  pending.from = from;
  return begin(std::move(pending), true);
}

UA_StatusCode UaLink::Impl::sendCall(Pending& pending, void* serial) {
  if (pending.from) {
    std::array inputs = traceInputs(*pending.from);
    const std::string piece = memberIdentifier(m_commands->object, kFetchTracePiece);
    MethodCall method(borrowNodeId(m_commands->nameSpace, m_commands->object),
                      borrowNodeId(m_commands->nameSpace, piece), inputs);
    pending.isCalled = true;
    return __UA_Client_AsyncService(m_client, &method.request, &UA_TYPES[UA_TYPES_CALLREQUEST],
                                    &Impl::onAnswer, &UA_TYPES[UA_TYPES_CALLRESPONSE], serial,
                                    nullptr);
  }
  UA_String target = borrow(pending.path);
  UA_ByteString data = borrow(pending.text);
  UA_Boolean mayOverwrite = true;
  std::array inputs{borrowScalar(target, UA_TYPES_STRING), borrowScalar(data, UA_TYPES_BYTESTRING),
                    borrowScalar(mayOverwrite, UA_TYPES_BOOLEAN)};
  const std::string methodIdentifier = memberIdentifier(m_fileMethods, kCopyToServer);
  const auto mapped = m_methods.find(kCopyToServer);
  const bool isMappedMethod = mapped != m_methods.end();
  MethodCall method(
      isMappedMethod ? mapped->second.object->nodeId : borrowNodeId(m_namespace, m_fileMethods),
      isMappedMethod ? mapped->second.method->nodeId : borrowNodeId(m_namespace, methodIdentifier),
      inputs);
  pending.isCalled = true;
  return __UA_Client_AsyncService(m_client, &method.request, &UA_TYPES[UA_TYPES_CALLREQUEST],
                                  &Impl::onAnswer, &UA_TYPES[UA_TYPES_CALLRESPONSE], serial,
                                  nullptr);
}

const std::string& UaLink::Impl::identifier(const Node& node) {
  const auto found = m_identifiers.find(node);
  if (found != m_identifiers.end()) {
    return found->second;
  }
  return m_identifiers
      .emplace(node, node.length > 1 ? arrayIdentifier({node.first.index,
                                                        static_cast<int>(node.length), node.form})
                                     : nodeIdentifier(node.first))
      .first->second;
}

const UaLink::Impl::Address& UaLink::Impl::addressOf(const Node& node) {
  static const Address kNowhere;
  if (node.length == 1) {
    const auto found = m_addressed.find(node.first);
    return found == m_addressed.end() ? kNowhere : found->second;
  }
  const auto known = m_blocks.find(node);
  if (known != m_blocks.end()) {
    return known->second;
  }
  Address address;
  const CellNodes& cells = m_map->cells;
  const ParameterArray block{node.first.index, static_cast<int>(node.length), node.form};
  if (const std::string text = blockAddress(cells, block); !text.empty()) {
    if (cells.isArray) {
      const auto first = m_addressed.find(node.first);
      UA_copy(first->second.id.get(), address.id.get(), NodeId::type());
      const int from = block.first + cells.offset;
      address.range = fmt::format("{}:{}", from, from + block.count - 1);
    } else if (auto id = parsed(text)) {
      address.id = std::move(*id);
    }
  }
  return m_blocks.emplace(node, std::move(address)).first->second;
}

/// What the map says of a variable that the server does not have.
Reading UaLink::Impl::nowhere(const Variable& variable) const {
  Reading reading;
  if (auto letter = axisLetterOf(*m_map, variable)) {
    reading.text = std::move(*letter);
  } else {
    reading.status = LinkError::VariableMissing;
  }
  return reading;
}

UA_NodeId UaLink::Impl::nodeId(const Node& node, UA_String& range) {
  if (!isMapped()) {
    return borrowNodeId(m_namespace, identifier(node));
  }
  const Address& address = addressOf(node);
  if (!address.range.empty()) {
    range = borrow(address.range);  // an empty text is not none: node-opcua cuts a text by it
  }
  return address.id->nodeId;
}

void UaLink::Impl::sendDue() {
  for (Pending& pending : m_pending) {
    if (m_lost || unanswered() >= kUnansweredMax) {
      return;
    }
    if (!pending.isSent() && pending.serial == 0) {
      send(pending);
    }
    if (!pending.isSent()) {
      return;  // a chain in progress: what follows it waits
    }
  }
}

void UaLink::Impl::send(Pending& pending) {
  const std::size_t first = pending.itemsSent;
  const std::size_t items =
      pending.grouping == Grouping::Single ? std::size_t{1} : pending.variables.size();
  pending.serial = nextSerial();
  pending.itemsSent = first + items;
  void* const serial = reinterpret_cast<void*>(static_cast<std::uintptr_t>(pending.serial));
  if (pending.operation == Operation::Call) {
    const UA_StatusCode called = sendCall(pending, serial);
    m_lost = m_lost || isBad(called);
    return;
  }
  m_nodes.clear();
  for (std::size_t item = first; item < pending.itemsSent; item += m_nodes.back().length) {
    const std::size_t length = sharedNodeLength(pending.variables, item, pending.grouping);
    m_nodes.push_back(
        {pending.variables[item], length, length > 1 ? pending.grouping : Grouping::List});
  }
  pending.nodesSent = m_nodes.size();

  UA_StatusCode status = UA_STATUSCODE_GOOD;
  if (pending.operation == Operation::Read) {
    m_readItems.resize(m_nodes.size());
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
      UA_ReadValueId& item = m_readItems[i];
      UA_ReadValueId_init(&item);
      item.nodeId = nodeId(m_nodes[i], item.indexRange);
      item.attributeId = UA_ATTRIBUTEID_VALUE;
    }
    UA_ReadRequest request;
    UA_ReadRequest_init(&request);
    request.requestHeader.timeoutHint = kLibraryTimeoutMs;
    request.timestampsToReturn = UA_TIMESTAMPSTORETURN_NEITHER;
    request.nodesToRead = m_readItems.data();
    request.nodesToReadSize = m_readItems.size();
    status = __UA_Client_AsyncService(m_client, &request, &UA_TYPES[UA_TYPES_READREQUEST],
                                      &Impl::onAnswer, &UA_TYPES[UA_TYPES_READRESPONSE], serial,
                                      nullptr);
  } else {
    m_writeItems.resize(m_nodes.size());
    const std::size_t type = m_hasFloatCells ? UA_TYPES_FLOAT : UA_TYPES_DOUBLE;
    noteFloats(pending);
    std::size_t value = first;
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
      // The value only: some servers refuse a write that carries a status or timestamps.
      UA_WriteValue& item = m_writeItems[i];
      UA_WriteValue_init(&item);
      item.nodeId = nodeId(m_nodes[i], item.indexRange);
      item.attributeId = UA_ATTRIBUTEID_VALUE;
      item.value.hasValue = true;
      if (m_nodes[i].length > 1 || item.indexRange.length > 0) {
        UA_Variant_setArray(&item.value.value, numberToSend(pending, value), m_nodes[i].length,
                            &UA_TYPES[type]);
      } else {
        UA_Variant_setScalar(&item.value.value, numberToSend(pending, value), &UA_TYPES[type]);
      }
      value += m_nodes[i].length;
    }
    UA_WriteRequest request;
    UA_WriteRequest_init(&request);
    request.requestHeader.timeoutHint = kLibraryTimeoutMs;
    request.nodesToWrite = m_writeItems.data();
    request.nodesToWriteSize = m_writeItems.size();
    status = __UA_Client_AsyncService(m_client, &request, &UA_TYPES[UA_TYPES_WRITEREQUEST],
                                      &Impl::onAnswer, &UA_TYPES[UA_TYPES_WRITERESPONSE], serial,
                                      nullptr);
  }
  // The library closes the channel when sending fails: nothing can be sent afterwards.
  m_lost = m_lost || isBad(status);
}

void UaLink::Impl::noteFloats(const Pending& pending) {
  m_floats.clear();
  if (m_hasFloatCells) {
    for (std::size_t i = 0; i < pending.values.size(); ++i) {
      m_meant[pending.variables[i].index] = pending.values[i];
      m_floats.push_back(static_cast<float>(pending.values[i]));
    }
  }
}

void* UaLink::Impl::numberToSend(Pending& pending, std::size_t item) {
  return m_hasFloatCells ? static_cast<void*>(&m_floats[item]) : &pending.values[item];
}

void UaLink::Impl::fail(Pending& pending, base::Error error) {
  Event event;
  event.kind = EventKind::RequestFailed;
  event.request = pending.id;
  event.sent = pending.event.sent;
  event.at = now();
  event.error = std::move(error);
  m_events.push_back(std::move(event));
}

void UaLink::Impl::finishAnswered() {
  for (Pending& pending : m_pending) {
    if (!pending.done) {
      continue;
    }
    if (isBad(pending.failure)) {
      fail(pending, requestError(pending.failure, pending.operation, endpoint()));
    } else {
      m_events.push_back(std::move(pending.event));
    }
  }
  std::erase_if(m_pending, [](const Pending& pending) { return pending.done; });
}

void UaLink::Impl::expire(Instant time) {
  for (Pending& pending : m_pending) {
    if (pending.deadline <= time) {
      fail(pending, error(LinkError::DeadlineExceeded));
      pending.done = true;
    }
  }
  std::erase_if(m_pending, [](const Pending& pending) { return pending.done; });
}

/// The library does not report every end of a connection.
void UaLink::Impl::noticeState() {
  UA_SecureChannelState channel = UA_SECURECHANNELSTATE_CLOSED;
  UA_Client_getState(m_client, &channel, nullptr, nullptr);
  m_lost = m_lost || channel != UA_SECURECHANNELSTATE_OPEN;
  if (!m_lost && silence() > m_options.silenceMax) {
    m_lost = true;
    m_isSilent = true;
  }
}

base::Error UaLink::Impl::lossError() const {
  if (!m_isSilent) {
    return error(LinkError::ConnectionLost);
  }
  return silenceError(m_options.silenceMax, endpoint());
}

void UaLink::Impl::noticeLoss() {
  if (!m_lost || m_lossReported) {
    return;
  }
  m_lossReported = true;
  m_pending.clear();
  Event event;
  event.kind = EventKind::ConnectionLost;
  event.at = now();
  event.sent = event.at;
  event.error = lossError();
  m_events.push_back(std::move(event));
}

void UaLink::Impl::settle() {
  finishAnswered();
  noticeState();
  if (!m_lost && !m_pending.empty()) {
    expire(now());
    sendDue();
  }
  if (!m_lost && m_subscription && m_subscription->serial == 0) {
    publish();
  }
  noticeLoss();
}

void UaLink::Impl::step(Instant until) {
  Instant limit = until;
  for (const Pending& pending : m_pending) {
    limit = std::min(limit, pending.deadline);
  }
  if (!m_asked.empty()) {
    limit = std::min(limit, addSaturating(now() - silence(), m_options.silenceMax));
  }
  const Duration left = std::min(limit - now(), kIterationMax);
  m_activity = false;
  const auto ms =
      left < milliseconds(1) ? milliseconds::zero() : std::chrono::floor<milliseconds>(left);
  const UA_StatusCode status = UA_Client_run_iterate(m_client, static_cast<UA_UInt32>(ms.count()));
  m_lost = m_lost || isBad(status);
  if (ms == milliseconds::zero() && !m_activity && !m_lost) {
    m_clock.sleepUntil(std::min(limit, now() + kNap));
  }
  settle();
}

std::optional<Event> UaLink::Impl::wait(Instant until) {
  // Deadlines are checked only after the network: an answer that arrived in time counts, however
  // late the caller asks for it.
  noticeLoss();
  for (bool looked = false; m_events.empty(); looked = true) {
    if (looked && now() >= until) {
      return std::nullopt;
    }
    if (m_lost) {
      m_clock.sleepUntil(until);  // nothing can arrive any more
    } else {
      step(until);
    }
  }
  Event event = std::move(m_events.front());
  m_events.pop_front();
  return event;
}

// --- methods ------------------------------------------------------------------------------------

UA_StatusCode UaLink::Impl::exchange(const void* request, const UA_DataType* requestType,
                                     void* response, const UA_DataType* responseType,
                                     Instant deadline) {
  if (m_lost) {
    return UA_STATUSCODE_BADCONNECTIONCLOSED;
  }
  m_exchange = Exchange{nextSerial(), response, responseType, false};
  void* const serial = reinterpret_cast<void*>(static_cast<std::uintptr_t>(m_exchange.serial));
  UA_StatusCode status = __UA_Client_AsyncService(m_client, request, requestType, &Impl::onAnswer,
                                                  responseType, serial, nullptr);
  m_lost = m_lost || isBad(status);
  while (!isBad(status) && !m_exchange.answered) {
    if (m_lost) {
      status = UA_STATUSCODE_BADCONNECTIONCLOSED;
    } else if (now() >= deadline) {
      status = UA_STATUSCODE_BADTIMEOUT;
    } else {
      step(deadline);
    }
  }
  m_exchange = Exchange{};
  settle();
  return isBad(status) ? status : static_cast<const UA_ResponseHeader*>(response)->serviceResult;
}

base::Result<CallResponse> UaLink::Impl::call(UA_UInt16 namespaceIndex, std::string_view object,
                                              std::string_view method,
                                              std::span<UA_Variant> inputs) {
  const std::string methodIdentifier = memberIdentifier(object, method);
  return callNode(borrowNodeId(namespaceIndex, object),
                  borrowNodeId(namespaceIndex, methodIdentifier), methodIdentifier, inputs);
}

base::Result<CallResponse> UaLink::Impl::callMapped(std::string_view method,
                                                    std::span<UA_Variant> inputs) {
  const auto found = m_methods.find(method);
  if (found == m_methods.end()) {
    return base::fail(LinkError::MethodMissing, "The map of this server names no such method.",
                      std::string(method));
  }
  return callNode(found->second.object->nodeId, found->second.method->nodeId, std::string(method),
                  inputs);
}

base::Result<CallResponse> UaLink::Impl::callNode(const UA_NodeId& object, const UA_NodeId& method,
                                                  const std::string& name,
                                                  std::span<UA_Variant> inputs) {
  MethodCall call(object, method, inputs);
  CallResponse response;
  UA_StatusCode status =
      exchange(&call.request, &UA_TYPES[UA_TYPES_CALLREQUEST], response.get(), CallResponse::type(),
               addSaturating(now(), m_options.commandDeadline));
  if (!isBad(status)) {
    status = response->resultsSize == 1 ? response->results[0].statusCode
                                        : UA_STATUSCODE_BADUNKNOWNRESPONSE;
  }
  if (isBad(status)) {
    return base::fail(m_isSilent ? lossError() : requestError(status, Operation::Call, name));
  }
  return response;
}

base::Result<std::vector<NodeValue>> UaLink::Impl::callMethod(const std::string& object,
                                                              const std::string& method,
                                                              std::span<const std::string> inputs) {
  const auto objectId = parsed(object);
  const auto methodId = parsed(method);
  if (!objectId || !methodId) {
    return base::fail(LinkError::MethodMissing, sentenceOf(LinkError::MethodMissing), method);
  }
  std::vector<UA_String> texts;
  std::transform(inputs.begin(), inputs.end(), std::back_inserter(texts),
                 [](const std::string& input) { return borrow(input); });
  std::vector<UA_Variant> arguments;
  std::transform(texts.begin(), texts.end(), std::back_inserter(arguments),
                 [](UA_String& text) { return borrowScalar(text, UA_TYPES_STRING); });
  const auto response = callNode((*objectId)->nodeId, (*methodId)->nodeId, method, arguments);
  if (!response) {
    return base::fail(response.error());
  }
  const UA_CallMethodResult& result = (*response)->results[0];
  std::vector<NodeValue> outputs;
  for (std::size_t i = 0; i < result.outputArgumentsSize; ++i) {
    outputs.push_back(nodeValueOf(result.outputArguments[i]));
  }
  return outputs;
}

base::Result<CallResponse> UaLink::Impl::callFileMethod(std::string_view method,
                                                        std::span<UA_Variant> inputs) {
  if (isMapped()) {
    return callMapped(method, inputs);
  }
  auto answer = call(m_namespace, m_fileMethods, method, inputs);
  if (!answer && answer.error().code == LinkError::MethodMissing) {
    const std::string_view other =
        m_fileMethods == kMethodsObject ? kFileMethodsObject : kMethodsObject;
    answer = call(m_namespace, other, method, inputs);
    m_fileMethods = answer ? other : m_fileMethods;
  }
  return answer;
}

base::Result<CallResponse> UaLink::Impl::callBeyond(std::string_view method,
                                                    std::span<UA_Variant> inputs) {
  if (!m_commands) {
    return base::fail(onlyVirtual(endpoint()));
  }
  return call(m_commands->nameSpace, m_commands->object, method, inputs);
}

// --- the public face ----------------------------------------------------------------------------

namespace {

/// An output argument of a method, or the error that it is not as specified.
template <class T>
[[nodiscard]] base::Result<T> output(const CallResponse& response, std::size_t index,
                                     std::size_t typeIndex, std::string_view method) {
  const UA_CallMethodResult& result = response->results[0];
  const T* value = index < result.outputArgumentsSize
                       ? scalarOf<T>(result.outputArguments[index], typeIndex)
                       : nullptr;
  if (value == nullptr) {
    return base::fail(unknownForm(method));
  }
  return *value;
}

/// The status number of a method, of whatever integer type this server uses.
[[nodiscard]] base::Result<int> statusOutput(const CallResponse& response,
                                             std::string_view method) {
  const UA_CallMethodResult& result = response->results[0];
  const auto number =
      result.outputArgumentsSize > 0 ? numberOf(result.outputArguments[0]) : std::nullopt;
  constexpr double kStatusMax = 1e6;
  if (!number || !(std::abs(*number) <= kStatusMax)) {  // NaN is none, either
    return base::fail(unknownForm(method));
  }
  return static_cast<int>(*number);
}

}  // namespace

UaLink::UaLink(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {
}
UaLink::~UaLink() = default;

LoginKind loginKindOf(const ConnectOptions& options) {
  if (options.userCertificate) {
    return LoginKind::Certificate;
  }
  return options.user.empty() ? LoginKind::Anonymous : LoginKind::UserName;
}

base::Result<std::unique_ptr<UaLink>> UaLink::connect(const ConnectOptions& options) {
  auto impl = std::make_unique<Impl>(options);
  if (auto opened = impl->open(); !opened) {
    return base::fail(opened.error());
  }
  return std::unique_ptr<UaLink>(new UaLink(std::move(impl)));
}

base::Result<Connection> openConnection(const ConnectOptions& options) {
  auto opened = UaLink::connect(options);
  if (!opened) {
    return base::fail(opened.error());
  }
  const std::shared_ptr<UaLink> link = std::move(*opened);
  return Connection{link,
                    link.get(),
                    link.get(),
                    options.endpoint,
                    link->security(),
                    link->serverCertificate(),
                    link.get(),
                    options.map};
}

base::Instant UaLink::now() const {
  return m_impl->now();
}

base::RequestId UaLink::read(std::span<const Variable> variables, base::Duration deadline,
                             Grouping grouping) {
  return m_impl->request(Operation::Read, {variables.begin(), variables.end()}, {}, deadline,
                         grouping);
}

base::RequestId UaLink::write(std::span<const Assignment> assignments, base::Duration deadline,
                              Grouping grouping) {
  Targets targets = targetsOf(assignments);
  return m_impl->request(Operation::Write, std::move(targets.variables), std::move(targets.values),
                         deadline, grouping);
}

base::RequestId UaLink::store(const std::string& name, const std::string& text,
                              base::Duration deadline) {
  return m_impl->store(name, text, deadline);
}

base::RequestId UaLink::readTrace(const trace::TracePosition& from, base::Duration deadline) {
  return m_impl->readTrace(from, deadline);
}

std::optional<Event> UaLink::wait(base::Instant until) {
  return m_impl->wait(until);
}

base::Duration UaLink::silence() const {
  return m_impl->silence();
}

base::Result<void> UaLink::uploadProgram(const std::string& name, const std::string& text,
                                         bool overwrite) {
  const std::string path = m_impl->pathOf(name);
  UA_String target = borrow(path);
  UA_ByteString data = borrow(text);
  UA_Boolean mayOverwrite = overwrite;
  std::array inputs{borrowScalar(target, UA_TYPES_STRING), borrowScalar(data, UA_TYPES_BYTESTRING),
                    borrowScalar(mayOverwrite, UA_TYPES_BOOLEAN)};
  const auto answer = m_impl->callFileMethod(kCopyToServer, inputs);
  if (!answer) {
    return base::fail(answer.error());
  }
  return {};
}

base::Result<std::string> UaLink::downloadProgram(const std::string& name) {
  const std::string path = m_impl->pathOf(name);
  UA_String source = borrow(path);
  std::array inputs{borrowScalar(source, UA_TYPES_STRING)};
  const auto answer = m_impl->callFileMethod(kCopyFromServer, inputs);
  if (!answer) {
    return base::fail(answer.error());
  }
  const auto data = output<UA_ByteString>(*answer, 0, UA_TYPES_BYTESTRING, kCopyFromServer);
  if (!data) {
    return base::fail(data.error());
  }
  return std::string(view(*data));
}

base::Result<void> UaLink::selectProgram(const std::string& name) {
  const std::string path = m_impl->pathOf(name);
  UA_String source = borrow(path);
  UA_UInt32 channel = 1;
  std::array inputs{borrowScalar(source, UA_TYPES_STRING), borrowScalar(channel, UA_TYPES_UINT32)};
  const auto answer = m_impl->callMethods(kSelect, inputs);
  if (!answer) {
    return base::fail(answer.error());
  }
  const auto status = statusOutput(*answer, kSelect);
  if (!status) {
    return base::fail(status.error());
  }
  return commandResult(*status, name);
}

base::Result<ServerIdentity> UaLink::identity() {
  return m_impl->identity();
}

base::Result<std::string> UaLink::accessRights() {
  const auto answer = m_impl->callMethods(kGetMyAccessRights, {});
  if (!answer) {
    return base::fail(answer.error());
  }
  const auto rights = output<UA_String>(*answer, 0, UA_TYPES_STRING, kGetMyAccessRights);
  return rights ? base::Result<std::string>(std::string(view(*rights)))
                : base::fail(rights.error());
}

base::Result<bool> UaLink::mayWrite(const Variable& variable) {
  return m_impl->mayWrite(variable);
}

base::Result<std::vector<BrowsedNode>> UaLink::children(const std::string& address) {
  return m_impl->children(address);
}

base::Result<std::vector<NodeFacts>> UaLink::examine(std::span<const std::string> addresses) {
  return m_impl->examine(addresses);
}

const ChannelSecurity& UaLink::security() const {
  return m_impl->security();
}

const std::optional<CertificateFacts>& UaLink::serverCertificate() const {
  return m_impl->serverCertificate();
}

base::Result<void> UaLink::watch(std::span<const std::string> addresses, base::Duration interval) {
  return m_impl->watch(addresses, interval);
}

std::vector<NodeChange> UaLink::takeChanges() {
  return m_impl->takeChanges();
}

base::Result<std::vector<NodeValue>> UaLink::callMethod(const std::string& object,
                                                        const std::string& method,
                                                        std::span<const std::string> inputs) {
  return m_impl->callMethod(object, method, inputs);
}

bool UaLink::isVirtualMachine() const {
  return m_impl->isVirtual();
}

Abilities UaLink::abilities() const {
  return m_impl->abilities();
}

base::Result<void> UaLink::cycleStart() {
  const auto answer = m_impl->callBeyond(kCycleStart, {});
  if (!answer) {
    return base::fail(answer.error());
  }
  const auto status = statusOutput(*answer, kCycleStart);
  if (!status) {
    return base::fail(status.error());
  }
  const auto message = output<UA_String>(*answer, 1, UA_TYPES_STRING, kCycleStart);
  return commandResult(*status, m_impl->endpoint(),
                       message ? std::string(view(*message)) : std::string());
}

base::Result<void> UaLink::reset() {
  const auto answer = m_impl->callBeyond(kReset, {});
  if (!answer) {
    return base::fail(answer.error());
  }
  return {};
}

base::Result<trace::TracePiece> UaLink::fetchTracePiece(const trace::TracePosition& from) {
  if (!m_impl->givesTracePieces()) {
    return Control::fetchTracePiece(from);
  }
  trace::TracePosition position = from;
  std::array inputs = traceInputs(position);
  const auto answer = m_impl->callBeyond(kFetchTracePiece, inputs);
  return answer ? tracePieceOf((*answer)->results[0])
                : base::Result<trace::TracePiece>(base::fail(answer.error()));
}

base::Result<trace::ControlTrace> UaLink::fetchTrace() {
  return joinTrace([this](std::uint64_t from) -> base::Result<TracePart> {
    UA_UInt64 offset = from;
    std::array inputs{borrowScalar(offset, UA_TYPES_UINT64)};
    const auto answer = m_impl->callBeyond(kFetchTrace, inputs);
    if (!answer) {
      return base::fail(answer.error());
    }
    const auto data = output<UA_ByteString>(*answer, 0, UA_TYPES_BYTESTRING, kFetchTrace);
    const auto total = output<UA_UInt64>(*answer, 1, UA_TYPES_UINT64, kFetchTrace);
    if (!data || !total) {
      return base::fail(!data ? data.error() : total.error());
    }
    return TracePart{std::string(view(*data)), *total};
  });
}

}  // namespace rivulet::opcua
